#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include "mesh_files.h"

#include <rolling_contact/mesh/body_mesh.h>
#include <rolling_contact/mesh/section_file_shape.h>
#include <rolling_contact/mesh/section_shapes.h>
#include <rolling_contact/profiles/nominal_profiles.h>
#include <rolling_contact/scene/scene_parameters.h>

#include <cmath>
#include <map>
#include <set>

using namespace RollingContact;

/** Bodies that are sections from files, and meshes of cells all alike. */
BOOST_AUTO_TEST_SUITE(sections)

namespace
{
  const double pi = std::acos(-1.);

  BodyParameters
  body_of(const std::string &section, const std::string &file)
  {
    BodyParameters body(section);
    body.shape     = "section";
    body.mesh_file = TEST_DATA "/../../prm/sections/" + file;
    if (section == "Rail")
      body.radius = 0.;
    return body;
  }

  std::shared_ptr<const BodyShape>
  shape_of(BodyParameters body)
  {
    body.check(3);
    body.read_mesh(3, "");
    return body.body_shape();
  }

  BodyParameters
  plate(const unsigned int cells_along)
  {
    BodyParameters body = body_of("Wheel", "annular_plate.msh");
    body.cells_along    = cells_along;
    return body;
  }

  /** Integral over the cells of a function of the place, axle at the origin. */
  double
  integral(const BodyMesh<3>                                   &mesh,
           const double                                         axle,
           const std::function<double(double, double, double)> &function)
  {
    const dealii::FE_Q<3>   element(1);
    const dealii::QGauss<3> points(4);
    dealii::FEValues<3>     values(element,
                               points,
                               dealii::update_JxW_values |
                                 dealii::update_quadrature_points);
    double                  sum = 0.;
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      {
        values.reinit(cell);
        for (const unsigned int q : values.quadrature_point_indices())
          {
            const auto &at = values.quadrature_point(q);
            sum += values.JxW(q) * function(at[0], at[1], at[2] + axle);
          }
      }
    return sum;
  }

  double
  volume(const BodyMesh<3> &mesh)
  {
    return integral(mesh, 0., [](double, double, double) { return 1.; });
  }

  double
  area(const BodyMesh<3> &mesh, const BoundaryId boundary)
  {
    double sum = 0.;
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && face->boundary_id() == boundary)
          sum += face->measure();
    return sum;
  }

  double
  relative(const double value, const double expected)
  {
    return std::abs(value / expected - 1);
  }

  using Place = std::array<long, 3>;

  Place
  rounded(const double x, const double y, const double z)
  {
    return {{std::lround(x * 1e9), std::lround(y * 1e9), std::lround(z * 1e9)}};
  }

  /** Whether a place is among others, to rounding. */
  bool
  has(const std::set<Place> &places, const Place &at)
  {
    for (long i = -1; i <= 1; ++i)
      for (long j = -1; j <= 1; ++j)
        for (long k = -1; k <= 1; ++k)
          if (places.count({{at[0] + i, at[1] + j, at[2] + k}}) > 0)
            return true;
    return false;
  }

  /** Whether turning all vertices about the axle gives vertices. */
  bool
  is_symmetric(const BodyMesh<3> &mesh, const double axle, const double angle)
  {
    std::set<Place> places;
    for (const auto &v : mesh.triangulation->get_vertices())
      places.insert(rounded(v[0], v[1], v[2] + axle));
    const double c = std::cos(angle), s = std::sin(angle);
    for (const auto &v : mesh.triangulation->get_vertices())
      {
        const double x = v[0], z = v[2] + axle;
        if (!has(places, rounded(c * x + s * z, v[1], c * z - s * x)))
          return false;
      }
    return true;
  }

  /** The mirror image in x has the same vertices. */
  bool
  is_mirrored_in_x(const BodyMesh<3> &mesh)
  {
    std::set<Place> places;
    for (const auto &v : mesh.triangulation->get_vertices())
      places.insert(rounded(v[0], v[1], v[2]));
    for (const auto &v : mesh.triangulation->get_vertices())
      if (!has(places, rounded(-v[0], v[1], v[2])))
        return false;
    return true;
  }
} // namespace



BOOST_AUTO_TEST_CASE(a_revolved_section_is_that_of_a_prism_around_the_axle)
{
  const double a = 0.46, b = 0.08, t = 0.02;
  for (const unsigned int n : {64, 97})
    {
      const auto mesh =
        make_body_mesh<3>(shape_of(plate(n)), Grading<3>::unrefined());
      BOOST_TEST(mesh.triangulation->n_active_cells() == n * 38);
      // regular polygons of n sides
      const double angle = 2 * pi / n;
      BOOST_TEST(
        relative(volume(mesh), n * std::sin(angle) * t * (a * a - b * b) / 2) <
        1e-10);
      BOOST_TEST(relative(integral(mesh,
                                   a,
                                   [](double x, double, double z) {
                                     return x * x + z * z;
                                   }),
                          n * std::sin(angle) * (2 + std::cos(angle)) / 12 * t *
                            (std::pow(a, 4) - std::pow(b, 4))) < 1e-10);
      BOOST_TEST(relative(area(mesh, contact_boundary),
                          2 * n * std::sin(angle / 2) * a * t) < 1e-10);
      BOOST_TEST(relative(area(mesh, hub_boundary),
                          2 * n * std::sin(angle / 2) * b * t) < 1e-10);
      BOOST_TEST(is_symmetric(mesh, a, angle));
      BOOST_TEST(!is_symmetric(mesh, a, 0.9 * angle));
      BOOST_TEST(is_mirrored_in_x(mesh));
    }
}



