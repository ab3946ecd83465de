#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include "half_plane.h"
#include "scratch_folder.h"

#include <rolling_contact/base/files.h>
#include <rolling_contact/base/hdf5_file.h>
#include <rolling_contact/contact/contact_problem_file.h>

#include <cmath>
#include <fstream>

using namespace RollingContact;

/** Contact problems in files of HDF5. */
BOOST_AUTO_TEST_SUITE(contact_problems)

namespace
{
  /** Carter's contact as tests/data/half_plane.h5 has it. */
  StoredProblem half_planes(const double coupling)
  {
    HalfPlane::Options options;
    options.n_elements = 20;
    options.coupling   = coupling;
    options.forces     = NodalForces::hats;
    StoredProblem stored;
    stored.problem     = HalfPlane::half_plane_problem(options);
    stored.trace.nodes = stored.problem.operators.positions();
    for (unsigned int i = 0; i + 1 < stored.trace.nodes.size(); ++i)
      stored.trace.cells.push_back({stored.trace.nodes[i],
                                    {{stored.trace.nodes[i + 1][0], 1.}},
                                    {{{i, 1.}}, {{i + 1, 1.}}}});
    stored.state = HalfPlane::solve(stored.problem).state;
    return stored;
  }

  std::string bytes_of(const StoredProblem &stored)
  {
    return contact_problem_bytes(stored.trace,
                                 stored.matrices,
                                 stored.problem,
                                 stored.state,
                                 "problem.h5");
  }

  StoredProblem written_and_read(const StoredProblem &stored)
  {
    const ScratchFolder scratch;
    const auto          file = scratch.scratch / "problem.h5";
    std::ofstream(file, std::ios::binary) << bytes_of(stored);
    return read_contact_problem(file);
  }

  bool same(const SparseRows &a, const SparseRows &b)
  {
    bool equal = a.size() == b.size();
    for (unsigned int i = 0; equal && i < a.size(); ++i)
      equal = a[i] == b[i];
    return equal;
  }
} // namespace

BOOST_AUTO_TEST_CASE(a_problem_comes_back_as_it_was)
{
  for (const double coupling : {0., 0.2})
    {
      const StoredProblem given = half_planes(coupling),
                          found = written_and_read(given);
      const ContactOperators &a = given.problem.operators,
                             &b = found.problem.operators;
      BOOST_CHECK(a.positions() == b.positions());
      BOOST_CHECK(same(a.H(), b.H()));
      BOOST_CHECK(same(a.slip_operator().rows(), b.slip_operator().rows()));
      BOOST_CHECK(a.slip_operator().lines() == b.slip_operator().lines());
      BOOST_CHECK(a.W().dense() == b.W().dense());
      BOOST_CHECK(a.nodal_forces() == NodalForces::hats);
      BOOST_CHECK(b.nodal_forces() == NodalForces::hats);
      BOOST_TEST(a.coupling().exists == b.coupling().exists);
      BOOST_TEST(a.coupling().dundurs_beta == b.coupling().dundurs_beta);
      BOOST_CHECK(given.problem.loads.gap == found.problem.loads.gap);
      BOOST_CHECK(given.problem.loads.friction == found.problem.loads.friction);
      BOOST_TEST(*given.problem.loads.normal_load ==
                 *found.problem.loads.normal_load);
      BOOST_CHECK(given.state.pressure == found.state.pressure);
      const auto solved = HalfPlane::solve(found.problem);
      BOOST_CHECK(solved.state.pressure == given.state.pressure);
      BOOST_TEST(solved.result.force_x ==
                 resultants(given.problem, given.state).force_x);
    }
}

/** On a curved surface, under an approach, with slip of the profiles. */
BOOST_AUTO_TEST_CASE(what_only_some_problems_have)
{
  StoredProblem given = half_planes(0.);
  const auto   &old   = given.problem.operators;
  SurfaceFrames frames;
  frames.load_angle = 0.1;
  for (std::size_t i = 0; i < old.n_nodes(); ++i)
    frames.nodes.push_back({0.1 * i, 0.01 * i, 0.001 * i});
  ContactOperators operators(
    old.positions(), old.H(), old.W(), old.slip_operator(), old.coupling());
  operators.set_frames(frames);
  given.problem.operators     = operators;
  ContactLoads &loads         = given.problem.loads;
  loads.slip_of_profile       = NodalField(old.n_nodes(), 1);
  loads.slip_of_profile(0, 3) = 0.5;
  loads.approach              = 0.4;
  loads.creepages             = {0.1, 0.2, 0.3};
  loads.normal_load.reset();
  const StoredProblem found = written_and_read(given);
  BOOST_TEST(found.problem.operators.frames().load_angle == 0.1);
  BOOST_TEST(found.problem.operators.frames().nodes[5].angle == 0.005);
  BOOST_TEST(found.problem.loads.slip_of_profile(0, 3) == 0.5);
  BOOST_TEST(!found.problem.loads.normal_load);
  BOOST_TEST(found.problem.loads.approach == 0.4);
  BOOST_TEST(found.problem.loads.creepages.spin == 0.3);
  BOOST_TEST(found.problem.loads.creepages.y == 0.2);
}

/** All solvers on a problem that is at hand, without a body or a mesh. */
BOOST_AUTO_TEST_CASE(solvers_agree_on_a_stored_problem)
{
  const StoredProblem stored =
    read_contact_problem(std::string(TEST_DATA) + "/half_plane.h5");
  const Resultants expected = resultants(stored.problem, stored.state);
  BOOST_TEST(expected.force_x == HalfPlane::carter_force(0.4) * HalfPlane::mu *
                                   expected.normal_force,
             boost::test_tools::tolerance(0.01));
  for (const auto &kind : contact_solver_kinds())
    if (kind.name != "fixed point") // which does not converge everywhere
      BOOST_TEST_CONTEXT(kind.name)
      {
        const auto found = HalfPlane::solve(stored.problem, kind.name);
        BOOST_TEST(found.report.converged);
        BOOST_TEST(found.result.normal_force == expected.normal_force,
                   boost::test_tools::tolerance(1e-9));
        BOOST_TEST(found.result.force_x == expected.force_x,
                   boost::test_tools::tolerance(1e-6));
      }
}

BOOST_AUTO_TEST_CASE(files_that_have_no_problem)
{
  const ScratchFolder scratch;
  const auto          said = [&](const std::string &bytes) {
    std::ofstream(scratch.scratch / "problem.h5", std::ios::binary) << bytes;
    return complaint(
      [&]() { read_contact_problem(scratch.scratch / "problem.h5"); });
  };
  BOOST_TEST(contains(said("text"), "is no file of HDF5"));
  Hdf5File empty("problem.h5");
  empty.make_group("/operators");
  empty.write("/operators/positions", {2}, std::vector<double>{1., 2.});
  BOOST_TEST(
    contains(said(empty.bytes()), "/operators/W: there is no such array"));
  StoredProblem given              = half_planes(0.);
  given.problem.loads.friction_law = make_friction_law("exponential", 0.5, 0.1);
  BOOST_TEST(contains(complaint([&]() { bytes_of(given); }),
                      "friction that depends on the sliding speed"));
}

BOOST_AUTO_TEST_SUITE_END()
