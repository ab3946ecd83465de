#include <rolling_contact/contact/node_lines.h>
#include <rolling_contact/contact/resultants.h>
#include <rolling_contact/results/lines_across.h>
#include <rolling_contact/results/state_damage.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace RollingContact
{
  namespace
  {
    /** Nodes by lines along x, these by their place over @p same_place. */
    std::map<long, std::vector<unsigned int>>
    nodes_of_lines(const SteadyState<3> &steady)
    {
      const double same_place = 1e-3 * steady.grading.element_size_y;
      std::map<long, std::vector<unsigned int>> lines;
      const auto &positions = steady.problem.operators.positions();
      for (unsigned int i = 0; i < steady.problem.n_nodes(); ++i)
        lines[std::lround(positions[i][1] / same_place)].push_back(i);
      return lines;
    }
  } // namespace

  std::vector<LineAcross> lines_across(const SteadyState<3> &steady)
  {
    const ContactProblem   &problem     = steady.problem;
    const ContactState     &state       = steady.state;
    const TangentialProblem tangential  = tangential_problem(problem, state);
    const std::vector<NodeState> states = node_states(tangential, state);
    const std::vector<double>   &areas  = problem.operators.areas();
    std::optional<NodalField>    slip;
    if (problem.n_tangential() > 0)
      slip = tangential.mean_slip(state);
    std::vector<LineAcross> lines;
    for (const auto &[place, nodes] : nodes_of_lines(steady))
      {
        LineAcross line;
        line.y     = problem.operators.positions()[nodes.front()][1];
        line.nodes = nodes;
        for (const unsigned int i : nodes)
          {
            line.max_pressure = std::max(line.max_pressure, state.pressure[i]);
            line.load += areas[i] * state.pressure[i];
            line.n_touching += states[i] != NodeState::open;
            line.n_stick += states[i] == NodeState::stick;
            for (unsigned int c = 0; slip && c < slip->n_components(); ++c)
              line.heat -= areas[i] * state.traction(c, i) * (*slip)(c, i);
          }
        lines.push_back(line);
      }
    std::vector<double> places;
    for (const LineAcross &line : lines)
      places.push_back(line.y);
    const std::vector<double> widths = widths_of_lines(places);
    for (std::size_t k = 0; k < lines.size(); ++k)
      if (LineAcross &line = lines[k]; widths[k] > 0.)
        {
          line.width = widths[k];
          line.load /= line.width;
          line.heat /= line.width;
        }
    return lines;
  }

  namespace
  {
    /** Places on rail and wheel of a line at y; none beyond their ends. */
    void set_places_on_profiles(const Profiles::ContactFrame &frame,
                                const double                  y,
                                ResultsTable                 &table)
    {
      const Profiles::ProfileCurve &wheel =
        frame.wheel_on_rail().wheel_profile();
      const auto rail   = frame.rail_in_track(y);
      const auto length = frame.wheel_arc_length(y);
      table.set_if(rail.has_value(), "y_track_m", rail ? (*rail)[0] : 0.);
      table.set_if(rail.has_value(), "height_m", rail ? (*rail)[1] : 0.);
      table.set_if(length.has_value(),
                   "y_wheel_m",
                   length ? wheel.at(*length).y : 0.);
    }
  } // namespace

  void write_lines_across(const PairSpec       &scene,
                          const SteadyState<3> &steady,
                          RunContext           &context,
                          const std::string    &file)
  {
    const Profiles::ContactFrame *frame = scene.frame.get();
    if (!(frame || scene.touches_in_line()) || !steady.solver.converged ||
        steady.result.n_touching == 0)
      return;
    ResultsTable               table(context.folder, file);
    std::optional<StateDamage> damage;
    if (StateDamage::is_asked(scene, steady.problem))
      damage.emplace(scene, steady.problem, steady.state);
    for (const LineAcross &line : lines_across(steady))
      {
        if (line.n_touching == 0)
          continue;
        table.set("y_m", line.y);
        table.set("width_m", line.width);
        if (frame)
          set_places_on_profiles(*frame, line.y, table);
        table.set("max_pressure_Pa", line.max_pressure);
        table.set("load_N/m", line.load);
        table.set("dissipation_J/m2", line.heat);
        table.set("nodes_in_contact", line.n_touching);
        table.set("nodes_in_stick", line.n_stick);
        if (damage)
          set_depth_columns(scene, *damage, line, table);
        table.end_row();
      }
    table.flush();
  }
} // namespace RollingContact
