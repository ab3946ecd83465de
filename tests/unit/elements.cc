#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <boost/test/unit_test.hpp>

#include "../references/slender_bodies.h"

#include <rolling_contact/algebra/factorisation.h>
#include <rolling_contact/bodies/assembly.h>
#include <rolling_contact/bodies/body_matrices.h>

#include <cmath>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(elements)

namespace
{
  const Material steel{210e9, 0.3, 7850.};

  /**
   * A box of given numbers of cells with one corner in the origin, and its
   * matrices; nodes with x = 0 clamped on request.
   */
  template <int dim>
  struct Box
  {
    Box(const std::array<double, dim>       &size,
        const std::array<unsigned int, dim> &n_cells,
        const ElementKind                    elements,
        const double                         distortion = 0.,
        const bool                           clamped    = false,
        const Material                      &material   = steel)
      : element(dealii::FE_Q<dim>(1), dim)
      , elements(elements)
      , material(material)
    {
      dealii::Point<dim> corner;
      for (unsigned int d = 0; d < dim; ++d)
        corner[d] = size[d];
      dealii::GridGenerator::subdivided_hyper_rectangle(
        cells,
        std::vector<unsigned int>(n_cells.begin(), n_cells.end()),
        dealii::Point<dim>(),
        corner);
      if (distortion > 0.)
        dealii::GridTools::distort_random(distortion, cells, n_cells[0] > 1);
      dofs.reinit(cells);
      dofs.distribute_dofs(element);
      points.resize(dofs.n_dofs());
      dealii::DoFTools::map_dofs_to_support_points(dealii::MappingQ1<dim>(),
                                                   dofs,
                                                   points);
      for (unsigned int i = 0; i < dofs.n_dofs(); ++i)
        {
          const bool is_held = clamped && points[i][0] < 1e-9;
          unknown_of_dof.push_back(is_held ? -1 : n_unknowns++);
          if (is_held)
            constraints.add_line(i);
          else
            node_of_unknown.push_back(node_of_unknown.empty()
                                        ? 0
                                        : node_of_unknown.back() +
                                            (i % dim == 0));
        }
      constraints.close();
    }

    SymmetricSparseMatrix stiffness() const
    {
      return assemble_stiffness(Discretisation<dim>{dofs,
                                                    constraints,
                                                    unknown_of_dof,
                                                    n_unknowns,
                                                    material,
                                                    1.,
                                                    elements,
                                                    none});
    }

    /** Of given forces at the dofs, displacements at the dofs. */
    std::vector<double>
    solve(const std::function<double(const dealii::Point<dim> &, unsigned int)>
            &force) const
    {
      std::vector<double> b(n_unknowns, 0.), u(dofs.n_dofs(), 0.);
      for (unsigned int i = 0; i < dofs.n_dofs(); ++i)
        if (unknown_of_dof[i] >= 0)
          b[unknown_of_dof[i]] = force(points[i], i % dim);
      Factorisation factor(stiffness(), node_of_unknown);
      factor.factorise();
      const auto x = factor.solve(b);
      for (unsigned int i = 0; i < dofs.n_dofs(); ++i)
        if (unknown_of_dof[i] >= 0)
          u[i] = x[unknown_of_dof[i]];
      return u;
    }

    dealii::Triangulation<dim>        cells;
    dealii::FESystem<dim>             element;
    dealii::DoFHandler<dim>           dofs;
    dealii::AffineConstraints<double> constraints;
    ElementKind                       elements;
    Material                          material;
    Supports<dim>                     none;
    std::vector<dealii::Point<dim>>   points;
    std::vector<int>                  unknown_of_dof;
    std::vector<unsigned int>         node_of_unknown;
    std::size_t                       n_unknowns = 0;
  };

  template <int dim>
  std::array<unsigned int, dim> equal(const unsigned int n)
  {
    std::array<unsigned int, dim> result;
    result.fill(n);
    return result;
  }

  template <int dim>
  std::array<double, dim> unit_size()
  {
    std::array<double, dim> result;
    result.fill(1.);
    return result;
  }

  template <int dim>
  bool is_inside(const dealii::Point<dim> &point)
  {
    for (unsigned int d = 0; d < dim; ++d)
      if (point[d] < 1e-9 || point[d] > 1 - 1e-9)
        return false;
    return true;
  }

