#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include "reference_checks.h"
#include "scene_run.h"

#include <rolling_contact/bodies/direct_body.h>
#include <rolling_contact/mesh/body_mesh.h>
#include <rolling_contact/mesh/material.h>
#include <rolling_contact/pair/layered_bodies.h>
#include <rolling_contact/pair/patch_estimate.h>
#include <rolling_contact/references/hertz_line.h>
#include <rolling_contact/references/layered_line.h>
#include <rolling_contact/results/cover_columns.h>
#include <rolling_contact/results/error_bounds.h>
#include <rolling_contact/results/line_contact.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace RollingContact;
using namespace RollingContact::References;
using boost::test_tools::tolerance;

/** Layers of another material on a body, of which rubber on steel is one. */
BOOST_AUTO_TEST_SUITE(covers)

namespace
{
  const double rigid = std::numeric_limits<double>::infinity();

  LayeredPlane layer_on_rigid(const double h, const double nu)
  {
    return {h, 1., nu, rigid, 0.3};
  }

  const LayeredPlane rigid_plane{0., 1., 0., rigid, 0.};

  /** Thin rollers of rubber on steel in the plane, R = 0.1 m, on a rigid flat
   * body or the other way round. */
  void rubber_block(SceneParameters &scene)
  {
    scene.dimension                    = 2;
    scene.wheel.rigid                  = true;
    scene.wheel.radius                 = 0.1;
    BodyParameters &top                = scene.rail;
    top.shape                          = "block";
    top.block_length                   = 0.2;
    top.block_depth                    = 0.1;
    top.thickness                      = 1.;
    scene.wheel.thickness              = 1.;
    top.radius                         = 0.;
    top.material                       = {210e9, 0.3};
    top.cover                          = {5e6, 0.49, 1100.};
    top.cover_thickness                = 5e-3;
    scene.contact.normal_load          = 5e3;
    scene.contact.friction_coefficient = 0.;
    scene.mesh.elements_across_patch   = 48;
  }

  /** That block in 3D, on coarse elements. */
  SceneRun<3>::Change
  block_in_3d(const double width, const double length, const double load)
  {
    return [=](SceneParameters &scene) {
      scene.dimension                  = 3;
      scene.rail.width                 = width;
      scene.rail.block_length          = length;
      scene.rail.block_depth           = 0.03;
      scene.contact.normal_load        = load;
      scene.mesh.elements_across_patch = 12;
    };
  }

  LayeredLine exact(const SceneRun<2> &run, const LineFriction friction)
  {
    return layered_line_contact(run.situation(),
                                run.steady.result.normal_force /
                                  run.scene.rail.thickness,
                                friction);
  }

  double length_of_patch(const SceneRun<2> &run)
  {
    return (run.steady.result.edge_end_x - run.steady.result.edge_begin_x) / 2;
  }

  std::string refusal(const SceneRun<2>::Change &change)
  {
    return complaint([&]() { SceneRun<2>(rubber_block, change); });
  }
} // namespace

/** A layer of the core's material is none, whatever the wave number. */
BOOST_AUTO_TEST_CASE(a_layer_of_the_same_material_is_none)
{
  const double            nu         = 0.3;
  const SurfaceCompliance half_plane = half_plane_compliance(1., nu);
  BOOST_TEST(std::abs(half_plane.normal - 1.82) < 1e-12);
  BOOST_TEST(std::abs(half_plane.coupling + 0.52) < 1e-12);
  for (const double k : {1e-5, 1e-2, 0.049, 0.051, 1., 5., 20., 39., 41.})
    {
      const SurfaceCompliance found = compliance({1., 1., nu, 1., nu}, k);
      BOOST_TEST(std::abs(found.normal - half_plane.normal) < 1e-11);
      BOOST_TEST(std::abs(found.tangential - half_plane.tangential) < 1e-11);
      BOOST_TEST(std::abs(found.coupling - half_plane.coupling) < 1e-11);
    }
}

/**
 * On a rigid core the normal compliance is k C = 2 (1-nu^2)/E (2 K sinh 2H - 4
 * H)/(2 K cosh 2H + 4 H^2 + 1 + K^2) with K = 3 - 4 nu and H = k h, as is known
 * of bonded layers.
 */
