#ifndef rolling_contact_analyses_study_state_h
#define rolling_contact_analyses_study_state_h

#include <rolling_contact/results/state_errors.h>
#include <rolling_contact/scene/pair_spec.h>
#include <rolling_contact/scene/study_parameters.h>

#include <array>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * A way to solve a state.
   */
  struct StudyMethod
  {
    std::string mesh;
    std::string slip_operator;
    std::string solver;

    /**
     * Name of the method as "upwind 2, graded": the operator, and mesh and
     * solver where they are not those of the standard.
     */
    std::string name(const StudyMethod &standard) const;
  };

  /**
   * The methods that the scene asks for, ordered by mesh.
   */
  std::vector<StudyMethod> study_methods(const StudyParameters &study);

  /**
   * CPU seconds of a state; the set-up is what it would need alone.
   */
  struct StateSeconds
  {
    double mesh = 0., factorisation = 0., contact = 0.;

    double total() const
    {
      return mesh + factorisation + contact;
    }

    void add(const double share, const StateSeconds &other)
    {
      mesh += share * other.mesh;
      factorisation += share * other.factorisation;
      contact += share * other.contact;
    }
  };

  /**
   * What the phases of a timer have taken so far; the phases that are not of
   * factorisation and contact count as mesh.
   */
  StateSeconds state_seconds(const PhaseTimer &timer);

  StateSeconds operator-(const StateSeconds &after, const StateSeconds &before);

  /**
   * What is kept of one state. Forces over mu N, mu_s N if friction falls.
   */
  struct StudySample
  {
    bool                  converged = false;
    double                residual  = 0.;
    std::array<double, 2> force{};
    double                load = 0.; ///< N, or the approach in m if N is given
    StateErrors           errors;
    StateSeconds          seconds;
    std::size_t           n_unknowns      = 0;
    std::size_t           n_contact_nodes = 0;
    std::size_t           peak_memory     = 0; ///< of the mesh; 0 if unknown
  };

  /**
   * Forces, errors and sizes of a solved state; see state_errors() for
   * @p finest.
   */
  template <int dim>
  StudySample study_sample(const PairSpec         &scene,
                           const SteadyState<dim> &steady,
                           const TractionField    *finest);
} // namespace RollingContact

#endif
