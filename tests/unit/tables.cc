#include <boost/test/unit_test.hpp>

#include "drawing_run.h"

#include <rolling_contact/base/ordered_work.h>
#include <rolling_contact/program/analysis_table.h>
#include <rolling_contact/results/result_row.h>
#include <rolling_contact/tables/kept_bodies.h>
#include <rolling_contact/tables/load_bands.h>
#include <rolling_contact/tables/table_output.h>

#include <atomic>
#include <cmath>
#include <numeric>
#include <set>

using namespace RollingContact;

/** Analysis = table: which states there are, and how they are gone through. */
BOOST_AUTO_TEST_SUITE(tables)

namespace
{
  SceneParameters table_scene(const std::vector<std::string> &axes)
  {
    SceneParameters scene;
    scene.analysis             = analysis_kind("table");
    scene.dimension            = 3;
    scene.wheel.lateral_radius = scene.rail.lateral_radius = 0.3;
    scene.contact.normal_load                              = 36e3;
    for (std::size_t k = 0; k < axes.size(); ++k)
      scene.table.axis_texts[k] = axes[k];
    return scene;
  }

  TablePlan plan_of(const std::vector<std::string> &axes)
  {
    return plan_table(Situation(table_scene(axes)));
  }

  std::string said_of(const std::vector<std::string> &axes)
  {
    return complaint([&]() { plan_of(axes); });
  }
} // namespace

BOOST_AUTO_TEST_CASE(axes_that_are_none)
{
  BOOST_TEST(contains(said_of({}), "Table/Axis 1 and Table/File of rows"));
  BOOST_TEST(
    contains(said_of({"Contact/Creepage x ="}),
             "Table/Axis 1 = Contact/Creepage x = : the list is empty"));
  BOOST_TEST(contains(said_of({"Contact/Creepage x"}),
                      "Table/Axis 1 = Contact/Creepage x: give it as"));
  BOOST_TEST(contains(said_of({"Contact/Creepage x = 1, 2, 1"}), "twice"));
  BOOST_TEST(contains(said_of({"Contact/Creepage x = 0, one"}), "'one'"));
  BOOST_TEST(contains(said_of({"Contact/Spin = 0, 1", "Contact/Spin = 2"}),
                      "Table/Axis 1 is this entry already"));
  BOOST_TEST(contains(said_of({"", "Contact/Creepage = 0"}),
                      "Table/Axis 2: there is no entry Contact/Creepage"));
  BOOST_TEST(
    contains(said_of({"Contact/Friction law = 0"}), "is not a number"));
  BOOST_TEST(contains(said_of({"Contact/Roughness = 0"}), "is not a number"));
  BOOST_TEST(contains(said_of({"Output/Verbosity = 0"}), "cannot vary"));
  BOOST_TEST(contains(said_of({"Dimension = 2, 3"}), "cannot vary"));
  BOOST_TEST(contains(said_of({"Contact/Friction coefficient = -0.1, 0.3"}),
                      "Contact/Friction coefficient = -0.1"));
  BOOST_TEST(contains(said_of({"Mesh/Elements across patch = 8.5"}), "8.5"));
  BOOST_TEST(contains(said_of({"Contact/Creepage x = 0 : 1 : 2000",
                               "Contact/Creepage y = 0 : 1 : 2000"}),
                      "a million"));
  // values that contradict others, only in one state
  BOOST_TEST(contains(said_of({"Contact/Normal load = -5, 3"}),
                      "Contact/Normal load = -5: contact cannot pull"));
  BOOST_TEST(contains(said_of({"Contact/Approach = 1e-5"}),
                      "The state of the table with Contact/Approach = 1e-05"));
}

