#include <rolling_contact/base/platform.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/parallel/ranks.h>
#include <rolling_contact/run/results_table.h>

#include <algorithm>
#include <exception>

namespace RollingContact
{
  namespace
  {
    /** A cell as text, its numbers with the given significant digits. */
    struct CellText
    {
      const unsigned int digits;

      std::string
      operator()(const bool value) const
      {
        return value ? "true" : "false";
      }

      std::string
      operator()(const std::int64_t value) const
      {
        return std::to_string(value);
      }

      std::string
      operator()(const double value) const
      {
        return significant(value, digits);
      }

      std::string
      operator()(const std::string &value) const
      {
        return value;
      }
    };



    std::string
    csv_field(const std::string &text)
    {
      if (text.find_first_of(",\"\r\n") == std::string::npos)
        return text;
      std::string result = "\"";
      for (const char character : text)
        result += character == '"' ? "\"\"" : std::string(1, character);
      return result + '"';
    }
  } // namespace



  ResultsTable::ResultsTable(RunFolder &folder, const std::string &file_name)
    : folder(folder)
    , file_name(file_name)
    , n_written_rows(0)
  {}



  ResultsTable::~ResultsTable()
  {
    try
      {
        flush();
      }
    catch (const std::exception &)
      {
        // The rows of the last successful write stay.
      }
  }



  void
  ResultsTable::set_cell(const std::string &column, const Cell &cell)
  {
    leave_empty(column);
    current_row[column] = cell;
  }



  void
  ResultsTable::leave_empty(const std::string &column)
  {
    if (std::find(column_names.begin(), column_names.end(), column) ==
        column_names.end())
      column_names.push_back(column);
  }



  void
  ResultsTable::end_row()
  {
    rows.push_back(std::move(current_row));
    current_row.clear();

    const auto since_last_write = std::chrono::steady_clock::now() - last_write;
    if (rows.size() <= 1000 || since_last_write > std::chrono::seconds(1))
      flush();
  }



  void
  ResultsTable::flush()
  {
    if (n_written_rows == rows.size() || !Ranks::is_root())
      return;
    folder.write_atomically(file_name, csv());
    n_written_rows = rows.size();
    last_write     = std::chrono::steady_clock::now();
  }



  std::size_t
  ResultsTable::n_rows() const
  {
    return rows.size();
  }



  std::string
  ResultsTable::csv() const
  {
    std::string text;
    for (const std::string &column : column_names)
      text += csv_field(column) + ',';
    if (!text.empty())
      text.back() = '\n';

    for (const Row &row : rows)
      {
        for (const std::string &column : column_names)
          {
            const auto cell = row.find(column);
            if (cell != row.end())
              text += csv_field(std::visit(CellText{9}, cell->second));
            text += ',';
          }
        text.back() = '\n';
      }
    return text;
  }



  std::string
  ResultsTable::screen_table(const std::vector<std::string> &columns) const
  {
    std::vector<std::string> lines(rows.size() + 1);
    for (const std::string &column : columns)
      {
        if (std::find(column_names.begin(), column_names.end(), column) ==
            column_names.end())
          continue;

        std::vector<std::string> texts{column};
        for (const Row &row : rows)
          {
            const auto cell = row.find(column);
            texts.push_back(
              cell == row.end() ? "-" : std::visit(CellText{4}, cell->second));
          }

        std::size_t width = 0;
        for (const std::string &text : texts)
          width = std::max(width, n_characters(text));
        const std::size_t gap = lines[0].empty() ? 0 : 2;
        if (n_characters(lines[0]) + gap + width > screen_width())
          break;
        for (std::size_t i = 0; i < lines.size(); ++i)
          lines[i] +=
            (lines[i].empty() ? "" : "  ") + right_aligned(texts[i], width);
      }

    std::string table;
    for (const std::string &line : lines)
      table += line + '\n';
    return table;
  }
} // namespace RollingContact
