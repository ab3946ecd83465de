#include <deal.II/base/parameter_handler.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/input/prm_declarations.h>
#include <rolling_contact/scene/mesh_parameters.h>

#include <cmath>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    const std::vector<NamedValue<RimEdges>> named_rim_edges{
      {"leading", RimEdges::leading},
      {"both", RimEdges::both}};
    const std::vector<NamedValue<LevelMarking>> named_markings{
      {"adaptive", LevelMarking::adaptive},
      {"uniform", LevelMarking::uniform}};



    std::optional<double>
    offset_of(const std::string &text)
    {
      if (text == "aligned")
        return {};
      const std::optional<double> value = number(text);
      if (value && std::abs(*value) <= 1.)
        return value;
      throw InputError(
        "Mesh/Patch offset = " + text +
        ": give a number of elements from -1 to 1, or `aligned`.");
    }
  } // namespace



  void
  MeshParameters::declare(ParameterHandler &prm)
  {
    prm.enter_subsection("Mesh");
    declare_patch(prm);
    declare_zone(prm);
    declare_levels(prm);
    prm.leave_subsection();
  }



  void
  MeshParameters::declare_patch(ParameterHandler &prm)
  {
    declare_number(
      prm,
      "Mesh/Target error",
      target_error,
      "parts of mu N",
      "Largest bound of the error of the force, over mu N, for quasi-static, "
      "creep curve (its worst point) and load curve: elements and growth that "
      "keep it at the least cost are chosen. `Elements across patch` is then "
      "the least and `Growth` the largest, where they are not the default. "
      "Errors are mostly below half of the bound. Empty: the elements "
      "and the growth given. Units: 1.");
    prm.add_parameter(
      "Elements across patch",
      elements_across_patch,
      "Elements across the patch of the Hertz estimate, in the rolling "
      "direction. 48 is for 2D; in 3D 12 to 24 are usual. Units: 1.",
      Patterns::Integer(1, 100000));
    prm.add_parameter(
      "Elements across patch y",
      elements_across_patch_y,
      "The same across the rolling direction, 3D only; 0: as many "
      "as in it, but 6 or more and elements at most 1.9 times as long as wide "
      "on patches that are slender along it, and as long as wide on those "
      "of profiles that are wider. 0.8 times as many serve the forces as well, the "
      "spin moment less. Units: 1.",
      Patterns::Integer(0, 100000));
    prm.declare_entry(
      "Patch offset",
      "0",
      Patterns::Anything(),
      "Shift of the mesh under the patch, in elements; `aligned` puts "
      "the leading edge where upwind 2 is most accurate, 0.38 elements "
      "upstream of a node. Units: 1.");
    prm.add_action("Patch offset", [this](const std::string &text) {
      patch_offset = offset_of(text);
    });
  }



  void
  MeshParameters::check() const
  {
    if (target_error && (*target_error <= 0. || *target_error >= 1.))
      throw InputError(
        "Mesh/Target error = " + text_of(*target_error) +
        ": give a number above 0 and below 1, parts of mu N such as 5e-3, or "
        "leave it empty.");
  }



  void
  MeshParameters::declare_zone(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Candidate zone",
      candidate_zone,
      "Half-length of the zone of contact nodes, over the half-width of "
      "the Hertz estimate; 0 takes 1.15, and 1.5 in time. A load curve "
      "takes 5 % more, for the loads above the largest. Units: 1.",
      Patterns::Double(0., 20.));
    prm.add_parameter(
      "Zone depth",
      zone_depth,
      "Depth of the zone of smallest elements, over the half-width of the "
      "Hertz estimate. Units: 1.",
      Patterns::Double(0., 20.));
    prm.add_parameter(
      "Growth",
      growth,
      "Growth of the element size with the distance from that zone. In 3D 0.4 "
      "to 0.8 are usual. Units: 1.",
      Patterns::Double(0.01, 10.));
    prm.add_parameter(
      "Rim levels",
      rim_levels,
      "Further halvings of the element size at the rim of the patch. "
      "Units: 1.",
      Patterns::Integer(0, 10));
    declare_choice(prm,
                   "Rim edges",
                   rim_edges,
                   named_rim_edges,
                   "Which part of the rim: `leading` or `both`.");
  }



  void
  MeshParameters::declare_levels(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Adaptive levels",
      adaptive_levels,
      "Solve again on at most so many refined meshes. Units: 1.",
      Patterns::Integer(0, 20));
    declare_choice(
      prm,
      "Level marking",
      level_marking,
      named_markings,
      "What a level refines: `adaptive` halves the elements at the leading "
      "edge, between stick and slip, at the rest of the rim and, in the bulk, "
      "where the strain jumps most; `uniform` halves all.");
    prm.add_parameter("Contact node budget",
                      contact_node_budget,
                      "Levels end before the mesh has more contact nodes than "
                      "this. Units: 1.",
                      Patterns::Integer(3, 100000));
    prm.add_parameter(
      "Target change",
      target_change,
      "Levels end when forces change less than this from one to the next, "
      "relative to N and to mu N; 0: never. Units: 1.",
      Patterns::Double(0., 1.));
  }

} // namespace RollingContact
