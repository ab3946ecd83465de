#include <rolling_contact/contact/contact_problem.h>

namespace RollingContact
{
  NodalField
  ContactProblem::rigid_slip() const
  {
    NodalField slip(n_nodes(), n_tangential());
    for (unsigned int i = 0; i < n_nodes(); ++i)
      {
        const auto at_node = loads.creepages.at(operators.positions()[i]);
        for (unsigned int c = 0; c < n_tangential(); ++c)
          slip(c, i) = at_node[c];
        if (!loads.slip_of_profile.empty() && n_tangential() > 0)
          slip(0, i) += loads.slip_of_profile[i];
      }
    return slip;
  }



  ContactState
  open_state(const ContactProblem &problem)
  {
    ContactState state;
    state.pressure.assign(problem.n_nodes(), 0.);
    state.traction = NodalField(problem.n_nodes(), problem.n_tangential());
    return state;
  }



  void
  complete(const ContactProblem &problem, ContactState &state)
  {
    state.pressure.resize(problem.n_nodes(), 0.);
    if (state.traction.n_nodes() != problem.n_nodes())
      state.traction = NodalField(problem.n_nodes(), problem.n_tangential());
    if (!problem.loads.normal_load)
      state.approach = problem.loads.approach;
  }



  std::vector<double>
  nodal_forces(const ContactProblem &contact, const ContactState &state)
  {
    const SparseRows         &H      = contact.operators.H();
    std::vector<double>       forces = H.multiply(state.traction.values());
    const std::vector<double> normal = H.multiply(state.pressure);
    forces.insert(forces.end(), normal.begin(), normal.end());
    return forces;
  }



  std::vector<double>
  normal_gap(const ContactProblem &contact, const ContactState &state)
  {
    std::vector<double> u_n =
      contact.operators.normal_displacement(state.pressure);
    const std::vector<double> coupling =
      contact.operators.normal_displacement_of_traction(state.traction);
    for (unsigned int i = 0; i < contact.n_nodes(); ++i)
      u_n[i] += contact.loads.gap[i] - state.approach + coupling[i];
    return u_n;
  }
} // namespace RollingContact
