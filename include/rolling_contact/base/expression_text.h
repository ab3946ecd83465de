#ifndef rolling_contact_base_expression_text_h
#define rolling_contact_base_expression_text_h

#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * A name in an expression: of a variable or constant, or of a function, if
   * "(" follows.
   */
  struct ExpressionName
  {
    std::string name;
    bool        is_function = false;
  };

  /** The names in an expression for muParser, in their order. */
  std::vector<ExpressionName> names_in_expression(const std::string &text);

  /**
   * What muParser would take without a word, but not as meant: a comma outside
   * of parentheses (of 0,5 it takes 5), more than one expression, an assignment
   * (t=5 is 5), a random number. A sentence; empty if there is nothing.
   */
  std::string trap_in_expression(const std::string &text);

  /**
   * Why an expression that was not understood may not have been: the first name
   * that is none of the @p variables, pi and functions. A sentence; empty if
   * all are known.
   */
  std::string
  unknown_name_in_expression(const std::string              &text,
                             const std::vector<std::string> &variables);
} // namespace RollingContact

#endif
