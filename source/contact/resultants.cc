#include <rolling_contact/contact/resultants.h>
#include <rolling_contact/contact/sliding_response.h>
#include <rolling_contact/interface/patch_edge.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace RollingContact
{
  namespace
  {
    double
    traction_size(const ContactProblem &problem,
                  const ContactState   &state,
                  const unsigned int    node)
    {
      double size = 0.;
      for (unsigned int c = 0; c < problem.n_tangential; ++c)
        size = std::hypot(size, state.traction[c * problem.n_nodes + node]);
      return size;
    }



    void
    add_forces(const ContactProblem &problem,
               const ContactState   &state,
               Resultants           &result)
    {
      result.normal_force = problem.resultant(state.pressure);
      if (problem.n_tangential == 0)
        return;
      const std::vector<double> force   = problem.H.multiply(state.traction);
      const bool                lateral = problem.n_tangential == 2;
      for (unsigned int i = 0; i < problem.n_nodes; ++i)
        {
          const auto  &position = problem.positions[i];
          const double force_y  = lateral ? force[problem.n_nodes + i] : 0.;
          result.force_x += force[i];
          result.force_y += force_y;
          result.spin_moment += position[0] * force_y - position[1] * force[i];
        }
      if (result.normal_force > 0.)
        result.traction_coefficient =
          std::hypot(result.force_x, result.force_y) / result.normal_force;
    }



    /**
     * Creep work and dissipation: -(q, rigid slip) and -(q, slip).
     */
    void
    add_work(const ContactProblem    &problem,
             const TangentialProblem &tangential,
             const ContactState      &state,
             Resultants              &result)
    {
      if (problem.n_tangential == 0)
        return;
      const std::vector<double> slip = tangential.material_slip(state.traction);
      const std::vector<double> force = problem.H.multiply(state.traction);
      result.creep_work               = -dot(force, problem.rigid_slip);
      result.dissipation              = -dot(force, slip);
    }



    void
    add_sizes(const ContactProblem         &problem,
              const std::vector<NodeState> &states,
              const ContactState           &state,
              Resultants                   &result)
    {
      std::array<double, 2>                  lower{}, upper{};
      std::vector<std::pair<double, double>> line;
      double nearest = std::numeric_limits<double>::max();
      for (unsigned int i = 0; i < problem.n_nodes; ++i)
        if (states[i] != NodeState::open)
          nearest = std::min(nearest, std::abs(problem.positions[i][1]));
      for (unsigned int i = 0; i < problem.n_nodes; ++i)
        {
          if (states[i] == NodeState::open)
            continue;
          const auto &position = problem.positions[i];
          for (unsigned int d = 0; d < 2; ++d)
            {
              lower[d] = result.n_touching == 0
                           ? position[d]
                           : std::min(lower[d], position[d]);
              upper[d] = result.n_touching == 0
                           ? position[d]
                           : std::max(upper[d], position[d]);
            }
          ++result.n_touching;
          result.contact_area += problem.areas[i];
          if (states[i] == NodeState::stick)
            result.stick_area += problem.areas[i];
          result.max_pressure =
            std::max(result.max_pressure, state.pressure[i]);
          if (std::abs(position[1]) <= nearest * (1 + 1e-9))
            line.emplace_back(position[0], state.pressure[i]);
        }
      result.half_width_y = (upper[1] - lower[1]) / 2;
      std::sort(line.begin(), line.end());
      std::vector<double> x, pressure;
      for (const auto &point : line)
        {
          x.push_back(point.first);
          pressure.push_back(point.second);
        }
      result.edge_begin_x = patch_edge(x, pressure);
      std::reverse(x.begin(), x.end());
      std::reverse(pressure.begin(), pressure.end());
      result.edge_end_x   = patch_edge(x, pressure);
      result.half_width_x = (result.edge_end_x - result.edge_begin_x) / 2;
    }
  } // namespace



  std::vector<NodeState>
  node_states(const TangentialProblem &tangential, const ContactState &state)
  {
    const ContactProblem  &problem = tangential.contact;
    std::vector<NodeState> states(problem.n_nodes, NodeState::open);
    const bool             rests = std::all_of(state.traction.begin(),
                                   state.traction.end(),
                                   [](const double q) { return q == 0.; });
    for (unsigned int i = 0; i < problem.n_nodes; ++i)
      if (state.pressure[i] > 0.)
        // a node that the edge law releases slips without traction
        states[i] =
          (rests || tangential.bound[i] > 0.) &&
              traction_size(problem, state, i) <
                (1 - 1e-9) * tangential.friction[i] * state.pressure[i]
            ? NodeState::stick
            : NodeState::slip;
    if (!problem.friction_law || state.holds_friction)
      return states;
    for (unsigned int i = 0; i < problem.n_nodes; ++i)
      if (states[i] == NodeState::slip)
        states[i] = NodeState::stick;
    for (const unsigned int i : slipping_nodes(tangential, state.traction))
      states[i] = NodeState::slip;
    return states;
  }



  double
  Resultants::energy_error() const
  {
    const double larger = std::max(std::abs(creep_work), std::abs(dissipation));
    return larger > 0. ? std::abs(creep_work - dissipation) / larger : 0.;
  }



  Resultants
  resultants(const ContactProblem &problem, const ContactState &state)
  {
    const TangentialProblem tangential = tangential_problem(problem, state);
    Resultants              result;
    add_forces(problem, state, result);
    add_work(problem, tangential, state, result);
    add_sizes(problem, node_states(tangential, state), state, result);
    return result;
  }



  bool
  reaches_border(const std::vector<bool>   &border,
                 const ContactProblem      &problem,
                 const std::vector<double> &pressure)
  {
    const auto &defined = problem.slip_operator.defined();
    for (unsigned int i = 0; i < problem.n_nodes; ++i)
      if (pressure[i] > 0. &&
          (border[i] || (problem.n_tangential > 0 && !defined[i])))
        return true;
    return false;
  }
} // namespace RollingContact
