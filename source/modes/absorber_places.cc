#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/mesh/ring_places.h>
#include <rolling_contact/modes/absorber_places.h>
#include <rolling_contact/modes/node_rings.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    double distance(const NodeRing &nodes, const AbsorberRing &ring)
    {
      const CylindricalPlace &at = nodes.nodes.front().place;
      return std::hypot(at.radius - ring.radius, at.axial - ring.position);
    }

    /** The circle of nodes nearest to a ring. */
    const NodeRing &nearest(const std::vector<NodeRing> &circles,
                            const AbsorberRing          &ring,
                            const std::string           &section)
    {
      const NodeRing *best    = nullptr;
      double          largest = 0.;
      for (const NodeRing &circle : circles)
        {
          largest = std::max(largest, circle.nodes.front().place.radius);
          if (best == nullptr || distance(circle, ring) < distance(*best, ring))
            best = &circle;
        }
      if (best == nullptr)
        throw InputError(section + "/Dampers: the mesh has no circle of nodes "
                                   "round the axle; take a disc or a section.");
      const CylindricalPlace &at = best->nodes.front().place;
      if (distance(*best, ring) > farthest_ring * largest)
        throw InputError(
          section + "/Damper radius = " + significant(ring.radius, 6) +
          ", Damper position = " + significant(ring.position, 6) +
          ": the wheel does not reach there; the nearest circle of nodes is at "
          "radius " +
          significant(at.radius, 4) + " m, position " +
          significant(at.axial, 4) + " m.");
      return *best;
    }

    const std::array<double, 3> &direction(const AbsorberRing     &ring,
                                           const CylindricalPlace &place)
    {
      return ring.direction == AbsorberDirection::axial    ? place.along
             : ring.direction == AbsorberDirection::radial ? place.outwards
                                                           : place.around;
    }

    /** Add the columns of L of one ring, from column @p first on. */
    void add_loads(const NodeRing     &circle,
                   const AbsorberRing &ring,
                   const unsigned int  D,
                   const std::size_t   first,
                   DenseMatrix        &L)
    {
      for (const NodeRing::Node &at : circle.nodes)
        {
          const auto &along = direction(ring, at.place);
          for (unsigned int axis = 0; axis < 3; ++axis)
            {
              const int unknown = at.node->unknowns[axis];
              if (unknown < 0)
                continue;
              const double w = at.weight * along[axis];
              L(unknown, first) += w;
              for (unsigned int d = 1; d <= D; ++d)
                {
                  L(unknown, first + 2 * d - 1) +=
                    w * std::sqrt(2.) * std::cos(d * at.place.angle);
                  L(unknown, first + 2 * d) +=
                    w * std::sqrt(2.) * std::sin(d * at.place.angle);
                }
            }
        }
    }

    unsigned int most_diameters_of(const std::vector<ModeCharacter> &characters)
    {
      unsigned int most = 0;
      for (const ModeCharacter &mode : characters)
        most = std::max(most, mode.nodal_diameters.value_or(0));
      return most;
    }

  } // namespace

  AbsorberPlaces absorber_places(const std::vector<AbsorberRing>  &rings,
                                 const std::string                &section,
                                 const BodyPlaces                 &body,
                                 const Axle                       &axle,
                                 const StructuralModes            &modes,
                                 const std::vector<ModeCharacter> &characters,
                                 const Factorisation              &factor,
                                 const double                      shift,
                                 std::vector<std::string>         &notes)
  {
    AbsorberPlaces places;
    if (rings.empty())
      return places;
    const auto                    circles = node_rings(body, axle);
    const unsigned int            highest = most_diameters_of(characters);
    std::vector<const NodeRing *> taken;
    for (const AbsorberRing &ring : rings)
      {
        const NodeRing &circle = nearest(circles, ring, section);
        taken.push_back(&circle);
        const unsigned int of_nodes = (pi / circle.gap) * 0.999;
        places.diameters.push_back(
          std::min({highest, ring.most_diameters(), of_nodes}));
        const CylindricalPlace &at = circle.nodes.front().place;
        notes.push_back(
          std::to_string(ring.number) + " dampers of " +
          significant(ring.mass, 4) + " kg at " +
          significant(ring.frequency, 5) + " Hz on the circle of " +
          std::to_string(circle.nodes.size()) + " nodes at radius " +
          significant(at.radius, 4) + " m, position " +
          significant(at.axial, 4) + " m, " +
          significant(std::round(1e4 * distance(circle, ring)) / 10, 4) +
          " mm from the one asked for, up to " +
          std::to_string(places.diameters.back()) + " nodal diameters.");
      }
    places.loads =
      DenseMatrix::Zero(modes.shapes.rows(), places.n_coordinates());
    std::size_t first = 0;
    for (std::size_t r = 0; r < rings.size(); ++r)
      {
        add_loads(
          *taken[r], rings[r], places.diameters[r], first, places.loads);
        first += 2 * places.diameters[r] + 1;
      }
    places.deflected = places.loads;
    factor.solve(places.deflected);
    places.motions  = places.loads.transpose() * modes.shapes;
    places.statics  = modes.statics(places.motions,
                                   places.loads.transpose() * modes.at_rest,
                                   shift);
    places.residual = places.loads.transpose() * places.deflected -
                      places.statics * places.statics.transpose();
    return places;
  }
} // namespace RollingContact
