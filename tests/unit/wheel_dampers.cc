#include <boost/test/unit_test.hpp>

#include "ring_with_dampers.h"

#include <rolling_contact/modes/frequency_response.h>
#include <rolling_contact/modes/node_rings.h>

#include <sstream>

using namespace RollingContact;
using namespace RingWithDampers;

/** Dampers on bodies with a mesh. */
BOOST_AUTO_TEST_SUITE(wheel_dampers)

BOOST_AUTO_TEST_CASE(they_hang_on_the_nearest_circles_of_nodes)
{
  const Ring ring(9e3);
  BOOST_TEST(ring.places.diameters.size() == 2u);
  BOOST_TEST(ring.places.diameters[0] >= 2u);
  BOOST_TEST(ring.places.diameters[1] <= 4u); // nine tell four apart
  BOOST_TEST(ring.notes[0].find("radius 0.2 m, position 0.01 m, 0 mm") !=
             std::string::npos);
  // all that moves along the axle by 1 moves the mean of the first ring by 1
  const std::size_t n    = ring.K.size();
  double            mean = 0., others = 0.;
  for (const auto &node : ring.at.nodes)
    if (node.unknowns[1] >= 0)
      for (std::size_t i = 0; i < 2 * ring.places.diameters[0] + 1; ++i)
        (i == 0 ? mean : others) += ring.places.loads(node.unknowns[1], i);
  BOOST_TEST(mean == 1., boost::test_tools::tolerance(1e-12));
  BOOST_TEST(std::abs(others) < 1e-12);
  BOOST_TEST(n > 300u);
  // modes of a pair turn into each other as the ring's coordinates do, the same
  // way round
  const DenseMatrix S   = modal_rotation(ring.S, ring.modes.shapes),
                    P_S = ring.places.motions * S;
  double common = 0., size = 0.;
  for (std::size_t j = 0; j < ring.modes.size(); ++j)
    for (unsigned int d = 1; d <= 2; ++d)
      {
        const double cosine = ring.places.motions(2 * d - 1, j),
                     sine   = ring.places.motions(2 * d, j);
        common += P_S(2 * d - 1, j) * d * sine - P_S(2 * d, j) * d * cosine;
        size += d * d * (cosine * cosine + sine * sine);
      }
  BOOST_TEST_MESSAGE("flow: " << common / size);
  // 24 cells and modes that are not all of them: a sign would give -1
  BOOST_TEST(common > 0.7 * size);
  BOOST_TEST(common < 1.05 * size);
}

/** Of all unknowns at once, by the modes as a preconditioner and by a dense
 * factor of the bodies and the masses of the dampers. */
/** Sixteen nodes on each of two circles, as a file with six digits has them. */
BOOST_AUTO_TEST_CASE(circles_of_nodes_are_found_in_rounded_coordinates)
{
  const auto rounded = [](const double x) {
    std::ostringstream text;
    text.precision(6);
    text << x;
    return std::stod(text.str());
  };
  BodyPlaces places = Ring(9e3).at;
  places.nodes.clear();
  for (const double radius : {0.46, 0.459})
    for (unsigned int k = 0; k < 16; ++k)
      {
        BodyPlaces::Node node;
        const double     angle = 2 * pi * (k + 0.3) / 16;
        node.point             = {{rounded(radius * std::cos(angle)),
                                   1e-9 * k,
                                   rounded(radius * std::sin(angle))}};
        node.mass              = 0.1;
        places.nodes.push_back(node);
      }
  const Axle axle{{{0., 0., 0.}}, {{0., 1., 0.}}};
  const auto rings = node_rings(places, axle);
  BOOST_TEST(rings.size() == 2u);
  for (const NodeRing &ring : rings)
    {
      BOOST_TEST(ring.nodes.size() == 16u);
      BOOST_TEST(ring.mass == 1.6, boost::test_tools::tolerance(1e-12));
    }
  // astride any of the borders that a grid could have
  for (double shift = 0.; shift < 1e-6; shift += 2e-8)
    {
      auto moved = places;
      for (std::size_t k = 0; k < moved.nodes.size(); ++k)
        moved.nodes[k].point[1] = shift + (k % 2) * 1e-9;
      BOOST_TEST(node_rings(moved, axle).size() == 2u);
    }
}

BOOST_AUTO_TEST_CASE(whole_bodies_have_their_dampers_and_losses)
{
  Ring ring(9e3);
  ring.H                         = linear_combination(0.03, ring.K, 0., ring.M);
  const double              rate = 50.;
  const ReducedPair         modal = ring.reduced(rate);
  const std::vector<double> no_ratios(ring.modes.size(), 0.);
  const auto                rings = ring.parameters.absorbers();
  const FullDynamics        full(
    TurningStructure{ring.K, ring.M, ring.C, ring.H, ring.S, rate},
    ring.factor,
    ring.modes,
    no_ratios,
    modal.K_m,
    modal.C_m,
    AttachedDynamics{ring.places.loads,
                     ring.places.deflected,
                     ring.places.residual,
                     ring.places.motions,
                     ring.places.statics,
                     [&](const Complex s) {
                       return absorber_stiffness(ring.places, rings, rate, s);
                     }});
  int                 unknown;
  const ComplexVector b     = force_on_contact(ring, unknown);
  ComplexVector       other = ComplexVector::Zero(b.size());
  other[unknown - 1]        = Complex(0.5, -2.);
  // side by side, with loads and numbers of steps of their own
  const ComplexValues              s     = {{15., 2 * pi * 2400.},
                                            {15., 2 * pi * 4100.},
                                            {-40., 2 * pi * 300.}};
  const std::vector<ComplexVector> loads = {b, other, b};
  const auto                       x     = full.solve(s, loads, 1e-11);
  for (std::size_t k = 0; k < s.size(); ++k)
    {
      const ComplexVector exact = solved_densely(ring, rate, s[k], loads[k]);
      BOOST_TEST((x[k] - exact).norm() / exact.norm() < 1e-8);
      BOOST_TEST(full.solve({s[k]}, {loads[k]}, 1e-11)[0].norm() /
                     exact.norm() ==
                   1.,
                 boost::test_tools::tolerance(1e-8));
    }
}

