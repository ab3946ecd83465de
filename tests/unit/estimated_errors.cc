#include "scene_run.h"

#include <rolling_contact/analyses/solve_to_target.h>
#include <rolling_contact/results/error_bounds.h>

#include <cmath>
#include <functional>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(estimated_errors)

namespace
{
  /**
   * Whether an estimate bounds the largest error found, and means something.
   */
  void check_bound(const double estimate, const double largest)
  {
    BOOST_TEST(largest <= estimate);
    BOOST_TEST(largest > estimate / 5);
  }

  void choose_operator(SceneParameters       &scene,
                       const SlipOperatorKind slip_operator)
  {
    scene.contact.slip_operator = slip_operator;
    if (slip_operator != SlipOperatorKind::galerkin)
      return;
    scene.contact.contact_matrices  = ContactMatrices::consistent;
    scene.solver.solver             = "extragradient";
    scene.solver.controls.tolerance = 1e-3;
  }
} // namespace

/**
 * Carter's force at 0.1 to 0.9 of saturation, at four positions of the mesh.
 */
BOOST_AUTO_TEST_CASE(of_line_contacts_bound_the_error_against_carter)
{
  for (const SlipOperatorKind slip_operator : {SlipOperatorKind::calibrated,
                                               SlipOperatorKind::upwind_2,
                                               SlipOperatorKind::upwind_1,
                                               SlipOperatorKind::galerkin})
    BOOST_TEST_CONTEXT(name_of(slip_operator))
    {
      double largest = 0., estimate = 0.;
      for (const double offset : {0., 0.25, 0.5, 0.75})
        for (const double share : {0.1, 0.5, 0.9})
          {
            const SceneRun<2> run(
              [](SceneParameters &scene) {
                scene.mesh.elements_across_patch = 24;
                scene.contact.approach           = 0.22e-3;
              },
              [&](SceneParameters &scene) {
                choose_operator(scene, slip_operator);
                scene.mesh.patch_offset   = offset;
                scene.contact.creepages.x = share * 0.005517;
              });
            // saturation is mu a / R, a that of the load
            const double a =
              2 * std::sqrt(run.steady.result.normal_force / 0.02 * 0.23 /
                            std::acos(-1.) / (210e9 / 1.82));
            const double z = run.scene.contact.creepages.x / (0.3 * a / 0.23);
            largest =
              std::max(largest, std::abs(run.force_x() + 2 * z - z * z));
            estimate = *error_bounds(run.situation(), run.steady).force;
          }
      check_bound(estimate, largest);
    }
}

/**
 * Forces over mu N on 32 elements, extrapolated: laterally, and with spin; the
 * largest error of two positions of the mesh.
 */
BOOST_AUTO_TEST_CASE(of_point_contacts_bound_the_error_against_fine_meshes)
{
  struct State
  {
    double creepage_x, creepage_y, spin, force_x, force_y;
  };
  const std::array<State, 2> converged{
    {{0., 0.00547104544, 0., 0., -0.982387},
     {0.0028528024, 0.00315870956, 1.99401971, -0.485431, 0.126772}}};
  for (const SlipOperatorKind slip_operator : {SlipOperatorKind::calibrated,
                                               SlipOperatorKind::upwind_2,
                                               SlipOperatorKind::upwind_1,
                                               SlipOperatorKind::galerkin})
    {
      double largest = 0., estimate = 0.;
      for (const State &state : converged)
        {
          double error = 0.;
          for (const double offset : {1. / 3, 0.4})
            {
              const SceneRun<3> run(
                [&](SceneParameters &scene) {
                  scene.dimension                  = 3;
                  scene.mesh.elements_across_patch = 8;
                  scene.mesh.growth                = 0.4;
                  scene.mesh.patch_offset          = offset;
                  scene.wheel.lateral_radius       = 0.3;
                  scene.rail.lateral_radius        = 0.3;
                  scene.contact.normal_load        = 36059.;
                },
                [&](SceneParameters &scene) {
                  choose_operator(scene, slip_operator);
                  scene.contact.creepages.x    = state.creepage_x;
                  scene.contact.creepages.y    = state.creepage_y;
                  scene.contact.creepages.spin = state.spin;
                });
              estimate = *error_bounds(run.situation(), run.steady).force;
              error    = std::max(error,
                               std::hypot(run.force_x() - state.force_x,
                                          run.force_y() - state.force_y));
            }
          BOOST_TEST_MESSAGE(name_of(slip_operator)
                             << " " << error << " " << estimate);
          // the edge law has an order of its own with spin
          if (slip_operator == SlipOperatorKind::calibrated)
            check_bound(estimate, error);
          largest = std::max(largest, error);
        }
      BOOST_TEST_CONTEXT(name_of(slip_operator))
      check_bound(estimate, largest);
    }
}

namespace
{
  void set_line_contact(SceneParameters &scene)
  {
    scene.contact.approach.reset();
    scene.contact.normal_load = 140e3;
    scene.contact.creepages.x = 0.0017;
  }

