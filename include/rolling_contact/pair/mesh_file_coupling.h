#ifndef rolling_contact_pair_mesh_file_coupling_h
#define rolling_contact_pair_mesh_file_coupling_h

#include <rolling_contact/contact/surface_coupling.h>
#include <rolling_contact/contact/trace.h>
#include <rolling_contact/scene/pair_spec.h>

namespace RollingContact
{
  /**
   * Text for the log about the coupling of a body from a mesh file.
   */
  struct SurfaceNote
  {
    std::string text;
    std::string warning; ///< empty unless faces are longer than the elements
  };

  /**
   * The axes of the contact in those of a body that keeps the axes of its
   * profile: they are turned about x, tangent across (cos, -sin) and normal
   * (sin, cos) of the angle in its (y, z), about their origin. Other bodies
   * have the axes of the contact. Units: rad, m.
   */
  struct AxesOfContact
  {
    double angle = 0., y = 0., z = 0.;
  };

  /**
   * The contact surface of a body from a mesh file and its coupling to the
   * interface. Units: m.
   */
  struct FileSurface
  {
    SurfaceCoupling           coupling;
    std::vector<unsigned int> vertices; ///< of the file's mesh: contact nodes
    std::vector<double>   heights; ///< at the interface's nodes; empty by radii
    std::array<double, 2> face_size{{0., 0.}}; ///< of the largest face, x and y
    AxesOfContact         axes;
    SurfaceNote           note;
  };

  /**
   * Couple the body of a side, with this @p mesh from a file or of a section
   * from a file, to the interface. Throws InputError if its contact boundary
   * ends in the zone of contact nodes, is too coarse, folded or clamped there,
   * or is farther from the surface given by its radii than 1 % of the largest
   * gap in the zone (half of that gap if the nodes themselves give the
   * surface), or, with profiles, is not on the body's. @p mesh is in the axes
   * of the body. Needs no other rank.
   */
  FileSurface couple_to_interface(const PairSpec &scene,
                                  const Side      side,
                                  const FileMesh &mesh,
                                  const Trace    &interface);

  /**
   * Throw InputError if the elements of an interface whose nodes no generated
   * body has on its surface are less than 1.2 times as long as the faces of
   * @p surface: pressures that alternate from node to node would deform
   * nothing. Units: m.
   */
  void check_resolution(const PairSpec    &scene,
                        const Side         side,
                        const FileSurface &surface,
                        const double       element_size_x,
                        const double       element_size_y);
} // namespace RollingContact

#endif
