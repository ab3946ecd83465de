#include <rolling_contact/analyses/study_summary.h>
#include <rolling_contact/base/text.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace RollingContact
{
  StudySummary::StudySummary(const Situation    &scene,
                             const StudyResults &results,
                             RunContext         &context)
    : scene(scene)
    , results(results)
    , context(context)
  {
    const StudyParameters &study = scene.inputs->study;
    force_reference              = std::to_string(study.reference_elements) +
                      " elements, mean of " + std::to_string(study.n_offsets) +
                      " positions" +
                      (study.extrapolate_reference ? ", extrapolated" : "");
    for (std::size_t i = 0; i < results.cases.size(); ++i)
      references.push_back(study_reference(study, results, i));
    for (const auto &[key, samples] : results.samples)
      all_errors[key] =
        study_errors(results.cases[key.state], references[key.state], samples);
  }

  void StudySummary::write()
  {
    write_cases();
    say_references();
    write_methods();
  }

  std::string StudySummary::load_reference() const
  {
    const StudyKey finest{results.reference_method,
                          0,
                          scene.inputs->study.reference_elements};
    if (results.samples.at(finest).front().errors.load)
      return "load against the exact clamped discs";
    return (scene.contact.normal_load ? "approach" : "load") +
           std::string(" against the same meshes");
  }

  void StudySummary::say_references() const
  {
    double change = 0.;
    for (const StudyReference &reference : references)
      change = std::max(change, reference.change);
    context.log.message(
      "Forces over mu N against " + force_reference +
      (scene.inputs->study.extrapolate_reference
         ? ", which changed them by at most " + scientific(change, 2)
         : std::string()) +
      "; " + load_reference() +
      (scene.profiles.in_use()
         ? ", pressure over its peak against the finest mesh"
         : ", pressure over p0 against Hertz") +
      (results.carter
         ? ", traction over mu p0 and stick boundary (in elements) "
           "against Carter"
         : ", traction over mu p0 against the finest mesh") +
      ". Largest of all positions and creepages; CPU time and memory "
      "(libraries included) of one state alone:");
  }

  void StudySummary::write_cases() const
  {
    ResultsTable table(context.folder, "summary.csv");
    for (const auto &[key, errors] : all_errors)
      add_case_row(key, errors, table);
    table.flush();
  }

  namespace
  {
    void set_error(const std::string    &name,
                   const MeanAndLargest &error,
                   ResultsTable         &table)
    {
      if (error.n == 0)
        return;
      table.set(name + "_max", error.largest);
      table.set(name + "_mean", error.mean);
    }

    void set_cost(const StudyErrors &errors, ResultsTable &table)
    {
      table.set("unknowns", std::lround(errors.n_unknowns));
      table.set("contact_nodes", std::lround(errors.n_contact_nodes));
      table.set("cpu_mesh_assembly_s", errors.seconds.mesh);
      table.set("cpu_factorisation_condensation_s",
                errors.seconds.factorisation);
      table.set("cpu_contact_s", errors.seconds.contact);
      table.set("cpu_s", errors.seconds.total());
      table.set("peak_memory_bytes", errors.peak_memory);
      table.set("states", errors.n_states);
      table.set("not_converged", errors.n_not_converged);
      table.set("residual_max", errors.residual);
    }
  } // namespace

  void StudySummary::add_case_row(const StudyKey    &key,
                                  const StudyErrors &errors,
                                  ResultsTable      &table) const
  {
    const StudyMethod    &method = results.methods[key.method];
    const StudyCase      &state  = results.cases[key.state];
    const StudyReference &limit  = references[key.state];
    table.set("mesh", method.mesh);
    table.set("slip_operator", method.slip_operator);
    table.set("solver", method.solver);
    table.set("direction", state.direction);
    table.set("creepage_over_saturation", state.over_saturation);
    table.set("elements", key.elements);
    table.set("reference_force_x/muN", limit.force[0]);
    table.set("reference_force_y/muN", limit.force[1]);
    set_error("force_error", errors.force, table);
    const auto coarser =
      all_errors.find({key.method, key.state, key.elements / 2});
    if (coarser != all_errors.end() && errors.force.n > 0 &&
        coarser->second.force.n > 0 &&
        key.elements != scene.inputs->study.reference_elements)
      table.set("order_of_mean",
                std::log2(
                  std::abs(coarser->second.force.mean / errors.force.mean)));
    set_error("load_error", errors.load, table);
    set_error("pressure_l2", errors.pressure, table);
    set_error("traction_l2", errors.traction, table);
    set_error("sawtooth", errors.sawtooth, table);
    set_error("stick_boundary_elements", errors.stick_boundary, table);
    set_cost(errors, table);
    table.set("force_reference", force_reference);
    table.set("load_reference", load_reference());
    const std::string finest =
      std::to_string(scene.inputs->study.reference_elements) +
      " elements, first position";
    table.set("pressure_reference",
              scene.profiles.in_use() ? finest : std::string("Hertz"));
    table.set("traction_reference",
              results.carter ? std::string("Carter") : finest);
    table.end_row();
  }

  std::string StudySummary::name_of(const std::size_t method) const
  {
    return results.methods[method].name(results.methods.front());
  }

  std::vector<unsigned int>
  StudySummary::meshes_of(const std::size_t method) const
  {
    std::vector<unsigned int> meshes =
      results.methods[method].mesh == "adaptive"
        ? scene.inputs->study.starts_of_levels()
        : scene.inputs->study.elements;
    std::sort(meshes.begin(), meshes.end());
    return meshes;
  }

  void StudySummary::write_methods() const
  {
    ResultsTable             table(context.folder, "methods.csv");
    std::vector<StudyErrors> rows;
    for (std::size_t method = 0; method < results.n_compared; ++method)
      for (const unsigned int elements : meshes_of(method))
        {
          std::vector<StudyErrors> cases;
          for (std::size_t i = 0; i < results.cases.size(); ++i)
            cases.push_back(all_errors.at({method, i, elements}));
          rows.push_back(worst_case(cases));
          table.set("method", name_of(method));
          table.set("elements", elements);
          set_error("force_error", rows.back().force, table);
          set_error("load_error", rows.back().load, table);
          set_error("pressure_l2", rows.back().pressure, table);
          set_error("traction_l2", rows.back().traction, table);
          set_error("stick_boundary_elements",
                    rows.back().stick_boundary,
                    table);
          set_cost(rows.back(), table);
          table.end_row();
        }
    table.flush();
    say_methods(rows);
    report_points();
  }

  void StudySummary::say_methods(const std::vector<StudyErrors> &rows) const
  {
    const auto largest = [](const MeanAndLargest &error) {
      return error.n > 0 ? scientific(error.largest, 2) : "-";
    };
    const auto milliseconds = [](const double seconds) {
      return seconds < 0.1 ? significant(1e3 * seconds, 2)
                           : std::to_string(std::lround(1e3 * seconds));
    };
    TextTable accuracy{
      {"", "n", "force", "load", "pressure", "traction", "stick"}},
      cost{{"CPU in ms",
            "n",
            "dofs",
            "nodes",
            "mesh",
            "factor",
            "solve",
            "all",
            "MB"}};
    auto row = rows.begin();
    for (std::size_t method = 0; method < results.n_compared; ++method)
      for (const unsigned int elements : meshes_of(method))
        {
          const std::string  name   = name_of(method);
          const StudyErrors &errors = *row++;
          accuracy.push_back(
            {name,
             std::to_string(elements),
             errors.n_not_converged > 0
               ? std::to_string(errors.n_not_converged) + " failed"
               : largest(errors.force),
             largest(errors.load),
             largest(errors.pressure),
             largest(errors.traction),
             largest(errors.stick_boundary)});
          cost.push_back({name,
                          std::to_string(elements),
                          std::to_string(std::lround(errors.n_unknowns)),
                          std::to_string(std::lround(errors.n_contact_nodes)),
                          milliseconds(errors.seconds.mesh),
                          milliseconds(errors.seconds.factorisation),
                          milliseconds(errors.seconds.contact),
                          milliseconds(errors.seconds.total()),
                          std::to_string(errors.peak_memory / 1000000)});
        }
    context.log.message(aligned_table(accuracy));
    context.log.message(aligned_table(cost));
  }

  ErrorCostSet StudySummary::points_of(const std::string &direction) const
  {
    ErrorCostSet set{direction.empty() ? "all" : direction, {}};
    for (std::size_t method = 0; method < results.n_compared; ++method)
      for (const unsigned int elements : meshes_of(method))
        {
          std::vector<StudyErrors> cases;
          for (std::size_t i = 0; i < results.cases.size(); ++i)
            if (direction.empty() || results.cases[i].direction == direction)
              cases.push_back(all_errors.at({method, i, elements}));
          const StudyErrors errors = worst_case(cases);
          set.points.push_back({name_of(method),
                                std::to_string(elements) + " elements",
                                errors.seconds.total(),
                                errors.n_not_converged > 0
                                  ? std::numeric_limits<double>::quiet_NaN()
                                  : errors.force.largest});
        }
    return set;
  }

  void StudySummary::report_points() const
  {
    std::vector<ErrorCostSet> sets{points_of("")};
    if (scene.inputs->study.directions.size() > 1)
      for (const std::string &direction : scene.inputs->study.directions)
        sets.push_back(points_of(direction));
    report_errors_and_costs(sets,
                            "largest error of T / (\u03bcN)",
                            "state",
                            context);
    note_study_error(
      sets.front().points, "force", "mu N", force_reference, context.report);
  }
} // namespace RollingContact
