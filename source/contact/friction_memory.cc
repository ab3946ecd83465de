#include <rolling_contact/contact/friction_memory.h>
#include <rolling_contact/contact/node_lines.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  FrictionMemory::FrictionMemory(const ContactProblem      &contact,
                                 const std::vector<double> &speeds)
    : contact(contact)
    , speeds(speeds)
    , mu(contact.loads.friction)
    , law(contact.loads.friction)
    , left(contact.n_nodes(), 1.)
  {
    find_lines();
    const ContactLoads &loads   = contact.loads;
    const bool          in_time = !loads.friction_arriving.empty();
    for (const unsigned int i : order)
      {
        law[i] = loads.friction[i] * (1 - loads.friction_law->drop(speeds[i]));
        left[i] =
          std::exp(-speeds[i] / loads.speed * path[i] / loads.memory_length);
        const double arriving = in_time          ? loads.friction_arriving[i]
                                : before[i] != i ? mu[before[i]]
                                                 : loads.friction[i];
        mu[i]                 = law[i] + (arriving - law[i]) * left[i];
      }
  }

  void FrictionMemory::find_lines()
  {
    const ContactOperators &operators = contact.operators;
    const ContactLoads     &loads     = contact.loads;
    const bool downwards = operators.slip_operator().flow_direction() < 0;
    before.resize(contact.n_nodes());
    path.assign(contact.n_nodes(), 0.);
    for (std::vector<unsigned int> line : node_lines(operators, 0))
      {
        if (downwards)
          std::reverse(line.begin(), line.end());
        for (std::size_t k = 0; k < line.size(); ++k)
          {
            const unsigned int i = line[k], other = line[k > 0 ? k - 1 : 0];
            order.push_back(i);
            before[i] = other;
            path[i]   = loads.friction_arriving.empty()
                          ? std::abs(operators.positions()[i][0] -
                                   operators.positions()[other][0])
                          : loads.step_path;
          }
      }
  }

  std::vector<double> moved_with_flow(const ContactOperators    &operators,
                                      const std::vector<double> &values,
                                      const std::vector<double> &entering,
                                      const double               distance)
  {
    const int           flow   = operators.slip_operator().flow_direction();
    std::vector<double> result = entering;
    const auto          x      = [&](const unsigned int i) {
      return operators.positions()[i][0];
    };
    for (const std::vector<unsigned int> &line : node_lines(operators, 0))
      for (const unsigned int i : line)
        {
          const double from = x(i) - flow * distance;
          const auto   after =
            std::find_if(line.begin(), line.end(), [&](const auto j) {
              return x(j) >= from;
            });
          if (after == line.end() || from < x(line.front()))
            continue;
          const unsigned int b = *after,
                             a = after == line.begin() ? b : *(after - 1);
          const double part    = a == b ? 0. : (x(b) - from) / (x(b) - x(a));
          result[i]            = part * values[a] + (1 - part) * values[b];
        }
    return result;
  }

  DenseMatrix
  FrictionMemory::derivative(const std::vector<unsigned int> &nodes) const
  {
    const ContactLoads &loads   = contact.loads;
    const bool          in_time = !loads.friction_arriving.empty();
    const std::size_t   none    = nodes.size();
    DenseMatrix         result  = DenseMatrix::Zero(nodes.size(), nodes.size());
    std::vector<std::size_t> number(contact.n_nodes(), none);
    for (std::size_t k = 0; k < nodes.size(); ++k)
      number[nodes[k]] = k;
    // rows of all nodes, one after the other along the flow
    std::vector<std::vector<double>> rows(contact.n_nodes());
    for (const unsigned int i : order)
      {
        const bool has_before = !in_time && before[i] != i;
        rows[i] =
          has_before ? rows[before[i]] : std::vector<double>(nodes.size(), 0.);
        for (double &entry : rows[i])
          entry *= left[i];
        if (number[i] == none)
          continue;
        const double arriving = in_time      ? loads.friction_arriving[i]
                                : has_before ? mu[before[i]]
                                             : loads.friction[i];
        rows[i][number[i]] += -loads.friction[i] *
                                loads.friction_law->slope(speeds[i]) *
                                (1 - left[i]) -
                              (arriving - law[i]) * left[i] * path[i] /
                                (loads.memory_length * loads.speed);
        for (std::size_t l = 0; l < nodes.size(); ++l)
          result(number[i], l) = rows[i][l];
      }
    return result;
  }
} // namespace RollingContact
