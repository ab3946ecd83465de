#ifndef rolling_contact_time_spectrogram_h
#define rolling_contact_time_spectrogram_h

namespace RollingContact
{
  class HistoryTable;
  struct RunContext;
  struct Situation;

  /**
   * The spectrum over time of the signal that `Spectrum/Spectrogram signal`
   * chooses, from the rows of history.csv behind what is skipped:
   * spectrogram.csv and with Output/Plot spectrogram.svg. A message tells why
   * there is none of rows that are too few. Only for the root.
   */
  void write_spectrogram(const Situation    &scene,
                         const HistoryTable &history,
                         RunContext         &context);
} // namespace RollingContact

#endif
