#define BOOST_TEST_MODULE ranks
#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include "half_plane.h"
#include "scratch_folder.h"
#include <signal.h>
#include <unistd.h>

#include <rolling_contact/base/broadcast.h>
#include <rolling_contact/base/collective_failure.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/ranks.h>
#include <rolling_contact/base/turns.h>
#include <rolling_contact/bodies/theta_scheme.h>
#include <rolling_contact/contact/trace.h>
#include <rolling_contact/run/log.h>
#include <rolling_contact/run/results_table.h>
#include <rolling_contact/run/run_report.h>
#include <rolling_contact/run/written_names.h>
#include <rolling_contact/solvers/contact_solver.h>
#include <rolling_contact/solvers/force_control.h>
#include <rolling_contact/tables/rows_of_ranks.h>
#include <rolling_contact/time/checkpoint.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <memory>
#include <mutex>
#include <new>
#include <sstream>
#include <thread>

/** To be run by mpirun, on any number of ranks. */
namespace
{
  using namespace RollingContact;
  namespace fs = std::filesystem;

  struct StartedMpi
  {
    StartedMpi()
    {
      install_interrupt_handlers(); // before MPI starts threads
      Ranks::start();
    }

    ~StartedMpi()
    {
      Ranks::finish();
    }
  };

  /** The same folder on all ranks; it must not go before all are done. */
  struct SharedFolder
  {
    SharedFolder()
    {
      std::string name;
      Ranks::on_root([&]() {
        own  = std::make_unique<ScratchFolder>();
        name = own->folder.string();
      });
      Ranks::broadcast(name);
      folder = name;
    }

    ~SharedFolder()
    {
      Ranks::sum(0.);
    }

    std::unique_ptr<ScratchFolder> own;
    fs::path                       folder;
  };

  unsigned int last()
  {
    return Ranks::count() - 1;
  }
} // namespace

BOOST_TEST_GLOBAL_FIXTURE(StartedMpi);

BOOST_AUTO_TEST_SUITE(ranks)

BOOST_AUTO_TEST_CASE(sums_and_extremes)
{
  const double n = Ranks::count(), own = Ranks::rank() + 1.;
  BOOST_TEST(Ranks::sum(own) == n * (n + 1) / 2);
  BOOST_TEST(Ranks::minimum(own) == 1.);
  BOOST_TEST(Ranks::maximum(own) == n);
  BOOST_TEST(Ranks::maximum(-own) == -1.);
  BOOST_TEST(Ranks::sum(Ranks::is_root()) == 1.);
  BOOST_TEST(Ranks::launched());
}

// 2.5 million entries go in three messages
BOOST_AUTO_TEST_CASE(vectors_in_pieces)
{
  const double        n = Ranks::count();
  std::vector<double> values(2500000);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = (Ranks::rank() + 1.) * i;
  Ranks::sum(values);
  std::size_t n_wrong = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    n_wrong += values[i] != n * (n + 1) / 2 * i;
  BOOST_TEST(n_wrong == 0u);

  std::vector<double> sent(Ranks::rank());
  if (Ranks::rank() == last())
    sent = values;
  Ranks::broadcast(sent, last());
  BOOST_TEST((sent == values));

  std::vector<double> none;
  Ranks::sum(none);
  Ranks::broadcast(none);
  BOOST_TEST(none.empty());
}

// each number is taken once, the lowest first, in threads of all ranks
BOOST_AUTO_TEST_CASE(turns)
{
  const std::size_t   n = 3000, first = 1000;
  Ranks::Turns        turns;
  std::vector<double> taken(n, 0.), own;
  std::mutex          mutex;
  Ranks::apart([&]() {
    for (const std::size_t end : {first, first, n})
      {
        std::vector<std::thread> threads;
        for (unsigned int k = 0; k < 2; ++k)
          threads.emplace_back([&]() {
            while (const auto turn = turns.take_below(end))
              {
                const std::lock_guard<std::mutex> lock(mutex);
                ++taken[*turn];
                own.push_back(*turn);
              }
          });
        for (std::thread &thread : threads)
          thread.join();
        BOOST_TEST(!turns.has_below(end));
      }
  });
  Ranks::sum(taken);
  BOOST_TEST(std::count(taken.begin(), taken.end(), 1.) ==
             static_cast<long>(n));
  BOOST_TEST(Ranks::sum(own.size()) == n);
  BOOST_TEST(!turns.stopped());
}

