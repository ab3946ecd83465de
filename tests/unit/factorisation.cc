#include <boost/test/unit_test.hpp>

#include <rolling_contact/algebra/dissection.h>
#include <rolling_contact/algebra/factorisation.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/contact/surface_coupling.h>

#include <cmath>
#include <future>
#include <map>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(factorisation)

namespace
{
  struct Problem
  {
    SymmetricSparseMatrix     matrix;
    std::vector<unsigned int> node_of_unknown;
  };

  /**
   * Coupled springs on a grid of @p n^3 nodes with two unknowns each: positive
   * definite, with the sparsity of a 3D mesh.
   */
  Problem grid(const int n, const double shift = 0.1)
  {
    Problem    problem;
    const auto node = [n](const int i, const int j, const int k) {
      return (k * n + j) * n + i;
    };
    std::vector<std::map<int, double>> columns(2 * n * n * n);
    const auto add = [&](const int row, const int column, const double value) {
      columns[std::min(row, column)][std::max(row, column)] += value;
    };
    for (int k = 0; k < n; ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
          {
            const int here = node(i, j, k);
            for (int c = 0; c < 2; ++c)
              add(2 * here + c, 2 * here + c, shift + 0.01 * c);
            add(2 * here + 1, 2 * here, 0.02);
            for (const int there : {i + 1 < n ? node(i + 1, j, k) : -1,
                                    j + 1 < n ? node(i, j + 1, k) : -1,
                                    k + 1 < n ? node(i, j, k + 1) : -1})
              if (there >= 0)
                for (int c = 0; c < 2; ++c)
                  {
                    const double stiffness = 1. + 0.1 * c + 0.01 * (here % 7);
                    add(2 * here + c, 2 * here + c, stiffness);
                    add(2 * there + c, 2 * there + c, stiffness);
                    add(2 * there + c, 2 * here + c, -stiffness);
                    add(2 * there + 1 - c, 2 * here + c, 0.);
                  }
          }
    problem.matrix.column_starts.push_back(0);
    for (std::size_t j = 0; j < columns.size(); ++j)
      {
        for (const auto &entry : columns[j])
          {
            problem.matrix.row_indices.push_back(entry.first);
            problem.matrix.values.push_back(entry.second);
          }
        problem.matrix.column_starts.push_back(problem.matrix.values.size());
        problem.node_of_unknown.push_back(j / 2);
      }
    return problem;
  }

  std::vector<std::size_t> surface_unknowns(const int n)
  {
    std::vector<std::size_t> unknowns;
    for (int c = 0; c < 2; ++c)
      for (int i = n * n * (n - 1) + 3; i < n * n * n - 2; ++i)
        unknowns.push_back(2 * i + c);
    return unknowns;
  }
} // namespace

BOOST_AUTO_TEST_CASE(order_does_not_depend_on_other_threads)
{
  const Problem problem = grid(14);
  const auto    order   = [&]() {
    return dissection_order(problem.matrix, problem.node_of_unknown);
  };
  const auto alone = order();
  for (int k = 0; k < 10; ++k)
    {
      auto       other = std::async(std::launch::async, order);
      const auto own   = order();
      BOOST_CHECK(own == alone);
      BOOST_CHECK(other.get() == alone);
    }
}

BOOST_AUTO_TEST_CASE(two_columns_at_once_are_those_one_by_one)
{
  using Columns = std::vector<std::vector<double>>;
  for (const int n : {1, 2, 3, 5, 6, 7}) // fronts of all widths and remainders
    {
      const Problem problem = grid(n);
      Factorisation factor(problem.matrix, problem.node_of_unknown);
      factor.factorise();
      Columns b(2, std::vector<double>(problem.matrix.size())), z(2), x(2),
        z_alone(2), x_alone(2), product(2, b[0]);
      for (std::size_t i = 0; i < b[0].size(); ++i)
        {
          b[0][i] = std::sin(1. + i);
          b[1][i] = 1e3 * std::cos(2. * i);
        }
      factor.solve_forward({&b[0], &b[1]}, {&z[0], &z[1]});
      for (const int r : {0, 1})
        factor.solve_forward(b[r], z_alone[r]);
      BOOST_CHECK(z == z_alone);
      factor.solve_backward({&z[0], &z[1]}, {&x[0], &x[1]});
      for (const int r : {0, 1})
        factor.solve_backward(z_alone[r], x_alone[r]);
      BOOST_CHECK(x == x_alone);

      problem.matrix.multiply(x[0], product[0], x[1], product[1]);
      for (const int r : {0, 1})
        {
          std::vector<double> alone(b[r].size());
          problem.matrix.multiply(x[r], alone);
          BOOST_CHECK(alone == product[r]);
          for (std::size_t i = 0; i < alone.size(); ++i)
            BOOST_TEST(std::abs(alone[i] - b[r][i]) < (r ? 1e-9 : 1e-12));
        }
      BOOST_CHECK_THROW(factor.solve_forward({&b[0], &b[0], &b[0]},
                                             {&z[0], &z[1], &x[0]}),
                        std::logic_error);
    }
}

BOOST_AUTO_TEST_CASE(solve_satisfies_the_equations)
{
  const Problem problem = grid(6);
  Factorisation factor(problem.matrix, problem.node_of_unknown);
  factor.factorise();
  const std::size_t   n = problem.matrix.size();
  std::vector<double> b(n);
  for (std::size_t i = 0; i < n; ++i)
    b[i] = std::sin(1. + i);
  const std::vector<double> x = factor.solve(b);
  std::vector<double>       residual(b);
  for (std::size_t j = 0; j < n; ++j)
    for (auto k = problem.matrix.column_starts[j];
         k < problem.matrix.column_starts[j + 1];
         ++k)
      {
        const auto i = problem.matrix.row_indices[k];
        residual[i] -= problem.matrix.values[k] * x[j];
        if (i != static_cast<std::int64_t>(j))
          residual[j] -= problem.matrix.values[k] * x[i];
      }
  BOOST_TEST(norm(residual) < 1e-12 * norm(b));
}

BOOST_AUTO_TEST_CASE(condensation_equals_plain_solves)
{
  const Problem problem = grid(9);
  Factorisation factor(problem.matrix, problem.node_of_unknown);
  factor.factorise();
  const auto        unknowns = surface_unknowns(9);
  const DenseMatrix W        = factor.condense(unknowns);
  double            largest = 0., difference = 0.;
  for (std::size_t j = 0; j < unknowns.size(); j += 5)
    {
      std::vector<double> unit(problem.matrix.size(), 0.);
      unit[unknowns[j]]           = 1.;
      const std::vector<double> x = factor.solve(unit);
      for (std::size_t i = 0; i < unknowns.size(); ++i)
        {
          largest    = std::max(largest, std::abs(x[unknowns[i]]));
          difference = std::max(difference, std::abs(x[unknowns[i]] - W(i, j)));
          BOOST_REQUIRE_EQUAL(W(i, j), W(j, i));
        }
    }
  BOOST_TEST(difference < 1e-12 * largest);
}

/** Loads of several unknowns each, in different parts of the tree, one of them
 * twice in a row and one row empty: P W P^T of the unknowns' own. */
BOOST_AUTO_TEST_CASE(loads_are_condensed_as_sums_of_unknowns)
{
  const Problem problem = grid(9);
  Factorisation factor(problem.matrix, problem.node_of_unknown);
  factor.factorise();
  const auto        unknowns = surface_unknowns(9);
  const std::size_t n        = unknowns.size();
  SparseRows        P(7), loads(7);
  for (unsigned int k = 0; k < 6; ++k)
    for (unsigned int i = 0; i < 4; ++i)
      {
        const std::size_t of = (11 * k + (i < 3 ? i : n - 1 - k)) % n;
        P.add(k, of, 0.3 + 0.2 * i - 0.5 * (k == i));
        loads.add(k, unknowns[of], 0.3 + 0.2 * i - 0.5 * (k == i));
      }
  CondensedColumns  Y;
  const DenseMatrix W      = factor.condense(unknowns),
                    PWP    = SurfaceCoupling(P, n).to_interface(W),
                    direct = factor.condense(loads, &Y);
  double largest = 0., difference = 0.;
  for (std::size_t i = 0; i < 7; ++i)
    for (std::size_t j = 0; j < 7; ++j)
      {
        largest    = std::max(largest, std::abs(PWP(i, j)));
        difference = std::max(difference, std::abs(direct(i, j) - PWP(i, j)));
      }
  BOOST_TEST(largest > 0.);
  BOOST_TEST(difference < 1e-12 * largest);
  BOOST_TEST(direct(6, 6) == 0.);
  BOOST_TEST(Y.column_order.size() == 7u);
}

BOOST_AUTO_TEST_CASE(kept_columns_give_the_same_compliance)
{
  const Problem problem = grid(7);
  Factorisation factor(problem.matrix, problem.node_of_unknown);
  factor.factorise();
  const auto        unknowns = surface_unknowns(7);
  CondensedColumns  Y;
  const DenseMatrix W = factor.condense(unknowns, &Y);
  DenseMatrix product = DenseMatrix::Zero(unknowns.size(), unknowns.size());
  for (const auto &block : Y.blocks)
    for (std::int64_t j = 0; j < block.n_columns; ++j)
      for (std::int64_t i = 0; i < block.n_columns; ++i)
        for (std::int64_t k = 0; k < block.n_rows; ++k)
          product(Y.column_order[block.first_column + i],
                  Y.column_order[block.first_column + j]) +=
            block.values[k + i * block.n_rows] *
            block.values[k + j * block.n_rows];
  for (std::size_t j = 0; j < unknowns.size(); ++j)
    for (std::size_t i = 0; i < unknowns.size(); ++i)
      BOOST_TEST(std::abs(product(i, j) - W(i, j)) < 1e-12 * W(0, 0));
  BOOST_TEST(Y.memory_consumption() > 0u);
}

BOOST_AUTO_TEST_CASE(an_indefinite_matrix_is_refused)
{
  const Problem problem = grid(4, -1.);
  Factorisation factor(problem.matrix, problem.node_of_unknown);
  BOOST_CHECK_THROW(factor.factorise(), ConvergenceError);
}

BOOST_AUTO_TEST_SUITE_END()
