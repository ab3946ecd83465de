#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/pair/mesh_limits.h>
#include <rolling_contact/pair/moving_surfaces.h>
#include <rolling_contact/pair/patch_estimate.h>
#include <rolling_contact/references/hertz_line.h>
#include <rolling_contact/surfaces/crown.h>
#include <rolling_contact/surfaces/expression_check.h>
#include <rolling_contact/surfaces/record_notes.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  /**
   * Height over the coordinate X of the material, see MovingSurfaces, and y.
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

  namespace
  {
    /** Elements in the shortest wave that passes a filter; half as many in the
     * longest that does not. */
    const double elements_in_wave = 4.;

    /**
     * How far the wheel has rolled, Position included, while the run lasts.
     */
    struct Rolled
    {
      double least, most;
    };

    /** Length of a turn; 0 for what is no disc. */
    double turn_of(const PairSpec &scene, const Side side)
    {
      const BodySpec &body = scene.body(side);
      const bool      is_disc =
        body.shape == "disc" || (side == Side::wheel && body.radius > 0.);
      return is_disc ? 2 * pi * std::abs(body.radius) : 0.;
    }

    class ExpressionSurface : public MovingSurfaces::Surface
    {
    public:
      ExpressionSurface(const HeightExpression &expression, const double turn)
        : expression(expression)
        , turn(turn)
      {}

      double height(const double X, const double y) const override
      {
        return expression.value(turn > 0. ? X - turn * std::round(X / turn) : X,
                                y);
      }

    private:
      const HeightExpression expression;
      const double           turn;
    };

    class CrownSurface : public MovingSurfaces::Surface
    {
    public:
      CrownSurface(const Crown &crown, const Crown::Roller &roller)
        : crown(crown)
        , roller(roller)
      {}

      double height(const double, const double y) const override
      {
        return -crown.drop(y, roller);
      }

    private:
      const Crown         crown;
      const Crown::Roller roller;
    };

    /** The line contact under the load of a crown. */
    Crown::Roller roller_of(const PairSpec &scene, const Crown &crown)
    {
      const PairConstants constants = pair_constants(scene);
      const double        length    = 2 * narrower_reach(scene);
      return {length,
              References::hertz_line(crown.load / length,
                                     constants.relative_radius,
                                     constants.contact_modulus)
                .half_width,
              constants.contact_modulus};
    }

    class RecordSurface : public MovingSurfaces::Surface
    {
    public:
      RecordSurface(const std::shared_ptr<const SurfaceRecord> &record,
                    const FilteredRecord                       &filtered,
                    const double                                flow,
                    const double                                turn)
        : record(record)
        , filtered(filtered)
        , flow(flow)
        , turn(turn)
      {}

      double height(const double X, const double) const override
      {
        return filtered.value(-flow * X);
      }

      void require(const double X) const override
      {
        require(Rolled{-flow * X, -flow * X});
      }

      /** Refuse to roll beyond an end of the record. */
      void require(const Rolled &rolled) const;

    private:
      const std::shared_ptr<const SurfaceRecord> record;
      const FilteredRecord                       filtered;
      const double                               flow, turn;
    };

    void RecordSurface::require(const Rolled &rolled) const
    {
      const double rounding = 1e-6 * record->spacing;
      if (filtered.is_periodic() || (rolled.least >= record->begin - rounding &&
                                     rolled.most <= record->end() + rounding))
        return;
      throw InputError(
        record->entry + ": \"" + record->file + "\": it goes from " +
        significant(record->begin, 6) + " to " + significant(record->end(), 6) +
        " m, and the wheel rolls " +
        (rolled.least < rolled.most
           ? "from " + significant(rolled.least, 6) + " to "
           : "to ") +
        significant(rolled.most, 6) +
        " m of it. Take another Surfaces/Position or Position unit, a shorter "
        "run or a longer record" +
        (turn > 0. ? ", or one of the whole turn of " + significant(turn, 6) +
                       " m, which comes again."
                   : "."));
    }

    /**
     * Refuses what a record cannot do for this zone.
     */
    void check_record(const SurfaceRecord &record,
                      const double         shortest,
                      const ZoneSizes     &sizes)
    {
      const std::string file = record.entry + ": \"" + record.file + "\": ";
      if (record.spacing > 2 * sizes.reach[0])
        throw InputError(
          file + "its points are " + significant(record.spacing, 4) +
          " m apart, more than the " + significant(2 * sizes.reach[0], 3) +
          " m that may touch. Check Surfaces/Position unit, or take a finer "
          "record.");
      if (shortest < elements_in_wave * sizes.element[0] * (1 - 1e-9))
        throw InputError(
          "Surfaces/Shortest wavelength = " + significant(shortest, 4) +
          ": at least 4 elements make a wave, " +
          significant(elements_in_wave * sizes.element[0], 4) +
          " m on this mesh. Take a longer one, 0, or more Mesh/Elements across "
          "patch.");
    }

    /** First and last X of the material that passes the zone. */
    std::array<double, 2> material_that_passes(const Rolled    &rolled,
                                               const double     flow,
                                               const ZoneSizes &sizes)
    {
      // the flow brings what lies against it
      const auto [first, last] =
        std::minmax({-flow * rolled.least, -flow * rolled.most});
      return {{first - sizes.reach[0], last + sizes.reach[0]}};
    }

    /**
     * Hold an expression against the elements, and add what is to be warned of.
     */
    void examine(const HeightExpression        &expression,
                 const MovingSurfaces::Surface &surface,
                 Examined                       it,
                 const std::array<double, 2>   &passes,
                 const double                   turn,
                 const ZoneSizes               &sizes,
                 std::vector<std::string>      &warnings)
    {
      const auto add = [&](const std::string &warning) {
        if (!warning.empty())
          warnings.push_back(warning);
      };
      const auto [begin, end] = passes;
      it.axis                 = "x";
      it.element              = sizes.element[0];
      if (turn > 0.)
        check_seam(expression, it, turn, begin, end);
      const auto along_x = [&](const double X) {
        return surface.height(X, 0.);
      };
      add(judge(it, short_waves(along_x, begin, end, it.element)));
      if (!expression.depends_on_y())
        return;
      const double middle = begin + sizes.reach[0];
      it.axis             = "y";
      it.element          = sizes.element[1];
      const auto along_y  = [&](const double y) {
        return surface.height(middle, y);
      };
      add(judge(
        it, short_waves(along_y, -sizes.reach[1], sizes.reach[1], it.element)));
    }
  } // namespace

  MovingSurfaces::MovingSurfaces(const PairSpec &scene, const ZoneSizes &sizes)
    : moves(scene.surfaces.in_use())
    , flow(scene.contact.flow())
    , position(scene.surfaces.position)
    , share(scene.surfaces.share)
  {
    if (!moves)
      return;
    const SurfaceSpec &given = scene.surfaces;
    const Rolled       rolled{given.least_rolled, given.most_rolled};
    const double       shortest = given.shortest_wavelength > 0.
                                    ? given.shortest_wavelength
                                    : elements_in_wave * sizes.element[0];
    for (const Side side : both_sides)
      {
        const double turn = turn_of(scene, side);
        if (const auto crown =
              crown_named(given.entry(side), given.height[side]))
          surfaces[side] =
            std::make_shared<const CrownSurface>(*crown,
                                                 roller_of(scene, *crown));
        if (const auto &record = given.records[side])
          {
            const FilteredRecord filtered(*record,
                                          {shortest, shortest / 2},
                                          turn);
            check_record(*record, shortest, sizes);
            const auto surface = std::make_shared<const RecordSurface>(record,
                                                                       filtered,
                                                                       flow,
                                                                       turn);
            surface->require(rolled);
            surfaces[side] = surface;
            notes.push_back(note_of_filter(*record, filtered, shortest));
            if (const std::string doubt = doubt_of_ends(*record);
                filtered.is_periodic() && !doubt.empty())
              warnings.push_back(doubt);
          }
        if (const auto &expression = given.expressions[side])
          {
            surfaces[side] =
              std::make_shared<const ExpressionSurface>(*expression, turn);
            examine(*expression,
                    *surfaces[side],
                    {given.entry(side), given.height[side], "", 0.},
                    material_that_passes(rolled, flow, sizes),
                    turn,
                    sizes,
                    warnings);
          }
      }
  }

  double MovingSurfaces::height(const double x,
                                const double y,
                                const double travelled) const
  {
    double sum = 0.;
    for (const Side side : both_sides)
      if (surfaces[side])
        {
          surfaces[side]->require(-travelled - flow * position);
          sum += surfaces[side]->height(x - travelled - flow * position, y);
        }
    return sum;
  }

  std::vector<double>
  MovingSurfaces::heights(const std::vector<std::array<double, 2>> &at,
                          const double travelled) const
  {
    std::vector<double> result;
    for (const auto &[x, y] : at)
      result.push_back(moves ? height(x, y, travelled) : 0.);
    return result;
  }

  std::vector<double>
  MovingSurfaces::friction_shares(const std::vector<std::array<double, 2>> &at,
                                  const double travelled) const
  {
    std::vector<double> result(at.size(), 1.);
    for (std::size_t i = 0; share && i < at.size(); ++i)
      {
        const double X = at[i][0] - travelled - flow * position;
        result[i]      = share->value(X, at[i][1]);
        if (!(result[i] >= 0. && result[i] <= 1.))
          throw InputError("Surfaces/Friction share is " +
                           significant(result[i], 6) +
                           " at x = " + significant(X, 6) +
                           " m, y = " + significant(at[i][1], 6) +
                           " m: it must be from 0 to 1, the share of "
                           "Contact/Friction coefficient that there is.");
      }
    return result;
  }

  void check_moving_surfaces(const PairSpec &scene)
  {
    if (!scene.surfaces.in_use())
      return;
    const PatchEstimate patch = estimate_patch(scene);
    const double        n     = scene.mesh.elements_across_patch;
    if (!(patch.half_width_x > 0.))
      return;
    const double half_y =
      patch.half_width_y > 0. ? patch.half_width_y : patch.half_width_x;
    MovingSurfaces(scene,
                   {{2 * patch.half_width_x / n, 2 * half_y / n},
                    {patch.half_width_x, half_y}});
  }
} // namespace RollingContact
