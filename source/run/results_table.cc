#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/platform.h>
#include <rolling_contact/base/ranks.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/run/results_table.h>
#include <rolling_contact/run/written_names.h>

#include <algorithm>
#include <cmath>
#include <exception>

namespace RollingContact
{
  namespace
  {
    /** A cell as text, its numbers with the given significant digits. */
    struct CellText
    {
      const unsigned int digits;

      std::string operator()(std::monostate) const
      {
        return "";
      }

      std::string operator()(const bool value) const
      {
        return value ? "true" : "false";
      }

      std::string operator()(const std::int64_t value) const
      {
        return std::to_string(value);
      }

      std::string operator()(const double value) const
      {
        return std::isnan(value) ? "" : significant(value, digits);
      }

      std::string operator()(const std::string &value) const
      {
        return value;
      }

      std::string
      operator()(const std::shared_ptr<const ResultsTable::Named> &cell) const
      {
        return cell->text;
      }
    };

    /** A cell as a number. */
    struct CellNumber
    {
      template <typename Value>
      std::optional<double> operator()(const Value &value) const
      {
        if constexpr (std::is_arithmetic_v<Value>)
          return static_cast<double>(value);
        else
          return {};
      }
    };

    std::string csv_field(const std::string &plain)
    {
      const std::string text = no_formula(plain);
      if (text.find_first_of(",\"\r\n") == std::string::npos)
        return text;
      std::string result = "\"";
      for (const char character : text)
        result += character == '"' ? "\"\"" : std::string(1, character);
      return result + '"';
    }
  } // namespace

  namespace
  {
    /**
     * The fields of the line of a CSV file that begins at @p begin, which moves
     * to the next one.
     */
    std::vector<std::string> next_fields(const std::string &text,
                                         std::size_t       &begin)
    {
      std::vector<std::string> fields{""};
      bool                     quoted = false;
      for (; begin < text.size(); ++begin)
        {
          const char character = text[begin];
          if (character == '"')
            {
              const bool doubled =
                quoted && begin + 1 < text.size() && text[begin + 1] == '"';
              if (doubled)
                fields.back() += text[++begin];
              else
                quoted = !quoted;
            }
          else if (quoted || (character != ',' && character != '\n'))
            fields.back() += character;
          else if (character == ',')
            fields.emplace_back();
          else
            {
              ++begin;
              break;
            }
        }
      return fields;
    }
  } // namespace

  std::string unit_of_column(const std::string &column)
  {
    const std::string units =
      " m m2 m/N N Nm Pa N/m J J/m J/m2 1/m rad s m/s 1/s Hz K ";
    const std::string end = column.substr(column.rfind('_') + 1);
    if (units.find(' ' + end + ' ') != std::string::npos)
      return end;
    const std::size_t slash = column.rfind("/muN");
    return slash == std::string::npos       ? "1"
           : column.substr(slash) == "/muN" ? "mu N"
                                            : "mu N a";
  }

  ResultsTable::ResultsTable(RunFolder &folder)
    : folder(&folder)
    , row_by_row(true)
    , file_name("results.csv")
  {}

  ResultsTable::ResultsTable(RunFolder &folder, const std::string &file_name)
    : folder(&folder)
    , file_name(file_name)
  {}

  ResultsTable::ResultsTable(RunFolder         &folder,
                             const std::string &file_name,
                             const bool         is_of_rank)
    : folder(&folder)
    , row_by_row(true)
    , is_of_rank(is_of_rank)
    , file_name(file_name)
  {}

  ResultsTable ResultsTable::of_rank(RunFolder &folder, const unsigned int rank)
  {
    return ResultsTable(folder, rank_file_name("results.csv", rank), true);
  }

  ResultsTable::~ResultsTable()
  {
    try
      {
        if (row_by_row)
          flush();
      }
    catch (const std::exception &)
      {
        // The rows of the last successful write stay.
      }
  }

  std::size_t ResultsTable::index_of(const std::string &column)
  {
    const auto [place, is_new] =
      column_numbers.emplace(column, column_names.size());
    if (is_new)
      column_names.push_back(column);
    return place->second;
  }

  void ResultsTable::set_cell(const std::string &column, const Cell &cell)
  {
    const std::size_t k = index_of(column);
    if (current_row.size() <= k)
      current_row.resize(k + 1);
    current_row[k] = cell;
  }

  void ResultsTable::leave_empty(const std::string &column)
  {
    index_of(column);
  }

  void ResultsTable::take_row(const ResultsTable &other, const std::size_t row)
  {
    const Row &cells = other.rows.at(row);
    for (std::size_t k = 0; k < other.column_names.size(); ++k)
      if (k < cells.size() && cells[k].index() != 0)
        set_cell(other.column_names[k], cells[k]);
      else
        leave_empty(other.column_names[k]);
  }

  void ResultsTable::clear()
  {
    rows.clear();
    current_row.clear();
  }

