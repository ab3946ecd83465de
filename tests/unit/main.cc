#define BOOST_TEST_MODULE rolling_contact
#include <boost/test/unit_test.hpp>

#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/platform.h>
#include <rolling_contact/base/ranks.h>

namespace
{
  /**
   * As the program does: BLAS threads that wait for each other on busy cores
   * can make a test a hundred times slower; MPI, started by the tests that need
   * it, ends after all of them.
   */
  struct Process
  {
    Process()
    {
      RollingContact::install_interrupt_handlers(); // before MPI has threads
      RollingContact::use_one_solver_thread();
      if (RollingContact::Ranks::launched())
        RollingContact::Ranks::start();
    }

    ~Process()
    {
      RollingContact::Ranks::finish();
    }
  };
} // namespace

BOOST_TEST_GLOBAL_FIXTURE(Process);
