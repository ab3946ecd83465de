#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/memory.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/linear_algebra/blas.h>
#include <rolling_contact/linear_algebra/block_lanczos.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <string>

namespace RollingContact
{
  namespace
  {
    /// squared length of a direction that is taken for 0: over the largest in
    /// its block, and over what it was before parts of it were taken away
    const double dependent = 1e-20, nothing = 1e-26;

    /// squared length of what is left of a direction of length 1, below which
    /// it lies in the space; and above which its parts there are gone
    const double rounding = 1e-16, much = 0.5;

    /// columns that are read at once
    const std::size_t panel_columns = 64;

    /// how well the first value beyond those wanted must be known
    const double guard_tolerance = 1e-6;

    /** Columns after which values that are not found are given up. */
    std::size_t
    most_basis(const std::size_t n_wanted)
    {
      return 12 * n_wanted + 400;
    }



    /**
     * Product C = alpha op(A) B + beta C of the first columns of blocks with
     * many rows; op is the transpose or nothing.
     */
    void
    product(const char   *transpose,
            const int     rows,
            const int     columns,
            const int     inner,
            const double  alpha,
            const double *A,
            const int     lda,
            const double *B,
            const int     ldb,
            const double  beta,
            double       *C,
            const int     ldc)
    {
      if (rows > 0 && columns > 0)
        dgemm_(transpose,
               "N",
               &rows,
               &columns,
               &inner,
               &alpha,
               A,
               &lda,
               B,
               &ldb,
               &beta,
               C,
               &ldc);
    }



    DenseMatrix
    times(const SymmetricSparseMatrix &M, const DenseMatrix &X)
    {
      DenseMatrix         result(X.n_rows(), X.n_columns());
      std::vector<double> column(X.n_rows()), image(X.n_rows());
      for (std::size_t j = 0; j < X.n_columns(); ++j)
        {
          std::copy_n(X.data() + j * X.n_rows(), X.n_rows(), column.begin());
          M.multiply(column, image);
          std::copy(image.begin(), image.end(), result.data() + j * X.n_rows());
        }
      return result;
    }



    /**
     * The columns V of the Krylov space, in panels.
     */
    class Basis
    {
    public:
      explicit Basis(const std::size_t n_rows)
        : n_rows(n_rows)
      {}

      std::size_t
      size() const
      {
        return n_columns;
      }

      void
      add(const DenseMatrix &block)
      {
        for (std::size_t j = 0; j < block.n_columns(); ++j, ++n_columns)
          {
            if (n_columns % panel_columns == 0)
              add_panel();
            std::copy_n(block.data() + j * n_rows,
                        n_rows,
                        panels.back().data() +
                          (n_columns % panel_columns) * n_rows);
          }
      }

      /** V^T X of the columns from @p first on. */
      DenseMatrix
      project(const DenseMatrix &X, const std::size_t first) const
      {
        DenseMatrix result(n_columns - first, X.n_columns());
        each_panel(first, [&](const double *V, std::size_t at, std::size_t k) {
          product("T",
                  k,
                  X.n_columns(),
                  n_rows,
                  1.,
                  V,
                  n_rows,
                  X.data(),
                  n_rows,
                  0.,
                  result.data() + at,
                  result.n_rows());
        });
        return result;
      }

      /** X += alpha V H with the columns from @p first on. */
      void
      add_combination(const double       alpha,
                      const DenseMatrix &H,
                      const std::size_t  first,
                      DenseMatrix       &X) const
      {
        each_panel(first, [&](const double *V, std::size_t at, std::size_t k) {
          product("N",
                  n_rows,
                  X.n_columns(),
                  k,
                  alpha,
                  V,
                  n_rows,
                  H.data() + at,
                  H.n_rows(),
                  1.,
                  X.data(),
                  n_rows);
        });
      }

    private:
      void
      add_panel()
      {
        const double bytes = sizeof(double) * n_rows * panel_columns;
        if (available_memory() > 0 && bytes > 0.7 * available_memory())
          throw MemoryError("The modes of a body with " +
                            std::to_string(n_rows) +
                            " unknowns need more than "
                            "the " +
                            human_bytes(available_memory()) +
                            " free: lower Modes/Maximum frequency or take a "
                            "coarser mesh.");
        panels.emplace_back(n_rows, panel_columns);
      }

      template <typename Action>
      void
      each_panel(const std::size_t first, const Action &action) const
      {
        for (std::size_t p = first / panel_columns; p < panels.size(); ++p)
          {
            const std::size_t begin = std::max(first, p * panel_columns),
                              end =
                                std::min(n_columns, (p + 1) * panel_columns);
            if (end > begin)
              action(panels[p].data() + (begin - p * panel_columns) * n_rows,
                     begin - first,
                     end - begin);
          }
      }

      std::size_t              n_rows, n_columns = 0;
      std::vector<DenseMatrix> panels;
    };



    /** X = Q R with orthonormal Q, and the least length of what was kept. */
    struct Orthonormal
    {
      DenseMatrix R;
      double      least_square = 1.;
    };



