#include <rolling_contact/wheelset/bogie_frame.h>
#include <rolling_contact/wheelset/equilibrium.h>

namespace RollingContact
{
  CurveCase BogieFrame::acting_on(const unsigned int     wheelset,
                                  const CurveCase       &acting,
                                  const Eigen::Vector2d &frame) const
  {
    const double s_a = ahead(wheelset);
    return {acting.curvature,
            bogie.hunting.lateral_stiffness *
              (frame[0] + s_a * frame[1] - s_a * s_a * acting.curvature / 2),
            frame[1] - s_a * acting.curvature,
            acting.axle_torque};
  }

  Eigen::Vector2d
  BogieFrame::residual(const CurveCase                  &acting,
                       const Eigen::Vector2d            &frame,
                       const std::vector<WheelsetState> &wheelsets) const
  {
    Eigen::Vector2d left(acting.lateral_force,
                         bogie.frame.yaw_stiffness *
                           (acting.frame_yaw - frame[1]));
    for (unsigned int i = 0; i < wheelsets.size(); ++i)
      {
        left[0] -= wheelsets[i].lateral_force;
        left[1] -=
          ahead(i) * wheelsets[i].lateral_force + wheelsets[i].yaw_moment;
      }
    return left / bogie.axle_load;
  }

  Eigen::Matrix2d BogieFrame::coupling(const unsigned int wheelset,
                                       const double       lateral,
                                       const double       yaw) const
  {
    Eigen::Matrix2d by_frame;
    by_frame << lateral, ahead(wheelset) * lateral, 0., yaw;
    return by_frame;
  }

  Eigen::Matrix2d BogieFrame::own(const double lateral, const double yaw) const
  {
    const double    a      = bogie.ahead_of_frame;
    Eigen::Matrix2d by_own = Eigen::Matrix2d::Zero();
    by_own.diagonal() << -2 * lateral, -2 * (a * a * lateral + yaw);
    return by_own;
  }

  Eigen::Matrix2d BogieFrame::own() const
  {
    Eigen::Matrix2d by_own =
      own(bogie.hunting.lateral_stiffness, bogie.yaw_stiffness);
    by_own(1, 1) -= bogie.frame.yaw_stiffness;
    return by_own;
  }
} // namespace RollingContact
