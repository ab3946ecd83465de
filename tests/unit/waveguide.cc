#include <boost/test/unit_test.hpp>

#include "rail_on_layer.h"

#include <rolling_contact/base/constants.h>
#include <rolling_contact/modes/measuring_point.h>
#include <rolling_contact/modes/modal_fit.h>
#include <rolling_contact/modes/section_outline.h>
#include <rolling_contact/modes/waveguide_response.h>
#include <rolling_contact/vibration/rail_waves.h>

#include <cmath>
#include <complex>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(waveguide)

namespace
{
  using Complex = std::complex<double>;

  const double width = 0.03, height = 0.04, E = 210e9, density = 7850.;

  const Waveguide::Place top{{0., 0., 0.}};

  /** A bar on a layer, its top at z = 0. */
  StraightBody bar(const double layer)
  {
    StraightBody body;
    const double low = -height, y = width / 2;
    SectionMesh  section(
      {{{-y, low, low}}, {{y, low, low}}, {{-y, 0., 0.}}, {{y, 0., 0.}}},
      {{{0, 1, 2, 3}}});
    section.set_boundary(0, 2, SectionBoundary::hub);
    body.shape.section             = section.divided(0.011);
    body.shape.placement.contact   = {{0., 0.}};
    body.material                  = {E, 0.3, density};
    body.foundation.stiffness      = {{1e-2 * layer, layer, layer}};
    body.foundation.loss_factor    = 0.1;
    body.damping.stiffness_damping = 1e-7;
    return body;
  }

  Waveguide waves_of(const StraightBody &body)
  {
    return Waveguide(body, 4000., {top}, []() {});
  }

  Complex at_frequency(const double f)
  {
    return {0., 2 * pi * f};
  }

  Complex vertical(const Waveguide &guide, const Complex s, const double x)
  {
    return guide.receptances(s, {top, {{x, 0., 0.}}})(5, 2);
  }

  /** Of a Bernoulli beam under a point force. */
  Complex of_beam(const Complex s, const double layer, const double x)
  {
    const double  area = width * height, I = area * height * height / 12;
    const Complex turned = s.imag() == 0. ? 0. : Complex(0., 1.);
    const Complex k =
      layer * (1. + 0.1 * turned + s * 1e-7) + density * area * s * s;
    const Complex EI = E * I * (1. + s * 1e-7),
                  b  = std::pow(k / (4. * EI), 0.25);
    return b / (2. * k) * std::exp(-b * x) *
           (std::cos(b * x) + std::sin(b * x));
  }
} // namespace

BOOST_AUTO_TEST_CASE(long_waves_are_those_of_a_beam_on_springs)
{
  const double    layer = 2e6;
  const Waveguide guide = waves_of(bar(layer));
  for (const double x : {0.2, 0.6, 1.3})
    {
      const Complex rest(1e-3, 0.), slow = at_frequency(40.),
                                    above = at_frequency(300.);
      for (const Complex s : {rest, slow, above})
        {
          const Complex exact = of_beam(s, layer, x);
          BOOST_TEST(std::abs(vertical(guide, s, x) - exact) <
                     0.03 * std::abs(of_beam(s, layer, 0.2)));
        }
    }
}

BOOST_AUTO_TEST_CASE(free_waves_are_a_bar_s)
{
  const Waveguide guide = waves_of(bar(2e4));
  const double    omega = 2 * pi * 500., area = width * height,
               along = omega * std::sqrt(density / E),
               bending =
                 std::pow(12 * density / E * omega * omega / (height * height),
                          0.25),
               across =
                 std::pow(12 * density / E * omega * omega / (width * width),
                          0.25);
  BOOST_TEST_REQUIRE(area > 0.);
  const auto has = [&](const double       wavenumber,
                       const unsigned int most, // of the shares
                       const double       tolerance) {
    for (const Waveguide::Wave &wave : guide.waves(at_frequency(500.)))
      {
        const auto shares = guide.shares(wave);
        if (std::abs(wave.wavenumber.real() / wavenumber - 1) < tolerance &&
            std::abs(wave.wavenumber.imag()) < 1e-2 && shares[most] > 0.9)
          return true;
      }
    return false;
  };
  BOOST_TEST(has(along, 0, 1e-3));
  BOOST_TEST(has(bending, 2, 0.01));
  BOOST_TEST(has(across, 1, 0.01));
}

