#include <rolling_contact/base/number_text.h>
#include <rolling_contact/run/results_table.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  void ResultsTable::append(const ResultsTable &other)
  {
    const bool is_fuller = other.column_names.size() > column_names.size();
    for (std::size_t row = 0; row < other.rows.size(); ++row)
      {
        take_row(other, row);
        rows.push_back(std::move(current_row));
        current_row.clear();
      }
    if (is_fuller)
      lead_with(other.column_names);
    write_now_and_then();
  }

  void ResultsTable::sort_by(const std::string &column)
  {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < rows.size(); ++i)
      order.emplace_back(number(i, column).value(), i);
    std::stable_sort(order.begin(),
                     order.end(),
                     [](const auto &a, const auto &b) {
                       return a.first < b.first;
                     });
    std::vector<Row> sorted;
    for (const auto &place : order)
      sorted.push_back(std::move(rows[place.second]));
    rows           = std::move(sorted);
    n_csv_columns  = 0;
    n_written_rows = 0;
  }

  void ResultsTable::lead_with(const std::vector<std::string> &names)
  {
    std::vector<std::string> order;
    for (const std::string &name : names)
      if (column_numbers.count(name) > 0)
        order.push_back(name);
    for (const std::string &name : column_names)
      if (std::find(names.begin(), names.end(), name) == names.end())
        order.push_back(name);
    if (order == column_names)
      return;
    for (Row &row : rows)
      {
        Row moved(order.size());
        for (std::size_t k = 0; k < order.size(); ++k)
          if (const std::size_t from = column_numbers.at(order[k]);
              from < row.size())
            moved[k] = std::move(row[from]);
        row = std::move(moved);
      }
    column_names = order;
    for (std::size_t k = 0; k < order.size(); ++k)
      column_numbers[order[k]] = k;
    n_csv_columns  = 0;
    n_written_rows = 0;
  }

  std::optional<double>
  ResultsTable::written_number(const std::size_t  row,
                               const std::string &column) const
  {
    const auto exact = number(row, column);
    if (!exact || std::isnan(*exact))
      return exact;
    const auto written = number_of(text(row, column));
    return written ? written : exact; // a bool
  }
} // namespace RollingContact
