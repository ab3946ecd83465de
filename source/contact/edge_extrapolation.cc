#include <rolling_contact/contact/edge_extrapolation.h>
#include <rolling_contact/contact/tangential_problem.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace RollingContact
{
  namespace
  {
    using Vector2 = std::array<double, 2>;

    /**
     * The first node of the line that carries the full traction bound; the
     * length of the line if there is none.
     */
    std::size_t first_slipping(const ContactEdge       &edge,
                               const TangentialProblem &problem,
                               const NodalField        &traction)
    {
      const auto found = std::find_if(edge.nodes.begin(),
                                      edge.nodes.end(),
                                      [&](const unsigned int node) {
                                        return traction.norm_at(node) >=
                                               (1 - 1e-9) * problem.bound[node];
                                      });
      return found - edge.nodes.begin();
    }

    /**
     * g = (q - q_n) / p at the node @p k of the edge.
     */
    Vector2 scaled_traction(const ContactEdge &edge,
                            const NodalField  &traction,
                            const std::size_t  k)
    {
      Vector2 g{{0., 0.}};
      for (unsigned int c = 0; c < traction.n_components(); ++c)
        g[c] = (traction(c, edge.nodes[k]) - edge.coupling[c][k]) /
               edge.pressure[c][k];
      return g;
    }

    /**
     * Make @p law that of a square rho = |g - e|^2 on a line through the second
     * and third node, e the value at the transition to slip. False if there is
     * none.
     */
    bool square_law(const double       r,
                    const Vector2     &g2,
                    const Vector2     &g3,
                    const Vector2     &e,
                    EdgeExtrapolation &law)
    {
      const Vector2 drop2{{g2[0] - e[0], g2[1] - e[1]}},
        drop3{{g3[0] - e[0], g3[1] - e[1]}};
      const double rho2 = std::hypot(drop2[0], drop2[1]);
      if (!(rho2 > 0.))
        return false;
      const double rho3 =
        std::max(0., (drop2[0] * drop3[0] + drop2[1] * drop3[1]) / rho2);
      // never less than half of the next node's, whatever the roughness
      const double rho1 = std::sqrt(
        std::max((1 + r) * rho2 * rho2 - r * rho3 * rho3, 0.25 * rho2 * rho2));
      if (!std::isfinite(rho1))
        return false;
      law.a = (1 + r) * rho2 / rho1;
      law.b = r * rho3 / rho1;
      for (unsigned int c = 0; c < 2; ++c)
        law.c[c] = e[c] * (1 - law.a + law.b);
      return true;
    }
  } // namespace

  EdgeExtrapolations extrapolate_edges(const TangentialProblem &problem,
                                       const NodalField        &traction)
  {
    EdgeExtrapolations result;
    for (const ContactEdge &edge : problem.rows.edges)
      {
        const std::size_t slipping = first_slipping(edge, problem, traction);
        if (edge.nodes.size() < 4 || slipping < 2 || edge.slender)
          continue;
        const auto g = [&](const std::size_t k) {
          return scaled_traction(edge, traction, k);
        };
        const double r =
          (edge.along[1] - edge.along[0]) / (edge.along[2] - edge.along[1]);
        EdgeExtrapolation law{edge.nodes[0], 1 + r, r, {{0., 0.}}};
        if (slipping < edge.nodes.size())
          {
            // at the transition, which need not be at rest at a node
            const unsigned int node = edge.nodes[slipping];
            const double       share =
              problem.contact.loads.friction[node] / problem.friction[node];
            const Vector2 at_node = g(slipping);
            const Vector2 e{{share * at_node[0], share * at_node[1]}};
            if (!square_law(r, g(1), g(2), e, law))
              continue;
          }
        result.push_back(law);
      }
    return result;
  }

  const EdgeExtrapolation *find_edge(const EdgeExtrapolations &extrapolations,
                                     const unsigned int        first)
  {
    const auto found =
      std::find_if(extrapolations.begin(),
                   extrapolations.end(),
                   [&](const auto &edge) { return edge.first == first; });
    return found == extrapolations.end() ? nullptr : &*found;
  }

  SlipScheme slip_scheme(const TangentialProblem &problem,
                         const NodalField        &traction)
  {
    SlipScheme scheme;
    scheme.edges = extrapolate_edges(problem, traction);
    if (traction.n_components() < 2 || problem.contact.loads.friction_law)
      return scheme;
    const auto slides = [&](const unsigned int node) {
      return traction.norm_at(node) >= (1 - 1e-9) * problem.bound[node];
    };
    for (const InnerNode &inner : problem.rows.inner)
      if (slides(inner.node) && slides(inner.upstream))
        scheme.sliding.push_back(inner.node);
    std::sort(scheme.sliding.begin(), scheme.sliding.end());
    return scheme;
  }

  double difference(const SlipScheme &first, const SlipScheme &second)
  {
    const double infinite = std::numeric_limits<double>::infinity();
    const auto  &a = first.edges, &b = second.edges;
    if (a.size() != b.size() || first.sliding != second.sliding)
      return infinite;
    double largest = 0.;
    for (std::size_t k = 0; k < a.size(); ++k)
      {
        if (a[k].first != b[k].first)
          return infinite;
        largest = std::max(
          {largest, std::abs(a[k].a - b[k].a), std::abs(a[k].b - b[k].b)});
      }
    return largest;
  }

  namespace
  {
    std::vector<unsigned int> in_both(const std::vector<unsigned int> &first,
                                      const std::vector<unsigned int> &second)
    {
      std::vector<unsigned int> nodes;
      std::set_intersection(first.begin(),
                            first.end(),
                            second.begin(),
                            second.end(),
                            std::back_inserter(nodes));
      return nodes;
    }
  } // namespace

  SlipScheme without_new_sliding(const SlipScheme &now, const SlipScheme &next)
  {
    return {next.edges, in_both(now.sliding, next.sliding)};
  }

  SlipScheme without_new_edges(const SlipScheme &now, const SlipScheme &next)
  {
    SlipScheme result{{}, next.sliding};
    for (const EdgeExtrapolation &edge : next.edges)
      if (find_edge(now.edges, edge.first))
        result.edges.push_back(edge);
    return result;
  }

  SlipScheme
  moved(const SlipScheme &now, const SlipScheme &next, const double part)
  {
    SlipScheme result = next;
    for (EdgeExtrapolation &edge : result.edges)
      if (const EdgeExtrapolation *old = find_edge(now.edges, edge.first))
        {
          edge.a = old->a + part * (edge.a - old->a);
          edge.b = old->b + part * (edge.b - old->b);
          for (unsigned int c = 0; c < 2; ++c)
            edge.c[c] = old->c[c] + part * (edge.c[c] - old->c[c]);
        }
    return result;
  }

  SlipScheme common(const SlipScheme &now, const SlipScheme &next)
  {
    SlipScheme result{{}, in_both(now.sliding, next.sliding)};
    for (const EdgeExtrapolation &edge : now.edges)
      if (find_edge(next.edges, edge.first))
        result.edges.push_back(edge);
    return result;
  }
} // namespace RollingContact
