#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include "half_plane.h"
#include "stability_bodies.h"
#include "vibrating_pair.h"

#include <rolling_contact/analyses/corrugation_report.h>
#include <rolling_contact/analyses/disturbed_waves.h>
#include <rolling_contact/contact/node_lines.h>
#include <rolling_contact/references/wavy_carter.h>
#include <rolling_contact/stability/passing_waves.h>
#include <rolling_contact/stability/wave_sweep.h>

using namespace RollingContact;

/** Waves that pass a contact, and how wear lets them grow. */
BOOST_AUTO_TEST_SUITE(corrugation)

namespace
{
  using Complex = std::complex<double>;

  /** A line contact with a wave, half-width, radius and peak pressure 1. */
  struct Case
  {
    double  creepage; ///< over saturation
    double  ka;
    Complex alpha, alpha_t; ///< of the bodies beyond the half-planes
  };

  const double speed = 1.7;

  /** A mode that answers forces at a rate i w by a given compliance. */
  void set_mode(const unsigned int mode,
                const Complex      compliance,
                const double       w,
                const std::size_t  first,
                const std::size_t  n,
                ReducedPair       &pair)
  {
    const Complex stiffness = 1. / compliance;
    pair.K_m(mode, mode)    = stiffness.real() + w * w;
    pair.C_m(mode, mode)    = stiffness.imag() / w;
    pair.Phi.block(first, mode, n, 1).setOnes();
  }

  ReducedPair
  bodies(const ContactProblem &problem, const Case &at, const double w)
  {
    const std::size_t N     = problem.n_nodes();
    const bool        drags = at.alpha_t != 0.;
    ReducedPair       pair;
    pair.W_res = problem.operators.W().dense();
    pair.K_m = pair.C_m = DenseMatrix::Zero(1 + drags, 1 + drags);
    pair.Phi            = DenseMatrix::Zero(2 * N, 1 + drags);
    set_mode(0, at.alpha, w, N, N, pair);
    if (drags)
      set_mode(1, at.alpha_t, w, 0, N, pair);
    return pair;
  }

  References::WavyCarter closed_form(const Case &at)
  {
    return References::WavyCarter({1.,
                                   1.,
                                   2.,
                                   std::exp(3.),
                                   HalfPlane::mu,
                                   at.creepage * HalfPlane::mu,
                                   1.,
                                   at.ka,
                                   at.alpha,
                                   at.alpha_t});
  }

  struct Rolling
  {
    Rolling(const unsigned int n,
            const double       offset,
            const double       creepage,
            const int          flow = 1)
    {
      HalfPlane::Options options;
      options.n_elements = n;
      options.offset     = offset;
      options.creepage   = creepage;
      options.flow       = flow;
      problem            = HalfPlane::half_plane_problem(options);
      SolverControls controls;
      controls.tolerance = 1e-11;
      solution           = HalfPlane::solve(problem, "automatic", controls);
      BOOST_TEST(solution.report.converged);
    }

    WaveSweep sweep(const std::vector<double>      &speeds,
                    const WaveSweep::BodiesAtSpeed &at) const
    {
      LinearContactOptions options;
      options.friction = FrictionResponse::constant;
      return WaveSweep(problem, solution.state, options, 1., speeds, at);
    }

    PassedWave wave(const Case &at) const
    {
      const WaveSweep waves = sweep({speed}, [&](const double V) {
        return bodies(problem, at, V * at.ka);
      });
      return waves.at(at.ka, waves.modal(at.ka)).front();
    }

    ContactProblem      problem;
    HalfPlane::Solution solution;
  };

  /** Largest difference of growth from the closed form over the place of the
   * mesh, over what wears flat by pressure alone, k_w mu xi pi E*. */
  double error_of_growth(const unsigned int n, const Case &at)
  {
    const Complex exact = closed_form(at).growth().total();
    double        worst = 0.;
    for (const double offset : {0., 0.25, 0.5, 0.75})
      worst =
        std::max(worst,
                 std::abs(
                   Rolling(n, offset, at.creepage).wave(at).growth.total() -
                   exact));
    return worst / (HalfPlane::mu * at.creepage * HalfPlane::mu * pi * 2.);
  }
} // namespace

