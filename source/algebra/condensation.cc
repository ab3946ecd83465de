#include <cholmod.h>

#include <rolling_contact/algebra/condensation.h>
#include <rolling_contact/algebra/supernodes.h>

#include <algorithm>
#include <numeric>

namespace RollingContact
{
  void CondensedColumns::add_product(const double               scale,
                                     const std::vector<double> &r,
                                     std::vector<double>       &z) const
  {
    std::vector<double> sorted(column_order.size());
    for (std::size_t c = 0; c < sorted.size(); ++c)
      sorted[c] = r[column_order[c]];
    for (const Block &block : blocks)
      {
        const int    n_rows = block.n_rows, n_columns = block.n_columns;
        const int    stride = 1;
        const double one    = 1.;
        dgemv_("N",
               &n_rows,
               &n_columns,
               &scale,
               block.values.data(),
               &n_rows,
               sorted.data() + block.first_column,
               &stride,
               &one,
               z.data() + block.first_row,
               &stride);
      }
  }

  std::vector<double>
  CondensedColumns::transposed_product(const std::vector<double> &z) const
  {
    std::vector<double> sorted(column_order.size(), 0.), result(sorted.size());
    for (const Block &block : blocks)
      {
        const int    n_rows = block.n_rows, n_columns = block.n_columns;
        const int    stride = 1;
        const double one    = 1.;
        dgemv_("T",
               &n_rows,
               &n_columns,
               &one,
               block.values.data(),
               &n_rows,
               z.data() + block.first_row,
               &stride,
               &one,
               sorted.data() + block.first_column,
               &stride);
      }
    for (std::size_t c = 0; c < sorted.size(); ++c)
      result[column_order[c]] = sorted[c];
    return result;
  }

  std::size_t CondensedColumns::memory_consumption() const
  {
    std::size_t bytes = column_order.capacity() * sizeof(std::int64_t);
    for (const Block &block : blocks)
      bytes += sizeof(Block) + block.values.capacity() * sizeof(double);
    return bytes;
  }

  namespace
  {
    using Index = std::int64_t;

    /**
     * The supernodes, and which of them a row is in.
     */
    class SupernodesOfRows : public Supernodes
    {
    public:
      explicit SupernodesOfRows(const cholmod_factor &L)
        : Supernodes(L)
        , of_row(L.n)
      {
        for (Index k = 0; k < size(); ++k)
          std::fill_n(of_row.begin() + first_row(k), n_diagonal_rows(k), k);
      }

      Index supernode_of_row(const Index row) const
      {
        return of_row[row];
      }

    private:
      std::vector<Index> of_row;
    };

    using Block = CondensedColumns::Block;

    /**
     * The columns of E in the permuted matrix, sorted by their first row.
     */
    struct SortedColumns
    {
      using Entry = std::pair<Index, double>; ///< row and value

      SortedColumns(const cholmod_factor &L, const SparseRows &loads)
        : order(loads.size())
        , columns(loads.size())
      {
        std::vector<Index> position(L.n);
        const Index       *permutation = static_cast<const Index *>(L.Perm);
        for (std::size_t i = 0; i < L.n; ++i)
          position[permutation[i]] = i;
        std::vector<Index> first_row(loads.size(), L.n);
        for (unsigned int c = 0; c < loads.size(); ++c)
          for (const auto &entry : loads[c])
            first_row[c] = std::min(first_row[c], position[entry.first]);
        std::iota(order.begin(), order.end(), 0);
        std::sort(order.begin(),
                  order.end(),
                  [&](const Index a, const Index b) {
                    return first_row[a] < first_row[b];
                  });
        for (std::size_t c = 0; c < order.size(); ++c)
          for (const auto &[unknown, value] : loads[order[c]])
            columns[c].emplace_back(position[unknown], value);
      }

      std::vector<Index>              order;
      std::vector<std::vector<Entry>> columns;
    };

    /**
     * The supernodes on the elimination-tree paths of the columns, each with
     * the range of columns alive in it; unreached blocks have no columns.
     */
    std::vector<Block> reach(const SupernodesOfRows &supernodes,
                             const SortedColumns    &sorted)
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
      for (Index c = 0; c < static_cast<Index>(sorted.columns.size()); ++c)
        for (const auto &entry : sorted.columns[c])
          widen(blocks[supernodes.supernode_of_row(entry.first)], c, c + 1);
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

