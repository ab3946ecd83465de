#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/mesh/cell_count.h>
#include <rolling_contact/mesh/coarse_boxes.h>
#include <rolling_contact/mesh/cover_cells.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /// the core of equal coarse cells over the zone of contact nodes, or beyond
    /// it, in elements
    const double core_over_zone = 1.2, core_margin = 3.;

    /// coarse cells over half the width and over the thickness
    const double largest_coarse_width = 2. / 3, largest_coarse_depth = 0.5;

    /// growth of coarse cells in 3D over that of the elements along x, across
    /// and in depth, where stresses fall off least: long cells cost few
    /// unknowns
    const double growth_along = 0.7, growth_across = 0.5, growth_in_depth = 0.3;

    const int n_tried = 7; ///< sizes smaller than the largest

    /// cells of a section under its running surface, across: m
    const double least_section_cell = 9e-3, largest_section_cell = 18e-3;

    /**
     * Longest coarse cell that resolves the shape in all directions, as long
     * as @p grading's elements are over their width.
     */
    template <int dim>
    double largest_coarse_size(const BodyShape    &shape,
                               const Grading<dim> &grading)
    {
      const double limit =
        std::min(shape.largest_coarse_size(), shape.thickness_below());
      return dim == 2
               ? limit
               : std::min(limit,
                          largest_coarse_width * shape.reach_y() *
                            grading.element_size_x / grading.element_size_y);
    }

    /** Division into coarse cells along one direction of the chart. */
    struct Direction
    {
      unsigned int index;
      double       element_size;
      double       zone; ///< of contact nodes
      double       largest;
      double       growth; ///< over that of the elements
    };

    /**
     * Coarse cells of this @p size in the direction's core, and elsewhere
     * unless they grow away from it.
     */
    template <int dim>
    CoarseCells cells_along(const Direction    &direction,
                            const double        size,
                            const bool          grows,
                            const Grading<dim> &grading)
    {
      const double scale = direction.element_size / grading.element_size_x;
      CoarseCells  cells;
      cells.size    = size * scale;
      cells.largest = direction.largest;
      cells.half_core =
        std::max(core_over_zone * direction.zone,
                 direction.zone + core_margin * direction.element_size);
      if (!grows)
        return cells;
      // a distributed body, coarser far away, keeps its coarse cells
      Grading<dim> near = grading;
      near.far_distance = Grading<dim>::infinity;
      cells.allowed     = [direction, scale, near](const double position) {
        Point<dim> point;
        point[0]               = near.centre_x();
        point[direction.index] = position;
        const double grown =
          near.allowed_size(point, point) - near.element_size_x;
        return scale * (near.element_size_x + direction.growth * grown);
      };
      return cells;
    }

    /// of a coarse cell: shorter ones at the ends of a body are not split off
    const double shortest_end = 0.02;

    /**
     * Split first and last cells that are longer than @p size into one of this
     * size and a shorter one at the end.
     */
    void split_ends(const double size, std::vector<double> &breaks)
    {
      const double longest = (1 + shortest_end) * size;
      for (unsigned int end = 0; end < 2; ++end)
        {
          const std::size_t n = breaks.size();
          if (n > 2 && breaks[n - 1] - breaks[n - 2] > longest &&
              breaks[n - 1] - breaks[n - 2] < 2 * size)
            breaks.insert(breaks.end() - 1, breaks[n - 2] + size);
          std::reverse(breaks.begin(), breaks.end());
          for (double &at : breaks)
            at = -at;
        }
    }

    struct Division
    {
      double size;        ///< under the contact
      bool   grows;       ///< away from it; else all cells are alike
      bool   splits_ends; ///< see split_ends()
    };

    template <int dim>
    CoarseBoxes<dim> coarse_boxes(const std::shared_ptr<const BodyShape> &shape,
                                  const Grading<dim> &grading,
                                  const Division     &division)
    {
      const double depth = shape->thickness_below(), width = shape->reach_y(),
                   element = grading.element_size_x;
      const auto cells     = [&](const Direction &direction) {
        return cells_along<dim>(direction,
                                division.size,
                                division.grows,
                                grading);
      };
      CoarseBoxes<dim> boxes;
      boxes.size          = division.size;
      CoarseCells along_x = cells({0,
                                   element,
                                   grading.zone_x,
                                   shape->largest_coarse_size(),
                                   growth_along});
      along_x.origin      = grading.offset * element;
      const std::shared_ptr<const SurfaceChart> chart = shape->chart(along_x);
      boxes.breaks[0]                                 = chart->edges_x();
      boxes.chart = std::make_unique<BodyChart<dim>>(shape, chart);
      if (division.splits_ends && chart->period() == 0.)
        split_ends(division.size, boxes.breaks[0]);
      if (dim == 3)
        {
          const CoarseCells across = cells({1,
                                            grading.element_size_y,
                                            grading.zone_y,
                                            largest_coarse_width * width,
                                            growth_across});
          boxes.breaks[1]          = break_points(-width, width, across);
          if (division.splits_ends)
            split_ends(across.size, boxes.breaks[1]);
        }
      const CoarseCells down = cells({dim - 1,
                                      grading.element_size_z(),
                                      0.,
                                      largest_coarse_depth * depth,
                                      growth_in_depth});
      boxes.breaks[dim - 1] =
        breaks_in_depth(*shape, down, division.size / element);
      return boxes;
    }

    /**
     * Whether halving the coarse cells gives the elements of the zone of
     * contact nodes, but for the last cells of a body, longer or shorter.
     */
    template <int dim>
    bool has_elements_of_zone(const CoarseBoxes<dim> &boxes,
                              const Grading<dim>     &grading)
    {
      const auto matches = [&](const int                    d,
                               const double                 element,
                               const std::array<double, 2> &zone) {
        const double size     = boxes.size * element / grading.element_size_x,
                     rounding = 1e-6 * size,
                     // beyond it no element has its middle in the zone
          slack                       = 0.2 * element;
        const std::vector<double> &at = boxes.breaks[d];
        for (std::size_t k = 1; k < at.size(); ++k)
          {
            const double length = at[k] - at[k - 1],
                         middle = (at[k] + at[k - 1]) / 2,
                         centred =
                           d == 0 ? boxes.chart->centred_x(middle) : middle;
            if (centred - length / 2 < zone[1] - slack &&
                centred + length / 2 > zone[0] + slack &&
                std::abs(length - size) > rounding)
              return false;
          }
        return true;
      };
      return matches(0, grading.element_size_x, grading.zone_along()) &&
             (dim == 2 ||
              matches(1, grading.element_size_y, grading.zone_across()));
    }

    /**
     * All alike, none longer than a uniform grading allows; and their number.
     */
    template <int dim>
    std::pair<CoarseBoxes<dim>, double>
    equal_boxes(const std::shared_ptr<const BodyShape> &shape,
                const Grading<dim>                     &grading)
    {
      const double depth = shape->thickness_below(), width = shape->reach_y();
      CoarseCells  along;
      along.equal = true;
      along.size =
        std::min(grading.element_size_x, shape->largest_coarse_size());
      const double across =
        std::min(grading.element_size_y, largest_coarse_depth * depth);
      CoarseBoxes<dim> boxes;
      boxes.size                                      = along.size;
      const std::shared_ptr<const SurfaceChart> chart = shape->chart(along);
      boxes.chart     = std::make_unique<BodyChart<dim>>(shape, chart);
      boxes.breaks[0] = chart->edges_x();
      if (dim == 3)
        boxes.breaks[1] =
          equal_parts(-width, width, fewest_parts(2 * width, across));
      boxes.breaks[dim - 1] = equal_breaks_in_depth(*shape, across);
      double n_cells        = 1.;
      for (const auto &points : boxes.breaks)
        n_cells *= points.size() - 1;
      return {std::move(boxes), n_cells};
    }
  } // namespace

  template <int dim>
  std::pair<CoarseBoxes<dim>, double>
  fewest_cells(const std::shared_ptr<const BodyShape> &shape,
               const Grading<dim>                     &grading,
               const double                            enough)
  {
    if (grading.is_uniform)
      return equal_boxes<dim>(shape, grading);
    const double longest = largest_coarse_size<dim>(*shape, grading);
    const int    most =
      std::max(0., std::floor(std::log2(longest / grading.element_size_x)));
    CoarseBoxes<dim> best;
    double           fewest  = std::numeric_limits<double>::infinity();
    bool             matches = false; // the best has the elements of the zone
    const auto       try_it =
      [&](const int k, const bool grows, const bool splits_ends = false) {
        CoarseBoxes<dim> boxes = coarse_boxes<dim>(
          shape,
          grading,
          {std::ldexp(grading.element_size_x, k), grows, splits_ends});
        const bool this_matches = has_elements_of_zone(boxes, grading);
        if (matches && !this_matches)
          return;
        const double to_beat = matches == this_matches
                                 ? fewest
                                 : std::numeric_limits<double>::infinity();
        const double n_cells = count_cells<dim>(boxes.breaks,
                                                *boxes.chart,
                                                grading,
                                                std::min(to_beat, enough));
        if (n_cells < to_beat)
          {
            best    = std::move(boxes);
            fewest  = n_cells;
            matches = this_matches;
          }
      };
    try_it(most, false);
    for (int k = most - 1; dim == 2 && !matches && k >= 0; --k)
      try_it(k, false);
    // in 2D long cells cost more than they save
    bool is_near = false; // the side, so that only small cells match
    for (int k = most; dim == 3 && k >= std::max(0, most - n_tried); --k)
      {
        try_it(k, true);
        is_near = is_near || !matches;
      }
    for (int k = most; (is_near || !matches) && k >= 0; --k)
      try_it(k, dim == 3, true);
    return {std::move(best), fewest};
  }

  namespace
  {
    /**
     * Whether halving the cells of the strip gives the elements of the zone of
     * contact nodes right across it, as it does but for cells at its ends.
     */
    bool has_elements_of_zone(const SweptMesh &mesh, const Grading<3> &grading)
    {
      const double across   = grading.element_size_y,
                   size     = mesh.size() * across / grading.element_size_x,
                   rounding = 1e-6 * size;
      const auto zone       = grading.zone_across();
      for (unsigned int quad = 0; quad < mesh.of_section().quads().size();
           ++quad)
        {
          if (!mesh.of_section().quads()[quad].chart)
            continue;
          const double p     = mesh.chart_point(quad, {{0., 0., 1.}})[1],
                       q     = mesh.chart_point(quad, {{0., 1., 1.}})[1],
                       begin = std::min(p, q), end = std::max(p, q);
          if (begin < zone[1] + across && end > zone[0] - across &&
              std::abs(end - begin - size) > rounding)
            return false;
        }
      return true;
    }
  } // namespace

  std::pair<std::shared_ptr<const SweptMesh>, double>
  fewest_swept_cells(const std::shared_ptr<const BodyShape> &shape,
                     const Grading<3>                       &grading,
                     const double                            enough)
  {
    const double element = grading.element_size_x,
                 across  = grading.element_size_y;
    if (grading.is_uniform || shape->has_own_cells())
      {
        const double longest = Grading<3>::infinity;
        const auto   mesh    = grading.is_uniform
                                 ? shape->equal_cells(element, across)
                                 : shape->equal_cells(longest, longest);
        return {mesh,
                count_cells(*mesh, grading_of_body(*shape, grading), enough)};
      }
    // the one size between a largest and half of that; halves of it where its
    // cells are distorted, or longer ones at the strip's ends reach the zone
    const int most =
      std::max(0., std::floor(std::log2(largest_section_cell / across)));
    std::shared_ptr<const SweptMesh> best;
    double fewest = std::numeric_limits<double>::infinity();
    for (const int k : {most, most - 1, most - 2})
      {
        if (k < 0 || (best && std::ldexp(across, k) < least_section_cell))
          continue;
        const double size    = std::ldexp(element, k);
        CoarseCells  along_x = cells_along<3>({0,
                                               element,
                                               grading.zone_x,
                                               shape->largest_coarse_size(),
                                               growth_along},
                                             size,
                                             true,
                                             grading);
        along_x.origin       = grading.offset * element;
        const auto mesh      = shape->swept_mesh(
          along_x,
          cells_along<3>(
            {1, across, grading.zone_y, largest_section_cell, growth_across},
            size,
            false,
            grading),
          size * grading.element_size_z() / element);
        if (!mesh || !has_elements_of_zone(*mesh, grading))
          continue;
        const double n_cells =
          count_cells(*mesh, grading, std::min(fewest, enough));
        if (n_cells < fewest)
          {
            best   = mesh;
            fewest = n_cells;
          }
      }
    if (!best)
      throw InputError(
        "Profiles/Body sections = true: the profiles' sections cannot be meshed "
        "with elements of " +
        significant(across, 3) +
        " m across: cells would be folded, or would differ at the contact "
        "zone. Take another Mesh/Elements across patch y, a profile nearer to "
        "a new one, or Body sections = plain.");
    return {best, fewest};
  }

  Grading<3> grading_of_body(const BodyShape &shape, const Grading<3> &grading)
  {
    if (!shape.has_own_cells() || grading.is_uniform || grading.is_alone)
      return grading;
    Grading<3>  own = grading.of_coupled_body();
    const auto &strip =
      grading.strips[shape.is_of_wheel() ? Side::wheel : Side::rail];
    own.zone_boxes = strip.empty() ? shape.on_surface(own.zone_boxes) : strip;
    return own;
  }

  template std::pair<CoarseBoxes<2>, double>
  fewest_cells(const std::shared_ptr<const BodyShape> &,
               const Grading<2> &,
               const double);
  template std::pair<CoarseBoxes<3>, double>
  fewest_cells(const std::shared_ptr<const BodyShape> &,
               const Grading<3> &,
               const double);
} // namespace RollingContact
