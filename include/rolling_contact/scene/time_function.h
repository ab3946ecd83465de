#ifndef rolling_contact_scene_time_function_h
#define rolling_contact_scene_time_function_h

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace dealii
{
  template <int>
  class FunctionParser;
}

namespace RollingContact
{
  /**
   * A quantity given as a function of time in the .prm file:
   * - a number;
   * - an expression in t (s) for muParser, with pi and deal.II's functions
   *   (sin, exp, sqrt, min, if, ...) except the random ones;
   * - `FILE.csv` or `table: FILE column`: a text file with the time (s) in the
   *   first column, rising, and the value in the column of that number (the
   *   time is 1) or name, by default the second. Linear in between, constant
   *   beyond the ends. Columns are separated by commas, semicolons or blanks;
   *   a first line that does not start with a number holds the names; lines
   *   starting with # do not count.
   */
  class TimeFunction
  {
  public:
    explicit TimeFunction(const double constant);

    /**
     * Linear between points of time and value, constant beyond their ends.
     * Throws InputError naming the entry if there is none, a value is not
     * finite or the times do not rise. Units: s.
     */
    TimeFunction(const std::string                            &entry,
                 const std::vector<std::pair<double, double>> &points);

    /**
     * A function from what the user wrote for an entry (Section/Entry, for
     * messages). Files are relative to a folder. Throws InputError naming the
     * entry, its text and what is allowed.
     */
    TimeFunction(const std::string           &entry,
                 const std::string           &text,
                 const std::filesystem::path &folder);

    /**
     * Throws InputError, naming the entry and the time, if it is not finite.
     * Units: s.
     */
    double value(const double time) const;

    bool is_constant() const;

    /**
     * True if more than half of what it does from @p begin to @p end it does
     * within an eighth of that time: a jump, or as good as one. Units: s.
     */
    bool jumps_between(const double begin, const double end) const;

    bool is_table() const
    {
      return points.size() > 1;
    }

    /**
     * Text that differs if the table differs: its size, ends and CRC-32.
     */
    std::string table_fingerprint() const;

  private:
    void read_expression();
    void read_table(std::filesystem::path file, const std::string &column);

    std::string entry, text;
    /**
     * Times and values of a table; a single one for a number. Empty for an
     * expression.
     */
    std::vector<std::pair<double, double>>     points;
    std::shared_ptr<dealii::FunctionParser<1>> expression;
    bool                                       depends_on_time = false;
  };

  /**
   * The value at @p x of points with rising abscissae: linear between them,
   * constant beyond. There is at least one.
   */
  double value_between(const std::vector<std::pair<double, double>> &points,
                       const double                                  x);
} // namespace RollingContact

#endif
