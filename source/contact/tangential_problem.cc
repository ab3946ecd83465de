#include <rolling_contact/contact/friction_memory.h>
#include <rolling_contact/contact/tangential_problem.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace RollingContact
{
  TangentialProblem::TangentialProblem(const ContactProblem      &contact,
                                       const std::vector<double> &pressure,
                                       const SlipScheme          &scheme,
                                       const bool                 edge_law)
    : contact(contact)
    , rows(slip_rows(contact, pressure, scheme, edge_law))
    , friction(contact.loads.friction)
    , bound(contact.n_nodes(), 0.)
    , slip_at_zero(contact.n_nodes(), contact.n_tangential())
  {
    if (contact.n_tangential() == 0)
      return;
    for (unsigned int i = 0; i < contact.n_nodes(); ++i)
      bound[i] = friction[i] * pressure[i];
    for (const unsigned int i : rows.released)
      bound[i] = 0.;

    const ContactLoads &loads = contact.loads;
    for (unsigned int i = 0; i < loads.slip_share.size(); ++i)
      for (SparseRows *B : {&rows.B1, &rows.B2})
        for (auto &entry : (*B)[i])
          entry.second *= loads.slip_share[i];
    NodalField drive = contact.rigid_slip();
    if (!loads.free_slip.empty())
      drive += loads.free_slip;
    slip_at_zero = rows.B2 * drive;
    slip_at_zero += slip_of(contact.operators.distortion_of_pressure(pressure));
    if (!loads.free_displacement.empty())
      slip_at_zero.add(contact.operators.slip_operator().flow_direction(),
                       rows.B1 * loads.free_displacement);
    if (!loads.slip_before.empty())
      slip_at_zero += loads.slip_before;
  }

  NodalField TangentialProblem::slip_of(const NodalField &w) const
  {
    NodalField s = rows.B1 * w;
    s *= contact.operators.flow_convection();
    const double rate = contact.operators.time_scaling().rate;
    return rate == 0. ? s : s.add(rate, rows.B2 * w);
  }

  double TangentialProblem::slip_of(const NodalField &w,
                                    const NodalIndex &at) const
  {
    const double s = contact.operators.flow_convection() *
                     apply(rows.B1[at.node], w, at.component),
                 rate = contact.operators.time_scaling().rate;
    return rate == 0. ? s : s + rate * apply(rows.B2[at.node], w, at.component);
  }

  NodalField TangentialProblem::material_slip(const NodalField &traction) const
  {
    NodalField s = slip_of(contact.operators.distortion_of_traction(traction));
    s += slip_at_zero;
    return s;
  }

  NodalField TangentialProblem::mean_slip(const ContactState &state) const
  {
    const ContactOperators &operators = contact.operators;
    const ContactLoads     &loads     = contact.loads;
    const SparseRows &derivative = operators.slip_operator().mean_derivative();
    NodalField        w = operators.distortion_of_traction(state.traction);
    w += operators.distortion_of_pressure(state.pressure);
    NodalField s = derivative * w;
    s *= operators.flow_convection();
    s.add(operators.time_scaling().rate, w);
    s += contact.rigid_slip();
    if (!loads.free_slip.empty())
      s += loads.free_slip;
    if (!loads.free_displacement.empty())
      s.add(operators.slip_operator().flow_direction(),
            derivative * loads.free_displacement);
    return s;
  }

  NodalField TangentialProblem::slip(const NodalField &traction) const
  {
    NodalField s = material_slip(traction);
    for (unsigned int c = 0; c < rows.edge_rows.size(); ++c)
      for (unsigned int i = 0; i < contact.n_nodes(); ++i)
        s(c, i) +=
          rows.edge_constants(c, i) + apply(rows.edge_rows[c][i], traction, c);
    return s;
  }

  DenseMatrix TangentialProblem::slip_compliance(
    const std::vector<NodalIndex> &unknowns) const
  {
    const std::size_t n = unknowns.size();
    DenseMatrix       A = DenseMatrix::Zero(n, n);
    for (std::size_t j = 0; j < n; ++j)
      {
        const NodalField w = contact.operators.distortion_of_unit(unknowns[j]);
        for (std::size_t i = 0; i < n; ++i)
          A(i, j) = slip_of(w, unknowns[i]);
      }
    for (unsigned int c = 0; c < rows.edge_rows.size(); ++c)
      {
        std::vector<std::size_t> place(contact.n_nodes(), n);
        for (std::size_t k = 0; k < n; ++k)
          if (unknowns[k].component == c)
            place[unknowns[k].node] = k;
        for (unsigned int i = 0; i < contact.n_nodes(); ++i)
          for (const auto &entry : rows.edge_rows[c][i])
            if (place[i] < n && place[entry.first] < n)
              A(place[i], place[entry.first]) += entry.second;
      }
    return A;
  }

  std::vector<double>
  TangentialProblem::sliding_speeds(const NodalField &slip) const
  {
    std::vector<double> speeds(contact.n_nodes(), 0.);
    for (unsigned int i = 0; i < contact.n_nodes(); ++i)
      if (bound[i] > 0.)
        speeds[i] = slip.norm_at(i) * contact.loads.speed;
    return speeds;
  }

  std::vector<double>
  TangentialProblem::friction_at(const NodalField &slip) const
  {
    const ContactLoads &loads = contact.loads;
    if (!loads.friction_law)
      return friction;
    std::vector<double> coefficients = sliding_speeds(slip);
    if (loads.memory_length > 0.)
      return FrictionMemory(contact, coefficients).friction();
    for (unsigned int i = 0; i < contact.n_nodes(); ++i)
      coefficients[i] =
        loads.friction[i] * (1 - loads.friction_law->drop(coefficients[i]));
    return coefficients;
  }

  void TangentialProblem::set_friction(const std::vector<double> &coefficients)
  {
    for (unsigned int i = 0; i < contact.n_nodes(); ++i)
      if (friction[i] > 0.)
        bound[i] *= coefficients[i] / friction[i];
    friction = coefficients;
  }

  void TangentialProblem::project(NodalField &traction) const
  {
    for (unsigned int i = 0; i < contact.n_nodes(); ++i)
      {
        const double size = traction.norm_at(i);
        if (size > bound[i])
          for (unsigned int c = 0; c < traction.n_components(); ++c)
            traction(c, i) *= bound[i] / size;
      }
  }

  NodalField TangentialProblem::trial(const NodalField &traction,
                                      const NodalField &slip) const
  {
    const double norm   = contact.operators.tangential_norm();
    NodalField   result = traction;
    std::transform(traction.begin(),
                   traction.end(),
                   slip.begin(),
                   result.begin(),
                   [&](const double q, const double s) {
                     return q - s / norm;
                   });
    return result;
  }

  double TangentialProblem::residual(const NodalField &traction,
                                     const NodalField &slip) const
  {
    const double friction_force = contact.operators.resultant(bound);
    if (friction_force <= 0. || contact.operators.tangential_norm() <= 0.)
      return 0.;
    NodalField projected = trial(traction, slip);
    project(projected);
    NodalField change = traction;
    change -= projected;
    double sum = 0.;
    for (unsigned int i = 0; i < contact.n_nodes(); ++i)
      sum += contact.operators.areas()[i] * change.norm_at(i);
    return sum / friction_force;
  }

  TangentialProblem tangential_problem(const ContactProblem &contact,
                                       const ContactState   &state)
  {
    TangentialProblem problem(contact,
                              state.pressure,
                              state.scheme,
                              state.edge_law);
    if (contact.loads.friction_law && contact.n_tangential() > 0)
      problem.set_friction(
        state.holds_friction
          ? state.friction
          : problem.friction_at(problem.slip(state.traction)));
    return problem;
  }

  double NaturalResidual::worst() const
  {
    // a comparison with NaN must not pass for convergence
    return std::isfinite(normal) && std::isfinite(tangential)
             ? std::max(normal, tangential)
             : std::numeric_limits<double>::infinity();
  }

  namespace
  {
    double normal_residual(const ContactProblem &contact,
                           const ContactState   &state)
    {
      const ContactOperators   &operators = contact.operators;
      const std::vector<double> u_n       = normal_gap(contact, state);
      const double              rho =
        operators.normal_norm() > 0. ? 1 / operators.normal_norm() : 0.;
      double sum = 0.;
      for (unsigned int i = 0; i < contact.n_nodes(); ++i)
        sum += operators.areas()[i] *
               std::abs(state.pressure[i] -
                        std::max(0., state.pressure[i] - rho * u_n[i]));
      double load = operators.load(state.pressure);
      if (contact.loads.normal_load)
        {
          sum += std::abs(load - *contact.loads.normal_load);
          load = *contact.loads.normal_load;
        }
      return load > 0. ? sum / load : sum;
    }
  } // namespace

  NaturalResidual natural_residual(const ContactProblem    &contact,
                                   const TangentialProblem &tangential,
                                   const ContactState      &state)
  {
    return {normal_residual(contact, state),
            contact.n_tangential() == 0
              ? 0.
              : tangential.residual(state.traction,
                                    tangential.slip(state.traction))};
  }
} // namespace RollingContact
