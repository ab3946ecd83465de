#include <rolling_contact/surfaces/height_bounds.h>

#include <algorithm>
#include <cmath>

namespace RollingContact::Profiles
{
  namespace
  {
    /// a cubic leaves its chord by at most 1.03 of the largest of these places
    const double inner_places[] = {0.25, 0.5, 0.75};
    const double safety         = 1.5;
  } // namespace

  HeightBounds::HeightBounds(const ProfileCurve &curve)
  {
    const ArcLengthAtY arc_length(curve);
    const auto        &points = curve.points();
    const auto        &arc    = curve.arc_lengths();
    const std::size_t  begin  = arc_length.first_point(),
                      end     = begin + arc_length.n_points();
    for (std::size_t k = begin; k < end; ++k)
      ends.push_back(points[k].y);
    for (std::size_t k = begin; k + 1 < end; ++k)
      {
        const CurvePoint &a = points[k], &b = points[k + 1];
        Chord             chord{a.y, a.z, (b.z - a.z) / (b.y - a.y), 0.};
        for (const double t : inner_places)
          {
            const CurvePoint at = curve.at(arc[k] + t * (arc[k + 1] - arc[k]));
            chord.off           = std::max(chord.off,
                                 safety * std::abs(at.z - a.z -
                                                   chord.slope * (at.y - a.y)));
          }
        chords.push_back(chord);
      }
  }

  std::pair<double, double> HeightBounds::operator()(const double y) const
  {
    const std::size_t k =
      std::clamp<std::ptrdiff_t>(std::upper_bound(ends.begin(), ends.end(), y) -
                                   ends.begin() - 1,
                                 0,
                                 chords.size() - 1);
    const Chord &chord  = chords[k];
    const double middle = chord.z + chord.slope * (y - chord.y);
    return {middle - chord.off, middle + chord.off};
  }
} // namespace RollingContact::Profiles
