#include <rolling_contact/base/ranks.h>
#include <rolling_contact/pair/rolling_pair.h>

namespace RollingContact
{
  namespace
  {
    /**
     * Add a body's compliance, given in its own frame. In the wheel's frame z
     * is mirrored: the blocks between tangential and normal components change
     * sign.
     */
    void add_compliance(const DenseMatrix &body,
                        const bool         mirrored,
                        const std::size_t  n_nodes,
                        DenseMatrix       &pair)
    {
      const std::size_t n = body.rows(), first_normal = n - n_nodes;
      Eigen::VectorXd   signs = Eigen::VectorXd::Ones(n);
      if (mirrored)
        signs.head(first_normal) *= -1;
      pair += signs.asDiagonal() * body * signs.asDiagonal();
    }
  } // namespace

  template <int dim>
  DenseMatrix
  RollingPair<dim>::pair_compliance(PerSide<DenseMatrix> bodies) const
  {
    for (const Side side : both_sides)
      bodies[side] =
        pair_interface.coupling[side].to_interface(std::move(bodies[side]));
    return added_compliance(std::move(bodies));
  }

  template <int dim>
  DenseMatrix
  RollingPair<dim>::added_compliance(PerSide<DenseMatrix> bodies) const
  {
    const std::size_t n_nodes = trace().nodes.size();
    for (const Side side : both_sides)
      if (body_pair.has_own_body(side))
        Ranks::broadcast(bodies[side], body_pair.rank_of(side));
    DenseMatrix W = DenseMatrix::Zero(components.size() * n_nodes,
                                      components.size() * n_nodes);
    for (const Side side : both_sides)
      if (const DenseMatrix &body =
            body_pair.twins() ? bodies.wheel : bodies[side];
          body.size() > 0)
        add_compliance(body, side == Side::wheel, n_nodes, W);
    return W;
  }

  namespace
  {
    /**
     * Nodes from which on products by Fourier transforms and iterations take
     * less time than a dense W: those of 17 to 20 elements across.
     */
    const std::size_t least_on_grid = 350;
  } // namespace

  template <int dim>
  std::optional<GridInfluence> RollingPair<dim>::influence_on_grid() const
  {
    if (!body_pair.is_split() || pair_interface.turns_nodes() ||
        Ranks::count() > 1 || trace().nodes.size() < least_on_grid)
      return {};
    std::optional<GridInfluence> pair;
    for (const Side side : both_sides)
      {
        const Side of = body_pair.twins() ? Side::wheel : side;
        if (!body_pair.body(of))
          continue;
        auto body = body_pair.body(of)->grid_influence(pair_interface.nodes[of],
                                                       components);
        if (!body)
          return {};
        if (side == Side::wheel)
          body->mirror();
        if (pair)
          pair->add(*body);
        else
          pair = std::move(body);
      }
    return pair;
  }

  template DenseMatrix
    RollingPair<2>::pair_compliance(PerSide<DenseMatrix>) const;
  template DenseMatrix
    RollingPair<3>::pair_compliance(PerSide<DenseMatrix>) const;
  template DenseMatrix
    RollingPair<2>::added_compliance(PerSide<DenseMatrix>) const;
  template DenseMatrix
    RollingPair<3>::added_compliance(PerSide<DenseMatrix>) const;
  template std::optional<GridInfluence>
  RollingPair<2>::influence_on_grid() const;
  template std::optional<GridInfluence>
  RollingPair<3>::influence_on_grid() const;
} // namespace RollingContact
