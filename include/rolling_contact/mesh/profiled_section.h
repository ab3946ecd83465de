#ifndef rolling_contact_mesh_profiled_section_h
#define rolling_contact_mesh_profiled_section_h

#include <rolling_contact/mesh/placed_profile.h>
#include <rolling_contact/mesh/zone_box.h>

#include <array>
#include <vector>

namespace RollingContact
{
  /**
   * The profile over a section from a file, in the file's axes: across, from
   * the gauge side to the field side, and out of the body; the origin is the
   * wheel's point of the tape circle or the middle of the top of a new rail
   * that is not inclined. Points of the profile are given by the length along
   * it from the one nearest to the origin, positive towards the field side.
   * Units: m.
   */
  class ProfiledSection
  {
  public:
    /** Across and out of the body. */
    using Point = std::array<double, 2>;

    /** Vertices of a file nearer to the profile than this are put on it. */
    static constexpr double largest_offset = 5e-5;

    ProfiledSection(const PlacedProfile &placed, const bool is_wheel);

    /**
     * Where the profile is nearest to a point, as a length, and how far that is
     * away.
     */
    struct Foot
    {
      double along, distance;
    };

    Foot nearest(const Point &point) const;

    Point at(const double along) const;

    /**
     * Unit tangent there, towards the field side.
     */
    Point tangent(const double along) const;

    /**
     * Where the contact's origin is.
     */
    double contact() const;

    /**
     * The coordinate across the surface of contact, as on the right-hand side,
     * at a length along the profile; beyond where it is known, by length.
     */
    double coordinate(const double along) const;

    /**
     * A box of the surface of contact, of the side of the track that this is
     * on, as one over the profile: x, and the length along it, mirrored on the
     * left.
     */
    ZoneBox on_profile(const ZoneBox &box) const;

  private:
    double along(const double coordinate) const;

    PlacedProfile         placed;
    double                outwards; ///< of the profile's z: 1 or -1
    double                origin;   ///< its arc length
    std::array<double, 2> known;    ///< coordinates
  };

  /**
   * Move a point of the contact boundary (across, outwards) to the profile if
   * that is nearer than ProfiledSection::largest_offset; heights are over
   * @p top. Units: m.
   */
  void put_on_profile(const ProfiledSection &profile,
                      const double           top,
                      SectionPoint          &point);

  /**
   * Let the edges of a section's contact boundary whose ends are on the profile
   * follow it, and give the quadrilaterals their places in the chart: the
   * length along the profile and the depth under it. Heights are over @p top.
   * Units: m.
   */
  void follow_profile(const ProfiledSection &profile,
                      const double           top,
                      SectionMesh           &section);
} // namespace RollingContact

#endif