BOOST_AUTO_TEST_CASE(turns_that_are_stopped)
{
  Ranks::Turns turns;
  BOOST_TEST(turns.has_below(1000 * Ranks::count()));
  BOOST_TEST(turns.take_below(1000 * Ranks::count()).has_value());
  Ranks::sum(0.);
  if (Ranks::rank() == last())
    turns.stop();
  Ranks::sum(0.);
  BOOST_TEST(turns.stopped());
  BOOST_TEST(!turns.take_below(1000000).has_value());
}

BOOST_AUTO_TEST_CASE(texts_of_any_length)
{
  const std::string zeros("a\0b", 3);
  for (const std::string &text :
       {std::string(), zeros, std::string(3000001, 'x')})
    {
      std::string sent = Ranks::is_root() ? text : "something else";
      Ranks::broadcast(sent);
      BOOST_TEST((sent == text));
    }
}

// each member is compared by name: serialize() may have lost one
BOOST_AUTO_TEST_CASE(a_solver_report_arrives_whole)
{
  SolverReport sent;
  if (Ranks::rank() == last())
    sent = {"fall-back",
            true,
            false,
            true,
            "none",
            1,
            2,
            3,
            4,
            5,
            6,
            7,
            {0.25, std::numeric_limits<double>::infinity()},
            {{1., 2.}, {3., 4.}}};
  Ranks::broadcast(sent, last());
  BOOST_TEST(sent.solver == "fall-back");
  BOOST_TEST(sent.used_fallback);
  BOOST_TEST(!sent.edges_settled);
  BOOST_TEST(sent.converged);
  BOOST_TEST(sent.reason == "none");
  BOOST_TEST(sent.iterations == 1u);
  BOOST_TEST(sent.normal_solves == 2u);
  BOOST_TEST(sent.tangential_solves == 3u);
  BOOST_TEST(sent.passes == 4u);
  BOOST_TEST(sent.corrections == 5u);
  BOOST_TEST(sent.friction_rounds == 6u);
  BOOST_TEST(sent.force_rounds == 7u);
  BOOST_TEST(sent.residual.normal == 0.25);
  BOOST_TEST(std::isinf(sent.residual.tangential));
  BOOST_REQUIRE_EQUAL(sent.history.size(), 2u);
  BOOST_TEST(sent.history[1].normal == 3.);
  BOOST_TEST(sent.history[1].tangential == 4.);
}

BOOST_AUTO_TEST_CASE(a_contact_state_arrives_whole)
{
  ContactState sent; // what other ranks hold is replaced, not kept
  sent.pressure       = {7., 7., 7.};
  sent.scheme         = {{{}, {}}, {1}};
  sent.edge_law       = true;
  sent.holds_friction = Ranks::rank() != last();
  sent.holds_scheme   = Ranks::rank() != last();
  if (Ranks::rank() == last())
    sent = {{1., 0., 3.},
            NodalField(1, std::vector<double>{-0.5, 0.5}),
            2e-4,
            {{{17, 1.5, 0.25, {{0.125, -2.}}}}, {2, 5}},
            false,
            {0.3, 0.2},
            false,
            false};
  Ranks::broadcast(sent, last());
  BOOST_TEST((sent.pressure == std::vector<double>{1., 0., 3.}));
  BOOST_TEST((sent.traction.values() == std::vector<double>{-0.5, 0.5}));
  BOOST_TEST(sent.traction.n_components() == 2u);
  BOOST_TEST(sent.approach == 2e-4);
  BOOST_TEST((sent.scheme.sliding == std::vector<unsigned int>{2, 5}));
  BOOST_REQUIRE_EQUAL(sent.scheme.edges.size(), 1u);
  BOOST_TEST(sent.scheme.edges[0].first == 17u);
  BOOST_TEST(sent.scheme.edges[0].a == 1.5);
  BOOST_TEST(sent.scheme.edges[0].b == 0.25);
  BOOST_TEST((sent.scheme.edges[0].c == std::array<double, 2>{{0.125, -2.}}));
  BOOST_TEST(!sent.edge_law);
  BOOST_TEST((sent.friction == std::vector<double>{0.3, 0.2}));
  BOOST_TEST(!sent.holds_friction);
  BOOST_TEST(!sent.holds_scheme);
}

