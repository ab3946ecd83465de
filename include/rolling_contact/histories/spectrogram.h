#ifndef rolling_contact_histories_spectrogram_h
#define rolling_contact_histories_spectrogram_h

#include <filesystem>

namespace RollingContact
{
  struct RunContext;
  struct SceneParameters;

  /**
   * The spectrum over time of the signal that `Spectrum/Spectrogram signal`
   * chooses, from @p file, history.csv behind what is skipped: spectrogram.csv
   * and with Output/Plot spectrogram.svg. A message tells why there is none of
   * rows that are too few. Only for the root.
   */
  void
  write_spectrogram(const SceneParameters       &scene,
                    const std::filesystem::path &file,
                    RunContext                  &context);
} // namespace RollingContact

#endif
