#include "drawing_run.h"
#include "time_run.h"

#include <rolling_contact/analyses/creep_curve.h>
#include <rolling_contact/analyses/creep_curve_parameters.h>
#include <rolling_contact/analyses/creep_curve_plot.h>
#include <rolling_contact/analyses/cycle_sweep.h>
#include <rolling_contact/analyses/error_cost_report.h>
#include <rolling_contact/analyses/limit_cycle_parameters.h>
#include <rolling_contact/analyses/load_curve.h>
#include <rolling_contact/analyses/quasi_static.h>
#include <rolling_contact/analyses/transient.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/program/analysis_table.h>
#include <rolling_contact/results/reference_2d.h>
#include <rolling_contact/results/state_report.h>
#include <rolling_contact/tables/stability_map_plot.h>
#include <rolling_contact/tables/table_output.h>
#include <rolling_contact/time/cycle_recording.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace
{
  using namespace RollingContact;
  using Values = std::vector<double>;

  void
  check_equal(const Values &found, const Values &expected, const double factor)
  {
    BOOST_REQUIRE_EQUAL(found.size(), expected.size());
    BOOST_TEST(!found.empty());
    for (std::size_t i = 0; i < found.size(); ++i)
      BOOST_TEST(std::abs(found[i] - factor * expected[i]) <=
                 1e-7 * std::abs(factor * expected[i]));
  }
} // namespace

BOOST_AUTO_TEST_SUITE(pictures)

BOOST_FIXTURE_TEST_CASE(load_curve_in_kilonewton_and_micrometres, DrawingRun)
{
  standard<3>(scene);
  scene.analysis                                  = analysis_kind("load curve");
  scene.own<LoadCurveParameters>().load_fractions = {0.5, 1.};
  scene.check();
  LoadCurve<3>(Situation(scene), drawing).run();
  table.flush();
  BOOST_TEST(is_drawn("load_curve"));
  BOOST_TEST(contains(script("load_curve"), "set xlabel 'approach (\u00b5m)'"));
  BOOST_TEST(contains(script("load_curve"), "set ylabel 'load (kN)'"));
  const auto computed = block("load_curve", "finite elements"),
             hertz    = block("load_curve", "Hertz, without bulk");
  const Values loads  = column("results.csv", "normal_force_N");
  check_equal(computed[0], column("results.csv", "approach_m"), 1e6);
  check_equal(computed[1], loads, 1e-3);
  check_equal(hertz[0], column("results.csv", "reference_approach_m"), 1e6);
  check_equal(hertz[1], loads, 1e-3);
}

BOOST_FIXTURE_TEST_CASE(creep_curve_in_percent_of_creepage, DrawingRun)
{
  standard<3>(scene);
  scene.analysis                               = analysis_kind("creep curve");
  scene.own<CreepCurveParameters>().creepage_y = {0.001, 0.004, 0.02};
  scene.check();
  CreepCurve<3>(Situation(scene), drawing).run();
  table.flush();
  BOOST_TEST(is_drawn("creep_curve"));
  BOOST_TEST(
    contains(script("creep_curve"), "set xlabel 'lateral creepage (%)'"));
  BOOST_TEST(contains(script("creep_curve"), "set ylabel '|T| / (\u03bcN)'"));
  const auto computed = block("creep_curve", "finite elements");
  check_equal(computed[0], {0.1, 0.4, 2.}, 1.);
  check_equal(computed[1],
              column("results.csv", "traction_coefficient"),
              1. / scene.contact.friction_coefficient);
  for (const char *reference : {"Shen, Hedrick, Elkins", "FASTSIM"})
    {
      const auto theory = block("creep_curve", reference);
      BOOST_TEST(theory[0] == computed[0], boost::test_tools::per_element());
      for (std::size_t i = 0; i < theory[1].size(); ++i)
        BOOST_TEST(std::abs(theory[1][i] - computed[1][i]) < 0.1);
    }
  const auto linear = block("creep_curve", "Kalker, linear");
  BOOST_TEST(linear[0].front() == 0.1);
  BOOST_TEST(linear[1].front() > computed[1].front());
  BOOST_TEST(linear[1].back() <= 1.2);
}

