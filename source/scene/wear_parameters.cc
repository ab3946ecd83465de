#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/scene/analysis_traits.h>
#include <rolling_contact/scene/entries.h>
#include <rolling_contact/scene/scene_parameters.h>
#include <rolling_contact/scene/wear_parameters.h>

#include <tuple>

namespace RollingContact
{
  namespace
  {
    using Damage::ArchardScatter;
    using Damage::CatastrophicBranch;
    using Damage::DamageThreshold;

    const std::vector<NamedValue<ArchardScatter>> scatters{
      {"lowest", ArchardScatter::lowest},
      {"middle", ArchardScatter::middle},
      {"highest", ArchardScatter::highest}};

    const std::vector<NamedValue<CatastrophicBranch>> branches{
      {"continuous", CatastrophicBranch::continuous},
      {"code", CatastrophicBranch::code},
      {"florence", CatastrophicBranch::florence}};

    const std::vector<NamedValue<DamageThreshold>> thresholds{
      {"15", DamageThreshold::newton_15},
      {"20", DamageThreshold::newton_20}};
  } // namespace

  void WearParameters::check() const
  {
    for (const auto &[entry, value, unit] :
         {std::tuple("Hardness", hardness, "Pa"),
          std::tuple("Density", density, "kg/m^3"),
          std::tuple("Shear yield stress", shear_yield_stress, "Pa")})
      if (!(value > 0.))
        throw InputError("Wear/" + std::string(entry) + " = " + text_of(value) +
                         ": it must be above 0, in " + unit + '.');
  }

  void WearParameters::declare(Entries &entries)
  {
    EntrySection &section =
      entries.section("Wear")
        .read_by(analyses_with_elements())
        .read_by(analyses_of_contact())
        .read_by(scenes_in_3d())
        .read_by({asks<AnalysisTraits>([](const auto &analysis) {
                    return !analysis.marches && !analysis.linearises;
                  }),
                  "an analysis of steady states reads that section"});
    section.renews = Renews::loads;
    section.varies = in_all_scenes;
    const Reader reports{[](const SceneParameters &scene) {
                           return scene.wear.report ||
                                  scene.analysis.wears_profiles;
                         },
                         "Wear/Report = false"};
    entries.add("Report", report)
      .read_by({asks<AnalysisTraits>([](const auto &analysis) {
                  return !analysis.wears_profiles;
                }),
                "an evolution of profiles tells of its own wear"})
      .help =
      "Whether wear and fatigue of each steady state are reported: columns of "
      "results.csv, depths per passage in across.csv, fields of "
      "interface.vtu, and the shakedown map.";
    entries.add("Hardness", hardness, "Pa").read_by(reports).help =
      "Hardness of the softer body, for Archard's law.";
    entries.add("Density", density, "kg/m^3").read_by(reports).help =
      "Density that turns worn mass into depth.";
    entries.add("Shear yield stress", shear_yield_stress, "Pa")
      .read_by({[reports](const SceneParameters &scene) {
                  return reports.reads(scene) ||
                         scene.surfaces.has_files(scene.contact.roughness);
                },
                reports.otherwise})
      .help = "Shear yield stress k, for the indices of fatigue, the "
              "shakedown map, and the warning of peak pressures on measured "
              "surfaces.";
    entries.add("Archard coefficient", archard_coefficient, "1")
      .at_least(0.)
      .read_by(reports)
      .help = "Coefficient k of Archard's law, worn volume k F s / H by a load "
              "F that slides by s, wherever the contact slides. A K per load "
              "and distance (m^2/N) times Hardness. 0: by the chart for "
              "wheels and rails.";
    entries.choice("Archard coefficients", archard_scatter, scatters)
      .read_by(reports)
      .read_by({[](const SceneParameters &scene) {
                  return scene.wear.archard_coefficient == 0.;
                },
                "Wear/Archard coefficient is given"})
      .help = "Where in the scatter of measurements the coefficients of "
              "Archard's law lie: `lowest`, `middle` or `highest`. The wear "
              "at both ends is in columns as well.";
    entries.choice("Catastrophic branch", catastrophic_branch, branches)
      .read_by(reports)
      .help =
      "How the law `usfd` continues above 77.2 N/mm^2: `continuous`, or with "
      "a jump as in programs (`code`) or in print (`florence`).";
    entries.choice("Damage threshold", threshold, thresholds)
      .read_by(reports)
      .help = "Value of T gamma (N) from which on its damage function counts "
              "a passage.";
  }
} // namespace RollingContact
