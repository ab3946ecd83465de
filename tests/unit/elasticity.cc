#include <deal.II/base/quadrature_lib.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/error_estimator.h>

#include <boost/test/unit_test.hpp>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/bodies/direct_body.h>
#include <rolling_contact/bodies/error_indicator.h>
#include <rolling_contact/references/clamped_annulus.h>

#include <algorithm>
#include <cmath>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(elasticity)

namespace
{
  const double half_width = 4e-3;

  Grading<2> grading(const unsigned int n_elements, const double growth)
  {
    Grading<2> result;
    result.element_size_x = 2 * half_width / n_elements;
    result.zone_x         = 1.5 * half_width;
    result.zone_depth     = 0.75 * half_width;
    result.growth         = growth;
    return result;
  }

  std::shared_ptr<const BodyShape> disc(const double radius,
                                        const double hub_radius)
  {
    ShapeParameters parameters;
    parameters.radius     = radius;
    parameters.hub_radius = hub_radius;
    return make_body_shape("disc", parameters);
  }

  std::shared_ptr<const BodyShape> block(const double radius)
  {
    ShapeParameters parameters;
    parameters.radius       = radius;
    parameters.block_length = 0.4;
    parameters.block_depth  = 0.2;
    return make_body_shape("block", parameters);
  }

  struct Surface
  {
    explicit Surface(const ElasticBody<2> &body)
    {
      body.surface(grading(48, 1.), nodes, faces);
    }

    std::vector<ElasticBody<2>::SurfaceNode> nodes;
    std::vector<ElasticBody<2>::SurfaceFace> faces;
  };

  /**
   * Rim displacement under the Hertz pressure, over that of the exact annulus.
   */
  double compression_ratio(const double poisson_ratio, const double growth)
  {
    const Material    material{210e9, poisson_ratio};
    DirectBody<2>     body(disc(0.46, 0.08), material, 1., grading(48, growth));
    const Surface     surface(body);
    const std::size_t n = surface.nodes.size();
    std::vector<double> forces(n, 0.);
    double              load = 0., middle = 0.;
    for (std::size_t i = 0; i + 1 < n; ++i)
      for (unsigned int k = 0; k < 200; ++k)
        {
          const double left = surface.nodes[i].position[0],
                       h    = surface.nodes[i + 1].position[0] - left,
                       s = (k + 0.5) / 200, x = (left + s * h) / half_width,
                       f = x * x < 1. ? std::sqrt(1 - x * x) * h / 200 : 0.;
          forces[i] -= (1 - s) * f;
          forces[i + 1] -= s * f;
          load += f;
        }
    const DenseMatrix W = body.compliance(surface.nodes, {1});
    for (std::size_t i = 0; i < n; ++i)
      if (std::abs(surface.nodes[i].position[0]) < 1e-9)
        for (std::size_t j = 0; j < n; ++j)
          middle += W(i, j) * forces[j];
    const double exact =
      References::ClampedAnnulus({0.46, 0.08, 210e9, poisson_ratio})
        .radial_displacement(half_width);
    return middle / (load * exact);
  }
} // namespace

BOOST_AUTO_TEST_CASE(compression_of_a_disc_converges_to_the_exact_series)
{
  const double coarse = compression_ratio(0.3, 0.2) - 1,
               fine   = compression_ratio(0.3, 0.1) - 1;
  BOOST_TEST(std::abs(fine) < 4e-3);
  BOOST_TEST(std::abs(fine) < std::abs(coarse) / 2.5);
}

BOOST_AUTO_TEST_CASE(incompressible_bodies_do_not_lock)
{
  BOOST_TEST(std::abs(compression_ratio(0.4999, 0.1) - 1) < 1e-2);
}

BOOST_AUTO_TEST_CASE(surfaces_of_any_radii_match)
{
  const Material material{210e9, 0.3};
  Grading<2>     shifted = grading(24, 0.3);
  shifted.offset         = 0.37;
  shifted.rim_levels     = 2;
  shifted.leading_edge_x = -half_width;
  shifted.rim_width      = 2 * shifted.element_size_x;
  const DirectBody<2> reference(disc(0.46, 0.08), material, 1., shifted);
  const Surface       expected(reference);
  BOOST_TEST(expected.nodes.size() > 40u);
  for (const auto &shape :
       {disc(0.05, 0.01), disc(5., 1.), block(0.), block(0.3), block(-0.6)})
    {
      const DirectBody<2> body(shape, material, 1., shifted);
      const Surface       surface(body);
      BOOST_TEST_CONTEXT("reach " << shape->reach_x())
      BOOST_REQUIRE_EQUAL(surface.nodes.size(), expected.nodes.size());
      for (std::size_t i = 0; i < surface.nodes.size(); ++i)
        BOOST_TEST(std::abs(surface.nodes[i].position[0] -
                            expected.nodes[i].position[0]) <
                   1e-10 * half_width);
    }
}