BOOST_FIXTURE_TEST_CASE(creep_curves_of_several_spins, DrawingRun)
{
  standard<3>(scene);
  scene.analysis                               = analysis_kind("creep curve");
  scene.own<CreepCurveParameters>().creepage_y = {0.001, 0.004, 0.001, 0.004};
  scene.own<CreepCurveParameters>().spin       = {0., 0., 0.5, 0.5};
  scene.check();
  CreepCurve<3>(Situation(scene), drawing).run();
  table.flush();
  BOOST_TEST(is_drawn("creep_curve"));
  const Values force  = column("results.csv", "force_y_N"),
               moment = column("results.csv", "spin_moment_Nm");
  for (const std::size_t line : {0, 1})
    {
      const std::string label = line == 0 ? "spin 0 1/m" : "spin 0.5 1/m";
      const auto        y     = block("creep_curve", label, "F_y (kN)"),
                 m            = block("creep_curve", label, "M_z (Nm)");
      check_equal(y[0], {0.1, 0.4}, 1.);
      check_equal(y[1], {force[2 * line], force[2 * line + 1]}, 1e-3);
      check_equal(m[1], {moment[2 * line], moment[2 * line + 1]}, 1.);
      BOOST_TEST(y[1][1] < 0.);
    }
  BOOST_TEST(!contains(script("creep_curve"), "Kalker"));
  BOOST_TEST(!contains(script("creep_curve"), "F_x"));
}

BOOST_AUTO_TEST_CASE(lines_of_a_creep_curve)
{
  const auto lines = [](const std::vector<Creepages> &points) {
    return CreepLines(points);
  };
  const CreepLines one = lines({{0.001, 0., 0.}, {0.002, 0., 0.}});
  BOOST_TEST(one.lines.size() == 1u);
  BOOST_TEST(one.label == "longitudinal creepage (%)");
  BOOST_TEST(one.lines[0].label == "finite elements");
  // both rise: a line along the path, over the lateral creepage
  const CreepLines path =
    lines({{0., 0., 0.}, {1e-3, 2e-3, 0.}, {2e-3, 4e-3, 0.}});
  BOOST_TEST(path.lines.size() == 1u);
  BOOST_TEST(path.abscissa[2] == 0.4);
  // three spins and two lateral creepages: two lines over the spin
  const CreepLines over_spin = lines({{0., 0., 0.},
                                      {0., 0., 1.},
                                      {0., 0., 2.},
                                      {0., 0.01, 0.},
                                      {0., 0.01, 1.},
                                      {0., 0.01, 2.}});
  BOOST_TEST(over_spin.label == "spin (1/m)");
  BOOST_TEST(over_spin.lines.size() == 2u);
  BOOST_TEST(over_spin.lines[1].label == "lateral creepage 1 %");
  BOOST_TEST(over_spin.lines[1].points[0] == 3u);
}

BOOST_FIXTURE_TEST_CASE(no_carter_where_he_does_not_hold, DrawingRun)
{
  standard<2>(scene);
  scene.contact.creepages.x = 0.001;
  scene.rail.radius         = 0.92;
  scene.check();
  const auto steady = solve_steady_state<2>(Situation(scene), {}, drawing);
  plot_line_tractions(Situation(scene), steady, drawing);
  BOOST_TEST(is_drawn("tractions"));
  BOOST_TEST(!contains(script("tractions"), "Carter"));
  BOOST_TEST(contains(script("tractions"), "Hertz"));
}

