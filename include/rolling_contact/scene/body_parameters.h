#ifndef rolling_contact_scene_body_parameters_h
#define rolling_contact_scene_body_parameters_h

#include <deal.II/base/parameter_acceptor.h>

#include <rolling_contact/elasticity/material.h>
#include <rolling_contact/mesh/geometry.h>
#include <rolling_contact/mesh_files/file_mesh.h>

#include <filesystem>
#include <string>

namespace RollingContact
{
  /**
   * Section `Wheel` or `Rail`: shape and material of one body.
   */
  struct BodyParameters : public dealii::ParameterAcceptor
  {
    explicit BodyParameters(const std::string &section);

    /**
     * Rules across entries. Throws InputError.
     */
    void
    check(const unsigned int dimension) const;

    /**
     * Read the mesh file, if there is one, from @p folder. Throws InputError.
     */
    void
    read_mesh(const unsigned int           dimension,
              const std::filesystem::path &folder);

    /**
     * That of a body from a file needs read_mesh().
     */
    BodyGeometry
    geometry() const;

    bool
    is_from_file() const
    {
      return shape == "mesh file";
    }

    std::string  section;
    std::string  shape          = "disc";
    bool         rigid          = false;
    double       radius         = 0.46;
    double       lateral_radius = 0.;
    double       hub_radius     = 0.08;
    double       block_length   = 1.;
    double       block_depth    = 0.5;
    double       thickness      = 0.02;
    double       width          = 0.1;
    std::string  hub            = "clamped";
    std::string  mesh_file;
    double       mesh_unit        = 1.;
    unsigned int contact_boundary = 1;
    unsigned int hub_boundary     = 2;
    std::string  surface          = "radii";
    Material     material         = {210e9, 0.3};

  private:
    void
    declare_profile();

    void
    declare_extent();

    void
    declare_mesh_file();

    void
    declare_material();

    void
    check_fall(const unsigned int dimension) const;

    void
    check_material(const unsigned int dimension) const;

    void
    check_mesh_file() const;

    std::shared_ptr<const FileMesh> mesh;
  };
} // namespace RollingContact

#endif
