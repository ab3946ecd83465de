#include "complaint.h"
#include "scene_run.h"
#include "scratch_folder.h"
#include "wheel_on_block.h"

#include <rolling_contact/evolution/duty.h>
#include <rolling_contact/evolution/evolution_state.h>
#include <rolling_contact/evolution/wearing_contact.h>
#include <rolling_contact/surfaces/profile_measures.h>
#include <rolling_contact/wheelset/wheel_pair.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>

using namespace RollingContact;

/** Profiles that wear: steps of a contact in its place, duties, states. */
BOOST_AUTO_TEST_SUITE(evolution)

namespace
{
  const double r0 = 0.46, mm = 1e-3, um = 1e-6, pi = 3.14159265358979323846;

  /** Wear by the pressure alone, so that long wear levels it. Units: m/m. */
  double rate_of_pressure(const Damage::RubbingNode &node,
                          const Damage::DamageParameters &)
  {
    return 1e-18 * node.pressure;
  }

  const Damage::WearLaw by_pressure{"pressure", "", &rate_of_pressure};

  /** @p zone: Mesh/Candidate zone, large enough to stay on the same nodes. */
  SceneParameters scene_on_profiles(const double zone)
  {
    SceneParameters scene        = wheel_on_block(8);
    scene.mesh.candidate_zone    = zone;
    scene.wheel.radius           = r0;
    scene.profiles.wheel_profile = "S1002";
    scene.profiles.rail_profile  = "60E1";
    scene.profiles.surface_kind  = Profiles::SurfaceKind::curved;
    scene.contact.speed          = 20.;
    return scene;
  }

  /** A right-hand wheel that stays where it is, on a profile that wears. */
  class WheelInItsPlace
  {
  public:
    explicit WheelInItsPlace(const Damage::WearLaw &law  = by_pressure,
                             const double           zone = 0.)
      : law(law)
      , scene(scene_on_profiles(zone))
      , pair(scene, wheelset, true)
      , surfaces({{{scene.profiles.wheel(""), scene.profiles.rail("")}}},
                 {{r0, r0}},
                 scene.profiles.tape_circle())
      , kept(nullptr, Verbosity::quiet, 0.6)
    {
      kept.tries_last = true;
    }

    WearingContact on(const RunningSurfaces &surfaces,
                      const double           portion = 1.)
    {
      pair.set_profiles(surfaces.wheels_on_rails());
      PairSpec now = pair.scene_as_right_hand(0, {3 * mm, -2e-3, 0.}, 0., 60e3);
      now.wear.report = true;
      return WearingContact(now, kept.solve(now, "bodies"), law, 0, 0, portion);
    }

    /** The amounts that the wheel loses on a way. */
    RunningSurfaces::Amounts worn(const RunningSurfaces &surfaces,
                                  const double           distance,
                                  const bool             is_implicit)
    {
      const WearingContact      contact = on(surfaces);
      const WearingWay          way{distance, 0.};
      const std::vector<double> none(contact.lines().size(), 0.);
      RunningSurfaces::Amounts  found = surfaces.nothing();
      found[0][0] =
        contact.amounts(surfaces.curve(0, 0),
                        0,
                        way,
                        is_implicit ? contact.depths_at_end(way, none)
                                    : contact.depths(),
                        0.);
      return found;
    }

    /** Depths over the first profile after equal steps. */
    std::vector<double> worn_in_steps(const double       distance,
                                      const unsigned int n,
                                      const bool         is_implicit,
                                      const bool         extrapolated = false)
    {
      RunningSurfaces          now   = surfaces;
      RunningSurfaces::Amounts total = surfaces.nothing();
      for (unsigned int k = 0; k < n; ++k)
        {
          RunningSurfaces::Amounts step = worn(now, distance / n, is_implicit);
          if (extrapolated)
            {
              const auto first = worn(now, distance / n / 2, is_implicit);
              const auto both =
                sum(first,
                    1.,
                    worn(now.worn(first), distance / n / 2, is_implicit));
              step = sum(sum(both, 1., both), -1., step);
            }
          now   = now.worn(step);
          total = sum(total, 1., step);
        }
      last = now;
      return surfaces.depths(total, 0, 0);
    }

