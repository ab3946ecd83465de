#ifndef rolling_contact_input_text_table_h
#define rolling_contact_input_text_table_h

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * The trimmed cells of a line, between the first ',' or ';' that it has or
   * between given separators, else between blanks.
   */
  std::vector<std::string> cells_of(const std::string &line,
                                    char               separator = 0);

  /**
   * What to do if a text is numbers between blanks or semicolons that have
   * decimal commas, as "1,5; 2,3": a clause behind "; " for messages; empty if
   * it is none.
   */
  std::string cure_of_decimal_commas(const std::string &text);

  /** The cure, or that decimals take a point, behind "; ". */
  std::string advice_on_decimals(const std::string &text);

  /**
   * The lines of a text file that say something, with their number: without a
   * byte order mark, comments and blanks around them.
   */
  class TextLines
  {
  public:
    /**
     * Comments begin with one of the @p marks. A file that cannot be read has
     * no lines.
     */
    explicit TextLines(const std::filesystem::path &file,
                       const char                  *marks = "#");

    /**
     * Go to the next line; false if there is none.
     */
    bool next();

    std::string text;
    std::size_t number = 0; ///< from 1

  private:
    std::ifstream     stream;
    const std::string marks;
  };
} // namespace RollingContact

#endif