BOOST_AUTO_TEST_CASE(files_that_have_no_rows)
{
  const ScratchFolder scratch;
  SceneParameters     scene = table_scene({});
  scene.prm_folder          = scratch.scratch;
  scene.table.file_of_rows  = "rows.csv";
  const auto said           = [&](const std::string &text) {
    std::ofstream(scratch.scratch / "rows.csv") << text;
    return complaint([&]() { plan_table(Situation(scene)); });
  };
  BOOST_TEST(contains(complaint([&]() { plan_table(Situation(scene)); }),
                      "cannot be read"));
  BOOST_TEST(contains(said(""), "the file is empty"));
  BOOST_TEST(contains(said("Contact/Spin\n"), "there is no row"));
  BOOST_TEST(contains(said("Contact/Spin,Contact/Spin\n0,1\n"), "two columns"));
  BOOST_TEST(contains(said("Contact/Spin,\n0,1\n"), "column 2 has no name"));
  BOOST_TEST(contains(said("Contact/Spin;Contact/Creepage x\n0;1\n\n2\n"),
                      "line 4: it has 1 columns"));
  BOOST_TEST(contains(said("Contact/Spin\n0,1\n"), "line 2"));
  BOOST_TEST(contains(said("Contact/Spin\nnan\n"), "'nan' is not a number"));
  BOOST_TEST(
    contains(said("Contact/Spn\n1\n"), "there is no entry Contact/Spn"));
  BOOST_TEST(said("\xEF\xBB\xBF\"Contact/Spin\" ; Contact/Creepage x\r\n"
                  "# a comment\r\n 0.5 ; -1e-3 \r\n") == "");
  const TablePlan plan = plan_table(Situation(scene));
  BOOST_REQUIRE(plan.values.size() == 1u);
  BOOST_TEST(plan.values[0][0] == 0.5);
  BOOST_TEST(plan.values[0][1] == -1e-3);
}

BOOST_AUTO_TEST_CASE(neighbours_differ_by_one_step)
{
  const TablePlan plan = plan_of({"Contact/Creepage x = -0.01 : 0.01 : 5",
                                  "Contact/Normal load = 40e3, 20e3, 30e3",
                                  "Contact/Spin = 0, 1, 3, 4"});
  BOOST_REQUIRE(plan.values.size() == 60u);
  BOOST_TEST(plan.values[0][1] == 20e3); // ascending, the last axis fastest
  BOOST_TEST(plan.values[1][2] == 1.);
  BOOST_TEST(plan.values[59][0] == 0.01);
  BOOST_TEST(plan.units[1] == "N");
  BOOST_TEST(plan.units[0] == "1");
  BOOST_REQUIRE(plan.groups.size() == 1u);
  const auto &order = plan.groups[0].states;
  BOOST_TEST(std::set<std::size_t>(order.begin(), order.end()).size() == 60u);
  unsigned int n_load_steps = 0;
  for (std::size_t k = 1; k < order.size(); ++k)
    {
      unsigned int n_steps = 0;
      for (std::size_t d = 0; d < 3; ++d)
        {
          const auto  &values = plan.axes[d].values;
          const double from   = plan.values[order[k - 1]][d],
                       to     = plan.values[order[k]][d];
          const auto place    = [&](const double value) {
            return std::find(values.begin(), values.end(), value) -
                   values.begin();
          };
          n_steps += std::abs(place(from) - place(to));
          n_load_steps += d == 1 && from != to;
        }
      BOOST_TEST(n_steps == 1u);
    }
  BOOST_TEST(n_load_steps == 2u);
}

BOOST_AUTO_TEST_CASE(what_makes_new_bodies)
{
  const auto n_groups = [](const std::string &axis) {
    return plan_of({axis, "Contact/Creepage y = 0, 0.001"}).groups.size();
  };
  BOOST_TEST(n_groups("Contact/Speed = 1, 2, 20") == 1u);
  BOOST_TEST(n_groups("Contact/Speed = -2, -1, 1, 2") == 2u);
  BOOST_TEST(n_groups("Contact/Friction coefficient = 0.1, 0.3") == 1u);
  BOOST_TEST(n_groups("Contact/Friction coefficient = 0, 0.1, 0.3") == 2u);
  BOOST_TEST(n_groups("Rail/Poisson ratio = 0.25, 0.3") == 2u);
  BOOST_TEST(n_groups("Mesh/Elements across patch = 8, 10, 12") == 3u);
}

