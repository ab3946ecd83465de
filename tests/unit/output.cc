#define BOOST_BIND_GLOBAL_PLACEHOLDERS
#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>
#include <boost/test/unit_test.hpp>

#include "scratch_folder.h"
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/files.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/memory.h>
#include <rolling_contact/base/platform.h>
#include <rolling_contact/base/stopwatch.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/run/log.h>
#include <rolling_contact/run/phase_timer.h>
#include <rolling_contact/run/results_table.h>
#include <rolling_contact/run/run_folder.h>
#include <rolling_contact/run/run_report.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <regex>
#include <sstream>
#include <thread>

namespace
{
  using namespace RollingContact;
  namespace fs = std::filesystem;
  using boost::property_tree::ptree;

  ptree read_json(const fs::path &file)
  {
    ptree tree;
    boost::property_tree::read_json(file.string(), tree);
    return tree;
  }

  unsigned int count(const std::string &text, const std::string &part)
  {
    unsigned int n_found = 0;
    for (std::size_t i = text.find(part); i != std::string::npos;
         i             = text.find(part, i + 1))
      ++n_found;
    return n_found;
  }

  std::size_t n_entries(const fs::path &folder)
  {
    return std::distance(fs::directory_iterator(folder),
                         fs::directory_iterator());
  }

  void spin(const double seconds)
  {
    const auto begin = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - begin <
           std::chrono::duration<double>(seconds))
      ;
  }

  const PhaseTimer::Row &row_of(const std::vector<PhaseTimer::Row> &rows,
                                const Phase                         phase)
  {
    for (const PhaseTimer::Row &row : rows)
      if (row.phase == phase)
        return row;
    throw std::out_of_range(name_of(phase));
  }
} // namespace

BOOST_AUTO_TEST_SUITE(output)

BOOST_AUTO_TEST_CASE(numbers_as_text)
{
  BOOST_TEST(significant(1234.5678, 4) == "1235");
  BOOST_TEST(significant(-1.25e-7, 9) == "-1.25e-07");
  BOOST_TEST(significant(-0., 3) == "0");
  BOOST_TEST(significant(std::nan(""), 3) == "nan");
  BOOST_TEST(significant(-INFINITY, 3) == "-inf");
  BOOST_TEST(scientific(123456., 3) == "1.23e+05");
  BOOST_TEST(human_bytes(0) == "0 B");
  BOOST_TEST(human_bytes(999999) == "1 MB");
  BOOST_TEST(human_bytes(3.1e9) == "3.1 GB");
  BOOST_TEST(millimetres(0.0012345, 3) == "1.23 mm");
  BOOST_TEST(human_seconds(0.0351) == "35 ms");
  BOOST_TEST(human_seconds(13.72) == "13.7 s");
  BOOST_TEST(human_seconds(119.7) == "2 min 00 s");
  BOOST_TEST(human_seconds(3725) == "1 h 02 min");
}

BOOST_AUTO_TEST_CASE(wrapping_and_utf8)
{
  BOOST_TEST(wrapped("aa bb cc", 5) == "aa bb\n  cc");
  BOOST_TEST(wrapped("  aa bb cc\nshort  line", 8) ==
             "  aa bb\n    cc\nshort\n  line");
  BOOST_TEST(wrapped("  a  table   row\n", 80) == "  a  table   row\n");
  BOOST_TEST(wrapped("\u03BC\u03BC \u03BC\u03BC", 5) ==
             "\u03BC\u03BC \u03BC\u03BC");
  BOOST_TEST(wrapped("averyverylongword b", 5) == "averyverylongword\n  b");
  BOOST_TEST(valid_utf8("\u03BC \xB5 \xED\xA0\x80") ==
             "\u03BC \uFFFD \uFFFD\uFFFD\uFFFD");
}