  /**
   * Discs on an elongated patch under a lateral creepage.
   */
  void set_point_contact(SceneParameters &scene)
  {
    scene.dimension            = 3;
    scene.wheel.lateral_radius = scene.rail.lateral_radius = 0.3;
    scene.wheel.width = scene.rail.width = 0.08;
    scene.contact.approach.reset();
    scene.contact.normal_load = 36059.;
    scene.contact.creepages.y = 0.003;
  }

  /**
   * The mesh of a target error for a scene, before anything is solved.
   */
  TargetMesh chosen(const std::function<void(SceneParameters &)> &change,
                    const double                                  target,
                    const TargetDemands                          &demands = {})
  {
    SceneParameters scene;
    set_line_contact(scene);
    change(scene);
    scene.mesh.target_error = target;
    return TargetError(Situation(scene), demands).cheapest_mesh();
  }

  /**
   * A state solved to a target: bound and force, over mu N, on its mesh and on
   * one of a fourth of its size.
   */
  template <int dim>
  struct TargetRun : public SceneInMemory
  {
    TargetRun(const std::function<void(SceneParameters &)> &set,
              const double                                  target)
    {
      set(scene);
      scene.mesh.target_error = target;
      scene.check();
      Situation              situation(scene);
      const SteadyState<dim> steady =
        solve_to_target<dim>(situation,
                             StateDemands(),
                             TargetDemands(),
                             context,
                             [&](const auto &) { ++n_kept; });
      scene.mesh    = situation.mesh;
      bound         = *error_bounds(situation, steady).force;
      force         = force_of(steady);
      growth        = scene.mesh.growth_in(dim);
      elements      = scene.mesh.elements_across_patch;
      grid_elements = steady.grading.elements_across();
    }

    double error_against_finer()
    {
      SceneParameters finer = scene;
      finer.mesh.target_error.reset();
      finer.mesh.elements_across_patch *= 4;
      finer.mesh.growth = dim == 2 ? 0.05 : 0.4;
      const SteadyState<dim> steady =
        solve_steady_state<dim>(Situation(finer), StateDemands(), context);
      return std::abs(force_of(steady) - force);
    }

    double       bound, force, growth;
    unsigned int elements, grid_elements, n_kept = 0;

  private:
    double force_of(const SteadyState<dim> &steady) const
    {
      return std::hypot(steady.result.force_x, steady.result.force_y) /
             steady.result.friction_force;
    }
  };
} // namespace

BOOST_AUTO_TEST_CASE(a_target_error_is_kept_by_the_bound_and_the_error)
{
  for (const double target : {2e-2, 2e-3})
    {
      TargetRun<2> run(set_line_contact, target);
      BOOST_TEST(run.bound <= target);
      BOOST_TEST(run.bound > 0.7 * target); // no finer than it need be
      BOOST_TEST(run.elements == run.grid_elements);
      BOOST_TEST(run.n_kept == 1u);
      BOOST_TEST(run.error_against_finer() <= run.bound);
      BOOST_TEST(run.said.str().find("made again") == std::string::npos);
      BOOST_TEST(run.report.objects.size() == 1u); // for run.json
      BOOST_TEST(run.report.objects.at(0).reason.find("Mesh/Target error = ") ==
                 0u);
    }
  TargetRun<3> run(set_point_contact, 4e-2);
  BOOST_TEST(run.bound <= 4e-2);
  BOOST_TEST(run.bound > 0.5 * 4e-2);
  BOOST_TEST(run.error_against_finer() <= run.bound);
}

/**
 * The patch on a layer is 5 % shorter than Hertz's: the first mesh misses the
 * target, which is said.
 */
BOOST_AUTO_TEST_CASE(a_mesh_that_misses_its_target_is_made_again)
{
  const auto thin_rail = [](SceneParameters &scene) {
    set_line_contact(scene);
    scene.rail.shape       = "block";
    scene.rail.radius      = 0.;
    scene.rail.block_depth = 0.01;
  };
  const double target = 3e-3;
  TargetRun<2> run(thin_rail, target);
  BOOST_TEST(run.said.str().find("made again") != std::string::npos);
  BOOST_TEST(run.bound <= target);
  BOOST_TEST(run.n_kept == 1u);
  warn_of_missed_target(run.situation(), run.context);
  BOOST_TEST(run.log.warnings().empty());
  run.report.errors.push_back({"force", 2 * target, "mu N", "", true, ""});
  warn_of_missed_target(run.situation(), run.context);
  BOOST_TEST(run.log.warnings().size() == 1u);
}

