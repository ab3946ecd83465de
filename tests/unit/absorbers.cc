#include <boost/test/unit_test.hpp>

#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/modes/absorbers.h>
#include <rolling_contact/stability/reduced_pair.h>
#include <rolling_contact/vibration/reduced_motion.h>

#include <algorithm>
#include <cmath>

using namespace RollingContact;
using Complex = std::complex<double>;

/** Rings of dampers on modes. */
BOOST_AUTO_TEST_SUITE(absorbers)

namespace
{
  /** Places on modes of a free ring whose coordinates of order d = 0 ... D move
   * by p_d: a mode for order 0, two for each other. */
  AbsorberPlaces places_on_ring(const std::vector<double> &p)
  {
    const std::size_t c = 2 * p.size() - 1;
    AbsorberPlaces    places;
    places.diameters = {static_cast<unsigned int>(p.size() - 1)};
    places.motions   = DenseMatrix::Zero(c, c);
    places.residual  = DenseMatrix::Zero(c, c);
    for (std::size_t i = 0; i < c; ++i)
      places.motions(i, i) = p[(i + 1) / 2];
    return places;
  }

  /** eta'' + C eta' + K eta = 0. */
  ComplexValues vibrations(const DenseMatrix &K, const DenseMatrix &C)
  {
    const std::size_t m = K.rows();
    const double      w = 1e3;
    DenseMatrix       A = DenseMatrix::Zero(2 * m, 2 * m);
    for (std::size_t j = 0; j < m; ++j)
      {
        A(j, m + j) = w;
        for (std::size_t i = 0; i < m; ++i)
          {
            A(m + i, j)     = -K(i, j) / w;
            A(m + i, m + j) = -C(i, j);
          }
      }
    return eigenvalues(std::move(A));
  }

  /** How far each of some values is from the nearest of others, at most. */
  double farthest(const ComplexValues &some, const ComplexValues &others)
  {
    double worst = 0.;
    for (const Complex &s : some)
      {
        double nearest = 1e300;
        for (const Complex &other : others)
          nearest = std::min(nearest, std::abs(s - other));
        worst = std::max(worst, nearest);
      }
    return worst;
  }

  /** A modal amplitude under a unit force on it. */
  Complex response(const DenseMatrix &K, const DenseMatrix &C, const Complex s)
  {
    ComplexMatrix D = K + s * C;
    D.diagonal().array() += s * s;
    ComplexVector x = ComplexVector::Unit(K.rows(), 0);
    ComplexLU(std::move(D)).solve(x);
    return x[0];
  }
} // namespace

/** Den Hartog: with a frequency of 1/(1 + mu) of the mode's two points of the
 * response, at sqrt(1 + 2/mu) of the static one, do not depend on the damping;
 * with his damping they are its peaks. */
BOOST_AUTO_TEST_CASE(one_mode_with_the_best_damper)
{
  const double host = 3.2, mu = 0.05, omega = 2 * pi * 500.; // kg, 1, rad/s
  auto         places = places_on_ring({1 / std::sqrt(host)});
  AbsorberRing ring;
  ring.number           = 4;
  ring.mass             = mu * host / 4;
  ring.frequency        = 500. / (1 + mu);
  const double expected = std::sqrt(1 + 2 / mu),
               best     = std::sqrt(3 * mu / (8 * (1 + mu)));
  double largest        = 0.;
  for (const double damping : {0.02, best, 0.6})
    {
      ring.damping_ratio = damping;
      DenseMatrix K = DenseMatrix::Zero(1, 1), C = DenseMatrix::Zero(1, 1);
      K(0, 0) = omega * omega;
      hang_absorbers(places, {ring}, 0., K, C);
      for (const double sign : {-1., 1.})
        {
          const double g =
            std::sqrt((1 + sign * std::sqrt(mu / (2 + mu))) / (1 + mu));
          const Complex s(0., g * omega);
          BOOST_TEST(std::abs(response(K, C, s)) * omega * omega == expected,
                     boost::test_tools::tolerance(1e-10));
          // as a dynamic stiffness on the same mode
          const Complex Z = absorber_stiffness(places, {ring}, 0., s)(0, 0);
          BOOST_TEST(std::abs(omega * omega /
                              (omega * omega + s * s + Z / host)) == expected,
                     boost::test_tools::tolerance(1e-10));
        }
      if (damping == best)
        for (double g = 0.5; g < 1.5; g += 1e-3)
          largest = std::max(largest,
                             std::abs(response(K, C, Complex(0., g * omega))) *
                               omega * omega);
    }
  BOOST_TEST(largest == expected, boost::test_tools::tolerance(2e-3));
}

