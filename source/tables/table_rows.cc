#include <fmt/format.h>
#include <glob.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/files.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/input/prm_entries.h>
#include <rolling_contact/results/result_row.h>
#include <rolling_contact/run/written_names.h>
#include <rolling_contact/tables/table_rows.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
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
                       "\", which is no status of a state. Start the run "
                       "without --resume.");
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

  namespace
  {
    /** Whether a row is of a state of the plan. */
    bool is_state_of(const TablePlan    &plan,
                     const ResultsTable &results,
                     const std::size_t   row)
    {
      const double number = results.number(row, "state").value_or(-1.);
      const auto   state  = static_cast<std::size_t>(std::max(number, 0.));
      bool         same   = number == static_cast<double>(state) &&
                  state < plan.values.size() &&
                  results.value<TableStatus>(row, "status");
      for (std::size_t d = 0; same && d < plan.entries.size(); ++d)
        {
          const auto *value = results.value<double>(row, plan.entries[d]);
          same              = value && *value == plan.values[state][d];
        }
      return same;
    }

    /**
     * Read the rows of a file, and note their states. Returns the first row,
     * from 1, that is none of the plan or of a state that has one already; 0 if
     * all are good.
     */
    std::size_t read_rows(const TablePlan   &plan,
                          const std::string &file,
                          ResultsTable      &results,
                          std::vector<bool> &has_row)
    {
      results.restore(read_bytes(file), file, readers_of(plan));
      for (std::size_t row = 0; row < results.n_rows(); ++row)
        {
          if (!is_state_of(plan, results, row) ||
              has_row[state_of_row(results, row)])
            return row + 1;
          has_row[state_of_row(results, row)] = true;
        }
      return 0;
    }

    /** The folders that match, in the order of their names. */
    std::vector<std::string> folders_of(const std::string &patterns)
    {
      std::vector<std::string> folders;
      std::istringstream       all(patterns);
      for (std::string pattern; std::getline(all, pattern, ',');)
        {
          glob_t    found{};
          const int code =
            glob(trimmed(pattern).c_str(), GLOB_ERR, nullptr, &found);
          for (std::size_t k = 0; code == 0 && k < found.gl_pathc; ++k)
            folders.push_back(found.gl_pathv[k]);
          globfree(&found);
          if (code != 0)
            throw InputError("Table/Join = " + patterns +
                             ": there is no folder " + trimmed(pattern) +
                             "; give those of the runs of all parts.");
        }
      return folders;
    }

    void check_part(const std::string           &folder,
                    const PrmEntries            &own,
                    const std::set<std::string> &may_differ)
    {
      const auto refuse = [&](const std::string &why) {
        throw InputError("Table/Join: \"" + folder + "\" " + why);
      };
      if (const std::string why = why_unreadable(folder + "/used.prm");
          !why.empty())
        refuse("is no folder of a part: used.prm: " + why + '.');
      if (const auto entry = changed_entry(
            prm_entries(read_bytes(folder + "/used.prm")), own, may_differ))
        refuse("is of another scene: " + *entry +
               " differs from that of this one.");
    }

    [[noreturn]] void refuse_to_resume(const RunContext  &context,
                                       const std::string &file,
                                       const std::size_t  row)
    {
      throw InputError("Cannot resume the table in \"" +
                       context.folder.get_path().string() + "\": row " +
                       std::to_string(row) + " of " + file +
                       " is not one of its states; was a file changed? Start "
                       "it without --resume.");
    }
  } // namespace

  void restore_rows(const TablePlan &plan, RunContext &context)
  {
    std::vector<bool>           has_row(plan.values.size(), false);
    const std::string           name = "results.csv";
    const std::filesystem::path file = context.folder.get_path() / name;
    // of a run on several ranks the others may have rows before the root has
    if (std::filesystem::is_regular_file(file))
      if (const std::size_t row =
            read_rows(plan, file.string(), context.results, has_row))
        refuse_to_resume(context, name, row);
    std::vector<std::size_t> numbers;
    add_rows_of_ranks(plan, context, numbers);
  }

  void add_rows_of_ranks(const TablePlan          &plan,
                         RunContext               &context,
                         std::vector<std::size_t> &numbers)
  {
    const std::string name  = "results.csv";
    const auto        files = files_of_ranks(context.folder.get_path(), name);
    if (files.empty())
      return;
    std::vector<bool> has_row(plan.values.size(), false);
    for (std::size_t row = 0; row < context.results.n_rows(); ++row)
      has_row[state_of_row(context.results, row)] = true;
    for (const std::string &file : files)
      {
        const std::string path = (context.folder.get_path() / file).string();
        ResultsTable      of_rank, news;
        of_rank.restore(read_bytes(path), path, readers_of(plan));
        for (std::size_t row = 0; row < of_rank.n_rows(); ++row)
          {
            if (!is_state_of(plan, of_rank, row))
              refuse_to_resume(context, file, row + 1);
            const std::size_t state = state_of_row(of_rank, row);
            if (has_row[state])
              continue;
            has_row[state] = true;
            news.take_row(of_rank, row);
            news.end_row();
          }
        numbers.push_back(of_rank.n_rows());
        context.results.append(news);
      }
    context.results.flush();
    context.folder.remove_files_of_ranks(name);
  }

  void join_rows(const TablePlan      &plan,
                 const std::string    &folders,
                 std::set<std::string> may_differ,
                 RunContext           &context)
  {
    may_differ.insert({"Table/Part", "Table/Join"});
    std::vector<bool> has_row(plan.values.size(), false);
    const PrmEntries  own =
      prm_entries(read_bytes(context.folder.get_path() / "used.prm"));
    for (const std::string &folder : folders_of(folders))
      {
        check_part(folder, own, may_differ);
        // a part of a small table may have no chain of states
        if (!why_unreadable(folder + "/results.csv").empty())
          continue;
        ResultsTable rows;
        if (const std::size_t row =
              read_rows(plan, folder + "/results.csv", rows, has_row))
          throw InputError("Table/Join: row " + std::to_string(row) + " of \"" +
                           folder +
                           "/results.csv\" is no state of this table, or one "
                           "that another folder has: give each part once.");
        context.results.append(rows);
      }
    const auto missing = std::count(has_row.begin(), has_row.end(), false);
    if (missing == 0)
      return;
    const std::size_t first =
      std::find(has_row.begin(), has_row.end(), false) - has_row.begin();
    throw InputError("Table/Join = " + folders + ": " +
                     std::to_string(missing) + " of " +
                     std::to_string(has_row.size()) +
                     " states have no row, the first " + plan.name(first) +
                     ": a part is missing or was stopped; run it, with "
                     "--resume where it was begun.");
  }
} // namespace RollingContact
