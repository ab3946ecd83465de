#include <boost/test/unit_test.hpp>

#include <rolling_contact/contact/edge_pressure.h>
#include <rolling_contact/contact/operators.h>

#include <cmath>
#include <functional>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(operators)

namespace
{
  Trace line(const std::vector<double> &x)
  {
    Trace trace;
    trace.n_dimensions = 1;
    for (const double at : x)
      trace.nodes.push_back({{at, 0.}});
    for (unsigned int i = 0; i + 1 < x.size(); ++i)
      {
        Trace::Cell cell;
        cell.lower   = {{x[i], 0.}};
        cell.upper   = {{x[i + 1], 0.}};
        cell.corners = {{{i, 1.}}, {{i + 1, 1.}}};
        trace.cells.push_back(cell);
      }
    return trace;
  }

  std::vector<double> uniform(const unsigned int n, const double h)
  {
    std::vector<double> x(n);
    for (unsigned int i = 0; i < n; ++i)
      x[i] = h * (i - 3.3);
    return x;
  }

  /**
   * Sizes halved twice towards the middle, as a mesh refined at the rim.
   */
  std::vector<double> graded()
  {
    return {-8.,
            -7.,
            -6.,
            -5.,
            -4.5,
            -4.,
            -3.75,
            -3.5,
            -3.25,
            -3.,
            -2.5,
            -2.,
            -1.,
            0.,
            1.,
            2.};
  }

  /**
   * A surface in 3D: six by four unit squares, those with 2 <= x, y < 2 split
   * in four; the new nodes on the border of the refined part hang.
   */
  Trace surface_with_hanging_nodes()
  {
    Trace trace;
    trace.n_dimensions = 2;
    const auto node    = [&](const double x, const double y) {
      for (unsigned int i = 0; i < trace.nodes.size(); ++i)
        if (trace.nodes[i][0] == x && trace.nodes[i][1] == y)
          return i;
      trace.nodes.push_back({{x, y}});
      return static_cast<unsigned int>(trace.nodes.size() - 1);
    };
    const auto refined = [](const double x, const double y) {
      return x >= 2. && x < 4. && y < 2.;
    };
    const auto corner = [&](const double x, const double y) {
      const bool on_x = x == std::floor(x), on_y = y == std::floor(y);
      if (on_y && !on_x && y == 2.)
        return SparseRows::Row{{node(x - 0.5, y), 0.5},
                               {node(x + 0.5, y), 0.5}};
      if (on_x && !on_y && (x == 2. || x == 4.))
        return SparseRows::Row{{node(x, y - 0.5), 0.5},
                               {node(x, y + 0.5), 0.5}};
      return SparseRows::Row{{node(x, y), 1.}};
    };
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 6; ++i)
        {
          const double size = refined(i, j) ? 0.5 : 1.;
          for (double y = j; y < j + 1; y += size)
            for (double x = i; x < i + 1; x += size)
              {
                Trace::Cell cell;
                cell.lower   = {{x, y}};
                cell.upper   = {{x + size, y + size}};
                cell.corners = {corner(x, y),
                                corner(x + size, y),
                                corner(x, y + size),
                                corner(x + size, y + size)};
                trace.cells.push_back(cell);
              }
        }
    return trace;
  }

  using Field = std::function<double(double, double)>;

  /**
   * Largest difference between rows applied to a field and its x-derivative.
   */
  double error(const Trace             &trace,
               const SparseRows        &rows,
               const std::vector<bool> &defined,
               const Field             &field,
               const Field             &derivative)
  {
    std::vector<double> values;
    for (const auto &node : trace.nodes)
      values.push_back(field(node[0], node[1]));
    const std::vector<double> result  = rows.multiply(values);
    double                    largest = 0.;
    for (unsigned int i = 0; i < result.size(); ++i)
      if (defined[i])
        largest = std::max(largest,
                           std::abs(result[i] - derivative(trace.nodes[i][0],
                                                           trace.nodes[i][1])));
    return largest;
  }

  const Field constant = [](double, double) { return 1.; };
  const Field zero     = [](double, double) { return 0.; };
  const Field linear   = [](double x, double y) { return 3 * x - 2 * y + 1; };
  const Field linear_slope    = [](double, double) { return 3.; };
  const Field quadratic       = [](double x, double) { return x * x - x; };
  const Field quadratic_slope = [](double x, double) { return 2 * x - 1; };
} // namespace

BOOST_AUTO_TEST_CASE(upstream_rows_are_exact_on_linear_fields)
{
  for (const Trace &trace :
       {line(uniform(12, 0.7)), line(graded()), surface_with_hanging_nodes()})
    for (const int flow : {1, -1})
      {
        const UpstreamRows rows = upstream_rows(trace, flow);
        for (const SparseRows *order : {&rows.order_1, &rows.order_2})
          {
            BOOST_TEST(
              error(trace, *order, rows.defined, linear, linear_slope) < 1e-12);
            BOOST_TEST(error(trace, *order, rows.defined, constant, zero) <
                       1e-12);
          }
      }
}

BOOST_AUTO_TEST_CASE(second_order_rows_are_exact_on_quadratics_at_nodes)
{
  const Trace        trace = line(uniform(12, 0.7));
  const UpstreamRows rows  = upstream_rows(trace, 1);
  BOOST_TEST(
    error(trace, rows.order_2, rows.defined, quadratic, quadratic_slope) <
    1e-12);
  BOOST_TEST(
    error(trace, rows.order_1, rows.defined, quadratic, quadratic_slope) > 0.1);
}

