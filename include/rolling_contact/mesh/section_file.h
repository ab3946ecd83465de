#ifndef rolling_contact_mesh_section_file_h
#define rolling_contact_mesh_section_file_h

#include <rolling_contact/mesh/mesh_file.h>

namespace RollingContact
{
  /**
   * Read the section of a body: a mesh of quadrilaterals as read_mesh_file()
   * reads one in 2D, with y across in place of x. The contact boundary must
   * pass through the origin unless a profile says where it is, and a section
   * that is revolved about an axle one
   * @p radius behind it must stay off the axle, and have that radius if the
   * name of a physical group of a Gmsh file ends with one, as "contact, radius
   * 0.46"; 0 if it is extruded. Throws InputError. Units: m.
   */
  std::shared_ptr<const FileMesh> read_section_file(const MeshFile &file,
                                                    const double    radius);
} // namespace RollingContact

#endif
