#ifndef rolling_contact_modes_measuring_point_h
#define rolling_contact_modes_measuring_point_h

#include <rolling_contact/bodies/direct_body.h>

#include <array>
#include <utility>
#include <vector>

namespace RollingContact
{
  /**
   * A place where a body is excited or its motion is measured: the mean over
   * the part of the body within a distance of the point, weighted by
   * 1 - (distance / radius)^2, or the point itself where that part is none.
   * Between its nodes the body moves as its shape functions say, so that the
   * place is where it is asked for and not at a node beside it. A force there
   * is spread with the same weights, so that receptances are symmetric. A force
   * on a point alone would give a compliance that grows with every refinement
   * of the mesh.
   */
  class MeasuringPoint
  {
  public:
    /**
     * @p point in the frame of the body, its second coordinate unused in 2D.
     * Units: m.
     */
    template <int dim>
    MeasuringPoint(const DirectBody<dim>       &body,
                   const std::array<double, 3> &point,
                   const double                 radius);

    /** Values at the unknowns that a force of 1 N along an axis (0, 1, 2: x, y,
     * z) makes. */
    std::vector<double> load(const unsigned int axis,
                             const std::size_t  n_unknowns) const;

    /** The motion along an axis of a field of the unknowns. */
    double motion(const unsigned int axis, const double *values) const;

    /** How far the body is from a point outside of it, but for what the facets
     * of the mesh leave out of a curved body; 0 where part of the body is
     * within the radius. Units: m. */
    double distance() const
    {
      return away;
    }

    /** Nodes whose unknowns along z take part. */
    std::size_t n_nodes() const
    {
      return weights[2].size();
    }

  private:
    std::array<std::vector<std::pair<std::size_t, double>>, 3> weights;
    double                                                     away = 0.;
  };
} // namespace RollingContact

#endif
