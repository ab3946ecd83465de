#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/numerics/error_estimator.h>

#include <rolling_contact/bodies/error_indicator.h>

#include <algorithm>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    const double equal_indicators = 1e-3; ///< relative difference
    const double size_margin      = 0.01; ///< of an element, for rounding

    /**
     * The indicators of all ranks with their boxes, in an order that does not
     * depend on their number.
     */
    template <int dim>
    std::vector<std::pair<double, RefinedBox<dim>>>
    gathered(std::vector<std::pair<double, RefinedBox<dim>>> here,
             const MPI_Comm                                  communicator)
    {
      std::vector<double> numbers;
      for (const auto &entry : here)
        {
          numbers.push_back(entry.first);
          numbers.push_back(entry.second.size);
          for (unsigned int d = 0; d < dim; ++d)
            {
              numbers.push_back(entry.second.lower[d]);
              numbers.push_back(entry.second.upper[d]);
            }
        }
      here.clear();
      for (const auto &part : Utilities::MPI::all_gather(communicator, numbers))
        for (auto number = part.begin(); number != part.end();)
          {
            std::pair<double, RefinedBox<dim>> entry;
            entry.first       = *number++;
            entry.second.size = *number++;
            for (unsigned int d = 0; d < dim; ++d)
              {
                entry.second.lower[d] = *number++;
                entry.second.upper[d] = *number++;
              }
            here.push_back(entry);
          }
      return here;
    }

    /**
     * The shortest head of the boxes, sorted by descending indicator, that
     * carries @p fraction of the sum of squares, with all that weigh the same
     * as its last.
     */
    template <int dim>
    std::vector<RefinedBox<dim>>
    heaviest(std::vector<std::pair<double, RefinedBox<dim>>> weighted,
             const double                                    fraction)
    {
      std::sort(weighted.begin(),
                weighted.end(),
                [](const auto &a, const auto &b) { return a.first > b.first; });
      double left = 0.;
      for (const auto &entry : weighted)
        left += fraction * entry.first * entry.first;
      double                       threshold = 0.;
      std::vector<RefinedBox<dim>> boxes;
      for (const auto &entry : weighted)
        {
          // equals go together, or a symmetric mesh would not stay so
          if (left <= 0. && entry.first < threshold)
            break;
          if (left > 0.)
            threshold = (1 - equal_indicators) * entry.first;
          left -= entry.first * entry.first;
          boxes.push_back(entry.second);
        }
      return boxes;
    }
  } // namespace

  template <int dim>
  std::vector<RefinedBox<dim>> bulk_boxes(const ElasticBody<dim> &body,
                                          const BodyField        &displacement,
                                          const Grading<dim>     &grading,
                                          const double            fraction)
  {
    const auto   &dofs = body.dof_handler();
    Vector<float> indicators(dofs.get_triangulation().n_active_cells());
    KellyErrorEstimator<dim>::estimate(
      dofs, QGauss<dim - 1>(2), {}, displacement, indicators);

    std::vector<std::pair<double, RefinedBox<dim>>> weighted;
    for (const auto &cell : dofs.active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        const auto   box     = body.mesh().chart_box(cell);
        const double half    = grading.size_in_x(box.first, box.second) / 2;
        const double zone    = grading.element_size_x;
        const bool   outside = grading.allowed_size(box.first, box.second) >
                             (1 + size_margin) * zone;
        if (outside && 2 * half > (1 - size_margin) * zone)
          weighted.push_back({indicators[cell->active_cell_index()],
                              {box.first, box.second, half}});
      }
    return heaviest(gathered(std::move(weighted),
                             dofs.get_triangulation().get_communicator()),
                    fraction);
  }

  template std::vector<RefinedBox<2>> bulk_boxes(const ElasticBody<2> &,
                                                 const BodyField &,
                                                 const Grading<2> &,
                                                 const double);
  template std::vector<RefinedBox<3>> bulk_boxes(const ElasticBody<3> &,
                                                 const BodyField &,
                                                 const Grading<3> &,
                                                 const double);
} // namespace RollingContact
