#include <cholmod.h>
#include <metis.h>

#include <rolling_contact/base/blas.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/elasticity/factorisation.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <string>

namespace RollingContact
{
  namespace
  {
    using Index = std::int64_t;
    static_assert(sizeof(Index) == sizeof(SuiteSparse_long),
                  "CHOLMOD's long interface works on 64-bit indices.");

    double
    seconds_since(const std::chrono::steady_clock::time_point start)
    {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() -
                                           start)
        .count();
    }



    /**
     * The graph of the mesh nodes: the matrix graph with the unknowns of a node
     * lumped together, both triangles, no diagonal.
     */
    void
    make_node_graph(const SymmetricSparseMatrix     &matrix,
                    const std::vector<unsigned int> &node_of_unknown,
                    std::vector<idx_t>              &starts,
                    std::vector<idx_t>              &neighbors)
    {
      const std::size_t n_nodes =
        node_of_unknown.empty() ? 0 : node_of_unknown.back() + 1;
      std::vector<std::vector<idx_t>> adjacency(n_nodes);
      for (std::size_t j = 0; j < matrix.size(); ++j)
        if (j == 0 || node_of_unknown[j] != node_of_unknown[j - 1])
          for (Index k = matrix.column_starts[j];
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
     * Fill-reducing order of the unknowns: nested dissection of the node graph,
     * the unknowns of a node kept together.
     */
    std::vector<Index>
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
      if (METIS_NodeND(&n_nodes,
                       starts.data(),
                       neighbors.data(),
                       nullptr,
                       options,
                       order.data(),
                       position.data()) != METIS_OK)
        throw std::runtime_error("METIS could not order the mesh nodes.");

      std::vector<Index> first_unknown(n_nodes + 1, matrix.size());
      for (std::size_t i = matrix.size(); i-- > 0;)
        first_unknown[node_of_unknown[i]] = i;
      std::vector<Index> permutation;
      permutation.reserve(matrix.size());
      for (const idx_t node : order)
        for (Index i = first_unknown[node]; i < first_unknown[node + 1]; ++i)
          permutation.push_back(i);
      return permutation;
    }
  } // namespace



  std::size_t
  CondensedColumns::memory_consumption() const
  {
    std::size_t bytes = column_order.capacity() * sizeof(std::int64_t);
    for (const Block &block : blocks)
      bytes += sizeof(Block) + block.values.capacity() * sizeof(double);
    return bytes;
  }



  struct Factorisation::Implementation
  {
    cholmod_common        common;
    cholmod_factor       *L = nullptr;
    SymmetricSparseMatrix matrix;
    mutable Size          size;

    Implementation()
    {
      cholmod_l_start(&common);
      common.supernodal         = CHOLMOD_SUPERNODAL;
      common.nmethods           = 1;
      common.method[0].ordering = CHOLMOD_GIVEN;
      common.postorder          = 1;
      common.print              = 0;
    }

    ~Implementation()
    {
      cholmod_l_free_factor(&L, &common);
      cholmod_l_finish(&common);
    }

    cholmod_sparse
    view()
    {
      cholmod_sparse A{};
      A.nrow = A.ncol = matrix.size();
      A.nzmax         = matrix.values.size();
      A.p             = matrix.column_starts.data();
      A.i             = matrix.row_indices.data();
      A.x             = matrix.values.data();
      A.stype         = -1;
      A.itype         = CHOLMOD_LONG;
      A.xtype         = CHOLMOD_REAL;
      A.dtype         = CHOLMOD_DOUBLE;
      A.sorted        = 1;
      A.packed        = 1;
      return A;
    }
  };



  Factorisation::Factorisation(Factorisation &&) noexcept = default;

  Factorisation::~Factorisation() = default;



  Factorisation::Factorisation(SymmetricSparseMatrix            matrix,
                               const std::vector<unsigned int> &node_of_unknown)
    : implementation(std::make_unique<Implementation>())
  {
    const auto start = std::chrono::steady_clock::now();
    auto      &own   = *implementation;
    own.matrix       = std::move(matrix);
    std::vector<Index> permutation =
      dissection_order(own.matrix, node_of_unknown);
    cholmod_sparse A = own.view();
    own.L            = cholmod_l_analyze_p(&A,
                                reinterpret_cast<SuiteSparse_long *>(
                                  permutation.data()),
                                nullptr,
                                0,
                                &own.common);
    if (own.L == nullptr)
      throw std::runtime_error("CHOLMOD could not analyse the matrix (status " +
                               std::to_string(own.common.status) + ").");
    own.size.n_unknowns   = own.matrix.size();
    own.size.n_entries    = own.L->is_super ? own.L->xsize : own.common.lnz;
    own.size.n_operations = own.common.fl;
    own.size.analysis_s   = seconds_since(start);
  }



