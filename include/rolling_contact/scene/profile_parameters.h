#ifndef rolling_contact_scene_profile_parameters_h
#define rolling_contact_scene_profile_parameters_h

#include <rolling_contact/mesh/placed_profile.h>
#include <rolling_contact/surfaces/conicity.h>
#include <rolling_contact/surfaces/contact_frame.h>
#include <rolling_contact/surfaces/profile_file.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace RollingContact
{
  class Entries;

  /**
   * Sections `Profiles` and `Contact table`: the sections of wheel and rail,
   * where they are, and the shifts of the wheelset. Units: m, rad, rad/s, 1.
   */
  struct ProfileParameters
  {
    void declare(Entries &entries);

    /**
     * Throws InputError if a value is out of its range, among them the radius
     * of the wheel, or a file is no profile.
     */
    void check(const double                 wheel_radius,
               const std::filesystem::path &prm_folder) const;

    /** Throws InputError if a value of `Contact table` is out of its range. */
    void check_table() const;

    /**
     * Whether the surfaces of the bodies are profiles.
     */
    bool in_use() const
    {
      return !wheel_profile.empty() || !rail_profile.empty();
    }

    /**
     * Whether the creepages are those of the wheelset's motion.
     */
    bool gives_creepages() const
    {
      return in_use() && creepage_source == CreepageSource::kinematics;
    }

    /**
     * How the wheelset moves along the track with this speed (m/s).
     */
    Profiles::WheelsetMotion motion(const double speed) const
    {
      return {speed,
              pitch_rate,
              curve_radius ? 1 / *curve_radius : 0.,
              lateral_velocity};
    }

    /**
     * Find the frame of the contact, from files in @p prm_folder. Throws
     * InputError if the wheel is not above the rail.
     */
    std::shared_ptr<const Profiles::ContactFrame>
    find_frame(const double                 wheel_radius,
               const std::filesystem::path &prm_folder) const;

    /**
     * Whether profiles, track and position of the wheelset are those of other
     * entries, and so the frame of the contact of the same wheel.
     */
    bool have_frame_of(const ProfileParameters &other) const;

    Profiles::ProfileCurve wheel(const std::filesystem::path &prm_folder) const;

    /** The tangent of the angle by which a rail is turned inwards. */
    double slope_of_inclination() const;

    /** In its place in the track. */
    Profiles::ProfileCurve rail(const std::filesystem::path &prm_folder) const;

    /**
     * Whether a file gives the difference of the rolling radii, and profiles
     * are not read.
     */
    bool has_radius_difference() const
    {
      return !difference_file.empty();
    }

    /** Throws InputError if the file is none. */
    Profiles::RadiusDifference
    radius_difference(const std::filesystem::path &prm_folder) const;

    /**
     * Whether elastic bodies have the true sections of wheel and rail.
     */
    bool has_true_sections() const
    {
      return in_use() && true_sections;
    }

    using Frame = std::shared_ptr<const Profiles::ContactFrame>;

    /**
     * Whether web and foot under the rail's head are those of a 60E1: not of
     * other rails by name.
     */
    bool has_section_of_60e1() const
    {
      return rail_is_file() || rail_profile.empty() ||
             rail_profile.compare(0, 3, "60E") == 0;
    }

    /**
     * What the bodies of true sections are made of.
     */
    std::shared_ptr<const PlacedProfile> placed_wheel(const Frame &frame) const;

    std::shared_ptr<const PlacedProfile> placed_rail(const Frame &frame) const;

    /**
     * Whether a profile is that of a file, and has no name of its own.
     */
    bool wheel_is_file() const;

    bool rail_is_file() const;

    bool has_files() const
    {
      return wheel_is_file() || rail_is_file();
    }

    /**
     * The tape circle's distance from the middle of the wheelset.
     */
    double tape_circle() const;

    /** Who gives the creepages. */
    enum class CreepageSource
    {
      given,
      kinematics
    };

    /** Which axes of a file's points are turned round. */
    enum class Mirror
    {
      none,
      y,
      z,
      y_and_z
    };

    /** How the file of a profile is read. */
    Profiles::FileOptions file_options(const Profiles::ProfileKind kind) const;

    std::string wheel_profile, rail_profile; ///< none: the shapes of the bodies
    std::string inclination = "1/40";
    double      gauge = 1.435, gauge_height = 0.014;
    double      flange_back_distance = 1.36;
    double      yaw                  = 0.;
    double      smoothing_length     = 4e-3;
    double      file_unit            = 1e-3;
    Mirror      wheel_mirror = Mirror::none, rail_mirror = Mirror::none;
    double      wheel_profile_shift = 0.;

    bool   true_sections = false; ///< of the bodies: else disc and block
    double web_bow       = 0.;

    Profiles::SurfaceKind surface_kind = Profiles::SurfaceKind::plane;
    bool                  is_left      = false;
    double                shift        = 0.;
    std::optional<double> roll; ///< none: both wheels touch
    CreepageSource        creepage_source = CreepageSource::given;
    std::optional<double> pitch_rate;   ///< none: no longitudinal creepage
    std::optional<double> curve_radius; ///< of the track; none: straight
    double                lateral_velocity = 0.;

    std::vector<double> shifts;
    double              conicity_amplitude = 3e-3;
    std::string         difference_file; ///< none: that of the profiles
    double              difference_unit = 1e-3;

  private:
    void declare_sections(Entries &entries);

    void declare_track(Entries &entries);

    void declare_wheelset(Entries &entries);

    void declare_table(Entries &entries);

    /** The head of the rail that is named; of a file, that of a 60E1. */
    Profiles::ProfileCurve nominal_rail() const;
  };

  /**
   * Throws InputError if the radius of a curve is none: below 10 m. Units: m.
   */
  void check_curve_radius(const std::string &entry, const double radius);
} // namespace RollingContact

#endif
