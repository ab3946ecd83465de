#ifndef rolling_contact_scene_body_parameters_h
#define rolling_contact_scene_body_parameters_h

#include <rolling_contact/mesh/absorber_ring.h>
#include <rolling_contact/mesh/body_model.h>
#include <rolling_contact/mesh/body_shape.h>
#include <rolling_contact/mesh/material.h>

#include <filesystem>
#include <optional>
#include <string>

namespace RollingContact
{
  class Entries;
  struct Reader;

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

    void declare(Entries &entries);

    /**
     * Rules across entries. Throws InputError.
     */
    void check(const unsigned int dimension) const;

    /**
     * Throws InputError if the body has no static compliance: nothing but
     * inertia holds it along some axis.
     */
    void check_held(const unsigned int dimension) const;

    /**
     * The absorbers that hang on it. Throws InputError if the lists of entries
     * do not fit each other or a value is not allowed.
     */
    std::vector<AbsorberRing> absorbers() const;

    /**
     * Whether it is elastic with a mesh or a section from a file.
     */
    bool is_from_file() const;

    /**
     * Whether it is elastic with a section from a file.
     */
    bool is_section() const;

    /**
     * Whether it is elastic and has a layer of another material on its core.
     */
    bool has_cover() const
    {
      return !rigid && cover_thickness > 0.;
    }

    Materials materials() const
    {
      return has_cover() ? Materials(material, cover) : Materials(material);
    }

    /**
     * The material that touches the other body.
     */
    const Material &surface_material() const
    {
      return has_cover() ? cover : material;
    }

    std::string   shape     = "disc";
    bool          rigid     = false;
    double        thickness = 0.02;
    SurfaceSource surface   = SurfaceSource::radii;
    Material      material  = {210e9, 0.3};
    Material      cover     = {5e6, 0.49, 1100.}; ///< if it has a thickness
    BodyModel     model;
    ModeModel     modes = ModeModel::mesh;
    DamperEntries dampers;
    double        thermal_conductivity = 50.;    ///< W/(m K)
    double        heat_capacity        = 460.;   ///< J/(kg K)
    double        temperature          = 293.15; ///< far from the contact, K
    std::string   velocity_points;               ///< see read_velocity_points()

  protected:
    /**
     * Rules of the entries and of a shape made of them; @p is_read: it has all
     * of its files, so that its size and axle are known. Throws InputError.
     */
    void check_with(const BodyShape   &body_shape,
                    const bool         is_read,
                    const unsigned int dimension) const;

  private:
    /**
     * A reader that looks at this body in a scene.
     */
    Reader reader(bool (*reads)(const BodyParameters &),
                  const std::string &otherwise) const;

    /**
     * Who reads entries on the damping of the body, and on that of its modes.
     */
    std::vector<Reader> readers_of_damping() const;

    static Reader analyses_of_modes();

    void declare_profile(Entries &entries);

    void declare_mesh_file(Entries &entries);

    void declare_material(Entries &entries);

    void declare_cover(Entries &entries);

    void declare_hub(Entries &entries);

    void declare_foundation(Entries &entries);

    void declare_damping(Entries &entries);

    void declare_modes(Entries &entries);

    void declare_dampers(Entries &entries);

    void check_material(const unsigned int dimension) const;

    void check_cover() const;

    /**
     * Rules for what is at the hub and for damping; @p body_shape: of a body
     * whose files are read, else nullptr.
     */
    void check_model(const BodyShape *body_shape) const;

    void check_foundation(const BodyShape *body_shape) const;

    /**
     * Throws InputError unless a pad lies wholly within @p reach of x = 0.
     */
    void check_pads_on(const double reach) const;

    void check_damping(const BodyShape *body_shape) const;

    void check_modes(const BodyShape   *body_shape,
                     const unsigned int dimension) const;

    void check_waveguide(const BodyShape *body_shape) const;

    void check_dampers(const BodyShape   *body_shape,
                       const unsigned int dimension) const;
  };

  /**
   * A body: its entries, and what the files they name hold.
   */
  struct BodySpec : public BodyParameters
  {
    explicit BodySpec(const BodyParameters &entries)
      : BodyParameters(entries)
    {}

    /**
     * Read the mesh or section file of an elastic body, if there is one, from
     * @p folder; a section under a profile has the axes of that. Throws
     * InputError.
     */
    void read_mesh(const unsigned int           dimension,
                   const std::filesystem::path &folder,
                   const bool                   is_under_profile = false);

    /**
     * Rules across entries and files. Throws InputError.
     */
    void check(const unsigned int dimension) const;

    /**
     * The shape with a true section if there is a profile and no file, else
     * that of the name `shape`.
     */
    std::shared_ptr<const BodyShape> body_shape() const;

    /** Hold a hub that is fixed to a free mass, as rest needs it; vibrations
     * move it, see AxleMotion. */
    void hold_axle();

    /** The mass that a hub which is held at rest moves with in vibrations. */
    std::optional<HubMass> axle_mass;

    /** Whether nothing but its inertia holds the body along z as it moves. */
    bool moves_along_z() const
    {
      return !rigid && (is_loose(hub) || axle_mass);
    }

    std::shared_ptr<const FileMesh>      mesh;    ///< none: it has no file
    std::shared_ptr<const PlacedProfile> profile; ///< see ShapeSpec
  };
} // namespace RollingContact

#endif
