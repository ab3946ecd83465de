#include <boost/test/unit_test.hpp>

#include <rolling_contact/contact/mortar.h>
#include <rolling_contact/contact/overlap.h>
#include <rolling_contact/contact/surface_coupling.h>

#include <cmath>
#include <functional>
#include <numeric>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(mortar)

namespace
{
  /** n_x by n_y boxes on [0, 1] x [0, 1]; n_y = 0 in 2D. */
  Trace grid(const unsigned int n_x, const unsigned int n_y)
  {
    Trace              trace;
    const unsigned int n_points_y = n_y + 1;
    trace.n_dimensions            = n_y == 0 ? 1 : 2;
    const auto point              = [&](unsigned int i, unsigned int j) {
      return std::array<double, 2>{
        {double(i) / n_x, n_y == 0 ? 0. : double(j) / n_y}};
    };
    for (unsigned int i = 0; i <= n_x; ++i)
      for (unsigned int j = 0; j <= n_y; ++j)
        trace.nodes.push_back(point(i, j));
    for (unsigned int i = 0; i < n_x; ++i)
      for (unsigned int j = 0; j < std::max(n_y, 1u); ++j)
        {
          Trace::Cell cell;
          cell.lower = point(i, j);
          cell.upper = point(i + 1, n_y == 0 ? 0 : j + 1);
          for (unsigned int v = 0; v < 1u << trace.n_dimensions; ++v)
            cell.corners.push_back(
              {{(i + (v & 1)) * n_points_y + j + (v >> 1), 1.}});
          trace.cells.push_back(cell);
        }
    return trace;
  }

  /** Faces on the same square, inner nodes moved by @p distortion elements. */
  SurfaceMesh surface(const unsigned int n_x,
                      const unsigned int n_y,
                      const double       distortion)
  {
    const Trace trace = grid(n_x, n_y);
    SurfaceMesh result;
    result.n_dimensions = trace.n_dimensions;
    for (const auto &node : trace.nodes)
      {
        const double x = node[0], y = node[1],
                     inside = n_y == 0 ? 1. : y * (1 - y) * 4;
        result.nodes.push_back(
          {{x + distortion / n_x * 4 * x * (1 - x) * std::sin(11 * x + 7 * y),
            n_y == 0 ? 0. : y + distortion / n_y * inside * std::cos(9 * x)}});
      }
    for (const auto &cell : trace.cells)
      {
        std::array<unsigned int, 4> face{};
        for (unsigned int v = 0; v < cell.corners.size(); ++v)
          face[v] = cell.corners[v][0].first;
        result.faces.push_back(face);
      }
    return result;
  }

  using Field = std::function<double(double, double)>;

  /** Largest error of the projected field at nodes of the interface. */
  double error(const Trace       &trace,
               const SurfaceMesh &from,
               const Field       &field,
               const bool         only_inside)
  {
    const MortarProjection projection = mortar_projection(trace, from);
    std::vector<double>    values;
    for (const unsigned int node : projection.nodes)
      values.push_back(field(from.nodes[node][0], from.nodes[node][1]));
    const auto border  = trace.border_nodes();
    double     largest = 0.;
    for (unsigned int i = 0; i < trace.nodes.size(); ++i)
      if (!only_inside || !border[i])
        largest =
          std::max(largest,
                   std::abs(RollingContact::apply(projection.rows[i], values) -
                            field(trace.nodes[i][0], trace.nodes[i][1])));
    return largest;
  }

  struct Case
  {
    Trace       trace;
    SurfaceMesh from;
  };

  std::vector<Case> cases()
  {
    return {{grid(7, 0), surface(5, 0, 0.2)},
            {grid(7, 0), surface(18, 0, 0.3)},
            {grid(5, 4), surface(4, 3, 0.2)},
            {grid(5, 4), surface(9, 11, 0.15)}};
  }

  const Field constant  = [](double, double) { return 2.; };
  const Field linear    = [](double x, double y) { return 3 * x - 2 * y + 1; };
  const Field quadratic = [](double x, double y) {
    return x * x - 0.5 * y * y + x * y;
  };
} // namespace

