#ifndef rolling_contact_mesh_swept_mesh_h
#define rolling_contact_mesh_swept_mesh_h

#include <rolling_contact/mesh/rim_coordinate.h>
#include <rolling_contact/mesh/section_mesh.h>

#include <array>
#include <optional>
#include <vector>

namespace RollingContact
{
  /**
   * Where the points of a section are in the frame of its body, whose origin
   * is the contact and whose z points out of it: turned about the contact and
   * moved along x, or round the axle. Units: m, rad.
   */
  struct SectionPlacement
  {
    using Point = std::array<double, 3>;

    /**
     * Place in the body of a point of the section at x, counted from the
     * contact.
     */
    Point to_body(const double x, const SectionPoint &point) const;

    /**
     * The point of an extruded section, across and outwards, at a place of the
     * body.
     */
    std::array<double, 2> to_section(const Point &place) const;

    /**
     * Rows x, y, z of the body, columns across, outwards and along x of an
     * extruded section: the components of vectors.
     */
    std::array<std::array<double, 3>, 3> directions() const;

    std::array<double, 2>        contact; ///< across and outwards
    double                       turn    = 0.;
    bool                         is_left = false; ///< y changes its sign
    std::optional<RimCoordinate> around  = {};    ///< of a body of revolution
  };

  /**
   * The section of a body that is extruded along x, across and outwards, and
   * where it is in the body. Units: m.
   */
  struct ExtrudedSection
  {
    SectionMesh      section;
    SectionPlacement placement;
  };

  /**
   * The coarse hexahedra of a body that is a section swept along x or round an
   * axle, and the map of each from the unit cube (x, a, b): where refinement
   * puts vertices, and where they are in the chart (x, y, w) of the interface.
   * Cells are numbered by quadrilaterals of the section, then along x. Units:
   * m.
   */
  class SweptMesh
  {
  public:
    using Point = SectionPlacement::Point;

    /**
     * With cells between these ends along x, counted from the contact; round
     * an axle the last is the first. @p size: of those at the contact.
     */
    SweptMesh(const SectionMesh         &section,
              const SectionPlacement    &placement,
              const std::vector<double> &ends_x,
              const double               size);

    std::vector<Point> vertices() const;

    std::size_t n_cells() const
    {
      return section.quads().size() * (ends_x.size() - 1);
    }

    /** Vertices of a cell, x fastest. */
    std::array<unsigned int, 8> corners(const unsigned int cell) const;

    SectionBoundary boundary(const unsigned int cell,
                             const unsigned int face) const;

    /**
     * Chart point of a place in the unit cube of a cell; x counted from the
     * contact, negative upstream, wrapped opposite the contact.
     */
    Point chart_point(const unsigned int cell, const Point &local) const;

    Point body_point(const unsigned int cell, const Point &local) const;

    double size() const
    {
      return coarse_size;
    }

    const SectionMesh &of_section() const
    {
      return section;
    }

  private:
    double x_at(const unsigned int slice, const double local) const;

    bool is_mirrored() const;

    SectionMesh         section;
    SectionPlacement    placement;
    std::vector<double> ends_x;
    double              coarse_size;
    bool                mirrored = false; ///< x descends in the unit cubes

    /** Places in the chart of the corners of each quadrilateral. */
    std::vector<std::array<SectionMesh::ChartPoint, 4>> chart;
  };
} // namespace RollingContact

#endif