BOOST_AUTO_TEST_CASE(a_layer_on_a_rigid_core_is_known)
{
  for (const double nu : {0., 0.3, 0.49, 0.5})
    for (const double H : {0.2, 1., 4.})
      {
        const double K     = 3 - 4 * nu,
                     known = 2 * (1 - nu * nu) *
                             (2 * K * std::sinh(2 * H) - 4 * H) /
                             (2 * K * std::cosh(2 * H) + 4 * H * H + 1 + K * K);
        BOOST_TEST(
          std::abs(compliance(layer_on_rigid(1., nu), H).normal / known - 1) <
          1e-11);
      }
  // thin: squeezed or sheared alone, and pressed out if it keeps its volume
  const double H = 1e-3;
  BOOST_TEST(std::abs(compliance(layer_on_rigid(1., 0.3), H).normal /
                        (H * 1.3 * 0.4 / 0.7) -
                      1) < 1e-5);
  BOOST_TEST(
    std::abs(compliance(layer_on_rigid(1., 0.3), H).tangential / (2.6 * H) -
             1) < 1e-5);
  BOOST_TEST(
    std::abs(compliance(layer_on_rigid(1., 0.5), H).normal / (H * H * H) - 1) <
    1e-5);
}

/** Without layers Hertz; with those of the cores' material as well. */
BOOST_AUTO_TEST_CASE(layers_of_the_same_material_touch_as_hertz)
{
  const double       a = 0.01, R = 1.;
  const LayeredPlane half{0., 1., 0., 1., 0.3}, same{0.004, 1., 0.3, 1., 0.3};
  const HertzLine    hertz = hertz_line_of_half_width(a, R, 1 / (2 * 0.91));
  for (const LayeredPair &pair : {LayeredPair{{half, half}},
                                  LayeredPair{{same, half}},
                                  LayeredPair{{same, same}}})
    {
      const auto line =
        layered_line_of_half_width(a, pair, R, LineFriction::none);
      BOOST_TEST(
        std::abs(line.load_per_length() / hertz.load_per_length() - 1) < 1e-10);
      BOOST_TEST(
        std::abs(line.pressure(0.4 * a) / hertz.pressure(0.4 * a) - 1) < 1e-10);
      BOOST_TEST(std::abs(line.approach_of_layers) < 1e-10 * a * a / R);
      const auto sticking =
        layered_line_of_half_width(a, pair, R, LineFriction::sticks);
      BOOST_TEST(std::abs(sticking.creepage) < 1e-10 * a / R);
    }
  BOOST_TEST(std::abs(layered_contact_modulus(a, {{same, same}}) * 1.82 - 1) <
             1e-10);
}

/**
 * The surface of the layer follows the cylinder, and where it sticks its strain
 * is the same all over: by sums over wave numbers of sums over the patch,
 * without Bessel functions and polynomials.
 */
BOOST_AUTO_TEST_CASE(surfaces_meet_by_plain_sums)
{
  const double       a = 1., R = 10.;
  const LayeredPlane layer{0.4, 1., 0.45, 50., 0.3}, body{0., 1., 0., 3., 0.2};
  for (const LineFriction friction : {LineFriction::none, LineFriction::sticks})
    {
      const auto line =
        layered_line_of_half_width(a, {{layer, body}}, R, friction);
      const std::array<double, 2> places{{0.3, 0.7}};
      std::array<double, 2>       lifts{}, strains{};
      const double                step = 0.04, end = 240., pi = std::acos(-1.);
      for (double k = step / 2; k < end; k += step)
        {
          const auto c = compliance(layer, k), d = compliance(body, k);
          const auto wave = [&](const auto &f) {
            return integrate(f, -a, a, 300);
          };
          const double p = wave(
            [&](const double s) { return line.pressure(s) * std::cos(k * s); });
          const double q = wave(
            [&](const double s) { return line.traction(s) * std::sin(k * s); });
          const double coupling = c.coupling - d.coupling;
          for (unsigned int i = 0; i < 2; ++i)
            {
              const double cosine = std::cos(k * places[i]);
              lifts[i] += step / pi / k * (cosine - 1) *
                          ((c.normal + d.normal) * p + coupling * q);
              strains[i] += step / pi * cosine *
                            ((c.tangential + d.tangential) * q + coupling * p);
            }
        }
      for (unsigned int i = 0; i < 2; ++i)
        {
          BOOST_TEST(
            std::abs(lifts[i] / (-places[i] * places[i] / (2 * R)) - 1) < 2e-3);
          if (friction == LineFriction::sticks)
            BOOST_TEST(std::abs(strains[i] - line.creepage) < 5e-3 * a / R);
        }
      if (friction == LineFriction::sticks)
        BOOST_TEST(std::abs(line.creepage) > 0.05 * a / R);
    }
}

