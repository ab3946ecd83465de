#include <deal.II/base/parameter_handler.h>

#include <rolling_contact/base/choices.h>
#include <rolling_contact/input/prm_declarations.h>
#include <rolling_contact/mesh/section_shapes.h>
#include <rolling_contact/mesh_files/mesh_file.h>
#include <rolling_contact/mesh_files/section_file.h>
#include <rolling_contact/scene/body_parameters.h>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    const std::vector<NamedValue<SurfaceSource>> named_surfaces{
      {"radii", SurfaceSource::radii},
      {"nodes", SurfaceSource::nodes}};
  } // namespace



  BodyParameters::BodyParameters(const std::string &section)
  {
    this->section = section;
  }



  void
  BodyParameters::declare(ParameterHandler &prm)
  {
    prm.enter_subsection(section);
    declare_profile(prm);
    declare_extent(prm);
    declare_mesh_file(prm);
    declare_material(prm);
    declare_hub(prm);
    declare_foundation(prm);
    declare_damping(prm);
    declare_points(prm);
    declare_dampers(prm);
    prm.leave_subsection();
  }



  void
  BodyParameters::declare_profile(ParameterHandler &prm)
  {
    const Patterns::Double any;
    prm.add_parameter("Shape",
                      shape,
                      body_shape_help(),
                      Patterns::Selection(choice_names(body_shape_kinds())));
    prm.add_parameter("Rigid",
                      rigid,
                      "A rigid body is a profile without mesh or compliance.");
    prm.add_parameter(
      "Radius",
      radius,
      "Radius of the profile in the rolling direction. For a block or a mesh "
      "file, 0 is flat and a negative radius is concave; a section is revolved "
      "about an axle so far behind the contact point, with 0 extruded. Units: "
      "m.",
      any);
    prm.add_parameter(
      "Lateral radius",
      lateral_radius,
      "Radius of the profile across the rolling direction, 3D only; 0 "
      "is flat, negative concave. Units: m.",
      any);
  }



  void
  BodyParameters::declare_extent(ParameterHandler &prm)
  {
    const Patterns::Double not_negative(0.);
    prm.add_parameter("Hub radius",
                      hub_radius,
                      "Radius of the inner circle of a disc. Units: m.",
                      not_negative);
    prm.add_parameter("Block length",
                      block_length,
                      "Extent of a block, or of a section that is extruded, in "
                      "the rolling direction. Units: m.",
                      not_negative);
    prm.add_parameter("Block depth",
                      block_depth,
                      "Depth of a block, from the contact point to its bottom. "
                      "Units: m.",
                      not_negative);
    prm.add_parameter(
      "Thickness",
      thickness,
      "Thickness in 2D (plane strain), the same for both bodies. "
      "Units: m.",
      not_negative);
    prm.add_parameter("Width",
                      width,
                      "Extent across the rolling direction, 3D only. Units: m.",
                      not_negative);
  }



  void
  BodyParameters::declare_mesh_file(ParameterHandler &prm)
  {
    const Patterns::Double not_negative(0.);
    prm.add_parameter(
      "Mesh file",
      mesh_file,
      "Gmsh .msh or Abaqus .inp file of quadrilaterals (2D) or "
      "hexahedra (3D), relative to the folder of the .prm file. x "
      "is the rolling direction, z (in 2D the file's y) goes from "
      "rail to wheel, the contact point is the origin, the wheel "
      "lies above it and the rail below. For Shape = section "
      "quadrilaterals of the section: the file's x is y, across, its y is z, "
      "so that an axle lies at z = Radius (wheel) or -Radius; with section "
      "Profiles its axes are those of the body's profile.",
      Patterns::Anything());
    prm.add_parameter(
      "Mesh unit",
      mesh_unit,
      "Length of one unit of the mesh file, 0.001 for millimetres. "
      "Units: m.",
      not_negative);
    prm.add_parameter(
      "Contact boundary id",
      contact_boundary,
      "Of the part of the mesh file's boundary that may touch: a "
      "physical group of Gmsh, or the digits in the name of an "
      "Abaqus surface. Units: 1.",
      Patterns::Integer(1));
    prm.add_parameter("Hub boundary id",
                      hub_boundary,
                      "The same of the part that is the hub. Units: 1.",
                      Patterns::Integer(1));
    prm.add_parameter("Cells along",
                      cells_along,
                      "Number of equal cells of a section round its axle or "
                      "along the rail; those at the patch are divided as the "
                      "contact needs. Units: 1.",
                      Patterns::Integer(1));
    declare_choice(
      prm,
      "Surface",
      surface,
      named_surfaces,
      "Undeformed surface of a mesh file's contact boundary: "
      "`radii` takes Radius and Lateral radius, which its nodes "
      "must lie on, and keeps facets out of the gap; `nodes` takes "
      "the nodes, and the radii for the estimate of the patch only.");
  }



  void
  BodyParameters::declare_material(ParameterHandler &prm)
  {
    const Patterns::Double not_negative(0.);
    prm.add_parameter("Young modulus",
                      material.young_modulus,
                      "Young's modulus. Units: Pa.",
                      not_negative);
    prm.add_parameter("Poisson ratio",
                      material.poisson_ratio,
                      "Poisson's ratio, at least 0 and below 0.5. Units: 1.",
                      Patterns::Double(0., 0.5));
    prm.add_parameter("Density",
                      material.density,
                      "Mass density, for analyses with inertia and flash "
                      "temperatures. Units: kg/m^3.",
                      not_negative);
    prm.add_parameter("Thermal conductivity",
                      thermal_conductivity,
                      "For flash temperatures. Units: W/(m K).",
                      not_negative);
    prm.add_parameter("Heat capacity",
                      heat_capacity,
                      "For flash temperatures. Units: J/(kg K).",
                      not_negative);
  }



  void
  BodyParameters::declare_points(ParameterHandler &prm)
  {
    const std::string what =
      section == "Wheel"
        ? "name: radius in m, angle from the contact in degrees (towards +x), "
          "position along the axle in m (towards +y), several separated by "
          "semicolons, such as `tread: 0.46, 90, 0; web: 0.3, 0, 0.01`. They stay "
          "where they are as the wheel turns. Units: m, degrees."
        : "name: x, y, z in m from the contact point, z upwards, several "
          "separated by semicolons, such as `foot: 0.3, 0, -0.17`. Units: m.";
    prm.add_parameter("Velocity points",
                      velocity_points,
                      "Points whose velocities Analysis = transient with "
                      "inertia writes into history.csv, columns "
                      "velocity_NAME_x_m/s, ...; a section from a file under "
                      "profiles has its file's origin in place of the contact. "
                      "Of each, " +
                        what);
  }



  void
  BodyParameters::check(const unsigned int dimension) const
  {
    const auto &kind = choice(body_shape_kinds(), shape, section + "/Shape");
    if (!kind.from_file && !mesh_file.empty())
      throw InputError(section + "/Mesh file = " + mesh_file +
                       ": it is read with Shape = mesh file or section only.");
    if (dimension == 2)
      require(lateral_radius == 0.,
              "Lateral radius",
              lateral_radius,
              "in 2D the profile is straight across; set it to 0 or take "
              "Dimension = 3.");
    body_shape()->check(dimension, rigid);
    check_model();
    check_dampers(dimension);
    if (!rigid)
      check_material(dimension);
  }



  void
  BodyParameters::check_material(const unsigned int dimension) const
  {
    require(material.young_modulus > 0.,
            "Young modulus",
            material.young_modulus,
            "it must be above 0 Pa; take Rigid = true for a rigid body.");
    require(material.poisson_ratio < 0.5,
            "Poisson ratio",
            material.poisson_ratio,
            "it must be below 0.5; 0.4999 is as good as incompressible.");
    require(material.density > 0.,
            "Density",
            material.density,
            "it must be above 0 kg/m^3.");
    require(thermal_conductivity > 0.,
            "Thermal conductivity",
            thermal_conductivity,
            "it must be above 0 W/(m K); steel has 50.");
    require(heat_capacity > 0.,
            "Heat capacity",
            heat_capacity,
            "it must be above 0 J/(kg K); steel has 460.");
    if (dimension == 2)
      require(thickness > 0., "Thickness", thickness, "it must be above 0 m.");
  }



  void
  BodyParameters::read_mesh(const unsigned int           dimension,
                            const std::filesystem::path &folder,
                            const bool                   is_under_profile)
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
    file.has_hub          = hub != Hub::free;
    file.mirrored         = section == "Wheel";
    file.is_section       = is_section();
    file.is_under_profile = is_under_profile && is_section();
    mesh                  = is_section()     ? read_section_file(file, radius)
                            : dimension == 2 ? read_mesh_file<2>(file)
                                             : read_mesh_file<3>(file);
  }



  std::shared_ptr<const BodyShape>
  BodyParameters::body_shape() const
  {
    if (!profile || is_from_file())
      return make_body_shape(shape, *this);
    if (section == "Wheel")
      return std::make_shared<const WheelShape>(*this);
    return std::make_shared<const RailShape>(*this);
  }



  bool
  BodyParameters::is_from_file() const
  {
    return !rigid &&
           choice(body_shape_kinds(), shape, section + "/Shape").from_file;
  }



  bool
  BodyParameters::is_section() const
  {
    return is_from_file() &&
           choice(body_shape_kinds(), shape, section + "/Shape").is_section;
  }
} // namespace RollingContact
