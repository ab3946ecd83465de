#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include "half_plane.h"
#include "vibrating_pair.h"

#include <rolling_contact/analyses/corrugation_check.h>
#include <rolling_contact/analyses/disturbed_waves.h>
#include <rolling_contact/analyses/wave_in_time.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/vibration/vibrations.h>

#include <cmath>
#include <complex>
#include <memory>

using namespace RollingContact;

/** Waves that are followed in time, beside those of the linearised contact. */
BOOST_AUTO_TEST_SUITE(waves_in_time)

namespace
{
  using Complex = std::complex<double>;

  /** How far a wave in time is from a small one. */
  struct Difference
  {
    Difference(const Complex in_time, const Complex linear)
      : size(std::abs(in_time / linear) - 1)
      , degrees(std::arg(in_time / linear) * 180 / pi)
    {}

    double size, degrees;
  };

  void require_alike(const std::string &what,
                     const WaveInTime  &found,
                     const PassedWave  &linear,
                     const double       share,
                     const double       degrees)
  {
    const Difference growth(found.growth, linear.growth.total()),
      load(found.load, linear.load);
    BOOST_TEST_MESSAGE(
      what << ": growth off by " << growth.size << " and " << growth.degrees
           << " degrees, load by " << load.size << " and " << load.degrees
           << " degrees, after " << found.n_periods << " periods");
    BOOST_TEST(found.settled);
    BOOST_TEST(std::abs(growth.size) < share);
    BOOST_TEST(std::abs(growth.degrees) < degrees);
    BOOST_TEST(std::abs(load.size) < share);
    BOOST_TEST(std::abs(load.degrees) < degrees);
  }

  /** Half-planes of radius and half-width 1 with a mode along each direction,
   * rolled over at a speed of 1.7 half-widths a second. */
  struct RollingPlanes
  {
    explicit RollingPlanes(const double creepage, const int flow = 1)
    {
      HalfPlane::Options of_planes;
      of_planes.n_elements = 32;
      of_planes.creepage   = creepage;
      of_planes.flow       = flow;
      problem              = HalfPlane::half_plane_problem(of_planes);
      options.friction     = FrictionResponse::constant;
      options.speed        = speed;
    }

    /** Falling friction that each node follows by itself must be nearly
     * constant, or the state of the nodes is not stable. */
    void fall(const FrictionResponse response)
    {
      problem.loads.friction_law =
        make_friction_law("exponential",
                          response == FrictionResponse::node ? 0.97 : 0.7,
                          1.);
      problem.loads.speed = speed;
      options.friction    = response;
      options.memory      = 0.2;
    }

    void solve()
    {
      SolverControls controls;
      controls.tolerance  = 1e-12;
      const auto solution = HalfPlane::solve(problem, "automatic", controls);
      BOOST_TEST_REQUIRE(solution.report.converged);
      state = solution.state;
    }

    ReducedPair bodies() const
    {
      const std::size_t N = problem.n_nodes();
      ReducedPair       pair;
      pair.W_res = problem.operators.W().dense();
      pair.K_m = pair.C_m = pair.H_m = DenseMatrix::Zero(2, 2);
      pair.Phi                       = DenseMatrix::Zero(2 * N, 2);
      pair.K_m.diagonal() << 5., 9.;
      pair.C_m.diagonal() << 0.4, 0.3;
      pair.H_m.diagonal() << 0.5, 0.2;
      pair.Phi.block(0, 0, N, 1).setConstant(0.8);
      pair.Phi.block(N, 1, N, 1).setOnes();
      pair.retardation   = 0.01;
      pair.n_wheel_modes = 1;
      return pair;
    }

    WaveSweep sweep() const
    {
      return WaveSweep(problem, state, options, 1., {speed}, [&](const double) {
        return bodies();
      });
    }

    FollowedWave wave(const double k, const double amplitude = 1e-5) const
    {
      FollowedWave wave;
      wave.wave_number = k;
      wave.amplitude   = amplitude;
      wave.speed       = speed;
      wave.n_steps     = 120;
      return wave;
    }

    WaveInTime follow(const FollowedWave      &wave,
                      const std::vector<bool> &border) const
    {
      return wave_in_time(problem, state, options, sweep(), 0, wave, border);
    }

