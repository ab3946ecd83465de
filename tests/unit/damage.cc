#include <boost/test/unit_test.hpp>

#include "reference_checks.h"

#include <rolling_contact/base/constants.h>
#include <rolling_contact/damage/line_depths.h>
#include <rolling_contact/damage/rcf_indices.h>
#include <rolling_contact/damage/shakedown.h>
#include <rolling_contact/references/carter.h>
#include <rolling_contact/references/line_contact_stress.h>

#include <array>
#include <numeric>

using namespace RollingContact;
using boost::test_tools::tolerance;

BOOST_AUTO_TEST_SUITE(damage)

using namespace RollingContact::Damage;

namespace
{
  const double p0 = 1000e6, half_width = 6e-3, radius = 0.46, mu = 0.3;

  /**
   * Nodes of a line at the middles of equal lengths, under Carter's tractions
   * and slip at a speed.
   */
  NodeLine carter_line(const double       creepage,
                       const double       speed,
                       const unsigned int n_nodes)
  {
    const References::HertzLine contact{half_width, p0};
    const References::Carter    carter(contact, radius, mu, creepage);
    const double                length = 2 * half_width / n_nodes;
    NodeLine                    line;
    for (unsigned int i = 0; i < n_nodes; ++i)
      {
        const double x = -half_width + (i + 0.5) * length;
        RubbingNode  node;
        node.pressure      = contact.pressure(x);
        node.slip          = std::abs(carter.slip(x));
        node.sliding_speed = node.slip * speed;
        node.power         = -carter.traction(x) * carter.slip(x);
        line.nodes.push_back(node);
        line.lengths.push_back(length);
      }
    return line;
  }

  const WearLaw &law(const std::string &name)
  {
    for (const WearLaw &one : wear_laws())
      if (one.name == name)
        return one;
    throw std::runtime_error(name);
  }
} // namespace

BOOST_AUTO_TEST_SUITE(laws)

// both borders belong to severe wear; 2.4 GPa is 0.8 H
BOOST_AUTO_TEST_CASE(chart_of_archard)
{
  const double gentle = 1e9, border = 2.4e9, hard = 2.41e9;
  BOOST_TEST(archard_coefficient(0.19, gentle) == 5e-4);
  BOOST_TEST(archard_coefficient(0.2, gentle) == 35e-4);
  BOOST_TEST(archard_coefficient(0.7, border) == 35e-4);
  BOOST_TEST(archard_coefficient(0.71, gentle) == 5e-4);
  for (const double speed : {0.1, 0.5, 1.})
    BOOST_TEST(archard_coefficient(speed, hard) == 350e-4);

  DamageParameters lowest, highest;
  lowest.archard_scatter  = ArchardScatter::lowest;
  highest.archard_scatter = ArchardScatter::highest;
  const std::vector<std::array<double, 4>> printed{{0.1, gentle, 1e-4, 10e-4},
                                                   {0.5, gentle, 30e-4, 40e-4},
                                                   {0.9, gentle, 1e-4, 10e-4},
                                                   {0.5, hard, 300e-4, 400e-4}};
  for (const auto &[v, p, least, most] : printed)
    {
      BOOST_TEST(archard_coefficient(v, p, lowest) == least);
      BOOST_TEST(archard_coefficient(v, p, highest) == most);
    }
  DamageParameters soft;
  soft.hardness = 1.2e9;
  BOOST_TEST(archard_coefficient(0.1, gentle, soft) == 350e-4);
  soft.archard_coefficient = 1e-7;
  for (const double speed : {0., 0.1, 0.5})
    BOOST_TEST(archard_coefficient(speed, hard, soft) == 1e-7);
  for (const WearLaw &law : wear_laws())
    {
      BOOST_TEST(law.needs_speed({}) == (law.name == "archard"));
      BOOST_TEST(!law.needs_speed(soft));
    }
}

BOOST_AUTO_TEST_CASE(depth_of_archard_at_a_node)
{
  // 5e-4 * 0.9e9 * 0.002 / 3e9
  const RubbingNode node{0.9e9, 0., 0.002, 0.04};
  BOOST_TEST(archard_rate(node) == 3e-7, tolerance(1e-14));
  BOOST_TEST(archard_rate({-1e6, 0., 0.002, 0.04}) == 0.);
}

