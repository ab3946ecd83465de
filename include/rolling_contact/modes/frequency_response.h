#ifndef rolling_contact_modes_frequency_response_h
#define rolling_contact_modes_frequency_response_h

#include <rolling_contact/algebra/factorisation.h>
#include <rolling_contact/modes/structural_modes.h>

#include <complex>
#include <vector>

namespace RollingContact
{
  /**
   * The matrices of a structure that vibrates at a frequency,
   *   D = K + i H + i omega C - omega^2 M,
   * with what is lost in a cycle whatever the frequency (H = eta K of each
   * part) and viscous damping C; H and C may be empty. Units: N/m, kg, N s/m.
   */
  struct VibratingStructure
  {
    SymmetricSparseMatrix     K, M, H, C;
    std::vector<unsigned int> node_of_unknown;
  };

  /**
   * Receptances of a structure at given places: displacement at place p under a
   * harmonic force of 1 N at place q,
   *
   *   alpha_pq = phi_p^T (Lambda + i H_m + i omega C_m - omega^2)^-1 phi_q
   *              + y_p^T (K - i H - i omega C + omega^2 M) y_q,
   *
   * modes plus the static compliance of what they leave out and its first
   * correction, y = K^-1 b - Phi Lambda^-1 Phi^T b. C_m = Phi^T C Phi, with
   * 2 zeta_j omega_j added on its diagonal, H_m = Phi^T H Phi. For a body that
   * nothing holds K + shift M stands for K in y.
   */
  class FrequencyResponse
  {
  public:
    using Complex = std::complex<double>;

    /**
     * @p loads: the forces b_q of 1 N at each place; @p damping_ratios: zeta of
     * each mode. @p factor: of K + shift M.
     */
    FrequencyResponse(const VibratingStructure               &structure,
                      const Factorisation                    &factor,
                      const double                            shift,
                      const StructuralModes                  &modes,
                      const std::vector<double>              &damping_ratios,
                      const std::vector<std::vector<double>> &loads);

    /**
     * alpha, row and column by place, at a frequency (Hz). With @p
     * modal_damping = false without the damping ratios. Units: m/N.
     */
    ComplexMatrix receptances(const double frequency,
                              const bool   modal_damping = true) const;

    std::size_t n_places() const
    {
      return phi.cols();
    }

  private:
    std::vector<double> lambda, viscous_ratios;
    DenseMatrix         phi;      ///< of modes, at the places
    DenseMatrix         C_m, H_m; ///< empty without damping
    DenseMatrix         stiff, lost, viscous, heavy; ///< y_p^T (K,H,C,M) y_q
  };

  /**
   * The receptances of FrequencyResponse without its modal damping, by solving
   * D x = b of the full structure with a complex factor: what modes leave out
   * is in them. Units: Hz, m/N.
   */
  ComplexMatrix
  direct_receptances(const VibratingStructure               &structure,
                     const std::vector<std::vector<double>> &loads,
                     const double                            frequency);
} // namespace RollingContact

#endif
