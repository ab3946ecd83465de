#include <rolling_contact/mesh/file_body_mesh.h>
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
    void
    set_boundary_ids(const FileMesh &mesh, Triangulation<dim> &triangulation)
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
  BodyMesh<dim>
  file_body_mesh(const FileMesh &mesh)
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



  template BodyMesh<2>
  file_body_mesh(const FileMesh &);
  template BodyMesh<3>
  file_body_mesh(const FileMesh &);
} // namespace RollingContact