  /**
   * Linear displacements on distorted cells: no force inside, and exactly the
   * strain energy of the constant strain.
   */
  template <int dim>
  void check_patch(const ElementKind kind)
  {
    const Box<dim>         box(unit_size<dim>(), equal<dim>(3), kind, 0.25);
    const auto             K = box.stiffness();
    std::vector<double>    u(K.size()), f(K.size());
    dealii::Tensor<2, dim> gradient;
    for (unsigned int a = 0; a < dim; ++a)
      for (unsigned int b = 0; b < dim; ++b)
        gradient[a][b] = 1e-3 * std::sin(1. + 3 * a + 7 * b);
    for (std::size_t i = 0; i < u.size(); ++i)
      u[i] = gradient[i % dim] * box.points[i];
    K.multiply(u, f);
    double largest = 0., inside = 0.;
    for (std::size_t i = 0; i < u.size(); ++i)
      {
        largest = std::max(largest, std::abs(f[i]));
        if (is_inside(box.points[i]))
          inside = std::max(inside, std::abs(f[i]));
      }
    BOOST_TEST(inside < 1e-12 * largest);
    const dealii::SymmetricTensor<2, dim> strain = symmetrize(gradient);
    const double                          G      = steel.shear_modulus(),
                 lambda = steel.bulk_modulus() - 2 * G / 3,
                 energy = 2 * G * (strain * strain) +
                          lambda * std::pow(trace(strain), 2);
    BOOST_TEST(std::abs(dot(u, f) / energy - 1) < 1e-12);
  }

  /**
   * Eigenvalues of one distorted cell: as many zeros as rigid motions, the rest
   * positive.
   */
  template <int dim>
  void check_spectrum(const ElementKind kind)
  {
    const Box<dim> box(unit_size<dim>(), equal<dim>(1), kind, 0.15);
    const auto     K = box.stiffness();
    dealii::LAPACKFullMatrix<double> matrix(K.size(), K.size());
    for (std::size_t j = 0; j < K.size(); ++j)
      for (auto k = K.column_starts[j]; k < K.column_starts[j + 1]; ++k)
        matrix(K.row_indices[k], j) = matrix(j, K.row_indices[k]) = K.values[k];
    dealii::Vector<double>     values(K.size());
    dealii::FullMatrix<double> vectors;
    matrix.compute_eigenvalues_symmetric(-1e30, 1e30, 1e-6, values, vectors);
    std::vector<double> sorted(values.begin(), values.end());
    std::sort(sorted.begin(), sorted.end());
    const unsigned int n_rigid = dim * (dim + 1) / 2;
    for (unsigned int i = 0; i < n_rigid; ++i)
      BOOST_TEST(std::abs(sorted[i]) < 1e-12 * sorted.back());
    BOOST_TEST(sorted[n_rigid] > 1e-3 * sorted.back());
  }

  /**
   * Deflection of a clamped bar under a force at its end, over that of beam
   * theory with shear: one cell through the depth, cells twice as long as deep.
   */
  template <int dim>
  double bending_ratio(const ElementKind kind)
  {
    const double                  length = 2., depth = 0.1;
    std::array<double, dim>       size{{length, depth}};
    std::array<unsigned int, dim> n_cells{{10, 1}};
    size.back()       = depth;
    n_cells.back()    = 1;
    Material material = steel;
    if (dim == 3) // the beam's ends may contract, the bar's clamped one may not
      material.poisson_ratio = 0.;
    const Box<dim> box(size, n_cells, kind, 0., true, material);
    const double   force = 1e3;
    const auto     u     = box.solve([&](const auto &at, const unsigned int c) {
      return c == dim - 1 && at[0] > length - 1e-9 ? force / (dim == 2 ? 2 : 4)
                                                           : 0.;
    });
    double         mean = 0., n = 0.;
    for (std::size_t i = 0; i < u.size(); ++i)
      if (i % dim == dim - 1 && box.points[i][0] > length - 1e-9)
        mean += u[i], ++n;
    References::Bar bar;
    bar.length        = length;
    bar.width         = dim == 2 ? 1. : depth;
    bar.depth         = depth;
    bar.shear_modulus = material.shear_modulus();
    bar.young_modulus = material.young_modulus;
    if (dim == 2) // plane strain
      bar.young_modulus /= 1 - std::pow(material.poisson_ratio, 2);
    return mean / n / (force * cantilever_compliance(bar));
  }

