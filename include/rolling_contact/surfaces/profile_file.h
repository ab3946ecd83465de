#ifndef rolling_contact_surfaces_profile_file_h
#define rolling_contact_surfaces_profile_file_h

#include <rolling_contact/surfaces/profile_curve.h>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace RollingContact::Profiles
{
  /**
   * How the file of a measured profile is to be read.
   */
  struct FileOptions
  {
    double unit     = 1e-3; ///< m, of a number in a file without units
    bool   mirror_y = false, mirror_z = false;
    double smoothing_length = 4e-3; ///< m; 0: none
    double shift_y          = 0.;   ///< m, of the mirrored points
  };

  enum class ProfileKind
  {
    wheel,
    rail
  };

  /**
   * How points stand in a file: columns y and z, SIMPACK (endings prr and prw)
   * or MiniProf (ban and whl).
   */
  enum class ProfileFormat
  {
    columns,
    simpack,
    miniprof
  };

  /**
   * The format of a file by the ending of its name, in any case; columns for
   * all others.
   */
  ProfileFormat format_of(const std::filesystem::path &file);

  /**
   * Largest number of points in a file of a profile.
   */
  constexpr std::size_t most_profile_points = 10'000;

  /**
   * Measured points, as they stand in a file but for its own units, mirrors,
   * shifts and turns. Units: m.
   */
  struct MeasuredPoint
  {
    double y, z;
  };

  /**
   * The rows of a file of two columns of numbers, which are separated by
   * blanks, commas, semicolons or tabs; lines that begin with #, % or ! are
   * comments, and a first line without digits is a heading. Throws InputError,
   * naming file and line, if a line holds anything else; @p columns are what
   * the numbers are, for its message.
   */
  std::vector<std::array<double, 2>>
  read_columns(const std::filesystem::path &file, const std::string &columns);

  /**
   * The points of a file, see format_of(): columns are those of read_columns(),
   * MiniProf has z upwards. Throws InputError, naming file and line.
   */
  std::vector<MeasuredPoint> read_points(const std::filesystem::path &file,
                                         const FileOptions           &options);

  /**
   * The profile of a file, smoothed, from the gauge side to the field side with
   * z down. Throws InputError if the file cannot be read or is not the profile
   * of a wheel or a rail that way up: it says what to do.
   */
  ProfileCurve read_profile(const std::filesystem::path &file,
                            const ProfileKind            kind,
                            const FileOptions           &options);

  /**
   * The numbers of the points, of which each is the first of a side of the
   * polygon through all, where two sides cross; none if the polygon does not
   * cross itself.
   */
  std::optional<std::pair<std::size_t, std::size_t>>
  first_crossing(const std::vector<MeasuredPoint> &points);

  /**
   * The checks and the smoothing of read_profile() on points; @p name is that
   * of messages.
   */
  ProfileCurve profile_of_points(std::vector<MeasuredPoint> points,
                                 const ProfileKind          kind,
                                 const double               smoothing_length,
                                 const std::string         &name);
} // namespace RollingContact::Profiles

#endif
