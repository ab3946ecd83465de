#include <rolling_contact/base/text.h>
#include <rolling_contact/results/error_bounds.h>
#include <rolling_contact/results/reference_2d.h>
#include <rolling_contact/results/result_error.h>
#include <rolling_contact/results/state_errors.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace RollingContact
{
  namespace
  {
    /**
     * Replaces a smaller error of the same quantity; one that is not known
     * stays.
     */
    void keep_largest(const ErrorStatement &error, RunReport &report)
    {
      const auto known = std::find_if(report.errors.begin(),
                                      report.errors.end(),
                                      [&](const ErrorStatement &other) {
                                        return other.quantity == error.quantity;
                                      });
      if (known == report.errors.end())
        report.errors.push_back(error);
      else if (std::isnan(error.value) || error.value > known->value)
        *known = error;
    }

    ErrorStatement statement(const ErrorBounds &bounds,
                             const std::string &remark)
    {
      return {"force",
              bounds.force.value_or(std::numeric_limits<double>::quiet_NaN()),
              "mu N",
              bounds.text,
              true,
              remark};
    }

    /**
     * How far the force is from Carter's, where he holds for the bodies as
     * half-spaces; that of finite bodies differs by itself.
     */
    template <int dim>
    std::string
    difference_to_carter([[maybe_unused]] const PairSpec         &scene,
                         [[maybe_unused]] const SteadyState<dim> &steady)
    {
      if constexpr (dim == 2)
        if (follows_carter(scene, steady))
          return scientific(std::abs(errors_2d(scene,
                                               steady,
                                               reference_2d(scene, steady))
                                       .force),
                            2) +
                 " from Carter";
      return "";
    }

    template <int dim>
    ErrorStatement force_error(const PairSpec         &scene,
                               const SteadyState<dim> &steady)
    {
      return statement(error_bounds(scene, steady),
                       difference_to_carter(scene, steady));
    }
  } // namespace

  namespace
  {
    /**
     * Estimated error of the peak pressure, for patches that no closed form
     * describes.
     */
    template <int dim>
    ErrorStatement pressure_error(const PairSpec         &scene,
                                  const SteadyState<dim> &steady)
    {
      const ErrorBounds bounds = error_bounds(scene, steady);
      return {"pressure",
              bounds.max_pressure.value_or(
                std::numeric_limits<double>::quiet_NaN()),
              "its peak",
              bounds.max_pressure
                ? "2/n^2, more where the surface has waves or the "
                  "pressure bends more across"
                : bounds.text,
              true,
              ""};
    }

    /**
     * Whether bodies that give way, as a rail that friction tilts on its pads,
     * have moved the patch away from the first contact: the centre of pressure
     * is farther off than a tenth of the half-widths, and the pressure differs
     * from that of Hertz's ellipse, which is there, by its place alone.
     */
    template <int dim>
    bool has_moved(const SteadyState<dim> &steady)
    {
      if (dim == 2)
        return false;
      const ContactOperators &operators = steady.problem.operators;
      double                  load = 0., x = 0., y = 0.;
      for (unsigned int i = 0; i < operators.n_nodes(); ++i)
        {
          const double force =
            operators.load_areas()[i] * steady.state.pressure[i];
          load += force;
          x += force * operators.positions()[i][0];
          y += force * operators.positions()[i][1];
        }
      const double far = 0.1;
      return std::hypot(x / steady.result.half_width_x,
                        y / steady.result.half_width_y) > far * load;
    }
  } // namespace

  template <int dim>
  void note_error(const PairSpec         &scene,
                  const SteadyState<dim> &steady,
                  RunReport              &report)
  {
    if (steady.result.normal_force <= 0.)
      return;
    const bool friction = steady.problem.n_tangential() > 0;
    if (friction)
      keep_largest(force_error(scene, steady), report);
    if (!scene.has_plain_surfaces() || has_moved(steady))
      {
        keep_largest(pressure_error(scene, steady), report);
        return;
      }
    const StateErrors errors = state_errors<dim>(scene, steady, nullptr);
    if (errors.load)
      keep_largest({"load",
                    std::abs(*errors.load),
                    "N",
                    "the exact clamped discs",
                    false,
                    ""},
                   report);
    if (dim == 3 || (!friction && !errors.load))
      keep_largest(
        {"pressure", errors.pressure_l2.value(), "p0", "Hertz", false, "L2"},
        report);
  }

  template <int dim>
  void note_error_of_step(const PairSpec         &scene,
                          const SteadyState<dim> &steady,
                          RunReport              &report)
  {
    if (steady.problem.n_tangential() == 0)
      {
        const double unknown = std::numeric_limits<double>::quiet_NaN();
        report.errors.push_back({"load",
                                 unknown,
                                 "N",
                                 "neither the error of the mesh nor that of "
                                 "the time step",
                                 true,
                                 ""});
        return;
      }
    report.errors.push_back(
      statement(error_bounds(scene, steady), "time step not estimated"));
  }

  void add_error_of_step(const StepErrors &of_step, RunReport &report)
  {
    for (ErrorStatement &error : report.errors)
      {
        const bool   force = error.quantity == "force";
        const double share = force ? of_step.force : of_step.load;
        const auto   text  = scientific(share, 2);
        error.time_step    = share;
        error.remark       = text + " for the time step";
        if (std::isnan(error.value))
          error.reference =
            (force ? error.reference : "the error of the mesh is not known") +
            "; " + text + " of " + error.scale + " for the time step";
        else
          error.value += share;
      }
  }

  void warn_of_unknown_errors(RunContext &context)
  {
    for (const ErrorStatement &error : context.report.errors)
      if (std::isnan(error.value))
        context.log.warning("How far the " + error.quantity +
                            " may be off is not known: " + error.reference +
                            ". Compare with a run that has more Mesh/Elements "
                            "across patch.");
  }

  template void
  note_error(const PairSpec &, const SteadyState<2> &, RunReport &);
  template void
  note_error(const PairSpec &, const SteadyState<3> &, RunReport &);
  template void
  note_error_of_step(const PairSpec &, const SteadyState<2> &, RunReport &);
  template void
  note_error_of_step(const PairSpec &, const SteadyState<3> &, RunReport &);
} // namespace RollingContact
