#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/numerics/vector_tools_boundary.h>

#include <boost/test/unit_test.hpp>

#include <rolling_contact/algebra/multigrid_solver.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/ranks.h>

#include <cmath>
#include <memory>

using namespace RollingContact;
using Vector = MultigridSolver::Vector;

BOOST_AUTO_TEST_SUITE(multigrid_solver)

namespace
{
  /**
   * Trilinos needs MPI.
   */
  struct MpiStart
  {
    MpiStart()
    {
      Ranks::start();
    }
  };

  /**
   * A bar of 4 x 0.75 x 0.75, clamped at x = 0 and refined twice at a corner,
   * hanging nodes eliminated; moduli of order one.
   */
  struct Bar : MpiStart
  {
    Bar()
    {
      dealii::GridGenerator::subdivided_hyper_rectangle(
        triangulation, {32, 6, 6}, {0., 0., 0.}, {4., 0.75, 0.75}, true);
      for (const double distance : {0.4, 0.2})
        {
          for (const auto &cell : triangulation.active_cell_iterators())
            if (cell->center().distance({4., 0.75, 0.75}) < distance)
              cell->set_refine_flag();
          triangulation.execute_coarsening_and_refinement();
        }
      dofs.distribute_dofs(element);
      dealii::DoFTools::make_hanging_node_constraints(dofs, constraints);
      BOOST_TEST(constraints.n_constraints() > 20u);
      dealii::DoFTools::make_zero_boundary_constraints(dofs, 0, constraints);
      constraints.close();
      assemble();
      make_modes();
    }

    void assemble()
    {
      dealii::DynamicSparsityPattern dynamic(dofs.n_dofs());
      dealii::DoFTools::make_sparsity_pattern(dofs,
                                              dynamic,
                                              constraints,
                                              false);
      pattern.copy_from(dynamic);
      serial.reinit(pattern);
      dealii::FEValues<3>                          values(element,
                                 dealii::QGauss<3>(2),
                                 dealii::update_gradients |
                                   dealii::update_JxW_values);
      const unsigned int                           n = element.dofs_per_cell;
      dealii::FullMatrix<double>                   cell_matrix(n);
      std::vector<dealii::types::global_dof_index> cell_dofs(n);
      const dealii::FEValuesExtractors::Vector     u(0);
      for (const auto &cell : dofs.active_cell_iterators())
        {
          values.reinit(cell);
          cell_matrix = 0.;
          for (const unsigned int q : values.quadrature_point_indices())
            for (unsigned int i = 0; i < n; ++i)
              for (unsigned int j = 0; j < n; ++j)
                cell_matrix(i, j) +=
                  (2 * values[u].symmetric_gradient(i, q) *
                     values[u].symmetric_gradient(j, q) +
                   values[u].divergence(i, q) * values[u].divergence(j, q)) *
                  values.JxW(q);
          cell->get_dof_indices(cell_dofs);
          constraints.distribute_local_to_global(cell_matrix,
                                                 cell_dofs,
                                                 serial);
        }
      matrix.reinit(dealii::complete_index_set(dofs.n_dofs()),
                    dealii::complete_index_set(dofs.n_dofs()),
                    serial,
                    MPI_COMM_WORLD);
    }

    void make_modes()
    {
      modes.assign(6, zero());
      for (const auto &cell : dofs.active_cell_iterators())
        for (const unsigned int v : cell->vertex_indices())
          {
            const auto first = cell->vertex_dof_index(v, 0);
            if (constraints.is_constrained(first))
              continue;
            const auto &x = cell->vertex(v);
            for (unsigned int d = 0; d < 3; ++d)
              {
                const unsigned int e = (d + 1) % 3, f = (d + 2) % 3;
                modes[d][first + d]     = 1.;
                modes[3 + d][first + e] = -x[f];
                modes[3 + d][first + f] = x[e];
              }
          }
    }

    Vector zero() const
    {
      return Vector(dealii::complete_index_set(dofs.n_dofs()), MPI_COMM_WORLD);
    }

    /**
     * A load on every unknown, of another shape for every @p number.
     */
    Vector load(const unsigned int number) const
    {
      Vector result = zero();
      for (unsigned int i = 0; i < dofs.n_dofs(); ++i)
        if (!constraints.is_constrained(i))
          result[i] = std::sin(1. + number + (number + 1) * 0.1 * i);
      return result;
    }

