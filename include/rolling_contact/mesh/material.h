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
} // namespace RollingContact

#endif
