#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include "scratch_folder.h"
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/program/command_line.h>
#include <rolling_contact/run/previous_run.h>
#include <rolling_contact/run/progress.h>
#include <rolling_contact/time/checkpoint.h>
#include <rolling_contact/time/checkpoint_schedule.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <random>

namespace
{
  using namespace RollingContact;
  namespace fs = std::filesystem;

  const std::string scene = "set Dimension = 2\n"
                            "subsection Output\n  set Plot = true\nend\n"
                            "subsection Time\n"
                            "  set End time  = 1\n"
                            "  set Time step = 1e-3\n"
                            "end\n";

  const RunFolder::Resumption resumption{{"Output/", "Time/End time"},
                                         checkpoint_name,
                                         {history_name,
                                          numbers_of(history_name)}};

  const std::vector<std::string> columns{"step", "time_s", "force_x_N"};

  std::string replaced(std::string        text,
                       const std::string &old_part,
                       const std::string &new_part)
  {
    text.replace(text.find(old_part), old_part.size(), new_part);
    return text;
  }

  /**
   * Like a time integration: a chaotic sequence, a row and a field per step, a
   * checkpoint every seventh.
   */
  void march(const fs::path     &folder,
             const bool          resume,
             const std::uint64_t last_step = 200)
  {
    RunFolder  run(folder, scene, scene);
    Checkpoint state;
    state.motion.bodies.wheel.displacement = {0.3};
    std::optional<HistoryTable> history;
    if (resume)
      {
        run.reopen(resumption);
        state = read_checkpoint(run);
        history.emplace(run, history_name, columns, state.history);
      }
    else
      {
        run.open();
        history.emplace(run, history_name, columns);
      }
    double &x = state.motion.bodies.wheel.displacement[0];
    while (state.progress.step < last_step)
      {
        ++state.progress.step;
        state.progress.time += 0.1;
        x = 3.99 * x * (1 - x);
        history->add_row({1. * state.progress.step, state.progress.time, x});
        const std::string name =
          "wheel-" + std::to_string(state.progress.step) + ".vtu";
        run.write_atomically(name, std::to_string(x));
        state.body_fields.push_back({state.progress.time, 0, "wheel", name});
        write_pvd(state.body_fields, run, "bodies.pvd");
        if (state.progress.step % 7 == 0)
          {
            state.history = history->flush();
            write_checkpoint(state, run);
          }
      }
    history->publish();
  }

  /** All files of a folder but run.json; its list is "listed". */
  std::map<std::string, std::string> contents(const fs::path &folder)
  {
    std::map<std::string, std::string> files;
    for (const auto &entry : fs::directory_iterator(folder))
      if (entry.path().filename() != record_name)
        files[entry.path().filename()] = read(entry.path());
    for (const std::string &name : read_previous_run(folder).files)
      files["listed"] += name + ' ';
    return files;
  }

  /** Runs an action in a process of its own. */
  pid_t in_child(const std::function<void()> &action)
  {
    const pid_t child = fork();
    if (child == 0)
      {
        int code = 0;
        try
          {
            action();
          }
        catch (const std::exception &)
          {
            code = 1;
          }
        _exit(code);
      }
    BOOST_REQUIRE(child > 0);
    return child;
  }

  int status_of(const pid_t child)
  {
    int status = 0;
    BOOST_REQUIRE(waitpid(child, &status, 0) == child);
    return status;
  }

  bool same_bits(const double first, const double second)
  {
    return std::memcmp(&first, &second, sizeof(double)) == 0;
  }
} // namespace

BOOST_AUTO_TEST_SUITE(resume)

BOOST_AUTO_TEST_CASE(entries_of_a_prm_text)
{
  const PrmEntries entries = prm_entries(
    "# comment\nset A b = 1 # 2\n\nsubsection S t\n  set C =\n"
    "  subsection U\n    set D = x=y\n  end\n  set E = 3\nend\nset F = 4\n");
  const PrmEntries expected{{"A b", "1 # 2"},
                            {"F", "4"},
                            {"S t/C", ""},
                            {"S t/E", "3"},
                            {"S t/U/D", "x=y"}};
  BOOST_TEST((entries == expected));
}