BOOST_AUTO_TEST_CASE(surface_vertices_lie_on_the_profile)
{
  for (const auto &shape : {disc(0.46, 0.08), block(0.3), block(-0.6)})
    {
      const BodyMesh<2> mesh    = make_body_mesh<2>(shape, grading(24, 0.3));
      double            largest = 0.;
      unsigned int      n_faces = 0;
      for (const auto &cell : mesh.triangulation->active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() &&
              cell->face(f)->boundary_id() == contact_boundary)
            for (const unsigned int v : {0, 1})
              {
                const auto &vertex = cell->face(f)->vertex(v);
                if (std::abs(vertex[0]) > 2 * half_width)
                  continue;
                ++n_faces;
                largest =
                  std::max(largest,
                           std::abs(vertex[1] -
                                    shape->surface_height(vertex[0], 0.)));
              }
      BOOST_TEST(n_faces > 40u);
      BOOST_TEST(largest < 1e-12);
    }
}

BOOST_AUTO_TEST_CASE(cells_are_counted_before_they_are_made)
{
  for (const auto &shape : {disc(0.46, 0.08), disc(0.05, 0.01), block(0.3)})
    for (const double growth : {0.1, 0.5, 1.})
      {
        const auto   graded  = grading(12, growth);
        const double counted = least_cells<2>(shape, graded),
                     made    = make_body_mesh<2>(shape, graded)
                              .triangulation->n_active_cells();
        BOOST_TEST(counted <= made);
        BOOST_TEST(counted > 0.7 * made);
        BOOST_TEST_MESSAGE(counted << " of " << made << " cells counted");
      }
}

BOOST_AUTO_TEST_CASE(compliance_is_symmetric_positive_and_equals_recovery)
{
  DirectBody<2>                   body(disc(0.46, 0.08),
                     Material{210e9, 0.3},
                     0.02,
                     grading(12, 0.4));
  const Surface                   surface(body);
  const std::vector<unsigned int> components{0, 1};
  const DenseMatrix   W = body.compliance(surface.nodes, components);
  const std::size_t   n = surface.nodes.size();
  std::vector<double> forces(2 * n);
  for (std::size_t i = 0; i < 2 * n; ++i)
    forces[i] = std::sin(1. + i);
  const std::vector<double> displacement = W * forces;
  BOOST_TEST(dot(forces, displacement) > 0.);
  const BodyField field =
    body.recover(surface.nodes, components, {forces}).front();
  for (std::size_t c = 0; c < 2; ++c)
    for (std::size_t i = 0; i < n; ++i)
      BOOST_TEST(std::abs(field[surface.nodes[i].dofs[c]] -
                          displacement[c * n + i]) < 1e-12 * W(0, 0) * n);
  for (std::size_t j = 0; j < 2 * n; ++j)
    for (std::size_t i = 0; i < j; ++i)
      BOOST_TEST(W(i, j) == W(j, i));
}

BOOST_AUTO_TEST_CASE(mirroring_x_mirrors_the_compliance)
{
  DirectBody<2>     body(disc(0.46, 0.08),
                     Material{210e9, 0.3},
                     1.,
                     grading(12, 0.4));
  const Surface     surface(body);
  const DenseMatrix W       = body.compliance(surface.nodes, {0, 1});
  const std::size_t n       = surface.nodes.size();
  double            largest = 0.;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      {
        largest =
          std::max(largest, std::abs(W(i, j) - W(n - 1 - i, n - 1 - j)));
        largest = std::max(largest,
                           std::abs(W(i, n + j) + W(n - 1 - i, 2 * n - 1 - j)));
      }
  BOOST_TEST(largest < 1e-9 * W(0, 0));
}

BOOST_AUTO_TEST_CASE(profiles)
{
  BOOST_TEST(crown_depth(0., 0.3) == 0.);
  BOOST_TEST(std::abs(crown_depth(0.5, 0.2) - (0.5 - std::sqrt(0.25 - 0.04))) <
             1e-15);
  BOOST_TEST(crown_depth(-0.5, 0.2) == -crown_depth(0.5, 0.2));
  const double below = crown_depth(0.5, 0.25 - 1e-9),
               above = crown_depth(0.5, 0.25 + 1e-9);
  BOOST_TEST(above > below);
  BOOST_TEST(above - below < 2e-9);
}

