#ifndef rolling_contact_bodies_hookes_law_h
#define rolling_contact_bodies_hookes_law_h

#include <deal.II/base/symmetric_tensor.h>

#include <rolling_contact/mesh/material.h>

namespace RollingContact
{
  /**
   * sigma = lambda tr(eps) I + 2 G eps, in the plane with eps_yy = 0. Units: 1
   * to Pa.
   */
  template <int dim>
  dealii::SymmetricTensor<2, dim>
  stress_of(const dealii::SymmetricTensor<2, dim> &strain,
            const Material                        &material)
  {
    const double G      = material.shear_modulus(),
                 lambda = material.bulk_modulus() - 2 * G / 3;
    return 2 * G * strain +
           lambda * trace(strain) * dealii::unit_symmetric_tensor<dim>();
  }
} // namespace RollingContact

#endif
