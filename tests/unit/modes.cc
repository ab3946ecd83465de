#include <boost/test/unit_test.hpp>

#include "springs.h"

#include <rolling_contact/algebra/block_lanczos.h>
#include <rolling_contact/algebra/indefinite_factor.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/modes/frequency_response.h>
#include <rolling_contact/modes/modal_damping.h>
#include <rolling_contact/modes/structural_modes.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace RollingContact;
using namespace SpringStructures;

BOOST_AUTO_TEST_SUITE(modes)

namespace
{
  StructuralModes
  modes_of(const Springs &springs, const double largest, const double shift)
  {
    ModeControls controls;
    controls.cut_off = frequency(largest);
    return structural_modes(springs.K,
                            springs.M,
                            springs.factor(shift),
                            shift,
                            springs.nodes,
                            controls);
  }
} // namespace

/** In a cube eigenvalues are up to six times there. */
BOOST_AUTO_TEST_CASE(all_modes_of_a_cube_are_found_as_often_as_they_are_there)
{
  const Springs springs(9, 3, true);
  const auto    exact   = springs.eigenvalues();
  const double  largest = gap_after(exact, 150);
  const auto    modes   = modes_of(springs, largest, 0.);
  const auto    n =
    std::upper_bound(exact.begin(), exact.end(), largest) - exact.begin();
  BOOST_TEST_REQUIRE(modes.size() == static_cast<std::size_t>(n));
  for (std::size_t j = 0; j < modes.size(); ++j)
    {
      BOOST_TEST(modes.eigenvalue(j) == exact[j],
                 boost::test_tools::tolerance(1e-11));
      BOOST_TEST(modes.residuals[j] < 1e-8);
    }
  BOOST_TEST(modes.orthogonality < 1e-12);
  BOOST_TEST(*modes.counted == modes.size());
}

BOOST_AUTO_TEST_CASE(a_space_that_is_exhausted_gives_all_modes)
{
  const Springs springs(11, 1, true);
  const auto    exact = springs.eigenvalues();
  const auto    modes = modes_of(springs, 2 * exact.back(), 0.);
  BOOST_TEST_REQUIRE(modes.size() == exact.size());
  for (std::size_t j = 0; j < exact.size(); ++j)
    BOOST_TEST(modes.eigenvalue(j) == exact[j],
               boost::test_tools::tolerance(1e-10));
}

