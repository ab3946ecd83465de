#include <deal.II/base/numbers.h>

#include <rolling_contact/base/captured_stderr.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/expression_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/surfaces/height_expression.h>

#include <cmath>

namespace RollingContact
{
  using namespace dealii;

  void HeightExpression::reject(const std::string &reason) const
  {
    throw InputError(entry + " = " + text + ": " + reason +
                     " Give an expression in x and y (m) such as "
                     "2e-6*cos(2*pi*x/1e-3)" +
                     otherwise);
  }

  HeightExpression::HeightExpression(const std::string &entry,
                                     const std::string &text,
                                     const std::string &otherwise)
    : entry(entry)
    , text(text)
    , otherwise(otherwise)
  {
    if (text.empty())
      return;
    const std::string trap = trap_in_expression(text);
    if (!trap.empty())
      reject(trap);
    for (const ExpressionName &it : names_in_expression(text))
      has_y = has_y || it.name == "y";
    expression      = std::make_shared<FunctionParser<2>>();
    bool understood = true;
    try
      {
        const CapturedStderr silence;
        expression->initialize("x,y", text, {{"pi", numbers::PI}});
        expression->value(Point<2>());
      }
    catch (const ExceptionBase &)
      {
        understood = false;
      }
    const std::string unknown = unknown_name_in_expression(text, {"x", "y"});
    if (!understood)
      reject(unknown.empty() ? "the expression cannot be understood."
                             : unknown);
  }

  double HeightExpression::value(const double x, const double y) const
  {
    if (!expression)
      return 0.;
    const double height = expression->value(Point<2>(x, y));
    if (!std::isfinite(height))
      reject("it is not finite at (" + significant(x, 6) + ", " +
             significant(y, 6) + ") m.");
    return height;
  }
} // namespace RollingContact
