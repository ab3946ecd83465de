#include <rolling_contact/analyses/study_state.h>

namespace RollingContact
{
  std::string StudyMethod::name(const StudyMethod &standard) const
  {
    std::string text = slip_operator;
    for (const auto part : {&StudyMethod::mesh, &StudyMethod::solver})
      if (this->*part != standard.*part)
        text += ", " + this->*part;
    return text;
  }

  std::vector<StudyMethod> study_methods(const StudyParameters &study)
  {
    std::vector<StudyMethod> methods;
    for (std::size_t m = 0; m < study.meshes.size(); ++m)
      for (std::size_t o = 0; o < study.slip_operators.size(); ++o)
        for (std::size_t s = 0; s < study.solvers.size(); ++s)
          if (study.combines_all || (m > 0) + (o > 0) + (s > 0) <= 1)
            methods.push_back(
              {study.meshes[m], study.slip_operators[o], study.solvers[s]});
    return methods;
  }

  StateSeconds state_seconds(const PhaseTimer &timer)
  {
    StateSeconds seconds;
    for (const PhaseTimer::Row &row : timer.rows())
      (row.phase == Phase::condensation    ? seconds.factorisation
       : row.phase == Phase::contact_solve ? seconds.contact
                                           : seconds.mesh) += row.cpu_seconds;
    return seconds;
  }

  StateSeconds operator-(const StateSeconds &after, const StateSeconds &before)
  {
    return {after.mesh - before.mesh,
            after.factorisation - before.factorisation,
            after.contact - before.contact};
  }

  template <int dim>
  StudySample study_sample(const PairSpec         &scene,
                           const SteadyState<dim> &steady,
                           const TractionField    *finest)
  {
    const Resultants &result = steady.result;
    StudySample       sample;
    sample.converged = steady.solver.converged && result.normal_force > 0.;
    sample.residual  = steady.solver.residual.worst();
    if (sample.converged)
      {
        sample.load   = scene.contact.normal_load ? steady.state.approach
                                                  : result.normal_force;
        sample.errors = state_errors(scene, steady, finest);
      }
    if (sample.converged && result.friction_force > 0.)
      sample.force = {{result.force_x / result.friction_force,
                       result.force_y / result.friction_force}};
    sample.n_unknowns      = steady.pair->bodies().n_unknowns();
    sample.n_contact_nodes = steady.problem.n_nodes();
    return sample;
  }

  template StudySample
  study_sample(const PairSpec &, const SteadyState<2> &, const TractionField *);
  template StudySample
  study_sample(const PairSpec &, const SteadyState<3> &, const TractionField *);
} // namespace RollingContact
