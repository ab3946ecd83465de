#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/contact/friction_limit.h>
#include <rolling_contact/contact/resultants.h>
#include <rolling_contact/solvers/newton_system.h>
#include <rolling_contact/solvers/scaled_forces.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  std::vector<double> Saturation::value(const std::vector<double> &F) const
  {
    const double        size  = norm(F);
    std::vector<double> value = F;
    as_vector(value) *= size > 0. ? grown(size) / size : 1.;
    return value;
  }

  DenseMatrix Saturation::derivative(const std::vector<double> &F) const
  {
    // g/|F| (1 - e e^T) + g' e e^T
    const double size   = norm(F);
    DenseMatrix  result = DenseMatrix::Identity(F.size(), F.size());
    if (size == 0.)
      return result;
    const double          ratio = grown(size) / size;
    const Eigen::VectorXd e     = as_vector(F) / size;
    return ratio * result + (growth(size) - ratio) * e * e.transpose();
  }

  double Saturation::growth(const double size) const
  {
    return std::pow(1 - std::min(size, last), 1 / m - 1);
  }

  double Saturation::grown(const double size) const
  {
    // m (1 - (1 - known)^(1/m)), of forces that are rounding alone too
    const double known = std::min(size, last);
    return -m * std::expm1(std::log1p(-known) / m) +
           growth(size) * (size - known);
  }

  DenseMatrix force_derivative(const ContactProblem &problem,
                               const SolverControls &controls,
                               const ContactState   &state)
  {
    const auto              asked = asked_components(problem.loads.forces);
    std::vector<NodalField> slips;
    for (const auto &[component, force] : asked)
      slips.push_back(rigid_slip(problem.operators, unit_creepage(component)));
    const auto unknowns = problem.operators.coupling().exists
                            ? NewtonSystem::Unknowns::traction_and_pressure
                            : NewtonSystem::Unknowns::traction;
    const std::vector<ContactState> changes =
      NewtonSystem(problem, controls, state, unknowns).response(slips);
    DenseMatrix derivative = DenseMatrix::Zero(changes.size(), changes.size());
    for (std::size_t l = 0; l < changes.size(); ++l)
      {
        const auto change =
          plane_resultant(problem, nodal_forces(problem, changes[l]));
        for (std::size_t k = 0; k < changes.size(); ++k)
          derivative(k, l) = change[asked[k].first];
      }
    return derivative;
  }

  std::vector<double> force_scales(const ContactProblem &problem,
                                   const ContactState   &state)
  {
    std::vector<double> scales;
    for (const auto &it : asked_components(problem.loads.forces))
      {
        const double sum = sliding_resultant(problem, state.pressure, it.first);
        scales.push_back(sum > 0. ? sum : 1.);
      }
    return scales;
  }

  std::pair<std::vector<double>, std::vector<double>>
  scaled_forces(const ContactProblem      &problem,
                const ContactState        &state,
                const std::vector<double> &scales)
  {
    const auto total = plane_resultant(problem, nodal_forces(problem, state));
    const auto part  = plane_resultant_of_pressure(problem, state.pressure);
    const auto asked = asked_components(problem.loads.forces);
    std::vector<double> target, present;
    for (std::size_t k = 0; k < asked.size(); ++k)
      {
        const unsigned int c = asked[k].first;
        target.push_back((asked[k].second - part[c]) / scales[k]);
        present.push_back((total[c] - part[c]) / scales[k]);
      }
    return {target, present};
  }

  DenseMatrix scaled_derivative(const ContactProblem      &problem,
                                const SolverControls      &controls,
                                const ContactState        &state,
                                const std::vector<double> &scales)
  {
    DenseMatrix derivative = force_derivative(problem, controls, state);
    for (Eigen::Index k = 0; k < derivative.rows(); ++k)
      derivative.row(k) /= scales[k];
    return derivative;
  }

  std::vector<double> creepage_margins(const ContactProblem &problem,
                                       const SolverControls &controls,
                                       const ContactState   &state,
                                       const double          part)
  {
    const Saturation          saturation(problem.n_tangential() + 1.);
    const std::vector<double> scales = force_scales(problem, state),
                              forces =
                                scaled_forces(problem, state, scales).second;
    const double      size = norm(forces);
    const DenseMatrix derivative =
      scaled_derivative(problem, controls, state, scales);
    if (size + part >= 1. || derivative.rows() == 0)
      return {};
    const std::size_t n       = forces.size();
    DenseMatrix       inverse = DenseMatrix::Identity(n, n),
                matrix        = saturation.derivative(forces) * derivative;
    if (!solve_general(matrix, inverse))
      return {};
    const double change =
      saturation.value(std::vector<double>{size + part})[0] -
      saturation.value(std::vector<double>{size})[0];
    std::vector<double> margins(n);
    as_vector(margins) = change * inverse.cwiseAbs().rowwise().sum();
    return margins;
  }
} // namespace RollingContact
