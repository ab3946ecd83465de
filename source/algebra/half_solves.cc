#include <cholmod.h>

#include <rolling_contact/algebra/half_solves.h>
#include <rolling_contact/algebra/supernodes.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#define ALWAYS_INLINE inline __attribute__((always_inline))

namespace RollingContact
{
  namespace
  {
    using Index = Supernodes::Index;

    /**
     * Four numbers in a row of memory, in one register or two.
     */
    using Pack = double __attribute__((vector_size(32), aligned(8), may_alias));

    ALWAYS_INLINE Pack &pack(double *x)
    {
      return *reinterpret_cast<Pack *>(x);
    }

    ALWAYS_INLINE const Pack &pack(const double *x)
    {
      return *reinterpret_cast<const Pack *>(x);
    }

    template <std::size_t n_columns>
    using Blocks = std::array<std::vector<double> *, n_columns>;

    /**
     * A supernode with its part of the columns: rows of the diagonal, then
     * those below, then three of padding. @p n_padded rows may be worked on:
     * behind its column L has another one, but for the last supernode.
     */
    template <std::size_t n_columns>
    struct Front
    {
      const double                   *L;
      Index                           n_rows, n_padded, n_diagonal;
      std::array<double *, n_columns> y;
    };

    constexpr Index padding = 3;

    /**
     * Some columns of a front.
     */
    template <int width>
    struct Panel
    {
      ALWAYS_INLINE
      Panel(const double *L, const Index n_rows, const Index first)
      {
        for (int c = 0; c < width; ++c)
          column[c] = L + (first + c) * n_rows;
        for (int c = 0; c < width; ++c)
          inverse[c] = 1. / column[c][first + c];
      }

      const double *column[width];
      double        inverse[width]; ///< of the diagonal
    };

    /**
     * Ask for the memory of the columns that come after (or, @p backward,
     * before) those of a panel, as much as the panel has. The processor sees
     * by itself what comes in long columns, but not in the many short ones.
     */
    template <int width>
    ALWAYS_INLINE void
    prefetch(const Panel<width> &panel, const Index n_rows, const bool backward)
    {
      constexpr Index line = 64, distance = 4096;
      const char     *ahead = reinterpret_cast<const char *>(panel.column[0]);
      ahead += backward ? -distance : distance;
      const Index n_bytes = width * n_rows * Index(sizeof(double));
      for (Index i = 0; i < n_bytes; i += line)
        __builtin_prefetch(ahead + i);
    }

    /**
     * Eliminate @p width columns of a supernode, from @p first on.
     */
    template <int width, std::size_t n_columns>
    ALWAYS_INLINE void eliminate(const Front<n_columns> &front,
                                 const Index             first)
    {
      const Panel<width> panel(front.L, front.n_rows, first);
      prefetch(panel, front.n_rows, false);
      double a[n_columns][width];
      for (std::size_t r = 0; r < n_columns; ++r)
        for (int c = 0; c < width; ++c)
          {
            double value = front.y[r][first + c];
            for (int d = 0; d < c; ++d)
              value -= panel.column[d][first + c] * a[r][d];
            front.y[r][first + c] = a[r][c] = value * panel.inverse[c];
          }
      Index i = first + width;
      for (; i + 4 <= front.n_padded; i += 4)
        for (std::size_t r = 0; r < n_columns; ++r)
          {
            Pack sum = pack(panel.column[0] + i) * a[r][0];
            for (int c = 1; c < width; ++c)
              sum += pack(panel.column[c] + i) * a[r][c];
            pack(front.y[r] + i) -= sum;
          }
      for (; i < front.n_rows; ++i)
        for (std::size_t r = 0; r < n_columns; ++r)
          {
            double sum = panel.column[0][i] * a[r][0];
            for (int c = 1; c < width; ++c)
              sum += panel.column[c][i] * a[r][c];
            front.y[r][i] -= sum;
          }
    }

