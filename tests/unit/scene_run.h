#ifndef rolling_contact_tests_scene_run_h
#define rolling_contact_tests_scene_run_h

#include <boost/test/unit_test.hpp>

#include <rolling_contact/analyses/steady_state.h>

#include <functional>
#include <sstream>

namespace RollingContact
{
  /**
   * A steady state solved in memory: nothing is written, what is said is kept.
   * The state must converge.
   */
  template <int dim>
  struct SceneRun
  {
    using Change = std::function<void(SceneParameters &)>;

    SceneRun(const Change &standard, const Change &change)
      : folder("never_opened", "", "")
      , results(folder)
      , log(Verbosity::normal, said, said)
    {
      standard(scene);
      change(scene);
      scene.check();
      RunContext context{folder, results, report, timer, log};
      steady = solve_steady_state<dim>(scene, context);
      BOOST_TEST(steady.solver.converged);
    }

    double
    friction_force() const
    {
      return scene.contact.friction_coefficient * steady.result.normal_force;
    }

    double
    force_x() const
    {
      return steady.result.force_x / friction_force();
    }

    double
    force_y() const
    {
      return steady.result.force_y / friction_force();
    }

    std::ostringstream said;
    RunFolder          folder;
    ResultsTable       results;
    RunReport          report;
    PhaseTimer         timer;
    Log                log;
    SceneParameters    scene;
    SteadyState<dim>   steady;
  };
} // namespace RollingContact

#endif
