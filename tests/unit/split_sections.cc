#include "disc_on_block.h"
#include "solved_scene.h"
#include "true_sections_scene.h"

#include <rolling_contact/bodies/curvature_correction.h>
#include <rolling_contact/bodies/moment_fields.h>
#include <rolling_contact/bodies/rigid_work.h>
#include <rolling_contact/pair/split_choice.h>
#include <rolling_contact/results/error_bounds.h>

#include <cmath>
#include <functional>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(split_sections)

namespace
{
  using Change = std::function<void(SceneParameters &)>;

  void set_sections(SceneParameters &scene)
  {
    set_true_sections(scene);
    scene.contact.creepages          = {0.001, 0.001, 0.191791};
    scene.mesh.elements_across_patch = 16;
  }

  /** Moments of displacement under moments of force. */
  DenseMatrix moments_of(DirectBody<3>      &body,
                         const BodyShape    &shape,
                         const FadingRegion &fading)
  {
    const FadedFields fields(body, shape, fading);
    return fields.F.transpose() * body.solve(fields.F) + fields.Q +
           curvature_correction(shape,
                                body.elasticity().core,
                                {{4e-3, 4e-3}},
                                fading);
  }

  Grading<3> grading_beside(const double element)
  {
    Grading<3> grading;
    grading.element_size_x = grading.element_size_y = element;
    grading.zone_x = grading.zone_y = grading.zone_depth = 18e-3;
    grading.growth                                       = 0.8;
    grading.is_alone                                     = true;
    return grading;
  }
} // namespace

/**
 * Tractions at the surface itself beyond a distance, and loads that do the work
 * of their moments on rigid motions, give what fields of a plain block give
 * that end before its edges.
 */
BOOST_AUTO_TEST_CASE(steep_surfaces_add_nothing_to_plain_bodies)
{
  SceneInMemory run;
  set_disc_on_block(run.scene);
  const BodySpec &rail  = run.situation().rail;
  const auto      shape = rail.body_shape();
  DirectBody<3>   body(
    shape, {rail.material}, 1., grading_beside(4e-3), true, rail.model);
  const DenseMatrix plain = moments_of(body, *shape, {11e-3, 38e-3}),
                    steep = moments_of(body, *shape, {11e-3, 38e-3, 18e-3});
  BOOST_TEST((steep - steep.transpose()).norm() < 1e-9 * steep.norm());
  const double a     = 5e-3;
  double       local = 0.;
  for (std::size_t k = 0; k < force_moments().size(); ++k)
    for (std::size_t l = 0; l < force_moments().size(); ++l)
      {
        const auto  &one = force_moments()[k], &other = force_moments()[l];
        const double scale = std::pow(a, one.degree() + other.degree());
        local = std::max(local, std::abs(steep(k, l) - plain(k, l)) * scale);
      }
  const double of_patch =
    1 / (2 * std::acos(-1.) * rail.material.shear_modulus() * a);
  BOOST_TEST_MESSAGE("differ by " << local / of_patch << " of the patch");
  BOOST_TEST(local < 0.01 * of_patch);
}

/**
 * Loads of moments do the work of their moments on rigid motions, those of
 * degree 2 at the height of the surface.
 */
BOOST_AUTO_TEST_CASE(loads_work_on_rigid_motions)
{
  SceneInMemory run;
  set_sections(run.scene);
  const BodySpec    &rail  = run.situation().rail;
  const auto         shape = rail.body_shape();
  const FadingRegion fading{12e-3, 36e-3, 19.2e-3};
  DirectBody<3>      body(
    shape, {rail.material}, 1., grading_beside(6e-3), true, rail.model);
  const DenseMatrix F       = FadedFields(body, *shape, fading).F;
  const DenseMatrix missing = missing_rigid_work(body, *shape, fading, F);
  BOOST_TEST(missing.norm() < 1e-9 * F.norm());
  // along y: the force itself and none of its moments
  const DenseMatrix along_y = F.transpose() * as_vector(body.uniform(1, 1.));
  for (std::size_t k = 0; k < force_moments().size(); ++k)
    BOOST_TEST(std::abs(along_y(k, 0) - (k == 1 ? 1. : 0.)) < 1e-9);
}

/**
 * A mesh refined to the patch, and one that does not know it.
 */
BOOST_AUTO_TEST_CASE(forces_are_those_of_finite_elements)
{
  const SolvedScene elements(Compliance::finite_elements, set_sections),
    split(Compliance::automatic, set_sections);
  // of the approach half-spaces are 0.034 mm, the rest is what bends
  check_split(elements, split, 4e-3, 8e-3);
  const double mu_N = elements.steady.result.friction_force;
  const double bulk = split.steady.estimate->bulk->force / mu_N;
  BOOST_TEST(bulk > 3.5e-3); // what 24 finite elements differ by
  BOOST_TEST(bulk < 6e-3);
}

