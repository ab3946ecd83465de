#ifndef rolling_contact_modes_axle_motion_h
#define rolling_contact_modes_axle_motion_h

#include <rolling_contact/bodies/direct_body.h>
#include <rolling_contact/modes/body_places.h>

#include <array>

namespace RollingContact
{
  /**
   * A body whose hub is fixed to a free rigid mass, by its modes with the hub
   * held: u = Phi eta + R d (Craig and Bampton), R the motions of the whole as
   * a rigid body, three of them in 2D and six in 3D, which need no force at
   * rest. With P = Phi^T M R and M_R = R^T M R + the mass of the axle,
   *
   *   [ 1    P  ] [eta'']   [ C_m  0 ] [eta']   [ K_m  0 ] [eta]
   *   [ P^T  M_R] [d''  ] + [ 0    0 ] [d'  ] + [ 0    0 ] [d  ]
   *
   * is brought to unit mass by d = r z and eta = q - P r z, r r^T = (M_R - P^T
   * P)^-1. What the modes leave out moves with the hub as a rigid body; the
   * turning of the axle by itself makes no gyroscopic moment here.
   */
  class AxleMotion
  {
  public:
    /**
     * Modes of @p body, by columns of @p shapes, with its hub clamped; @p axis:
     * the direction of the axle. Throws InputError if the mass of body and axle
     * does not fit the modes.
     */
    template <int dim>
    AxleMotion(const DirectBody<dim>       &body,
               const BodyPlaces            &places,
               const HubMass               &axle,
               const std::array<double, 3> &axis,
               const DenseMatrix           &shapes);

    /** Motions z. */
    std::size_t size() const
    {
      return unit.cols();
    }

    /** R by columns, of the unknowns; 1, and 1 rad/m for turns. */
    const DenseMatrix &motions() const
    {
      return fields;
    }

    /** Join the motions z to the stiffness or damping of the modes. */
    void join(DenseMatrix &matrix) const;

    /** Join what the motions z move, from what the modes and R move. */
    void join(DenseMatrix &shapes, const DenseMatrix &of_motions) const;

    /** Amplitudes eta of the modes, the motion relative to the axle, by those
     * of a body's coordinates, q before z: eta = q - P r z. */
    std::vector<double>
    relative_to_axle(const std::vector<double> &coordinates) const;

    /**
     * Velocity along z of the centre of mass of body and axle by the rates of a
     * body's coordinates, q before z: (P_z eta' + M_R,z d') / M_R,zz. Units:
     * m/s.
     */
    double velocity_along_z(const std::vector<double> &rates) const;

    /** M_R. Units: kg. */
    const DenseMatrix &mass() const
    {
      return rigid;
    }

    /** r. Units: 1/kg^(1/2). */
    const DenseMatrix &scales() const
    {
      return unit;
    }

  private:
    DenseMatrix         fields;      ///< n x q
    DenseMatrix         rigid;       ///< q x q
    DenseMatrix         unit;        ///< q x q
    DenseMatrix         held;        ///< P r, m x q
    std::vector<double> coupling_z;  ///< P of the translation along z, m values
    Eigen::Index        along_z = 0; ///< which of the motions that is
  };
} // namespace RollingContact

#endif
