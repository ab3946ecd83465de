#ifndef rolling_contact_scene_body_parameters_h
#define rolling_contact_scene_body_parameters_h

#include <rolling_contact/elasticity/absorber_ring.h>
#include <rolling_contact/elasticity/body_model.h>
#include <rolling_contact/elasticity/material.h>
#include <rolling_contact/mesh/body_shape.h>

#include <filesystem>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace RollingContact
{
  /**
   * What gives the undeformed surface of a body from a mesh file.
   */
  enum class SurfaceSource
  {
    radii,
    nodes
  };

  /**
   * Absorbers on a wheel as the entries have them: lists with a value for each
   * ring, or one value for all.
   */
  struct DamperEntries
  {
    std::vector<double> number; ///< in each ring; empty: none
    std::vector<double> mass, frequency, damping_ratio, radius, position;
    std::string         direction = "axial";
  };

  /**
   * Section `Wheel` or `Rail`: shape, material and model of one body.
   */
  struct BodyParameters : public ShapeParameters
  {
    explicit BodyParameters(const std::string &section);

    void
    declare(dealii::ParameterHandler &prm);

    /**
     * Rules across entries. Throws InputError.
     */
    void
    check(const unsigned int dimension) const;

    /**
     * Throws InputError if the body has no static compliance: nothing but
     * inertia holds it along some axis.
     */
    void
    check_held(const unsigned int dimension) const;

    /**
     * Read the mesh or section file of an elastic body, if there is one, from
     * @p folder; a section under a profile has the axes of that. Throws
     * InputError.
     */
    void
    read_mesh(const unsigned int           dimension,
              const std::filesystem::path &folder,
              const bool                   is_under_profile = false);

    /**
     * That with a true section if there is a `profile` and no file, else the
     * shape of the name `shape`; one from a file needs read_mesh().
     */
    std::shared_ptr<const BodyShape>
    body_shape() const;

    /**
     * The absorbers that hang on it. Throws InputError if the lists of entries
     * do not fit each other or a value is not allowed.
     */
    std::vector<AbsorberRing>
    absorbers() const;

    /**
     * Whether it is elastic with a mesh or a section from a file.
     */
    bool
    is_from_file() const;

    /**
     * Whether it is elastic with a section from a file.
     */
    bool
    is_section() const;

    std::string   shape     = "disc";
    bool          rigid     = false;
    double        thickness = 0.02;
    SurfaceSource surface   = SurfaceSource::radii;
    Material      material  = {210e9, 0.3};
    BodyModel     model;
    DamperEntries dampers;
    double        thermal_conductivity = 50.;  ///< W/(m K)
    double        heat_capacity        = 460.; ///< J/(kg K)
    std::string   velocity_points;             ///< see read_velocity_points()

  private:
    void
    declare_profile(dealii::ParameterHandler &prm);

    void
    declare_extent(dealii::ParameterHandler &prm);

    void
    declare_mesh_file(dealii::ParameterHandler &prm);

    void
    declare_material(dealii::ParameterHandler &prm);

    void
    declare_points(dealii::ParameterHandler &prm);

    void
    declare_hub(dealii::ParameterHandler &prm);

    void
    declare_foundation(dealii::ParameterHandler &prm);

    void
    declare_damping(dealii::ParameterHandler &prm);

    void
    declare_dampers(dealii::ParameterHandler &prm);

    void
    check_material(const unsigned int dimension) const;

    /**
     * Rules for what is at the hub and for damping.
     */
    void
    check_model() const;

    void
    check_foundation() const;

    /**
     * Throws InputError unless a pad lies wholly within @p reach of x = 0.
     */
    void
    check_pads_on(const double reach) const;

    void
    check_damping() const;

    void
    check_dampers(const unsigned int dimension) const;
  };
} // namespace RollingContact

#endif
