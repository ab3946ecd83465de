#include <rolling_contact/base/choices.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/mesh/mesh_file.h>
#include <rolling_contact/mesh/section_file.h>
#include <rolling_contact/mesh/section_shapes.h>
#include <rolling_contact/scene/body_parameters.h>
#include <rolling_contact/scene/entries.h>
#include <rolling_contact/scene/scene_parameters.h>

namespace RollingContact
{
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

  Reader BodyParameters::reader(bool (*reads)(const BodyParameters &),
                                const std::string &otherwise) const
  {
    const Side side = section == "Wheel" ? Side::wheel : Side::rail;
    return {[side, reads](const SceneParameters &scene) {
              return reads(scene.body(side));
            },
            otherwise};
  }

  void BodyParameters::declare(Entries &entries)
  {
    entries.section(section).varies = in_all_scenes;
    declare_profile(entries);
    declare_mesh_file(entries);
    declare_material(entries);
    declare_cover(entries);
    declare_hub(entries);
    declare_foundation(entries);
    declare_modes(entries);
    declare_damping(entries);
    declare_dampers(entries);
  }

  void BodyParameters::declare_profile(Entries &entries)
  {
    entries.add("Shape", shape).one_of(choice_names(body_shape_kinds())).help =
      body_shape_help();
    entries.add("Rigid", rigid).help =
      "Whether the body is rigid: a profile without mesh and compliance.";
    entries.add("Radius", radius, "m").help =
      "Radius of the profile in the rolling direction. For a block or a mesh "
      "file, 0 is flat and a negative radius is concave. A section is "
      "revolved about an axle at this distance behind the contact point; 0 "
      "extrudes it.";
    entries.add("Lateral radius", lateral_radius, "m").help =
      "Radius of the profile across the rolling direction, 3D only. 0 is "
      "flat; a negative radius is concave.";
    const Reader plain_sections{
      asks<AnalysisTraits, ProfileParameters>(
        [](const auto &analysis, const auto &profiles) {
          return !analysis.has_bodies || !profiles.has_true_sections();
        }),
      "Profiles/Body sections = true gives the bodies' sections"};
    entries.add("Hub radius", hub_radius, "m").at_least(0.).help =
      "Radius of the inner circle of a disc.";
    entries.add("Block length", block_length, "m").at_least(0.).help =
      "Extent of a block or of an extruded section in the rolling direction.";
    const std::vector<Reader> of_block =
      section == "Rail" ? std::vector{plain_sections} : std::vector<Reader>();
    entries.add("Block depth", block_depth, "m")
      .at_least(0.)
      .read_by(of_block)
      .help = "Depth of a block, from the contact point to its bottom.";
    entries.add("Thickness", thickness, "m")
      .at_least(0.)
      .read_by(
        {[](const SceneParameters &scene) { return scene.dimension == 2; },
         "it is the thickness of plane strain (Dimension = 2); in 3D a body "
         "has a Width"})
      .help = "Thickness in 2D (plane strain), the same for both bodies.";
    entries.add("Width", width, "m")
      .at_least(0.)
      .read_by(scenes_in_3d())
      .read_by(plain_sections)
      .help = "Extent across the rolling direction, 3D only.";
  }

  void BodyParameters::declare_mesh_file(Entries &entries)
  {
    entries.add("Mesh file", mesh_file).help =
      "Gmsh .msh or Abaqus .inp file of quadrilaterals (2D) or hexahedra "
      "(3D), relative to the folder of the .prm file. x is the rolling "
      "direction and z (in 2D the file's y) points from rail to wheel. The "
      "contact point is the origin; the wheel lies above it and the rail "
      "below. For Shape = section the file has quadrilaterals of the section: "
      "its x is y (across) and its y is z, so that an axle lies at z = Radius "
      "(wheel) or -Radius (rail). With section Profiles its axes are those of "
      "the body's profile.";
    entries.add("Mesh unit", mesh_unit, "m").at_least(0.).help =
      "Length of one unit of the mesh file, 0.001 for millimetres.";
    entries.add("Contact boundary id", contact_boundary, "1").at_least(1).help =
      "Number of the part of the mesh file's boundary that may touch: a "
      "physical group of Gmsh, or the digits in the name of an Abaqus surface.";
    entries.add("Hub boundary id", hub_boundary, "1").at_least(1).help =
      "Number of the part of the mesh file's boundary that is the hub, given "
      "as in Contact boundary id.";
    entries.add("Cells along", cells_along, "1").between(1, 100000).help =
      "Number of equal cells of a section round its axle or along the rail. "
      "Cells at the patch are divided as the contact needs.";
    entries.choice("Surface", surface, named_surfaces).help =
      "Undeformed surface of a mesh file's contact boundary. `radii`: it has "
      "Radius and Lateral radius, its nodes must lie on that shape, and the "
      "facets do not show in the gap. `nodes`: it goes through the nodes, and "
      "the radii serve the estimate of the patch only.";
  }