    /** The distance after which an explicit step would be so deep. */
    double distance_for(const double depth)
    {
      return depth / surfaces.largest_depth(worn(surfaces, 1., false));
    }

    const Damage::WearLaw          law;
    const Situation                scene;
    const WheelsetParameters       wheelset;
    WheelPair                      pair;
    RunningSurfaces                surfaces;
    KeptStates<3>                  kept;
    std::optional<RunningSurfaces> last;
  };

  double largest_difference(const std::vector<double> &a,
                            const std::vector<double> &b)
  {
    double largest = 0.;
    for (std::size_t k = 0; k < a.size(); ++k)
      largest = std::max(largest, std::abs(a[k] - b[k]));
    return largest;
  }

  /** The mean, so that where a patch ends between lines counts little. */
  double mean_difference(const std::vector<double> &a,
                         const std::vector<double> &b)
  {
    double sum = 0.;
    for (std::size_t k = 0; k < a.size(); ++k)
      sum += std::abs(a[k] - b[k]);
    return sum / a.size();
  }

} // namespace

BOOST_AUTO_TEST_CASE(a_step_takes_off_what_its_law_says)
{
  const auto t_gamma =
    std::find_if(Damage::wear_laws().begin(),
                 Damage::wear_laws().end(),
                 [](const auto &it) { return it.name == "t-gamma"; });
  WheelInItsPlace      wheel(*t_gamma);
  const WearingContact contact  = wheel.on(wheel.surfaces);
  const double         distance = 1e6;
  // K E / rho for a passage, over the circumference of the wheel
  const auto   worn = wheel.worn(wheel.surfaces, distance, false);
  const double area = std::accumulate(worn[0][0].begin(), worn[0][0].end(), 0.);
  double       radius = 0., loads = 0.;
  for (const WearingLine &line : contact.lines())
    {
      radius += line.radius * line.load * line.width;
      loads += line.load * line.width;
    }
  radius /= loads;
  BOOST_TEST(area == 5.3e-9 * contact.summary.creep_work / 7850. * distance /
                       (2 * pi * radius),
             boost::test_tools::tolerance(5e-3));
  BOOST_TEST(Profiles::worn_area(wheel.surfaces.curve(0, 0),
                                 wheel.surfaces.worn(worn).curve(0, 0),
                                 Profiles::ProfileKind::wheel) == area,
             boost::test_tools::tolerance(1e-8));
  // normal to the profile, which is inclined, and without friction
  BOOST_TEST(loads == 60e3, boost::test_tools::tolerance(3e-2));
}

BOOST_AUTO_TEST_CASE(amounts_are_those_of_portion_way_and_lines)
{
  WheelInItsPlace           wheel;
  const WearingContact      contact = wheel.on(wheel.surfaces);
  const std::vector<double> depths  = contact.depths();
  const WearingWay          way{3e6, 7e3};
  double                    of_wheel = 0., of_rail = 0.;
  for (std::size_t k = 0; k < depths.size(); ++k)
    {
      const WearingLine &line = contact.lines()[k];
      BOOST_TEST(depths[k] == line.depth_over_load * line.load,
                 boost::test_tools::tolerance(1e-12));
      of_wheel += depths[k] * line.width * 3e6 / (2 * pi * line.radius);
      of_rail += depths[k] * line.width * 7e3;
    }
  for (const double smoothing : {0., 2 * mm})
    for (unsigned int body = 0; body < 2; ++body)
      {
        const auto amounts = contact.amounts(
          wheel.surfaces.curve(0, body), body, way, depths, smoothing);
        BOOST_TEST(std::accumulate(amounts.begin(), amounts.end(), 0.) ==
                     (body == 0 ? of_wheel : of_rail),
                   boost::test_tools::tolerance(1e-12));
      }
}

BOOST_AUTO_TEST_CASE(the_end_of_a_short_way_is_that_of_the_state)
{
  WheelInItsPlace           wheel;
  const WearingContact      contact = wheel.on(wheel.surfaces);
  const std::vector<double> none(contact.lines().size(), 0.);
  const auto   now = contact.depths(), there = contact.depths_at_end({}, none);
  const double largest = *std::max_element(now.begin(), now.end());
  BOOST_TEST(largest_difference(now, there) < 1e-6 * largest);
}

