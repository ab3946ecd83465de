#ifndef rolling_contact_pair_passing_surface_h
#define rolling_contact_pair_passing_surface_h

#include <rolling_contact/pair/moving_surfaces.h>

namespace RollingContact
{
  /**
   * Height over the coordinate X of the material, see MovingSurfaces, and y.
   * Units: m.
   */
  class MovingSurfaces::Surface
  {
  public:
    virtual ~Surface() = default;

    virtual double height(const double X, const double y) const = 0;

    /** Throws InputError where there is no surface under the wheel, at X. */
    virtual void require(const double) const
    {}
  };

  /**
   * How a surface passes: how far the wheel has rolled, Position included,
   * while the run lasts, the sign of the speed and the length of a turn, 0 for
   * what is no disc. What stands has positions along x. Units: m.
   */
  struct SurfacePassage
  {
    double least = 0., most = 0.;
    double flow    = -1.;
    double turn    = 0.;
    bool   stands  = false;
    bool   is_even = true; ///< the zone reaches as far on both sides
  };

  /** Elements in the shortest wave that passes a filter; half as many in the
   * longest that does not. */
  inline constexpr double elements_in_wave = 4.;

  /**
   * A file's heights. Of a line what lies beyond its ends are mirror images
   * while the wheel is between them; a map, and what stands, is known where
   * nodes may touch.
   */
  class RecordSurface : public MovingSurfaces::Surface
  {
  public:
    RecordSurface(const std::shared_ptr<const SurfaceRecord> &record,
                  const FilteredRecord                       &filtered,
                  const ZoneSizes                            &sizes,
                  const SurfacePassage                       &passage)
      : record(record)
      , filtered(filtered)
      , passage(passage)
      , margin(record->is_map() || passage.stands
                 ? sizes.reach[0] + (passage.stands ? 0. : sizes.element[0])
                 : 0.)
      , reach_y(record->is_map() && passage.is_even ? sizes.reach[1] : 0.)
    {}

    double height(const double X, const double y) const override
    {
      const double at = -passage.flow * X;
      if (record->is_map() || passage.stands)
        require_inside({at, at}, {y, y}, "what may touch reaches");
      return filtered.value(at, y);
    }

    void require(const double X) const override
    {
      require(-passage.flow * X, -passage.flow * X);
    }

    /** Refuse to roll beyond an end of what is known. */
    void require(const double least, const double most) const
    {
      require_inside({least - margin, most + margin},
                     {-reach_y, reach_y},
                     margin == 0. ? "the wheel rolls"
                                  : "what may touch reaches");
    }

  private:
    using Range = std::array<double, 2>;

    void require_inside(const Range       &along,
                        const Range       &across,
                        const std::string &what) const;

    const std::shared_ptr<const SurfaceRecord> record;
    const FilteredRecord                       filtered;
    const SurfacePassage                       passage;
    const double                               margin, reach_y;
  };

  /**
   * Throws InputError for what a record cannot do for this zone: too coarse
   * points, waves of less than four elements along or across, slopes beyond
   * reason in what the filter left.
   */
  void check_record(const SurfaceRecord         &record,
                    const FilteredRecord        &filtered,
                    const std::array<double, 2> &shortest,
                    const ZoneSizes             &sizes);
} // namespace RollingContact

#endif