  void BodyParameters::declare_material(Entries &entries)
  {
    entries.add("Young modulus", material.young_modulus, "Pa")
      .at_least(0.)
      .help = "Young's modulus.";
    entries.add("Poisson ratio", material.poisson_ratio, "1")
      .between(0., 0.5)
      .help = "Poisson's ratio, at least 0 and below 0.5.";
    entries.add("Density", material.density, "kg/m^3").at_least(0.).help =
      "Mass density, for analyses with inertia and flash temperatures.";
    entries.add("Thermal conductivity", thermal_conductivity, "W/(m K)")
      .at_least(0.)
      .help = "Thermal conductivity, for flash temperatures.";
    entries.add("Heat capacity", heat_capacity, "J/(kg K)").at_least(0.).help =
      "Specific heat capacity, for flash temperatures.";
    entries.add("Temperature", temperature, "K").at_least(150.).help =
      "Temperature of the body away from the contact, to which the flash "
      "temperature is added. 20 degrees Celsius are 293.15 K.";
    const std::string what =
      section == "Wheel"
        ? "name: radius in m, angle from the contact in degrees (towards +x), "
          "position along the axle in m (towards +y). Separate several by "
          "semicolons, such as `tread: 0.46, 90, 0; web: 0.3, 0, 0.01`. The "
          "points stay where they are as the wheel turns."
        : "name: x, y, z in m from the contact point, z upwards. Separate "
          "several by semicolons, such as `foot: 0.3, 0, -0.17`.";
    const std::string unit = section == "Wheel" ? "m, degrees" : "m";
    entries.add("Velocity points", velocity_points, unit)
      .read_by(reader([](const BodyParameters &body) { return !body.rigid; },
                      "a rigid body has no velocity of its own"))
      .read_by({asks<AnalysisTraits, TimeParameters>(
                  [](const auto &analysis, const auto &time) {
                    return analysis.records_run && time.inertia;
                  }),
                "Analysis = transient with Time/Inertia = true reads it"})
      .help = "Points whose velocities Analysis = transient with inertia "
              "writes into history.csv, as columns velocity_NAME_x_m/s and so "
              "on. In a section from a file under profiles, the origin of the "
              "file takes the place of the contact. Give each point as " +
              what;
  }

  void BodyParameters::check(const unsigned int dimension) const
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
    const double largest = 1e6; // m
    for (const auto &[entry, value] :
         {std::pair("Radius", radius),
          std::pair("Lateral radius", lateral_radius)})
      require(std::abs(value) <= largest,
              entry,
              value,
              "at most 1e6 m; a flat surface has 0.");
    check_with(*make_body_shape(shape, *this), !is_from_file(), dimension);
  }

  void BodyParameters::check_with(const BodyShape   &body_shape,
                                  const bool         is_read,
                                  const unsigned int dimension) const
  {
    const BodyShape *known = is_read ? &body_shape : nullptr;
    body_shape.check(dimension, rigid);
    check_model(known);
    check_modes(known, dimension);
    check_dampers(known, dimension);
    check_cover();
    if (!rigid)
      check_material(dimension);
  }

  void BodyParameters::check_material(const unsigned int dimension) const
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

  void BodySpec::check(const unsigned int dimension) const
  {
    check_with(*body_shape(), true, dimension);
  }

  void BodySpec::hold_axle()
  {
    if (rigid || hub != Hub::mass)
      return;
    axle_mass = model.hub_mass;
    hub       = Hub::clamped;
  }

  void BodySpec::read_mesh(const unsigned int           dimension,
                           const std::filesystem::path &folder,
                           const bool                   is_under_profile)
  {
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

  std::shared_ptr<const BodyShape> BodySpec::body_shape() const
  {
    const ShapeSpec spec(*this, mesh, profile);
    if (!profile || is_from_file())
      return make_body_shape(shape, spec);
    if (section == "Wheel")
      return std::make_shared<const WheelShape>(spec);
    return std::make_shared<const RailShape>(spec);
  }

  bool BodyParameters::is_from_file() const
  {
    return !rigid &&
           choice(body_shape_kinds(), shape, section + "/Shape").from_file;
  }

  bool BodyParameters::is_section() const
  {
    return is_from_file() &&
           choice(body_shape_kinds(), shape, section + "/Shape").is_section;
  }
} // namespace RollingContact
