#include <deal.II/base/geometry_info.h>

#include <rolling_contact/base/text.h>
#include <rolling_contact/mesh/mesh_file_checks.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    std::string place(const Point<dim> &point)
    {
      std::string text = "(";
      for (unsigned int d = 0; d < dim; ++d)
        text += (d == 0 ? "" : ", ") + significant(point[d], 4);
      return text + ")";
    }

    const double flat_cell = 1e-9; ///< of its diameter to the power of dim
    const double on_a_side = 1e-9; ///< of a face's area, by rounding

    /**
     * True if the map from the reference cell keeps its orientation at all
     * corners.
     */
    template <int dim>
    bool
    is_upright(const typename Triangulation<dim>::active_cell_iterator &cell)
    {
      Point<dim>     corners[GeometryInfo<dim>::vertices_per_cell];
      Tensor<0, dim> determinants[GeometryInfo<dim>::vertices_per_cell];
      for (const unsigned int v : cell->vertex_indices())
        corners[v] = cell->vertex(v);
      GeometryInfo<dim>::alternating_form_at_vertices(corners, determinants);
      const double size = std::pow(cell->diameter(), int(dim));
      return std::all_of(std::begin(determinants),
                         std::end(determinants),
                         [&](const double determinant) {
                           return determinant > flat_cell * size;
                         });
    }

    /**
     * Number of cells that faces join with the first one, itself included.
     */
    template <int dim>
    std::size_t n_cells_of_first_part(const Triangulation<dim> &cells)
    {
      std::vector<bool> reached(cells.n_active_cells(), false);
      std::vector<typename Triangulation<dim>::active_cell_iterator> front{
        cells.begin_active()};
      reached[front[0]->active_cell_index()] = true;
      std::size_t n                          = 0;
      while (!front.empty())
        {
          const auto cell = front.back();
          front.pop_back();
          ++n;
          for (const unsigned int f : cell->face_indices())
            if (!cell->at_boundary(f) &&
                !reached[cell->neighbor(f)->active_cell_index()])
              {
                reached[cell->neighbor(f)->active_cell_index()] = true;
                front.push_back(cell->neighbor(f));
              }
        }
      return n;
    }
  } // namespace

  template <int dim>
  void check_cells(const MeshFile &file, const Triangulation<dim> &cells)
  {
    if (!cells.all_reference_cells_are_hyper_cube())
      reject(file,
             dim == 2 ? "it has triangles; only quadrilaterals can be used "
                        "(Gmsh: Recombine Surface)."
                      : "it has tetrahedra, wedges or pyramids; only hexahedra "
                        "can be used (Gmsh: transfinite or extruded volumes "
                        "with Recombine).");
    std::size_t n_bad = 0;
    Point<dim>  first;
    for (const auto &cell : cells.active_cell_iterators())
      if (!is_upright<dim>(cell) && n_bad++ == 0)
        first = cell->center();
    if (n_bad > 0)
      reject(file,
             std::to_string(n_bad) + " of " +
               std::to_string(cells.n_active_cells()) +
               " cells are inverted, folded or flat, the first at " +
               place(first) + " of the file.");
    const std::size_t n_first = n_cells_of_first_part(cells);
    if (n_first < cells.n_active_cells())
      reject(file,
             "its cells are in separate parts: " + std::to_string(n_first) +
               " of " + std::to_string(cells.n_active_cells()) +
               " hang together. Make the mesh of one part, with common nodes "
               "where parts meet (Gmsh: Coherence, or BooleanFragments).");
  }

  template <int dim>
  void check_boundary_ids(const MeshFile &file, const Triangulation<dim> &cells)
  {
    std::set<types::boundary_id> ids;
    for (const types::boundary_id id : cells.get_boundary_ids())
      ids.insert(id);
    std::string list;
    for (const types::boundary_id id : ids)
      list += (list.empty() ? "" : ", ") + std::to_string(id);
    const auto require = [&](const std::string &entry, const unsigned int id) {
      if (ids.count(id) == 0)
        reject(file,
               "no face of its boundary has " + file.section + "/" + entry +
                 " = " + std::to_string(id) + "; its boundary has " + list +
                 " (0: no id). Ids are those of physical groups (Gmsh), or "
                 "the digits in the names of surfaces (Abaqus).");
    };
    require("Contact boundary id", file.contact_boundary);
    if (file.has_hub)
      require("Hub boundary id", file.hub_boundary);
  }

  namespace
  {
    /**
     * Twice the area, seen along z, of the triangle from the origin to the side
     * of a face from corner @p a to @p b.
     */
    double from_origin(const FileMesh       &mesh,
                       const FileMesh::Face &face,
                       const unsigned int    a,
                       const unsigned int    b)
    {
      const FileMesh::Point &p = mesh.vertices[face[a]],
                            &q = mesh.vertices[face[b]];
      return p[0] * q[1] - p[1] * q[0];
    }

    /**
     * True if a contact face lies over or under the origin, to rounding.
     */
    bool holds_origin(const FileMesh &mesh, const FileMesh::Face &face)
    {
      if (mesh.dimension == 2)
        return mesh.vertices[face[0]][0] * mesh.vertices[face[1]][0] <= 0.;
      const double sides[4] = {from_origin(mesh, face, 0, 1),
                               from_origin(mesh, face, 1, 3),
                               from_origin(mesh, face, 3, 2),
                               from_origin(mesh, face, 2, 0)};
      double       sum      = 0.;
      for (const double side : sides)
        sum += side;
      return std::all_of(std::begin(sides), std::end(sides), [&](double side) {
        return side / sum >= -on_a_side;
      });
    }

    double mean_height(const FileMesh &mesh, const FileMesh::Face &face)
    {
      double sum = 0.;
      for (unsigned int v = 0; v < mesh.n_corners(); ++v)
        sum += mesh.vertices[face[v]][2] / mesh.n_corners();
      return sum;
    }
  } // namespace

  void check_contact_boundary(const MeshFile                 &file,
                              const FileMesh                 &mesh,
                              const std::vector<ContactFace> &contact_faces)
  {
    const std::string boundary =
      "its contact boundary (" + file.section +
      "/Contact boundary id = " + std::to_string(file.contact_boundary) + ")";
    const std::string side = file.mirrored
                               ? "the wheel must lie above, at z > 0."
                               : "the rail must lie below, at z < 0.";
    if (mesh.contact_faces.empty())
      reject(file,
             boundary + ": no face of it looks towards the other body; " +
               side);
    const ContactFace *at_origin = nullptr;
    for (const ContactFace &face : contact_faces)
      if (holds_origin(mesh, face.corners) &&
          (at_origin == nullptr ||
           std::abs(mean_height(mesh, face.corners)) <
             std::abs(mean_height(mesh, at_origin->corners))))
        at_origin = &face;
    const auto range = [&](const unsigned int d) {
      return significant(mesh.lower[d], 4) + " to " +
             significant(mesh.upper[d], 4) + " m";
    };
    if (at_origin == nullptr)
      reject(file,
             boundary + " is not around the origin: it reaches from " +
               (file.is_section ? "y = " : "x = ") + range(0) +
               (mesh.dimension == 3 ? ", y = " + range(1) : "") +
               ". Move the contact point to the origin, with " +
               (file.is_section ? "y across" : "x in the rolling direction") +
               " and z from rail to wheel" +
               (mesh.dimension == 2 ? " (the file's y)." : "."));
    if (at_origin->upwards <= least_upwards)
      reject(file,
             boundary +
               " turns away from the other body at the origin: " + side);
    if (!(mesh.depth > 0.))
      reject(file,
             "its hub (" + file.section +
               "/Hub boundary id = " + std::to_string(file.hub_boundary) +
               ") must lie behind the contact point, at z " +
               (file.mirrored ? "> 0." : "< 0."));
  }

  template void check_cells(const MeshFile &, const Triangulation<2> &);
  template void check_cells(const MeshFile &, const Triangulation<3> &);
  template void check_boundary_ids(const MeshFile &, const Triangulation<2> &);
  template void check_boundary_ids(const MeshFile &, const Triangulation<3> &);
} // namespace RollingContact
