#ifndef rolling_contact_time_modal_sound_h
#define rolling_contact_time_modal_sound_h

#include <rolling_contact/algebra/dense_matrix.h>
#include <rolling_contact/algebra/welch.h>

#include <complex>
#include <functional>
#include <vector>

namespace RollingContact::Sound
{
  /**
   * What the sound travels in. Units: kg/m^3, m/s.
   */
  struct Air
  {
    double density = 1.2;
    double speed   = 343.;
  };

  /**
   * Modes of a body that radiate together, by the part of their motion along
   * one direction e: with the velocities v_i of these modes at a frequency the
   * power is
   *
   *   rho c sigma sum_ij v_i^* R_ij v_j,    R_ij = int (n.e)^2 (phi_i . e)
   *                                                 (phi_j . e) dS
   *
   * over the outer surface. Units: m kg^(1/2)/s, m^2/kg.
   */
  struct RadiatingPart
  {
    std::vector<std::size_t>      modes;      ///< numbers, in the order of R
    DenseMatrix                   surface;    ///< R
    std::function<double(double)> efficiency; ///< sigma of a frequency in Hz
  };

  /**
   * A body by the sound of its modes: parts radiate incoherently.
   */
  struct RadiatingBody
  {
    std::vector<double>        frequencies; ///< of the modes, Hz
    std::vector<RadiatingPart> parts;
  };

  /**
   * The power that modes radiate together at a frequency, with these complex
   * root mean square velocities: a row for each mode, columns that are
   * incoherent with each other. Units: m kg^(1/2)/s, Hz, W.
   */
  double radiated_power(const RadiatingBody    &body,
                        const Eigen::MatrixXcd &velocities,
                        const double            frequency,
                        const Air              &air);

  /**
   * Frequencies that count. Units: Hz.
   */
  struct AudibleRange
  {
    double lowest  = 20.;
    double highest = 20e3;

    bool contains(const double frequency) const
    {
      return frequency >= lowest && frequency <= highest * (1 + 1e-12);
    }
  };

  /**
   * The sound of a body over a record of n steps.
   */
  struct BodySound
  {
    double power = 0.; ///< mean over the record, W

    /** By Welch's method over segments of a quarter of the record, or of 0.1 s
     * where that is longer, scaled so that its sum is the power. Units: W/Hz.
     */
    Signals::PowerSpectrum spectrum;

    /**
     * Power of each mode, in the measure of the spectrum: the power it would
     * radiate without the others, and its part of the whole power, which
     * includes half of each interference with another mode and may be negative.
     * Units: W.
     */
    std::vector<double> alone, part;

    /**
     * Spectrum of the whole record, lines 1/(n h) apart from 0 on: the power of
     * each line, W, and the sum over modes of sqrt(sigma R_ii) times the
     * complex amplitude.
     */
    std::vector<double>               line_powers;
    std::vector<std::complex<double>> line_signals;
  };

  /**
   * The sound of a body with these velocities of its modes, a vector of equal
   * length for each, at equal steps. Units: m kg^(1/2)/s, s.
   */
  BodySound body_sound(const RadiatingBody                    &body,
                       const std::vector<std::vector<double>> &velocities,
                       const double                            time_step,
                       const Air                              &air,
                       const AudibleRange                     &range);
} // namespace RollingContact::Sound

#endif
