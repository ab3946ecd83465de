#ifndef rolling_contact_stability_contact_response_h
#define rolling_contact_stability_contact_response_h

#include <rolling_contact/algebra/dense_matrix.h>
#include <rolling_contact/stability/linear_contact.h>
#include <rolling_contact/stability/reduced_pair.h>

namespace RollingContact
{
  /**
   * A linearised contact on what the modes of a pair leave out, W_res and tau,
   * as a pencil in s,
   *
   *   statics + s viscosity
   *     = [(N_u + s N_v) W_res forces + (1 + tau s) N_r + s N_s],
   *
   * of unknowns of which (1 + tau s) are tractions and pressures. The term tau
   * s N_r acts on these alone.
   */
  struct ResidualContact
  {
    ResidualContact(const LinearContact &contact, const ReducedPair &pair);

    DenseMatrix statics;   ///< n_x x n_x
    DenseMatrix viscosity; ///< n_x x n_x, s
  };

  /**
   * How a contact answers motions U of the patch, as complex stiffness:
   *
   *   G(s) = -U^T forces [(N_u + s N_v) W_res / (1 + tau s) forces
   *              + N_r + s N_s]^-1 (N_u + s N_v) U,
   *
   * with what the modes of a pair leave out, W_res and tau: the generalised
   * forces of unit motions that go as exp(s t). Smooth in s but for its poles,
   * the eigenvalues of the contact with bodies that stand still. Units: 1/s,
   * N/m if U has none.
   */
  class ContactResponse
  {
  public:
    ContactResponse(const LinearContact &contact,
                    const ReducedPair   &pair,
                    const DenseMatrix   &U);

    /**
     * G(s), by a solution with the unknowns of the contact.
     */
    ComplexMatrix operator()(const std::complex<double> s) const;

    /**
     * Its finite poles, found by a real @p shift. Units: 1/s.
     */
    ComplexValues poles(const double shift) const;

  private:
    /**
     * Normal rows are in m, those of slip in Pa: solutions want them alike.
     */
    void scale_rows();

    ResidualContact residual;
    DenseMatrix     motion, velocity;
    double          retardation;
    ComplexMatrix   reaction;
  };
} // namespace RollingContact

#endif
