#include "input_parts.h"

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/input/rows_file.h>
#include <rolling_contact/scene/table_parameters.h>
#include <rolling_contact/tables/table_plan.h>

using namespace RollingContact;

namespace
{
  const char entry[] = "Table/File of rows";

  std::string csv_of(const NamedRows &table, const char separator)
  {
    std::string text;
    for (const std::string &name : table.names)
      text += (text.empty() ? "" : std::string(1, separator)) + name;
    text += '\n';
    for (const auto &row : table.rows)
      {
        must(row.size() == table.names.size(), "a row of another length");
        for (std::size_t k = 0; k < row.size(); ++k)
          text += (k == 0 ? "" : std::string(1, separator)) + written(row[k]);
        text += '\n';
      }
    return text;
  }

  void read_file()
  {
    NamedRows table;
    try
      {
        table = read_rows(entry, "rows.csv");
      }
    catch (const InputError &error)
      {
        must_name(error, entry);
        must_name(error, "rows.csv");
        return;
      }
    must(!table.names.empty() && !table.rows.empty(), "an empty table");
    // a name may hold what separates columns only where the other one does, and
    // a mark of the byte order only behind the first line
    bool has_comma = false;
    for (const std::string &name : table.names)
      has_comma = has_comma || name.find(',') != std::string::npos;
    if ((has_comma && table.names.size() == 1) ||
        table.names[0].compare(0, 3, "\xEF\xBB\xBF") == 0)
      return;
    write_part("rows.csv", {csv_of(table, has_comma ? ';' : ',')}, 0);
    const NamedRows again = read_rows(entry, "rows.csv");
    must(again.names == table.names && again.rows == table.rows,
         "written and read it is another table");
  }

  void read_axes(const std::vector<std::string> &texts)
  {
    TableParameters parameters;
    for (std::size_t k = 0; k < parameters.axis_texts.size(); ++k)
      if (k < texts.size())
        parameters.axis_texts[k] = texts[k];
    std::vector<TableAxis> axes;
    try
      {
        axes = parameters.axes();
      }
    catch (const InputError &error)
      {
        must_name(error, "Table/Axis ");
        return;
      }
    for (std::size_t d = 0; d < axes.size(); ++d)
      {
        std::string text = axes[d].entry + " = ";
        for (std::size_t k = 0; k < axes[d].values.size(); ++k)
          {
            must(k == 0 || axes[d].values[k] > axes[d].values[k - 1],
                 "values that do not rise");
            text += (k == 0 ? "" : ", ") + written(axes[d].values[k]);
          }
        TableParameters again;
        again.axis_texts[0] = text;
        must(again.axes().at(0).values == axes[d].values,
             "written and read it is another axis");
      }
  }
} // namespace

/** Parts: rows.csv, then the texts of axes. */
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data,
                                      const std::size_t   size)
{
  const auto parts = input_parts(data, size);
  write_part("rows.csv", parts, 0);
  read_file();
  read_axes({parts.begin() + 1, parts.end()});
  return 0;
}
