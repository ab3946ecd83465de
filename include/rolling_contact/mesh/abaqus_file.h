#ifndef rolling_contact_mesh_abaqus_file_h
#define rolling_contact_mesh_abaqus_file_h

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace RollingContact
{
  /**
   * The mesh of an Abaqus input file as its lines say it, up to the first
   * *STEP. Units: those of the file.
   */
  struct AbaqusFile
  {
    using Point = std::array<double, 3>;

    /**
     * An element: its line in the file and the numbers of its nodes, in Abaqus'
     * order.
     */
    struct Element
    {
      unsigned int      line;
      std::vector<long> corners;
    };

    /**
     * A surface: its faces, each an element from 1 on and a label from 1 on;
     * the id is the first digits in its name, 0 without.
     */
    struct Surface
    {
      std::string                        id;
      std::vector<std::pair<long, long>> faces;
    };

    std::map<long, Point> nodes;
    std::vector<Element>  elements; ///< number 1, 2, 3, ...
    std::vector<Surface>  surfaces;
  };

  /**
   * Reads an Abaqus input file. Throws std::runtime_error, with the line, for
   * what cannot be taken as it stands: elements that are no quadrilaterals (2D)
   * or hexahedra (3D) of first order, other numbers, unknown nodes, elements or
   * sets, coordinates that are none, parts that are moved or generated.
   */
  AbaqusFile read_abaqus_file(const std::string &text,
                              const unsigned int dimension);
} // namespace RollingContact

#endif
