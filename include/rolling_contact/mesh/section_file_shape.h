#ifndef rolling_contact_mesh_section_file_shape_h
#define rolling_contact_mesh_section_file_shape_h

#include <rolling_contact/mesh/body_shape.h>
#include <rolling_contact/mesh/swept_mesh.h>

namespace RollingContact
{
  /**
   * A body whose section is a mesh of quadrilaterals from a file: revolved
   * about its axle, which is one Radius behind the contact point, or, with
   * Radius = 0, extruded along x over the Block length. Its coarse cells are
   * the quadrilaterals, between planes of equal angles or distances. Under a
   * profile the file's axes are those of the profile, wherever it touches: the
   * body is the same for all places of the contact.
   */
  class SectionFileShape : public BodyShape
  {
  public:
    using BodyShape::BodyShape;

    void check(const unsigned int dimension, const bool rigid) const override;

    /**
     * Along the running surface of the section, revolved or extruded.
     */
    double height_as_made(const double x, const double y) const override;

    double thickness_below() const override;

    std::optional<Axle> axle() const override;

    std::optional<SectionMesh> section_about_axle() const override;

    std::shared_ptr<const ExtrudedSection> extruded_section() const override;

    double reach_x() const override;

    double reach_y() const override;

    /**
     * In the section, to the next edge that is not of the running surface or is
     * far below its circle; 0 under a profile.
     */
    double distance_to_edge() const override;

    double largest_half_width() const override;

    double line_compression(const References::HertzLine &contact,
                            const double                 young_modulus,
                            const double poisson_ratio) const override;

    bool is_swept() const override
    {
      return true;
    }

    bool has_own_cells() const override
    {
      return true;
    }

    /**
     * Under a profile, along that: see ProfiledSection.
     */
    std::vector<ZoneBox>
    on_surface(const std::vector<ZoneBox> &boxes) const override;

    std::shared_ptr<const SweptMesh>
    equal_cells(const double along, const double across) const override;

  protected:
    std::vector<double> dimensions() const override;

  private:
    bool is_revolved() const
    {
      return parameters.radius > 0.;
    }

    /**
     * The file's quadrilaterals, (y, z) of the body's frame or, revolved, (y,
     * radius). Edges of the contact boundary between points of the profile or,
     * without one, of the circle with the Lateral radius follow it.
     */
    SectionMesh section() const;

    /** Where the section is, at rest and not revolved. */
    SectionPlacement placement() const;
  };
} // namespace RollingContact

#endif
