#include <rolling_contact/contact/trace.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    /**
     * Local coordinates of a point in a box, or none if it is outside by more
     * than rounding.
     */
    std::optional<std::array<double, 2>>
    local_coordinates(const Trace::Cell &cell,
                      const unsigned int n_dimensions,
                      const double       x,
                      const double       y)
    {
      const std::array<double, 2> point{{x, y}};
      std::array<double, 2>       local{};
      for (unsigned int d = 0; d < n_dimensions; ++d)
        {
          local[d] =
            (point[d] - cell.lower[d]) / (cell.upper[d] - cell.lower[d]);
          if (local[d] < -1e-6 || local[d] > 1 + 1e-6)
            return {};
          for (const double end : {0., 1.})
            if (std::abs(local[d] - end) < 1e-6)
              local[d] = end;
        }
      return local;
    }
  } // namespace

  std::optional<SparseRows::Row> Trace::interpolation(const double x,
                                                      const double y) const
  {
    for (const Cell &cell : cells)
      if (const auto local = local_coordinates(cell, n_dimensions, x, y))
        {
          SparseRows weights(1);
          for (unsigned int corner = 0; corner < cell.corners.size(); ++corner)
            {
              double shape = 1.;
              for (unsigned int d = 0; d < n_dimensions; ++d)
                shape *= (corner >> d) & 1 ? (*local)[d] : 1 - (*local)[d];
              if (shape != 0.)
                for (const auto &entry : cell.corners[corner])
                  weights.add(0, entry.first, shape * entry.second);
            }
          return weights[0];
        }
    return {};
  }

  std::optional<double> Trace::element_size(const unsigned int i,
                                            const int          direction) const
  {
    std::optional<double> smallest;
    for (const Cell &cell : cells)
      {
        const double size = cell.upper[0] - cell.lower[0];
        if (local_coordinates(cell,
                              n_dimensions,
                              nodes[i][0] + direction * 1e-3 * size,
                              nodes[i][1]) &&
            (!smallest || size < *smallest))
          smallest = size;
      }
    return smallest;
  }

  std::vector<bool> Trace::border_nodes() const
  {
    std::vector<unsigned int> n_elements(nodes.size(), 0);
    for (const Cell &cell : cells)
      for (const auto &corner : cell.corners)
        if (corner.size() == 1)
          ++n_elements[corner[0].first];
    std::vector<bool> border(nodes.size());
    for (unsigned int i = 0; i < nodes.size(); ++i)
      border[i] = n_elements[i] < (1u << n_dimensions);
    return border;
  }
} // namespace RollingContact
