#ifndef rolling_contact_wheelset_equilibrium_h
#define rolling_contact_wheelset_equilibrium_h

#include <Eigen/Dense>

#include <rolling_contact/wheelset/hunting.h>
#include <rolling_contact/wheelset/wheel_pair.h>

#include <optional>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * A wheelset in a case of curve and suspension, not necessarily in balance.
   */
  struct WheelsetState
  {
    CurveCase     acting; ///< the lateral force found where the shift is given
    WheelsetPlace place;
    double        lateral_force = 0., yaw_moment = 0.; ///< that hold it, N, N m
    BothWheels    wheels;

    /**
     * What is left of the balances over the axle load, moments per metre: of
     * the lateral forces, of the moments about the vertical through the middle
     * of the wheelset, of the torques about the axle, and of what presses the
     * rails apart against their springs.
     */
    Eigen::Vector4d residual = Eigen::Vector4d::Constant(1.);

    double largest_residual() const
    {
      return residual.lpNorm<Eigen::Infinity>();
    }

    WheelsetState mirrored() const;
  };

  /**
   * The equilibrium of a wheelset: shift, yaw and angular velocity of the axle
   * (or, where shift or yaw are given, the lateral force and the yaw moment)
   * for which
   *
   *   sum F_y + H = 0,
   *   sum M_z + K (alpha - yaw) = 0 about the middle of the wheelset,
   *   sum M_axle - T = 0,
   *
   * under wheel loads from statics, Q = W/2 +- (r0 H / (2 e) + load transfer).
   * Rails on lateral springs k give way by H / (2 k) +- w, where the fourth
   * unknown w follows from (F_y,right - F_y,left) / 2 + k w = 0.
   * Newton's method with derivatives by differences and Broyden's updates;
   * where it fails, on flanges above all, the shift is bracketed with the other
   * two balanced at each shift.
   */
  class Equilibrium
  {
  public:
    Equilibrium(WheelPair &pair, const WheelsetParameters &wheelset);

    /**
     * The balance of a case from a start near it, which is now() then; false,
     * and now() as it was, where it is not found.
     */
    bool solve(const CurveCase &acting, const WheelsetState &start);

    /**
     * Find the equilibrium by bracketing the shift, from the shift of the start
     * up to @p farthest (m) away.
     */
    bool bracket(const CurveCase     &acting,
                 const WheelsetState &start,
                 const double         farthest);

    /**
     * Make the residual of now() as small as it gets with edges of stick zones
     * that are held; false, and now() as it was, where it does not get smaller
     * than 1e-8.
     */
    bool polish();

    const WheelsetState &now() const
    {
      return state;
    }

    /** Derivatives of scaled unknowns, as far as they are known. */
    using Derivatives = std::optional<Eigen::Matrix4d>;

    const Derivatives &derivatives() const
    {
      return jacobian;
    }

    /**
     * The residual of now() by shift, yaw and excess, from its steps or else by
     * differences, with rails that follow; nothing where a state beside it is
     * not found. Units: 1/m, 1.
     */
    std::optional<Eigen::Matrix3d> slopes();

    void begin_with(const WheelsetState &other,
                    const Derivatives   &derivatives = {})
    {
      state    = other;
      jacobian = derivatives;
    }

    /**
     * The residual by shift, yaw and excess, and where they are asked for by
     * velocity to the right and turn about the vertical over V, 0 else; by
     * central differences with edges of stick zones held, rails following.
     * Nothing where a state is not found, or shift or yaw are given. Units:
     * 1/m, 1, 1, 1, m.
     */
    std::optional<Hunting::Derivatives>
    motion_derivatives(const bool with_velocities);

    /**
     * The loads of both wheels under a lateral force (N); nothing, and the
     * reason, if one is lifted off its rail.
     */
    std::optional<std::array<double, 2>> loads_under(const double force);

    /** Nothing but friction turns it. */
    bool is_free() const
    {
      return wheelset.yaw_stiffness == 0. && !wheelset.yaw;
    }

    /** Why the last solve failed. */
    std::string reason;

    /** Largest residual of an equilibrium. */
    static constexpr double tolerance = 1e-5;

    /** Largest residual that will do where forces jump, as they do from one set
     * of bodies to another, if it is above `enough`. */
    double accepted = tolerance;

    /** Largest residual that solve() and bracket() ask for, over the axle load.
     */
    double enough = tolerance;

    unsigned int n_steps = 0; ///< of Newton's method

  private:
    /** Which of the balances and unknowns take part. */
    using Active = std::vector<unsigned int>;

    using Unknowns = Eigen::Vector4d;

    Unknowns unknowns_of(const WheelsetState &state) const;

    /** The balances that take part, with or without that of lateral forces. */
    Active all(const bool with_shift = true) const;

    /** Nothing if a wheel has no state there. @p aside: see WheelsetPlace. */
    std::optional<WheelsetState> evaluate(const CurveCase &acting,
                                          const Unknowns  &x,
                                          const double     aside = 0.);

    bool differences(const CurveCase     &acting,
                     const Active        &active,
                     const WheelsetState &at,
                     const double         size);

    /** Newton's method on the active ones. */
    std::optional<WheelsetState> newton(const CurveCase     &acting,
                                        const Active        &active,
                                        const WheelsetState &start,
                                        const double         least,
                                        const unsigned int   most_steps);

    /** With edges of stick zones held where that fails. */
    std::optional<WheelsetState> newton_or_held(const CurveCase     &acting,
                                                const Active        &active,
                                                const WheelsetState &start,
                                                const double         least);

  public:
    /**
     * Yaw and spin speed balanced at a shift (m); nothing if they are not.
     */
    std::optional<WheelsetState> at_shift(const CurveCase     &acting,
                                          const double         shift,
                                          const WheelsetState &start);

  private:
    WheelPair                &pair;
    const WheelsetParameters &wheelset;
    const double              lateral_stiffness; ///< between it and a frame
    const double              rail_stiffness;    ///< lateral; 0: rigid rails
    const Unknowns            scales, limits;
    WheelsetState             state;
    Derivatives               jacobian;

    std::optional<WheelsetState> closest; ///< that Newton's method came to
  };
} // namespace RollingContact

#endif
