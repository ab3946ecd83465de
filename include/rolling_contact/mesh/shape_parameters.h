#ifndef rolling_contact_mesh_shape_parameters_h
#define rolling_contact_mesh_shape_parameters_h

#include <rolling_contact/mesh/file_mesh.h>
#include <rolling_contact/mesh/placed_profile.h>

#include <memory>
#include <string>

namespace RollingContact
{
  /**
   * What the inner circle, bottom or hub boundary of a body does.
   */
  enum class Hub
  {
    clamped,
    free,    ///< held by inertia alone
    elastic, ///< on springs, pads or sleepers
    mass     ///< fixed to a rigid mass, which is free
  };

  /**
   * Whether nothing but inertia holds a body.
   */
  inline bool is_loose(const Hub hub)
  {
    return hub == Hub::free || hub == Hub::mass;
  }

  /**
   * The part of its radius up to which the profile of a disc or wheel is its
   * circle and may be meshed for a patch; it leaves the circle at 0.5.
   */
  constexpr double usable_rim = 0.55;

  /**
   * What section `Wheel` or `Rail` says of the shape of its body. Every shape
   * takes those of the entries that concern it. Units: m.
   */
  struct ShapeParameters
  {
    /**
     * Throws InputError "section/entry = value: allowed" unless the
     * @p condition holds.
     */
    void require(const bool         condition,
                 const std::string &entry,
                 const double       value,
                 const std::string &allowed) const;

    std::string  section;                ///< Wheel or Rail, for messages
    double       radius          = 0.46; ///< in the rolling direction; 0 flat
    double       lateral_radius  = 0.;   ///< across; 0 flat
    double       hub_radius      = 0.08; ///< of the inner circle of a disc
    double       block_length    = 1.;   ///< in the rolling direction
    double       block_depth     = 0.5;  ///< down to the bottom, the hub
    double       width           = 0.1;  ///< across, 3D only
    double       cover_thickness = 0.;   ///< of the layer on the core; 0 none
    Hub          hub             = Hub::clamped;
    std::string  mesh_file;
    double       mesh_unit        = 1.;
    unsigned int contact_boundary = 1;
    unsigned int hub_boundary     = 2;
    unsigned int cells_along      = 96; ///< of a section, along x
  };

  /**
   * The entries of a shape with what its files hold.
   */
  struct ShapeSpec : public ShapeParameters
  {
    ShapeSpec(const ShapeParameters               &entries,
              std::shared_ptr<const FileMesh>      mesh    = nullptr,
              std::shared_ptr<const PlacedProfile> profile = nullptr)
      : ShapeParameters(entries)
      , mesh(std::move(mesh))
      , profile(std::move(profile))
    {}

    std::shared_ptr<const FileMesh> mesh; ///< what mesh_file holds, or nullptr

    /**
     * Profile in its place on a body with a true section, or with a section
     * from a file; nullptr for other bodies.
     */
    std::shared_ptr<const PlacedProfile> profile;
  };
} // namespace RollingContact

#endif
