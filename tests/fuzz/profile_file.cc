#include "input_parts.h"

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/surfaces/profile_file.h>

using namespace RollingContact;

namespace
{
  /** All coordinates are finite, and the arc length rises. */
  void check_curve(const Profiles::ProfileCurve &curve)
  {
    for (const auto &point : curve.points())
      must(std::isfinite(point.y) && std::isfinite(point.z) &&
             std::isfinite(point.angle),
           "a point of the profile is not finite");
    const auto &arc = curve.arc_lengths();
    for (std::size_t k = 1; k < arc.size(); ++k)
      must(arc[k] > arc[k - 1], "the arc length does not rise");
    for (const double s : {0., 0.3, 0.7, 1.})
      must(std::isfinite(curve.at(s * curve.length()).z) &&
             std::isfinite(curve.curvature(s * curve.length())),
           "the profile between its points is not finite");
  }

  /** Points written in m in two columns must be read as the same. */
  void write_and_read(const std::vector<Profiles::MeasuredPoint> &points)
  {
    std::string text = "# y z\n";
    for (const auto &point : points)
      text += written(point.y) + ' ' + written(point.z) + '\n';
    write_part("again.txt", {text}, 0);
    Profiles::FileOptions metres;
    metres.unit      = 1.;
    const auto again = Profiles::read_points("again.txt", metres);
    must(again.size() == points.size(), "another number of points");
    for (std::size_t k = 0; k < points.size(); ++k)
      must(again[k].y == points[k].y && again[k].z == points[k].z,
           "another point");
  }
} // namespace

/** Parts: the ending of the file's name and letters for its options (y and z:
 * mirrored, m: metres, s: not smoothed), the file. */
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data,
                                      const std::size_t   size)
{
  const auto        parts = input_parts(data, size);
  const std::string file =
    parts[0].find("prw") != std::string::npos   ? "profile.prw"
    : parts[0].find("whl") != std::string::npos ? "profile.whl"
                                                : "profile.txt";
  const auto has = [&](const char letter) {
    return parts[0].find(letter) != std::string::npos;
  };
  Profiles::FileOptions options;
  options.unit     = has('m') ? 1. : 1e-3;
  options.mirror_y = has('y');
  options.mirror_z = has('z');
  if (has('s'))
    options.smoothing_length = 0.;
  write_part(file, parts, 1);
  try
    {
      write_and_read(Profiles::read_points(file, options));
    }
  catch (const InputError &error)
    {
      must_name(error, file);
    }
  for (const auto kind :
       {Profiles::ProfileKind::wheel, Profiles::ProfileKind::rail})
    try
      {
        check_curve(Profiles::read_profile(file, kind, options));
      }
    catch (const InputError &error)
      {
        must_name(error, file);
      }
  return 0;
}
