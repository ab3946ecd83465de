#ifndef rolling_contact_pair_moving_surfaces_h
#define rolling_contact_pair_moving_surfaces_h

#include <rolling_contact/scene/pair_spec.h>
#include <rolling_contact/surfaces/filtered_record.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace RollingContact
{
  struct SurfacePassage;

  /**
   * Sizes of the elements of a zone of contact nodes and how far it reaches
   * from the origin, along x and y. Units: m.
   */
  struct ZoneSizes
  {
    std::array<double, 2> element, reach;
  };

  /**
   * What of measured surfaces the elements see: the shortest waves along x and
   * y that their filter passes, of half of it none, 0 along y without a map,
   * and the root mean square of the gradient that is left. Units: m, 1.
   */
  struct ResolvedWaves
  {
    std::array<double, 2> shortest;
    double                rms_slope = 0.;
  };

  /**
   * Heights of wheel and rail that move with the material, section `Surfaces`,
   * on the nodes of a zone of contact. When the material has moved by s along x
   * from t = 0, at x is its point X = x - s - flow * Position, flow being the
   * sign of the speed: an expression's height at X. A file's positions count as
   * the wheel runs, -flow * X; y of a map is the frame's. A wheel and other
   * discs come again after a turn, for expressions with X within half a turn of
   * 0. Beside them what stands, Contact/Roughness from a file, with positions
   * along x. Units: m.
   */
  class MovingSurfaces
  {
  public:
    /**
     * Filter the scene's records for the elements and look at what expressions
     * have, along all that the run lets pass. Throws InputError: waves of fewer
     * than two elements, steps, heights beyond reason, a record that ends
     * before the run, a map that ends within the zone, a tread that does not
     * close where the run comes to it.
     */
    MovingSurfaces(const PairSpec &scene, const ZoneSizes &sizes);

    bool in_use() const
    {
      return moves;
    }

    /**
     * Sum of the heights of both bodies at a place of the frame after the
     * material moved by @p travelled along x since t = 0.
     */
    double height(const double x, const double y, const double travelled) const;

    /** Height that stands at a place of the frame, 0 without a file of it. */
    double standing_height(const double x, const double y) const;

    /** Heights at many places. Units: m. */
    std::vector<double> heights(const std::vector<std::array<double, 2>> &at,
                                const double travelled) const;

    /**
     * What share of mu there is at the places then, Surfaces/Friction share of
     * the rail's material. Throws InputError if it is not between 0 and 1.
     */
    std::vector<double>
    friction_shares(const std::vector<std::array<double, 2>> &at,
                    const double                              travelled) const;

    /** What was filtered, to be told. */
    std::vector<std::string> notes, warnings;

    /** Where a file gives heights. */
    std::optional<ResolvedWaves> resolved;

    class Surface;

  private:
    /** The surface of a file for these elements, and what is told of it. */
    std::shared_ptr<const Surface>
    filtered(const std::shared_ptr<const SurfaceRecord> &record,
             const ZoneSizes                            &sizes,
             const SurfacePassage                       &passage,
             const double                                shortest_wavelength);

    bool                                    moves;
    double                                  flow, position;
    std::shared_ptr<const HeightExpression> share; ///< of mu; or none
    PerSide<std::shared_ptr<const Surface>> surfaces;
    std::shared_ptr<const Surface>          standing; ///< or none
  };

  /**
   * How far from the origin rigid bodies touch as dents of their surfaces pass,
   * such as on the edges of a flat; 0 without dents. Units: m.
   */
  double farthest_contact_of_dents(const PairSpec &scene);

  /**
   * Throws InputError, before anything is meshed, if the surfaces do not suit
   * elements of the size that the estimated patch asks for.
   */
  void check_moving_surfaces(const PairSpec &scene);
} // namespace RollingContact

#endif