namespace
{
  /** A force at one unknown and its motion, by modes, dampers and what the
   * modes leave out. */
  struct AtOnePoint
  {
    AtOnePoint(const Ring &ring, const int unknown, const double rate)
      : pair(ring.reduced(rate))
    {
      const auto        rings = ring.parameters.absorbers();
      const std::size_t n = ring.K.size(), m = ring.modes.size(),
                        c = ring.places.n_coordinates();
      std::vector<double> load(n, 0.);
      load[unknown]        = 1.;
      const auto deflected = ring.factor.solve(load);
      pair.W_res           = DenseMatrix::Zero(1, 1);
      pair.W_res(0, 0)     = deflected[unknown];
      pair.Phi             = DenseMatrix::Zero(1, m);
      DenseMatrix cross    = DenseMatrix::Zero(1, c);
      for (std::size_t k = 0; k < c; ++k)
        cross(0, k) = ring.places.deflected(unknown, k);
      for (std::size_t j = 0; j < m; ++j)
        {
          const double phi    = ring.modes.shapes(unknown, j),
                       lambda = ring.modes.eigenvalue(j);
          pair.Phi(0, j)      = phi;
          pair.W_res(0, 0) -= phi * phi / lambda;
          for (std::size_t k = 0; k < c; ++k)
            cross(0, k) -= phi * ring.places.motions(k, j) / lambda;
        }
      hang_absorbers(ring.places, rings, rate, pair.K_m, pair.C_m);
      join_absorbers(ring.places, rings, cross, pair.Phi, pair.W_res);
    }

    Complex response(const Complex s) const
    {
      ComplexMatrix D = pair.K_m + s * pair.C_m;
      D.diagonal().array() += s * s;
      ComplexVector eta = pair.Phi.transpose().cast<Complex>();
      ComplexLU(std::move(D)).solve(eta);
      return pair.W_res(0, 0) + (pair.Phi * eta)[0];
    }

    ReducedPair pair;
  };
} // namespace

/** The reduced equations have the response of the whole ring with dampers, and
 * its statics exactly. */
BOOST_AUTO_TEST_CASE(what_the_modes_leave_out_is_there)
{
  Ring ring(9e3);
  // so stiff that what is left out softens them by several per cent
  ring.parameters.dampers.mass      = {0.4};
  ring.parameters.dampers.frequency = {6000.};
  BOOST_TEST(softening(ring.places, ring.parameters.absorbers()) > 0.05);
  int                 unknown;
  const ComplexVector b = force_on_contact(ring, unknown);
  const AtOnePoint    standing(ring, unknown, 0.), turning(ring, unknown, 50.);
  std::vector<double> load(b.size(), 0.);
  load[unknown] = 1.;
  BOOST_TEST(standing.response(0.).real() == ring.factor.solve(load)[unknown],
             boost::test_tools::tolerance(1e-9));
  for (const double f : {1300., 1500., 1700.})
    {
      const Complex s(0., 2 * pi * f),
        exact            = solved_densely(ring, 50., s, b)[unknown];
      const double error = std::abs(turning.response(s) / exact - 1.);
      BOOST_TEST_MESSAGE(f << " Hz: " << error);
      BOOST_TEST(error < 2.2e-3); // 2.8e-3 without R
    }
}

/** Receptances of the wheel and of the motions its dampers follow give those
 * with dampers. */
BOOST_AUTO_TEST_CASE(receptances_with_dampers)
{
  const Ring                       ring(9e3);
  const auto                       rings = ring.parameters.absorbers();
  int                              unknown;
  const ComplexVector              b = force_on_contact(ring, unknown);
  const std::size_t                n = b.size();
  std::vector<std::vector<double>> loads{std::vector<double>(n, 0.)};
  loads[0][unknown] = 1.;
  for (std::size_t k = 0; k < ring.places.n_coordinates(); ++k)
    loads.emplace_back(ring.places.loads.data() + k * n,
                       ring.places.loads.data() + (k + 1) * n);
  const VibratingStructure structure{
    ring.K, ring.M, {}, ring.C, ring.body.nodes_of_unknowns()};
  const FrequencyResponse response(structure,
                                   ring.factor,
                                   0.,
                                   ring.modes,
                                   std::vector<double>(ring.modes.size(), 0.),
                                   loads);
  for (const double f : {1900., 2450.})
    {
      const Complex s(0., 2 * pi * f),
        exact             = solved_densely(ring, 0., s, b)[unknown];
      const auto    alpha = response.receptances(f);
      const Complex found =
        receptances_with(alpha,
                         absorber_stiffness(ring.places, rings, 0., s),
                         1)(0, 0);
      BOOST_TEST_MESSAGE(f << " Hz: " << std::abs(found / exact - 1.)
                           << ", without dampers "
                           << std::abs(alpha(0, 0) / exact - 1.));
      BOOST_TEST(std::abs(found / exact - 1.) < 2e-3);
      BOOST_TEST(std::abs(alpha(0, 0) / exact - 1.) > 2e-2);
    }
}

BOOST_AUTO_TEST_SUITE_END()
