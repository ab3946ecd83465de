#include <metis.h>

#include <rolling_contact/algebra/dissection.h>

#include <mutex>
#include <new>
#include <numeric>
#include <stdexcept>

namespace RollingContact
{
  namespace
  {
    /**
     * The graph of the mesh nodes: the matrix graph with the unknowns of a node
     * lumped together, both triangles, no diagonal.
     */
    void make_node_graph(const SymmetricSparseMatrix     &matrix,
                         const std::vector<unsigned int> &node_of_unknown,
                         std::vector<idx_t>              &starts,
                         std::vector<idx_t>              &neighbors)
    {
      const std::size_t n_nodes =
        node_of_unknown.empty() ? 0 : node_of_unknown.back() + 1;
      std::vector<std::vector<idx_t>> adjacency(n_nodes);
      for (std::size_t j = 0; j < matrix.size(); ++j)
        if (j == 0 || node_of_unknown[j] != node_of_unknown[j - 1])
          for (std::int64_t k = matrix.column_starts[j];
               k < matrix.column_starts[j + 1];
               ++k)
            {
              const idx_t a = node_of_unknown[j],
                          b = node_of_unknown[matrix.row_indices[k]];
              if (a != b && (adjacency[a].empty() || adjacency[a].back() != b))
                adjacency[a].push_back(b);
            }
      std::vector<idx_t> degree(n_nodes, 0);
      for (std::size_t a = 0; a < n_nodes; ++a)
        for (const idx_t b : adjacency[a])
          ++degree[a], ++degree[b];
      starts.assign(n_nodes + 1, 0);
      std::partial_sum(degree.begin(), degree.end(), starts.begin() + 1);
      neighbors.resize(starts.back());
      std::vector<idx_t> next(starts.begin(), starts.end() - 1);
      for (std::size_t a = 0; a < n_nodes; ++a)
        for (const idx_t b : adjacency[a])
          {
            neighbors[next[a]++] = b;
            neighbors[next[b]++] = a;
          }
    }

    /**
     * METIS draws from std::rand() and seeds it on entry: two bodies ordered at
     * the same time would take each other's numbers, and no two runs would
     * eliminate, and round, alike.
     */
    std::mutex random_numbers;
  } // namespace

  std::vector<std::int64_t>
  dissection_order(const SymmetricSparseMatrix     &matrix,
                   const std::vector<unsigned int> &node_of_unknown)
  {
    std::vector<idx_t> starts, neighbors;
    make_node_graph(matrix, node_of_unknown, starts, neighbors);
    idx_t              n_nodes = starts.size() - 1;
    std::vector<idx_t> order(n_nodes), position(n_nodes);
    idx_t              options[METIS_NOPTIONS];
    METIS_SetDefaultOptions(options);
    options[METIS_OPTION_NUMBERING] = 0;
    const std::lock_guard<std::mutex> alone(random_numbers);
    const int                         outcome = METIS_NodeND(&n_nodes,
                                     starts.data(),
                                     neighbors.data(),
                                     nullptr,
                                     options,
                                     order.data(),
                                     position.data());
    if (outcome == METIS_ERROR_MEMORY)
      throw std::bad_alloc();
    if (outcome != METIS_OK)
      throw std::runtime_error("METIS could not order the mesh nodes.");

    std::vector<std::int64_t> first_unknown(n_nodes + 1, matrix.size());
    for (std::size_t i = matrix.size(); i-- > 0;)
      first_unknown[node_of_unknown[i]] = i;
    std::vector<std::int64_t> permutation;
    permutation.reserve(matrix.size());
    for (const idx_t node : order)
      for (std::int64_t i = first_unknown[node]; i < first_unknown[node + 1];
           ++i)
        permutation.push_back(i);
    return permutation;
  }
} // namespace RollingContact
