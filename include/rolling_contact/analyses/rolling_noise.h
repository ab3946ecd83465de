#ifndef rolling_contact_analyses_rolling_noise_h
#define rolling_contact_analyses_rolling_noise_h

#include <rolling_contact/algebra/third_octaves.h>
#include <rolling_contact/analyses/disturbed_state.h>
#include <rolling_contact/analyses/rolling_noise_parameters.h>
#include <rolling_contact/analyses/rolling_noise_report.h>
#include <rolling_contact/run/run_context.h>
#include <rolling_contact/scene/analysis_kind.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/stability/passing_waves.h>
#include <rolling_contact/state/steady_state.h>
#include <rolling_contact/time/radiating_rail.h>
#include <rolling_contact/vibration/rolling_modes.h>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace RollingContact
{
  /**
   * Analysis = rolling noise: the sound that wheel and rail radiate by the
   * roughness of their surfaces, in third octaves over speed, without steps in
   * time: waves over a steady rolling state excite the modes of the bodies, by
   * the contact as it is linearised there, in rolling_noise.csv.
   */
  class RollingNoise : public Analysis
  {
  public:
    RollingNoise(const Situation &scene, RunContext &context);

    void run() override;

  private:
    /** A body that radiates by its modes, and where these stand among all
     * coordinates, or by all the length of a rail without ends. */
    struct Radiator
    {
      double power(const PassingWaves::Passed &passed,
                   const Eigen::Index          n_waves,
                   const double                frequency,
                   const Sound::Air           &air) const;

      Side                                  side;
      Sound::RadiatingBody                  body  = {};
      std::size_t                           first = 0;
      std::shared_ptr<Sound::RadiatingRail> rail  = {};
    };

    /** The third octaves that are told at a speed. */
    std::vector<Signals::ThirdOctave> bands_at(const double speed) const;

    /** All speeds with the scene as it is at one place of the track. */
    std::vector<NoiseOfSpeed> noise_at(const Situation &at);

    void find_radiators(const RollingModes<3> &rolling);

    /** Reactions of the patches to waves of all speeds, at all bands. */
    std::vector<PassingWaves> passing_waves(const WaveSweep &sweep) const;

    /** What a unit of roughness makes of power and load at a frequency. */
    Eigen::ArrayXd unit_powers(const PassingWaves &waves,
                               const ModalFactors &modal,
                               const double        frequency,
                               const double        speed) const;

    NoiseBand band_at(const PassingWaves         &waves,
                      const Signals::ThirdOctave &third_octave,
                      const double                speed);

    /** See NoiseOfSpeed::uncertainty. */
    std::optional<double>
    uncertainty_at(const std::size_t                             speed,
                   const std::vector<PassingWaves>              &whole,
                   const std::vector<std::vector<PassingWaves>> &halves,
                   const NoiseOfSpeed                           &found) const;

    /** Tell how far it may be off, and write what was found. */
    void report(const std::vector<NoiseOfSpeed> &found);

    const Situation              &scene;
    RunContext                   &context;
    const RollingNoiseParameters &section;
    const std::vector<double>     speeds;
    Sound::Air                    air;
    Roughness                     roughness;
    std::vector<Radiator>         radiators;
    double                        load     = 0.; ///< N
    std::size_t                   n_coarse = 0;
    DisturbedPlaces<3>            track; ///< whose wheel is the same everywhere
  };

  AnalysisKind rolling_noise_kind();
} // namespace RollingContact

#endif
