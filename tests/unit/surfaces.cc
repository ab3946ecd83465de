#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include "scratch_folder.h"

#include <rolling_contact/base/constants.h>
#include <rolling_contact/pair/moving_surfaces.h>
#include <rolling_contact/program/analysis_table.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/scene/travelled_distance.h>
#include <rolling_contact/surfaces/filtered_record.h>
#include <rolling_contact/surfaces/short_waves.h>
#include <rolling_contact/tables/transient_session.h>

#include <cmath>
#include <functional>
#include <sstream>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(surfaces)

namespace
{
  /** Rows of positions at equal spacing and heights, in the file's units. */
  std::string rows(const std::size_t                          n,
                   const double                               spacing,
                   const std::function<double(const double)> &height,
                   const double                               begin = 0.)
  {
    std::ostringstream text;
    text.precision(15);
    for (std::size_t k = 0; k < n; ++k)
      text << begin + k * spacing << ", " << height(begin + k * spacing)
           << '\n';
    return text.str();
  }

  struct Records : public ScratchFolder
  {
    SurfaceRecord read_rows(const std::string &text,
                            const RecordUnits &units = {}) const
    {
      write(scratch / "rail.csv", text);
      return read_surface_record("Surfaces/Rail height",
                                 "rail.csv",
                                 scratch,
                                 units);
    }

    std::string complaint_of(const std::string &text,
                             const RecordUnits &units = {}) const
    {
      return complaint([&]() { read_rows(text, units); });
    }

    /** A scene of a wheel on a straight rail with this record. */
    SceneParameters scene_with(const std::string &text)
    {
      write(scratch / "rail.csv", text);
      SceneParameters scene;
      scene.prm_folder           = scratch;
      scene.contact.normal_load  = 100e3;
      scene.rail.shape           = "block";
      scene.rail.radius          = 0.;
      scene.surfaces.height.rail = "rail.csv";
      return scene;
    }
  };

  const ZoneSizes sizes{{0.5e-3, 0.5e-3}, {8e-3, 8e-3}};

  double wave(const double x)
  {
    return 20e-6 * std::cos(2 * pi * x / 0.03);
  }
} // namespace