BOOST_FIXTURE_TEST_CASE(tractions_over_the_patch, DrawingRun)
{
  standard<2>(scene);
  scene.contact.creepages.x = 0.001;
  scene.check();
  const auto steady = solve_steady_state<2>(Situation(scene), {}, drawing);
  plot_line_tractions(Situation(scene), steady, drawing);
  BOOST_TEST(is_drawn("tractions"));
  BOOST_TEST(contains(
    script("tractions"),
    "set ylabel 'p / p\u2080,   q / (\u03bcp\u2080),   "
    "p\u2080 = " +
      significant(
        1e-6 * reference_2d(Situation(scene), steady).hertz.max_pressure, 4) +
      " MPa'"));
  BOOST_TEST(contains(
    script("tractions"),
    "a = " +
      significant(1e3 * reference_2d(Situation(scene), steady).hertz.half_width,
                  4) +
      " mm"));
  BOOST_TEST(
    contains(script("tractions"),
             "N = " + significant(1e-3 * steady.result.normal_force, 4) +
               " kN"));
  const auto largest = [](const Values &values) {
    return *std::max_element(values.begin(), values.end());
  };
  const auto pressure = block("tractions", "pressure p"),
             traction = block("tractions", "traction q on the wheel"),
             hertz    = block("tractions", "Hertz"),
             carter   = block("tractions", "Carter"),
             bound    = block("tractions", "bound \u03bcp");
  BOOST_TEST(std::abs(largest(pressure[1]) - 1.) < 0.02);
  BOOST_TEST(std::abs(largest(hertz[1]) - 1.) < 1e-4);
  BOOST_TEST(std::abs(largest(hertz[0]) - 1.15) < 1e-9);
  BOOST_TEST(largest(traction[1]) < 1e-9);
  BOOST_TEST(largest(carter[1]) <= 0.);
  for (std::size_t i = 0; i < pressure[1].size(); ++i)
    BOOST_TEST(std::abs(bound[1][i] + pressure[1][i]) < 1e-8);
  // a bound mu p0 of the tractions, a force mu N
  double sum = 0., total = 0.;
  for (std::size_t i = 0; i < pressure[1].size(); ++i)
    {
      sum += traction[1][i];
      total += pressure[1][i];
    }
  const double ratio =
    steady.result.force_x /
    (scene.contact.friction_coefficient * steady.result.normal_force);
  BOOST_TEST(std::abs(sum / total - ratio) < 0.02);
}

BOOST_FIXTURE_TEST_CASE(history_in_millimetres_and_milliseconds, DrawingRun)
{
  standard<2>(scene);
  scene.analysis            = analysis_kind("transient");
  scene.contact.creepages.x = 0.001;
  scene.time.end_time       = 5e-4;
  scene.check();
  Transient<2>(Situation(scene), drawing).run();
  BOOST_TEST(is_drawn("history"));
  BOOST_TEST(contains(script("history"), "set xlabel 'rolled distance (mm)'"));
  BOOST_TEST(contains(script("history"), "set ylabel 'T / (\u03bcN)'"));
  const auto forces = block("history", "longitudinal"),
             loads  = block("history", "load N"),
             drive  = block("history", "longitudinal creepage");
  check_equal(loads[0], column("history.csv", "rolled_m"), 1e3);
  check_equal(loads[1], column("history.csv", "normal_force_N"), 1e-3);
  check_equal(drive[1], column("history.csv", "creepage_x"), 100.);
  BOOST_TEST(contains(script("history"), "set ylabel 'N (kN)'"));
  BOOST_TEST(contains(script("history"), "set ylabel 'creepage (%)'"));
  const Values force = column("history.csv", "force_x_N"),
               load  = column("history.csv", "normal_force_N");
  check_equal(forces[0], column("history.csv", "rolled_m"), 1e3);
  BOOST_REQUIRE_EQUAL(forces[1].size(), 5u);
  for (std::size_t i = 0; i < 5; ++i)
    BOOST_TEST(
      std::abs(forces[1][i] * scene.contact.friction_coefficient * load[i] -
               force[i]) < 1e-6 * load[i]);
}

