#include <deal.II/base/parameter_handler.h>

#include <rolling_contact/base/choices.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/input/prm_declarations.h>
#include <rolling_contact/scene/scene_parameters.h>

#include <cmath>

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



  void
  SceneParameters::declare(ParameterHandler                   &prm,
                           const std::vector<DescribedChoice> &analyses)
  {
    prm.add_parameter(
      "Dimension",
      dimension,
      "2 (x, z: rolling direction and normal, plane strain) or 3. "
      "Units: 1.",
      Patterns::Integer(2, 3));
    prm.add_parameter("Analysis",
                      analysis,
                      choice_help(analyses),
                      Patterns::Selection(choice_names(analyses)));
    declare_choice(
      prm,
      "Body solver",
      body_solver,
      named_body_solvers,
      "How the displacements of a body are found. `direct`: one factorisation, "
      "on one rank or, under mpirun -n 2, wheel and rail on a rank each. "
      "`distributed`: spread over all ranks of mpirun, multigrid-preconditioned "
      "conjugate gradients. `automatic`: direct on one rank if the factors are "
      "predicted to fit into 70 % of the free memory, else distributed. An "
      "accuracy study and bodies with a Poisson ratio above 0.49 are always "
      "direct.");
    prm.add_parameter(
      "Body threads",
      body_threads,
      "2: wheel and rail at the same time; 1: one after the other, "
      "with the same numbers. Units: 1.",
      Patterns::Integer(1, 2));
    wheel.declare(prm);
    rail.declare(prm);
    contact.declare(prm);
    solver.declare(prm);
    mesh.declare(prm);
    creep_curve.declare(prm);
    load_curve.declare(prm);
    study.declare(prm);
    table.declare(prm);
    time.declare(prm);
    surfaces.declare(prm);
    spectrum.declare(prm);
    sound.declare(prm);
    profiles.declare(prm);
    modes.declare(prm);
    receptance.declare(prm);
    stability.declare(prm);
    limit_cycle.declare(prm);
    output.declare(prm);
  }



  FrictionResponse
  SceneParameters::friction_response() const
  {
    const std::string &response = contact.friction_response;
    if (!contact.falling_friction() || response == "constant")
      return FrictionResponse::constant;
    const bool vibrates = is_of_stability() || has_reduced_bodies();
    return response == "patch mean" || (response == "automatic" && vibrates)
             ? FrictionResponse::patch_mean
             : FrictionResponse::node;
  }



  void
  SceneParameters::read_meshes()
  {
    wheel.read_mesh(dimension, prm_folder, profiles.in_use());
    rail.read_mesh(dimension, prm_folder, profiles.in_use());
  }



  void
  SceneParameters::read_surfaces()
  {
    if (analysis != "contact table" && !is_of_structures())
      surfaces.read(prm_folder);
  }



  void
  SceneParameters::check() const
  {
    if (analysis == "contact table")
      return profiles.check(wheel.radius, prm_folder);
    wheel.check(dimension);
    rail.check(dimension);
    if (is_of_structures())
      return check_structures();
    contact.check(dimension);
    mesh.check();
    check_surfaces();
    check_target_error();
    check_study();
    check_table();
    creep_curve.check();
    if (analysis == "creep curve" && dimension == 2)
      creep_curve.check_in_2d();
    load_curve.check();
    check_hubs();
    check_mesh_files();
    if (is_transient())
      time.check(contact, dimension, prm_folder);
    check_spectra();
    check_speed();
    check_forces();
    check_stability();
    check_reduced_bodies();
    check_excitation();
    check_cycles();
    check_friction_response();
    check_sound();
    check_pair();
    check_body_solver();
    check_profiles();
    check_curvatures();
  }



  void
  SceneParameters::read_profiles()
  {
    if (!profiles.in_use() || analysis == "contact table")
      return contact.take_creepage_by_size();
    profiles.find_frame(wheel.radius, prm_folder);
    if (wheel.is_section())
      wheel.profile = profiles.placed_wheel();
    if (rail.is_section())
      rail.profile = profiles.placed_rail();
    if (profiles.has_true_sections())
      {
        if (!wheel.rigid)
          wheel.profile = profiles.placed_wheel();
        if (!rail.rigid)
          rail.profile = profiles.placed_rail();
        wheel.check(dimension);
        rail.check(dimension);
      }
    take_derived_contact();
  }



  void
  SceneParameters::take_derived_contact()
  {
    contact.take_creepage_by_size();
    if (!profiles.frame)
      return;
    if (profiles.gives_creepages())
      contact.creepages =
        profiles.frame->creepages(contact.rolling_speed(), profiles.pitch_rate);
    if (contact.vertical_load)
      contact.normal_load = *contact.vertical_load /
                            std::cos(profiles.frame->angle() - load_angle());
  }



  double
  SceneParameters::load_angle() const
  {
    return contact.vertical_load &&
               profiles.frame->kind() == Profiles::SurfaceKind::curved
             ? profiles.frame->angle()
             : 0.;
  }
} // namespace RollingContact
