#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/scene/mesh_parameters.h>

#include <cmath>

namespace RollingContact
{
  using namespace dealii;

  MeshParameters::MeshParameters()
    : ParameterAcceptor("/Mesh")
  {
    declare_patch();
    declare_zone();
    declare_levels();
  }



  void
  MeshParameters::declare_patch()
  {
    add_parameter(
      "Elements across patch",
      elements_across_patch,
      "Elements across the patch of the Hertz estimate, in the rolling "
      "direction. Units: 1.",
      prm,
      Patterns::Integer(1, 100000));
    add_parameter("Elements across patch y",
                  elements_across_patch_y,
                  "The same across the rolling direction, 3D only; 0: as many "
                  "as in it. 0.8 times as many serve the forces as well, the "
                  "spin moment less. Units: 1.",
                  prm,
                  Patterns::Integer(0, 100000));
    add_parameter(
      "Patch offset",
      patch_offset,
      "Shift of the mesh under the patch, in elements; `aligned` puts "
      "the leading edge where upwind 2 is most accurate, 0.38 elements "
      "upstream of a node. Units: 1.",
      prm,
      Patterns::Anything());
  }



  void
  MeshParameters::declare_zone()
  {
    add_parameter(
      "Candidate zone",
      candidate_zone,
      "Half-length of the zone of contact nodes, over the half-width of "
      "the Hertz estimate; 0 takes 1.15, and 1.5 in time. A load curve "
      "takes 5 % more, for the loads above the largest. Units: 1.",
      prm,
      Patterns::Double(0., 20.));
    add_parameter(
      "Zone depth",
      zone_depth,
      "Depth of the zone of smallest elements, over the half-width of the "
      "Hertz estimate. Units: 1.",
      prm,
      Patterns::Double(0., 20.));
    add_parameter(
      "Growth",
      growth,
      "Growth of the element size with the distance from that zone. "
      "Units: 1.",
      prm,
      Patterns::Double(0.01, 10.));
    add_parameter(
      "Rim levels",
      rim_levels,
      "Further halvings of the element size at the rim of the patch. "
      "Units: 1.",
      prm,
      Patterns::Integer(0, 10));
    add_parameter("Rim edges",
                  rim_edges,
                  "Which part of the rim: `leading` or `both`.",
                  prm,
                  Patterns::Selection("leading|both"));
  }



  void
  MeshParameters::declare_levels()
  {
    add_parameter("Adaptive levels",
                  adaptive_levels,
                  "Solve again on at most so many refined meshes. Units: 1.",
                  prm,
                  Patterns::Integer(0, 20));
    add_parameter(
      "Level marking",
      level_marking,
      "What a level refines: `adaptive` halves the elements at the leading "
      "edge, between stick and slip, at the rest of the rim and, in the bulk, "
      "where the strain jumps most; `uniform` halves all.",
      prm,
      Patterns::Selection("adaptive|uniform"));
    add_parameter("Contact node budget",
                  contact_node_budget,
                  "Levels end before the mesh has more contact nodes than "
                  "this. Units: 1.",
                  prm,
                  Patterns::Integer(3, 100000));
    add_parameter(
      "Target change",
      target_change,
      "Levels end when forces change less than this from one to the next, "
      "relative to N and to mu N; 0: never. Units: 1.",
      prm,
      Patterns::Double(0., 1.));
  }



  double
  MeshParameters::offset() const
  {
    if (aligned())
      return 0.;
    try
      {
        std::size_t  end   = 0;
        const double value = std::stod(patch_offset, &end);
        if (end == patch_offset.size() && std::abs(value) <= 1.)
          return value;
      }
    catch (const std::logic_error &)
      {}
    throw InputError("Mesh/Patch offset = " + patch_offset +
                     ": give a number of elements from -1 to 1, or `aligned`.");
  }



  void
  MeshParameters::check() const
  {
    offset();
  }
} // namespace RollingContact
