#ifndef rolling_contact_modes_measuring_point_h
#define rolling_contact_modes_measuring_point_h

#include <rolling_contact/modes/body_places.h>

#include <array>
#include <utility>
#include <vector>

namespace RollingContact
{
  /**
   * A place where a body is excited or its motion is measured: the mean over
   * the nodes within a distance of the point, weighted by their masses and by
   * 1 - (distance / radius)^2, or the nearest node if there are none. A force
   * there is spread with the same weights, so that receptances are symmetric. A
   * force on a single node would give a compliance that grows with every
   * refinement of the mesh.
   */
  class MeasuringPoint
  {
  public:
    /**
     * Units: m.
     */
    MeasuringPoint(const BodyPlaces            &places,
                   const std::array<double, 3> &point,
                   const double                 radius);

    /** Values at the unknowns that a force of 1 N along an axis (0, 1, 2: x, y,
     * z) makes. */
    std::vector<double> load(const unsigned int axis,
                             const std::size_t  n_unknowns) const;

    /** The motion along an axis of a field of the unknowns. */
    double motion(const unsigned int axis, const double *values) const;

    /** The unknown along an axis of the nearest node; -1 if it is held. */
    std::array<int, 3> nearest_unknowns() const
    {
      return nearest;
    }

    /** Distance of the asked point from the nearest node. Units: m. */
    double distance() const
    {
      return nearest_distance;
    }

    std::size_t n_nodes() const
    {
      return weights[2].size();
    }

  private:
    std::array<std::vector<std::pair<std::size_t, double>>, 3> weights;
    std::array<int, 3>                                         nearest;
    double nearest_distance = 0.;
  };
} // namespace RollingContact

#endif
