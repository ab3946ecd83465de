#ifndef rolling_contact_algebra_supernodes_h
#define rolling_contact_algebra_supernodes_h

#include <cstdint>

struct cholmod_factor_struct;

namespace RollingContact
{
  /**
   * Read access to the supernodes of CHOLMOD's factor L, which must outlive it:
   * groups of consecutive columns with the same rows, stored as one dense block
   * by columns, the rows of its diagonal first.
   */
  class Supernodes
  {
  public:
    using Index = std::int64_t;

    explicit Supernodes(const cholmod_factor_struct &L);

    Index size() const
    {
      return n_supernodes;
    }

    Index first_row(const Index k) const
    {
      return super[k];
    }

    int n_diagonal_rows(const Index k) const
    {
      return super[k + 1] - super[k];
    }

    int n_rows(const Index k) const
    {
      return pi[k + 1] - pi[k];
    }

    const Index *rows_below(const Index k) const
    {
      return s + pi[k] + n_diagonal_rows(k);
    }

    /**
     * Entries of L in n_rows() rows and n_diagonal_rows() columns.
     */
    const double *values(const Index k) const
    {
      return x + px[k];
    }

    /**
     * The largest n_rows().
     */
    int max_n_rows() const;

  private:
    const Index  *super, *pi, *px, *s;
    const double *x;
    Index         n_supernodes;
  };
} // namespace RollingContact

#endif
