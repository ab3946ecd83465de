#include <rolling_contact/patch/friction_limit.h>
#include <rolling_contact/patch/resultants.h>
#include <rolling_contact/solvers/newton_system.h>
#include <rolling_contact/solvers/scaled_forces.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  std::vector<double>
  Saturation::value(const std::vector<double> &F) const
  {
    const double        size  = norm(F);
    std::vector<double> value = F;
    for (double &entry : value)
      entry *= size > 0. ? grown(size) / size : 1.;
    return value;
  }



  DenseMatrix
  Saturation::derivative(const std::vector<double> &F) const
  {
    // g/|F| (1 - e e^T) + g' e e^T
    const double      size  = norm(F);
    const std::size_t n     = F.size();
    const double      ratio = size > 0. ? grown(size) / size : 1.;
    DenseMatrix       result(n, n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        result(i, j) =
          (i == j ? ratio : 0.) +
          (size > 0. ? (growth(size) - ratio) * F[i] * F[j] / (size * size)
                     : 0.);
    return result;
  }



  double
  Saturation::growth(const double size) const
  {
    return std::pow(1 - std::min(size, last), 1 / m - 1);
  }



  double
  Saturation::grown(const double size) const
  {
    const double known = std::min(size, last);
    return m * (1 - std::pow(1 - known, 1 / m)) + growth(size) * (size - known);
  }



  DenseMatrix
  force_derivative(const ContactProblem &problem,
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
    DenseMatrix derivative(changes.size(), changes.size());
    for (std::size_t l = 0; l < changes.size(); ++l)
      {
        const auto change =
          plane_resultant(problem, nodal_forces(problem, changes[l]));
        for (std::size_t k = 0; k < changes.size(); ++k)
          derivative(k, l) = change[asked[k].first];
      }
    return derivative;
  }



  std::vector<double>
  force_scales(const ContactProblem &problem, const ContactState &state)
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



  DenseMatrix
  scaled_derivative(const ContactProblem      &problem,
                    const SolverControls      &controls,
                    const ContactState        &state,
                    const std::vector<double> &scales)
  {
    DenseMatrix derivative = force_derivative(problem, controls, state);
    for (std::size_t k = 0; k < derivative.n_rows(); ++k)
      for (std::size_t l = 0; l < derivative.n_columns(); ++l)
        derivative(k, l) /= scales[k];
    return derivative;
  }



  DenseMatrix
  product(const DenseMatrix &first, const DenseMatrix &second)
  {
    const std::size_t n = first.n_rows();
    DenseMatrix       result(n, n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t k = 0; k < n; ++k)
          result(i, j) += first(i, k) * second(k, j);
    return result;
  }



  std::vector<double>
  creepage_margins(const ContactProblem &problem,
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
    if (size + part >= 1. || derivative.n_rows() == 0)
      return {};
    const std::size_t n = forces.size();
    DenseMatrix       inverse(n, n),
      matrix = product(saturation.derivative(forces), derivative);
    for (std::size_t i = 0; i < n; ++i)
      inverse(i, i) = 1.;
    if (!solve_general(matrix, inverse))
      return {};
    const double change =
      saturation.value(std::vector<double>{size + part})[0] -
      saturation.value(std::vector<double>{size})[0];
    std::vector<double> margins(n, 0.);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        margins[i] += std::abs(inverse(i, j)) * change;
    return margins;
  }
} // namespace RollingContact
