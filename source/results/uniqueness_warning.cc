#include <rolling_contact/base/text.h>
#include <rolling_contact/results/uniqueness_warning.h>

namespace RollingContact
{
  void UniquenessSummary::add(const Uniqueness     &found,
                              const ContactProblem &problem,
                              const std::string    &of_state)
  {
    ++n;
    n_above += found.possible();
    if (found.ratio <= ratio)
      return;
    ratio    = found.ratio;
    position = problem.operators.positions()[found.node];
    of       = of_state;
  }

  void warn_of_non_uniqueness(const unsigned int       dimension,
                              const SolutionsOf        solutions,
                              const UniquenessSummary &worst,
                              Log                     &log)
  {
    if (worst.n_above == 0)
      return;
    const bool        in_time = solutions != SolutionsOf::steady_states;
    const std::string what =
      in_time
        ? "Steps in which friction and sliding speed may have several "
          "solutions: " +
            std::to_string(worst.n_above) + " of " + std::to_string(worst.n)
        : "Friction falls so steeply that the steady state may be one of "
          "several";
    const std::string remedy =
      !in_time
        ? "Which one is found depends on where the solver starts; a transient "
          "with inertia tells which one follows from a known state."
      : solutions == SolutionsOf::steps_with_inertia
        ? "The solver starts from the friction of the step before. The "
          "solution is certain to be the only one if steps are well below the "
          "time that a wave needs to cross an element."
        : "Without inertia nothing limits how fast sliding changes, and "
          "smaller steps make it worse: take longer steps, or Time/Inertia = "
          "true.";
    log.warning(
      what + ". Worst ratio of fall to compliance " +
      significant(worst.ratio, 3) +
      " (unique well below 1, see "
      "contact/uniqueness.h) " +
      (worst.of.empty() ? "" : "at " + worst.of + ", ") +
      "node at x = " + millimetres(worst.position[0]) +
      (dimension == 3 ? ", y = " + millimetres(worst.position[1]) : "") + ". " +
      remedy);
  }

  std::string scale_of_friction(const ContactParameters &contact)
  {
    return contact.falling_friction() ? "\u03bc\u209b " : "\u03bc";
  }
} // namespace RollingContact
