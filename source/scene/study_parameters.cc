#include <rolling_contact/base/choices.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/scene/entries.h>
#include <rolling_contact/scene/study_parameters.h>
#include <rolling_contact/solvers/contact_solver.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  using namespace dealii;

  void StudyParameters::declare(Entries &entries)
  {
    entries.section("Accuracy study").read_by_analyses("accuracy study");
    const std::vector<NamedValue<bool>> varied{{"mesh", false},
                                               {"time step", true}};
    entries.choice("Vary", varies_time_step, varied).help =
      "`mesh`: steady states on many meshes; `time step`: the transient scene "
      "of section Time with many time steps.";
    declare_meshes(entries);
    declare_methods(entries);
  }

  void StudyParameters::declare_meshes(Entries &entries)
  {
    entries.add("Elements across patch", elements, "1")
      .between(1, 100000)
      .several()
      .help = "Meshes to compare, by their numbers of elements across the "
              "patch.";
    entries.add("Offsets", n_offsets, "1").between(1, 1000).help =
      "Number of positions of each mesh under the patch, equally spaced over "
      "one element.";
    entries.add("Reference elements across patch", reference_elements, "1")
      .between(1, 100000)
      .help =
      "Elements across the patch of the reference mesh, finer than the "
      "others. Its forces with `calibrated`, as a mean over the offsets, are "
      "the converged solution that all forces are compared with.";
    entries.add("Extrapolate reference", extrapolate_reference).help =
      "Whether the converged solution is extrapolated from the reference mesh "
      "and from meshes of half and a quarter of its elements, with the order "
      "that they show.";
    entries.add("Rim levels", rim_levels, "1").between(1, 10).help =
      "Halvings of the element size at the leading edge on `graded` meshes.";
    entries.add("Adaptive levels", adaptive_levels, "1").between(1, 20).help =
      "Number of levels of `adaptive` meshes. Mesh/Contact node budget may "
      "end them before.";
    entries.add("Adaptive starts", adaptive_starts, "1")
      .between(1, 100000)
      .several(0)
      .help =
      "Elements across the patch of the meshes from which Adaptive levels "
      "start; empty: as Elements across patch.";
    entries.add("Creepages over saturation", creepages, "1").several().help =
      "Creepages, divided by that of saturation: in 2D mu a/R of the Hertz "
      "estimate; in 3D the creepage at which Kalker's linear force is 3 mu N, "
      "on profiles for the ellipse as long and as wide as the patch.";
    entries.add("Directions", directions)
      .one_of("longitudinal|lateral|spin|combined")
      .several()
      .help =
      "Directions of the creepage: `longitudinal`, and in 3D `lateral`, "
      "`spin` (its lateral force is judged) or `combined`, all three, each "
      "divided by sqrt(3).";
  }

  void StudyParameters::declare_methods(Entries &entries)
  {
    entries.add("Meshes", meshes)
      .one_of("uniform|graded|adaptive")
      .several()
      .help =
      "Kinds of meshes: `uniform`, `graded` (finer at the leading edge, by "
      "Rim levels) or `adaptive`.";
    entries.add("Slip operators", slip_operators)
      .one_of(choice_names(slip_operator_choices()) + "|paper")
      .several()
      .help =
      "Slip operators to compare, as Contact/Slip operator, and `paper` (Lai "
      "et al. 2017): galerkin with consistent contact matrices, by the "
      "extragradient iteration where the solver is `automatic`.";
    entries.add("Solvers", solvers)
      .one_of(choice_names(contact_solver_kinds()))
      .several()
      .help = "Contact solvers to compare, as Contact/Solver.";
    const std::vector<NamedValue<bool>> combined{{"one at a time", false},
                                                 {"all", true}};
    entries.choice("Combinations", combines_all, combined).help =
      "`one at a time`: the first mesh, operator and solver, and methods that "
      "differ from them in one of the three; `all`: all combinations.";
    entries.add("Paper tolerance", paper_tolerance, "1")
      .between(1e-15, 1.)
      .help =
      "Tolerance of `paper`. No solver reaches the tolerance of the other "
      "operators with it.";
    entries.add("Time steps", time_steps, "s").at_least(0.).several().help =
      "Time steps to compare, in place of Time/Time step. Each is a multiple "
      "of twice the Reference time step.";
    entries.add("Thetas", thetas, "1").between(0.5, 1.).several().help =
      "Values of Time/Theta to compare.";
    entries.add("Reference time step", reference_time_step, "s")
      .at_least(0.)
      .help =
      "Time step of the reference, which is extrapolated to first order from "
      "this step and twice this step, with the first of Thetas.";
  }

  namespace
  {
    template <typename Value>
    void require_different(const std::string &entry, std::vector<Value> values)
    {
      std::sort(values.begin(), values.end());
      const auto same = std::adjacent_find(values.begin(), values.end());
      if (same != values.end())
        throw InputError("Accuracy study/" + entry + " contains " +
                         Patterns::Tools::to_string(*same) +
                         " twice: give every value once.");
    }
  } // namespace

  void StudyParameters::check_meshes() const
  {
    for (const auto *list : {&elements, &starts_of_levels()})
      for (const unsigned int n : *list)
        if (n >= reference_elements)
          throw InputError("Accuracy study/" +
                           std::string(list == &elements
                                         ? "Elements across patch"
                                         : "Adaptive starts") +
                           " contains " + std::to_string(n) +
                           ": take fewer than the reference mesh's " +
                           std::to_string(reference_elements) +
                           " (Reference elements across patch).");
    if (extrapolate_reference && reference_elements % 4 != 0)
      throw InputError("Accuracy study/Reference elements across patch = " +
                       std::to_string(reference_elements) +
                       ": take a multiple of 4, as the meshes of half and a "
                       "quarter of it are needed to extrapolate, or set "
                       "Extrapolate reference = false.");
  }

  void StudyParameters::check_time_steps() const
  {
    if (reference_time_step <= 0.)
      throw InputError("Accuracy study/Reference time step = 0: give a step "
                       "above 0 s.");
    for (const double step : time_steps)
      {
        const double ratio = step / (2 * reference_time_step);
        if (step <= 0. || std::abs(ratio - std::round(ratio)) > 1e-6 * ratio)
          throw InputError("Accuracy study/Time steps contains " +
                           significant(step, 6) +
                           " s: take multiples of twice the Reference time "
                           "step, 2 * " +
                           significant(reference_time_step, 6) +
                           " s, so that times are common.");
      }
  }

  void StudyParameters::check(const unsigned int dimension) const
  {
    require_different("Elements across patch", elements);
    require_different("Adaptive starts", adaptive_starts);
    require_different("Creepages over saturation", creepages);
    require_different("Directions", directions);
    require_different("Meshes", meshes);
    require_different("Slip operators", slip_operators);
    require_different("Solvers", solvers);
    require_different("Time steps", time_steps);
    require_different("Thetas", thetas);
    if (varies_time_step)
      check_time_steps();
    else
      check_meshes();
    for (const double creepage : creepages)
      if (creepage == 0.)
        throw InputError("Accuracy study/Creepages over saturation contains 0: "
                         "there is no force to judge.");
    for (const std::string &direction : directions)
      if (dimension == 2 && direction != "longitudinal")
        throw InputError("Accuracy study/Directions contains " + direction +
                         ": in 2D there is only longitudinal; take Dimension = "
                         "3.");
  }
} // namespace RollingContact