BOOST_AUTO_TEST_CASE(usfd_at_its_borders)
{
  const double unit = 1e-3; // ug per m and mm^2, in kg/m^2 per m
  for (const auto branch : {CatastrophicBranch::continuous,
                            CatastrophicBranch::code,
                            CatastrophicBranch::florence})
    {
      BOOST_TEST(usfd_mass_loss(-1e6, branch) == 0.);
      BOOST_TEST(usfd_mass_loss(4e6, branch) == 21.2 * unit, tolerance(1e-14));
      BOOST_TEST(usfd_mass_loss(10.3999e6, branch) == 55.11947 * unit,
                 tolerance(1e-12));
      BOOST_TEST(usfd_mass_loss(10.4e6, branch) == 55 * unit, tolerance(1e-14));
      BOOST_TEST(usfd_mass_loss(77.1e6, branch) == 55 * unit, tolerance(1e-14));
    }
  const auto at = [&](const double x, const CatastrophicBranch branch) {
    return usfd_mass_loss(x * 1e6, branch) / unit;
  };
  BOOST_TEST(at(77.2, CatastrophicBranch::continuous) == 55., tolerance(1e-14));
  BOOST_TEST(at(77.2, CatastrophicBranch::code) == 0.);
  BOOST_TEST(at(77.2, CatastrophicBranch::florence) == 4778.68,
             tolerance(1e-14));
  BOOST_TEST(at(100., CatastrophicBranch::continuous) == 1466.32,
             tolerance(1e-13));
  BOOST_TEST(at(100., CatastrophicBranch::code) == 1411.3, tolerance(1e-13));
  BOOST_TEST(at(100., CatastrophicBranch::florence) == 6190., tolerance(1e-13));

  DamageParameters parameters;
  parameters.catastrophic_branch = CatastrophicBranch::florence;
  BOOST_TEST(usfd_rate({0., 100e6, 0., 0.}, parameters) == 6.19 / 7850,
             tolerance(1e-13));
}

