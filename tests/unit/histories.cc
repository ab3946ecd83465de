#include <deal.II/base/parameter_handler.h>

#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include "scratch_folder.h"

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/program/analysis_table.h>
#include <rolling_contact/program/scene_reader.h>
#include <rolling_contact/scene/entries.h>
#include <rolling_contact/scene/scene_parameters.h>

#include <cmath>
#include <functional>
#include <iostream>
#include <sstream>

namespace
{
  using namespace RollingContact;

  const std::string table = "# measured\n"
                            "time_s, speed_m/s, spin_1/m\n"
                            "0, 10, -1\n"
                            "\n"
                            "2, 20, -3\n"
                            "2.5, 15, 7e-1\n";

  struct TransientScene : ScratchFolder
  {
    TransientScene()
    {
      scene.analysis            = analysis_kind("transient");
      scene.prm_folder          = scratch;
      scene.contact.approach    = 2e-4;
      scene.contact.speed       = 10.;
      scene.contact.creepages.x = 1e-3;
      scene.time.end_time       = 2.;
      scene.time.time_step      = 0.1;
    }

    std::string complaint_of_check() const
    {
      return complaint([&]() { scene.check(); });
    }

    /** What check() says to one changed entry; sets it back. */
    template <typename Value>
    std::string with(Value TimeParameters::*entry, const Value &value)
    {
      const Value before     = scene.time.*entry;
      scene.time.*entry      = value;
      const std::string said = complaint_of_check();
      scene.time.*entry      = before;
      return said;
    }

    SceneParameters scene;
  };
} // namespace

BOOST_AUTO_TEST_SUITE(histories)

BOOST_AUTO_TEST_CASE(numbers_and_expressions)
{
  const auto history = [](const std::string &text) {
    return TimeFunction("Time/Spin", text, "");
  };
  BOOST_TEST(TimeFunction(2.5).is_constant());
  BOOST_TEST(TimeFunction(2.5).value(7.) == 2.5);
  BOOST_TEST(history(" 1.7e-3 ").is_constant());
  BOOST_TEST(history("1.7e-3").value(1e9) == 1.7e-3);
  BOOST_TEST(history("2*pi").is_constant());
  BOOST_TEST(history("max(1,2)").is_constant());
  BOOST_TEST(history("2*pi").value(1.) == 2 * M_PI);
  for (const double t : {0., 0.3, 1.7})
    {
      BOOST_TEST(history("1e-3*sin(2*pi*50*t)").value(t) ==
                   1e-3 * std::sin(2 * M_PI * 50 * t),
                 boost::test_tools::tolerance(1e-14));
      BOOST_TEST(history("if(t<1, t^2, 1)").value(t) == (t < 1 ? t * t : 1.),
                 boost::test_tools::tolerance(1e-15));
    }
  BOOST_TEST(!history("t").is_constant());
  BOOST_TEST(!history("1e-3*exp(-t)").is_constant());
  BOOST_TEST(!history("if(t<1, t^2, 1)").is_table());

  const TimeFunction copy = history("3*t");
  BOOST_TEST(TimeFunction(copy).value(2.) == 6.);
}

/**
 * A jump shows within a step however long that is; what is merely steep, or
 * turns back, is none.
 */
