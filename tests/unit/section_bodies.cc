#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include "scene_run.h"
#include "section_files.h"

#include <rolling_contact/mesh/body_mesh.h>
#include <rolling_contact/pair/section_advice.h>

#include <cmath>

using namespace RollingContact;

/** What is said of sections from files, and how they roll. */
BOOST_AUTO_TEST_SUITE(section_bodies)

namespace
{
  /** What is said of a wheel, R = 20 mm, with this section below its axle. */
  struct Sections : public Files
  {
    std::string
    said(const std::function<void(WrittenMesh &)>    &deform,
         const std::function<void(BodyParameters &)> &change = {}) const
    {
      WrittenMesh mesh;
      mesh.a        = equal(-0.01, 0.01, 4);
      mesh.c        = equal(0., 0.01, 3);
      mesh.mirrored = true;
      mesh.map      = [](double a, double, double c) {
        return WrittenMesh::Point{{a, 0., -c}};
      };
      deform(mesh);
      BodyParameters body("Wheel");
      take(body, save("section.msh", mesh.gmsh()));
      body.shape  = "section";
      body.radius = 0.02;
      if (change)
        change(body);
      return complaint([&]() { shape_of(body); });
    }
  };

  void check(const std::string &said, const std::string &part)
  {
    BOOST_TEST(contains(said, part), said);
    BOOST_TEST(contains(said, "Wheel/"), said);
  }
} // namespace

BOOST_AUTO_TEST_CASE(sections_that_cannot_be_used)
{
  const Sections sections;
  const auto     as_it_is = [](WrittenMesh &) {};
  const auto     moved    = [](const double y, const double z) {
    return [=](WrittenMesh &mesh) {
      mesh.map = [=](double a, double, double c) {
        return WrittenMesh::Point{{a + y, 0., z - c}};
      };
    };
  };
  BOOST_TEST(sections.said(as_it_is) == "");
  check(sections.said(as_it_is,
                      [](BodyParameters &body) { body.radius = 0.01; }),
        "crosses or touches its axle, which is Wheel/Radius = 0.01 m above");
  check(sections.said(as_it_is, [](BodyParameters &body) { body.radius = -1; }),
        "revolved about an axle one radius behind the contact point");
  check(sections.said(moved(0., -0.001)),
        "passes 0.001 m over or under the contact point, the file's origin: "
        "move the section, or check Mesh unit (1 m).");
  check(sections.said(moved(0.02, 0.)), "it reaches from y = 0.01 to 0.03 m");
  check(sections.said([](WrittenMesh &mesh) {
    mesh.map = [](double a, double, double c) {
      const bool inside = std::abs(a) < 1e-3 && c > 0.003 && c < 0.004;
      return WrittenMesh::Point{{a, 0., inside ? -0.008 : -c}};
    };
  }),
        "cells are inverted, folded or flat, the first at");
  const auto other_hub = [](BodyParameters &body) { body.hub_boundary = 7; };
  check(sections.said(as_it_is, other_hub),
        "no face of its boundary has Wheel/Hub boundary id = 7");
  BOOST_TEST(sections.said(as_it_is, [&](BodyParameters &body) {
    other_hub(body);
    body.hub = Hub::free;
  }) == "");
  check(sections.said(as_it_is,
                      [](BodyParameters &body) { body.hub_boundary = 1; }),
        "Hub boundary id are both 1");
  check(sections.said(as_it_is,
                      [](BodyParameters &body) { body.cells_along = 4; }),
        "Cells along = 4: give 8 to 100000");
  check(sections.said(as_it_is,
                      [](BodyParameters &body) { body.mesh_file = ""; }),
        "Mesh file = : Shape = section needs");
  check(sections.said(as_it_is,
                      [&](BodyParameters &body) {
                        sections.save("solid.msh", block(3, 4, 0.).gmsh());
                        sections.take(body, "solid.msh");
                        body.shape = "section";
                      }),
        "cannot read it as a mesh of quadrilaterals (Shape = section)");
  BodyParameters flat("Wheel");
  flat.shape = "section";
  check(complaint([&]() { flat.check(2); }), "take Dimension = 3");
}

BOOST_AUTO_TEST_CASE(scenes_that_sections_do_not_allow)
{
  const auto said = [](const std::function<void(SceneParameters &)> &change) {
    SceneParameters scene;
    scene.dimension           = 3;
    scene.wheel               = section_body("Wheel", "wheel_2.msh");
    scene.rail                = section_body("Rail", "rail_2.msh");
    scene.rail.lateral_radius = 0.3;
    scene.contact.normal_load = 60e3;
    change(scene);
    return complaint([&]() { scene.check(); });
  };
  BOOST_TEST(said([](SceneParameters &) {}) == "");
  // a rigid one is a surface by its radii
  BOOST_TEST(said([](SceneParameters &scene) { scene.rail.rigid = true; }) ==
             "");
  const std::string why = ": a body with a section from a file (Wheel/Shape) ";
  const auto        check = [&](const std::string                            &part,
                         const std::function<void(SceneParameters &)> &change) {
    BOOST_TEST(contains(said(change), part), said(change));
  };
  check("Body solver = distributed" + why + "lives on one rank",
        [](SceneParameters &scene) {
          scene.body_solver = BodySolver::distributed;
        });
  check("Mesh/Adaptive levels = 2" + why + "is refined for the estimated patch",
        [](SceneParameters &scene) { scene.mesh.adaptive_levels = 2; });
  check("Mesh/Rim levels = 1" + why + "is refined for the estimated patch",
        [](SceneParameters &scene) { scene.mesh.rim_levels = 1; });
}

