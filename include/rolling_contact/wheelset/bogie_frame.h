#ifndef rolling_contact_wheelset_bogie_frame_h
#define rolling_contact_wheelset_bogie_frame_h

#include <Eigen/Dense>

#include <rolling_contact/wheelset/wheelset_parameters.h>

#include <vector>

namespace RollingContact
{
  struct WheelsetState;

  /**
   * The frame of a bogie between two wheelsets, 0 the leading one at s = 1 and
   * 1 the trailing one at s = -1, half a wheelbase a from its middle. With its
   * shift y_f and yaw psi_f against track and radial direction there, in a
   * curve kappa the suspension holds the wheelsets by
   *
   *   H_i = k (y_f + s a psi_f - a^2 kappa/2 - y_i),
   *   M_i = K (psi_f - s a kappa - psi_i),
   *
   * and the frame is in balance where
   *
   *   H - sum H_i = 0,  K_s (psi_body - psi_f) - sum (s a H_i + M_i) = 0.
   *
   * Units: m, rad, N, N m.
   */
  class BogieFrame
  {
  public:
    explicit BogieFrame(const WheelsetParameters &bogie)
      : bogie(bogie)
    {}

    /** What acts on a wheelset that has no shift, with the frame there. */
    CurveCase acting_on(const unsigned int     wheelset,
                        const CurveCase       &acting,
                        const Eigen::Vector2d &frame) const;

    /** What is left of the balances of the frame over the axle load. */
    Eigen::Vector2d residual(const CurveCase                  &acting,
                             const Eigen::Vector2d            &frame,
                             const std::vector<WheelsetState> &wheelsets) const;

    /**
     * Force and moment on a wheelset by shift and yaw of the frame, and,
     * transposed, those on the frame by shift and yaw of the wheelset, of
     * springs or dashpots that are lateral and in yaw.
     */
    Eigen::Matrix2d coupling(const unsigned int wheelset,
                             const double       lateral,
                             const double       yaw) const;

    Eigen::Matrix2d coupling(const unsigned int wheelset) const
    {
      return coupling(wheelset,
                      bogie.hunting.lateral_stiffness,
                      bogie.yaw_stiffness);
    }

    /** Force and moment on the frame by its own shift and yaw. */
    Eigen::Matrix2d own(const double lateral, const double yaw) const;

    /** With the moment of the car body. */
    Eigen::Matrix2d own() const;

  private:
    double ahead(const unsigned int wheelset) const
    {
      return wheelset == 0 ? bogie.ahead_of_frame : -bogie.ahead_of_frame;
    }

    const WheelsetParameters &bogie;
  };
} // namespace RollingContact

#endif