BOOST_AUTO_TEST_CASE(jumps_are_found_where_they_are)
{
  const auto function = [](const std::string &text) {
    return TimeFunction("Time/Creepage x", text, "");
  };
  const TimeFunction step = function("if(t < 0.3, 1, 2)");
  BOOST_TEST(step.jumps_between(0.2, 0.3)); // takes the value behind it
  BOOST_TEST(step.jumps_between(0., 10.));
  BOOST_TEST(step.jumps_between(0.29999, 0.30001));
  BOOST_TEST(!step.jumps_between(0.3, 0.4));
  BOOST_TEST(!step.jumps_between(0., 0.29));
  BOOST_TEST(function("0.001 + if(t < 0.3, 0, 1e-6)").jumps_between(0.2, 0.4));
  const TimeFunction wave = function("sin(2 * pi * t)");
  for (unsigned int k = 0; k < 40; ++k)
    for (const double h : {1e-3, 0.025, 0.1})
      BOOST_TEST(!wave.jumps_between(0.025 * k, 0.025 * k + h));
  BOOST_TEST(!function("1e-3 + 1e-18 * sin(1e5 * t)").jumps_between(0., 1.));
  BOOST_TEST(!function("0.0017").jumps_between(0., 1.));

  DrivingFunctions driving{{},
                           {},
                           wave,
                           TimeFunction(0.),
                           TimeFunction(0.),
                           TimeFunction(10.),
                           {},
                           {},
                           {},
                           {}};
  BOOST_TEST(!driving.jump_between(0.2, 0.4));
  driving.approach = step;
  BOOST_TEST(driving.jump_between(0.2, 0.4));
  driving.approach      = {};
  driving.lateral_force = step;
  BOOST_TEST(driving.jump_between(0.2, 0.4));
  driving.lateral_force = {};
  BOOST_TEST(!driving.jump_between(0.2, 0.4));
  driving.speed = step;
  BOOST_TEST(driving.jump_between(0.2, 0.4));
}

BOOST_AUTO_TEST_CASE(bad_expressions_name_the_entry)
{
  const auto said = [](const std::string &text) {
    return complaint([&]() { TimeFunction("Time/Spin", text, ""); });
  };
  for (const std::string text : {"2*x",
                                 "sin(t",
                                 "1 +",
                                 "",
                                 "nan",
                                 "inf",
                                 "0,5",
                                 "1;2",
                                 "1.5 m",
                                 "rand()*t",
                                 "rand_seed(1)"})
    {
      BOOST_TEST_CONTEXT(text)
      {
        BOOST_TEST(contains(said(text), "Time/Spin = " + text + ": "));
        BOOST_TEST(contains(said(text), "Give a number, an expression in t"));
      }
    }
  BOOST_TEST(contains(said("0,5"), "decimals take a point"));
  BOOST_TEST(
    contains(said("2*x"),
             ": 'x' is not known here; there are t, pi and functions."));
  BOOST_TEST(contains(said("sin(t"), ": Missing parenthesis. Give"));

  std::ostringstream    errors;
  std::streambuf *const buffer = std::cerr.rdbuf(errors.rdbuf());
  said("sin(t");
  std::cerr << "end";
  std::cerr.rdbuf(buffer);
  BOOST_TEST(errors.str() == "end");
  BOOST_TEST(contains(complaint([]() {
                        TimeFunction("Time/Spin", "1/(t-2)", "").value(2.);
                      }),
                      "Time/Spin = 1/(t-2): at t = 2 s it is not finite"));
}

BOOST_FIXTURE_TEST_CASE(tables, ScratchFolder)
{
  write(scratch / "a b.csv", table);
  const auto history = [&](const std::string &text) {
    return TimeFunction("Time/Speed", text, scratch);
  };
  for (const std::string text :
       {"a b.csv", "table: a b.csv 2", "table: a b.csv speed_m/s"})
    {
      const TimeFunction speed = history(text);
      BOOST_TEST(!speed.is_constant());
      BOOST_TEST(speed.is_table());
      BOOST_TEST(speed.value(-1.) == 10.);
      BOOST_TEST(speed.value(0.) == 10.);
      BOOST_TEST(speed.value(0.5) == 12.5);
      BOOST_TEST(speed.value(2.) == 20.);
      BOOST_TEST(speed.value(2.25) == 17.5);
      BOOST_TEST(speed.value(2.5) == 15.);
      BOOST_TEST(speed.value(99.) == 15.);
    }
  BOOST_TEST(history("table: a b.csv 3").value(1.) == -2.);
  BOOST_TEST(history("table: a b.csv spin_1/m").value(3.) == 0.7);

  write(scratch / "blanks.txt", "0 1\r\n1\t3\r\n");
  const TimeFunction blanks = history("table: blanks.txt");
  BOOST_TEST(blanks.value(0.5) == 2.);
  write(scratch / "semicolons.csv", "0; 1\n1; 3\n");
  BOOST_TEST(history("semicolons.csv").value(0.5) == 2.);
  BOOST_TEST(history("semicolons.csv").table_fingerprint() ==
             blanks.table_fingerprint());
  write(scratch / "semicolons.csv", "0; 1\n1; 3.000000001\n");
  BOOST_TEST(history("semicolons.csv").table_fingerprint() !=
             blanks.table_fingerprint());
}