/**
 * Thin layers come close to a foundation, from 3.7 % off at h/a = 0.1, and
 * those that keep their volume by far more slowly.
 */
BOOST_AUTO_TEST_CASE(thin_layers_are_limits)
{
  const auto over_limit = [](const double h, const double nu) {
    return layered_line_of_half_width(1.,
                                      {{layer_on_rigid(h, nu), rigid_plane}},
                                      1.,
                                      LineFriction::none)
             .load_per_length() /
           load_of_thin_layer(1., h, 1., nu, 1.);
  };
  BOOST_TEST(std::abs(over_limit(0.1, 0.3) - 1.0372) < 2e-4);
  BOOST_TEST(std::abs(over_limit(0.02, 0.3) - 1) < 0.008);
  BOOST_TEST(std::abs(over_limit(0.1, 0.5) - 1.960) < 2e-3);
  BOOST_TEST(std::abs(over_limit(0.02, 0.5) - 1) < 0.16);
  // a layer that sticks to both bodies has a quarter of the room to flow
  const auto sticking = layered_line_of_half_width(
    1., {{layer_on_rigid(0.02, 0.5), rigid_plane}}, 1., LineFriction::sticks);
  BOOST_TEST(std::abs(sticking.load_per_length() /
                        (4 * load_of_thin_layer(1., 0.02, 1., 0.5, 1.)) -
                      1) < 0.1);
  const auto found = layered_line(sticking.load_per_length(),
                                  {{layer_on_rigid(0.02, 0.5), rigid_plane}},
                                  1.,
                                  LineFriction::sticks);
  BOOST_TEST(std::abs(found.half_width - 1) < 1e-9);
  CHECK_INPUT_ERROR(
    layered_line_of_half_width(
      1., {{layer_on_rigid(0.005, 0.4), rigid_plane}}, 1., LineFriction::none),
    "at least a hundredth");
}

/** Half-width, peak and pressure are those of the exact layer. */
BOOST_AUTO_TEST_CASE(a_cover_in_the_plane_is_the_exact_layer)
{
  for (const double nu : {0.3, 0.49, 0.499})
    for (const double thickness : {2e-3, 1e-2})
      {
        const SceneRun<2> run(rubber_block, [&](SceneParameters &scene) {
          scene.rail.cover.poisson_ratio = nu;
          scene.rail.cover_thickness     = thickness;
        });
        const auto        line = exact(run, LineFriction::none);
        BOOST_TEST_INFO(
          "nu " << nu << ", h/a " << thickness / line.half_width
                << ": half-width " << length_of_patch(run) / line.half_width - 1
                << ", peak "
                << run.steady.result.max_pressure / line.pressure(0.) - 1);
        BOOST_TEST(std::abs(length_of_patch(run) / line.half_width - 1) < 5e-3);
        BOOST_TEST(std::abs(run.steady.result.max_pressure / line.pressure(0.) -
                            1) < 5e-3);
        BOOST_TEST(!error_bounds(run.situation(), run.steady).force);
      }
}

namespace
{
  /** Volumes of the core and of the cover, in the plane areas. */
  template <int dim>
  std::array<double, 2> volumes(const BodyParameters &body,
                                const Grading<dim>   &grading)
  {
    const BodyMesh<dim> mesh =
      make_body_mesh<dim>(BodySpec(body).body_shape(), grading);
    std::array<double, 2> volumes{};
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      volumes.at(cell->material_id()) += cell->measure();
    return volumes;
  }

  BodyParameters covered_disc()
  {
    BodyParameters disc("Wheel");
    disc.radius          = 0.1;
    disc.hub_radius      = 0.06;
    disc.width           = 0.05;
    disc.lateral_radius  = 0.;
    disc.cover_thickness = 0.01;
    return disc;
  }

  template <int dim>
  Grading<dim> around_patch()
  {
    Grading<dim> grading;
    grading.element_size_x = 2e-3;
    grading.element_size_y = 4e-3;
    grading.zone_x = grading.zone_y = grading.zone_depth = 8e-3;
    grading.growth                                       = 0.5;
    return grading;
  }
} // namespace

