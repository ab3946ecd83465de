#include <rolling_contact/contact/node_lines.h>
#include <rolling_contact/contact/recovered_tractions.h>
#include <rolling_contact/contact/resultants.h>
#include <rolling_contact/contact/square_root_edge.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

namespace RollingContact
{
  namespace
  {
    using Line = std::vector<unsigned int>;

    const double alike = 1e-3; // distances between nodes, relatively

    /**
     * The nodes from place @p k of a line on, in steps of 1 or -1, while they
     * are @p inside and as far from each other as the first from the node
     * before it.
     */
    Line inwards(const ContactOperators                        &operators,
                 const Line                                    &line,
                 const unsigned int                             axis,
                 const int                                      k,
                 const int                                      step,
                 const std::function<bool(const unsigned int)> &inside)
    {
      const int  n        = line.size();
      const auto distance = [&](const int m) {
        return operators.positions()[line[m]][axis] -
               operators.positions()[line[m - step]][axis];
      };
      Line found;
      for (int m = k; m >= 0 && m < n && inside(line[m]); m += step)
        {
          if (std::abs(distance(m) - distance(k)) >
              alike * std::abs(distance(k)))
            break;
          found.push_back(line[m]);
        }
      return found;
    }

    /**
     * The deviations of the squares of a field: of the two ends of lines along
     * an axis their sum, of different axes the mean.
     */
    class Deviations
    {
    public:
      Deviations(const SquareRootEdge &edge, const std::vector<double> &field)
        : edge(edge)
        , field(field)
      {}

      void add(const Line &nodes, const unsigned int axis)
      {
        std::vector<double> values;
        for (const unsigned int node : nodes)
          values.push_back(field[node]);
        const auto found = edge.deviation(values);
        for (std::size_t k = 0; k < found.size(); ++k)
          {
            OfAxis &here = of_nodes[nodes[k]][axis];
            here.sum += found[k].of_square;
            here.weight = std::max(here.weight, std::pow(found[k].growth, 2));
          }
      }

      /**
       * The field without them.
       */
      std::vector<double> recovered() const
      {
        std::vector<double> values(field);
        for (const auto &[node, axes] : of_nodes)
          {
            double sum = 0., weight = 0.;
            for (const OfAxis &axis : axes)
              {
                sum += axis.weight * axis.sum;
                weight += axis.weight;
              }
            values[node] =
              std::sqrt(std::max(0., std::pow(field[node], 2) - sum / weight));
          }
        return values;
      }

    private:
      struct OfAxis
      {
        double sum = 0., weight = 0.;
      };

      const SquareRootEdge                         &edge;
      const std::vector<double>                    &field;
      std::map<unsigned int, std::array<OfAxis, 2>> of_nodes;
    };
  } // namespace

  std::vector<double> recovered_pressure(const ContactOperators    &operators,
                                         const std::vector<double> &pressure)
  {
    const SquareRootEdge edge =
      SquareRootEdge::of_pressure(operators.nodal_forces());
    const auto touches = [&](const unsigned int node) {
      return pressure[node] > 0.;
    };
    Deviations deviations(edge, pressure);
    for (unsigned int axis = 0; axis < 2; ++axis)
      for (const Line &line : node_lines(operators, axis))
        for (std::size_t k = 1; k < line.size(); ++k)
          if (touches(line[k]) != touches(line[k - 1]))
            deviations.add(
              touches(line[k])
                ? inwards(operators, line, axis, k, 1, touches)
                : inwards(operators, line, axis, k - 1, -1, touches),
              axis);
    return deviations.recovered();
  }

  std::vector<double> recovered_margin(const TangentialProblem      &tangential,
                                       const std::vector<NodeState> &states,
                                       const ContactState           &state)
  {
    std::vector<double> margin(state.pressure.size());
    for (unsigned int i = 0; i < margin.size(); ++i)
      margin[i] = std::max(0., tangential.bound[i] - state.traction.norm_at(i));
    const ContactOperators &operators = tangential.contact.operators;
    const SquareRootEdge    edge =
      SquareRootEdge::of_stick_zone(operators.nodal_forces());
    const auto sticks = [&](const unsigned int node) {
      return states[node] == NodeState::stick;
    };
    Deviations deviations(edge, margin);
    for (const Line &line : operators.slip_operator().lines())
      for (std::size_t k = 0; k + 1 < line.size(); ++k)
        if (sticks(line[k]) && states[line[k + 1]] == NodeState::slip)
          deviations.add(inwards(operators, line, 0, k, -1, sticks), 0);
    return deviations.recovered();
  }

  RecoveredTractions recovered_tractions(const TangentialProblem &tangential,
                                         const ContactState      &state)
  {
    RecoveredTractions recovered{
      recovered_pressure(tangential.contact.operators, state.pressure),
      state.traction};
    if (state.traction.empty())
      return recovered;
    const std::vector<NodeState> states = node_states(tangential, state);
    const std::vector<double>    left =
      recovered_margin(tangential, states, state);
    for (unsigned int i = 0; i < states.size(); ++i)
      {
        const double size = state.traction.norm_at(i);
        if (!(size > 0.) || !(state.pressure[i] > 0.))
          continue;
        const double next_to_edge = recovered.pressure[i] / state.pressure[i];
        const double recovered_size =
          states[i] == NodeState::stick
            ? std::max(0., tangential.bound[i] - left[i])
            : size;
        for (unsigned int c = 0; c < state.traction.n_components(); ++c)
          recovered.traction(c, i) *= next_to_edge * recovered_size / size;
      }
    return recovered;
  }

  RecoveredTractions recovered_tractions(const ContactProblem &contact,
                                         const ContactState   &state)
  {
    return recovered_tractions(tangential_problem(contact, state), state);
  }
} // namespace RollingContact
