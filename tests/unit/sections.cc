#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <boost/test/unit_test.hpp>

#include "section_files.h"

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/bodies/direct_body.h>
#include <rolling_contact/mesh/file_body_mesh.h>
#include <rolling_contact/mesh/section_file_shape.h>
#include <rolling_contact/mesh/section_shapes.h>
#include <rolling_contact/surfaces/nominal_profiles.h>

#include <cmath>
#include <map>
#include <set>

using namespace RollingContact;

/** Bodies that are sections from files, and meshes of cells all alike. */
BOOST_AUTO_TEST_SUITE(sections)

namespace
{
  const double pi = std::acos(-1.);

  BodyParameters plate(const unsigned int cells_along)
  {
    BodyParameters body = section_body("Wheel", "annular_plate.msh");
    body.cells_along    = cells_along;
    return body;
  }

  /** Integral over the cells of a function of the place, axle at the origin. */
  double integral(const BodyMesh<3>                                   &mesh,
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

  double volume(const BodyMesh<3> &mesh)
  {
    return integral(mesh, 0., [](double, double, double) { return 1.; });
  }

  double area(const BodyMesh<3> &mesh, const BoundaryId boundary)
  {
    double sum = 0.;
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && face->boundary_id() == boundary)
          sum += face->measure();
    return sum;
  }

  using Place = std::array<long, 3>;

  Place rounded(const double x, const double y, const double z)
  {
    return {{std::lround(x * 1e9), std::lround(y * 1e9), std::lround(z * 1e9)}};
  }