BOOST_AUTO_TEST_CASE(what_waves_bring_is_reciprocal_and_takes_energy)
{
  const Waveguide                     guide = waves_of(bar(2e6));
  const std::vector<Waveguide::Place> places{top,
                                             {{0.3, 0.01, -0.02}},
                                             {{-0.2, -0.015, -0.04}}};
  for (const double f : {30., 400., 2500.})
    {
      const ComplexMatrix alpha = guide.receptances(at_frequency(f), places);
      // but for rounding, up to 1.3e-6 by some kernels of BLAS
      BOOST_TEST((alpha - alpha.transpose()).norm() < 2e-6 * alpha.norm());
      for (Eigen::Index i = 0; i < alpha.rows(); ++i)
        BOOST_TEST(alpha(i, i).imag() < 0.);
      // mirror images along the bar
      const ComplexMatrix other =
        guide.receptances(at_frequency(f), {top, {{-0.3, 0.01, -0.02}}});
      BOOST_TEST(std::abs(other(5, 2) - alpha(5, 2)) < 1e-9 * alpha.norm());
      BOOST_TEST(std::abs(other(3, 2) + alpha(3, 2)) < 1e-9 * alpha.norm());
    }
}

/** A vibration that grows fades along the bar, whatever its damping. */
BOOST_AUTO_TEST_CASE(growing_waves_fade)
{
  const Waveguide guide = waves_of(bar(2e6));
  for (const Waveguide::Wave &wave : guide.waves(Complex(100., 2 * pi * 800.)))
    BOOST_TEST(wave.wavenumber.imag() < 0.);
  // and is the analytic continuation of one that does not
  const double  f    = 800.;
  const Complex here = vertical(guide, at_frequency(f), 0.4),
                step = vertical(guide, Complex(1., 2 * pi * f), 0.4) - here,
                along =
                  vertical(guide, at_frequency(f + 1 / (2 * pi)), 0.4) - here;
  BOOST_TEST(std::abs(along - Complex(0., 1.) * step) < 0.01 * std::abs(step));
}

BOOST_AUTO_TEST_CASE(pads_close_to_each_other_are_a_layer)
{
  StraightBody body           = bar(2e6);
  body.damping.loss_factor    = 0.1;
  body.foundation.stiffness   = {{2e6, 2e6, 2e6}};
  const Waveguide on_layer    = waves_of(body);
  body.foundation.pad_spacing = 0.2;
  body.foundation.pad_length  = 0.2;
  const Waveguide on_pads     = waves_of(body);
  for (const Complex s :
       {Complex(30., 0.), at_frequency(50.), at_frequency(400.)})
    for (const double x : {0., 0.25, -0.7})
      {
        const Complex layer = vertical(on_layer, s, x);
        BOOST_TEST(std::abs(vertical(on_pads, s, x) - layer) <
                   4e-4 * std::abs(vertical(on_layer, s, 0.)));
      }
}

BOOST_AUTO_TEST_CASE(the_whole_rail_is_integrated)
{
  StraightBody on_layer = bar(2e6), on_pads = bar(2e6);
  on_pads.foundation.pad_spacing = 0.25;
  on_pads.foundation.pad_length  = 0.06;
  on_pads.foundation.pad_offset  = 0.03;
  for (StraightBody *body : {&on_layer, &on_pads})
    {
      body->damping.loss_factor = 0.3;
      const Waveguide     guide = waves_of(*body);
      const Complex       s     = at_frequency(900.);
      const ComplexMatrix there = guide.motion_at(top), // 3 x fields
        loads                   = ComplexMatrix::Identity(3, 2) +
                ComplexMatrix::Constant(3, 2, Complex(0., 0.2));
      // of the motion outwards of two places
      const Waveguide::Place     side{{0., width / 2, -height / 3}};
      const ComplexMatrix        row = guide.motion_at(side);
      std::vector<ComplexMatrix> forms{there.row(2).adjoint() * there.row(2),
                                       row.row(1).adjoint() * row.row(1)};
      const WaveguideResponse    response(guide, s);
      const auto exact = response.integrals(0., there.adjoint() * loads, forms);

      // trapezoids, finer near the load where waves fade at once
      ComplexMatrix       sums[2] = {ComplexMatrix::Zero(2, 2),
                                     ComplexMatrix::Zero(2, 2)};
      std::vector<double> x;
      for (double at = 0., step = 1e-4; at < 12.; at += step)
        {
          x.push_back(at);
          step = std::min(4e-3, 1e-4 + 0.02 * at);
        }
      for (const double way : {-1., 1.})
        {
          std::vector<Waveguide::Place> places;
          for (const double at : x)
            for (const Waveguide::Place &of : {top, side})
              places.push_back({{way * at, of[1], of[2]}});
          // a place at the load belongs to both sides
          const ComplexMatrix moved = response.field(places, top, loads);
          for (std::size_t i = 0; i < x.size(); ++i)
            {
              const double h = (i > 0 ? x[i] - x[i - 1] : 0.) / 2 +
                               (i + 1 < x.size() ? x[i + 1] - x[i] : 0.) / 2;
              const auto top_z  = moved.row(6 * i + 2),
                         side_y = moved.row(6 * i + 4);
              sums[0] += h * top_z.adjoint() * top_z;
              sums[1] += h * side_y.adjoint() * side_y;
            }
        }
      for (unsigned int form = 0; form < 2; ++form)
        {
          const double error =
            (exact[form] - sums[form]).norm() / exact[form].norm();
          BOOST_TEST_MESSAGE("integral of the rail off by " << error);
          BOOST_TEST(error < 2e-4);
          BOOST_TEST((exact[form] - exact[form].adjoint()).norm() <
                     1e-10 * exact[form].norm());
        }
    }
}

