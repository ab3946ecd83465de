#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include "scene_run.h"

#include <rolling_contact/analyses/convergence.h>
#include <rolling_contact/analyses/error_cost.h>
#include <rolling_contact/analyses/force_history.h>
#include <rolling_contact/analyses/study_errors.h>
#include <rolling_contact/base/percentages.h>
#include <rolling_contact/results/error_bounds.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(studies, *boost::unit_test::tolerance(1e-12))

namespace
{
  const double not_solved = std::numeric_limits<double>::quiet_NaN();

  CostedError point(const double seconds, const double error)
  {
    return {"", "", seconds, error};
  }

  const std::vector<CostedError> some_points{point(3., 1e-3),
                                             point(1., 1e-2),
                                             point(2., 2e-2),
                                             point(0.5, not_solved),
                                             point(4., 1e-3),
                                             point(9., 1e-4),
                                             point(1., 5e-3)};

  template <typename Values>
  void check_equal(const Values &found, const Values &expected)
  {
    BOOST_TEST(found == expected, boost::test_tools::per_element());
  }
} // namespace

BOOST_AUTO_TEST_CASE(front_of_made_up_points)
{
  check_equal(pareto_front(some_points), {6, 0, 5});
  check_equal(pareto_front({}), {});
  check_equal(pareto_front({point(1., not_solved)}), {});
}

/** No point of the front is beaten, and every other one is. */
BOOST_AUTO_TEST_CASE(front_of_random_points)
{
  std::mt19937                           random(7);
  std::uniform_real_distribution<double> uniform(0.1, 1.);
  std::vector<CostedError>               points;
  for (unsigned int k = 0; k < 200; ++k)
    points.push_back(point(uniform(random), uniform(random)));
  const auto front = pareto_front(points);
  for (std::size_t i = 0; i < points.size(); ++i)
    {
      const bool is_beaten =
        std::any_of(points.begin(), points.end(), [&](const auto &other) {
          return other.cpu_seconds < points[i].cpu_seconds &&
                 other.error < points[i].error;
        });
      const bool is_on_front =
        std::find(front.begin(), front.end(), i) != front.end();
      BOOST_TEST(is_beaten != is_on_front);
    }
}

BOOST_AUTO_TEST_CASE(cheapest_of_a_level)
{
  const auto best =
    best_of_levels(some_points, {1e-1, 1e-2, 3e-3, 1e-3, 1e-4, 1e-5});
  std::vector<std::size_t> points;
  std::vector<double>      levels;
  for (const BestOfLevel &level : best)
    {
      points.push_back(level.point);
      levels.push_back(level.level);
    }
  check_equal(points, {6, 6, 0, 0, 5});
  check_equal(levels, {1e-1, 1e-2, 3e-3, 1e-3, 1e-4});
}

BOOST_AUTO_TEST_CASE(extrapolation)
{
  // f(h) = 3 + 0.7 h^p
  for (const double p : {1., 1.7, 2., 3.})
    {
      const auto   f = [&](const double h) { return 3 + 0.7 * std::pow(h, p); };
      const double order = observed_order(f(0.2) - f(0.4), f(0.1) - f(0.2));
      BOOST_TEST(order == p);
      BOOST_TEST(extrapolated(f(0.2), f(0.1), 2., order) == 3.);
    }
  BOOST_TEST(observed_order(1., 0.9) == 1.); // scatter
  BOOST_TEST(observed_order(1., 1e-9) == 3.);
  BOOST_TEST(observed_order(1., 0.) == 3.);
  BOOST_TEST(extrapolated(2., 2., 2., 3.) == 2.);
}

namespace
{
  /** T_x = t^2 + slope h, T_y = -t, N = 10 t at the times up to 1. */
  ForceHistory made_up_history(const double h, const double slope)
  {
    ForceHistory history{h, {}};
    for (int k = 1; k * h < 1 + 1e-9; ++k)
      {
        const double t = k * h;
        history.forces.push_back({{t * t + slope * h, -t, 10 * t}});
      }
    return history;
  }
} // namespace

BOOST_AUTO_TEST_CASE(histories_of_first_order)
{
  const ForceHistory limit =
    limit_of(made_up_history(0.02, 3.), made_up_history(0.01, 3.), 1.);
  BOOST_TEST(limit.step == 0.02);
  BOOST_TEST(limit.forces.size() == 50u);
  const ForceHistory exact = made_up_history(0.02, 0.);
  for (std::size_t i = 0; i < limit.forces.size(); ++i)
    BOOST_TEST(limit.forces[i][0] == exact.forces[i][0],
               boost::test_tools::tolerance(1e-10));

  const HistoryErrors errors = history_errors(made_up_history(0.1, 3.), limit);
  BOOST_TEST(errors.n_times == 10u);
  BOOST_TEST(errors.force_largest == 0.03, boost::test_tools::tolerance(1e-10));
  BOOST_TEST(errors.force_mean == 0.03, boost::test_tools::tolerance(1e-10));
  BOOST_TEST((errors.load_largest < 1e-12));
}

