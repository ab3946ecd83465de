#ifndef rolling_contact_contact_surface_frames_h
#define rolling_contact_contact_surface_frames_h

#include <vector>

namespace RollingContact
{
  /**
   * Where the nodes of a surface of contact that is curved across are, and how
   * their normals are turned, in the axes of the plane in which creepages and
   * resultants are given: a node is at (y, z), its normal (sin angle, cos
   * angle) in these axes and its tangent across (cos angle, - sin angle).
   * Bodies approach, and a given load acts, along the direction (- sin, cos) of
   * load_angle. Without nodes the surface is that plane, and they do so along
   * its normal. Units: m, rad.
   */
  struct SurfaceFrames
  {
    struct Node
    {
      double y, z, angle;
    };

    bool is_plane() const
    {
      return nodes.empty();
    }

    std::vector<Node> nodes;
    double            load_angle = 0.;
  };
} // namespace RollingContact

#endif
