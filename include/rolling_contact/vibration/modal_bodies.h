#ifndef rolling_contact_vibration_modal_bodies_h
#define rolling_contact_vibration_modal_bodies_h

#include <rolling_contact/modes/absorbers.h>
#include <rolling_contact/modes/axle_motion.h>
#include <rolling_contact/modes/full_dynamics.h>
#include <rolling_contact/pair/body_pair.h>
#include <rolling_contact/scene/modes_parameters.h>
#include <rolling_contact/scene/pair_spec.h>
#include <rolling_contact/scene/stability_parameters.h>
#include <rolling_contact/vibration/vibrating_body.h>

#include <memory>
#include <utility>

namespace RollingContact
{
  /**
   * What the modes of rolling bodies are damped and turned by, besides what the
   * bodies are made of.
   */
  struct RollingConditions
  {
    RollingConditions() = default;

    RollingConditions(const PairSpec            &scene,
                      const StabilityParameters &stability);

    double speed = 0.; ///< of rolling, m/s; 0: the wheel does not turn
    double added_damping =
      0.; ///< damping ratio that all modes have in addition

    /** True keeps losses that are not viscous apart, as loss stiffness, for
     * answers at given real frequencies. */
    bool hysteretic = false;

    /**
     * Dampers of the wheel, on the circles where they were when the modes were
     * found.
     */
    std::vector<AbsorberRing> absorbers;
  };

  /**
   * The modes of the elastic bodies of a rolling pair, found once, and the
   * matrices of their equations under given conditions. A wheel that is a body
   * of revolution turns under the contact and may have absorbers.
   */
  template <int dim>
  class ModalBodies
  {
  public:
    /**
     * Find the modes up to a frequency (Hz) of @p bodies, which must have kept
     * their factors. Modes of a body that @p earlier has, found under the same
     * conditions, are taken from there. Throws InputError for bodies without
     * factors.
     */
    ModalBodies(const PairSpec         &scene,
                const ModesParameters  &wanted,
                const BodyPair<dim>    &bodies,
                const double            cut_off,
                RunContext             &context,
                const ModalBodies<dim> *earlier = nullptr);

    /** nullptr for a rigid body. */
    const VibratingBody<dim> *body(const Side side) const
    {
      return bodies[side].get();
    }

    /** 0 for a rigid body. */
    std::size_t n_modes(const Side side) const
    {
      return bodies[side] ? bodies[side]->modes.size() : 0;
    }

    /** Unknowns of the reduced equations of a body: its modes, then what
     * absorbers add. 0 for a rigid body. */
    std::size_t n_coordinates(const Side side) const
    {
      return n_modes(side) + hanging[side].n_coordinates() +
             (axle(side) ? axle(side)->size() : 0);
    }

    /** How a body moves with the axle that its hub is fixed to; nullptr if the
     * hub is held. */
    const AxleMotion *axle(const Side side) const
    {
      return axles[side].get();
    }

    /**
     * Conditions of a wheel that does not turn, with the dampers that it had
     * when the modes were found.
     */
    RollingConditions standing() const;

    /** Where absorbers hang on a body. */
    const AbsorberPlaces &absorber_places(const Side side) const
    {
      return hanging[side];
    }

    /** Angular velocity of the wheel, 0 if it does not turn. Units: rad/s. */
    double rate(const Side side, const RollingConditions &conditions) const;

    /**
     * The stiffness and the damping matrix of the coordinates of a body. Units:
     * 1/s^2, 1/s.
     */
    std::pair<DenseMatrix, DenseMatrix>
    modal_matrices(const Side side, const RollingConditions &conditions) const;

    /** The loss stiffness of the coordinates of a body. Units: 1/s^2. */
    DenseMatrix loss_stiffness(const Side side) const;

    /**
     * All unknowns of a body under the same conditions, its hub held. Keeps
     * references to this.
     */
    std::unique_ptr<FullDynamics>
    whole_body(const Side side, const RollingConditions &conditions) const;

  private:
    /**
     * Damping matrix of the modes of one body as it stands, without damping
     * ratios, of all its losses and of the viscous ones alone, its loss
     * stiffness, and the gyroscopic matrices of one that may turn.
     */
    struct Part
    {
      DenseMatrix      C_m, viscous, H_m, S_m;
      SkewSparseMatrix S;
    };

    std::vector<double>
    damping_ratios(const Side side, const RollingConditions &conditions) const;

    /** Without absorbers. */
    std::pair<DenseMatrix, DenseMatrix>
    matrices_of_modes(const Side               side,
                      const RollingConditions &conditions) const;

    /** Find the modes of a body, and what belongs to them. */
    void find(const PairSpec        &scene,
              const Side             side,
              const ModesParameters &wanted,
              const double           cut_off,
              RunContext            &context);

    PerSide<std::shared_ptr<const ElasticBody<dim>>>   owners;
    PerSide<std::shared_ptr<const VibratingBody<dim>>> bodies;
    PerSide<std::shared_ptr<const Part>>               parts;
    PerSide<AbsorberPlaces>                            hanging;
    PerSide<std::shared_ptr<const AxleMotion>>         axles;
  };
} // namespace RollingContact

#endif
