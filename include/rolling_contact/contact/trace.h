#ifndef rolling_contact_contact_trace_h
#define rolling_contact_contact_trace_h

#include <rolling_contact/algebra/sparse_rows.h>

#include <array>
#include <optional>
#include <vector>

namespace RollingContact
{
  /**
   * The trace of the body meshes on the contact surface, common to both bodies:
   * nodes (x, y) and boxes whose corners are nodes or, where they hang,
   * combinations of nodes. In 2D y is zero and a box is a segment. Units: m.
   */
  struct Trace
  {
    struct Cell
    {
      std::array<double, 2>        lower{}, upper{};
      std::vector<SparseRows::Row> corners; ///< x fastest

      /** For Boost.Serialization. A member not listed here does not compile. */
      template <typename Archive>
      void serialize(Archive &archive, const unsigned int)
      {
        auto &[lower, upper, corners] = *this;
        archive &lower &upper &corners;
      }
    };

    unsigned int                       n_dimensions = 1;
    std::vector<std::array<double, 2>> nodes;
    std::vector<Cell>                  cells;

    /**
     * Weights of the nodes in the value at (@p x, @p y); none outside.
     */
    std::optional<SparseRows::Row> interpolation(const double x,
                                                 const double y) const;

    /**
     * Size in x of the element on side @p direction (+1, -1) of node @p i; none
     * at the border.
     */
    std::optional<double> element_size(const unsigned int i,
                                       const int          direction) const;

    /**
     * True for the nodes that have no element on one of their sides.
     */
    std::vector<bool> border_nodes() const;

    /** For Boost.Serialization. A member not listed here does not compile. */
    template <typename Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      auto &[n_dimensions, nodes, cells] = *this;
      archive &n_dimensions &nodes &cells;
    }
  };
} // namespace RollingContact

#endif
