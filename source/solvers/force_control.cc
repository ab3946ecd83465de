#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/base/broadcast.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/contact/friction_limit.h>
#include <rolling_contact/contact/resultants.h>
#include <rolling_contact/solvers/force_control.h>
#include <rolling_contact/solvers/scaled_forces.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace RollingContact
{
  namespace
  {
    using Vector = std::vector<double>;
    using Asked  = std::vector<std::pair<unsigned int, double>>;

    double &component(Creepages &creepages, const unsigned int k)
    {
      return k == 0 ? creepages.x : k == 1 ? creepages.y : creepages.spin;
    }

    /**
     * The creepages on their way to the asked forces.
     */
    class CreepageSearch
    {
    public:
      CreepageSearch(const std::function<SolverReport()> &solve,
                     const SolverControls                &controls,
                     ContactProblem                      &problem,
                     ContactState                        &state)
        : solve(solve)
        , controls(controls)
        , problem(problem)
        , state(state)
        , asked(asked_components(problem.loads.forces))
        , saturation(problem.n_tangential() + 1.)
      {}

      SolverReport find();

    private:
      struct Point
      {
        Creepages    creepages;
        ContactState state;
        Vector       forces;        ///< scaled
        DenseMatrix  derivative;    ///< of the scaled forces
        double       distance = 0.; ///< of G from that of the asked forces
      };

      bool solve_here(Point &point);

      void set_scales();

      void refuse_beyond_friction() const;

      Vector newton_step(const Point &point) const;

      bool step(Point &point);

      /**
       * Steps from a point as long as they come closer.
       */
      void go_on(bool works, Point &point);

      bool hold_edges(const Point &point);

      bool bracket(Point &point);

      bool is_there(const Point &point) const;

      std::string described(const Creepages &creepages,
                            const Vector    &forces) const;

      const std::function<SolverReport()> &solve;
      const SolverControls                &controls;
      ContactProblem                      &problem;
      ContactState                        &state;
      const Asked                          asked;
      const Saturation                     saturation;
      Vector                               scales, target, G;
      SolverReport                         report;
    };

    /**
     * Solve for the creepages of the problem; false if there is no state or
     * its forces do not answer to creepages. All that is decided by a point
     * comes from rank 0. Collective.
     */
    bool CreepageSearch::solve_here(Point &point)
    {
      throw_if_interrupted();
      const SolverReport now = solve();
      report.add_work(now);
      ++report.force_rounds;
      report.solver        = now.solver;
      report.used_fallback = now.used_fallback;
      report.edges_settled = now.edges_settled;
      report.converged     = now.converged;
      report.reason        = now.reason;
      report.residual      = now.residual;
      if (!report.converged)
        return false;
      if (scales.empty())
        set_scales();
      point.creepages                = problem.loads.creepages;
      point.state                    = state;
      std::tie(target, point.forces) = scaled_forces(problem, state, scales);
      // ranks on unlike processors have other last digits
      Ranks::broadcast(target);
      Ranks::broadcast(point.forces);
      G                  = saturation.value(target);
      const Vector now_G = saturation.value(point.forces);
      double       sum   = 0.;
      for (std::size_t k = 0; k < asked.size(); ++k)
        sum += std::pow(now_G[k] - G[k], 2);
      point.distance = std::sqrt(sum);
      bool answers   = is_there(point);
      if (!answers)
        {
          point.derivative =
            scaled_derivative(problem, controls, state, scales);
          answers = point.derivative.size() > 0 && !newton_step(point).empty();
        }
      Vector decisive{point.distance, answers ? 1. : 0.};
      Ranks::broadcast(decisive);
      point.distance = decisive[0];
      return decisive[1] > 0.;
    }

    void CreepageSearch::set_scales()
    {
      refuse_beyond_friction();
      scales = force_scales(problem, state);
    }

    /** "Longitudinal force = 5 N, Spin moment = 2 N m" */
    std::string named(const Asked &forces)
    {
      const char *names[] = {"Longitudinal force",
                             "Lateral force",
                             "Spin moment"};
      std::string text;
      for (const auto &[k, force] : forces)
        text += (text.empty() ? "" : ", ") + std::string(names[k]) + " = " +
                significant(force, 6) + (k == 2 ? " N m" : " N");
      return text;
    }

    void CreepageSearch::refuse_beyond_friction() const
    {
      const double friction = sliding_resultant(problem, state.pressure, 0),
                   share    = largest_share_of_forces(problem, state.pressure);
      if (share > 1.)
        return;
      auto largest = asked;
      for (auto &it : largest)
        it.second *= share;
      throw InputError(
        named(asked) + ": " +
        (friction > 0. ? "friction carries less than " + named(largest) +
                           " here, where mu N = " + significant(friction, 6) +
                           " N. Give less, or creepages."
                       : "the bodies do not touch, and friction carries no "
                         "force. Give a load or an approach, or creepages."));
    }

    bool CreepageSearch::is_there(const Point &point) const
    {
      double off = 0.;
      for (std::size_t k = 0; k < asked.size(); ++k)
        off = std::max(off, std::abs(point.forces[k] - target[k]));
      return off <= std::max(1e-9, 0.1 * controls.tolerance);
    }

    /**
     * Empty if the forces do not answer to the creepages.
     */
    Vector CreepageSearch::newton_step(const Point &point) const
    {
      DenseMatrix matrix =
        saturation.derivative(point.forces) * point.derivative;
      Vector step = sum(G, -1., saturation.value(point.forces));
      if (!solve_general(matrix, as_vector(step)) ||
          !as_vector(step).allFinite())
        return {};
      return step;
    }

    /**
     * Take the Newton step or the largest of its halves that comes closer.
     */
    bool CreepageSearch::step(Point &point)
    {
      const unsigned int max_halvings = point.state.holds_scheme ? 14 : 4;
      Vector             whole        = newton_step(point);
      Ranks::broadcast(whole);
      double part = 1.;
      for (unsigned int k = 0; k < max_halvings; ++k, part /= 2)
        {
          Creepages next = point.creepages;
          for (std::size_t l = 0; l < asked.size(); ++l)
            component(next, asked[l].first) += part * whole[l];
          problem.loads.creepages = next;
          if (k > 0)
            state = point.state;
          Point trial;
          if (solve_here(trial) &&
              (is_there(trial) ||
               trial.distance < (1 - 0.1 * part) * point.distance))
            {
              point = std::move(trial);
              return true;
            }
        }
      return false;
    }

    std::string CreepageSearch::described(const Creepages &creepages,
                                          const Vector    &forces) const
    {
      auto reached = asked;
      for (std::size_t k = 0; k < asked.size(); ++k)
        reached[k].second = forces[k] * scales[k];
      return named(reached) + " at creepages " + significant(creepages.x, 5) +
             ", " + significant(creepages.y, 5) + " and spin " +
             significant(creepages.spin, 5) + " 1/m";
    }

    void CreepageSearch::go_on(bool works, Point &point)
    {
      const unsigned int max_steps = 30;
      for (unsigned int k = 0; works && k < max_steps && !is_there(point); ++k)
        works = step(point);
    }

    /**
     * On a mesh the force jumps where the edge law gets an edge or loses one;
     * with those that the state of a point has it does not.
     */
    bool CreepageSearch::hold_edges(const Point &point)
    {
      state                   = point.state;
      state.holds_scheme      = true;
      problem.loads.creepages = point.creepages;
      Point held;
      go_on(solve_here(held), held);
      state.holds_scheme = false;
      return report.converged && is_there(held);
    }

    /**
     * Where all nodes slide, some forwards and some backwards, a force does not
     * answer to its creepage: go against it in growing steps until the force
     * is passed, then bisect, with Newton's steps from wherever it answers.
     */
    bool CreepageSearch::bracket(Point &point)
    {
      if (asked.size() != 1 || point.forces.empty())
        return false;
      const auto   c         = asked[0].first;
      const double direction = point.forces[0] > target[0] ? 1. : -1.;
      double       step = 1e-6, from = component(point.creepages, c), to = 0.;
      bool         passed = false;
      for (unsigned int k = 0; k < 60; ++k)
        {
          const double at = passed ? (from + to) / 2 : from + direction * step;
          component(problem.loads.creepages, c) = at;
          Point      trial;
          const bool answers = solve_here(trial);
          if (!report.converged)
            return false;
          if (answers && k % 4 == 0)
            go_on(true, trial);
          if (is_there(trial))
            {
              point = std::move(trial);
              return true;
            }
          const bool beyond    = (trial.forces[0] - target[0]) * direction < 0.;
          passed               = passed || beyond;
          (beyond ? to : from) = component(trial.creepages, c);
          step *= 4;
        }
      return false;
    }

    SolverReport CreepageSearch::find()
    {
      Point point;
      bool  works = solve_here(point);
      if (!report.converged)
        return report;
      if (!works) // all slides: begin where nothing is asked to
        {
          for (const auto &it : asked)
            component(problem.loads.creepages, it.first) = 0.;
          works = solve_here(point);
        }
      go_on(works, point);
      if (is_there(point) || hold_edges(point) || bracket(point))
        return report;
      // the best state found, and that it is not the one
      state                   = point.state;
      problem.loads.creepages = point.creepages;
      report.converged        = false;
      report.reason           = "no state with " + named(asked) +
                      " was found; the closest has " +
                      described(point.creepages, point.forces) +
                      (problem.loads.friction_law
                         ? ". Friction falls with the sliding speed: give less"
                         : "");
      return report;
    }
  } // namespace

  SolverReport solve_for_forces(const std::function<SolverReport()> &solve,
                                const SolverControls                &controls,
                                ContactProblem                      &problem,
                                ContactState                        &state)
  {
    return CreepageSearch(solve, controls, problem, state).find();
  }
} // namespace RollingContact
