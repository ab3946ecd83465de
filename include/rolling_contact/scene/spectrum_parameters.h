#ifndef rolling_contact_scene_spectrum_parameters_h
#define rolling_contact_scene_spectrum_parameters_h

#include <cstddef>
#include <string>

namespace RollingContact
{
  class Entries;

  struct TimeSteps;

  /**
   * When a transient run ends with spectra.
   */
  enum class WriteSpectrum
  {
    automatic, ///< where the scene has something that vibrates
    always,
    never
  };

  /**
   * Section `Spectrum`: spectra of the forces and velocities of a transient
   * run, their lines, and a spectrogram.
   */
  struct SpectrumParameters
  {
    void declare(Entries &entries);

    /**
     * Whether a transient run ends with spectra; @p of_interest: a surface
     * moves, a vibration is excited or points are named.
     */
    bool wanted(const bool of_interest) const
    {
      return write == WriteSpectrum::always ||
             (write == WriteSpectrum::automatic && of_interest);
    }

    /**
     * Why a run of these steps has no spectra although they are wanted, a
     * sentence; empty if it has.
     */
    std::string why_none(const TimeSteps &steps) const;

    /**
     * Rows of a history that are left out, and those in a segment; 0: to be
     * chosen. Units: s.
     */
    std::size_t skipped_rows(const double time_step) const;

    std::size_t rows_in_segment(const double time_step) const;

    /**
     * Rows in a window of the spectrogram of so many rows; chosen: those of
     * 10 ms, a quarter of them at most. Units: s.
     */
    std::size_t rows_in_window(const double      time_step,
                               const std::size_t n_rows) const;

    /** Fewest rows of a segment. */
    static constexpr std::size_t least_rows = 32;

    WriteSpectrum write          = WriteSpectrum::automatic;
    double        skipped_time   = 0.; ///< s
    double        segment_length = 0.; ///< s; 0 chooses

    double      highest_frequency = 0.;  ///< Hz; 0 chooses
    double      line_prominence   = 10.; ///< dB
    bool        spectrogram       = false;
    std::string spectrogram_signal;      ///< column of history.csv
    double      spectrogram_window = 0.; ///< s; 0 chooses

  private:
  };
} // namespace RollingContact

#endif
