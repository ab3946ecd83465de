#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/scene/analysis_traits.h>
#include <rolling_contact/scene/entries.h>
#include <rolling_contact/scene/mesh_parameters.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    const std::vector<NamedValue<RimEdges>> named_rim_edges{
      {"leading", RimEdges::leading},
      {"both", RimEdges::both}};
    const std::vector<NamedValue<LevelMarking>> named_markings{
      {"adaptive", LevelMarking::adaptive},
      {"uniform", LevelMarking::uniform}};

    const std::vector<NamedValue<Compliance>> named_compliances{
      {"automatic", Compliance::automatic},
      {"finite elements", Compliance::finite_elements},
      {"split", Compliance::split}};

    std::optional<double> offset_of(const std::string &text)
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

  void MeshParameters::declare(Entries &entries)
  {
    EntrySection &section = entries.section("Mesh");
    section.read_by(analyses_with_elements()).read_by(analyses_of_contact());
    section.varies = in_all_scenes;
    declare_patch(entries);
    declare_zone(entries);
  }

  void MeshParameters::declare_patch(Entries &entries)
  {
    entries.add("Target error", target_error, "1")
      .read_by({asks<AnalysisTraits>(
                  [](const auto &analysis) { return !analysis.records_run; }),
                "the error of a time step is not known beforehand; "
                "Mesh/Elements across patch gives the mesh"})
      .read_by({asks<AnalysisTraits>([](const auto &analysis) {
                  return !analysis.has_own_meshes;
                }),
                "a study has its own meshes, Accuracy study/Elements across "
                "patch"})
      .help =
      "Largest bound of the error of the force, over mu N, for quasi-static, "
      "creep curve (its worst point) and load curve. The program chooses the "
      "cheapest mesh that keeps it; `Elements across patch` and `Growth` have "
      "no effect then. Errors are mostly below half of the bound. Empty: the "
      "elements and the growth given.";
    entries.add("Elements across patch", elements_across_patch, "1")
      .between(1, 100000)
      .help = "Number of elements across the patch of the Hertz estimate, in "
              "the rolling direction. 48 is for 2D; in 3D 12 to 24 are usual.";
    entries.add("Elements across patch y", elements_across_patch_y, "1")
      .between(0, 100000)
      .read_by(scenes_in_3d())
      .help =
      "Number of elements across the patch at right angles to the rolling "
      "direction, 3D only. 0: as many as in the rolling direction; on slender "
      "patches fewer, but at least 6, with elements at most 1.9 times as long "
      "as wide; on wide patches of profiles more, with elements as long as "
      "wide. With 0.8 times as many, forces are as good and the spin moment "
      "is worse.";
    entries.add("Least elements y", least_elements_y, "1")
      .between(0, 1000)
      .read_by(scenes_in_3d())
      .help =
      "Least number of elements across the rolling direction, where Elements "
      "across patch y is 0: on a patch that is slender along the rolling "
      "direction, as on a flange, and on each of several patches. 0: 6, or 10 "
      "where wear is reported, because depths of wear are those of lines of "
      "nodes.";
    const auto read_offset = [this](const std::string &text) {
      patch_offset = offset_of(text);
    };
    entries.parsed("Patch offset", Entry::Kind::numbers, "0", "1", read_offset)
      .help = "Shift of the mesh under the patch, in elements. `aligned`: the "
              "leading edge lies 0.38 elements upstream of a node, where "
              "upwind 2 is most accurate.";
  }

  void MeshParameters::check() const
  {
    if (target_error && (*target_error <= 0. || *target_error >= 1.))
      throw InputError(
        "Mesh/Target error = " + text_of(*target_error) +
        ": give a number above 0 and below 1, parts of mu N such as 5e-3, or "
        "leave it empty.");
  }

  void MeshParameters::declare_zone(Entries &entries)
  {
    entries.add("Candidate zone", candidate_zone, "1").between(0., 20.).help =
      "Half-length of the zone of contact nodes, over the half-width of the "
      "Hertz estimate. 0: 1.15, or 1.5 in time. A load curve adds 5 %, "
      "because its stiffness needs loads above the largest.";
    entries.add("Zone depth", zone_depth, "1").between(0., 20.).help =
      "Depth of the zone of smallest elements, over the half-width of the "
      "Hertz estimate.";
    entries.add_automatic("Growth", growth, "1").between(0.01, 10.).help =
      "Growth of the element size with the distance from the zone of the "
      "smallest elements. `automatic`: 0.1 in 2D and 0.4 in 3D, where 0.4 to "
      "0.8 are usual.";
    entries.choice("Compliance", compliance, named_compliances)
      .read_by(scenes_in_3d())
      .read_by({asks<AnalysisTraits>([](const auto &analysis) {
                  return !analysis.has_own_meshes;
                }),
                "studies of meshes take finite elements"})
      .help =
      "How the compliance of the contact nodes is computed. `finite "
      "elements`: by a mesh refined to the patch. `split`: a half-space in "
      "closed form, plus what the body adds by a mesh that is not refined to "
      "the patch, in a third of the time. Split is for discs, blocks and "
      "sections from files whose edges are far from the patch, in steady "
      "states without Output/Body fields and in vibrations by modes. "
      "`automatic`: split where its error is below that of the elements "
      "across the patch.";
    entries.add("Rim levels", rim_levels, "1").between(0, 10).help =
      "Further halvings of the element size at the rim of the patch. A line "
      "contact is refined at its ends only.";
    entries.choice("Rim edges", rim_edges, named_rim_edges).help =
      "Part of the patch's rim that is refined: `leading` or `both`.";
    entries.add("Adaptive levels", adaptive_levels, "1").between(0, 20).help =
      "Largest number of refined meshes on which the state is solved again.";
    entries.choice("Level marking", level_marking, named_markings).help =
      "Elements that a level refines. `adaptive` halves those at the leading "
      "edge, between stick and slip, at the rest of the rim and, inside the "
      "bodies, where the strain jumps most; `uniform` halves all.";
    entries.add("Contact node budget", contact_node_budget, "1")
      .between(3, 100000)
      .help = "Adaptive levels end before the mesh has more contact nodes "
              "than this.";
    entries.add("Target change", target_change, "1").between(0., 1.).help =
      "Adaptive levels end when forces change by less than this from one "
      "level to the next, relative to N and to mu N; 0: never.";
  }

} // namespace RollingContact