  void
  Factorisation::factorise()
  {
    const auto start = std::chrono::steady_clock::now();
    auto      &own   = *implementation;
    if (own.matrix.size() == 0)
      return;
    cholmod_sparse A = own.view();
    cholmod_l_factorize(&A, own.L, &own.common);
    if (own.common.status == CHOLMOD_OUT_OF_MEMORY)
      throw InputError("The factor needs " +
                       std::to_string(size().memory_consumption() >> 20) +
                       " MB, more than this machine has free: take fewer "
                       "elements.");
    if (own.common.status != CHOLMOD_OK || own.L->minor < own.L->n)
      throw ConvergenceError(
        "The stiffness matrix is not positive definite (column " +
        std::to_string(own.L->minor) +
        "): the body is not held, or the material is unstable.");
    own.matrix        = SymmetricSparseMatrix();
    own.size.factor_s = seconds_since(start);
  }



  std::vector<double>
  Factorisation::solve(const std::vector<double> &right_hand_side) const
  {
    auto               &own = *implementation;
    cholmod_dense       b{};
    std::vector<double> values = right_hand_side;
    b.nrow = b.d = b.nzmax = values.size();
    b.ncol                 = 1;
    b.x                    = values.data();
    b.xtype                = CHOLMOD_REAL;
    b.dtype                = CHOLMOD_DOUBLE;
    cholmod_dense *solution =
      cholmod_l_solve(CHOLMOD_A, own.L, &b, &own.common);
    if (solution == nullptr)
      throw std::runtime_error("CHOLMOD could not solve.");
    const double *begin = static_cast<const double *>(solution->x);
    values.assign(begin, begin + right_hand_side.size());
    cholmod_l_free_dense(&solution, &own.common);
    return values;
  }



  namespace
  {
    /**
     * Read access to CHOLMOD's supernodes.
     */
    class Supernodes
    {
    public:
      explicit Supernodes(const cholmod_factor &L)
        : super(static_cast<const Index *>(L.super))
        , pi(static_cast<const Index *>(L.pi))
        , px(static_cast<const Index *>(L.px))
        , s(static_cast<const Index *>(L.s))
        , x(static_cast<const double *>(L.x))
        , of_row(L.n)
        , n_supernodes(L.nsuper)
      {
        for (Index k = 0; k < n_supernodes; ++k)
          std::fill(of_row.begin() + super[k],
                    of_row.begin() + super[k + 1],
                    k);
      }

      Index
      size() const
      {
        return n_supernodes;
      }

      Index
      first_row(const Index k) const
      {
        return super[k];
      }

      int
      n_diagonal_rows(const Index k) const
      {
        return super[k + 1] - super[k];
      }

      int
      n_rows(const Index k) const
      {
        return pi[k + 1] - pi[k];
      }

      const Index *
      rows_below(const Index k) const
      {
        return s + pi[k] + n_diagonal_rows(k);
      }

      const double *
      values(const Index k) const
      {
        return x + px[k];
      }

      Index
      supernode_of_row(const Index row) const
      {
        return of_row[row];
      }

    private:
      const Index       *super, *pi, *px, *s;
      const double      *x;
      std::vector<Index> of_row;
      Index              n_supernodes;
    };



    using Block = CondensedColumns::Block;

    /**
     * The supernodes on the elimination-tree paths of the sorted rows, each
     * with the range of columns alive in it; unreached blocks have no columns.
     */
    std::vector<Block>
    reach(const Supernodes &supernodes, const std::vector<Index> &sorted_rows)
    {
      std::vector<Block> blocks(supernodes.size());
      const auto widen = [](Block &block, const Index begin, const Index end) {
        const Index last =
          std::max(block.n_columns > 0 ? block.first_column + block.n_columns
                                       : end,
                   end);
        block.first_column =
          block.n_columns > 0 ? std::min(block.first_column, begin) : begin;
        block.n_columns = last - block.first_column;
      };
      for (Index c = 0; c < static_cast<Index>(sorted_rows.size()); ++c)
        widen(blocks[supernodes.supernode_of_row(sorted_rows[c])], c, c + 1);
      for (Index k = 0; k < supernodes.size(); ++k)
        {
          Block &block    = blocks[k];
          block.first_row = supernodes.first_row(k);
          block.n_rows    = supernodes.n_diagonal_rows(k);
          if (block.n_columns > 0 && supernodes.n_rows(k) > block.n_rows)
            widen(
              blocks[supernodes.supernode_of_row(*supernodes.rows_below(k))],
              block.first_column,
              block.first_column + block.n_columns);
        }
      return blocks;
    }



