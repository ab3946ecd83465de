#include <rolling_contact/base/choices.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/scene/entries.h>
#include <rolling_contact/scene/scene_parameters.h>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    const std::vector<NamedValue<BodySolver>> named_body_solvers{
      {"automatic", BodySolver::automatic},
      {"direct", BodySolver::direct},
      {"distributed", BodySolver::distributed}};
  } // namespace

  Entries SceneParameters::declare(const std::vector<AnalysisTraits> &analyses)
  {
    Entries entries;
    entries.add("Dimension", dimension, "1").between(2, 3).help =
      "2: plane strain in x (rolling direction) and z (normal); 3: three "
      "dimensions.";
    entries
      .parsed("Analysis",
              Entry::Kind::text,
              analysis.name,
              "",
              [this, analyses](const std::string &name) {
                analysis = choice(analyses, name, "Analysis");
              })
      .one_of(choice_names(analyses))
      .help = choice_help(analyses);
    entries.choice("Body solver", body_solver, named_body_solvers)
      .resumed_if(
        [](const SceneParameters &scene) { return scene.analysis.records_run; })
      .help =
      "How the displacements of a body are computed. `direct`: one "
      "factorisation, on one rank, or with mpirun -n 2 on a rank each for "
      "wheel and rail. `distributed`: conjugate gradients with a multigrid "
      "preconditioner on all ranks of mpirun. `automatic`: direct on one rank "
      "if the factors are predicted to fit into 70 % of the free memory, else "
      "distributed. Accuracy studies and bodies with a Poisson ratio above "
      "0.49 are always direct.";
    entries.add("Body threads", body_threads, "1")
      .between(1, 2)
      .resumed_if(in_all_scenes)
      .help =
      "2: wheel and rail are computed at the same time; 1: one after the "
      "other. Both give the same numbers.";
    wheel.declare(entries);
    rail.declare(entries);
    contact.declare(entries);
    solver.declare(entries);
    mesh.declare(entries);
    study.declare(entries);
    table.declare(entries);
    time.declare(entries);
    surfaces.declare(entries);
    spectrum.declare(entries);
    sound.declare(entries);
    profiles.declare(entries);
    modes.declare(entries);
    stability.declare(entries);
    wear.declare(entries);
    output.declare(entries);
    for (const AnalysisTraits &kind : analyses)
      if (kind.own_section)
        own_sections.push_back(*kind.own_section);
    for (OwnSection &section : own_sections)
      section.declare(entries);
    return entries;
  }

  FrictionResponse SceneParameters::friction_response() const
  {
    const std::string &response = contact.friction_response;
    if (!contact.falling_friction() || response == "constant")
      return FrictionResponse::constant;
    const bool vibrates = analysis.linearises || has_reduced_bodies();
    return response == "patch mean" || (response == "automatic" && vibrates)
             ? FrictionResponse::patch_mean
             : FrictionResponse::node;
  }

  void SceneParameters::check() const
  {
    for (const OwnSection &section : own_sections)
      section.check();
    if (analysis.has_bodies)
      {
        wheel.check(dimension);
        rail.check(dimension);
      }
    if (analysis.has_contact)
      check_contact();
    else
      check_rules();
  }

  void SceneParameters::check_rules() const
  {
    for (const auto &rule : analysis.rules)
      rule(*this);
  }

  std::vector<TableAxis> SceneParameters::axes() const
  {
    if (analysis.has_many_states)
      return table.axes();
    return analysis.axes ? analysis.axes(*this) : std::vector<TableAxis>();
  }

  void SceneParameters::check_contact() const
  {
    contact.check(dimension, !finds_place());
    mesh.check();
    surfaces.check(dimension);
    if (wear.report)
      wear.check();
    check_target_error();
    check_hubs();
    check_mesh_files();
    if (marches())
      time.check(contact, dimension, prm_folder);
    check_speed();
    check_hot_friction();
    if (contact.forces.any())
      check_forces("Contact/Longitudinal force, Lateral force or Spin moment",
                   contact.forces.y || contact.forces.moment);
    check_reduced_bodies();
    check_excitation();
    check_rules();
    check_friction_response();
    check_pair();
    check_covers();
    check_body_solver();
    check_profiles();
    check_curvatures();
  }

} // namespace RollingContact