BOOST_AUTO_TEST_CASE(growth_is_that_of_the_wavy_line_contact)
{
  // by what bodies the second is near a resonance, where crests carry more
  for (const auto &[at, coarse, fine] :
       {std::tuple(Case{0.5, 0.39, {-2.9, -0.28}, 0.}, 0.004, 0.001),
        std::tuple(Case{0.5, 1.26, {0.14, -0.50}, 0.}, 0.0125, 0.003),
        std::tuple(Case{0.5, 0.5, {1.2, 0.}, {0.6, -0.6}}, 0.004, 0.001),
        std::tuple(Case{0.9, 1., {1.2, 0.}, 0.}, 0.005, 0.002),
        std::tuple(Case{2., 1., {1.2, 0.}, 0.}, 0.0095, 0.0024),
        std::tuple(Case{2., 1., {1.2, 0.}, {0.6, -0.6}}, 0.0095, 0.0024)})
    {
      const double with_32  = error_of_growth(32, at),
                   with_128 = error_of_growth(128, at);
      BOOST_TEST_MESSAGE("creepage " << at.creepage << ", ka " << at.ka
                                     << ": growth off by " << with_32
                                     << " with 32 elements, " << with_128
                                     << " with 128");
      BOOST_TEST(with_32 < coarse);
      BOOST_TEST(with_128 < fine);
    }
}

BOOST_AUTO_TEST_CASE(the_load_on_crests_is_that_of_the_wavy_line_contact)
{
  const Case       at{0.5, 1., {0.3, -0.4}, 0.};
  const PassedWave found = Rolling(128, 0.3, at.creepage).wave(at);
  const Complex    exact = closed_form(at).load();
  BOOST_TEST_MESSAGE("load off by "
                     << std::abs(found.load / exact - 1.) << ", filter by "
                     << found.filter - std::cyl_bessel_j(0., 1.));
  BOOST_TEST(std::abs(found.load - exact) < 0.006 * std::abs(exact));
  // what a wave loses to one that lifts the whole patch: J0(ka)
  BOOST_TEST(std::abs(found.filter - std::cyl_bessel_j(0., 1.)) < 0.001);
  // long waves lose nothing
  const Case longer{0.5, 1e-3, {0.3, -0.4}, 0.};
  BOOST_TEST(std::abs(Rolling(32, 0.3, 0.5).wave(longer).filter - 1) < 1e-5);
}

BOOST_AUTO_TEST_CASE(a_long_wave_wears_as_the_load_it_makes)
{
  // by the states under loads a few percent apart, whose edges pass nodes
  for (const double creepage : {0.3, 0.5, 0.8})
    {
      const auto power = [&](const double change) {
        double sum = 0.;
        for (const double offset : {0., 0.25, 0.5, 0.75})
          {
            HalfPlane::Options options;
            options.n_elements        = 64;
            options.offset            = offset;
            options.creepage          = creepage;
            ContactProblem problem    = HalfPlane::half_plane_problem(options);
            problem.loads.normal_load = pi / 2 * (1 + change);
            sum += HalfPlane::solve(problem).result.dissipation / 4;
          }
        return sum;
      };
      const double by_load = (power(0.025) - power(-0.025)) / (0.05 * pi / 2);
      Complex      growth = 0., load = 0.;
      for (const double offset : {0., 0.25, 0.5, 0.75})
        {
          const PassedWave wave =
            Rolling(64, offset, creepage).wave({creepage, 1e-3, 0.4, 0.});
          growth += wave.growth.total();
          load += wave.load;
        }
      const double found = -(growth / load).real();
      BOOST_TEST_MESSAGE("creepage " << creepage << ": power over load "
                                     << found << " of waves, " << by_load
                                     << " of states 5 % of the load apart");
      BOOST_TEST(std::abs(found / by_load - 1) < 0.004);
    }
}

