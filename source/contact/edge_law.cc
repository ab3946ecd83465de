#include <rolling_contact/contact/edge_law.h>
#include <rolling_contact/contact/patch_edge.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    const double pi = 3.14159265358979323846;

    /**
     * Touching nodes of one line, in the order of the flow.
     */
    using Run = std::vector<unsigned int>;

    std::vector<Run>
    touching_runs(const SlipOperator        &slip_operator,
                  const std::vector<double> &pressure)
    {
      std::vector<Run> runs;
      for (const auto &line : slip_operator.lines())
        {
          bool touching = false;
          for (const unsigned int node : line)
            {
              if (pressure[node] > 0. && !touching)
                runs.emplace_back();
              touching = pressure[node] > 0.;
              if (touching)
                runs.back().push_back(node);
            }
        }
      return runs;
    }



    /**
     * How many nodes from the edge are corrected, and over how many more the
     * displacement is fitted, for a run of @p n_touching nodes. Coupling makes
     * the pressure less Hertzian and the displacement less quadratic away from
     * the edge: the window narrows to 3/8 at Dundurs' beta = 0.05 and above.
     */
    struct Window
    {
      Window(const std::size_t n_touching, const double dundurs_beta)
      {
        if (n_touching < 6)
          return;
        const double narrowing =
          1 - 0.625 * std::min(1., std::abs(dundurs_beta) / 0.05);
        const std::size_t n =
          std::max<std::size_t>(6, std::lround(narrowing * n_touching));
        n_corrected = std::clamp<std::size_t>(n / 3, 2, 10);
        n_fitted    = std::max<std::size_t>(n_corrected, 3);
      }

      std::size_t n_corrected = 0;
      std::size_t n_fitted    = 0;
    };



    /**
     * Works on one run for one tangential component.
     */
    class EdgeProblem
    {
    public:
      EdgeProblem(const ContactProblem &contact,
                  const Run            &run,
                  const unsigned int    component)
        : contact(contact)
        , run(run)
        , offset(component * contact.n_nodes)
        , flow(contact.slip_operator.flow_direction())
      {}

      /**
       * Coordinate along the flow, m.
       */
      double
      along(const std::size_t k) const
      {
        return flow * contact.positions[run[k]][0];
      }

      /**
       * (W_tt H)_kj of two nodes of the run, m/Pa.
       */
      double
      compliance(const std::size_t k, const std::size_t j) const
      {
        double sum = 0.;
        for (const auto &entry : contact.H[run[j]])
          sum +=
            contact.W(offset + run[k], offset + entry.first) * entry.second;
        return sum;
      }

      /**
       * Correct @p field (a traction over the run) at the first nodes so that
       * its displacement is quadratic in x on the window, in the least-squares
       * sense;
       * @p displacement is that of the uncorrected field and whatever else
       * moves the surface, at the nodes of the run.
       */
      void
      smooth(const std::vector<double> &displacement,
             std::vector<double>       &field) const
      {
        const Window      window(run.size(), contact.dundurs_beta);
        const std::size_t m = window.n_corrected, n = m + window.n_fitted;
        if (m == 0)
          return;
        const double scale  = std::abs(compliance(0, 0) - compliance(0, 1)),
                     length = along(n - 1) - along(0);
        DenseMatrix         matrix(n, m + 3);
        std::vector<double> solution(n);
        for (std::size_t k = 0; k < n; ++k)
          {
            const double x = (along(k) - along(0)) / length;
            for (std::size_t j = 0; j < m; ++j)
              matrix(k, j) = compliance(k, j) / scale;
            for (unsigned int power = 0; power < 3; ++power)
              matrix(k, m + power) = -std::pow(x, power);
            solution[k] = -displacement[k];
          }
        if (solve_least_squares(matrix, solution))
          for (std::size_t j = 0; j < m; ++j)
            field[j] += solution[j] / scale;
      }

      const ContactProblem &contact;
      const Run            &run;
      std::size_t           offset;
      int                   flow;
    };



    std::vector<double>
    on_run(const Run                 &run,
           const std::vector<double> &nodal,
           const std::size_t          offset = 0)
    {
      std::vector<double> values;
      for (const unsigned int node : run)
        values.push_back(nodal[offset + node]);
      return values;
    }



    /**
     * W_tt H f for a field given on the nodes and used as the traction of one
     * component.
     */
    std::vector<double>
    displacement_of(const ContactProblem      &contact,
                    const std::vector<double> &field,
                    const unsigned int         component)
    {
      std::vector<double> traction(contact.n_tangential * contact.n_nodes, 0.);
      std::copy(field.begin(),
                field.end(),
                traction.begin() + component * contact.n_nodes);
      return contact.tangential_displacement(traction);
    }



    /**
     * The companion of the pressure in the tangential compliance: equal to it
     * but for the first nodes, where the two compliances of finite elements
     * differ at the scale of an element.
     */
    std::vector<double>
    companion(const EdgeProblem         &edge,
              const std::vector<double> &pressure,
              const std::vector<double> &displacement_of_pressure)
    {
      std::vector<double> field = on_run(edge.run, pressure);
      edge.smooth(on_run(edge.run, displacement_of_pressure, edge.offset),
                  field);
      return field;
    }



    /**
     * q_n: the traction that answers the tangential displacement of the
     * pressure near the edge, on the run.
     */
    std::vector<double>
    coupling_traction(const EdgeProblem         &edge,
                      const std::vector<double> &pressure)
    {
      const Run                &run     = edge.run;
      const ContactProblem     &contact = edge.contact;
      const std::size_t         n       = run.size();
      const std::vector<double> p       = on_run(run, pressure);
      std::vector<double>       field(n, 0.);
      if (!contact.coupled || n < 10 || edge.offset > 0)
        return field;
      std::vector<double> x(n), x_reversed, p_reversed(p.rbegin(), p.rend());
      for (std::size_t k = 0; k < n; ++k)
        x[k] = edge.along(k);
      x_reversed.assign(x.rbegin(), x.rend());
      const double        begin  = patch_edge(x, p);
      const double        end    = patch_edge(x_reversed, p_reversed);
      const double        margin = 0.02 * (edge.along(1) - edge.along(0));
      std::vector<double> nodal(contact.n_nodes, 0.);
      for (std::size_t k = 0; k < n; ++k)
        {
          if (x[k] > begin + margin && x[k] < end - margin)
            field[k] = edge.flow * contact.dundurs_beta / pi * p[k] *
                       std::log((x[k] - begin) / (end - x[k]));
          nodal[run[k]] = field[k];
        }
      std::vector<double> displacement = displacement_of(contact, nodal, 0);
      const std::vector<double> of_pressure =
        contact.tangential_displacement_of_pressure(pressure);
      for (std::size_t i = 0; i < displacement.size(); ++i)
        displacement[i] += of_pressure[i];
      edge.smooth(on_run(run, displacement), field);
      return field;
    }



    /**
     * d/dx at node 1 from nodes 1, 2 and 3.
     */
    void
    take_inside_derivative(const EdgeProblem &edge, TangentialProblem &problem)
    {
      const Run   &run    = edge.run;
      const double h      = edge.along(1) - edge.along(0),
                   h2     = edge.along(2) - edge.along(1);
      const double second = edge.flow * (h + h2) / (h * h2),
                   third  = -edge.flow * h / (h2 * (h + h2));
      problem.B1[run[0]]  = {{run[0], -second - third},
                             {run[1], second},
                             {run[2], third}};
    }



    /**
     * The inside derivative at node 1, and one-element differences where the
     * upstream points leave the contact.
     */
    void
    replace_slip_rows(const EdgeProblem &edge, TangentialProblem &problem)
    {
      const Run &run = edge.run;
      for (std::size_t k = 1; k < run.size(); ++k)
        {
          const double d = edge.along(k) - edge.along(k - 1);
          if (edge.along(k) - 2 * d > edge.along(0) - 1e-9 * d)
            break;
          problem.B1[run[k]] = {{run[k], edge.flow / d},
                                {run[k - 1], -edge.flow / d}};
          for (std::size_t i = run[k]; i < problem.slip_at_zero.size();
               i += edge.contact.n_nodes)
            problem.slip_at_zero[i] =
              (edge.contact.rigid_slip[i] +
               edge.contact.rigid_slip[i - run[k] + run[k - 1]]) /
              2;
        }
      if (run.size() >= 3)
        take_inside_derivative(edge, problem);
    }



    /**
     * kappa L of one component at node 1.
     */
    void
    add_law(const EdgeProblem         &edge,
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
      const std::size_t component = edge.offset / edge.contact.n_nodes;
      SparseRows::Row  &row       = problem.edge_rows[component][edge.run[0]];
      double &constant = problem.edge_constants[edge.offset + edge.run[0]];
      constant         = 0.;
      row.clear();
      for (unsigned int k = 0; k < (linear ? 3u : 2u); ++k)
        {
          row.emplace_back(edge.run[k], weights[k]);
          constant -= weights[k] * coupling[k];
        }
    }



    /**
     * A first node that barely touches carries friction in the proportion of
     * the next node, by the constant law.
     */
    void
    follow_next_node(const ContactProblem      &contact,
                     const Run                 &run,
                     const std::vector<double> &pressure,
                     TangentialProblem         &problem)
    {
      take_inside_derivative(EdgeProblem(contact, run, 0), problem);
      for (unsigned int c = 0; c < contact.n_tangential; ++c)
        add_law(EdgeProblem(contact, run, c),
                on_run(run, pressure),
                std::vector<double>(run.size(), 0.),
                false,
                problem);
    }



    /**
     * True if a companion pulls at the first node, in any component.
     */
    bool
    drops_first_node(const ContactProblem                   &contact,
                     const Run                              &run,
                     const std::vector<double>              &pressure,
                     const std::vector<std::vector<double>> &displacements)
    {
      for (unsigned int c = 0; c < contact.n_tangential; ++c)
        if (companion(EdgeProblem(contact, run, c),
                      pressure,
                      displacements[c])[0] <= 0.)
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
    std::vector<Run>    runs = touching_runs(contact.slip_operator, pressure);
    std::vector<double> frictional = pressure;
    auto displacements = displacements_of_pressure(contact, frictional);
    bool released      = false;
    for (Run &run : runs)
      if (run.size() >= 6 &&
          drops_first_node(contact, run, pressure, displacements))
        {
          if (linear(run[1]))
            {
              problem.bound[run[0]] = frictional[run[0]] = 0.;
              released                                   = true;
            }
          else
            follow_next_node(contact, run, pressure, problem);
          run.erase(run.begin());
        }
    if (released)
      displacements = displacements_of_pressure(contact, frictional);

    for (const Run &run : runs)
      {
        replace_slip_rows(EdgeProblem(contact, run, 0), problem);
        if (run.size() < 3)
          continue;
        problem.edges.push_back(
          {{{run[0], run[1], run[2]}}, static_cast<unsigned int>(run.size())});
        for (unsigned int c = 0; c < contact.n_tangential; ++c)
          {
            const EdgeProblem edge(contact, run, c);
            add_law(edge,
                    linear(run[0])
                      ? companion(edge, frictional, displacements[c])
                      : on_run(run, frictional),
                    coupling_traction(edge, frictional),
                    linear(run[0]),
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