BOOST_AUTO_TEST_CASE(a_contact_feels_what_both_bodies_lose)
{
  WheelInItsPlace      wheel;
  const WearingContact whole = wheel.on(wheel.surfaces),
                       half  = wheel.on(wheel.surfaces, 0.5);
  const std::vector<double> none(whole.lines().size(), 0.);
  const double              distance = wheel.distance_for(40 * um),
               passages              = distance / (2 * pi * r0);
  const auto   of_wheel = whole.depths_at_end({distance, 0.}, none);
  const double largest  = *std::max_element(of_wheel.begin(), of_wheel.end()),
               before   = [&]() {
                 const auto depths = whole.depths();
                 return *std::max_element(depths.begin(), depths.end());
               }();
  BOOST_TEST(largest < 0.8 * before);
  // radii of lines are within 0.5 % of r0
  BOOST_TEST(
    largest_difference(of_wheel, whole.depths_at_end({0., passages}, none)) <
    5e-3 * largest);
  BOOST_TEST(
    largest_difference(of_wheel,
                       whole.depths_at_end({distance / 2, passages / 2},
                                           none)) < 5e-3 * largest);
  BOOST_TEST(
    largest_difference(of_wheel, half.depths_at_end({2 * distance, 0.}, none)) <
    1e-6 * largest);
}

BOOST_AUTO_TEST_CASE(a_wider_kernel_makes_wear_shallower)
{
  WheelInItsPlace      wheel;
  const WearingContact contact = wheel.on(wheel.surfaces);
  const auto           deepest = [&](const double smoothing) {
    auto amounts  = wheel.surfaces.nothing();
    amounts[0][0] = contact.amounts(
      wheel.surfaces.curve(0, 0), 0, {1e6, 0.}, contact.depths(), smoothing);
    return wheel.surfaces.largest_depth(amounts);
  };
  BOOST_TEST(deepest(6 * mm) < 0.9 * deepest(0.));
  BOOST_TEST(deepest(0.1 * mm) == deepest(0.)); // a line is wider
}

