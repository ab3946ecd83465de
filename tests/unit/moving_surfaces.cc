#include <boost/math/special_functions/bessel.hpp>
#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include "scratch_folder.h"
#include "time_run.h"

#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/text.h>

#include <cmath>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(moving_surfaces)

namespace
{
  using Change = std::function<void(SceneParameters &)>;

  std::string wave(const double amplitude, const double wavelength)
  {
    return scientific(amplitude, 16) + "*cos(2*pi*x/" +
           scientific(wavelength, 16) + ")";
  }

  void frictionless(SceneParameters &scene)
  {
    scene.contact.friction_coefficient = 0.;
    scene.time.initial_state           = InitialState::steady;
  }

  /**
   * The load after each of @p n steps of @p rolled metres.
   */
  template <int dim>
  std::vector<double>
  loads(const Change &change, const unsigned int n, const double rolled)
  {
    TimeRun<dim>        run([&](SceneParameters &scene) {
      frictionless(scene);
      change(scene);
      scene.time.time_step = rolled / std::abs(*scene.contact.speed);
      scene.time.end_time  = (n + 1) * scene.time.time_step;
    });
    std::vector<double> found;
    for (unsigned int k = 0; k < n; ++k)
      {
        run.march(1);
        found.push_back(run.stepper->current().result.normal_force);
      }
    return found;
  }

  struct Patch
  {
    double half_width, load, stiffness;
  };

  /** Of smooth bodies; the stiffness from a small change of the approach. */
  template <int dim>
  Patch patch_of(const Change &change)
  {
    const double        by = 1e-9;
    Patch               patch{};
    const SceneRun<dim> run(standard<dim>, [&](SceneParameters &scene) {
      frictionless(scene);
      change(scene);
    });
    patch.half_width = run.steady.result.half_width_x;
    const auto moved = [&](const double step) {
      return loads<dim>(
        [&](SceneParameters &scene) {
          change(scene);
          // the same mesh
          scene.time.approach = scientific(*scene.contact.approach + step, 16);
        },
        1,
        1e-4)[0];
    };
    patch.load      = moved(0.);
    patch.stiffness = (moved(by) - moved(-by)) / (2 * by);
    return patch;
  }

  /**
   * Amplitude of the load over the amplitude of the surface, of the waves in
   * phase with the wave at the origin, over the stiffness: the contact filter.
   */
  template <int dim>
  double
  filter(const Change &change, const Patch &patch, const double wavelength)
  {
    const unsigned int n         = 8;
    const double       amplitude = 1e-9;
    const auto         found     = loads<dim>(
      [&](SceneParameters &scene) {
        change(scene);
        scene.surfaces.height.rail = wave(amplitude, wavelength);
      },
      n,
      wavelength / n);
    double in_phase = 0.;
    for (unsigned int k = 0; k < n; ++k)
      in_phase +=
        2. / n * (found[k] - patch.load) * std::cos(2 * pi * (k + 1) / n);
    return in_phase / (amplitude * patch.stiffness);
  }

  void fine(SceneParameters &scene)
  {
    scene.mesh.elements_across_patch = 128; // its ends are known to half of one
    // a disc that closes with any wave
    scene.rail.shape        = "block";
    scene.rail.radius       = 0.;
    scene.rail.block_length = 0.2;
    scene.rail.block_depth  = 0.1;
  }
} // namespace

/**
 * Waves much longer than the patch lift the load by the static stiffness times
 * their height; over the patch of 2a the response is that of the pressure of a
 * flat punch, J0(ka): line contact under waves so small that the patch stays.
 */
BOOST_AUTO_TEST_CASE(line_contact_filters_by_the_bessel_function)
{
  const Patch  patch     = patch_of<2>(fine);
  const double a         = patch.half_width;
  const double long_wave = filter<2>(fine, patch, 200 * a);
  BOOST_TEST_MESSAGE("wavelength 200 a: " << long_wave);
  BOOST_TEST(long_wave == 1., boost::test_tools::tolerance(5e-4));
  for (const double over_a : {8., 4., 2., 1.})
    {
      const double exact = boost::math::cyl_bessel_j(0, 2 * pi / over_a),
                   found = filter<2>(fine, patch, over_a * a);
      BOOST_TEST_MESSAGE("wavelength " << over_a << " a: " << found << ", J0 "
                                       << exact);
      BOOST_TEST(std::abs(found - exact) < 0.01);
    }
}

/**
 * On a round patch it is sin(ka)/(ka), the transform of the pressure of a round
 * flat punch.
 */
