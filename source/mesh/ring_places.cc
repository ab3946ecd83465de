#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/mesh/ring_places.h>
#include <rolling_contact/mesh/swept_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace RollingContact
{
  namespace
  {
    using Place = std::array<double, 2>; ///< radius, position
    using Quad  = std::array<Place, 4>;  ///< one corner after the other

    /**
     * The section of a body of revolution in quadrilaterals; empty if it is not
     * known before there is a mesh.
     */
    std::vector<Quad> quads_of(const BodyShape &shape, const Axle &axle)
    {
      const auto place = [&](const std::array<double, 3> &point) {
        double square = 0., axial = 0.;
        for (unsigned int d = 0; d < 3; ++d)
          {
            const double from = point[d] - axle.point[d];
            square += from * from;
            axial += from * axle.direction[d];
          }
        return Place{{std::sqrt(std::max(0., square - axial * axial)), axial}};
      };
      std::vector<Quad> quads;
      if (shape.mesh())
        return quads;
      const double infinity = std::numeric_limits<double>::infinity();
      if (const auto mesh = shape.equal_cells(infinity, infinity))
        {
          const auto vertices = mesh->vertices();
          for (unsigned int k = 0; k < mesh->of_section().quads().size(); ++k)
            {
              const auto corners = mesh->corners(k);
              quads.push_back({{place(vertices[corners[0]]),
                                place(vertices[corners[2]]),
                                place(vertices[corners[6]]),
                                place(vertices[corners[4]])}});
            }
          return quads;
        }
      const double outer = place({{0., 0., 0.}})[0],
                   inner = outer - shape.thickness_below(),
                   side  = shape.reach_y();
      quads.push_back({{{{inner, -side}},
                        {{outer, -side}},
                        {{outer, side}},
                        {{inner, side}}}});
      return quads;
    }

    /** The point of a segment that is nearest to another. */
    Place nearest_on(const Place &p, const Place &q, const Place &to)
    {
      const double r = q[0] - p[0], y = q[1] - p[1], square = r * r + y * y,
                   along =
                     square > 0.
                       ? std::clamp(((to[0] - p[0]) * r + (to[1] - p[1]) * y) /
                                      square,
                                    0.,
                                    1.)
                       : 0.;
      return {{p[0] + along * r, p[1] + along * y}};
    }

    /** Whether a place is in a convex quadrilateral, either way round. */
    bool is_inside(const Quad &quad, const Place &place)
    {
      unsigned int n_left = 0;
      for (unsigned int k = 0; k < 4; ++k)
        {
          const Place &p = quad[k], &q = quad[(k + 1) % 4];
          n_left += (q[0] - p[0]) * (place[1] - p[1]) >
                    (q[1] - p[1]) * (place[0] - p[0]);
        }
      return n_left == 0 || n_left == 4;
    }

    double distance(const Place &p, const Place &q)
    {
      return std::hypot(p[0] - q[0], p[1] - q[1]);
    }

    Place nearest_of(const std::vector<Quad> &quads, const Place &place)
    {
      Place nearest = quads[0][0];
      for (const Quad &quad : quads)
        {
          if (is_inside(quad, place))
            return place;
          for (unsigned int k = 0; k < 4; ++k)
            {
              const Place here = nearest_on(quad[k], quad[(k + 1) % 4], place);
              if (distance(here, place) < distance(nearest, place))
                nearest = here;
            }
        }
      return nearest;
    }
  } // namespace

  void check_ring_places(const std::vector<AbsorberRing> &rings,
                         const std::string               &section,
                         const BodyShape                 &shape)
  {
    const auto axle = shape.axle();
    if (!axle || rings.empty())
      return;
    const std::vector<Quad> quads = quads_of(shape, *axle);
    if (quads.empty())
      return;
    double largest = 0.;
    for (const Quad &quad : quads)
      for (const Place &corner : quad)
        largest = std::max(largest, corner[0]);
    for (const AbsorberRing &ring : rings)
      {
        const Place asked{{ring.radius, ring.position}},
          nearest = nearest_of(quads, asked);
        if (distance(asked, nearest) > farthest_ring * largest)
          throw InputError(
            section + "/Damper radius = " + significant(ring.radius, 6) +
            ", Damper position = " + significant(ring.position, 6) +
            ": the wheel does not reach there; the nearest point of its section is at "
            "radius " +
            significant(nearest[0], 4) + " m, position " +
            significant(nearest[1], 4) + " m.");
      }
  }
} // namespace RollingContact
