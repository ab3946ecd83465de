#include "input_parts.h"

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/mesh/section_file.h>

#include <algorithm>

using namespace RollingContact;

namespace
{
  /** Numbers of corners are those of vertices, and all is finite. */
  void check_mesh(const FileMesh &mesh)
  {
    const std::size_t n = mesh.vertices.size();
    for (const auto &vertex : mesh.vertices)
      for (const double x : vertex)
        must(std::isfinite(x), "a vertex is not finite");
    for (const auto &cell : mesh.cells)
      must(std::max({cell[0], cell[1], cell[2], cell[3]}) < n,
           "a cell has a corner that is not there");
    for (const auto *faces : {&mesh.contact_faces, &mesh.hub_faces})
      for (const auto &face : *faces)
        must(std::max(face[0], face[1]) < n,
             "an edge has an end that is not there");
    must(!mesh.cells.empty() && !mesh.contact_faces.empty(), "it is empty");
    must(std::isfinite(mesh.depth) && mesh.depth > 0., "it has no depth");
  }

  /** Lines of format 2.2: edges of a boundary. */
  std::string edges(const std::vector<FileMesh::Face> &faces,
                    const unsigned int                 boundary,
                    std::size_t                       &number)
  {
    std::string text;
    for (const auto &face : faces)
      text += std::to_string(++number) + " 1 2 " + std::to_string(boundary) +
              " 1 " + std::to_string(face[0] + 1) + ' ' +
              std::to_string(face[1] + 1) + '\n';
    return text;
  }

  /** As a file of Gmsh, of a rail in m. */
  std::string gmsh_of(const FileMesh &mesh)
  {
    std::string nodes, elements;
    std::size_t node = 0, element = 0;
    for (const auto &vertex : mesh.vertices)
      nodes += std::to_string(++node) + ' ' + written(vertex[0]) + ' ' +
               written(vertex[2]) + " 0\n";
    elements =
      edges(mesh.contact_faces, 1, element) + edges(mesh.hub_faces, 2, element);
    for (const auto &cell : mesh.cells)
      {
        elements += std::to_string(++element) + " 3 2 3 1";
        for (const unsigned int corner : {0, 1, 3, 2})
          elements += ' ' + std::to_string(cell[corner] + 1);
        elements += '\n';
      }
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" +
           std::to_string(node) + '\n' + nodes + "$EndNodes\n$Elements\n" +
           std::to_string(element) + '\n' + elements + "$EndElements\n";
  }

  /** What was read as a rail's section, written and read again, has the same
   * vertices and as many cells and edges. */
  void write_and_read(const FileMesh &mesh, MeshFile file)
  {
    file.name             = "again.msh";
    file.path             = file.name;
    file.unit             = 1.;
    file.contact_boundary = 1;
    write_part(file.name, {gmsh_of(mesh)}, 0);
    const auto again  = read_section_file(file, 0.);
    auto       before = mesh.vertices, behind = again->vertices;
    std::sort(before.begin(), before.end());
    std::sort(behind.begin(), behind.end());
    must(before == behind, "other vertices");
    must(again->cells.size() == mesh.cells.size() &&
           again->contact_faces.size() == mesh.contact_faces.size() &&
           again->hub_faces.size() == mesh.hub_faces.size(),
         "other cells or edges");
  }
} // namespace

/** Parts: letters for options (r: revolved, w: a wheel's, p: under a profile,
 * m: metres), a mesh of Gmsh if it begins with a dollar, else of Abaqus. */
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data,
                                      const std::size_t   size)
{
  const auto parts = input_parts(data, size);
  if (parts.size() < 2)
    return 0;
  const auto has = [&](const char letter) {
    return parts[0].find(letter) != std::string::npos;
  };
  MeshFile file;
  file.section          = has('w') ? "Wheel" : "Rail";
  file.name             = parts[1][0] == '$' ? "section.msh" : "section.inp";
  file.path             = file.name;
  file.unit             = has('m') ? 1. : 1e-3;
  file.mirrored         = has('w');
  file.has_hub          = !has('w');
  file.is_section       = true;
  file.is_under_profile = has('p');
  write_part(file.name, parts, 1);
  std::shared_ptr<const FileMesh> mesh;
  try
    {
      mesh = read_section_file(file, has('r') ? 0.46 : 0.);
    }
  catch (const InputError &error)
    {
      must_name(error, file.name);
      return 0;
    }
  check_mesh(*mesh);
  if (!file.mirrored)
    write_and_read(*mesh, file);
  return 0;
}
