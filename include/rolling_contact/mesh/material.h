#ifndef rolling_contact_mesh_material_h
#define rolling_contact_mesh_material_h

namespace RollingContact
{
  /**
   * Isotropic linear elasticity. Units: Pa, 1, kg/m^3.
   */
  struct Material
  {
    double young_modulus = 0.;
    double poisson_ratio = 0.;
    double density       = 7800.;

    double shear_modulus() const
    {
      return young_modulus / (2 * (1 + poisson_ratio));
    }

    double bulk_modulus() const
    {
      return young_modulus / (3 * (1 - 2 * poisson_ratio));
    }

    bool operator==(const Material &other) const
    {
      return young_modulus == other.young_modulus &&
             poisson_ratio == other.poisson_ratio && density == other.density;
    }
  };

  /**
   * Material ids of the cells of every body mesh.
   */
  enum MaterialId : unsigned int
  {
    core_material  = 0,
    cover_material = 1
  };

  /**
   * Materials of a body by the ids of its cells: that of its core, and of the
   * cover bonded on it, which is the core's where there is none.
   */
  struct Materials
  {
    Materials(const Material &core)
      : Materials(core, core)
    {}

    Materials(const Material &core, const Material &cover)
      : core(core)
      , cover(cover)
    {}

    const Material &of(const unsigned int material_id) const
    {
      return material_id == cover_material ? cover : core;
    }

    bool operator==(const Materials &other) const
    {
      return core == other.core && cover == other.cover;
    }

    Material core, cover;
  };
} // namespace RollingContact

#endif
