#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/pair/moving_surfaces.h>
#include <rolling_contact/pair/patch_estimate.h>
#include <rolling_contact/scene/travelled_distance.h>
#include <rolling_contact/surfaces/expression_check.h>

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

    virtual double
    height(const double X, const double y) const = 0;
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



    Rolled
    rolled_in(const SceneParameters &scene)
    {
      const double position = scene.surfaces.position;
      Rolled       rolled{position, position};
      if (scene.analysis != "transient")
        return rolled;
      const DrivingFunctions drive =
        scene.time.histories(scene.contact, scene.prm_folder);
      const TimeSteps         steps = scene.time.steps(drive.speed);
      const double            end   = steps.length * steps.number;
      const TravelledDistance travelled(drive.speed,
                                        std::max(steps.length, end / 1000));
      const unsigned int      n = drive.speed.is_constant() ? 1 : 100;
      for (unsigned int k = 1; k <= n; ++k)
        {
          // the shifted law looks half a step beyond the end
          const double now =
            position +
            scene.contact.flow() *
              travelled.value(steps.length * (steps.number + 0.5) * k / n);
          rolled.least = std::min(rolled.least, now);
          rolled.most  = std::max(rolled.most, now);
        }
      return rolled;
    }



    /** Length of a turn; 0 for what is no disc. */
    double
    turn_of(const SceneParameters &scene, const Side side)
    {
      const BodyParameters &body = scene.body(side);
      const bool            is_disc =
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

      double
      height(const double X, const double y) const override
      {
        return expression.value(turn > 0. ? X - turn * std::round(X / turn) : X,
                                y);
      }

    private:
      const HeightExpression expression;
      const double           turn;
    };



    class RecordSurface : public MovingSurfaces::Surface
    {
    public:
      RecordSurface(const FilteredRecord &record, const double flow)
        : record(record)
        , flow(flow)
      {}

      double
      height(const double X, const double) const override
      {
        return record.value(-flow * X);
      }

    private:
      const FilteredRecord record;
      const double         flow;
    };



    /**
     * Refuses what a record cannot do for this zone and this run.
     */
    void
    check_record(const SurfaceRecord &record,
                 const double         shortest,
                 const ZoneSizes     &sizes,
                 const Rolled        &rolled,
                 const bool           is_periodic,
                 const double         turn)
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
      if (is_periodic ||
          (rolled.least >= record.begin && rolled.most <= record.end()))
        return;
      throw InputError(
        file + "it goes from " + significant(record.begin, 6) + " to " +
        significant(record.end(), 6) + " m, and the wheel rolls from " +
        significant(rolled.least, 6) + " to " + significant(rolled.most, 6) +
        " m of it. Take another Surfaces/Position or Position unit, a shorter "
        "run or a longer record" +
        (turn > 0. ? ", or one of the whole turn of " + significant(turn, 6) +
                       " m, which comes again."
                   : "."));
    }



    std::string
    told_of(const SurfaceRecord  &record,
            const FilteredRecord &filtered,
            const double          shortest)
    {
      const auto micrometres = [](const double length) {
        return significant(1e6 * length, 3) + " um";
      };
      return record.entry + ": " + std::to_string(record.heights.size()) +
             " heights " + millimetres(record.spacing) + " apart" +
             (record.resampled ? " (resampled)" : "") + ", rms " +
             micrometres(filtered.rms) + " about a mean of " +
             micrometres(record.mean) +
             ", which is taken out; waves shorter than " +
             millimetres(shortest) + " fade, below " +
             millimetres(shortest / 2) + " none is left: rms " +
             micrometres(filtered.removed_rms) + " is taken out" +
             (filtered.is_periodic() ? "; it comes again after a turn." : ".");
    }



    /** First and last X of the material that passes the zone. */
    std::array<double, 2>
    material_that_passes(const Rolled    &rolled,
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
    void
    examine(const HeightExpression        &expression,
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



    /** A warning of a record of a turn whose ends do not meet, or none. */
    std::string
    doubt_of_ends(const SurfaceRecord &record)
    {
      const auto &heights = record.heights;
      double      largest = 0.;
      for (std::size_t k = 1; k < heights.size(); ++k)
        largest = std::max(largest, std::abs(heights[k] - heights[k - 1]));
      const double jump = heights.front() - heights.back();
      if (std::abs(jump) <= 3 * largest)
        return "";
      return record.entry + ": \"" + record.file +
             "\": it goes once around, but from its end to its beginning the "
             "height jumps by " +
             significant(1e6 * jump, 3) + " um, elsewhere by at most " +
             significant(1e6 * largest, 3) +
             " um from point to point: the filter makes waves of that. Take the "
             "drift out of the record.";
    }
  } // namespace



  MovingSurfaces::MovingSurfaces(const SceneParameters &scene,
                                 const ZoneSizes       &sizes)
    : moves(scene.surfaces.in_use())
    , flow(scene.contact.flow())
    , position(scene.surfaces.position)
    , share(scene.surfaces.share)
  {
    if (!moves)
      return;
    const SurfaceParameters &given    = scene.surfaces;
    const Rolled             rolled   = rolled_in(scene);
    const double             shortest = given.shortest_wavelength > 0.
                                          ? given.shortest_wavelength
                                          : elements_in_wave * sizes.element[0];
    for (const Side side : both_sides)
      {
        const double turn = turn_of(scene, side);
        if (const auto &record = given.records[side])
          {
            const FilteredRecord filtered(*record,
                                          {shortest, shortest / 2},
                                          turn);
            check_record(
              *record, shortest, sizes, rolled, filtered.is_periodic(), turn);
            notes.push_back(told_of(*record, filtered, shortest));
            if (const std::string doubt = doubt_of_ends(*record);
                filtered.is_periodic() && !doubt.empty())
              warnings.push_back(doubt);
            surfaces[side] =
              std::make_shared<const RecordSurface>(filtered, flow);
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



  double
  MovingSurfaces::height(const double x,
                         const double y,
                         const double travelled) const
  {
    double sum = 0.;
    for (const Side side : both_sides)
      if (surfaces[side])
        sum += surfaces[side]->height(x - travelled - flow * position, y);
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



  void
  check_moving_surfaces(const SceneParameters &scene)
  {
    if (!scene.surfaces.in_use() || scene.analysis == "contact table")
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