BOOST_AUTO_TEST_CASE(log_levels)
{
  for (const Verbosity verbosity :
       {Verbosity::quiet, Verbosity::normal, Verbosity::verbose})
    {
      std::ostringstream out, errors;
      Log                log(verbosity, out, errors);
      log.message("message");
      log.detail("detail");
      log.warning("slow BLAS");
      log.error("broken");

      BOOST_TEST(count(out.str(), "message") ==
                 (verbosity != Verbosity::quiet));
      BOOST_TEST(count(out.str(), "detail") ==
                 (verbosity == Verbosity::verbose));
      BOOST_TEST(errors.str() == "Warning: slow BLAS\nError: broken\n");
      BOOST_TEST(log.warnings().size() == 1u);
    }
}

BOOST_AUTO_TEST_CASE(work_done_a_second_time)
{
  std::ostringstream out, errors;
  Log                log(Verbosity::normal, out, errors);
  log.warning("coarse");
  {
    const Log::Again again(log);
    log.message("message");
    log.warning("coarse");
    log.warning("slow");
    log.warning("slow");
  }
  log.message("next");
  log.warning("coarse");
  BOOST_TEST(out.str() == "next\n");
  BOOST_TEST(errors.str() ==
             "Warning: coarse\nWarning: slow\nWarning: coarse\n");
  BOOST_TEST(log.warnings().size() == 3u);
}

BOOST_AUTO_TEST_CASE(phases_sum_to_the_run)
{
  using Clock   = std::chrono::steady_clock;
  using Seconds = std::chrono::duration<double>;

  const auto before = Clock::now();
  PhaseTimer timer;
  const auto begin = Clock::now();
  {
    PhaseTimer::Scope outer(timer, Phase::mesh);
    spin(0.02);
    {
      PhaseTimer::Scope inner(timer, Phase::condensation);
      std::thread([&]() {
        PhaseTimer::Scope ignored(timer, Phase::fields);
        spin(0.05);
      }).join();
    }
    PhaseTimer::Scope again(timer, Phase::condensation);
  }
  spin(0.01);

  const auto end   = Clock::now();
  const auto rows  = timer.rows();
  const auto after = Clock::now();
  const auto total = PhaseTimer::total(rows);

  BOOST_TEST(total.wall_seconds >= Seconds(end - begin).count() - 1e-6);
  BOOST_TEST(total.wall_seconds <= Seconds(after - before).count() + 1e-6);
  BOOST_TEST(rows.size() == 3u);
  BOOST_TEST(name_of(rows.back().phase) == "other");
  BOOST_TEST(row_of(rows, Phase::condensation).n_calls == 2u);
  BOOST_TEST(row_of(rows, Phase::condensation).wall_seconds >= 0.05);
  BOOST_TEST(row_of(rows, Phase::condensation).cpu_seconds > 1e-3);
  BOOST_TEST(row_of(rows, Phase::other).wall_seconds >= 0.01);
  BOOST_TEST(row_of(rows, Phase::mesh).wall_seconds >= 0.02);
  BOOST_TEST(row_of(rows, Phase::mesh).wall_seconds <=
             total.wall_seconds - 0.06);

  std::istringstream lines(timer.summary());
  for (std::string line; std::getline(lines, line);)
    BOOST_TEST(line.size() == 80u);
}

BOOST_AUTO_TEST_CASE(memory_is_plausible)
{
  const std::size_t before = peak_memory();
  BOOST_TEST(before > 1000000u);
  BOOST_TEST(available_memory() > 1000000u);

  std::vector<char> block(50000000, 'x');
  std::vector<char>().swap(block);
  BOOST_TEST(peak_memory() > 50000000u);
}

BOOST_AUTO_TEST_CASE(peak_memory_since_a_reset)
{
  const std::size_t large = 60000000;
  {
    const std::vector<char> held(large, 1);
    BOOST_TEST(held[large / 2] == 1);
  }
  const std::size_t peak = peak_memory();
  release_free_memory();
  BOOST_TEST_REQUIRE(reset_peak_memory());
#ifndef __SANITIZE_ADDRESS__ // which keeps what was freed
  BOOST_TEST(peak_memory_since_reset() + large / 2 < peak);
#endif
  // the system counts to some pages
  BOOST_TEST(peak_memory() + 1000000 > peak);
  const std::size_t       before = peak_memory_since_reset();
  const std::vector<char> held(large, 1);
  BOOST_TEST(held[large / 2] == 1);
  BOOST_TEST(peak_memory_since_reset() > before + large / 2);
}

