#ifndef rolling_contact_algebra_grid_compliance_h
#define rolling_contact_algebra_grid_compliance_h

#include <rolling_contact/algebra/dense_matrix.h>
#include <rolling_contact/algebra/fourier.h>
#include <rolling_contact/algebra/nodal_field.h>
#include <rolling_contact/algebra/sparse_rows.h>

#include <array>
#include <cstdlib>
#include <vector>

namespace RollingContact
{
  /**
   * Where nodes are on a grid of equal boxes. Not every place of the grid has a
   * node.
   */
  struct NodesOnGrid
  {
    std::array<std::size_t, 2>      n{};    ///< places along and across
    std::vector<std::array<int, 2>> places; ///< of the nodes, from 0 on

    std::size_t index(const std::size_t node) const
    {
      return places[node][1] * n[0] + places[node][0];
    }
  };

  /**
   * The grid of boxes of @p size that nodes are on which are multiples of it
   * apart. Units: m.
   */
  NodesOnGrid nodes_on_grid(const std::vector<std::array<double, 2>> &positions,
                            const std::array<double, 2>              &size);

  /**
   * How a place is moved by a force at another so many boxes away. Components
   * are those along the surface first, the normal one last; without friction
   * the normal one alone. Units: m/N.
   */
  class InfluenceTable
  {
  public:
    /** @p at_distance: answers (row) to forces (column) at distances along and
     * across that are not negative, of which there are so many. */
    template <class AtDistance>
    InfluenceTable(const std::array<std::size_t, 2> &n,
                   const AtDistance                 &at_distance)
      : n_along(n[0])
    {
      for (std::size_t across = 0; across < n[1]; ++across)
        for (std::size_t along = 0; along < n[0]; ++along)
          entries.push_back(at_distance(along, across));
    }

    unsigned int n_components() const
    {
      return entries[0].rows();
    }

    /** An answer between two components changes its sign with that of the
     * distance along if one of them is the first, across if one is the second.
     */
    double operator()(const int          along,
                      const int          across,
                      const unsigned int of,
                      const unsigned int by) const
    {
      const double value =
        entries[std::abs(across) * n_along + std::abs(along)](of, by);
      return of != by && ((of == 0 || by == 0) && along < 0) !=
                           ((of == 1 || by == 1) && across < 0)
               ? -value
               : value;
    }

    /** In axes of which those along the surface have the opposite direction. */
    void mirror();

    void add(const InfluenceTable &other);

    std::size_t memory_consumption() const
    {
      return entries.size() * RollingContact::memory_consumption(entries[0]);
    }

  private:
    std::size_t              n_along;
    std::vector<DenseMatrix> entries;
  };

  /**
   * W of nodes on a grid: what half-spaces do, which distances alone tell, and
   * a smooth part of low rank,
   *   W = T + Phi S Phi^T.
   * Units: m/N.
   */
  struct GridInfluence
  {
    NodesOnGrid       nodes;
    InfluenceTable    half_space;         ///< T
    DenseMatrix       shapes;             ///< Phi^T, columns as those of W
    DenseMatrix       of_shapes;          ///< S
    std::vector<bool> shape_is_normal;    ///< or along the surface
    std::vector<bool> shape_is_no_strain; ///< a constant

    /**
     * W in axes of which those along the surface have the opposite direction.
     */
    void mirror();

    /**
     * Add what another body does to the same nodes.
     */
    void add(const GridInfluence &other);

    /**
     * R W R^T on elements of twice the size, whose nodes are some @p of these:
     * R spreads forces and takes displacements with the weights 1/4, 1/2, 1/4
     * in each direction, at the border those of its rows.
     */
    GridInfluence halved(const std::vector<unsigned int> &of,
                         const SparseRows                &R) const;

    DenseMatrix dense() const;
  };

  /**
   * The compliance of a GridInfluence: entries one by one, products by Fourier
   * transforms, n log n for n nodes. Units: m/N, forces in N, displacements in
   * m.
   */
  class GridCompliance
  {
  public:
    explicit GridCompliance(GridInfluence influence);

    GridCompliance(const GridCompliance &) = delete;

    std::size_t n_nodes() const
    {
      return nodes.places.size();
    }

    std::size_t rows() const
    {
      return n_components * n_nodes();
    }

    double operator()(const std::size_t row, const std::size_t column) const;

    /**
     * An entry without the part of low rank, node and component by node and
     * component.
     */
    double of_half_space(const NodalIndex &of, const NodalIndex &by) const
    {
      const auto &at = nodes.places[of.node], &from = nodes.places[by.node];
      return influence.half_space(at[0] - from[0],
                                  at[1] - from[1],
                                  of.component,
                                  by.component);
    }

    const GridInfluence &parts() const
    {
      return influence;
    }

    /**
     * The product of forces of components from @p by_first on, one after the
     * other, in the components @p of_first to @p of_end. Without what moves all
     * nodes alike if @p strains_alone: see ContactOperators::distortion().
     */
    std::vector<double> product(const std::vector<double> &forces,
                                const unsigned int         by_first,
                                const unsigned int         of_first,
                                const unsigned int         of_end,
                                const bool strains_alone = false) const;

    /**
     * Forces that move the nodes about so in one component: a preconditioner,
     * symmetric and positive definite, as its part of any nodes is.
     */
    std::vector<double> forces_for(const std::vector<double> &moved,
                                   const unsigned int         component) const;

    DenseMatrix dense() const
    {
      return influence.dense();
    }

    std::size_t memory_consumption() const;

  private:
    /**
     * Values on all places of a component, of those of the nodes.
     */
    std::vector<double> on_grid(const double *at_nodes) const;

    const GridInfluence            influence;
    const NodesOnGrid             &nodes;
    const unsigned int             n_components;
    const DenseMatrix              moved_shapes; ///< S^T Phi^T
    const Signals::GridConvolution half_space;
  };
} // namespace RollingContact

#endif
