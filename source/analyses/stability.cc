#include <rolling_contact/analyses/rolling_modes.h>
#include <rolling_contact/analyses/solve_to_target.h>
#include <rolling_contact/analyses/stability.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/parallel/interrupt.h>
#include <rolling_contact/plot/figure.h>
#include <rolling_contact/report/bodies_report.h>
#include <rolling_contact/report/result_row.h>
#include <rolling_contact/report/state_report.h>
#include <rolling_contact/stability/correction.h>
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

    /// largest damping ratio that the picture shows (%)
    const double shown_damping = 1.;



    StateDemands
    demands()
    {
      StateDemands demands;
      demands.pair.displacements = true; // keeps the factors
      demands.pair.factors       = true;
      return demands;
    }



    /** A vibration and what is known of it. */
    struct Finding
    {
      StabilityMode                mode;
      std::optional<CorrectedMode> corrected;

      double
      growth() const
      {
        return corrected ? corrected->growth() : mode.growth();
      }

      bool
      unstable() const
      {
        return corrected ? corrected->unstable() : mode.growth() > 0.;
      }
    };



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



    /** The column with the largest share among those of a body. */
    std::pair<std::size_t, double>
    largest_share(const std::vector<double> &shares,
                  const std::size_t          begin,
                  const std::size_t          end)
    {
      std::size_t largest = begin;
      for (std::size_t k = begin; k < end; ++k)
        if (shares[k] > shares[largest])
          largest = k;
      return {largest, begin < end ? shares[largest] : 0.};
    }



    /** By how much the lateral force leads the normal one: the phase of their
     * sums over the patch. */
    double
    phase_of_forces(const LinearContact &contact, const ComplexVector &unknowns)
    {
      const unsigned int   N = contact.n_nodes, T = contact.n_tangential;
      std::complex<double> tangential = 0., normal = 0.;
      for (std::size_t k = 0; k < unknowns.size(); ++k)
        for (unsigned int i = 0; i < N; ++i)
          {
            normal += contact.forces(T * N + i, k) * unknowns[k];
            tangential += contact.forces((T - 1) * N + i, k) * unknowns[k];
          }
      return std::arg(tangential / normal);
    }



    template <int dim>
    void
    set_nearest(const Side                 side,
                const RollingModes<dim>   &rolling,
                const std::vector<double> &shares,
                ResultsTable              &table)
    {
      const ReducedPair &pair  = rolling.reduced();
      const bool         wheel = side == Side::wheel;
      const auto [column, share] =
        largest_share(shares,
                      wheel ? 0 : pair.n_wheel_modes,
                      wheel ? pair.n_wheel_modes : pair.n_modes());
      const std::string name = name_of(side);
      if (rolling.body(side) == nullptr ||
          rolling.body(side)->modes.size() == 0)
        {
          for (const char *what : {"_mode", "_mode_Hz", "_mode_share"})
            table.leave_empty(name + what);
          return;
        }
      const std::size_t mode = rolling.mode_of(column).second;
      table.set(name + "_mode", mode + 1);
      table.set(name + "_mode_Hz", rolling.body(side)->modes.frequencies[mode]);
      table.set(name + "_mode_share", share);
    }



    template <int dim>
    void
    add_row(const Finding           &finding,
            const LinearContact     &contact,
            const RollingModes<dim> &rolling,
            ResultsTable            &table)
    {
      const StabilityMode &mode = finding.mode;
      table.set("frequency_Hz", mode.frequency());
      table.set("growth_1/s", mode.growth());
      table.set("damping_ratio", mode.damping_ratio());
      if (finding.corrected)
        {
          const CorrectedMode &corrected = *finding.corrected;
          table.set("corrected_frequency_Hz",
                    std::abs(corrected.s.imag()) / (2 * pi));
          table.set("corrected_growth_1/s", corrected.growth());
          table.set("uncertainty_1/s", corrected.uncertainty);
          table.set("reduced_backward_error", corrected.first_backward_error);
          table.set("backward_error", corrected.backward_error);
          table.set("undecided", corrected.undecided());
          table.set("damping_needed", corrected.damping_needed);
        }
      else
        for (const char *column : {"corrected_frequency_Hz",
                                   "corrected_growth_1/s",
                                   "uncertainty_1/s",
                                   "reduced_backward_error",
                                   "backward_error",
                                   "undecided",
                                   "damping_needed"})
          table.leave_empty(column);
      table.set("unstable", finding.unstable());
      const std::vector<double> shares = mode.participation();
      for (const Side side : both_sides)
        set_nearest(side, rolling, shares, table);
      table.set("force_phase_rad", phase_of_forces(contact, mode.unknowns));
      table.end_row();
    }



    void
    plot_eigenvalues(const ComplexVector        &eigenvalues,
                     const std::vector<Finding> &findings,
                     const double                lowest,
                     const double                highest,
                     RunContext                 &context)
    {
      std::vector<double> f, zeta, unstable_f, unstable_zeta;
      for (const auto &s : eigenvalues)
        if (s.imag() / (2 * pi) >= lowest && s.imag() / (2 * pi) <= highest)
          {
            const double ratio = -100 * s.real() / std::abs(s);
            if (ratio > shown_damping)
              continue;
            f.push_back(s.imag() / (2 * pi * 1000));
            zeta.push_back(ratio);
          }
      for (const Finding &finding : findings)
        if (finding.unstable())
          {
            unstable_f.push_back(finding.mode.frequency() / 1000);
            unstable_zeta.push_back(100 * finding.mode.damping_ratio());
          }
      Figure figure("Vibrations about the steady rolling state",
                    "frequency (kHz)",
                    "damping ratio (%)");
      figure.add_curve("below 1 %", f, zeta, CurveStyle::points);
      if (!unstable_f.empty())
        figure.add_curve("unstable",
                         unstable_f,
                         unstable_zeta,
                         CurveStyle::points);
      figure.draw(context, "stability");
    }
  } // namespace



  template <int dim>
  void
  Stability<dim>::run()
  {
    if (!bodies_touch(scene))
      throw InputError("Analysis = stability needs contact: check "
                       "Contact/Approach and Contact/Normal load.");
    SceneParameters        used = scene;
    const SteadyState<dim> steady =
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

    const double lowest  = scene.stability.lowest_frequency,
                 highest = scene.modes.maximum_frequency;
    const RollingModes<dim> rolling(scene,
                                    steady,
                                    scene.modes.cut_off_ratio * highest,
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

    std::vector<Finding> findings;
    for (const auto &s : listed(eigenvalues, lowest, highest))
      {
        throw_if_interrupted();
        findings.push_back({pencil.mode(s), {}});
        if (!scene.stability.correct)
          continue;
        CorrectionOptions correction;
        correction.damping_margin = scene.stability.damping_margin;
        findings.back().corrected = correct(
          rolling.reduced(),
          contact,
          findings.back().mode,
          [&](const std::complex<double> at, const ComplexVector &forces) {
            return rolling.response(at, forces);
          },
          correction);
      }
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
    std::size_t n_real = 0, n_reduced = 0;
    double      fastest = 0.;
    for (const auto &s : eigenvalues)
      {
        if (s.imag() == 0. && s.real() > 0.)
          {
            ++n_real;
            fastest = std::max(fastest, s.real());
          }
        const double f = s.imag() / (2 * pi);
        n_reduced += s.real() > 0. && f >= lowest && f <= highest ? 1 : 0;
      }
    std::string counted;
    if (scene.stability.count)
      {
        CountOptions count;
        count.lowest_frequency  = lowest;
        count.highest_frequency = highest;
        const UnstableCount found =
          UnstableCounter(rolling.reduced(), count).count(contact);
        counted = found.resolved && found.count == static_cast<int>(n_reduced)
                    ? ", as many as the argument principle counts"
                    : "";
        if (!found.resolved || found.count != static_cast<int>(n_reduced))
          context.log.warning(
            "The argument principle counts " + std::to_string(found.count) +
            " unstable vibrations (" + significant(found.turns, 4) +
            " turns), the eigenvalues are " + std::to_string(n_reduced) +
            ". A vibration that is neither stable nor unstable may lie on the "
            "contour.");
      }
    if (n_real > 0)
      context.log.warning(
        "The contact by itself is unstable: " + std::to_string(n_real) +
        " real eigenvalues, up to " + significant(fastest, 3) +
        " 1/s. This is no squeal: friction falls faster with the speed than "
        "its memory allows. Raise Stability/Friction memory, or take Friction "
        "response = constant.");
    if (contact.n_border() > 0)
      context.log.detail(
        std::to_string(contact.n_border()) +
        " nodes are about to open, to slip or to stick, where the laws have "
        "other derivatives on either side.");

    const Finding *worst = nullptr;
    std::size_t    n     = 0;
    for (const Finding &finding : findings)
      if (finding.unstable())
        {
          ++n;
          if (worst == nullptr || finding.growth() > worst->growth())
            worst = &finding;
        }
    std::string verdict = "no vibration grows between " +
                          significant(lowest, 4) + " and " +
                          significant(highest, 5) + " Hz" + counted;
    if (worst != nullptr)
      verdict =
        std::to_string(n) + (n == 1 ? " mode grows" : " modes grow") + counted +
        "; the fastest at " + significant(worst->mode.frequency(), 5) +
        " Hz by " + significant(worst->growth(), 3) + " 1/s" +
        (worst->corrected
           ? ", needs a damping ratio of " +
               significant(worst->corrected->damping_needed, 2) + " more"
           : "");
    context.report.set_finding("squeal", verdict);
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
      plot_eigenvalues(eigenvalues, findings, lowest, highest, context);
  }



  template class Stability<2>;
  template class Stability<3>;
} // namespace RollingContact
