#include <rolling_contact/linear_algebra/blas.h>
#include <rolling_contact/modes/rotation.h>

namespace RollingContact
{
  DenseMatrix
  modal_rotation(const SkewSparseMatrix &S, const DenseMatrix &shapes)
  {
    const std::size_t   n = shapes.n_rows(), m = shapes.n_columns();
    DenseMatrix         images(n, m), result(m, m);
    std::vector<double> phi(n), image(n);
    for (std::size_t j = 0; j < m; ++j)
      {
        std::copy_n(shapes.data() + j * n, n, phi.begin());
        S.multiply(phi, image);
        std::copy(image.begin(), image.end(), images.data() + j * n);
      }
    const int    rows = n, columns = m;
    const double one = 1., zero = 0.;
    if (m > 0)
      dgemm_("T",
             "N",
             &columns,
             &columns,
             &rows,
             &one,
             shapes.data(),
             &rows,
             images.data(),
             &rows,
             &zero,
             result.data(),
             &columns);
    for (std::size_t j = 0; j < m; ++j)
      for (std::size_t i = 0; i <= j; ++i)
        {
          const double skew = (result(i, j) - result(j, i)) / 2;
          result(i, j)      = skew;
          result(j, i)      = -skew;
        }
    return result;
  }
} // namespace RollingContact
