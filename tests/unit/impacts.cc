#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include "time_run.h"

#include <rolling_contact/base/constants.h>
#include <rolling_contact/pair/moving_surfaces.h>
#include <rolling_contact/surfaces/dent.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace RollingContact;

/** Wheels that run over flats and dips, and the axle that they move. */
BOOST_AUTO_TEST_SUITE(impacts)

namespace
{
  namespace tt = boost::test_tools;

  /** A disc on half an axle over a dip of the rail; bodies weigh little, so
   * that the axle is a mass on the spring of the contact. */
  const double axle_mass = 5000., dip_length = 0.3, dip_depth = 0.1e-3,
               position = -0.2, density = 60.;

  void set_light_bodies(SceneParameters &scene)
  {
    scene.wheel.hub_radius     = 0.15;
    scene.wheel.width          = 0.1;
    scene.wheel.lateral_radius = 0.;
    scene.wheel.hub            = Hub::mass;
    scene.wheel.model.hub_mass = {axle_mass, {{500., 50., 500.}}};
    scene.rail.shape           = "block";
    scene.rail.radius          = 0.;
    scene.rail.block_length    = 0.4;
    scene.rail.block_depth     = 0.15;
    scene.rail.width           = 0.1;
    for (BodyParameters *body : {&scene.wheel, &scene.rail})
      body->material.density = density;
    scene.contact.friction_coefficient = 0.;
    scene.modes.maximum_frequency      = 20e3;
    scene.surfaces.height.rail         = "dip : 0.3, 0.1e-3";
    scene.surfaces.position            = position;
    scene.time.inertia                 = true;
    scene.time.bodies                  = BodiesInTime::reduced;
    scene.time.initial_state           = InitialState::steady;
  }

  /** Load (N) over approach (m) of the bodies at rest: the root of order 3/2 of
   * the load by the parabola through three states. */
  class ContactSpring
  {
  public:
    ContactSpring()
    {
      for (std::size_t k = 0; k < 3; ++k)
        {
          approach[k] = (0.02 + 0.06 * k) * 1e-3;
          const SceneRun<3> run(
            [](SceneParameters &scene) {
              standard<3>(scene);
              set_light_bodies(scene);
              scene.wheel.hub = Hub::clamped;
              scene.surfaces  = {};
            },
            [&](SceneParameters &scene) {
              scene.contact.approach = approach[k];
            });
          root[k] = std::pow(run.steady.result.normal_force, 2. / 3);
        }
    }

    double operator()(const double at) const
    {
      double sum = 0.;
      for (std::size_t k = 0; k < 3; ++k)
        {
          double share = 1.;
          for (std::size_t j = 0; j < 3; ++j)
            if (j != k)
              share *= (at - approach[j]) / (approach[k] - approach[j]);
          sum += share * root[k];
        }
      return at > 0. ? std::pow(std::max(0., sum), 1.5) : 0.;
    }

  private:
    std::array<double, 3> approach, root;
  };
} // namespace

BOOST_AUTO_TEST_CASE(dents_have_their_shapes)
{
  const double R    = 0.46;
  const auto   flat = dent_named("Surfaces/Wheel height", " flat: 0.05 ");
  BOOST_REQUIRE(flat);
  BOOST_TEST(flat->height(0., R) == -0.05 * 0.05 / (8 * R),
             tt::tolerance(1e-3));
  BOOST_TEST(flat->height(0.025, R) == 0.);
  BOOST_TEST(std::abs(flat->height(-0.02499, R)) < 2e-6);
  const auto dip = dent_named("Surfaces/Rail height", "dip : 0.1, 2e-4");
  BOOST_REQUIRE(dip);
  BOOST_TEST(dip->height(0., 0.) == -2e-4, tt::tolerance(1e-12));
  BOOST_TEST(dip->height(0.025, 0.) == -1e-4, tt::tolerance(1e-12));
  BOOST_TEST(dip->height(-0.05, 0.) == 0.);
  BOOST_TEST(!dent_named("Surfaces/Rail height", "1e-6 * sin(x)"));
  BOOST_TEST(!dent_named("Surfaces/Rail height", ""));
}

