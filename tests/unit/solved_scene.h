#ifndef rolling_contact_tests_solved_scene_h
#define rolling_contact_tests_solved_scene_h

#include "scene_run.h"

#include <rolling_contact/state/estimate_errors.h>

#include <cmath>

/**
 * The steady state of a scene with a compliance of this kind, and its error.
 */
struct SolvedScene : public RollingContact::SceneInMemory
{
  using Change = std::function<void(RollingContact::SceneParameters &)>;

  SolvedScene(const RollingContact::Compliance compliance, const Change &set)
  {
    using namespace RollingContact;
    set(scene);
    scene.mesh.compliance    = compliance;
    scene.output.body_fields = false;
    scene.check();
    StateDemands demands;
    demands.pair.bulk_errors = true;
    steady = solve_steady_state<3>(situation(), demands, context);
    BOOST_TEST(steady.solver.converged);
    estimate_errors(situation(), steady);
  }

  RollingContact::SteadyState<3> steady;
};

/**
 * The forces of both, over mu N, and their peak pressures and approaches agree.
 */
inline void check_split(const SolvedScene &elements,
                        const SolvedScene &split,
                        const double       of_force,
                        const double       of_pressure)
{
  const auto &one = elements.steady.result, &other = split.steady.result;
  BOOST_TEST(!elements.steady.pair->bodies().is_split());
  BOOST_TEST(split.steady.pair->bodies().is_split());
  const double mu_N = one.friction_force;
  BOOST_TEST_MESSAGE("forces " << one.force_x << ' ' << one.force_y << ", "
                               << other.force_x << ' ' << other.force_y);
  BOOST_TEST(std::abs(one.force_x - other.force_x) < of_force * mu_N);
  BOOST_TEST(std::abs(one.force_y - other.force_y) < of_force * mu_N);
  BOOST_TEST(one.max_pressure == other.max_pressure,
             boost::test_tools::tolerance(of_pressure));
  BOOST_TEST(elements.steady.state.approach == split.steady.state.approach,
             boost::test_tools::tolerance(0.01));
}

#endif
