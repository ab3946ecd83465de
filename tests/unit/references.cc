#include <boost/test/unit_test.hpp>

#include "reference_checks.h"

#include <rolling_contact/references/bracketed_root.h>
#include <rolling_contact/references/carter.h>
#include <rolling_contact/references/clamped_annuli_approach.h>
#include <rolling_contact/references/contact_modulus.h>
#include <rolling_contact/references/line_contact_approach.h>

#include <limits>

using namespace RollingContact;
using namespace RollingContact::References;
using boost::test_tools::tolerance;

namespace
{
  const double pi       = std::acos(-1.);
  const double infinity = std::numeric_limits<double>::infinity();
  const double steel    = 210e9;
} // namespace

BOOST_AUTO_TEST_SUITE(references)

BOOST_AUTO_TEST_SUITE(moduli)

// body 1 is drawn towards the middle of the patch more: positive
BOOST_AUTO_TEST_CASE(sign_of_dundurs_constant)
{
  BOOST_TEST(dundurs_beta(steel, 0.3, steel, 0.3) == 0);
  BOOST_TEST(dundurs_beta(steel, 0.3, infinity, 0.3) == 0.4 / 1.4,
             tolerance(1e-14));
  const double beta = dundurs_beta(70e9, 0.33, 210e9, 0.3);
  BOOST_TEST(beta == 0.1167359696, tolerance(1e-9));
  BOOST_TEST(dundurs_beta(210e9, 0.3, 70e9, 0.33) == -beta);
}