/**
 * With theta = 0.5 the forces of a step act in its middle.
 */
BOOST_FIXTURE_TEST_CASE(forces_are_drawn_where_they_act, DrawingRun)
{
  standard<2>(scene);
  scene.analysis              = analysis_kind("transient");
  scene.contact.creepages.x   = 0.001;
  scene.contact.slip_operator = SlipOperatorKind::upwind_2;
  scene.time.inertia          = true;
  scene.time.initial_state    = InitialState::steady;
  scene.time.creepage_x       = "0.001 + 0.1 * t";
  scene.time.time_step        = 1e-5;
  scene.time.end_time         = 3e-5;
  scene.check();
  Transient<2>(Situation(scene), drawing).run();
  const Values time = column("history.csv", "time_s"),
               acts = column("history.csv", "force_time_s");
  BOOST_REQUIRE_EQUAL(time.size(), 3u);
  Values middles, ends;
  for (std::size_t i = 0; i < 3; ++i)
    {
      BOOST_TEST(acts[i] == time[i] - 0.5e-5,
                 boost::test_tools::tolerance(1e-8));
      middles.push_back(10 * acts[i]);
      ends.push_back(10 * time[i]);
    }
  check_equal(block("history", "longitudinal")[0], middles, 1e3);
  check_equal(block("history", "load N")[0], middles, 1e3);
  check_equal(block("history", "longitudinal creepage")[0], ends, 1e3);
}

BOOST_FIXTURE_TEST_CASE(load_in_time, DrawingRun)
{
  standard<2>(scene);
  scene.analysis                     = analysis_kind("transient");
  scene.contact.friction_coefficient = 0.;
  scene.time.end_time                = 3e-4;
  scene.check();
  Transient<2>(Situation(scene), drawing).run();
  BOOST_TEST(contains(script("history"), "set xlabel 'time (ms)'"));
  BOOST_TEST(contains(script("history"), "set ylabel 'N (kN)'"));
  const auto loads = block("history", "load N");
  check_equal(loads[0], column("history.csv", "time_s"), 1e3);
  check_equal(loads[1], column("history.csv", "normal_force_N"), 1e-3);
}

/**
 * A patch that slides sideways, in a period of two steps: no traction along x
 * on the line through its middle.
 */
BOOST_FIXTURE_TEST_CASE(record_of_a_patch_that_slides_sideways, DrawingRun)
{
  standard<3>(scene);
  scene.analysis            = analysis_kind("transient");
  scene.contact.creepages.y = 0.02;
  scene.check();
  const Situation   situation(scene);
  ContactStepper<3> stepper(situation, PairDemands(), drawing);
  record_cycle(situation, 0., 1e-4, 2e-4, stepper, drawing);
  const char  *file = "cycle_patch.csv";
  const Values time = column(file, "time_s"), phase = column(file, "phase"),
               place    = column(file, "x_m"),
               pressure = column(file, "pressure_Pa"),
               along    = column(file, "traction_x_Pa"),
               across = column(file, "traction_y_Pa"), y = column(file, "y_m");
  const double peak  = *std::max_element(pressure.begin(), pressure.end()),
               bound = scene.contact.friction_coefficient * peak;
  BOOST_TEST(peak > 0.);
  check_equal(phase, time, 1 / 2e-4);
  BOOST_TEST(phase.front() == 0.5);
  BOOST_TEST(phase.back() == 1.);
  for (std::size_t k = 0; k < time.size(); ++k)
    {
      BOOST_TEST(y[k] == y[0]);
      BOOST_TEST(std::abs(along[k]) < 0.02 * bound);
      BOOST_TEST(across[k] <= 0.);
    }
  BOOST_TEST(*std::min_element(across.begin(), across.end()) < -0.5 * bound);
  // the end of the period, node by node
  const ContactState &state   = stepper.current().state;
  const auto         &at      = stepper.current().problem.operators.positions();
  unsigned int        n_found = 0;
  for (std::size_t k = 0; k < time.size(); ++k)
    for (unsigned int i = 0; i < at.size() && phase[k] == 1.; ++i)
      if (std::hypot(at[i][0] - place[k], at[i][1] - y[k]) < 1e-9)
        {
          ++n_found;
          BOOST_TEST(std::abs(pressure[k] - state.pressure[i]) <= 1e-8 * peak);
          BOOST_TEST(std::abs(across[k] - state.traction(1, i)) <=
                     1e-8 * bound);
        }
  BOOST_TEST(2 * n_found == time.size());
  BOOST_TEST(n_found > 4u);
  BOOST_TEST(is_drawn("cycle_patch"));
}

