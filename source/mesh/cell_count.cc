#include <rolling_contact/mesh/cell_count.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /** A box of the chart, x from the contact point, and the cells it would be
     * divided into. */
    template <int dim>
    class Divider
    {
    public:
      Divider(const Grading<dim> &grading, const double enough)
        : grading(grading)
        , enough(enough)
      {}

      void divide(const Point<dim> &lower, const Point<dim> &upper)
      {
        if (n_cells > enough)
          return;
        if (!grading.refine(lower, upper))
          {
            ++n_cells;
            return;
          }
        for (unsigned int child = 0; child < (1u << dim); ++child)
          {
            Point<dim> begin = lower, end = upper;
            for (int d = 0; d < dim; ++d)
              ((child >> d) & 1 ? begin : end)[d] = (lower[d] + upper[d]) / 2;
            divide(begin, end);
          }
      }

      double n_cells = 0.;

    private:
      const Grading<dim> &grading;
      const double        enough;
    };
  } // namespace

  template <int dim>
  double count_cells(const std::array<std::vector<double>, dim> &breaks,
                     const BodyChart<dim>                       &chart,
                     const Grading<dim>                         &grading,
                     const double                                enough)
  {
    Divider<dim> divider(grading, enough);
    std::size_t  total = 1;
    for (const auto &points : breaks)
      total *= points.size() - 1;
    for (std::size_t k = 0; k < total && divider.n_cells <= enough; ++k)
      {
        Point<dim>  lower, upper;
        std::size_t rest = k;
        for (int d = 0; d < dim; ++d)
          {
            const std::size_t n = breaks[d].size() - 1, i = rest % n;
            rest /= n;
            lower[d] = breaks[d][i];
            upper[d] = breaks[d][i + 1];
          }
        const double length = upper[0] - lower[0];
        lower[0] = chart.centred_x(lower[0] + length / 2) - length / 2;
        upper[0] = lower[0] + length;
        divider.divide(lower, upper);
      }
    return divider.n_cells;
  }

  std::pair<Point<3>, Point<3>> chart_box(const SweptMesh             &mesh,
                                          const unsigned int           cell,
                                          const std::array<double, 3> &lower,
                                          const double                 size)
  {
    Point<3> least, largest;
    for (unsigned int v = 0; v < 8; ++v)
      {
        std::array<double, 3> local = lower;
        for (unsigned int d = 0; d < 3; ++d)
          local[d] += ((v >> d) & 1) * size;
        const auto corner = mesh.chart_point(cell, local);
        for (unsigned int d = 0; d < 3; ++d)
          {
            least[d]   = v == 0 ? corner[d] : std::min(least[d], corner[d]);
            largest[d] = v == 0 ? corner[d] : std::max(largest[d], corner[d]);
          }
      }
    return {least, largest};
  }

  double count_cells(const SweptMesh  &mesh,
                     const Grading<3> &grading,
                     const double      enough)
  {
    double                                             n_cells = 0.;
    std::vector<std::pair<std::array<double, 3>, int>> parts;
    for (unsigned int cell = 0; cell < mesh.n_cells() && n_cells <= enough;
         ++cell)
      {
        parts.push_back({{{0., 0., 0.}}, 0});
        while (!parts.empty() && n_cells <= enough)
          {
            const auto [lower, level] = parts.back();
            parts.pop_back();
            const double size = std::ldexp(1., -level);
            const auto   box  = chart_box(mesh, cell, lower, size);
            if (!grading.refine(box.first, box.second))
              {
                ++n_cells;
                continue;
              }
            for (unsigned int child = 0; child < 8; ++child)
              {
                std::array<double, 3> begin = lower;
                for (unsigned int d = 0; d < 3; ++d)
                  begin[d] += ((child >> d) & 1) * size / 2;
                parts.push_back({begin, level + 1});
              }
          }
        parts.clear();
      }
    return n_cells;
  }

  template double count_cells<2>(const std::array<std::vector<double>, 2> &,
                                 const BodyChart<2> &,
                                 const Grading<2> &,
                                 const double);
  template double count_cells<3>(const std::array<std::vector<double>, 3> &,
                                 const BodyChart<3> &,
                                 const Grading<3> &,
                                 const double);
} // namespace RollingContact
