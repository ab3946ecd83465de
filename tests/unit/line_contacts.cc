#include "complaint.h"
#include "scene_run.h"

#include <rolling_contact/results/error_bounds.h>
#include <rolling_contact/results/line_contact.h>
#include <rolling_contact/results/lines_across.h>
#include <rolling_contact/surfaces/crown.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace RollingContact;

/** Cylinders that touch from side to side of the narrower one, Hertz's patch
 * 0.47 mm long. */
BOOST_AUTO_TEST_SUITE(line_contacts)

namespace
{
  void rollers(SceneParameters &scene)
  {
    scene.dimension = 3;
    for (BodyParameters *body : {&scene.wheel, &scene.rail})
      {
        body->radius                 = 0.02;
        body->lateral_radius         = 0.;
        body->hub_radius             = 0.014;
        body->material.young_modulus = 210e9;
        body->material.poisson_ratio = 0.3;
        body->width                  = 1e-3;
      }
    scene.contact.normal_load          = 500;
    scene.contact.friction_coefficient = 0.;
    scene.mesh.elements_across_patch   = 6;
    scene.mesh.growth                  = 0.8;
  }

  /** Largest pressures of the lines across over that of the middle one. */
  std::vector<double> along(const SceneRun<3> &run)
  {
    const auto          lines = lines_across(run.steady);
    std::vector<double> p;
    for (const LineAcross &line : lines)
      p.push_back(line.max_pressure / lines[lines.size() / 2].max_pressure);
    return p;
  }

  std::string refusal(const SceneRun<3>::Change &change)
  {
    return complaint([&]() { SceneRun<3>(rollers, change); });
  }
} // namespace

/**
 * Without Poisson's effect the plane contact needs no stress at flush ends:
 * the pressure is the same all along, with half the area at nodes of the ends.
 */
BOOST_AUTO_TEST_CASE(flush_ends_without_poisson_bear_as_the_middle)
{
  const SceneRun<3> run(rollers, [](SceneParameters &scene) {
    scene.wheel.material.poisson_ratio = 0.;
    scene.rail.material.poisson_ratio  = 0.;
  });
  for (const double p : along(run))
    BOOST_TEST(std::abs(p - 1) < 0.01); // cells in depth are unlike across
  const auto found = line_contact(run.situation(), run.steady);
  BOOST_REQUIRE(found);
  BOOST_TEST(std::abs(found->end_excess) < 1e-3);
  // few elements, and thin rings for half-spaces
  BOOST_TEST(std::abs(found->middle_pressure / found->hertz.max_pressure - 1) <
             0.03);
  BOOST_TEST(std::abs(2 * run.steady.result.half_width_y - 1e-3) < 1e-9);
}

/** Flush ends give way to the side; a narrow body's press into a wide one. */
BOOST_AUTO_TEST_CASE(ends_bear_less_where_flush_and_more_on_a_wider_body)
{
  const SceneRun<3> flush(rollers, widths(1e-3, 1e-3)),
    narrow(rollers, widths(1e-3, 2e-3)), wide(rollers, widths(2e-3, 1e-3));
  BOOST_TEST(along(flush).front() < 0.9);
  BOOST_TEST(along(narrow).front() > 1.3);
  BOOST_TEST(line_contact(narrow.situation(), narrow.steady)->end_excess > 0.1);
  BOOST_TEST(line_contact(flush.situation(), flush.steady)->end_excess < -0.05);

  // both are discs of one material: which is the wider does not matter
  const auto p = along(narrow), q = along(wide);
  BOOST_REQUIRE(p.size() == q.size());
  for (std::size_t k = 0; k < p.size(); ++k)
    {
      BOOST_TEST(std::abs(p[k] / q[k] - 1) < 1e-6);
      BOOST_TEST(std::abs(p[k] / p[p.size() - 1 - k] - 1) < 1e-6);
    }
}

/**
 * Pressure at a square end on a wider body of one material, without friction:
 * r^-0.226 (a wedge of 90 degrees on a half-plane); half-spaces have r^-0.5.
 */
BOOST_AUTO_TEST_CASE(pressure_at_square_ends_grows_as_that_of_a_wedge)
{
  std::vector<double> peaks;
  for (const unsigned int levels : {3, 4, 5})
    {
      const SceneRun<3> run(rollers, [&](SceneParameters &scene) {
        widths(1e-3, 3e-3)(scene);
        scene.mesh.rim_levels = levels;
      });
      peaks.push_back(run.steady.result.max_pressure);
    }
  const double first  = std::log2(peaks[1] / peaks[0]),
               second = std::log2(peaks[2] / peaks[1]);
  BOOST_TEST_MESSAGE("exponents " << first << ", " << second);
  BOOST_TEST(std::abs((first + second) / 2 - 0.226) < 0.03);
}

/** No closed form is told, nor a bound of an error. */
BOOST_AUTO_TEST_CASE(no_bound_is_known)
{
  const SceneRun<3> run(rollers, widths(1e-3, 2e-3));
  const Situation  &scene  = run.situation();
  const ErrorBounds bounds = error_bounds(scene, run.steady);
  BOOST_TEST(!bounds.force);
  BOOST_TEST(!bounds.max_pressure);
  BOOST_TEST(contains(bounds.text, "ends of a line contact"));
  BOOST_TEST(!scene.has_plain_surfaces());
}

