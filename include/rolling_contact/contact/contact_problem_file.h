#ifndef rolling_contact_contact_contact_problem_file_h
#define rolling_contact_contact_contact_problem_file_h

#include <rolling_contact/contact/contact_problem.h>
#include <rolling_contact/contact/trace.h>

#include <filesystem>

namespace RollingContact
{
  /**
   * What a steady contact problem on N nodes is made of, with a state of it:
   * enough to solve it anew, and with other solvers. The slip operator is made
   * of the trace.
   */
  struct StoredProblem
  {
    Trace           trace;
    ContactMatrices matrices = ContactMatrices::lumped; ///< of B1's integrals
    ContactProblem  problem;
    ContactState    state;
  };

  /**
   * The bytes of an HDF5 file of a problem and its solution, for messages of
   * that name. Units are those of ContactProblem, and stand beside each array;
   * sparse matrices are triplets (row, column, value) from 0 on. Beside what
   * read_contact_problem() needs there are B1 at the solution, edges included,
   * slip and gap. Throws InputError if friction depends on the sliding speed,
   * which the file has no place for.
   */
  std::string contact_problem_bytes(const Trace                 &trace,
                                    const ContactMatrices        matrices,
                                    const ContactProblem        &problem,
                                    const ContactState          &state,
                                    const std::filesystem::path &name);

  /**
   * Read what contact_problem_bytes() made. Throws InputError.
   */
  StoredProblem read_contact_problem(const std::filesystem::path &file);
} // namespace RollingContact

#endif