BOOST_AUTO_TEST_CASE(a_factor_serves_all_speeds)
{
  const Rolling rolling(24, 0.2, 0.5);
  const auto    lossy = [&](const double) {
    ReducedPair pair = bodies(rolling.problem, {0.5, 1., {0.3, -0.2}, 0.1}, 2.);
    pair.retardation = 0.02;
    return pair;
  };
  const std::vector<double> speeds{0.5, 1., 3.};
  const auto                passed = [&](const std::vector<double> &at) {
    const WaveSweep waves = rolling.sweep(at, lossy);
    return waves.at(1.3, waves.modal(1.3));
  };
  const auto together = passed(speeds);
  for (std::size_t v = 0; v < speeds.size(); ++v)
    {
      const PassedWave alone = passed({speeds[v]})[0];
      BOOST_TEST(std::abs(together[v].growth.total() - alone.growth.total()) <
                 1e-8 * std::abs(alone.growth.total()));
      BOOST_TEST(std::abs(together[v].load - alone.load) <
                 1e-8 * std::abs(alone.load));
    }
  BOOST_TEST(std::abs(together[0].growth.total() - together[2].growth.total()) >
             1e-2 * std::abs(together[0].growth.total()));
}

BOOST_AUTO_TEST_CASE(reactions_in_between_are_those_of_the_wave)
{
  const Rolling  rolling(24, 0.2, 0.5);
  const unsigned N     = rolling.problem.n_nodes();
  const auto     lossy = [&](const double) {
    ReducedPair pair = bodies(rolling.problem, {0.5, 1., {0.3, -0.2}, 0.1}, 2.);
    pair.retardation = 0.02;
    return pair;
  };
  const std::vector<double> speeds{0.5, 3.};
  const WaveSweep           waves = rolling.sweep(speeds, lossy);
  const double              k = 1.3, first = 1., ratio = std::pow(10., 1. / 90);
  std::vector<std::vector<WaveResponse::Reaction>> reactions(2);
  for (unsigned int i = 0; i < 20; ++i)
    {
      auto found =
        waves.reactions(first * std::pow(ratio, i),
                        [](const WaveGrowth &patch, const double wave_number) {
                          ComplexMatrix b = random_waves(patch.along(),
                                                         patch.across(),
                                                         wave_number,
                                                         0.);
                          b.conservativeResize(Eigen::NoChange, 2);
                          b.col(1).setOnes();
                          return b;
                        },
                        {0, 1});
      for (const std::size_t v : {0, 1})
        reactions[v].push_back(found.at(v));
    }
  const auto exact = waves.at(k, waves.modal(k));
  for (const std::size_t v : {0, 1})
    {
      const PassingWaves passing{
        waves, v, speeds[v], first, ratio, reactions[v]};
      const double f      = k * speeds[v] / (2 * pi);
      const auto   passed = passing.at(f, passing.modal(f));
      BOOST_TEST_REQUIRE(passed.loads.size() == 2);
      // waves are 2.6 % apart
      const double error = std::abs(passed.loads[0] / exact[v].load - 1.);
      BOOST_TEST_MESSAGE("load between waves off by " << error);
      BOOST_TEST(error < 1e-7);
      BOOST_TEST(
        std::abs(std::abs(passed.loads[0] / passed.loads[1]) / exact[v].filter -
                 1) < 1e-7);
      // the first mode moves all nodes along the normal alike
      const ReducedPair pair = lossy(speeds[v]);
      const Complex     s(0., k * speeds[v]);
      const Complex     compliance =
        1. / (s * s + s * pair.C_m(0, 0) + pair.K_m(0, 0));
      BOOST_TEST(pair.Phi(N, 0) == 1.);
      for (const int wave : {0, 1})
        BOOST_TEST(std::abs(passed.amplitudes(0, wave) -
                            compliance * passed.loads[wave]) <
                   1e-9 * std::abs(passed.amplitudes(0, wave)));
    }
}

BOOST_AUTO_TEST_CASE(the_flow_the_other_way_is_the_mirror_image)
{
  const Case       at{0.5, 1., {0.3, -0.4}, {0.2, -0.1}};
  const PassedWave one   = Rolling(32, 0.3, 0.5, 1).wave(at),
                   other = Rolling(32, -0.3, 0.5, -1).wave(at);
  BOOST_TEST(std::abs(one.load - other.load) < 1e-7 * std::abs(one.load));
  BOOST_TEST(std::abs(one.growth.total() - other.growth.total()) <
             1e-6 * std::abs(one.growth.total()));
}