    /**
     * Replace X by an orthonormal basis Q of its columns in the inner product
     * of M and leave out what depends on others (Stathopoulos and Wu 2002).
     * @p scales: of the columns, 0 for those that are left out; directions
     * whose squared length, so scaled, is below @p floor are nothing.
     */
    Orthonormal
    orthonormalise(const DenseMatrix         &G,
                   const std::vector<double> &scales,
                   const double               floor,
                   DenseMatrix               &X)
    {
      const std::size_t   n = X.n_rows(), b = X.n_columns();
      DenseMatrix         U = G;
      std::vector<double> values;
      for (std::size_t j = 0; j < b; ++j)
        for (std::size_t i = 0; i < b; ++i)
          U(i, j) *= scales[i] * scales[j];
      symmetric_eigenpairs(U, values);
      std::size_t first = 0;
      while (first < b && !(values[first] > floor))
        ++first;
      const std::size_t rank = b - first;
      DenseMatrix       T(b, rank), Q(n, rank);
      Orthonormal       result;
      result.R            = DenseMatrix(rank, b);
      result.least_square = rank > 0 ? values[first] : 1.;
      for (std::size_t k = 0; k < rank; ++k)
        for (std::size_t i = 0; i < b; ++i)
          {
            const double root = std::sqrt(values[first + k]);
            T(i, k)           = scales[i] * U(i, first + k) / root;
            result.R(k, i) =
              scales[i] > 0. ? root * U(i, first + k) / scales[i] : 0.;
          }
      product("N", n, rank, b, 1., X.data(), n, T.data(), b, 0., Q.data(), n);
      X = std::move(Q);
      return result;
    }



    /** X^T M X. */
    DenseMatrix
    gram(const SymmetricSparseMatrix &M, const DenseMatrix &X)
    {
      const std::size_t n = X.n_rows(), b = X.n_columns();
      const DenseMatrix MX = times(M, X);
      DenseMatrix       G(b, b);
      product("T", b, b, n, 1., X.data(), n, MX.data(), n, 0., G.data(), b);
      return G;
    }



    /** Columns are taken for nothing that are so against what they were. */
    Orthonormal
    orthonormalise_columns(const SymmetricSparseMatrix &M,
                           const std::vector<double>   &before,
                           DenseMatrix                 &X)
    {
      const DenseMatrix   G = gram(M, X);
      std::vector<double> scales(X.n_columns(), 0.);
      for (std::size_t i = 0; i < scales.size(); ++i)
        if (G(i, i) > nothing * before[i])
          scales[i] = 1 / std::sqrt(G(i, i));
      return orthonormalise(G, scales, dependent, X);
    }



    /** Columns of length 1 whose parts in the space were taken away: what is
     * left must be more than rounding. */
    Orthonormal
    orthonormalise_rest(const SymmetricSparseMatrix &M, DenseMatrix &X)
    {
      return orthonormalise(gram(M, X),
                            std::vector<double>(X.n_columns(), 1.),
                            rounding,
                            X);
    }



    DenseMatrix
    multiply(const DenseMatrix &A, const DenseMatrix &B)
    {
      DenseMatrix C(A.n_rows(), B.n_columns());
      product("N",
              A.n_rows(),
              B.n_columns(),
              A.n_columns(),
              1.,
              A.data(),
              std::max<std::size_t>(1, A.n_rows()),
              B.data(),
              std::max<std::size_t>(1, B.n_rows()),
              0.,
              C.data(),
              std::max<std::size_t>(1, C.n_rows()));
      return C;
    }



    /**
     * The block tridiagonal T, its last off-diagonal block R, and the Ritz
     * values they give.
     */
    class Projection
    {
    public:
      /** Add the columns V^T M A^-1 M V_j, where only those rows stand that
       * belong to V_j (@p diagonal), and the block @p below of the next one. */
      void
      add(const DenseMatrix &diagonal, const DenseMatrix &below)
      {
        const std::size_t before = size, b = diagonal.n_columns();
        size += b;
        DenseMatrix larger(size, size);
        for (std::size_t j = 0; j < before; ++j)
          for (std::size_t i = 0; i < before; ++i)
            larger(i, j) = T(i, j);
        for (std::size_t j = 0; j < b; ++j)
          for (std::size_t i = 0; i < b; ++i)
            larger(before + i, before + j) =
              (diagonal(i, j) + diagonal(j, i)) / 2;
        for (std::size_t j = 0; j < last.n_columns(); ++j)
          for (std::size_t i = 0; i < last.n_rows(); ++i)
            larger(before + i, before - last.n_columns() + j) =
              larger(before - last.n_columns() + j, before + i) = last(i, j);
        T    = std::move(larger);
        last = below;
      }

      /** Ritz values in descending order, their vectors, and how far they are
       * from being exact. */
      void
      solve()
      {
        vectors = T;
        std::vector<double> ascending;
        symmetric_eigenpairs(vectors, ascending);
        theta.assign(ascending.rbegin(), ascending.rend());
        residual.assign(size, 0.);
        for (std::size_t k = 0; k < size; ++k)
          for (std::size_t i = 0; i < last.n_rows(); ++i)
            {
              double entry = 0.;
              for (std::size_t j = 0; j < last.n_columns(); ++j)
                entry += last(i, j) *
                         vectors(size - last.n_columns() + j, size - 1 - k);
              residual[k] = std::hypot(residual[k], entry);
            }
      }

