#ifndef rolling_contact_mesh_mesh_file_h
#define rolling_contact_mesh_mesh_file_h

#include <rolling_contact/mesh/file_mesh.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace RollingContact
{
  /**
   * The mesh file of a body and how to take it. In the file x is the rolling
   * direction, y goes across and z from rail to wheel (in 2D x and z are the
   * first two coordinates), the contact point is the origin; the wheel lies
   * above it, the rail below.
   */
  struct MeshFile
  {
    std::string           section; ///< Wheel or Rail, for messages
    std::string           name;    ///< as given, for messages
    std::filesystem::path path;
    double                unit             = 1.; ///< m
    unsigned int          contact_boundary = 1;
    unsigned int          hub_boundary     = 2;
    bool                  has_hub  = true;  ///< false: nothing holds the body
    bool                  mirrored = false; ///< the wheel
    /** A section, for messages: the file's first coordinate is y, across. */
    bool is_section = false;
    /** A section under a profile: all of the contact boundary may touch, and
     * the origin need not be on it. */
    bool is_under_profile = false;
  };

  /**
   * Read a Gmsh .msh or Abaqus .inp file of quadrilaterals (2D) or hexahedra
   * (3D) and check it: boundary ids, inverted cells, separate parts, a contact
   * boundary around the origin that faces the other body. Throws InputError.
   */
  template <int dim>
  std::shared_ptr<const FileMesh> read_mesh_file(const MeshFile &file);

  /**
   * Throws an InputError that names the file and says what is wrong with it.
   */
  [[noreturn]] void reject(const MeshFile &file, const std::string &reason);

  /**
   * Calls @p read, and throws an InputError that names the file for whatever
   * that throws, except std::bad_alloc; nothing is printed.
   */
  void read_or_reject(const MeshFile              &file,
                      const unsigned int           dimension,
                      const std::function<void()> &read);
} // namespace RollingContact

#endif
