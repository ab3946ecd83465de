#ifndef rolling_contact_bodies_hub_faces_h
#define rolling_contact_bodies_hub_faces_h

#include <deal.II/base/tensor.h>
#include <deal.II/dofs/dof_handler.h>

#include <functional>
#include <vector>

namespace RollingContact
{
  /**
   * A point of integration of a face: where it is, its area, what the vertices
   * of the face have of it.
   */
  template <int dim>
  struct FacePoint
  {
    dealii::Point<dim>  at;
    double              area;
    std::vector<double> shape;
  };

  /**
   * The faces of the hub boundary.
   */
  template <int dim>
  std::vector<typename dealii::DoFHandler<dim>::active_face_iterator>
  hub_faces(const dealii::DoFHandler<dim> &dofs);

  /**
   * Integrate over the part of a face between two values of x by Gauss's
   * points, two along each direction: exact for products of shape functions
   * where one pair of edges goes along x and the other across. Units: m.
   */
  template <int dim>
  void
  integrate(const typename dealii::DoFHandler<dim>::active_face_iterator &face,
            const double                                                  from,
            const double                                                  to,
            const std::function<void(const FacePoint<dim> &)> &action);

  /**
   * Axes of the hub by rows: where it is flat as a sole, z is its normal into
   * the body; where it is round as a bore, y is its axis; x is as near to that
   * of the body as this allows. Those of the body for other hubs, in 2D, and
   * where they are the same to 1e-6.
   */
  template <int dim>
  dealii::Tensor<2, dim> hub_axes(const dealii::DoFHandler<dim> &dofs);
} // namespace RollingContact

#endif