namespace
{
  struct Chosen
  {
    ComplianceChoice           choice;
    std::shared_ptr<SplitBody> rail; ///< that serves, if it is split
  };

  Chosen choose(const Change               &change,
                SplitBodies                &bodies,
                const Compliance            compliance = Compliance::automatic,
                const std::vector<ZoneBox> &nodes      = {})
  {
    SceneInMemory run;
    set_sections(run.scene);
    run.scene.mesh.compliance = compliance;
    change(run.scene);
    const Situation &situation = run.situation();
    PairDemands      demands;
    demands.bulk_errors = true;
    auto grading        = make_grading<3>(situation,
                                   StateDemands(),
                                   estimate_patch(situation),
                                   situation.mesh.elements_across_patch,
                                   0.);
    if (!nodes.empty())
      grading.zone_boxes = nodes;
    Chosen chosen{choose_compliance(situation, grading, demands), nullptr};
    if (chosen.choice.split)
      chosen.rail = bodies.body_of(situation.rail, grading, false, false);
    return chosen;
  }
} // namespace

/**
 * Contacts near the corner of the rail and on curved surfaces are left to
 * finite elements, and `split` says why.
 */
BOOST_AUTO_TEST_CASE(corners_and_curved_surfaces_are_refused)
{
  SplitBodies bodies;
  const auto  check = [&](const Change &change, const std::string &reason) {
    const auto found = choose(change, bodies).choice;
    BOOST_TEST(!found.split);
    BOOST_TEST_MESSAGE(found.reason);
    BOOST_TEST(found.reason.find(reason) != std::string::npos);
    BOOST_CHECK_THROW(choose(change, bodies, Compliance::split), InputError);
  };
  BOOST_TEST(choose([](SceneParameters &) {}, bodies).choice.split);
  check([](SceneParameters &scene) { scene.profiles.shift = 6.2e-3; },
        "the next edge of the Wheel");
  check(
    [](SceneParameters &scene) {
      scene.profiles.surface_kind = Profiles::SurfaceKind::curved;
    },
    "is curved");
  const auto fine = [](SceneParameters &scene) {
    scene.mesh.elements_across_patch = 20;
  };
  const auto found = choose(fine, bodies).choice;
  BOOST_TEST(!found.split);
  BOOST_TEST(found.reason.find("known less exactly") != std::string::npos);
  BOOST_TEST(choose(fine, bodies, Compliance::split).choice.split);
}

/** Nodes that may touch on one side are as far as those on the other. */
BOOST_AUTO_TEST_CASE(far_nodes_are_refused_on_both_sides)
{
  SplitBodies bodies;
  const auto  chosen = [&](const double from, const double to) {
    return choose([](SceneParameters &) {},
                  bodies,
                  Compliance::automatic,
                  {{{{-3e-3, from}}, {{3e-3, to}}}})
      .choice;
  };
  for (const auto &[near, far] : {std::pair(3e-3, 14e-3), {14e-3, 3e-3}})
    {
      const ComplianceChoice found = chosen(-near, far);
      BOOST_TEST(!found.split);
      BOOST_TEST(found.reason.find("large for the section") !=
                 std::string::npos);
    }
}

/**
 * One body at each place serves all loads there, and S is symmetric.
 */
BOOST_AUTO_TEST_CASE(bodies_are_kept_for_other_patches)
{
  SceneInMemory run;
  set_sections(run.scene);
  SplitBodies                          bodies;
  std::shared_ptr<const PlacedProfile> placed;
  const auto rail_under = [&](const double load, const unsigned int across) {
    run.scene.contact.normal_load = load;
    const Situation &situation    = run.situation();
    const auto       grading      = make_grading<3>(
      situation, StateDemands(), estimate_patch(situation), across, 0.);
    BodySpec rail = run.situation().rail;
    rail.profile  = placed ? placed : rail.profile;
    placed        = rail.profile;
    return bodies.body_of(rail, grading, false, false);
  };
  const auto rail = rail_under(16e3, 16);
  BOOST_TEST(rail == rail_under(10e3, 32));
  std::vector<ElasticBody<3>::SurfaceNode> nodes;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j)
      {
        nodes.emplace_back();
        nodes.back().position =
          dealii::Point<2>((i - 2) * 1e-3, (j - 2) * 1e-3);
      }
  const DenseMatrix S = rail->grid_influence(nodes, {0, 1, 2})->of_shapes;
  BOOST_TEST((S - S.transpose()).norm() < 1e-9 * S.norm());
  // the web bends across: 30 times what the patch gives way by
  BOOST_TEST(S(1, 1) > 50 * S(2, 2));
}

BOOST_AUTO_TEST_SUITE_END()