BOOST_AUTO_TEST_CASE(changed_entries_are_refused)
{
  const PrmEntries old_entries{{"Time/Theta", "0.5"},
                               {"Time/End time", "1"},
                               {"Output/Plot", "true"},
                               {"Contact/Approach", "0.0001"}};
  const auto change = [&](const std::string &entry, const std::string &value) {
    PrmEntries entries = old_entries;
    entries[entry]     = value;
    return complaint([&]() {
      refuse_changed_entries(old_entries, entries, resumption.may_differ);
    });
  };
  BOOST_TEST(change("Time/Theta", "0.5") == "");
  BOOST_TEST(change("Contact/Approach", "1e-4") == "");
  BOOST_TEST(change("Time/End time", "2") == "");
  BOOST_TEST(change("Output/Plot", "false") == "");
  BOOST_TEST(contains(change("Time/Theta", "0.51"),
                      "Time/Theta was \"0.5\" when the run began and is "
                      "\"0.51\" now"));
  BOOST_TEST(contains(change("Contact/Approach", ""), "is \"\" now"));
  BOOST_TEST(contains(change("Time/New", "1"), "Time/New was missing"));
  BOOST_TEST(
    contains(complaint([&]() { refuse_changed_entries(old_entries, {}, {}); }),
             "Contact/Approach was \"0.0001\""));
}

