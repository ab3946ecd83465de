#include "complaint.h"
#include "scene_run.h"
#include "wheel_on_block.h"

#include <rolling_contact/state/estimate_errors.h>
#include <rolling_contact/tables/kept_bodies.h>
#include <rolling_contact/tables/session.h>

#include <cmath>
#include <thread>

using namespace RollingContact;

/** Bodies that are kept from state to state. */
BOOST_AUTO_TEST_SUITE(sessions)

namespace
{
  void coarse_3d(SceneParameters &scene)
  {
    scene.dimension                  = 3;
    scene.mesh.elements_across_patch = 8;
    scene.mesh.growth                = 0.8;
    scene.wheel.lateral_radius       = 0.3;
    scene.rail.lateral_radius        = 0.3;
    scene.contact.normal_load        = 36e3;
  }

  Situation coarse_scene()
  {
    SceneParameters scene;
    coarse_3d(scene);
    return Situation(scene);
  }
} // namespace

namespace
{
  /** S1002 on 60E1 over a disc and a block. */
  SceneParameters profile_scene()
  {
    SceneParameters scene        = wheel_on_block(8);
    scene.profiles.wheel_profile = "S1002";
    scene.profiles.rail_profile  = "60E1";
    scene.profiles.shift         = 0.003;
    scene.profiles.creepage_source =
      ProfileParameters::CreepageSource::kinematics;
    scene.contact.normal_load = 16e3;
    scene.contact.speed       = 20.;
    return scene;
  }
} // namespace

/** How fast the axle turns is a creepage, not another place. */
BOOST_AUTO_TEST_CASE(an_axle_that_turns_faster_keeps_its_bodies)
{
  SceneParameters scene = profile_scene();
  Session         session{Situation(scene)};
  const double    rolling = -20. / scene.wheel.radius;
  session.set("Profiles/Pitch rate", rolling);
  const double before = session.solve().forces.force_x;
  session.set("Profiles/Pitch rate", 1.001 * rolling);
  const SessionState found = session.solve();
  BOOST_TEST(found.converged);
  BOOST_TEST(session.n_bodies_made() == 1u);
  scene.profiles.pitch_rate = 1.001 * rolling;
  const double expected     = Session{Situation(scene)}.solve().forces.force_x;
  BOOST_TEST(std::abs(expected - before) > 500.);
  BOOST_TEST(found.forces.force_x == expected,
             boost::test_tools::tolerance(1e-5));
}

/**
 * A state on bodies that were made for another place is that of bodies of the
 * same mesh that are made there: gap, slip, frames and loads are all of the new
 * place, in the state and in its error.
 */
BOOST_AUTO_TEST_CASE(profiles_touch_elsewhere_on_the_same_bodies)
{
  for (const Profiles::SurfaceKind kind :
       {Profiles::SurfaceKind::plane, Profiles::SurfaceKind::curved})
    for (const Compliance compliance :
         {Compliance::finite_elements, Compliance::split})
      {
        SceneParameters scene       = profile_scene();
        scene.profiles.surface_kind = kind;
        scene.mesh.compliance       = compliance;
        scene.mesh.candidate_zone   = 1.3;
        SceneInMemory   run;
        const Situation here(scene);
        SteadyState<3>  kept =
          solve_steady_state<3>(here, demands_of_kept_bodies(), run.context);
        estimate_errors(here, kept);
        const double before  = kept.result.force_y;
        scene.profiles.shift = 0.0034;
        scene.profiles.yaw   = 0.003;
        scene.contact.normal_load.reset();
        scene.contact.vertical_load = 15e3;
        const Situation there(scene);
        solve_on_kept_bodies(there, kept);
        estimate_errors(there, kept);
        BOOST_TEST(kept.solver.converged);
        SteadyState<3> made =
          StateFinder<3>(there, demands_of_kept_bodies(), run.context)
            .solve_on(kept.grading, [&](const ContactProblem &problem) {
              return initial_state(problem, estimate_patch(there));
            });
        estimate_errors(there, made);
        BOOST_TEST(std::abs(before - made.result.force_y) > 100.);
        const auto same = [](const double one, const double other) {
          BOOST_TEST(one == other, boost::test_tools::tolerance(1e-5));
        };
        same(kept.result.force_x, made.result.force_x);
        same(kept.result.force_y, made.result.force_y);
        same(kept.result.spin_moment, made.result.spin_moment);
        same(kept.result.normal_force, made.result.normal_force);
        same(kept.result.max_pressure, made.result.max_pressure);
        same(kept.state.approach, made.state.approach);
        BOOST_TEST(kept.problem.loads.gap == made.problem.loads.gap,
                   boost::test_tools::per_element());
        const HalvedProblem &half   = kept.halves.at(1);
        const SurfaceFrames &frames = half.problem.operators.frames(),
                            &whole  = kept.problem.operators.frames();
        BOOST_TEST(frames.is_plane() == (kind == Profiles::SurfaceKind::plane));
        for (std::size_t k = 0; k < frames.nodes.size(); ++k)
          BOOST_TEST(frames.nodes[k].angle == whole.nodes[half.nodes[k]].angle);
        BOOST_TEST(kept.estimate->across.force == made.estimate->across.force,
                   boost::test_tools::tolerance(1e-3));
        BOOST_TEST(kept.estimate->bulk->force == made.estimate->bulk->force,
                   boost::test_tools::tolerance(0.05));
      }
}

