#include <rolling_contact/contact/contact_problem.h>

#include <cmath>

namespace RollingContact
{
  NodalField rigid_slip(const ContactOperators &operators,
                        const Creepages        &creepages)
  {
    const unsigned int n_tangential = operators.n_tangential();
    NodalField         slip(operators.n_nodes(), n_tangential);
    for (unsigned int i = 0; i < operators.n_nodes(); ++i)
      {
        const auto at_node = creepages.at(operators.place(i));
        for (unsigned int c = 0; c < n_tangential; ++c)
          slip(c, i) = at_node[c];
        if (!operators.frames().is_plane() && n_tangential > 1)
          slip(1, i) *= std::cos(operators.frames().nodes[i].angle);
      }
    return slip;
  }

  NodalField ContactProblem::rigid_slip() const
  {
    NodalField slip = RollingContact::rigid_slip(operators, loads.creepages);
    if (!loads.slip_of_profile.empty())
      slip += loads.slip_of_profile;
    return slip;
  }

  ContactState open_state(const ContactProblem &problem)
  {
    ContactState state;
    state.pressure.assign(problem.n_nodes(), 0.);
    state.traction = NodalField(problem.n_nodes(), problem.n_tangential());
    return state;
  }

  void complete(const ContactProblem &problem, ContactState &state)
  {
    state.pressure.resize(problem.n_nodes(), 0.);
    if (state.traction.n_nodes() != problem.n_nodes())
      state.traction = NodalField(problem.n_nodes(), problem.n_tangential());
    if (!problem.loads.normal_load)
      state.approach = problem.loads.approach;
  }

  std::vector<double> nodal_forces(const ContactProblem &contact,
                                   const ContactState   &state)
  {
    const SparseRows         &H      = contact.operators.H();
    std::vector<double>       forces = H.multiply(state.traction.values());
    const std::vector<double> normal = H.multiply(state.pressure);
    forces.insert(forces.end(), normal.begin(), normal.end());
    return forces;
  }

  std::vector<NodalForce> forces_in_plane(const ContactProblem      &contact,
                                          const std::vector<double> &forces)
  {
    const unsigned int n            = contact.n_nodes(),
                       n_tangential = contact.n_tangential();
    const SurfaceFrames    &frames  = contact.operators.frames();
    std::vector<NodalForce> result(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        const double along  = n_tangential > 0 ? forces[i] : 0.,
                     across = n_tangential > 1 ? forces[n + i] : 0.,
                     normal = forces[n_tangential * n + i];
        result[i]           = {along, across, normal};
        if (frames.is_plane())
          continue;
        const double c = std::cos(frames.nodes[i].angle),
                     s = std::sin(frames.nodes[i].angle);
        result[i] = {along, c * across + s * normal, c * normal - s * across};
      }
    return result;
  }

  std::vector<double> normal_gap(const ContactProblem &contact,
                                 const ContactState   &state)
  {
    std::vector<double> u_n =
      contact.operators.normal_displacement(state.pressure);
    const std::vector<double> coupling =
      contact.operators.normal_displacement_of_traction(state.traction);
    for (unsigned int i = 0; i < contact.n_nodes(); ++i)
      u_n[i] += contact.loads.gap[i] -
                state.approach * contact.operators.approach_share(i) +
                coupling[i];
    return u_n;
  }
} // namespace RollingContact
