#ifndef rolling_contact_mesh_placed_profile_h
#define rolling_contact_mesh_placed_profile_h

#include <rolling_contact/mesh/section_mesh.h>
#include <rolling_contact/surfaces/outline.h>
#include <rolling_contact/surfaces/profile_curve.h>

#include <functional>
#include <optional>

namespace RollingContact
{
  /**
   * The profile of a wheel or a rail in the axes of its own section, and where
   * its points are on the surface of contact: what a body with a true section
   * is made of. As on the right-hand side; the left-hand side is its mirror
   * image. Units: m, rad.
   */
  struct PlacedProfile
  {
    /** Across and down: z from a 60E1's crown, or growth of the wheel's radius.
     */
    Profiles::ProfileCurve profile;

    /**
     * Arc length on the profile at a coordinate across the surface of contact,
     * where there is one; ascends.
     */
    std::function<std::optional<double>(double)> arc_length;

    double turn    = 0.; ///< of the section's axes against those of the body
    double radius  = 0.; ///< at the tape circle, of a wheel
    double bow     = 0.; ///< of a wheel's web
    bool   is_left = false;
  };

  /**
   * The running surface of a section by the coordinate across the surface of
   * contact, 0 at the contact: over the profile as PlacedProfile::arc_length
   * has it, beyond that by length, and past the profile's ends along lines.
   * Units: m.
   */
  class RunningSurface
  {
  public:
    /**
     * The profile between two of its arc lengths, with lines from there on
     * (across, down), each from its end of the profile outwards.
     */
    RunningSurface(const PlacedProfile                         &placed,
                   const std::array<double, 2>                 &ends,
                   const std::vector<Profiles::Outline::Point> &before,
                   const std::vector<Profiles::Outline::Point> &after);

    /**
     * Across and down.
     */
    Profiles::Outline::Point at(const double coordinate) const;

    /** First and last coordinate. */
    std::array<double, 2> ends() const;

    /**
     * Coordinates between which nodes face those of the other body.
     */
    std::array<double, 2> facing() const
    {
      return known;
    }

    /**
     * The coordinate at which it is nearest to a point (across, down).
     */
    double nearest(const Profiles::Outline::Point &point) const;

  private:
    double arc(const double coordinate) const;

    double coordinate(const double arc) const;

    PlacedProfile         placed;
    std::array<double, 2> profile_ends, known, known_arcs;
    /// of lines beyond the profile
    std::vector<Profiles::Outline> before, after;
  };

  /**
   * Arc lengths of the profile over its contact, and where the known
   * coordinates end: where the profile does, where the wheel has no facing
   * point, or where the surface is steeper than 60 degrees against them.
   */
  std::array<double, 2> facing_coordinates(const PlacedProfile &placed);
} // namespace RollingContact

#endif