    /**
     * Substitute back into @p width columns of a supernode, from @p first on.
     */
    template <int width, std::size_t n_columns>
    ALWAYS_INLINE void substitute(const Front<n_columns> &front,
                                  const Index             first)
    {
      const Panel<width> panel(front.L, front.n_rows, first);
      prefetch(panel, front.n_rows, true);
      Pack sums[n_columns][width];
      for (std::size_t r = 0; r < n_columns; ++r)
        for (int c = 0; c < width; ++c)
          sums[r][c] = Pack{0., 0., 0., 0.};
      Index i = first + width;
      for (; i + 4 <= front.n_padded; i += 4)
        for (int c = 0; c < width; ++c)
          for (std::size_t r = 0; r < n_columns; ++r)
            sums[r][c] += pack(panel.column[c] + i) * pack(front.y[r] + i);
      for (std::size_t r = 0; r < n_columns; ++r)
        {
          double value[width];
          for (int c = 0; c < width; ++c)
            {
              double sum = (sums[r][c][0] + sums[r][c][1]) +
                           (sums[r][c][2] + sums[r][c][3]);
              for (Index row = i; row < front.n_rows; ++row)
                sum += panel.column[c][row] * front.y[r][row];
              value[c] = front.y[r][first + c] - sum;
            }
          for (int c = width - 1; c >= 0; --c)
            {
              for (int d = c + 1; d < width; ++d)
                value[c] -= panel.column[c][first + d] * value[d];
              front.y[r][first + c] = value[c] *= panel.inverse[c];
            }
        }
    }

    template <std::size_t n_columns>
    ALWAYS_INLINE void eliminate_all(const Front<n_columns> &front)
    {
      Index first = 0;
      for (; first + 4 <= front.n_diagonal; first += 4)
        eliminate<4>(front, first);
      if (front.n_diagonal - first == 3)
        eliminate<3>(front, first);
      else if (front.n_diagonal - first == 2)
        eliminate<2>(front, first);
      else if (front.n_diagonal - first == 1)
        eliminate<1>(front, first);
    }

    template <std::size_t n_columns>
    ALWAYS_INLINE void substitute_all(const Front<n_columns> &front)
    {
      Index first = front.n_diagonal / 4 * 4;
      if (front.n_diagonal - first == 3)
        substitute<3>(front, first);
      else if (front.n_diagonal - first == 2)
        substitute<2>(front, first);
      else if (front.n_diagonal - first == 1)
        substitute<1>(front, first);
      for (first -= 4; first >= 0; first -= 4)
        substitute<4>(front, first);
    }

    /**
     * The kernels for any processor of this family, and for those with AVX2 and
     * FMA, which have twice the width.
     */
    template <std::size_t n_columns>
    struct Kernels
    {
      using Kernel = void (*)(const Front<n_columns> &);

      static void forward(const Front<n_columns> &front)
      {
        eliminate_all(front);
      }

      static void backward(const Front<n_columns> &front)
      {
        substitute_all(front);
      }

#if defined(__x86_64__)
      __attribute__((target("avx2,fma"))) static void
      wide_forward(const Front<n_columns> &front)
      {
        eliminate_all(front);
      }

      __attribute__((target("avx2,fma"))) static void
      wide_backward(const Front<n_columns> &front)
      {
        substitute_all(front);
      }

      static bool are_wide()
      {
        return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
      }

      const Kernel eliminate  = are_wide() ? wide_forward : forward;
      const Kernel substitute = are_wide() ? wide_backward : backward;
#else
      const Kernel eliminate = forward, substitute = backward;
#endif
    };

