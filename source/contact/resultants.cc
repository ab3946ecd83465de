#include <rolling_contact/contact/patch_edges.h>
#include <rolling_contact/contact/resultants.h>
#include <rolling_contact/contact/sliding_response.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    void add_forces(const ContactProblem &problem,
                    const ContactState   &state,
                    Resultants           &result)
    {
      const ContactOperators &operators = problem.operators;
      const bool              is_plane  = operators.frames().is_plane();
      if (is_plane)
        result.normal_force = operators.resultant(state.pressure);
      if (is_plane && problem.n_tangential() == 0)
        return;
      const std::vector<double>     along_nodes = nodal_forces(problem, state);
      const std::vector<NodalForce> forces =
        forces_in_plane(problem, along_nodes);
      const unsigned int    n = problem.n_nodes();
      std::array<double, 2> tangential{};
      for (unsigned int i = 0; i < problem.n_nodes(); ++i)
        {
          result.friction_force += operators.areas()[i] *
                                   problem.loads.friction[i] *
                                   state.pressure[i];
          const auto        place = operators.place(i);
          const NodalForce &force = forces[i];
          result.force_x += force.x;
          result.force_y += force.y;
          if (!is_plane)
            result.normal_force += force.z;
          result.spin_moment += place[0] * force.y - place[1] * force.x;
          for (unsigned int c = 0; c < problem.n_tangential(); ++c)
            tangential[c] += along_nodes[c * n + i];
        }
      const double pressed    = operators.resultant(state.pressure);
      result.tangential_force = std::hypot(tangential[0], tangential[1]);
      if (pressed > 0.)
        result.traction_coefficient = result.tangential_force / pressed;
    }

    void add_sizes(const TangentialProblem      &tangential,
                   const std::vector<NodeState> &states,
                   const ContactState           &state,
                   Resultants                   &result)
    {
      const ContactProblem   &problem   = tangential.contact;
      const ContactOperators &operators = problem.operators;
      double                  load      = 0.;
      for (unsigned int i = 0; i < problem.n_nodes(); ++i)
        if (states[i] != NodeState::open)
          {
            ++result.n_touching;
            result.max_pressure =
              std::max(result.max_pressure, state.pressure[i]);
            const double force = operators.areas()[i] * state.pressure[i];
            load += force;
            result.centre_x += force * operators.positions()[i][0];
            result.centre_y += force * operators.positions()[i][1];
          }
      if (load > 0.)
        {
          result.centre_x /= load;
          result.centre_y /= load;
        }
      const PatchEdges edges =
        recovered_edges(problem.operators, state.pressure);
      result.edge_begin_x = edges.begin_x;
      result.edge_end_x   = edges.end_x;
      result.half_width_x = (edges.end_x - edges.begin_x) / 2;
      result.half_width_y = (edges.end_y - edges.begin_y) / 2;
    }
  } // namespace

  std::vector<NodeState> node_states(const TangentialProblem &tangential,
                                     const ContactState      &state)
  {
    const ContactProblem  &problem = tangential.contact;
    std::vector<NodeState> states(problem.n_nodes(), NodeState::open);
    const bool             rests = std::all_of(state.traction.begin(),
                                   state.traction.end(),
                                   [](const double q) { return q == 0.; });
    for (unsigned int i = 0; i < problem.n_nodes(); ++i)
      if (state.pressure[i] > 0.)
        // a node that the edge law releases slips without traction
        states[i] =
          (rests || tangential.bound[i] > 0.) &&
              state.traction.norm_at(i) <
                (1 - 1e-9) * tangential.friction[i] * state.pressure[i]
            ? NodeState::stick
            : NodeState::slip;
    if (!problem.loads.friction_law || state.holds_friction)
      return states;
    for (unsigned int i = 0; i < problem.n_nodes(); ++i)
      if (states[i] == NodeState::slip)
        states[i] = NodeState::stick;
    for (const unsigned int i : slipping_nodes(tangential, state.traction))
      states[i] = NodeState::slip;
    return states;
  }

  double Resultants::energy_error() const
  {
    const double larger = std::max(std::abs(creep_work), std::abs(dissipation));
    return larger > 0. ? std::abs(creep_work - dissipation) / larger : 0.;
  }

  Resultants resultants(const ContactProblem &problem,
                        const ContactState   &state)
  {
    const TangentialProblem tangential = tangential_problem(problem, state);
    Resultants              result;
    add_forces(problem, state, result);
    if (problem.n_tangential() > 0)
      {
        result.creep_work =
          -dot(problem.operators.H() * state.traction, problem.rigid_slip());
        result.dissipation = dissipation(tangential, state);
      }
    add_sizes(tangential, node_states(tangential, state), state, result);
    return result;
  }

  std::array<double, 3> plane_resultant(const ContactProblem      &problem,
                                        const std::vector<double> &forces)
  {
    const std::vector<NodalForce> in_plane = forces_in_plane(problem, forces);
    std::array<double, 3>         sum{};
    for (unsigned int i = 0; i < problem.n_nodes(); ++i)
      {
        const auto        place = problem.operators.place(i);
        const NodalForce &force = in_plane[i];
        sum[0] += force.x;
        sum[1] += force.y;
        sum[2] += place[0] * force.y - place[1] * force.x;
      }
    return sum;
  }

  double dissipation(const TangentialProblem &tangential,
                     const ContactState      &state)
  {
    return dissipation(tangential.contact.operators,
                       state.traction,
                       tangential.mean_slip(state));
  }

  double dissipation(const ContactOperators &operators,
                     const NodalField       &traction,
                     const NodalField       &slip)
  {
    double power = 0.;
    for (unsigned int c = 0; c < slip.n_components(); ++c)
      for (unsigned int i = 0; i < slip.n_nodes(); ++i)
        power += operators.areas()[i] * traction(c, i) * slip(c, i);
    return -power;
  }

  std::vector<unsigned int> nodes_at_border(const std::vector<bool>   &border,
                                            const ContactProblem      &problem,
                                            const std::vector<double> &pressure)
  {
    const auto &defined = problem.operators.slip_operator().defined();
    std::vector<unsigned int> found;
    for (unsigned int i = 0; i < problem.n_nodes(); ++i)
      if (pressure[i] > 0. &&
          (border[i] || (problem.n_tangential() > 0 && !defined[i])))
        found.push_back(i);
    return found;
  }

  bool reaches_border(const std::vector<bool>   &border,
                      const ContactProblem      &problem,
                      const std::vector<double> &pressure)
  {
    return !nodes_at_border(border, problem, pressure).empty();
  }
} // namespace RollingContact