BOOST_AUTO_TEST_CASE(round_contact_filters_by_its_punch)
{
  const Change round = [](SceneParameters &scene) {
    scene.mesh.elements_across_patch = 16;
    scene.mesh.growth                = 0.8;
    scene.wheel.lateral_radius = scene.rail.lateral_radius = 0.46;
  };
  const Patch  patch = patch_of<3>(round);
  const double a     = patch.half_width;
  for (const double over_a : {8., 4., 2.5, 2.})
    {
      const double k     = 2 * pi / over_a;
      const double exact = std::sin(k) / k,
                   found = filter<3>(round, patch, over_a * a);
      BOOST_TEST_MESSAGE("wavelength " << over_a << " a: " << found
                                       << ", sin(ka)/(ka) " << exact);
      BOOST_TEST(std::abs(found - exact) < (over_a > 2. ? 0.006 : 0.015));
    }
}

/**
 * A pattern that lies one element further upstream comes one step later, if a
 * step rolls an element, in both directions of flow.
 */
BOOST_AUTO_TEST_CASE(a_shift_by_an_element_is_a_step)
{
  for (const double flow : {1., -1.})
    {
      const TimeRun<2> mesh([](SceneParameters &) {});
      const double     element = mesh.stepper->current().grading.element_size_x;
      const auto       history = [&](const double shift) {
        return loads<2>(
          [&](SceneParameters &scene) {
            scene.contact.speed = 10. * flow;
            scene.surfaces.height.rail =
              "20e-6*exp(-((x+" + scientific(flow * (0.004 + shift), 16) +
              ")/4e-3)^2)*(1+(x+" + scientific(flow * shift, 16) + ")/0.02)";
            scene.surfaces.height.wheel = wave(3e-6, 2 * pi * 0.46 / 400);
            if (shift > 0.) // the wheel's comes as before
              scene.surfaces.height.wheel =
                "3e-6*cos(400*(x+" + scientific(flow * shift, 16) + ")/0.46)";
          },
          30,
          element);
      };
      const auto first = history(0.), second = history(element);
      double     most = 0., least = 1e9;
      for (std::size_t k = 0; k + 1 < first.size(); ++k)
        {
          BOOST_TEST(first[k] == second[k + 1],
                     boost::test_tools::tolerance(1e-9));
          most  = std::max(most, first[k]);
          least = std::min(least, first[k]);
        }
      BOOST_TEST(most > 1.05 * least);
    }
}