BOOST_AUTO_TEST_CASE(matching_nodes_are_taken_as_they_are)
{
  for (const unsigned int n_y : {0u, 4u})
    {
      const MortarProjection projection =
        mortar_projection(grid(5, n_y), surface(5, n_y, 0.));
      for (unsigned int i = 0; i < projection.rows.size(); ++i)
        for (const auto &entry : projection.rows[i])
          BOOST_TEST(std::abs(entry.second -
                              (projection.nodes[entry.first] == i ? 1. : 0.)) <
                     1e-14);
    }
}

BOOST_AUTO_TEST_CASE(constants_are_exact_and_linear_fields_inside)
{
  for (const Case &c : cases())
    {
      BOOST_TEST(error(c.trace, c.from, constant, false) < 1e-12);
      BOOST_TEST(error(c.trace, c.from, linear, true) < 1e-10);
    }
}

BOOST_AUTO_TEST_CASE(equal_faces_that_are_finer_are_exact_on_quadratics)
{
  for (const unsigned int finer : {10u, 15u})
    {
      BOOST_TEST(error(grid(5, 0), surface(finer, 0, 0.), quadratic, true) <
                 1e-13);
      BOOST_TEST(
        error(grid(5, 4), surface(finer, finer + 1, 0.), quadratic, true) <
        2e-3);
    }
  BOOST_TEST(error(grid(5, 4), surface(10, 8, 0.), quadratic, true) < 1e-13);
}

BOOST_AUTO_TEST_CASE(forces_and_their_moments_are_transmitted)
{
  for (const Case &c : cases())
    {
      const MortarProjection projection = mortar_projection(c.trace, c.from);
      const auto             border     = c.trace.border_nodes();
      std::vector<double>    r(c.trace.nodes.size(), 0.);
      double                 force = 0., moment = 0.;
      for (unsigned int i = 0; i < r.size(); ++i)
        if (!border[i])
          {
            r[i] = std::sin(1. + 3 * i);
            force += r[i];
            moment += r[i] * linear(c.trace.nodes[i][0], c.trace.nodes[i][1]);
          }
      const auto f =
        SurfaceCoupling(projection.rows, projection.nodes.size()).to_body(r);
      for (unsigned int j = 0; j < f.size(); ++j)
        {
          const auto &node = c.from.nodes[projection.nodes[j]];
          force -= f[j];
          moment -= f[j] * linear(node[0], node[1]);
        }
      BOOST_TEST(std::abs(force) < 1e-12);
      BOOST_TEST(std::abs(moment) < 1e-10);
    }
}

BOOST_AUTO_TEST_CASE(a_constant_pressure_becomes_its_consistent_forces)
{
  for (const Case &c : cases())
    {
      const MortarProjection projection = mortar_projection(c.trace, c.from);
      std::vector<double>    r(c.trace.nodes.size(), 0.);
      for (const Trace::Cell &cell : c.trace.cells)
        for (const auto &corner : cell.corners)
          r[corner[0].first] += 1. / c.trace.cells.size() / cell.corners.size();
      const auto f =
        SurfaceCoupling(projection.rows, projection.nodes.size()).to_body(r);
      // exact integrals of the shape functions over their faces
      std::vector<double> expected(c.from.nodes.size(), 0.);
      for (const auto &face : c.from.faces)
        {
          std::array<Point2, 4> corners{};
          const unsigned int    n = 1 << c.from.n_dimensions;
          for (unsigned int v = 0; v < n; ++v)
            corners[v] = c.from.nodes[face[v]];
          for (const double s :
               {0.5 - std::sqrt(1. / 12), 0.5 + std::sqrt(1. / 12)})
            for (const double t :
                 {0.5 - std::sqrt(1. / 12), 0.5 + std::sqrt(1. / 12)})
              {
                double jacobian = corners[1][0] - corners[0][0];
                if (n == 4)
                  {
                    double ds[2], dt[2];
                    for (unsigned int d = 0; d < 2; ++d)
                      {
                        ds[d] = (1 - t) * (corners[1][d] - corners[0][d]) +
                                t * (corners[3][d] - corners[2][d]);
                        dt[d] = (1 - s) * (corners[2][d] - corners[0][d]) +
                                s * (corners[3][d] - corners[1][d]);
                      }
                    jacobian = ds[0] * dt[1] - ds[1] * dt[0];
                  }
                for (unsigned int v = 0; v < n; ++v)
                  expected[face[v]] += jacobian / 4 * (v & 1 ? s : 1 - s) *
                                       (n == 2 ? 1. : (v >> 1 ? t : 1 - t));
              }
        }
      for (unsigned int j = 0; j < f.size(); ++j)
        BOOST_TEST(std::abs(f[j] / expected[projection.nodes[j]] - 1) < 1e-10);
    }
}

