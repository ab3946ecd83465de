#ifndef rolling_contact_surfaces_filtered_record_h
#define rolling_contact_surfaces_filtered_record_h

#include <rolling_contact/algebra/low_pass.h>
#include <rolling_contact/surfaces/surface_record.h>

namespace RollingContact
{
  /**
   * A record or a map as a smooth surface without waves that elements cannot
   * follow: a zero-phase low pass, then a spline, cubic in either direction.
   * Units: m.
   */
  class FilteredRecord
  {
  public:
    /**
     * A record that goes once around a @p circumference, to 1 %, is scaled to
     * it and goes on periodically, with the slope along that was taken out;
     * others, and all if it is 0, go on as mirror
     * images beyond their ends, as maps do across. Of a map a wave with the
     * wave numbers k along and l across has the amplitude of one with
     *
     *   sqrt(k^2 + (stretch l)^2)
     *
     * along. Units: m, 1.
     */
    FilteredRecord(const SurfaceRecord   &record,
                   const Signals::CutOff &cut_off,
                   const double           circumference,
                   const double           stretch = 1.);

    /** Height at a position along and a place across, which does not matter if
     * it is no map. */
    double value(const double position, const double y = 0.) const;

    bool is_periodic() const
    {
      return along.period > 0.;
    }

    /** Forget what of a map is more than a line beyond these places. */
    void keep_across(const double least_y, const double most_y);

    /** Root mean squares of what was there and of what the filter took. */
    double rms = 0., removed_rms = 0.;

    /** Largest slope of what is left from point to point, and where. */
    double steepest = 0., steepest_at = 0., steepest_y = 0.;

    /** Root mean square of the gradient of what is left. */
    double rms_slope = 0.;

  private:
    /** Points along a direction and how they go on beyond their ends. */
    struct Axis
    {
      double      begin = 0., spacing = 1., period = 0.;
      std::size_t n = 1;

      /** The cubic B-splines at a place: four points and their weights. */
      struct Splines;

      Splines at(const double place) const;
    };

    void measure_slopes(const std::vector<double> &smooth);

    Axis                along, across;
    std::size_t         first_kept = 0; ///< line
    std::vector<double> coefficients;   ///< of the splines, line after line
  };
} // namespace RollingContact

#endif
