#include <rolling_contact/base/text.h>
#include <rolling_contact/contact/resultants.h>
#include <rolling_contact/results/nodal_values.h>
#include <rolling_contact/results/patch_output.h>
#include <rolling_contact/run/figure.h>
#include <rolling_contact/run/results_table.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace RollingContact
{
  namespace
  {
    /** NAME_UNIT, m^2 as m2. */
    std::string column_of(const NodalQuantity &quantity,
                          const std::string   &component)
    {
      std::string unit = quantity.unit;
      unit.erase(std::remove(unit.begin(), unit.end(), '^'), unit.end());
      return quantity.name + component + (unit == "1" ? "" : '_' + unit);
    }
  } // namespace

  template <int dim>
  void write_nodes(const PairSpec         &scene,
                   const SteadyState<dim> &steady,
                   RunContext             &context,
                   const std::string      &name)
  {
    static const std::string directions[] = {"_x", "_y"};
    const NodalState         all(steady.problem,
                         steady.state,
                         !steady.restored,
                         &scene);

    std::vector<std::pair<std::string, std::vector<double>>> columns;
    for (const NodalQuantity &quantity : nodal_quantities())
      if (const auto field = quantity.of(all); field && !field->empty())
        for (unsigned int c = 0; c < field->n_components(); ++c)
          columns.emplace_back(
            column_of(quantity, quantity.is_vector ? directions[c] : ""),
            field->component(c));
    ResultsTable table(context.folder, name + ".csv");
    const auto  &positions = steady.problem.operators.positions();
    for (unsigned int i = 0; i < steady.problem.n_nodes(); ++i)
      {
        for (int d = 0; d < dim - 1; ++d)
          table.set(d == 0 ? "x_m" : "y_m", positions[i][d]);
        for (const auto &[column, values] : columns)
          table.set_if(std::isfinite(values[i]), column, values[i]);
        table.end_row();
      }
    table.flush();
  }

  namespace
  {
    const double mega = 1e-6, milli = 1e3; // of Pa and m, as they are drawn

    std::string signed_number(const double value)
    {
      return (value < 0. ? "\u2212" : "") + significant(std::abs(value), 4);
    }

    std::string title(const SteadyState<3> &steady)
    {
      const Resultants &result = steady.result;
      const bool        kilo   = result.normal_force >= 1e3;
      const std::string unit   = kilo ? " kN" : " N";
      const auto        scaled = [&](const double force) {
        const double nothing = 1e-9 * result.normal_force;
        return std::abs(force) < nothing ? 0. : (kilo ? 1e-3 : 1.) * force;
      };
      std::string text = "N = " + significant(scaled(result.normal_force), 4);
      text += unit;
      if (steady.problem.n_tangential() > 0)
        text += ", T = (" + signed_number(scaled(result.force_x)) + ", " +
                signed_number(scaled(result.force_y)) + ')' + unit;
      return text + ", p up to " + significant(mega * result.max_pressure, 4) +
             " MPa";
    }

    /** The fields of a state at its nodes, in mm and MPa. */
    struct Patch
    {
      explicit Patch(const SteadyState<3> &steady)
        : all(steady.problem, steady.state)
        , states(node_states(all.tangential(), steady.state))
        , has_friction(steady.problem.n_tangential() > 0)
      {
        for (const auto &at : steady.problem.operators.positions())
          for (const unsigned int d : {0, 1})
            place[d].push_back(milli * at[d]);
        const RecoveredTractions &found = all.recovered();
        for (std::size_t i = 0; i < states.size(); ++i)
          {
            pressure.push_back(mega * found.pressure[i]);
            for (unsigned int d = 0; has_friction && d < 2; ++d)
              traction[d].push_back(mega * found.traction(d, i));
            bound.push_back(has_friction
                              ? all.tangential().friction[i] * pressure.back()
                              : 0.);
          }
      }

      /** The nodes of the line along d through the largest pressure. */
      std::vector<std::size_t> line(const unsigned int d) const
      {
        const std::size_t peak =
          std::max_element(pressure.begin(), pressure.end()) - pressure.begin();
        const double             same_place = 1e-6; // mm
        std::vector<std::size_t> nodes;
        for (std::size_t i = 0; i < states.size(); ++i)
          if (std::abs(place[1 - d][i] - place[1 - d][peak]) < same_place)
            nodes.push_back(i);
        std::sort(nodes.begin(),
                  nodes.end(),
                  [&](const std::size_t i, const std::size_t j) {
                    return place[d][i] < place[d][j];
                  });
        return nodes;
      }

      const NodalState                   all;
      const std::vector<NodeState>       states;
      const bool                         has_friction;
      std::array<std::vector<double>, 2> place, traction; ///< along x, y
      std::vector<double>                pressure, bound;
    };

    /** The nodes of a state with their tractions, a node's arrow as long as
     * two elements where the traction is largest. An arrow without length
     * stands for a state that no node has, so that colours stay the same. */
    void add_arrows(const Patch       &patch,
                    const NodeState    state,
                    const std::string &label,
                    const double       length,
                    Figure            &figure)
    {
      double      largest  = 0.;
      std::size_t touching = 0;
      for (std::size_t i = 0; i < patch.states.size(); ++i)
        {
          largest =
            std::max(largest,
                     std::hypot(patch.traction[0][i], patch.traction[1][i]));
          if (patch.states[i] != NodeState::open)
            touching = i;
        }
      std::array<std::vector<double>, 2> at, along;
      for (std::size_t i = 0; i < patch.states.size(); ++i)
        if (patch.states[i] == state)
          for (const unsigned int d : {0, 1})
            {
              at[d].push_back(patch.place[d][i]);
              along[d].push_back(
                largest > 0. ? length * patch.traction[d][i] / largest : 0.);
            }
      for (const unsigned int d : {0, 1})
        if (at[d].empty())
          {
            at[d].push_back(patch.place[d][touching]);
            along[d].push_back(0.);
          }
      figure.add_arrows(label, at[0], at[1], along[0], along[1]);
    }

    void add_line(const Patch &patch, const unsigned int d, Figure &figure)
    {
      static const std::string axes[] = {"x along the rail (mm)",
                                         "y across (mm)"};
      std::vector<double>      place, pressure, size, bound;
      for (const std::size_t i : patch.line(d))
        {
          place.push_back(patch.place[d][i]);
          pressure.push_back(patch.pressure[i]);
          if (!patch.has_friction)
            continue;
          size.push_back(
            std::hypot(patch.traction[0][i], patch.traction[1][i]));
          bound.push_back(patch.bound[i]);
        }
      Figure panel("",
                   axes[d],
                   patch.has_friction ? "|q|, \u03bcp (MPa)" : "p (MPa)");
      if (patch.has_friction)
        {
          panel.add_curve("|q|", place, size, CurveStyle::line_and_points);
          panel.add_curve("\u03bcp", place, bound, CurveStyle::reference);
        }
      else
        panel.add_curve("p", place, pressure, CurveStyle::line_and_points);
      figure.add_separate_panel(panel);
    }
  } // namespace

  void plot_patch(const PairSpec       &scene,
                  const SteadyState<3> &steady,
                  RunContext           &context,
                  const std::string    &name)
  {
    if (!steady.solver.converged || steady.result.n_touching == 0)
      return;
    const Patch patch(steady);
    Figure      figure(title(steady),
                  "x along the rail (mm), material flows to the " +
                    std::string(scene.contact.flow() > 0 ? "right" : "left"),
                  "y across (mm)");
    figure.set_equal_scales();
    std::array<std::vector<double>, 2> touching;
    for (std::size_t i = 0; i < patch.states.size(); ++i)
      if (patch.states[i] != NodeState::open)
        for (const unsigned int d : {0, 1})
          touching[d].push_back(patch.place[d][i]);
    figure.add_curve("touches", touching[0], touching[1], CurveStyle::marks);
    const double elements = 2.,
                 length   = elements * milli *
                          std::min(steady.grading.element_size_x,
                                   steady.grading.element_size_y);
    if (patch.has_friction)
      {
        add_arrows(patch, NodeState::stick, "q, sticks", length, figure);
        add_arrows(patch, NodeState::slip, "q, slides", length, figure);
      }
    for (const unsigned int d : {0, 1})
      add_line(patch, d, figure);
    figure.draw(context, name);
  }

  template void write_nodes(const PairSpec &,
                            const SteadyState<2> &,
                            RunContext &,
                            const std::string &);
  template void write_nodes(const PairSpec &,
                            const SteadyState<3> &,
                            RunContext &,
                            const std::string &);
} // namespace RollingContact