namespace
{
  /** Modes of order d and n single absorbers on them in the wheel's own frame,
   * each mass a coordinate at its angle. */
  ComplexValues in_the_wheels_frame(const unsigned int  d,
                                    const double        omega,
                                    const double        p,
                                    const AbsorberRing &ring)
  {
    const unsigned int n  = ring.number;
    const double       w0 = 2 * pi * ring.frequency, k = ring.mass * w0 * w0,
                 c = 2 * ring.damping_ratio * ring.mass * w0;
    DenseMatrix K  = DenseMatrix::Zero(2 + n, 2 + n),
                C  = DenseMatrix::Zero(2 + n, 2 + n);
    for (unsigned int j = 0; j < 2; ++j)
      {
        K(j, j) = omega * omega;
        C(j, j) = 2e-3 * omega;
      }
    for (unsigned int q = 0; q < n; ++q)
      {
        const double        angle = 0.3 + 2 * pi * q / n;
        std::vector<double> e(2 + n, 0.);
        e[0]     = -p * std::sqrt(2.) * std::cos(d * angle);
        e[1]     = -p * std::sqrt(2.) * std::sin(d * angle);
        e[2 + q] = 1 / std::sqrt(ring.mass);
        for (unsigned int i = 0; i < 2 + n; ++i)
          for (unsigned int j = 0; j < 2 + n; ++j)
            {
              K(i, j) += k * e[i] * e[j];
              C(i, j) += c * e[i] * e[j];
            }
      }
    return vibrations(K, C);
  }
} // namespace

/** A wheel that turns under the place it is seen from: a vibration with d nodal
 * diameters at s in the wheel's own frame, where the dampers are points, is at
 * s +- i d Omega here, where they are a ring. */
BOOST_AUTO_TEST_CASE(dampers_turn_with_the_wheel)
{
  const double              rate = 21.;
  const std::vector<double> p{0.05, 0.07, 0.06}, omegas{1500., 2100., 3000.};
  for (const unsigned int n : {5u, 6u, 12u})
    for (const unsigned int d : {1u, 2u})
      {
        AbsorberRing ring;
        ring.number        = n;
        ring.mass          = 1.5;
        ring.frequency     = omegas[d] / (2 * pi) * 0.97;
        ring.damping_ratio = 0.06;
        const auto  places = places_on_ring(p);
        ReducedPair wheel;
        wheel.K_m = wheel.C_m = DenseMatrix::Zero(5, 5);
        DenseMatrix S         = DenseMatrix::Zero(5, 5);
        for (unsigned int j = 0; j < 5; ++j)
          {
            const unsigned int order = (j + 1) / 2;
            wheel.K_m(j, j)          = omegas[order] * omegas[order];
            wheel.C_m(j, j)          = 2e-3 * omegas[order];
            if (j % 2 == 1)
              {
                S(j, j + 1) = order;
                S(j + 1, j) = -double(order);
              }
          }
        add_rotation(wheel, S, rate);
        hang_absorbers(places, {ring}, rate, wheel.K_m, wheel.C_m);
        const ComplexValues here = vibrations(wheel.K_m, wheel.C_m);

        const double  w0 = 2 * pi * ring.frequency;
        const Complex alone(-ring.damping_ratio * w0,
                            w0 *
                              std::sqrt(1 - std::pow(ring.damping_ratio, 2.)));
        ComplexValues expected;
        for (const Complex &s : in_the_wheels_frame(d, omegas[d], p[d], ring))
          if (s.imag() > 0. && std::abs(s - alone) > 1.) // not of other orders
            for (const double way : {-1., 1.})
              expected.push_back(s + Complex(0., way * d * rate));
        BOOST_TEST(expected.size() == 8u); // two pairs in the wheel's frame
        BOOST_TEST(farthest(expected, here) < 1e-5);
      }
}