BOOST_FIXTURE_TEST_CASE(checkpoints_keep_every_bit, ScratchFolder)
{
  RunFolder run(folder, scene, scene);
  run.open();
  Checkpoint state;
  state.tables              = {{"Time/Speed (table)", "12 rows"}};
  state.progress.step       = 1234567890123u;
  state.progress.time       = 0.1 + 0.2;
  state.motion.bodies.wheel = {
    {-0., std::numeric_limits<double>::denorm_min(), 1. / 3},
    {std::nextafter(1., 2.), INFINITY, std::nan("7")}};
  state.motion.past  = {{1. / 7}, std::nextafter(2e-6, 0.)};
  state.motion.modes = {
    {1. / 41}, {1. / 43}, {1. / 17}, {1. / 19}, 1. / 23, 1. / 29};
  state.patch_friction          = {1. / 31, 1. / 37};
  state.slip                    = {NodalField(1, std::vector<double>{1. / 9}),
                                   NodalField(1, std::vector<double>{-1. / 11}),
                                   1. / 13,
                                   -1. / 15};
  state.state.pressure          = {1e300, -1e-300};
  state.state.traction          = NodalField(1, std::vector<double>{M_PI});
  state.state.approach          = std::nextafter(2.2e-4, 0.);
  state.state.edge_law          = false;
  state.state.scheme            = {{{3, 1. / 3, 0.1, {{-0.3, 0.}}},
                                    {7, 2., 1., {{0., 0.}}}},
                                   {4, 9}};
  state.progress.n_impacts      = 8;
  state.progress.surface_energy = 0.125;
  state.last_step.is_known      = true;
  state.last_step.length        = std::nextafter(1e-6, 0.);
  state.last_step.loads.gap     = {1. / 3};
  state.last_step.rate          = 1. / 17;
  state.last_step.loads.slip_share = {0.5};
  state.last_step.loads.slip_before =
    NodalField(1, std::vector<double>{1. / 19});
  state.last_step.solver.solver = "active set";
  state.history                 = {17, 4321};
  state.body_fields             = {{0.1, 1, "rail", "rail-0001.vtu"}};
  write_checkpoint(Checkpoint(), run);
  write_checkpoint(state, run);

  const Checkpoint copy = read_checkpoint(run);
  BOOST_TEST((copy.tables == state.tables));
  BOOST_TEST(copy.progress.step == state.progress.step);
  BOOST_TEST(same_bits(copy.progress.time, state.progress.time));
  BOOST_TEST(same_bits(copy.state.approach, state.state.approach));
  for (unsigned int i = 0; i < 3; ++i)
    {
      BOOST_TEST(same_bits(copy.motion.bodies.wheel.displacement[i],
                           state.motion.bodies.wheel.displacement[i]));
      BOOST_TEST(same_bits(copy.motion.bodies.wheel.velocity[i],
                           state.motion.bodies.wheel.velocity[i]));
    }
  BOOST_TEST(copy.motion.bodies.rail.displacement.empty());
  const PairMotion &motion = copy.motion, &expected = state.motion;
  BOOST_TEST((motion.past.velocity == expected.past.velocity));
  BOOST_TEST(same_bits(motion.past.length, expected.past.length));
  BOOST_TEST((motion.modes.eta == expected.modes.eta));
  BOOST_TEST((motion.modes.rate == expected.modes.rate));
  BOOST_TEST((motion.modes.forces == expected.modes.forces));
  BOOST_TEST((motion.modes.forces_before == expected.modes.forces_before));
  BOOST_TEST(same_bits(motion.modes.last_step, expected.modes.last_step));
  BOOST_TEST(same_bits(motion.modes.distance, expected.modes.distance));
  BOOST_TEST(same_bits(copy.patch_friction.share, state.patch_friction.share));
  BOOST_TEST(
    same_bits(copy.patch_friction.target, state.patch_friction.target));
  BOOST_TEST((copy.slip.sliding.values() == state.slip.sliding.values()));
  BOOST_TEST((copy.slip.mean.values() == state.slip.mean.values()));
  BOOST_TEST(same_bits(copy.slip.power, state.slip.power));
  BOOST_TEST(same_bits(copy.slip.debt, state.slip.debt));
  BOOST_TEST(same_bits(copy.last_step.rate, state.last_step.rate));
  BOOST_TEST(
    (copy.last_step.loads.slip_share == state.last_step.loads.slip_share));
  BOOST_TEST((copy.last_step.loads.slip_before.values() ==
              state.last_step.loads.slip_before.values()));
  BOOST_TEST((copy.state.pressure == state.state.pressure));
  BOOST_TEST((copy.state.traction.values() == state.state.traction.values()));
  BOOST_TEST(copy.state.scheme.edges.size() == 2u);
  BOOST_TEST((copy.state.scheme.sliding == state.state.scheme.sliding));
  BOOST_TEST(copy.state.scheme.edges[0].first == 3u);
  BOOST_TEST(
    same_bits(copy.state.scheme.edges[0].a, state.state.scheme.edges[0].a));
  BOOST_TEST(
    same_bits(copy.state.scheme.edges[0].b, state.state.scheme.edges[0].b));
  BOOST_TEST((copy.state.scheme.edges[0].c == state.state.scheme.edges[0].c));
  BOOST_TEST(!copy.state.edge_law);
  BOOST_TEST(copy.progress.n_impacts == 8u);
  BOOST_TEST(copy.progress.surface_energy == 0.125);
  BOOST_TEST(copy.last_step.is_known);
  BOOST_TEST(same_bits(copy.last_step.length, state.last_step.length));
  BOOST_TEST((copy.last_step.loads.gap == state.last_step.loads.gap));
  BOOST_TEST(copy.last_step.solver.solver == "active set");
  BOOST_TEST(copy.history.n_rows == 17u);
  BOOST_TEST(copy.history.n_bytes == 4321u);
  BOOST_REQUIRE(copy.body_fields.size() == 1u);
  BOOST_TEST(copy.body_fields[0].file == "rail-0001.vtu");
  BOOST_TEST(copy.body_fields[0].part == 1u);
}

BOOST_AUTO_TEST_CASE(checkpoints_come_soon_and_cost_little)
{
  const auto written_at = [](const double longest, const double cost) {
    CheckpointSchedule  schedule(0, longest);
    std::vector<double> times;
    for (double now = 0.; now < 400.; now += 0.25)
      if (schedule.is_due(1, now))
        {
          times.push_back(now);
          schedule.written(now, now + cost);
        }
    return times;
  };
  BOOST_TEST((
    written_at(60., 0.) ==
    std::vector<double>{
      1.25, 3.5, 7.75, 16., 32.25, 64.5, 124.75, 185., 245.25, 305.5, 365.75}));
  BOOST_TEST((written_at(0.5, 0.)[0] == 0.75));
  BOOST_TEST(written_at(0., 0.).empty());
  const auto costly = written_at(60., 4.);
  BOOST_TEST(costly.size() == 4u); // 120 s of work between them
  BOOST_TEST(costly[2] - costly[1] > 30 * 4.);

  const CheckpointSchedule by_steps(5, 0.);
  BOOST_TEST(by_steps.is_due(10, 0.));
  BOOST_TEST(!by_steps.is_due(11, 1e6));
}

