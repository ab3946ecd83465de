#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/pair/mesh_limits.h>
#include <rolling_contact/pair/moving_surfaces.h>
#include <rolling_contact/pair/passing_surface.h>
#include <rolling_contact/pair/patch_estimate.h>
#include <rolling_contact/references/hertz_line.h>
#include <rolling_contact/surfaces/crown.h>
#include <rolling_contact/surfaces/dent.h>
#include <rolling_contact/surfaces/expression_check.h>
#include <rolling_contact/surfaces/record_notes.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
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

    /** A dent that comes again after a turn; a rail has it once. */
    class DentSurface : public MovingSurfaces::Surface
    {
    public:
      DentSurface(const Dent &dent, const double turn)
        : dent(dent)
        , turn(turn)
      {}

      double height(const double X, const double) const override
      {
        return dent.height(turn > 0. ? X - turn * std::round(X / turn) : X,
                           turn / (2 * pi));
      }

    private:
      const Dent   dent;
      const double turn;
    };

    void check_size(const Dent &dent, const Examined &it, const double turn)
    {
      const std::string given = it.entry + " = " + it.text + ": ";
      if (dent.kind == Dent::Kind::flat && turn == 0.)
        throw InputError(given + "a flat is that of a disc, and this body is "
                                 "none; take dip : LENGTH, DEPTH.");
      if (dent.length < 8 * it.element)
        throw InputError(given + "it is shorter than eight elements (" +
                         significant(8 * it.element, 3) +
                         " m), which the mesh does not follow; take more "
                         "Mesh/Elements across patch.");
      if (turn > 0. && dent.length > turn / 4)
        throw InputError(given + "it is longer than a quarter of a turn (" +
                         significant(turn / 4, 4) + " m); give less.");
    }

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
      const double length = crown.length.value_or(2 * narrower_reach(scene));
      return {length,
              References::hertz_line(crown.load / length,
                                     constants.relative_radius,
                                     constants.contact_modulus)
                .half_width,
              constants.contact_modulus};
    }

    /** First and last X of the material that passes the zone. */
    std::array<double, 2> material_that_passes(const SurfacePassage &passage,
                                               const ZoneSizes      &sizes)
    {
      // the flow brings what lies against it
      const auto [first, last] = std::minmax(
        {-passage.flow * passage.least, -passage.flow * passage.most});
      return {{first - sizes.reach[0], last + sizes.reach[0]}};
    }

    std::string judge_along_x(const MovingSurfaces::Surface &surface,
                              const Examined                &it,
                              const std::array<double, 2>   &passes)
    {
      const auto along_x = [&](const double X) {
        return surface.height(X, 0.);
      };
      return judge(it, short_waves(along_x, passes[0], passes[1], it.element));
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
      if (turn > 0.)
        check_seam(expression, it, turn, begin, end);
      add(judge_along_x(surface, it, passes));
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

  std::shared_ptr<const MovingSurfaces::Surface>
  MovingSurfaces::filtered(const std::shared_ptr<const SurfaceRecord> &record,
                           const ZoneSizes                            &sizes,
                           const SurfacePassage                       &passage,
                           const double shortest_wavelength)
  {
    ResolvedWaves waves;
    for (unsigned int d = 0; d < 2; ++d)
      waves.shortest[d] = shortest_wavelength > 0.
                            ? shortest_wavelength
                            : elements_in_wave * sizes.element[d];
    FilteredRecord surface(*record,
                           {waves.shortest[0], waves.shortest[0] / 2},
                           passage.turn,
                           waves.shortest[1] / waves.shortest[0]);
    check_record(*record, surface, waves.shortest, sizes);
    surface.keep_across(-sizes.reach[1], sizes.reach[1]);
    notes.push_back(note_of_filter(*record, surface, waves.shortest));
    if (const std::string doubt = doubt_of_ends(*record);
        surface.is_periodic() && !doubt.empty())
      warnings.push_back(doubt);
    waves.rms_slope = surface.rms_slope;
    if (!record->is_map())
      waves.shortest[1] = 0.;
    if (resolved)
      {
        waves.shortest[1] = std::max(waves.shortest[1], resolved->shortest[1]);
        waves.rms_slope   = std::hypot(waves.rms_slope, resolved->rms_slope);
      }
    resolved = waves;
    const auto found =
      std::make_shared<const RecordSurface>(record, surface, sizes, passage);
    found->require(passage.least, passage.most);
    return found;
  }

  MovingSurfaces::MovingSurfaces(const PairSpec &scene, const ZoneSizes &sizes)
    : moves(scene.surfaces.in_use())
    , flow(scene.contact.flow())
    , position(scene.surfaces.position)
    , share(scene.surfaces.share)
  {
    const SurfaceSpec &given   = scene.surfaces;
    const bool         is_even = !scene.profiles.in_use();
    if (given.standing)
      standing = filtered(given.standing,
                          sizes,
                          {0., 0., -1., 0., true, is_even},
                          given.shortest_wavelength);
    for (const Side side : both_sides)
      {
        const SurfacePassage passage{given.least_rolled,
                                     given.most_rolled,
                                     flow,
                                     turn_of(scene, side),
                                     false,
                                     is_even};
        const Examined       it{given.entry(side),
                          given.height[side],
                          "x",
                          sizes.element[0]};
        const auto           passes = material_that_passes(passage, sizes);
        if (const auto dent = dent_named(it.entry, it.text))
          {
            check_size(*dent, it, passage.turn);
            surfaces[side] =
              std::make_shared<const DentSurface>(*dent, passage.turn);
            if (const std::string doubt =
                  judge_along_x(*surfaces[side], it, passes);
                !doubt.empty())
              warnings.push_back(doubt);
          }
        if (const auto crown = crown_named(it.entry, it.text))
          surfaces[side] =
            std::make_shared<const CrownSurface>(*crown,
                                                 roller_of(scene, *crown));
        if (const auto &record = given.records[side])
          surfaces[side] =
            filtered(record, sizes, passage, given.shortest_wavelength);
        if (const auto &expression = given.expressions[side])
          {
            surfaces[side] =
              std::make_shared<const ExpressionSurface>(*expression,
                                                        passage.turn);
            examine(*expression,
                    *surfaces[side],
                    it,
                    passes,
                    passage.turn,
                    sizes,
                    warnings);
          }
      }
  }

  double MovingSurfaces::standing_height(const double x, const double y) const
  {
    return standing ? standing->height(x, y) : 0.;
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

  double farthest_contact_of_dents(const PairSpec &scene)
  {
    const double R   = pair_constants(scene).relative_radius;
    const int    n   = 200; // places of a dent, and of the contact
    double       sum = 0.;
    for (const Side side : both_sides)
      {
        const auto dent = dent_named(SurfaceParameters::entry(side),
                                     scene.surfaces.height[side]);
        if (!dent)
          continue;
        const double step     = dent->length / n;
        int          farthest = 0;
        for (int place = -n; place <= n; ++place)
          {
            const auto gap = [&](const int i) {
              return i * step * i * step / (2 * R) -
                     dent->height((i - place) * step,
                                  turn_of(scene, side) / (2 * pi));
            };
            int nearest = 0;
            for (int i = -n; i <= n; ++i)
              if (gap(i) < gap(nearest))
                nearest = i;
            farthest = std::max(farthest, std::abs(nearest));
          }
        sum += farthest * step;
      }
    return sum;
  }

  void check_moving_surfaces(const PairSpec &scene)
  {
    if (!scene.surfaces.in_use() && !scene.surfaces.standing)
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