BOOST_AUTO_TEST_CASE(charts_and_their_inverses)
{
  ShapeParameters parameters;
  parameters.radius         = 0.3;
  parameters.lateral_radius = 0.2;
  for (const std::string name : {"disc", "block"})
    {
      const auto shape = make_body_shape(name, parameters);
      const auto chart = shape->chart({1e-4, 1e-3, 7.2e-3});
      const auto edges = chart->edges_x();
      BOOST_TEST(std::is_sorted(edges.begin(), edges.end()));
      const auto top = chart->to_body({{chart->contact_x(), 0., 0.}});
      BOOST_TEST(std::hypot(top[0], top[2]) < 1e-16);
      double largest = 0.;
      for (std::size_t e = 0; e + 1 < edges.size(); ++e)
        for (const double below : {0., 0.4, 1.})
          {
            const SurfaceChart::Point at{
              {edges[e], 0.03, -below * shape->thickness_below()}};
            const auto back = chart->to_chart(chart->to_body(at));
            for (unsigned int d = 0; d < 3; ++d)
              largest = std::max(largest, std::abs(back[d] - at[d]));
          }
      BOOST_TEST(largest < 1e-14);
    }
}

BOOST_AUTO_TEST_CASE(twins)
{
  const auto two = [](const std::string &name, const auto &change) {
    ShapeParameters parameters;
    const auto      first = make_body_shape(name, parameters);
    change(parameters);
    return first->is_twin_of(*make_body_shape(name, parameters));
  };
  BOOST_TEST(two("disc", [](auto &) {}));
  BOOST_TEST(two("block", [](auto &) {}));
  // an entry of another shape does not matter
  BOOST_TEST(two("disc", [](auto &it) { it.block_depth = 1.; }));
  BOOST_TEST(two("block", [](auto &it) { it.hub_radius = 0.1; }));
  BOOST_TEST(!two("disc", [](auto &it) { it.hub_radius = 0.1; }));
  BOOST_TEST(!two("disc", [](auto &it) { it.hub = Hub::free; }));
  BOOST_TEST(!two("block", [](auto &it) { it.block_depth = 1.; }));
  BOOST_TEST(!two("block", [](auto &it) { it.block_length = 2.; }));
  for (const std::string name : {"disc", "block"})
    {
      BOOST_TEST(!two(name, [](auto &it) { it.radius = 0.3; }));
      BOOST_TEST(!two(name, [](auto &it) { it.lateral_radius = 0.3; }));
      BOOST_TEST(!two(name, [](auto &it) { it.width = 0.3; }));
    }
  const ShapeParameters usual;
  BOOST_TEST(!make_body_shape("disc", usual)
                ->is_twin_of(*make_body_shape("block", usual)));
  BOOST_CHECK_THROW(make_body_shape("cone", usual), InputError);
}

/**
 * The fewest cells that carry a share of the squared indicators, with those
 * that weigh as much as the last of them.
 */
BOOST_AUTO_TEST_CASE(bulk_refinement_marks_the_cells_of_the_largest_jumps)
{
  const Grading<2>    zone = grading(24, 0.5);
  const DirectBody<2> body(disc(0.46, 0.08), Material{210e9, 0.3}, 1., zone);
  const auto         &dofs = body.dof_handler();
  BodyField           displacement(dofs.n_dofs());
  for (const auto &cell : dofs.active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
      for (unsigned int d = 0; d < 2; ++d)
        displacement[cell->vertex_dof_index(v, d)] =
          std::log(cell->vertex(v).distance({0.01, 0.47}));
  dealii::Vector<float> indicators(dofs.get_triangulation().n_active_cells());
  dealii::KellyErrorEstimator<2>::estimate(
    dofs, dealii::QGauss<1>(2), {}, displacement, indicators);

  // squared indicators of the cells marked, ascending
  const auto marked = [&](const double fraction) {
    const auto          boxes = bulk_boxes(body, displacement, zone, fraction);
    std::vector<double> squares;
    for (const auto &cell : dofs.active_cell_iterators())
      {
        const auto corners = body.mesh().chart_box(cell);
        for (const auto &box : boxes)
          if (corners.first.distance(box.lower) +
                corners.second.distance(box.upper) ==
              0.)
            squares.push_back(
              std::pow(indicators[cell->active_cell_index()], 2));
      }
    BOOST_TEST(squares.size() == boxes.size());
    std::sort(squares.begin(), squares.end());
    return squares;
  };
  const auto sum_above = [](const std::vector<double> &squares,
                            const double               limit) {
    double sum = 0.;
    for (const double square : squares)
      sum += square > limit ? square : 0.;
    return sum;
  };
  const auto   all   = marked(1.);
  const double total = sum_above(all, 0.);
  for (const double fraction : {0.3, 0.6, 0.9})
    {
      const auto squares = marked(fraction);
      BOOST_TEST(squares.size() > 2u);
      BOOST_TEST(sum_above(squares, 0.) >= fraction * total);
      BOOST_TEST(sum_above(squares, 1.01 * squares.front()) < fraction * total);
      BOOST_TEST(sum_above(all, 1.01 * squares.front()) ==
                 sum_above(squares, 1.01 * squares.front()));
    }
}

BOOST_AUTO_TEST_SUITE_END()
