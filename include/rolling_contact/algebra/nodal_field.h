#ifndef rolling_contact_algebra_nodal_field_h
#define rolling_contact_algebra_nodal_field_h

#include <rolling_contact/algebra/sparse_rows.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace RollingContact
{
  /**
   * One value of a NodalField.
   */
  struct NodalIndex
  {
    unsigned int component = 0;
    unsigned int node      = 0;
  };

  /**
   * A field with T components at N nodes, such as a traction, a slip or a
   * tangential displacement. The T N values stand component by component in one
   * vector, as the compliances and BLAS want them: component c of node i at
   * c N + i. T may be 0.
   */
  class NodalField
  {
  public:
    NodalField() = default;

    /**
     * Zero everywhere.
     */
    NodalField(const std::size_t n_nodes, const unsigned int n_components)
      : nodes(n_nodes)
      , all(n_components * n_nodes, 0.)
    {}

    /**
     * Takes over @p values, given component by component; their number must be
     * a multiple of @p n_nodes.
     */
    NodalField(const std::size_t n_nodes, std::vector<double> values)
      : nodes(n_nodes)
      , all(std::move(values))
    {}

    std::size_t n_nodes() const
    {
      return nodes;
    }

    unsigned int n_components() const
    {
      return nodes == 0 ? 0 : all.size() / nodes;
    }

    /**
     * Number of values, T N.
     */
    std::size_t size() const
    {
      return all.size();
    }

    bool empty() const
    {
      return all.empty();
    }

    double &operator()(const unsigned int component, const std::size_t node)
    {
      return all[component * nodes + node];
    }

    double operator()(const unsigned int component,
                      const std::size_t  node) const
    {
      return all[component * nodes + node];
    }

    double &operator[](const NodalIndex &index)
    {
      return (*this)(index.component, index.node);
    }

    double operator[](const NodalIndex &index) const
    {
      return (*this)(index.component, index.node);
    }

    /**
     * Euclidean norm of the T components at a node; zero if T = 0.
     */
    double norm_at(const std::size_t node) const
    {
      double norm = 0.;
      for (std::size_t k = node; k < all.size(); k += nodes)
        norm = std::hypot(norm, all[k]);
      return norm;
    }

    /**
     * The N values of one component.
     */
    std::vector<double> component(const unsigned int c) const
    {
      return {all.begin() + c * nodes, all.begin() + (c + 1) * nodes};
    }

    /**
     * All values, component by component: for BLAS, files and other ranks.
     */
    const std::vector<double> &values() const
    {
      return all;
    }

    std::vector<double>::iterator begin()
    {
      return all.begin();
    }

    std::vector<double>::iterator end()
    {
      return all.end();
    }

    std::vector<double>::const_iterator begin() const
    {
      return all.begin();
    }

    std::vector<double>::const_iterator end() const
    {
      return all.end();
    }

    /**
     * This field plus @p factor times @p other, which has the same size.
     */
    NodalField &add(const double factor, const NodalField &other)
    {
      for (std::size_t k = 0; k < all.size(); ++k)
        all[k] += factor * other.all[k];
      return *this;
    }

    NodalField &operator+=(const NodalField &other)
    {
      return add(1., other);
    }

    NodalField &operator-=(const NodalField &other)
    {
      return add(-1., other);
    }

    NodalField &operator*=(const double factor)
    {
      for (double &value : all)
        value *= factor;
      return *this;
    }

    friend bool operator==(const NodalField &a, const NodalField &b)
    {
      return a.nodes == b.nodes && a.all == b.all;
    }

    /** For Boost.Serialization. */
    template <typename Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &nodes &all;
    }

  private:
    std::size_t         nodes = 0;
    std::vector<double> all;
  };

  /**
   * M x_c for each component x_c of a field.
   */
  inline NodalField operator*(const SparseRows &M, const NodalField &x)
  {
    return {x.n_nodes(), M.multiply(x.values())};
  }

  /**
   * A row of a matrix times one component of a field.
   */
  inline double apply(const SparseRows::Row &row,
                      const NodalField      &field,
                      const unsigned int     component)
  {
    return apply(row, field.values(), component * field.n_nodes());
  }

  inline double dot(const NodalField &x, const NodalField &y)
  {
    return dot(x.values(), y.values());
  }
} // namespace RollingContact

#endif
