#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/mesh/rail_section_mesh.h>
#include <rolling_contact/mesh/running_surfaces.h>
#include <rolling_contact/mesh/section_shapes.h>
#include <rolling_contact/mesh/wheel_section_mesh.h>
#include <rolling_contact/surfaces/rail_section.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /// longest coarse cell along x: of the rail (m), and over a wheel's radius
    const double longest_rail_cell = 0.04, longest_wheel_cell = 0.15;

    /// of the coarse quadrilaterals, divided as often as this
    const double       least_quality = 0.05;
    const unsigned int quality_parts = 4;

    /// cells under the running surface that are divided further, across: m
    const std::array<double, 3> section_cells{{18e-3, 13e-3, 9e-3}};

    /// height of a running surface over the distance across from the contact
    /// point from which on it is an edge, and steps of the search: m
    const double slope_of_edge = 0.2, edge_step = 0.25e-3;

    const double least_rail = 0.2, longest_rail = 5., least_bore = 0.05,
                 largest_bow = 0.04;
  } // namespace

  SectionShape::SectionShape(const ShapeSpec      &parameters,
                             const RunningSurface &surface)
    : BodyShape(parameters)
    , placed(*this->parameters.profile)
    , surface(surface)
  {}

  double SectionShape::surface_height(const double x, const double y) const
  {
    const auto   ends = surface.ends();
    const double at   = placed.is_left ? -y : y;
    const auto   here = surface_point(std::clamp(at, ends[0], ends[1]));
    CoarseCells  cells;
    cells.size = cells.half_core = reach_x();
    return sweep(cells).first.to_body(x, here)[2];
  }

  double SectionShape::thickness_below() const
  {
    return surface_point(0.)[1];
  }

  double SectionShape::reach_y() const
  {
    return std::min(-surface.facing()[0], surface.facing()[1]);
  }

  std::array<double, 2> SectionShape::room_across() const
  {
    const auto [begin, end] = surface.facing();
    if (placed.is_left)
      return {{-end, -begin}};
    return {{begin, end}};
  }

  double SectionShape::distance_to_edge() const
  {
    CoarseCells cells;
    cells.size = cells.half_core     = reach_x();
    const SectionPlacement placement = sweep(cells).first;
    const auto             ends      = surface.ends();
    double                 nearest   = reach_x();
    for (const double end : ends)
      {
        std::array<double, 3> at{};
        for (double c = edge_step; c <= std::abs(end); c += edge_step)
          {
            at = placement.to_body(0., surface_point(std::copysign(c, end)));
            if (std::abs(at[2]) > slope_of_edge * std::abs(at[1]))
              break;
          }
        nearest = std::min(nearest, std::hypot(at[1], at[2]));
      }
    return nearest;
  }

  std::shared_ptr<const SweptMesh>
  SectionShape::swept_mesh(const CoarseCells &along,
                           const CoarseCells &across,
                           const double       deepest) const
  {
    const SectionMesh quads = section(across, deepest);
    if (!(quads.least_quality(quality_parts) > least_quality))
      return nullptr;
    const auto [placement, ends_x] = sweep(along);
    return std::make_shared<const SweptMesh>(quads,
                                             placement,
                                             ends_x,
                                             along.size);
  }

  std::shared_ptr<const SweptMesh>
  SectionShape::equal_cells(const double along, const double across) const
  {
    CoarseCells slices;
    slices.equal                   = true;
    slices.size                    = std::min(along, largest_coarse_size());
    const auto [placement, ends_x] = sweep(slices);
    return std::make_shared<const SweptMesh>(
      unfolded_section(across).divided(across), placement, ends_x, slices.size);
  }

  SectionMesh SectionShape::unfolded_section(const double across) const
  {
    for (const double size : section_cells)
      {
        CoarseCells under_surface;
        under_surface.size    = std::min(size, across);
        const SectionMesh all = section(under_surface, under_surface.size);
        if (all.least_quality(quality_parts) > least_quality)
          return all;
      }
    throw InputError("Profiles/Body sections = true: the profiles' sections "
                     "cannot be meshed, cells would be folded: take profiles "
                     "nearer to new ones, or Body sections = plain.");
  }

  std::vector<double> SectionShape::dimensions() const
  {
    // of a class of its own: never the mirror image of another body
    return {};
  }

  RailShape::RailShape(const ShapeSpec &parameters)
    : SectionShape(parameters, rail_surface(*parameters.profile))
  {}

  void RailShape::check(const unsigned int, const bool rigid) const
  {
    if (!rigid)
      parameters.require(parameters.block_length >= least_rail &&
                           parameters.block_length <= longest_rail,
                         "Block length",
                         parameters.block_length,
                         "with Profiles/Body sections = true it is the length "
                         "of the rail; give 0.2 to 5 m.");
  }

  std::shared_ptr<const ExtrudedSection> RailShape::extruded_section() const
  {
    CoarseCells along;
    along.size = along.half_core = reach_x();
    return std::make_shared<const ExtrudedSection>(
      ExtrudedSection{unfolded_section(section_cells.front()),
                      sweep(along).first});
  }

  double RailShape::reach_x() const
  {
    return parameters.block_length / 2;
  }

  double RailShape::largest_coarse_size() const
  {
    return longest_rail_cell;
  }

  SectionMesh RailShape::section(const CoarseCells &across,
                                 const double       deepest) const
  {
    return rail_section_mesh(surface, across, deepest);
  }

  std::pair<SectionPlacement, std::vector<double>>
  RailShape::sweep(const CoarseCells &along) const
  {
    const SectionPoint contact = surface_point(0.);
    SectionPlacement   placement;
    placement.contact = {{contact[0], contact[1]}};
    placement.turn    = placed.turn;
    placement.is_left = placed.is_left;
    return {placement, break_points(-reach_x(), reach_x(), along)};
  }

  SectionPoint RailShape::surface_point(const double coordinate) const
  {
    const auto point = surface.at(coordinate);
    return {{point[0], Profiles::rail_60e1_height - point[1], 0.}};
  }

  WheelShape::WheelShape(const ShapeSpec &parameters)
    : SectionShape(parameters, wheel_surface(*parameters.profile))
  {}

  void WheelShape::check(const unsigned int, const bool rigid) const
  {
    if (rigid)
      return;
    const double largest = parameters.radius - WheelMeasures::rim_depth -
                           WheelMeasures::hub_depth -
                           WheelMeasures::shortest_web;
    parameters.require(
      parameters.hub_radius >= least_bore && parameters.hub_radius <= largest,
      "Hub radius",
      parameters.hub_radius,
      "with Profiles/Body sections = true it is the bore of a wheel with a rim "
      "of 0.068 m, a web and a hub of 0.04 m; give " +
        significant(least_bore, 3) + " m up to " +
        (largest < least_bore
           ? "a wheel with a Wheel/Radius of " +
               significant(parameters.radius + least_bore - largest, 3) +
               " m or more."
           : significant(largest, 3) + " m."));
    if (!(std::abs(placed.bow) <= largest_bow))
      throw InputError("Profiles/Web bow = " + significant(placed.bow, 6) +
                       ": give metres, from -0.04 to 0.04.");
  }

  double WheelShape::thickness_below() const
  {
    return surface_point(0.)[1] - parameters.hub_radius;
  }

  std::optional<Axle> WheelShape::axle() const
  {
    CoarseCells cells;
    cells.size = cells.half_core  = reach_x();
    const SectionPlacement placed = sweep(cells).first;
    // towards positive y on the left as well: the rim flows in +x
    const double way   = placed.is_left ? -1. : 1.;
    const auto   point = placed.to_body(0., {{0., 0., 1.}}),
               other   = placed.to_body(0., {{way, 0., 1.}});
    return Axle{
      point, {{other[0] - point[0], other[1] - point[1], other[2] - point[2]}}};
  }

  std::optional<SectionMesh> WheelShape::section_about_axle() const
  {
    const SectionMesh all = unfolded_section(section_cells.front());
    return placed.is_left ? all.mirrored() : all;
  }

  double WheelShape::reach_x() const
  {
    return usable_rim * parameters.radius;
  }

  double WheelShape::largest_half_width() const
  {
    return parameters.radius;
  }

  double WheelShape::largest_coarse_size() const
  {
    return longest_wheel_cell * parameters.radius;
  }

  SectionMesh WheelShape::section(const CoarseCells &across,
                                  const double       deepest) const
  {
    return wheel_section_mesh(placed,
                              surface,
                              {placed.radius, parameters.hub_radius},
                              surface_point(0.)[1],
                              across,
                              deepest);
  }

  std::pair<SectionPlacement, std::vector<double>>
  WheelShape::sweep(const CoarseCells &along) const
  {
    const SectionPoint contact = surface_point(0.);
    SectionPlacement   placement;
    placement.contact = {{contact[0], contact[1]}};
    placement.turn    = placed.turn;
    placement.is_left = placed.is_left;
    placement.around.emplace(contact[1], along);
    std::vector<double> ends = placement.around->edges();
    for (double &end : ends)
      end -= placement.around->contact();
    return {placement, ends};
  }

  SectionPoint WheelShape::surface_point(const double coordinate) const
  {
    const auto   point  = surface.at(coordinate);
    const double radius = placed.radius + point[1];
    return {{point[0], radius, radius}};
  }
} // namespace RollingContact