BOOST_AUTO_TEST_CASE(receptances_are_those_of_the_bodies)
{
  const Case       at{0.5, 1., {5., -0.4}, {2., -3.}};
  const Rolling    rolling(32, 0.3, 0.5);
  const PassedWave found = rolling.wave(at);
  // the punch leaves the half-planes the same real compliance in both
  const Complex local_x = found.receptance_x - at.alpha_t,
                local_z = found.receptance_z - at.alpha;
  BOOST_TEST(std::abs(local_x - local_z) < 1e-9 * std::abs(local_z));
  // ln(2 L / a) of the punch, 2/(pi E*)
  BOOST_TEST(std::abs(local_z - 2 / (pi * 2) * (3 + std::log(2.))) < 0.02);
}

BOOST_AUTO_TEST_CASE(loss_stiffness_acts_at_real_rates_alone)
{
  ReducedPair pair;
  pair.K_m = DenseMatrix::Constant(1, 1, 7.);
  pair.C_m = DenseMatrix::Constant(1, 1, 0.5);
  pair.H_m = DenseMatrix::Constant(1, 1, 2.);
  for (const double w : {3., -3.})
    {
      ComplexMatrix one = ComplexMatrix::Ones(1, 1);
      ModalFactors(pair, {0., w}).solve(one);
      const Complex exact =
        1. / Complex(7. - 9., 0.5 * w + std::copysign(2., w));
      BOOST_TEST(std::abs(one(0, 0) - exact) < 1e-14);
    }
}

BOOST_AUTO_TEST_CASE(halved_patches_tell_how_far_growth_is_off)
{
  // first order: the change from half of the nodes is as large as the error
  const Case at{2., 1., {1.2, 0.}, 0.};
  double     error = 0., change = 0.;
  for (const double offset : {0., 0.25, 0.5, 0.75})
    {
      const Rolling whole(32, offset, at.creepage);
      const Complex growth = whole.wave(at).growth.total();
      error =
        std::max(error, std::abs(growth - closed_form(at).growth().total()));
      change =
        std::max(change,
                 std::abs(
                   growth -
                   Rolling(16, offset, at.creepage).wave(at).growth.total()));
    }
  BOOST_TEST(change > 0.7 * error);
  BOOST_TEST(change < 6. * error);
}

namespace
{
  /** A round patch of radius one that sticks, on half-spaces that are alike,
   * with so many elements across; its answer to creepage that oscillates. */
  struct StickingPatch
  {
    explicit StickingPatch(const unsigned int n)
      : rolling{StabilityBodies::rolling_problem(grid_of(n),
                                                 alike(grid_of(n)),
                                                 1e4,
                                                 {1e-6, 0., 0.},
                                                 0.,
                                                 SlipOperatorKind::calibrated),
                {}}
    {
      auto &loads = rolling.problem.loads;
      for (std::size_t i = 0; i < loads.gap.size(); ++i)
        {
          const auto &at = rolling.problem.operators.positions()[i];
          loads.gap[i]   = (at[0] * at[0] + at[1] * at[1]) / 2;
        }
      loads.approach = 1.; // a^2 / R
      rolling.solve();
      BOOST_TEST(rolling.converged);
      LinearContactOptions options;
      options.speed = 1.;
      contact       = linear_contact(rolling.problem, rolling.state, options);
      pair.W_res    = rolling.problem.operators.W().dense();
      pair.Phi      = DenseMatrix::Zero(pair.W_res.rows(), 0);
      pair.K_m = pair.C_m = DenseMatrix::Zero(0, 0);
      BOOST_TEST(contact.n_slip() == 0u);
      for (const unsigned int i : contact.touching)
        along.push_back(rolling.problem.operators.positions()[i][0]);
      response.emplace(
        contact, pair, 1., along, WaveResponse::motions_of(pair));
    }

    static StabilityBodies::Grid grid_of(const unsigned int n)
    {
      return {n + 4, n + 2, 2. / n};
    }

    static DenseMatrix alike(const StabilityBodies::Grid &grid)
    {
      DenseMatrix        W = StabilityBodies::half_space(grid, 1., 0.25);
      const Eigen::Index N = grid.n_nodes();
      W.topRightCorner(2 * N, N).setZero();
      W.bottomLeftCorner(N, 2 * N).setZero();
      return W;
    }

