#define BOOST_TEST_MODULE rolling_contact
#include <boost/test/unit_test.hpp>

#include <rolling_contact/base/platform.h>

namespace
{
  /**
   * As the program does: BLAS threads that wait for each other on busy cores
   * can make a test a hundred times slower.
   */
  struct OneSolverThread
  {
    OneSolverThread()
    {
      RollingContact::use_one_solver_thread();
    }
  };
} // namespace

BOOST_TEST_GLOBAL_FIXTURE(OneSolverThread);
