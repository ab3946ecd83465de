#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/grid_tools.h>

#include <rolling_contact/base/captured_stderr.h>
#include <rolling_contact/base/exception_text.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/files.h>
#include <rolling_contact/mesh/abaqus_text.h>
#include <rolling_contact/mesh/gmsh_text.h>
#include <rolling_contact/mesh/mesh_file.h>
#include <rolling_contact/mesh/mesh_file_checks.h>

#include <algorithm>
#include <limits>
#include <new>
#include <sstream>
#include <system_error>
#include <tuple>

namespace RollingContact
{
  using namespace dealii;

  void reject(const MeshFile &file, const std::string &reason)
  {
    throw InputError(file.section + "/Mesh file = " + file.name + ": " +
                     reason);
  }

  void read_or_reject(const MeshFile              &file,
                      const unsigned int           dimension,
                      const std::function<void()> &read)
  {
    const CapturedStderr silence;
    try
      {
        read();
      }
    catch (const std::bad_alloc &)
      {
        throw;
      }
    catch (const ExceptionBase &error)
      {
        const std::string cause = silence.cause();
        reject(file,
               "deal.II cannot read it as a mesh of " +
                 std::string(dimension == 2 ? "quadrilaterals" : "hexahedra") +
                 (file.is_section
                    ? " (Shape = section): "
                    : " (Dimension = " + std::to_string(dimension) + "): ") +
                 (cause.empty() ? message_of(error) : cause));
      }
    catch (const std::exception &error)
      {
        reject(file, error.what());
      }
  }

  namespace
  {
    std::string text_of(const MeshFile &file)
    {
      const std::string problem = why_unreadable(file.path);
      if (!problem.empty())
        reject(file,
               "\"" + file.path.string() + "\" cannot be read: " + problem +
                 ".");
      const std::string text = read_bytes(file.path);
      if (text.empty())
        reject(file, "\"" + file.path.string() + "\" is empty.");
      return text;
    }

    template <int dim>
    void read_cells(const MeshFile &file, Triangulation<dim> &cells)
    {
      const std::string extension = file.path.extension().string(),
                        text      = text_of(file);
      const bool is_gmsh          = extension == ".msh";
      if (!is_gmsh && extension != ".inp")
        reject(file,
               "it must be a mesh of Gmsh, .msh, or an Abaqus input file, "
               ".inp.");
      read_or_reject(file, dim, [&]() {
        GridIn<dim>        reader(cells);
        std::istringstream stream(is_gmsh ? checked_gmsh(text, dim)
                                          : checked_abaqus(text, dim));
        is_gmsh ? reader.read_msh(stream) : reader.read_abaqus(stream);
      });
    }

    /**
     * Vertices and cells in the body's frame; a mirrored cell swaps its bottom
     * and top to keep its orientation.
     */
    template <int dim>
    void take_cells(const MeshFile           &file,
                    const Triangulation<dim> &triangulation,
                    FileMesh                 &mesh)
    {
      std::vector<Point<dim>>    vertices;
      std::vector<CellData<dim>> cells;
      SubCellData                boundary;
      std::tie(vertices, cells, boundary) =
        GridTools::get_coarse_mesh_description(triangulation);
      for (const Point<dim> &vertex : vertices)
        {
          mesh.vertices.push_back({{0., 0., 0.}});
          for (unsigned int d = 0; d < dim; ++d)
            mesh.vertices.back()[d == dim - 1 ? 2 : d] =
              (d == dim - 1 && file.mirrored ? -1. : 1.) * file.unit *
              vertex[d];
        }
      const unsigned int half = GeometryInfo<dim>::vertices_per_cell / 2;
      if (file.mirrored)
        {
          for (CellData<dim> &cell : cells)
            std::swap_ranges(cell.vertices.begin(),
                             cell.vertices.begin() + half,
                             cell.vertices.begin() + half);
          GridTools::consistently_order_cells(cells);
        }
      for (const CellData<dim> &cell : cells)
        {
          mesh.cells.push_back({});
          std::copy(cell.vertices.begin(),
                    cell.vertices.begin() + 2 * half,
                    mesh.cells.back().begin());
        }
    }

