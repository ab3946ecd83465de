#ifndef rolling_contact_tests_scene_run_h
#define rolling_contact_tests_scene_run_h

#include <boost/test/unit_test.hpp>

#include <rolling_contact/scene/situation.h>
#include <rolling_contact/state/state_finder.h>

#include <deque>
#include <functional>
#include <sstream>

namespace RollingContact
{
  /**
   * A scene and what a run of it needs, in memory: nothing is written, what is
   * said is kept.
   */
  struct SceneInMemory
  {
    SceneInMemory()
      : folder("never_opened", "", "")
      , results(folder)
      , log(Verbosity::normal, said, said)
      , context{folder, results, report, timer, log}
    {}

    /**
     * What follows from the scene as it is now; lives as long as this.
     */
    const Situation &situation() const
    {
      return situations.emplace_back(scene);
    }

    std::ostringstream said;
    RunFolder          folder;
    ResultsTable       results;
    RunReport          report;
    PhaseTimer         timer;
    Log                log;
    RunContext         context;
    SceneParameters    scene;

  private:
    mutable std::deque<Situation> situations;
  };

  /**
   * A steady state solved in memory. The state must converge.
   */
  template <int dim>
  struct SceneRun : public SceneInMemory
  {
    using Change = std::function<void(SceneParameters &)>;

    SceneRun(const Change &standard, const Change &change)
    {
      standard(scene);
      change(scene);
      scene.check();
      StateDemands demands;
      demands.pair.displacements = scene.output.body_fields;
      steady = solve_steady_state<dim>(situation(), demands, context);
      BOOST_TEST(steady.solver.converged);
    }

    double friction_force() const
    {
      return scene.contact.friction_coefficient * steady.result.normal_force;
    }

    double force_x() const
    {
      return steady.result.force_x / friction_force();
    }

    double force_y() const
    {
      return steady.result.force_y / friction_force();
    }

    SteadyState<dim> steady;
  };

  /** Bodies as wide as this, m. */
  inline SceneRun<3>::Change widths(const double wheel, const double rail)
  {
    return [=](SceneParameters &scene) {
      scene.wheel.width = wheel;
      scene.rail.width  = rail;
    };
  }
} // namespace RollingContact

#endif
