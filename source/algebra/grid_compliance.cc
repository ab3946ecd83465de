#include <rolling_contact/algebra/grid_compliance.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  NodesOnGrid nodes_on_grid(const std::vector<std::array<double, 2>> &positions,
                            const std::array<double, 2>              &size)
  {
    NodesOnGrid nodes;
    nodes.places.resize(positions.size());
    for (unsigned int d = 0; d < 2; ++d)
      {
        int least = 0, largest = 0;
        for (std::size_t i = 0; i < positions.size(); ++i)
          {
            const int at =
              std::lround((positions[i][d] - positions[0][d]) / size[d]);
            nodes.places[i][d] = at;
            least              = std::min(least, at);
            largest            = std::max(largest, at);
          }
        for (auto &place : nodes.places)
          place[d] -= least;
        nodes.n[d] = largest - least + 1;
      }
    return nodes;
  }

  void InfluenceTable::mirror()
  {
    const Eigen::Index n = n_components() - 1;
    for (DenseMatrix &at : entries)
      {
        at.col(n).head(n) *= -1;
        at.row(n).head(n) *= -1;
      }
  }

  void InfluenceTable::add(const InfluenceTable &other)
  {
    for (std::size_t k = 0; k < entries.size(); ++k)
      entries[k] += other.entries[k];
  }

  void GridInfluence::mirror()
  {
    half_space.mirror();
    for (Eigen::Index k = 0; k < of_shapes.rows(); ++k)
      for (Eigen::Index l = 0; l < of_shapes.cols(); ++l)
        if (shape_is_normal[k] != shape_is_normal[l])
          of_shapes(k, l) *= -1;
  }

  void GridInfluence::add(const GridInfluence &other)
  {
    half_space.add(other.half_space);
    of_shapes += other.of_shapes;
  }

  namespace
  {
    /** The influence between forces and displacements that are both taken with
     * the weights 1/4, 1/2, 1/4 in each direction. */
    double halved_entry(const InfluenceTable &table,
                        const int             along,
                        const int             across,
                        const unsigned int    of,
                        const unsigned int    by)
    {
      const std::array<double, 5> weights{
        {1. / 16, 4. / 16, 6. / 16, 4. / 16, 1. / 16}};
      double sum = 0.;
      for (int j = -2; j <= 2; ++j)
        for (int i = -2; i <= 2; ++i)
          sum += weights[i + 2] * weights[j + 2] *
                 table(2 * along + i, 2 * across + j, of, by);
      return sum;
    }
  } // namespace

  GridInfluence GridInfluence::halved(const std::vector<unsigned int> &of,
                                      const SparseRows                &R) const
  {
    std::array<int, 2> least = nodes.places[of[0]], largest = least;
    for (const unsigned int node : of)
      for (unsigned int d = 0; d < 2; ++d)
        {
          least[d]   = std::min(least[d], nodes.places[node][d]);
          largest[d] = std::max(largest[d], nodes.places[node][d]);
        }
    NodesOnGrid half;
    for (unsigned int d = 0; d < 2; ++d)
      half.n[d] = (largest[d] - least[d]) / 2 + 1;
    for (const unsigned int node : of)
      half.places.push_back({{(nodes.places[node][0] - least[0]) / 2,
                              (nodes.places[node][1] - least[1]) / 2}});
    const unsigned int n = half_space.n_components();
    const std::size_t  N = nodes.places.size(), N_half = of.size();
    GridInfluence      result{
      half,
      InfluenceTable(half.n,
                     [&](const int along, const int across) {
                       DenseMatrix at(n, n);
                       for (unsigned int a = 0; a < n; ++a)
                         for (unsigned int b = 0; b < n; ++b)
                           at(a, b) =
                             halved_entry(half_space, along, across, a, b);
                       return at;
                     }),
      {},
      of_shapes,
      shape_is_normal,
      shape_is_no_strain};
    result.shapes = DenseMatrix::Zero(shapes.rows(), n * N_half);
    for (unsigned int c = 0; c < n; ++c)
      for (std::size_t k = 0; k < N_half; ++k)
        for (const auto &[i, weight] : R[k])
          result.shapes.col(c * N_half + k) += weight * shapes.col(c * N + i);
    return result;
  }

  DenseMatrix GridInfluence::dense() const
  {
    const std::size_t  N = nodes.places.size();
    const unsigned int n = half_space.n_components();
    DenseMatrix        W(n * N, n * N);
    for (unsigned int by = 0; by < n; ++by)
      for (std::size_t column = 0; column < N; ++column)
        for (unsigned int of = 0; of < n; ++of)
          for (std::size_t row = 0; row < N; ++row)
            W(of * N + row, by * N + column) =
              half_space(nodes.places[row][0] - nodes.places[column][0],
                         nodes.places[row][1] - nodes.places[column][1],
                         of,
                         by);
    W.noalias() += (shapes.transpose() * of_shapes) * shapes;
    return W;
  }

  GridCompliance::GridCompliance(GridInfluence of_nodes)
    : influence(std::move(of_nodes))
    , nodes(influence.nodes)
    , n_components(influence.half_space.n_components())
    , moved_shapes(influence.of_shapes.transpose() * influence.shapes)
    , half_space(nodes.n[0],
                 nodes.n[1],
                 n_components,
                 [&](const int          along,
                     const int          across,
                     const unsigned int of,
                     const unsigned int by) {
                   return influence.half_space(along, across, of, by);
                 })
  {}

  double GridCompliance::operator()(const std::size_t row,
                                    const std::size_t column) const
  {
    const std::size_t N = nodes.places.size();
    const auto &at = nodes.places[row % N], &by = nodes.places[column % N];
    return influence.half_space(at[0] - by[0],
                                at[1] - by[1],
                                row / N,
                                column / N) +
           moved_shapes.col(row).dot(influence.shapes.col(column));
  }

  std::vector<double> GridCompliance::on_grid(const double *at_nodes) const
  {
    std::vector<double> values(nodes.n[0] * nodes.n[1], 0.);
    for (std::size_t i = 0; i < nodes.places.size(); ++i)
      values[nodes.index(i)] = at_nodes[i];
    return values;
  }

  std::vector<double> GridCompliance::product(const std::vector<double> &forces,
                                              const unsigned int by_first,
                                              const unsigned int of_first,
                                              const unsigned int of_end,
                                              const bool strains_alone) const
  {
    const std::size_t   N = nodes.places.size(), n = nodes.n[0] * nodes.n[1];
    std::vector<double> on_places;
    for (std::size_t first = 0; first < forces.size(); first += N)
      {
        const auto part = on_grid(&forces[first]);
        on_places.insert(on_places.end(), part.begin(), part.end());
      }
    const std::vector<double> moved =
      half_space.multiply(on_places, by_first, of_first, of_end);
    const DenseMatrix  &shapes = influence.shapes;
    std::vector<double> result((of_end - of_first) * N);
    Eigen::VectorXd     moments =
      influence.of_shapes *
      (shapes.middleCols(by_first * N, forces.size()) * as_vector(forces));
    if (strains_alone)
      for (Eigen::Index k = 0; k < moments.size(); ++k)
        if (influence.shape_is_no_strain[k])
          moments[k] = 0.;
    as_vector(result) =
      shapes.middleCols(of_first * N, result.size()).transpose() * moments;
    for (unsigned int of = of_first; of < of_end; ++of)
      for (std::size_t i = 0; i < N; ++i)
        result[(of - of_first) * N + i] +=
          moved[(of - of_first) * n + nodes.index(i)];
    return result;
  }

  std::vector<double>
  GridCompliance::forces_for(const std::vector<double> &moved,
                             const unsigned int         component) const
  {
    const auto forces = half_space.divide(on_grid(moved.data()), component);
    std::vector<double> result;
    for (std::size_t i = 0; i < nodes.places.size(); ++i)
      result.push_back(forces[nodes.index(i)]);
    return result;
  }

  std::size_t GridCompliance::memory_consumption() const
  {
    return 2 * RollingContact::memory_consumption(moved_shapes) +
           influence.half_space.memory_consumption() +
           half_space.memory_consumption();
  }
} // namespace RollingContact
