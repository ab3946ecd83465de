#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/bodies/theta_system.h>

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

  SymmetricSparseMatrix ThetaSystem::step_matrix(const double h) const
  {
    const double          theta = parameters.theta;
    SymmetricSparseMatrix A =
      linear_combination(1 + theta * h * parameters.mass_damping,
                         M,
                         theta * h * (theta * h + parameters.stiffness_damping),
                         K);
    return D.size() == 0 ? A : linear_combination(1., A, theta * h, D);
  }

  void ThetaSystem::set_time_step(const double new_h)
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
    compliance *= new_h * new_h;
    h = new_h;
  }

  std::vector<double> ThetaSystem::on_contact(const Vector &values) const
  {
    std::vector<double> result;
    result.reserve(contact.size());
    for (const std::size_t i : contact)
      result.push_back(values[i]);
    return result;
  }

  void ThetaSystem::begin(const std::vector<Work *> &states) const
  {
    std::vector<const Vector *> b;
    std::vector<Vector *>       z;
    for (Work *state : states)
      {
        b.push_back(&state->momentum);
        z.push_back(&state->z);
      }
    factor.solve_forward(b, z);
    for (Work *state : states)
      state->free_velocity = Y.transposed_product(state->z);
  }

  void ThetaSystem::end(
    const std::vector<Work *>                      &states,
    const std::vector<const std::vector<double> *> &reactions) const
  {
    std::vector<Vector *> z, v_th;
    for (std::size_t k = 0; k < states.size(); ++k)
      {
        Y.add_product(parameters.theta * h, *reactions[k], states[k]->z);
        z.push_back(&states[k]->z);
        v_th.push_back(&states[k]->momentum);
      }
    factor.solve_backward(z, v_th);
  }

  std::vector<double>
  ThetaSystem::response(Work &, const std::vector<double> &reactions) const
  {
    return compliance * reactions;
  }

  namespace
  {
    void multiply(const SymmetricSparseMatrix &matrix,
                  const ThetaSystem::Products &products)
    {
      const auto &first = products.front(), &last = products.back();
      if (products.size() == 1)
        matrix.multiply(*first.first, *first.second);
      else
        matrix.multiply(*first.first, *first.second, *last.first, *last.second);
    }
  } // namespace

  void ThetaSystem::multiply_stiffness(const Products &products) const
  {
    multiply(K, products);
  }

  void ThetaSystem::multiply_mass(const Products &products) const
  {
    multiply(M, products);
  }

  bool ThetaSystem::multiply_damping(const Vector &x, Vector &result) const
  {
    if (D.size() > 0)
      D.multiply(x, result);
    return D.size() > 0;
  }

  std::size_t ThetaSystem::memory_consumption() const
  {
    return factor.size().memory_consumption() + Y.memory_consumption() +
           RollingContact::memory_consumption(compliance) +
           K.memory_consumption() + M.memory_consumption() +
           D.memory_consumption() + contact.capacity() * sizeof(std::size_t);
  }
} // namespace RollingContact
