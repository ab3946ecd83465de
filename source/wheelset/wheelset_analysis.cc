#include <rolling_contact/results/bodies_report.h>
#include <rolling_contact/results/interface_fields.h>
#include <rolling_contact/results/lines_across.h>
#include <rolling_contact/results/patch_output.h>
#include <rolling_contact/results/profile_plot.h>
#include <rolling_contact/results/state_damage.h>
#include <rolling_contact/scene/scene_parameters.h>
#include <rolling_contact/wheelset/found_place.h>
#include <rolling_contact/wheelset/wheelset_analysis.h>

namespace RollingContact
{
  void WheelsetAnalysis::run()
  {
    PhaseTimer::Scope phase(context.timer, Phase::contact_solve);
    const std::size_t n = solver.n_cases();
    for (std::size_t k = 0; k < n; ++k)
      {
        const std::vector<FoundEquilibrium> found = solver.next();
        report.add(found);
        for (const FoundEquilibrium &one : found)
          write_fields(one, k, n);
        if (k == 0)
          describe_bodies(found[0].steady[0], context);
      }
    report.finish();
  }

  void WheelsetAnalysis::write_fields(const FoundEquilibrium &found,
                                      const std::size_t       number,
                                      const std::size_t       of)
  {
    const std::string names[] = {"right", "left"};
    for (unsigned int wheel = 0; wheel < 2; ++wheel)
      {
        const std::string name =
          (found.name.empty() ? "" : found.name + '_') + names[wheel] +
          (of > 1 ? '_' + std::to_string(number + 1) : "");
        const PairSpec       &of_wheel = *found.scenes[wheel];
        const SteadyState<3> &steady   = found.steady[wheel];
        if (scene.inputs->output.interface_fields)
          {
            write_interface(of_wheel,
                            steady,
                            context.folder,
                            "interface_" + name + ".vtu");
            write_nodes(of_wheel, steady, context, "nodes_" + name);
          }
        write_lines_across(of_wheel,
                           steady,
                           context,
                           "across_" + name + ".csv");
        if (scene.inputs->output.plot)
          {
            plot_patch(of_wheel, steady, context, "patch_" + name);
            plot_profiles(of_wheel, steady, context, "profiles_" + name);
            plot_shakedown_map(of_wheel, steady, context, "shakedown_" + name);
          }
      }
  }

  AnalysisKind wheelset_kind()
  {
    AnalysisKind kind = kind_of<WheelsetAnalysis>(
      "wheelset",
      "where a wheelset or a bogie runs in balance, on straight track and in "
      "curves, see section Wheelset");
    kind.sections = {"Wheelset"};
    kind.own_section.emplace(WheelsetParameters());
    kind.on_ranks    = false;
    kind.finds_place = true;
    kind.rules       = rules_of_wheelsets();
    return kind;
  }
} // namespace RollingContact
