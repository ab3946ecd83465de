#ifndef rolling_contact_bodies_faded_fields_h
#define rolling_contact_bodies_faded_fields_h

#include <rolling_contact/algebra/dense_matrix.h>
#include <rolling_contact/bodies/direct_body.h>
#include <rolling_contact/bodies/fading_region.h>

namespace RollingContact
{
  /**
   * The fields of a half-space under each of force_moments(), faded out within
   * a body, chi u_hs, and what the body has to add for want of them: u_c with
   *   a(u_c, v) = F(v) = int (sigma_hs grad chi).v
   *                          - C:(u_hs x grad chi) : grad v dV
   *                      - int h sigma_hs,ka (chi v_k),a dS,
   * the first integral over the region where chi changes and the second, of the
   * curved surface z = h(x, y), a = x, y, beyond the loads, of which @p fading
   * leaves room for the farthest.
   */
  struct FadedFields
  {
    FadedFields() = default;

    FadedFields(const DirectBody<3> &body,
                const BodyShape     &shape,
                const FadingRegion  &fading);

    DenseMatrix F; ///< of the unknowns by moment. Units: N/(N m^degree)
    DenseMatrix Q; ///< F_k(chi u_hs,l), from within. m/(N m^degrees)
  };

  /**
   * The inertia of the fields chi u_hs: loads on the unknowns of a body,
   * int rho chi u_hs,k . v dV by moment, and between each other,
   * int rho chi^2 u_hs,k . u_hs,l dV; and their values at the nodes, unknown by
   * moment. Next to the contact point, where forces are spread and fields end,
   * they are those a quarter of the inner radius away. Units: kg m/(N
   * m^degree), kg m^2/(N^2 m^degrees), m/(N m^degree).
   */
  struct FadedInertia
  {
    FadedInertia() = default;

    FadedInertia(const DirectBody<3> &body, const FadingRegion &fading);

    DenseMatrix loads, mutual, at_nodes;
  };
} // namespace RollingContact

#endif
