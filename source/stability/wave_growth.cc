#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/contact/node_lines.h>
#include <rolling_contact/contact/tangential_problem.h>
#include <rolling_contact/stability/wave_growth.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  WaveGrowth::WaveGrowth(const ContactProblem &problem,
                         const ContactState   &state,
                         const LinearContact  &contact,
                         const ReducedPair    &pair,
                         const double          speed,
                         const double          thickness)
    : problem(problem)
    , contact(contact)
    , speed(speed)
    , traction(state.traction)
    , slip(tangential_problem(problem, state).mean_slip(state))
  {
    const ContactOperators &operators = problem.operators;
    for (const unsigned int i : contact.touching)
      places.push_back(operators.slip_operator().flow_direction() *
                       operators.positions()[i][0]);
    find_punch(pair);
    find_lengths(thickness);
  }

  void WaveGrowth::find_punch(const ReducedPair &pair)
  {
    const std::size_t n = contact.touching.size(), T = contact.n_tangential;
    const DenseMatrix moved = pair.W_res * contact.forces;
    DenseMatrix       W(n, n);
    for (std::size_t i = 0; i < n; ++i)
      W.row(i) =
        moved.row(T * contact.n_nodes + contact.touching[i]).segment(T * n, n);
    Eigen::VectorXd pressure = Eigen::VectorXd::Ones(n);
    if (!solve_general(W, pressure))
      throw ConvergenceError("A flat punch on the patch has no pressure: its "
                             "compliance is singular.");
    const Eigen::VectorXd forces =
      contact.forces.block(T * contact.n_nodes, T * n, contact.n_nodes, n) *
      pressure;
    for (std::size_t k = 0; k < n; ++k)
      punch.push_back(forces[contact.touching[k]] / forces.sum());
  }

  void WaveGrowth::find_lengths(const double thickness)
  {
    const auto          lines = node_lines(problem.operators, 0);
    std::vector<double> y, of_node(problem.n_nodes(), 0.);
    for (std::size_t k = 0; k < punch.size(); ++k)
      of_node[contact.touching[k]] = punch[k];
    for (const auto &nodes : lines)
      y.push_back(problem.operators.positions()[nodes.front()][1]);
    const std::vector<double> width =
      lines.size() > 1 ? widths_of_lines(y) : std::vector<double>{thickness};
    node_lengths.assign(problem.n_nodes(), 0.);
    for (std::size_t j = 0; j < lines.size(); ++j)
      {
        double share = 0.;
        for (const unsigned int node : lines[j])
          share += of_node[node];
        for (const unsigned int node : lines[j])
          node_lengths[node] =
            share * problem.operators.areas()[node] / width[j];
      }
  }

  std::vector<double> WaveGrowth::across() const
  {
    std::vector<double> result;
    for (const unsigned int i : contact.touching)
      result.push_back(problem.operators.positions()[i][1]);
    return result;
  }

  std::vector<double> WaveGrowth::punch_forces(const unsigned int c) const
  {
    std::vector<double> result((contact.n_tangential + 1) * contact.n_nodes,
                               0.);
    for (std::size_t k = 0; k < punch.size(); ++k)
      result[c * contact.n_nodes + contact.touching[k]] = punch[k];
    return result;
  }

  std::complex<double> WaveGrowth::load(const ComplexVector &unknowns) const
  {
    return contact.normal_load() * unknowns;
  }

  Growth WaveGrowth::growth(const WaveAnswer &answer,
                            const double      wave_number) const
  {
    const std::complex<double> s(0., wave_number * speed);
    const SlipOperator        &slips = problem.operators.slip_operator();
    const SparseRows          &mean  = slips.mean_derivative();
    const std::size_t          N = contact.n_nodes, n = contact.touching.size();
    Growth                     result;
    for (std::size_t k = 0; k < n; ++k)
      {
        const unsigned int i = contact.touching[k];
        const auto         weight =
          node_lengths[i] * std::polar(1 / speed, wave_number * places[k]);
        for (std::size_t c = 0; c < contact.n_tangential; ++c)
          {
            std::complex<double> v = s * answer.motion[c * N + i];
            for (const auto &[node, derivative] : mean[i])
              v += speed * slips.flow_direction() * derivative *
                   answer.motion[c * N + node];
            result.by_slip += weight * traction(c, i) * v;
            result.by_traction +=
              weight * answer.unknowns[c * n + k] * speed * slip(c, i);
          }
      }
    return result;
  }
} // namespace RollingContact
