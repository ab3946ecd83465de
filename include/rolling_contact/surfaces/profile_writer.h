#ifndef rolling_contact_surfaces_profile_writer_h
#define rolling_contact_surfaces_profile_writer_h

#include <rolling_contact/surfaces/profile_file.h>

#include <string>

namespace RollingContact::Profiles
{
  /**
   * The text of a file that read_profile() reads as this curve, in mm to 1e-9
   * mm: within 0.1 um for points 0.1 mm apart if File unit is 1e-3 m and
   * Smoothing length is 0, as comments of the text say. Columns have y and z
   * down as here, MiniProf both the other way, as its reader takes them; a
   * SIMPACK file has its own unit, no mirror, and for a wheel type 1 and
   * descending y, as CONTACT writes them. Points closer than 0.1 um are read as
   * one, and @p title stands in a comment: one line, plain text without ". The
   * keys of MiniProf are those of its reader, unverified with its own program.
   * Throws std::invalid_argument for more points than most_profile_points.
   */
  std::string profile_text(const ProfileCurve &curve,
                           const ProfileKind   kind,
                           const ProfileFormat format,
                           const std::string  &title);
} // namespace RollingContact::Profiles

#endif