BOOST_AUTO_TEST_CASE(equal_rigid_and_flat)
{
  BOOST_TEST(contact_modulus(steel, 0.3, steel, 0.3) == steel / (2 * 0.91),
             tolerance(1e-15));
  BOOST_TEST(contact_modulus(steel, 0.3, infinity, 0.3) == steel / 0.91,
             tolerance(1e-15));
  BOOST_TEST(relative_radius(0.46, 0.46) == 0.23, tolerance(1e-15));
  BOOST_TEST(relative_radius(0.46, infinity) == 0.46, tolerance(1e-15));
  BOOST_TEST(relative_radius(0.5, -1) == 1, tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(combined_elasticity_gives_the_contact_modulus)
{
  const CombinedElasticity pair = combined_elasticity(210e9, 0.28, 70e9, 0.34);
  BOOST_TEST(pair.shear_modulus / (1 - pair.poisson_ratio) ==
               contact_modulus(210e9, 0.28, 70e9, 0.34),
             tolerance(1e-15));
  const CombinedElasticity equal = combined_elasticity(steel, 0.3, steel, 0.3);
  BOOST_TEST(equal.shear_modulus == steel / 2.6, tolerance(1e-15));
  BOOST_TEST(equal.poisson_ratio == 0.3, tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(bad_input)
{
  CHECK_INPUT_ERROR(contact_modulus(-2, 0.3, steel, 0.3),
                    "Young modulus is -2 Pa");
  CHECK_INPUT_ERROR(contact_modulus(steel, 0.51, steel, 0.3),
                    "Poisson ratio is 0.51");
  CHECK_INPUT_ERROR(contact_modulus(infinity, 0.3, infinity, 0.3),
                    "infinite for both");
  CHECK_INPUT_ERROR(relative_radius(infinity, infinity),
                    "Relative curvature 1/R1 + 1/R2 is 0 1/m");
  CHECK_INPUT_ERROR(relative_radius(0, 1), "Radius is 0 m");
}

BOOST_AUTO_TEST_CASE(root)
{
  const auto line = [](const double x) { return std::exp(x) - 2; };
  BOOST_TEST(bracketed_root(line, -30, 30) == std::log(2.), tolerance(4e-16));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(line_contact)

// CONTACT user guide, Carter example: R = 500 mm, G = 82 GPa, nu = 0.28 on a
// plane of the same material, 178.90 N/mm: a = 1 mm, p0 = 113.89 MPa.
BOOST_AUTO_TEST_CASE(hertz_against_published_values)
{
  const double young_modulus = 2 * 82e9 * 1.28;
  const double modulus =
    contact_modulus(young_modulus, 0.28, young_modulus, 0.28);
  const HertzLine contact = hertz_line(178.90e3, 0.5, modulus);
  BOOST_TEST(contact.half_width == 1e-3, tolerance(5e-5));
  BOOST_TEST(contact.max_pressure == 113.89e6, tolerance(5e-5));
}

BOOST_AUTO_TEST_CASE(hertz_pressure)
{
  const HertzLine contact = hertz_line(7.05e6, 0.23, steel / 1.82);
  // independent computation
  BOOST_TEST(contact.half_width == 0.004229992354858723, tolerance(1e-14));
  BOOST_TEST(contact.max_pressure == 1061034871.6200808, tolerance(1e-14));
  BOOST_TEST(contact.load_per_length() == 7.05e6, tolerance(1e-14));
  const double integral =
    integrate([&](const double x) { return contact.pressure(x); },
              -contact.half_width,
              contact.half_width);
  BOOST_TEST(integral == 7.05e6, tolerance(1e-12));
  BOOST_TEST(contact.pressure(1.01 * contact.half_width) == 0);
  BOOST_TEST(hertz_line(0, 0.23, steel).pressure(0) == 0);
  CHECK_INPUT_ERROR(hertz_line(-1, 0.23, steel), "Load per length is -1 N/m");
}

BOOST_AUTO_TEST_CASE(compression_of_disc_and_layer)
{
  const HertzLine contact = hertz_line(7.05e6, 0.23, steel / 1.82);
  // independent computation of Johnson 1985, 5.57
  BOOST_TEST(compression_of_disc(0.46, steel, 0.3, contact) ==
               0.00010843292883202297,
             tolerance(1e-13));

  // P = 1, E = 1, nu = 0.3, D/a = 7: independent quadrature of the axial strain
  const HertzLine unit{1, 2 / pi};
  BOOST_TEST(compression_of_layer(7, 1, 0.3, unit) == 1.4082887312859431,
             tolerance(1e-12));
  BOOST_TEST(compression_of_layer(1e5, 1, 0.3, unit) ==
               0.91 / pi * (2 * std::log(2e5) - 0.3 / 0.7),
             tolerance(1e-9));

  // independent computation of the infinite layer bonded at D/a = 20
  const double ratio =
    compression_of_layer(20, 1, 0.3, unit) / (0.91 / pi * 7.3254);
  BOOST_TEST(ratio < 1);
  BOOST_TEST(ratio > 0.94);

  BOOST_TEST(compression_of_disc(0.46, steel, 0.3, {0, 0}) == 0);
  CHECK_INPUT_ERROR(compression_of_layer(0, steel, 0.3, contact),
                    "Depth of the layer is 0 m");
  CHECK_INPUT_ERROR(compression_of_disc(-1, steel, 0.3, contact),
                    "Radius of the disc is -1 m");
}

BOOST_AUTO_TEST_CASE(half_width_is_the_inverse_of_the_approach)
{
  const double modulus  = steel / 1.82;
  const auto   approach = [&](const double half_width) {
    const HertzLine contact =
      hertz_line_of_half_width(half_width, 0.23, modulus);
    return compression_of_disc(0.46, steel, 0.3, contact) +
           compression_of_layer(0.1, steel, 0.3, contact);
  };
  for (const double half_width : {1e-7, 1e-5, 1e-3, 0.03})
    BOOST_TEST(half_width_of_approach(approach, 0.05, approach(half_width)) ==
                 half_width,
               tolerance(1e-12));
  BOOST_TEST(half_width_of_approach(approach, 0.05, 0) == 0);
  BOOST_TEST(half_width_of_approach(approach, 0.05, -1e-4) == 0);
  CHECK_INPUT_ERROR(half_width_of_approach(approach, 0.05, 0.5),
                    "Approach is 0.5 m: it must be smaller than");
}

BOOST_AUTO_TEST_SUITE_END()

namespace
{
  const HertzLine paper_line{0.004229992354858723, 1061034871.6200808};

  Carter paper_carter(const double creepage, const int flow_direction = 1)
  {
    return Carter(paper_line, 0.23, 0.3, creepage, flow_direction);
  }

  /**
   * Relative slip at x from the traction alone: the half-planes' surface strain
   * is -2/(pi E*) times the principal value of the integral of q(t)/(x - t).
   */
  double slip_from_traction(const Carter &carter,
                            const double  creepage,
                            const int     flow_direction,
                            const double  x)
  {
    const int    n_steps  = 100000;
    const double reach    = 3 * paper_line.half_width;
    double       integral = 0;
    for (int i = 0; i < n_steps; ++i)
      {
        const double distance = reach * (i + 0.5) / n_steps;
        integral +=
          (carter.traction(x - distance) - carter.traction(x + distance)) /
          distance * reach / n_steps;
      }
    const double modulus =
      2 * 0.23 * paper_line.max_pressure / paper_line.half_width;
    return creepage - flow_direction * 2 / (pi * modulus) * integral;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(carter)

// The table inferred for the paper's two-dimensional case, 141 kN on 20 mm:
// creepage, c/a, T/(mu N), T in kN; 4 digits are printed.
BOOST_AUTO_TEST_CASE(paper_table)
{
  const double rows[][4] = {{0.0005, 0.9094, 0.1730, 7.319},
                            {0.001, 0.8188, 0.3296, 13.944},
                            {0.0017, 0.6919, 0.5213, 22.051},
                            {0.003, 0.4563, 0.7918, 33.494},
                            {0.005, 0.0938, 0.9912, 41.928},
                            {0.0055, 0.0032, 0.99999, 42.300}};
  BOOST_TEST(paper_carter(0).saturation_creepage() == 0.005517,
             tolerance(1e-4));
  for (const auto &row : rows)
    {
      const Carter carter = paper_carter(row[0]);
      BOOST_TEST(std::abs(carter.stick_half_width() / paper_line.half_width -
                          row[1]) < 6e-5);
      BOOST_TEST(std::abs(carter.force_ratio() + row[2]) < 6e-5);
      BOOST_TEST(std::abs(-42.3 * carter.force_ratio() - row[3]) < 6e-4);
    }
}

// CONTACT user guide: a = 1 mm, R = 500 mm, mu = 0.3, creepage -2.4e-4 gives a
// stick half-width of 0.6 mm and |T|/(mu N) = 0.64.
BOOST_AUTO_TEST_CASE(published_point)
{
  const Carter carter(HertzLine{1e-3, 113.89e6}, 0.5, 0.3, -2.4e-4);
  BOOST_TEST(carter.stick_half_width() == 0.6e-3, tolerance(1e-12));
  BOOST_TEST(carter.force_ratio() == 0.64, tolerance(1e-12));
}

// independent computation at creepage 0.0017: x/a, -q (Pa), s
BOOST_AUTO_TEST_CASE(traction_and_slip_values)
{
  const double rows[][3] = {{-0.9, 24698708.65002671, 0},
                            {-0.2, 94351283.99158037, 0},
                            {0.3, 198608631.68701136, 0},
                            {0.5, 275664945.93724513, 0.002303806029123424},
                            {0.9, 138748313.42893752, 0.005464283944091716}};
  const Carter carter    = paper_carter(0.0017);
  for (const auto &row : rows)
    {
      const double x = row[0] * paper_line.half_width;
      BOOST_TEST(carter.traction(x) == -row[1], tolerance(1e-11));
      BOOST_TEST(carter.slip(x) == row[2], tolerance(1e-11));
    }
}

BOOST_AUTO_TEST_CASE(stick_zone_touches_the_leading_edge)
{
  const double half_width = paper_line.half_width;
  const auto   forward    = paper_carter(0.003).stick_interval();
  BOOST_TEST(forward.first == -half_width, tolerance(1e-14));
  BOOST_TEST(forward.second ==
               -half_width + 2 * paper_carter(0.003).stick_half_width(),
             tolerance(1e-14));
  const auto backward = paper_carter(0.003, -1).stick_interval();
  BOOST_TEST(backward.second == half_width, tolerance(1e-14));
  BOOST_TEST(backward.first == -forward.second, tolerance(1e-14));
  const auto sliding = paper_carter(0.01).stick_interval();
  BOOST_TEST(sliding.first == -half_width);
  BOOST_TEST(sliding.second == -half_width);
}

BOOST_AUTO_TEST_CASE(slip_follows_from_the_traction)
{
  for (const int flow_direction : {1, -1})
    for (const double creepage : {0.0017, -0.003, 0.008})
      {
        const Carter carter = paper_carter(creepage, flow_direction);
        for (const double position : {-1.7, -0.93, -0.4, 0.21, 0.77, 1.4})
          {
            const double x = position * paper_line.half_width;
            BOOST_TEST(std::abs(carter.slip(x) -
                                slip_from_traction(
                                  carter, creepage, flow_direction, x)) < 1e-6);
            if (std::abs(position) < 1)
              BOOST_TEST(carter.slip(x) * carter.traction(x) <= 0);
          }
      }
}

BOOST_AUTO_TEST_CASE(force_and_energy)
{
  for (const int flow_direction : {1, -1})
    for (const double creepage : {1e-4, 0.0017, -0.003, 0.0055, -0.02})
      {
        const Carter carter   = paper_carter(creepage, flow_direction);
        const auto   stick    = carter.stick_interval();
        const double edge     = paper_line.half_width;
        const auto   traction = [&](const double x) {
          return carter.traction(x);
        };
        const auto power = [&](const double x) {
          return carter.traction(x) * carter.slip(x);
        };
        const auto whole = [&](const auto &function) {
          return integrate(function, -edge, stick.first) +
                 integrate(function, stick.first, stick.second) +
                 integrate(function, stick.second, edge);
        };
        const double force =
          0.3 * paper_line.load_per_length() * carter.force_ratio();
        BOOST_TEST(whole(traction) == force, tolerance(1e-6));
        BOOST_TEST(whole(power) == force * creepage, tolerance(1e-6));
      }
}

BOOST_AUTO_TEST_CASE(limits)
{
  const double modulus =
    2 * 0.23 * paper_line.max_pressure / paper_line.half_width;
  const double creepage = 1e-9;
  BOOST_TEST(0.3 * paper_line.load_per_length() *
                 paper_carter(creepage).force_ratio() / creepage ==
               -pi / 2 * paper_line.half_width * modulus,
             tolerance(1e-6));
  BOOST_TEST(paper_carter(0).force_ratio() == 0);
  BOOST_TEST(paper_carter(0).traction(1e-3) == 0);
  BOOST_TEST(paper_carter(0.0056).force_ratio() == -1);
  BOOST_TEST(paper_carter(0.01).slip(0) == 0.01, tolerance(1e-14));
  const Carter frictionless(paper_line, 0.23, 0, 0.001);
  BOOST_TEST(frictionless.traction(0) == 0);
  BOOST_TEST(frictionless.slip(0) == 0.001, tolerance(1e-14));
  CHECK_INPUT_ERROR(Carter(paper_line, 0.23, -0.1, 0),
                    "Friction coefficient is -0.1:");
  CHECK_INPUT_ERROR(paper_carter(0, 2), "Flow direction is 2:");
}

BOOST_AUTO_TEST_SUITE_END()

namespace
{
  const Annulus paper_annulus{0.46, 0.08, steel, 0.3};

  /**
   * Displacement inwards over p0 R/(2 G).
   */
  double rim_response(const double hub_ratio,
                      const double nu,
                      const double half_angle,
                      const double angle)
  {
    const ClampedAnnulus annulus(Annulus{1, hub_ratio, 1, nu});
    return -annulus.radial_displacement(half_angle, angle) * pi / 2 *
           half_angle / (1 + nu);
  }
} // namespace

BOOST_AUTO_TEST_SUITE(annulus)

// independent computation: Navier's equations integrated radially for each of
// the first harmonics, four million terms summed; its own error is about 1e-11
BOOST_AUTO_TEST_CASE(rim_values)
{
  const double thick = 0.08 / 0.46;
  BOOST_TEST(rim_response(thick, 0.3, 0.0092, 0) == 0.03647759414371887,
             tolerance(1e-11));
  BOOST_TEST(rim_response(thick, 0.3, 0.0092, 0.005) == 0.034579921214433616,
             tolerance(1e-11));
  BOOST_TEST(rim_response(thick, 0.3, 0.0092, 0.02) == 0.024014418093095964,
             tolerance(1e-11));
  BOOST_TEST(rim_response(thick, 0.3, 0.0092, 1) == -5.67302089506123e-05,
             tolerance(1e-9));
  BOOST_TEST(rim_response(thick, 0.3, 0.0092, 3) == -0.001437052581496255,
             tolerance(1e-10));
  BOOST_TEST(rim_response(0.8, 0.3, 0.02, 0) == 0.042157153056823014,
             tolerance(1e-11));
  BOOST_TEST(rim_response(0.8, 0.3, 0.02, 0.05) == 0.013612987326929893,
             tolerance(1e-11));
  BOOST_TEST(rim_response(0.8, 0.3, 0.02, 1) == -2.4732854072310995e-05,
             tolerance(1e-9));
  for (const double angle : {-0.05, 2 * pi - 0.05, 6 * pi + 0.05})
    BOOST_TEST(rim_response(0.8, 0.3, 0.02, angle) ==
                 rim_response(0.8, 0.3, 0.02, 0.05),
               tolerance(1e-12));
}

// A clamped rim of thickness t much below a is a row of springs:
// u = p t (1 + nu)(1 - 2 nu)/(E (1 - nu)).
BOOST_AUTO_TEST_CASE(thin_rim)
{
  const double springs = 0.001 * 2 * (1 - 2 * 0.3) / (2 * (1 - 0.3));
  BOOST_TEST(rim_response(0.999, 0.3, 0.2, 0) == springs, tolerance(1e-3));
  BOOST_TEST(rim_response(0.999, 0.3, 0.2, 0.1) == springs * std::sqrt(0.75),
             tolerance(1e-3));
}

// Near a small patch a half-plane: u(0) - u(x) = (1 - nu^2) p0 x^2/(E a).
BOOST_AUTO_TEST_CASE(curvature_under_a_small_patch)
{
  const double half_angle = 1e-4;
  const double drop       = rim_response(0.2, 0.3, half_angle, 0) -
                      rim_response(0.2, 0.3, half_angle, half_angle);
  BOOST_TEST(drop == (1 - 0.3) * half_angle, tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(incompressible)
{
  const double exact = rim_response(0.3, 0.5, 0.01, 0);
  BOOST_TEST(exact > 0);
  BOOST_TEST(rim_response(0.3, 0.5 - 1e-9, 0.01, 0) == exact, tolerance(1e-7));
}

// 0.22 mm on 20 mm of thickness; the paper prints 141 kN, the independent
// series 140759.776 N.
BOOST_AUTO_TEST_CASE(load_of_the_paper)
{
  const double load =
    load_of_two_clamped_annuli(paper_annulus, paper_annulus, 0.22e-3);
  BOOST_TEST(0.02 * load == 140.76e3, tolerance(4e-5));
  BOOST_TEST(0.02 * load == 140759.77618510436, tolerance(1e-10));
  const AnnuliContact contact =
    approach_of_two_clamped_annuli(paper_annulus, paper_annulus, 7.05e6);
  BOOST_TEST(contact.approach == 0.00022034234824717185, tolerance(1e-11));
  BOOST_TEST(contact.hertz.half_width == 4.230e-3, tolerance(1e-4));
  BOOST_TEST(contact.hertz.max_pressure == 1061.0e6, tolerance(1e-4));
}

BOOST_AUTO_TEST_CASE(approach_adds_both_compressions)
{
  const Annulus other{0.3, 0.29, 70e9, 0.45};
  const Annulus rigid{0.3, 0.1, infinity, 0.3};
  for (const Annulus &second : {other, rigid})
    {
      const AnnuliContact contact =
        approach_of_two_clamped_annuli(paper_annulus, second, 1e6);
      const double width = contact.hertz.half_width;
      BOOST_TEST(contact.approach ==
                   -1e6 *
                     (ClampedAnnulus(paper_annulus).radial_displacement(width) +
                      ClampedAnnulus(second).radial_displacement(width)),
                 tolerance(1e-13));
      BOOST_TEST(
        contact.approach ==
          approach_of_two_clamped_annuli(second, paper_annulus, 1e6).approach,
        tolerance(1e-13));
    }
  BOOST_TEST(ClampedAnnulus(rigid).radial_displacement(1e-3) == 0);
}

BOOST_AUTO_TEST_CASE(inverse)
{
  const Annulus other{0.3, 0.29, 70e9, 0.45};
  const Annulus rigid{0.3, 0.1, infinity, 0.3};
  for (const Annulus &second : {paper_annulus, other, rigid})
    for (const double load : {1., 1e4, 1e7})
      {
        const double approach =
          approach_of_two_clamped_annuli(paper_annulus, second, load).approach;
        BOOST_TEST(load_of_two_clamped_annuli(paper_annulus,
                                              second,
                                              approach) == load,
                   tolerance(1e-12));
      }
  BOOST_TEST(approach_of_two_clamped_annuli(paper_annulus, other, 0).approach ==
             0);
  BOOST_TEST(load_of_two_clamped_annuli(paper_annulus, other, -1e-5) == 0);
}

BOOST_AUTO_TEST_CASE(bad_input)
{
  CHECK_INPUT_ERROR(ClampedAnnulus(Annulus{0.1, 0.2, steel, 0.3}),
                    "Hub radius over rim radius is 2:");
  CHECK_INPUT_ERROR(ClampedAnnulus(Annulus{0.1, 0, steel, 0.3}),
                    "Hub radius is 0 m");
  CHECK_INPUT_ERROR(ClampedAnnulus(paper_annulus).radial_displacement(0),
                    "Half-width is 0 m");
  CHECK_INPUT_ERROR(load_of_two_clamped_annuli(paper_annulus,
                                               paper_annulus,
                                               0.4),
                    "Approach is 0.4 m");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
