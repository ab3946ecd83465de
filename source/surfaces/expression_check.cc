#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/surfaces/expression_check.h>
#include <rolling_contact/surfaces/surface_record.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    /** Shares of the root mean square from which on short waves are told of
     * and refused. */
    const double notable = 0.05, too_short = 0.05;
  } // namespace

  std::string judge(const Examined &it, const ShortWaves &found)
  {
    const std::string given = it.entry + " = " + it.text + ": ",
                      more  = " Take more Mesh/Elements across patch, or leave "
                              "short waves out; a step needs a ramp.";
    if (found.highest > highest_surface)
      throw InputError(given + "a height of " + significant(found.highest, 4) +
                       " m is too large for a surface that a wheel rolls on "
                       "(at most 5e-3 m): x, y and the height are in m.");
    if (found.steepest > steepest_surface)
      throw InputError(given + "a slope of " + significant(found.steepest, 3) +
                       " at " + it.axis + " = " +
                       significant(found.steepest_from, 6) +
                       " m is too steep for a surface that a wheel rolls on "
                       "(at most 0.1): x, y and the height are in m." +
                       more);
    const auto share = [&](const double part) {
      return significant(100 * part / found.rms, 2) + " % of its rms along " +
             it.axis + " are waves shorter than ";
    };
    if (found.below_two > too_short * found.rms)
      throw InputError(given + share(found.below_two) + "two elements (" +
                       significant(2 * it.element, 3) +
                       " m), which nodes show as longer ones." + more);
    if (found.below_four > notable * found.rms)
      return given + share(found.below_four) + "four elements (" +
             significant(4 * it.element, 3) +
             " m), which the mesh follows poorly." + more;
    return "";
  }

  void check_seam(const HeightExpression &expression,
                  const Examined         &it,
                  const double            turn,
                  const double            begin,
                  const double            end)
  {
    // half a turn from 0, where one turn ends and the next begins
    const double seam = turn * (std::floor(begin / turn + 0.5) + 0.5);
    if (seam > end)
      return;
    const double before = expression.value(turn / 2, 0.),
                 behind = expression.value(-turn / 2, 0.);
    if (std::abs(before - behind) > 1e-3 * it.element)
      throw InputError(it.entry + " = " + it.text +
                       ": after half a turn, x = " + significant(turn / 2, 7) +
                       " m, comes x = " + significant(-turn / 2, 7) +
                       " m, and the height jumps by " +
                       significant(1e6 * (behind - before), 3) +
                       " um. Give it an integer number of waves in a turn of " +
                       significant(turn, 7) + " m, or let it end before.");
  }
} // namespace RollingContact
