#ifndef rolling_contact_scene_analysis_traits_h
#define rolling_contact_scene_analysis_traits_h

#include <rolling_contact/scene/own_section.h>
#include <rolling_contact/scene/table_parameters.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace RollingContact
{
  struct SceneParameters;

  /**
   * What an analysis does, as far as the sections of a scene and their rules
   * ask for it. The defaults are those of one steady rolling state.
   */
  struct AnalysisTraits
  {
    std::string name = "quasi-static", help = {};

    /** Sections that this analysis reads and some others do not. */
    std::vector<std::string> sections = {};

    /** The section that no other analysis reads, with its defaults. */
    std::optional<OwnSection> own_section = {};

    /** Entries of other sections that take values which the own section gives
     * them; null if there are none. Those of section Table are known. */
    std::vector<TableAxis> (*axes)(const SceneParameters &scene) = nullptr;

    /** Creepages that the section of this analysis gives in place of section
     * Contact; null if section Contact gives them. */
    std::vector<TableAxis> (*own_creepages)(const SceneParameters &scene) =
      nullptr;

    /** Rules beyond those of all analyses: each throws InputError if it is
     * broken. */
    std::vector<void (*)(const SceneParameters &scene)> rules = {};

    /** The bodies have finite elements; otherwise they are rigid profiles. */
    bool has_bodies = true;
    /** The meshed bodies touch, and the tractions between them are found. */
    bool has_contact = true;
    /** Load, place and motion of the wheels are found. */
    bool finds_place = false;
    /** They are found where the scene asks for it, see Stability/Wheel. */
    bool takes_found_place = false;
    /** The analysis solves many states, which section Table lists. */
    bool has_many_states = false;
    /** Vibrations about a steady rolling state are linearised. */
    bool linearises = false;
    /** They are driven by waves on the surface, at frequencies of these. */
    bool passes_waves = false;
    /** The analysis takes bodies by their modes, on which Wheel/Dampers hang.
     */
    bool has_dampers = false;
    /** The analysis takes steps in time, which section Time describes. */
    bool marches = false;
    /** The analysis is one run in time, recorded step by step with velocities
     * of points, spectra and sound. */
    bool records_run = false;
    /** Each run goes on until the motion repeats itself, from starts that the
     * analysis finds. */
    bool until_periodic = false;
    /** Section Accuracy study gives the meshes, or the time steps. */
    bool has_own_meshes = false;
    /** Profiles wear from state to state. */
    bool wears_profiles = false;
    /** The analysis has one steady state, whose contact problem may be written.
     */
    bool has_one_state = false;
    /** The analysis can be run on several MPI ranks. */
    bool on_ranks = true;

    /** Bodies are meshed, and each is taken alone. */
    bool has_lone_bodies() const
    {
      return has_bodies && !has_contact;
    }

    /** Runs in time have a row of results.csv each, and are not recorded. */
    bool has_row_for_each_run() const
    {
      return marches && !records_run;
    }

    bool reads(const std::string &section) const
    {
      return std::find(sections.begin(), sections.end(), section) !=
             sections.end();
    }
  };
} // namespace RollingContact

#endif