/**
 * Made-up forces over load, creepage and spin: each line is named by its value
 * and holds the states it is named by.
 */
BOOST_FIXTURE_TEST_CASE(sections_of_a_table, DrawingRun)
{
  standard<3>(scene);
  scene.analysis            = analysis_kind("table");
  scene.contact.approach    = {};
  scene.contact.normal_load = 20e3;
  scene.table.axis_texts    = {"Contact/Normal load = 800, 20e3, 45e3",
                               "Contact/Creepage x = 0.001, 0.002",
                               "Contact/Spin = 0, 0.5"};
  const auto force =
    [](const double N, const double creepage, const double spin) {
      return N * (100 * creepage + 0.01 * spin);
    };
  const TablePlan plan = plan_table(Situation(scene));
  BOOST_REQUIRE_EQUAL(plan.values.size(), 12u);
  for (std::size_t state = 0; state < 12; ++state)
    {
      const auto &at = plan.values[state];
      table.set("state", state);
      table.set("status", "solved", TableStatus::solved);
      table.set("force_x_N", force(at[0], at[1], at[2]));
      table.set("force_y_N", 0.);
      table.set("spin_moment_Nm", at[0] * at[2]);
      table.end_row();
    }
  plot_sections(plan, drawing);
  BOOST_TEST(contains(script("table_1"), "Table at Spin 0.5 1/m"));
  BOOST_TEST(contains(script("table_1"), "set xlabel 'Normal load (N)'"));
  BOOST_TEST(contains(script("table_2"), "set xlabel 'Creepage x'"));
  BOOST_TEST(contains(script("table_3"), "set xlabel 'Spin (1/m)'"));
  BOOST_TEST(contains(script("table_3"), "Table at Creepage x 0.002"));
  BOOST_TEST(!contains(script("table_1"), "F_y"));
  for (const auto &[label, N] : {std::pair("Normal load 800 N", 800.),
                                 std::pair("Normal load 20 kN", 20e3),
                                 std::pair("Normal load 45 kN", 45e3)})
    {
      const auto over_creepage = block("table_2", label, "F_x (kN)"),
                 over_spin     = block("table_3", label, "F_x (kN)"),
                 moment        = block("table_3", label, "M_z (Nm)");
      check_equal(over_creepage[0], {0.001, 0.002}, 1.);
      check_equal(over_creepage[1],
                  {force(N, 0.001, 0.5), force(N, 0.002, 0.5)},
                  1e-3);
      check_equal(over_spin[0], {0., 0.5}, 1.);
      check_equal(over_spin[1],
                  {force(N, 0.002, 0.), force(N, 0.002, 0.5)},
                  1e-3);
      check_equal(moment[1], {0., N * 0.5}, 1.);
    }
  const auto over_load = block("table_1", "Creepage x 0.001", "F_x (kN)");
  check_equal(over_load[0], {800., 20e3, 45e3}, 1.);
  check_equal(over_load[1],
              {force(800., 0.001, 0.5),
               force(20e3, 0.001, 0.5),
               force(45e3, 0.001, 0.5)},
              1e-3);
}

