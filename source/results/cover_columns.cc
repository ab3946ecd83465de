#include <rolling_contact/base/text.h>
#include <rolling_contact/pair/layered_bodies.h>
#include <rolling_contact/results/cover_columns.h>
#include <rolling_contact/results/reference_2d.h>

namespace RollingContact
{
  std::optional<CoverReference> cover_reference(const PairSpec       &scene,
                                                const SteadyState<2> &steady)
  {
    if (!scene.has_covers() || !scene.contact.roughness.empty() ||
        scene.surfaces.in_use() || !steady.solver.converged ||
        !(steady.result.normal_force > 0.))
      return {};
    const Reference2D reference = reference_2d(scene, steady);
    CoverReference    found{*reference.layered, {}, {}, {}};
    if (steady.problem.n_tangential() > 0)
      {
        found.rolling =
          layered_line_contact(scene,
                               steady.result.normal_force / scene.thickness(),
                               References::LineFriction::sticks);
        // a stretched wheel passes more slowly than its radius has it
        found.creepage = -scene.contact.flow() * found.rolling->creepage;
      }
    else
      found.pressure_l2 = errors_2d(scene, steady, reference).pressure_l2;
    return found;
  }

  void set_cover_columns(const PairSpec       &scene,
                         const SteadyState<2> &steady,
                         ResultsTable         &table)
  {
    const auto reference = cover_reference(scene, steady);
    if (!reference)
      return;
    const References::LayeredLine &line =
      reference->rolling ? *reference->rolling : reference->frictionless;
    table.set("reference_half_width_x_m", line.half_width);
    table.set("reference_max_pressure_Pa", line.pressure(0.));
    if (reference->pressure_l2)
      table.set("error_pressure_l2", *reference->pressure_l2);
    if (!reference->rolling)
      return;
    table.set("free_creepage_x", *reference->creepage);
    table.set("sticking_friction", line.least_friction());
  }

  void note_cover(const PairSpec       &scene,
                  const SteadyState<2> &steady,
                  RunReport            &report)
  {
    const auto reference = cover_reference(scene, steady);
    if (!reference)
      return;
    const References::LayeredLine &line =
      reference->rolling ? *reference->rolling : reference->frictionless;
    std::string text = "half-planes with covers have a half-width of " +
                       millimetres(line.half_width, 5) +
                       " and a peak pressure of " +
                       significant(1e-6 * line.pressure(0.), 5) + " MPa";
    if (reference->rolling)
      text += " rolling freely with friction from " +
              significant(line.least_friction(), 3) + " on, at a creepage of " +
              scientific(*reference->creepage, 4);
    report.set_finding("cover", text);
  }
} // namespace RollingContact