/** Units, comments, names and columns; the mean goes. */
BOOST_FIXTURE_TEST_CASE(records_are_read_with_their_units, Records)
{
  std::ostringstream text;
  text << "# a rail\nposition_mm; left_um; right_um\n";
  for (int k = 0; k < 40; ++k)
    text << k << "; 7; " << (k % 2 ? 5. : 1.) << "  # point\n\n";
  write(scratch / "rail.txt", text.str());
  const SurfaceRecord record = read_surface_record("Surfaces/Rail height",
                                                   "table: rail.txt 3",
                                                   scratch,
                                                   {1e-3, 1e-6});
  BOOST_TEST(record.heights.size() == 40);
  BOOST_TEST(record.spacing == 1e-3, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(record.mean == 3e-6, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(record.heights[1] == 2e-6, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(!record.resampled);
  SurfaceRecord other = record;
  other.heights[7] *= 1 + 1e-15;
  BOOST_TEST(other.fingerprint() != record.fingerprint());
}

/** Uneven positions within reason are resampled, gaps are not filled. */
BOOST_FIXTURE_TEST_CASE(uneven_records_are_resampled, Records)
{
  std::ostringstream text;
  text.precision(15);
  for (int k = 0; k <= 600; ++k)
    {
      const double x = 0.5e-3 * k + (k % 600 ? 0.15e-3 * std::sin(3. * k) : 0.);
      text << x << ' ' << wave(x) << '\n';
    }
  const SurfaceRecord record = read_rows(text.str());
  BOOST_TEST(record.resampled);
  BOOST_TEST(record.end() == 0.3, boost::test_tools::tolerance(1e-12));
  for (std::size_t k = 0; k < record.heights.size(); ++k)
    BOOST_TEST(std::abs(record.heights[k] + record.mean -
                        wave(k * record.spacing)) < 5e-8);
}

/** What is wrong is named with its line and what to do. */
BOOST_FIXTURE_TEST_CASE(bad_records_are_refused_by_their_line, Records)
{
  const std::string good = rows(100, 1e-3, wave);
  BOOST_TEST(complaint_of(good) == "");
  const auto with    = [&](const std::string &line) { return good + line; };
  const auto refused = [&](const std::string &text, const std::string &part) {
    const std::string said = complaint_of(text);
    BOOST_TEST(contains(said, part), said);
    BOOST_TEST(contains(said, "Surfaces/Rail height = rail.csv"), said);
  };
  refused(with("0.1, nan\n"), "line 101: \"0.1, nan\" has no finite position");
  refused(with("0.1, inf\n"), "line 101");
  refused(with("0.1, 1e-6 um\n"), "line 101");
  refused(with("0,1, 3e-6\n"), "the position does not rise");
  refused(with("0.1\n"), "line 101: there is no column 2");
  refused(with("0.099, 0\n"), "line 101: the position does not rise");
  refused(with("0.12, 0\n"), "line 101: a gap: 0.021 m");
  refused("1, 2\n2, 3\n", "it has 2 points; 10 are the least");
  refused(rows(100, 1e-3, [](double x) { return 1e6 * wave(x); }),
          "Surfaces/Height unit = 1 m");
  // metres, but heights in micrometres of the positions' millimetres
  refused(rows(100, 1e-4, [](double x) { return 200 * wave(10 * x); }),
          "a slope of");
  const std::string none = complaint([&]() {
    read_surface_record("Surfaces/Rail height", "none.csv", scratch, {});
  });
  BOOST_TEST(contains(none, "there is no such file"), none);
  const std::string column = complaint([&]() {
    read_surface_record("Surfaces/Rail height",
                        "table: rail.csv height",
                        scratch,
                        {});
  });
  BOOST_TEST(contains(column, "a number from 2 on, not \"height\""), column);
}

/** A wave that the elements follow passes exactly, one they cannot is gone. */
BOOST_FIXTURE_TEST_CASE(records_are_filtered_for_the_elements, Records)
{
  // 300 waves of 1 mm beside 10 of 30 mm; elements of 0.5 mm stop at 1 mm
  const auto both = [](const double x) {
    return wave(x) + 2e-6 * std::cos(2 * pi * x / 1e-3);
  };
  const SurfaceRecord  record = read_rows(rows(3001, 1e-4, both));
  const FilteredRecord filtered(record, {2e-3, 1e-3}, 0.);
  BOOST_TEST(filtered.removed_rms == 2e-6 / std::sqrt(2.),
             boost::test_tools::tolerance(1e-3));
  BOOST_TEST(!filtered.is_periodic());
  double worst = 0.;
  for (double x = 0.; x < 0.3; x += 0.37e-4)
    worst =
      std::max(worst, std::abs(filtered.value(x) + record.mean - wave(x)));
  BOOST_TEST(worst < 1e-9);
  // beyond its ends come mirror images
  BOOST_TEST(filtered.value(-0.004) == filtered.value(0.004),
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(filtered.value(0.304) == filtered.value(0.296),
             boost::test_tools::tolerance(1e-12));
  // also of one whose ends differ
  const FilteredRecord slanted(read_rows(rows(3001,
                                              1e-4,
                                              [](const double x) {
                                                return 1e-6 *
                                                       std::cos(pi * x / 0.3);
                                              })),
                               {2e-3, 1e-3},
                               0.);
  for (const double x : {0.004, 0.07, 0.29})
    for (const double there : {-x, 0.6 - x, 0.6 + x, 1.2 - x})
      BOOST_TEST(slanted.value(there) == slanted.value(x),
                 boost::test_tools::tolerance(1e-12));
  BOOST_TEST(slanted.value(0.29) < -0.9e-6);
  const FilteredRecord unfiltered(record, {4e-4, 2e-4}, 0.);
  BOOST_TEST(unfiltered.removed_rms < 1e-15);
  BOOST_TEST(std::abs(unfiltered.value(0.1234) + record.mean - both(0.1234)) <
             1e-7);
}

/** Once around, with or without the first point again, to a percent. */
BOOST_FIXTURE_TEST_CASE(a_record_of_a_turn_comes_again, Records)
{
  const double turn   = 2.4;
  const auto   height = [&](const double x) {
    return 30e-6 * std::sin(2 * pi * 5 * x / turn);
  };
  for (const std::size_t n : {2400, 2401})
    {
      const SurfaceRecord  record = read_rows(rows(n, 1e-3, height));
      const FilteredRecord filtered(record, {2e-3, 1e-3}, turn);
      BOOST_TEST(filtered.is_periodic());
      for (const double x : {0., 0.0123, 1.7, 2.3995})
        {
          BOOST_TEST(std::abs(filtered.value(x) - height(x)) < 1e-9);
          BOOST_TEST(
            std::abs(filtered.value(x + 3 * turn) - filtered.value(x)) < 1e-16);
          BOOST_TEST(std::abs(filtered.value(x - turn) - filtered.value(x)) <
                     1e-16);
        }
    }
  // it does not matter where on the turn the file begins, however rough it is
  const auto rough = [](const double x) {
    const double k = std::round(1e3 * x);
    return 3e-6 * std::sin(k * k);
  };
  const FilteredRecord here(read_rows(rows(2400, 1e-3, rough)),
                            {2e-3, 1e-3},
                            turn),
    there(read_rows(rows(2400,
                         1e-3,
                         [&](const double x) {
                           return rough(std::fmod(x + 1.2, turn));
                         })),
          {2e-3, 1e-3},
          turn);
  for (double x = -0.01; x < 0.01; x += 0.37e-3)
    BOOST_TEST(std::abs(here.value(x) - there.value(x + 1.2)) < 1e-15);
  const SurfaceRecord short_one = read_rows(rows(2300, 1e-3, height));
  BOOST_TEST(!FilteredRecord(short_one, {2e-3, 1e-3}, turn).is_periodic());
}

/** Material goes with the flow; positions of files count as the wheel runs. */
BOOST_FIXTURE_TEST_CASE(surfaces_move_with_the_flow, Records)
{
  const auto bump = [](const double p) {
    return 10e-6 * std::exp(-std::pow((p - 0.1) / 0.01, 2));
  };
  SceneParameters scene  = scene_with(rows(401, 0.5e-3, bump, 0.06));
  const auto      top_at = [&](const MovingSurfaces &surfaces, const double s) {
    double best = 0., at = 0.;
    for (double x = -0.02; x <= 0.02; x += 1e-4)
      if (surfaces.height(x, 0., s) > best)
        best = surfaces.height(x, 0., s), at = x;
    return at;
  };
  for (const double flow : {1., -1.})
    {
      scene.contact.speed     = 20. * flow;
      scene.surfaces.position = 0.09;
      const MovingSurfaces surfaces(Situation(scene), sizes);
      // 0.01 m before it comes, it is upstream
      BOOST_TEST(std::abs(top_at(surfaces, 0.) + flow * 0.01) < 1e-6);
      BOOST_TEST(std::abs(top_at(surfaces, flow * 0.01)) < 1e-6);
      BOOST_TEST(std::abs(top_at(surfaces, flow * 0.015) - flow * 0.005) <
                 1e-6);
      // an expression is the frame's at position 0
      SceneParameters written      = scene;
      written.surfaces.height.rail = "1e-5*exp(-((x-0.012)/0.01)^2)";
      written.surfaces.position    = 0.;
      written.prm_folder           = scratch;
      const MovingSurfaces there(Situation(written), sizes);
      BOOST_TEST(std::abs(top_at(there, 0.) - 0.012) < 1e-6);
      BOOST_TEST(std::abs(top_at(there, -0.012)) < 1e-6);
      written.surfaces.position = 0.004;
      BOOST_TEST(
        std::abs(top_at(MovingSurfaces(Situation(written), sizes), 0.) -
                 (0.012 + flow * 0.004)) < 1e-6);
    }
}

/** A wheel's expression comes again after a turn, and must close there. */
BOOST_AUTO_TEST_CASE(a_wheel_comes_again_after_a_turn)
{
  SceneParameters scene;
  scene.contact.normal_load   = 100e3;
  scene.surfaces.height.wheel = "-2e-5*exp(-(x/0.02)^2)";
  const double         turn   = 2 * pi * scene.wheel.radius;
  const MovingSurfaces flat(Situation(scene), sizes);
  for (const double x : {0., 0.01, -0.013})
    BOOST_TEST(flat.height(x, 0., 3 * turn) == flat.height(x, 0., 0.),
               boost::test_tools::tolerance(1e-9));
  BOOST_TEST(std::abs(flat.height(0., 0., turn / 2)) < 1e-20);
  // 100.3 waves do not close; they need not before the run comes there
  scene.surfaces.height.wheel =
    "2e-5*sin(2*pi*100.3*x/" + std::to_string(turn) + ")";
  BOOST_TEST(complaint([&]() { MovingSurfaces(Situation(scene), sizes); }) ==
             "");
  scene.surfaces.position = turn / 2;
  const std::string said =
    complaint([&]() { MovingSurfaces(Situation(scene), sizes); });
  BOOST_TEST(contains(said, "the height jumps by"), said);
  scene.surfaces.height.wheel =
    "2e-5*sin(2*pi*100*x/" + std::to_string(turn) + ")";
  BOOST_TEST(complaint([&]() { MovingSurfaces(Situation(scene), sizes); }) ==
             "");
}

/** A record of a turn that drifts is warned of. */
BOOST_FIXTURE_TEST_CASE(the_ends_of_a_turn_meet, Records)
{
  for (const double drift : {0., 20e-6})
    {
      SceneParameters scene =
        scene_with(rows(10, 1., [](double) { return 0.; }));
      scene.surfaces.height = {"rail.csv", ""};
      write(scratch / "rail.csv", rows(2890, 1e-3, [&](const double x) {
              return 5e-6 * std::sin(40 * pi * x / 2.89) + drift * x / 2.89;
            }));
      scene.prm_folder = scratch;
      const MovingSurfaces surfaces(Situation(scene), sizes);
      BOOST_TEST(surfaces.warnings.size() == (drift > 0. ? 1 : 0));
      BOOST_TEST(contains(surfaces.notes.at(0), "it comes again after a turn"));
    }
}

/** Expressions are held against the elements along all that passes. */
BOOST_AUTO_TEST_CASE(expressions_suit_the_elements)
{
  SceneParameters scene;
  scene.contact.normal_load = 100e3;
  scene.rail.shape          = "block";
  scene.rail.radius         = 0.;
  std::vector<std::string> warnings;
  const auto               said_of = [&](const std::string &height) {
    scene.surfaces.height.rail = height;
    return complaint(
      [&]() { warnings = MovingSurfaces(Situation(scene), sizes).warnings; });
  };
  BOOST_TEST(said_of("2e-6*cos(2*pi*x/4e-3)") == "");
  BOOST_TEST(warnings.empty());
  BOOST_TEST(said_of("2e-6*cos(2*pi*x/1.5e-3)") == "");
  BOOST_TEST(warnings.size() == 1);
  const std::string two = said_of("2e-6*cos(2*pi*x/0.7e-3)");
  BOOST_TEST(contains(two, "waves shorter than two elements (0.001 m)"), two);
  BOOST_TEST(contains(two, "Mesh/Elements across patch"), two);
  const std::string high = said_of("20*cos(2*pi*x/0.03)");
  BOOST_TEST(contains(high, "the height are in m"), high);
  const std::string steep = said_of("3e-3*cos(2*pi*x/0.03)");
  BOOST_TEST(contains(steep, "a slope of"), steep);
  const std::string infinite = said_of("1e-9/x");
  BOOST_TEST(infinite != "");
  // what comes only later counts as well
  const std::string later = "2e-6*cos(2*pi*x/4e-3)+if(x<-1,1e-6,0)*cos(2*pi*x/"
                            "0.7e-3)";
  BOOST_TEST(said_of(later) == "");
  scene.analysis       = analysis_kind("transient");
  scene.contact.speed  = 10.;
  scene.time.end_time  = 0.2;
  scene.time.time_step = 1e-5;
  BOOST_TEST(contains(said_of(later), "shorter than two elements"));
}

/** A record that is too coarse, too short or ends before the run. */
BOOST_FIXTURE_TEST_CASE(records_suit_the_run, Records)
{
  SceneParameters scene = scene_with(rows(601, 0.5e-3, wave));
  const auto      said  = [&]() {
    return complaint([&]() { MovingSurfaces(Situation(scene), sizes); });
  };
  BOOST_TEST(said() == "");
  scene.surfaces.position = 0.31;
  BOOST_TEST(contains(said(), "Surfaces/Position"), said());
  scene.surfaces.position = 0.1;
  scene.analysis          = analysis_kind("transient");
  scene.contact.speed     = -10.;
  scene.time.time_step    = 1e-4;
  scene.time.end_time     = 0.0195;
  BOOST_TEST(said() == "");
  scene.time.end_time = 0.03;
  BOOST_TEST(contains(said(), "the wheel rolls from 0.1 to 0.4005 m"), said());
  scene.time.end_time                = 0.01;
  scene.surfaces.shortest_wavelength = 1.5e-3;
  BOOST_TEST(contains(said(), "Surfaces/Shortest wavelength"), said());
  scene.surfaces.shortest_wavelength = 0.;
  scene =
    scene_with(rows(601, 0.5, [](const double x) { return wave(x / 1000); }));
  BOOST_TEST(contains(said(), "its points are 0.5 m apart"), said());
}

/** Steps that nobody announced: of a vehicle code, or after a limit cycle. */
BOOST_FIXTURE_TEST_CASE(records_are_not_left, Records)
{
  SceneParameters scene   = scene_with(rows(601, 0.5e-3, wave));
  scene.surfaces.position = 0.1;
  for (const double flow : {1., -1.})
    {
      scene.contact.speed = 10. * flow;
      const MovingSurfaces surfaces(Situation(scene), sizes);
      const auto           said = [&](const double rolled) {
        return complaint([&]() {
          surfaces.heights({{{-8e-3, 0.}}, {{8e-3, 0.}}}, flow * rolled);
        });
      };
      BOOST_TEST(said(0.) == "");
      BOOST_TEST(said(0.2) == "");
      BOOST_TEST(said(-0.1) == "");
      BOOST_TEST(contains(said(0.201),
                          "it goes from 0 to 0.3 m, and the wheel "
                          "rolls to 0.301 m of it"),
                 said(0.201));
      BOOST_TEST(contains(said(0.201), "rail.csv"));
      BOOST_TEST(contains(said(-0.101), "rolls to -0.001 m of it"),
                 said(-0.101));
      BOOST_TEST(said(5.) != "");
    }
}

/** Up to the end of the record, and not beyond it; the session goes on. */
BOOST_FIXTURE_TEST_CASE(a_session_ends_with_its_record, Records)
{
  SceneParameters scene            = scene_with(rows(601, 0.5e-3, wave));
  scene.analysis                   = analysis_kind("transient");
  scene.wheel.radius               = 0.46;
  scene.wheel.hub_radius           = 0.3;
  scene.rail.block_length          = 0.2;
  scene.rail.block_depth           = 0.1;
  scene.mesh.elements_across_patch = 12;
  scene.contact.speed              = 10.;
  scene.surfaces.position          = 0.297;
  scene.time.time_step             = 1e-4;
  scene.time.end_time              = 1e-4;
  scene.time.inertia               = false;
  TransientSession session((Situation(scene)));
  for (unsigned int k = 0; k < 3; ++k)
    session.step(StepInputs());
  const double load = session.current().forces.normal_force;
  const auto   said = complaint([&]() { session.step(StepInputs()); });
  BOOST_TEST(contains(said, "rail.csv"), said);
  BOOST_TEST(contains(said, "the wheel rolls to 0.301 m of it"), said);
  BOOST_TEST(session.current().time == 3e-4,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(session.current().forces.normal_force == load);
}

/** The distance is the integral of the speed, the same however it is asked. */
BOOST_AUTO_TEST_CASE(distance_is_the_integral_of_speed)
{
  const TimeFunction      speed("Time/Speed", "-10 + 5*sin(40*t)", "");
  const TravelledDistance there(speed, 1e-2), again(speed, 1e-2);
  for (const double t : {0.3, 0.0123, 1., 0.})
    BOOST_TEST(there.value(t) == -10 * t + 5 * (1 - std::cos(40 * t)) / 40,
               boost::test_tools::tolerance(1e-12));
  again.value(0.5);
  BOOST_TEST(again.value(0.3) == there.value(0.3));
  BOOST_TEST(TravelledDistance(TimeFunction(-7.), 1e-3).value(2.) == -14.);
}

BOOST_AUTO_TEST_SUITE_END()