BOOST_FIXTURE_TEST_CASE(damaged_checkpoints_are_refused, ScratchFolder)
{
  RunFolder run(folder, scene, scene);
  run.open();
  const fs::path file = folder / checkpoint_name;
  BOOST_TEST(contains(complaint([&]() { read_checkpoint(run); }),
                      file.string() + "\": it is missing"));
  Checkpoint state;
  state.motion.bodies.wheel.displacement = {1., 2., 3.};
  write_checkpoint(state, run);
  const std::string whole = read(file);

  for (std::size_t i = 0; i < whole.size(); ++i)
    {
      std::string damaged = whole;
      damaged[i] ^= 0x10;
      write(file, damaged);
      const std::string said = complaint([&]() { read_checkpoint(run); });
      BOOST_REQUIRE_MESSAGE(contains(said, file.string()), "byte " << i);
      write(file, whole.substr(0, i));
      BOOST_REQUIRE_THROW(read_checkpoint(run), InputError);
    }
  write(file, whole + '\0');
  BOOST_CHECK_THROW(read_checkpoint(run), InputError);
  write(file, whole);
  BOOST_TEST(read_checkpoint(run).motion.bodies.wheel.displacement.size() ==
             3u);
}

BOOST_FIXTURE_TEST_CASE(reopening_refuses_what_cannot_be_resumed, ScratchFolder)
{
  const auto reopen = [&](const std::string &prm) {
    return complaint([&]() {
      RunFolder run(folder, prm, prm);
      run.reopen(resumption);
    });
  };
  BOOST_TEST(contains(reopen(scene), "there is no such folder"));
  BOOST_TEST(!fs::exists(folder));
  write(folder / "thesis.tex", "mine");
  BOOST_TEST(contains(reopen(scene), "did not write"));
  fs::remove_all(folder);
  {
    RunFolder run(folder, scene, scene);
    run.open();
    BOOST_TEST(contains(reopen(scene), "another run is writing"));
  }
  BOOST_TEST(contains(reopen(scene), "holds no checkpoint"));

  march(folder, false, 14);
  const auto        before = contents(folder);
  const std::string record = read(folder / record_name);
  BOOST_TEST(contains(reopen(replaced(scene, "1e-3", "2e-3")),
                      "Time/Time step was \"1e-3\" when the run began and is "
                      "\"2e-3\" now"));
  BOOST_TEST((contents(folder) == before));
  BOOST_TEST(read(folder / record_name) == record);

  const std::string longer = replaced(scene, "End time  = 1", "End time = 2");
  BOOST_TEST(reopen(longer) == "");
  BOOST_TEST(read(folder / "used.prm") == longer);
  BOOST_TEST(read(folder / "history.csv") == before.at("history.csv"));
  BOOST_TEST(read(folder / "wheel-5.vtu") == before.at("wheel-5.vtu"));
}

BOOST_FIXTURE_TEST_CASE(starting_anew_leaves_nothing_to_resume, ScratchFolder)
{
  march(folder, false, 14);
  RunFolder run(folder, scene, scene);
  run.open();
  BOOST_TEST(!fs::exists(folder / checkpoint_name));
  BOOST_TEST(!fs::exists(folder / history_name));
}

BOOST_FIXTURE_TEST_CASE(histories_continue_byte_for_byte, ScratchFolder)
{
  march(folder, false, 100);
  const std::string whole = read(folder / history_name);
  BOOST_TEST(whole.substr(0, 22) == "step,time_s,force_x_N\n");

  // Stopped after step 45, published with it; the checkpoint is that of 42.
  march(folder, false, 45);
  BOOST_TEST(read(folder / history_name) ==
             whole.substr(0, read(folder / history_name).size()));
  march(folder, true, 100);
  BOOST_TEST(read(folder / history_name) == whole);

  // A resumed run that fails before it continues the history loses no row.
  march(folder, false, 45);
  fs::rename(folder / history_name, folder / "history.csv.part");
  {
    RunFolder run(folder, scene, scene);
    run.reopen(resumption);
    BOOST_TEST(
      contains(complaint([&]() {
                 HistoryTable(run, history_name, columns, {1000, 100000});
               }),
               "history.csv has less than the 100000 bytes"));
  }
  march(folder, true, 100);
  BOOST_TEST(read(folder / history_name) == whole);
}

