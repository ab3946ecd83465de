#ifndef rolling_contact_scene_spectrum_parameters_h
#define rolling_contact_scene_spectrum_parameters_h

namespace dealii
{
  class ParameterHandler;
}

namespace RollingContact
{
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

    WriteSpectrum write          = WriteSpectrum::automatic;
    double        skipped_time   = 0.; ///< s
    double        segment_length = 0.; ///< s; 0 chooses
  };
} // namespace RollingContact

#endif