  /** Whether a place is among others, to rounding. */
  bool has(const std::set<Place> &places, const Place &at)
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
  bool is_mirrored_in_x(const BodyMesh<3> &mesh)
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

BOOST_AUTO_TEST_CASE(a_wheel_gives_way_alike_at_all_angles)
{
  const unsigned int n = 24, n_points = 60;
  const auto         at_rim = [](const DirectBody<3> &body) {
    std::vector<unsigned int> vertices;
    const auto &points = body.mesh().triangulation->get_vertices();
    for (unsigned int v = 0; v < points.size(); ++v)
      if (std::abs(std::hypot(points[v][0], points[v][2] + 0.46) - 0.46) <
            1e-9 &&
          std::abs(points[v][1]) < 1e-9)
        vertices.push_back(v);
    return vertices;
  };
  DirectBody<3> body(shape_of(plate(n)),
                     Material{210e9, 0.3},
                     0.,
                     Grading<3>::unrefined());
  const auto    vertices = at_rim(body);
  BOOST_TEST_REQUIRE(vertices.size() == n);
  BOOST_TEST(vertices[5] - vertices[4] == n_points);
  const DenseMatrix W = body.compliance(body.nodes_at(vertices), {1});
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      BOOST_TEST(relative(W(i, j), W(0, (j + n - i) % n)) < 1e-9);
}

BOOST_AUTO_TEST_CASE(the_wheel_has_its_section_and_equal_angles)
{
  for (const unsigned int through : {2, 3})
    {
      BodyParameters body =
        section_body("Wheel", "wheel_" + std::to_string(through) + ".msh");
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

// the axle is not in the file: only a name in it tells of another radius
BOOST_AUTO_TEST_CASE(sections_that_name_their_radius_take_no_other)
{
  const auto said = [](const std::string &file, const double radius) {
    BodyParameters body = section_body("Wheel", file);
    body.radius         = radius;
    try
      {
        shape_of(body);
      }
    catch (const InputError &error)
      {
        return std::string(error.what());
      }
    return std::string();
  };
  BOOST_TEST(said("wheel_2.msh", 0.46) == "");
  BOOST_TEST(said("wheel_2.msh", 0.461) == "");
  const std::string refusal = said("wheel_2.msh", 0.5);
  BOOST_TEST_CONTEXT(refusal)
  {
    BOOST_TEST(refusal.find("radius 0.46 m") != std::string::npos);
    BOOST_TEST(refusal.find("Wheel/Radius = 0.5 m") != std::string::npos);
  }
  BOOST_TEST(said("annular_plate.msh", 0.5) == "");
}

BOOST_AUTO_TEST_CASE(an_extruded_rail_is_a_60e1)
{
  for (const unsigned int through : {2, 3})
    {
      BodyParameters body =
        section_body("Rail", "rail_" + std::to_string(through) + ".msh");
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
  const auto shape = shape_of(section_body("Wheel", "wheel_2.msh"));
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
  BOOST_TEST(relative(area(mesh, contact_boundary),
                      2 * n * std::sin(pi / n) * 0.46 * 0.135) < 1e-9);
  BOOST_TEST(relative(area(mesh, hub_boundary),
                      2 * n * std::sin(pi / n) * 0.0925 * 0.17) < 1e-9);
}

namespace
{
  /** Largest distance between the ends of an edge, along x and otherwise. */
  std::array<double, 2> longest_edges(const BodyMesh<3> &mesh,
                                      const double       axle)
  {
    std::array<double, 2> longest{{0., 0.}};
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      for (unsigned int line = 0; line < 12; ++line)
        {
          const auto vertex = [&](const unsigned int end) {
            return cell->line(line)->vertex(end);
          };
          const bool along =
            std::abs(vertex(0)[1] - vertex(1)[1]) < 1e-9 &&
            std::abs(std::hypot(vertex(0)[0], vertex(0)[2] + axle) -
                     std::hypot(vertex(1)[0], vertex(1)[2] + axle)) < 1e-9;
          double &here = longest[along ? 0 : 1];
          here         = std::max(here, cell->line(line)->diameter());
        }
    return longest;
  }
} // namespace

BOOST_AUTO_TEST_CASE(plain_bodies_and_profiles_have_uniform_meshes)
{
  const auto      size = Grading<3>::uniform(0.04, 0.016);
  ShapeParameters plain;
  const auto disc = make_body_mesh<3>(make_body_shape("disc", plain), size);
  const unsigned int n = std::ceil(2 * pi * 0.46 / 0.04);
  BOOST_TEST(longest_edges(disc, 0.46)[0] <= 0.04);
  BOOST_TEST(longest_edges(disc, 0.46)[1] <= 0.016 * (1 + 1e-9));
  BOOST_TEST(is_symmetric(disc, 0.46, 2 * pi / n));
  BOOST_TEST(relative(volume(disc),
                      n * std::sin(2 * pi / n) * 0.1 *
                        (0.46 * 0.46 - 0.08 * 0.08) / 2) < 1e-10);

  plain.radius     = 0.;
  const auto block = make_body_mesh<3>(make_body_shape("block", plain), size);
  BOOST_TEST(block.triangulation->n_active_cells() == 25u * 7u * 32u);
  BOOST_TEST(relative(volume(block), 0.05) < 1e-10);

  PlacedProfile profile{Profiles::s1002(), [](const double across) {
                          return std::optional<double>(
                            Profiles::s1002().length() / 2 + across);
                        }};
  profile.radius = 0.46;
  ShapeParameters wheel;
  wheel.hub_radius = 0.095;
  const auto shape = std::make_shared<const WheelShape>(
    ShapeSpec(wheel, nullptr, std::make_shared<const PlacedProfile>(profile)));
  for (const double across : {0.03, 0.01})
    {
      const auto mesh =
        make_body_mesh<3>(shape, Grading<3>::uniform(0.06, across));
      BOOST_TEST(mesh.triangulation->n_levels() == 1u);
      const double axle = shape->thickness_below() + wheel.hub_radius;
      BOOST_TEST(longest_edges(mesh, axle)[1] < across * (1 + 1e-9));
      BOOST_TEST(
        is_symmetric(mesh, axle, 2 * pi / std::ceil(2 * pi * axle / 0.06)));
    }
}

namespace
{
  Grading<3> small_zone()
  {
    Grading<3> grading;
    grading.element_size_x = 1.2e-3;
    grading.element_size_y = 1e-3;
    grading.zone_x         = 7e-3;
    grading.zone_y         = 5e-3;
    grading.zone_depth     = 4e-3;
    grading.growth         = 0.8;
    return grading;
  }
} // namespace

BOOST_AUTO_TEST_CASE(cells_at_the_patch_are_divided_on_the_true_surface)
{
  const auto     zone = small_zone();
  BodyParameters rail = section_body("Rail", "rail_2.msh");
  rail.lateral_radius = 0.3;
  rail.cells_along    = 60;
  for (const BodyParameters &body :
       {section_body("Wheel", "wheel_2.msh"), rail})
    {
      const auto shape = shape_of(body);
      const auto cells = make_body_mesh<3>(shape, zone);
      BOOST_TEST(cells.triangulation->n_active_cells() ==
                   least_cells<3>(shape, zone),
                 boost::test_tools::tolerance(0.1));
      const FileMesh mesh    = as_file_mesh(cells);
      double         covered = 0.;
      for (const auto &face : mesh.contact_faces)
        {
          const auto  &p = mesh.vertices[face[0]], &q = mesh.vertices[face[3]];
          const double x = (p[0] + q[0]) / 2, y = (p[1] + q[1]) / 2;
          if (std::hypot(x / (zone.zone_x + 1.2e-3), y / (zone.zone_y + 1e-3)) >
              1)
            continue;
          covered += std::abs((q[0] - p[0]) * (q[1] - p[1]));
          BOOST_TEST_REQUIRE(std::abs(q[0] - p[0]) < zone.element_size_x / 1.2);
          BOOST_TEST_REQUIRE(std::abs(q[1] - p[1]) < zone.element_size_y / 1.2);
          for (const unsigned int v : face)
            {
              const auto &at = mesh.vertices[v];
              BOOST_TEST_REQUIRE(
                std::abs(at[2] - shape->surface_height(at[0], at[1])) < 1e-12);
            }
        }
      BOOST_TEST(covered == pi * 8.2e-3 * 6e-3,
                 boost::test_tools::tolerance(0.05));
    }
}

BOOST_AUTO_TEST_SUITE_END()
