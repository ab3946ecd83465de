#include <rolling_contact/algebra/polynomial_fit.h>
#include <rolling_contact/contact/edge_examination.h>
#include <rolling_contact/contact/edge_law.h>
#include <rolling_contact/contact/edge_pressure.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace RollingContact
{
  namespace
  {
    SparseRows identity(const unsigned int n)
    {
      SparseRows rows(n);
      for (unsigned int i = 0; i < n; ++i)
        rows.add(i, i, 1.);
      return rows;
    }

    /**
     * Replaces rows of the slip operators by those of the edge law, one run of
     * touching nodes after the other.
     */
    class EdgeLaw
    {
    public:
      EdgeLaw(const ContactProblem           &contact,
              const std::vector<double>      &pressure,
              const SlipScheme               &scheme,
              const std::vector<ContactEdge> &like,
              SlipRows                       &rows);

      void apply_to_all_runs();

    private:
      void examine_runs();

      void leave_out_first_node(TouchingRun &run);

      void replace_slip_rows(const TouchingRun &run);

      void take_cubics(const TouchingRun &run);

      void take_one_element(const unsigned int node);

      void take_inside_derivative(const TouchingRun &run);

      void follow_next_node(const TouchingRun &run);

      void add_edge(const TouchingRun &run);

      void add_law(const EdgePressure        &line,
                   const std::vector<double> &p,
                   const std::vector<double> &q_n,
                   const EdgeExtrapolation   &extrapolation);

      void find_surplus();

      const ContactProblem           &contact;
      const SlipOperator             &slip_operator;
      const SlipScheme               &scheme;
      const std::vector<ContactEdge> &like;
      SlipRows                       &rows;
      std::vector<TouchingRun>        runs;
      std::vector<double>             pressure;   ///< of all nodes
      std::vector<double>             frictional; ///< without released nodes
      std::vector<double> normal_displacement;    ///< under the pressure
      std::vector<bool>   inside; ///< touches and is not a first to drop

      /// What the frictional pressure, as the traction in each direction,
      /// moves the surface beyond what the pressure moves it along the normal.
      std::vector<std::vector<double>> surplus;
      std::vector<double>              moved_along; ///< by it along x, m
    };

    EdgeLaw::EdgeLaw(const ContactProblem           &contact,
                     const std::vector<double>      &pressure,
                     const SlipScheme               &scheme,
                     const std::vector<ContactEdge> &like,
                     SlipRows                       &rows)
      : contact(contact)
      , slip_operator(contact.operators.slip_operator())
      , scheme(scheme)
      , like(like)
      , rows(rows)
      , runs(touching_runs(slip_operator, pressure))
      , pressure(pressure)
      , frictional(pressure)
      , normal_displacement(contact.operators.normal_displacement(pressure))
    {
      for (const double p : pressure)
        inside.push_back(p > 0.);
      find_surplus();
    }

    void EdgeLaw::find_surplus()
    {
      const NodalField moved =
        contact.operators.tangential_displacement_of_pressure(frictional);
      moved_along.assign(moved.begin(), moved.begin() + contact.n_nodes());
      surplus.clear();
      for (unsigned int c = 0; c < contact.n_tangential(); ++c)
        {
          // of lines of traction across the flow
          const double share =
            c == 0 ? 1. : contact.operators.coupling().antiplane_share;
          surplus.push_back(
            contact.operators.displacement_along(c, frictional));
          for (unsigned int i = 0; i < contact.n_nodes(); ++i)
            surplus[c][i] -= share * normal_displacement[i];
        }
    }

    /**
     * Leave runs that are not resolved to upwind 2, and first nodes that barely
     * touch out of theirs.
     */
    void EdgeLaw::examine_runs()
    {
      const std::size_t least = 6; // nodes that a window of EdgePressure needs
      std::vector<TouchingRun> resolved;
      for (TouchingRun &run : runs)
        {
          const EdgeExamination found =
            run.leading ? examine_edge(contact, run, pressure, surplus)
                        : EdgeExamination();
          if (!found.resolved)
            {
              ++rows.n_unresolved;
              continue;
            }
          if (found.barely_touches && run.nodes.size() >= least)
            leave_out_first_node(run);
          resolved.push_back(std::move(run));
        }
      runs = std::move(resolved);
      if (!rows.released.empty())
        find_surplus();
    }

    /**
     * Let the second node be the first of a run.
     */
    void EdgeLaw::leave_out_first_node(TouchingRun &run)
    {
      const unsigned int first = run.nodes[0];
      if (find_edge(scheme.edges, run.nodes[1]))
        {
          rows.released.push_back(first);
          frictional[first] = 0.;
        }
      else
        follow_next_node(run);
      inside[first] = false;
      run.nodes.erase(run.nodes.begin());
    }

    void EdgeLaw::apply_to_all_runs()
    {
      examine_runs();
      for (const TouchingRun &run : runs)
        {
          replace_slip_rows(run);
          take_cubics(run);
          if (run.leading && run.nodes.size() >= 3)
            add_edge(run);
        }
    }

    /**
     * One-element differences where the second upstream point lies outside the
     * contact; the first does not, except at a leading edge.
     */
    void EdgeLaw::replace_slip_rows(const TouchingRun &run)
    {
      for (std::size_t k = run.leading ? 1 : 0; k < run.nodes.size(); ++k)
        {
          const auto &point = slip_operator.two_upstream()[run.nodes[k]];
          if (std::any_of(point.begin(), point.end(), [&](const auto &entry) {
                return !inside[entry.first];
              }))
            take_one_element(run.nodes[k]);
        }
    }

    /**
     * The derivative of the cubic through its neighbours at inner nodes that
     * slide.
     */
    void EdgeLaw::take_cubics(const TouchingRun &run)
    {
      const auto               &nodes = run.nodes;
      const std::vector<double> x     = places(run, contact.operators);
      const int                 flow  = slip_operator.flow_direction();
      for (std::size_t k = 2; k + 1 < nodes.size(); ++k)
        {
          rows.inner.push_back({nodes[k], nodes[k - 1]});
          if (!std::binary_search(scheme.sliding.begin(),
                                  scheme.sliding.end(),
                                  nodes[k]))
            continue;
          const std::vector<double> weights = derivative_weights(
            {x[k - 2] - x[k], x[k - 1] - x[k], 0., x[k + 1] - x[k]});
          rows.B1[nodes[k]].clear();
          for (std::size_t j = 0; j < 4; ++j)
            rows.B1[nodes[k]].emplace_back(nodes[k - 2 + j], flow * weights[j]);
          rows.B2[nodes[k]] = {{nodes[k], 1.}};
        }
    }

    /**
     * d/dx and everything else half an element upstream of a node.
     */
    void EdgeLaw::take_one_element(const unsigned int node)
    {
      const auto &positions = contact.operators.positions();
      const auto &upstream  = slip_operator.one_upstream()[node];
      double      length    = positions[node][0];
      for (const auto &entry : upstream)
        length -= entry.second * positions[entry.first][0];
      rows.B1[node] = {{node, 1 / length}};
      rows.B2[node] = {{node, 0.5}};
      for (const auto &entry : upstream)
        {
          rows.B1[node].emplace_back(entry.first, -entry.second / length);
          rows.B2[node].emplace_back(entry.first, entry.second / 2);
        }
    }

    /**
     * d/dx at node 1 from nodes 1, 2 and 3.
     */
    void EdgeLaw::take_inside_derivative(const TouchingRun &run)
    {
      const EdgePressure line(contact, run, 0);
      const int          flow = slip_operator.flow_direction();
      const double       h    = line.along(1) - line.along(0),
                   h2         = line.along(2) - line.along(1);
      const double second     = flow * (h + h2) / (h * h2),
                   third      = -flow * h / (h2 * (h + h2));
      const auto &nodes       = run.nodes;
      rows.B1[nodes[0]]       = {{nodes[0], -second - third},
                                 {nodes[1], second},
                                 {nodes[2], third}};
    }

    /**
     * A first node that barely touches carries friction in the proportion of
     * the next node: g1 = g2.
     */
    void EdgeLaw::follow_next_node(const TouchingRun &run)
    {
      take_inside_derivative(run);
      for (unsigned int c = 0; c < contact.n_tangential(); ++c)
        {
          const EdgePressure line(contact, run, c);
          add_law(line,
                  line.on_run(pressure),
                  std::vector<double>(run.nodes.size(), 0.),
                  EdgeExtrapolation());
        }
    }

    /**
     * The row of node 1 and what extrapolate_edges() needs.
     */
    void EdgeLaw::add_edge(const TouchingRun &run)
    {
      take_inside_derivative(run);
      const EdgeExtrapolation *given = find_edge(scheme.edges, run.nodes[0]);
      ContactEdge              edge;
      edge.nodes   = run.nodes;
      edge.slender = EdgePressure(contact, run, 0).across_first().size() > 1;
      for (const ContactEdge &other : like)
        if (other.nodes[0] == edge.nodes[0])
          {
            edge.degree             = other.degree;
            edge.degree_of_coupling = other.degree_of_coupling;
          }
      for (unsigned int c = 0; c < contact.n_tangential(); ++c)
        {
          const EdgePressure line(contact, run, c);
          edge.pressure[c] =
            line.equivalent(frictional, surplus[c], edge.degree[c]);
          edge.coupling[c] = line.coupling_traction(frictional,
                                                    moved_along,
                                                    edge.degree_of_coupling[c]);
          add_law(line,
                  given ? edge.pressure[c] : line.on_run(frictional),
                  edge.coupling[c],
                  given ? *given : EdgeExtrapolation());
        }
      for (std::size_t k = 0; k < run.nodes.size(); ++k)
        edge.along.push_back(EdgePressure(contact, run, 0).along(k));
      rows.edges.push_back(std::move(edge));
    }

    /**
     * kappa [q1 - p1 (a g2 - b g3 + c)] of one component at node 1.
     */
    void EdgeLaw::add_law(const EdgePressure        &line,
                          const std::vector<double> &p,
                          const std::vector<double> &q_n,
                          const EdgeExtrapolation   &extrapolation)
    {
      const auto  &nodes = line.nodes();
      const double h     = line.along(1) - line.along(0);
      const double kappa = 2 * std::abs(line.fall_of_compliance()) / h;
      const std::array<double, 3> weights{
        {kappa,
         -kappa * extrapolation.a * p[0] / p[1],
         kappa * extrapolation.b * p[0] / p[2]}};
      const unsigned int c        = line.component();
      SparseRows::Row   &row      = rows.edge_rows[c][nodes[0]];
      double            &constant = rows.edge_constants(c, nodes[0]);
      constant                    = -kappa * p[0] * extrapolation.c[c];
      row.clear();
      for (unsigned int k = 0; k < (extrapolation.b != 0. ? 3u : 2u); ++k)
        {
          row.emplace_back(nodes[k], weights[k]);
          constant -= weights[k] * q_n[k];
        }
    }
  } // namespace

  namespace
  {
    /**
     * Steps in which an element is rolled; in more of them nothing enters the
     * patch through its leading edge.
     */
    const double most_steps = 1e3;

    /**
     * Whether the edge that is upstream differs from the one downstream: in
     * steady rolling, and in time if it is rolling at all.
     */
    bool flows(const ContactOperators &operators)
    {
      const double rate = operators.time_scaling().rate;
      if (rate == 0.)
        return true;
      double shortest = std::numeric_limits<double>::infinity();
      for (const auto &line : operators.slip_operator().lines())
        for (std::size_t k = 1; k < line.size(); ++k)
          shortest = std::min(shortest,
                              std::abs(operators.positions()[line[k]][0] -
                                       operators.positions()[line[k - 1]][0]));
      return rate * shortest < most_steps;
    }
  } // namespace

  SlipRows slip_rows(const ContactProblem           &problem,
                     const std::vector<double>      &pressure,
                     const SlipScheme               &scheme,
                     const bool                      edge_law,
                     const std::vector<ContactEdge> &like)
  {
    const unsigned int n            = problem.n_nodes(),
                       n_components = problem.n_tangential();
    SlipRows rows;
    if (n_components == 0)
      return rows;
    rows.B1 = problem.operators.slip_operator().rows();
    rows.B2 = identity(n);
    if (edge_law && problem.operators.slip_operator().has_edge_law() &&
        flows(problem.operators))
      {
        rows.edge_rows.assign(n_components, SparseRows(n));
        rows.edge_constants = NodalField(n, n_components);
        EdgeLaw(problem, pressure, scheme, like, rows).apply_to_all_runs();
      }
    return rows;
  }
} // namespace RollingContact