    void allocate(Block &block)
    {
      if (block.values.empty())
        block.values.resize(block.n_rows * block.n_columns, 0.);
    }

    /**
     * Subtract the share of a finished block, in @p below, from the blocks of
     * its ancestors.
     */
    void subtract_from_ancestors(const SupernodesOfRows    &supernodes,
                                 const Index                k,
                                 const std::vector<double> &below,
                                 std::vector<Block>        &blocks)
    {
      const Block &block     = blocks[k];
      const int    n_columns = block.n_columns,
                n_below      = supernodes.n_rows(k) - block.n_rows;
      const Index *rows      = supernodes.rows_below(k);
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
                below.data() + static_cast<std::size_t>(c) * n_below;
              for (int i = begin; i < end; ++i)
                to[rows[i] - ancestor.first_row] -= from[i];
            }
        }
    }

    /**
     * Finish the block of supernode @p k, Y_k = L_kk^-1 Y_k, and subtract its
     * share from the blocks of its ancestors.
     */
    void eliminate(const SupernodesOfRows &supernodes,
                   const Index             k,
                   std::vector<Block>     &blocks,
                   std::vector<double>    &buffer)
    {
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
      subtract_from_ancestors(supernodes, k, buffer, blocks);
    }

    void put_entries(const SupernodesOfRows &supernodes,
                     const SortedColumns    &sorted,
                     std::vector<Block>     &blocks)
    {
      for (std::size_t c = 0; c < sorted.columns.size(); ++c)
        for (const auto &[row, value] : sorted.columns[c])
          {
            Block &block = blocks[supernodes.supernode_of_row(row)];
            allocate(block);
            block.values[row - block.first_row +
                         (c - block.first_column) * block.n_rows] += value;
          }
    }

    /**
     * Add Y_k^T Y_k to the lower triangle of W.
     */
    void add_product(const Block &block, DenseMatrix &W)
    {
      const int n_columns = block.n_columns, n_rows = block.n_rows,
                leading = W.rows();
      const double one  = 1.;
      dsyrk_("L",
             "T",
             &n_columns,
             &n_rows,
             &one,
             block.values.data(),
             &n_rows,
             &one,
             &W(block.first_column, block.first_column),
             &leading);
    }

    /**
     * A lower triangle, row and column k of which belong to order[k], as a full
     * matrix.
     */
    DenseMatrix unsorted(const DenseMatrix        &lower,
                         const std::vector<Index> &order)
    {
      const std::size_t n = order.size();
      DenseMatrix       W = DenseMatrix::Zero(n, n);
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = j; i < n; ++i)
          W(order[i], order[j]) = W(order[j], order[i]) = lower(i, j);
      return W;
    }
  } // namespace

  DenseMatrix condensed_compliance(const cholmod_factor &L,
                                   const SparseRows     &loads,
                                   CondensedColumns     *columns)
  {
    const SupernodesOfRows supernodes(L);
    SortedColumns          sorted(L, loads);
    std::vector<Block>     blocks = reach(supernodes, sorted);
    DenseMatrix            W = DenseMatrix::Zero(loads.size(), loads.size());
    std::vector<double>    buffer;
    put_entries(supernodes, sorted, blocks);
    for (Index k = 0; k < supernodes.size(); ++k)
      if (blocks[k].n_columns > 0)
        {
          eliminate(supernodes, k, blocks, buffer);
          add_product(blocks[k], W);
          if (columns == nullptr)
            blocks[k].values = std::vector<double>();
        }
    W = unsorted(W, sorted.order);
    if (columns != nullptr)
      {
        const auto is_empty = [](const Block &block) {
          return block.n_columns == 0;
        };
        blocks.erase(std::remove_if(blocks.begin(), blocks.end(), is_empty),
                     blocks.end());
        columns->blocks       = std::move(blocks);
        columns->column_order = std::move(sorted.order);
      }
    return W;
  }
} // namespace RollingContact
