#ifndef rolling_contact_scene_body_parameters_h
#define rolling_contact_scene_body_parameters_h

#include <deal.II/base/parameter_acceptor.h>

#include <rolling_contact/elasticity/material.h>
#include <rolling_contact/mesh/body_shape.h>

#include <filesystem>
#include <string>

namespace RollingContact
{
  /**
   * Section `Wheel` or `Rail`: shape and material of one body.
   */
  struct BodyParameters
    : public dealii::ParameterAcceptor
    , public ShapeParameters
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
     * The shape of the name `shape`; one from a file needs read_mesh().
     */
    std::shared_ptr<const BodyShape>
    body_shape() const;

    bool
    is_from_file() const;

    std::string shape     = "disc";
    bool        rigid     = false;
    double      thickness = 0.02;
    std::string surface   = "radii";
    Material    material  = {210e9, 0.3};

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
    check_material(const unsigned int dimension) const;
  };
} // namespace RollingContact

#endif
