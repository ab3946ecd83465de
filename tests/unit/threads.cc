#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include <dlfcn.h>
#include <dmumps_c.h>

#include <rolling_contact/algebra/fourier.h>
#include <rolling_contact/algebra/indefinite_factor.h>
#include <rolling_contact/base/captured_stderr.h>
#include <rolling_contact/surfaces/height_expression.h>

#include <atomic>
#include <cmath>
#include <iostream>
#include <sstream>
#include <thread>

using namespace RollingContact;

namespace
{
  /** Instances of MUMPS that are alive, and whether the next one fails. */
  std::atomic<int>  n_instances{0};
  std::atomic<bool> start_fails{false};
} // namespace

/** MUMPS' own function behind one that counts, for all of this program. */
extern "C" void dmumps_c(DMUMPS_STRUC_C *const solver)
{
  static const auto library =
    reinterpret_cast<void (*)(DMUMPS_STRUC_C *)>(dlsym(RTLD_NEXT, "dmumps_c"));
  const int job = solver->job;
  n_instances += job == -1 ? 1 : job == -2 ? -1 : 0;
  library(solver);
  if (job == -1 && start_fails.exchange(false))
    solver->infog[0] = -7; // no memory
}

/** What several threads may do at once. */
BOOST_AUTO_TEST_SUITE(threads)

namespace
{
  /** Runs the action in four threads that begin together. */
  void in_threads(const std::function<void(const unsigned int)> &action)
  {
    const unsigned int       n_threads = 4;
    std::atomic<int>         n_ready{0};
    std::vector<std::thread> all;
    for (unsigned int k = 0; k < n_threads; ++k)
      all.emplace_back([&, k]() {
        for (++n_ready; n_ready < static_cast<int>(n_threads);)
          std::this_thread::yield();
        action(k);
      });
    for (std::thread &thread : all)
      thread.join();
  }

  /** diag(-1, ..., -1, 1, ..., 1) with some coupling. */
  SymmetricSparseMatrix indefinite(const std::size_t n,
                                   const std::size_t n_negative)
  {
    SymmetricSparseMatrix matrix;
    matrix.column_starts.push_back(0);
    for (std::size_t j = 0; j < n; ++j)
      {
        matrix.row_indices.push_back(j);
        matrix.values.push_back(j < n_negative ? -1. : 1.);
        if (j + 1 < n)
          {
            matrix.row_indices.push_back(j + 1);
            matrix.values.push_back(0.1);
          }
        matrix.column_starts.push_back(matrix.values.size());
      }
    return matrix;
  }

  std::vector<unsigned int> one_by_one(const std::size_t n)
  {
    std::vector<unsigned int> nodes(n);
    for (std::size_t k = 0; k < n; ++k)
      nodes[k] = k;
    return nodes;
  }
} // namespace

/** Expressions, right and wrong ones, while others write to std::cerr. */
BOOST_AUTO_TEST_CASE(what_is_printed_ends_where_it_belongs)
{
  std::streambuf *const own = std::cerr.rdbuf();
  std::ostringstream    screen;
  std::cerr.rdbuf(screen.rdbuf());
  std::atomic<unsigned int> n_wrong{0};
  in_threads([&](const unsigned int) {
    for (unsigned int k = 0; k < 500; ++k)
      {
        HeightExpression("Surfaces/Rail height", "1e-6*sin(x)", ".");
        n_wrong += complaint([]() {
                     HeightExpression("Surfaces/Rail height", "1e-6*(x", ".");
                   }) != "";
      }
  });
  BOOST_TEST(std::cerr.rdbuf() == screen.rdbuf());
  BOOST_TEST(n_wrong == 4 * 500u);
  BOOST_TEST(screen.str() == "");
  {
    const CapturedStderr silence;
    std::cerr << "Additional information:\n    a cause\n\n";
    std::thread([]() { std::cerr << "a warning" << std::endl; }).join();
    BOOST_TEST(silence.cause() == "a cause");
  }
  std::cerr << "the end";
  std::cerr.rdbuf(own);
  BOOST_TEST(screen.str() == "a warning\nthe end");
}

BOOST_AUTO_TEST_CASE(transforms_at_once)
{
  const auto values = [](const std::size_t n) {
    std::vector<double> x(n);
    for (std::size_t j = 0; j < n; ++j)
      x[j] = std::sin(0.3 * j * j + n);
    return x;
  };
  const std::size_t                              n_sizes = 60;
  std::vector<std::vector<std::complex<double>>> alone;
  for (std::size_t k = 0; k < n_sizes; ++k)
    alone.push_back(Signals::fourier_sums(values(100 + 7 * k)));
  std::atomic<unsigned int> n_equal{0};
  in_threads([&](const unsigned int thread) {
    for (std::size_t k = 0; k < 20 * n_sizes; ++k)
      {
        const std::size_t size = (k + 17 * thread) % n_sizes;
        n_equal += Signals::fourier_sums(values(100 + 7 * size)) == alone[size];
      }
  });
  BOOST_TEST(n_equal == 4 * 20 * n_sizes);
}

BOOST_AUTO_TEST_CASE(inertias_at_once)
{
  std::atomic<unsigned int> n_right{0};
  in_threads([&](const unsigned int thread) {
    for (std::size_t k = 0; k < 30; ++k)
      {
        const std::size_t n = 200 + 10 * thread, n_negative = 3 * k + thread;
        n_right += n_negative_eigenvalues(indefinite(n, n_negative),
                                          one_by_one(n)) == n_negative;
      }
  });
  BOOST_TEST(n_right == 4 * 30u);
  BOOST_TEST(n_instances == 0);
}

BOOST_AUTO_TEST_CASE(a_start_that_fails_leaves_no_instance)
{
  start_fails = true;
  BOOST_CHECK_THROW(n_negative_eigenvalues(indefinite(10, 2), one_by_one(10)),
                    MemoryError);
  BOOST_TEST(n_instances == 0);
  BOOST_TEST(n_negative_eigenvalues(indefinite(10, 2), one_by_one(10)) == 2u);
}

BOOST_AUTO_TEST_SUITE_END()
