#ifndef rolling_contact_analyses_track_decay_h
#define rolling_contact_analyses_track_decay_h

#include <rolling_contact/analyses/receptance_parameters.h>
#include <rolling_contact/modes/track_decay.h>
#include <rolling_contact/run/results_table.h>
#include <rolling_contact/vibration/vibrating_body.h>

#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * How vibrations of a rail fade along it, as EN 15461 measures it:
   * track_decay.csv, a table on the screen and a picture. The rail is struck at
   * its contact point, vertically and across, and moves as `receptances.csv`
   * has it there, and along its running surface towards positive x.
   */
  class TrackDecay
  {
  public:
    TrackDecay(const VibratingBody<3>     &rail,
               const ReceptanceParameters &section,
               RunContext                 &context);

    /**
     * Compute and write all of it. Throws ConvergenceError where nothing on
     * pads fades.
     */
    void write(const bool plot) const;

    /** Least decay of the waves at a frequency that move mostly along an axis;
     * NaN where they are not known: on pads and of a mesh. Units: Hz, dB/m. */
    double least_decay(const unsigned int axis, const double frequency) const;

    /** Rules for the rail. Throws InputError. */
    static void check(const BodyParameters       &rail,
                      const unsigned int          dimension,
                      const ReceptanceParameters &section);

  private:
    /** What is drawn of a direction. */
    struct Curves
    {
      std::vector<double> centres, rates, waves, limits;
    };

    /** The rates of all bands, by directions. */
    std::vector<Curves> curves() const;

    void add_row(const std::vector<Curves> &curves,
                 const std::size_t          band,
                 ResultsTable              &table) const;

    void warn_of_floor(const std::vector<Curves> &curves) const;

    void draw(const std::vector<Curves> &curves) const;

    const VibratingBody<3>      &rail;
    const ReceptanceParameters  &section;
    RunContext                  &context;
    const DecayGrid              grid;
    const std::vector<DecayBand> bands;
  };
} // namespace RollingContact

#endif
