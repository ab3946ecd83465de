#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/bodies/theta_scheme.h>

#include <string>

namespace RollingContact
{
  void ThetaScheme::check() const
  {
    if (!(theta >= 0.5 && theta <= 1.))
      throw InputError("theta = " + std::to_string(theta) +
                       ": the scheme is stable for every step from 0.5 to 1.");
    if (!(mass_damping >= 0. && stiffness_damping >= 0.))
      throw InputError("Rayleigh damping of " + std::to_string(mass_damping) +
                       " 1/s and " + std::to_string(stiffness_damping) +
                       " s: neither may be negative.");
  }

  void StepEnergy::balance(const double energy_before)
  {
    balance_error = kinetic + strain - energy_before - contact_work -
                    load_work + damping + numerical_dissipation;
  }

  void StepEnergy::add_changes(const StepEnergy &other)
  {
    contact_work += other.contact_work;
    load_work += other.load_work;
    damping += other.damping;
    numerical_dissipation += other.numerical_dissipation;
    balance_error += other.balance_error;
  }
} // namespace RollingContact
