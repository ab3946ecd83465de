#ifndef rolling_contact_pair_mesh_file_coupling_h
#define rolling_contact_pair_mesh_file_coupling_h

#include <rolling_contact/interface/surface_coupling.h>
#include <rolling_contact/interface/trace.h>
#include <rolling_contact/scene/scene_parameters.h>

namespace RollingContact
{
  /**
   * What the log tells of it.
   */
  struct SurfaceNote
  {
    std::string text;
    std::string warning; ///< if its faces are longer than the interface's
  };

  /**
   * The contact surface of a body from a file as the interface sees it.
   */
  struct FileSurface
  {
    SurfaceCoupling           coupling;
    std::vector<unsigned int> vertices; ///< of the mesh: the contact nodes
    std::vector<double>       heights;  ///< at the interface's nodes, or empty
    std::array<double, 2>     face_size{{0., 0.}}; ///< the largest, in x and y
    SurfaceNote               note;
  };

  /**
   * Couple the wheel or the rail, read from a file, to the interface. Throws
   * InputError if its contact boundary ends in the zone, is too coarse, folded
   * or clamped there, or does not lie on its radii: within 1 % of the largest
   * gap in the zone, or half of it if the nodes themselves are the surface.
   */
  FileSurface
  couple_to_interface(const SceneParameters &scene,
                      const Side             side,
                      const Trace           &interface);

  /**
   * Throws InputError if the interface's elements are less than 1.2 times as
   * long as the faces of the surface. Where no generated body carries its
   * nodes, pressures that alternate from node to node would deform nothing.
   */
  void
  check_resolution(const SceneParameters &scene,
                   const Side             side,
                   const FileSurface     &surface,
                   const double           element_size_x,
                   const double           element_size_y);
} // namespace RollingContact

#endif
