#ifndef rolling_contact_analyses_accuracy_study_h
#define rolling_contact_analyses_accuracy_study_h

#include <rolling_contact/analyses/steady_state.h>

#include <map>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * Analysis = accuracy study: the force of one scene on several meshes, at
   * several positions of each under the patch, for several creepages and slip
   * operators, against the converged solution of the same bodies. One row per
   * state in results.csv, largest and mean errors with their order in
   * summary.csv, and a plot. 2D.
   */
  class AccuracyStudy
  {
  public:
    AccuracyStudy(const SceneParameters &scene, RunContext &context)
      : scene(scene)
      , context(context)
    {}

    void
    run();

  private:
    /**
     * All states of one method on one mesh and creepage.
     */
    struct Key
    {
      std::string  slip_operator;
      double       creepage; ///< over saturation
      unsigned int elements;

      bool
      operator<(const Key &other) const;
    };

    struct Sample
    {
      double force          = 0.; ///< T / (mu N)
      double traction_l2    = 0.;
      double pressure_l2    = 0.;
      double sawtooth       = 0.;
      double stick_boundary = 0.; ///< elements
      double normal_force   = 0.; ///< relative error
    };

    void
    solve_mesh(const unsigned int              elements,
               const std::vector<std::string> &slip_operators);

    void
    solve_states(SteadyState<2>                 &steady,
                 const unsigned int              elements,
                 const std::vector<std::string> &slip_operators);

    void
    add_row(const Key &key, const SteadyState<2> &steady, const Sample &sample);

    double
    reference_force(const double creepage) const;

    void
    summarise();

    void
    plot(const std::map<Key, double> &largest) const;

    const SceneParameters             &scene;
    RunContext                        &context;
    PatchEstimate                      patch;
    double                             saturation = 0.;
    std::map<Key, std::vector<Sample>> samples;
  };
} // namespace RollingContact

#endif