/**
 * Rolling rigidly over a chord, the wheel turns about its edges: at s from its
 * middle the axle is (L/2 - |s|)^2 / (2 R) below its height on the circle.
 */
BOOST_AUTO_TEST_CASE(a_rigid_wheel_turns_about_the_edges_of_its_flat)
{
  const double R = 0.46, L = 0.05;
  const Dent   flat{Dent::Kind::flat, L};
  for (const double s : {-0.03, -0.02, -0.004, 0., 0.01, 0.024})
    {
      double gap = 1.;
      for (double x = -0.06; x <= 0.06; x += 1e-5)
        gap = std::min(gap, x * x / (2 * R) - flat.height(x - s, R));
      const double turned = std::max(0., L / 2 - std::abs(s));
      BOOST_TEST(std::abs(gap - turned * turned / (2 * R)) < 1e-6);
    }
}

/** Bodies touch on the edges of a flat, and on the slopes of a dip at R z'. */
BOOST_AUTO_TEST_CASE(zones_reach_as_far_as_dents_move_the_contact)
{
  SceneParameters scene;
  standard<3>(scene);
  set_light_bodies(scene);
  const auto reach = [&](const Side side, const std::string &height) {
    scene.surfaces.height       = {};
    scene.surfaces.height[side] = height;
    return farthest_contact_of_dents(PairSpec(scene));
  };
  BOOST_TEST(reach(Side::rail, "1e-6 * sin(x)") == 0.);
  BOOST_TEST(reach(Side::wheel, "flat : 0.04") == 0.02, tt::tolerance(0.02));
  BOOST_TEST(reach(Side::wheel, "dip : 0.05, 1e-4") == 0.46 * pi * 1e-4 / 0.05,
             tt::tolerance(0.1));
}

BOOST_AUTO_TEST_CASE(dents_that_are_none_are_refused)
{
  for (const std::string text : {"flat",
                                 "flat :",
                                 "flat : 0",
                                 "flat : -1",
                                 "flat : 0.1, 2",
                                 "flat : long",
                                 "flat : inf"})
    BOOST_TEST(
      contains(complaint([&]() { dent_named("Here/Height", text); }),
               "Here/Height = " + text + ": give the length of the flat in m"));
  for (const std::string text : {"dip",
                                 "dip : 0.1",
                                 "dip : 0.1, 0",
                                 "dip : 0.1, 1e-4, 3",
                                 "dip : 0.1; 1e-4"})
    BOOST_TEST(contains(complaint([&]() { dent_named("Here/Height", text); }),
                        "Here/Height = " + text +
                          ": give length and depth of the dip in m"));
}

/**
 * The axle of bodies that weigh little is a mass on the spring of the contact,
 *   m q'' = N_0 - N(approach + q + height under the wheel),
 * here by Runge and Kutta's method; what it goes through is the impulse of the
 * contact.
 */