    dealii::Triangulation<3>               triangulation;
    dealii::FESystem<3>                    element{dealii::FE_Q<3>(1), 3};
    dealii::DoFHandler<3>                  dofs{triangulation};
    dealii::AffineConstraints<double>      constraints;
    dealii::SparsityPattern                pattern;
    dealii::SparseMatrix<double>           serial;
    dealii::TrilinosWrappers::SparseMatrix matrix;
    std::vector<Vector>                    modes;
  };

  double distance(const Vector &a, const Vector &b)
  {
    Vector difference(a);
    difference -= b;
    return difference.l2_norm() / b.l2_norm();
  }
} // namespace

BOOST_FIXTURE_TEST_CASE(solution_is_that_of_a_direct_solver, Bar)
{
  const MultigridSolver       solver(matrix, modes, 3);
  const Vector                b = load(0);
  std::vector<Vector>         x(1, zero());
  const auto                  report = solver.solve(x, {b}, 1e-13);
  dealii::SparseDirectUMFPACK direct;
  direct.initialize(serial);
  dealii::Vector<double> exact(dofs.n_dofs());
  for (unsigned int i = 0; i < dofs.n_dofs(); ++i)
    exact[i] = b[i];
  direct.solve(exact);
  Vector expected = zero();
  for (unsigned int i = 0; i < dofs.n_dofs(); ++i)
    expected[i] = exact[i];
  BOOST_TEST(distance(x[0], expected) < 1e-9);
  BOOST_TEST(report.residual <= 1e-13);
  BOOST_TEST(solver.memory_consumption() > 0u);
}

BOOST_FIXTURE_TEST_CASE(rigid_modes_save_iterations, Bar)
{
  const MultigridSolver with(matrix, modes, 3), without(matrix, {}, 3);
  std::vector<Vector>   x(1, zero()), y(1, zero());
  const unsigned int    few = with.solve(x, {load(0)}, 1e-10).iterations,
                     many   = without.solve(y, {load(0)}, 1e-10).iterations;
  BOOST_TEST_MESSAGE(few << " iterations with modes, " << many << " without");
  BOOST_TEST(few < 0.6 * many);
  BOOST_TEST(few < 25u);
}

BOOST_FIXTURE_TEST_CASE(several_right_hand_sides_are_solved_as_one_by_one, Bar)
{
  const MultigridSolver     solver(matrix, modes, 3);
  const std::vector<Vector> b{load(0), zero(), load(1), load(2)};
  std::vector<Vector>       x(4, zero());
  x[1] = load(3);
  solver.solve(x, b, 1e-11);
  BOOST_TEST(x[1].l2_norm() == 0.);
  for (const unsigned int i : {0, 2, 3})
    {
      std::vector<Vector> one(1, zero());
      solver.solve(one, {b[i]}, 1e-11);
      BOOST_TEST(distance(x[i], one[0]) < 1e-9);
    }
}

BOOST_FIXTURE_TEST_CASE(an_initial_guess_counts, Bar)
{
  const MultigridSolver solver(matrix, modes, 3);
  std::vector<Vector>   x(1, zero());
  solver.solve(x, {load(0)}, 1e-10);
  BOOST_TEST(solver.solve(x, {load(0)}, 1e-10).iterations == 0u);
}

BOOST_FIXTURE_TEST_CASE(rounding_ends_a_solve_and_is_reported, Bar)
{
  const MultigridSolver solver(matrix, modes, 3);
  std::vector<Vector>   x(1, zero());
  const double          residual = solver.solve(x, {load(0)}, 1e-20).residual;
  BOOST_TEST(residual < 1e-11);
  BOOST_TEST(residual > 1e-20);
}

BOOST_FIXTURE_TEST_CASE(no_convergence_is_an_error, Bar)
{
  // an unknown that nothing holds, and a force on it
  Vector     force = load(0);
  const auto dof =
    std::distance(force.begin(), std::max_element(force.begin(), force.end()));
  matrix.clear_row(dof, 0.);
  const MultigridSolver solver(matrix, modes, 3);
  std::vector<Vector>   x(1, zero());
  BOOST_CHECK_THROW(solver.solve(x, {force}, 1e-10), ConvergenceError);
}

BOOST_AUTO_TEST_SUITE_END()