BOOST_AUTO_TEST_CASE(the_outline_of_a_section_leaves_out_its_foot)
{
  const auto outline = outline_of(bar(1e6).shape.section);
  double     length = 0., across = 0., turned = 0.;
  for (const OutlinePoint &at : outline)
    {
      length += at.length;
      across += at.length * at.normal[1] * at.normal[1];
      turned += at.length * at.point[1] * at.normal[0] * at.normal[0];
    }
  BOOST_TEST(length == width + 2 * height, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(across == width, boost::test_tools::tolerance(1e-12));
  // int z ds of both sides
  BOOST_TEST(turned == -height * height, boost::test_tools::tolerance(1e-12));
}

/** Pads apart: the sum over many pads, each of them solved for. */
BOOST_AUTO_TEST_CASE(pads_apart_carry_what_equilibrium_says)
{
  StraightBody body                 = bar(2e6);
  body.damping.loss_factor          = 0.1;
  body.foundation.stiffness         = {{2e6, 2e6, 2e6}};
  body.foundation.pad_spacing       = 0.6;
  body.foundation.pad_length        = 0.1;
  body.foundation.pad_offset        = 0.2;
  body.foundation.sleeper_mass      = 20.;
  body.foundation.ballast_stiffness = {{3e6, 3e6, 3e6}};
  const Waveguide guide             = waves_of(body);
  // pads are in series with ballast and sleepers, 20 kg each 0.6 m
  const double rate = 10., sleeper = 3e6 + 20. / 0.6 * rate * rate,
               support    = 2e6 * sleeper / (2e6 + sleeper),
               bar_itself = width * height * density * rate * rate;
  const WaveguideResponse       response(guide, rate);
  std::vector<Waveguide::Place> places;
  for (int pad = -40; pad <= 40; ++pad)
    for (const double way : {-1., 1.})
      places.push_back(
        {{0.6 * pad + 0.2 + way * 0.1 / (2 * std::sqrt(3.)), 0., -height}});
  const ComplexMatrix moved =
    response.field(places, top, ComplexMatrix::Identity(3, 3));
  double sum = 0.;
  for (std::size_t p = 0; p < places.size(); ++p)
    sum += 0.5 * moved(3 * p + 2, 2).real();
  BOOST_TEST(sum * 0.6 * (support + bar_itself) == 1.,
             boost::test_tools::tolerance(2e-4));
  // a bay further all is as it was
  const ComplexMatrix here = guide.receptances(at_frequency(350.), {top}),
                      next = guide.receptances(at_frequency(350.),
                                               {{{0.6, 0., 0.}}});
  BOOST_TEST((here - next).norm() < 1e-6 * here.norm());
  const ComplexMatrix between =
    guide.receptances(at_frequency(350.), {{{0.3, 0., 0.}}});
  BOOST_TEST((here - between).norm() > 1e-3 * here.norm());
}

namespace
{
  BodySpec rail(const double length, const unsigned int cells)
  {
    BodyParameters parameters("Rail");
    set_rail_on_layer(parameters, length, cells);
    BodySpec spec(parameters);
    spec.read_mesh(3, std::string(TEST_DATA) + "/../../prm");
    return spec;
  }

  /** At rest in the four motions: what a mesh says, and with what waves add. */
  std::array<DenseMatrix, 2> at_rest(const BodySpec &spec)
  {
    const DirectBody<3> mesh(spec.body_shape(),
                             spec.material,
                             spec.thickness,
                             Grading<3>::unrefined(),
                             true,
                             spec.model);
    Factorisation       factor(mesh.stiffness(), mesh.nodes_of_unknowns());
    factor.factorise();
    const RailWaves      waves(spec, {50., 1500., 3000.}, []() {});
    DenseMatrix          own(3, 3);
    const MeasuringPoint point(mesh, top, 0.);
    for (unsigned int c = 0; c < 3; ++c)
      {
        const auto moved = factor.solve(point.load(c, mesh.n_unknowns()));
        for (unsigned int d = 0; d < 3; ++d)
          own(d, c) = point.motion(d, moved.data());
      }
    return {{own, own + waves.beyond_mesh(mesh, factor, {top})}};
  }
} // namespace

/** Short meshes are softer where they end, and told so. */
BOOST_AUTO_TEST_CASE(a_rail_without_ends_is_the_same_by_meshes_of_any_length)
{
  const auto short_one = at_rest(rail(1.2, 48)),
             long_one  = at_rest(rail(2.4, 96));
  for (unsigned int c = 0; c < 3; ++c)
    {
      BOOST_TEST(std::abs(short_one[1](c, c) / long_one[1](c, c) - 1) < 3e-4);
      if (c < 2)
        BOOST_TEST(std::abs(short_one[0](c, c) / long_one[0](c, c) - 1) > 0.05);
    }
}

BOOST_AUTO_TEST_CASE(modes_stand_for_the_waves_of_a_rail)
{
  RailWaves waves(rail(1.2, 48), {50., 1500., 3000.}, []() {});
  waves.find_modes([]() {});
  const FittedModes &fit = waves.modes();
  BOOST_TEST(fit.error < 0.1);
  BOOST_TEST(fit.frequencies.size() > 20);
  for (const double f : {150., 400., 1000.})
    {
      const Complex s      = at_frequency(f);
      const double  tau    = 0.02 / (2 * pi * 1000.);
      ComplexMatrix answer = fit.rest.cast<Complex>() / (1. + tau * s);
      for (std::size_t j = 0; j < fit.frequencies.size(); ++j)
        {
          const double omega = 2 * pi * fit.frequencies[j];
          answer +=
            fit.motions.col(j) * fit.motions.col(j).transpose() /
            (s * s + 2 * fit.damping_ratios[j] * omega * s + omega * omega);
        }
      const ComplexMatrix exact =
        waves.change(s) + waves.at_rest() / waves.stiffening(s);
      for (unsigned int c = 0; c < 3; ++c)
        BOOST_TEST(std::abs(answer(c, c) - exact(c, c)) <
                   0.05 * std::abs(exact(c, c)));
    }
  BOOST_TEST(waves.lower_degree_error([]() {}) < 5e-3);
  // the fields of modes are their motions, in the mean of points beside
  const double      low = -std::pow(5e-3, 2) / (2 * 0.3);
  const DenseMatrix shapes =
                      waves.shapes({{{0., -5e-3, low}}, {{0., 5e-3, low}}}),
                    mean = (shapes.topRows(3) + shapes.bottomRows(3)) / 2;
  BOOST_TEST((mean - fit.motions.topRows(3)).norm() <
             1e-3 * fit.motions.topRows(3).norm());
}

BOOST_AUTO_TEST_CASE(a_fit_finds_modes_and_stays_passive)
{
  // two motions, coupled in one of three modes, and a rest
  std::vector<double>        frequencies;
  std::vector<ComplexMatrix> receptances;
  const std::vector<double>  f{120., 300., 900.}, zeta{0.05, 0.02, 0.1};
  DenseMatrix                phi(2, 3), rest = DenseMatrix::Zero(2, 2);
  phi << 0.3, 0.1, 0.2, 0., 0.2, -0.1;
  rest.diagonal() << 2e-9, 1e-9;
  const auto exact = [&](const Complex s) {
    ComplexMatrix alpha = rest.cast<Complex>() / (1. + 1e-6 * s);
    for (unsigned int j = 0; j < 3; ++j)
      {
        const double omega = 2 * pi * f[j];
        alpha += phi.col(j) * phi.col(j).transpose() /
                 (s * s + 2 * zeta[j] * omega * s + omega * omega);
      }
    return alpha;
  };
  for (double at = 20.; at < 2000.; at *= 1.02)
    {
      frequencies.push_back(at);
      receptances.push_back(exact(at_frequency(at)));
    }
  ModalFitControls controls;
  controls.tolerance    = 2e-3;
  controls.retardation  = 1e-6;
  const FittedModes fit = fit_modes(frequencies, receptances, controls);
  BOOST_TEST(fit.error < 0.01);
  for (const double at : {60., 118., 305., 700., 1500.})
    {
      const Complex s     = at_frequency(at);
      ComplexMatrix alpha = fit.rest.cast<Complex>() / (1. + 1e-6 * s);
      for (std::size_t j = 0; j < fit.frequencies.size(); ++j)
        {
          const double omega = 2 * pi * fit.frequencies[j];
          BOOST_TEST(fit.damping_ratios[j] > 0.);
          alpha +=
            fit.motions.col(j) * fit.motions.col(j).transpose() /
            (s * s + 2 * fit.damping_ratios[j] * omega * s + omega * omega);
        }
      BOOST_TEST((alpha - exact(s)).norm() < 0.02 * exact(s).norm());
    }
  BOOST_TEST(fit.rest(0, 0) == 2e-9, boost::test_tools::tolerance(0.1));
}

BOOST_AUTO_TEST_SUITE_END()
