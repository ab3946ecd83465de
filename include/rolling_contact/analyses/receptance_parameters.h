#ifndef rolling_contact_analyses_receptance_parameters_h
#define rolling_contact_analyses_receptance_parameters_h

#include <rolling_contact/base/side.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace RollingContact
{
  class Entries;

  /**
   * Section `Receptance`: where and at which frequencies the bodies are
   * excited and measured.
   */
  struct ReceptanceParameters
  {
    /**
     * A named place on a body, in the coordinates of the rail's frame: x along
     * the rolling direction, z from rail to wheel, the contact point 0. Units:
     * m.
     */
    struct Place
    {
      std::string           name;
      Side                  side;
      std::array<double, 3> point;
    };

    void declare(Entries &entries);

    /**
     * Throws InputError.
     */
    void check() const;

    /** Rules in 2D. Throws InputError. */
    void check_in_2d() const;

    /**
     * The contact point and the places named in `Points` on a body.
     */
    std::vector<Place> places(const Side side) const;

    /**
     * The axes (0, 1, 2: x, y, z) of `Directions`.
     */
    std::vector<unsigned int> axes() const;

    /**
     * From the lowest to the highest with equal ratios, both included. Units:
     * Hz.
     */
    std::vector<double> frequencies() const;

    double       lowest_frequency  = 20.;   ///< Hz
    double       highest_frequency = 5000.; ///< Hz
    unsigned int per_octave        = 48;
    std::string  points;
    std::string  directions  = "z, y";
    double       load_radius = 0.01; ///< m

    /** Where the whole structure is solved as well. Units: Hz. */
    std::vector<double> check_frequencies;

    bool decay_rates = false; ///< of the rail, see TrackDecay

    std::string measured_wheel, measured_rail; ///< files
  };
} // namespace RollingContact

#endif
