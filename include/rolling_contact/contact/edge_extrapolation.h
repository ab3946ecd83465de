#ifndef rolling_contact_contact_edge_extrapolation_h
#define rolling_contact_contact_edge_extrapolation_h

#include <rolling_contact/algebra/nodal_field.h>

#include <array>
#include <vector>

namespace RollingContact
{
  struct TangentialProblem;

  /**
   * What the edge law asks of the first node of a line of touching nodes, by
   * the next two: g1 = a g2 - b g3 + c, with g = (q - q_n) / p. The default is
   * g1 = g2. See slip_rows() and extrapolate_edges().
   */
  struct EdgeExtrapolation
  {
    unsigned int          first = 0; ///< node
    double                a     = 1.;
    double                b     = 0.;
    std::array<double, 2> c{{0., 0.}}; ///< for each tangential component

    /** For Boost.Serialization. A member not listed here does not compile. */
    template <typename Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      auto &[first, a, b, c] = *this;
      archive &first &a &b &c;
    }
  };

  using EdgeExtrapolations = std::vector<EdgeExtrapolation>;

  /**
   * What the rows of the slip take from the traction of the round before: the
   * extrapolations at leading edges, and which nodes slide behind a node that
   * slides. See slip_rows().
   */
  struct SlipScheme
  {
    EdgeExtrapolations        edges; ///< where not g1 = g2
    std::vector<unsigned int> sliding;

    bool empty() const
    {
      return edges.empty() && sliding.empty();
    }

    /** For Boost.Serialization. A member not listed here does not compile. */
    template <typename Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      auto &[edges, sliding] = *this;
      archive &edges &sliding;
    }
  };

  /**
   * The extrapolations that a traction asks for. With e the value of g at the
   * first node that slips, rho = g - e vanishes with the square root of the
   * distance to the transition, as in Carter's solution: there rho^2 =
   * (l - x)/(2a - x) times a constant, l the length of the stick zone and x
   * from the edge. So rho^2 is taken as linear in x,
   *
   *   |rho1|^2 = (1 + r) |rho2|^2 - r |rho3|^2,    r = (x2 - x1)/(x3 - x2),
   *
   * and what is given is its tangent, a = (1 + r) |rho2|/|rho1|, b = r
   * |rho3|/|rho1|, c = e (1 - a + b). On lines that stick throughout g itself
   * is linear; where node 1 or 2 slips and on lines of less than four nodes g1
   * = g2, and there is no entry. So it is where elements are more than twice as
   * long as wide: there nodes of other lines are nearer than those of the line
   * itself, which is taken to act alone, and the slip would no longer grow with
   * the traction, so that short stick zones come and go without end.
   */
  EdgeExtrapolations extrapolate_edges(const TangentialProblem &problem,
                                       const NodalField        &traction);

  /**
   * The scheme that a traction asks for: extrapolate_edges(), and the nodes of
   * TangentialProblem::rows.inner that slide behind a node that slides. The
   * latter with two tangential components only, as with one the traction of a
   * sliding node does not depend on the size of its slip, and without a
   * friction law.
   */
  SlipScheme slip_scheme(const TangentialProblem &problem,
                         const NodalField        &traction);

  /**
   * The extrapolation at the edge that begins with node @p first; nullptr if
   * there is none.
   */
  const EdgeExtrapolation *find_edge(const EdgeExtrapolations &extrapolations,
                                     const unsigned int        first);

  /**
   * The largest difference between two schemes, in the coefficients a and b of
   * their extrapolations; infinite if they are of different edges or nodes.
   */
  double difference(const SlipScheme &first, const SlipScheme &second);

  /**
   * The scheme @p next with no sliding nodes that @p now does not have.
   */
  SlipScheme without_new_sliding(const SlipScheme &now, const SlipScheme &next);

  /**
   * The scheme @p next with no extrapolations at edges where @p now has none.
   */
  SlipScheme without_new_edges(const SlipScheme &now, const SlipScheme &next);

  /**
   * The scheme @p next, where @p now has an edge as well @p part of the way
   * from those of @p now.
   */
  SlipScheme
  moved(const SlipScheme &now, const SlipScheme &next, const double part);

  /**
   * The extrapolations of @p now at edges that @p next has as well, and the
   * sliding nodes of both.
   */
  SlipScheme common(const SlipScheme &now, const SlipScheme &next);
} // namespace RollingContact

#endif
