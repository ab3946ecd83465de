#include <rolling_contact/base/text.h>
#include <rolling_contact/contact/recovered_tractions.h>
#include <rolling_contact/pair/layered_bodies.h>
#include <rolling_contact/results/cover_columns.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    double pressure_difference(const SteadyState<2>          &steady,
                               const References::LayeredLine &line)
    {
      const std::vector<double> pressure =
        recovered_tractions(steady.problem, steady.state).pressure;
      const auto &at  = steady.problem.operators.positions();
      double      sum = 0., previous = 0.;
      for (std::size_t i = 0; i < pressure.size(); ++i)
        {
          const double square =
            std::pow(pressure[i] - line.pressure(at[i][0]), 2);
          if (i > 0)
            sum += (at[i][0] - at[i - 1][0]) * (previous + square) / 2;
          previous = square;
        }
      return std::sqrt(sum / line.half_width) / line.pressure(0.);
    }
  } // namespace

  std::optional<CoverReference> cover_reference(const PairSpec       &scene,
                                                const SteadyState<2> &steady)
  {
    if (!scene.has_covers() || !scene.contact.roughness.empty() ||
        scene.surfaces.in_use() || !steady.solver.converged ||
        !(steady.result.normal_force > 0.))
      return {};
    const double   load = steady.result.normal_force / scene.thickness();
    CoverReference reference{
      layered_line_contact(scene, load, References::LineFriction::none),
      {},
      {},
      {}};
    if (steady.problem.n_tangential() > 0)
      {
        reference.rolling =
          layered_line_contact(scene, load, References::LineFriction::sticks);
        // a stretched wheel passes more slowly than its radius has it
        reference.creepage =
          -scene.contact.flow() * reference.rolling->creepage;
      }
    else
      reference.pressure_l2 =
        pressure_difference(steady, reference.frictionless);
    return reference;
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
