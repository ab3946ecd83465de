#include <rolling_contact/base/constants.h>
#include <rolling_contact/mesh/rim_coordinate.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /// over the radius: the sector, longer than the zone of contact nodes,
    /// stays off the equator
    constexpr double largest_sector = 0.97;

    constexpr unsigned int least_cells_outside_sector = 4;

    /**
     * Coarse cells on either side of the origin: they cover the core and stay
     * off the equator. None if all cells are of equal angles.
     */
    double cells_in_half_sector(const double radius, const CoarseCells &cells)
    {
      if (cells.equal)
        return 0.;
      return std::max(1.,
                      std::min(std::ceil(cells.half_core / cells.size),
                               std::floor(largest_sector * radius /
                                          cells.size)));
    }
  } // namespace

  RimCoordinate::RimCoordinate(const double radius, const CoarseCells &cells)
    : cells(cells)
    , radius(radius)
    , half_sector(cells_in_half_sector(radius, cells))
    , sector_begin(cells.origin - half_sector * cells.size)
    , sector_end(cells.origin + half_sector * cells.size)
    , angle_begin(std::asin(sector_begin / radius))
    , angle_end(std::asin(sector_end / radius))
    , circumference(sector_end - sector_begin +
                    radius * (2 * pi - (angle_end - angle_begin)))
  {}

  double RimCoordinate::angle(const double chart_x) const
  {
    const double x = chart_x + sector_begin;
    return x <= sector_end ? std::asin(x / radius)
                           : angle_end + (x - sector_end) / radius;
  }

  double RimCoordinate::from_angle(const double angle) const
  {
    const double rounding = 1e-13;
    double       positive = angle;
    if (positive < angle_begin - rounding)
      positive += 2 * pi;
    return positive <= angle_end
             ? radius * std::sin(positive) - sector_begin
             : sector_end + radius * (positive - angle_end) - sector_begin;
  }

  double RimCoordinate::angle_on(const double x,
                                 const double other_radius) const
  {
    const double end     = std::asin(sector_end / other_radius),
                 begin   = std::asin(sector_begin / other_radius),
                 outside = (2 * pi - (end - begin)) /
                           (circumference - (sector_end - sector_begin));
    if (x > sector_end)
      return end + (x - sector_end) * outside;
    if (x < sector_begin)
      return begin - (sector_begin - x) * outside;
    return std::asin(x / other_radius);
  }

  namespace
  {
    /**
     * Ends of the coarse cells around a disc of this @p circumference, from the
     * end of the sector, at @p begin, to its begin, at @p end: growing up to
     * the middle, or all alike.
     */
    std::vector<double> edges_outside_sector(const double       begin,
                                             const double       end,
                                             const double       circumference,
                                             const CoarseCells &cells)
    {
      if (!cells.allowed)
        return equal_parts(begin,
                           end,
                           std::max<double>(least_cells_outside_sector,
                                            std::round((end - begin) /
                                                       cells.size)));
      const double        middle = (begin + end) / 2;
      std::vector<double> edges  = growing_parts(begin, middle, cells),
                          others = growing_parts(end - circumference,
                                                 middle - circumference,
                                                 cells);
      if (edges.size() + others.size() < least_cells_outside_sector + 2)
        return equal_parts(begin, end, least_cells_outside_sector);
      for (std::size_t i = others.size() - 1; i-- > 0;)
        edges.push_back(others[i] + circumference);
      return edges;
    }
  } // namespace

  std::vector<double> RimCoordinate::edges() const
  {
    if (cells.equal)
      return equal_parts(0.,
                         circumference,
                         std::max(least_cells_outside_sector,
                                  fewest_parts(circumference, cells.size)));
    const double        sector = 2 * half_sector * cells.size;
    std::vector<double> result = equal_parts(0., sector, 2 * half_sector);
    result.pop_back();
    for (const double x : edges_outside_sector(
           sector_end, sector_begin + circumference, circumference, cells))
      result.push_back(x - sector_begin);
    return result;
  }
} // namespace RollingContact
