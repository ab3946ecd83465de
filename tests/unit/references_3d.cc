#include <boost/test/unit_test.hpp>

#include "reference_checks.h"

#include <rolling_contact/references/fastsim.h>
#include <rolling_contact/references/hertz_ellipse.h>
#include <rolling_contact/references/kalker.h>
#include <rolling_contact/references/shen_hedrick_elkins.h>

#include <fstream>
#include <sstream>

using namespace RollingContact;
using namespace RollingContact::References;
using boost::test_tools::tolerance;

namespace
{
  const double pi    = std::acos(-1.);
  const double steel = 210e9;
} // namespace

BOOST_AUTO_TEST_SUITE(references)

BOOST_AUTO_TEST_SUITE(ellipse)

BOOST_AUTO_TEST_CASE(circle)
{
  const HertzEllipse contact = hertz_ellipse(1000, 2, 2, 1e11);
  const double       radius  = std::cbrt(0.75 * 1000 * 0.25 / 1e11);
  BOOST_TEST(contact.half_width_x == radius, tolerance(1e-14));
  BOOST_TEST(contact.half_width_y == radius, tolerance(1e-14));
  BOOST_TEST(contact.approach == radius * radius / 0.25, tolerance(1e-14));
  const HertzEllipse almost = hertz_ellipse(1000, 2, 2 * (1 + 1e-12), 1e11);
  BOOST_TEST(almost.approach == contact.approach, tolerance(1e-11));
  BOOST_TEST(almost.half_width_x > almost.half_width_y);
}

// CONTACT user guide: a sphere (mm, N), and the Eurosprinter wheel with
// a/b = 1/2, approach 0.07652 mm, maximal pressure 640.7 MPa.
BOOST_AUTO_TEST_CASE(published_values)
{
  const HertzEllipse sphere = hertz_ellipse(9.1954, 0.01, 0.01, 200 / 0.58);
  BOOST_TEST(sphere.half_width_x == 1, tolerance(1e-4));
  BOOST_TEST(sphere.max_pressure == 4.3905, tolerance(1e-4));
  BOOST_TEST(sphere.approach == 0.02, tolerance(1e-4));
  const HertzEllipse wheel =
    hertz_ellipse(106700, 0.0008, 0.0002814173138273489, 82000 / 0.72);
  BOOST_TEST(wheel.half_width_x / wheel.half_width_y == 0.5, tolerance(1e-9));
  BOOST_TEST(wheel.approach == 0.07652, tolerance(1e-4));
  BOOST_TEST(wheel.max_pressure == 640.7, tolerance(1e-3));
}

// independent computation, 1000 N, A = 1/m, E* = 100 GPa: B/A, a, b, p0,
// approach
BOOST_AUTO_TEST_CASE(values)
{
  const double rows[][5] = {{1.5,
                             0.0016582910949074258,
                             0.001265771578924738,
                             227470602.43536222,
                             5.153195890469705e-06},
                            {10,
                             0.002103981124351739,
                             0.00046760879339029834,
                             485307359.8743129,
                             6.613316408187708e-06},
                            {1000,
                             0.0028014211635059103,
                             4.1274775565060014e-05,
                             4129317347.6671576,
                             9.551567633284666e-06}};
  for (const auto &row : rows)
    {
      const HertzEllipse contact = hertz_ellipse(1000, 1, row[0], 1e11);
      BOOST_TEST(contact.half_width_x == row[1], tolerance(1e-10));
      BOOST_TEST(contact.half_width_y == row[2], tolerance(1e-10));
      BOOST_TEST(contact.max_pressure == row[3], tolerance(1e-10));
      BOOST_TEST(contact.approach == row[4], tolerance(1e-10));
    }
}

// b << a: B/A = (a/b)^2/(ln(4 a/b) - 1), a line contact of width b with the
// pressure E* b B, and approach p0 b ln(4 a/b)/E*
BOOST_AUTO_TEST_CASE(slender_limit)
{
  for (const double slenderness : {1e3, 1e5})
    {
      const double log_term        = std::log(4 * slenderness);
      const double curvature_ratio = slenderness * slenderness / (log_term - 1);
      const HertzEllipse along     = hertz_ellipse(1, 1, curvature_ratio, 1e11);
      BOOST_TEST(along.half_width_x / along.half_width_y == slenderness,
                 tolerance(10 / slenderness / slenderness + 1e-13));
      BOOST_TEST(along.max_pressure ==
                   1e11 * along.half_width_y * curvature_ratio,
                 tolerance(10 / slenderness / slenderness + 1e-13));
      BOOST_TEST(along.approach ==
                   along.max_pressure / 1e11 * along.half_width_y * log_term,
                 tolerance(10 / slenderness / slenderness + 1e-13));
      const HertzEllipse across = hertz_ellipse(1, curvature_ratio, 1, 1e11);
      BOOST_TEST(across.half_width_y == along.half_width_x, tolerance(1e-12));
      BOOST_TEST(across.half_width_x == along.half_width_y, tolerance(1e-12));
      BOOST_TEST(across.approach == along.approach, tolerance(1e-12));
    }
}

