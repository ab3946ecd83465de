#ifndef rolling_contact_scene_contact_parameters_h
#define rolling_contact_scene_contact_parameters_h

#include <rolling_contact/base/asked_forces.h>
#include <rolling_contact/base/creepages.h>
#include <rolling_contact/contact/friction_law.h>
#include <rolling_contact/contact/operators.h>

#include <optional>
#include <string>

namespace RollingContact
{
  class Entries;

  /**
   * Section `Contact`: load, creepages, friction and the choice of operators.
   */
  struct ContactParameters
  {
    void declare(Entries &entries);

    /**
     * Rules across entries. Throws InputError. @p needs_load: whether a load or
     * an approach is to be given.
     */
    void check(const unsigned int dimension,
               const bool         needs_load = true) const;

    /**
     * The law by which mu falls; nullptr if it is constant.
     */
    std::shared_ptr<const FrictionLaw> falling_friction() const;

    /**
     * Whether mu follows neither the slip nor the temperature.
     */
    bool has_constant_friction() const
    {
      return !falling_friction() && friction_over_temperature.empty();
    }

    /**
     * The creepages with x and y as they follow from creepage_size, if that is
     * given.
     */
    Creepages asked_creepages() const;

    /**
     * Rolling speed, 1 where it is not given. Units: m/s.
     */
    double rolling_speed() const
    {
      return speed.value_or(1.);
    }

    /**
     * Direction of the material flow along x, the sign of the speed.
     */
    int flow() const
    {
      return rolling_speed() < 0. ? -1 : 1;
    }

    /** One of them is given. In a Situation, the normal load of a vertical one
     * is what it is without friction, and a state finds its own. Units: N, m.
     */
    std::optional<double> normal_load, vertical_load, approach;
    double                friction_coefficient = 0.3;
    std::string           friction_law         = "constant";
    double                kinetic_friction     = 0.; ///< of the laws that fall
    double friction_decay_speed   = 0.; ///< of the laws that fall, m/s
    double friction_memory_length = 0.; ///< of the laws that fall, m
    /** How such a law follows vibration: `automatic` or a FrictionResponse. */
    std::string friction_response = "automatic";
    double      friction_memory   = 60e-6; ///< of `patch mean`, s
    std::string friction_over_temperature; ///< as HotFriction takes it
    Creepages   creepages;
    /**
     * Length of creepages.x and y together, which follow from it and the angle
     * from x towards y (rad).
     */
    std::optional<double> creepage_size;
    double                creepage_direction = 0.;
    AskedForces           forces; ///< in place of creepages
    std::optional<double> speed;  ///< m/s
    SlipOperatorKind      slip_operator    = SlipOperatorKind::calibrated;
    ContactMatrices       contact_matrices = ContactMatrices::lumped;
    std::string           roughness;

  private:
    void declare_load(Entries &entries);

    void declare_friction(Entries &entries);

    void declare_rolling(Entries &entries);

    void check_load(const bool needs_load) const;

    void check_friction_law() const;

    void check_forces(const unsigned int dimension) const;
  };
} // namespace RollingContact

#endif
