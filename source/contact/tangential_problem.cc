#include <rolling_contact/contact/contact_problem.h>
#include <rolling_contact/contact/edge_law.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    SparseRows
    identity(const unsigned int n)
    {
      SparseRows rows(n);
      for (unsigned int i = 0; i < n; ++i)
        rows.add(i, i, 1.);
      return rows;
    }
  } // namespace



  TangentialProblem::TangentialProblem(
    const ContactProblem                 &contact,
    const std::vector<double>            &pressure,
    const std::vector<EdgeExtrapolation> &extrapolations,
    const bool                            edge_law)
    : contact(contact)
    , B1(contact.slip_operator.rows())
    , B2(identity(contact.n_nodes))
    , friction(contact.friction)
    , bound(contact.n_nodes)
    , slip_at_zero(contact.n_tangential * contact.n_nodes)
  {
    if (contact.n_tangential == 0)
      return;
    for (unsigned int i = 0; i < contact.n_nodes; ++i)
      bound[i] = friction[i] * pressure[i];
    if (edge_law && contact.slip_operator.has_edge_law())
      {
        edge_rows.assign(contact.n_tangential, SparseRows(contact.n_nodes));
        edge_constants.assign(slip_at_zero.size(), 0.);
        apply_edge_law(pressure, extrapolations, *this);
      }
    std::vector<double> given = contact.rigid_slip;
    for (std::size_t i = 0; i < contact.free_slip.size(); ++i)
      given[i] += contact.free_slip[i];
    slip_at_zero                       = B2.multiply(given);
    const std::vector<double> coupling = slip_of(displacement({}, pressure));
    for (std::size_t i = 0; i < slip_at_zero.size(); ++i)
      slip_at_zero[i] += coupling[i];
    if (contact.free_displacement.empty())
      return;
    const std::vector<double> free = B1.multiply(contact.free_displacement);
    for (std::size_t i = 0; i < slip_at_zero.size(); ++i)
      slip_at_zero[i] += contact.slip_operator.flow_direction() * free[i];
  }



  std::vector<double>
  TangentialProblem::displacement(const std::vector<double> &traction,
                                  const std::vector<double> &pressure) const
  {
    const bool of_pressure = traction.empty();
    if (contact.rate != 0.)
      return of_pressure ? contact.tangential_displacement_of_pressure(pressure)
                         : contact.tangential_displacement(traction);
    return contact.tangential_distortion(
      of_pressure
        ? std::vector<double>(contact.n_tangential * contact.n_nodes, 0.)
        : traction,
      pressure);
  }



  std::vector<double>
  TangentialProblem::slip_of(const std::vector<double> &w) const
  {
    const double convection =
      contact.slip_operator.flow_direction() * contact.convection;
    std::vector<double> s = B1.multiply(w);
    for (double &value : s)
      value *= convection;
    if (contact.rate == 0.)
      return s;
    const std::vector<double> change = B2.multiply(w);
    for (std::size_t i = 0; i < s.size(); ++i)
      s[i] += contact.rate * change[i];
    return s;
  }



  std::vector<double>
  TangentialProblem::material_slip(const std::vector<double> &traction) const
  {
    std::vector<double> s = slip_of(displacement(traction, {}));
    for (std::size_t i = 0; i < s.size(); ++i)
      s[i] += slip_at_zero[i];
    return s;
  }



  std::vector<double>
  TangentialProblem::slip(const std::vector<double> &traction) const
  {
    std::vector<double> s = material_slip(traction);
    for (std::size_t i = 0; i < edge_constants.size(); ++i)
      {
        const std::size_t component = i / contact.n_nodes,
                          node      = i % contact.n_nodes;
        s[i] += edge_constants[i] + apply(edge_rows[component][node],
                                          traction,
                                          component * contact.n_nodes);
      }
    return s;
  }



  DenseMatrix
  TangentialProblem::slip_compliance(
    const std::vector<std::size_t> &unknowns) const
  {
    const unsigned int n = contact.n_nodes;
    const double       convection =
      contact.slip_operator.flow_direction() * contact.convection;
    DenseMatrix A(unknowns.size(), unknowns.size());
    for (std::size_t j = 0; j < unknowns.size(); ++j)
      {
        const std::vector<double> displacement =
          contact.distortion_of_unit(unknowns[j] % n, unknowns[j] / n);
        for (std::size_t i = 0; i < unknowns.size(); ++i)
          {
            const std::size_t node  = unknowns[i] % n,
                              first = unknowns[i] - node;
            A(i, j) = convection * apply(B1[node], displacement, first) +
                      contact.rate * apply(B2[node], displacement, first);
          }
      }
    std::vector<std::size_t> place(contact.n_tangential * n, unknowns.size());
    for (std::size_t k = 0; k < unknowns.size(); ++k)
      place[unknowns[k]] = k;
    for (std::size_t c = 0; c < edge_rows.size(); ++c)
      for (unsigned int i = 0; i < n; ++i)
        for (const auto &entry : edge_rows[c][i])
          {
            const std::size_t row    = place[c * n + i],
                              column = place[c * n + entry.first];
            if (row < unknowns.size() && column < unknowns.size())
              A(row, column) += entry.second;
          }
    return A;
  }



  std::vector<double>
  TangentialProblem::sliding_speeds(const std::vector<double> &slip) const
  {
    std::vector<double> speeds(contact.n_nodes, 0.);
    for (std::size_t i = 0; i < slip.size(); ++i)
      if (bound[i % contact.n_nodes] > 0.)
        speeds[i % contact.n_nodes] =
          std::hypot(speeds[i % contact.n_nodes], slip[i]);
    for (double &speed : speeds)
      speed *= contact.speed;
    return speeds;
  }



  std::vector<double>
  TangentialProblem::friction_at(const std::vector<double> &slip) const
  {
    if (!contact.friction_law)
      return friction;
    std::vector<double> coefficients = sliding_speeds(slip);
    for (unsigned int i = 0; i < contact.n_nodes; ++i)
      coefficients[i] =
        contact.friction[i] * (1 - contact.friction_law->drop(coefficients[i]));
    return coefficients;
  }



  void
  TangentialProblem::set_friction(const std::vector<double> &coefficients)
  {
    for (unsigned int i = 0; i < contact.n_nodes; ++i)
      if (friction[i] > 0.)
        bound[i] *= coefficients[i] / friction[i];
    friction = coefficients;
  }



  void
  TangentialProblem::project(std::vector<double> &traction) const
  {
    const unsigned int n = contact.n_nodes, n_components = contact.n_tangential;
    for (unsigned int i = 0; i < n; ++i)
      {
        double size = 0.;
        for (unsigned int c = 0; c < n_components; ++c)
          size = std::hypot(size, traction[c * n + i]);
        if (size > bound[i])
          for (unsigned int c = 0; c < n_components; ++c)
            traction[c * n + i] *= bound[i] / size;
      }
  }



  double
  TangentialProblem::residual(const std::vector<double> &traction,
                              const std::vector<double> &slip) const
  {
    const double friction_force = contact.resultant(bound);
    if (friction_force <= 0. || contact.tangential_norm <= 0.)
      return 0.;
    std::vector<double> projected(traction);
    for (std::size_t i = 0; i < projected.size(); ++i)
      projected[i] -= slip[i] / contact.tangential_norm;
    project(projected);
    const unsigned int n   = contact.n_nodes;
    double             sum = 0.;
    for (unsigned int i = 0; i < n; ++i)
      {
        double size = 0.;
        for (std::size_t k = i; k < traction.size(); k += n)
          size = std::hypot(size, traction[k] - projected[k]);
        sum += contact.areas[i] * size;
      }
    return sum / friction_force;
  }
} // namespace RollingContact