BOOST_AUTO_TEST_CASE(pressure_carries_the_load)
{
  const HertzEllipse contact = hertz_ellipse(36059, 1 / 0.46, 1 / 0.3, 1.2e11);
  BOOST_TEST(contact.load() == 36059, tolerance(1e-13));
  const double length = contact.half_width_x;
  const double width  = contact.half_width_y;
  const double load   = integrate(
    [&](const double x) {
      const double edge = width * std::sqrt(1 - std::pow(x / length, 2));
      return integrate([&](const double y) { return contact.pressure(x, y); },
                       -edge,
                       edge,
                       200);
    },
    -length,
    length,
    200);
  BOOST_TEST(load == 36059, tolerance(1e-4));
  BOOST_TEST(contact.pressure(0.8 * length, 0.7 * width) == 0);
  BOOST_TEST(hertz_ellipse(0, 1, 2, 1e11).approach == 0);
  BOOST_TEST(hertz_ellipse(0, 1, 2, 1e11).pressure(0, 0) == 0);
}

BOOST_AUTO_TEST_CASE(inverse)
{
  for (const double curvature : {1e-6, 0.3, 1., 4e5})
    for (const double load : {1e-3, 1e5})
      {
        const double approach =
          hertz_ellipse(load, 1, curvature, 1e11).approach;
        BOOST_TEST(load_of_hertz_ellipse(approach, 1, curvature, 1e11) == load,
                   tolerance(1e-13));
      }
  BOOST_TEST(load_of_hertz_ellipse(-1e-5, 1, 1, 1e11) == 0);
  CHECK_INPUT_ERROR(hertz_ellipse(1, 1, 0, 1e11),
                    "Curvature of the gap along y is 0 1/m");
  CHECK_INPUT_ERROR(hertz_ellipse(-1, 1, 1, 1e11), "Load is -1 N");
}

BOOST_AUTO_TEST_SUITE_END()

namespace
{
  const CombinedElasticity paper_steel{steel / 2.6, 0.3};

  // the load inferred for the paper's three-dimensional case
  const double paper_load = 36059;

  HertzEllipse paper_ellipse()
  {
    return hertz_ellipse(paper_load, 1 / 0.46, 1 / 0.3, steel / 1.82);
  }

  void check_coefficients(const double axis_ratio,
                          const double nu,
                          const double C11,
                          const double C22,
                          const double C23,
                          const double C33,
                          const double accuracy)
  {
    const KalkerCoefficients kalker = kalker_coefficients(axis_ratio, nu);
    BOOST_TEST(kalker.C11 == C11, tolerance(accuracy));
    BOOST_TEST(kalker.C22 == C22, tolerance(accuracy));
    BOOST_TEST(kalker.C23 == C23, tolerance(accuracy));
    BOOST_TEST(kalker.C33 == C33, tolerance(accuracy));
  }
} // namespace

BOOST_AUTO_TEST_SUITE(kalker)

// Kalker 1990, table E3
BOOST_AUTO_TEST_CASE(table_entries)
{
  check_coefficients(0.1, 0, 2.51, 2.51, 0.334, 6.42, 1e-12);
  check_coefficients(0.1, 0.5, 4.85, 2.53, 0.731, 11.7, 1e-12);
  check_coefficients(0.5, 0.25, 3.62, 3.01, 0.929, 1.93, 1e-12);
  check_coefficients(1, 0.25, 4.12, 3.67, 1.47, 1.19, 1e-12);
  check_coefficients(1 / 0.6, 0.5, 5.80, 5.04, 2.50, 0.751, 1e-12);
  check_coefficients(10, 0.25, 11.7, 12.8, 14.6, 0.526, 1e-12);
}

