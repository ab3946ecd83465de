#ifndef rolling_contact_analyses_corrugation_parameters_h
#define rolling_contact_analyses_corrugation_parameters_h

#include <rolling_contact/analyses/pad_places.h>
#include <rolling_contact/base/side.h>

#include <string>
#include <vector>

namespace RollingContact
{
  class Entries;

  /**
   * Section `Corrugation`: which waves pass the contact, how fast, where in a
   * bay of the track, and how the body that has them wears.
   */
  struct CorrugationParameters
  {
    void declare(Entries &entries);

    /** Throws InputError unless wavelengths and speeds are above 0, and the
     * wave that is followed in time is flat. */
    void check() const;

    /** Whether a wave is followed in time, too. */
    bool follows_wave() const
    {
      return check_wavelength > 0.;
    }

    /** The length of the wave that is followed in time; one round a wheel of
     * this @p radius (m) fits it, if it is the wheel that wears. Units: m. */
    double check_wavelength_round(const double radius) const;

    /** Ascending; those round a wheel of this @p radius (m) fit it, if it is
     * the wheel that wears. Throws InputError. Units: m. */
    std::vector<double> wavelengths_round(const double radius) const;

    /** Ascending; @p given if there are none. Throws InputError. Units: m/s. */
    std::vector<double> speeds_or(const double given) const;

    /** Throws InputError. */
    PadPlaces places() const
    {
      return {"Corrugation", pad_offsets};
    }

    std::string wavelengths      = "0.02 : 0.2 : 60";
    std::string speeds           = "";
    Side        worn             = Side::rail;
    double      wear_coefficient = 6.75e-13; ///< m^3/J
    double      passages         = 1e6;
    std::string pad_offsets      = "";
    double      check_wavelength = 0.;   ///< m, 0: none
    double      check_amplitude  = 1e-8; ///< m
  };
} // namespace RollingContact

#endif
