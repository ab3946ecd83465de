#include <rolling_contact/base/number_text.h>
#include <rolling_contact/scene/analysis_traits.h>
#include <rolling_contact/scene/contact_parameters.h>
#include <rolling_contact/scene/entries.h>
#include <rolling_contact/scene/output_parameters.h>

namespace RollingContact
{
  namespace
  {
    const std::vector<NamedValue<Verbosity>> named_verbosities{
      {"quiet", Verbosity::quiet},
      {"normal", Verbosity::normal},
      {"verbose", Verbosity::verbose}};
  } // namespace

  void OutputParameters::declare(Entries &entries)
  {
    entries.section("Output").free_on_resume = in_all_scenes;
    entries.add("Body fields", body_fields)
      .read_by({asks<AnalysisTraits>(
                  [](const auto &analysis) { return !analysis.finds_place; }),
                "a wheelset writes fields of its contacts only"})
      .help = "Write bodies.pvd: displacement, stress and von Mises stress.";
    entries.add("Contact problem", contact_problem)
      .read_by({asks<AnalysisTraits>(
                  [](const auto &analysis) { return analysis.has_one_state; }),
                "this analysis has no single steady state"})
      .read_by({asks<ContactParameters>([](const auto &contact) {
                  return !contact.falling_friction();
                }),
                "friction depends on the sliding speed"})
      .help = "Write contact_problem.h5: compliance, contact matrix, slip "
              "operator, loads and solution of the discrete contact.";
    entries.add("Interface fields", interface_fields).help =
      "Write interface.pvd: pressure, traction, slip, gap and state; for "
      "profiles that wear, profiles.pvd.";
    entries.add("Plot", plot).help =
      "Write plots as SVG, each with its data and gnuplot script: tractions "
      "in 2D, profiles, curves, histories, maps, modes.";
    entries.choice("Verbosity", verbosity, named_verbosities).help =
      "How much is printed on the screen: `quiet`, `normal` or `verbose`.";
  }
} // namespace RollingContact
