#ifndef rolling_contact_base_text_h
#define rolling_contact_base_text_h

#include <cstddef>
#include <string>

namespace RollingContact
{
  /**
   * A number with so many significant digits, in the shorter of plain and
   * exponential form; "nan" and "inf" as such. Independent of the locale.
   */
  std::string significant(double value, unsigned int digits);

  /** Like significant(), always in exponential form: 1.23e-05. */
  std::string scientific(double value, unsigned int digits);

  /**
   * A length in m as text in mm: "0.123 mm".
   */
  std::string millimetres(double length, unsigned int digits = 3);

  /**
   * A number of bytes as 3.1 GB, with powers of 1000.
   */
  std::string human_bytes(double bytes);

  /**
   * A time as 35 ms, 13.7 s, 2 min 05 s, 1 h 02 min.
   */
  std::string human_seconds(double seconds);

  /** A text without the blanks that it begins and ends with. */
  std::string trimmed(const std::string &text,
                      const char        *blanks = " \t\r\n\v\f");

  /** The text with every byte that is not UTF-8 replaced by U+FFFD. */
  std::string valid_utf8(const std::string &text);

  /**
   * A text of unknown origin for a message: control characters and bytes that
   * are not UTF-8 as hexadecimal escapes, and no more of it than so many
   * characters, with ... behind them.
   */
  std::string quotable(const std::string &text,
                       std::size_t        most_characters = 60);

  /**
   * A text for a cell that a spreadsheet shows and never evaluates: one that it
   * would take for a formula, for it begins with '=', '+', '-', '@' or a tab
   * and is not a number, gets an apostrophe before it, as does one that would
   * be mistaken for such a cell.
   */
  std::string no_formula(const std::string &text);

  /** The text that no_formula() made this cell of. */
  std::string without_apostrophe(const std::string &cell);

  /** A number filled up with zeros to so many digits: 007. */
  std::string zero_padded(std::size_t number, unsigned int digits);

  /** Number of characters (not bytes) of a UTF-8 text. */
  std::size_t n_characters(const std::string &text);

  /** The text filled up with spaces, behind it or before it, to a width. */
  std::string left_aligned(const std::string &text, std::size_t width);
  std::string right_aligned(const std::string &text, std::size_t width);

  /**
   * Breaks every line longer than `width` between words; what follows a break
   * is indented as its line was, and by `hanging_indentation` more. Lines that
   * fit stay as they are, and so do words longer than a line.
   */
  std::string wrapped(const std::string &text,
                      std::size_t        width               = 80,
                      std::size_t        hanging_indentation = 2);
} // namespace RollingContact

#endif
