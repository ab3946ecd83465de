#ifndef rolling_contact_mesh_section_shapes_h
#define rolling_contact_mesh_section_shapes_h

#include <rolling_contact/mesh/body_shape.h>
#include <rolling_contact/mesh/placed_profile.h>
#include <rolling_contact/mesh/swept_mesh.h>

namespace RollingContact
{
  /**
   * A body with a true section under a profile, ShapeSpec::profile.
   */
  class SectionShape : public BodyShape
  {
  public:
    double surface_height(const double x, const double y) const override;

    double thickness_below() const override;

    double reach_y() const override;

    /**
     * Where nodes face those of the other body.
     */
    std::array<double, 2> room_across() const override;

    /**
     * Distance to where the running surface is steep, as the corner of a rail
     * or the root of a flange, or ends.
     */
    double distance_to_edge() const override;

    bool is_swept() const override
    {
      return true;
    }

    std::shared_ptr<const SweptMesh>
    swept_mesh(const CoarseCells &along,
               const CoarseCells &across,
               const double       deepest) const override;

    std::shared_ptr<const SweptMesh>
    equal_cells(const double along, const double across) const override;

  protected:
    SectionShape(const ShapeSpec &parameters, const RunningSurface &surface);

    std::vector<double> dimensions() const override;

    /**
     * The section with cells under its surface as long as @p across, or
     * shorter where those would be folded. Throws InputError if all are.
     */
    SectionMesh unfolded_section(const double across) const;

    /**
     * The section's coarse quadrilaterals, under the running surface at most so
     * deep.
     */
    virtual SectionMesh section(const CoarseCells &across,
                                const double       deepest) const = 0;

    /**
     * Where the section is in the body's frame, and the ends of coarse cells
     * along x from the contact.
     */
    virtual std::pair<SectionPlacement, std::vector<double>>
    sweep(const CoarseCells &along) const = 0;

    /**
     * A point of the running surface as one of section().
     */
    virtual SectionPoint surface_point(const double coordinate) const = 0;

    const PlacedProfile &placed;
    const RunningSurface surface;
  };

  /**
   * A rail: a head with this profile, web and foot of a 60E1, as long as the
   * block in its place, held at its sole.
   */
  class RailShape : public SectionShape
  {
  public:
    explicit RailShape(const ShapeSpec &parameters);

    void check(const unsigned int dimension, const bool rigid) const override;

    std::shared_ptr<const ExtrudedSection> extruded_section() const override;

    double reach_x() const override;

    double largest_coarse_size() const override;

  protected:
    SectionMesh section(const CoarseCells &across,
                        const double       deepest) const override;

    std::pair<SectionPlacement, std::vector<double>>
    sweep(const CoarseCells &along) const override;

    SectionPoint surface_point(const double coordinate) const override;
  };

  /**
   * A wheel: rim, web and hub under this profile, held at its bore.
   */
  class WheelShape : public SectionShape
  {
  public:
    explicit WheelShape(const ShapeSpec &parameters);

    void check(const unsigned int dimension, const bool rigid) const override;

    double thickness_below() const override;

    std::optional<Axle> axle() const override;

    std::optional<SectionMesh> section_about_axle() const override;

    double reach_x() const override;

    double largest_half_width() const override;

    double largest_coarse_size() const override;

  protected:
    SectionMesh section(const CoarseCells &across,
                        const double       deepest) const override;

    std::pair<SectionPlacement, std::vector<double>>
    sweep(const CoarseCells &along) const override;

    SectionPoint surface_point(const double coordinate) const override;
  };
} // namespace RollingContact

#endif