BOOST_AUTO_TEST_CASE(rows_look_upstream_only)
{
  const Trace trace = line(graded());
  for (const int flow : {1, -1})
    {
      const UpstreamRows rows = upstream_rows(trace, flow);
      for (unsigned int i = 0; i < trace.nodes.size(); ++i)
        for (const auto &entry : rows.order_2[i])
          BOOST_TEST(flow * (trace.nodes[entry.first][0] - trace.nodes[i][0]) <=
                     0.);
    }
}

BOOST_AUTO_TEST_CASE(the_upstream_border_has_no_rows)
{
  const UpstreamRows forward = upstream_rows(line(uniform(8, 1.)), 1);
  BOOST_TEST(!forward.defined[0]);
  BOOST_TEST(!forward.defined[1]);
  BOOST_TEST(forward.defined[2]);
  const UpstreamRows backward = upstream_rows(line(uniform(8, 1.)), -1);
  BOOST_TEST(!backward.defined[7]);
  BOOST_TEST(!backward.defined[6]);
  BOOST_TEST(backward.defined[5]);
}

BOOST_AUTO_TEST_CASE(reversing_the_flow_mirrors_the_rows)
{
  std::vector<double> mirrored = graded();
  std::reverse(mirrored.begin(), mirrored.end());
  for (double &x : mirrored)
    x = -x;
  const UpstreamRows forward  = upstream_rows(line(graded()), 1);
  const UpstreamRows backward = upstream_rows(line(mirrored), -1);
  const unsigned int n        = mirrored.size();
  const DenseMatrix  A = forward.order_2.dense(), B = backward.order_2.dense();
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      BOOST_TEST(A(i, j) == -B(n - 1 - i, n - 1 - j));
}

BOOST_AUTO_TEST_CASE(galerkin_rows_are_exact_on_linear_fields)
{
  for (const Trace &trace : {line(graded()), surface_with_hanging_nodes()})
    {
      // lumped, the mean slope around a node: exact where it is constant
      for (const ContactMatrices kind :
           {ContactMatrices::consistent, ContactMatrices::lumped})
        BOOST_TEST(error(trace,
                         galerkin_rows(trace, kind),
                         std::vector<bool>(trace.nodes.size(), true),
                         linear,
                         linear_slope) < 1e-11);
    }
}

BOOST_AUTO_TEST_CASE(lines_end_where_the_next_point_is_no_node)
{
  // the line y = 0.5 exists at x = 2.5, 3 and 3.5 only; x = 2.5 and 3.5 hang on
  // the line y = 2
  const Trace trace = surface_with_hanging_nodes();
  for (const int flow : {1, -1})
    {
      const SlipOperator       slip_operator(trace,
                                       SlipOperatorKind::calibrated,
                                       ContactMatrices::lumped,
                                       flow);
      std::vector<std::size_t> lengths;
      for (const auto &line : slip_operator.lines())
        lengths.push_back(line.size());
      const std::vector<std::size_t> expected{9, 3, 9, 3, 7, 7, 7};
      BOOST_TEST(lengths == expected);
    }
}

BOOST_AUTO_TEST_CASE(runs_that_begin_inside_the_contact_have_no_leading_edge)
{
  const Trace        trace = surface_with_hanging_nodes();
  const SlipOperator slip_operator(trace,
                                   SlipOperatorKind::calibrated,
                                   ContactMatrices::lumped,
                                   1);
  const auto         runs_behind = [&](const double edge) {
    std::vector<double> pressure;
    for (const auto &node : trace.nodes)
      pressure.push_back(node[0] > edge && node[0] < 5.5 ? 1. : 0.);
    return touching_runs(slip_operator, pressure);
  };
  // the contact begins upstream of the refined part
  for (const TouchingRun &run : runs_behind(0.5))
    {
      const auto &first = trace.nodes[run.nodes[0]];
      BOOST_TEST(run.leading == (first[0] == 1.));
      BOOST_TEST(run.cut == (first[0] != 1.));
    }
  // and inside it, but for the lines that do not exist there
  for (const TouchingRun &run : runs_behind(2.2))
    {
      BOOST_TEST(run.leading);
      BOOST_TEST(run.cut == (run.nodes.size() == 3u &&
                             trace.nodes[run.nodes[0]][0] == 2.5));
    }
}

BOOST_AUTO_TEST_CASE(contact_matrices_carry_the_area)
{
  const Trace trace = surface_with_hanging_nodes();
  for (const ContactMatrices kind :
       {ContactMatrices::lumped, ContactMatrices::consistent})
    {
      const SparseRows    H    = contact_matrix(trace, kind, 2.);
      double              area = 0., moment = 0.;
      std::vector<double> x;
      for (const auto &node : trace.nodes)
        x.push_back(node[0]);
      for (const double value :
           H.multiply(std::vector<double>(trace.nodes.size(), 1.)))
        area += value;
      for (const double value : H.multiply(x))
        moment += value;
      BOOST_TEST(area == 48., boost::test_tools::tolerance(1e-13));
      BOOST_TEST(moment == 48. * 3., boost::test_tools::tolerance(1e-13));
    }
}

BOOST_AUTO_TEST_CASE(border_nodes_are_found_despite_hanging_nodes)
{
  const Trace             trace  = surface_with_hanging_nodes();
  const std::vector<bool> border = trace.border_nodes();
  for (unsigned int i = 0; i < trace.nodes.size(); ++i)
    {
      const auto &node = trace.nodes[i];
      const bool  expected =
        node[0] == 0. || node[0] == 6. || node[1] == 0. || node[1] == 4.;
      BOOST_TEST(border[i] == expected);
    }
}

BOOST_AUTO_TEST_SUITE_END()
