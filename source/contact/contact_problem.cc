#include <rolling_contact/contact/contact_problem.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace RollingContact
{
  namespace
  {
    /**
     * The block of W on the given component times H.
     */
    DenseMatrix
    compliance_of_density(const ContactProblem &problem,
                          const std::size_t     first,
                          const std::size_t     n)
    {
      DenseMatrix result(n, n);
      for (std::size_t k = 0; k < n; ++k)
        for (const auto &entry : problem.H[k % problem.n_nodes])
          {
            const std::size_t j = k - k % problem.n_nodes + entry.first;
            for (std::size_t i = 0; i < n; ++i)
              result(i, j) += problem.W(first + i, first + k) * entry.second;
          }
      return result;
    }



    /**
     * Largest singular value of an operator from products with it and its
     * transpose; to the few digits an augmentation parameter needs.
     */
    template <typename Product, typename TransposedProduct>
    double
    operator_norm(const std::size_t        n,
                  const Product           &product,
                  const TransposedProduct &transposed_product)
    {
      std::vector<double> x(n);
      for (std::size_t i = 0; i < n; ++i)
        x[i] = 1. + 0.5 * std::cos(1. + 7. * i);
      double value = 0.;
      for (unsigned int iteration = 0; iteration < 100; ++iteration)
        {
          const double length = norm(x);
          if (length == 0.)
            return 0.;
          for (double &entry : x)
            entry /= length;
          x                     = transposed_product(product(x));
          const double previous = value;
          value                 = std::sqrt(norm(x));
          if (std::abs(value - previous) < 1e-3 * value)
            break;
        }
      return value;
    }



    std::vector<double>
    block_product(const DenseMatrix         &W,
                  const std::size_t          first_row,
                  const std::size_t          first_column,
                  const std::size_t          n_rows,
                  const std::vector<double> &forces)
    {
      std::vector<double> result(n_rows, 0.);
      W.multiply_block(first_row, first_column, forces, result);
      return result;
    }
  } // namespace



  void
  ContactProblem::set_creepages(const Creepages &values)
  {
    creepages = values;
    rigid_slip.resize(n_tangential * n_nodes);
    for (std::size_t i = 0; i < rigid_slip.size(); ++i)
      rigid_slip[i] = creepages.at(positions[i % n_nodes])[i / n_nodes];
  }



  std::vector<double>
  ContactProblem::normal_displacement(const std::vector<double> &pressure) const
  {
    const std::size_t first = n_tangential * n_nodes;
    return block_product(W, first, first, n_nodes, H.multiply(pressure));
  }



  std::vector<double>
  ContactProblem::normal_displacement_of_traction(
    const std::vector<double> &traction) const
  {
    if (!coupled || n_tangential == 0)
      return std::vector<double>(n_nodes, 0.);
    return block_product(
      W, n_tangential * n_nodes, 0, n_nodes, H.multiply(traction));
  }



  std::vector<double>
  ContactProblem::tangential_displacement(
    const std::vector<double> &traction) const
  {
    return block_product(W, 0, 0, n_tangential * n_nodes, H.multiply(traction));
  }



  std::vector<double>
  ContactProblem::tangential_displacement_of_pressure(
    const std::vector<double> &pressure) const
  {
    if (!coupled)
      return std::vector<double>(n_tangential * n_nodes, 0.);
    return block_product(W,
                         0,
                         n_tangential * n_nodes,
                         n_tangential * n_nodes,
                         H.multiply(pressure));
  }



  std::vector<double>
  ContactProblem::tangential_displacement(
    const std::vector<double> &traction,
    const std::vector<double> &pressure) const
  {
    if (n_tangential == 0)
      return {};
    std::vector<double>       w = tangential_displacement(traction);
    const std::vector<double> coupling =
      tangential_displacement_of_pressure(pressure);
    for (std::size_t i = 0; i < w.size(); ++i)
      w[i] += coupling[i];
    return w;
  }



  std::vector<double>
  ContactProblem::tangential_distortion(
    const std::vector<double> &traction,
    const std::vector<double> &pressure) const
  {
    std::vector<double> forces = H.multiply(traction);
    if (coupled && !pressure.empty())
      {
        const std::vector<double> normal = H.multiply(pressure);
        forces.insert(forces.end(), normal.begin(), normal.end());
      }
    std::vector<double> result(n_tangential * n_nodes, 0.);
    for (std::size_t j = 0; j < forces.size(); ++j)
      if (forces[j] != 0.)
        for (unsigned int c = 0; c < n_tangential; ++c)
          {
            const std::size_t first  = c * n_nodes;
            const double      common = W(first + n_nodes / 2, j);
            for (std::size_t i = first; i < first + n_nodes; ++i)
              result[i] += (W(i, j) - common) * forces[j];
          }
    return result;
  }



  std::vector<double>
  ContactProblem::distortion_of_unit(const unsigned int node,
                                     const unsigned int component) const
  {
    std::vector<double> result(n_tangential * n_nodes, 0.);
    for (const auto &entry : H_columns[node])
      {
        const std::size_t j = component * n_nodes + entry.first;
        for (unsigned int c = 0; c < n_tangential; ++c)
          {
            const std::size_t first = c * n_nodes;
            const double common = rate == 0. ? W(first + n_nodes / 2, j) : 0.;
            for (std::size_t i = first; i < first + n_nodes; ++i)
              result[i] += (W(i, j) - common) * entry.second;
          }
      }
    return result;
  }



  double
  ContactProblem::resultant(const std::vector<double> &nodal_field,
                            const unsigned int         component) const
  {
    double sum = 0.;
    for (unsigned int i = 0; i < n_nodes; ++i)
      sum += areas[i] * nodal_field[component * n_nodes + i];
    return sum;
  }



  void
  ContactProblem::finish()
  {
    areas = H.multiply(std::vector<double>(n_nodes, 1.));
    update_pressure_compliance();
    normal_norm = operator_norm(
      n_nodes,
      [&](const std::vector<double> &x) { return normal_displacement(x); },
      [&](const std::vector<double> &x) {
        const std::size_t first = n_tangential * n_nodes;
        return H.multiply_transposed(
          block_product(W, first, first, n_nodes, x));
      });
    H_columns = H.transposed();
    find_tangential_norm();
  }



  void
  ContactProblem::update_pressure_compliance()
  {
    W_nn_H = compliance_of_density(*this, n_tangential * n_nodes, n_nodes);
  }



  void
  ContactProblem::find_tangential_norm()
  {
    if (n_tangential == 0)
      return;
    const double flow = slip_operator.flow_direction();
    tangential_norm   = operator_norm(
      n_tangential * n_nodes,
      [&](const std::vector<double> &x) {
        const std::vector<double> w = tangential_displacement(x);
        std::vector<double>       s = slip_operator.rows().multiply(w);
        for (std::size_t i = 0; i < s.size(); ++i)
          s[i] = flow * convection * s[i] + rate * w[i];
        return s;
      },
      [&](const std::vector<double> &x) {
        std::vector<double> y = slip_operator.rows().multiply_transposed(x);
        for (std::size_t i = 0; i < y.size(); ++i)
          y[i] = flow * convection * y[i] + rate * x[i];
        return H.multiply_transposed(
          block_product(W, 0, 0, n_tangential * n_nodes, y));
      });
  }



  std::vector<double>
  nodal_forces(const ContactProblem &contact, const ContactState &state)
  {
    std::vector<double> forces;
    if (contact.n_tangential > 0)
      forces = contact.H.multiply(state.traction);
    const std::vector<double> normal = contact.H.multiply(state.pressure);
    forces.insert(forces.end(), normal.begin(), normal.end());
    return forces;
  }



  std::vector<double>
  normal_gap(const ContactProblem &contact, const ContactState &state)
  {
    std::vector<double>       u_n = contact.normal_displacement(state.pressure);
    const std::vector<double> coupling =
      contact.normal_displacement_of_traction(state.traction);
    for (unsigned int i = 0; i < contact.n_nodes; ++i)
      u_n[i] += contact.gap[i] - state.approach + coupling[i];
    return u_n;
  }



  double
  NaturalResidual::worst() const
  {
    // a comparison with NaN must not pass for convergence
    return std::isfinite(normal) && std::isfinite(tangential)
             ? std::max(normal, tangential)
             : std::numeric_limits<double>::infinity();
  }



  namespace
  {
    double
    normal_residual(const ContactProblem &contact, const ContactState &state)
    {
      const std::vector<double> u_n = normal_gap(contact, state);
      const double              rho =
        contact.normal_norm > 0. ? 1 / contact.normal_norm : 0.;
      double sum = 0.;
      for (unsigned int i = 0; i < contact.n_nodes; ++i)
        sum += contact.areas[i] *
               std::abs(state.pressure[i] -
                        std::max(0., state.pressure[i] - rho * u_n[i]));
      double load = contact.resultant(state.pressure);
      if (contact.normal_load)
        {
          sum += std::abs(load - *contact.normal_load);
          load = *contact.normal_load;
        }
      return load > 0. ? sum / load : sum;
    }
  } // namespace



  NaturalResidual
  natural_residual(const ContactProblem    &contact,
                   const TangentialProblem &tangential,
                   const ContactState      &state)
  {
    return {normal_residual(contact, state),
            contact.n_tangential == 0
              ? 0.
              : tangential.residual(state.traction,
                                    tangential.slip(state.traction))};
  }



  ContactState
  open_state(const ContactProblem &problem)
  {
    ContactState state;
    state.pressure.assign(problem.n_nodes, 0.);
    state.traction.assign(problem.n_tangential * problem.n_nodes, 0.);
    return state;
  }



  TangentialProblem
  tangential_problem(const ContactProblem &contact, const ContactState &state)
  {
    TangentialProblem problem(contact,
                              state.pressure,
                              state.edges,
                              state.edge_law);
    if (contact.friction_law && contact.n_tangential > 0)
      problem.set_friction(
        state.holds_friction
          ? state.friction
          : problem.friction_at(problem.slip(state.traction)));
    return problem;
  }
} // namespace RollingContact
