#include <rolling_contact/solvers/touching_friction.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /**
     * The touching unknowns, both components of a node side by side.
     */
    std::vector<NodalIndex> touching_unknowns(const TangentialProblem &problem)
    {
      std::vector<NodalIndex> unknowns;
      for (unsigned int i = 0; i < problem.contact.n_nodes(); ++i)
        if (problem.bound[i] > 0.)
          for (unsigned int c = 0; c < 2; ++c)
            unknowns.push_back({c, i});
      return unknowns;
    }

    /**
     * ds/dq of two nodal components on half-spaces.
     */
    double slip_of_entry(const TangentialProblem &problem,
                         const NodalIndex        &of,
                         const NodalIndex        &by)
    {
      const ContactOperators &operators = problem.contact.operators;
      const GridCompliance   &W         = *operators.W().on_grid();
      double                  sum       = 0.;
      for (const auto &[j, area] : operators.H_column(by.node))
        for (const auto &[i, weight] : problem.rows.B1[of.node])
          sum += weight * area *
                 W.of_half_space({of.component, i}, {by.component, j});
      sum *= operators.flow_convection();
      if (of.component == by.component &&
          by.component < problem.rows.edge_rows.size())
        for (const auto &[j, value] :
             problem.rows.edge_rows[of.component][of.node])
          if (j == by.node)
            sum += value;
      return sum;
    }
  } // namespace

  TouchingFriction::TouchingFriction(const TangentialProblem &problem)
    : problem(problem)
    , unknowns(touching_unknowns(problem))
    , norm(problem.contact.operators.tangential_norm())
    , friction_force(problem.contact.operators.resultant(problem.bound))
  {
    const NodalField no_traction(problem.contact.n_nodes(), 2);
    slip_at_zero = gathered(problem.slip(no_traction));
    for (const NodalIndex &unknown : unknowns)
      {
        bound.push_back(problem.bound[unknown.node]);
        area.push_back(problem.contact.operators.areas()[unknown.node]);
      }
    if (problem.contact.operators.W().on_grid())
      make_lines();
    else
      slip_compliance = problem.slip_compliance(unknowns);
  }

  void TouchingFriction::make_lines()
  {
    const std::size_t        none = unknowns.size();
    std::vector<std::size_t> first(problem.contact.n_nodes(), none);
    for (std::size_t k = 0; k < unknowns.size(); k += 2)
      first[unknowns[k].node] = k;
    for (const auto &nodes : problem.contact.operators.slip_operator().lines())
      {
        Line line;
        for (const unsigned int node : nodes)
          if (first[node] != none)
            line.first.push_back(first[node]);
        const std::size_t n  = 2 * line.first.size();
        line.slip_compliance = DenseMatrix(n, n);
        for (std::size_t j = 0; j < n; ++j)
          for (std::size_t i = 0; i < n; ++i)
            line.slip_compliance(i, j) =
              slip_of_entry(problem,
                            unknowns[line.first[i / 2] + i % 2],
                            unknowns[line.first[j / 2] + j % 2]);
        if (n > 0)
          lines.push_back(std::move(line));
      }
  }

  std::vector<double> TouchingFriction::gathered(const NodalField &field) const
  {
    std::vector<double> values;
    for (const NodalIndex &unknown : unknowns)
      values.push_back(field[unknown]);
    return values;
  }

  void TouchingFriction::scatter(const std::vector<double> &values,
                                 NodalField                &field) const
  {
    for (std::size_t k = 0; k < unknowns.size(); ++k)
      field[unknowns[k]] = values[k];
  }

  std::vector<double>
  TouchingFriction::slip(const std::vector<double> &traction) const
  {
    return sum(change_of_slip(traction), 1., slip_at_zero);
  }

  std::vector<double>
  TouchingFriction::change_of_slip(const std::vector<double> &traction) const
  {
    if (!is_on_grid())
      return slip_compliance * traction;
    NodalField q(problem.contact.n_nodes(), 2);
    scatter(traction, q);
    NodalField s =
      problem.slip_of(problem.contact.operators.distortion_of_traction(q));
    for (unsigned int c = 0; c < problem.rows.edge_rows.size(); ++c)
      for (const NodalIndex &unknown : unknowns)
        if (unknown.component == c)
          s[unknown] += apply(problem.rows.edge_rows[c][unknown.node], q, c);
    return gathered(s);
  }

  void TouchingFriction::project(std::vector<double> &traction) const
  {
    for (std::size_t k = 0; k < traction.size(); k += 2)
      {
        const double size = std::hypot(traction[k], traction[k + 1]);
        if (size > bound[k])
          for (unsigned int c = 0; c < 2; ++c)
            traction[k + c] *= bound[k] / size;
      }
  }

  double TouchingFriction::residual(const std::vector<double> &traction) const
  {
    const std::vector<double> s   = slip(traction);
    double                    sum = 0.;
    for (std::size_t k = 0; k < traction.size(); k += 2)
      {
        const double x     = traction[k] - s[k] / norm,
                     y     = traction[k + 1] - s[k + 1] / norm;
        const double size  = std::hypot(x, y),
                     scale = size > bound[k] ? bound[k] / size : 1.;
        sum += area[k] * (std::abs(traction[k] - scale * x) +
                          std::abs(traction[k + 1] - scale * y));
      }
    return sum / friction_force;
  }
} // namespace RollingContact