BOOST_AUTO_TEST_CASE(a_free_body_moves_rigidly_at_no_frequency)
{
  const Springs springs(7, 3, false);
  const auto    exact = springs.eigenvalues();
  const auto    modes = modes_of(springs, gap_after(exact, 30), 0.05);
  BOOST_TEST(modes.frequencies[0] < 1e-4 * modes.frequencies[1]);
  BOOST_TEST(modes.residuals[0] < 1e-8);
  for (std::size_t j = 1; j < modes.size(); ++j)
    BOOST_TEST(modes.eigenvalue(j) == exact[j],
               boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(the_inertia_counts_eigenvalues_below)
{
  const Springs springs(6, 3, true);
  const auto    exact = springs.eigenvalues();
  for (const double value : {0.01, 2.3, 7.7, 13.1, 30.})
    {
      const auto n =
        std::upper_bound(exact.begin(), exact.end(), value) - exact.begin();
      BOOST_TEST(n_negative_eigenvalues(
                   linear_combination(1., springs.K, -value, springs.M),
                   springs.nodes) == static_cast<std::size_t>(n));
    }
  // zeros on the diagonal
  SymmetricSparseMatrix swap;
  swap.column_starts = {0, 2, 3};
  swap.row_indices   = {0, 1, 1};
  swap.values        = {0., 1., 0.};
  BOOST_TEST(n_negative_eigenvalues(swap, {0, 1}) == 1u);
}

BOOST_AUTO_TEST_CASE(modes_that_are_missed_are_noticed)
{
  // the count is that of twice the stiffness: half of the modes
  const Springs springs(5, 2, true);
  auto          softer = springs.K;
  for (double &value : softer.values)
    value *= 0.5;
  ModeControls controls;
  controls.cut_off = frequency(4.);
  BOOST_CHECK_THROW(
    structural_modes(
      softer, springs.M, springs.factor(0.), 0., springs.nodes, controls),
    ConvergenceError);
}

BOOST_AUTO_TEST_CASE(blocks_are_solved_like_columns)
{
  const Springs springs(6, 3, true);
  const auto    factor = springs.factor(0.);
  DenseMatrix   block  = DenseMatrix::Zero(springs.K.size(), 5);
  for (Eigen::Index i = 0; i < block.size(); ++i)
    block.data()[i] = std::sin(3. * i);
  DenseMatrix solved = block;
  factor.solve(solved);
  for (Eigen::Index j = 0; j < block.cols(); ++j)
    {
      const auto x = factor.solve(
        std::vector<double>(block.data() + j * block.rows(),
                            block.data() + (j + 1) * block.rows()));
      double largest = 0.;
      for (const double value : x)
        largest = std::max(largest, std::abs(value));
      for (std::size_t i = 0; i < x.size(); ++i)
        BOOST_TEST(std::abs(solved(i, j) - x[i]) <= 1e-13 * largest);
    }
}

namespace
{
  using Complex = std::complex<double>;

  /** Two masses between three springs, the first and the last of which lose
   * energy, and a damper at the second mass: by Cramer's rule. */
  std::array<Complex, 3> two_masses(const double omega)
  {
    const Complex i(0., 1.);
    const Complex a = 3. + 0.3 * i - omega * omega * 2., b = -1.,
                  d   = 5. + i * 0.2 + i * omega * 0.4 - omega * omega * 1.,
                  det = a * d - b * b;
    return {{d / det, -b / det, a / det}};
  }

  VibratingStructure structure_of_two_masses()
  {
    VibratingStructure structure;
    structure.K.column_starts = {0, 2, 3};
    structure.K.row_indices   = {0, 1, 1};
    structure.K.values        = {3., -1., 5.};
    structure.M               = diagonal_matrix({2., 1.});
    structure.H               = diagonal_matrix({0.3, 0.2});
    structure.C               = diagonal_matrix({0., 0.4});
    structure.node_of_unknown = {0, 1};
    return structure;
  }
} // namespace

BOOST_AUTO_TEST_CASE(two_masses_vibrate_as_cramers_rule_has_it)
{
  const VibratingStructure               structure = structure_of_two_masses();
  const std::vector<std::vector<double>> loads{{1., 0.}, {0., 1.}};
  Factorisation factor(structure.K, structure.node_of_unknown);
  factor.factorise();
  ModeControls controls;
  controls.cut_off = 10.;
  const auto modes = structural_modes(
    structure.K, structure.M, factor, 0., structure.node_of_unknown, controls);
  BOOST_TEST_REQUIRE(modes.size() == 2u);
  const FrequencyResponse response(
    structure, factor, 0., modes, {0., 0.}, loads);
  for (const double f : {0.01, 0.2, 0.35, 1.})
    {
      const auto exact  = two_masses(2 * pi * f);
      const auto modal  = response.receptances(f),
                 direct = direct_receptances(structure, loads, f);
      for (const auto &found : {modal, direct})
        {
          BOOST_TEST(std::abs(found(0, 0) - exact[0]) < 1e-12);
          BOOST_TEST(std::abs(found(1, 0) - exact[1]) < 1e-12);
          BOOST_TEST(std::abs(found(0, 1) - exact[1]) < 1e-12);
          BOOST_TEST(std::abs(found(1, 1) - exact[2]) < 1e-12);
        }
    }
}

BOOST_AUTO_TEST_CASE(modal_damping_limits_a_resonance)
{
  const Springs       springs(40, 1, true);
  const auto          factor = springs.factor(0.);
  const auto          modes  = modes_of(springs, 1., 0.);
  std::vector<double> ratios(modes.size(), 0.01), load(springs.K.size(), 0.);
  load[3] = 1.;
  const VibratingStructure structure{
    springs.K, springs.M, {}, {}, springs.nodes};
  const FrequencyResponse response(
    structure, factor, 0., modes, ratios, {load});
  // alone at its resonance a mode has phi^2 / (2 i zeta omega^2)
  const double phi = modes.shapes(3, 0);
  const auto   at  = response.receptances(modes.frequencies[0])(0, 0);
  BOOST_TEST(-at.imag() == phi * phi / (0.02 * modes.eigenvalue(0)),
             boost::test_tools::tolerance(1e-3));
  BOOST_TEST(total_damping(modes, ratios, {}, {})[0] == 0.01);
}

/** What modes leave out shrinks with the fourth power of the frequency over
 * the cut-off once its compliance and its mass are there. */
BOOST_AUTO_TEST_CASE(what_modes_leave_out_is_of_fourth_order)
{
  const Springs       springs(60, 1, true);
  const auto          factor = springs.factor(0.);
  std::vector<double> load(springs.K.size(), 0.);
  load[7] = load[8] = 0.5;
  const VibratingStructure structure{
    springs.K, springs.M, {}, {}, springs.nodes};
  std::vector<double> errors;
  const double        f = frequency(0.0931);
  for (const double ratio : {2., 4.})
    {
      const auto modes = modes_of(springs, 0.0931 * ratio * ratio, 0.);
      const FrequencyResponse response(structure,
                                       factor,
                                       0.,
                                       modes,
                                       std::vector<double>(modes.size(), 0.),
                                       {load});
      const auto direct = direct_receptances(structure, {load}, f)(0, 0);
      errors.push_back(std::abs(response.receptances(f)(0, 0) - direct) /
                       std::abs(direct));
    }
  BOOST_TEST(errors[0] < 3e-3);
  BOOST_TEST(errors[1] < errors[0] / 10);
}

/** The compliance that modes leave out loses energy as they do: that of each
 * mode left out, 1 / (lambda + i (eta lambda + omega c) - omega^2). */
BOOST_AUTO_TEST_CASE(what_modes_leave_out_loses_energy_too)
{
  const Springs       springs(60, 1, true);
  const auto          factor = springs.factor(0.);
  std::vector<double> load(springs.K.size(), 0.);
  load[7]        = 1.;
  const auto all = modes_of(springs, 9., 0.), kept = modes_of(springs, 1., 0.);
  const double f = frequency(0.05), omega = 2 * pi * f;
  BOOST_TEST_REQUIRE(all.size() == springs.K.size());
  BOOST_TEST_REQUIRE(kept.size() < all.size() / 2);
  for (const auto &[eta, c] : {std::pair(0.02, 0.), std::pair(0., 0.1)})
    {
      VibratingStructure structure{
        springs.K, springs.M, springs.K, springs.M, springs.nodes};
      for (double &value : structure.H.values)
        value *= eta;
      for (double &value : structure.C.values)
        value *= c;
      Complex rest = FrequencyResponse(structure,
                                       factor,
                                       0.,
                                       kept,
                                       std::vector<double>(kept.size(), 0.),
                                       {load})
                       .receptances(f)(0, 0),
              expected = 0.;
      for (std::size_t j = 0; j < all.size(); ++j)
        {
          const double  lambda = all.eigenvalue(j), phi = all.shapes(7, j);
          const Complex part =
            phi * phi /
            Complex(lambda - omega * omega, eta * lambda + omega * c);
          (j < kept.size() ? rest : expected) +=
            (j < kept.size() ? -1. : 1.) * part;
        }
      BOOST_TEST(expected.imag() < 0.);
      BOOST_TEST(rest.real() == expected.real(),
                 boost::test_tools::tolerance(0.01));
      BOOST_TEST(rest.imag() == expected.imag(),
                 boost::test_tools::tolerance(0.15));
    }
}

BOOST_AUTO_TEST_CASE(losses_become_damping_ratios)
{
  const Springs springs(20, 1, true);
  const auto    modes = modes_of(springs, 3., 0.);
  auto          H = springs.K, C = springs.M;
  for (double &value : H.values)
    value *= 0.02;
  for (double &value : C.values)
    value *= 0.1;
  const auto ratios =
    total_damping(modes, std::vector<double>(modes.size(), 1e-3), H, C);
  for (std::size_t j = 0; j < modes.size(); ++j)
    BOOST_TEST(ratios[j] == 1e-3 + 0.01 + 0.05 / std::sqrt(modes.eigenvalue(j)),
               boost::test_tools::tolerance(1e-9));
  // as a matrix, with what couples the modes
  const DenseMatrix nothing = in_modes(modes, {}),
                    all     = modal_damping_matrix(modes,
                                               in_modes(modes, H),
                                               in_modes(modes, C)),
                    none    = modal_damping_matrix(modes, nothing, nothing);
  BOOST_TEST(none.norm() == 0.);
  for (std::size_t j = 0; j < modes.size(); ++j)
    BOOST_TEST(all(j, j) ==
                 2 * (ratios[j] - 1e-3) * std::sqrt(modes.eigenvalue(j)),
               boost::test_tools::tolerance(1e-9));
  // a loss in one spring couples what K and M do not
  SymmetricSparseMatrix one = springs.K;
  std::fill(one.values.begin(), one.values.end(), 0.);
  one.values[one.column_starts[3]] = 2.;
  const DenseMatrix coupled =
    modal_damping_matrix(modes, in_modes(modes, one), nothing);
  const auto place = [&](const std::size_t j) {
    return modes.shapes(3, j) / std::pow(modes.eigenvalue(j), 0.25);
  };
  BOOST_TEST(coupled(1, 2) == 2. * place(1) * place(2),
             boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_SUITE_END()