BOOST_AUTO_TEST_CASE(an_axle_is_a_mass_on_the_spring_of_the_contact)
{
  const ContactSpring spring;
  const double        rest = 0.07e-3,
               wheel_mass  = density * pi * (0.46 * 0.46 - 0.15 * 0.15) * 0.1,
               m           = axle_mass + wheel_mass;
  for (const double V : {5., 15., 40.})
    {
      const double h = std::min(1e-4, 1e-3 / V);
      const auto   n = static_cast<unsigned int>(std::ceil(0.6 / (V * h)));
      TimeRun<3>   run([&](SceneParameters &scene) {
        set_light_bodies(scene);
        scene.wheel.velocity_points = "rim: 0.45, 0, 0";
        scene.mesh.candidate_zone   = 2.;
        scene.contact.speed         = V;
        scene.time.time_step        = h;
        scene.time.end_time         = n * h;
      });
      const double at_rest = run.stepper->current().problem.operators.resultant(
        run.stepper->current().state.pressure);
      BOOST_TEST(at_rest == spring(rest), tt::tolerance(2e-3));
      double largest = 0., least = at_rest, impulse = 0., fastest = 0.,
             off = 0., of_rim = 0.;
      for (unsigned int k = 0; k < n; ++k)
        {
          run.march(1);
          const double load = run.stepper->current().result.normal_force,
                       v    = *run.last.wheel_velocity;
          largest           = std::max(largest, load);
          least             = std::min(least, load);
          impulse += (load - at_rest) * h;
          fastest = std::max(fastest, std::abs(v));
          off     = std::max(off, std::abs(v - impulse / m));
          for (const double rate : run.last.point_velocity)
            of_rim = std::max(of_rim, std::abs(rate));
        }
      BOOST_TEST(off < 2e-3 * fastest);
      BOOST_TEST(of_rim < 0.05 * fastest); // relative to the axle

      const Dent   dip{Dent::Kind::dip, dip_length, dip_depth};
      double       q = 0., v = 0., highest = 0., lowest = spring(rest);
      const double dt   = 1e-6 * 10 / V;
      const auto   rate = [&](const double t, const double at) {
        const double load =
          spring(rest + at + dip.height(-V * t - position, 0.));
        highest = std::max(highest, load);
        lowest  = std::min(lowest, load);
        return (spring(rest) - load) / m;
      };
      for (double t = 0.; t < n * h; t += dt)
        {
          const double a1 = rate(t, q), a2 = rate(t + dt / 2, q + dt / 2 * v),
                       a3 = rate(t + dt / 2, q + dt / 2 * v + dt * dt / 4 * a1),
                       a4 = rate(t + dt, q + dt * v + dt * dt / 2 * a2);
          q += dt * v + dt * dt / 6 * (a1 + a2 + a3);
          v += dt / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
        }
      BOOST_TEST_MESSAGE(V << " m/s: largest load " << largest << " of "
                           << highest << " N, least " << least << " of "
                           << lowest << " N");
      BOOST_TEST(highest > 1.02 * at_rest);
      BOOST_TEST(largest == highest, tt::tolerance(0.01));
      BOOST_TEST(std::abs(least - lowest) < 0.01 * at_rest);
    }
}

/**
 * What the contact gives wheel and axle changes the velocity of their centre of
 * mass, however the wheel vibrates on the axle.
 */
BOOST_AUTO_TEST_CASE(wheel_and_axle_have_the_impulse_of_the_contact)
{
  const double V = 40., h = 1e-5, steel = 7800.;
  TimeRun<3>   run([&](SceneParameters &scene) {
    set_light_bodies(scene);
    for (BodyParameters *body : {&scene.wheel, &scene.rail})
      body->material.density = steel;
    scene.wheel.model.hub_mass    = {50., {{5., 1., 5.}}};
    scene.modes.maximum_frequency = 3000.;
    scene.surfaces.height.rail    = "dip : 0.1, 0.05e-3";
    scene.surfaces.position       = -0.06;
    scene.mesh.candidate_zone     = 2.;
    scene.contact.speed           = V;
    scene.time.time_step          = h;
    scene.time.end_time           = 300 * h;
  });
  const double at_rest = run.stepper->current().problem.operators.resultant(
                 run.stepper->current().state.pressure),
               m = 50. + steel * pi * (0.46 * 0.46 - 0.15 * 0.15) * 0.1;
  double impulse = 0., fastest = 0., off = 0.;
  for (unsigned int k = 0; k < 300; ++k)
    {
      run.march(1);
      impulse += (run.stepper->current().result.normal_force - at_rest) * h;
      fastest = std::max(fastest, std::abs(*run.last.wheel_velocity));
      off     = std::max(off, std::abs(*run.last.wheel_velocity - impulse / m));
    }
  BOOST_TEST_MESSAGE("velocity off by " << off << " of " << fastest << " m/s");
  // the mesh of the wheel weighs 2 % less
  BOOST_TEST(off < 0.03 * fastest);
}

BOOST_AUTO_TEST_SUITE_END()
