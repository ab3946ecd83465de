#ifndef rolling_contact_modes_body_reflections_h
#define rolling_contact_modes_body_reflections_h

#include <rolling_contact/algebra/reflection.h>
#include <rolling_contact/algebra/symmetric_sparse_matrix.h>
#include <rolling_contact/modes/body_places.h>

#include <vector>

namespace RollingContact
{
  /**
   * Reflections across planes normal to x, y and z, through the middle of a
   * body, which leave its stiffness and mass as they are to rounding. A rail
   * has one halfway along it, and another if its section has; a wheel one
   * across the running direction and one across its radius. Bodies with meshes
   * that are graded towards one side, and those that hang on rigid masses, have
   * none.
   */
  std::vector<Reflection> body_reflections(const BodyPlaces            &places,
                                           const SymmetricSparseMatrix &K,
                                           const SymmetricSparseMatrix &M);
} // namespace RollingContact

#endif
