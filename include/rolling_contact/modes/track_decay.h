#ifndef rolling_contact_modes_track_decay_h
#define rolling_contact_modes_track_decay_h

#include <rolling_contact/algebra/third_octaves.h>

#include <functional>
#include <optional>
#include <vector>

namespace RollingContact
{
  /**
   * Places where EN 15461 strikes a rail, 29 of them up to 66 sleeper bays from
   * an accelerometer, and the decay rate that it makes of what is measured,
   *
   *   rate = 10 lg e / sum_n |A(x_n)|^2 / |A(0)|^2 dx_n,
   *
   * A a mobility; dx_n reaches from half-way to the place before to half-way to
   * the next one, from 0 at the first place, as far ahead as behind at the
   * last. A = A(0) exp(-b x) has 20 lg e b. Units: m, dB/m.
   *
   * Source: EN 15461:2008+A1:2010, clauses 6.7 and 7, Figure 2, Annex A.
   */
  class DecayGrid
  {
  public:
    /** @p bay: from sleeper to sleeper, 0.6 m where there are none. Units: m.
     */
    explicit DecayGrid(const double bay);

    /** x_n, from 0 on. Units: m. */
    const std::vector<double> &distances() const
    {
      return x;
    }

    /** Decay rate by |A|^2 at distances(), in any unit. Units: dB/m. */
    double rate(const std::vector<double> &energies) const;

    /** Rates below twice this are no more than bounds from above, as the grid
     * ends: 10 lg e over its length. Units: dB/m. */
    double floor() const;

  private:
    std::vector<double> x;
  };

  /**
   * A third octave in which a track is measured, by its nominal centre, and the
   * decay rates that a track for type tests has at least. Units: Hz, dB/m.
   *
   * Source: ISO 3095:2013, Figure 3, 250 Hz to 5 kHz.
   */
  struct DecayBand
  {
    double                nominal;
    std::optional<double> vertical_limit, lateral_limit;

    /** The band of base ten that has this name. */
    Signals::ThirdOctave exact() const;

    /**
     * Means of values, one by one, at frequencies in the middle of so many
     * equal parts of the band. Units: Hz.
     */
    std::vector<double>
    mean(const unsigned int                                      n_lines,
         const std::function<std::vector<double>(const double)> &at) const;
  };

  /**
   * Bands from 100 Hz to 5 kHz whose nominal centre is not outside of a range.
   * Units: Hz.
   */
  std::vector<DecayBand> decay_bands(const double lowest, const double highest);
} // namespace RollingContact

#endif
