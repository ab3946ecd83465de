#ifndef rolling_contact_modes_modal_fit_h
#define rolling_contact_modes_modal_fit_h

#include <rolling_contact/algebra/dense_matrix.h>

#include <functional>
#include <vector>

namespace RollingContact
{
  /** What a fit of modes is asked for. */
  struct ModalFitControls
  {
    /** Below this frequency differences count three tenths. Units: Hz. */
    double lowest = 50.;

    /** The difference at a frequency, as FittedModes::error has it, that is
     * small enough. */
    double tolerance = 0.01;

    /** Modes of motions that are coupled are not more than these. */
    unsigned int most_modes = 80;

    /** Retardation time of the compliance beyond the modes. Units: s. */
    double retardation = 0.;

    std::function<void()> interrupt = []() {};
  };

  /**
   * Modes that a body without modes of its own answers forces by, as one that
   * has no ends: with real shapes and positive damping, so that they are stable
   * and take no energy from nowhere,
   *
   *   alpha(s) = sum_j phi_j phi_j^T / (s^2 + 2 zeta_j omega_j s + omega_j^2)
   *              + R / (1 + tau s),     R symmetric and positive semi-definite.
   */
  struct FittedModes
  {
    std::vector<double> frequencies;    ///< omega_j / (2 pi). Units: Hz
    std::vector<double> damping_ratios; ///< zeta_j
    DenseMatrix         motions;        ///< phi_j by columns. Units: 1/kg^(1/2)
    DenseMatrix         rest;           ///< R. Units: m/N

    /** The largest difference from the receptances at a frequency not below the
     * lowest, over the geometric mean of those of both motions there; that of
     * imaginary parts over the mean of these, which are taken as a twentieth of
     * the receptance at least. A norm over motions that are coupled. */
    double error    = 0.;
    double error_at = 0.; ///< Hz
  };

  /**
   * Modes are added where the difference is largest, all of them adapted each
   * time by least squares (Levenberg, Marquardt), until it is small enough.
   * Motions that do not answer each other are fitted by modes of their own.
   * @p receptances: symmetric, at @p frequencies, ascending. Units: Hz, m/N.
   */
  FittedModes fit_modes(const std::vector<double>        &frequencies,
                        const std::vector<ComplexMatrix> &receptances,
                        const ModalFitControls           &controls);
} // namespace RollingContact

#endif
