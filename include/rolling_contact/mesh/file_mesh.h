#ifndef rolling_contact_mesh_file_mesh_h
#define rolling_contact_mesh_file_mesh_h

#include <array>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * A body as read from a mesh file, in the body's own frame: z out of the
   * body, the contact point at the origin. In 2D y is zero, a cell has four
   * corners and a face two. Units: m.
   */
  struct FileMesh
  {
    using Point = std::array<double, 3>;
    using Cell  = std::array<unsigned int, 8>; ///< corners as deal.II's
    using Face  = std::array<unsigned int, 4>;

    unsigned int       dimension = 2;
    std::vector<Point> vertices;
    std::vector<Cell>  cells;
    std::vector<Face>  contact_faces;
    std::vector<Face>  hub_faces;

    Point  lower{{0., 0., 0.}}; ///< of the box around the contact faces
    Point  upper{{0., 0., 0.}};
    double depth = 0.; ///< from the contact point down to the hub

    /**
     * Number of corners of a face: 2 in 2D, 4 in 3D.
     */
    unsigned int n_corners() const
    {
      return dimension == 2 ? 2 : 4;
    }

    /**
     * Text that tells meshes apart: the numbers of nodes and cells, and a
     * checksum of all of it.
     */
    std::string fingerprint() const;
  };
} // namespace RollingContact

#endif