/** Dampers that are carried along at rest carry nothing, and what a vibration
 * loses is what the dashpots take. */
BOOST_AUTO_TEST_CASE(energies_in_time)
{
  const auto   places = places_on_ring({0.05, 0.07, 0.06});
  AbsorberRing ring;
  ring.number        = 7;
  ring.mass          = 2.;
  ring.frequency     = 300.;
  ring.damping_ratio = 0.1;
  for (const double rate : {0., 20.})
    {
      ReducedPair pair;
      pair.K_m = pair.C_m = DenseMatrix::Zero(5, 5);
      DenseMatrix S       = DenseMatrix::Zero(5, 5);
      for (unsigned int j = 0; j < 5; ++j)
        pair.K_m(j, j) = std::pow(2 * pi * (250. + 40. * ((j + 1) / 2)), 2.);
      for (unsigned int j = 1; j < 5; j += 2)
        {
          S(j, j + 1) = (j + 1) / 2;
          S(j + 1, j) = -S(j, j + 1);
        }
      add_rotation(pair, S, rate);
      hang_absorbers(places, {ring}, rate, pair.K_m, pair.C_m);
      pair.Phi   = DenseMatrix::Zero(2, 10);
      pair.W_res = DenseMatrix::Zero(2, 2);
      for (unsigned int i = 0; i < 2; ++i)
        pair.W_res(i, i) = 1e-9;
      for (unsigned int j = 0; j < 5; ++j)
        pair.Phi(0, j) = 0.1;
      ReducedMotion motion(pair);
      if (rate == 0.)
        {
          const std::vector<double> forces{100., 0.};
          std::vector<double>       eta(5);
          // statics of the modes alone, without the springs of the dampers
          for (unsigned int j = 0; j < 5; ++j)
            eta[j] = 10. / std::pow(2 * pi * (250. + 40. * ((j + 1) / 2)), 2.);
          std::vector<double> all = eta;
          for (const double z :
               absorbers_at_rest(places, {ring}, eta, std::vector<double>(5)))
            all.push_back(z);
          motion.rest_at(all, forces);
          double load = 0., scale = 0.;
          for (std::size_t k = 0; k < 10; ++k)
            {
              load  = std::max(load, std::abs(motion.load_at_rest()[k]));
              scale = std::max(scale, std::abs(pair.K_m(k, k) * all[k]));
            }
          BOOST_TEST(load < 1e-9 * scale);
        }
      motion.rest_at(std::vector<double>(10), {0., 0.});
      ReducedState state = motion.state();
      for (unsigned int k = 0; k < 10; ++k)
        {
          state.eta[k]  = k < 5 ? 1e-5 * (1. + k) : 0.;
          state.rate[k] = 0.;
        }
      motion.set_state(state);
      motion.set_time_step(1e-5);
      const double start = motion.energy().kinetic + motion.energy().strain;
      double       lost = 0., most = 0.;
      for (unsigned int k = 0; k < 3000; ++k)
        {
          motion.begin_step();
          const StepEnergy &energy = motion.end_step({0., 0.});
          lost += energy.damping;
          most = std::max(most, std::abs(energy.balance_error));
        }
      const double left = motion.energy().kinetic + motion.energy().strain;
      BOOST_TEST(most < 1e-12 * start);
      BOOST_TEST(lost == start - left, boost::test_tools::tolerance(1e-9));
      BOOST_TEST(left < 0.03 * start);
    }
}

BOOST_AUTO_TEST_SUITE_END()
