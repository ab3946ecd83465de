#ifndef rolling_contact_vibration_rolling_modes_h
#define rolling_contact_vibration_rolling_modes_h

#include <rolling_contact/pair/rolling_pair.h>
#include <rolling_contact/stability/reduced_pair.h>
#include <rolling_contact/vibration/modal_bodies.h>

namespace RollingContact
{
  /**
   * The modes of two bodies as a contact between them sees them.
   */
  template <int dim>
  class RollingModes
  {
  public:
    /**
     * @p rolling: where @p bodies touch, with its compliance @p W in m/N. Keeps
     * references to the first two. Throws InputError if W is not that of the
     * matrices the modes come from.
     */
    RollingModes(const ModalBodies<dim> &bodies,
                 const RollingPair<dim> &rolling,
                 const DenseMatrix      &W);

    /**
     * What a disturbance of a state under these conditions moves.
     */
    ReducedPair reduced(const RollingConditions &conditions) const;

    /** The column of the first coordinate of a side. */
    std::size_t first_column(const Side side) const;

    /** The mode of a body that has the largest part of its share in a motion,
     * see StabilityMode::participation(), and that share; none of a body
     * without modes. */
    std::optional<std::pair<std::size_t, double>>
    nearest_mode(const Side side, const std::vector<double> &shares) const;

    /** The name of that mode, "0L3": of the wheel, of the rail where the wheel
     * has none; empty where neither has. */
    std::string nearest_name(const std::vector<double> &shares) const;

    /**
     * Static amplitudes of all coordinates under nodal forces, Lambda^-1 Phi^T
     * f of modes, absorbers at rest with them. Units: N to m kg^(1/2).
     */
    std::vector<double>
    static_amplitudes(const std::vector<double> &forces,
                      const RollingConditions   &conditions) const;

    /**
     * The static compliance of the reduced bodies: that of their mesh, @p W,
     * but for modes that others than those of the mesh take the place of, see
     * StructuralModes::statics(). Units: m/N.
     */
    DenseMatrix compliance_at_rest(DenseMatrix W) const;

    /**
     * Load on all coordinates when the wheel's hub accelerates by 1 m/s^2
     * towards the rail and displacements are those relative to it: -Phi^T M e_z
     * of the wheel, 0 of the rail. Units: kg^(1/2).
     */
    std::vector<double> hub_inertia() const;

    /**
     * Displacement of a body by amplitudes of all coordinates, of which those
     * of absorbers move nothing of it; of a body on an axle that moves relative
     * to the axle. Units: m kg^(1/2), m.
     */
    BodyField displacement(const Side                 side,
                           const std::vector<double> &eta) const;

    /** AxleMotion::velocity_along_z() of a wheel whose axle moves, by the rates
     * of all coordinates; none of others. Units: m/s. */
    std::optional<double>
    wheel_velocity(const std::vector<double> &rates) const;

    const ModalBodies<dim> &bodies() const
    {
      return modal;
    }

    const RollingPair<dim> &pair() const
    {
      return rolling;
    }

    /** The motions of the contact nodes of a rail by those of RailWaves, by
     * columns: of the body, numbered as its forces. */
    const DenseMatrix &motions_of_waves(const Side side) const
    {
      return four_motions[side];
    }

    /** Motions of all contact nodes, as the relative motion, by those four. */
    DenseMatrix relative_motions_of_waves(const Side side) const
    {
      return at_contact(side, four_motions[side]);
    }

    /** RailWaves::beyond_mesh() of a rail without ends, less what is known of
     * it at the contact nodes. */
    const DenseMatrix &beyond_mesh(const Side side) const
    {
      return beyond[side];
    }

    /** How the contact nodes belong to vibrations of an elastic body. */
    const ContactVibration &contact_of(const Side side) const
    {
      return *contacts[side];
    }

    /** Motions of the contact nodes, as the relative motion, by those of the
     * axle that a body hangs on. */
    DenseMatrix motions_of_axle(const Side side) const;

