#ifndef rolling_contact_scene_run_signals_h
#define rolling_contact_scene_run_signals_h

#include <string>
#include <vector>

namespace RollingContact
{
  struct SceneParameters;

  /**
   * What a signal of a transient run is of, which gives its unit and what its
   * level is related to.
   */
  enum class SignalKind
  {
    force,   ///< N, levels re 1 N
    height,  ///< m, levels re 1 um
    velocity ///< m/s, levels re 1 nm/s, ISO 1683
  };

  /**
   * A column of history.csv that spectra are made of.
   */
  struct RunSignal
  {
    std::string column; ///< its name with the unit
    std::string name;   ///< the same without
    std::string label;  ///< in pictures
    SignalKind  kind;
  };

  /**
   * The signals that the spectra of a transient run are of: forces, heights of
   * surfaces that move, velocities of the contact and of named points, as far
   * as the scene has them.
   */
  std::vector<RunSignal> run_signals(const SceneParameters &scene);

  /**
   * The signal that the spectrogram is of, `Spectrum/Spectrogram signal`, or
   * the lateral velocity of the contact, in 2D that along. Throws InputError
   * if there is no such signal.
   */
  RunSignal spectrogram_signal(const SceneParameters &scene);
} // namespace RollingContact

#endif