/** The numbers of a history have all digits, of the columns that are asked for,
 * also where it was continued, and none behind the rows of the checkpoint. */
BOOST_FIXTURE_TEST_CASE(numbers_of_a_history, ScratchFolder)
{
  const auto             third = [](const double step) { return step / 3; };
  HistoryTable::Position position;
  {
    RunFolder run(folder, scene, scene);
    run.open();
    write_checkpoint({}, run);
    HistoryTable history(run, history_name, columns);
    for (int step = 1; step < 6; ++step)
      {
        history.add_row({1. * step, 0.1 * step, third(step)});
        if (step == 3)
          position = history.flush();
      }
    BOOST_TEST(history.size() == 5u);
    history.flush();
    BOOST_TEST(history.columns({"force_x_N"}).at("force_x_N").size() == 5u);
  }
  RunFolder run(folder, scene, scene);
  run.reopen(resumption);
  HistoryTable history(run, history_name, columns, position);
  BOOST_TEST(history.size() == 3u);
  history.add_row({4., 0.5, third(4)});
  history.publish();
  const HistoryColumns found =
    history.columns({"force_x_N", "step", "wheel_velocity_m/s"});
  BOOST_TEST(found.at("wheel_velocity_m/s").empty());
  BOOST_REQUIRE_EQUAL(found.at("force_x_N").size(), 4u);
  BOOST_REQUIRE_EQUAL(found.at("step").size(), 4u);
  for (int step = 1; step < 5; ++step)
    {
      BOOST_TEST(found.at("step")[step - 1] == step);
      BOOST_TEST(found.at("force_x_N")[step - 1] == third(step));
    }
  BOOST_TEST(fs::file_size(folder / "history.bin") == 4 * 3 * sizeof(double));
  BOOST_TEST(!fs::exists(folder / "history.bin.part"));
  HistoryTable text(run, "cycle_patch.csv", columns, false);
  text.add_row({1., 2., 3.});
  text.publish();
  BOOST_TEST(!fs::exists(folder / "cycle_patch.bin"));
}

BOOST_FIXTURE_TEST_CASE(history_rows, ScratchFolder)
{
  RunFolder run(folder, scene, scene);
  run.open();
  {
    HistoryTable history(run, history_name, columns);
    history.add_row({999999999., 1. / 3, -1e-7});
    BOOST_TEST(history.flush().n_rows == 1u);
    BOOST_TEST(!fs::exists(folder / history_name));
    BOOST_TEST(read(folder / "history.csv.part") ==
               "step,time_s,force_x_N\n999999999,0.333333333,-1e-07\n");
    BOOST_CHECK_THROW(history.add_row({1., 2.}), std::logic_error);
    history.add_row({2., std::nan(""), 0.});
  }
  const std::string text = read(folder / history_name);
  BOOST_TEST(text == "step,time_s,force_x_N\n999999999,0.333333333,-1e-07\n"
                     "2,,0\n");
  BOOST_CHECK_THROW(
    HistoryTable(run, history_name, {"other", "columns"}, {2, text.size()}),
    InputError);
  BOOST_CHECK_THROW(
    HistoryTable(run, history_name, columns, {1, text.size() - 3}), InputError);
}

BOOST_FIXTURE_TEST_CASE(lock_of_a_dead_process, ScratchFolder)
{
  int  ready[2];
  char byte = 0;
  BOOST_REQUIRE(pipe(ready) == 0);
  const pid_t child = in_child([&]() {
    RunFolder run(folder, scene, scene);
    run.open();
    write_checkpoint({}, run);
    if (write(ready[1], "x", 1) == 1)
      pause();
  });
  BOOST_REQUIRE(read(ready[0], &byte, 1) == 1);
  RunFolder run(folder, scene, scene);
  BOOST_TEST(contains(complaint([&]() { run.reopen(resumption); }),
                      "another run is writing"));
  kill(child, SIGKILL);
  status_of(child);
  BOOST_TEST(complaint([&]() { run.reopen(resumption); }) == "");
  close(ready[0]);
  close(ready[1]);
}