BOOST_AUTO_TEST_CASE(a_target_error_takes_growth_and_elements_together)
{
  const auto       as_is  = [](SceneParameters &) {};
  const TargetMesh coarse = chosen(as_is, 1e-2), fine = chosen(as_is, 1e-4);
  BOOST_TEST(coarse.elements < fine.elements);
  BOOST_TEST(coarse.growth > fine.growth);
  const TargetMesh steep = chosen(set_point_contact, 1e-2);
  BOOST_TEST(steep.growth >= 0.6);
  // under an approach the bulk makes the load, and needs more of the mesh
  BOOST_TEST(chosen(
               [](SceneParameters &scene) {
                 scene.contact.normal_load.reset();
                 scene.contact.approach = 0.22e-3;
               },
               2e-3)
               .growth < chosen(as_is, 2e-3).growth);
  // whatever mesh the scene has
  const TargetMesh other = chosen(
    [](SceneParameters &scene) {
      scene.mesh.elements_across_patch = 70;
      scene.mesh.growth                = 0.07;
    },
    1e-2);
  BOOST_TEST(other.elements == coarse.elements);
  BOOST_TEST(other.growth == coarse.growth);
  // the worst states of curves
  TargetDemands spin, loads;
  spin.spin     = true;
  loads.patches = {1., 0.5};
  BOOST_TEST(chosen(set_point_contact, 1e-2, spin).elements > steep.elements);
  const TargetMesh small = chosen(as_is, 1e-2, loads);
  BOOST_TEST(small.elements >= 1.5 * coarse.elements);
}

BOOST_AUTO_TEST_CASE(a_target_error_out_of_reach_is_refused)
{
  const auto refused = [](const std::function<void(SceneParameters &)> &change,
                          const double                                  target,
                          const std::string                            &text) {
    BOOST_CHECK_EXCEPTION(chosen(change, target),
                          InputError,
                          [&](const InputError &error) {
                            BOOST_TEST_MESSAGE(error.what());
                            return std::string(error.what()).find(text) !=
                                   std::string::npos;
                          });
  };
  refused([](SceneParameters &) {}, 1e-6, "Give a larger target.");
  refused([](
            SceneParameters &scene) { scene.solver.controls.tolerance = 1e-3; },
          2e-3,
          "a smaller Contact/Tolerance than 0.001");
  refused(
    [](SceneParameters &scene) {
      scene.contact.slip_operator = SlipOperatorKind::upwind_1;
    },
    5e-6,
    "Contact/Slip operator = calibrated");
  refused(
    [](SceneParameters &scene) {
      scene.rail.shape       = "block";
      scene.rail.radius      = 0.;
      scene.rail.block_depth = 0.004;
    },
    1e-2,
    "thinner than half the patch");
  // waves as long as an element show at the nodes of other meshes
  refused(
    [](SceneParameters &scene) {
      scene.contact.roughness = "1e-6*cos(2*pi*x/4e-4)";
    },
    5e-3,
    "a smoother Contact/Roughness");
}

/**
 * A material that differs by a millionth, or a Poisson ratio just above 0.45,
 * moves the bound by as little; materials that are unlike in full raise it.
 */
BOOST_AUTO_TEST_CASE(bounds_do_not_jump_from_class_to_class)
{
  const auto bound_of =
    [](const std::function<void(BoundCircumstances &)> &change,
       const SlipOperatorKind                           kind) {
      BoundCircumstances found;
      found.kind     = kind;
      found.n        = 48.;
      found.growth   = 0.1;
      found.friction = 0.3;
      change(found);
      return *error_bounds(found).force;
    };
  for (const SlipOperatorKind kind :
       {SlipOperatorKind::calibrated, SlipOperatorKind::upwind_2})
    {
      const double twins = bound_of([](BoundCircumstances &) {}, kind);
      const auto   check =
        [&](const std::function<void(BoundCircumstances &)> &little) {
          BOOST_TEST(bound_of(little, kind) >= twins);
          BOOST_TEST(bound_of(little, kind) == twins,
                     boost::test_tools::tolerance(5e-3));
        };
      check([](BoundCircumstances &found) { found.beta = 1e-6; });
      check([](BoundCircumstances &found) { found.incompressibility = 1e-4; });
      BOOST_TEST(bound_of([](BoundCircumstances &found) { found.beta = 0.1; },
                          kind) > 1.5 * twins);
    }
}

/**
 * On a patch that is three times as wide as long elements are at most 1.5 times
 * as wide as long, on one that is long six of them are enough.
 */
BOOST_AUTO_TEST_CASE(elements_across_are_as_small_as_spin_needs)
{
  SceneInMemory run;
  run.scene.dimension            = 3;
  run.scene.wheel.lateral_radius = run.scene.rail.lateral_radius = 0.3;
  run.scene.contact.normal_load                                  = 36059.;
  run.scene.check();
  const auto elements = [&](const double half_width_y) {
    PatchEstimate patch;
    patch.half_width_x = 3e-3;
    patch.half_width_y = half_width_y;
    const Grading<3> grading =
      make_grading<3>(run.situation(), StateDemands(), patch, 12, 0.);
    return std::lround(2 * half_width_y / grading.element_size_y);
  };
  BOOST_TEST(elements(8.9e-3) == 24);
  BOOST_TEST(elements(5.9e-3) == 16);
  BOOST_TEST(elements(4e-3) == 12);
  BOOST_TEST(elements(3e-3) == 12);
  BOOST_TEST(elements(0.5e-3) == 6);
}

BOOST_AUTO_TEST_SUITE_END()
