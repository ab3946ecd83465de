#include <deal.II/base/function_parser.h>

#include <boost/crc.hpp>

#include <rolling_contact/base/captured_stderr.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/expression_text.h>
#include <rolling_contact/base/files.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/input/text_table.h>
#include <rolling_contact/scene/time_function.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace RollingContact
{
  using namespace dealii;
  namespace fs = std::filesystem;

  namespace
  {
    [[noreturn]] void reject(const std::string &entry,
                             const std::string &text,
                             const std::string &reason)
    {
      throw InputError(entry + " = " + text + ": " + reason +
                       " Give a number, an expression in t (s) such as "
                       "1e-3*sin(2*pi*50*t), or a table, FILE.csv or "
                       "table: FILE column.");
    }

    /** What is wrong with an expression; empty if nothing. */
    std::string parse(const std::string &text, FunctionParser<1> &expression)
    {
      try
        {
          const CapturedStderr silence;
          expression.initialize("t", text, {{"pi", numbers::PI}});
          expression.value(Point<1>(0.));
          return {};
        }
      catch (const ExceptionBase &error)
        {
          std::ostringstream text_of_error;
          error.print_info(text_of_error);
          const std::string reason = text_of_error.str(),
                            mark   = "The parser said: ";
          const std::size_t found  = reason.find(mark);
          return trimmed(found == std::string::npos
                           ? reason
                           : reason.substr(found + mark.size())) +
                 '.';
        }
    }

    /** Whether the whole text is a number. */
    bool is_number(const std::string &text, double &value)
    {
      const auto found = number_of(text);
      value            = found.value_or(0.);
      return found.has_value();
    }

    /** Index of a column given by its number from 1 or by its name; the number
     * of columns if there is no such one. */
    std::size_t index_of_column(const std::string              &column,
                                const std::vector<std::string> &names,
                                const std::size_t               n_columns)
    {
      double number = 0.;
      if (is_number(column, number))
        return number >= 2 && number <= n_columns &&
                   number == std::floor(number)
                 ? static_cast<std::size_t>(number) - 1
                 : n_columns;
      const std::size_t index =
        std::find(names.begin(), names.end(), column) - names.begin();
      return index < names.size() && index < n_columns ? index : n_columns;
    }
  } // namespace

  TimeFunction::TimeFunction(const double constant)
    : points{{0., constant}}
  {}

  TimeFunction::TimeFunction(
    const std::string                            &entry,
    const std::vector<std::pair<double, double>> &points)
    : entry(entry)
    , points(points)
  {
    if (points.empty())
      throw InputError(entry + ": a history needs a point of time and value.");
    double before = -std::numeric_limits<double>::infinity();
    for (const auto &[time, value] : points)
      {
        if (!std::isfinite(time) || !std::isfinite(value) || !(time > before))
          throw InputError(entry + " = " + significant(value, 6) +
                           " at t = " + significant(time, 6) +
                           " s: values must be finite, and times in s too and "
                           "rising; give others.");
        before = time;
      }
  }

  TimeFunction::TimeFunction(const std::string &entry,
                             const std::string &given_text,
                             const fs::path    &folder)
    : entry(entry)
    , text(trimmed(given_text))
  {
    const std::string keyword = "table:", ending = ".csv";
    double            number = 0.;
    if (is_number(text, number))
      {
        if (!std::isfinite(number))
          reject(entry, text, "it is not finite.");
        points = {{0., number}};
      }
    else if (text.compare(0, keyword.size(), keyword) == 0)
      {
        const std::string rest  = trimmed(text.substr(keyword.size()));
        const std::size_t space = rest.find_last_of(" \t\r\n\v\f");
        if (space == std::string::npos)
          read_table(folder / rest, "2");
        else
          read_table(folder / trimmed(rest.substr(0, space)),
                     rest.substr(space + 1));
      }
    else if (text.size() > ending.size() &&
             text.substr(text.size() - ending.size()) == ending)
      read_table(folder / text, "2");
    else
      read_expression();
  }

  void TimeFunction::read_expression()
  {
    if (text.empty())
      reject(entry, text, "it is empty.");
    const std::string trap = trap_in_expression(text);
    if (!trap.empty())
      reject(entry, text, trap);
    for (const ExpressionName &it : names_in_expression(text))
      depends_on_time = depends_on_time || it.name == "t";
    expression                = std::make_shared<FunctionParser<1>>();
    const std::string problem = parse(text, *expression),
                      unknown = unknown_name_in_expression(text, {"t"});
    if (!problem.empty())
      reject(entry, text, unknown.empty() ? problem : unknown);
  }

  void TimeFunction::read_table(fs::path file, const std::string &column)
  {
    const std::string problem = why_unreadable(file);
    if (!problem.empty())
      reject(entry,
             text,
             "\"" + file.string() + "\" cannot be read: " + problem + '.');
    TextLines                lines(file);
    std::vector<std::string> names;
    while (lines.next())
      {
        const auto        cells = cells_of(lines.text);
        const std::string place = '"' + file.string() + "\", line " +
                                  std::to_string(lines.number) + ": ";
        double time = 0., value = 0.;
        if (points.empty() && names.empty() && !is_number(cells[0], time))
          {
            names = cells;
            continue;
          }
        const std::size_t index = index_of_column(column, names, cells.size());
        if (index == cells.size())
          reject(entry, text, place + "there is no column " + column + '.');
        if (!is_number(cells[0], time) || !is_number(cells[index], value) ||
            !std::isfinite(time) || !std::isfinite(value))
          reject(entry,
                 text,
                 place + "not a number" + cure_of_decimal_commas(lines.text) +
                   ".");
        if (!points.empty() && time <= points.back().first)
          reject(entry, text, place + "the time does not rise.");
        points.emplace_back(time, value);
      }
    if (points.size() < 2)
      reject(entry, text, '"' + file.string() + "\" has less than two rows.");
  }

  bool TimeFunction::jumps_between(const double begin, const double end) const
  {
    if (is_constant())
      return false;
    const unsigned int n_parts = 8;
    double             before = value(begin), sum = 0., largest = 0., size = 0.;
    for (unsigned int k = 1; k <= n_parts; ++k)
      {
        // the ends themselves, as the steps see them
        const double now =
          value(k == n_parts ? end : begin + (end - begin) * k / n_parts);
        const double change = std::abs(now - before);
        size                = std::max({size, std::abs(now), std::abs(before)});
        largest             = std::max(largest, change);
        sum += change;
        before = now;
      }
    const double rounding = 1e-12 * size;
    return largest > rounding && largest > sum / 2;
  }

  double TimeFunction::value(const double time) const
  {
    if (expression)
      {
        const double result = expression->value(Point<1>(time));
        if (!std::isfinite(result))
          reject(entry,
                 text,
                 "at t = " + significant(time, 6) + " s it is not finite.");
        return result;
      }
    return value_between(points, time);
  }

  double value_between(const std::vector<std::pair<double, double>> &points,
                       const double                                  x)
  {
    const auto next =
      std::upper_bound(points.begin(),
                       points.end(),
                       x,
                       [](const double                     t,
                          const std::pair<double, double> &point) {
                         return t < point.first;
                       });
    if (next == points.begin())
      return points.front().second;
    if (next == points.end())
      return points.back().second;
    const auto &[x0, first] = *(next - 1);
    const double weight     = (x - x0) / (next->first - x0);
    return (1 - weight) * first + weight * next->second;
  }

  bool TimeFunction::is_constant() const
  {
    return expression ? !depends_on_time : !is_table();
  }

  std::string TimeFunction::table_fingerprint() const
  {
    boost::crc_32_type crc;
    for (const auto &[time, value] : points)
      {
        crc.process_bytes(&time, sizeof(time));
        crc.process_bytes(&value, sizeof(value));
      }
    return std::to_string(points.size()) + " rows from " +
           significant(points.front().first, 6) + " to " +
           significant(points.back().first, 6) + " s, CRC-32 " +
           std::to_string(crc.checksum());
  }
} // namespace RollingContact