/** A state that was not solved has no point, whatever its row holds. */
BOOST_FIXTURE_TEST_CASE(unsolved_states_are_not_drawn, DrawingRun)
{
  standard<3>(scene);
  scene.analysis            = analysis_kind("table");
  scene.contact.approach    = {};
  scene.contact.normal_load = 20e3;
  scene.table.axis_texts[0] = "Contact/Creepage x = 0.001, 0.002, 0.003";
  const TablePlan plan      = plan_table(Situation(scene));
  for (std::size_t state = 0; state < 3; ++state)
    {
      begin_table_row(plan,
                      state,
                      state == 1 ? TableStatus::not_converged
                                 : TableStatus::solved,
                      table);
      table.set("force_x_N", 1000. * (state + 1));
      table.end_row();
    }
  plot_sections(plan, drawing);
  const std::string data = read(files.folder / "table_1.dat");
  BOOST_TEST(contains(data, "0.001\t1\n"));
  BOOST_TEST(contains(data, "0.003\t3\n"));
  BOOST_TEST(!contains(data, "0.002\t2\n"));
}

/** The map over two axes, the last one of which counts fastest: growth as it
 * is, frequencies in kHz where something grows, axes in kN and degrees. */
BOOST_FIXTURE_TEST_CASE(map_of_vibrations, DrawingRun)
{
  TablePlan plan;
  plan.axes  = {{"Table/Axis 1", "Contact/Normal load", {10e3, 20e3}},
                {"Table/Axis 2", "Rail/Cant", {0., 0.1, 0.2}}};
  plan.units = {"N", "rad"};
  const Values growth{-1., 2., 3., 4., -5., 6.};
  for (std::size_t state = 6; state-- > 0;)
    {
      table.set("state", state);
      table.set("n_unstable", state + 10);
      table.set("largest_growth_1/s", growth[state]);
      table.set("fastest_Hz", 1000. * (state + 1));
      table.end_row();
    }
  plot_stability_map(plan, drawing);
  BOOST_TEST(contains(script("stability_map"), "Normal load (kN)"));
  BOOST_TEST(contains(script("stability_map"), "Cant (degrees)"));
  const auto corners = [&](const std::string &name, const std::string &label) {
    std::map<std::pair<double, double>, double> found;
    std::istringstream lines(read(files.folder / (name + ".dat")));
    std::string        line, value;
    std::getline(lines, line); // the title
    BOOST_TEST((std::getline(lines, line) && line == "# " + label));
    while (std::getline(lines, line))
      {
        std::istringstream numbers(line);
        double             x, y;
        if (numbers >> x >> y >> value)
          found[{std::round(x), std::round(y)}] = std::stod(value);
      }
    return found;
  };
  const double degree = pi / 180;
  const auto   cell   = [&](const double load, const double cant) {
    // the lower corner of a cell, half way to its neighbour
    return std::pair(std::round(load - 5.),
                     std::round(cant / degree - 0.05 / degree));
  };
  const auto map   = corners("stability_map", "1/s; grey: none grows"),
             count = corners("stability_map_count", "number"),
             kHz = corners("stability_map_frequency", "kHz; white: none grows");
  for (std::size_t state = 0; state < 6; ++state)
    {
      const auto at = cell(state < 3 ? 10. : 20., 0.1 * (state % 3));
      BOOST_TEST(map.at(at) == growth[state]);
      BOOST_TEST(count.at(at) == state + 10.);
      if (growth[state] > 0.)
        BOOST_TEST(kHz.at(at) == state + 1.);
    }
  // the line of no growth, between the values by rule of three
  const std::string data = read(files.folder / "stability_map.dat");
  for (const std::string piece : {"\n12\t0\n20\t2.54647909\n",
                                  "\n12.8571429\t5.72957795\n10\t1.90985932\n",
                                  "\n12.8571429\t5.72957795\n20\t8.33393157\n"})
    BOOST_TEST(contains(data, piece), piece);
  // colours from 0 to the largest
  BOOST_TEST(contains(script("stability_map"), "set cbrange [-0.5:6]"));
  BOOST_TEST(contains(script("stability_map"), "0 \"#DDDDDD\", 0 \"#440154\""));
  BOOST_TEST(!contains(script("stability_map_count"), "set cbrange"));
}

