#include <fmt/format.h>

#include <rolling_contact/analyses/stability_verdict.h>
#include <rolling_contact/base/text.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /** Thresholds that turn the verdict, the smallest share of a change first,
     * then those without a share. */
    std::vector<DrivingThreshold>
    turning(const std::vector<DrivingThreshold> &thresholds)
    {
      std::vector<DrivingThreshold> found;
      for (const DrivingThreshold &threshold : thresholds)
        if (threshold.found)
          found.push_back(threshold);
      std::stable_sort(found.begin(),
                       found.end(),
                       [](const DrivingThreshold &a,
                          const DrivingThreshold &b) {
                         return a.share > 0. &&
                                (!(b.share > 0.) || a.share < b.share);
                       });
      return found;
    }

    /** "-0.0094 +- 0.0008": digits down to the second one of the
     * uncertainty. */
    std::string with_uncertainty(const double value, const double uncertainty)
    {
      const int digits =
        uncertainty > 0.
          ? std::clamp(static_cast<int>(std::ceil(1 - std::log10(uncertainty))),
                       0,
                       9)
          : 6;
      return fmt::format(
        "{:.{}f} +- {:.{}f}", value, digits, uncertainty, digits);
    }

    std::string percent(const double share)
    {
      return significant(100 * share, 2) + " %";
    }

    /** "friction 0.148 +- 0.002 in place of 0.5 (70 %)" */
    std::string text_of(const DrivingThreshold &threshold)
    {
      return threshold.quantity + ' ' +
             with_uncertainty(threshold.value, threshold.uncertainty) +
             " in place of " + significant(threshold.now, 3) +
             (threshold.share > 0. ? " (" + percent(threshold.share) + ")"
                                   : "") +
             (threshold.by_sticking
                ? ", where a node begins to stick, known to an element of the "
                  "mesh only"
                : "");
    }

    /** "friction down to 0.025" of those that turn nothing. */
    std::string rest_of(const std::vector<DrivingThreshold> &thresholds,
                        const bool                           unknown)
    {
      std::string text;
      for (const DrivingThreshold &threshold : thresholds)
        if (!threshold.found && threshold.known != unknown)
          text += (text.empty() ? "" : ", ") + threshold.quantity + " up to " +
                  significant(threshold.to, 3);
      return text;
    }

    std::string table_of_modes(const std::vector<Finding>     &findings,
                               const std::vector<std::string> &names)
    {
      std::string text =
        "| mode | Hz | growth, 1/s | +- | damping ratio needed |\n"
        "|---|---|---|---|---|\n";
      for (std::size_t k = 0; k < findings.size(); ++k)
        if (const Finding &it = findings[k]; it.unstable())
          text += fmt::format(
            "| {} | {} | {} | {} | {} |\n",
            names[k],
            significant(it.mode.frequency(), 5),
            significant(it.growth(), 4),
            it.corrected ? significant(it.corrected->uncertainty, 1) : "",
            it.corrected ? significant(it.corrected->damping_needed, 3) : "");
      return text;
    }

    std::string
    table_of_thresholds(const std::vector<DrivingThreshold> &thresholds)
    {
      const std::vector<DrivingThreshold> found = turning(thresholds);
      if (found.empty())
        return "";
      std::string text =
        "\n| quantity | now | threshold | +- | stable from | change | vibration |\n"
        "|---|---|---|---|---|---|---|\n";
      for (const DrivingThreshold &it : found)
        text += fmt::format("| {} | {} | {} | {} | {} | {} | {} {} Hz |\n",
                            it.quantity,
                            significant(it.now, 4),
                            significant(it.value, 4),
                            significant(it.uncertainty, 2),
                            significant(it.stable, 4),
                            it.share > 0. ? percent(it.share) : "",
                            it.mode,
                            significant(it.frequency, 5));
      return text +
             "\nOne quantity is changed at a time, on the same mesh. The "
             "smallest change comes first; change is a share of the value, or "
             "of all creepage. +- includes the interval that the search "
             "leaves and the difference from the whole bodies. Where a node "
             "begins to stick, it also includes the share of the patch that "
             "one element has. Added damping is a damping ratio of all modes "
             "of the bodies, each at its own frequency.\n";
    }

    void write_thresholds(const std::vector<DrivingThreshold> &thresholds,
                          RunFolder                           &folder)
    {
      ResultsTable table(folder, "thresholds.csv");
      for (const DrivingThreshold &it : thresholds)
        {
          table.set("quantity", it.quantity);
          table.set("now", it.now);
          table.set("found", it.found);
          table.set("followed_to", it.to);
          table.set_if(it.found, "threshold", it.value);
          table.set_if(it.found, "uncertainty", it.uncertainty);
          table.set_if(it.found, "stable_from", it.stable);
          table.set_if(it.found && it.share > 0., "share", it.share);
          table.set_if(it.found, "n_sticking", it.n_sticking);
          table.set_if(it.found, "frequency_Hz", it.frequency);
          table.set_if(it.found, "mode_name", it.mode);
          table.end_row();
        }
      table.flush();
    }
  } // namespace

  std::string verdict(const Situation            &scene,
                      const std::vector<Finding> &findings,
                      const std::string          &counted)
  {
    const Finding *fastest = nullptr;
    std::size_t    n       = 0;
    for (const Finding &finding : findings)
      if (finding.unstable())
        {
          ++n;
          if (fastest == nullptr || finding.growth() > fastest->growth())
            fastest = &finding;
        }
    if (fastest == nullptr)
      return "no vibration grows between " +
             significant(scene.inputs->stability.lowest_frequency, 4) +
             " and " + significant(scene.inputs->modes.maximum_frequency, 5) +
             " Hz" + counted;
    return std::to_string(n) + (n == 1 ? " mode grows" : " modes grow") +
           counted + "; the fastest at " +
           significant(fastest->mode.frequency(), 5) + " Hz by " +
           significant(fastest->growth(), 3) + " 1/s" +
           (fastest->corrected
              ? ", needs a damping ratio of " +
                  significant(fastest->corrected->damping_needed, 2) + " more"
              : "");
  }

  std::string text_of(const std::vector<DrivingThreshold> &thresholds)
  {
    std::string text;
    for (const DrivingThreshold &threshold : turning(thresholds))
      text += (!text.empty()          ? "; or "
               : !threshold.squeals   ? "begins at "
               : threshold.share > 0. ? "least change: "
                                      : "") +
              text_of(threshold);
    const std::string same   = rest_of(thresholds, false),
                      beyond = rest_of(thresholds, true);
    if (!same.empty())
      text += (text.empty() ? "" : "; ") + std::string("not by ") + same;
    if (!beyond.empty())
      text += (text.empty() ? "" : "; ") +
              std::string("not followed on these bodies: ") + beyond;
    return text;
  }

  void tell_verdict(const Situation                     &scene,
                    const std::vector<Finding>          &findings,
                    const std::vector<std::string>      &names,
                    const std::string                   &counted,
                    const std::vector<DrivingThreshold> &thresholds,
                    RunContext                          &context)
  {
    const bool squeals =
      std::any_of(findings.begin(), findings.end(), [](const Finding &it) {
        return it.unstable();
      });
    std::string text =
      "# " + std::string(squeals ? "It squeals" : "It does not squeal") +
      "\n\n" + verdict(scene, findings, counted) + ".\n";
    text[text.find("\n\n") + 2] = std::toupper(text[text.find("\n\n") + 2]);
    if (squeals)
      text += "\n" + table_of_modes(findings, names) +
              "\n+- is the last change by the equations of the whole bodies. "
              "The errors of mesh and damping come in addition.\n";
    if (!thresholds.empty())
      {
        write_thresholds(thresholds, context.folder);
        std::string words = text_of(thresholds);
        context.report.set_finding(squeals ? "cures" : "onset", words);
        words[0] = std::toupper(words[0]);
        text += "\n## " +
                std::string(squeals ? "What stops it" : "What would start it") +
                "\n\n" + words + ".\n" + table_of_thresholds(thresholds);
      }
    context.folder.write_atomically("verdict.md", text);
  }
} // namespace RollingContact
