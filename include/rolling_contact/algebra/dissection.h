#ifndef rolling_contact_algebra_dissection_h
#define rolling_contact_algebra_dissection_h

#include <rolling_contact/algebra/symmetric_sparse_matrix.h>

#include <cstdint>
#include <vector>

namespace RollingContact
{
  /**
   * Fill-reducing order of the unknowns: nested dissection of the node graph by
   * METIS, the unknowns of a node kept together. Entry k is the unknown that is
   * eliminated as number k. The same in every run, also if several threads call
   * it, which then wait for each other.
   */
  std::vector<std::int64_t>
  dissection_order(const SymmetricSparseMatrix     &matrix,
                   const std::vector<unsigned int> &node_of_unknown);
} // namespace RollingContact

#endif
