#ifndef rolling_contact_bodies_moment_fields_h
#define rolling_contact_bodies_moment_fields_h

#include <deal.II/base/point.h>

#include <rolling_contact/algebra/dense_matrix.h>
#include <rolling_contact/mesh/material.h>

#include <array>
#include <vector>

namespace RollingContact
{
  /**
   * A moment of surface forces about the origin: the sum of forces in one
   * component times x^i y^j/(i! j!).
   */
  struct ForceMoment
  {
    unsigned int component, i, j;

    unsigned int degree() const
    {
      return i + j;
    }

    /** x^i y^j/(i! j!). */
    double shape(const double x, const double y) const;
  };

  /**
   * The moments to degree 2, in ascending degree: 18.
   */
  const std::vector<ForceMoment> &force_moments();

  /**
   * Phi: the shapes of force_moments() at nodes, component @p components[i] of
   * node n in row i * N + n. Phi^T f are the moments of nodal forces f. Units:
   * m to m^degrees.
   */
  DenseMatrix
  shapes_of_moments(const std::vector<std::array<double, 2>> &positions,
                    const std::vector<unsigned int>          &components);

  /**
   * Displacement and its gradient, gradient[k][l] = du_k/dx_l.
   */
  struct DisplacementField
  {
    dealii::Tensor<1, 3> value;
    dealii::Tensor<2, 3> gradient;
  };

  /**
   * What a half-space does under each of force_moments(), that of 1 N m^degree
   * at the origin: Boussinesq's and Cerruti's fields (Johnson 1985, 3.18, 3.75)
   * and their derivatives with respect to the place of the force. In axes of
   * a body, z out of it; @p point is below the surface or on it, and not the
   * origin. Units: m.
   */
  std::vector<DisplacementField> moment_fields(const dealii::Point<3> &point,
                                               const Material &material);
} // namespace RollingContact

#endif
