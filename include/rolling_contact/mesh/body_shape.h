#ifndef rolling_contact_mesh_body_shape_h
#define rolling_contact_mesh_body_shape_h

#include <rolling_contact/mesh/section_mesh.h>
#include <rolling_contact/mesh/shape_parameters.h>
#include <rolling_contact/mesh/surface_chart.h>
#include <rolling_contact/mesh/zone_box.h>
#include <rolling_contact/references/clamped_annulus.h>
#include <rolling_contact/references/hertz_line.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace RollingContact
{
  class SweptMesh;
  struct ExtrudedSection;

  /**
   * The axis that a body of revolution has, in the body's frame: a point on it
   * and its direction, of length 1. Units: m.
   */
  struct Axle
  {
    std::array<double, 3> point, direction;
  };

  /**
   * Shape of one body in its own frame: the contact point is the origin, z
   * points out of the body; the wheel is its mirror image in z. A shape is
   * either meshed by the program, as boxes in its chart() or as a section that
   * is swept, or brings its mesh(). A new one is a class of its own and, unless
   * it is that of a body with a profile, a row in body_shape_kinds().
   * Units: m.
   */
  class BodyShape
  {
  public:
    explicit BodyShape(const ShapeSpec &parameters);

    virtual ~BodyShape() = default;

    /**
     * Rules for the entries of this shape; a rigid body is a surface only.
     * Throws InputError.
     */
    virtual void check(const unsigned int dimension,
                       const bool         rigid) const = 0;

    /**
     * Height of the undeformed surface at (@p x, @p y), 0 at the contact point
     * and negative where the surface falls away: two circular profiles unless a
     * shape says otherwise.
     */
    virtual double surface_height(const double x, const double y) const;

    /**
     * Height of the surface that the body is made with, which is another one
     * where a file leaves the profiles, as beside a crown.
     */
    virtual double height_as_made(const double x, const double y) const
    {
      return surface_height(x, y);
    }

    /**
     * Thickness of material under the contact point.
     */
    virtual double thickness_below() const = 0;

    /**
     * Thickness of the cover under the contact point, a part of that of the
     * material: where the chart's depth is less, cells are of the cover. 0
     * without a cover.
     */
    double cover_thickness() const
    {
      return parameters.cover_thickness;
    }

    /**
     * How far from the contact point the contact zone may reach along x.
     */
    virtual double reach_x() const = 0;

    /**
     * How far from the contact point the contact zone may reach across.
     */
    virtual double reach_y() const;

    /**
     * Between which coordinates across the contact zone may lie: as far as
     * reach_y() to both sides unless a shape says otherwise.
     */
    virtual std::array<double, 2> room_across() const;

    /**
     * Distance from the contact point to the next edge or to what holds the
     * body: so far it is a half-space but for the curvature of its surface. 0
     * for shapes that do not know.
     */
    virtual double distance_to_edge() const;

    /**
     * Largest half-width of a patch that line_compression() is asked for.
     */
    virtual double largest_half_width() const;

    /**
     * Approximate compression between the middle of the patch of a line contact
     * and the place where the body is held: that of a layer of
     * thickness_below() unless a shape says otherwise. E in Pa.
     */
    virtual double line_compression(const References::HertzLine &contact,
                                    const double                 young_modulus,
                                    const double poisson_ratio) const;

    /**
     * The clamped annulus that this body is, whose exact compression is known;
     * nothing for other shapes. E in Pa.
     */
    virtual std::optional<References::Annulus>
    clamped_annulus(const double young_modulus,
                    const double poisson_ratio) const;

    /**
     * The axis that the body is revolved about; nothing for other bodies.
     */
    virtual std::optional<Axle> axle() const;

    /**
     * The section of a body of revolution: along axle() from its point, and the
     * distance from it, with curved edges and the hub; nothing for other
     * bodies. Units: m.
     */
    virtual std::optional<SectionMesh> section_about_axle() const;

    /**
     * The section of a body that is extruded along x; nullptr for other bodies.
     */
    virtual std::shared_ptr<const ExtrudedSection> extruded_section() const;

    /**
     * Largest coarse cell along x that still resolves the shape.
     */
    virtual double largest_coarse_size() const;

    /**
     * The chart with these coarse cells, which refers to this shape; nullptr
     * for one that is swept or has a mesh().
     */
    virtual std::unique_ptr<SurfaceChart> chart(const CoarseCells &cells) const;

    /**
     * Whether swept_mesh() has its coarse cells.
     */
    virtual bool is_swept() const;

    /**
     * The coarse cells of a swept section with these sizes along x and across,
     * under its running surface at most so deep; nullptr for other shapes, and
     * if cells of these sizes would be too distorted.
     */
    virtual std::shared_ptr<const SweptMesh>
    swept_mesh(const CoarseCells &along,
               const CoarseCells &across,
               const double       deepest) const;

    /**
     * Whether its coarse cells are its own and do not depend on the zone of
     * contact nodes, so that none of those is on its surface.
     */
    virtual bool has_own_cells() const;

    /**
     * Boxes of the surface of contact as boxes of x and the coordinate across
     * of the coarse cells: the same unless a shape says otherwise.
     */
    virtual std::vector<ZoneBox>
    on_surface(const std::vector<ZoneBox> &boxes) const;

    /**
     * Whether it is that of the wheel.
     */
    bool is_of_wheel() const
    {
      return parameters.section == "Wheel";
    }

    /**
     * The cells of a swept section, all along alike, none longer than @p along
     * and, in the section, than @p across; nullptr for other shapes. Units: m.
     */
    virtual std::shared_ptr<const SweptMesh>
    equal_cells(const double along, const double across) const;

    /**
     * The mesh that the shape brings; nullptr if the program meshes it.
     */
    virtual std::shared_ptr<const FileMesh> mesh() const;

    bool hub_clamped() const
    {
      return hub() == Hub::clamped;
    }

    Hub hub() const
    {
      return parameters.hub;
    }

    /**
     * True for mirror images of each other, which share one mesh. Bodies that
     * bring their meshes or are swept never do.
     */
    bool is_twin_of(const BodyShape &other) const;

    /**
     * Whether the program meshes both alike.
     */
    bool is_same_as(const BodyShape &other) const;

  protected:
    /**
     * Whatever makes two bodies of this class differ, in any order.
     */
    virtual std::vector<double> dimensions() const = 0;

    /**
     * Throws InputError if the body has no width (3D) or its profile falls too
     * far at its ends, @p end_x along x.
     */
    void check_extent(const unsigned int dimension, const double end_x) const;

    const ShapeSpec parameters;
  };

  /**
   * A shape as Wheel/Shape, Rail/Shape and --print-parameters know it.
   */
  struct BodyShapeKind
  {
    using Maker =
      std::shared_ptr<const BodyShape> (*)(const ShapeSpec &parameters);

    std::string name;
    std::string help; ///< how it is held
    Maker       make;
    bool        from_file  = false; ///< needs ShapeSpec::mesh
    bool        is_section = false; ///< which is that of a section
  };

  const std::vector<BodyShapeKind> &body_shape_kinds();

  /**
   * The sentence about all kinds, for the list of parameters.
   */
  std::string body_shape_help();

  /**
   * The shape of a name in body_shape_kinds(); its entries are not checked.
   * Throws InputError for any other name.
   */
  std::shared_ptr<const BodyShape> make_body_shape(const std::string &name,
                                                   const ShapeSpec &parameters);
} // namespace RollingContact

#endif
