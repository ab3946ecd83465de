#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/dynamics/theta_scheme.h>

#include <string>

namespace RollingContact
{
  void
  ThetaScheme::check() const
  {
    if (!(theta >= 0.5 && theta <= 1.))
      throw InputError("theta = " + std::to_string(theta) +
                       ": the scheme is stable for every step from 0.5 to 1.");
    if (!(mass_damping >= 0. && stiffness_damping >= 0.))
      throw InputError("Rayleigh damping of " + std::to_string(mass_damping) +
                       " 1/s and " + std::to_string(stiffness_damping) +
                       " s: neither may be negative.");
  }



  std::vector<double>
  ThetaScheme::end_velocity(const std::vector<double> &theta_velocity,
                            const std::vector<double> &velocity) const
  {
    std::vector<double> end(velocity.size());
    for (std::size_t i = 0; i < end.size(); ++i)
      end[i] = (theta_velocity[i] - (1 - theta) * velocity[i]) / theta;
    return end;
  }



  std::vector<double>
  end_displacement(const std::vector<double> &theta_velocity,
                   const std::vector<double> &displacement,
                   const double               h)
  {
    std::vector<double> end(displacement);
    for (std::size_t i = 0; i < end.size(); ++i)
      end[i] += h * theta_velocity[i];
    return end;
  }



  void
  StepEnergy::add_displacement(const ThetaScheme &scheme,
                               const double       h,
                               const double       u_K_u,
                               const double       v_K_du)
  {
    strain = u_K_u / 2;
    damping += scheme.stiffness_damping * v_K_du;
    numerical_dissipation += (scheme.theta - 0.5) * h * v_K_du;
  }



  void
  StepEnergy::add_velocity(const ThetaScheme &scheme,
                           const double       h,
                           const double       v_M_v,
                           const double       dv_M_dv,
                           const double       theta_v_M_v)
  {
    kinetic = v_M_v / 2;
    damping += h * scheme.mass_damping * theta_v_M_v;
    numerical_dissipation += (scheme.theta - 0.5) * dv_M_dv;
  }



  void
  StepEnergy::balance(const double energy_before)
  {
    balance_error = kinetic + strain - energy_before - contact_work -
                    load_work + damping + numerical_dissipation;
  }



  void
  StepEnergy::add_changes(const StepEnergy &other)
  {
    contact_work += other.contact_work;
    load_work += other.load_work;
    damping += other.damping;
    numerical_dissipation += other.numerical_dissipation;
    balance_error += other.balance_error;
  }
} // namespace RollingContact
