#ifndef rolling_contact_wheelset_running_gear_h
#define rolling_contact_wheelset_running_gear_h

#include <rolling_contact/wheelset/bogie_frame.h>
#include <rolling_contact/wheelset/equilibrium.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * A wheelset, or the two of a bogie, the leading one first, with shift and
   * yaw of its frame (m, rad) and what is left of the frame's balances over the
   * axle load.
   */
  struct RunningState
  {
    CurveCase                  acting;
    std::vector<WheelsetState> wheelsets;
    Eigen::Vector2d            frame      = Eigen::Vector2d::Zero();
    Eigen::Vector2d            frame_left = Eigen::Vector2d::Zero();
  };

  /**
   * The equilibrium of a wheelset or of a bogie. That of a bogie is found by
   * Newton's method on shift and yaw of its frame, with each wheelset balanced
   * at each place of the frame; the derivatives follow from those of the
   * balances of the wheelsets.
   */
  class RunningGear
  {
  public:
    /** See WheelPair. */
    RunningGear(const Situation          &scene,
                const WheelsetParameters &parameters,
                const bool                roughly);

    void swap_sides();

    /** On straight track without forces, in the middle. */
    RunningState at_rest() const;

    /**
     * The balance of the case of @p start from there, which is now() then;
     * false, and now() as it was, where it is not found.
     */
    bool solve(const RunningState &start);

    /**
     * With wheelsets whose shift is bracketed, up to @p farthest (m) from that
     * of the start, where Newton's method does not find it.
     */
    bool bracket(const RunningState &start, const double farthest);

    /** See Equilibrium::polish(). */
    void polish();

    /** The residual of each wheelset that solve() ends with. */
    void ask_for(const double residual)
    {
      for (const auto &one : wheelsets)
        one->balance.enough = residual;
    }

    const RunningState &now() const
    {
      return state;
    }

    /** Go on from a state, with the derivatives of @p other if there is one. */
    void begin_with(const RunningState &from,
                    const RunningGear  *other = nullptr);

    /** Whether no wheel is lifted off its rail by the lateral force. */
    bool carries(const CurveCase &acting);

    Equilibrium &balance(const unsigned int wheelset)
    {
      return wheelsets[wheelset]->balance;
    }

    WheelPair &wheels(const unsigned int wheelset) const
    {
      return wheelsets[wheelset]->pair;
    }

    unsigned int n_wheelsets() const
    {
      return wheelsets.size();
    }

    /**
     * By how much shift, yaw and excess of each wheelset change where its
     * balances are off by one of each over the axle load, by the derivatives of
     * each (rows: balances) with a frame that stays; the frame follows. Nothing
     * if they do not depend on each other.
     */
    std::optional<Eigen::MatrixXd>
    compliance(const std::vector<Eigen::Matrix3d> &derivatives) const;

    unsigned int n_states() const;
    unsigned int n_bodies() const;
    unsigned int n_steps() const;

    /** Why the last solve failed. */
    std::string reason;

  private:
    struct One
    {
      One(const Situation          &scene,
          const WheelsetParameters &parameters,
          const bool                roughly)
        : pair(scene, parameters, roughly)
        , balance(pair, parameters)
      {}

      WheelPair   pair;
      Equilibrium balance;
    };

    /** Balances a wheelset in a case from a start; false if it cannot. */
    using Settle =
      std::function<bool(Equilibrium &, const CurveCase &, WheelsetState)>;

    /** Newton's method on the frame until its balances are closed to @p least.
     */
    bool
    find(const RunningState &start, const Settle &settle, const double least);

    /** The wheelsets of a state balanced where its frame is. */
    bool settle_wheelsets(RunningState &at, const Settle &settle);

    /** The balances of the frame by its shift and yaw, wheelsets following. */
    std::optional<Eigen::Matrix2d> frame_derivatives();

    const WheelsetParameters         &parameters;
    const BogieFrame                  frame;
    const double                      largest_left; ///< of the frame
    std::vector<std::unique_ptr<One>> wheelsets;
    RunningState                      state;
  };
} // namespace RollingContact

#endif