BOOST_AUTO_TEST_CASE(interrupts)
{
  for (const int signal : {SIGINT, SIGTERM})
    {
      install_interrupt_handlers();
      BOOST_TEST(!interrupted());
      BOOST_CHECK_NO_THROW(throw_if_interrupted());
      kill(getpid(), signal); // heard by another thread
      for (int k = 0; k < 500 && !interrupted(); ++k)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      BOOST_TEST(interrupted());
      BOOST_CHECK_THROW(throw_if_interrupted(), Interrupted);
    }
  install_interrupt_handlers();
}

namespace
{
  /**
   * How a process ends that never stops by itself and gets these signals, with
   * what it leaves.
   */
  std::pair<int, std::string>
  end_of_busy_process(const std::vector<int>      &signals,
                      const std::filesystem::path &folder)
  {
    const pid_t child = fork();
    if (child == 0)
      {
        install_interrupt_handlers();
        leave_on_stop(folder / "words", folder / ".words.part", "last words");
        for (const int signal : signals)
          {
            kill(getpid(), signal);
            for (int k = 0; k < 500 && !interrupted(); ++k)
              std::this_thread::sleep_for(std::chrono::milliseconds(10));
          }
        for (;;)
          pause();
      }
    int status = 0;
    waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1,
            read_bytes(folder / "words")};
  }
} // namespace

BOOST_FIXTURE_TEST_CASE(second_interrupt_ends_the_process, ScratchFolder)
{
  std::filesystem::create_directories(folder);
  const auto expected = std::make_pair(2, std::string("last words"));
  BOOST_CHECK(end_of_busy_process({SIGINT, SIGINT}, folder) == expected);
  std::filesystem::remove(folder / "words");
  const Stopwatch watch;
  BOOST_CHECK(end_of_busy_process({SIGTERM}, folder) == expected);
  BOOST_TEST(watch.seconds() > seconds_to_stop - 1);
  BOOST_TEST(watch.seconds() < seconds_to_stop + 5);
}

BOOST_AUTO_TEST_CASE(platform)
{
  const BlasLibrary blas = loaded_blas();
  BOOST_TEST(!blas.name.empty());
  BOOST_TEST((blas.name == "none") == blas.file.empty());
  BOOST_TEST((blas.name == "reference BLAS") == blas.is_reference);
  BOOST_CHECK_NO_THROW(use_one_solver_thread());
  BOOST_TEST(n_host_cpus() >= 1u);
  BOOST_TEST(library_versions().size() >= 4u);
  for (const auto &[name, version] : library_versions())
    BOOST_TEST(!version.empty(), name);
}

BOOST_FIXTURE_TEST_CASE(run_folder_is_created_by_open, ScratchFolder)
{
  RunFolder run(folder, "set A = 1", "set A = 1\nset B = 2");
  BOOST_TEST(n_entries(scratch) == 0u);
  BOOST_CHECK_THROW(run.temporary("a.csv"), std::logic_error);

  run.open();
  BOOST_TEST(read(folder / "original.prm") == "set A = 1");
  BOOST_TEST(read(folder / "used.prm") == "set A = 1\nset B = 2");
  const ptree record = read_json(folder / "run.json");
  BOOST_TEST(record.front().first == "program");
  BOOST_TEST(record.get<std::string>("program") == "rolling-contact");
  BOOST_TEST(record.get<std::string>("status") == "failed");
  BOOST_TEST(RunFolder::default_path("prm/carter.2d.prm") ==
             fs::path("output/carter.2d"));
}

