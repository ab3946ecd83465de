#include <rolling_contact/analyses/solve_to_target.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /**
     * "Mesh/Target error = 0.005".
     */
    std::string entry_of(const Situation &scene)
    {
      return "Mesh/Target error = " + significant(*scene.mesh.target_error, 6);
    }

    /**
     * Gives the scene the mesh, says so and notes it for run.json.
     */
    void take(const TargetMesh &mesh, Situation &scene, RunContext &context)
    {
      scene.mesh.elements_across_patch = mesh.elements;
      scene.mesh.growth                = mesh.growth;
      if (scene.mesh.elements_across_patch_y > 0) // see its help
        scene.mesh.elements_across_patch_y =
          std::max(scene.mesh.elements_across_patch_y,
                   static_cast<unsigned int>(std::ceil(0.8 * mesh.elements)));
      BuiltItem item;
      item.object = "mesh with " + std::to_string(mesh.elements) +
                    " elements across the patch and a growth of " +
                    significant(mesh.growth, 3);
      const std::string why = "expected bound " +
                              scientific(*mesh.bounds.force, 2) + " (" +
                              mesh.bounds.text + ")";
      item.reason = entry_of(scene) + ": " + why;
      context.report.objects.push_back(item);
      context.log.message(entry_of(scene) + " takes a " + item.object + ": " +
                          why + ".");
    }

  } // namespace

  template <int dim>
  SteadyState<dim>
  solve_to_target(Situation                                           &scene,
                  const StateDemands                                  &demands,
                  const TargetDemands                                 &targets,
                  RunContext                                          &context,
                  const std::function<void(const SteadyState<dim> &)> &on_level)
  {
    AdaptiveLevels<dim> levels(scene, demands, context);
    if (!scene.mesh.target_error)
      return levels.run(on_level);
    const double       target   = *scene.mesh.target_error;
    const unsigned int n_meshes = 3;
    TargetError        chooser(scene, targets);
    for (unsigned int k = 1;; ++k)
      {
        const TargetMesh mesh = chooser.cheapest_mesh();
        take(mesh, scene, context);
        SteadyState<dim> steady;
        try
          {
            steady = levels.run([](const auto &) {});
          }
        catch (const MemoryError &error)
          {
            throw MemoryError(entry_of(scene) + " takes " +
                              std::to_string(scene.mesh.elements_across_patch) +
                              " elements across the patch and a growth of " +
                              significant(mesh.growth, 3) +
                              ", give a larger one. " + error.what());
          }
        const ErrorBounds bounds = chooser.bounds_on(mesh, steady);
        if (k == n_meshes || !steady.solver.converged ||
            steady.result.n_touching == 0 ||
            (bounds.force && *bounds.force <= target))
          {
            on_level(steady);
            return steady;
          }
        context.log.message("The bound is " +
                            (bounds.force ? scientific(*bounds.force, 2) +
                                              " (" + bounds.text + ')'
                                          : "not known (" + bounds.text + ')') +
                            ": the mesh is made again.");
        chooser.learn(mesh, steady, k + 1 == n_meshes);
      }
  }

  void warn_of_missed_target(const Situation &scene, RunContext &context)
  {
    if (!scene.mesh.target_error)
      return;
    for (const ErrorStatement &error : context.report.errors)
      if (error.quantity == "force" &&
          !(error.value <= *scene.mesh.target_error))
        context.log.warning(entry_of(scene) + " is missed: " + error.text() +
                            ". Give a smaller target.");
  }

  template SteadyState<2>
  solve_to_target(Situation &,
                  const StateDemands &,
                  const TargetDemands &,
                  RunContext &,
                  const std::function<void(const SteadyState<2> &)> &);
  template SteadyState<3>
  solve_to_target(Situation &,
                  const StateDemands &,
                  const TargetDemands &,
                  RunContext &,
                  const std::function<void(const SteadyState<3> &)> &);
} // namespace RollingContact
