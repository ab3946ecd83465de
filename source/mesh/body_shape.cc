#include <rolling_contact/base/choices.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/mesh/block_shape.h>
#include <rolling_contact/mesh/disc_shape.h>
#include <rolling_contact/mesh/mesh_file_shape.h>
#include <rolling_contact/mesh/section_file_shape.h>
#include <rolling_contact/references/line_contact_approach.h>

#include <algorithm>
#include <typeinfo>

namespace RollingContact
{
  namespace
  {
    template <class Shape>
    std::shared_ptr<const BodyShape> make(const ShapeSpec &parameters)
    {
      return std::make_shared<Shape>(parameters);
    }
  } // namespace

  const std::vector<BodyShapeKind> &body_shape_kinds()
  {
    static const std::vector<BodyShapeKind> kinds{
      {"disc", "held at its inner circle", &make<DiscShape>},
      {"block", "held at its bottom", &make<BlockShape>},
      {"mesh file",
       "read from Mesh file and held at its hub boundary",
       &make<MeshFileShape>,
       true},
      {"section",
       "quadrilaterals from Mesh file, revolved about the axle or extruded "
       "along the rail, and held at its hub boundary (3D only)",
       &make<SectionFileShape>,
       true,
       true}};
    return kinds;
  }

  std::string body_shape_help()
  {
    std::string help;
    for (const BodyShapeKind &kind : body_shape_kinds())
      help += (help.empty()                          ? "`"
               : &kind == &body_shape_kinds().back() ? "; or `"
                                                     : "; `") +
              kind.name + "`, " + kind.help;
    return help + ".";
  }

  std::shared_ptr<const BodyShape> make_body_shape(const std::string &name,
                                                   const ShapeSpec &parameters)
  {
    return choice(body_shape_kinds(), name, parameters.section + "/Shape")
      .make(parameters);
  }

  void ShapeParameters::require(const bool         condition,
                                const std::string &entry,
                                const double       value,
                                const std::string &allowed) const
  {
    if (!condition)
      throw InputError(section + "/" + entry + " = " + significant(value, 6) +
                       ": " + allowed);
  }

  namespace
  {
    /// of the profile over the thickness: the chart degenerates at 1
    constexpr double largest_fall = 0.9;
  } // namespace

  BodyShape::BodyShape(const ShapeSpec &parameters)
    : parameters(parameters)
  {}

  double BodyShape::surface_height(const double x, const double y) const
  {
    return -crown_depth(parameters.radius, x) -
           crown_depth(parameters.lateral_radius, y);
  }

  double BodyShape::reach_y() const
  {
    return parameters.width / 2;
  }

  double BodyShape::largest_half_width() const
  {
    return reach_x();
  }

  double BodyShape::line_compression(const References::HertzLine &contact,
                                     const double                 young_modulus,
                                     const double poisson_ratio) const
  {
    return References::compression_of_layer(thickness_below(),
                                            young_modulus,
                                            poisson_ratio,
                                            contact);
  }

  std::optional<References::Annulus>
  BodyShape::clamped_annulus(const double, const double) const
  {
    return {};
  }

  std::optional<SectionMesh> BodyShape::section_about_axle() const
  {
    return {};
  }

  std::shared_ptr<const ExtrudedSection> BodyShape::extruded_section() const
  {
    return nullptr;
  }

  std::optional<Axle> BodyShape::axle() const
  {
    return std::nullopt;
  }

  double BodyShape::largest_coarse_size() const
  {
    return 2 * reach_x() / 3;
  }

  std::unique_ptr<SurfaceChart> BodyShape::chart(const CoarseCells &) const
  {
    return nullptr;
  }

  double BodyShape::distance_to_edge() const
  {
    if (is_swept() || parameters.mesh)
      return 0.;
    const auto across = room_across();
    return std::min({reach_x(), -across[0], across[1], thickness_below()});
  }

  std::array<double, 2> BodyShape::room_across() const
  {
    return {{-reach_y(), reach_y()}};
  }

  bool BodyShape::is_swept() const
  {
    return false;
  }

  std::shared_ptr<const SweptMesh> BodyShape::swept_mesh(const CoarseCells &,
                                                         const CoarseCells &,
                                                         const double) const
  {
    return nullptr;
  }

  bool BodyShape::has_own_cells() const
  {
    return false;
  }

  std::vector<ZoneBox>
  BodyShape::on_surface(const std::vector<ZoneBox> &boxes) const
  {
    return boxes;
  }

  std::shared_ptr<const SweptMesh> BodyShape::equal_cells(const double,
                                                          const double) const
  {
    return nullptr;
  }

  std::shared_ptr<const FileMesh> BodyShape::mesh() const
  {
    return nullptr;
  }

  bool BodyShape::is_twin_of(const BodyShape &other) const
  {
    return is_same_as(other) && !mesh() && !is_swept();
  }

  bool BodyShape::is_same_as(const BodyShape &other) const
  {
    return typeid(*this) == typeid(other) && hub() == other.hub() &&
           parameters.mesh == other.parameters.mesh &&
           parameters.profile == other.parameters.profile &&
           parameters.cover_thickness == other.parameters.cover_thickness &&
           dimensions() == other.dimensions();
  }

  void BodyShape::check_extent(const unsigned int dimension,
                               const double       end_x) const
  {
    if (dimension == 3)
      parameters.require(parameters.width > 0.,
                         "Width",
                         parameters.width,
                         "it must be above 0 m.");
    const double fall =
      -surface_height(end_x, dimension == 3 ? parameters.width / 2 : 0.);
    if (fall >= largest_fall * thickness_below())
      throw InputError(
        parameters.section + ": at its ends the profile lies " +
        significant(fall, 6) +
        " m below the contact point, and the body is only " +
        significant(thickness_below(), 6) +
        " m thick there: take larger radii, a narrower or a thicker body.");
  }
} // namespace RollingContact
