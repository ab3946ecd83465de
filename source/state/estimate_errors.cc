#include <rolling_contact/contact/halved_problem.h>
#include <rolling_contact/contact/node_lines.h>
#include <rolling_contact/solvers/newton_system.h>
#include <rolling_contact/state/estimate_errors.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /**
     * What the problems with half of the nodes are solved to: much less than
     * their own errors, and soon.
     */
    const double       tolerance       = 1e-8;
    const unsigned int most_iterations = 500;

    bool is_finite(const Resultants &found)
    {
      return std::isfinite(found.normal_force + found.force_x + found.force_y +
                           found.spin_moment + found.max_pressure);
    }

    void keep_larger(double &largest, const double change)
    {
      if (std::isfinite(change))
        largest = std::max(largest, std::abs(change));
    }

    /**
     * Keep the changes of the values of a state that are larger than before.
     */
    void keep_larger(const Resultants &state,
                     const Resultants &other,
                     ValueChanges     &changes)
    {
      keep_larger(changes.force,
                  std::hypot(state.force_x - other.force_x,
                             state.force_y - other.force_y));
      keep_larger(changes.moment, state.spin_moment - other.spin_moment);
      keep_larger(changes.normal_force,
                  state.normal_force - other.normal_force);
      keep_larger(changes.max_pressure,
                  state.max_pressure - other.max_pressure);
      keep_larger(changes.dissipation, state.dissipation - other.dissipation);
    }

    /**
     * Weights of tractions and pressures in the forces along x and y and the
     * moment of spin, and in the load.
     */
    std::vector<ContactState> weights_of_forces(const ContactProblem &problem)
    {
      std::vector<ContactState> weights;
      const unsigned int        n = problem.n_tangential();
      for (unsigned int c = 0; c < (n == 2 ? 3 : n); ++c)
        {
          ContactState     weight = open_state(problem);
          const NodalField slip =
            rigid_slip(problem.operators,
                       {c == 0 ? 1. : 0., c == 1 ? 1. : 0., c == 2 ? 1. : 0.});
          weight.traction =
            NodalField(problem.n_nodes(),
                       problem.operators.H().multiply_transposed(
                         slip.values()));
          weights.push_back(weight);
        }
      weights.push_back(open_state(problem));
      weights.back().pressure = problem.operators.load_areas();
      return weights;
    }

    /**
     * How much the errors of the bulk change the values of a state of @p
     * problem, which may be that on half of the nodes. None if that is not
     * known.
     */
    template <int dim>
    std::optional<ValueChanges> changes_by_bulk(const PairSpec         &scene,
                                                const SteadyState<dim> &steady,
                                                const ContactProblem   &problem,
                                                const ContactState     &state)
    {
      if (steady.pair->bulk_errors().smooth.forces().empty())
        return {};
      const auto &positions = steady.problem.operators.positions();
      const auto  forces    = nodal_forces(steady.problem, steady.state);
      const auto  answers = NewtonSystem(problem, scene.solver.controls, state)
                             .sensitivities(weights_of_forces(problem));
      std::vector<double> changes;
      for (const std::vector<double> &answer : answers)
        changes.push_back(steady.pair->bulk_errors().largest(
          problem.operators.positions(), answer, positions, forces));
      if (changes.empty())
        return {};
      ValueChanges      bulk;
      const Resultants &found = steady.result;
      bulk.normal_force       = changes.back();
      if (changes.size() > 1)
        bulk.force = changes[0];
      if (changes.size() > 2)
        {
          bulk.force  = std::hypot(changes[0], changes[1]);
          bulk.moment = changes[2];
        }
      bulk.max_pressure =
        0.5 * bulk.normal_force / found.normal_force * found.max_pressure;
      const Creepages &creepages = steady.problem.loads.creepages;
      bulk.dissipation = bulk.force * std::hypot(creepages.x, creepages.y) +
                         bulk.moment * std::abs(creepages.spin);
      return bulk;
    }

    /**
     * |s_i - s_j| / min(|s_i|, |s_j|), at most 1.
     */
    double
    turn(const NodalField &slip, const unsigned int i, const unsigned int j)
    {
      double change = 0.;
      for (unsigned int c = 0; c < slip.n_components(); ++c)
        change = std::hypot(change, slip(c, i) - slip(c, j));
      const double smaller = std::min(slip.norm_at(i), slip.norm_at(j));
      return change < smaller ? change / smaller : 1.;
    }

    /**
     * ErrorEstimate::load_on_turning_slip.
     */
    std::optional<double> load_on_turning_slip(const ContactProblem &problem,
                                               const ContactState   &state)
    {
      if (problem.n_tangential() == 0)
        return {};
      const TangentialProblem tangential = tangential_problem(problem, state);
      const auto              states     = node_states(tangential, state);
      if (std::find(states.begin(), states.end(), NodeState::stick) !=
          states.end())
        return {};
      const NodalField    slip = tangential.mean_slip(state);
      std::vector<double> turns(problem.n_nodes(), 0.);
      for (unsigned int axis = 0; axis < problem.n_tangential(); ++axis)
        for (const auto &line : node_lines(problem.operators, axis))
          for (std::size_t k = 1; k < line.size(); ++k)
            if (const unsigned int i = line[k - 1], j = line[k];
                states[i] == NodeState::slip && states[j] == NodeState::slip)
              for (const unsigned int node : {i, j})
                turns[node] = std::max(turns[node], turn(slip, i, j));
      double sum = 0.;
      for (unsigned int i = 0; i < problem.n_nodes(); ++i)
        sum += problem.operators.areas()[i] * state.pressure[i] *
               std::pow(turns[i], 2);
      return sum;
    }
  } // namespace

  template <int dim>
  void make_halves(const PairSpec &scene, SteadyState<dim> &steady)
  {
    if (!steady.halves.empty())
      return;
    for (unsigned int k = 0; k < 1u << (dim - 1); ++k)
      if (auto half = halved_problem(steady.problem,
                                     steady.pair->trace(),
                                     scene.contact.contact_matrices,
                                     dim == 2 ? scene.thickness() : 1.,
                                     {{k & 1, k >> 1}}))
        steady.halves.push_back(std::move(*half));
  }

  std::optional<ContactState> state_of_half(const PairSpec       &scene,
                                            const ContactProblem &whole,
                                            const ContactState   &from,
                                            HalvedProblem        &half)
  {
    half.take(whole);
    SolverControls controls = scene.solver.controls;
    controls.tolerance      = std::max(controls.tolerance, tolerance);
    controls.max_iterations =
      std::min(controls.max_iterations, most_iterations);
    ContactState state = halved_state(half, from);
    if (!make_contact_solver("economical", controls)
           ->solve(half.problem, state)
           .converged)
      return {};
    return state;
  }

  template <int dim>
  void estimate_errors(const PairSpec &scene, SteadyState<dim> &steady)
  {
    const ContactProblem &problem = steady.problem;
    steady.estimate.reset();
    if (!steady.solver.converged || steady.result.n_touching == 0 ||
        problem.operators.time_scaling().rate != 0.)
      return;
    make_halves(scene, steady);
    ErrorEstimate         estimate;
    const ContactProblem *last = &problem;
    ContactState          last_state;
    for (HalvedProblem &half : steady.halves)
      if (auto state = state_of_half(scene, problem, steady.state, half))
        {
          const Resultants found = resultants(half.problem, *state);
          if (!is_finite(found) || found.n_touching == 0)
            continue;
          keep_larger(steady.result, found, estimate.across);
          ++estimate.n_positions;
          last       = &half.problem;
          last_state = std::move(*state);
        }
    estimate.load_on_turning_slip = load_on_turning_slip(problem, steady.state);
    estimate.bulk                 = changes_by_bulk(
      scene, steady, *last, last == &problem ? steady.state : last_state);
    steady.estimate = estimate;
  }

  template void make_halves(const PairSpec &, SteadyState<2> &);
  template void make_halves(const PairSpec &, SteadyState<3> &);
  template void estimate_errors(const PairSpec &, SteadyState<2> &);
  template void estimate_errors(const PairSpec &, SteadyState<3> &);
} // namespace RollingContact