    /**
     * z of the outward unit normal of a face in the body's frame.
     */
    template <int dim>
    double upwards(const MeshFile                                   &file,
                   const typename Triangulation<dim>::cell_iterator &cell,
                   const typename Triangulation<dim>::face_iterator &face)
    {
      Tensor<1, dim> normal;
      if constexpr (dim == 2)
        normal = cross_product_2d(face->vertex(1) - face->vertex(0));
      else
        normal = cross_product_3d(face->vertex(3) - face->vertex(0),
                                  face->vertex(2) - face->vertex(1));
      if (normal * (face->center() - cell->center()) < 0.)
        normal = -normal;
      return (file.mirrored ? -1. : 1.) * normal[dim - 1] / normal.norm();
    }

    template <int dim>
    std::vector<ContactFace>
    take_boundary(const MeshFile           &file,
                  const Triangulation<dim> &triangulation,
                  FileMesh                 &mesh)
    {
      std::vector<ContactFace> contact_faces;
      for (const auto &cell : triangulation.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            {
              FileMesh::Face corners{};
              for (const unsigned int v : face->vertex_indices())
                corners[v] = face->vertex_index(v);
              if (face->boundary_id() == file.contact_boundary)
                contact_faces.push_back(
                  {corners, upwards<dim>(file, cell, face)});
              else if (file.has_hub && face->boundary_id() == file.hub_boundary)
                mesh.hub_faces.push_back(corners);
            }
      // of a whole rim the part towards the other body
      for (const ContactFace &face : contact_faces)
        if (file.is_under_profile || face.upwards > least_upwards)
          mesh.contact_faces.push_back(face.corners);
      return contact_faces;
    }

    /**
     * The box around the contact faces and the depth of the hub; without one,
     * of the body.
     */
    void measure(const MeshFile &file, FileMesh &mesh)
    {
      const double infinity = std::numeric_limits<double>::infinity();
      mesh.lower.fill(infinity);
      mesh.upper.fill(-infinity);
      for (const FileMesh::Face &face : mesh.contact_faces)
        for (unsigned int v = 0; v < mesh.n_corners(); ++v)
          for (unsigned int d = 0; d < 3; ++d)
            {
              const double at = mesh.vertices[face[v]][d];
              mesh.lower[d]   = std::min(mesh.lower[d], at);
              mesh.upper[d]   = std::max(mesh.upper[d], at);
            }
      mesh.depth = file.has_hub ? infinity : 0.;
      for (const FileMesh::Face &face : mesh.hub_faces)
        for (unsigned int v = 0; v < mesh.n_corners(); ++v)
          mesh.depth = std::min(mesh.depth, -mesh.vertices[face[v]][2]);
      if (!file.has_hub)
        for (const FileMesh::Point &vertex : mesh.vertices)
          mesh.depth = std::max(mesh.depth, -vertex[2]);
    }
  } // namespace

  template <int dim>
  std::shared_ptr<const FileMesh> read_mesh_file(const MeshFile &file)
  {
    Triangulation<dim> triangulation;
    read_cells(file, triangulation);
    check_cells(file, triangulation);
    check_boundary_ids(file, triangulation);
    const auto mesh = std::make_shared<FileMesh>();
    mesh->dimension = dim;
    take_cells(file, triangulation, *mesh);
    const auto contact_faces = take_boundary(file, triangulation, *mesh);
    measure(file, *mesh);
    check_contact_boundary(file, *mesh, contact_faces);
    return mesh;
  }

  template std::shared_ptr<const FileMesh> read_mesh_file<2>(const MeshFile &);
  template std::shared_ptr<const FileMesh> read_mesh_file<3>(const MeshFile &);
} // namespace RollingContact
