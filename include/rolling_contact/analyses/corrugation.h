#ifndef rolling_contact_analyses_corrugation_h
#define rolling_contact_analyses_corrugation_h

#include <rolling_contact/analyses/corrugation_check.h>
#include <rolling_contact/analyses/corrugation_report.h>
#include <rolling_contact/analyses/disturbed_state.h>
#include <rolling_contact/scene/analysis_kind.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/state/steady_state.h>
#include <rolling_contact/vibration/rolling_modes.h>

namespace RollingContact
{
  /**
   * Analysis = corrugation: how small waves on rail or wheel grow or are worn
   * flat, per passage, over wavelength, speed and place in a bay of the track,
   * by friction's work in a steady rolling state that they disturb, in
   * corrugation.csv.
   */
  template <int dim>
  class Corrugation : public Analysis
  {
  public:
    Corrugation(const Situation &scene, RunContext &context);

    void run() override;

  private:
    /** All waves at one place of the track, the scene as it is there. */
    void run_at(const Situation &at);

    /** The element along x must resolve the shortest wave. */
    void require_elements(const SteadyState<dim> &steady) const;

    void warn_of_border(const LinearContact &contact) const;

    /** Tell how far growth may be off. */
    void note_errors() const;

    /** Rows of all speeds, one speed after the other. */
    std::vector<CorrugationRow>
    sweep(const WaveSweep              &whole,
          const std::vector<WaveSweep> &halves,
          const std::optional<double>  &pad_offset) const;

    /** Find the growth of the wave that grows most by the whole bodies. */
    void prove_fastest(const Situation             &at,
                       const RollingModes<dim>     &rolling,
                       const WaveSweep             &waves,
                       std::vector<CorrugationRow> &found) const;

    const Situation             &scene;
    RunContext                  &context;
    const CorrugationParameters &section;
    const std::vector<double>    wavelengths, speeds;
    std::vector<CorrugationRow>  rows;
    std::vector<CheckedWave>     followed; ///< in time
    DisturbedPlaces<dim>         track; ///< whose wheel is the same everywhere
  };

  AnalysisKind corrugation_kind();
} // namespace RollingContact

#endif
