#include <rolling_contact/contact/edge_companion.h>
#include <rolling_contact/contact/edge_law.h>

#include <algorithm>
#include <cmath>
#include <limits>

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
     * kappa [q1 - p1 (a g2 - b g3 + c)] of one component at node 1.
     */
    void
    add_law(const EdgeCompanion       &edge,
            const TouchingRun         &run,
            const unsigned int         component,
            const std::vector<double> &field,
            const std::vector<double> &coupling,
            const EdgeExtrapolation   &law,
            TangentialProblem         &problem)
    {
      const double h = edge.along(1) - edge.along(0);
      const double kappa =
        2 * std::abs(edge.compliance(0, 0) - edge.compliance(1, 0)) / h;
      const std::array<double, 3> weights{
        {kappa,
         -kappa * law.second * field[0] / field[1],
         kappa * law.third * field[0] / field[2]}};
      SparseRows::Row &row = problem.edge_rows[component][run.nodes[0]];
      double          &constant =
        problem
          .edge_constants[component * problem.contact.n_nodes + run.nodes[0]];
      constant = -kappa * field[0] * law.rest[component];
      row.clear();
      for (unsigned int k = 0; k < (law.third != 0. ? 3u : 2u); ++k)
        {
          row.emplace_back(run.nodes[k], weights[k]);
          constant -= weights[k] * coupling[k];
        }
    }



    /**
     * A first node that barely touches carries friction in the proportion of
     * the next node.
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
                  EdgeExtrapolation(),
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



  namespace
  {
    /**
     * The row of node 1 and what extrapolate_edges() needs.
     */
    void
    add_edge(const ContactProblem                   &contact,
             const TouchingRun                      &run,
             const std::vector<double>              &frictional,
             const std::vector<std::vector<double>> &displacements,
             const EdgeExtrapolation                *extrapolation,
             TangentialProblem                      &problem)
    {
      take_inside_derivative(EdgeCompanion(contact, run, 0), run, problem);
      ContactEdge record;
      record.nodes = run.nodes;
      for (unsigned int c = 0; c < contact.n_tangential; ++c)
        {
          const EdgeCompanion edge(contact, run, c);
          record.companion[c] = edge.pressure(frictional, displacements[c]);
          record.coupling[c]  = edge.coupling_traction(frictional);
          add_law(edge,
                  run,
                  c,
                  extrapolation ? record.companion[c] : edge.on_run(frictional),
                  record.coupling[c],
                  extrapolation ? *extrapolation : EdgeExtrapolation(),
                  problem);
        }
      for (std::size_t k = 0; k < run.nodes.size(); ++k)
        record.along.push_back(EdgeCompanion(contact, run, 0).along(k));
      problem.edges.push_back(std::move(record));
    }
  } // namespace



  void
  apply_edge_law(const std::vector<double>            &pressure,
                 const std::vector<EdgeExtrapolation> &extrapolations,
                 TangentialProblem                    &problem)
  {
    const ContactProblem &contact = problem.contact;
    auto                  runs = touching_runs(contact.slip_operator, pressure);
    std::vector<double>   frictional = pressure;
    std::vector<bool>     inside(contact.n_nodes);
    for (unsigned int i = 0; i < contact.n_nodes; ++i)
      inside[i] = pressure[i] > 0.;
    auto displacements = displacements_of_pressure(contact, frictional);
    bool released      = false;
    for (TouchingRun &run : runs)
      if (run.leading && run.nodes.size() >= 6 &&
          drops_first_node(contact, run, pressure, displacements))
        {
          const unsigned int first = run.nodes[0];
          if (find_edge(extrapolations, run.nodes[1]))
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
        if (run.leading && run.nodes.size() >= 3)
          add_edge(contact,
                   run,
                   frictional,
                   displacements,
                   find_edge(extrapolations, run.nodes[0]),
                   problem);
      }
  }



  namespace
  {
    using Vector2 = std::array<double, 2>;

    /**
     * The first node of the line that carries the full traction bound; the
     * length of the line if there is none.
     */
    std::size_t
    first_slipping(const ContactEdge         &edge,
                   const TangentialProblem   &problem,
                   const std::vector<double> &traction)
    {
      const unsigned int n = problem.contact.n_nodes;
      std::size_t        k = 0;
      for (; k < edge.nodes.size(); ++k)
        {
          const unsigned int node = edge.nodes[k];
          double             q    = 0.;
          for (unsigned int c = 0; c < problem.contact.n_tangential; ++c)
            q = std::hypot(q, traction[c * n + node]);
          if (q >= (1 - 1e-9) * problem.bound[node])
            break;
        }
      return k;
    }



    /**
     * (q - q_n) / p at the node @p k of the edge.
     */
    Vector2
    scaled_traction(const ContactEdge         &edge,
                    const TangentialProblem   &problem,
                    const std::vector<double> &traction,
                    const std::size_t          k)
    {
      Vector2 g{{0., 0.}};
      for (unsigned int c = 0; c < problem.contact.n_tangential; ++c)
        g[c] = (traction[c * problem.contact.n_nodes + edge.nodes[k]] -
                edge.coupling[c][k]) /
               edge.companion[c][k];
      return g;
    }



    /**
     * Make @p law that of a square rho = |g - e|^2 on a line through the second
     * and third node, e the value at the transition to slip. False if there is
     * none.
     */
    bool
    square_law(const double       r,
               const Vector2     &g2,
               const Vector2     &g3,
               const Vector2     &e,
               EdgeExtrapolation &law)
    {
      const Vector2 drop2{{g2[0] - e[0], g2[1] - e[1]}},
        drop3{{g3[0] - e[0], g3[1] - e[1]}};
      const double rho2 = std::hypot(drop2[0], drop2[1]);
      if (!(rho2 > 0.))
        return false;
      const double rho3 =
        std::max(0., (drop2[0] * drop3[0] + drop2[1] * drop3[1]) / rho2);
      // never less than half of the next node's, whatever the roughness
      const double rho1 = std::sqrt(
        std::max((1 + r) * rho2 * rho2 - r * rho3 * rho3, 0.25 * rho2 * rho2));
      if (!std::isfinite(rho1))
        return false;
      law.second = (1 + r) * rho2 / rho1;
      law.third  = r * rho3 / rho1;
      for (unsigned int c = 0; c < 2; ++c)
        law.rest[c] = e[c] * (1 - law.second + law.third);
      return true;
    }
  } // namespace



  std::vector<EdgeExtrapolation>
  extrapolate_edges(const TangentialProblem   &problem,
                    const std::vector<double> &traction)
  {
    std::vector<EdgeExtrapolation> result;
    for (const ContactEdge &edge : problem.edges)
      {
        const std::size_t slipping = first_slipping(edge, problem, traction);
        if (edge.nodes.size() < 4 || slipping < 2)
          continue;
        const auto g = [&](const std::size_t k) {
          return scaled_traction(edge, problem, traction, k);
        };
        const double r =
          (edge.along[1] - edge.along[0]) / (edge.along[2] - edge.along[1]);
        EdgeExtrapolation law{edge.nodes[0], 1 + r, r, {{0., 0.}}};
        if (slipping < edge.nodes.size())
          {
            // at the transition, which need not be at rest at a node
            const unsigned int node = edge.nodes[slipping];
            const double       share =
              problem.contact.friction[node] / problem.friction[node];
            const Vector2 at_node = g(slipping);
            const Vector2 e{{share * at_node[0], share * at_node[1]}};
            if (!square_law(r, g(1), g(2), e, law))
              continue;
          }
        result.push_back(law);
      }
    return result;
  }



  const EdgeExtrapolation *
  find_edge(const std::vector<EdgeExtrapolation> &extrapolations,
            const unsigned int                    first)
  {
    const auto found =
      std::find_if(extrapolations.begin(),
                   extrapolations.end(),
                   [&](const auto &edge) { return edge.first == first; });
    return found == extrapolations.end() ? nullptr : &*found;
  }



  double
  difference(const std::vector<EdgeExtrapolation> &first,
             const std::vector<EdgeExtrapolation> &second)
  {
    double largest = 0.;
    for (std::size_t k = 0; k < first.size(); ++k)
      {
        if (first.size() != second.size() || first[k].first != second[k].first)
          return std::numeric_limits<double>::infinity();
        largest = std::max({largest,
                            std::abs(first[k].second - second[k].second),
                            std::abs(first[k].third - second[k].third)});
      }
    return first.size() == second.size()
             ? largest
             : std::numeric_limits<double>::infinity();
  }
} // namespace RollingContact