    template <std::size_t n_columns>
    Front<n_columns> front_of(const Supernodes    &supernodes,
                              const Index          k,
                              std::vector<double> &workspace)
    {
      const Index      n_rows  = supernodes.n_rows(k);
      const bool       is_last = k + 1 == supernodes.size();
      Front<n_columns> front{supernodes.values(k),
                             n_rows,
                             n_rows + (is_last ? 0 : padding),
                             supernodes.n_diagonal_rows(k),
                             {}};
      for (std::size_t r = 0; r < n_columns; ++r)
        front.y[r] = workspace.data() + r * (workspace.size() / n_columns);
      return front;
    }

    template <std::size_t n_columns>
    void forward(const cholmod_factor    &L,
                 const Blocks<n_columns> &x,
                 std::vector<double>     &workspace)
    {
      const Supernodes         supernodes(L);
      const Kernels<n_columns> kernels;
      workspace.resize(n_columns * (supernodes.max_n_rows() + padding));
      for (Index k = 0; k < supernodes.size(); ++k)
        {
          const auto   front   = front_of<n_columns>(supernodes, k, workspace);
          const Index *below   = supernodes.rows_below(k);
          const Index  n_below = front.n_rows - front.n_diagonal;
          for (std::size_t r = 0; r < n_columns; ++r)
            {
              std::copy_n(x[r]->data() + supernodes.first_row(k),
                          front.n_diagonal,
                          front.y[r]);
              std::fill_n(front.y[r] + front.n_diagonal, n_below + padding, 0.);
            }
          kernels.eliminate(front);
          for (std::size_t r = 0; r < n_columns; ++r)
            {
              std::copy_n(front.y[r],
                          front.n_diagonal,
                          x[r]->data() + supernodes.first_row(k));
              double       *to   = x[r]->data();
              const double *from = front.y[r] + front.n_diagonal;
              for (Index i = 0; i < n_below; ++i)
                to[below[i]] += from[i];
            }
        }
    }

    template <std::size_t n_columns>
    void backward(const cholmod_factor    &L,
                  const Blocks<n_columns> &x,
                  std::vector<double>     &workspace)
    {
      const Supernodes         supernodes(L);
      const Kernels<n_columns> kernels;
      workspace.resize(n_columns * (supernodes.max_n_rows() + padding));
      for (Index k = supernodes.size() - 1; k >= 0; --k)
        {
          const auto   front   = front_of<n_columns>(supernodes, k, workspace);
          const Index *below   = supernodes.rows_below(k);
          const Index  n_below = front.n_rows - front.n_diagonal;
          for (std::size_t r = 0; r < n_columns; ++r)
            {
              double *own = x[r]->data() + supernodes.first_row(k);
              std::copy_n(own, front.n_diagonal, front.y[r]);
              const double *from = x[r]->data();
              double       *to   = front.y[r] + front.n_diagonal;
              for (Index i = 0; i < n_below; ++i)
                to[i] = from[below[i]];
              std::fill_n(to + n_below, padding, 0.);
            }
          kernels.substitute(front);
          for (std::size_t r = 0; r < n_columns; ++r)
            std::copy_n(front.y[r],
                        front.n_diagonal,
                        x[r]->data() + supernodes.first_row(k));
        }
    }

    void require_one_or_two(const std::vector<std::vector<double> *> &x)
    {
      if (x.empty() || x.size() > 2)
        throw std::logic_error("Half-solves take one or two columns.");
    }
  } // namespace

  void solve_forward(const cholmod_factor                     &L,
                     const std::vector<std::vector<double> *> &x,
                     std::vector<double>                      &workspace)
  {
    require_one_or_two(x);
    if (x.size() == 1)
      forward<1>(L, {x[0]}, workspace);
    else
      forward<2>(L, {x[0], x[1]}, workspace);
  }

  void solve_backward(const cholmod_factor                     &L,
                      const std::vector<std::vector<double> *> &x,
                      std::vector<double>                      &workspace)
  {
    require_one_or_two(x);
    if (x.size() == 1)
      backward<1>(L, {x[0]}, workspace);
    else
      backward<2>(L, {x[0], x[1]}, workspace);
  }
} // namespace RollingContact
