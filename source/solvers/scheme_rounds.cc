#include <rolling_contact/solvers/scheme_rounds.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /**
     * Rounds that take the whole step, the first round that adds no edges, the
     * part of the step that others take, and withdrawals after which an edge is
     * excluded. Empirical; calls for more than a few rounds are rare.
     */
    const unsigned int full_rounds = 2, last_growth = 8, max_withdrawals = 2;
    const double       part_of_step = 0.7;

    NodalField coefficients(const EdgeExtrapolations &edges)
    {
      NodalField values(edges.size(), 4);
      for (std::size_t k = 0; k < edges.size(); ++k)
        {
          values(0, k) = edges[k].a;
          values(1, k) = edges[k].b;
          for (unsigned int c = 0; c < 2; ++c)
            values(2 + c, k) = edges[k].c[c];
        }
      return values;
    }
  } // namespace

  SlipScheme SchemeRounds::admitted(const SlipScheme &now, SlipScheme asked)
  {
    if (n_rounds >= full_rounds)
      asked = without_new_sliding(now, asked);
    // an edge that comes and goes does not come back
    if (n_rounds >= last_growth)
      asked = without_new_edges(now, asked);
    auto &edges = asked.edges;
    edges.erase(std::remove_if(edges.begin(),
                               edges.end(),
                               [&](const EdgeExtrapolation &edge) {
                                 return excluded.count(edge.first) > 0;
                               }),
                edges.end());
    return asked;
  }

  SlipScheme SchemeRounds::next(const SlipScheme &now, const SlipScheme &asked)
  {
    const unsigned int round = n_rounds++;
    for (const EdgeExtrapolation &edge : now.edges)
      if (round > 0 && !find_edge(asked.edges, edge.first) &&
          ++withdrawals[edge.first] == max_withdrawals)
        excluded.insert(edge.first);
    const bool same_set = std::isfinite(difference(now, asked));
    n_rounds_of_set     = same_set ? n_rounds_of_set + 1 : 0;
    if (!same_set)
      anderson = Anderson(depth);
    if (round < full_rounds)
      return asked;
    if (n_rounds == max_rounds)
      return common(now, asked);
    if (n_rounds_of_set > 1 && n_rounds > plain_rounds)
      return accelerated(now, asked);
    return moved(now, asked, part_of_step);
  }

  SlipScheme SchemeRounds::accelerated(const SlipScheme &now,
                                       const SlipScheme &asked)
  {
    const NodalField values =
      anderson.next(coefficients(now.edges), coefficients(asked.edges));
    SlipScheme result = asked;
    for (std::size_t k = 0; k < result.edges.size(); ++k)
      {
        result.edges[k].a = values(0, k);
        result.edges[k].b = values(1, k);
        for (unsigned int c = 0; c < 2; ++c)
          result.edges[k].c[c] = values(2 + c, k);
      }
    return result;
  }

  bool SchemeRounds::exclude_new_edges(const SlipScheme &solved,
                                       const SlipScheme &failed)
  {
    bool any = false;
    for (const EdgeExtrapolation &edge : failed.edges)
      if (!find_edge(solved.edges, edge.first))
        any = excluded.insert(edge.first).second || any;
    return any;
  }
} // namespace RollingContact