BOOST_AUTO_TEST_CASE(each_load_has_its_elements)
{
  SceneParameters scene =
    table_scene({"Contact/Normal load = 0, 20e3, 55e3, 70e3, 80e3, 100e3",
                 "Contact/Creepage x = 0, 0.001"});
  scene.mesh.elements_across_patch = 12;
  const TablePlan plan             = plan_table(Situation(scene));
  const auto      bands = load_bands(Situation(scene), plan, smallest_patch);
  BOOST_REQUIRE(bands.size() == 4u); // 100 and 80, 70 and 55, 20, 0 kN
  std::set<std::size_t> all;
  for (const LoadBand &band : bands)
    {
      all.insert(band.states.begin(), band.states.end());
      if (!band.touches())
        continue;
      SceneEntries entries{Situation(scene)};
      const auto   made = band.scene(plan, entries);
      BOOST_TEST(wanted_mesh(made).patch.half_width_x == band.largest_size);
      for (const std::size_t state : band.states)
        {
          plan.set(state, entries);
          const double share =
            wanted_mesh(entries.situation()).patch.half_width_x /
            band.largest_size;
          BOOST_TEST(share <= 1.);
          BOOST_TEST(share >= smallest_patch);
          BOOST_TEST(made.mesh.elements_across_patch * share >= 12 - 1e-6);
          BOOST_TEST(made.mesh.elements_across_patch <= 14u);
        }
    }
  BOOST_TEST(all.size() == plan.values.size());
  BOOST_TEST(!bands.back().touches());
  BOOST_TEST(bands[0].states.size() == 4u);
}

BOOST_AUTO_TEST_CASE(work_in_threads_ends_in_order)
{
  for (const unsigned int n_threads : {1u, 2u, 5u})
    {
      std::vector<std::size_t>  followed;
      std::vector<double>       results(50, 0.);
      std::atomic<unsigned int> n_workers = 0;
      do_in_order(
        results.size(),
        n_threads,
        [&]() {
          ++n_workers;
          return [&](const std::size_t k) { results[k] = std::sqrt(k); };
        },
        [&](const std::size_t k) {
          BOOST_TEST(results[k] == std::sqrt(k));
          followed.push_back(k);
        });
      std::vector<std::size_t> all(results.size());
      std::iota(all.begin(), all.end(), 0);
      BOOST_TEST(followed == all, boost::test_tools::per_element());
      BOOST_TEST(n_workers <= n_threads);
    }
  std::size_t n_followed = 0;
  const auto  says       = [&]() {
    do_in_order(
      20,
      3,
      []() {
        return [](const std::size_t k) {
          if (k == 7 || k == 9)
            throw InputError(std::to_string(k));
        };
      },
      [&](std::size_t) { ++n_followed; });
  };
  BOOST_TEST(complaint(says) == "7");
  BOOST_TEST(n_followed == 7u);
  BOOST_TEST(complaint([&]() {
               do_in_order(
                 9,
                 2,
                 []() { return [](std::size_t) {}; },
                 [](const std::size_t k) {
                   if (k == 3)
                     throw InputError("disk");
                 });
             }) == "disk");
}

/** A note to a solver's name is no fallback, unless it says so. */
BOOST_FIXTURE_TEST_CASE(what_stood_in_for_a_solver, DrawingRun)
{
  const TablePlan plan = plan_table(
    Situation(table_scene({"Contact/Creepage x = 0.001 : 0.005 : 5"})));
  const std::vector<std::string> solvers{
    "normal-tangential split, from fast sliding",
    "normal-tangential split",
    "normal-tangential split, fallback extragradient",
    "normal-tangential split, edges unsettled",
    "normal-tangential split, edges unsettled"};
  for (std::size_t state = 0; state < solvers.size(); ++state)
    {
      begin_table_row(plan,
                      state,
                      state < 4 ? TableStatus::solved
                                : TableStatus::not_converged,
                      table);
      table.set("solver", solvers[state]);
      table.set("bound_force/muN", 0.01);
      table.end_row();
    }
  table.flush();
  ResultsTable again(run_folder);
  RunContext   resumed{run_folder, again, report, timer, log};
  restore_rows(plan, resumed);
  BOOST_TEST(summary_of(again).n_fallbacks == 2u);
  BOOST_TEST(summary_of(table).n_fallbacks == 0u);
}

// whatever came first, as parts and ranks have it
BOOST_AUTO_TEST_CASE(columns_that_lead)
{
  ResultsTable table;
  table.set("state", 3);
  table.set("converged", false);
  table.end_row();
  table.set("state", 1);
  table.set("x", 1. / 3);
  table.end_row();
  table.lead_with({"state", "none", "x"});
  BOOST_TEST(table.csv() == "state,x,converged\n3,,false\n1,0.333333333,\n");
  BOOST_TEST(table.number(1, "x").value() == 1. / 3);
  table.set("converged", true);
  table.set("x", 2);
  table.end_row();
  BOOST_TEST(contains(table.csv(), "\n,2,true\n"));
  BOOST_TEST(table.written_number(1, "x").value() == 0.333333333);
  BOOST_TEST(table.written_number(0, "converged").value() == 0.);
  BOOST_TEST(!table.written_number(0, "x").has_value());
}