// all 240 numbers, from a transcription of its own
BOOST_AUTO_TEST_CASE(the_whole_table)
{
  std::ifstream file(TEST_DATA "/kalker_table_e3.csv");
  unsigned int  n_numbers = 0;
  for (std::string line; std::getline(file, line);)
    {
      if (line.empty() || line[0] == '#' || line[0] == 'a')
        continue;
      std::istringstream  row(line);
      std::vector<double> cells;
      for (std::string cell; std::getline(row, cell, ',');)
        cells.push_back(cell.empty() ? 0. : std::stod(cell));
      BOOST_REQUIRE_EQUAL(cells.size(), 7u);
      std::vector<double> ratios = {cells[0] > 0. ? cells[0] : 1 / cells[1]};
      if (ratios[0] == 1.) // where both halves of the table end
        ratios.push_back(1 + 1e-12);
      for (const double ratio : ratios)
        {
          BOOST_TEST_CONTEXT("a/b = " << ratio << ", nu = " << cells[2])
          check_coefficients(
            ratio, cells[2], cells[3], cells[4], cells[5], cells[6], 1e-11);
          n_numbers += 4;
        }
    }
  BOOST_TEST(n_numbers == 240u);
}

// independent computation
BOOST_AUTO_TEST_CASE(between_entries)
{
  check_coefficients(0.55,
                     0.28,
                     3.7830904777839627,
                     3.0927478905058803,
                     0.9941755695782144,
                     1.828220551856283,
                     1e-12);
  check_coefficients(1.7,
                     0.4,
                     5.38233679892705,
                     4.864931148693786,
                     2.435431486251067,
                     0.7972249825525507,
                     1e-12);
  check_coefficients(0.05,
                     0.3,
                     3.524858714674771,
                     2.4674011002723395,
                     0.4116194536127008,
                     17.624293573373855,
                     1e-12);
  check_coefficients(20,
                     0.3,
                     18.434761745916152,
                     21.78828101279743,
                     35.11417175366163,
                     0.48665568668067294,
                     1e-12);
}

BOOST_AUTO_TEST_CASE(limits)
{
  // strips that roll as line contacts: pi^2/(4 (1 - nu))
  BOOST_TEST(kalker_coefficients(1e-4, 0.3).C11 == pi * pi / 2.8,
             tolerance(1e-14));
  // the asymptotes meet the table within 7 % (C33 of long patches: 17 %)
  for (const double nu : {0., 0.25, 0.3, 0.38, 0.5})
    for (const double ratio : {0.1, 10.})
      {
        const double             outside = ratio < 1 ? 0.0999999 : 10.00001;
        const KalkerCoefficients kalker  = kalker_coefficients(outside, nu);
        const KalkerCoefficients table   = kalker_coefficients(ratio, nu);
        BOOST_TEST(kalker.C11 == table.C11, tolerance(0.046));
        BOOST_TEST(kalker.C22 == table.C22, tolerance(0.032));
        BOOST_TEST(kalker.C23 == table.C23, tolerance(0.065));
        BOOST_TEST(kalker.C33 == table.C33, tolerance(ratio < 1 ? 0.06 : 0.17));
      }
  CHECK_INPUT_ERROR(kalker_coefficients(1, 0.6), "Poisson ratio is 0.6:");
  CHECK_INPUT_ERROR(kalker_coefficients(0, 0.3),
                    "Ratio of the semi-axes is 0:");
}

BOOST_AUTO_TEST_CASE(paper_coefficients)
{
  const HertzEllipse contact = paper_ellipse();
  BOOST_TEST(contact.half_width_x == 4.046e-3, tolerance(1e-4));
  BOOST_TEST(contact.half_width_y == 3.043e-3, tolerance(2e-4));
  BOOST_TEST(contact.max_pressure == 1398e6, tolerance(2e-4));
  BOOST_TEST(contact.approach == 66.46e-6, tolerance(1e-4));
  const KalkerCoefficients kalker =
    kalker_coefficients(contact.half_width_x / contact.half_width_y, 0.3);
  BOOST_TEST(kalker.C11 == 4.623, tolerance(1e-4));
  BOOST_TEST(kalker.C22 == 4.175, tolerance(2e-4));
  BOOST_TEST(kalker.C23 == 1.885, tolerance(1e-4));
}

// CONTACT user guide, Eurosprinter: creepage 1e-5 gives 247.0 N (mm, N)
BOOST_AUTO_TEST_CASE(published_force)
{
  const HertzEllipse wheel =
    hertz_ellipse(106700, 0.0008, 0.0002814173138273489, 82000 / 0.72);
  const CreepForces forces =
    kalker_forces({1e-5, 0, 0}, wheel, CombinedElasticity{82000, 0.28});
  BOOST_TEST(forces.x == -247.0, tolerance(0.02));
}

