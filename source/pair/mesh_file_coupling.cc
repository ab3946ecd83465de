#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/contact/mortar.h>
#include <rolling_contact/contact/overlap.h>
#include <rolling_contact/pair/file_surface_checks.h>
#include <rolling_contact/pair/mesh_file_coupling.h>
#include <rolling_contact/pair/refined_coupling.h>
#include <rolling_contact/pair/section_advice.h>
#include <rolling_contact/pair/section_in_contact.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

namespace RollingContact
{
  namespace
  {
    const double warned_face   = 1.1; ///< in elements of the interface
    const double least_element = 1.2; ///< of the interface, in faces

    Box box_of(const Trace &interface)
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

    Box box_of(const SurfaceMesh                 &surface,
               const std::array<unsigned int, 4> &face)
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
    SurfaceMesh surface_over(const Box             &zone,
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

    /**
     * What the undeformed surface is, and how far nodes are off it.
     */
    std::string note_on_surface(const BodySpec &body,
                                const bool      under_profile,
                                const double    distance)
    {
      if (under_profile)
        return "the profile, the nodes lie within " + millimetres(distance) +
               " of it.";
      return body.surface == SurfaceSource::radii
               ? "the radii, the nodes lie within " + millimetres(distance) +
                   " of them."
               : "the nodes, which lie within " + millimetres(distance) +
                   " of the radii.";
    }

    std::string note_on(const BodySpec    &body,
                        const FileMesh    &mesh,
                        const FileSurface &surface,
                        const std::string &on_surface)
    {
      return body.section + ": " + body.mesh_file + sweep_of(body) + ", " +
             std::to_string(mesh.cells.size()) + " cells; its " +
             std::to_string(surface.vertices.size()) +
             " contact nodes, up to " + millimetres(surface.face_size[0]) +
             " apart, are coupled to the interface. Undeformed surface: " +
             on_surface;
    }

    std::string warning_of(const BodySpec    &body,
                           const FileSurface &surface,
                           const Trace       &interface)
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

  namespace
  {
    /**
     * Let vertices that hang move with the corners of the faces they are on.
     */
    void take_corners_of_hanging(const HangingVertices &hanging,
                                 MortarProjection      &projection)
    {
      if (std::none_of(projection.nodes.begin(),
                       projection.nodes.end(),
                       [&](const unsigned int vertex) {
                         return hanging.count(vertex) > 0;
                       }))
        return;
      const std::vector<unsigned int>      vertices = projection.nodes;
      std::map<unsigned int, unsigned int> number;
      SparseRows                           rows(projection.rows.size());
      projection.nodes.clear();
      const auto add = [&](const unsigned int row,
                           const unsigned int vertex,
                           const double       value) {
        const auto [at, is_new] = number.emplace(vertex, number.size());
        if (is_new)
          projection.nodes.push_back(vertex);
        rows.add(row, at->second, value);
      };
      for (unsigned int i = 0; i < rows.size(); ++i)
        for (const auto &[column, value] : projection.rows[i])
          {
            const auto found = hanging.find(vertices[column]);
            if (found == hanging.end())
              add(i, vertices[column], value);
            else
              for (const auto &[corner, share] : found->second)
                add(i, corner, share * value);
          }
      projection.rows = std::move(rows);
    }
  } // namespace

  FileSurface couple_to_interface(const PairSpec &scene,
                                  const Side      side,
                                  const FileMesh &mesh,
                                  const Trace    &interface)
  {
    return couple_refined_to_interface(scene, side, mesh, {}, interface);
  }

  FileSurface couple_refined_to_interface(const PairSpec        &scene,
                                          const Side             side,
                                          const FileMesh        &body_mesh,
                                          const HangingVertices &hanging,
                                          const Trace           &interface)
  {
    const BodySpec                 &body = scene.body(side);
    const Box                       zone = box_of(interface);
    std::optional<SectionInContact> section;
    std::optional<FileMesh>         seen;
    if (SectionInContact::is_on(scene, side))
      {
        section.emplace(scene, side);
        seen = section->seen_from_contact(body_mesh);
      }
    const FileMesh   &mesh = seen ? *seen : body_mesh;
    FileSurface       result;
    const SurfaceMesh surface = surface_over(zone, mesh, result.face_size);
    check_faces(body, surface, result.face_size, zone);
    MortarProjection projection = mortar_projection(interface, surface);
    check_cover(body, interface, projection);
    check_free_of_hub(body, mesh, projection.nodes);
    result.face_size = size_of_used_faces(surface, projection.nodes);
    take_corners_of_hanging(hanging, projection);
    result.vertices = projection.nodes;
    const double distance =
      section
        ? check_on_profile(scene, side, body_mesh, result.vertices, *section)
        : check_heights(body,
                        mesh,
                        result.vertices,
                        largest_gap(scene, interface));
    if (section)
      result.axes = section->axes();
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
    result.note = {
      note_on(body,
              mesh,
              result,
              note_on_surface(body, section.has_value(), distance)) +
        advice,
      warning_of(body, result, interface)};
    return result;
  }

  void check_resolution(const PairSpec    &scene,
                        const Side         side,
                        const FileSurface &surface,
                        const double       element_size_x,
                        const double       element_size_y)
  {
    const BodySpec &body = scene.body(side);
    const auto      check =
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
