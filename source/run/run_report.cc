#include <rolling_contact/base/memory.h>
#include <rolling_contact/base/percentages.h>
#include <rolling_contact/base/platform.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/parallel/ranks.h>
#include <rolling_contact/run/run_report.h>

#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <stdexcept>

namespace RollingContact
{
  namespace
  {
    /** Members of a JSON object: keys, and values already in JSON. */
    using JsonMembers = std::vector<std::pair<std::string, std::string>>;

    std::string
    json_string(const std::string &text)
    {
      std::string result = "\"";
      for (const char character : valid_utf8(text))
        {
          const auto byte = static_cast<unsigned char>(character);
          if (character == '"' || character == '\\')
            result += std::string("\\") + character;
          else if (character == '\n')
            result += "\\n";
          else if (byte < 0x20 || byte == 0x7F)
            {
              char code[8];
              std::snprintf(code, sizeof(code), "\\u%04x", byte);
              result += code;
            }
          else
            result += character;
        }
      return result + '"';
    }



    std::string
    json_number(const double value)
    {
      return std::isfinite(value) ? significant(value, 9) : "null";
    }



    std::string
    json_bool(const bool value)
    {
      return value ? "true" : "false";
    }



    /** Members in one line. */
    std::string
    json_object(const JsonMembers &members)
    {
      std::string text;
      for (const auto &[key, value] : members)
        text += (text.empty() ? "" : ", ") + json_string(key) + ": " + value;
      return '{' + text + '}';
    }



    /** One value per line, within an object that is itself indented by 2. */
    std::string
    json_array(const std::vector<std::string> &values)
    {
      std::string text;
      for (const std::string &value : values)
        text += (text.empty() ? "\n    " : ",\n    ") + value;
      return text.empty() ? "[]" : '[' + text + "\n  ]";
    }



    std::string
    json_strings(const std::vector<std::string> &texts)
    {
      std::vector<std::string> values;
      for (const std::string &text : texts)
        values.push_back(json_string(text));
      return json_array(values);
    }



    std::string
    json_libraries(
      const std::vector<std::pair<std::string, std::string>> &libraries)
    {
      std::vector<std::string> values;
      for (const auto &[name, version] : libraries)
        values.push_back(json_object(
          {{"name", json_string(name)}, {"version", json_string(version)}}));
      return json_array(values);
    }



    std::vector<int>
    cpu_percentages(const std::vector<PhaseTimer::Row> &phases)
    {
      std::vector<double> seconds;
      for (const PhaseTimer::Row &phase : phases)
        seconds.push_back(phase.cpu_seconds);
      return percentages(seconds);
    }



    std::string
    json_phases(const std::vector<PhaseTimer::Row> &phases)
    {
      const std::vector<int>   percent = cpu_percentages(phases);
      std::vector<std::string> values;
      for (std::size_t k = 0; k < phases.size(); ++k)
        values.push_back(
          json_object({{"phase", json_string(name_of(phases[k].phase))},
                       {"calls", std::to_string(phases[k].n_calls)},
                       {"wall_seconds", json_number(phases[k].wall_seconds)},
                       {"cpu_seconds", json_number(phases[k].cpu_seconds)},
                       {"cpu_percent", std::to_string(percent[k])}}));
      return json_array(values);
    }



    std::string
    json_errors(const std::vector<ErrorStatement> &errors)
    {
      std::vector<std::string> values;
      for (const ErrorStatement &error : errors)
        values.push_back(
          json_object({{"quantity", json_string(error.quantity)},
                       {"value", json_number(error.value)},
                       {"scale", json_string(error.scale)},
                       {"reference", json_string(error.reference)},
                       {"estimated", json_bool(error.estimated)},
                       {"remark", json_string(error.remark)}}));
      return json_array(values);
    }



    std::string
    json_objects(const std::vector<BuiltItem> &objects)
    {
      std::vector<std::string> values;
      for (const BuiltItem &object : objects)
        values.push_back(json_object({{"object", json_string(object.object)},
                                      {"built", json_bool(object.built)},
                                      {"bytes", std::to_string(object.bytes)},
                                      {"seconds", json_number(object.seconds)},
                                      {"reason", json_string(object.reason)}}));
      return json_array(values);
    }



    std::string
    json_totals(const RankTotals &totals)
    {
      const auto bytes = [](const double value) {
        return std::to_string(static_cast<std::uint64_t>(value));
      };
      return json_object(
        {{"cpu_seconds", json_number(totals.cpu_seconds)},
         {"largest_cpu_seconds", json_number(totals.largest_cpu_seconds)},
         {"peak_memory_bytes", bytes(totals.peak_memory)},
         {"largest_peak_memory_bytes", bytes(totals.largest_peak_memory)}});
    }



