#ifndef rolling_contact_wheelset_hunting_h
#define rolling_contact_wheelset_hunting_h

#include <Eigen/Dense>

#include <rolling_contact/wheelset/bogie_frame.h>

#include <complex>
#include <optional>
#include <vector>

namespace RollingContact
{
  /**
   * Small motions of a wheelset about its equilibrium: shift y, yaw psi and the
   * axle's speed omega follow
   *
   *   m y'' = dF_y - k y - c y',  I_z psi'' = dM_z - c_psi psi',
   *   I_y omega' = dM_axle,
   *
   * the balances of Equilibrium linear in (y, psi, excess, y'/V, psi'/V) with
   * quasi-steady contacts under loads that stay. Springs and dashpots of a
   * bogie are those between wheelsets and frame, which has shift, yaw, mass and
   * inertia, and between frame and a car body that does not move. Units: SI.
   */
  class Hunting
  {
  public:
    /** Rows: balances over the axle load; columns as above. */
    using Derivatives = Eigen::Matrix<double, 3, 5>;

    /** Derivatives of each wheelset with a frame that stays. */
    Hunting(const WheelsetParameters       &vehicle,
            const std::vector<Derivatives> &derivatives,
            const double                    radius)
      : vehicle(vehicle)
      , derivatives(derivatives)
      , radius(radius)
    {}

    /**
     * Eigenvalues at a speed (m/s), the least damped first. Units: 1/s.
     */
    std::vector<std::complex<double>> eigenvalues(const double speed) const;

    /**
     * The least speed up to @p most (m/s) at which a motion grows; nothing if
     * none does. Found to 1e-6.
     */
    std::optional<double> critical_speed(const double most) const;

    /** Whether the least damped of some eigenvalues grows by more than rounding
     * does, as that of springs without dashpots. */
    static bool grows(const std::vector<std::complex<double>> &eigenvalues);

  private:
    /** Forces by positions, and by velocities. */
    struct Forces
    {
      Eigen::MatrixXd of_places, of_velocities;
    };

    Forces forces(const double speed) const;

    const WheelsetParameters       vehicle;
    const std::vector<Derivatives> derivatives;
    const double                   radius;
  };
} // namespace RollingContact

#endif
