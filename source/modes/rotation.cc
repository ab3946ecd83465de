#include <rolling_contact/modes/rotation.h>

namespace RollingContact
{
  DenseMatrix modal_rotation(const SkewSparseMatrix &S,
                             const DenseMatrix      &shapes)
  {
    const DenseMatrix P = projected(S, shapes);
    return (P - P.transpose()) / 2;
  }
} // namespace RollingContact
