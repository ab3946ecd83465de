#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/mesh/profiled_section.h>
#include <rolling_contact/mesh/section_file_shape.h>
#include <rolling_contact/mesh/swept_mesh.h>
#include <rolling_contact/references/line_contact_approach.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace RollingContact
{
  namespace
  {

    const unsigned int least_cells_along = 8, most_cells_along = 100000;

    /// of an edge's length, its ends may be off the circle that it follows
    const double on_circle = 1e-3;

    /// so far below its circle, over the distance from the contact point, a
    /// running surface is an edge
    const double steepest = 0.2;

    using Edge = std::pair<unsigned int, unsigned int>; ///< ends, ascending

    std::map<Edge, SectionBoundary> boundary_of(const FileMesh &mesh)
    {
      std::map<Edge, SectionBoundary> boundary;
      for (const FileMesh::Face &edge : mesh.contact_faces)
        boundary[std::minmax(edge[0], edge[1])] = SectionBoundary::contact;
      for (const FileMesh::Face &edge : mesh.hub_faces)
        boundary[std::minmax(edge[0], edge[1])] = SectionBoundary::hub;
      return boundary;
    }

    /**
     * Whether both ends of an edge are on the circle of this radius across, or
     * the straight line, with the contact point at this height.
     */
    bool follows_crown(const SectionPoint &p,
                       const SectionPoint &q,
                       const double        top,
                       const double        lateral_radius)
    {
      const double tolerance = on_circle * std::hypot(q[0] - p[0], q[1] - p[1]);
      const auto   off       = [&](const SectionPoint &point) {
        return std::abs(point[1] - top + crown_depth(lateral_radius, point[0]));
      };
      return std::max(off(p), off(q)) <= tolerance;
    }

    /**
     * The edge from @p p to @p q, with the contact point at this height, along
     * the circle of this radius across; none if its ends are not on it.
     */
    SectionMesh::Curve crowned(const SectionPoint &p,
                               const SectionPoint &q,
                               const double        top,
                               const double        lateral_radius)
    {
      if (lateral_radius == 0. || !follows_crown(p, q, top, lateral_radius))
        return {};
      const auto height = [=](const double y) {
        return top - crown_depth(lateral_radius, y);
      };
      const double off_p = p[1] - height(p[0]), off_q = q[1] - height(q[0]);
      return [=](const double t) {
        const double y = (1 - t) * p[0] + t * q[0],
                     z = height(y) + (1 - t) * off_p + t * off_q;
        return SectionPoint{{y, z, (1 - t) * p[2] + t * q[2]}};
      };
    }

    /** Distance of a point from the segment between two others. Units: m. */
    double distance_to_segment(const std::array<double, 2> &from,
                               const SectionPoint          &p,
                               const SectionPoint          &q)
    {
      const double along_y = q[0] - p[0], along_z = q[1] - p[1],
                   square = along_y * along_y + along_z * along_z,
                   t      = std::clamp(((from[0] - p[0]) * along_y +
                                   (from[1] - p[1]) * along_z) /
                                    square,
                                  0.,
                                  1.);
      return std::hypot(p[0] + t * along_y - from[0],
                        p[1] + t * along_z - from[1]);
    }
  } // namespace

  void SectionFileShape::check(const unsigned int dimension,
                               const bool         rigid) const
  {
    const std::string &section = parameters.section;
    parameters.require(parameters.radius >= 0.,
                       "Radius",
                       parameters.radius,
                       "a section is revolved about an axle one radius behind "
                       "the contact point, or extruded with 0 m; give 0 m or "
                       "more.");
    if (rigid)
      return;
    if (dimension == 2)
      throw InputError(section +
                       "/Shape = section: a section is across the rolling "
                       "direction; take Dimension = 3.");
    if (parameters.mesh_file.empty())
      throw InputError(section +
                       "/Mesh file = : Shape = section needs the name of a "
                       ".msh or .inp file with the section's quadrilaterals.");
    parameters.require(parameters.mesh_unit > 0.,
                       "Mesh unit",
                       parameters.mesh_unit,
                       "it must be above 0 m; 0.001 for millimetres.");
    parameters.require(parameters.cells_along >= least_cells_along &&
                         parameters.cells_along <= most_cells_along,
                       "Cells along",
                       parameters.cells_along,
                       "give 8 to 100000 equal cells round the axle or along "
                       "the rail.");
    if (!is_revolved())
      parameters.require(parameters.block_length > 0.,
                         "Block length",
                         parameters.block_length,
                         "it is the length of a section that is extruded "
                         "(Radius = 0) and must be above 0 m.");
    if (hub_clamped() && parameters.contact_boundary == parameters.hub_boundary)
      throw InputError(section + "/Contact boundary id and " + section +
                       "/Hub boundary id are both " +
                       std::to_string(parameters.hub_boundary) +
                       ": the hub must be another part of the boundary.");
  }

  double SectionFileShape::height_as_made(const double x, const double y) const
  {
    if (parameters.mesh && !parameters.profile)
      for (const FileMesh::Face &edge : parameters.mesh->contact_faces)
        {
          const auto &p = parameters.mesh->vertices[edge[0]],
                     &q = parameters.mesh->vertices[edge[1]];
          const SectionPoint begin{{p[0], p[2], p[2]}}, end{{q[0], q[2], q[2]}};
          const double       t = (y - p[0]) / (q[0] - p[0]);
          if (t >= 0. && t <= 1. &&
              !follows_crown(begin, end, 0., parameters.lateral_radius))
            return (1 - t) * p[2] + t * q[2] -
                   crown_depth(parameters.radius, x);
        }
    return surface_height(x, y);
  }

  double SectionFileShape::thickness_below() const
  {
    return parameters.mesh ? parameters.mesh->depth : 0.;
  }

  std::optional<Axle> SectionFileShape::axle() const
  {
    if (!is_revolved())
      return std::nullopt;
    return Axle{{{0., 0., -parameters.radius}}, {{0., 1., 0.}}};
  }

  std::optional<SectionMesh> SectionFileShape::section_about_axle() const
  {
    if (!is_revolved())
      return {};
    const bool is_left = parameters.profile && parameters.profile->is_left;
    return is_left ? section().mirrored() : section();
  }

  std::shared_ptr<const ExtrudedSection>
  SectionFileShape::extruded_section() const
  {
    if (is_revolved())
      return nullptr;
    return std::make_shared<const ExtrudedSection>(
      ExtrudedSection{section(), placement()});
  }

  SectionPlacement SectionFileShape::placement() const
  {
    SectionPlacement placement;
    placement.contact = {{0., parameters.radius}};
    placement.is_left = parameters.profile && parameters.profile->is_left;
    return placement;
  }

  double SectionFileShape::reach_x() const
  {
    return is_revolved() ? usable_rim * parameters.radius
                         : parameters.block_length / 2;
  }

  double SectionFileShape::reach_y() const
  {
    if (!parameters.mesh)
      return parameters.width / 2;
    const FileMesh &mesh = *parameters.mesh;
    // under a profile, from wherever that touches
    return parameters.profile ? mesh.upper[0] - mesh.lower[0]
                              : std::min(-mesh.lower[0], mesh.upper[0]);
  }

  double SectionFileShape::distance_to_edge() const
  {
    if (!parameters.mesh || parameters.profile)
      return 0.;
    const SectionMesh            body = section();
    std::map<Edge, unsigned int> cells_at;
    for (unsigned int cell = 0; cell < body.quads().size(); ++cell)
      for (unsigned int edge = 0; edge < 4; ++edge)
        {
          const auto ends = body.ends_of_edge(cell, edge);
          ++cells_at[std::minmax(ends[0], ends[1])];
        }
    const auto   boundary = boundary_of(*parameters.mesh);
    const double top      = parameters.radius;
    const auto   is_edge  = [&](const SectionPoint &point) {
      return top - crown_depth(parameters.lateral_radius, point[0]) - point[1] >
             steepest * std::hypot(point[0], point[1] - top);
    };
    double distance = reach_x();
    for (const auto &[ends, n_cells] : cells_at)
      {
        const SectionPoint &p = body.vertices()[ends.first],
                           &q = body.vertices()[ends.second];
        const auto found      = boundary.find(ends);
        const bool runs       = found != boundary.end() &&
                          found->second == SectionBoundary::contact &&
                          !is_edge(p) && !is_edge(q);
        if (n_cells == 1 && !runs)
          distance = std::min(distance, distance_to_segment({{0., top}}, p, q));
      }
    return distance;
  }

  double SectionFileShape::largest_half_width() const
  {
    return is_revolved() ? parameters.radius : BodyShape::largest_half_width();
  }

  double
  SectionFileShape::line_compression(const References::HertzLine &contact,
                                     const double                 young_modulus,
                                     const double poisson_ratio) const
  {
    return is_revolved() ? References::compression_of_disc(parameters.radius,
                                                           young_modulus,
                                                           poisson_ratio,
                                                           contact)
                         : BodyShape::line_compression(contact,
                                                       young_modulus,
                                                       poisson_ratio);
  }

  SectionMesh SectionFileShape::section() const
  {
    const FileMesh           &mesh = *parameters.mesh;
    const double              top  = parameters.radius;
    std::vector<SectionPoint> points;
    for (const FileMesh::Point &vertex : mesh.vertices)
      points.push_back({{vertex[0], top + vertex[2], top + vertex[2]}});
    std::optional<ProfiledSection> profile;
    if (parameters.profile)
      profile.emplace(*parameters.profile, is_of_wheel());
    if (profile)
      for (const FileMesh::Face &edge : mesh.contact_faces)
        for (const unsigned int end : {edge[0], edge[1]})
          put_on_profile(*profile, top, points[end]);
    std::vector<std::array<unsigned int, 4>> corners;
    for (const FileMesh::Cell &cell : mesh.cells)
      corners.push_back({{cell[0], cell[1], cell[2], cell[3]}});
    SectionMesh section(points, corners);
    const auto  boundary = boundary_of(mesh);
    for (unsigned int quad = 0; quad < corners.size(); ++quad)
      for (unsigned int edge = 0; edge < 4; ++edge)
        {
          const auto ends  = section.ends_of_edge(quad, edge);
          const auto found = boundary.find(std::minmax(ends[0], ends[1]));
          if (found == boundary.end())
            continue;
          section.set_boundary(quad, edge, found->second);
          if (found->second == SectionBoundary::contact && !profile)
            section.set_curve(quad,
                              edge,
                              crowned(points[ends[0]],
                                      points[ends[1]],
                                      top,
                                      parameters.lateral_radius));
        }
    if (profile)
      follow_profile(*profile, top, section);
    return section;
  }

  std::vector<ZoneBox>
  SectionFileShape::on_surface(const std::vector<ZoneBox> &boxes) const
  {
    if (!parameters.profile)
      return boxes;
    const ProfiledSection profile(*parameters.profile, is_of_wheel());
    std::vector<ZoneBox>  result;
    for (const ZoneBox &box : boxes)
      result.push_back(profile.on_profile(box));
    return result;
  }

  std::shared_ptr<const SweptMesh>
  SectionFileShape::equal_cells(const double along, const double across) const
  {
    const double length =
      is_revolved() ? 2 * pi * parameters.radius : parameters.block_length;
    const unsigned int n =
      std::max(parameters.cells_along, fewest_parts(length, along));
    CoarseCells cells;
    cells.equal                   = true;
    cells.size                    = length / n;
    SectionPlacement    placement = this->placement();
    std::vector<double> ends;
    if (is_revolved())
      {
        placement.around.emplace(parameters.radius, cells);
        ends = placement.around->edges();
      }
    else
      ends = equal_parts(-length / 2, length / 2, n);
    return std::make_shared<const SweptMesh>(section().divided(across),
                                             placement,
                                             ends,
                                             cells.size);
  }

  std::vector<double> SectionFileShape::dimensions() const
  {
    return {parameters.radius,
            parameters.lateral_radius,
            parameters.block_length,
            double(parameters.cells_along)};
  }
} // namespace RollingContact
