#include <rolling_contact/linear_algebra/block_lanczos.h>
#include <rolling_contact/linear_algebra/block_products.h>
#include <rolling_contact/linear_algebra/krylov_basis.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

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

    /// how well the first value beyond those wanted must be known
    const double guard_tolerance = 1e-6;

    /** Columns after which values that are not found are given up. */
    std::size_t
    most_basis(const std::size_t n_wanted)
    {
      return 12 * n_wanted + 400;
    }



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
      const std::size_t   b = X.n_columns();
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
      DenseMatrix       T(b, rank);
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
      X = dense_product(X, T);
      return result;
    }



    /** Columns are taken for nothing that are so against what they were. */
    Orthonormal
    orthonormalise_columns(const SymmetricSparseMatrix &M,
                           const std::vector<double>   &before,
                           DenseMatrix                 &X)
    {
      const DenseMatrix   G = projected(M, X);
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
      return orthonormalise(projected(M, X),
                            std::vector<double>(X.n_columns(), 1.),
                            rounding,
                            X);
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
    wanted_pairs(const KrylovBasis     &V,
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

    KrylovBasis               V(n);
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
            R                       = dense_product(clean.R, R);
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