// as of a state that was given up, and of one that is solved
BOOST_AUTO_TEST_CASE(order_of_columns_whichever_rows_come_first)
{
  ResultsTable given_up, solved, one, other;
  given_up.set("state", 1);
  given_up.set("converged", false);
  given_up.end_row();
  solved.set("state", 2);
  solved.set("x", 5);
  solved.set("converged", true);
  solved.leave_empty("y");
  solved.end_row();
  one.append(given_up);
  one.append(solved);
  other.append(solved);
  other.append(given_up);
  other.sort_by("state");
  BOOST_TEST(one.csv() == "state,x,converged,y\n1,,false,\n2,5,true,\n");
  BOOST_TEST(other.csv() == one.csv());
}

BOOST_AUTO_TEST_CASE(rows_that_are_read_again)
{
  ResultsTable table, more, again;
  table.set("state", 3);
  table.set("text", std::string("a, \"b\"\nc"));
  table.set("x", 0.1);
  table.end_row();
  more.set("state", 1);
  more.leave_empty("x");
  more.set("y", true);
  more.end_row();
  table.append(more);
  BOOST_TEST(table.csv() ==
             "state,text,x,y\n3,\"a, \"\"b\"\"\nc\",0.1,\n1,,,true\n");
  again.restore(table.csv(), "f.csv");
  BOOST_TEST(again.csv() == table.csv());
  BOOST_TEST(again.number(0, "x").value() == 0.1);
  BOOST_TEST(again.number(1, "y").value() == 1.);
  BOOST_TEST(!again.number(0, "text"));
  BOOST_TEST(!again.number(1, "x"));
  BOOST_TEST(!again.number(1, "none"));
  BOOST_TEST(again.has_numbers("x"));
  BOOST_TEST(!again.has_numbers("text"));
  again.sort_by("state");
  BOOST_TEST(again.csv() ==
             "state,text,x,y\n1,,,true\n3,\"a, \"\"b\"\"\nc\",0.1,\n");
  again.set("state", 2);
  again.end_row();
  BOOST_TEST(contains(again.csv(), "c\",0.1,\n2,,,\n"));
  BOOST_TEST(contains(complaint([]() {
                        ResultsTable().restore("a,b\n1,2\n3\n", "f.csv");
                      }),
                      "f.csv: row 2 has 1 columns"));
}

/** What is read of a table is what was set, whatever the file shows of it, and
 * a text of a file is read as the value that it stands for. */
BOOST_AUTO_TEST_CASE(cells_are_values)
{
  ResultsTable table, again;
  table.set("x_m", 1. / 3);
  table.set("status", "no contact", TableStatus::no_contact);
  table.set("Contact/Spin", "0.12345678901234", 0.12345678901234);
  table.set("known", std::optional<double>(2.));
  table.set("unknown", std::optional<double>());
  table.end_row();
  BOOST_TEST(table.number(0, "x_m").value() == 1. / 3);
  BOOST_TEST(
    (*table.value<TableStatus>(0, "status") == TableStatus::no_contact));
  BOOST_TEST(!table.value<double>(0, "status")); // another type
  BOOST_TEST(!table.value<double>(0, "x_m"));    // set without a text
  BOOST_TEST(!table.has_numbers("status"));
  BOOST_TEST(table.csv() == "x_m,status,Contact/Spin,known,unknown\n"
                            "0.333333333,no contact,0.12345678901234,2,\n");
  again.restore(table.csv(),
                "f.csv",
                {{"status",
                  [](const std::string &name, const std::size_t row) {
                    return std::any(name + std::to_string(row));
                  }},
                 {"Contact/Spin", [](const std::string &text, std::size_t) {
                    return std::any(2 * std::stod(text));
                  }}});
  BOOST_TEST(*again.value<std::string>(0, "status") == "no contact0");
  BOOST_TEST(*again.value<double>(0, "Contact/Spin") == 2 * 0.12345678901234);
  BOOST_TEST(again.number(0, "x_m").value() == 0.333333333);
  BOOST_TEST(again.csv() == table.csv());
}

