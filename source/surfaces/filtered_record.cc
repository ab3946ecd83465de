#include <boost/math/interpolators/cardinal_cubic_b_spline.hpp>

#include <rolling_contact/surfaces/filtered_record.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  class FilteredRecord::Curve
    : public boost::math::interpolators::cardinal_cubic_b_spline<double>
  {
  public:
    using cardinal_cubic_b_spline::cardinal_cubic_b_spline;
  };

  namespace
  {
    const double closes = 0.01; // of the circumference

    /**
     * Number of values repeated from the other end in front and behind, so many
     * that the influence of the spline's end conditions has decayed to 1e-11.
     */
    const std::size_t n_overlapping = 20;
  } // namespace

  FilteredRecord::FilteredRecord(const SurfaceRecord   &record,
                                 const Signals::CutOff &cut_off,
                                 const double           circumference)
    : rms(Signals::root_mean_square(record.heights))
    , begin(record.begin)
    , end(record.end())
  {
    const std::size_t n      = record.heights.size();
    double            length = n * record.spacing, spacing = record.spacing;
    // the last value may be the first one again
    std::vector<double> heights      = record.heights;
    const double        without_last = length - spacing;
    if (circumference > 0. && std::abs(without_last - circumference) <
                                std::abs(length - circumference))
      {
        length = without_last;
        heights.pop_back();
      }
    const bool closed =
      circumference > 0. &&
      std::abs(length - circumference) <= closes * circumference;
    if (!closed)
      heights = record.heights;
    else
      {
        period  = circumference;
        spacing = period / heights.size();
      }
    const std::vector<double> smooth =
      closed ? Signals::low_pass_periodic(heights, spacing, cut_off)
             : Signals::low_pass_mirrored(heights, spacing, cut_off);
    for (std::size_t k = 0; k < heights.size(); ++k)
      heights[k] -= smooth[k];
    removed_rms = Signals::root_mean_square(heights);
    if (!closed)
      {
        curve = std::make_shared<const Curve>(
          smooth.begin(), smooth.end(), begin, spacing, 0., 0.);
        return;
      }
    std::vector<double> around;
    const std::size_t   m = smooth.size();
    for (std::size_t k = 0; k < m + 2 * n_overlapping; ++k)
      around.push_back(smooth[(k + m * n_overlapping - n_overlapping) % m]);
    curve = std::make_shared<const Curve>(around.begin(),
                                          around.end(),
                                          begin - n_overlapping * spacing,
                                          spacing);
  }

  double FilteredRecord::value(const double position) const
  {
    if (period > 0.)
      return (*curve)(position -
                      period * std::floor((position - begin) / period));
    const double length = end - begin;
    double       at     = std::fmod(std::abs(position - begin), 2 * length);
    if (at > length)
      at = 2 * length - at;
    return (*curve)(std::min(begin + at, end));
  }
} // namespace RollingContact
