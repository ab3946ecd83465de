#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/dynamics/theta_system.h>

#include <cmath>
#include <string>
#include <utility>

namespace RollingContact
{
  ThetaSystem::ThetaSystem(const ThetaScheme               &scheme,
                           SymmetricSparseMatrix            stiffness,
                           SymmetricSparseMatrix            mass,
                           const std::vector<unsigned int> &node_of_unknown,
                           std::vector<std::size_t>         contact_unknowns,
                           SymmetricSparseMatrix            damping)
    : parameters(scheme)
    , K(std::move(stiffness))
    , M(std::move(mass))
    , D(std::move(damping))
    , contact(std::move(contact_unknowns))
    , factor(step_matrix(1.), node_of_unknown)
  {
    parameters.check();
  }



  SymmetricSparseMatrix
  ThetaSystem::step_matrix(const double h) const
  {
    const double          theta = parameters.theta;
    SymmetricSparseMatrix A =
      linear_combination(1 + theta * h * parameters.mass_damping,
                         M,
                         theta * h * (theta * h + parameters.stiffness_damping),
                         K);
    return D.size() == 0 ? A : linear_combination(1., A, theta * h, D);
  }



  void
  ThetaSystem::set_time_step(const double new_h)
  {
    if (!(new_h > 0. && std::isfinite(new_h)))
      throw InputError("Time step " + std::to_string(new_h) +
                       " s: it must be above 0.");
    if (new_h == h)
      return;
    h          = 0.;
    Y          = CondensedColumns();
    compliance = DenseMatrix();
    factor.factorise(step_matrix(new_h));
    compliance = factor.condense(contact, &Y);
    for (std::size_t j = 0; j < contact.size(); ++j)
      for (std::size_t i = 0; i < contact.size(); ++i)
        compliance(i, j) *= new_h * new_h;
    h = new_h;
  }



  std::size_t
  ThetaSystem::memory_consumption() const
  {
    return factor.size().memory_consumption() + Y.memory_consumption() +
           compliance.memory_consumption() + K.memory_consumption() +
           M.memory_consumption() + D.memory_consumption() +
           contact.capacity() * sizeof(std::size_t);
  }
} // namespace RollingContact