BOOST_AUTO_TEST_CASE(refusals)
{
  BOOST_TEST(contains(refusal([](SceneParameters &scene) {
                        scene.contact.friction_coefficient = 0.3;
                        scene.mesh.target_error            = 0.01;
                      }),
                      "Mesh/Target error = 0.01: no bound"));
  BOOST_TEST(contains(refusal([](SceneParameters &scene) {
                        scene.rail.lateral_radius   = 0.1;
                        scene.surfaces.height.wheel = "lundberg : 500";
                      }),
                      "Surfaces/Wheel height = lundberg : 500: a crown"));
  BOOST_TEST(contains(refusal([](SceneParameters &scene) {
                        scene.mesh.adaptive_levels = 1;
                      }),
                      "Mesh/Adaptive levels = 1 refines no line contact"));
  for (const char *text : {"lundberg", "lundberg : many", "johns-gohar : 0"})
    BOOST_TEST(contains(refusal([&](SceneParameters &scene) {
                          scene.surfaces.height.wheel = text;
                        }),
                        "give the load in N, above 0"));
}

/** Drops over q/(pi E*) at half and at all of the half-length. */
BOOST_AUTO_TEST_CASE(drops_of_crowns)
{
  const Crown::Roller roller{0.01, 2.5e-4, 1e11};
  const double        scale = 5000. / 0.01 / (std::acos(-1.) * 1e11);
  const Crown         lundberg{Crown::Kind::lundberg, 5000.},
    johns_gohar{Crown::Kind::johns_gohar, 5000.};
  BOOST_TEST(lundberg.drop(0., roller) == 0.);
  BOOST_TEST(
    std::abs(lundberg.drop(2.5e-3, roller) / scale - std::log(4. / 3)) < 1e-12);
  BOOST_TEST(lundberg.drop(5e-3, roller) == lundberg.drop(-4.996e-3, roller));
  // at the end ln(L / (0.6066 b))
  BOOST_TEST(std::abs(johns_gohar.drop(-5e-3, roller) / scale -
                      std::log(0.01 / (0.6066 * 2.5e-4))) < 1e-12);
  BOOST_TEST(!crown_named("Surfaces/Wheel height", "1e-6 * x").has_value());
}

/** A crown for a part of the length, from where the surface falls as a chamfer
 * does. */
BOOST_AUTO_TEST_CASE(a_crown_has_its_own_length)
{
  const auto crown =
    crown_named("Surfaces/Wheel height", "lundberg : 4000 : 0.008");
  BOOST_REQUIRE(crown);
  BOOST_TEST(crown->load == 4000.);
  BOOST_TEST(crown->length.value() == 0.008);
  // the load per length is that of 5000 N on 10 mm
  const Crown::Roller own{0.008, 2.5e-4, 1e11}, all{0.01, 2.5e-4, 1e11};
  const Crown         whole{Crown::Kind::lundberg, 5000.};
  BOOST_TEST(std::abs(crown->drop(2e-3, own) / whole.drop(2.5e-3, all) - 1) <
             1e-12);
  const double slope =
                 (crown->drop(4.5e-3, own) - crown->drop(4.2e-3, own)) / 3e-4,
               before =
                 (crown->drop(3.99599e-3, own) - crown->drop(3.99597e-3, own)) /
                 2e-8;
  BOOST_TEST(std::abs(slope / before - 1) < 0.01);
  BOOST_TEST(slope > 0.1);
  BOOST_TEST(contains(complaint([]() {
                        crown_named("Surfaces/Wheel height",
                                    "lundberg : 4000 : 0");
                      }),
                      "give the crown's own length in m, above 0"));
  // the part that bears is shorter than the bodies
  const SceneRun<3> run(rollers, [](SceneParameters &scene) {
    scene.surfaces.height.wheel = "johns-gohar : 300 : 0.6e-3";
    scene.contact.normal_load   = 300;
  });
  BOOST_TEST(run.steady.result.half_width_y < 0.42e-3);
  BOOST_TEST(run.steady.result.half_width_y > 0.25e-3);
}

/** A crown takes load from the ends and leaves the middle alike. */
BOOST_AUTO_TEST_CASE(crowns_relieve_the_ends)
{
  const auto pressure = [](const std::string &crown) {
    const SceneRun<3> run(rollers, [&](SceneParameters &scene) {
      widths(2e-3, 6e-3)(scene);
      scene.contact.normal_load   = 1000;
      scene.surfaces.height.wheel = crown;
    });
    const auto        found = line_contact(run.situation(), run.steady);
    BOOST_TEST(found->middle_pressure < 1.12 * found->hertz.max_pressure);
    return found->end_pressure;
  };
  const double flat = pressure(""), lundberg = pressure("lundberg : 1000"),
               johns_gohar = pressure("johns-gohar : 1000");
  BOOST_TEST(lundberg < johns_gohar);
  BOOST_TEST(johns_gohar < 0.8 * flat);
}

BOOST_AUTO_TEST_SUITE_END()
