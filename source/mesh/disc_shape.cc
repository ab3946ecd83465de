#include <boost/math/constants/constants.hpp>

#include <rolling_contact/mesh/disc_shape.h>
#include <rolling_contact/references/line_contact_approach.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    constexpr double pi = boost::math::constants::pi<double>();

    /// over the radius: the profile leaves its circle at 0.5, and the sector of
    /// the chart, longer than the zone of contact nodes, stays off the equator
    constexpr double usable_rim = 0.55, largest_sector = 0.97;

    constexpr double largest_coarse_rim = 0.4; ///< cell over radius

    constexpr unsigned int least_cells_outside_sector = 4;



    /**
     * Chart of a disc. Inside the contact sector x is the Cartesian x of the
     * surface, outside it is arc length; it is counted from the begin of the
     * sector, where the chart is closed.
     */
    class DiscChart : public SurfaceChart
    {
    public:
      DiscChart(const ShapeParameters &disc, const CoarseCells &cells);

      Point
      to_body(const Point &chart_point) const override;

      Point
      to_chart(const Point &body_point) const override;

      std::vector<double>
      edges_x() const override;

      double
      period() const override
      {
        return circumference;
      }

      double
      contact_x() const override
      {
        return -sector_begin;
      }

    private:
      double
      rim(const double y) const
      {
        return radius - crown_depth(lateral_radius, y);
      }

      double
      angle(const double x) const;

      double
      from_angle(const double angle) const;

      const CoarseCells cells;
      const double      radius, lateral_radius, hub_radius, half_sector,
        sector_begin, sector_end, angle_begin, angle_end, circumference;
    };



    /**
     * Coarse cells on either side of the origin: they cover the core and stay
     * off the equator.
     */
    double
    cells_in_half_sector(const double radius, const CoarseCells &cells)
    {
      return std::max(1.,
                      std::min(std::ceil(cells.half_core / cells.size),
                               std::floor(largest_sector * radius /
                                          cells.size)));
    }



    DiscChart::DiscChart(const ShapeParameters &disc, const CoarseCells &cells)
      : cells(cells)
      , radius(disc.radius)
      , lateral_radius(disc.lateral_radius)
      , hub_radius(disc.hub_radius)
      , half_sector(cells_in_half_sector(radius, cells))
      , sector_begin(cells.origin - half_sector * cells.size)
      , sector_end(cells.origin + half_sector * cells.size)
      , angle_begin(std::asin(sector_begin / radius))
      , angle_end(std::asin(sector_end / radius))
      , circumference(sector_end - sector_begin +
                      radius * (2 * pi - (angle_end - angle_begin)))
    {}



    double
    DiscChart::angle(const double chart_x) const
    {
      const double x = chart_x + sector_begin;
      return x <= sector_end ? std::asin(x / radius)
                             : angle_end + (x - sector_end) / radius;
    }



    double
    DiscChart::from_angle(const double angle) const
    {
      const double rounding = 1e-13;
      double       positive = angle;
      if (positive < angle_begin - rounding)
        positive += 2 * pi;
      return positive <= angle_end
               ? radius * std::sin(positive) - sector_begin
               : sector_end + radius * (positive - angle_end) - sector_begin;
    }



    SurfaceChart::Point
    DiscChart::to_body(const Point &chart_point) const
    {
      const auto [x, y, w]       = chart_point;
      const double below_surface = w / (radius - hub_radius);
      const double r = hub_radius + (rim(y) - hub_radius) * (1 + below_surface);
      const double theta = angle(x);
      return {{r * std::sin(theta), y, r * std::cos(theta) - radius}};
    }



    SurfaceChart::Point
    DiscChart::to_chart(const Point &body_point) const
    {
      const auto [x, y, z]   = body_point;
      const double thickness = radius - hub_radius, crown = rim(y),
                   r = std::hypot(x, z + radius);
      return {{from_angle(std::atan2(x, z + radius)),
               y,
               thickness * (r - crown) / (crown - hub_radius)}};
    }



    /**
     * Ends of the coarse cells around a disc of this @p circumference, from the
     * end of the sector, at @p begin, to its begin, at @p end: growing up to
     * the middle, or all alike.
     */
    std::vector<double>
    edges_outside_sector(const double       begin,
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



    std::vector<double>
    DiscChart::edges_x() const
    {
      const double        sector = 2 * half_sector * cells.size;
      std::vector<double> edges  = equal_parts(0., sector, 2 * half_sector);
      edges.pop_back();
      for (const double x : edges_outside_sector(
             sector_end, sector_begin + circumference, circumference, cells))
        edges.push_back(x - sector_begin);
      return edges;
    }
  } // namespace



  void
  DiscShape::check(const unsigned int dimension, const bool rigid) const
  {
    parameters.require(parameters.radius > 0.,
                       "Radius",
                       parameters.radius,
                       "a disc needs a radius above 0 m; take Shape = block "
                       "for a flat or concave body.");
    if (rigid)
      return;
    parameters.require(parameters.hub_radius > 0. &&
                         parameters.hub_radius < parameters.radius,
                       "Hub radius",
                       parameters.hub_radius,
                       "it must lie above 0 m and below the Radius.");
    check_extent(dimension, 0.);
  }



  double
  DiscShape::thickness_below() const
  {
    return parameters.radius - parameters.hub_radius;
  }



  double
  DiscShape::reach_x() const
  {
    return usable_rim * parameters.radius;
  }



  double
  DiscShape::largest_half_width() const
  {
    return parameters.radius;
  }



  double
  DiscShape::line_compression(const References::HertzLine &contact,
                              const double                 young_modulus,
                              const double                 poisson_ratio) const
  {
    return References::compression_of_disc(parameters.radius,
                                           young_modulus,
                                           poisson_ratio,
                                           contact);
  }



  std::optional<References::Annulus>
  DiscShape::clamped_annulus(const double young_modulus,
                             const double poisson_ratio) const
  {
    if (parameters.hub_radius >=
        References::largest_hub_ratio * parameters.radius)
      return {};
    return References::Annulus{parameters.radius,
                               parameters.hub_radius,
                               young_modulus,
                               poisson_ratio};
  }



  double
  DiscShape::largest_coarse_size() const
  {
    return largest_coarse_rim * parameters.radius;
  }



  std::unique_ptr<SurfaceChart>
  DiscShape::chart(const CoarseCells &cells) const
  {
    return std::make_unique<DiscChart>(parameters, cells);
  }



  std::vector<double>
  DiscShape::dimensions() const
  {
    return {parameters.radius,
            parameters.lateral_radius,
            parameters.hub_radius,
            parameters.width};
  }
} // namespace RollingContact
