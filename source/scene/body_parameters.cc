#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/mesh_files/mesh_file.h>
#include <rolling_contact/scene/body_parameters.h>

#include <algorithm>

namespace RollingContact
{
  using namespace dealii;

  BodyParameters::BodyParameters(const std::string &section)
    : ParameterAcceptor("/" + section)
    , section(section)
  {
    declare_profile();
    declare_extent();
    declare_mesh_file();
    declare_material();
  }



  void
  BodyParameters::declare_profile()
  {
    const Patterns::Double any;
    add_parameter("Shape",
                  shape,
                  "`disc`, held at its inner circle; `block`, held at its "
                  "bottom; or `mesh file`, read from Mesh file and held at its "
                  "hub boundary.",
                  prm,
                  Patterns::Selection("disc|block|mesh file"));
    add_parameter("Rigid",
                  rigid,
                  "A rigid body is a profile without mesh or compliance.");
    add_parameter(
      "Radius",
      radius,
      "Radius of the profile in the rolling direction. For a block or a mesh "
      "file, 0 is flat and a negative radius is concave. Units: m.",
      prm,
      any);
    add_parameter(
      "Lateral radius",
      lateral_radius,
      "Radius of the profile across the rolling direction, 3D only; 0 "
      "is flat, negative concave. Units: m.",
      prm,
      any);
  }



  void
  BodyParameters::declare_extent()
  {
    const Patterns::Double not_negative(0.);
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
  }



  void
  BodyParameters::declare_mesh_file()
  {
    const Patterns::Double not_negative(0.);
    add_parameter("Mesh file",
                  mesh_file,
                  "Gmsh .msh or Abaqus .inp file of quadrilaterals (2D) or "
                  "hexahedra (3D), relative to the folder of the .prm file. x "
                  "is the rolling direction, z (in 2D the file's y) goes from "
                  "rail to wheel, the contact point is the origin, the wheel "
                  "lies above it and the rail below.",
                  prm,
                  Patterns::Anything());
    add_parameter("Mesh unit",
                  mesh_unit,
                  "Length of one unit of the mesh file, 0.001 for millimetres. "
                  "Units: m.",
                  prm,
                  not_negative);
    add_parameter("Contact boundary id",
                  contact_boundary,
                  "Of the part of the mesh file's boundary that may touch: a "
                  "physical group of Gmsh, or the digits in the name of an "
                  "Abaqus surface. Units: 1.",
                  prm,
                  Patterns::Integer(1));
    add_parameter("Hub boundary id",
                  hub_boundary,
                  "The same of the part that is clamped. Units: 1.",
                  prm,
                  Patterns::Integer(1));
    add_parameter(
      "Surface",
      surface,
      "Undeformed surface of a mesh file's contact boundary: "
      "`radii` takes Radius and Lateral radius, which its nodes "
      "must lie on, and keeps facets out of the gap; `nodes` takes "
      "the nodes, and the radii for the estimate of the patch only.",
      prm,
      Patterns::Selection("radii|nodes"));
  }



  void
  BodyParameters::declare_material()
  {
    const Patterns::Double not_negative(0.);
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
    check_mesh_file();
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
    check_fall(dimension);
    check_material(dimension);
  }



  void
  BodyParameters::check_fall(const unsigned int dimension) const
  {
    if (is_from_file())
      return;
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
  }



  void
  BodyParameters::check_material(const unsigned int dimension) const
  {
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
    else if (!is_from_file())
      require(width > 0., section, "Width", width, "it must be above 0 m.");
  }



  void
  BodyParameters::check_mesh_file() const
  {
    const std::string given = section + "/Mesh file = " + mesh_file;
    if (!is_from_file())
      {
        if (!mesh_file.empty())
          throw InputError(given + ": it is read with Shape = mesh file only.");
        return;
      }
    if (mesh_file.empty())
      throw InputError(given + ": Shape = mesh file needs the name of a .msh "
                               "or .inp file.");
    if (rigid)
      throw InputError(section +
                       "/Shape = mesh file: a rigid body has no mesh; take "
                       "disc or block with its radii.");
    require(mesh_unit > 0.,
            section,
            "Mesh unit",
            mesh_unit,
            "it must be above 0 m; 0.001 for millimetres.");
    if (hub == "clamped" && contact_boundary == hub_boundary)
      throw InputError(section + "/Contact boundary id and " + section +
                       "/Hub boundary id are both " +
                       std::to_string(hub_boundary) +
                       ": the hub must be another part of the boundary.");
  }



  void
  BodyParameters::read_mesh(const unsigned int           dimension,
                            const std::filesystem::path &folder)
  {
    mesh.reset();
    if (!is_from_file())
      return;
    MeshFile file;
    file.section          = section;
    file.name             = mesh_file;
    file.path             = folder / mesh_file;
    file.unit             = mesh_unit;
    file.contact_boundary = contact_boundary;
    file.hub_boundary     = hub_boundary;
    file.has_hub          = hub == "clamped";
    file.mirrored         = section == "Wheel";
    mesh = dimension == 2 ? read_mesh_file<2>(file) : read_mesh_file<3>(file);
  }



  BodyGeometry
  BodyParameters::geometry() const
  {
    BodyGeometry geometry;
    geometry.shape          = shape == "disc"  ? Shape::disc
                              : is_from_file() ? Shape::mesh_file
                                               : Shape::block;
    geometry.rigid          = rigid;
    geometry.radius         = radius;
    geometry.lateral_radius = lateral_radius;
    geometry.hub_radius     = hub_radius;
    geometry.length         = block_length;
    geometry.depth          = block_depth;
    geometry.width          = width;
    geometry.hub_clamped    = hub == "clamped";
    geometry.mesh           = mesh;
    if (mesh)
      {
        geometry.length = 2 * std::min(-mesh->lower[0], mesh->upper[0]);
        geometry.width  = 2 * std::min(-mesh->lower[1], mesh->upper[1]);
        geometry.depth  = mesh->depth;
      }
    return geometry;
  }
} // namespace RollingContact