/** The cover is a ring at the rim or the top of a block, also in 3D. */
BOOST_AUTO_TEST_CASE(covers_lie_on_their_cores)
{
  const auto is_ring = [](const std::array<double, 2> &volumes) {
    const double ratio =
      (0.1 * 0.1 - 0.09 * 0.09) / (0.09 * 0.09 - 0.06 * 0.06);
    return std::abs(volumes[1] / volumes[0] / ratio - 1) < 0.01;
  };
  BodyParameters disc = covered_disc();
  for (const Grading<2> &grading :
       {around_patch<2>(), Grading<2>::uniform(4e-3, 4e-3)})
    BOOST_TEST(is_ring(volumes<2>(disc, grading)));
  BOOST_TEST(is_ring(volumes<3>(disc, around_patch<3>())));
  BodyParameters block("Rail");
  block.shape           = "block";
  block.radius          = 0.;
  block.block_length    = 0.1;
  block.block_depth     = 0.03;
  block.width           = 0.05;
  block.cover_thickness = 3e-3;
  const auto of_block   = volumes<3>(block, around_patch<3>());
  BOOST_TEST(std::abs(of_block[1] / (0.1 * 0.05 * 3e-3) - 1) < 1e-9);
  BOOST_TEST(std::abs(of_block[0] / (0.1 * 0.05 * 27e-3) - 1) < 1e-9);
  // six elements through it under the contact, though one is as long
  Grading<2> coarse     = around_patch<2>();
  coarse.element_size_x = 8e-3;
  coarse.zone_x         = 24e-3;
  disc.cover_thickness  = 4e-3;
  const BodyMesh<2> mesh =
    make_body_mesh<2>(BodySpec(disc).body_shape(), coarse);
  unsigned int under_contact = 0;
  for (const auto &cell : mesh.triangulation->active_cell_iterators())
    under_contact += cell->material_id() == cover_material &&
                     cell->center()[0] > 0. && cell->center()[0] < 8e-3 &&
                     cell->center()[1] > -8e-3;
  BOOST_TEST(under_contact >= 6u);
}

/** Each part has its own density. */
BOOST_AUTO_TEST_CASE(a_cover_has_its_own_mass)
{
  const BodyParameters disc  = covered_disc();
  const auto           areas = volumes<2>(disc, around_patch<2>());
  const Material       steel{210e9, 0.3, 7800.}, rubber{5e6, 0.49, 1100.};
  BodyModel            model;
  BodyParameters       free_disc = disc;
  free_disc.hub                  = Hub::free;
  for (const MassKind kind : {MassKind::lumped, MassKind::consistent})
    {
      const DirectBody<2>         body(BodySpec(free_disc).body_shape(),
                               Materials(steel, rubber),
                               0.5,
                               around_patch<2>(),
                               false,
                               model);
      const SymmetricSparseMatrix M = body.mass(kind);
      // of all nodes moved by 1 along x and y
      std::vector<double> ones(body.n_unknowns(), 1.);
      std::vector<double> forces(ones.size());
      M.multiply(ones, forces);
      double sum = 0.;
      for (const double force : forces)
        sum += force;
      BOOST_TEST(
        std::abs(sum / (2 * 0.5 * (7800. * areas[0] + 1100. * areas[1])) - 1) <
        1e-9);
    }
}

/**
 * Rolling freely with friction by which nothing slides, the creepage is that of
 * the exact layers, and with less friction between that and none.
 */
BOOST_AUTO_TEST_CASE(a_covered_cylinder_runs_further_than_its_radius)
{
  const auto run_with = [](const double friction) {
    return SceneRun<2>(rubber_block, [&](SceneParameters &scene) {
      scene.contact.friction_coefficient = friction;
      scene.contact.forces.x             = 0.;
    });
  };
  const SceneRun<2> run  = run_with(0.6);
  const auto        line = exact(run, LineFriction::sticks);
  BOOST_TEST(line.least_friction() < 0.6);
  const double creepage = run.steady.problem.loads.creepages.x;
  BOOST_TEST_INFO("creepage " << creepage << ", exact " << line.creepage);
  BOOST_TEST(std::abs(creepage / -line.creepage - 1) < 0.02);
  // as it is told beside the state, also where the material flows back
  const auto told = cover_reference(run.situation(), run.steady);
  BOOST_REQUIRE(told);
  BOOST_TEST(std::abs(*told->creepage / creepage - 1) < 0.02);
  const SceneRun<2> back(rubber_block, [](SceneParameters &scene) {
    scene.contact.friction_coefficient = 0.6;
    scene.contact.forces.x             = 0.;
    scene.contact.speed                = -1.;
  });
  BOOST_TEST(std::abs(back.steady.problem.loads.creepages.x / -creepage - 1) <
             1e-6);
  BOOST_TEST(
    std::abs(*cover_reference(back.situation(), back.steady)->creepage /
               -*told->creepage -
             1) < 1e-9);
  BOOST_TEST(std::abs(length_of_patch(run) / line.half_width - 1) < 5e-3);
}

