#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <rolling_contact/algebra/adaptive_integral.h>

#include <algorithm>
#include <vector>

namespace RollingContact
{
  namespace
  {
    using Function = std::function<Eigen::ArrayXd(const double)>;

    struct Cell
    {
      double         begin, end;
      Eigen::ArrayXd value, error;
    };

    Cell cell_of(const Function &f, const double begin, const double end)
    {
      using Kronrod = boost::math::quadrature::gauss_kronrod<double, 15>;
      using Gauss   = boost::math::quadrature::gauss<double, 7>;
      const double         middle = (begin + end) / 2, half = (end - begin) / 2;
      const Eigen::ArrayXd at_middle = f(middle);
      Eigen::ArrayXd       fine      = Kronrod::weights()[0] * at_middle,
                     coarse          = Gauss::weights()[0] * at_middle;
      for (std::size_t i = 1; i < Kronrod::abscissa().size(); ++i)
        {
          const double         x    = half * Kronrod::abscissa()[i];
          const Eigen::ArrayXd both = f(middle - x) + f(middle + x);
          fine += Kronrod::weights()[i] * both;
          if (i % 2 == 0)
            coarse += Gauss::weights()[i / 2] * both;
        }
      return {begin, end, half * fine, half * (fine - coarse).abs()};
    }
  } // namespace

  AdaptiveIntegral adaptive_integral(const Function   &f,
                                     const double      a,
                                     const double      b,
                                     const std::size_t n_watched,
                                     const double      tolerance,
                                     const std::size_t n_cells,
                                     const std::size_t n_most)
  {
    std::vector<Cell> cells;
    for (std::size_t i = 0; i < n_cells; ++i)
      cells.push_back(
        cell_of(f, a + (b - a) * i / n_cells, a + (b - a) * (i + 1) / n_cells));
    AdaptiveIntegral result;
    for (;;)
      {
        result.value = result.error =
          Eigen::ArrayXd::Zero(cells[0].value.size());
        for (const Cell &cell : cells)
          {
            result.value += cell.value;
            result.error += cell.error;
          }
        const Eigen::ArrayXd allowed =
          tolerance * result.value.head(n_watched).abs();
        result.converged = (result.error.head(n_watched) <= allowed).all();
        if (result.converged || cells.size() >= n_most)
          break;
        const auto share = [&](const Cell &cell) {
          double largest = 0.;
          for (std::size_t i = 0; i < n_watched; ++i)
            if (result.error[i] > allowed[i])
              largest = std::max(largest, cell.error[i] / allowed[i]);
          return largest;
        };
        const auto   worst = std::max_element(cells.begin(),
                                            cells.end(),
                                            [&](const Cell &x, const Cell &y) {
                                              return share(x) < share(y);
                                            });
        const double end = worst->end, middle = (worst->begin + end) / 2;
        *worst = cell_of(f, worst->begin, middle);
        cells.push_back(cell_of(f, middle, end));
      }
    return result;
  }
} // namespace RollingContact
