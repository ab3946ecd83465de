#include <rolling_contact/contact/edge_companion.h>
#include <rolling_contact/contact/edge_law.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /**
     * d/dx at node 1 from nodes 1, 2 and 3.
     */
    void
    take_inside_derivative(const EdgeCompanion &edge,
                           const TouchingRun   &run,
                           TangentialProblem   &problem)
    {
      const int    flow    = problem.contact.slip_operator.flow_direction();
      const double h       = edge.along(1) - edge.along(0),
                   h2      = edge.along(2) - edge.along(1);
      const double second  = flow * (h + h2) / (h * h2),
                   third   = -flow * h / (h2 * (h + h2));
      const auto &nodes    = run.nodes;
      problem.B1[nodes[0]] = {{nodes[0], -second - third},
                              {nodes[1], second},
                              {nodes[2], third}};
    }



    /**
     * d/dx and everything else half an element upstream of a node.
     */
    void
    take_one_element(const unsigned int node, TangentialProblem &problem)
    {
      const ContactProblem  &contact = problem.contact;
      const SparseRows::Row &upstream =
        contact.slip_operator.one_upstream()[node];
      double length = contact.positions[node][0];
      for (const auto &entry : upstream)
        length -= entry.second * contact.positions[entry.first][0];
      problem.B1[node] = {{node, 1 / length}};
      for (const auto &entry : upstream)
        problem.B1[node].emplace_back(entry.first, -entry.second / length);
      problem.B2[node] = {{node, 0.5}};
      for (const auto &entry : upstream)
        problem.B2[node].emplace_back(entry.first, entry.second / 2);
    }



    /**
     * One-element differences where the second upstream point lies outside the
     * contact (@p inside); the first does not, except at a leading edge.
     */
    void
    replace_slip_rows(const TouchingRun       &run,
                      const std::vector<bool> &inside,
                      TangentialProblem       &problem)
    {
      const SparseRows &two_upstream =
        problem.contact.slip_operator.two_upstream();
      for (std::size_t k = run.leading ? 1 : 0; k < run.nodes.size(); ++k)
        {
          const SparseRows::Row &point = two_upstream[run.nodes[k]];
          if (std::any_of(point.begin(), point.end(), [&](const auto &entry) {
                return !inside[entry.first];
              }))
            take_one_element(run.nodes[k], problem);
        }
    }



    /**
     * kappa L of one component at node 1.
     */
    void
    add_law(const EdgeCompanion       &edge,
            const TouchingRun         &run,
            const unsigned int         component,
            const std::vector<double> &field,
            const std::vector<double> &coupling,
            const bool                 linear,
            TangentialProblem         &problem)
    {
      const double h = edge.along(1) - edge.along(0),
                   r = linear ? h / (edge.along(2) - edge.along(1)) : 0.;
      const double kappa =
        2 * std::abs(edge.compliance(0, 0) - edge.compliance(1, 0)) / h;
      const std::array<double, 3> weights{
        {kappa,
         -kappa * (1 + r) * field[0] / field[1],
         kappa * r * field[0] / field[2]}};
      SparseRows::Row &row = problem.edge_rows[component][run.nodes[0]];
      double          &constant =
        problem
          .edge_constants[component * problem.contact.n_nodes + run.nodes[0]];
      constant = 0.;
      row.clear();
      for (unsigned int k = 0; k < (linear ? 3u : 2u); ++k)
        {
          row.emplace_back(run.nodes[k], weights[k]);
          constant -= weights[k] * coupling[k];
        }
    }



    /**
     * A first node that barely touches carries friction in the proportion of
     * the next node, by the constant law.
     */
    void
    follow_next_node(const ContactProblem      &contact,
                     const TouchingRun         &run,
                     const std::vector<double> &pressure,
                     TangentialProblem         &problem)
    {
      take_inside_derivative(EdgeCompanion(contact, run, 0), run, problem);
      for (unsigned int c = 0; c < contact.n_tangential; ++c)
        {
          const EdgeCompanion edge(contact, run, c);
          add_law(edge,
                  run,
                  c,
                  edge.on_run(pressure),
                  std::vector<double>(run.nodes.size(), 0.),
                  false,
                  problem);
        }
    }



    /**
     * True if a companion pulls at the first node, in any component.
     */
    bool
    drops_first_node(const ContactProblem                   &contact,
                     const TouchingRun                      &run,
                     const std::vector<double>              &pressure,
                     const std::vector<std::vector<double>> &displacements)
    {
      for (unsigned int c = 0; c < contact.n_tangential; ++c)
        if (EdgeCompanion(contact, run, c)
              .pressure(pressure, displacements[c])[0] <= 0.)
          return true;
      return false;
    }



    std::vector<std::vector<double>>
    displacements_of_pressure(const ContactProblem      &contact,
                              const std::vector<double> &pressure)
    {
      std::vector<std::vector<double>> displacements;
      for (unsigned int c = 0; c < contact.n_tangential; ++c)
        displacements.push_back(displacement_of(contact, pressure, c));
      return displacements;
    }
  } // namespace



  void
  apply_edge_law(const std::vector<double> &pressure,
                 const std::vector<bool>   &linear_edges,
                 TangentialProblem         &problem)
  {
    const ContactProblem &contact = problem.contact;
    const auto            linear  = [&](const unsigned int node) {
      return !linear_edges.empty() && linear_edges[node];
    };
    auto                runs = touching_runs(contact.slip_operator, pressure);
    std::vector<double> frictional = pressure;
    std::vector<bool>   inside(contact.n_nodes);
    for (unsigned int i = 0; i < contact.n_nodes; ++i)
      inside[i] = pressure[i] > 0.;
    auto displacements = displacements_of_pressure(contact, frictional);
    bool released      = false;
    for (TouchingRun &run : runs)
      if (run.leading && run.nodes.size() >= 6 &&
          drops_first_node(contact, run, pressure, displacements))
        {
          const unsigned int first = run.nodes[0];
          if (linear(run.nodes[1]))
            {
              problem.bound[first] = frictional[first] = 0.;
              released                                 = true;
            }
          else
            follow_next_node(contact, run, pressure, problem);
          inside[first] = false;
          run.nodes.erase(run.nodes.begin());
        }
    if (released)
      displacements = displacements_of_pressure(contact, frictional);

    for (const TouchingRun &run : runs)
      {
        replace_slip_rows(run, inside, problem);
        if (!run.leading || run.nodes.size() < 3)
          continue;
        const auto        &nodes = run.nodes;
        const unsigned int first = nodes[0];
        take_inside_derivative(EdgeCompanion(contact, run, 0), run, problem);
        problem.edges.push_back({{{first, nodes[1], nodes[2]}},
                                 static_cast<unsigned int>(nodes.size())});
        for (unsigned int c = 0; c < contact.n_tangential; ++c)
          {
            const EdgeCompanion edge(contact, run, c);
            add_law(edge,
                    run,
                    c,
                    linear(first) ? edge.pressure(frictional, displacements[c])
                                  : edge.on_run(frictional),
                    edge.coupling_traction(frictional),
                    linear(first),
                    problem);
          }
      }
  }



  std::vector<bool>
  sticking_edges(const TangentialProblem   &problem,
                 const std::vector<double> &traction,
                 const unsigned int         first)
  {
    std::vector<bool>  result;
    const unsigned int n      = problem.contact.n_nodes;
    const auto         sticks = [&](const unsigned int node) {
      double size = 0.;
      for (unsigned int c = 0; c < problem.contact.n_tangential; ++c)
        size = std::hypot(size, traction[c * n + node]);
      return size < (1 - 1e-9) * problem.bound[node];
    };
    for (const ContactEdge &edge : problem.edges)
      if (edge.n_touching >= 4 &&
          std::all_of(edge.nodes.begin() + first, edge.nodes.end(), sticks))
        {
          result.resize(n, false);
          result[edge.nodes[0]] = true;
        }
    return result;
  }
} // namespace RollingContact
