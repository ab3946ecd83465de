#ifndef rolling_contact_contact_surface_coupling_h
#define rolling_contact_contact_surface_coupling_h

#include <rolling_contact/algebra/sparse_rows.h>

#include <utility>

namespace RollingContact
{
  /**
   * How a body's contact nodes hang together with the nodes of the interface:
   * they are the same, or values go over by P (see MortarProjection) and nodal
   * forces back by P^T; and on a curved surface the components of the interface
   * are those along the tangents and normals of its nodes. Values are given
   * component by component.
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

    /**
     * Whether nodes are the same.
     */
    bool is_identity() const
    {
      return n_body_nodes == 0;
    }

    /**
     * From now on, let the last two of three components on the interface be
     * those along the tangent across, (cos, - sin) of the angle of a node in
     * the body's (y, z), and along its normal (sin, cos). Units: rad.
     */
    void turn(std::vector<double> node_angles)
    {
      angles = std::move(node_angles);
    }

    /**
     * Nodal values P u on the interface from those on the body.
     */
    std::vector<double> to_interface(std::vector<double> body_values) const;

    /**
     * Nodal forces P^T r on the body from those on the interface. Units: N.
     */
    std::vector<double> to_body(std::vector<double> interface_forces) const;

    /**
     * P; without rows if nodes are the same.
     */
    const SparseRows &projection() const
    {
      return P;
    }

    /**
     * Compliance P W P^T on the interface from a body's W, symmetric. Units:
     * m/N.
     */
    DenseMatrix to_interface(DenseMatrix W) const;

    /**
     * P W P^T in the components of the interface.
     */
    DenseMatrix turned(DenseMatrix W) const;

  private:
    /**
     * Turn the values of two components, of one node after the other @p stride
     * apart, from axes of the body to those of the nodes, or backwards.
     */
    void turn_values(double           *across,
                     double           *normal,
                     const std::size_t stride,
                     const bool        backwards) const;

    DenseMatrix projected(const DenseMatrix &W) const;

    SparseRows          P;
    std::size_t         n_body_nodes = 0;
    std::vector<double> angles; ///< empty: axes of the body
  };
} // namespace RollingContact

#endif