/** With friction and a given load as well, once the start is forgotten. */
BOOST_AUTO_TEST_CASE(the_shift_holds_with_friction_under_a_load)
{
  const TimeRun<2> mesh([](SceneParameters &) {});
  const double     element = mesh.stepper->current().grading.element_size_x;
  const auto       history = [&](const double position) {
    TimeRun<2> run([&](SceneParameters &scene) {
      scene.contact.approach.reset();
      scene.contact.normal_load   = 90e3;
      scene.contact.creepages.x   = 0.001;
      scene.wheel.hub_radius      = 0.42;
      scene.rail.hub_radius       = 0.42;
      scene.time.initial_state    = InitialState::steady;
      scene.time.time_step        = element / 10.;
      scene.surfaces.position     = position;
      scene.surfaces.height.wheel = wave(5e-6, 2 * pi * 0.46 / 300);
    });
    auto       forces = run.march(120);
    forces.push_back(run.stepper->current().state.approach);
    forces.push_back(run.stepper->current().result.normal_force);
    return forces;
  };
  const auto first = history(element), second = history(0.);
  for (std::size_t k = 90; k + 1 < 120; ++k)
    BOOST_TEST(std::abs(first[k] - second[k + 1]) < 1e-5);
  BOOST_TEST(first.back() == 90e3, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(*std::max_element(first.begin() + 90, first.begin() + 120) -
               *std::min_element(first.begin() + 90, first.begin() + 120) >
             1e-3);
}

/** A snapshot is a state with the roughness that lies there. */
BOOST_AUTO_TEST_CASE(snapshots_are_states_with_that_roughness)
{
  for (const double flow : {1., -1.})
    {
      const auto state = [&](const Change &change) {
        return SceneRun<2>(standard<2>,
                           [&](SceneParameters &scene) {
                             scene.contact.speed       = 10. * flow;
                             scene.contact.creepages.x = 0.001;
                             change(scene);
                           })
          .steady.result;
      };
      const Resultants moving = state([&](SceneParameters &scene) {
        scene.surfaces.height.rail = "3e-6*sin(2*pi*x/0.03)";
        scene.surfaces.position    = 0.003;
      });
      const Resultants fixed  = state([&](SceneParameters &scene) {
        scene.contact.roughness =
          "-3e-6*sin(2*pi*(x-" + scientific(flow * 0.003, 16) + ")/0.03)";
      });
      const Resultants smooth = state([](SceneParameters &) {});
      BOOST_TEST(moving.normal_force == fixed.normal_force,
                 boost::test_tools::tolerance(1e-9));
      BOOST_TEST(moving.force_x == fixed.force_x,
                 boost::test_tools::tolerance(1e-7));
      BOOST_TEST(std::abs(moving.normal_force / smooth.normal_force - 1) >
                 1e-3);
    }
}

/**
 * Without friction and inertia and with a held hub all work is that of the
 * surfaces: where the patch stays it is the contact's to rounding, and over
 * whole waves it is none.
 */
BOOST_AUTO_TEST_CASE(surfaces_supply_the_work_of_the_contact)
{
  for (const double amplitude : {1e-9, 5e-6})
    {
      TimeRun<2> run([&](SceneParameters &scene) {
        frictionless(scene);
        scene.time.time_step        = 1e-5;
        scene.surfaces.height.wheel = wave(amplitude, 2 * pi * 0.46 / 300);
      });
      double     of_surfaces = 0., of_contact = 0., most = 0., worst = 0.;
      const auto n = static_cast<unsigned int>(2 * pi * 0.46 / 300 / 1e-4);
      for (unsigned int k = 0; k < n; ++k)
        {
          run.march(1);
          of_surfaces += run.last.surface_work;
          of_contact += run.last.energy.contact_work;
          most  = std::max(most, std::abs(of_contact));
          worst = std::max(worst, std::abs(of_contact - of_surfaces));
        }
      BOOST_TEST_MESSAGE("waves of " << amplitude
                                     << " m: work of the contact at "
                                        "most "
                                     << most << " J, of the surfaces " << worst
                                     << " J off");
      BOOST_TEST(most > 0.);
      BOOST_TEST(worst < (amplitude < 1e-6 ? 1e-6 : 2e-3) * most);
      BOOST_TEST(std::abs(of_surfaces) < 0.05 * most);
    }
}

/** With inertia too, to the second order of the step; the balance closes. */
BOOST_AUTO_TEST_CASE(energy_balances_over_moving_surfaces)
{
  double errors[2];
  for (const unsigned int finer : {1, 2})
    {
      TimeRun<2> run([&](SceneParameters &scene) {
        frictionless(scene);
        scene.contact.slip_operator = SlipOperatorKind::upwind_2;
        scene.time.inertia          = true;
        scene.time.time_step        = 4e-6 / finer;
        scene.time.end_time         = 2e-3;
        scene.surfaces.height.rail  = wave(1e-8, 2 * pi * 0.46 / 300);
        scene.surfaces.height.wheel = "1e-7*(1-cos(2*pi*100*x/2.9))*0";
      });
      double     of_surfaces = 0., of_contact = 0., most = 0., worst = 0.;
      for (unsigned int k = 0; k < 200 * finer; ++k)
        {
          run.march(1);
          of_surfaces += run.last.surface_work;
          of_contact += run.last.energy.contact_work;
          most  = std::max(most, std::abs(of_contact));
          worst = std::max(worst, std::abs(of_contact - of_surfaces));
        }
      BOOST_TEST(run.worst_balance < 1e-12 * run.largest_energy);
      errors[finer - 1] = worst / most;
    }
  BOOST_TEST_MESSAGE("work of the surfaces against the contact's: "
                     << errors[0] << ", half the step " << errors[1]);
  BOOST_TEST(errors[1] < 1e-4);
  BOOST_TEST(errors[1] < 0.3 * errors[0]);
}

/** A stepper that fails leaves gap and surfaces as they were. */
BOOST_AUTO_TEST_CASE(a_patch_that_outgrows_the_zone_is_told)
{
  TimeRun<2> run([](SceneParameters &scene) {
    frictionless(scene);
    scene.surfaces.height.rail = "80e-6*(1-cos(300*x/0.46))";
  });
  bool       failed = false;
  try
    {
      run.march(40);
    }
  catch (const ConvergenceError &error)
    {
      failed = contains(error.what(), "Mesh/Candidate zone");
    }
  BOOST_TEST(failed);
}

BOOST_AUTO_TEST_SUITE_END()
