#include <rolling_contact/base/text.h>
#include <rolling_contact/contact/patch_area.h>
#include <rolling_contact/pair/patch_estimate.h>
#include <rolling_contact/results/rough_state.h>
#include <rolling_contact/run/log.h>
#include <rolling_contact/surfaces/record_notes.h>

namespace RollingContact
{
  template <int dim>
  void set_roughness_columns(const SteadyState<dim> &steady,
                             ResultsTable           &table)
  {
    const auto &resolved = steady.pair->moving_surfaces().resolved;
    if (!resolved)
      return;
    table.set("cut_off_wavelength_x_m", resolved->shortest[0]);
    if (resolved->shortest[1] > 0.)
      table.set("cut_off_wavelength_y_m", resolved->shortest[1]);
    table.set("rms_slope", resolved->rms_slope);
  }

  template <int dim>
  void tell_rough_state(const PairSpec         &scene,
                        const SteadyState<dim> &steady,
                        RunContext             &context)
  {
    const auto       &resolved = steady.pair->moving_surfaces().resolved;
    const Resultants &result   = steady.result;
    if (!resolved || !(result.normal_force > 0.))
      return;
    const double area = patch_areas(steady.problem, steady.state).contact,
                 k    = scene.wear.shear_yield_stress,
                 slope_over_pressure =
                   area * pair_constants(scene).contact_modulus *
                   resolved->rms_slope / result.normal_force;
    std::string text =
      "area of contact " + significant(1e6 * area, 4) +
      " mm^2 and peak pressure " + significant(1e-6 * result.max_pressure, 5) +
      " MPa belong to waves of " + text_of_waves(resolved->shortest) +
      " and longer; they change further as shorter waves are added. Rms slope " +
      significant(resolved->rms_slope, 3);
    if (dim == 3)
      text += ", area E* slope / N = " + significant(slope_over_pressure, 3);
    context.report.set_finding("rough", text);
    if (resolved->shortest[1] > 0. && result.max_pressure > 3 * k)
      context.log.warning(
        "Of the rough surface the peak pressure is " +
        significant(1e-6 * result.max_pressure, 4) +
        " MPa, more than 3 k = " + significant(3e-6 * k, 4) +
        " MPa (k: Wear/Shear yield stress). Real asperities would yield, "
        "which elastic bodies do not, and pressures would be lower.");
  }

  template <int dim>
  void warn_of_long_steps(const PairSpec         &scene,
                          const SteadyState<dim> &steady,
                          const double            rolled,
                          RunContext             &context)
  {
    const double element = steady.grading.element_size_x;
    if (scene.surfaces.in_use() && rolled > element * (1 + 1e-9))
      context.log.warning(
        "A step rolls " + millimetres(rolled) + ", an element is " +
        millimetres(element) +
        " long: in the history, waves of the surfaces shorter than " +
        millimetres(2 * rolled) +
        " appear as longer ones. Take shorter steps (Time/Time step or Step "
        "length).");
  }

  template void warn_of_long_steps(const PairSpec &,
                                   const SteadyState<2> &,
                                   const double,
                                   RunContext &);
  template void warn_of_long_steps(const PairSpec &,
                                   const SteadyState<3> &,
                                   const double,
                                   RunContext &);
  template void set_roughness_columns(const SteadyState<2> &, ResultsTable &);
  template void set_roughness_columns(const SteadyState<3> &, ResultsTable &);
  template void
  tell_rough_state(const PairSpec &, const SteadyState<2> &, RunContext &);
  template void
  tell_rough_state(const PairSpec &, const SteadyState<3> &, RunContext &);
} // namespace RollingContact
