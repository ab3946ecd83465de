#include <rolling_contact/algebra/block_lanczos.h>
#include <rolling_contact/algebra/krylov_basis.h>
#include <rolling_contact/algebra/lapack.h>

#include <algorithm>
#include <cmath>
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
    std::size_t most_basis(const std::size_t n_wanted)
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
    Orthonormal orthonormalise(const DenseMatrix         &G,
                               const std::vector<double> &scales,
                               const double               floor,
                               DenseMatrix               &X)
    {
      const auto                scaled = as_vector(scales).asDiagonal();
      DenseMatrix               U      = scaled * G * scaled;
      const std::vector<double> values = symmetric_eigenpairs(U);
      std::size_t               first = 0, b = values.size();
      while (first < b && !(values[first] > floor))
        ++first;
      Orthonormal result;
      result.least_square = first < b ? values[first] : 1.;
      const Eigen::ArrayXd roots =
        as_vector(values).tail(b - first).array().sqrt();
      const auto           kept = U.rightCols(b - first);
      const Eigen::ArrayXd inverse =
        (as_vector(scales).array() > 0.)
          .select(as_vector(scales).array().inverse(), 0.);
      result.R = roots.matrix().asDiagonal() * kept.transpose() *
                 inverse.matrix().asDiagonal();
      X = X * (scaled * kept * roots.inverse().matrix().asDiagonal());
      return result;
    }

    /** Columns are taken for nothing that are so against what they were. */
    Orthonormal orthonormalise_columns(const SymmetricSparseMatrix &M,
                                       const std::vector<double>   &before,
                                       DenseMatrix                 &X)
    {
      const DenseMatrix   G = projected(M, X);
      std::vector<double> scales(X.cols(), 0.);
      for (std::size_t i = 0; i < scales.size(); ++i)
        if (G(i, i) > nothing * before[i])
          scales[i] = 1 / std::sqrt(G(i, i));
      return orthonormalise(G, scales, dependent, X);
    }

    /** Columns of length 1 whose parts in the space were taken away: what is
     * left must be more than rounding. */
    Orthonormal orthonormalise_rest(const SymmetricSparseMatrix &M,
                                    DenseMatrix                 &X)
    {
      return orthonormalise(projected(M, X),
                            std::vector<double>(X.cols(), 1.),
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
      void add(const DenseMatrix &diagonal, const DenseMatrix &below)
      {
        const std::size_t before = size, b = diagonal.cols();
        size += b;
        T.conservativeResizeLike(DenseMatrix::Zero(size, size));
        T.bottomRightCorner(b, b) = (diagonal + diagonal.transpose()) / 2;
        // which the reading of the lower triangle mirrors
        T.block(before, before - last.cols(), last.rows(), last.cols()) = last;
        last                                                            = below;
      }

      /** Ritz values in descending order, their vectors, and how far they are
       * from being exact. */
      void solve()
      {
        vectors              = T;
        const auto ascending = symmetric_eigenpairs(vectors);
        theta.assign(ascending.rbegin(), ascending.rend());
        residual.resize(size);
        as_vector(residual) =
          (last * vectors.bottomRows(last.cols())).colwise().norm().reverse();
      }

      /** True if all values from @p least on have converged and are as many as
       * wanted; if that is not known, the first one below @p least as well. */
      bool converged(const double                      least,
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

    DenseMatrix random_block(const std::size_t      n_rows,
                             const LanczosControls &controls)
    {
      std::mt19937_64                        generator(controls.seed);
      std::uniform_real_distribution<double> value(-1., 1.);
      return DenseMatrix::NullaryExpr(n_rows,
                                      std::min<std::size_t>(controls.block_size,
                                                            n_rows),
                                      [&]() { return value(generator); });
    }

    /** The eigenpairs wanted, of Ritz vectors of the basis. */
    EigenPairs wanted_pairs(const KrylovBasis     &V,
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
      found.vectors       = DenseMatrix::Zero(n_rows, m);
      V.add_combination(1.,
                        projection.vectors.rightCols(m).rowwise().reverse(),
                        0,
                        found.vectors);
      found.n_basis = V.size();
      return found;
    }
  } // namespace

  EigenPairs block_lanczos(const Factorisation         &factor,
                           const SymmetricSparseMatrix &M,
                           const LanczosControls       &controls)
  {
    const std::size_t n        = M.size();
    const double      least    = 1 / (controls.largest + controls.shift);
    std::size_t       n_solves = 0;
    const auto        invert   = [&](const DenseMatrix &X) {
      DenseMatrix image = times(M, X);
      factor.solve(image);
      n_solves += X.cols();
      return image;
    };

    KrylovBasis               V(n);
    Projection                projection;
    DenseMatrix               block = invert(random_block(n, controls));
    const std::vector<double> any(block.cols(), 0.);
    orthonormalise_columns(M, any, block);
    orthonormalise_rest(M, block);
    std::size_t begin = 0, before = 0, checked = 0;
    while (block.cols() > 0)
      {
        controls.interrupt();
        V.add(block);
        DenseMatrix X = invert(block);
        // against the last two blocks, then against rounding
        const DenseMatrix   MX = times(M, X), H = V.project(MX, before);
        std::vector<double> lengths(X.cols());
        as_vector(lengths) = X.cwiseProduct(MX).colwise().sum();
        V.add_combination(-1., H, before, X);
        DenseMatrix R = orthonormalise_columns(M, lengths, X).R;
        for (double least = 0.; least < much && X.cols() > 0;)
          {
            const DenseMatrix rest = V.project(times(M, X), 0);
            V.add_combination(-1., rest, 0, X);
            const Orthonormal clean = orthonormalise_rest(M, X);
            R                       = clean.R * R;
            least                   = clean.least_square;
          }
        projection.add(H.bottomRows(block.cols()), R);
        block  = std::move(X);
        before = begin;
        begin  = V.size();
        if (block.cols() > 0 && begin < 1.05 * checked + 8)
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