BOOST_AUTO_TEST_CASE(what_is_misplaced_is_a_share_of_the_depth)
{
  WheelInItsPlace wheel;
  const auto      amounts = wheel.worn(wheel.surfaces, 1e6, false);
  const auto      tenth   = sum(wheel.surfaces.nothing(), -0.1, amounts);
  BOOST_TEST(wheel.surfaces.misplaced_depth(tenth, amounts) ==
               0.1 * wheel.surfaces.largest_depth(amounts),
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(
    wheel.surfaces.misplaced_depth(wheel.surfaces.nothing(), amounts) == 0.);
}

// Depth that others make all over a contact lets it come down and no more; in
// its middle it takes load away from there.
BOOST_AUTO_TEST_CASE(others_take_load_where_they_wear)
{
  WheelInItsPlace      wheel;
  const WearingContact contact = wheel.on(wheel.surfaces);
  std::vector<double>  others(contact.lines().size(), 0.);
  const auto           now = contact.depths();
  const std::size_t    middle =
    std::max_element(now.begin(), now.end()) - now.begin();
  others[middle]   = 5 * um;
  const auto there = contact.depths_at_end({}, others);
  BOOST_TEST(there[middle] < 0.9 * now[middle]);
  BOOST_TEST(there[middle - 1] > now[middle - 1]);
  BOOST_TEST(there[middle + 1] > now[middle + 1]);
}

// On one mesh: bodies that are made anew elsewhere are another discretisation.
BOOST_AUTO_TEST_CASE(implicit_steps_are_of_order_one_and_extrapolated_of_two)
{
  WheelInItsPlace wheel(by_pressure, 2.2);
  const double    distance = wheel.distance_for(20 * um);
  const auto      exact    = wheel.worn_in_steps(distance, 16, true, true);
  const auto      off = [&](const unsigned int n, const bool extrapolated) {
    const double mean =
      mean_difference(wheel.worn_in_steps(distance, n, true, extrapolated),
                      exact);
    BOOST_TEST_MESSAGE(n << (extrapolated ? " extrapolated" : " implicit")
                         << " steps, m: " << mean);
    return mean;
  };
  double before = off(2, false);
  for (const unsigned int n : {4, 8})
    {
      const double now = off(n, false);
      BOOST_TEST(before / now > 1.8);
      BOOST_TEST(before / now < 2.1);
      before = now;
    }
  const double two = off(2, true), four = off(4, true), eight = off(8, true);
  BOOST_TEST(two / four > 3.);
  BOOST_TEST(four / eight > 3.5);
  BOOST_TEST(four < 0.1 * off(4, false));
  BOOST_TEST(wheel.kept.n_made == 1);
}

BOOST_AUTO_TEST_CASE(implicit_steps_are_stable_where_explicit_ones_are_not)
{
  const double depth         = 100 * um;
  const auto   peak_pressure = [&](const bool is_implicit) {
    WheelInItsPlace wheel;
    const double    before = wheel.on(wheel.surfaces).summary.max_pressure;
    wheel.worn_in_steps(3 * wheel.distance_for(depth), 3, is_implicit);
    const double after = wheel.on(*wheel.last).summary.max_pressure;
    BOOST_TEST_MESSAGE((is_implicit ? "implicit" : "explicit")
                       << ": peak pressure over that before "
                       << after / before);
    return after / before;
  };
  BOOST_TEST(peak_pressure(true) < 0.8);
  BOOST_TEST(peak_pressure(false) > 1.2);
}

BOOST_AUTO_TEST_CASE(long_wear_levels_what_it_is_linear_in)
{
  WheelInItsPlace wheel;
  wheel.worn_in_steps(wheel.distance_for(1 * mm), 20, true, true);
  std::vector<double>  loads;
  const WearingContact contact = wheel.on(*wheel.last);
  // where the wheel comes down as a whole, inclined lines lose less
  for (const WearingLine &line : contact.lines())
    if (line.load > 0.)
      loads.push_back(
        line.load /
        std::cos(wheel.last->curve(0, 0).at(line.place[0].value()).angle));
  BOOST_TEST_REQUIRE(loads.size() > 40);
  double mean = 0., square = 0.;
  // less those at the edges, which have worn for a part of the way
  const std::size_t edge = loads.size() / 4;
  for (std::size_t k = edge; k + edge < loads.size(); ++k)
    mean += loads[k] / (loads.size() - 2 * edge);
  for (std::size_t k = edge; k + edge < loads.size(); ++k)
    square += std::pow(loads[k] / mean - 1, 2) / (loads.size() - 2 * edge);
  BOOST_TEST_MESSAGE("line loads off their mean, rms: " << std::sqrt(square));
  BOOST_TEST(std::sqrt(square) < 0.015);
}

BOOST_AUTO_TEST_CASE(a_state_is_read_as_it_was_written)
{
  WheelInItsPlace wheel;
  EvolutionState  state;
  state.duty       = "share\n1\n";
  state.now        = {3, 0.25, 1e-7, 2e-5};
  state.next_share = 0.125;
  state.results    = "a,b\n1,2\n";
  state.shares     = {0.25};
  state.curves     = {wheel.surfaces.curves()};
  ScratchFolder scratch;
  const auto    file = scratch.scratch / "state.bin";
  std::ofstream(file, std::ios::binary) << text_of(state);
  const EvolutionState read = read_evolution_state(file);
  BOOST_TEST(read.duty == state.duty);
  BOOST_TEST(read.now.step == 3);
  BOOST_TEST(read.now.share == 0.25);
  BOOST_TEST(read.now.error == 1e-7);
  BOOST_TEST(read.now.depth == 2e-5);
  BOOST_TEST(read.next_share == 0.125);
  BOOST_TEST(read.results == state.results);
  for (unsigned int body = 0; body < 2; ++body)
    {
      const auto &points = wheel.surfaces.curve(0, body).points();
      const auto &again  = read.curves.at(0).at(0)[body].points();
      BOOST_TEST_REQUIRE(again.size() == points.size());
      for (std::size_t k = 0; k < points.size(); ++k)
        BOOST_TEST((again[k].y == points[k].y && again[k].z == points[k].z &&
                    again[k].angle == points[k].angle));
    }
  std::ofstream(file, std::ios::binary) << "no state";
  BOOST_TEST(complaint([&]() {
               read_evolution_state(file);
             }).find("Start the run without --resume") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
