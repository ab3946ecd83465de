#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/scene/analysis_traits.h>
#include <rolling_contact/scene/entries.h>
#include <rolling_contact/scene/stability_parameters.h>

namespace RollingContact
{
  void StabilityParameters::declare(Entries &entries)
  {
    EntrySection &section = entries.section("Stability");
    section.read_with_reduced_bodies(
      "Analysis = stability, stability map, corrugation or rolling noise reads "
      "that section");
    section.renews = Renews::loads;
    section.varies = asks<AnalysisTraits>([](const auto &analysis) {
      return analysis.has_many_states && analysis.linearises;
    });
    entries
      .choice("Wheel",
              wheels,
              std::vector<NamedValue<WheelsFound>>{{"none", WheelsFound::none},
                                                   {"right",
                                                    WheelsFound::right},
                                                   {"left", WheelsFound::left},
                                                   {"both", WheelsFound::both}})
      .read_by({asks<AnalysisTraits>([](const auto &analysis) {
                  return analysis.takes_found_place;
                }),
                "Analysis = stability or stability map reads it"})
      .help =
      "Wheel of a wheelset in balance, see section Wheelset: its place, "
      "motion and load are found first. `none`: they are given in sections "
      "Profiles and Contact.";
    const Reader of_growth = {asks<AnalysisTraits>([](const auto &analysis) {
                                return !analysis.passes_waves;
                              }),
                              "surfaces with waves give the frequencies "
                              "themselves"};
    const Reader one_state = {asks<AnalysisTraits>([](const auto &analysis) {
                                return analysis.linearises &&
                                       !analysis.has_many_states &&
                                       !analysis.passes_waves;
                              }),
                              "Analysis = stability of one state reads it"};
    entries.add("Lowest frequency", lowest_frequency, "Hz")
      .at_least(0.)
      .read_by(of_growth)
      .help = "Lowest frequency of the vibrations that are looked for, up to "
              "Modes/Maximum frequency.";
    entries.add("Rotation", rotation).help =
      "Whether the wheel turns under the contact while it vibrates, with "
      "Contact/Speed over its radius. The rotation splits the wheel's pairs "
      "of modes.";
    entries.add("Added damping", added_damping, "1").at_least(0.).help =
      "Damping ratio that is added to all modes of both bodies, as a damper "
      "would.";
    entries.add("Count check", count).read_by(of_growth).help =
      "Whether the unstable vibrations are counted by the argument principle "
      "too, independently of the eigenvalues.";
    entries.add("Full model", correct).help =
      "Whether each unstable vibration, or the wave that grows most, is "
      "corrected by the equations of the whole bodies. The run reports the "
      "difference.";
    entries.add("Thresholds", thresholds).read_by(one_state).help =
      "Whether friction, creepages and damping are varied from the state on "
      "until the last vibration ceases to grow, or the first one begins to.";
    entries.add("Damping margin", damping_margin, "1")
      .at_least(0.)
      .read_by(of_growth)
      .help = "Damping ratio that a cured mode shall have beyond the limit of "
              "stability. It is added to the damping that is needed.";
  }

  void StabilityParameters::check() const
  {
    if (!(lowest_frequency > 0.))
      throw InputError(
        "Stability/Lowest frequency = " + text_of(lowest_frequency) +
        ": it must be above 0 Hz; 60 is below every squeal.");
  }
} // namespace RollingContact