BOOST_FIXTURE_TEST_CASE(files_appear_when_complete, ScratchFolder)
{
  {
    RunFolder run(folder, "", "");
    run.open();
    write(run.temporary("wheel-0001.vtu"), "whole");
    BOOST_TEST(!fs::exists(folder / "wheel-0001.vtu"));
    BOOST_TEST(count(read(folder / "run.json"), "wheel-0001.vtu") == 1u);
    run.publish("wheel-0001.vtu");
    BOOST_TEST(read(folder / "wheel-0001.vtu") == "whole");

    write(run.temporary("wheel-0002.vtu"), "half");
    BOOST_TEST(run.files() == (std::vector<std::string>{"original.prm",
                                                        "used.prm",
                                                        "wheel-0001.vtu"}),
               boost::test_tools::per_element());

    BOOST_CHECK_THROW(run.publish("never-written.csv"), InputError);
    for (const std::string name :
         {"", "../x", "a/b", ".x", "run.json", "a\"", "thesis.csv"})
      BOOST_CHECK_THROW(run.temporary(name), std::logic_error);
  }
  BOOST_TEST(n_entries(folder) == 4u);
  BOOST_TEST(read_json(folder / "run.json").get_child("files").size() == 3u);
}

BOOST_FIXTURE_TEST_CASE(old_run_is_replaced_and_nothing_else, ScratchFolder)
{
  {
    RunFolder run(folder, "old", "old");
    run.open();
    run.write_atomically("results.csv", "old");
    run.write_atomically("wheel-0001.vtu", "old");
  }
  write(folder / "notes.txt", "mine");
  write(scratch / "output" / "victim", "mine");
  std::string record = read(folder / "run.json");
  record.insert(record.find("\"wheel"), "\"../victim\", \"notes.txt\", ");
  write(folder / "run.json", record);
  // a run that died left it behind
  write(folder / ".wheel-0001.vtu.part", "half");

  RunFolder run(folder, "new", "new");
  run.open();
  BOOST_TEST(read(folder / "original.prm") == "new");
  BOOST_TEST(read(folder / "notes.txt") == "mine");
  BOOST_TEST(read(scratch / "output" / "victim") == "mine");
  BOOST_TEST(n_entries(folder) == 4u);
}

BOOST_FIXTURE_TEST_CASE(a_crash_while_replacing_can_be_resumed, ScratchFolder)
{
  write(folder / "run.json",
        "{\"program\": \"rolling-contact\", \"status\": \"running\", "
        "\"files\": [\"wheel-0001.vtu\", \"blocked\"]}");
  write(folder / "wheel-0001.vtu", "old");
  // A folder of a listed name is left alone.
  write(folder / "blocked" / "inner", "mine");

  RunFolder run(folder, "", "");
  run.open();
  BOOST_TEST(!fs::exists(folder / "wheel-0001.vtu"));
  BOOST_TEST(read(folder / "blocked" / "inner") == "mine");
}

BOOST_FIXTURE_TEST_CASE(foreign_folders_are_refused, ScratchFolder)
{
  const auto refuses = [](const fs::path &path) {
    RunFolder run(path, "new", "new");
    BOOST_CHECK_THROW(run.open(), InputError);
  };

  write(folder / "original.prm", "mine");
  refuses(folder);
  for (const std::string record : {"not JSON",
                                   "{}",
                                   "[]",
                                   "{\"program\": \"other\"}",
                                   "{\"name\": \"rolling-contact\"}",
                                   "{\"a\": 1, \"program\": "
                                   "\"rolling-contact\"}"})
    {
      write(folder / "run.json", record);
      refuses(folder);
      BOOST_TEST(read(folder / "run.json") == record);
    }
  BOOST_TEST(read(folder / "original.prm") == "mine");
  BOOST_TEST(n_entries(folder) == 2u);

  refuses(folder / "original.prm");
  refuses(folder / "original.prm" / "below");
  refuses("");

  RunFolder long_name(scratch / std::string(300, 'x'), "", "");
  BOOST_CHECK_THROW(long_name.open(), InputError);
  RunFolder in_proc("/proc/no/such/folder", "", "");
  BOOST_CHECK_THROW(in_proc.open(), InputError);
}

