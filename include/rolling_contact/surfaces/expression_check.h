#ifndef rolling_contact_surfaces_expression_check_h
#define rolling_contact_surfaces_expression_check_h

#include <rolling_contact/surfaces/height_expression.h>
#include <rolling_contact/surfaces/short_waves.h>

#include <string>

namespace RollingContact
{
  /**
   * What is asked of an expression along an axis, with its name in messages.
   * Units: m.
   */
  struct Examined
  {
    std::string entry, text, axis;
    double      element;
  };

  /**
   * What to warn of in what an expression has along its axis, a sentence, or
   * nothing. Throws InputError: waves of fewer than two elements, heights and
   * slopes beyond reason.
   */
  std::string judge(const Examined &it, const ShortWaves &found);

  /**
   * Throws InputError if the expression jumps where one turn ends and the next
   * begins, half a turn from 0, and this lies between @p begin and @p end.
   * Units: m.
   */
  void check_seam(const HeightExpression &expression,
                  const Examined         &it,
                  const double            turn,
                  const double            begin,
                  const double            end);
} // namespace RollingContact

#endif
