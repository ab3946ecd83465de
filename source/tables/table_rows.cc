#include <fmt/format.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/files.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/results/result_row.h>
#include <rolling_contact/tables/table_rows.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace RollingContact
{
  namespace
  {
    const std::array<const char *, 5> status_names{{"solved",
                                                    "no contact",
                                                    "broken invariant",
                                                    "not converged",
                                                    "outside of the zone"}};

    TableStatus status_named(const std::string &name, const std::size_t row)
    {
      for (std::size_t k = 0; k < status_names.size(); ++k)
        if (name == status_names[k])
          return static_cast<TableStatus>(k);
      throw InputError("results.csv, row " + std::to_string(row + 1) +
                       ": column status has \"" + name +
                       "\", which is none. Start the run without --resume.");
    }

    /** How the texts in the file of a table are read. */
    ResultsTable::Readers readers_of(const TablePlan &plan)
    {
      ResultsTable::Readers readers{
        {"status", &status_named},
        {"fastest_mode",
         [](const std::string &name, std::size_t) { return name; }},
        {"vibrations", &vibrations_of},
        {"solver",
         [](const std::string &name, std::size_t) { return solved_by(name); }}};
      for (const std::string &entry : plan.entries)
        readers[entry] = [](const std::string &text, std::size_t) {
          return number_of(text).value_or(std::nan(""));
        };
      return readers;
    }
  } // namespace

  std::string name_of(const TableStatus status)
  {
    return status_names[static_cast<std::size_t>(status)];
  }

  std::string text_of(const std::vector<ListedVibration> &vibrations)
  {
    std::string text;
    for (const ListedVibration &vibration : vibrations)
      text += fmt::format("{}{:.7g}:{:.6g}",
                          text.empty() ? "" : " ",
                          vibration.frequency,
                          vibration.growth);
    return text;
  }

  std::vector<ListedVibration> vibrations_of(const std::string &text,
                                             const std::size_t  row)
  {
    std::vector<ListedVibration> vibrations;
    std::istringstream           words(text);
    std::string                  word;
    while (words >> word)
      {
        ListedVibration    vibration;
        std::istringstream pair(word);
        char               colon = ' ';
        if (!(pair >> vibration.frequency >> colon >> vibration.growth) ||
            colon != ':')
          throw InputError("results.csv, row " + std::to_string(row + 1) +
                           ": column vibrations has \"" + word +
                           "\", which is no frequency:growth.");
        vibrations.push_back(vibration);
      }
    return vibrations;
  }

  void begin_table_row(const TablePlan  &plan,
                       const std::size_t state,
                       const TableStatus status,
                       ResultsTable     &rows)
  {
    rows.set("state", state);
    for (const auto &[column, texts] : plan.titles)
      rows.set(column, texts[state]);
    for (std::size_t d = 0; d < plan.entries.size(); ++d)
      rows.set(plan.entries[d],
               exact_text(plan.values[state][d]),
               plan.values[state][d]);
    rows.set("status", name_of(status), status);
  }

  void add_unsolved_row(const TablePlan  &plan,
                        const std::size_t state,
                        const TableStatus status,
                        ResultsTable     &rows)
  {
    begin_table_row(plan, state, status, rows);
    rows.set("converged", false);
    rows.end_row();
  }

  std::size_t state_of_row(const ResultsTable &results, const std::size_t row)
  {
    return static_cast<std::size_t>(results.number(row, "state").value());
  }

  TableStatus status_of_row(const ResultsTable &results, const std::size_t row)
  {
    return *results.value<TableStatus>(row, "status");
  }

  void restore_rows(const TablePlan &plan, RunContext &context)
  {
    ResultsTable     &results = context.results;
    const std::string file =
      (context.folder.get_path() / "results.csv").string();
    results.restore(read_bytes(file), file, readers_of(plan));
    std::vector<bool> has_row(plan.values.size(), false);
    for (std::size_t row = 0; row < results.n_rows(); ++row)
      {
        const double number = results.number(row, "state").value_or(-1.);
        const auto   state  = static_cast<std::size_t>(std::max(number, 0.));
        bool         same   = number == static_cast<double>(state) &&
                    state < has_row.size() && !has_row[state] &&
                    results.value<TableStatus>(row, "status");
        for (std::size_t d = 0; same && d < plan.entries.size(); ++d)
          {
            const auto *value = results.value<double>(row, plan.entries[d]);
            same              = value && *value == plan.values[state][d];
          }
        if (!same)
          throw InputError(
            "Cannot resume the table in \"" +
            context.folder.get_path().string() + "\": row " +
            std::to_string(row + 1) +
            " of results.csv is none of its states; was a file changed? Start "
            "it without --resume.");
        has_row[state] = true;
      }
  }
} // namespace RollingContact