BOOST_FIXTURE_TEST_CASE(folder_of_a_going_run_is_refused, ScratchFolder)
{
  // Counts as empty: a first run died before its mark was complete.
  write(folder / ".run.json.part", "");
  RunFolder first(folder, "first", "first");
  first.open();
  RunFolder second(folder, "second", "second");
  BOOST_CHECK_THROW(second.open(), InputError);
  BOOST_TEST(read(folder / "original.prm") == "first");
}

BOOST_FIXTURE_TEST_CASE(results_csv, ScratchFolder)
{
  RunFolder run(folder, "", "");
  run.open();
  ResultsTable table(run);
  table.set("level", 0u);
  table.set("solver", "active set, \"warm\"");
  table.set("force_x_N", -141000.123456789);
  table.set("converged", true);
  table.end_row();
  BOOST_TEST(read(folder / "results.csv") ==
             "level,solver,force_x_N,converged\n"
             "0,\"active set, \"\"warm\"\"\",-141000.123,true\n");

  table.set("level", -1);
  table.set("level", 1);
  table.set("new", 1.f);
  table.set("force_x_N", std::nan(""));
  table.end_row();
  table.set("level", 2);
  BOOST_TEST(read(folder / "results.csv") ==
             "level,solver,force_x_N,converged,new\n"
             "0,\"active set, \"\"warm\"\"\",-141000.123,true,\n"
             "1,,,,1\n");
  BOOST_TEST(table.n_rows() == 2u);
  BOOST_TEST(table.screen_table({"level", "force_x_N", "absent", "solver"}) ==
             "level  force_x_N              solver\n"
             "    0  -1.41e+05  active set, \"warm\"\n"
             "    1          -                   -\n");
}

/** The units that doc/reference/output.md gives to columns are those that their
 * names, and with them table.h5, say, in their order; columns that follow each
 * other share one. Units that the program has no columns of are left out. */
BOOST_AUTO_TEST_CASE(units_of_the_documentation)
{
  const std::map<std::string, std::string> as_program{{"N m", "Nm"},
                                                      {"m^2", "m2"},
                                                      {"J/m^2", "J/m2"}};
  const auto add = [](std::vector<std::string> &units,
                      const std::string        &unit) {
    const bool known = unit != "1" && unit_of_column("any_" + unit) == unit;
    if (known && (units.empty() || units.back() != unit))
      units.push_back(unit);
  };
  std::ifstream page(std::string(TEST_DATA) + "/../../doc/reference/output.md");
  const std::regex row("^\\| (`[^|]*) \\| ([^|]*?) *\\| .*"),
    column("`([^`]+)`");
  unsigned int n_columns = 0;
  for (std::string line; std::getline(page, line);)
    {
      std::smatch parts;
      if (!std::regex_match(line, parts, row) || parts[1] == "`vibrations`")
        continue;
      std::vector<std::string> given, found;
      std::istringstream       texts(parts[2]);
      for (std::string unit; std::getline(texts >> std::ws, unit, ',');)
        {
          const auto other = as_program.find(unit);
          add(given, other == as_program.end() ? unit : other->second);
        }
      const std::string names = parts[1];
      for (std::sregex_iterator it(names.begin(), names.end(), column), end;
           it != end;
           ++it, ++n_columns)
        add(found, unit_of_column((*it)[1]));
      BOOST_TEST((given == found), line);
    }
  BOOST_TEST(n_columns > 300u);
  BOOST_TEST(unit_of_column("bound_force/muN") == "mu N");
  BOOST_TEST(unit_of_column("bound_moment/muNa") == "mu N a");
  BOOST_TEST(unit_of_column("contact_area_m2") == "m2");
  BOOST_TEST(unit_of_column("iterations") == "1");
}

BOOST_FIXTURE_TEST_CASE(long_results_are_complete_at_the_end, ScratchFolder)
{
  RunFolder run(folder, "", "");
  run.open();
  {
    ResultsTable table(run);
    for (int i = 0; i < 1500; ++i)
      {
        table.set("time_s", 0.1 * i);
        table.end_row();
      }
    BOOST_TEST(count(read(folder / "results.csv"), "\n") >= 1001u);
  }
  BOOST_TEST(count(read(folder / "results.csv"), "\n") == 1501u);
}

