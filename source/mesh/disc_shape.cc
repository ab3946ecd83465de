#include <rolling_contact/mesh/disc_shape.h>
#include <rolling_contact/mesh/rim_coordinate.h>
#include <rolling_contact/references/line_contact_approach.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {

    constexpr double largest_coarse_rim = 0.4; ///< cell over radius

    constexpr double section_cell = 0.025; ///< longest of the section: m

    /**
     * Chart of a disc: x around its rim, w stretched between rim and hub.
     */
    class DiscChart : public SurfaceChart
    {
    public:
      DiscChart(const ShapeParameters &disc, const CoarseCells &cells)
        : around(disc.radius, cells)
        , radius(disc.radius)
        , lateral_radius(disc.lateral_radius)
        , hub_radius(disc.hub_radius)
      {}

      Point to_body(const Point &chart_point) const override;

      Point to_chart(const Point &body_point) const override;

      std::vector<double> edges_x() const override
      {
        return around.edges();
      }

      double period() const override
      {
        return around.length();
      }

      double contact_x() const override
      {
        return around.contact();
      }

    private:
      double rim(const double y) const
      {
        return radius - crown_depth(lateral_radius, y);
      }

      const RimCoordinate around;
      const double        radius, lateral_radius, hub_radius;
    };

    SurfaceChart::Point DiscChart::to_body(const Point &chart_point) const
    {
      const auto [x, y, w]       = chart_point;
      const double below_surface = w / (radius - hub_radius);
      const double r = hub_radius + (rim(y) - hub_radius) * (1 + below_surface);
      const double theta = around.angle(x);
      return {{r * std::sin(theta), y, r * std::cos(theta) - radius}};
    }

    SurfaceChart::Point DiscChart::to_chart(const Point &body_point) const
    {
      const auto [x, y, z]   = body_point;
      const double thickness = radius - hub_radius, crown = rim(y),
                   r = std::hypot(x, z + radius);
      return {{around.from_angle(std::atan2(x, z + radius)),
               y,
               thickness * (r - crown) / (crown - hub_radius)}};
    }
  } // namespace

  void DiscShape::check(const unsigned int dimension, const bool rigid) const
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

  double DiscShape::thickness_below() const
  {
    return parameters.radius - parameters.hub_radius;
  }

  std::optional<Axle> DiscShape::axle() const
  {
    return Axle{{{0., 0., -parameters.radius}}, {{0., 1., 0.}}};
  }

  std::optional<SectionMesh> DiscShape::section_about_axle() const
  {
    if (!(parameters.width > 0.))
      return {}; // in the plane
    const double inner = parameters.hub_radius,
                 outer =
                   parameters.radius -
                   crown_depth(parameters.lateral_radius, parameters.width / 2);
    const auto y = equal_parts(-parameters.width / 2,
                               parameters.width / 2,
                               fewest_parts(parameters.width, section_cell)),
               r = equal_parts(inner,
                               outer,
                               fewest_parts(outer - inner, section_cell));
    SectionMesh section;
    for (std::size_t i = 0; i + 1 < y.size(); ++i)
      for (std::size_t j = 0; j + 1 < r.size(); ++j)
        {
          // the rim is a curve, all other lines of the section are straight
          const auto at = [&](const double across, const std::size_t row) {
            const double height =
              row + 1 < r.size()
                ? r[row]
                : parameters.radius -
                    crown_depth(parameters.lateral_radius, across);
            return SectionPoint{{across, height, height}};
          };
          const std::array<SectionPoint, 4> corners{{at(y[i], j),
                                                     at(y[i + 1], j),
                                                     at(y[i], j + 1),
                                                     at(y[i + 1], j + 1)}};
          const unsigned int                quad = section.add(corners);
          if (j == 0)
            section.set_boundary(quad,
                                 corners[0],
                                 corners[1],
                                 SectionBoundary::hub);
          if (j + 2 == r.size())
            section.set_curve(quad,
                              corners[2],
                              corners[3],
                              [at, begin = y[i], end = y[i + 1], j](
                                const double t) {
                                return at((1 - t) * begin + t * end, j + 1);
                              });
        }
    return section;
  }

  double DiscShape::reach_x() const
  {
    return usable_rim * parameters.radius;
  }

  double DiscShape::largest_half_width() const
  {
    return parameters.radius;
  }

  double DiscShape::line_compression(const References::HertzLine &contact,
                                     const double                 young_modulus,
                                     const double poisson_ratio) const
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
    if (hub() == Hub::elastic || hub() == Hub::mass ||
        parameters.hub_radius >=
          References::largest_hub_ratio * parameters.radius)
      return {};
    return References::Annulus{parameters.radius,
                               parameters.hub_radius,
                               young_modulus,
                               poisson_ratio};
  }

  double DiscShape::largest_coarse_size() const
  {
    return largest_coarse_rim * parameters.radius;
  }

  std::unique_ptr<SurfaceChart> DiscShape::chart(const CoarseCells &cells) const
  {
    return std::make_unique<DiscChart>(parameters, cells);
  }

  std::vector<double> DiscShape::dimensions() const
  {
    return {parameters.radius,
            parameters.lateral_radius,
            parameters.hub_radius,
            parameters.width};
  }
} // namespace RollingContact