  /**
   * Twist of a bar of square section, clamped and free to warp at the other
   * end, over that of Saint-Venant; away from the clamped end.
   */
  double torsion_ratio(const ElementKind kind, const unsigned int n_across)
  {
    const double length = 1., side = 0.1;
    const Box<3> box(
      {{length, side, side}}, {{20, n_across, n_across}}, kind, 0., true);
    // shear at the end that makes a moment of known size
    double     moment = 0.;
    const auto arm    = [&](const dealii::Point<3> &at, const unsigned int c) {
      const double y = at[1] - side / 2, z = at[2] - side / 2;
      return at[0] < length - 1e-9 || c == 0 ? 0. : (c == 1 ? -z : y);
    };
    for (std::size_t i = 0; i < box.points.size(); ++i)
      moment += std::pow(arm(box.points[i], i % 3), 2);
    const auto u = box.solve(arm);
    // rotation of the outline of the section at x, from its nodes
    const auto turn = [&](const double x) {
      double sum = 0., weight = 0.;
      for (std::size_t i = 0; i < box.points.size(); ++i)
        if (std::abs(box.points[i][0] - x) < 1e-9 && i % 3 != 0)
          {
            const double y = box.points[i][1] - side / 2,
                         z = box.points[i][2] - side / 2,
                         a = i % 3 == 1 ? -z : y;
            sum += a * u[i];
            weight += a * a;
          }
      return sum / weight;
    };
    References::Bar bar;
    bar.width = bar.depth = side;
    bar.shear_modulus     = steel.shear_modulus();
    return (turn(0.7) - turn(0.3)) / 0.4 /
           (moment / References::torsional_stiffness(bar));
  }
} // namespace

BOOST_AUTO_TEST_CASE(constant_strain_is_exact_on_distorted_cells)
{
  for (const ElementKind kind : {ElementKind::b_bar, ElementKind::enhanced})
    {
      check_patch<2>(kind);
      check_patch<3>(kind);
    }
}

BOOST_AUTO_TEST_CASE(only_rigid_motions_cost_no_energy)
{
  for (const ElementKind kind : {ElementKind::b_bar, ElementKind::enhanced})
    {
      check_spectrum<2>(kind);
      check_spectrum<3>(kind);
    }
}

BOOST_AUTO_TEST_CASE(one_enhanced_element_through_the_depth_bends)
{
  BOOST_TEST_MESSAGE("2D: B-bar " << bending_ratio<2>(ElementKind::b_bar)
                                  << ", enhanced "
                                  << bending_ratio<2>(ElementKind::enhanced));
  BOOST_TEST_MESSAGE("3D: B-bar " << bending_ratio<3>(ElementKind::b_bar)
                                  << ", enhanced "
                                  << bending_ratio<3>(ElementKind::enhanced));
  BOOST_TEST(std::abs(bending_ratio<2>(ElementKind::enhanced) - 1) < 0.01);
  BOOST_TEST(std::abs(bending_ratio<3>(ElementKind::enhanced) - 1) < 0.01);
  BOOST_TEST(bending_ratio<2>(ElementKind::b_bar) < 0.8);
  BOOST_TEST(bending_ratio<3>(ElementKind::b_bar) < 0.8);
}

BOOST_AUTO_TEST_CASE(a_bar_twists_as_saint_venant_says)
{
  for (const unsigned int n : {2, 4, 8})
    BOOST_TEST_MESSAGE("twist, " << n << " across: B-bar "
                                 << torsion_ratio(ElementKind::b_bar, n)
                                 << ", enhanced "
                                 << torsion_ratio(ElementKind::enhanced, n));
  // of second order
  const double coarse = torsion_ratio(ElementKind::enhanced, 4),
               fine   = torsion_ratio(ElementKind::enhanced, 8);
  BOOST_TEST(std::abs(fine - 1) < 0.015);
  BOOST_TEST(std::abs((4 * fine - coarse) / 3 - 1) < 0.003);
}

BOOST_AUTO_TEST_SUITE_END()
