#ifndef rolling_contact_wheelset_wheelset_parameters_h
#define rolling_contact_wheelset_wheelset_parameters_h

#include <rolling_contact/scene/profile_parameters.h>
#include <rolling_contact/wheelset/hunting_wheelset.h>

#include <optional>
#include <string>
#include <vector>

namespace RollingContact
{
  class Entries;
  struct Reader;

  /**
   * What acts on a wheelset in a curve besides the rails, per unit of its
   * length: curvature, positive to the right (1/m), force of suspension and
   * cant to the right (N), yaw of the frame against the radial direction (rad),
   * and torque that drives it forwards (N m).
   */
  struct CurveCase
  {
    double curvature = 0., lateral_force = 0., frame_yaw = 0., axle_torque = 0.;

    /** The one in the mirror: a curve to the other side. */
    CurveCase mirrored() const
    {
      return {-curvature, -lateral_force, -frame_yaw, axle_torque};
    }

    /** A part of the way from one to another. */
    static CurveCase
    between(const CurveCase &from, const CurveCase &to, const double share);
  };

  /**
   * Section `Wheelset`: a wheelset, or a bogie of two, which stands at the
   * middle of its frame. Units: N, m, N m/rad, rad, N m.
   */
  struct WheelsetParameters
  {
    void declare(Entries &entries);

    /**
     * Throws InputError if a value is out of its range or two contradict each
     * other.
     */
    void check() const;

    /** As of a wheelset in a mirror, but for the profiles of the sides. */
    WheelsetParameters mirrored() const;

    /** Profiles of the left side; @p right: those of the right one. */
    ProfileParameters left_profiles(const ProfileParameters &right) const;

    /** In the order in which they are given; a straight track without. */
    std::vector<CurveCase> cases() const;

    /** Whether the first case goes, or on straight track is pushed, there. */
    bool goes_to_the_left() const;

    unsigned int n_wheelsets() const
    {
      return is_bogie ? 2 : 1;
    }

    /** The leading or trailing one of a bogie; empty for a lone wheelset. */
    std::string name_of(const unsigned int number) const
    {
      return !is_bogie ? "" : number == 0 ? "leading" : "trailing";
    }

    bool                  is_bogie = false;
    std::vector<double>   curve_radii;             ///< positive to the right
    double                axle_load       = 120e3; ///< of a wheelset
    double                lateral_force   = 0.;    ///< to the right
    double                cant_deficiency = 0.;
    double                load_transfer   = 0.; ///< from the left to the right
    double                yaw_stiffness   = 0.;
    double                frame_yaw       = 0.;
    double                ahead_of_frame  = 0.; ///< of the frame's middle
    double                axle_torque     = 0.;
    std::optional<double> rail_stiffness;  ///< lateral, of each; rigid without
    std::optional<double> shift, yaw;      ///< given in place of forces
    bool                  searches = true; ///< for another equilibrium

    /** What hunts about the equilibrium; without mass it is not asked. */
    HuntingWheelset hunting;

    HuntingFrame frame; ///< of a bogie

    std::string           left_wheel_profile, left_rail_profile;
    std::optional<double> left_wheel_radius;

  private:
    void declare_balance(Entries &entries);

    void declare_hunting(Entries &entries, const Reader &reader);

    void declare_bogie(Entries &entries, const Reader &reader);

    void check_bogie() const;

    void declare_left_side(Entries &entries);
  };
} // namespace RollingContact

#endif
