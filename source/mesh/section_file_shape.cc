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
     * The edge from @p p to @p q, with the contact point at this height, along
     * the circle of this radius across; none if its ends are not on it.
     */
    SectionMesh::Curve crowned(const SectionPoint &p,
                               const SectionPoint &q,
                               const double        top,
                               const double        lateral_radius)
    {
      const double tolerance = on_circle * std::hypot(q[0] - p[0], q[1] - p[1]);
      const auto   height    = [=](const double y) {
        return top - crown_depth(lateral_radius, y);
      };
      const double off_p = p[1] - height(p[0]), off_q = q[1] - height(q[0]);
      if (lateral_radius == 0. ||
          std::max(std::abs(off_p), std::abs(off_q)) > tolerance)
        return {};
      return [=](const double t) {
        const double y = (1 - t) * p[0] + t * q[0],
                     z = height(y) + (1 - t) * off_p + t * off_q;
        return SectionPoint{{y, z, (1 - t) * p[2] + t * q[2]}};
      };
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
    cells.equal = true;
    cells.size  = length / n;
    SectionPlacement placement;
    placement.contact = {{0., parameters.radius}};
    placement.is_left = parameters.profile && parameters.profile->is_left;
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
    // never the mirror image of another body
    return {};
  }
} // namespace RollingContact