  void ResultsTable::restore(const std::string &text,
                             const std::string &file,
                             const Readers     &readers)
  {
    const auto set_read = [&](const std::string &name,
                              const std::string &field) {
      const std::string text   = without_apostrophe(field);
      const auto        reader = readers.find(name);
      const auto        number = number_of(text);
      if (text.empty())
        leave_empty(name);
      else if (reader != readers.end())
        set_cell(name,
                 std::make_shared<const Named>(
                   Named{text, reader->second(text, rows.size())}));
      else if (text == "true" || text == "false")
        set(name, text == "true");
      else if (text.find_first_not_of("0123456789") == std::string::npos &&
               text.size() < 19)
        set(name, std::stoll(text));
      else if (number)
        set(name, *number);
      else
        set(name, text);
    };
    std::size_t begin = 0;
    auto        names = next_fields(text, begin);
    for (std::string &name : names)
      name = without_apostrophe(name);
    while (begin < text.size())
      {
        const auto fields = next_fields(text, begin);
        if (fields.size() != names.size())
          throw InputError(
            file + ": row " + std::to_string(rows.size() + 1) + " has " +
            std::to_string(fields.size()) + " columns, its first line " +
            std::to_string(names.size()) + ". Start the run without --resume.");
        for (std::size_t k = 0; k < names.size(); ++k)
          set_read(names[k], fields[k]);
        rows.push_back(std::move(current_row));
        current_row.clear();
      }
    n_written_rows = rows.size();
  }

  void ResultsTable::end_row()
  {
    rows.push_back(std::move(current_row));
    current_row.clear();
    write_now_and_then();
  }

  void ResultsTable::write_now_and_then()
  {
    // the whole file is written: some hundredths of the time, however large
    const double                        bytes_a_second = 2e7;
    const std::chrono::duration<double> since_last_write =
      std::chrono::steady_clock::now() - last_write;
    if (row_by_row && (rows.size() <= 1000 ||
                       since_last_write.count() >
                         std::max(1., csv_text.size() / bytes_a_second)))
      flush();
  }

  void ResultsTable::flush()
  {
    if (!folder || n_written_rows == rows.size() ||
        !(is_of_rank || Ranks::is_root()))
      return;
    update_csv();
    is_of_rank ? folder->write_of_rank(file_name, csv_text)
               : folder->write_atomically(file_name, csv_text);
    n_written_rows = rows.size();
    last_write     = std::chrono::steady_clock::now();
  }

  std::size_t ResultsTable::n_rows() const
  {
    return rows.size();
  }

  const ResultsTable::Cell &ResultsTable::cell(const std::size_t  row,
                                               const std::string &column) const
  {
    static const Cell empty;
    const auto        found = column_numbers.find(column);
    return found == column_numbers.end() || found->second >= rows.at(row).size()
             ? empty
             : rows[row][found->second];
  }

  bool ResultsTable::has_numbers(const std::string &column) const
  {
    for (std::size_t row = 0; row < rows.size(); ++row)
      if (cell(row, column).index() != 0 && !number(row, column))
        return false;
    return true;
  }

  std::optional<double> ResultsTable::number(const std::size_t  row,
                                             const std::string &column) const
  {
    return std::visit(CellNumber(), cell(row, column));
  }

  std::string ResultsTable::text(const std::size_t  row,
                                 const std::string &column) const
  {
    return std::visit(CellText{9}, cell(row, column));
  }

  std::string ResultsTable::csv_of(const Row &row) const
  {
    std::string line;
    for (std::size_t k = 0; k < column_names.size(); ++k)
      {
        if (k < row.size())
          line += csv_field(std::visit(CellText{9}, row[k]));
        line += ',';
      }
    if (!line.empty())
      line.back() = '\n';
    return line;
  }

  void ResultsTable::update_csv() const
  {
    if (n_csv_columns != column_names.size() || n_csv_rows > rows.size())
      {
        csv_text.clear();
        for (const std::string &column : column_names)
          csv_text += csv_field(column) + ',';
        if (!csv_text.empty())
          csv_text.back() = '\n';
        n_csv_columns = column_names.size();
        n_csv_rows    = 0;
      }
    for (; n_csv_rows < rows.size(); ++n_csv_rows)
      csv_text += csv_of(rows[n_csv_rows]);
  }

  std::string ResultsTable::csv() const
  {
    update_csv();
    return csv_text;
  }

  std::string
  ResultsTable::screen_table(const std::vector<std::string> &columns,
                             const std::size_t               stride) const
  {
    std::vector<std::string> lines((rows.size() + stride - 1) / stride + 1);
    for (const std::string &column : columns)
      {
        const auto found = column_numbers.find(column);
        if (found == column_numbers.end())
          continue;

        std::vector<std::string> texts{column};
        for (std::size_t k = 0; k < rows.size(); k += stride)
          {
            const Row &row = rows[k];
            const bool is_set =
              found->second < row.size() && row[found->second].index() != 0;
            const std::string text =
              is_set ? std::visit(CellText{4}, row[found->second]) : "";
            texts.push_back(text.empty() ? "-" : text);
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
