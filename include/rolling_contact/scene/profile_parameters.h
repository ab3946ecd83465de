#ifndef rolling_contact_scene_profile_parameters_h
#define rolling_contact_scene_profile_parameters_h

#include <rolling_contact/profiles/contact_search.h>
#include <rolling_contact/profiles/profile_file.h>

#include <filesystem>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace RollingContact
{
  /**
   * Sections `Profiles` and `Contact table`: the sections of wheel and rail,
   * where they are, and the shifts of the wheelset. Units: m, rad, 1.
   */
  struct ProfileParameters
  {
    void
    declare(dealii::ParameterHandler &prm);

    /**
     * Throws InputError if a value is out of its range, among them the radius
     * of the wheel, or a file is no profile.
     */
    void
    check(const double                 wheel_radius,
          const std::filesystem::path &prm_folder) const;

    Profiles::ProfileCurve
    wheel(const std::filesystem::path &prm_folder) const;

    /** In its place in the track. */
    Profiles::ProfileCurve
    rail(const std::filesystem::path &prm_folder) const;

    /**
     * Whether a profile is that of a file.
     */
    bool
    has_files() const;

    /**
     * The tape circle's distance from the middle of the wheelset.
     */
    double
    tape_circle() const;

    /** Which axes of a file's points are turned round. */
    enum class Mirror
    {
      none,
      y,
      z,
      y_and_z
    };

    std::string wheel_profile = "S1002";
    std::string rail_profile  = "60E1";
    std::string inclination   = "1/40";
    double      gauge = 1.435, gauge_height = 0.014;
    double      flange_back_distance = 1.36;
    double      yaw                  = 0.;
    double      smoothing_length     = 4e-3;
    double      file_unit            = 1e-3;
    Mirror      wheel_mirror = Mirror::none, rail_mirror = Mirror::none;

    std::vector<double> shifts;
    double              conicity_amplitude = 3e-3;

  private:
    void
    declare_sections(dealii::ParameterHandler &prm);

    void
    declare_track(dealii::ParameterHandler &prm);

    void
    declare_table(dealii::ParameterHandler &prm);

    Profiles::FileOptions
    file_options(const Mirror mirror) const;

    double
    slope_of_inclination() const;
  };
} // namespace RollingContact

#endif