/**
 * Forces at half of each step: means of the exact ones over the steps differ
 * from those there by h^2 / 12, which the limit of second order takes out.
 */
BOOST_AUTO_TEST_CASE(histories_of_forces_within_their_steps)
{
  const auto means = [](const double h) {
    ForceHistory history{h, {}, h / 2};
    for (int k = 1; k * h < 1 + 1e-9; ++k)
      {
        const double end = k * h, begin = end - h;
        history.forces.push_back(
          {{(end * end * end - begin * begin * begin) / (3 * h),
            0.,
            5 * (end + begin)}});
      }
    return history;
  };
  const ForceHistory limit = limit_of(means(0.02), means(0.01), 2.);
  BOOST_TEST(limit.forces.size() == 50u);
  for (std::size_t i = 0; i < limit.forces.size(); ++i)
    BOOST_TEST(
      (std::abs(limit.forces[i][0] - std::pow(limit.time(i), 2)) < 1e-12));
  const HistoryErrors errors = history_errors(means(0.1), limit);
  BOOST_TEST(errors.n_times == 10u);
  BOOST_TEST(errors.force_largest == 0.01 / 12 / (10 * 0.99),
             boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(shares_add_up)
{
  check_equal(percentages({1., 1., 1.}), {34, 33, 33});
  check_equal(percentages({0.005, 0.995}), {1, 99});
  check_equal(percentages({0., 2., 2.}), {0, 50, 50});
  check_equal(percentages({1., 2., 4.}), {14, 29, 57});
  check_equal(percentages({0., 0.}), {0, 0});
  std::mt19937                           random(3);
  std::uniform_real_distribution<double> uniform(0., 1.);
  for (unsigned int k = 0; k < 100; ++k)
    {
      std::vector<double> values(1 + k % 9);
      for (double &value : values)
        value = uniform(random);
      const std::vector<int> shares = percentages(values);
      const double sum = std::accumulate(values.begin(), values.end(), 0.);
      BOOST_TEST(std::accumulate(shares.begin(), shares.end(), 0) == 100);
      for (std::size_t i = 0; i < values.size(); ++i)
        BOOST_TEST(std::abs(shares[i] - 100 * values[i] / sum) < 1.);
    }
}

BOOST_AUTO_TEST_CASE(methods_one_at_a_time)
{
  SceneParameters  scene;
  StudyParameters &study = scene.study;
  study.meshes           = {"uniform", "graded"};
  study.slip_operators   = {"calibrated", "paper", "upwind 1"};
  study.solvers          = {"automatic", "extragradient"};
  std::vector<std::string> names;
  for (const StudyMethod &method : study_methods(study))
    names.push_back(method.name(study_methods(study).front()));
  check_equal(names,
              {"calibrated",
               "calibrated, extragradient",
               "paper",
               "upwind 1",
               "calibrated, graded"});
  study.combines_all = true;
  BOOST_TEST(study_methods(study).size() == 12u);
}

namespace
{
  StudySample
  sample(const double force_x, const double force_y, const bool converged)
  {
    StudySample result;
    result.converged       = converged;
    result.force           = {{force_x, force_y}};
    result.load            = 2.;
    result.seconds.contact = 1.;
    return result;
  }
} // namespace

/** f(n) = (-0.5, 0.2) (1 - 8 / n^2), at two positions 0.001 apart. */
BOOST_AUTO_TEST_CASE(errors_against_the_extrapolated_reference)
{
  SceneParameters scene;
  scene.study.reference_elements = 32;
  StudyResults results;
  results.methods = study_methods(scene.study);
  results.cases   = {{"combined", 0.5, {}}};
  const auto at   = [](const double n, const double shift) {
    const double factor = 1 - 8 / (n * n);
    return sample(-0.5 * factor + shift, 0.2 * factor, true);
  };
  for (const unsigned int n : {8, 16, 32})
    results.samples[{0, 0, n}] = {at(n, 0.0005), at(n, -0.0005)};
  const StudyReference reference = study_reference(scene.study, results, 0);
  BOOST_TEST(reference.force[0] == -0.5);
  BOOST_TEST(reference.force[1] == 0.2);
  BOOST_TEST(reference.order == 2.);

  const double size    = std::hypot(0.5, 0.2) / 8; // of the error with n = 8
  auto         samples = results.samples[{0, 0, 8}];
  const auto   errors  = study_errors(results.cases[0], reference, samples);
  BOOST_TEST(errors.force.mean == size);
  BOOST_TEST(errors.force.largest == std::hypot(0.5 / 8 + 0.0005, 0.2 / 8));
  BOOST_TEST(errors.seconds.total() == 1.);

  // of one component: too small a force is a negative error
  samples.push_back(sample(9., 9., false));
  const auto lateral = study_errors({"lateral", 0.5, {}}, reference, samples);
  BOOST_TEST(lateral.force.mean == -0.2 / 8);
  BOOST_TEST(lateral.n_not_converged == 1u);
  BOOST_TEST(lateral.force.n == 2u);
}

BOOST_AUTO_TEST_CASE(entries_that_do_not_fit)
{
  SceneParameters scene;
  const auto      with = [&](auto StudyParameters::*entry, const auto &value) {
    const auto before      = scene.study.*entry;
    scene.study.*entry     = value;
    const std::string said = complaint([&]() { scene.study.check(2); });
    scene.study.*entry     = before;
    return said;
  };
  BOOST_TEST(complaint([&]() { scene.study.check(2); }) == "");
  using Numbers = std::vector<unsigned int>;
  using Texts   = std::vector<std::string>;
  using Reals   = std::vector<double>;
  BOOST_TEST(contains(with(&StudyParameters::elements, Numbers{12, 192}),
                      "Accuracy study/Elements across patch contains 192"));
  BOOST_TEST(contains(with(&StudyParameters::adaptive_starts, Numbers{500}),
                      "Accuracy study/Adaptive starts contains 500"));
  BOOST_TEST(contains(with(&StudyParameters::reference_elements, 190u),
                      "Reference elements across patch = 190"));
  BOOST_TEST(contains(with(&StudyParameters::directions, Texts{"spin"}),
                      "Accuracy study/Directions contains spin"));
  BOOST_TEST(contains(with(&StudyParameters::creepages, Reals{0.1, 0.}),
                      "Creepages over saturation contains 0"));
  BOOST_TEST(
    contains(with(&StudyParameters::slip_operators, Texts{"paper", "paper"}),
             "Slip operators contains paper twice"));
  scene.study.varies_time_step = true;
  BOOST_TEST(contains(with(&StudyParameters::time_steps, Reals{3e-6}),
                      "Accuracy study/Time steps contains 3e-06"));
  BOOST_TEST(contains(with(&StudyParameters::reference_time_step, 0.),
                      "Accuracy study/Reference time step"));
}

BOOST_AUTO_TEST_CASE(line_of_a_run)
{
  RunReport  report;
  PhaseTimer timer;
  report.set_finding("load", "N = 1 N");
  report.set_finding("force", "T = 2 N");
  report.set_finding("load", "N = 3 N");
  BOOST_TEST(contains(report.summary(timer, "run"),
                      "load   N = 3 N\nforce  T = 2 N\nerror  no contact, no "
                      "error\ntime   "));
  report.errors.push_back({"force", 2.94e-4, "mu N", "Carter", false, ""});
  report.errors.push_back({"pressure", 0.5, "p0", "Hertz", false, "L2"});
  report.errors.push_back({"load", 1e-3, "N", "2/n", true, "not in time"});
  BOOST_TEST(contains(report.summary(timer, "run"),
                      "error  force 2.9e-04 of mu N against Carter, pressure "
                      "5.0e-01 of p0 against\n       Hertz (L2), load 1.0e-03 "
                      "of N (estimate: 2/n; not in time)\ntime   "));
  BOOST_TEST(contains(report.summary(timer, "run"), "\nfiles  run"));
}

/**
 * The bound on which estimates rest holds for these discs, out of the positions
 * and creepages it was measured at, and is no looser than by a factor of 300.
 */
BOOST_AUTO_TEST_CASE(estimates_hold)
{
  const auto run = [](const SlipOperatorKind slip_operator,
                      const unsigned int     n,
                      const double           offset,
                      const double           creepage) {
    SceneRun<2> result(
      [&](SceneParameters &scene) {
        for (BodyParameters *body : {&scene.wheel, &scene.rail})
          {
            body->radius     = 0.46;
            body->hub_radius = 0.08;
          }
        scene.contact.approach           = 0.22e-3;
        scene.contact.creepages.x        = creepage;
        scene.contact.slip_operator      = slip_operator;
        scene.mesh.elements_across_patch = n;
        scene.mesh.patch_offset          = offset;
      },
      [](SceneParameters &) {});
    return std::make_pair(
      result.force_x(), *error_bounds(result.situation(), result.steady).force);
  };
  const double creepage = 0.0022;
  const double converged =
    run(SlipOperatorKind::calibrated, 160, 0.5, creepage).first;
  for (const auto slip_operator : {SlipOperatorKind::calibrated,
                                   SlipOperatorKind::upwind_2,
                                   SlipOperatorKind::upwind_1})
    for (const unsigned int n : {15, 30})
      {
        double largest = 0., estimate = 0.;
        for (const double offset : {0.1, 0.43, 0.77})
          {
            const auto found = run(slip_operator, n, offset, creepage);
            largest  = std::max(largest, std::abs(found.first - converged));
            estimate = found.second;
          }
        BOOST_TEST(largest < estimate);
        BOOST_TEST(largest > estimate / 300);
      }
}

BOOST_AUTO_TEST_SUITE_END()