/** Every status has a name of its own, and a row that a stopped table left is
 * of the state that it says. */
BOOST_FIXTURE_TEST_CASE(rows_of_a_stopped_table, DrawingRun)
{
  const TablePlan                plan = plan_table(Situation(
    table_scene({"Contact/Creepage x = 0.001, 0.002", "Contact/Spin = 0.1"})));
  const std::vector<TableStatus> all{TableStatus::solved,
                                     TableStatus::no_contact,
                                     TableStatus::broken,
                                     TableStatus::not_converged,
                                     TableStatus::not_enclosed};
  std::set<std::string>          names;
  for (const TableStatus status : all)
    {
      names.insert(name_of(status));
      ResultsTable left, read;
      begin_table_row(plan, 1, status, left);
      left.set("solver", "active set, fallback fixed point", SolvedBy{true});
      left.end_row();
      BOOST_TEST((status_of_row(left, 0) == status));
      BOOST_TEST(state_of_row(left, 0) == 1u);
      BOOST_TEST(*left.value<double>(0, "Contact/Creepage x") == 0.002);
      run_folder.write_atomically("results.csv", left.csv());
      RunContext context{run_folder, read, report, timer, log};
      restore_rows(plan, context);
      BOOST_TEST((status_of_row(read, 0) == status));
      BOOST_TEST(state_of_row(read, 0) == 1u);
      BOOST_TEST(read.value<SolvedBy>(0, "solver")->stood_in);
      BOOST_TEST(read.csv() == left.csv());
    }
  BOOST_TEST(names.size() == all.size());
  const auto said = [&](const std::string &text) {
    run_folder.write_atomically("results.csv", text);
    ResultsTable read;
    RunContext   context{run_folder, read, report, timer, log};
    return complaint([&]() { restore_rows(plan, context); });
  };
  const std::string head = "state,Contact/Creepage x,Contact/Spin,status\n";
  BOOST_TEST(said(head + "1,0.002,0.1,solved\n") == "");
  for (const char *row : {"2,0.002,0.1,solved\n",
                          "1,0.001,0.1,solved\n",
                          "1.5,0.002,0.1,solved\n",
                          "-1,0.002,0.1,solved\n",
                          ",0.002,0.1,solved\n",
                          "1,,0.1,solved\n",
                          "1,0.002,0.1,\n",
                          "1,0.002,0.1,solved\n1,0.002,0.1,solved\n"})
    BOOST_TEST(contains(said(head + row), "is not one of its states"));
  BOOST_TEST(contains(said(head + "1,0.002,0.1,done\n"),
                      "row 1: column status has \"done\""));
  BOOST_TEST(!solved_by("active set, from fast sliding").stood_in);
  BOOST_TEST(solved_by("active set, edges unsettled").stood_in);
}

/** A summary counts what rows say: solved states alone have bounds and may
 * lack them. */
BOOST_AUTO_TEST_CASE(summary_of_rows)
{
  const TablePlan plan = plan_table(
    Situation(table_scene({"Contact/Creepage x = 1e-3, 2e-3, 3e-3, 4e-3"})));
  ResultsTable table;
  const auto   add = [&](const std::size_t           state,
                       const TableStatus           status,
                       const std::optional<double> bound,
                       const bool                  stood_in) {
    begin_table_row(plan, state, status, table);
    table.set("bound_force/muN", bound);
    table.set("bound_max_pressure", bound);
    table.set("solver", "any", SolvedBy{stood_in});
    table.end_row();
  };
  add(0, TableStatus::solved, 0.01, false);
  add(1, TableStatus::solved, 0.03, true);
  add(2, TableStatus::solved, {}, false);
  add(3, TableStatus::not_converged, 0.5, true);
  const TableSummary summary = summary_of(table);
  BOOST_TEST(summary.largest_bound.value() == 0.03);
  BOOST_TEST(summary.n_fallbacks == 1u);
  BOOST_TEST(summary.n_without_bound == 1u);
  BOOST_TEST(summary.states.at(TableStatus::solved).size() == 3u);
  BOOST_CHECK_EXCEPTION(summary.require_solved(plan),
                        ConvergenceError,
                        [](const ConvergenceError &error) {
                          return contains(error.what(),
                                          "1 x not converged, first state 3 "
                                          "(Contact/Creepage x = 0.004)");
                        });
}

BOOST_AUTO_TEST_SUITE_END()
