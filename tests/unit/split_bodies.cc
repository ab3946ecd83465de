#include "disc_on_block.h"
#include "solved_scene.h"

#include <rolling_contact/bodies/curvature_correction.h>
#include <rolling_contact/bodies/half_space_influence.h>
#include <rolling_contact/bodies/moment_fields.h>
#include <rolling_contact/pair/split_choice.h>
#include <rolling_contact/results/error_bounds.h>
#include <rolling_contact/state/estimate_errors.h>

#include <cmath>
#include <functional>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(split_bodies)

namespace
{
  Material steel()
  {
    Material material;
    material.young_modulus = 210e9;
    material.poisson_ratio = 0.3;
    return material;
  }

  /**
   * Surface displacement at (x, y) by unit point forces at the origin, row by
   * column, by the formulas of Boussinesq and Cerruti at z = 0.
   */
  Eigen::Matrix3d point_forces(const double x, const double y)
  {
    const double G = steel().shear_modulus(), nu = 0.3, r = std::hypot(x, y),
                 k = 1 / (2 * std::acos(-1.) * G), c = k / 2 * (1 - 2 * nu);
    Eigen::Matrix3d W;
    W << (1 - nu) / r + nu * x * x / std::pow(r, 3),
      nu * x * y / std::pow(r, 3),
      c / k * x / (r * r), //
      nu * x * y / std::pow(r, 3), (1 - nu) / r + nu * y * y / std::pow(r, 3),
      c / k * y / (r * r), //
      -c / k * x / (r * r), -c / k * y / (r * r), (1 - nu) / r;
    return k * W;
  }
} // namespace

/**
 * Closed forms against a hat of 160 000 point forces.
 */
BOOST_AUTO_TEST_CASE(hats_are_sums_of_point_forces)
{
  const std::array<double, 2> size{{1e-3, 0.7e-3}};
  const HalfSpaceInfluence    hats(steel(), size);
  const int                   n = 200;
  for (const auto &at : std::vector<std::array<int, 2>>{{{1, 0}},
                                                        {{0, 1}},
                                                        {{3, 2}},
                                                        {{-3, 2}},
                                                        {{3, -2}},
                                                        {{-4, 0}},
                                                        {{0, -5}}})
    {
      const double    x = at[0] * size[0], y = at[1] * size[1];
      Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
      for (int i = 0; i < 2 * n; ++i)
        for (int j = 0; j < 2 * n; ++j)
          {
            const double s = (i + 0.5) / n - 1, t = (j + 0.5) / n - 1;
            sum += (1 - std::abs(s)) * (1 - std::abs(t)) / (n * n) *
                   point_forces(x - s * size[0], y - t * size[1]);
          }
      BOOST_TEST((hats.at(x, y) - sum).cwiseAbs().maxCoeff() <
                 2e-5 * sum.cwiseAbs().maxCoeff());
    }
  // and at its own node, where the point forces are infinite
  BOOST_TEST(std::abs(hats.at(0., 0.)(0, 2)) < 1e-12 * hats.at(0., 0.)(2, 2));
  BOOST_TEST(hats.at(0., 0.)(2, 2) > hats.at(size[0], 0.)(2, 2));
}

BOOST_AUTO_TEST_CASE(half_spaces_are_symmetric_and_positive)
{
  std::vector<std::array<double, 2>> at;
  for (int i = 0; i < 9; ++i)
    for (int j = 0; j < 7; ++j)
      at.push_back({{1e-3 * (i - 0.3), 0.7e-3 * j}});
  const std::array<double, 2> size{{1e-3, 0.7e-3}};
  const auto compliance = [&](const std::vector<unsigned int> &components) {
    const NodesOnGrid nodes = nodes_on_grid(at, size);
    return GridInfluence{
      nodes,
      HalfSpaceInfluence(steel(), size).table(nodes.n, components),
      {},
      {},
      {},
      {}}
      .dense();
  };
  const DenseMatrix W = compliance({0, 1, 2});
  BOOST_TEST((W - W.transpose()).cwiseAbs().maxCoeff() <
             1e-12 * W.cwiseAbs().maxCoeff());
  const Eigen::VectorXd some = Eigen::VectorXd::Random(W.rows());
  BOOST_TEST(some.dot(W * some) > 0.);
  const DenseMatrix normal = compliance({2});
  BOOST_TEST((W.bottomRightCorner(at.size(), at.size()) - normal).norm() == 0.);
}

