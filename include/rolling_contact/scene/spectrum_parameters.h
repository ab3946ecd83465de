#ifndef rolling_contact_scene_spectrum_parameters_h
#define rolling_contact_scene_spectrum_parameters_h

#include <cstddef>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace RollingContact
{
  struct TimeSteps;

  /**
   * When a transient run ends with spectra of its forces.
   */
  enum class WriteSpectrum
  {
    automatic, ///< when a surface moves
    always,
    never
  };

  /**
   * Section `Spectrum`: spectra of the forces of a transient run.
   */
  struct SpectrumParameters
  {
    void
    declare(dealii::ParameterHandler &prm);

    /**
     * Whether a transient run ends with spectra.
     */
    bool
    wanted(const bool a_surface_moves) const
    {
      return write == WriteSpectrum::always ||
             (write == WriteSpectrum::automatic && a_surface_moves);
    }

    /**
     * Why a run of these steps has no spectra although they are wanted, a
     * sentence; empty if it has.
     */
    std::string
    why_none(const TimeSteps &steps) const;

    /**
     * Rows of a history that are left out, and those in a segment; 0: to be
     * chosen. Units: s.
     */
    std::size_t
    skipped_rows(const double time_step) const;

    std::size_t
    rows_in_segment(const double time_step) const;

    /** Fewest rows of a segment. */
    static constexpr std::size_t least_rows = 32;

    WriteSpectrum write          = WriteSpectrum::automatic;
    double        skipped_time   = 0.; ///< s
    double        segment_length = 0.; ///< s; 0 chooses
  };
} // namespace RollingContact

#endif
