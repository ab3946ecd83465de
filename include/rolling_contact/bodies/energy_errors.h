#ifndef rolling_contact_bodies_energy_errors_h
#define rolling_contact_bodies_energy_errors_h

#include <rolling_contact/algebra/dense_matrix.h>
#include <rolling_contact/bodies/elastic_body.h>

#include <vector>

namespace RollingContact
{
  /**
   * Estimates of a(u_k - u_kh, u_l - u_lh), the energy product a of the errors
   * of static displacements u_kh of a body, row k and column l: what finite
   * elements take from the work of the loads of u_k on the displacement u_l, a
   * flexibility that is too small. The gradient of the exact displacement is
   * taken to be that in the middle of the elements averaged at their vertices
   * (Zienkiewicz and Zhu 1987), with weights as the inverse of their sizes,
   * which is exact on lines of elements of different sizes if it changes
   * linearly. Matrix m is that of the cells of this rank that are about 2^(m +
   * 1) times as large as @p element_size, so that parts which cancel each other
   * are seen; smaller cells are left out. @p thickness counts in 2D. Units: m,
   * J.
   */
  template <int dim>
  std::vector<DenseMatrix>
  energy_errors(const ElasticBody<dim>       &body,
                const double                  thickness,
                const double                  element_size,
                const std::vector<BodyField> &displacements);
} // namespace RollingContact

#endif