BOOST_AUTO_TEST_CASE(parts_of_bodies_arrive_whole)
{
  DenseMatrix W =
    Ranks::rank() == last() ? DenseMatrix::Zero(2, 3) : DenseMatrix();
  if (Ranks::rank() == last())
    for (unsigned int i = 0; i < 6; ++i)
      W.data()[i] = i;
  Ranks::broadcast(W, last());
  BOOST_TEST(W.rows() == 2u);
  BOOST_TEST(W.cols() == 3u);
  BOOST_TEST(W(1, 2) == 5.);

  StepEnergy energy;
  if (Ranks::rank() == last())
    energy = {1., 2., 3., 4., 5., 6., 7.};
  Ranks::broadcast(energy, last());
  BOOST_TEST(energy.kinetic == 1.);
  BOOST_TEST(energy.strain == 2.);
  BOOST_TEST(energy.contact_work == 3.);
  BOOST_TEST(energy.load_work == 4.);
  BOOST_TEST(energy.damping == 5.);
  BOOST_TEST(energy.numerical_dissipation == 6.);
  BOOST_TEST(energy.balance_error == 7.);

  Trace trace;
  if (Ranks::rank() == last())
    trace = {2,
             {{{0., 1.}}, {{2., 3.}}},
             {{{{4., 5.}}, {{6., 7.}}, {{{0, 1.}}, {{0, 0.5}, {1, 0.5}}}}}};
  Ranks::broadcast(trace, last());
  BOOST_TEST(trace.n_dimensions == 2u);
  BOOST_REQUIRE_EQUAL(trace.nodes.size(), 2u);
  BOOST_TEST(trace.nodes[1][1] == 3.);
  BOOST_REQUIRE_EQUAL(trace.cells.size(), 1u);
  BOOST_TEST(trace.cells[0].lower[1] == 5.);
  BOOST_TEST(trace.cells[0].upper[0] == 6.);
  BOOST_REQUIRE_EQUAL(trace.cells[0].corners.size(), 2u);
  BOOST_TEST(trace.cells[0].corners[1][1].first == 1u);
  BOOST_TEST(trace.cells[0].corners[1][1].second == 0.5);
}

BOOST_AUTO_TEST_CASE(one_rank_acts_the_others_wait)
{
  double n_calls = 0;
  Ranks::on(last(), [&]() {
    ++n_calls;
    BOOST_TEST(Ranks::rank() == last());
    BOOST_TEST(Ranks::others_wait() == (Ranks::count() > 1));
    Ranks::on_root([&]() { ++n_calls; });
    if (Ranks::count() > 1)
      BOOST_CHECK_THROW(Ranks::sum(1.), std::logic_error);
  });
  BOOST_TEST(!Ranks::others_wait());
  BOOST_TEST(n_calls == (Ranks::rank() == last() ? 2. : 0.));
}

template <typename Exception>
void check_shared(const Exception &exception, const std::string &message)
{
  for (const unsigned int rank : {0u, last()})
    {
      const auto is_it = [&](const Exception &error) {
        return error.what() == message;
      };
      BOOST_CHECK_EXCEPTION(Ranks::on(rank, [&]() { throw exception; }),
                            Exception,
                            is_it);
      BOOST_TEST(!Ranks::others_wait());
    }
}