BOOST_AUTO_TEST_CASE(long_or_short_cells_get_advice)
{
  BodyParameters body = section_body("Wheel", "annular_plate.msh");
  body.cells_along    = 64;
  const auto advice   = [&](const double x, const double y) {
    return advice_on_cells_along(body, {{x, y}}, {{2e-3, 1e-3}});
  };
  BOOST_TEST(advice(1.6e-3, 0.8e-3) == "");
  BOOST_TEST(advice(1.6e-3, 0.4e-3) == "");
  BOOST_TEST(
    contains(advice(1.6e-3, 0.2e-3), "about Wheel/Cells along = 256 "));
  BOOST_TEST(contains(advice(0.4e-3, 0.8e-3), "about Wheel/Cells along = 16 "));
  body.shape = "mesh file";
  BOOST_TEST(advice(1.6e-3, 0.2e-3) == "");
}

BOOST_AUTO_TEST_CASE(a_section_too_large_for_the_memory_is_refused)
{
  BodyParameters body = section_body("Wheel", "wheel_3.msh");
  body.cells_along    = 100000;
  try
    {
      make_body_mesh<3>(shape_of(body), Grading<3>::unrefined());
      BOOST_ERROR("it was meshed");
    }
  catch (const MemoryError &error)
    {
      BOOST_TEST(contains(error.what(), "fewer Cells along"), error.what());
    }
}

namespace
{
  /** A small wheel on a crowned rail, in longitudinal and lateral creepage. */
  void small_pair(SceneParameters &scene)
  {
    scene.dimension                  = 3;
    scene.wheel.radius               = 0.1;
    scene.wheel.hub_radius           = 0.03;
    scene.wheel.width                = 0.03;
    scene.rail.shape                 = "block";
    scene.rail.radius                = 0.;
    scene.rail.lateral_radius        = 0.1;
    scene.rail.block_length          = 0.1;
    scene.rail.block_depth           = 0.05;
    scene.rail.width                 = 0.03;
    scene.contact.normal_load        = 5e3;
    scene.contact.creepages.x        = 0.001;
    scene.contact.creepages.y        = 0.001;
    scene.contact.creepages.spin     = 0.3;
    scene.mesh.elements_across_patch = 12;
    scene.mesh.growth                = 0.8;
    scene.output.body_fields         = false;
  }

  /** The bodies of small_pair() as sections. */
  struct SmallSections : public Files
  {
    SmallSections()
    {
      WrittenMesh section;
      section.a        = equal(-0.015, 0.015, 5);
      section.c        = equal(0., 0.07, 8);
      section.mirrored = true;
      section.map      = [](double a, double, double c) {
        return WrittenMesh::Point{{a, 0., -c}};
      };
      save("wheel.msh", section.gmsh());
      section.mirrored = false;
      section.a        = equal(-0.015, 0.015, 5);
      section.c        = equal(0., 1., 6);
      section.map      = [](double a, double, double c) {
        const double top = -crown_depth(0.1, a);
        return WrittenMesh::Point{{a, 0., (1 - c) * top - c * 0.05}};
      };
      save("rail.msh", section.gmsh());
    }

    void use(BodyParameters &body, const std::string &name) const
    {
      take(body, name);
      body.shape       = "section";
      body.cells_along = body.section == "Wheel" ? 100 : 16;
    }
  };
} // namespace

BOOST_AUTO_TEST_CASE(sections_roll_as_plain_bodies_do)
{
  const SmallSections files;
  const SceneRun<3>   plain(small_pair, [](SceneParameters &) {});
  for (const int which : {1, 2, 3})
    {
      const SceneRun<3> run(small_pair, [&](SceneParameters &scene) {
        if (which & 1)
          files.use(scene.wheel, "wheel.msh");
        if (which & 2)
          files.use(scene.rail, "rail.msh");
        scene.check();
      });
      BOOST_TEST_CONTEXT("sections of " << which)
      {
        const auto &expected = plain.steady.result, &result = run.steady.result;
        BOOST_TEST_MESSAGE(
          "approach " << relative(run.steady.state.approach,
                                  plain.steady.state.approach)
                      << ", pressure "
                      << relative(result.max_pressure, expected.max_pressure)
                      << ", forces " << run.force_x() - plain.force_x() << " "
                      << run.force_y() - plain.force_y() << ", "
                      << run.steady.pair->bodies().n_unknowns() << " against "
                      << plain.steady.pair->bodies().n_unknowns()
                      << " unknowns");
        BOOST_TEST(relative(run.steady.state.approach,
                            plain.steady.state.approach) < 3e-3);
        BOOST_TEST(relative(result.max_pressure, expected.max_pressure) < 0.01);
        BOOST_TEST(std::abs(run.force_x() - plain.force_x()) < 0.01);
        BOOST_TEST(std::abs(run.force_y() - plain.force_y()) < 0.01);
      }
    }
}

BOOST_AUTO_TEST_SUITE_END()
