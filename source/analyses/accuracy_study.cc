#include <rolling_contact/analyses/accuracy_study.h>
#include <rolling_contact/base/choices.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/memory.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/contact/recovered_tractions.h>
#include <rolling_contact/results/reference_3d.h>
#include <rolling_contact/results/result_row.h>
#include <rolling_contact/solvers/normal_active_set.h>
#include <rolling_contact/state/adaptive_levels.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  template <int dim>
  AccuracyStudy<dim>::AccuracyStudy(const Situation &scene, RunContext &context)
    : scene(scene)
    , context(context)
    , patch(estimate_patch(scene))
  {
    demands.pair.factors = true;
  }

  template <int dim>
  void AccuracyStudy<dim>::run()
  {
    const StudyParameters &study = scene.inputs->study;
    list_cases();
    list_methods();
    context.log.message(
      std::to_string(n_states()) + " states, those of the reference of " +
      std::to_string(study.reference_elements) + " elements first.");
    progress.emplace(context.log, "state", n_states());
    solve_reference();
    for (const std::string &mesh : study.meshes)
      if (mesh == "adaptive")
        for (const std::size_t method : methods_on(mesh))
          for (const unsigned int start : study.starts_of_levels())
            solve_levels(start, method);
      else
        for (const unsigned int elements : study.elements)
          solve_mesh(mesh, elements, methods_on(mesh));
    StudySummary(scene, results, context).write();
  }

  template <int dim>
  Creepages AccuracyStudy<dim>::saturation() const
  {
    const double mu = scene.contact.friction_coefficient;
    if (mu <= 0. || patch.half_width_x <= 0.)
      throw InputError("Analysis = accuracy study needs contact and friction: "
                       "check Contact/Approach, Contact/Normal load and "
                       "Contact/Friction coefficient.");
    if (dim == 2)
      return {mu * patch.half_width_x / pair_constants(scene).relative_radius,
              0.,
              0.};
    const auto linear = [&](const Creepages &creepages) {
      if (!scene.profiles.in_use())
        return reference_3d(scene, patch.normal_force, creepages).linear();
      return linear_theory(scene,
                           patch.half_width_x,
                           patch.half_width_y,
                           creepages);
    };
    const double limit = 3 * mu * patch.normal_force;
    return {limit / std::abs(linear({1., 0., 0.}).x),
            limit / std::abs(linear({0., 1., 0.}).y),
            limit / std::abs(linear({0., 0., 1.}).y)};
  }

  template <int dim>
  void AccuracyStudy<dim>::list_cases()
  {
    const Creepages limit = saturation();
    for (const std::string &direction : scene.inputs->study.directions)
      for (const double part : scene.inputs->study.creepages)
        {
          const bool   combined = direction == "combined";
          const double share    = combined ? part / std::sqrt(3.) : part;
          const auto   of       = [&](const std::string &name) {
            return combined || direction == name ? share : 0.;
          };
          results.cases.push_back({direction,
                                   part,
                                   {of("longitudinal") * limit.x,
                                    of("lateral") * limit.y,
                                    of("spin") * limit.spin}});
        }
  }

  template <int dim>
  std::vector<std::size_t>
  AccuracyStudy<dim>::methods_on(const std::string &mesh) const
  {
    std::vector<std::size_t> indices;
    for (std::size_t k = 0; k < results.n_compared; ++k)
      if (results.methods[k].mesh == mesh)
        indices.push_back(k);
    return indices;
  }

  template <int dim>
  void AccuracyStudy<dim>::list_methods()
  {
    auto &methods = results.methods;
    methods       = study_methods(scene.inputs->study);
    const auto known =
      std::find_if(methods.begin(), methods.end(), [&](const auto &method) {
        return method.mesh == "uniform" &&
               method.slip_operator == "calibrated" &&
               method.solver == scene.solver.solver;
      });
    results.n_compared       = methods.size();
    results.reference_method = known - methods.begin();
    if (known == methods.end())
      methods.push_back({"uniform", "calibrated", scene.solver.solver});
  }

  template <int dim>
  std::vector<unsigned int>
  AccuracyStudy<dim>::meshes_of_reference_alone() const
  {
    const StudyParameters &study = scene.inputs->study;
    const bool is_listed = results.reference_method < results.n_compared;
    std::vector<unsigned int> meshes;
    for (const unsigned int elements : reference_meshes(study))
      if (elements == study.reference_elements || !is_listed ||
          std::find(study.elements.begin(), study.elements.end(), elements) ==
            study.elements.end())
        meshes.push_back(elements);
    return meshes;
  }

  template <int dim>
  std::uint64_t AccuracyStudy<dim>::n_states() const
  {
    const StudyParameters &study = scene.inputs->study;
    std::uint64_t          n     = meshes_of_reference_alone().size();
    for (const std::string &mesh : study.meshes)
      n += methods_on(mesh).size() * (mesh == "adaptive"
                                        ? study.starts_of_levels().size()
                                        : study.elements.size());
    return n * study.n_offsets * results.cases.size();
  }

  template <int dim>
  void AccuracyStudy<dim>::solve_reference()
  {
    for (const unsigned int elements : meshes_of_reference_alone())
      solve_mesh("uniform", elements, {results.reference_method});
  }

  template <int dim>
  Situation AccuracyStudy<dim>::scene_of(const std::size_t method) const
  {
    const auto &[mesh, slip_operator, solver] = results.methods[method];
    Situation varied                          = scene;
    varied.solver.solver                      = solver;
    if (mesh == "graded")
      varied.mesh.rim_levels = scene.inputs->study.rim_levels;
    if (slip_operator != "paper")
      {
        varied.contact.slip_operator =
          choice(slip_operator_choices(), slip_operator, "Slip operators").kind;
        return varied;
      }
    varied.contact.slip_operator    = SlipOperatorKind::galerkin;
    varied.contact.contact_matrices = ContactMatrices::consistent;
    if (solver == "automatic")
      varied.solver.solver = "extragradient";
    varied.solver.controls.tolerance =
      std::max(scene.solver.controls.tolerance,
               scene.inputs->study.paper_tolerance);
    return varied;
  }

  template <int dim>
  Situation AccuracyStudy<dim>::with_case(Situation         scene,
                                          const std::size_t index) const
  {
    scene.contact.creepages = results.cases[index].creepages;
    return scene;
  }

  template <int dim>
  SteadyState<dim> AccuracyStudy<dim>::set_up(const Situation &scene,
                                              Grading<dim>     grading)
  {
    const StateFinder<dim> finder(scene, demands, context);
    SteadyState<dim>       steady;
    solve_on_fitting_mesh(
      [&](const unsigned int) {
        steady = {};
        steady = finder.set_up(grading);
        PhaseTimer::Scope phase(context.timer, Phase::condensation);
        steady.state = initial_state(steady.problem, patch);
        NormalActiveSet(scene.solver.controls)
          .solve(steady.problem, steady.state);
      },
      [&](const unsigned int) {
        const bool too_small = zone_too_small(steady);
        if (too_small)
          grading.enlarge_zone(1);
        return too_small;
      });
    return steady;
  }

  template <int dim>
  void AccuracyStudy<dim>::solve_mesh(const std::string              &mesh,
                                      const unsigned int              elements,
                                      const std::vector<std::size_t> &methods)
  {
    const unsigned int n_offsets = scene.inputs->study.n_offsets;
    const Situation    first     = scene_of(methods.front());
    for (unsigned int k = 0; k < n_offsets; ++k)
      {
        throw_if_interrupted();
        release_free_memory();
        reset_peak_memory();
        const StateSeconds before = state_seconds(context.timer);
        SteadyState<dim>   steady =
          set_up(first,
                 make_grading<dim>(
                   first, demands, patch, elements, double(k) / n_offsets));
        // of the first method, as it would be for any
        const StateSeconds set_up = state_seconds(context.timer) - before;
        for (const std::size_t method : methods)
          {
            const Situation varied = scene_of(method);
            if (method != methods.front())
              {
                PhaseTimer::Scope phase(context.timer, Phase::condensation);
                steady.problem = steady.pair->contact_problem(
                  varied.contact, std::move(steady.problem.operators).W());
              }
            for (std::size_t i = 0; i < results.cases.size(); ++i)
              solve_case({method, i, elements},
                         with_case(varied, i),
                         set_up,
                         steady);
          }
      }
    context.log.message(
      mesh + ", " + std::to_string(elements) + " elements: " +
      std::to_string(n_offsets * methods.size() * results.cases.size()) +
      " states");
  }

  template <int dim>
  void AccuracyStudy<dim>::solve_case(const StudyKey     &key,
                                      const Situation    &scene,
                                      const StateSeconds &set_up,
                                      SteadyState<dim>   &steady)
  {
    const StateSeconds before      = state_seconds(context.timer);
    steady.problem.loads.creepages = scene.contact.creepages;
    steady.state                   = initial_state(steady.problem, patch);
    StateFinder<dim>(scene, demands, context).solve_enclosed(steady);
    StateSeconds seconds = set_up;
    seconds.add(1., state_seconds(context.timer) - before);
    if (steady.solver.converged && zone_too_small(steady))
      throw ConvergenceError(
        "Accuracy study, " + std::to_string(key.elements) +
        " elements: the patch reaches the border of the candidate zone; take "
        "a larger Mesh/Candidate zone.");
    keep(key, scene, seconds, steady);
  }

  template <int dim>
  void AccuracyStudy<dim>::solve_levels(const unsigned int start,
                                        const std::size_t  method)
  {
    const unsigned int n_offsets = scene.inputs->study.n_offsets;
    for (unsigned int k = 0; k < n_offsets; ++k)
      for (std::size_t i = 0; i < results.cases.size(); ++i)
        solve_levels({method, i, start}, double(k) / n_offsets);
    context.log.message(
      "adaptive, from " + std::to_string(start) + " elements: " +
      std::to_string(n_offsets * results.cases.size()) + " states");
  }

  template <int dim>
  void AccuracyStudy<dim>::solve_levels(const StudyKey &key,
                                        const double    offset)
  {
    Situation varied = with_case(scene_of(key.method), key.state);
    varied.mesh.elements_across_patch = key.elements;
    varied.mesh.adaptive_levels       = scene.inputs->study.adaptive_levels;
    varied.mesh.target_change         = 0.;
    varied.mesh.patch_offset          = offset;
    release_free_memory();
    reset_peak_memory();
    const StateSeconds before = state_seconds(context.timer);
    Log                quiet(Verbosity::quiet);
    RunContext         unheard{
      context.folder, context.results, context.report, context.timer, quiet};
    const SteadyState<dim> steady =
      AdaptiveLevels<dim>(varied, demands, unheard).run([](const auto &) {});
    keep(key, varied, state_seconds(context.timer) - before, steady);
  }

  template <int dim>
  void AccuracyStudy<dim>::keep(const StudyKey         &key,
                                const Situation        &scene,
                                const StateSeconds     &seconds,
                                const SteadyState<dim> &steady)
  {
    const bool is_reference =
      key.method == results.reference_method &&
      key.elements == scene.inputs->study.reference_elements;
    const TractionField *field =
      !is_reference && !finest.empty() ? &finest[key.state] : nullptr;
    StudySample sample = study_sample(scene, steady, field);
    sample.seconds     = seconds;
    sample.peak_memory = peak_memory_since_reset();
    results.samples[key].push_back(sample);
    context.results.set("mesh", results.methods[key.method].mesh);
    context.results.set("operator", results.methods[key.method].slip_operator);
    context.results.set("cpu_s", seconds.total());
    add_result_row(scene, steady, context);
    progress->report(++n_done);
    const auto meshes = reference_meshes(scene.inputs->study);
    if (!sample.converged && key.method == results.reference_method &&
        std::find(meshes.begin(), meshes.end(), key.elements) != meshes.end())
      throw ConvergenceError(
        "Accuracy study, the reference of " + std::to_string(key.elements) +
        " elements, creepage " +
        significant(results.cases[key.state].over_saturation, 3) +
        " of saturation: " + steady.solver.reason + ".");
    if (!is_reference)
      return;
    results.carter = follows_carter(scene, steady);
    if (!results.carter && finest.size() == key.state)
      finest.push_back({steady.pair->trace(),
                        recovered_tractions(steady.problem, steady.state)});
  }

  template class AccuracyStudy<2>;
  template class AccuracyStudy<3>;
} // namespace RollingContact
