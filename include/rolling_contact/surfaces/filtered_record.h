#ifndef rolling_contact_surfaces_filtered_record_h
#define rolling_contact_surfaces_filtered_record_h

#include <rolling_contact/algebra/low_pass.h>
#include <rolling_contact/surfaces/surface_record.h>

#include <memory>

namespace RollingContact
{
  /**
   * A record as a smooth curve without waves that elements cannot follow: a
   * zero-phase low pass, then a cubic spline. Units: m.
   */
  class FilteredRecord
  {
  public:
    /**
     * A record that goes once around a @p circumference, to 1 %, is scaled to
     * it and goes on periodically; others, and all if it is 0, go on as mirror
     * images beyond their ends. Units: m.
     */
    FilteredRecord(const SurfaceRecord   &record,
                   const Signals::CutOff &cut_off,
                   const double           circumference);

    double value(const double position) const;

    bool is_periodic() const
    {
      return period > 0.;
    }

    /** Root mean squares of what was there and of what the filter took. */
    double rms = 0., removed_rms = 0.;

  private:
    double begin = 0., end = 0., period = 0.;
    class Curve;
    std::shared_ptr<const Curve> curve;
  };
} // namespace RollingContact

#endif
