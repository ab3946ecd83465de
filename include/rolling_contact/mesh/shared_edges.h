#ifndef rolling_contact_mesh_shared_edges_h
#define rolling_contact_mesh_shared_edges_h

#include <utility>
#include <vector>

namespace RollingContact
{
  /**
   * The edges of quadrilaterals, by the numbers of their nodes.
   */
  class SharedEdges
  {
  public:
    /**
     * Adds the four edges of a quadrilateral whose corners are given one after
     * another around it.
     */
    void add(const std::vector<long> &corners);

    /**
     * Throws std::runtime_error, naming its nodes, if three quadrilaterals or
     * more have an edge: deal.II would look for their orientation without end.
     */
    void check() const;

  private:
    std::vector<std::pair<long, long>> edges; ///< the lesser number first
  };
} // namespace RollingContact

#endif
