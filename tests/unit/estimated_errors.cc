#include "scene_run.h"

#include <rolling_contact/assessment/error_bounds.h>

#include <cmath>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(estimated_errors)

namespace
{
  /**
   * Whether an estimate bounds the largest error found, and means something.
   */
  void
  check_bound(const double estimate, const double largest)
  {
    BOOST_TEST(largest <= estimate);
    BOOST_TEST(largest > estimate / 5);
  }



  void
  choose_operator(SceneParameters &scene, const SlipOperatorKind slip_operator)
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
            estimate = *error_bounds(run.scene, run.steady).force;
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
              estimate = *error_bounds(run.scene, run.steady).force;
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

BOOST_AUTO_TEST_SUITE_END()
