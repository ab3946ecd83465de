#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <rolling_contact/base/memory.h>
#include <rolling_contact/base/percentages.h>
#include <rolling_contact/base/platform.h>
#include <rolling_contact/base/ranks.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/run/run_report.h>

#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace RollingContact
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    /** With 9 significant digits; null if it is not finite. */
    Json json_number(const double value)
    {
      return std::isfinite(value) ? Json::parse(significant(value, 9)) : Json();
    }

    Json json_libraries(
      const std::vector<std::pair<std::string, std::string>> &libraries)
    {
      Json values = Json::array();
      for (const auto &[name, version] : libraries)
        values.push_back({{"name", name}, {"version", version}});
      return values;
    }

    std::vector<int> cpu_percentages(const std::vector<PhaseTimer::Row> &phases)
    {
      std::vector<double> seconds;
      for (const PhaseTimer::Row &phase : phases)
        seconds.push_back(phase.cpu_seconds);
      return percentages(seconds);
    }

    Json json_phases(const std::vector<PhaseTimer::Row> &phases)
    {
      const std::vector<int> percent = cpu_percentages(phases);
      Json                   values  = Json::array();
      for (std::size_t k = 0; k < phases.size(); ++k)
        values.push_back({{"phase", name_of(phases[k].phase)},
                          {"calls", phases[k].n_calls},
                          {"wall_seconds", json_number(phases[k].wall_seconds)},
                          {"cpu_seconds", json_number(phases[k].cpu_seconds)},
                          {"cpu_percent", percent[k]}});
      return values;
    }

    Json json_errors(const std::vector<ErrorStatement> &errors)
    {
      Json values = Json::array();
      for (const ErrorStatement &error : errors)
        {
          values.push_back({{"quantity", error.quantity},
                            {"value", json_number(error.value)},
                            {"scale", error.scale},
                            {"reference", error.reference},
                            {"estimated", error.estimated},
                            {"remark", error.remark}});
          if (error.time_step)
            values.back()["time_step"] = json_number(*error.time_step);
        }
      return values;
    }

    Json json_objects(const std::vector<BuiltItem> &objects)
    {
      Json values = Json::array();
      for (const BuiltItem &object : objects)
        values.push_back({{"object", object.object},
                          {"built", object.built},
                          {"bytes", object.bytes},
                          {"seconds", json_number(object.seconds)},
                          {"reason", object.reason}});
      return values;
    }

    Json json_totals(const RankTotals &totals)
    {
      return {{"cpu_seconds", json_number(totals.cpu_seconds)},
              {"largest_cpu_seconds", json_number(totals.largest_cpu_seconds)},
              {"peak_memory_bytes",
               static_cast<std::uint64_t>(totals.peak_memory)},
              {"largest_peak_memory_bytes",
               static_cast<std::uint64_t>(totals.largest_peak_memory)}};
    }

    std::string status_name(const RunStatus status)
    {
      switch (status)
        {
          case RunStatus::running:
            return "running";
          case RunStatus::done:
            return "done";
          case RunStatus::not_converged:
            return "not converged";
          case RunStatus::failed:
            return "failed";
          case RunStatus::interrupted:
            return "interrupted";
        }
      throw std::logic_error("Unknown status of a run.");
    }

    std::string summary_line(const BuiltItem &object)
    {
      std::string line = "  " + object.object;
      if (object.built && (object.bytes > 0 || object.seconds != 0.))
        line += fmt::format(": {}, {}",
                            human_bytes(static_cast<double>(object.bytes)),
                            human_seconds(object.seconds));
      if (!object.reason.empty())
        line += " (" + object.reason + ')';
      return line + '\n';
    }
  } // namespace

  RankTotals totals_of_ranks(const PhaseTimer &timer)
  {
    const double cpu    = PhaseTimer::total(timer.rows()).cpu_seconds;
    const double memory = static_cast<double>(peak_memory());
    return {Ranks::sum(cpu),
            Ranks::maximum(cpu),
            Ranks::sum(memory),
            Ranks::maximum(memory)};
  }

  std::string RunReport::members(const RunStatus   status,
                                 const PhaseTimer &timer) const
  {
    const std::vector<PhaseTimer::Row> phases = timer.rows();
    const PhaseTimer::Row              total  = PhaseTimer::total(phases);

    Json record{{"version", version},
                {"git_revision", git_revision},
                {"status", status_name(status)},
                {"failure", failure},
                {"command_line", command_line},
                {"libraries", json_libraries(libraries)},
                {"host_cpus", n_host_cpus()},
                {"threads", n_threads},
                {"ranks", n_ranks},
                {"wall_seconds", json_number(total.wall_seconds)},
                {"cpu_seconds", json_number(total.cpu_seconds)},
                {"phases", json_phases(phases)},
                {"peak_memory_bytes", peak_memory()},
                {"objects", json_objects(objects)},
                {"errors", json_errors(errors)},
                {"warnings", warnings}};
    if (rank_totals)
      record["all_ranks"] = json_totals(*rank_totals);
    const std::string object =
      record.dump(-1, ' ', false, Json::error_handler_t::replace);
    return object.substr(1, object.size() - 2); // no braces
  }

  void RunReport::write(RunFolder        &folder,
                        const RunStatus   status,
                        const PhaseTimer &timer) const
  {
    const bool over = status != RunStatus::running;
    folder.write_record(members(status, timer),
                        over ? "" : members(RunStatus::interrupted, timer));
  }

  std::string RunReport::objects_summary() const
  {
    std::string built, left_out;
    for (const BuiltItem &object : objects)
      (object.built ? built : left_out) += summary_line(object);
    return (built.empty() ? "" : "Built:\n" + built) +
           (left_out.empty() ? "" : "Left out:\n" + left_out);
  }

  std::string ErrorStatement::text() const
  {
    if (std::isnan(value))
      return quantity + " not estimated (" + reference + ")";
    const std::string size = quantity + ' ' + scientific(value, 2) + " of " +
                             scale + (estimated ? "" : " against " + reference);
    if (estimated)
      return size + " (estimate: " + reference +
             (remark.empty() ? "" : "; " + remark) + ')';
    return size + (remark.empty() ? "" : " (" + remark + ')');
  }

  void RunReport::set_finding(const std::string &label, const std::string &text)
  {
    for (auto &finding : findings)
      if (finding.first == label)
        {
          finding.second = text;
          return;
        }
    findings.emplace_back(label, text);
  }

  std::string RunReport::all_errors() const
  {
    std::string text;
    for (const ErrorStatement &error : errors)
      text += (text.empty() ? "" : ", ") + error.text();
    return errors.empty() ? "no contact, no error" : text;
  }

  std::string RunReport::cost(const PhaseTimer &timer) const
  {
    const PhaseTimer::Row total = PhaseTimer::total(timer.rows());
    if (rank_totals)
      return fmt::format("{} on {} ranks, {} of CPU (at most {} of one), "
                         "{} of memory (at most {} of one)",
                         human_seconds(total.wall_seconds),
                         n_ranks,
                         human_seconds(rank_totals->cpu_seconds),
                         human_seconds(rank_totals->largest_cpu_seconds),
                         human_bytes(rank_totals->peak_memory),
                         human_bytes(rank_totals->largest_peak_memory));
    return fmt::format("{}, {} of CPU, {} of memory",
                       human_seconds(total.wall_seconds),
                       human_seconds(total.cpu_seconds),
                       human_bytes(static_cast<double>(peak_memory())));
  }

  std::string RunReport::summary(const PhaseTimer  &timer,
                                 const std::string &folder) const
  {
    auto lines = findings;
    lines.emplace_back("error", all_errors());
    lines.emplace_back("time", cost(timer));
    lines.emplace_back("files", folder);
    const std::size_t width = 7;
    std::string       text;
    for (const auto &[label, line] : lines)
      {
        std::istringstream parts(wrapped(line, screen_width() - width, 0));
        std::string        start = left_aligned(label, width);
        for (std::string part; std::getline(parts, part);)
          {
            text += start + part + '\n';
            start = std::string(width, ' ');
          }
      }
    text.pop_back();
    return text;
  }
} // namespace RollingContact
