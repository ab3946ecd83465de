#ifndef rolling_contact_modes_rotation_h
#define rolling_contact_modes_rotation_h

#include <rolling_contact/algebra/dense_matrix.h>
#include <rolling_contact/algebra/skew_sparse_matrix.h>

namespace RollingContact
{
  /**
   * Phi^T S Phi of the flow round an axle: by which modes turn into each other
   * as the body spins and is looked at from where it does not, see
   * assemble_rotation(). Skew. Units: 1.
   */
  DenseMatrix modal_rotation(const SkewSparseMatrix &S,
                             const DenseMatrix      &shapes);
} // namespace RollingContact

#endif