/** Bodies are made where none reach, and then reach both places. */
BOOST_AUTO_TEST_CASE(a_wheelset_that_moves_keeps_its_bodies)
{
  const SceneParameters scene = profile_scene();
  Session               session{Situation(scene)};
  const auto            moved = [&](const double shift) {
    session.set("Profiles/Lateral shift", shift);
    const SessionState found = session.solve();
    BOOST_TEST(found.converged);
    SceneParameters alone       = scene;
    alone.profiles.shift        = shift;
    const SessionState expected = Session{Situation(alone)}.solve();
    const double       mu_N     = 0.3 * 16e3;
    BOOST_TEST(std::abs(found.forces.force_y - expected.forces.force_y) <
               0.01 * mu_N);
    BOOST_TEST(std::abs(found.forces.spin_moment -
                        expected.forces.spin_moment) < 0.01 * mu_N * 3e-3);
    return found;
  };
  moved(0.003);
  for (const double shift : {0.0031, 0.0032, 0.0033, 0.0029})
    BOOST_TEST(moved(shift).new_bodies == "");
  const unsigned int n_made = session.n_bodies_made();
  BOOST_TEST(n_made == 1u);
  session.set("Profiles/Yaw", 0.004);
  BOOST_TEST(session.solve().new_bodies == "");
  // sections that follow their profiles are other bodies elsewhere
  SceneParameters followed        = scene;
  followed.profiles.true_sections = true;
  BOOST_TEST(Situation(followed).follows_profiles());
  BOOST_TEST(!Situation(scene).follows_profiles());
}

BOOST_AUTO_TEST_CASE(states_are_those_of_runs_of_their_own)
{
  Session session(coarse_scene());
  session.set("Contact/Creepage y", 0.001);
  session.solve();
  const SceneRun<3> first(coarse_3d, [](SceneParameters &scene) {
    scene.contact.creepages.y = 0.001;
  });
  SessionState      found = session.solve();
  BOOST_TEST(found.converged);
  BOOST_TEST(found.new_bodies == "");
  BOOST_TEST(found.forces.force_y == first.steady.result.force_y,
             boost::test_tools::tolerance(1e-9));

  // another load, friction, creepages and spin on the same mesh
  session.set("Contact/Normal load", 33e3);
  session.set("Contact/Friction coefficient", "0.4");
  session.set("Contact/Creepage x", -0.002);
  session.set("Contact/Spin", 0.5);
  found = session.solve();
  BOOST_TEST(found.converged);
  BOOST_TEST(session.n_bodies_made() == 1u);
  SteadyState<3>  direct             = first.steady;
  SceneParameters scene              = first.scene;
  scene.contact.normal_load          = 33e3;
  scene.contact.friction_coefficient = 0.4;
  scene.contact.creepages            = {-0.002, 0.001, 0.5};
  direct.problem                     = first.steady.pair->contact_problem(
    scene.contact, first.steady.problem.operators.W().dense());
  direct.state =
    initial_state(direct.problem, estimate_patch(Situation(scene)));
  solve_contact(Situation(scene), StateDemands(), direct);
  const Resultants expected = resultants(direct.problem, direct.state);
  // edges settle to 1e-6
  BOOST_TEST(found.forces.force_x == expected.force_x,
             boost::test_tools::tolerance(1e-6));
  BOOST_TEST(found.forces.force_y == expected.force_y,
             boost::test_tools::tolerance(1e-6));
  BOOST_TEST(found.forces.spin_moment == expected.spin_moment,
             boost::test_tools::tolerance(1e-5));
  BOOST_TEST(found.forces.normal_force == 33e3,
             boost::test_tools::tolerance(1e-9));
  BOOST_TEST(*found.bounds.force > 0.);
  BOOST_TEST(session.problem().n_nodes() == session.state().pressure.size());

  // and so on with what they had, bodies and all
  session.set("Contact/Normal load", 36e3);
  session.set("Contact/Friction coefficient", 0.3);
  session.set("Contact/Creepage x", 0.);
  session.set("Contact/Spin", 0.);
  BOOST_TEST(session.solve().forces.force_y == first.steady.result.force_y,
             boost::test_tools::tolerance(1e-6));
  BOOST_TEST(session.n_bodies_made() == 1u);
}