    void check(const std::string &what, const FollowedWave &of) const
    {
      const WaveSweep waves  = sweep();
      const double    k      = of.wave_number;
      const auto      linear = waves.at(k, waves.modal(k)).front();
      require_alike(what,
                    follow(of, std::vector<bool>(problem.n_nodes(), false)),
                    linear,
                    0.005,
                    0.3);
    }

    static constexpr double speed = 1.7;

    ContactProblem       problem;
    ContactState         state;
    LinearContactOptions options;
  };
} // namespace

BOOST_AUTO_TEST_CASE(small_waves_in_time_are_those_of_the_linear_contact)
{
  for (const auto &[creepage, flow] :
       {std::pair(0.5, 1), std::pair(0.5, -1), std::pair(2., 1)})
    {
      RollingPlanes planes(creepage, flow);
      planes.solve();
      planes.check("creepage " + std::to_string(creepage) + ", flow " +
                     std::to_string(flow),
                   planes.wave(0.9));
    }
}

BOOST_AUTO_TEST_CASE(friction_that_falls_follows_waves_in_time)
{
  for (const auto response : {FrictionResponse::constant,
                              FrictionResponse::node,
                              FrictionResponse::patch_mean})
    {
      RollingPlanes planes(2.);
      planes.fall(response);
      planes.solve();
      planes.check("friction response " +
                     std::to_string(static_cast<int>(response)),
                   planes.wave(0.9));
    }
}

BOOST_AUTO_TEST_CASE(patches_at_the_border_are_refused_in_time)
{
  RollingPlanes planes(0.5);
  planes.solve();
  std::string said;
  try
    {
      planes.follow(planes.wave(0.9),
                    std::vector<bool>(planes.problem.n_nodes(), true));
    }
  catch (const ConvergenceError &error)
    {
      said = error.what();
    }
  BOOST_TEST(contains(said, "reaches the border"));
}

namespace
{
  /** Two discs that are alike, of which a part of the patch sticks. */
  template <int dim>
  struct RollingDiscs
  {
    RollingDiscs(const unsigned int n,
                 const Creepages   &creepages,
                 const double       cut_off)
      : pair(
          [&](SceneParameters &scene) {
            VibratingPair::vibrating(scene);
            scene.contact.slip_operator      = SlipOperatorKind::calibrated;
            scene.contact.creepages          = creepages;
            scene.mesh.elements_across_patch = n;
          },
          cut_off)
    {
      const double V = *pair.run.scene.contact.speed;
      options        = linear_contact_options(pair.run.situation());
      waves =
        std::make_unique<WaveSweep>(pair.steady.problem,
                                    pair.steady.state,
                                    options,
                                    dim == 2 ? pair.run.situation().thickness()
                                             : 1.,
                                    std::vector<double>{V},
                                    [&](const double) { return pair.reduced; });
    }

    bool is_partly_sticking() const
    {
      const LinearContact &contact = waves->contact();
      return contact.n_slip() > 0 && contact.n_slip() < contact.touching.size();
    }

    WaveInTime follow(const double length, const double amplitude) const
    {
      FollowedWave wave;
      wave.wave_number = 2 * pi / length;
      wave.amplitude   = amplitude;
      wave.speed       = *pair.run.scene.contact.speed;
      wave.n_steps     = steps_of_period(waves->bodies(0),
                                     wave.speed,
                                     wave.wave_number,
                                     pair.steady.grading.element_size_x);
      return wave_in_time(pair.steady.problem,
                          pair.steady.state,
                          options,
                          *waves,
                          0,
                          wave,
                          pair.steady.pair->trace().border_nodes());
    }

    /** Compare a wave in time with a small one. Units: m. */
    void check(const std::string &what,
               const double       length,
               const double       amplitude,
               const double       share,
               const double       degrees) const
    {
      const double k = 2 * pi / length;
      require_alike(what + ", " + std::to_string(1e3 * length) + " mm",
                    follow(length, amplitude),
                    waves->at(k, waves->modal(k)).front(),
                    share,
                    degrees);
    }