/**
 * A rigid sphere on a covered block. The pressure of half-spaces with such a
 * layer on a rigid core, by conjugate gradients on a grid of 512 x 512 points
 * with the Fourier transform of the layer: a = 11.46 mm, p0 = 789.9 kPa, an
 * approach of 0.7120 mm.
 */
BOOST_AUTO_TEST_CASE(a_sphere_on_a_cover)
{
  const SceneRun<3> run(
    [](SceneParameters &scene) {
      rubber_block(scene);
      scene.wheel.lateral_radius = 0.1;
      scene.rail.cover_thickness = 0.01;
    },
    block_in_3d(0.16, 0.16, 200.));
  BOOST_TEST(std::abs(run.steady.result.max_pressure / 789.9e3 - 1) < 0.01);
  BOOST_TEST(std::abs(run.steady.state.approach / 0.7120e-3 - 1) < 0.01);
  const PatchEstimate estimate = estimate_patch(run.situation());
  BOOST_TEST(std::abs(estimate.half_width_x / 11.46e-3 - 1) < 0.05);
  BOOST_TEST(estimate.half_width_x == estimate.half_width_y, tolerance(1e-6));
}

/** Between endless cylinders of rubber on steel the middle is the plane's. */
BOOST_AUTO_TEST_CASE(the_middle_of_a_covered_roller_is_plane)
{
  const SceneRun<3> run(rubber_block, block_in_3d(0.08, 0.1, 400.));
  const auto        found = line_contact(run.situation(), run.steady);
  BOOST_REQUIRE(found);
  // under the load per length of the middle, less as rubber gives way at ends
  const auto line = layered_line_contact(run.situation(),
                                         found->middle_load,
                                         LineFriction::none);
  BOOST_TEST_INFO(found->middle_pressure / line.pressure(0.)
                  << " of " << line.half_width);
  BOOST_TEST(std::abs(found->middle_pressure / line.pressure(0.) - 1) < 0.01);
  BOOST_TEST(found->end_excess < -0.1);
}

/** Under an approach the compression of the core adds to that of the cover. */
BOOST_AUTO_TEST_CASE(the_patch_under_an_approach_is_estimated)
{
  const SceneRun<2> run(rubber_block, [](SceneParameters &scene) {
    scene.contact.normal_load.reset();
    scene.contact.approach         = 0.2e-3;
    scene.rail.cover_thickness     = 2e-3;
    scene.rail.material            = {1e9, 0.3}; // gives way as well
    scene.rail.cover.young_modulus = 50e6;
  });
  const double      estimate = estimate_patch(run.situation()).half_width_x;
  BOOST_TEST_INFO(estimate << " and " << length_of_patch(run));
  BOOST_TEST(std::abs(estimate / length_of_patch(run) - 1) < 0.03);
}

/** What covers are not made for is refused by name. */
BOOST_AUTO_TEST_CASE(covers_are_refused_by_name)
{
  const auto says = [](const SceneRun<2>::Change &change,
                       const std::string         &words) {
    const std::string found = refusal(change);
    BOOST_TEST_INFO(found);
    BOOST_TEST(contains(found, words));
  };
  says([](auto &scene) { scene.rail.cover_thickness = 0.095; },
       "Rail/Cover thickness = 0.095: it may be at most");
  says([](auto &scene) { scene.rail.cover.poisson_ratio = 0.5; },
       "Rail/Cover Poisson ratio = 0.5: it must be below 0.5");
  says([](auto &scene) { scene.rail.cover.young_modulus = 0.; },
       "Rail/Cover Young modulus = 0: it must be above 0 Pa");
  says([](auto &scene) { scene.wheel.cover_thickness = 0.01; },
       "Wheel/Cover thickness = 0.01: Rigid = true has no mesh");
  says([](auto &scene) { scene.rail.model.elements = ElementKind::enhanced; },
       "Rail/Elements = enhanced and Cover thickness");
  says([](auto &scene) { scene.body_solver = BodySolver::distributed; },
       "Body solver = distributed and Rail/Cover thickness");
  says([](auto &scene) { scene.mesh.adaptive_levels = 2; },
       "Mesh/Adaptive levels = 2 and Rail/Cover thickness");
  says([](auto &scene) { scene.rail.cover_thickness = 2e-6; },
       "Rail/Cover thickness = 2e-06 m: it is less than a hundredth");
}

BOOST_AUTO_TEST_SUITE_END()