      /** True if all values from @p least on have converged and are as many as
       * wanted; if that is not known, the first one below @p least as well. */
      bool
      converged(const double                      least,
                const double                      tolerance,
                const std::optional<std::size_t> &number) const
      {
        std::size_t k = 0;
        for (; k < size && theta[k] >= least; ++k)
          if (residual[k] > tolerance * theta[k])
            return false;
        if (number)
          return k >= *number;
        return k < size && residual[k] <= guard_tolerance * theta[k];
      }

      std::size_t         size = 0;
      std::vector<double> theta, residual;

      /** Columns in ascending order of the values. */
      DenseMatrix vectors;

    private:
      DenseMatrix T, last;
    };



    DenseMatrix
    bottom_rows(const DenseMatrix &A, const std::size_t n_rows)
    {
      DenseMatrix result(n_rows, A.n_columns());
      for (std::size_t j = 0; j < A.n_columns(); ++j)
        for (std::size_t i = 0; i < n_rows; ++i)
          result(i, j) = A(A.n_rows() - n_rows + i, j);
      return result;
    }



    DenseMatrix
    random_block(const std::size_t n_rows, const LanczosControls &controls)
    {
      std::mt19937_64                        generator(controls.seed);
      std::uniform_real_distribution<double> value(-1., 1.);
      DenseMatrix X(n_rows, std::min<std::size_t>(controls.block_size, n_rows));
      for (std::size_t i = 0; i < X.n_rows() * X.n_columns(); ++i)
        X.data()[i] = value(generator);
      return X;
    }



    /** The eigenpairs wanted, of Ritz vectors of the basis. */
    EigenPairs
    wanted_pairs(const Basis           &V,
                 const Projection      &projection,
                 const LanczosControls &controls,
                 const std::size_t      n_rows)
    {
      const double least = 1 / (controls.largest + controls.shift);
      EigenPairs   found;
      while (found.values.size() < projection.size &&
             projection.theta[found.values.size()] >= least)
        found.values.push_back(1 / projection.theta[found.values.size()] -
                               controls.shift);
      const std::size_t m = found.values.size();
      DenseMatrix       S(projection.size, m);
      for (std::size_t k = 0; k < m; ++k)
        for (std::size_t i = 0; i < projection.size; ++i)
          S(i, k) = projection.vectors(i, projection.size - 1 - k);
      found.vectors = DenseMatrix(n_rows, m);
      V.add_combination(1., S, 0, found.vectors);
      found.n_basis = V.size();
      return found;
    }
  } // namespace



  EigenPairs
  block_lanczos(const Factorisation         &factor,
                const SymmetricSparseMatrix &M,
                const LanczosControls       &controls)
  {
    const std::size_t n        = M.size();
    const double      least    = 1 / (controls.largest + controls.shift);
    std::size_t       n_solves = 0;
    const auto        invert   = [&](const DenseMatrix &X) {
      DenseMatrix image = times(M, X);
      factor.solve(image);
      n_solves += X.n_columns();
      return image;
    };

    Basis                     V(n);
    Projection                projection;
    DenseMatrix               block = invert(random_block(n, controls));
    const std::vector<double> any(block.n_columns(), 0.);
    orthonormalise_columns(M, any, block);
    orthonormalise_rest(M, block);
    std::size_t begin = 0, before = 0, checked = 0;
    while (block.n_columns() > 0)
      {
        controls.interrupt();
        V.add(block);
        DenseMatrix X = invert(block);
        // against the last two blocks, then against rounding
        const DenseMatrix   MX = times(M, X), H = V.project(MX, before);
        std::vector<double> lengths(X.n_columns());
        for (std::size_t j = 0; j < X.n_columns(); ++j)
          lengths[j] = std::inner_product(X.data() + j * n,
                                          X.data() + (j + 1) * n,
                                          MX.data() + j * n,
                                          0.);
        V.add_combination(-1., H, before, X);
        DenseMatrix R = orthonormalise_columns(M, lengths, X).R;
        for (double least = 0.; least < much && X.n_columns() > 0;)
          {
            const DenseMatrix rest = V.project(times(M, X), 0);
            V.add_combination(-1., rest, 0, X);
            const Orthonormal clean = orthonormalise_rest(M, X);
            R                       = multiply(clean.R, R);
            least                   = clean.least_square;
          }
        projection.add(bottom_rows(H, block.n_columns()), R);
        block  = std::move(X);
        before = begin;
        begin  = V.size();
        if (block.n_columns() > 0 && begin < 1.05 * checked + 8)
          continue;
        projection.solve();
        checked = begin;
        if (projection.converged(least, controls.tolerance, controls.number) ||
            (controls.number && begin > most_basis(*controls.number)))
          break;
      }
    EigenPairs found = wanted_pairs(V, projection, controls, n);
    found.n_solves   = n_solves;
    return found;
  }
} // namespace RollingContact
