#ifndef rolling_contact_pair_pair_demands_h
#define rolling_contact_pair_pair_demands_h

#include <memory>

namespace RollingContact
{
  class SplitBodies;

  /**
   * What an analysis demands of the bodies, beyond what the scene says.
   */
  struct PairDemands
  {
    /** Displacements inside the bodies will be asked for. */
    bool displacements = false;
    /** How far off the compliance is for want of elements in the bulk will be
     * asked for. */
    bool bulk_errors = false;
    /** Modes of the bodies and displacements by them will be asked for, so
     * that bodies keep their factors. */
    bool modes = false;
    /** The compliance must be exact: bodies are factorised. */
    bool factors = false;
    /** Surfaces that move are left out of the gap: each step of time brings
     * its own. */
    bool surfaces_in_time = false;
    /** Where split bodies are kept for other meshes; none: they are not. */
    std::shared_ptr<SplitBodies> split_bodies;

    /** Displacements of whole bodies will be asked for. */
    bool whole_bodies() const
    {
      return displacements || modes;
    }
  };
} // namespace RollingContact

#endif
