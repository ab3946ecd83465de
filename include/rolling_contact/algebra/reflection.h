#ifndef rolling_contact_algebra_reflection_h
#define rolling_contact_algebra_reflection_h

#include <rolling_contact/algebra/dense_matrix.h>
#include <rolling_contact/algebra/symmetric_sparse_matrix.h>

#include <cstddef>
#include <vector>

namespace RollingContact
{
  /**
   * A reflection R of the unknowns of a structure: what moves unknown i moves,
   * seen in the mirror, unknown image_i to the side of sign_i,
   * (R x)_image_i = sign_i x_i, and R R = 1.
   */
  struct Reflection
  {
    std::vector<std::size_t> image;
    std::vector<double>      sign; ///< +1 or -1
  };

  /**
   * How far the reflection changes a matrix with a positive diagonal: largest
   * entry of |R^T A R - A|, over the root of the two diagonal entries that
   * belong to its row and column. 0 to rounding if the structure is its own
   * mirror image.
   */
  double asymmetry(const SymmetricSparseMatrix &A, const Reflection &R);

  /**
   * The vectors that each of several reflections, which commute, either leaves
   * as they are or turns round, R x = +-x. An orthonormal basis Q of them has
   * one entry in each row at most, as an unknown belongs to itself and its
   * images alone. A matrix that the reflections do not change couples no two of
   * these spaces, so that its eigenvectors are found in one after the other.
   */
  class InvariantSubspace
  {
  public:
    /** @p parity: +1 or -1 for each of the reflections. */
    InvariantSubspace(const std::vector<Reflection> &reflections,
                      const std::vector<int>        &parity,
                      const std::size_t              n_unknowns);

    /** Its dimension, that is number of columns of Q. */
    std::size_t size() const
    {
      return first_unknown.size();
    }

    /** Q^T A Q. */
    SymmetricSparseMatrix restricted(const SymmetricSparseMatrix &A) const;

    /** Nodes of the columns of Q, counted anew: a column belongs to the node of
     * its first unknown. */
    std::vector<unsigned int>
    nodes_of_columns(const std::vector<unsigned int> &node_of_unknown) const;

    /** Write Q x, for column @p k of @p X, to column @p at of @p result. */
    void extend(const DenseMatrix &X,
                const std::size_t  k,
                DenseMatrix       &result,
                const std::size_t  at) const;

  private:
    std::vector<std::size_t> column, first_unknown;
    std::vector<double>      weight; ///< 0: the unknown is at rest
  };

  /**
   * All of these spaces that are not empty; without reflections the one of all
   * vectors.
   */
  std::vector<InvariantSubspace>
  invariant_subspaces(const std::vector<Reflection> &reflections,
                      const std::size_t              n_unknowns);
} // namespace RollingContact

#endif