BOOST_FIXTURE_TEST_CASE(other_tables_are_complete_or_not_there, ScratchFolder)
{
  RunFolder run(folder, "", "");
  run.open();
  {
    ResultsTable table(run, "modes.csv"), stopped(run, "lines.csv");
    for (ResultsTable *it : {&table, &stopped})
      for (int i = 0; i < 3; ++i)
        {
          it->set("mode", i);
          it->end_row();
        }
    BOOST_TEST(!std::filesystem::exists(folder / "modes.csv"));
    table.flush();
    BOOST_TEST(read(folder / "modes.csv") == "mode\n0\n1\n2\n");
  }
  BOOST_TEST(!std::filesystem::exists(folder / "lines.csv"));
}

BOOST_FIXTURE_TEST_CASE(files_are_overwritten_where_they_are, ScratchFolder)
{
  const auto file = folder / "small";
  std::filesystem::create_directories(folder);
  BOOST_TEST(!overwrite_file(file, "text")); // there is none
  std::ofstream(file) << "some text";
  BOOST_TEST(overwrite_file(file, "other"));
  BOOST_TEST(read(file) == "other");
  BOOST_TEST(overwrite_file(file, std::string(400, 'x')));
  BOOST_TEST(read(file) == std::string(400, 'x'));
  // more than a file of a few bytes has blocks for
  BOOST_TEST(!overwrite_file(file, std::string(1 << 20, 'y')));
  BOOST_TEST(read(file) == std::string(400, 'x'));
}

BOOST_FIXTURE_TEST_CASE(run_report, ScratchFolder)
{
  RunFolder run(folder, "", "");
  run.open();
  PhaseTimer timer;
  {
    PhaseTimer::Scope scope(timer, Phase::mesh);
  }

  RunReport report;
  report.version      = "1.0";
  report.git_revision = "abc";
  report.command_line = {"rolling-contact", "a \"b\"\\\n\x01\xB5.prm"};
  report.libraries    = {{"Boost", "1.74"}};
  report.n_threads    = 2;
  report.objects      = {{"wheel", true, 8000, 0.5, ""},
                         {"rail", true, 0, std::nan(""), ""},
                         {"mass matrix", false, 0, 0., "no dynamics"}};
  report.warnings     = {"slow BLAS"};

  report.write(run, RunStatus::not_converged, timer);
  run.write_atomically("results.csv", "");

  const ptree record = read_json(folder / "run.json");
  BOOST_TEST(record.front().first == "program");
  BOOST_TEST(record.get<std::string>("status") == "not converged");
  BOOST_TEST(record.get<unsigned int>("threads") == 2u);
  BOOST_TEST(record.get<double>("peak_memory_bytes") > 1e6);
  BOOST_TEST(record.get_child("files").size() == 3u);
  BOOST_TEST(record.get_child("command_line").back().second.data() ==
             "a \"b\"\\\n\x01\uFFFD.prm");
  BOOST_TEST(record.get_child("warnings").front().second.data() == "slow BLAS");

  double wall = 0.;
  for (const auto &phase : record.get_child("phases"))
    wall += phase.second.get<double>("wall_seconds");
  BOOST_TEST(std::abs(wall - record.get<double>("wall_seconds")) <= 1e-8);

  const ptree &rail = std::next(record.get_child("objects").begin())->second;
  BOOST_TEST(rail.get<std::string>("seconds") == "null");
  const ptree &mass = record.get_child("objects").back().second;
  BOOST_TEST(mass.get<bool>("built") == false);
  BOOST_TEST(mass.get<std::string>("reason") == "no dynamics");

  BOOST_TEST(report.objects_summary() == "Built:\n"
                                         "  wheel: 8 kB, 500 ms\n"
                                         "  rail: 0 B, nan s\n"
                                         "Left out:\n"
                                         "  mass matrix (no dynamics)\n");
}

BOOST_AUTO_TEST_SUITE_END()
