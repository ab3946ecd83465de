#ifndef rolling_contact_mesh_cover_cells_h
#define rolling_contact_mesh_cover_cells_h

#include <rolling_contact/mesh/body_shape.h>

#include <vector>

namespace RollingContact
{
  /**
   * Ends of the coarse cells of a body in depth, ascending to 0: growing parts
   * from the surface down, with one end at the bottom of its cover. Through the
   * cover there are cells enough for several elements under the contact, where
   * each cell is halved until @p n_elements are along it. Units: m.
   */
  std::vector<double> breaks_in_depth(const BodyShape   &shape,
                                      const CoarseCells &down,
                                      const double       n_elements);

  /**
   * Ends of coarse cells in depth that are all alike in the core, and alike in
   * the cover, none longer than @p longest (m), ascending to 0.
   */
  std::vector<double> equal_breaks_in_depth(const BodyShape &shape,
                                            const double     longest);
} // namespace RollingContact

#endif