    /** The force along one direction under a creepage along it that goes as
     * exp(i ka V t / a). */
    Complex force(const unsigned int direction, const double ka) const
    {
      const std::size_t n = along.size();
      ComplexVector     b = ComplexVector::Zero(3 * n);
      for (std::size_t k = 0; k < n; ++k)
        b[n + direction * n + k] = -1.;
      const auto                 factors = response->factors(ka);
      const WaveResponse::AtWave at(*response,
                                    ka,
                                    factors,
                                    response->modal(ka));
      const ComplexVector forces = contact.forces * at.answer(b).unknowns;
      return forces.segment(direction * contact.n_nodes, contact.n_nodes).sum();
    }

    StabilityBodies::RollingState rolling;
    LinearContact                 contact;
    ReducedPair                   pair;
    std::vector<double>           along;
    std::optional<WaveResponse>   response;
  };
} // namespace

BOOST_AUTO_TEST_CASE(a_patch_that_sticks_answers_creepage_that_oscillates)
{
  // an independent computation, extrapolated from 10 to 28 elements across
  const StickingPatch                                     patch(18);
  const std::vector<std::tuple<double, Complex, Complex>> known{
    {0.25, {0.892, -0.324}, {0.919, -0.288}},
    {0.5, {0.664, -0.499}, {0.731, -0.473}},
    {1., {0.294, -0.510}, {0.365, -0.541}},
    {2., {0.042, -0.307}, {0.056, -0.351}}};
  const Complex steady_x = patch.force(0, 1e-5),
                steady_y = patch.force(1, 1e-5);
  // Kalker's C11 and C22 of a circle, nu = 0.25, bodies of twice the stiffness
  BOOST_TEST(std::abs(-steady_x / (2 * 4.12) - 1.) < 0.03);
  BOOST_TEST(std::abs(-steady_y / (2 * 3.67) - 1.) < 0.03);
  for (const auto &[ka, along, across] : known)
    {
      const Complex x = patch.force(0, ka) / steady_x,
                    y = patch.force(1, ka) / steady_y;
      BOOST_TEST_MESSAGE("ka " << ka << ": " << x << " of " << along << ", "
                               << y << " of " << across);
      BOOST_TEST(std::abs(x - along) < 0.006);
      BOOST_TEST(std::abs(y - across) < 0.006);
    }
  // fast: the patch moves as one (Mindlin), here less what the edges lose
  for (const double ka : {4., 8.})
    {
      const Complex mindlin = -2 * 4 / (2 - 0.25) / Complex(0., ka),
                    x       = patch.force(0, ka);
      BOOST_TEST_MESSAGE("ka " << ka << ": " << x << ", Mindlin " << mindlin);
      BOOST_TEST(std::abs(x.imag() / mindlin.imag() - 1) < 0.16 / ka);
    }
}

namespace
{
  void on_axle(SceneParameters &scene)
  {
    VibratingPair::disc_on_pad(scene);
    if (scene.dimension == 2)
      scene.wheel.lateral_radius = 0.;
    scene.wheel.hub                    = Hub::mass;
    scene.wheel.model.hub_mass.mass    = 5.;
    scene.wheel.model.hub_mass.inertia = {{0.01, 0.02, 0.01}};
    scene.wheel.model.damping          = {};
    scene.mesh.elements_across_patch   = 5;
    scene.mesh.growth                  = 1.5;
    scene.contact.approach             = 4.5e-5;
    scene.contact.creepages.x          = 0.05;
  }

  /** The sum of motions along z under unit forces along z at all nodes that
   * touch, over the square of their number. */
  template <int dim>
  Complex lift(const VibratingPair::Eigenvalues<dim>                     &found,
               const std::function<ComplexVector(const ComplexVector &)> &W)
  {
    const auto       &contact = found.contact;
    const std::size_t first   = contact.n_tangential * contact.n_nodes;
    ComplexVector     forces  = ComplexVector::Zero(first + contact.n_nodes);
    for (const unsigned int i : contact.touching)
      forces[first + i] = 1. / contact.touching.size();
    return (forces.transpose() * W(forces)).value();
  }