BOOST_AUTO_TEST_CASE(what_is_not_covered_is_told)
{
  SurfaceMesh half = surface(6, 0, 0.);
  half.faces.resize(3);
  const auto covered = mortar_projection(grid(4, 0), half).covered;
  const std::vector<double> expected{1., 1., 0., 0.};
  for (unsigned int c = 0; c < 4; ++c)
    BOOST_TEST(std::abs(covered[c] - expected[c]) < 1e-13);
  BOOST_TEST(is_convex({{{{0., 0.}}, {{1., 0.}}, {{0., 1.}}, {{1., 1.}}}}));
  BOOST_TEST(!is_convex({{{{0., 0.}}, {{1., 0.}}, {{0., 1.}}, {{.2, .2}}}}));
}

BOOST_AUTO_TEST_CASE(a_coupled_compliance_is_that_of_forces_and_displacements)
{
  const MortarProjection projection =
    mortar_projection(grid(6, 0), surface(9, 0, 0.2));
  const std::size_t     n = projection.nodes.size(), n_interface = 7;
  const SurfaceCoupling coupling(projection.rows, n);
  DenseMatrix           W = DenseMatrix::Zero(2 * n, 2 * n);
  for (std::size_t i = 0; i < 2 * n; ++i)
    for (std::size_t j = 0; j < 2 * n; ++j)
      W(i, j) = 1 / (1. + i + j);
  const DenseMatrix   coupled = coupling.to_interface(W);
  std::vector<double> r(2 * n_interface);
  for (std::size_t i = 0; i < r.size(); ++i)
    r[i] = std::cos(2. * i);
  const std::vector<double> f = coupling.to_body(r);
  const std::vector<double> u = W * f, direct = coupled * r;
  const std::vector<double> by_body = coupling.to_interface(u);
  for (std::size_t i = 0; i < r.size(); ++i)
    {
      BOOST_TEST(std::abs(direct[i] - by_body[i]) < 1e-13);
      for (std::size_t j = 0; j < r.size(); ++j)
        BOOST_TEST(coupled(i, j) == coupled(j, i));
    }
  const SurfaceCoupling none;
  BOOST_TEST(none.to_body(r) == r);
  BOOST_TEST(none.to_interface(r) == r);
}

BOOST_AUTO_TEST_CASE(turned_nodes_see_the_same_body)
{
  const std::size_t   n = 4;
  SurfaceCoupling     coupling;
  std::vector<double> angles;
  for (std::size_t i = 0; i < n; ++i)
    angles.push_back(0.4 * i - 0.5);
  coupling.turn(angles);
  DenseMatrix W = DenseMatrix::Zero(3 * n, 3 * n);
  for (std::size_t i = 0; i < 3 * n; ++i)
    for (std::size_t j = 0; j < 3 * n; ++j)
      W(i, j) = 1 / (1. + i + j);
  const DenseMatrix   turned = coupling.to_interface(W);
  std::vector<double> r(3 * n);
  for (std::size_t i = 0; i < r.size(); ++i)
    r[i] = std::cos(2. * i);
  const std::vector<double> f = coupling.to_body(r);
  for (std::size_t i = 0; i < n; ++i)
    {
      // along the tangent (cos, -sin) and the normal (sin, cos) in (y, z)
      const double c = std::cos(angles[i]), s = std::sin(angles[i]);
      BOOST_TEST(f[i] == r[i]);
      BOOST_TEST(std::abs(f[n + i] - c * r[n + i] - s * r[2 * n + i]) < 1e-15);
      BOOST_TEST(std::abs(f[2 * n + i] + s * r[n + i] - c * r[2 * n + i]) <
                 1e-15);
    }
  const std::vector<double> u = W * f, direct = turned * r;
  const std::vector<double> by_body = coupling.to_interface(u);
  for (std::size_t i = 0; i < r.size(); ++i)
    BOOST_TEST(std::abs(direct[i] - by_body[i]) < 1e-13);
}

BOOST_AUTO_TEST_SUITE_END()
