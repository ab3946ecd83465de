#ifndef rolling_contact_scene_contact_parameters_h
#define rolling_contact_scene_contact_parameters_h

#include <deal.II/base/parameter_acceptor.h>

#include <rolling_contact/base/creepages.h>
#include <rolling_contact/contact/friction_law.h>
#include <rolling_contact/interface/operators.h>

#include <optional>
#include <string>

namespace RollingContact
{
  /**
   * Section `Contact`: load, creepages, friction and the choice of operators.
   */
  struct ContactParameters : public dealii::ParameterAcceptor
  {
    ContactParameters();

    /**
     * Rules across entries. Throws InputError.
     */
    void
    check(const unsigned int dimension) const;

    /**
     * None when the entry is empty. Throws InputError.
     */
    std::optional<double>
    normal_load() const;

    std::optional<double>
    approach() const;

    SlipOperatorKind
    slip_operator_kind() const;

    ContactMatrices
    contact_matrices_kind() const;

    /**
     * The law by which mu falls; none if it is constant.
     */
    std::shared_ptr<const FrictionLaw>
    falling_friction() const;

    /**
     * Direction of the material flow along x, the sign of the speed.
     */
    int
    flow() const
    {
      return speed < 0. ? -1 : 1;
    }

    std::string normal_load_entry;
    std::string approach_entry;
    double      friction_coefficient = 0.3;
    std::string friction_law         = "constant";
    double      kinetic_friction     = 0.; ///< of the laws that fall
    double      friction_decay_speed = 0.; ///< of the laws that fall, m/s
    Creepages   creepages;
    std::string speed_entry;
    double      speed            = 1.;
    bool        speed_is_given   = true;
    std::string slip_operator    = "calibrated";
    std::string contact_matrices = "lumped";
    std::string roughness;

  private:
    void
    declare_load();

    void
    declare_friction();

    void
    declare_rolling();

    void
    declare_operators();

    void
    read_speed();

    void
    check_friction_law() const;
  };
} // namespace RollingContact

#endif