BOOST_AUTO_TEST_CASE(the_wheel_has_its_section_and_equal_angles)
{
  for (const unsigned int through : {2, 3})
    {
      BodyParameters body =
        body_of("Wheel", "wheel_" + std::to_string(through) + ".msh");
      const auto mesh =
        make_body_mesh<3>(shape_of(body), Grading<3>::unrefined());
      BOOST_TEST(is_symmetric(mesh, 0.46, 2 * pi / 96));
      const double R = 0.46, rim = 0.39, hub = 0.135, bore = 0.0925,
                   moment = (0.135 * (R * R - rim * rim) +
                             0.03 * (rim * rim - hub * hub) +
                             0.17 * (hub * hub - bore * bore)) /
                            2;
      BOOST_TEST(relative(volume(mesh), 96 * std::sin(2 * pi / 96) * moment) <
                 1e-6);
      BOOST_TEST(relative(area(mesh, hub_boundary),
                          192 * std::sin(pi / 96) * bore * 0.17) < 1e-6);
    }
}



BOOST_AUTO_TEST_CASE(an_extruded_rail_is_a_60e1)
{
  for (const unsigned int through : {2, 3})
    {
      BodyParameters body =
        body_of("Rail", "rail_" + std::to_string(through) + ".msh");
      body.block_length = 2.;
      body.cells_along  = 51;
      const auto mesh =
        make_body_mesh<3>(shape_of(body), Grading<3>::unrefined());
      const auto moment = [&](const int y, const int z) {
        return integral(mesh,
                        0.172,
                        [=](double, double at_y, double at_z) {
                          return std::pow(at_y, y) * std::pow(at_z, z);
                        }) /
               body.block_length;
      };
      const double section = moment(0, 0), height = moment(0, 1) / section;
      BOOST_TEST(relative(section, 76.70e-4) < 0.005);
      BOOST_TEST(relative(height, 80.92e-3) < 0.004);
      BOOST_TEST(relative(moment(0, 2) - section * height * height, 3038.3e-8) <
                 0.004);
      BOOST_TEST(relative(moment(2, 0), 512.3e-8) < 0.006);
      BOOST_TEST(std::abs(moment(1, 0)) < 1e-12);
      BOOST_TEST(relative(area(mesh, hub_boundary), 0.15 * 2.) < 1e-10);
      BOOST_TEST(is_mirrored_in_x(mesh));
    }
}



BOOST_AUTO_TEST_CASE(finer_uniform_gradings_divide_a_section)
{
  const auto shape = shape_of(body_of("Wheel", "wheel_2.msh"));
  const auto mesh  = make_body_mesh<3>(shape, Grading<3>::uniform(0.02, 0.009));
  BOOST_TEST(mesh.triangulation->n_levels() == 1u); // nothing hangs
  for (const auto &cell : mesh.triangulation->active_cell_iterators())
    for (unsigned int line = 0; line < 12; ++line)
      {
        const bool along = line < 8 && line % 4 >= 2;
        BOOST_TEST_REQUIRE(cell->line(line)->diameter() <
                           (along ? 0.02 : 0.009) * (1 + 1e-9));
      }
  const double coarse =
    volume(make_body_mesh<3>(shape, Grading<3>::unrefined()));
  const unsigned int n = std::ceil(2 * pi * 0.46 / 0.02);
  BOOST_TEST(relative(volume(mesh) / (n * std::sin(2 * pi / n)),
                      coarse / (96 * std::sin(2 * pi / 96))) < 1e-9);
  BOOST_TEST(is_symmetric(mesh, 0.46, 2 * pi / n));
}

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

  void
  check(const std::string &said, const std::string &part)
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
        "passes 0.001 m over or under the contact point");
  check(sections.said(moved(0.02, 0.)), "it reaches from y = 0.01 to 0.03 m");
  check(sections.said([](WrittenMesh &mesh) {
    mesh.map = [](double a, double, double c) {
      return WrittenMesh::Point{{c > 0.004 && c < 0.008 ? -a : a, 0., -c}};
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
    scene.wheel               = body_of("Wheel", "wheel_2.msh");
    scene.rail                = body_of("Rail", "rail_2.msh");
    scene.rail.lateral_radius = 0.3;
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

BOOST_AUTO_TEST_CASE(a_section_too_large_for_the_memory_is_refused)
{
  BodyParameters body = body_of("Wheel", "wheel_3.msh");
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

BOOST_AUTO_TEST_SUITE_END()