    /**
     * Finish the block of supernode @p k, Y_k = L_kk^-1 Y_k, and subtract its
     * share from the blocks of its ancestors.
     */
    void
    eliminate(const Supernodes    &supernodes,
              const Index          k,
              std::vector<Block>  &blocks,
              std::vector<double> &buffer)
    {
      const auto allocate = [](Block &block) {
        if (block.values.empty())
          block.values.resize(block.n_rows * block.n_columns, 0.);
      };
      Block    &block      = blocks[k];
      const int n_diagonal = block.n_rows, n_columns = block.n_columns,
                n_rows = supernodes.n_rows(k), n_below = n_rows - n_diagonal;
      const double one = 1., zero = 0.;
      allocate(block);
      dtrsm_("L",
             "L",
             "N",
             "N",
             &n_diagonal,
             &n_columns,
             &one,
             supernodes.values(k),
             &n_rows,
             block.values.data(),
             &n_diagonal);
      if (n_below == 0)
        return;
      buffer.resize(static_cast<std::size_t>(n_below) * n_columns);
      dgemm_("N",
             "N",
             &n_below,
             &n_columns,
             &n_diagonal,
             &one,
             supernodes.values(k) + n_diagonal,
             &n_rows,
             block.values.data(),
             &n_diagonal,
             &zero,
             buffer.data(),
             &n_below);
      const Index *rows = supernodes.rows_below(k);
      for (int begin = 0, end; begin < n_below; begin = end)
        {
          const Index target = supernodes.supernode_of_row(rows[begin]);
          for (end = begin + 1; end < n_below && supernodes.supernode_of_row(
                                                   rows[end]) == target;)
            ++end;
          Block &ancestor = blocks[target];
          allocate(ancestor);
          for (int c = 0; c < n_columns; ++c)
            {
              double *to = ancestor.values.data() +
                           (block.first_column - ancestor.first_column + c) *
                             ancestor.n_rows;
              const double *from =
                buffer.data() + static_cast<std::size_t>(c) * n_below;
              for (int i = begin; i < end; ++i)
                to[rows[i] - ancestor.first_row] -= from[i];
            }
        }
    }
  } // namespace



  DenseMatrix
  Factorisation::condense(const std::vector<std::size_t> &unknowns,
                          CondensedColumns               *columns) const
  {
    const auto        start = std::chrono::steady_clock::now();
    const auto       &own   = *implementation;
    const Supernodes  supernodes(*own.L);
    const std::size_t n = unknowns.size();

    std::vector<Index> position(own.L->n);
    const Index       *permutation = static_cast<const Index *>(own.L->Perm);
    for (std::size_t i = 0; i < own.L->n; ++i)
      position[permutation[i]] = i;
    std::vector<Index> order(n), sorted_rows(n);
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](const Index a, const Index b) {
      return position[unknowns[a]] < position[unknowns[b]];
    });
    for (std::size_t c = 0; c < n; ++c)
      sorted_rows[c] = position[unknowns[order[c]]];

    std::vector<Block> blocks = reach(supernodes, sorted_rows);
    for (std::size_t c = 0; c < n; ++c)
      {
        Block &block = blocks[supernodes.supernode_of_row(sorted_rows[c])];
        if (block.values.empty())
          block.values.resize(block.n_rows * block.n_columns, 0.);
        block.values[sorted_rows[c] - block.first_row +
                     (c - block.first_column) * block.n_rows] = 1.;
      }

    DenseMatrix         sorted_W(n, n);
    std::vector<double> buffer;
    const int           leading = n;
    const double        one     = 1.;
    for (Index k = 0; k < supernodes.size(); ++k)
      if (blocks[k].n_columns > 0)
        {
          eliminate(supernodes, k, blocks, buffer);
          Block    &block     = blocks[k];
          const int n_columns = block.n_columns, n_rows = block.n_rows;
          dsyrk_("L",
                 "T",
                 &n_columns,
                 &n_rows,
                 &one,
                 block.values.data(),
                 &n_rows,
                 &one,
                 &sorted_W(block.first_column, block.first_column),
                 &leading);
          if (columns == nullptr)
            block.values = std::vector<double>();
        }

    DenseMatrix W(n, n);
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = j; i < n; ++i)
        W(order[i], order[j]) = W(order[j], order[i]) = sorted_W(i, j);
    if (columns != nullptr)
      {
        blocks.erase(std::remove_if(blocks.begin(),
                                    blocks.end(),
                                    [](const Block &block) {
                                      return block.n_columns == 0;
                                    }),
                     blocks.end());
        columns->blocks       = std::move(blocks);
        columns->column_order = std::move(order);
      }
    own.size.condensation_s = seconds_since(start);
    return W;
  }



  const Factorisation::Size &
  Factorisation::size() const
  {
    return implementation->size;
  }
} // namespace RollingContact
