#include <rolling_contact/linear_algebra/block_products.h>
#include <rolling_contact/modes/rotation.h>

namespace RollingContact
{
  DenseMatrix
  modal_rotation(const SkewSparseMatrix &S, const DenseMatrix &shapes)
  {
    DenseMatrix result = projected(S, shapes);
    for (std::size_t j = 0; j < result.n_columns(); ++j)
      for (std::size_t i = 0; i <= j; ++i)
        {
          const double skew = (result(i, j) - result(j, i)) / 2;
          result(i, j)      = skew;
          result(j, i)      = -skew;
        }
    return result;
  }
} // namespace RollingContact
