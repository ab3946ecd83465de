#ifndef rolling_contact_algebra_factorisation_h
#define rolling_contact_algebra_factorisation_h

#include <rolling_contact/algebra/condensation.h>
#include <rolling_contact/algebra/symmetric_sparse_matrix.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace RollingContact
{
  /**
   * Factorisation K = P^T L L^T P by CHOLMOD's supernodal factorisation,
   * ordered by METIS on the graph of the nodes. Owns L. Serves K of the
   * quasi-static and M + theta dt C + theta^2 dt^2 K of the dynamic problem
   * alike.
   */
  class Factorisation
  {
  public:
    /**
     * What the symbolic analysis knows before any number is computed.
     */
    struct Size
    {
      std::size_t n_unknowns     = 0;
      std::size_t n_entries      = 0; ///< of L, as stored in supernodes
      double      n_operations   = 0;
      double      analysis_s     = 0;
      double      factor_s       = 0;
      double      condensation_s = 0;

      std::size_t memory_consumption() const
      {
        return n_entries * sizeof(double);
      }
    };

    /**
     * What all factorisations of this process did so far.
     */
    struct Work
    {
      std::uint64_t n_factorisations    = 0;
      std::uint64_t n_condensed_columns = 0;
      std::uint64_t n_solves            = 0; ///< columns given to solve()
    };

    static Work work_done();

    /**
     * Order and analyse. @p node_of_unknown groups the unknowns of one mesh
     * node; unknowns of a node must be consecutive.
     */
    Factorisation(SymmetricSparseMatrix            matrix,
                  const std::vector<unsigned int> &node_of_unknown);

    ~Factorisation();

    Factorisation(Factorisation &&) noexcept;

    /**
     * Compute L and release the matrix. Throws ConvergenceError when the matrix
     * is not positive definite, MemoryError when L needs more than 70 % of the
     * free memory.
     */
    void factorise();

    /**
     * Compute L of another matrix with the pattern of the first, whose order
     * and analysis are kept.
     */
    void factorise(SymmetricSparseMatrix matrix);

    /**
     * K^-1 b: one forward and one backward solve.
     */
    std::vector<double> solve(const std::vector<double> &right_hand_side) const;

    /**
     * K^-1 B for the columns of a block, in place: a block of 16 takes a third
     * to a quarter of the time of 16 single columns. Not at the same time as
     * another solve.
     */
    void solve(DenseMatrix &block) const;

    /**
     * Forward solve z = L^-1 P b, with z in elimination order. Allocates
     * nothing when @p z has its size. One half-solve at a time: they share a
     * workspace.
     */
    void solve_forward(const std::vector<double> &b,
                       std::vector<double>       &z) const;

    /**
     * Backward solve x = P^T L^-T z, overwriting @p z.
     */
    void solve_backward(std::vector<double> &z, std::vector<double> &x) const;

    /**
     * Forward solves of one or two columns at once, for hardly more time than
     * one takes, with the same digits.
     */
    void solve_forward(const std::vector<const std::vector<double> *> &b,
                       const std::vector<std::vector<double> *>       &z) const;

    /**
     * Backward solves of one or two columns at once.
     */
    void solve_backward(const std::vector<std::vector<double> *> &z,
                        const std::vector<std::vector<double> *> &x) const;

    /**
     * Compliance W = E^T K^-1 E = Y^T Y, E with a column for each row of
     * @p loads, which has its unknowns and values. Y is computed supernode by
     * supernode with BLAS-3; kept in @p columns if that is given, released on
     * the way otherwise.
     */
    DenseMatrix condense(const SparseRows &loads,
                         CondensedColumns *columns = nullptr) const;

    /**
     * Such a compliance of the given unknowns, in their order.
     */
    DenseMatrix condense(const std::vector<std::size_t> &unknowns,
                         CondensedColumns *columns = nullptr) const;

    /**
     * Free L for good, when nothing is to be solved any more; its size stays
     * known.
     */
    void release();

    const Size &size() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation;
  };
} // namespace RollingContact

#endif