/** The amplitude of a cycle is the larger of those along x and y, in m/s, over
 * the values of the axis; 0 for what has decayed. */
BOOST_FIXTURE_TEST_CASE(sweep_of_limit_cycles, DrawingRun)
{
  LimitCycleParameters parameters;
  parameters.axis      = "Contact/Friction coefficient";
  parameters.values    = "0.2, 0.3, 0.4";
  parameters.direction = SweepDirection::both;
  const auto runs      = sweep_runs(parameters, 1);
  BOOST_REQUIRE_EQUAL(runs.size(), 5u);
  const std::vector<RunEnd> ends{Cycles::Motion::decayed,
                                 Cycles::Motion::periodic,
                                 Cycles::Motion::periodic,
                                 Cycles::Motion::periodic,
                                 Cycles::Motion::changing};
  for (std::size_t row = 0; row < 5; ++row)
    {
      table.set("largest_growth_1/s", 10. * *runs[row].value);
      table.set("cycle", name_of(ends[row]), ends[row]);
      table.set("cycle_frequency_Hz", 400.);
      table.set("cycle_velocity_x_amplitude_m/s", 0.1 * row);
      table.set("cycle_velocity_y_amplitude_m/s", row == 2 ? 0.7 : 0.01);
      table.end_row();
    }
  plot_sweep(parameters, runs, drawing);
  const auto up    = block("limit_cycles", "start 1, up"),
             down  = block("limit_cycles", "start 1, down"),
             small = block("limit_cycles", "while it is small");
  check_equal(up[0], {0.2, 0.3, 0.4}, 1.);
  check_equal(up[1], {0., 0.1, 0.7}, 1.);
  check_equal(down[0], {0.3, 0.2}, 1.);
  check_equal(down[1], {0.3, 0.4}, 1.);
  check_equal(small[1], {0.2, 0.3, 0.4}, 10.);
  note_sweep(parameters, runs, {400.}, drawing);
  const auto finding = [&](const std::string &name) {
    for (const auto &[key, text] : drawing.report.findings)
      if (key == name)
        return text;
    return std::string();
  };
  BOOST_TEST(finding("cycles") ==
             "of 5 runs 1 changing, 1 decayed, 3 periodic");
  BOOST_TEST(finding("sweep") ==
             "hysteresis: up and down end in different motions at 0.3, 0.2");
  BOOST_TEST(contains(said.str(), "1 of the runs still change at their end"));
}

/** Each end has a name, and the name tells it. */
BOOST_AUTO_TEST_CASE(ends_of_runs)
{
  for (const RunEnd &end : {RunEnd(),
                            RunEnd(Cycles::Motion::too_short),
                            RunEnd(Cycles::Motion::periodic),
                            RunEnd(Cycles::Motion::stationary),
                            RunEnd(Cycles::Motion::decayed),
                            RunEnd(Cycles::Motion::changing)})
    BOOST_TEST((end_named(name_of(end)) == end));
}