BOOST_FIXTURE_TEST_CASE(killed_at_random_times, ScratchFolder)
{
  march(scratch / "whole", false);
  const auto expected = contents(scratch / "whole");

  std::mt19937                       random(4);
  std::uniform_int_distribution<int> microseconds(0, 40000);
  unsigned int                       n_killed = 0, n_resumed = 0;
  for (bool done = false; !done;)
    {
      const bool  resume = fs::exists(folder / checkpoint_name);
      const pid_t child  = in_child([&]() { march(folder, resume); });
      if (n_killed < 40)
        {
          usleep(microseconds(random));
          // a busy machine may never get as far as the first checkpoint
          for (unsigned int k = 0; n_killed > 20 && k < 5000 &&
                                   !fs::exists(folder / checkpoint_name);
               ++k)
            usleep(1000);
          kill(child, SIGKILL);
        }
      const int status = status_of(child);
      BOOST_REQUIRE((WIFSIGNALED(status) || WEXITSTATUS(status) == 0));
      n_killed += WIFSIGNALED(status);
      n_resumed += resume;
      done = WIFEXITED(status);
    }
  BOOST_TEST_MESSAGE(n_killed << " kills, " << n_resumed << " resumptions");
  BOOST_TEST(n_resumed > 0u);
  BOOST_TEST((contents(folder) == expected));
}

BOOST_FIXTURE_TEST_CASE(killed_while_starting_anew, ScratchFolder)
{
  march(scratch / "whole", false, 80);
  march(scratch / "old", false, 76);
  const auto expected = contents(scratch / "whole");
  fs::create_directories(folder.parent_path());

  std::mt19937                       random(5);
  std::uniform_int_distribution<int> microseconds(0, 4000);
  unsigned int                       n_old_runs = 0;
  for (unsigned int i = 0; i < 40; ++i)
    {
      fs::remove_all(folder);
      fs::copy(scratch / "old", folder);
      const pid_t child = in_child([&]() {
        RunFolder run(folder, scene, scene);
        run.open();
        pause();
      });
      usleep(microseconds(random));
      kill(child, SIGKILL);
      status_of(child);
      const bool is_old_run =
        complaint([&]() { march(folder, true, 80); }).empty();
      if (is_old_run)
        BOOST_REQUIRE((contents(folder) == expected));
      n_old_runs += is_old_run;
    }
  BOOST_TEST_MESSAGE(n_old_runs << " of 40 not begun anew");
}

BOOST_AUTO_TEST_CASE(progress_lines)
{
  std::ostringstream out, errors;
  Log                log(Verbosity::normal, out, errors);
  Progress           rare(log, "step", 1000);
  for (unsigned int i = 1; i <= 1000; ++i)
    rare.report(i);
  BOOST_TEST(out.str() == "");

  Progress eager(log, "step", 4, 1, 0.);
  for (unsigned int i = 2; i <= 4; ++i)
    eager.report(i);
  BOOST_TEST(contains(out.str(), "step 2 of 4, about "));
  BOOST_TEST(contains(out.str(), "step 3 of 4, about "));
  BOOST_TEST(!contains(out.str(), "step 4 of 4"));

  // Two thirds of the steps of this run are left after 30 ms.
  out.str("");
  Progress paced(log, "step", 13, 10, 0.);
  usleep(30000);
  paced.report(11);
  const std::string said = out.str();
  const double      left = std::stod(said.substr(said.find("about ") + 6));
  BOOST_TEST(contains(said, " ms left"));
  BOOST_TEST(left >= 60.);
}

BOOST_AUTO_TEST_CASE(option_on_the_command_line)
{
  const char *words[] = {"rolling-contact", "a.prm", "--resume"};
  BOOST_TEST(CommandLine(3, words).resume);
  BOOST_TEST(!CommandLine(2, words).resume);
  BOOST_TEST(contains(CommandLine::help(), "--resume"));
}

BOOST_AUTO_TEST_SUITE_END()