/** States that differ from rank to rank, more than the forces are asked for. */
BOOST_AUTO_TEST_CASE(what_is_near_enough_rank_0_decides)
{
  HalfPlane::Options options;
  options.creepage       = 0.;
  ContactProblem problem = HalfPlane::half_plane_problem(options);
  problem.loads.forces.x = -0.6 * HalfPlane::mu * *problem.loads.normal_load;
  const SolverControls controls;
  const auto           solver = make_contact_solver("automatic", controls);
  ContactState         state;
  const auto           solve = [&]() {
    const SolverReport report = solver->solve(problem, state);
    for (double &traction : state.traction)
      traction *= 1 + 1e-6 * Ranks::rank();
    return report;
  };
  const SolverReport report = solve_for_forces(solve, controls, problem, state);
  const double       rounds = report.force_rounds;
  BOOST_TEST(report.converged);
  BOOST_TEST(Ranks::maximum(rounds) == rounds);
  BOOST_TEST(Ranks::maximum(problem.loads.creepages.x) ==
             problem.loads.creepages.x);
}

BOOST_AUTO_TEST_CASE(what_one_throws_all_throw)
{
  check_shared(InputError("no such file"), "no such file");
  check_shared(ConvergenceError("50 iterations"), "50 iterations");
  check_shared(Interrupted("stop"), "stop");
  check_shared(std::logic_error("a bug"), "a bug");
  check_shared(std::runtime_error(std::string(5000000, 'r')),
               std::string(5000000, 'r'));
  check_shared(std::bad_alloc(), std::bad_alloc().what());
  if (Ranks::count() > 1) // a type the others do not know
    BOOST_CHECK_THROW(Ranks::on(last(),
                                []() { throw fs::filesystem_error("a", {}); }),
                      std::runtime_error);
  BOOST_TEST(Ranks::sum(1.) == Ranks::count());
}

BOOST_AUTO_TEST_CASE(the_lowest_failure_of_all)
{
  Ranks::on_all([]() {});
  const unsigned int first = Ranks::count() > 1 ? 1 : 0;
  BOOST_TEST(complaint([&]() {
               Ranks::on_all([&]() {
                 if (Ranks::rank() >= first)
                   throw InputError("rank " + std::to_string(Ranks::rank()));
               });
             }) == "rank " + std::to_string(first));
}

