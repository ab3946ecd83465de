#ifndef rolling_contact_mesh_section_mesh_h
#define rolling_contact_mesh_section_mesh_h

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace RollingContact
{
  /**
   * A point of a section: across, outwards, and, where the section is revolved,
   * the radius on which x is measured. Units: m.
   */
  using SectionPoint = std::array<double, 3>;

  /**
   * What an edge of a section is part of.
   */
  enum class SectionBoundary
  {
    none, ///< free, or inside of the section
    contact,
    hub
  };

  /**
   * Coarse quadrilaterals of a section. Each is the image (a, b) -> point of
   * the unit square between its four edges, straight ones or curves (Coons):
   *
   *   P = (1-b) E_2(a) + b E_3(a) + (1-a) E_0(b) + a E_1(b) - bilinear part,
   *
   * edges 0 and 1 at a = 0 and 1, 2 and 3 at b = 0 and 1, corners with a
   * fastest. Units: m.
   */
  class SectionMesh
  {
  public:
    using Curve = std::function<SectionPoint(double)>; ///< of 0 to 1

    /**
     * Place in the interface's chart: coordinate across and height, 0 at the
     * surface and negative below.
     */
    using ChartPoint = std::array<double, 2>;

    struct Quad
    {
      std::array<unsigned int, 4>    corners;
      std::array<Curve, 4>           curves = {}; ///< of edges; none: straight
      std::array<SectionBoundary, 4> boundary{};
      /**
       * Places in the chart of the corners of a quadrilateral under the running
       * surface; none elsewhere.
       */
      std::optional<std::array<ChartPoint, 4>> chart = {};
    };

    SectionMesh() = default;

    /**
     * With these points and quadrilaterals between them, of positive area and
     * with straight edges.
     */
    SectionMesh(const std::vector<SectionPoint>                &points,
                const std::vector<std::array<unsigned int, 4>> &corners);

    /**
     * Add a quadrilateral, its corners with a fastest; corners that coincide
     * with others are shared with them. The curve of the edge b = 1 and what
     * that is part of are set by the caller in what is returned. Turned round
     * (a to 1 - a) if it has a negative area, so that curves must be added by
     * set_curve().
     */
    unsigned int add(const std::array<SectionPoint, 4> &corners);

    /**
     * Let the edge between two corners of the quadrilateral follow a curve from
     * the first to the second.
     */
    void set_curve(const unsigned int  quad,
                   const SectionPoint &begin,
                   const SectionPoint &end,
                   const Curve        &curve);

    /**
     * Let an edge of a quadrilateral, 0 to 3, follow a curve by ascending a or
     * b.
     */
    void set_curve(const unsigned int quad,
                   const unsigned int edge,
                   const Curve       &curve)
    {
      cells[quad].curves[edge] = curve;
    }

    void set_boundary(const unsigned int    quad,
                      const unsigned int    edge,
                      const SectionBoundary boundary)
    {
      cells[quad].boundary[edge] = boundary;
    }

    /** Numbers of the begin and the end of an edge of a quadrilateral. */
    std::array<unsigned int, 2> ends_of_edge(const unsigned int quad,
                                             const unsigned int edge) const;

    void set_boundary(const unsigned int    quad,
                      const SectionPoint   &begin,
                      const SectionPoint   &end,
                      const SectionBoundary boundary);

    /**
     * Places of the corners, in the order in which add() was given them.
     */
    void set_chart(const unsigned int                 quad,
                   const std::array<SectionPoint, 4> &corners,
                   const std::array<ChartPoint, 4>   &chart);

    const std::vector<SectionPoint> &vertices() const
    {
      return points;
    }

    const std::vector<Quad> &quads() const
    {
      return cells;
    }

    SectionPoint
    at(const unsigned int quad, const double a, const double b) const;

    /**
     * The least sine of the angle between the edges at a corner, negative for a
     * quadrilateral that is folded, over all quadrilaterals divided into
     * @p parts by @p parts.
     */
    double least_quality(const unsigned int parts) const;

    /**
     * The section with its quadrilaterals divided so that no edge is longer
     * than @p longest: edges opposite each other, through the whole section,
     * into equal numbers of parts, so that no node hangs. New edges are
     * straight, between points on the curves. Units: m.
     */
    SectionMesh divided(const double longest) const;

    /** The mirror image, across turned round. */
    SectionMesh mirrored() const;

  private:
    unsigned int vertex(const SectionPoint &point);

    unsigned int edge_between(const unsigned int  quad,
                              const SectionPoint &begin,
                              const SectionPoint &end,
                              bool               &reversed) const;

    std::vector<SectionPoint> points;
    std::vector<Quad>         cells;
  };
} // namespace RollingContact

#endif
