#ifndef rolling_contact_mesh_hanging_vertices_h
#define rolling_contact_mesh_hanging_vertices_h

#include <deal.II/grid/tria.h>

#include <map>
#include <utility>
#include <vector>

namespace RollingContact
{
  /**
   * Vertices in the middle of edges and faces of larger cells, which move with
   * the corners of these: shares of those corners, none of which hangs itself.
   * Units: 1.
   */
  using HangingVertices =
    std::map<unsigned int, std::vector<std::pair<unsigned int, double>>>;

  HangingVertices hanging_vertices(const dealii::Triangulation<3> &cells);
} // namespace RollingContact

#endif
