#include <rolling_contact/stability/threshold.h>

#include <algorithm>

namespace RollingContact
{
  namespace
  {
    /** Between both ends, nearer to neither than half of the width, so that
     * the next one is on the other side: where a straight line has its zero. */
    double next_of_threshold(const Threshold &found,
                             const double     width,
                             const bool       halve)
    {
      const double at = halve
                          ? (found.before + found.behind) / 2
                          : found.before - found.growth_before / found.slope();
      return std::clamp(at, found.before + width / 2, found.behind - width / 2);
    }
  } // namespace

  Threshold
  first_threshold(const double                                        at_zero,
                  const std::function<std::optional<double>(double)> &growth,
                  const ThresholdSearch                              &search)
  {
    Threshold found;
    found.growth_before = at_zero;
    const bool grows    = at_zero > 0.;
    /* takes the growth at a change to one end; false if there is none */
    const auto ask = [&](const double change) {
      const std::optional<double> here = growth(change);
      ++found.n_states;
      found.known = here.has_value();
      if (!here)
        {
          found.behind  = change;
          found.crossed = false;
          return false;
        }
      const bool crossed                      = (*here > 0.) != grows;
      (crossed ? found.behind : found.before) = change;
      (crossed ? found.growth_behind : found.growth_before) = *here;
      found.crossed = found.crossed || crossed;
      return true;
    };
    double step = search.first;
    do
      {
        if (!ask(std::min(step, search.most)))
          return found;
        step *= 2;
    } while (!found.crossed && found.before < search.most);
    if (!found.crossed)
      {
        found.behind = found.before;
        return found;
      }
    // a bracket that secants do not halve within two steps is halved
    const double small = 1e-9 * search.width;
    double       last  = found.behind - found.before;
    for (unsigned int k = 1; found.behind - found.before > search.width + small;
         ++k)
      {
        const double length = found.behind - found.before;
        const bool   halve  = k % 3 == 0 && length > last / 2;
        if (k % 3 == 0)
          last = length;
        if (!ask(next_of_threshold(found, search.width, halve)))
          return found;
      }
    return found;
  }
} // namespace RollingContact