BOOST_FIXTURE_TEST_CASE(error_against_seconds, DrawingRun)
{
  const std::vector<CostedError> points{{"coarse", "8", 0.1, 1e-2},
                                        {"coarse", "16", 0.4, 3e-3},
                                        {"fine", "8", 0.3, 2e-2},
                                        {"fine", "16", 0.9, 1e-4}};
  report_errors_and_costs({{"all", points}}, "error of T", "state", drawing);
  BOOST_TEST(is_drawn("error_cpu"));
  for (const char *line : {"set xlabel 'CPU seconds per state'",
                           "set ylabel 'error of T'",
                           "set logscale x\n",
                           "set logscale y\n"})
    BOOST_TEST(contains(script("error_cpu"), line), line);
  const auto fine  = block("error_cpu", "fine"),
             front = block("error_cpu", "Pareto front");
  check_equal(fine[0], {0.3, 0.9}, 1.);
  check_equal(fine[1], {2e-2, 1e-4}, 1.);
  check_equal(front[0], {0.1, 0.4, 0.9}, 1.);
  check_equal(front[1], {1e-2, 3e-3, 1e-4}, 1.);
}

BOOST_FIXTURE_TEST_CASE(profiles_in_the_track, DrawingRun)
{
  standard<3>(scene);
  scene.rail.shape             = "block";
  scene.rail.radius            = 0.;
  scene.rail.lateral_radius    = 0.;
  scene.wheel.lateral_radius   = 0.;
  scene.profiles.wheel_profile = "S1002";
  scene.profiles.rail_profile  = "60E1";
  scene.profiles.is_left       = true;
  scene.profiles.shift         = -4e-3;
  scene.profiles.roll          = 0.;
  scene.contact.approach       = {};
  scene.contact.normal_load    = 20e3;
  scene.contact.creepages      = {};
  scene.output.body_fields     = false;
  scene.check();
  QuasiStatic<3>(Situation(scene), drawing).run();
  table.flush();
  BOOST_TEST(is_drawn("profiles"));
  const auto first = block("profiles", "first contact");
  const auto place = column("results.csv", "contact_y_track_m");
  BOOST_TEST(place[0] < -0.73);
  check_equal(first[0], place, 1e3);
  // wheel and rail meet there, and the wheel is nowhere in the rail
  const auto rail  = block("profiles", "rail"),
             wheel = block("profiles", "wheel");
  double least     = 1.;
  for (std::size_t i = 0; i < wheel[0].size(); ++i)
    for (std::size_t k = 1; k < rail[0].size(); ++k)
      if ((wheel[0][i] - rail[0][k - 1]) * (wheel[0][i] - rail[0][k]) <= 0.)
        {
          const double share =
            (wheel[0][i] - rail[0][k - 1]) / (rail[0][k] - rail[0][k - 1]);
          const double height =
            rail[1][k - 1] + share * (rail[1][k] - rail[1][k - 1]);
          if (height > -10.) // of the head, not of its sides
            least = std::min(least, wheel[1][i] - height);
        }
  BOOST_TEST(std::abs(least) < 1e-3);
  // the patch lies around the contact, on the plane's slope
  const auto patch  = block("profiles", "patch"),
             plane  = block("profiles", "plane of contact"),
             normal = block("profiles", "its normal");
  BOOST_TEST(patch[0].front() < first[0][0]);
  BOOST_TEST(patch[0].back() > first[0][0]);
  const double angle = column("results.csv", "contact_angle_rad")[0];
  BOOST_TEST(angle > 0.09);
  BOOST_TEST((plane[1][1] - plane[1][0]) / (plane[0][1] - plane[0][0]) ==
               -std::tan(angle),
             boost::test_tools::tolerance(1e-6));
  BOOST_TEST((normal[0][1] - normal[0][0]) / (normal[1][1] - normal[1][0]) ==
               std::tan(angle),
             boost::test_tools::tolerance(1e-6));
  const auto peaks = block("profiles", "peak pressure along x");
  check_equal({*std::max_element(peaks[1].begin(), peaks[1].end())},
              column("results.csv", "max_pressure_Pa"),
              1e-6);
  BOOST_TEST(peaks[0][0] < 0.);
  BOOST_TEST(peaks[1][0] == 0.);
}

BOOST_AUTO_TEST_SUITE_END()
