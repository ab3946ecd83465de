#ifndef rolling_contact_contact_contact_compliance_h
#define rolling_contact_contact_contact_compliance_h

#include <rolling_contact/algebra/grid_compliance.h>

#include <memory>

namespace RollingContact
{
  /**
   * W of the contact nodes, (T + 1) N rows and columns, tangential components
   * first: a dense matrix, or that of nodes on a grid, whose products are made
   * without one. Copies share what is on a grid. Units: m/N.
   */
  class ContactCompliance
  {
  public:
    ContactCompliance() = default;

    ContactCompliance(DenseMatrix W)
      : matrix(std::move(W))
    {}

    ContactCompliance(std::shared_ptr<const GridCompliance> on_grid)
      : grid(std::move(on_grid))
    {}

    /**
     * What is on a grid; nullptr for a dense matrix.
     */
    const GridCompliance *on_grid() const
    {
      return grid.get();
    }

    std::size_t rows() const
    {
      return grid ? grid->rows() : matrix.rows();
    }

    double operator()(const std::size_t row, const std::size_t column) const
    {
      return grid ? (*grid)(row, column) : matrix(row, column);
    }

    /**
     * Product of x with the block of @p n_rows that starts there, on a grid
     * that of whole components.
     */
    std::vector<double> product(const std::size_t          first_row,
                                const std::size_t          first_column,
                                const std::size_t          n_rows,
                                const std::vector<double> &x) const;

    /**
     * Rows @p first_row and after of column @p j.
     */
    Eigen::VectorXd column(const std::size_t first_row,
                           const std::size_t n_rows,
                           const std::size_t j) const;

    /**
     * The matrix; it is made here where nodes are on a grid.
     */
    DenseMatrix dense() const &
    {
      return grid ? grid->dense() : matrix;
    }

    DenseMatrix dense() &&
    {
      return grid ? grid->dense() : std::move(matrix);
    }

    /**
     * The matrix itself, as which W is kept from now on.
     */
    DenseMatrix &make_dense();

    /**
     * The entries of a dense matrix, column by column.
     */
    const double *data() const
    {
      return matrix.data();
    }

    std::size_t memory_consumption() const
    {
      return grid ? grid->memory_consumption()
                  : RollingContact::memory_consumption(matrix);
    }

  private:
    DenseMatrix                           matrix;
    std::shared_ptr<const GridCompliance> grid;
  };

  inline std::vector<double> operator*(const ContactCompliance   &W,
                                       const std::vector<double> &x)
  {
    return W.product(0, 0, W.rows(), x);
  }
} // namespace RollingContact

#endif
