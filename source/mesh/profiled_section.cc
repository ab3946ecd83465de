#include <rolling_contact/mesh/profiled_section.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    const double on_profile_already = 1e-9; // m

    double product(const ProfiledSection::Point &a,
                   const ProfiledSection::Point &b)
    {
      return a[0] * b[0] + a[1] * b[1];
    }

    ProfiledSection::Point difference(const ProfiledSection::Point &a,
                                      const ProfiledSection::Point &b)
    {
      return {{a[0] - b[0], a[1] - b[1]}};
    }
  } // namespace

  ProfiledSection::ProfiledSection(const PlacedProfile &placed,
                                   const bool           is_wheel)
    : placed(placed)
    , outwards(is_wheel ? 1. : -1.)
    , origin(0.)
    , known(facing_coordinates(placed))
  {
    origin = nearest({{0., 0.}}).along;
  }

  ProfiledSection::Foot ProfiledSection::nearest(const Point &point) const
  {
    const auto  &nodes = placed.profile.points();
    std::size_t  best  = 0;
    double       least = HUGE_VAL;
    const double z     = outwards * point[1];
    for (std::size_t k = 0; k < nodes.size(); ++k)
      {
        const double distance =
          std::hypot(nodes[k].y - point[0], nodes[k].z - z);
        if (distance < least)
          {
            least = distance;
            best  = k;
          }
      }
    // the foot of a perpendicular beside this node
    const auto  &arcs  = placed.profile.arc_lengths();
    const double lower = arcs[best > 0 ? best - 1 : 0],
                 upper = arcs[std::min(best + 1, arcs.size() - 1)];
    Foot foot{arcs[best] - origin, least};
    for (unsigned int round = 0; round < 20; ++round)
      {
        const Point  away = difference(point, at(foot.along));
        const double step = product(away, tangent(foot.along));
        const double next =
          std::clamp(foot.along + origin + step, lower, upper) - origin;
        const bool done = std::abs(next - foot.along) < 1e-13;
        foot.along      = next;
        if (done)
          break;
      }
    const Point away = difference(point, at(foot.along));
    foot.distance    = std::hypot(away[0], away[1]);
    return foot;
  }

  ProfiledSection::Point ProfiledSection::at(const double along) const
  {
    const auto point = placed.profile.at(
      std::clamp(along + origin, 0., placed.profile.length()));
    return {{point.y, outwards * point.z}};
  }

  ProfiledSection::Point ProfiledSection::tangent(const double along) const
  {
    const double angle =
      placed.profile.at(std::clamp(along + origin, 0., placed.profile.length()))
        .angle;
    return {{std::cos(angle), outwards * std::sin(angle)}};
  }

  double ProfiledSection::contact() const
  {
    return *placed.arc_length(0.) - origin;
  }

  double ProfiledSection::along(const double coordinate) const
  {
    const double inside = std::clamp(coordinate, known[0], known[1]);
    return *placed.arc_length(inside) - origin + coordinate - inside;
  }

  double ProfiledSection::coordinate(const double wanted) const
  {
    const std::array<double, 2> ends{{along(known[0]), along(known[1])}};
    for (const unsigned int side : {0u, 1u})
      if ((side == 0 ? ends[0] - wanted : wanted - ends[1]) >= 0.)
        return known[side] + wanted - ends[side];
    double lower = known[0], upper = known[1];
    for (unsigned int round = 0; round < 60; ++round)
      {
        const double middle                      = (lower + upper) / 2;
        (along(middle) < wanted ? lower : upper) = middle;
      }
    return (lower + upper) / 2;
  }

  ZoneBox ProfiledSection::on_profile(const ZoneBox &box) const
  {
    ZoneBox      result = box;
    const double sign   = placed.is_left ? -1. : 1.;
    const double one    = sign * along(sign * box.lower[1]),
                 other  = sign * along(sign * box.upper[1]);
    result.lower[1]     = std::min(one, other);
    result.upper[1]     = std::max(one, other);
    return result;
  }

  void put_on_profile(const ProfiledSection &profile,
                      const double           top,
                      SectionPoint          &point)
  {
    const auto foot = profile.nearest({{point[0], point[1] - top}});
    if (foot.distance > ProfiledSection::largest_offset)
      return;
    const auto on = profile.at(foot.along);
    point         = {{on[0], top + on[1], top + on[1]}};
  }

  namespace
  {
    /** Corners that edges of a quadrilateral cross to from its edge. */
    unsigned int opposite(const unsigned int corner, const unsigned int edge)
    {
      return corner ^ (edge < 2 ? 1 : 2);
    }

    /** Moves the points of one section to follow its profile. */
    class Follower
    {
    public:
      Follower(const ProfiledSection &profile,
               const double           top,
               SectionMesh           &section)
        : profile(profile)
        , top(top)
        , section(section)
      {
        for (const SectionPoint &point : section.vertices())
          feet.push_back(profile.nearest({{point[0], point[1] - top}}));
      }

      void follow(const unsigned int quad)
      {
        const auto  &corners = section.quads()[quad].corners;
        unsigned int n_edges = 0, last = 0;
        for (unsigned int edge = 0; edge < 4; ++edge)
          {
            const auto ends = section.ends_of_edge(quad, edge);
            if (section.quads()[quad].boundary[edge] !=
                  SectionBoundary::contact ||
                !is_on_profile(ends[0]) || !is_on_profile(ends[1]))
              continue;
            section.set_curve(quad, edge, curve_between(ends[0], ends[1]));
            ++n_edges;
            last = edge;
          }
        std::array<SectionPoint, 4> points;
        for (unsigned int v = 0; v < 4; ++v)
          points[v] = section.vertices()[corners[v]];
        section.set_chart(quad,
                          points,
                          n_edges == 1 ? chart_under(corners, last)
                                       : chart_beside(corners));
      }

    private:
      using Corners = std::array<unsigned int, 4>;
      using Chart   = std::array<SectionMesh::ChartPoint, 4>;

      bool is_on_profile(const unsigned int vertex) const
      {
        return feet[vertex].distance < on_profile_already;
      }

      SectionMesh::Curve curve_between(const unsigned int begin,
                                       const unsigned int end) const
      {
        const double a = feet[begin].along, b = feet[end].along;
        return [profile = profile, top = top, a, b](const double t) {
          const auto on = profile.at((1 - t) * a + t * b);
          return SectionPoint{{on[0], top + on[1], top + on[1]}};
        };
      }

      /**
       * Inner corners are under those of the edge on the profile.
       */
      Chart chart_under(const Corners &corners, const unsigned int edge) const
      {
        Chart chart;
        for (unsigned int v = 0; v < 4; ++v)
          {
            const bool upper = edge < 2 ? (v & 1) == edge : v >> 1 == edge - 2;
            const unsigned int above = upper ? v : opposite(v, edge);
            const auto        &p     = section.vertices()[corners[v]],
                       &q            = section.vertices()[corners[above]];
            chart[v]                 = {{feet[corners[above]].along,
                                         -std::hypot(p[0] - q[0], p[1] - q[1])}};
          }
        return chart;
      }

      /**
       * By the tangent at the point of the profile nearest to the middle.
       */
      Chart chart_beside(const Corners &corners) const
      {
        ProfiledSection::Point middle{{0., -top}};
        for (const unsigned int corner : corners)
          for (unsigned int d = 0; d < 2; ++d)
            middle[d] += section.vertices()[corner][d] / 4;
        const auto foot    = profile.nearest(middle);
        const auto on      = profile.at(foot.along),
                   tangent = profile.tangent(foot.along);
        Chart chart;
        for (unsigned int v = 0; v < 4; ++v)
          {
            const auto &p = section.vertices()[corners[v]];
            chart[v]      = {
                   {foot.along +
                      product(difference({{p[0], p[1] - top}}, on), tangent),
                    -feet[corners[v]].distance}};
          }
        return chart;
      }

      const ProfiledSection             &profile;
      const double                       top;
      SectionMesh                       &section;
      std::vector<ProfiledSection::Foot> feet;
    };
  } // namespace

  void follow_profile(const ProfiledSection &profile,
                      const double           top,
                      SectionMesh           &section)
  {
    Follower follower(profile, top, section);
    for (unsigned int quad = 0; quad < section.quads().size(); ++quad)
      follower.follow(quad);
  }
} // namespace RollingContact