  template <int dim>
  void check_axle_in_contact()
  {
    VibratingPair::Eigenvalues<dim> found(on_axle, 40e3);
    const auto                      by_modes = [&](const Complex s) {
      return lift<dim>(found, [&](const ComplexVector &forces) {
        return reduced_response(found.reduced, s, forces);
      });
    };
    const auto by_all = [&](const Complex s) {
      return lift<dim>(found, [&](const ComplexVector &forces) {
        return found.whole->response({s}, {forces}).front();
      });
    };
    // slow: the inertia of disc and axle, beside what is soft at rest
    const BodySpec &wheel = found.run.situation().wheel;
    const double    disc  = pi * (0.2 * 0.2 - 0.05 * 0.05) * 7800. *
                        (dim == 2 ? wheel.thickness : wheel.width);
    const double  slow  = 2 * pi * 20.;
    const Complex heavy = by_all({0., slow}) * slow * slow;
    BOOST_TEST_MESSAGE(dim << "D: mass " << -1 / heavy.real() << " kg of "
                           << disc + 5.);
    BOOST_TEST(std::abs(heavy.real() * (disc + 5.) + 1) < 0.02);
    for (const double f : {300., 1500., 4000.})
      {
        const Complex s(0., 2 * pi * f);
        BOOST_TEST(std::abs(by_modes(s) - by_all(s)) <
                   2e-3 * std::abs(by_all(s)));
      }
  }
} // namespace

BOOST_AUTO_TEST_CASE(a_wheel_on_its_axle_is_as_heavy_as_both)
{
  check_axle_in_contact<2>();
  check_axle_in_contact<3>();
}

BOOST_AUTO_TEST_CASE(peaks_are_those_of_each_speed_and_place)
{
  const auto row = [](const double place, const double V, const double G) {
    CorrugationRow row;
    row.pad_offset                = place;
    row.speed                     = V;
    row.passed.growth.by_traction = G;
    return row;
  };
  std::vector<CorrugationRow> rows;
  for (const double growth : {3., 1., 2., 5., 4., 6.})
    rows.push_back(row(0., 10., growth));
  for (const double growth : {7., 8., 1.})
    rows.push_back(row(0., 20., growth));
  rows.push_back(row(0.3, 20., 0.5));
  const std::vector<std::size_t> expected{0, 3, 5, 7, 9};
  BOOST_TEST(peaks_of_growth(rows) == expected,
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(growth_is_as_uncertain_as_halves_say)
{
  BOOST_TEST(!uncertainty_by_halves(1., {}).has_value());
  BOOST_TEST(*uncertainty_by_halves(1., {4.}) == 3.);
  // the mean is 2, the largest scatter 3
  BOOST_TEST(*uncertainty_by_halves(1., {5., 1., 1., 1.}) == 1. + 3. / 2);
  BOOST_TEST(*uncertainty_by_halves(-2., {-1., -3.}) == 0.5);
}

BOOST_AUTO_TEST_CASE(lines_share_the_distances_of_their_neighbours)
{
  const std::vector<double> widths = widths_of_lines({0., 1., 3., 7.}),
                            expected{0.5, 1.5, 3., 2.};
  BOOST_TEST(widths == expected, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(wavelengths_are_in_equal_ratios_and_fit_a_wheel)
{
  CorrugationParameters section;
  section.wavelengths = "0.02 : 0.16 : 4";
  const auto lengths  = section.wavelengths_round(0.46);
  BOOST_TEST_REQUIRE(lengths.size() == 4u);
  for (std::size_t i = 0; i < 4; ++i)
    BOOST_TEST(std::abs(lengths[i] / (0.02 * std::pow(2., i)) - 1) < 1e-12);
  section.worn = Side::wheel;
  for (const double length : section.wavelengths_round(0.46))
    {
      const double n = 2 * pi * 0.46 / length;
      BOOST_TEST(std::abs(n - std::round(n)) < 1e-9);
    }
  section.wavelengths = "0.03, 0, 0.1";
  BOOST_TEST(complaint([&] { section.check(); }).find("above 0 m") !=
             std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
