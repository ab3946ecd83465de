#include "complaint.h"
#include "scene_run.h"

#include <rolling_contact/pair/mesh_limits.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

using namespace RollingContact;

/** Bodies whose sides and ends are near the patch, wide by 0.86 mm, long by
 * 0.2 mm. */
BOOST_AUTO_TEST_SUITE(narrow_bodies)

namespace
{
  void small(SceneParameters &scene)
  {
    scene.dimension = 3;
    for (BodyParameters *body : {&scene.wheel, &scene.rail})
      {
        body->radius         = 0.02;
        body->lateral_radius = 0.2;
        body->hub_radius     = 0.015;
        body->width          = 4e-3;
      }
    scene.contact.normal_load          = 50;
    scene.contact.friction_coefficient = 0.;
    scene.mesh.elements_across_patch   = 6;
    scene.mesh.growth                  = 0.8;
  }

  double approach(const double wheel, const double rail)
  {
    const SceneRun<3> run(small, widths(wheel, rail));
    BOOST_TEST(run.steady.result.half_width_y < std::min(wheel, rail) / 2);
    return run.steady.state.approach;
  }

  void on_block(SceneParameters &scene)
  {
    small(scene);
    scene.rail.shape           = "block";
    scene.rail.radius          = 0.;
    scene.rail.lateral_radius  = 0.;
    scene.rail.block_length    = 4e-3;
    scene.rail.block_depth     = 4e-3;
    scene.wheel.radius         = 0.01;
    scene.wheel.lateral_radius = 0.1;
    scene.wheel.hub_radius     = 0.006;
  }

  std::string refusal(const SceneRun<3>::Change &change)
  {
    return complaint([&]() { SceneRun<3>(on_block, change); });
  }

  /** The length behind "at least". */
  double asked(const std::string &text)
  {
    const std::string before = "at least ";
    const auto        place  = text.find(before);
    BOOST_REQUIRE_MESSAGE(place != std::string::npos, text);
    return std::stod(text.substr(place + before.size()));
  }
} // namespace

/**
 * Compliances of bodies of one material add up, and are those of half of a pair
 * of equal bodies; wheel and rail may change places.
 */
BOOST_AUTO_TEST_CASE(unlike_widths_give_way_as_each_body_does)
{
  for (const auto &[narrow, wide] : std::vector<std::pair<double, double>>{
         {0.92e-3, 4e-3}, {0.98e-3, 1e-3}, {1.15e-3, 4e-3}})
    BOOST_TEST_CONTEXT(narrow << " m and " << wide << " m")
    {
      const double mean = (approach(narrow, narrow) + approach(wide, wide)) / 2;
      const double unlike = approach(narrow, wide);
      BOOST_TEST(std::abs(unlike / mean - 1) < 0.01);
      BOOST_TEST(std::abs(approach(wide, narrow) / unlike - 1) < 1e-7);
    }
}

/**
 * The mesh of a body costs no more where its side cuts the zone off: some have
 * no coarse cells otherwise, and five to ten times as many.
 */
BOOST_AUTO_TEST_CASE(sides_near_the_patch_cost_few_cells)
{
  SceneInMemory run;
  small(run.scene);
  const auto cells = [&](const double wheel, const double rail) {
    widths(wheel, rail)(run.scene);
    const Situation &scene = run.situation();
    return cells_to_mesh(scene,
                         make_grading<3>(scene,
                                         StateDemands(),
                                         estimate_patch(scene),
                                         scene.mesh.elements_across_patch,
                                         0.))
      .total;
  };
  for (double width = 0.9e-3; width < 1.2e-3; width += 0.02e-3)
    for (const double rail : {4e-3, width + 0.03e-3, width + 0.1e-3})
      BOOST_TEST_CONTEXT(width << " m and " << rail << " m")
  BOOST_TEST(cells(width, rail) < 1.5 * cells(4e-3, 4e-3));
}

/** What refusals ask for will do; a zone that grows asks again. */
BOOST_AUTO_TEST_CASE(refusals_name_what_will_do)
{
  const std::string wide = refusal(widths(0.7e-3, 4e-3));
  BOOST_TEST(contains(wide, "Wheel/Width = 0.0007 m"));
  BOOST_TEST(contains(wide, "must not reach the edges of the body"));
  BOOST_TEST(refusal(widths(asked(wide), 4e-3)) == "");

  // the patch comes to the side, which its estimate does not
  const std::string at_side = refusal(widths(0.88e-3, 4e-3));
  BOOST_TEST(contains(at_side, "Wheel/Width = 0.00088 m"));
  BOOST_TEST(asked(at_side) < 1.2 * 0.88e-3);

  const auto length = [](const double value) {
    return [=](SceneParameters &scene) { scene.rail.block_length = value; };
  };
  const std::string past = refusal(length(0.23e-3));
  BOOST_TEST(contains(past, "Rail/Block length = 0.00023 m"));
  BOOST_TEST(contains(past, "beyond what the body offers"));
  const std::string at_end = refusal(length(0.28e-3));
  BOOST_TEST(
    contains(at_end,
             "Rail/Block length = 0.00028 m: this zone takes at least "));
  const std::string narrow = refusal([&](SceneParameters &scene) {
    length(0.28e-3)(scene);
    widths(1e-3, 1.2e-3)(scene);
  });
  BOOST_TEST(contains(narrow, "Rail/Block length = 0.00028 m: this zone"));
  BOOST_TEST(!contains(narrow, "Width"));
  for (const std::string &first : {past, at_end})
    {
      std::string text = first;
      for (unsigned int k = 0; k < 3 && !text.empty(); ++k)
        text = refusal(length(asked(text)));
      BOOST_TEST(text == "");
    }

  // too alike for a cell beside the side that they have in common
  const std::string alike = refusal(widths(1e-3, 1.0005e-3));
  BOOST_TEST(contains(alike,
                      "Wheel/Width = 0.001 m and Rail/Width = 0.0010005 m: "
                      "this zone takes at least"));
  BOOST_TEST(!contains(alike, "Block length"));
  BOOST_TEST(refusal(widths(asked(alike), asked(alike))) == "");
  BOOST_TEST(refusal(widths(1e-3, 1e-3)) == "");
}

BOOST_AUTO_TEST_SUITE_END()
