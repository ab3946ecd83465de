#ifndef rolling_contact_analyses_rolling_modes_h
#define rolling_contact_analyses_rolling_modes_h

#include <rolling_contact/analyses/vibrating_body.h>
#include <rolling_contact/modes/full_dynamics.h>
#include <rolling_contact/stability/reduced_pair.h>
#include <rolling_contact/state/steady_state.h>

#include <array>
#include <memory>

namespace RollingContact
{
  /**
   * The bodies of a steady rolling state by their modes, as its contact sees
   * them: what a disturbance of the state moves, reduced and in full. A wheel
   * that is a body of revolution turns under the contact.
   */
  template <int dim>
  class RollingModes
  {
  public:
    /**
     * Find the modes up to a frequency (Hz) of the bodies of @p steady, which
     * must outlive this and have kept their factors.
     */
    RollingModes(const SceneParameters  &scene,
                 const SteadyState<dim> &steady,
                 const double            cut_off,
                 RunContext             &context);

    const ReducedPair &
    reduced() const
    {
      return pair;
    }

    /**
     * Motion of the wheel relative to the rail at the contact nodes under nodal
     * forces that go as exp(s t), by all unknowns of both bodies. Units: 1/s, N
     * to m.
     */
    ComplexVector
    response(const std::complex<double> s, const ComplexVector &forces) const;

    /** Iterations of response() so far, two triangular solves each. */
    unsigned int
    n_iterations() const;

    /** The side and the number of a column of the reduced pair. */
    std::pair<Side, std::size_t>
    mode_of(const std::size_t column) const;

    /** nullptr for a rigid body. */
    const VibratingBody<dim> *
    body(const Side side) const
    {
      return bodies[side].get();
    }

    /** Angular velocity of the wheel, 0 if it does not turn. Units: rad/s. */
    double
    rate_of_wheel() const
    {
      return rate;
    }

  private:
    /** A body alone: matrices of its modes, and the whole of it. */
    struct Part
    {
      std::vector<std::size_t>      unknowns; ///< of contact
      std::vector<double>           damping_ratios;
      SymmetricSparseMatrix         C;
      SkewSparseMatrix              S;
      DenseMatrix                   K_m, C_m;
      std::unique_ptr<FullDynamics> full;
    };

    void
    add_part(const SceneParameters &scene, const Side side);

    void
    join(const DenseMatrix &W);

    /** The motion of the contact by a mode, relative to the other body. */
    std::vector<double>
    contact_motion(const Side side, const std::size_t mode) const;

    const RollingPair<dim>                      &rolling;
    PerSide<std::unique_ptr<VibratingBody<dim>>> bodies;
    PerSide<Part>                                parts;
    double                                       rate = 0.;
    ReducedPair                                  pair;
  };
} // namespace RollingContact

#endif
