#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/pair/moving_surfaces.h>
#include <rolling_contact/pair/patch_estimate.h>
#include <rolling_contact/scene/travelled_distance.h>
#include <rolling_contact/surfaces/height_expression.h>
#include <rolling_contact/surfaces/short_waves.h>

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
    /** Shares of the root mean square from which on short waves are told of
     * and refused. */
    const double notable = 0.05, too_short = 0.05;

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



    /** What is asked of an expression, with its name in messages. */
    struct Examined
    {
      std::string entry, text, axis;
      double      element;
    };



    /** A warning, or none. */
    std::string
    judge(const Examined &it, const ShortWaves &found)
    {
      const std::string given = it.entry + " = " + it.text + ": ",
                        more =
                          " Take more Mesh/Elements across patch, or leave "
                          "short waves out; a step needs a ramp.";
      if (found.highest > highest_surface)
        throw InputError(given + "a height of " +
                         significant(found.highest, 4) +
                         " m is that of no surface a wheel rolls on (at most "
                         "5e-3 m): x, y and the height are in m.");
      if (found.steepest > steepest_surface)
        throw InputError(given + "a slope of " +
                         significant(found.steepest, 3) + " at " + it.axis +
                         " = " + significant(found.steepest_from, 6) +
                         " m is that of no surface a wheel rolls on (at most "
                         "0.1): x, y and the height are in m." +
                         more);
      const auto share = [&](const double part) {
        return significant(100 * part / found.rms, 2) + " % of its rms along " +
               it.axis + " are waves shorter than ";
      };
      if (found.below_two > too_short * found.rms)
        throw InputError(given + share(found.below_two) + "two elements (" +
                         significant(2 * it.element, 3) +
                         " m), which nodes show as longer ones." + more);
      if (found.below_four > notable * found.rms)
        return given + share(found.below_four) + "four elements (" +
               significant(4 * it.element, 3) +
               " m), which the mesh follows poorly." + more;
      return "";
    }



    void
    check_seam(const HeightExpression &expression,
               const Examined         &it,
               const double            turn,
               const double            begin,
               const double            end)
    {
      // half a turn from 0, where one turn ends and the next begins
      const double seam = turn * (std::floor(begin / turn + 0.5) + 0.5);
      if (seam > end)
        return;
      const double before = expression.value(turn / 2, 0.),
                   behind = expression.value(-turn / 2, 0.);
      if (std::abs(before - behind) > 1e-3 * it.element)
        throw InputError(
          it.entry + " = " + it.text +
          ": after half a turn, x = " + significant(turn / 2, 7) +
          " m, comes x = " + significant(-turn / 2, 7) +
          " m, and the height jumps by " +
          significant(1e6 * (behind - before), 3) +
          " um. Give it an integer number of waves in a turn of " +
          significant(turn, 7) + " m, or let it end before.");
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
            surfaces[side] =
              std::make_shared<const RecordSurface>(filtered, flow);
          }
        const auto &expression = given.expressions[side];
        if (!expression)
          continue;
        surfaces[side] =
          std::make_shared<const ExpressionSurface>(*expression, turn);
        Examined it{given.entry(side),
                    given.height[side],
                    "x",
                    sizes.element[0]};
        // of the material: the flow brings what lies against it
        double begin = -flow * rolled.least, end = -flow * rolled.most;
        if (begin > end)
          std::swap(begin, end);
        begin -= sizes.reach[0];
        end += sizes.reach[0];
        if (turn > 0.)
          check_seam(*expression, it, turn, begin, end);
        const auto add = [&](const std::string &warning) {
          if (!warning.empty())
            warnings.push_back(warning);
        };
        const Surface &surface = *surfaces[side];
        const auto     along_x = [&](const double X) {
          return surface.height(X, 0.);
        };
        add(judge(it, short_waves(along_x, begin, end, it.element)));
        if (scene.dimension == 2 || !expression->depends_on_y())
          continue;
        it.axis            = "y";
        it.element         = sizes.element[1];
        const auto along_y = [&](const double y) {
          return surface.height(begin + sizes.reach[0], y);
        };
        add(judge(
          it,
          short_waves(along_y, -sizes.reach[1], sizes.reach[1], it.element)));
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
