#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/files.h>
#include <rolling_contact/scene/profile_parameters.h>
#include <rolling_contact/surfaces/nominal_profiles.h>

#include <algorithm>

namespace RollingContact
{
  namespace
  {
    const std::vector<std::string> wheel_names{"S1002"},
      rail_names = Profiles::rail_names();

    bool is_file(const std::string              &profile,
                 const std::vector<std::string> &names)
    {
      return !profile.empty() &&
             std::find(names.begin(), names.end(), profile) == names.end();
    }
  } // namespace

  bool ProfileParameters::wheel_is_file() const
  {
    return is_file(wheel_profile, wheel_names);
  }

  bool ProfileParameters::rail_is_file() const
  {
    return is_file(rail_profile, rail_names);
  }

  Profiles::FileOptions
  ProfileParameters::file_options(const Profiles::ProfileKind kind) const
  {
    const bool   is_wheel = kind == Profiles::ProfileKind::wheel;
    const Mirror mirror   = is_wheel ? wheel_mirror : rail_mirror;
    return {file_unit,
            mirror == Mirror::y || mirror == Mirror::y_and_z,
            mirror == Mirror::z || mirror == Mirror::y_and_z,
            smoothing_length,
            is_wheel ? wheel_profile_shift : 0.};
  }

  namespace
  {
    /**
     * The file of a profile that has none of the names. Throws InputError if
     * there is none, with the names.
     */
    std::filesystem::path
    file_of_profile(const std::string              &entry,
                    const std::string              &profile,
                    const std::vector<std::string> &names,
                    const std::filesystem::path    &prm_folder)
    {
      const std::filesystem::path file = prm_folder / profile;
      std::error_code             failed;
      if (std::filesystem::exists(file, failed))
        return file;
      std::string known;
      for (const std::string &name : names)
        known += (known.empty()            ? ""
                  : &name == &names.back() ? " or "
                                           : ", ") +
                 name;
      throw InputError("Profiles/" + entry + " = " + profile + ": give " +
                       known +
                       ", or the name of a file; there is no such "
                       "file as " +
                       file.string() + ".");
    }
  } // namespace

  Profiles::ProfileCurve
  ProfileParameters::wheel(const std::filesystem::path &prm_folder) const
  {
    return wheel_profile.empty() || wheel_profile == "S1002"
             ? Profiles::s1002()
             : Profiles::read_profile(file_of_profile("Wheel profile",
                                                      wheel_profile,
                                                      wheel_names,
                                                      prm_folder),
                                      Profiles::ProfileKind::wheel,
                                      file_options(
                                        Profiles::ProfileKind::wheel));
  }

  Profiles::ProfileCurve ProfileParameters::nominal_rail() const
  {
    return Profiles::rail_head(
      rail_profile.empty() || rail_is_file() ? "60E1" : rail_profile);
  }

  Profiles::ProfileCurve
  ProfileParameters::rail(const std::filesystem::path &prm_folder) const
  {
    const Profiles::ProfileCurve section =
      rail_is_file()
        ? Profiles::read_profile(file_of_profile("Rail profile",
                                                 rail_profile,
                                                 rail_names,
                                                 prm_folder),
                                 Profiles::ProfileKind::rail,
                                 file_options(Profiles::ProfileKind::rail))
        : nominal_rail();
    return Profiles::placed_rail(section,
                                 slope_of_inclination(),
                                 gauge,
                                 gauge_height);
  }

  Profiles::RadiusDifference ProfileParameters::radius_difference(
    const std::filesystem::path &prm_folder) const
  {
    const std::filesystem::path file    = prm_folder / difference_file;
    const std::string           problem = why_unreadable(file);
    if (!problem.empty())
      throw InputError(
        "Contact table/Rolling radius difference = " + difference_file + ": " +
        file.string() + " cannot be read: " + problem +
        "; give a file of two columns, the shift to the right "
        "and r right - r left.");
    return Profiles::read_radius_difference(file, difference_unit);
  }
} // namespace RollingContact
