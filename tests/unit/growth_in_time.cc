#include <deal.II/lac/vector.h>

#include <boost/test/unit_test.hpp>

#include "vibrating_pair.h"

#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/base/text.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace RollingContact;
using namespace VibratingPair;

/** Small vibrations of rolling by two programs that share the matrices of the
 * bodies alone: steps of the theta-scheme, and eigenvalues. */
BOOST_AUTO_TEST_SUITE(growth_in_time)

namespace
{
  using Complex = std::complex<double>;

  /**
   * Forces of a run in time (N), and those of its steady start.
   */
  struct Recording
  {
    double                             step = 0.; ///< s
    std::vector<std::array<double, 3>> forces;
    std::array<double, 3>              steady{{0., 0., 0.}}; ///< N
    std::size_t                        n_nodes = 0;
  };

  /**
   * A steady state, an approach that is larger by 1e-5 for 0.6 ms, and what
   * follows from a time on. Units: s.
   */
  template <int dim>
  Recording record(const Change &change,
                   const double  step,
                   const double  from,
                   const double  end)
  {
    TimeRun<dim> run([&](SceneParameters &scene) {
      change(scene);
      scene.time.time_step = step;
      scene.time.approach =
        significant(*scene.contact.approach, 12) +
        " * (1 + if(t < 6e-4, 1e-5 * sin(pi * t / 6e-4)^2, 0))";
    });
    Recording    result;
    result.step       = step;
    const auto forces = [&]() -> std::array<double, 3> {
      const Resultants &now = run.stepper->current().result;
      return {{now.normal_force, now.force_x, now.force_y}};
    };
    result.steady  = forces();
    result.n_nodes = run.stepper->current().problem.n_nodes();
    for (long k = 0; k < std::lround(end / step); ++k)
      {
        run.march(1);
        BOOST_TEST_REQUIRE(run.last.n_parts == 1u);
        if (k * step > from)
          result.forces.push_back(forces());
      }
    return result;
  }

  /**
   * The exponents s of the vibrations that a recording is the sum of (ESPRIT):
   * the span of its windows does not change by a step later. A step of theta =
   * 1/2 multiplies by z = (1 + s h / 2) / (1 - s h / 2). Units: 1/s.
   */
  ComplexValues exponents(const Recording &recording, const std::size_t order)
  {
    const std::size_t n = recording.forces.size(), window = n / 3,
                      n_windows = n - window;
    DenseMatrix windows         = DenseMatrix::Zero(window, 3 * n_windows);
    for (unsigned int c = 0; c < 3; ++c)
      {
        const double steady  = recording.steady[c];
        double       largest = 1e-30;
        for (const auto &force : recording.forces)
          largest = std::max(largest, std::abs(force[c] - steady));
        for (std::size_t j = 0; j < n_windows; ++j)
          for (std::size_t i = 0; i < window; ++i)
            windows(i, c * n_windows + j) =
              (recording.forces[i + j][c] - steady) / largest;
      }
    std::vector<double> values;
    const DenseMatrix span = left_singular_vectors(std::move(windows), values);
    const auto        now  = span.topLeftCorner(window - 1, order),
               later       = span.block(1, 0, window - 1, order);
    DenseMatrix gram = now.transpose() * now, shift = now.transpose() * later;
    BOOST_TEST_REQUIRE(solve_general(gram, shift));
    ComplexValues result;
    for (const Complex &z : eigenvalues(shift))
      result.push_back(2. / recording.step * (z - 1.) / (z + 1.));
    return result;
  }

  /**
   * From the eigenvalue to the nearest exponent, over its size.
   */
  double difference(const CorrectedMode &mode, const ComplexValues &found)
  {
    Complex best = found.at(0);
    for (const Complex &s : found)
      if (std::abs(s - mode.s) < std::abs(best - mode.s))
        best = s;
    BOOST_TEST_MESSAGE("eigenvalue " << mode.s.imag() / (2 * pi) << " Hz, "
                                     << mode.growth() << " 1/s, in time "
                                     << best.imag() / (2 * pi) << " Hz, "
                                     << best.real() << " 1/s; by modes alone "
                                     << mode.reduced.real());
    return std::abs(best - mode.s) / std::abs(mode.s);
  }
} // namespace

BOOST_AUTO_TEST_CASE(a_vibration_that_grows_in_full_slip)
{
  const Change   change = unstable_pair;
  Eigenvalues<3> eigen(change, 12e3);
  const auto     recording = record<3>(change, 2e-5, 6e-4, 10e-3);
  BOOST_TEST(recording.n_nodes == eigen.steady.problem.n_nodes());
  BOOST_TEST(eigen.contact.n_slip() == eigen.contact.touching.size());
  const auto found     = exponents(recording, 22);
  unsigned   n_growing = 0;
  for (const CorrectedMode &mode : eigen.vibrations(1700., 2100.))
    {
      const bool grows = mode.growth() > 0.;
      n_growing += grows;
      BOOST_TEST(difference(mode, found) < (grows ? 1e-5 : 1e-4));
      // what the modes leave out is damped as well
      if (grows)
        BOOST_TEST(std::abs(mode.reduced.real() / mode.growth() - 1.) < 1e-3);
    }
  BOOST_TEST(n_growing == 1u);
}

BOOST_AUTO_TEST_CASE(vibrations_that_the_flow_damps_in_partial_slip)
{
  const Change change = [](SceneParameters &scene) {
    vibrating(scene);
    scene.mesh.elements_across_patch = 12;
    scene.mesh.growth                = 0.8;
    scene.contact.approach           = 6e-5;
    scene.contact.creepages.x        = 0.002;
  };
  Eigenvalues<2> eigen(change, 80e3);
  // what the flow carries through the patch has gone after 3 ms
  const auto recording = record<2>(change, 2e-5, 3e-3, 10e-3);
  BOOST_TEST(recording.n_nodes == eigen.steady.problem.n_nodes());
  BOOST_TEST(eigen.contact.n_slip() > 4u);
  BOOST_TEST(eigen.contact.n_slip() + 4u < eigen.contact.touching.size());
  const auto found   = exponents(recording, 22);
  unsigned   n_alike = 0;
  for (const CorrectedMode &mode : eigen.vibrations(2000., 5200.))
    n_alike += difference(mode, found) < 5e-5;
  BOOST_TEST(n_alike >= 3u);
  // mostly damped by the rolling, not by the bodies
  const CorrectedMode mode = eigen.vibrations(2500., 2600.).at(0);
  BOOST_TEST(difference(mode, found) < 1e-5);
  BOOST_TEST(mode.growth() < -200.);
}

BOOST_AUTO_TEST_SUITE_END()
