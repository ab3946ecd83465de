#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/interface/mortar.h>
#include <rolling_contact/interface/overlap.h>
#include <rolling_contact/pair/mesh_file_coupling.h>
#include <rolling_contact/pair/section_advice.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace RollingContact
{
  namespace
  {
    const double largest_face_of_zone = 0.25; ///< of the zone's length
    const double limit_of_radii = 0.01, limit_of_nodes = 0.5; ///< of the gap
    const double warned_face   = 1.1; ///< in elements of the interface
    const double least_element = 1.2; ///< of the interface, in faces

    using Box = std::array<std::array<double, 2>, 2>; ///< lower, upper

    [[noreturn]] void
    reject_file(const BodyParameters &body, const std::string &reason)
    {
      throw InputError(body.section + "/Mesh file = " + body.mesh_file + ": " +
                       reason);
    }



    std::string
    place(const double x, const double y)
    {
      return "x = " + millimetres(x) + ", y = " + millimetres(y);
    }



    Box
    box_of(const Trace &interface)
    {
      const double infinity = std::numeric_limits<double>::infinity();
      Box          box{{{{infinity, infinity}}, {{-infinity, -infinity}}}};
      for (const Trace::Cell &cell : interface.cells)
        for (unsigned int d = 0; d < 2; ++d)
          {
            box[0][d] = std::min(box[0][d], cell.lower[d]);
            box[1][d] = std::max(box[1][d], cell.upper[d]);
          }
      return box;
    }



    Box
    box_of(const SurfaceMesh &surface, const std::array<unsigned int, 4> &face)
    {
      Box box{{surface.nodes[face[0]], surface.nodes[face[0]]}};
      for (unsigned int v = 1; v < 1u << surface.n_dimensions; ++v)
        for (unsigned int d = 0; d < 2; ++d)
          {
            const double at = surface.nodes[face[v]][d];
            box[0][d]       = std::min(box[0][d], at);
            box[1][d]       = std::max(box[1][d], at);
          }
      return box;
    }



    /**
     * The contact faces that overlap the box of the zone; @p face_size becomes
     * the size of the largest of them in x and y. Units: m.
     */
    SurfaceMesh
    surface_over(const Box             &zone,
                 const FileMesh        &mesh,
                 std::array<double, 2> &face_size)
    {
      SurfaceMesh surface;
      surface.n_dimensions = mesh.dimension - 1;
      for (const FileMesh::Point &vertex : mesh.vertices)
        surface.nodes.push_back({{vertex[0], vertex[1]}});
      for (const FileMesh::Face &face : mesh.contact_faces)
        {
          const Box box     = box_of(surface, face);
          bool      overlap = true;
          for (unsigned int d = 0; d < surface.n_dimensions; ++d)
            overlap = overlap && box[1][d] > zone[0][d] && //
                      box[0][d] < zone[1][d];
          if (!overlap)
            continue;
          surface.faces.push_back(face);
          for (unsigned int d = 0; d < 2; ++d)
            face_size[d] = std::max(face_size[d], box[1][d] - box[0][d]);
        }
      return surface;
    }



    /**
     * Size in x and y of the largest face whose corners are all contact nodes.
     * Units: m.
     */
    std::array<double, 2>
    size_of_used_faces(const SurfaceMesh               &surface,
                       const std::vector<unsigned int> &nodes)
    {
      const std::set<unsigned int> used(nodes.begin(), nodes.end());
      std::array<double, 2>        size{{0., 0.}};
      for (const auto &face : surface.faces)
        {
          const bool is_used =
            std::all_of(face.begin(),
                        face.begin() + (1 << surface.n_dimensions),
                        [&](const unsigned int v) {
                          return used.count(v) > 0;
                        });
          const Box box = box_of(surface, face);
          for (unsigned int d = 0; is_used && d < 2; ++d)
            size[d] = std::max(size[d], box[1][d] - box[0][d]);
        }
      return size;
    }



    void
    check_faces(const BodyParameters        &body,
                const SurfaceMesh           &surface,
                const std::array<double, 2> &face_size,
                const Box                   &zone)
    {
      for (unsigned int d = 0; d < surface.n_dimensions; ++d)
        {
          const double length = zone[1][d] - zone[0][d];
          if (face_size[d] > largest_face_of_zone * length)
            reject_file(body,
                        "in the contact zone, " + millimetres(length) +
                          (d == 0 ? " long" : " wide") +
                          ", a face of its contact boundary is " +
                          millimetres(face_size[d]) +
                          (d == 0 ? " long" : " wide") +
                          ". Refine it there to a quarter of the zone at most, "
                          "better to Mesh/Elements across patch, or check " +
                          body.section + "/Mesh unit (" +
                          significant(body.mesh_unit, 4) + " m).");
        }
      if (surface.n_dimensions == 1)
        return;
      for (const auto &face : surface.faces)
        {
          std::array<Point2, 4> corners;
          for (unsigned int v = 0; v < 4; ++v)
            corners[v] = surface.nodes[face[v]];
          if (!is_convex(corners))
            reject_file(body,
                        "the face of its contact boundary at " +
                          place(corners[0][0], corners[0][1]) +
                          " is no convex quadrilateral seen along z.");
        }
    }



    void
    check_cover(const BodyParameters   &body,
                const Trace            &interface,
                const MortarProjection &projection)
    {
      for (std::size_t c = 0; c < interface.cells.size(); ++c)
        {
          const Trace::Cell &cell   = interface.cells[c];
          const double       excess = projection.covered[c] - 1;
          if (std::abs(excess) > 1e-6)
            reject_file(body,
                        std::string("its contact boundary ") +
                          (excess < 0. ? "ends" : "lies twice") +
                          " inside the contact zone, near " +
                          place((cell.lower[0] + cell.upper[0]) / 2,
                                (cell.lower[1] + cell.upper[1]) / 2) +
                          ". Extend the boundary " + body.section +
                          "/Contact boundary id = " +
                          std::to_string(body.contact_boundary) +
                          ", or check Mesh unit, load and "
                          "Mesh/Candidate zone.");
        }
    }



    void
    check_free_of_hub(const BodyParameters            &body,
                      const FileMesh                  &mesh,
                      const std::vector<unsigned int> &vertices)
    {
      std::set<unsigned int> clamped;
      for (const FileMesh::Face &face : mesh.hub_faces)
        clamped.insert(face.begin(), face.begin() + mesh.n_corners());
      for (const unsigned int vertex : vertices)
        if (clamped.count(vertex) > 0)
          reject_file(
            body,
            "its hub (" + body.section +
              "/Hub boundary id = " + std::to_string(body.hub_boundary) +
              ") reaches into the contact zone, at " +
              place(mesh.vertices[vertex][0], mesh.vertices[vertex][1]) + ".");
    }



    double
    largest_gap(const SceneParameters &scene, const Trace &interface)
    {
      const auto wheel = scene.wheel.body_shape(),
                 rail  = scene.rail.body_shape();
      double largest   = 0.;
      for (const auto &node : interface.nodes)
        largest = std::max(largest,
                           -wheel->surface_height(node[0], node[1]) -
                             rail->surface_height(node[0], node[1]));
      return largest;
    }



    /**
     * Largest distance of the contact nodes from the surface given by the
     * radii. Throws InputError if it is more than allowed for this largest @p
     * gap. Units: m.
     */
    double
    check_heights(const BodyParameters            &body,
                  const FileMesh                  &mesh,
                  const std::vector<unsigned int> &vertices,
                  const double                     gap)
    {
      const auto   shape   = body.body_shape();
      double       largest = 0.;
      unsigned int worst   = 0;
      for (const unsigned int vertex : vertices)
        {
          const auto  &at = mesh.vertices[vertex];
          const double distance =
            std::abs(at[2] - shape->surface_height(at[0], at[1]));
          if (distance >= largest)
            worst = vertex;
          largest = std::max(largest, distance);
        }
      const bool   by_radii = body.surface == SurfaceSource::radii;
      const double limit = (by_radii ? limit_of_radii : limit_of_nodes) * gap;
      if (largest > limit)
        {
          const auto &at = mesh.vertices[worst];
          reject_file(
            body,
            "the node of its contact boundary at " + place(at[0], at[1]) +
              " lies " + millimetres(largest) + " off the surface of " +
              body.section + "/Radius = " + significant(body.radius, 6) + " m" +
              (mesh.dimension == 3
                 ? " and Lateral radius = " +
                     significant(body.lateral_radius, 6) + " m"
                 : std::string()) +
              "; " + millimetres(limit) + " is allowed, " +
              (by_radii ? "1 %" : "half") +
              " of the largest gap in the contact zone. Check the radii, Mesh "
              "unit (" +
              significant(body.mesh_unit, 4) +
              " m), the contact point (the origin) and the axes (z from rail "
              "to wheel)" +
              (by_radii ? ", or take " + body.section + "/Surface = nodes."
                        : "."));
        }
      return largest;
    }



    std::string
    note_on(const BodyParameters &body,
            const FileMesh       &mesh,
            const FileSurface    &surface,
            const double          distance)
    {
      return body.section + ": " + body.mesh_file + sweep_of(body) + ", " +
             std::to_string(mesh.cells.size()) + " cells; its " +
             std::to_string(surface.vertices.size()) +
             " contact nodes, up to " + millimetres(surface.face_size[0]) +
             " apart, are coupled to the interface. Undeformed surface: " +
             (body.surface == SurfaceSource::radii
                ? "the radii, the nodes lie within "
                : "the nodes, which lie within ") +
             millimetres(distance) +
             (body.surface == SurfaceSource::radii ? " of them."
                                                   : " of the radii.");
    }



    std::string
    warning_of(const BodyParameters &body,
               const FileSurface    &surface,
               const Trace          &interface)
    {
      const Trace::Cell &cell = interface.cells[0];
      for (unsigned int d = 0; d < interface.n_dimensions; ++d)
        {
          const double size = cell.upper[d] - cell.lower[d];
          if (surface.face_size[d] > warned_face * size)
            return body.section + "/Mesh file = " + body.mesh_file +
                   ": faces of " + millimetres(surface.face_size[d]) +
                   " are too large for the interface's elements of " +
                   millimetres(size) +
                   "; with twice the size forces are off by 1 % of mu N. Take "
                   "faces at most as large, or fewer Mesh/Elements across "
                   "patch.";
        }
      return "";
    }
  } // namespace



  FileSurface
  couple_to_interface(const SceneParameters &scene,
                      const Side             side,
                      const FileMesh        &mesh,
                      const Trace           &interface)
  {
    const BodyParameters &body = scene.body(side);
    const Box             zone = box_of(interface);
    FileSurface           result;
    const SurfaceMesh     surface = surface_over(zone, mesh, result.face_size);
    check_faces(body, surface, result.face_size, zone);
    MortarProjection projection = mortar_projection(interface, surface);
    check_cover(body, interface, projection);
    check_free_of_hub(body, mesh, projection.nodes);
    result.vertices  = projection.nodes;
    result.face_size = size_of_used_faces(surface, projection.nodes);
    const double distance =
      check_heights(body, mesh, result.vertices, largest_gap(scene, interface));
    result.coupling =
      SurfaceCoupling(std::move(projection.rows), result.vertices.size());
    if (body.surface == SurfaceSource::nodes)
      {
        std::vector<double> heights;
        for (const unsigned int vertex : result.vertices)
          heights.push_back(mesh.vertices[vertex][2]);
        result.heights = result.coupling.to_interface(heights);
      }
    const auto &[lower, upper, corners] = interface.cells[0];
    const std::string advice =
      advice_on_cells_along(body,
                            result.face_size,
                            {{upper[0] - lower[0], upper[1] - lower[1]}});
    result.note = {note_on(body, mesh, result, distance) + advice,
                   warning_of(body, result, interface)};
    return result;
  }



  void
  check_resolution(const SceneParameters &scene,
                   const Side             side,
                   const FileSurface     &surface,
                   const double           element_size_x,
                   const double           element_size_y)
  {
    const BodyParameters &body = scene.body(side);
    const auto            check =
      [&](const double element, const double face, const std::string &entry) {
        if (element < least_element * face)
          throw InputError(
            "Mesh/" + entry + ": the interface's elements are " +
            millimetres(element) + " long, the faces of " + body.section +
            "/Mesh file = " + body.mesh_file + " up to " + millimetres(face) +
            ". Where the program meshes neither body they must be " +
            significant(least_element, 3) +
            " times as long as the faces: refine the file or take fewer.");
      };
    check(element_size_x, surface.face_size[0], "Elements across patch");
    if (scene.dimension == 3)
      check(element_size_y, surface.face_size[1], "Elements across patch y");
  }
} // namespace RollingContact
