#ifndef rolling_contact_bodies_body_point_h
#define rolling_contact_bodies_body_point_h

#include <rolling_contact/bodies/elastic_body.h>

#include <utility>
#include <vector>

namespace RollingContact
{
  /**
   * A point of a body between its nodes, whose motion is that of the shape
   * functions of its cell. A point beyond the facets of the mesh is moved onto
   * the nearest cell.
   */
  template <int dim>
  class BodyPoint
  {
  public:
    /**
     * @p point in the frame of the body. Units: m.
     */
    BodyPoint(const ElasticBody<dim> &body, const dealii::Point<dim> &point);

    /**
     * Value of a nodal field at the point, by components.
     */
    std::array<double, dim> value(const BodyField &field) const;

    /**
     * The first degree of freedom of each vertex of its cell, and the value of
     * the vertex's shape function.
     */
    const std::vector<std::pair<dealii::types::global_dof_index, double>> &
    weights() const
    {
      return vertices;
    }

    /**
     * Where the point is, moved onto the mesh or not. Units: m.
     */
    const dealii::Point<dim> &place() const
    {
      return at;
    }

    /**
     * By how much it was moved. Units: m.
     */
    double distance() const
    {
      return moved;
    }

    /**
     * Diameter of its cell. Units: m.
     */
    double cell_diameter() const
    {
      return diameter;
    }

  private:
    /** Degree of freedom of the first component of a vertex, and its weight. */
    std::vector<std::pair<dealii::types::global_dof_index, double>> vertices;

    dealii::Point<dim> at;
    double             moved    = 0.;
    double             diameter = 0.;
  };
} // namespace RollingContact

#endif
