#ifndef rolling_contact_bodies_moment_fields_h
#define rolling_contact_bodies_moment_fields_h

#include <deal.II/base/point.h>

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