    VibratingPair::Eigenvalues<dim> pair;
    LinearContactOptions            options;
    std::unique_ptr<WaveSweep>      waves;
  };
} // namespace

BOOST_AUTO_TEST_CASE(edges_of_bodies_that_are_alike_move_as_in_time)
{
  // the edge law's pressures are those of the elements, and follow the wave
  const RollingDiscs<2> discs(16, {1e-3, 0., 0.}, 5e3);
  BOOST_TEST(discs.is_partly_sticking());
  BOOST_TEST(!discs.pair.steady.problem.operators.coupling().exists);
  for (const double length : {0.012, 0.03})
    {
      discs.check("10 nm", length, 1e-8, 0.005, 0.5);
      BOOST_TEST(discs.follow(length, 1e-8).n_changed == 0u);
      BOOST_TEST(discs.follow(length, 5e-6).n_changed > 0u);
    }
}

BOOST_AUTO_TEST_CASE(edges_move_as_in_time_on_fine_meshes)
{
  // where little is left of what the edge law takes for smooth, so that it may
  // take another degree of it in time, and would at any pressure at one node
  for (const auto &[n, amplitude] :
       {std::pair(40u, 1e-10), std::pair(48u, 1e-8), std::pair(64u, 1e-9)})
    {
      const RollingDiscs<2> discs(n, {1e-3, 0., 0.}, 5e3);
      BOOST_TEST(discs.is_partly_sticking());
      discs.check(
        std::to_string(n) + " elements", 0.03, amplitude, 0.001, 0.05);
    }
}

BOOST_AUTO_TEST_CASE(waves_of_micrometres_are_followed)
{
  // all slides, and the patch gains and loses nodes
  const RollingDiscs<2> discs(16, {1e-2, 0., 0.}, 5e3);
  BOOST_TEST(!discs.is_partly_sticking());
  discs.check("5 um", 0.03, 5e-6, 0.01, 0.5);
}

BOOST_AUTO_TEST_CASE(steps_are_short_enough_for_fast_modes)
{
  const RollingDiscs<2> discs(16, {1e-3, 0., 0.}, 40e3);
  discs.check("modes up to 40 kHz", 0.03, 1e-8, 0.002, 0.1);
}

BOOST_AUTO_TEST_CASE(waves_over_patches_are_those_in_time)
{
  const RollingDiscs<3> discs(6, {5e-4, -6e-4, 0.2}, 5e3);
  BOOST_TEST(discs.is_partly_sticking());
  discs.check("3D", 0.03, 1e-8, 0.005, 0.5);
}

BOOST_AUTO_TEST_CASE(waves_that_cannot_be_followed_are_refused)
{
  CorrugationParameters section;
  BOOST_TEST(complaint([&] { section.check(); }).empty());
  section.check_amplitude = 0.; // not read
  BOOST_TEST(complaint([&] { section.check(); }).empty());
  section.check_wavelength = 0.03;
  for (const double amplitude : {0., 1e-3})
    {
      section.check_amplitude = amplitude;
      const std::string said  = complaint([&] { section.check(); });
      BOOST_TEST(contains(said, "Corrugation/Check amplitude = "));
      BOOST_TEST(contains(said, "at most 0.00048 m"));
    }
  section.check_amplitude = 4.7e-4;
  BOOST_TEST(complaint([&] { section.check(); }).empty());
  const auto refused = [&](const double highest, const double element) {
    return complaint(
      [&] { check_followed_wave(section, 0.46, 30., highest, element); });
  };
  BOOST_TEST(refused(1000., 0.0075).empty());
  BOOST_TEST(contains(refused(999., 0.001), "1000 Hz, beyond Modes/Maximum"));
  BOOST_TEST(contains(refused(1000., 0.0076), "take at least 0.0304 m"));
  section.check_wavelength = 0.;
  BOOST_TEST(refused(1., 1.).empty());
  // round a wheel, the nearest that fits
  section.check_wavelength = 0.03;
  section.worn             = Side::wheel;
  BOOST_TEST(std::abs(section.check_wavelength_round(0.46) -
                      2 * pi * 0.46 / 96) < 1e-15);
}

BOOST_AUTO_TEST_SUITE_END()