// independent computation, in Kalker's convention (flow in -x)
BOOST_AUTO_TEST_CASE(force_values)
{
  const CreepForces forces =
    kalker_forces({-8e-4, 1.2e-3, 0.4}, paper_ellipse(), paper_steel, -1);
  BOOST_TEST(forces.x == 3678.001446595203, tolerance(1e-9));
  BOOST_TEST(forces.y == -7613.724710573188, tolerance(1e-9));
  BOOST_TEST(forces.spin_moment == 3.063608860249342, tolerance(1e-9));
}

// Reflection x -> -x: creepage x, spin, force x and moment change sign.
BOOST_AUTO_TEST_CASE(forces_are_mirrored_by_the_flow_direction)
{
  const CreepForces forward =
    kalker_forces({-8e-4, 1.2e-3, 0.4}, paper_ellipse(), paper_steel);
  const CreepForces backward =
    kalker_forces({8e-4, 1.2e-3, -0.4}, paper_ellipse(), paper_steel, -1);
  BOOST_TEST(forward.x == -backward.x);
  BOOST_TEST(forward.y == backward.y);
  BOOST_TEST(forward.spin_moment == -backward.spin_moment);
}

// Flow in +x, stick: y + spin X + du/dX = 0 and u = 0 at the leading edge, so
// positive spin moves the wheel's surface to u > 0, which takes a force > 0.
BOOST_AUTO_TEST_CASE(signs)
{
  const CreepForces from_spin =
    kalker_forces({0, 0, 0.1}, paper_ellipse(), paper_steel);
  BOOST_TEST(from_spin.y > 0);
  BOOST_TEST(from_spin.spin_moment < 0);
  const CreepForces from_slip =
    kalker_forces({1e-4, 1e-4, 0}, paper_ellipse(), paper_steel);
  BOOST_TEST(from_slip.x < 0);
  BOOST_TEST(from_slip.y < 0);
  BOOST_TEST(kalker_forces({1, 1, 1}, HertzEllipse{}, paper_steel).y == 0);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(saturated_force)

// The table for the paper's three-dimensional case (4 digits printed), then
// independent computation in N.
BOOST_AUTO_TEST_CASE(paper_table)
{
  const double rows[][3] = {{0.001, 0.3368, 3643.6462500520515},
                            {0.002, 0.5880, 6360.708383300089},
                            {0.003, 0.7661, 8287.133309133631},
                            {0.004, 0.8836, 9558.8679369422},
                            {0.005, 0.9532, 10311.859176115318},
                            {0.007, 0.9989, 10805.399126113281},
                            {0.01, 1, 0.3 * paper_load}};
  for (const auto &row : rows)
    {
      const TangentialForce force =
        shen_hedrick_elkins({0, row[0], 0}, paper_ellipse(), paper_steel, 0.3);
      BOOST_TEST(force.x == 0);
      BOOST_TEST(std::abs(-force.y / (0.3 * paper_load) - row[1]) < 6e-5);
      BOOST_TEST(force.y == -row[2], tolerance(1e-9));
    }
}

// CONTACT's full solution for the Eurosprinter wheel, creepage against
// |T|/(mu N), mu = 0.33: the law stays within 0.039 of it.
BOOST_AUTO_TEST_CASE(near_the_full_solution)
{
  const double       rows[][2] = {{4e-4, 0.2588},
                                  {8e-4, 0.4742},
                                  {1.2e-3, 0.6482},
                                  {1.6e-3, 0.7831},
                                  {2e-3, 0.8816},
                                  {2.4e-3, 0.9467},
                                  {2.8e-3, 0.9832},
                                  {3.2e-3, 0.9976}};
  const HertzEllipse wheel =
    hertz_ellipse(106700, 0.0008, 0.0002814173138273489, 82000 / 0.72);
  for (const auto &row : rows)
    {
      const TangentialForce force =
        shen_hedrick_elkins({row[0], 0, 0}, wheel, {82000, 0.28}, 0.33);
      BOOST_TEST(std::abs(-force.x / (0.33 * 106700) - row[1]) < 0.039);
    }
}

BOOST_AUTO_TEST_CASE(combined_creepages)
{
  // independent computation, in Kalker's convention (flow in -x)
  const TangentialForce force = shen_hedrick_elkins(
    {-8e-4, 1.2e-3, 0.4}, paper_ellipse(), paper_steel, 0.3, -1);
  BOOST_TEST(force.x == 2802.935704482571, tolerance(1e-9));
  BOOST_TEST(force.y == -5802.276357210896, tolerance(1e-9));

  // full sliding keeps the direction of the linear force
  const Creepages   large{0.03, -0.05, 1};
  const CreepForces linear = kalker_forces(large, paper_ellipse(), paper_steel);
  const TangentialForce bound =
    shen_hedrick_elkins(large, paper_ellipse(), paper_steel, 0.3);
  BOOST_TEST(std::hypot(bound.x, bound.y) == 0.3 * paper_load,
             tolerance(1e-12));
  BOOST_TEST(bound.x / bound.y == linear.x / linear.y, tolerance(1e-12));
  BOOST_TEST(bound.x < 0);
}

BOOST_AUTO_TEST_CASE(limits)
{
  const Creepages   small{1e-9, -2e-9, 1e-9};
  const CreepForces linear = kalker_forces(small, paper_ellipse(), paper_steel);
  const TangentialForce force =
    shen_hedrick_elkins(small, paper_ellipse(), paper_steel, 0.3);
  BOOST_TEST(force.x == linear.x, tolerance(1e-5));
  BOOST_TEST(force.y == linear.y, tolerance(1e-5));
  for (const double friction : {0., 0.3})
    {
      const TangentialForce none =
        shen_hedrick_elkins({}, paper_ellipse(), paper_steel, friction);
      BOOST_TEST(none.x == 0);
      BOOST_TEST(none.y == 0);
    }
  const TangentialForce frictionless =
    shen_hedrick_elkins({0.01, 0, 0}, paper_ellipse(), paper_steel, 0);
  BOOST_TEST(frictionless.x == 0);
  CHECK_INPUT_ERROR(
    shen_hedrick_elkins(small, paper_ellipse(), paper_steel, -1),
    "Friction coefficient is -1:");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(bed_of_springs)

// An independent program with 800 and 1600 steps, extrapolated, in Kalker's
// convention (flow in -x); of mu N.
BOOST_AUTO_TEST_CASE(fastsim_values)
{
  const double rows[][5] = {{0, 0.003, 0, 0, -0.75727},
                            {0.002, 0, 0, -0.62586, 0},
                            {0.001, 0.0015, 0.6, -0.27998, -0.72442},
                            {0, 0, 0.8, 0, -0.45932},
                            {0, 0.002, -0.5, 0, -0.30488}};
  for (const auto &row : rows)
    {
      const TangentialForce force = fastsim(
        {row[0], row[1], row[2]}, paper_ellipse(), paper_steel, 0.3, -1);
      BOOST_TEST(std::abs(force.x / (0.3 * paper_load) - row[3]) < 4e-4);
      BOOST_TEST(std::abs(force.y / (0.3 * paper_load) - row[4]) < 4e-4);
    }
}

// what its springs are made for
BOOST_AUTO_TEST_CASE(fastsim_of_small_creepages_is_linear_theory)
{
  for (const int flow : {1, -1})
    {
      const Creepages       small{1e-9, -2e-9, 3e-7};
      const TangentialForce force =
        fastsim(small, paper_ellipse(), paper_steel, 0.3, flow, 400);
      const CreepForces linear =
        kalker_forces(small, paper_ellipse(), paper_steel, flow);
      BOOST_TEST(force.x == linear.x, tolerance(1e-4));
      BOOST_TEST(force.y == linear.y, tolerance(1e-4));
    }
}

BOOST_AUTO_TEST_CASE(fastsim_limits)
{
  const TangentialForce full =
    fastsim({0.03, -0.04, 0}, paper_ellipse(), paper_steel, 0.3);
  // the direction is off by the ratio of L1 and L2, the size is not
  BOOST_TEST(std::hypot(full.x, full.y) == 0.3 * paper_load, tolerance(1e-3));
  const TangentialForce coarse =
    fastsim({1e-3, 1e-3, 0.5}, paper_ellipse(), paper_steel, 0.3);
  const TangentialForce fine =
    fastsim({1e-3, 1e-3, 0.5}, paper_ellipse(), paper_steel, 0.3, 1, 1600);
  BOOST_TEST(std::abs(coarse.y - fine.y) < 4e-4 * 0.3 * paper_load);
  BOOST_TEST(fastsim({1, 1, 1}, HertzEllipse{}, paper_steel, 0.3).y == 0);
  CHECK_INPUT_ERROR(fastsim({}, paper_ellipse(), paper_steel, -1),
                    "Friction coefficient is -1:");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
