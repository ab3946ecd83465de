#include <rolling_contact/pair/interface_mesh.h>

#include <array>
#include <cmath>
#include <map>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    using Index = std::array<int, 2>; ///< of a grid point, in x and y

    /**
     * The grid point of an index. Points lie multiples of the element sizes
     * away from the point that Patch offset shifts. Units: m.
     */
    template <int dim>
    Point<dim - 1> grid_point(const Grading<dim> &grading, const Index &index)
    {
      Point<dim - 1> point;
      point[0] = (grading.offset + index[0]) * grading.element_size_x;
      if constexpr (dim == 3)
        point[1] = index[1] * grading.element_size_y;
      return point;
    }

    Index corner(const Index &box, const unsigned int v)
    {
      return {{box[0] + int(v & 1), box[1] + int(v >> 1)}};
    }

    /**
     * The boxes of the zone by their lower corners, in ascending x, then y.
     */
    template <int dim>
    std::vector<Index> boxes_of_zone(const Grading<dim> &grading)
    {
      const int n_x =
        std::ceil((grading.semi_axis_x() + std::abs(grading.centre_x())) /
                  grading.element_size_x) +
        2;
      int first_y = 0, last_y = 0;
      if (dim == 3)
        {
          last_y  = std::ceil(grading.zone_y / grading.element_size_y) + 1;
          first_y = -last_y - 1;
        }
      std::vector<Index> boxes;
      for (int i = -n_x; i < n_x; ++i)
        for (int j = first_y; j <= last_y; ++j)
          if (grading.in_zone(grid_point(grading, {{i, j}}),
                              grid_point(grading, {{i + 1, j + 1}})))
            boxes.push_back({{i, j}});
      return boxes;
    }
  } // namespace

  template <int dim>
  Trace interface_mesh(const Grading<dim> &grading)
  {
    const auto                    boxes     = boxes_of_zone(grading);
    const unsigned int            n_corners = 1 << (dim - 1);
    std::map<Index, unsigned int> number;
    for (const Index &box : boxes)
      for (unsigned int v = 0; v < n_corners; ++v)
        number[corner(box, v)] = 0;
    const auto point = [&](const Index &index) {
      const Point<dim - 1>  at = grid_point(grading, index);
      std::array<double, 2> result{{0., 0.}};
      for (unsigned int d = 0; d < dim - 1; ++d)
        result[d] = at[d];
      return result;
    };
    Trace trace;
    trace.n_dimensions = dim - 1;
    for (auto &entry : number)
      {
        entry.second = trace.nodes.size();
        trace.nodes.push_back(point(entry.first));
      }
    for (const Index &box : boxes)
      {
        Trace::Cell cell;
        cell.lower = point(box);
        cell.upper = point(corner(box, n_corners - 1));
        for (unsigned int v = 0; v < n_corners; ++v)
          cell.corners.push_back({{number[corner(box, v)], 1.}});
        trace.cells.push_back(cell);
      }
    return trace;
  }

  template Trace interface_mesh(const Grading<2> &);
  template Trace interface_mesh(const Grading<3> &);
} // namespace RollingContact
