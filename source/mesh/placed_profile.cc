#include <rolling_contact/mesh/placed_profile.h>

#include <cmath>
#include <stdexcept>

namespace RollingContact
{
  using Profiles::Outline;

  namespace
  {
    /// of the search for the end of the known coordinates, and of a nearest
    /// point: m
    const double step = 0.25e-3, largest_reach = 0.2;

    /// length on the profile over that of the coordinate: less where the wheel
    /// is hollow, 2 where the surface is inclined by 60 degrees
    const double least_stretch = 0.1, largest_stretch = 2.;

    double last_known(const PlacedProfile &placed, const double way)
    {
      double last = 0., arc = *placed.arc_length(0.);
      for (unsigned int k = 1; k * step < largest_reach; ++k)
        {
          const auto next = placed.arc_length(way * k * step);
          if (!next)
            break;
          const double stretch = way * (*next - arc) / step;
          if (!(stretch > least_stretch && stretch < largest_stretch))
            break;
          last = way * k * step;
          arc  = *next;
        }
      return last;
    }
  } // namespace

  std::array<double, 2> facing_coordinates(const PlacedProfile &placed)
  {
    return {{last_known(placed, -1.), last_known(placed, 1.)}};
  }

  RunningSurface::RunningSurface(const PlacedProfile               &placed,
                                 const std::array<double, 2>       &ends,
                                 const std::vector<Outline::Point> &before,
                                 const std::vector<Outline::Point> &after)
    : placed(placed)
    , profile_ends(ends)
    , known(facing_coordinates(placed))
    , known_arcs{{*placed.arc_length(known[0]), *placed.arc_length(known[1])}}
  {
    if (before.size() > 1)
      this->before.emplace_back(before);
    if (after.size() > 1)
      this->after.emplace_back(after);
    for (unsigned int side = 0; side < 2; ++side)
      known[side] = side == 0 ? std::max(known[0], this->ends()[0])
                              : std::min(known[1], this->ends()[1]);
    for (unsigned int side = 0; side < 2; ++side)
      known_arcs[side] = *placed.arc_length(known[side]);
  }

  double RunningSurface::arc(const double coordinate) const
  {
    if (coordinate < known[0])
      return known_arcs[0] + coordinate - known[0];
    if (coordinate > known[1])
      return known_arcs[1] + coordinate - known[1];
    const auto arc = placed.arc_length(coordinate);
    if (!arc)
      throw std::logic_error("A running surface ends where it should not.");
    return *arc;
  }

  double RunningSurface::coordinate(const double wanted) const
  {
    if (wanted <= known_arcs[0])
      return known[0] + wanted - known_arcs[0];
    if (wanted >= known_arcs[1])
      return known[1] + wanted - known_arcs[1];
    double lower = known[0], upper = known[1];
    for (unsigned int round = 0; round < 60; ++round)
      {
        const double middle                    = (lower + upper) / 2;
        (arc(middle) < wanted ? lower : upper) = middle;
      }
    return (lower + upper) / 2;
  }

  Outline::Point RunningSurface::at(const double coordinate) const
  {
    const double s = arc(coordinate);
    if (s < profile_ends[0] && !before.empty())
      return before[0].at(profile_ends[0] - s);
    if (s > profile_ends[1] && !after.empty())
      return after[0].at(s - profile_ends[1]);
    const auto point = placed.profile.at(
      std::min(std::max(s, profile_ends[0]), profile_ends[1]));
    return {{point.y, point.z}};
  }

  std::array<double, 2> RunningSurface::ends() const
  {
    return {
      {coordinate(profile_ends[0] - (before.empty() ? 0. : before[0].length())),
       coordinate(profile_ends[1] + (after.empty() ? 0. : after[0].length()))}};
  }

  double RunningSurface::nearest(const Outline::Point &point) const
  {
    const auto   range = ends();
    double       found = range[0], least = -1.;
    const double n = std::ceil((range[1] - range[0]) / step);
    for (unsigned int k = 0; k <= n; ++k)
      {
        const double c    = range[0] + (range[1] - range[0]) * k / n;
        const auto   here = at(c);
        const double away = std::hypot(here[0] - point[0], here[1] - point[1]);
        if (least < 0. || away < least)
          {
            least = away;
            found = c;
          }
      }
    return found;
  }
} // namespace RollingContact
