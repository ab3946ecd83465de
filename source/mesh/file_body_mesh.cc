#include <rolling_contact/mesh/file_body_mesh.h>
#include <rolling_contact/mesh/mesh_file_checks.h>
#include <rolling_contact/mesh/mesh_memory.h>

#include <algorithm>
#include <map>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    using Corners = std::vector<unsigned int>; ///< ascending

    std::map<Corners, types::boundary_id>
    boundary_of_corners(const FileMesh &mesh)
    {
      std::map<Corners, types::boundary_id> result;
      const auto                            add = [&](const auto              &faces,
                           const types::boundary_id boundary) {
        for (const FileMesh::Face &face : faces)
          {
            Corners corners(face.begin(), face.begin() + mesh.n_corners());
            std::sort(corners.begin(), corners.end());
            result[corners] = boundary;
          }
      };
      add(mesh.contact_faces, contact_boundary);
      add(mesh.hub_faces, hub_boundary);
      return result;
    }

    template <int dim>
    void set_boundary_ids(const FileMesh     &mesh,
                          Triangulation<dim> &triangulation)
    {
      const auto boundary = boundary_of_corners(mesh);
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            {
              Corners corners;
              for (const unsigned int v : face->vertex_indices())
                corners.push_back(face->vertex_index(v));
              std::sort(corners.begin(), corners.end());
              const auto found = boundary.find(corners);
              face->set_boundary_id(found == boundary.end() ? free_boundary
                                                            : found->second);
            }
    }
  } // namespace

  template <int dim>
  BodyMesh<dim> file_body_mesh(const FileMesh &mesh)
  {
    check_mesh_memory<dim>(mesh.cells.size(),
                           MeshKind::serial,
                           "take a coarser Mesh file.");
    std::vector<Point<dim>> vertices;
    for (const FileMesh::Point &vertex : mesh.vertices)
      {
        vertices.emplace_back();
        for (unsigned int d = 0; d < dim; ++d)
          vertices.back()[d] = vertex[d == dim - 1 ? 2 : d];
      }
    std::vector<CellData<dim>> cells;
    for (const FileMesh::Cell &corners : mesh.cells)
      {
        cells.emplace_back();
        for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
          cells.back().vertices[v] = corners[v];
      }
    BodyMesh<dim> result;
    result.triangulation = std::make_unique<Triangulation<dim>>();
    result.triangulation->create_triangulation(vertices, cells, SubCellData());
    set_boundary_ids(mesh, *result.triangulation);
    return result;
  }

  namespace
  {
    /**
     * The outward unit normal of a face.
     */
    Tensor<1, 3> normal_of(const Triangulation<3>::active_cell_iterator &cell,
                           const unsigned int                            f)
    {
      const auto   face   = cell->face(f);
      Tensor<1, 3> normal = cross_product_3d(face->vertex(3) - face->vertex(0),
                                             face->vertex(2) - face->vertex(1));
      if (normal * (face->center() - cell->center()) < 0.)
        normal = -normal;
      return normal / normal.norm();
    }
  } // namespace

  FileMesh as_file_mesh(const BodyMesh<3> &mesh,
                        const Tensor<1, 3> towards_other)
  {
    FileMesh result;
    result.dimension = 3;
    for (const Point<3> &vertex : mesh.triangulation->get_vertices())
      result.vertices.push_back({{vertex[0], vertex[1], vertex[2]}});
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      {
        result.cells.emplace_back();
        for (const unsigned int v : cell->vertex_indices())
          result.cells.back()[v] = cell->vertex_index(v);
        for (const unsigned int f : cell->face_indices())
          {
            const auto     face = cell->face(f);
            FileMesh::Face corners;
            for (const unsigned int v : face->vertex_indices())
              corners[v] = face->vertex_index(v);
            if (face->at_boundary() && face->boundary_id() == hub_boundary)
              result.hub_faces.push_back(corners);
            if (face->at_boundary() &&
                face->boundary_id() == contact_boundary &&
                normal_of(cell, f) * towards_other > least_upwards)
              result.contact_faces.push_back(corners);
          }
      }
    return result;
  }

  template BodyMesh<2> file_body_mesh(const FileMesh &);
  template BodyMesh<3> file_body_mesh(const FileMesh &);
} // namespace RollingContact