// A signal to one rank stops all, but inside on() only that one.
BOOST_AUTO_TEST_CASE(interrupts_are_agreed_on)
{
  install_interrupt_handlers();
  BOOST_CHECK_NO_THROW(throw_if_interrupted());
  if (Ranks::rank() == last())
    kill(getpid(), SIGTERM); // heard by another thread
  for (int k = 0; k < 500 && Ranks::rank() == last() && !interrupted(); ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  BOOST_TEST(interrupted() == (Ranks::rank() == last()));
  if (Ranks::count() > 1)
    BOOST_CHECK_NO_THROW(Ranks::on_root(throw_if_interrupted));
  BOOST_CHECK_THROW(Ranks::on(last(), throw_if_interrupted), Interrupted);
  BOOST_CHECK_EXCEPTION(throw_if_interrupted(),
                        Interrupted,
                        [](const Interrupted &error) {
                          return contains(error.what(), "SIGTERM");
                        });
  install_interrupt_handlers();
  BOOST_CHECK_NO_THROW(throw_if_interrupted());
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(files_of_ranks)

BOOST_AUTO_TEST_CASE(only_the_root_talks)
{
  std::ostringstream    out, errors;
  std::streambuf *const old_out    = std::cout.rdbuf(out.rdbuf());
  std::streambuf *const old_errors = std::cerr.rdbuf(errors.rdbuf());
  Log                   log(Verbosity::normal);
  log.message("hello");
  log.warning("careful");
  std::cout.rdbuf(old_out);
  std::cerr.rdbuf(old_errors);
  BOOST_TEST(out.str() == (Ranks::is_root() ? "hello\n" : ""));
  BOOST_TEST(errors.str().empty() == !Ranks::is_root());
  BOOST_TEST(log.warnings().size() == 1u);
}

BOOST_AUTO_TEST_CASE(rows_that_a_rank_keeps)
{
  const SharedFolder shared;
  const unsigned int number = last();
  const bool many = Ranks::count() > 1, is_last = Ranks::rank() == last();
  const std::string name = "results.csv", own = rank_file_name(name, last());
  RunFolder         run(shared.folder, "a", "b");
  run.open();
  run.claim_for_ranks(name);
  const bool keeps = many && is_last;
  Ranks::apart([&]() { // where each rank is the root
    ResultsTable rows = ResultsTable::of_rank(run, number);
    if (!keeps)
      return;
    rows.set("state", 7);
    rows.end_row();
    BOOST_TEST(read(shared.folder / own) == "state\n7\n");
  });
  BOOST_TEST(fs::exists(shared.folder / own) == many);
  BOOST_TEST(!fs::exists(shared.folder / name));
  BOOST_TEST(contains(read(shared.folder / "run.json"), own) == many);
  Ranks::sum(0.);
  Ranks::on_root([&]() { run.remove_files_of_ranks(name); });
  BOOST_TEST(!fs::exists(shared.folder / own));
  BOOST_TEST(!contains(read(shared.folder / "run.json"), own));
  Ranks::sum(0.);
}

/** A rank on another machine may have written to a folder of the same name. */
BOOST_AUTO_TEST_CASE(rows_that_the_root_does_not_see_are_missed)
{
  const SharedFolder shared;
  const bool         many = Ranks::count() > 1;
  RunFolder          run(shared.folder, "a", "b");
  run.open();
  ResultsTable results(run);
  RunReport    report;
  PhaseTimer   timer;
  Log          log(Verbosity::quiet);
  RunContext   context{run, results, report, timer, log};
  RowsOfRanks  rows(context);
  rows.claim();
  Ranks::sum(0.);
  const bool keeps = many && Ranks::rank() == last();
  Ranks::apart([&]() {
    if (!keeps)
      return;
    rows.context().results.set("state", 0);
    rows.context().results.end_row();
  });
  Ranks::on_root([&]() {
    fs::remove(shared.folder / rank_file_name("results.csv", last()));
  });
  const std::string said = complaint([&]() { rows.collect(TablePlan()); });
  BOOST_TEST(contains(said, "Of 1 states that ranks have solved, 0 are in") ==
             many);
  BOOST_TEST(said.empty() == !many);
}

BOOST_AUTO_TEST_CASE(only_the_root_writes)
{
  const SharedFolder shared;
  RunFolder          run(shared.folder, "a", "b");
  run.open();
  run.write_atomically("wheel.txt", std::to_string(Ranks::rank()));
  run.write_record("\"status\": \"done\"");
  Ranks::sum(0.);
  BOOST_TEST(read(shared.folder / "wheel.txt") == "0");
  BOOST_TEST(contains(read(shared.folder / "run.json"), "wheel.txt"));
}

BOOST_AUTO_TEST_CASE(a_file_in_pieces)
{
  const SharedFolder       shared;
  std::vector<std::string> names;
  for (unsigned int r = 0; r < Ranks::count(); ++r)
    names.push_back("wheel-" + std::to_string(r) + ".vtu");
  RunFolder run(shared.folder, "", "");
  run.open();
  run.write_pieces(names, "of " + std::to_string(Ranks::rank()));
  for (unsigned int r = 0; r < Ranks::count(); ++r)
    {
      BOOST_TEST(read(shared.folder / names[r]) == "of " + std::to_string(r));
      BOOST_TEST(contains(read(shared.folder / "run.json"), names[r]));
    }
  Ranks::sum(0.); // all have read before pieces are begun anew

  // the last rank finds a folder where its file should be
  Ranks::on_root([&]() { fs::create_directory(shared.folder / "rail.vtu"); });
  names.back() = "rail.vtu";
  BOOST_TEST(
    contains(complaint([&]() { run.write_pieces(names, ""); }), "rail.vtu"));
}

BOOST_AUTO_TEST_CASE(a_folder_that_is_refused)
{
  const SharedFolder shared;
  Ranks::on_root([&]() { write(shared.folder / "thesis.tex", ""); });
  RunFolder run(shared.folder, "", "");
  BOOST_TEST(contains(complaint([&]() { run.open(); }), "did not write"));
  BOOST_TEST(contains(complaint([&]() { run.reopen({}); }), "did not write"));
}

BOOST_AUTO_TEST_CASE(checkpoint_and_history)
{
  const SharedFolder shared;
  RunFolder          run(shared.folder, "", "");
  run.open();
  Checkpoint record;
  {
    HistoryTable history(run, history_name, {"step", "force"});
    history.add_row({1., 2.});
    record.history        = history.flush();
    record.state.pressure = {1. + Ranks::rank(), 0.5};
    write_checkpoint(record, run);
  }
  const Checkpoint kept = read_checkpoint(run); // of the root
  BOOST_TEST((kept.state.pressure == std::vector<double>{1., 0.5}));
  BOOST_TEST(kept.history.n_rows == 1u);
  Ranks::sum(0.);
  BOOST_TEST(read(shared.folder / history_name) == "step,force\n1,2\n");
  Ranks::on_root([&]() { write(shared.folder / checkpoint_name, "noise"); });
  BOOST_TEST(contains(complaint([&]() { read_checkpoint(run); }), "truncated"));
  BOOST_TEST(contains(complaint([&]() {
                        HistoryTable(run, history_name, {"a"}, {1, 1000});
                      }),
                      "has less than"));
}

BOOST_AUTO_TEST_CASE(totals)
{
  const PhaseTimer timer;
  const RankTotals totals = totals_of_ranks(timer);
  const double     n      = Ranks::count();
  BOOST_TEST(totals.largest_peak_memory > 1e6);
  BOOST_TEST(totals.peak_memory <= n * totals.largest_peak_memory);
  BOOST_TEST(totals.peak_memory > 0.5 * n * totals.largest_peak_memory);
  BOOST_TEST(totals.cpu_seconds >= totals.largest_cpu_seconds);

  RunReport report;
  report.n_ranks = 3;
  BOOST_TEST(!contains(report.summary(timer, ""), "ranks"));
  report.rank_totals = {{3., 1.25, 5e6, 2e6}};
  std::istringstream lines(report.summary(timer, ""));
  std::string        text;
  for (std::string word; lines >> word;)
    text += word + ' ';
  BOOST_TEST(contains(text,
                      "on 3 ranks, 3 s of CPU (at most 1.25 s of one), "
                      "5 MB of memory (at most 2 MB of one)"));
}

BOOST_AUTO_TEST_SUITE_END()

// Only mpirun sees how it ends: a suite for a run of its own.
BOOST_AUTO_TEST_SUITE(terminated_rank)

BOOST_AUTO_TEST_CASE(the_others_do_not_wait)
{
  Ranks::abort_all_ranks_on_terminate();
  if (Ranks::rank() == last())
    std::thread([]() { throw std::runtime_error("lost in a thread"); }).join();
  Ranks::sum(1.);
}

BOOST_AUTO_TEST_SUITE_END()

// Asked once in a run: each of the two in a run of its own.
BOOST_AUTO_TEST_SUITE(alike_failures)

BOOST_AUTO_TEST_CASE(one_code_one_message)
{
  BOOST_TEST(Ranks::all_ranks_failed(ExitCode::not_converged));
  std::ostringstream    errors;
  std::streambuf *const old = std::cerr.rdbuf(errors.rdbuf());
  const int code = Ranks::end_failed_run(ExitCode::not_converged, "diverged");
  std::cerr.rdbuf(old);
  BOOST_TEST(code == 2);
  BOOST_TEST(errors.str() ==
             (Ranks::is_root() ? "rolling-contact: diverged\n" : ""));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(different_failures)

BOOST_AUTO_TEST_CASE(the_root_speaks_for_itself)
{
  const bool     several = Ranks::count() > 1;
  const ExitCode own =
    Ranks::is_root() ? ExitCode::input_error : ExitCode::internal_error;
  BOOST_TEST(Ranks::all_ranks_failed(own) == !several);
  std::ostringstream    errors;
  std::streambuf *const old = std::cerr.rdbuf(errors.rdbuf());
  const int code = Ranks::end_failed_run(own, std::to_string(Ranks::rank()));
  std::cerr.rdbuf(old);
  BOOST_TEST(code == 1);
  const std::string name =
    several ? "rank 0 of " + std::to_string(Ranks::count()) + ": " : "";
  BOOST_TEST(errors.str() ==
             (Ranks::is_root() ? "rolling-contact: " + name + "0\n" : ""));
}

BOOST_AUTO_TEST_SUITE_END()
