#ifndef rolling_contact_solvers_scheme_rounds_h
#define rolling_contact_solvers_scheme_rounds_h

#include <rolling_contact/contact/edge_extrapolation.h>
#include <rolling_contact/solvers/anderson.h>

#include <map>
#include <set>

namespace RollingContact
{
  /**
   * The fixed point of the slip scheme: each round solves with a scheme and
   * finds the one its traction asks for. The first rounds take the whole step,
   * later ones a part of it, which settles rounds that alternate between two
   * sets, and let nodes no more be added to those that slide; once the set of
   * edges stays, with Anderson acceleration, as a step may overshoot by more
   * than a part of it cures. An edge that was withdrawn twice, or that made the
   * problem unsolvable, does not come back: the stick zone of its line is as
   * short as two nodes and has no extrapolation.
   */
  class SchemeRounds
  {
  public:
    static constexpr unsigned int max_rounds = 24;

    /**
     * Rounds before acceleration: where rounds converge by themselves few are
     * faster, where sets of edges come and go many are safer.
     */
    static constexpr unsigned int cautious = 12, economical = 2;

    explicit SchemeRounds(const unsigned int n_plain_rounds)
      : plain_rounds(n_plain_rounds)
    {}

    /**
     * What is taken of the scheme @p asked by the solution with the scheme
     * @p now.
     */
    SlipScheme admitted(const SlipScheme &now, SlipScheme asked);

    /**
     * The scheme to solve with next, and one round more. @p asked comes from
     * admitted().
     */
    SlipScheme next(const SlipScheme &now, const SlipScheme &asked);

    /**
     * Exclude the edges that @p failed has and @p solved has not. False if
     * there are none.
     */
    bool exclude_new_edges(const SlipScheme &solved, const SlipScheme &failed);

    unsigned int round() const
    {
      return n_rounds;
    }

  private:
    SlipScheme accelerated(const SlipScheme &now, const SlipScheme &asked);

    static constexpr std::size_t         depth = 3;
    const unsigned int                   plain_rounds;
    unsigned int                         n_rounds = 0, n_rounds_of_set = 0;
    std::map<unsigned int, unsigned int> withdrawals; ///< of first nodes
    std::set<unsigned int>               excluded;    ///< first nodes
    Anderson                             anderson{depth};
  };
} // namespace RollingContact

#endif