BOOST_FIXTURE_TEST_CASE(bad_tables_name_the_line, ScratchFolder)
{
  const auto said = [&](const std::string &text, const std::string &content) {
    write(scratch / "v.csv", content);
    return complaint([&]() { TimeFunction("Time/Speed", text, scratch); });
  };
  const auto says = [&](const std::string &content, const std::string &reason) {
    const std::string message = said("v.csv", content);
    BOOST_TEST_CONTEXT(message)
    {
      BOOST_TEST(contains(message, "Time/Speed = v.csv: "));
      BOOST_TEST(contains(message, (scratch / "v.csv").string()));
      BOOST_TEST(contains(message, reason));
    }
  };
  says("0,1\n1,x\n", "line 2: not a number");
  says("0,1\nx,1\n", "line 2: not a number");
  says("0,1\n1,nan\n", "line 2: not a number");
  says("0,1\n\n0,2\n", "line 3: the time does not rise");
  says("0,1\n1\n", "line 2: there is no column 2");
  says("0,1\n", "less than two rows");
  says("", "less than two rows");
  BOOST_TEST(contains(said("table: v.csv 1", table), "no column 1"));
  BOOST_TEST(contains(said("table: v.csv 4", table), "no column 4"));
  BOOST_TEST(contains(said("table: v.csv 2.5", table), "no column 2.5"));
  BOOST_TEST(contains(said("table: v.csv load_N", table), "no column load_N"));
  BOOST_TEST(contains(said("absent.csv", ""), "cannot be read"));
  BOOST_TEST(contains(said("table:", ""), "cannot be read"));
}

BOOST_FIXTURE_TEST_CASE(steps_of_equal_length, TransientScene)
{
  TimeParameters    &time = scene.time;
  const TimeFunction speed(-5.);
  const auto expect = [&](const double length, const std::uint64_t number) {
    const TimeSteps steps = time.steps(speed);
    BOOST_TEST(steps.length == length, boost::test_tools::tolerance(1e-15));
    BOOST_TEST(steps.number == number);
  };
  time.end_time  = 1.;
  time.time_step = 0.1;
  expect(0.1, 10);
  time.time_step = 0.3;
  expect(0.3, 4);
  time.time_step = 1e-7;
  expect(1e-7, 10000000);
  time.time_step = 7.;
  expect(7., 1);
  time.end_time  = 0.07;
  time.time_step = 0.01;
  expect(0.01, 7);
  time.end_time    = 1.;
  time.time_step   = 0.;
  time.step_length = 0.05;
  expect(0.01, 100);
  time.end_time        = 0.;
  time.rolled_distance = 0.2;
  expect(0.01, 4);

  time.theta             = 0.55;
  time.damping_frequency = 5e3;
  BOOST_TEST(time.numerical_damping(1e-6) == 1.57e-3,
             boost::test_tools::tolerance(1e-3));
}