/**
 * Fields of moments are derivatives of those of forces, gradients those of
 * displacements, and at the surface the forces' are Boussinesq's and Cerruti's.
 */
BOOST_AUTO_TEST_CASE(fields_of_moments_are_derivatives)
{
  const dealii::Point<3> at(0.011, -0.006, -0.009);
  const auto            &moments = force_moments();
  const auto             fields  = moment_fields(at, steel());
  const double           step    = 1e-6;
  for (unsigned int l = 0; l < 3; ++l)
    {
      dealii::Point<3> before = at, after = at;
      before[l] -= step;
      after[l] += step;
      const auto below = moment_fields(before, steel()),
                 above = moment_fields(after, steel());
      for (std::size_t m = 0; m < fields.size(); ++m)
        {
          const auto slope = (above[m].value - below[m].value) / (2 * step);
          for (unsigned int k = 0; k < 3; ++k)
            BOOST_TEST(std::abs(slope[k] - fields[m].gradient[k][l]) <
                       1e-6 * fields[m].gradient.norm());
          for (std::size_t n = 0; n < fields.size() && l < 2; ++n)
            if (moments[n].component == moments[m].component &&
                moments[n].i == moments[m].i + (l == 0) &&
                moments[n].j == moments[m].j + (l == 1))
              BOOST_TEST((fields[n].value + slope).norm() <
                         1e-6 * fields[n].value.norm());
        }
    }
  const auto at_surface =
    moment_fields(dealii::Point<3>(0.011, -0.006, 0.), steel());
  const Eigen::Matrix3d expected = point_forces(0.011, -0.006);
  for (unsigned int c = 0; c < 3; ++c)
    for (unsigned int k = 0; k < 3; ++k)
      BOOST_TEST(std::abs(at_surface[c].value[k] - expected(k, c)) <
                 1e-12 * expected.norm());
}

namespace
{
  /**
   * A disc on a crowned block under two creepages, in finite elements or split.
   */
  struct WheelOnRail : public SolvedScene
  {
    explicit WheelOnRail(
      const Compliance compliance,
      const Change    &change = [](SceneParameters &) {})
      : SolvedScene(compliance, [&](SceneParameters &scene) {
        set_disc_on_block(scene);
        scene.contact.creepages          = {0.001, 0.002, 0.};
        scene.mesh.elements_across_patch = 16;
        scene.mesh.growth                = 0.4;
        change(scene);
      })
    {}
  };
} // namespace

/**
 * Two ways to the same forces, with no more in common than the contact: finite
 * elements refined to the patch, and half-spaces with moments of bodies.
 */
BOOST_AUTO_TEST_CASE(forces_are_those_of_finite_elements)
{
  const WheelOnRail elements(Compliance::finite_elements),
    split(Compliance::automatic);
  check_split(elements, split, 1.6e-3, 5e-3);
  BOOST_TEST(elements.steady.result.half_width_x ==
               split.steady.result.half_width_x,
             boost::test_tools::tolerance(5e-3));
  const double mu_N  = elements.steady.result.friction_force;
  const double bound = *error_bounds(split.situation(), split.steady).force;
  BOOST_TEST(bound < 0.02);
  BOOST_TEST(split.steady.estimate->bulk->force > 2e-4 * mu_N);
  BOOST_TEST(split.steady.estimate->bulk->force < 4e-3 * mu_N);
}

/**
 * Crowned discs, whose curved surfaces count for more than the elements: 1.5e-3
 * of mu N if it did not load what is not a half-space.
 */
BOOST_AUTO_TEST_CASE(curved_twins_have_the_forces_of_finite_elements)
{
  const auto twins = [](SceneParameters &scene) {
    scene.wheel.lateral_radius = 0.6;
    scene.wheel.hub_radius     = 0.08;
    scene.wheel.width          = 0.1;
    scene.rail                 = BodyParameters("Rail");
    static_cast<ShapeParameters &>(scene.rail) =
      static_cast<const ShapeParameters &>(scene.wheel);
    scene.rail.section        = "Rail";
    scene.contact.normal_load = 36059.;
    scene.contact.creepages   = {0., 0.003, 0.};
  };
  const WheelOnRail elements(Compliance::finite_elements, twins),
    split(Compliance::split, twins);
  BOOST_TEST(split.steady.pair->bodies().twins());
  const double mu_N = elements.steady.result.friction_force,
               difference =
                 split.steady.result.force_y - elements.steady.result.force_y;
  BOOST_TEST_MESSAGE("differs by " << difference / mu_N << " of mu N");
  BOOST_TEST(std::abs(difference) < 1.2e-3 * mu_N);
}

