#ifndef rolling_contact_analyses_corrugation_check_h
#define rolling_contact_analyses_corrugation_check_h

#include <rolling_contact/analyses/corrugation_parameters.h>
#include <rolling_contact/analyses/wave_in_time.h>
#include <rolling_contact/run/run_context.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/state/steady_state.h>

#include <complex>
#include <optional>
#include <vector>

namespace RollingContact
{
  /**
   * A wave that was followed in time, at a speed and a place of the track, and
   * what a small one does there.
   */
  struct CheckedWave
  {
    std::optional<double> pad_offset; ///< m; none without pads
    double                speed = 0., wavelength = 0., amplitude = 0.;

    /** Growth of a small wave, with the wear coefficient asked for. */
    std::complex<double> growth;
    std::complex<double> load; ///< of a small wave, N/m

    /** With this wear coefficient, too. */
    WaveInTime in_time;

    /** Growth in time over that of a small wave. */
    std::complex<double> ratio() const
    {
      return in_time.growth / growth;
    }

    /** By how much growth in time leads. Units: degrees. */
    double phase() const;
  };

  /**
   * Throws InputError where the wave that is to be followed in time has a
   * frequency beyond the modes, or too few elements of this length along x (m),
   * which is 0 before there is a mesh.
   */
  void check_followed_wave(const CorrugationParameters &section,
                           const double                 radius,
                           const double                 fastest,
                           const double                 highest_frequency,
                           const double                 element);

  /**
   * Follow the wave that the section asks for in time, at all speeds of @p
   * waves over the steady state of the scene @p at, at that pad @p offset (m).
   * Tells how each compares. Throws ConvergenceError.
   */
  template <int dim>
  std::vector<CheckedWave> followed_waves(const Situation             &at,
                                          const SteadyState<dim>      &steady,
                                          const WaveSweep             &waves,
                                          const std::vector<double>   &speeds,
                                          const std::optional<double> &offset,
                                          RunContext                  &context);

  /** Write corrugation_check.csv and tell the largest difference. */
  void report_followed_waves(const std::vector<CheckedWave> &found,
                             RunContext                     &context);
} // namespace RollingContact

#endif
