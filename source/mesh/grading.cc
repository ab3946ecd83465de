#include <rolling_contact/mesh/grading.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /// of a cell, so that rounding decides neither on a node nor on a halving
    const double zone_margin = 0.01, size_rounding = 1e-6;

    /**
     * Distance of the interval [lower, upper] from [begin, end].
     */
    double interval_distance(const double lower,
                             const double upper,
                             const double begin,
                             const double end)
    {
      return std::max({0., begin - upper, lower - end});
    }
  } // namespace

  template <int dim>
  Grading<dim> Grading<dim>::of_coupled_body() const
  {
    const double       share    = 0.8; // beyond check_resolution()'s 1 / 1.2
    const unsigned int n_around = 2;
    Grading            grading  = *this;
    grading.make_even_in_x();
    grading.element_size_x *= share;
    grading.element_size_y *= share;
    grading.deeper = 1.4;
    grading.enlarge_zone(n_around);
    return grading;
  }

  template <int dim>
  void Grading<dim>::make_even_in_x()
  {
    zone_x   = semi_axis_x() + std::abs(centre_x());
    upstream = 0;
    // boxes about the contact point; patches elsewhere stay where they are
    for (ZoneBox &box : zone_boxes)
      if (std::abs(box.lower[0] + box.upper[0]) < 1.5 * element_size_x)
        {
          box.upper[0] = std::max(box.upper[0], -box.lower[0]);
          box.lower[0] = -box.upper[0];
        }
  }

  template <int dim>
  bool Grading<dim>::in_zone(const Point<dim - 1> &lower,
                             const Point<dim - 1> &upper) const
  {
    if (!zone_boxes.empty())
      {
        // a node on a border belongs to neither box by rounding
        const double x = (lower[0] + upper[0]) / 2,
                     y = dim == 3 ? (lower[dim - 2] + upper[dim - 2]) / 2 : 0.,
                     slack = zone_margin * element_size_x;
        return std::any_of(zone_boxes.begin(),
                           zone_boxes.end(),
                           [&](const ZoneBox &box) {
                             return box.grown(slack, slack).contains(x, y);
                           });
      }
    const std::array<double, 2> semi_axes{{semi_axis_x(), zone_y}},
      centre{{centre_x(), 0.}};
    double sum = 0.;
    for (int d = 0; d < dim - 1; ++d)
      {
        const double middle = std::abs((lower[d] + upper[d]) / 2 - centre[d]),
                     margin = zone_margin * (upper[d] - lower[d]);
        sum += std::pow(std::max(0., middle - margin) / semi_axes[d], 2);
      }
    return sum <= 1.;
  }

  template <int dim>
  double Grading<dim>::size_in_x(const Point<dim> &lower,
                                 const Point<dim> &upper) const
  {
    double size = std::max(upper[0] - lower[0],
                           (upper[dim - 1] - lower[dim - 1]) * element_size_x /
                             element_size_z());
    if (dim == 3)
      size =
        std::max(size, (upper[1] - lower[1]) * element_size_x / element_size_y);
    return size;
  }

  template <int dim>
  double Grading<dim>::outside_zone(const Point<dim> &lower,
                                    const Point<dim> &upper) const
  {
    if (!zone_boxes.empty())
      {
        double least = infinity;
        for (const ZoneBox &box : zone_boxes)
          {
            const double in_x = interval_distance(lower[0],
                                                  upper[0],
                                                  box.lower[0],
                                                  box.upper[0]),
                         in_y = interval_distance(lower[1],
                                                  upper[1],
                                                  box.lower[1],
                                                  box.upper[1]);
            least             = std::min(
              least, std::hypot(in_x, in_y * element_size_x / element_size_y));
          }
        return std::max(0., least - element_size_x);
      }
    const double fine_x = semi_axis_x() + element_size_x,
                 fine_y = zone_y + element_size_y;
    const auto nearest  = [&](const unsigned int d, const double centre) {
      return interval_distance(lower[d], upper[d], centre, centre);
    };
    if (dim == 2)
      return std::max(0., nearest(0, centre_x()) - fine_x);
    return std::max(0.,
                    std::hypot(nearest(0, centre_x()) / fine_x,
                               nearest(1, 0.) / fine_y) -
                      1) *
           fine_x;
  }

  template <int dim>
  double Grading<dim>::allowed_size(const Point<dim> &lower,
                                    const Point<dim> &upper) const
  {
    const double distance = std::hypot(
      outside_zone(lower, upper),
      interval_distance(lower[dim - 1], upper[dim - 1], -zone_depth, 0.) *
        element_size_x / element_size_z());
    return element_size_x + growth * std::min(distance, far_distance) +
           far_growth * std::max(0., distance - far_distance);
  }

  template <int dim>
  bool Grading<dim>::exceeds_rim(const double      size,
                                 const Point<dim> &lower,
                                 const Point<dim> &upper) const
  {
    // in 3D the band across the zone, not across the body
    const double beside =
      dim == 3 ? interval_distance(lower[1], upper[1], -zone_y, zone_y) *
                   element_size_x / element_size_y
               : 0.;
    const auto too_large_at = [&](const double edge) {
      const double finest = std::ldexp(element_size_x, -int(rim_levels));
      const double away   = std::hypot(
        interval_distance(
          lower[0], upper[0], edge - rim_width, edge + rim_width),
        beside,
        interval_distance(lower[dim - 1], upper[dim - 1], -rim_width, 0.));
      return size > finest + growth * away;
    };
    return rim_levels > 0 &&
           (too_large_at(leading_edge_x) ||
            (!leading_edge_only && too_large_at(trailing_edge_x)));
  }

  template <int dim>
  bool Grading<dim>::exceeds_boxes(const double      size,
                                   const Point<dim> &lower,
                                   const Point<dim> &upper) const
  {
    // a cell at the surface counts as flat: how deep it is differs from body
    // to body, the surface nodes must not
    const double tolerance = size_rounding * size;
    const bool   flat      = upper[dim - 1] > -tolerance;
    Point<dim>   bottom    = lower;
    if (flat)
      bottom[dim - 1] = upper[dim - 1];
    const auto overlaps = [&](const RefinedBox<dim> &box) {
      for (unsigned int d = 0; d < dim; ++d)
        {
          const bool   touches = flat && d == dim - 1;
          const double margin  = touches ? -tolerance : tolerance;
          if (upper[d] < box.lower[d] + margin ||
              bottom[d] > box.upper[d] - margin)
            return false;
        }
      return true;
    };
    const auto distance = [&](const RefinedBox<dim> &box) {
      double square = 0.;
      for (unsigned int d = 0; d < dim; ++d)
        {
          const double scale =
            dim == 3 && d == 1 ? element_size_x / element_size_y : 1.;
          const double away =
            interval_distance(bottom[d], upper[d], box.lower[d], box.upper[d]);
          square += std::pow(scale * away, 2);
        }
      return std::sqrt(square);
    };
    return std::any_of(boxes.begin(), boxes.end(), [&](const auto &box) {
      return size > box.size &&
             (overlaps(box) || size > 2 * box.size + growth * distance(box));
    });
  }

  template <int dim>
  bool Grading<dim>::refine(const Point<dim> &lower,
                            const Point<dim> &upper) const
  {
    if (is_uniform)
      return false;
    const double size = size_in_x(lower, upper) / (1. + size_rounding);
    return size > allowed_size(lower, upper) ||
           exceeds_rim(size, lower, upper) || exceeds_boxes(size, lower, upper);
  }

  template struct Grading<2>;
  template struct Grading<3>;
} // namespace RollingContact
