#include <rolling_contact/analyses/accuracy_study.h>
#include <rolling_contact/analyses/study_kind.h>
#include <rolling_contact/analyses/time_study.h>
#include <rolling_contact/base/exceptions.h>

namespace RollingContact
{
  namespace
  {
    template <int dim>
    std::unique_ptr<Analysis> make_study(const Situation &scene,
                                         RunContext      &context)
    {
      return scene.inputs->study.varies_time_step
               ? make_analysis<TimeStudy<dim>>(scene, context)
               : make_analysis<AccuracyStudy<dim>>(scene, context);
    }

    void check_study(const SceneParameters &scene)
    {
      scene.study.check(scene.dimension);
      if (scene.mesh.adaptive_levels > 0)
        throw InputError(
          "Mesh/Adaptive levels = " +
          std::to_string(scene.mesh.adaptive_levels) +
          ": an accuracy study has its own meshes (Accuracy study/Elements "
          "across patch); set it to 0.");
      for (const BodyParameters *body : {&scene.wheel, &scene.rail})
        if (body->is_from_file())
          throw InputError(
            "Analysis = accuracy study: a body " +
            std::string(body->is_section() ? "with a section from a file ("
                                           : "from a mesh file (") +
            body->section + "/Shape) has one mesh only, a study needs many.");
      if (scene.surfaces.in_use() || names_a_record(scene.contact.roughness))
        throw InputError("Analysis = accuracy study: its meshes would each "
                         "show another surface (section Surfaces, or a file of "
                         "Contact/Roughness). Leave the heights empty.");
      if (scene.contact.forces.any())
        throw InputError("Contact/Longitudinal force, Lateral force or Spin "
                         "moment and Analysis = accuracy study: a study "
                         "compares the forces of given creepages; leave them "
                         "empty.");
      if (scene.has_reduced_bodies())
        throw InputError("Time/Bodies = reduced: Analysis = accuracy study "
                         "varies theta, and reduced bodies have 0.5; take "
                         "full.");
      if (scene.body_solver == BodySolver::distributed)
        throw InputError(
          "Body solver = distributed: an accuracy study factorises "
          "its bodies; take direct or automatic.");
      if (scene.profiles.in_use() && scene.profiles.gives_creepages())
        throw InputError("Profiles/Creepages = from kinematics: an accuracy "
                         "study has its own creepages (Accuracy "
                         "study/Creepages over saturation); take given.");
    }
  } // namespace

  AnalysisKind accuracy_study_kind()
  {
    AnalysisKind kind;
    kind.name     = "accuracy study";
    kind.help     = "the same state on many meshes, or the same transient with "
                    "many steps, see section Accuracy study";
    kind.in_2d    = &make_study<2>;
    kind.in_3d    = &make_study<3>;
    kind.sections = {"Accuracy study"};
    kind.has_own_meshes = true;
    kind.on_ranks       = false;
    kind.rules          = {&check_study};
    return kind;
  }
} // namespace RollingContact