BOOST_FIXTURE_TEST_CASE(rules_of_section_time, TransientScene)
{
  using T         = TimeParameters;
  const auto text = [](const char *characters) {
    return std::string(characters);
  };
  BOOST_TEST(complaint_of_check() == "");
  BOOST_TEST(contains(with(&T::end_time, 0.), "Time/End time = 0 and"));
  BOOST_TEST(contains(with(&T::rolled_distance, 1.), "needs one of them"));
  BOOST_TEST(contains(with(&T::time_step, 0.), "Time/Time step = 0 and"));
  BOOST_TEST(contains(with(&T::time_step, 1e-15), "steps: at most 1e12"));
  BOOST_TEST(with(&T::rayleigh_beta, 1e-6) == "");
  BOOST_TEST(with(&T::inertia, false) == "");
  BOOST_TEST(with(&T::approach, text("1e-4*t")) == "");
  BOOST_TEST(contains(with(&T::normal_load, text("1e4")),
                      "Time/Normal load = 1e4: give Contact/Normal load too"));
  BOOST_TEST(contains(with(&T::spin, text("t")), "Time/Spin = t: "));
  BOOST_TEST(contains(with(&T::creepage_y, text("0")), "3D only"));
  BOOST_TEST(with(&T::speed, text("10+t")) == "");
  BOOST_TEST(contains(with(&T::speed, text("10-8*t")),
                      "Time/Speed is -0.4 at t = 1.3 s: "));
  BOOST_TEST(contains(with(&T::speed, text("-10")), "keep the sign"));
  BOOST_TEST(contains(with(&T::creepage_x, text("1/(t-1)")),
                      "Time/Creepage x = 1/(t-1): at t = 1 s"));

  scene.time.rayleigh_alpha = 1.;
  BOOST_TEST(contains(with(&T::inertia, false), "without inertia there is no"));
  scene.time.rayleigh_alpha = 0.;
  scene.time.time_step      = 0.;
  scene.time.step_length    = 1.;
  BOOST_TEST(complaint_of_check() == "");
  BOOST_TEST(contains(with(&T::speed, text("10+t")),
                      "Time/Step length = 1: it needs a constant speed"));

  scene.time.step_length             = 0.;
  scene.time.time_step               = 0.1;
  scene.contact.friction_coefficient = 0.;
  BOOST_TEST(with(&T::speed, text("10-8*t")) == "");
  scene.contact.approach    = {};
  scene.contact.normal_load = 1e4;
  BOOST_TEST(with(&T::normal_load, text("1e4*(1+t)")) == "");
  BOOST_TEST(
    contains(with(&T::normal_load, text("1e4*(1-t)")), "contact cannot pull"));
  BOOST_TEST(contains(with(&T::approach, text("1e-4")),
                      "Time/Approach = 1e-4: give Contact/Approach too"));
}

BOOST_FIXTURE_TEST_CASE(empty_histories_are_the_constants, TransientScene)
{
  write(scratch / "spin.csv", table);
  scene.time.spin     = "table: spin.csv 3";
  scene.time.approach = "2e-4*t";
  const DrivingFunctions driving =
    scene.time.histories(scene.contact, scene.prm_folder);
  BOOST_TEST(driving.creepage_x.value(1.) == 1e-3);
  BOOST_TEST(driving.creepage_x.is_constant());
  BOOST_TEST(driving.speed.value(1.) == 10.);
  BOOST_TEST(driving.spin.value(1.) == -2.);
  BOOST_TEST(!driving.normal_load.has_value());
  BOOST_REQUIRE(driving.approach.has_value());
  BOOST_TEST(driving.approach->value(0.5) == 1e-4);
  BOOST_REQUIRE(driving.tables.size() == 1u);
  BOOST_TEST(contains(driving.tables.at("Time/Spin (table)"),
                      "3 rows from 0 to 2.5 s, CRC-32 "));
}

BOOST_AUTO_TEST_CASE(entries_have_units_and_bounds)
{
  const std::string all = documented_parameters();
  for (const std::string entry :
       {"Theta", "Rayleigh alpha", "Checkpoint seconds"})
    BOOST_TEST(contains(all, "set " + entry));
  dealii::ParameterHandler prm;
  TimeParameters           time;
  Entries                  entries;
  time.declare(entries);
  entries.declare(prm);
  prm.enter_subsection("Time");
  BOOST_CHECK_THROW(prm.set("Theta", "0.49"), dealii::ExceptionBase);
  BOOST_CHECK_THROW(prm.set("Theta", "1.01"), dealii::ExceptionBase);
  BOOST_CHECK_THROW(prm.set("Time step", "-1"), dealii::ExceptionBase);
  prm.leave_subsection();
}

BOOST_AUTO_TEST_SUITE_END()