    std::string
    status_name(const RunStatus status)
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



    std::string
    summary_line(const BuiltItem &object)
    {
      std::string line = "  " + object.object;
      if (object.built && (object.bytes > 0 || object.seconds != 0.))
        {
          line += ": " + human_bytes(static_cast<double>(object.bytes));
          line += ", " + human_seconds(object.seconds);
        }
      if (!object.reason.empty())
        line += " (" + object.reason + ')';
      return line + '\n';
    }
  } // namespace



  RankTotals
  totals_of_ranks(const PhaseTimer &timer)
  {
    const double cpu    = PhaseTimer::total(timer.rows()).cpu_seconds;
    const double memory = static_cast<double>(peak_memory());
    return {Ranks::sum(cpu),
            Ranks::maximum(cpu),
            Ranks::sum(memory),
            Ranks::maximum(memory)};
  }



  void
  RunReport::write(RunFolder        &folder,
                   const RunStatus   status,
                   const PhaseTimer &timer) const
  {
    const std::vector<PhaseTimer::Row> phases = timer.rows();
    const PhaseTimer::Row              total  = PhaseTimer::total(phases);

    JsonMembers members{{"version", json_string(version)},
                        {"git_revision", json_string(git_revision)},
                        {"status", json_string(status_name(status))},
                        {"command_line", json_strings(command_line)},
                        {"libraries", json_libraries(libraries)},
                        {"host_cpus", std::to_string(n_host_cpus())},
                        {"threads", std::to_string(n_threads)},
                        {"ranks", std::to_string(n_ranks)},
                        {"wall_seconds", json_number(total.wall_seconds)},
                        {"cpu_seconds", json_number(total.cpu_seconds)},
                        {"phases", json_phases(phases)},
                        {"peak_memory_bytes", std::to_string(peak_memory())},
                        {"objects", json_objects(objects)},
                        {"errors", json_errors(errors)},
                        {"warnings", json_strings(warnings)}};
    if (rank_totals)
      members.emplace_back("all_ranks", json_totals(*rank_totals));

    std::string text;
    for (const auto &[key, value] : members)
      text += (text.empty() ? "" : ",\n  ") + json_string(key) + ": " + value;
    folder.write_record(text);
  }



  std::string
  RunReport::objects_summary() const
  {
    std::string built, left_out;
    for (const BuiltItem &object : objects)
      (object.built ? built : left_out) += summary_line(object);
    return (built.empty() ? "" : "Built:\n" + built) +
           (left_out.empty() ? "" : "Left out:\n" + left_out);
  }



  std::string
  ErrorStatement::text() const
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



  void
  RunReport::set_finding(const std::string &label, const std::string &text)
  {
    for (auto &finding : findings)
      if (finding.first == label)
        {
          finding.second = text;
          return;
        }
    findings.emplace_back(label, text);
  }



  std::string
  RunReport::all_errors() const
  {
    std::string text;
    for (const ErrorStatement &error : errors)
      text += (text.empty() ? "" : ", ") + error.text();
    return errors.empty() ? "no contact, no error" : text;
  }



  std::string
  RunReport::cost(const PhaseTimer &timer) const
  {
    const std::vector<PhaseTimer::Row> phases  = timer.rows();
    const std::vector<int>             percent = cpu_percentages(phases);
    const PhaseTimer::Row              total   = PhaseTimer::total(phases);

    std::string text = human_seconds(total.wall_seconds);
    if (rank_totals)
      text += " on " + std::to_string(n_ranks) + " ranks, " +
              human_bytes(rank_totals->peak_memory) + " (at most " +
              human_bytes(rank_totals->largest_peak_memory) + " of one), " +
              human_seconds(rank_totals->cpu_seconds) + " CPU (at most " +
              human_seconds(rank_totals->largest_cpu_seconds) +
              " of one); of rank 0 ";
    else
      text += ", " + human_bytes(static_cast<double>(peak_memory())) + "; ";
    text += human_seconds(total.cpu_seconds) + " CPU: ";
    for (std::size_t k = 0; k < phases.size(); ++k)
      text += (k == 0 ? "" : ", ") + name_of(phases[k].phase) + ' ' +
              std::to_string(percent[k]) + " %";
    return text;
  }



  std::string
  RunReport::summary(const PhaseTimer &timer, const std::string &folder) const
  {
    auto lines = findings;
    lines.emplace_back("error", all_errors());
    lines.emplace_back("time", cost(timer));
    lines.emplace_back("files", folder);
    const std::size_t width = 7;
    std::string       text;
    for (const auto &[label, line] : lines)
      {
        std::istringstream parts(wrapped(line, 80 - width, 0));
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