/** What the curvature of a ball of this radius adds to a plane. */
DenseMatrix correction_of_ball(const double        radius,
                               const double        half_width,
                               const FadingRegion &fading,
                               const double        grid_reach = 10)
{
  ShapeParameters parameters;
  parameters.section        = "Rail";
  parameters.radius         = radius;
  parameters.lateral_radius = radius;
  parameters.width          = 0.2;
  parameters.block_depth    = 0.1;
  parameters.block_length   = 0.2;
  return curvature_correction(*make_body_shape("block", parameters),
                              steel(),
                              {{half_width, half_width}},
                              fading,
                              grid_reach);
}

/**
 * No curvature adds nothing, one twice as large twice as much, to second order;
 * a ball has no preferred direction, and work is symmetric.
 */
BOOST_AUTO_TEST_CASE(curvature_adds_in_proportion)
{
  const auto correction = [](const double radius) {
    return correction_of_ball(radius, 4e-3, {8e-3, 32e-3});
  };
  const DenseMatrix flat = correction(0.), one = correction(2.),
                    two = correction(1.);
  BOOST_TEST(flat.norm() == 0.);
  BOOST_TEST((two - 2 * one).norm() < 1e-3 * one.norm());
  BOOST_TEST((one - one.transpose()).norm() < 1e-12 * one.norm());
  BOOST_TEST(one(0, 0) == one(1, 1), boost::test_tools::tolerance(1e-6));
  // under its own load the surface of a ball gives way more than a plane
  BOOST_TEST(one(2, 2) > 0.);
}

/**
 * Far from a small patch its loads are those of their moments: a grid that ends
 * at 10 half-widths gives what one over the whole region does.
 */
BOOST_AUTO_TEST_CASE(curvature_far_from_a_small_patch)
{
  const FadingRegion fading{6e-3, 32e-3};
  const DenseMatrix  part = correction_of_ball(2., 4e-4, fading),
                    whole = correction_of_ball(2., 4e-4, fading, 1e3);
  for (unsigned int i = 0; i < whole.rows(); ++i)
    for (unsigned int j = 0; j < whole.cols(); ++j)
      BOOST_TEST(std::abs(part(i, j) - whole(i, j)) <
                 2e-3 * std::sqrt(std::abs(whole(i, i) * whole(j, j))));
}

/**
 * What cannot be split is refused with the reason, or taken as finite elements.
 */
BOOST_AUTO_TEST_CASE(choice_is_told)
{
  const auto choice = [](const std::function<void(SceneParameters &)> &change,
                         const Compliance compliance) {
    SceneInMemory run;
    run.scene.dimension           = 3;
    run.scene.contact.normal_load = 36e3;
    run.scene.contact.approach.reset();
    run.scene.wheel.lateral_radius = run.scene.rail.lateral_radius = 0.6;
    run.scene.mesh.elements_across_patch                           = 12;
    run.scene.mesh.compliance                                      = compliance;
    change(run.scene);
    const Situation    &situation = run.situation();
    const PatchEstimate patch     = estimate_patch(situation);
    PairDemands         demands;
    demands.bulk_errors = true;
    return choose_compliance(
      situation,
      make_grading<3>(situation, StateDemands(), patch, 12, 0.),
      demands);
  };
  const auto none = [](SceneParameters &) {};
  BOOST_TEST(choice(none, Compliance::split).split);
  BOOST_TEST(choice(none, Compliance::automatic).split);
  BOOST_TEST(!choice(none, Compliance::finite_elements).split);
  const auto check = [&](const std::function<void(SceneParameters &)> &change,
                         const std::string                            &reason) {
    const ComplianceChoice found = choice(change, Compliance::automatic);
    BOOST_TEST(!found.split);
    BOOST_TEST(found.reason.find(reason) != std::string::npos);
  };
  check([](SceneParameters &scene) { scene.rail.width = 0.03; },
        "the next edge of the Rail");
  check([](SceneParameters &scene) { scene.mesh.rim_levels = 1; },
        "elements of the contact are refined");
  check([](
          SceneParameters &scene) { scene.rail.material.young_modulus = 7e10; },
        "materials are unlike");
  check([](SceneParameters &scene) { scene.rail.lateral_radius = -2.; },
        "concave");
  BOOST_CHECK_THROW(
    choice([](SceneParameters &scene) { scene.rail.width = 0.03; },
           Compliance::split),
    InputError);
}

BOOST_AUTO_TEST_SUITE_END()
