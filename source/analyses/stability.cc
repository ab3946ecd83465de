#include <rolling_contact/analyses/rolling_modes.h>
#include <rolling_contact/analyses/solve_to_target.h>
#include <rolling_contact/analyses/stability.h>
#include <rolling_contact/analyses/stability_report.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/parallel/interrupt.h>
#include <rolling_contact/report/bodies_report.h>
#include <rolling_contact/report/result_row.h>
#include <rolling_contact/report/state_report.h>
#include <rolling_contact/stability/pencil.h>
#include <rolling_contact/stability/unstable_count.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    const char table_file[] = "stability.csv";

    /// stable vibrations that are listed as well, the least damped ones
    const std::size_t n_stable_listed = 5;



    StateDemands
    demands()
    {
      StateDemands demands;
      demands.pair.displacements = true; // keeps the factors
      demands.pair.factors       = true;
      return demands;
    }



    /** The vibrations from the most unstable on: all that grow, and some of the
     * least damped. */
    std::vector<std::complex<double>>
    listed(const ComplexVector &eigenvalues,
           const double         lowest,
           const double         highest)
    {
      std::vector<std::complex<double>> found;
      for (const auto &s : eigenvalues)
        {
          const double f = s.imag() / (2 * pi);
          if (f >= lowest && f <= highest)
            found.push_back(s);
        }
      const auto damping = [](const std::complex<double> &s) {
        return -s.real() / std::abs(s);
      };
      std::sort(found.begin(), found.end(), [&](const auto &a, const auto &b) {
        return damping(a) < damping(b);
      });
      std::size_t n = 0;
      while (n < found.size() && found[n].real() > 0.)
        ++n;
      found.resize(std::min(found.size(), n + n_stable_listed));
      std::sort(found.begin(), found.end(), [](const auto &a, const auto &b) {
        return a.imag() < b.imag();
      });
      return found;
    }



    /** The listed vibrations, corrected by the whole bodies if that is wanted.
     */
    template <int dim>
    std::vector<Finding>
    find_vibrations(const SceneParameters   &scene,
                    const RollingModes<dim> &rolling,
                    const LinearContact     &contact,
                    const StabilityPencil   &pencil,
                    const ComplexVector     &eigenvalues)
    {
      CorrectionOptions options;
      options.damping_margin = scene.stability.damping_margin;
      std::vector<Finding> findings;
      for (const auto &s : listed(eigenvalues,
                                  scene.stability.lowest_frequency,
                                  scene.modes.maximum_frequency))
        {
          throw_if_interrupted();
          findings.push_back({pencil.mode(s), {}});
          if (scene.stability.correct)
            findings.back().corrected = correct(
              rolling.reduced(),
              contact,
              findings.back().mode,
              [&](const std::complex<double> at, const ComplexVector &forces) {
                return rolling.response(at, forces);
              },
              options);
        }
      return findings;
    }



    /** Warns of a contact that is unstable by itself. */
    void
    warn_of_contact(const ComplexVector &eigenvalues, Log &log)
    {
      std::size_t n       = 0;
      double      fastest = 0.;
      for (const auto &s : eigenvalues)
        if (s.imag() == 0. && s.real() > 0.)
          {
            ++n;
            fastest = std::max(fastest, s.real());
          }
      if (n > 0)
        log.warning("The contact by itself is unstable: " + std::to_string(n) +
                    " real eigenvalues, up to " + significant(fastest, 3) +
                    " 1/s. This is no squeal: friction falls faster with the "
                    "speed than its memory allows. Raise Stability/Friction "
                    "memory, or take Friction response = constant.");
    }



    /** Counts the unstable vibrations a second time; a part of the verdict if
     * they are as many. */
    std::string
    counted_again(const SceneParameters &scene,
                  const ReducedPair     &pair,
                  const LinearContact   &contact,
                  const ComplexVector   &eigenvalues,
                  Log                   &log)
    {
      if (!scene.stability.count)
        return "";
      CountOptions options;
      options.lowest_frequency  = scene.stability.lowest_frequency;
      options.highest_frequency = scene.modes.maximum_frequency;
      int n                     = 0;
      for (const auto &s : eigenvalues)
        {
          const double f = s.imag() / (2 * pi);
          n += s.real() > 0. && f >= options.lowest_frequency &&
                   f <= options.highest_frequency
                 ? 1
                 : 0;
        }
      const UnstableCount found = UnstableCounter(pair, options).count(contact);
      if (found.resolved && found.count == n)
        return ", as many as the argument principle counts";
      log.warning(
        "The argument principle counts " + std::to_string(found.count) +
        " unstable vibrations (" + significant(found.turns, 4) +
        " turns), the eigenvalues are " + std::to_string(n) +
        ". A vibration that is neither stable nor unstable may lie on "
        "the contour.");
      return "";
    }



  } // namespace



  template <int dim>
  SteadyState<dim>
  Stability<dim>::steady_state()
  {
    if (!bodies_touch(scene))
      throw InputError("Analysis = stability needs contact: check "
                       "Contact/Approach and Contact/Normal load.");
    SceneParameters  used = scene;
    SteadyState<dim> steady =
      solve_to_target<dim>(used,
                           demands(),
                           TargetDemands(),
                           context,
                           [&](const SteadyState<dim> &level) {
                             add_result_row(scene, level, context);
                           });
    require_solved(scene, steady, "The steady rolling state");
    describe_bodies(steady, context);
    StateReview<dim> review(scene, context);
    review.add(steady);
    review.warn(steady);
    note_state(steady, context.report);
    return steady;
  }



  template <int dim>
  void
  Stability<dim>::run()
  {
    const SteadyState<dim>  steady = steady_state();
    const RollingModes<dim> rolling(scene,
                                    steady,
                                    scene.modes.cut_off_ratio *
                                      scene.modes.maximum_frequency,
                                    context);
    PhaseTimer::Scope       phase(context.timer, Phase::eigenvalues);
    LinearContactOptions    options;
    options.speed    = std::abs(*scene.contact.speed);
    options.friction = scene.stability.friction;
    options.memory   = scene.stability.memory;
    const LinearContact contact =
      linear_contact(steady.problem, steady.state, options);
    const StabilityPencil pencil(rolling.reduced(), contact);
    const ComplexVector   eigenvalues = pencil.eigenvalues();
    throw_if_interrupted();
    const auto findings =
      find_vibrations(scene, rolling, contact, pencil, eigenvalues);

    ResultsTable table(context.folder, table_file);
    for (const Finding &finding : findings)
      add_row(finding, contact, rolling, table);
    table.flush();
    context.log.message(table.screen_table({"frequency_Hz",
                                            "growth_1/s",
                                            "corrected_growth_1/s",
                                            "damping_needed",
                                            "wheel_mode",
                                            "unstable"}));
    warn_of_contact(eigenvalues, context.log);
    if (contact.n_border() > 0)
      context.log.detail(
        std::to_string(contact.n_border()) +
        " nodes are about to open, to slip or to stick, where the laws have "
        "other derivatives on either side.");
    const std::string counted = counted_again(
      scene, rolling.reduced(), contact, eigenvalues, context.log);
    context.report.set_finding("squeal", verdict(scene, findings, counted));
    double backward = 0.;
    for (const Finding &finding : findings)
      if (finding.corrected)
        backward = std::max(backward, finding.corrected->backward_error);
    if (scene.stability.correct && !findings.empty())
      context.report.errors.push_back(
        {"vibrations that grow",
         backward,
         "the equations of the whole bodies",
         "their backward error after correction, " +
           std::to_string(rolling.n_iterations()) + " solves",
         false,
         ""});
    if (scene.output.plot)
      plot_eigenvalues(eigenvalues,
                       findings,
                       scene.stability.lowest_frequency,
                       scene.modes.maximum_frequency,
                       context);
  }



  template class Stability<2>;
  template class Stability<3>;
} // namespace RollingContact