BOOST_AUTO_TEST_CASE(what_bodies_do_not_serve_for)
{
  Session session(coarse_scene());
  session.solve();
  const double force = session.solve().forces.normal_force;
  session.set("Contact/Normal load", 80e3); // 1.3 times the patch
  BOOST_TEST(contains(session.solve().new_bodies, "half-width"));
  BOOST_TEST(session.n_bodies_made() == 2u);
  session.set("Contact/Normal load", 36e3); // kept
  BOOST_TEST(session.solve().new_bodies == "");
  BOOST_TEST(session.solve().forces.normal_force == force,
             boost::test_tools::tolerance(1e-9));
  session.set("Rail/Young modulus", 100e9);
  BOOST_TEST(contains(session.solve().new_bodies, "Rail/Young modulus"));
  session.set("Contact/Speed", -1.);
  BOOST_TEST(contains(session.solve().new_bodies, "flow -x"));
  session.set("Contact/Friction coefficient", 0.);
  BOOST_TEST(contains(session.solve().new_bodies, "without friction"));
  BOOST_TEST(session.solve().forces.tangential_force == 0.);
  BOOST_TEST(session.n_bodies_made() == 5u);
  session.set("Contact/Normal load", 0.);
  const SessionState &open = session.solve();
  BOOST_TEST(!open.touches);
  BOOST_TEST(open.converged);
  BOOST_TEST(open.forces.normal_force == 0.);
  BOOST_CHECK_THROW(session.problem(), std::logic_error);
}

BOOST_AUTO_TEST_CASE(what_a_session_refuses)
{
  Session    session(coarse_scene());
  const auto said = [&](const std::string &entry, const std::string &value) {
    return complaint([&]() { session.set(entry, value); });
  };
  BOOST_TEST(contains(said("Contact/Creepage z", "0"), "there is no entry"));
  BOOST_TEST(contains(said("Contact/Creepage x", "0,1"), "Creepage x = 0,1"));
  BOOST_TEST(contains(said("Contact/Normal load", "heavy"), "heavy"));
  BOOST_TEST(contains(said("Dimension", "2"), "keeps its dimension"));
  BOOST_TEST(session.solve().forces.normal_force == 36e3,
             boost::test_tools::tolerance(1e-9));
  session.set("Contact/Normal load", -1.);
  BOOST_TEST(contains(complaint([&]() { session.solve(); }), "cannot pull"));
  session.set("Contact/Normal load", 36e3);
  BOOST_TEST(session.solve().converged);
  BOOST_TEST(session.n_bodies_made() == 1u);
  SceneParameters target   = *coarse_scene().inputs;
  target.mesh.target_error = 1e-2;
  BOOST_TEST(contains(complaint([&]() { Session refused{Situation(target)}; }),
                      "Mesh/Target error"));
}

BOOST_AUTO_TEST_CASE(sessions_do_not_know_of_each_other)
{
  const auto march = [](const double sign, std::vector<double> &forces) {
    Session session(coarse_scene());
    for (unsigned int k = 0; k < 6; ++k)
      {
        session.set("Contact/Creepage x", sign * 0.001 * k);
        session.set("Contact/Spin", 0.1 * k);
        forces.push_back(session.solve().forces.force_x);
        forces.push_back(session.solve().forces.force_y);
      }
  };
  std::vector<double> alone, other_alone, together, other;
  march(1., alone);
  march(-1., other_alone);
  std::thread thread([&]() { march(-1., other); });
  march(1., together);
  thread.join();
  BOOST_TEST(alone == together, boost::test_tools::per_element());
  BOOST_TEST(other_alone == other, boost::test_tools::per_element());
  BOOST_TEST(std::abs(alone.back() - other_alone.back()) < 1e-6 * 36e3);
  BOOST_TEST(std::abs(alone[2] + other_alone[2]) < 1e-2 * std::abs(alone[2]));
}

BOOST_AUTO_TEST_SUITE_END()