// K is the first branch of the other law: 5.3 ug/(m mm^2) for 1 N/mm^2
BOOST_AUTO_TEST_CASE(t_gamma_is_the_first_branch_of_usfd)
{
  const RubbingNode node{0., 3e6, 0., 0.};
  BOOST_TEST(t_gamma_rate(node) == usfd_rate(node), tolerance(1e-14));
  BOOST_TEST(t_gamma_rate(node) == 5.3e-9 * 3e6 / 7850, tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(british_rail_research)
{
  const double D      = 0.92; // 920 mm
  const auto   mm2_km = [&](const double E) {
    return brr_worn_area(E, D) / 1e-9 * 920;
  };
  BOOST_TEST(mm2_km(40) == 10., tolerance(1e-13));
  BOOST_TEST(mm2_km(100 * (1 - 1e-12)) == 25., tolerance(1e-11));
  BOOST_TEST(mm2_km(100) == 25., tolerance(1e-13));
  BOOST_TEST(mm2_km(105) == 25., tolerance(1e-13));
  BOOST_TEST(mm2_km(199.999) == 25., tolerance(1e-13));
  BOOST_TEST(mm2_km(200) == 84., tolerance(1e-13)); // the jump
  BOOST_TEST(mm2_km(300) == 203., tolerance(1e-13));
  BOOST_TEST(brr_worn_area(100, D) / mm2_per_km == 25. / 920, tolerance(1e-13));
  CHECK_INPUT_ERROR(brr_worn_area(-1, D), "Energy per metre rolled is -1 J/m");
  CHECK_INPUT_ERROR(brr_worn_area(1, 0), "Wheel diameter is 0 m");
}

// two laws of different origin and units agree to a sixth in mild wear:
// 0.25 mm^3/(km N) against K/(pi rho)
BOOST_AUTO_TEST_CASE(british_rail_research_against_t_gamma)
{
  const double energy = 80., wheel_radius = 0.46,
               rail_area = 5.3e-9 * energy / 7850,
               t_gamma   = wheel_depth_per_metre(rail_area, wheel_radius),
               brr       = brr_worn_area(energy, 2 * wheel_radius);
  BOOST_TEST(t_gamma / brr == 5.3e-9 / (7850 * pi * 0.25e-12),
             tolerance(1e-13));
  BOOST_TEST(std::abs(t_gamma / brr - 1) < 1. / 6);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(lines)

// rigid sliding: depth = k xi/H integral p dx, here without elastic slip
BOOST_AUTO_TEST_CASE(full_sliding)
{
  const double                creepage = 0.5, speed = 0.1; // 0.05 m/s: mild
  NodeLine                    line;
  const References::HertzLine contact{half_width, p0};
  const unsigned int          n_nodes = 2000;
  for (unsigned int i = 0; i < n_nodes; ++i)
    {
      const double angle = pi * (i + 0.5) / n_nodes,
                   x = -half_width * std::cos(angle), p = contact.pressure(x);
      line.nodes.push_back({p, mu * p * creepage, creepage, creepage * speed});
      line.lengths.push_back(half_width * std::sin(angle) * pi / n_nodes);
    }
  const double load = contact.load_per_length();
  BOOST_TEST(depth_per_passage(line, law("archard")) ==
               5e-4 * creepage / 3e9 * load,
             tolerance(1e-10));
  BOOST_TEST(depth_per_passage(line, law("t-gamma")) ==
               5.3e-9 * mu * load * creepage / 7850,
             tolerance(1e-10));
  // far beyond saturation the elastic slip of Carter cancels over the line
  const NodeLine carter = carter_line(creepage, speed, 4000);
  BOOST_TEST(depth_per_passage(carter, law("archard")) ==
               5e-4 * creepage / 3e9 * load,
             tolerance(1e-4));
}

// E = mu N xi (1 - (1 - xi/xi_s)^2), and worn mass = K E
BOOST_AUTO_TEST_CASE(carter)
{
  const double saturation = mu * half_width / radius,
               load       = pi / 2 * half_width * p0;
  for (const double part : {0.1, 0.3, 0.6, 0.9, 1., 1.5})
    {
      const double creepage = part * saturation, stick = std::max(0., 1 - part),
                   energy = mu * load * creepage * (1 - stick * stick);
      for (const double sign : {1., -1.})
        {
          const NodeLine line = carter_line(sign * creepage, 20., 400);
          double         e    = 0.;
          for (std::size_t i = 0; i < line.nodes.size(); ++i)
            e += line.nodes[i].power * line.lengths[i];
          BOOST_TEST(e == energy, tolerance(5e-3));
          const double depth = depth_per_passage(line, law("t-gamma"));
          BOOST_TEST(7850 * depth == 5.3e-9 * e, tolerance(1e-14));
          BOOST_TEST(7850 * depth == 5.3e-9 * energy, tolerance(5e-3));
        }
    }
}

BOOST_AUTO_TEST_CASE(scatter_of_archard_is_a_factor)
{
  const NodeLine   line = carter_line(0.002, 20., 100); // 0.04 m/s: mild
  DamageParameters lowest, highest;
  lowest.archard_scatter  = ArchardScatter::lowest;
  highest.archard_scatter = ArchardScatter::highest;
  const double low        = depth_per_passage(line, law("archard"), lowest);
  BOOST_TEST(low > 0.);
  BOOST_TEST(depth_per_passage(line, law("archard"), highest) == 10 * low,
             tolerance(1e-13));
}

BOOST_AUTO_TEST_CASE(wheel_and_errors)
{
  BOOST_TEST(wheel_depth_per_metre(3e-9, 0.5) == 3e-9 / pi, tolerance(1e-14));
  CHECK_INPUT_ERROR(wheel_depth_per_metre(1, 0), "Rolling radius is 0 m");
  NodeLine line = carter_line(0.002, 20., 10);
  line.lengths.pop_back();
  CHECK_INPUT_ERROR(depth_per_passage(line, law("usfd")),
                    "Number of lengths is 9: it must be 10");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(fatigue)

BOOST_AUTO_TEST_CASE(indices_of_a_patch)
{
  const double a = 6e-3, b = 4e-3, load = 80e3, k = 300e6,
               peak = 3 * load / (2 * pi * a * b), mu_u = 0.35;
  BOOST_TEST(utilised_friction(28e3, load) == mu_u, tolerance(1e-14));
  BOOST_TEST(load_factor(peak, k) == peak / k, tolerance(1e-14));
  const double index = surface_fatigue_index(mu_u, peak, k);
  BOOST_TEST(index == mu_u - 2 * pi * a * b * k / (3 * load), tolerance(1e-13));
  BOOST_TEST(surface_fatigue_index_of_area(mu_u, load, pi * a * b, k) == index,
             tolerance(1e-13));
  // on the surface branch it is zero
  BOOST_TEST(std::abs(surface_fatigue_index(mu_u,
                                            k * shakedown_limits(mu_u).surface,
                                            k)) < 1e-14);
  BOOST_TEST(subsurface_fatigue_index(0., load, pi * a * b) ==
               load / (4 * pi * a * b),
             tolerance(1e-14));
  BOOST_TEST(subsurface_fatigue_index(mu_u, load, pi * a * b) ==
               peak / 6 * 1.1225,
             tolerance(1e-13));
  CHECK_INPUT_ERROR(utilised_friction(1, 0), "Normal force is 0 N");
  CHECK_INPUT_ERROR(surface_fatigue_index(0.3, 1e9, 0),
                    "Shear yield stress is 0 Pa");
  CHECK_INPUT_ERROR(surface_fatigue_index_of_area(0.3, 1e3, 0, k),
                    "Area is 0 m^2");
}

// all nodes of a patch that slides have q = mu p: the worst has the patch's
BOOST_AUTO_TEST_CASE(index_of_a_node)
{
  BOOST_TEST(nodal_surface_index(0.35e9, 1e9, 300e6) ==
               surface_fatigue_index(0.35, 1e9, 300e6),
             tolerance(1e-13));
  BOOST_TEST(nodal_surface_index(0.2e9, 1e9, 300e6) == -0.1, tolerance(1e-13));
  BOOST_TEST(std::isinf(nodal_surface_index(0., 0., 300e6)));
}

BOOST_AUTO_TEST_CASE(damage_by_t_gamma)
{
  using D = DamageThreshold;
  for (const D reading : {D::newton_15, D::newton_20})
    {
      BOOST_TEST(t_gamma_damage(0, reading) == 0.);
      BOOST_TEST(t_gamma_damage(15, reading) == 0.);
      BOOST_TEST(t_gamma_damage(65, reading) == 1e-5, tolerance(1e-14));
      BOOST_TEST(t_gamma_damage(120, reading) == 5e-6, tolerance(1e-14));
      BOOST_TEST(t_gamma_damage(175, reading) == 0.);
      BOOST_TEST(t_gamma_damage(300, reading) == 0.);
    }
  BOOST_TEST(t_gamma_damage(20, D::newton_15) == 1e-6, tolerance(1e-14));
  BOOST_TEST(t_gamma_damage(20, D::newton_20) == 0.);
  // as printed in programs, to the digits there
  BOOST_TEST(t_gamma_damage(50, D::newton_20) == 2.22e-7 * 50 - 4.44e-6,
             tolerance(2e-3));
  BOOST_TEST(t_gamma_damage(100) == 1.59e-5 - 9.09e-8 * 100, tolerance(2e-3));
  CHECK_INPUT_ERROR(t_gamma_damage(-1), "Energy per metre rolled is -1 J/m");
}

BOOST_AUTO_TEST_CASE(percentile_of_friction)
{
  std::vector<FrictionUse> nodes;
  for (int i = 100; i > 0; --i)
    nodes.push_back({i / 100., 5e3});
  BOOST_TEST(friction_use_percentile(nodes) == 0.95);
  BOOST_TEST(friction_use_percentile(nodes, 0.) == 0.01);
  BOOST_TEST(friction_use_percentile(nodes, 1.) == 1.);
  nodes.push_back({7., 0.}); // open nodes
  nodes.push_back({0., 0.});
  BOOST_TEST(friction_use_percentile(nodes, 0.) == 0.01);
  BOOST_TEST(friction_use_percentile(nodes, 1.) == 1.);
  nodes.push_back({0.001, 9.5e6}); // carries 95 % of all
  BOOST_TEST(friction_use_percentile(nodes) == 0.001);
  BOOST_TEST(friction_use_percentile({}) == 0.);
  CHECK_INPUT_ERROR(friction_use_percentile(nodes, 95), "Portion is 95");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(map)

// stresses under a line load on a half-plane (Flamant), summed over the
// pressure and the traction; z of their shear points out of the body
BOOST_AUTO_TEST_CASE(stresses_by_quadrature)
{
  for (const auto &[x, z] : std::vector<std::pair<double, double>>{
         {0., 0.5}, {0.87, 0.5}, {-0.4, 0.8}, {1.3, 0.3}, {-2., 1.}})
    {
      const auto of = [&, x = x, z = z](const int i, const double share) {
        return integrate(
          [&](const double s) {
            const double d = x - s, r = d * d + z * z,
                         radial = -2 / pi * std::sqrt(std::max(0., 1 - s * s)) *
                                  ((1 - share) * z + share * d) / (r * r);
            return radial * (i == 0 ? d * d : i == 1 ? z * z : -d * z);
          },
          -1,
          1);
      };
      const auto p = References::stresses_of_pressure(x, z, 1, 1),
                 q = References::stresses_of_traction(x, z, 1, 1);
      const std::array<double, 3> pressure{p.xx, p.zz, p.xz},
        traction{q.xx, q.zz, q.xz};
      for (const int i : {0, 1, 2})
        {
          BOOST_TEST(std::abs(pressure[i] - of(i, 0.)) < 1e-6);
          BOOST_TEST(std::abs(traction[i] - of(i, 1.)) < 1e-6);
        }
    }
}

// Johnson 1985, sections 4.2 (c) and 3.4 (d)
BOOST_AUTO_TEST_CASE(elastic_limits_of_hertz)
{
  const ShearPeak line = line_shear(0.);
  BOOST_TEST(line.shear == 0.3003, tolerance(5e-4));
  BOOST_TEST(line.depth == 0.7861, tolerance(5e-4));
  const ShearPeak circle = circle_shear();
  BOOST_TEST(circle.shear == 0.310, tolerance(2e-3));
  BOOST_TEST(circle.depth == 0.481, tolerance(2e-3));
  const ShakedownLimits limits = shakedown_limits(0.);
  BOOST_TEST(limits.line_elastic == 3.33, tolerance(1e-3));
  BOOST_TEST(limits.point_elastic == 1 / 0.310, tolerance(2e-3));
  // on the axis of a line contact: 0.300 p0 is the root of a closed form
  const double z = line.depth, root = std::sqrt(1 + z * z);
  BOOST_TEST(line.shear == z - z * z / root, tolerance(1e-9));
  CHECK_INPUT_ERROR(line_shear(-0.1), "Utilised friction is -0.1");
  CHECK_INPUT_ERROR(circle_shear(0.6), "Poisson ratio is 0.6");
}

// tau_xz = p0/4 at a/2 (Johnson 1985, section 9.2): 4.0
BOOST_AUTO_TEST_CASE(shakedown_of_a_line)
{
  const ShearPeak free = line_orthogonal_shear(0.);
  BOOST_TEST(free.shear == 0.25, tolerance(1e-9));
  BOOST_TEST(free.depth == 0.5, tolerance(1e-3));
  BOOST_TEST(shakedown_limits(0.).line_shakedown == 4., tolerance(1e-9));
  BOOST_TEST(line_orthogonal_shear(0.36).depth > 0.3);
  for (const double mu_u : {0.37, 0.5, 0.8})
    {
      const ShearPeak surface = line_orthogonal_shear(mu_u);
      BOOST_TEST(surface.shear == mu_u, tolerance(1e-9));
      BOOST_TEST(surface.depth < 1e-6);
    }
}

/**
 * Melan's theorem by itself: the least yield stress for which each depth has
 * residual stresses along x and along the line with which no place yields.
 */
double least_yield_stress(const double mu_u)
{
  struct Stress
  {
    double difference, middle, shear;
  };
  const auto lasts = [&](const std::vector<Stress> &row, const double k) {
    double from = -1e300, to = 1e300;
    for (const Stress &s : row)
      {
        if (std::abs(s.shear) > k)
          return false;
        const double room = 2 * std::sqrt(k * k - s.shear * s.shear);
        from              = std::max(from, -s.difference - room);
        to                = std::min(to, -s.difference + room);
      }
    for (int part = 0; part <= 4 && from <= to; ++part)
      {
        const double residual = from + (to - from) * part / 4;
        double       low = -1e300, high = 1e300;
        for (const Stress &s : row)
          {
            const double radius =
                           std::hypot((s.difference + residual) / 2, s.shear),
                         middle = s.middle + residual / 2 - 0.6 * s.middle;
            low                 = std::max(low, middle - (2 * k - radius));
            high                = std::min(high, middle + (2 * k - radius));
          }
        if (low <= high)
          return true;
      }
    return false;
  };
  double least = 0.;
  for (double z = 0.; z < 2.; z += 0.02)
    {
      std::vector<Stress> row;
      for (double x = -4; x <= 4; x += 0.01)
        {
          const auto p = References::stresses_of_pressure(x, z, 1, 1),
                     q = References::stresses_of_traction(x, z, 1, mu_u);
          row.push_back({p.xx + q.xx - p.zz - q.zz,
                         (p.xx + q.xx + p.zz + q.zz) / 2,
                         p.xz + q.xz});
        }
      double low = 0., high = 1.;
      for (int i = 0; i < 24; ++i)
        (lasts(row, (low + high) / 2) ? high : low) = (low + high) / 2;
      least = std::max(least, high);
    }
  return least;
}

// what shear along the surface demands is enough, with residual stresses that
// are found depth by depth
BOOST_AUTO_TEST_CASE(shakedown_by_melan)
{
  for (const double mu_u : {0., 0.1, 0.25, 0.4})
    BOOST_TEST(least_yield_stress(mu_u) == line_orthogonal_shear(mu_u).shear,
               tolerance(1e-3));
}

// order of the limits, and where the surface takes over
BOOST_AUTO_TEST_CASE(limits_over_utilised_friction)
{
  const auto map = shakedown_map(0.6, 30);
  BOOST_TEST(map.size() == 31U);
  BOOST_TEST(map.front().utilised_friction == 0.);
  BOOST_TEST(map.back().utilised_friction == 0.6, tolerance(1e-14));
  BOOST_TEST(std::isinf(map.front().surface));
  BOOST_TEST(map.front().point_shakedown == 4.7);
  for (std::size_t k = 0; k < map.size(); ++k)
    {
      const ShakedownLimits &row = map[k];
      BOOST_TEST(row.line_elastic <= row.line_shakedown * (1 + 1e-9));
      BOOST_TEST(row.line_shakedown <= row.surface * (1 + 1e-9));
      BOOST_TEST(row.point_elastic <= row.point_shakedown);
      BOOST_TEST(row.point_shakedown <= row.surface);
      if (k > 0)
        BOOST_TEST(row.line_elastic < map[k - 1].line_elastic);
    }
  // independent search on a grid, nu = 0.3: 0.3190, 0.3588, 0.5
  BOOST_TEST(1 / shakedown_limits(0.2).line_elastic == 0.3190, tolerance(5e-4));
  BOOST_TEST(1 / shakedown_limits(0.3).line_elastic == 0.3588, tolerance(5e-4));
  BOOST_TEST(1 / shakedown_limits(0.5).line_elastic == 0.5, tolerance(1e-3));
  CHECK_INPUT_ERROR(shakedown_map(0), "Most utilised friction is 0");
  CHECK_INPUT_ERROR(shakedown_map(0.5, 0), "Number of steps is 0");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
