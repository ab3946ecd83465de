#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/elasticity/body_parameters.h>

namespace RollingContact
{
  using namespace dealii;

  BodyParameters::BodyParameters(const std::string &section)
    : ParameterAcceptor("/" + section)
    , section(section)
  {
    const Patterns::Double any, not_negative(0.);
    add_parameter("Shape",
                  shape,
                  "`disc`, held at its inner circle, or `block`, held at its "
                  "bottom.",
                  prm,
                  Patterns::Selection("disc|block"));
    add_parameter("Rigid",
                  rigid,
                  "A rigid body is a profile without mesh or compliance.");
    add_parameter(
      "Radius",
      radius,
      "Radius of the profile in the rolling direction. For a block, 0 "
      "is flat and a negative radius is concave. Units: m.",
      prm,
      any);
    add_parameter(
      "Lateral radius",
      lateral_radius,
      "Radius of the profile across the rolling direction, 3D only; 0 "
      "is flat, negative concave. Units: m.",
      prm,
      any);
    add_parameter("Hub radius",
                  hub_radius,
                  "Radius of the inner circle of a disc. Units: m.",
                  prm,
                  not_negative);
    add_parameter("Block length",
                  block_length,
                  "Extent of a block in the rolling direction. Units: m.",
                  prm,
                  not_negative);
    add_parameter("Block depth",
                  block_depth,
                  "Depth of a block, from the contact point to its bottom. "
                  "Units: m.",
                  prm,
                  not_negative);
    add_parameter("Thickness",
                  thickness,
                  "Thickness in 2D (plane strain), the same for both bodies. "
                  "Units: m.",
                  prm,
                  not_negative);
    add_parameter("Width",
                  width,
                  "Extent across the rolling direction, 3D only. Units: m.",
                  prm,
                  not_negative);
    add_parameter("Hub",
                  hub,
                  "What the inner circle of a disc or the bottom of a block "
                  "does: `clamped`, or `free` in a transient analysis, where "
                  "inertia alone holds the body.",
                  prm,
                  Patterns::Selection("clamped|free"));
    add_parameter("Young modulus",
                  material.young_modulus,
                  "Young's modulus. Units: Pa.",
                  prm,
                  not_negative);
    add_parameter("Poisson ratio",
                  material.poisson_ratio,
                  "Poisson's ratio, at least 0 and below 0.5. Units: 1.",
                  prm,
                  Patterns::Double(0., 0.5));
    add_parameter("Density",
                  material.density,
                  "Mass density, for analyses with inertia. Units: kg/m^3.",
                  prm,
                  not_negative);
  }



  namespace
  {
    void
    require(const bool         condition,
            const std::string &section,
            const std::string &entry,
            const double       value,
            const std::string &allowed)
    {
      if (!condition)
        throw InputError(section + "/" + entry + " = " +
                         Patterns::Tools::to_string(value) + ": " + allowed);
    }
  } // namespace



  void
  BodyParameters::check(const unsigned int dimension) const
  {
    if (shape == "disc")
      {
        require(radius > 0.,
                section,
                "Radius",
                radius,
                "a disc needs a radius above 0 m; take Shape = block for a "
                "flat or concave body.");
        if (!rigid)
          require(hub_radius > 0. && hub_radius < radius,
                  section,
                  "Hub radius",
                  hub_radius,
                  "it must lie above 0 m and below the Radius.");
      }
    if (rigid && hub == "free")
      throw InputError(section + "/Hub = free: a rigid body is held; take "
                                 "Rigid = false or Hub = clamped.");
    if (rigid)
      return;
    if (shape == "block")
      {
        require(block_length > 0.,
                section,
                "Block length",
                block_length,
                "it must be above 0 m.");
        require(block_depth > 0.,
                section,
                "Block depth",
                block_depth,
                "it must be above 0 m.");
      }
    const BodyGeometry shape_of_body = geometry();
    const double       fall =
      -shape_of_body.surface_height(shape == "block" ? block_length / 2 : 0.,
                                    dimension == 3 ? width / 2 : 0.);
    if (fall >= 0.9 * shape_of_body.thickness_below())
      throw InputError(
        section + ": at its ends the profile lies " +
        Patterns::Tools::to_string(fall) +
        " m below the contact point, and the body is only " +
        Patterns::Tools::to_string(shape_of_body.thickness_below()) +
        " m thick there: take larger radii, a narrower or a thicker body.");
    require(material.young_modulus > 0.,
            section,
            "Young modulus",
            material.young_modulus,
            "it must be above 0 Pa; take Rigid = true for a rigid body.");
    require(material.poisson_ratio < 0.5,
            section,
            "Poisson ratio",
            material.poisson_ratio,
            "it must be below 0.5; 0.4999 is as good as incompressible.");
    require(material.density > 0.,
            section,
            "Density",
            material.density,
            "it must be above 0 kg/m^3.");
    if (dimension == 2)
      require(thickness > 0.,
              section,
              "Thickness",
              thickness,
              "it must be above 0 m.");
    else
      require(width > 0., section, "Width", width, "it must be above 0 m.");
  }



  BodyGeometry
  BodyParameters::geometry() const
  {
    BodyGeometry geometry;
    geometry.shape          = shape == "disc" ? Shape::disc : Shape::block;
    geometry.rigid          = rigid;
    geometry.radius         = radius;
    geometry.lateral_radius = lateral_radius;
    geometry.hub_radius     = hub_radius;
    geometry.length         = block_length;
    geometry.depth          = block_depth;
    geometry.width          = width;
    geometry.hub_clamped    = hub == "clamped";
    return geometry;
  }
} // namespace RollingContact