  private:
    /**
     * Retardation time of the residual compliance, which is the material's
     * under the contact: the mean of both bodies by the compliances of their
     * half-spaces, (1 - nu^2) / E. Units: s.
     */
    double retardation() const;

    /** The coordinates of a body among all. */
    std::vector<double> part_of(const Side                 side,
                                const std::vector<double> &coordinates) const;

    /** Motions of the contact nodes of a body, by columns, as the relative
     * motion. */
    DenseMatrix at_contact(const Side side, const DenseMatrix &motions) const;

    /** Take the modes of a body of its mesh or its section. */
    void take_modes(const Side side);

    /** Take the modes that stand for the waves of a rail. */
    void take_waves(const Side side);

    DenseMatrix find_motions_of_waves(const Side side) const;

    const ModalBodies<dim> &modal;
    const RollingPair<dim> &rolling;

    PerSide<std::unique_ptr<ContactVibration>> contacts;
    PerSide<DenseMatrix>                       Phi; ///< of the modes of a body
    PerSide<DenseMatrix>                       four_motions, beyond;
    DenseMatrix          more_at_rest; ///< compliance that modes add to W
    PerSide<DenseMatrix> cross; ///< between contact and absorbers, residual
    DenseMatrix          W_res; ///< without absorbers
  };

  /**
   * How whole bodies in contact answer forces that go as exp(s t), by all their
   * unknowns.
   */
  template <int dim>
  class WholeBodies
  {
  public:
    /** Keeps a reference to @p rolling. */
    WholeBodies(const RollingModes<dim> &rolling,
                const RollingConditions &conditions);

    /**
     * Motions of the wheel relative to the rail at the contact nodes under
     * nodal forces, of each s and forces. Units: 1/s, N to m.
     */
    std::vector<ComplexVector>
    response(const ComplexValues              &s,
             const std::vector<ComplexVector> &forces) const;

    /**
     * All unknowns of a body under them; empty ones for a rigid one. Units: m.
     */
    std::vector<ComplexVector>
    motion(const Side                        side,
           const ComplexValues              &s,
           const std::vector<ComplexVector> &forces) const;

    /** Iterations so far, two triangular solves each. */
    unsigned int n_iterations() const;

  private:
    /** What nodal forces of contact move of a body, its unknowns. */
    struct Answer
    {
      std::vector<ComplexVector> forces; ///< on the contact nodes of the body
      std::vector<ComplexVector> x;      ///< relative to the axle
      std::vector<ComplexVector> axle;   ///< d of AxleMotion, if there is one
    };

    /** Let the axle that a body hangs on move, too: with its mass M_R,
     *
     *   D x + s^2 M R d = f,      s^2 R^T M x + s^2 M_R d = R^T f. */
    void move_axle(const Side                        side,
                   const AxleMotion                 &axle,
                   const ComplexValues              &s,
                   const std::vector<ComplexVector> &loads,
                   Answer                           &answer) const;

    /** Nodal forces of contact as those on the nodes of a body. */
    std::vector<ComplexVector>
    forces_on(const Side side, const std::vector<ComplexVector> &forces) const;

    /** What nodal forces of contact move of the nodes of a body. */
    std::vector<ComplexVector>
    answer_of_body(const Side                        side,
                   const ComplexValues              &s,
                   const std::vector<ComplexVector> &forces) const;

    /** All unknowns of the mesh of a rail without ends, as its waves say. */
    std::vector<ComplexVector>
    motion_of_waves(const Side                        side,
                    const ComplexValues              &s,
                    const std::vector<ComplexVector> &forces) const;

    /** What forces on the nodes of a rail without ends move of them. */
    std::vector<ComplexVector>
    answer_of_waves(const Side                        side,
                    const ComplexValues              &s,
                    const std::vector<ComplexVector> &forces) const;

    Answer answer(const Side                        side,
                  const ComplexValues              &s,
                  const std::vector<ComplexVector> &forces) const;

    const RollingModes<dim>               &rolling;
    const double                           added_damping;
    PerSide<std::unique_ptr<FullDynamics>> bodies;
  };
} // namespace RollingContact

#endif
