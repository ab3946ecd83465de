#ifndef rolling_contact_interface_surface_coupling_h
#define rolling_contact_interface_surface_coupling_h

#include <rolling_contact/linear_algebra/sparse_rows.h>

#include <utility>

namespace RollingContact
{
  /**
   * How a body's contact nodes hang together with the nodes of the interface:
   * they are the same, or values go over by P (see MortarProjection) and nodal
   * forces back by P^T. Values are given component by component.
   */
  class SurfaceCoupling
  {
  public:
    /**
     * A body whose contact nodes are those of the interface: values and forces
     * pass through unchanged.
     */
    SurfaceCoupling() = default;

    SurfaceCoupling(SparseRows P, const std::size_t n_body_nodes)
      : P(std::move(P))
      , n_body_nodes(n_body_nodes)
    {}

    bool
    is_identity() const
    {
      return n_body_nodes == 0;
    }

    /**
     * Nodal values P u on the interface from those on the body.
     */
    std::vector<double>
    to_interface(std::vector<double> body_values) const;

    /**
     * Nodal forces P^T r on the body from those on the interface. Units: N.
     */
    std::vector<double>
    to_body(std::vector<double> interface_forces) const;

    /**
     * Compliance P W P^T on the interface from a body's W, symmetric. Units:
     * m/N.
     */
    DenseMatrix
    to_interface(DenseMatrix W) const;

  private:
    SparseRows  P;
    std::size_t n_body_nodes = 0;
  };
} // namespace RollingContact

#endif
