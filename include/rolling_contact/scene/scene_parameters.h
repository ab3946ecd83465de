#ifndef rolling_contact_scene_scene_parameters_h
#define rolling_contact_scene_scene_parameters_h

#include <rolling_contact/base/side.h>
#include <rolling_contact/mesh/body_model.h>
#include <rolling_contact/scene/analysis_traits.h>
#include <rolling_contact/scene/body_parameters.h>
#include <rolling_contact/scene/contact_parameters.h>
#include <rolling_contact/scene/mesh_parameters.h>
#include <rolling_contact/scene/modes_parameters.h>
#include <rolling_contact/scene/output_parameters.h>
#include <rolling_contact/scene/own_section.h>
#include <rolling_contact/scene/profile_parameters.h>
#include <rolling_contact/scene/solver_parameters.h>
#include <rolling_contact/scene/sound_parameters.h>
#include <rolling_contact/scene/spectrum_parameters.h>
#include <rolling_contact/scene/stability_parameters.h>
#include <rolling_contact/scene/study_parameters.h>
#include <rolling_contact/scene/surface_parameters.h>
#include <rolling_contact/scene/table_parameters.h>
#include <rolling_contact/scene/time_parameters.h>
#include <rolling_contact/scene/velocity_points.h>
#include <rolling_contact/scene/wear_parameters.h>

#include <filesystem>
#include <list>

namespace RollingContact
{
  class Entries;

  /**
   * A scene as it was asked for: the whole .prm file, plain values. Nothing
   * changes it once it is read; what follows from it is a Situation.
   */
  struct SceneParameters
  {
    /**
     * All entries; they set the members, so they must not outlive the scene.
     * @p analyses: what `Analysis` may be.
     */
    Entries declare(const std::vector<AnalysisTraits> &analyses);

    /**
     * Rules within and across sections. Throws InputError.
     */
    void check() const;

    const BodyParameters &body(const Side side) const
    {
      return side == Side::wheel ? wheel : rail;
    }

    unsigned int   dimension = 2;
    AnalysisTraits analysis;
    BodySolver     body_solver  = BodySolver::automatic;
    unsigned int   body_threads = 2;
    /**
     * Folder of the .prm file, where the files it names are.
     */
    std::filesystem::path prm_folder;

    BodyParameters      wheel{"Wheel"};
    BodyParameters      rail{"Rail"};
    ContactParameters   contact;
    SolverParameters    solver;
    MeshParameters      mesh;
    StudyParameters     study;
    TableParameters     table;
    TimeParameters      time;
    SurfaceParameters   surfaces;
    SpectrumParameters  spectrum;
    SoundParameters     sound;
    ProfileParameters   profiles;
    ModesParameters     modes;
    StabilityParameters stability;
    WearParameters      wear;
    OutputParameters    output;

    /**
     * The section of this type, which one analysis alone reads.
     */
    template <class Section>
    Section &own()
    {
      for (OwnSection &section : own_sections)
        if (section.is<Section>())
          return section.get<Section>();
      own_sections.emplace_back(Section());
      return own<Section>();
    }

    template <class Section>
    const Section &own() const
    {
      static const Section defaults;
      for (const OwnSection &section : own_sections)
        if (section.is<Section>())
          return section.get<Section>();
      return defaults;
    }

    /**
     * Whether load, place and motion of the wheels are found, as those of a
     * wheelset in balance.
     */
    bool finds_place() const
    {
      return analysis.finds_place || (analysis.takes_found_place &&
                                      stability.wheels != WheelsFound::none);
    }

    /**
     * Whether steps are taken in time, so that section Time is in use.
     */
    bool marches() const
    {
      return analysis.marches ||
             (analysis.has_own_meshes && study.varies_time_step);
    }

    /**
     * Whether steps are taken until the motion repeats itself.
     */
    bool looks_for_cycles() const
    {
      return analysis.until_periodic ||
             (analysis.records_run && time.stop_when_periodic);
    }

    /**
     * Whether a transient run takes the bodies by their modes.
     */
    bool has_reduced_bodies() const
    {
      return marches() && time.bodies == BodiesInTime::reduced;
    }

    /**
     * Whether the wheel hangs on an axle that is held at rest and moves in
     * vibrations, by its modes, see AxleMotion.
     */
    bool moves_axle() const
    {
      return !wheel.rigid && wheel.hub == Hub::mass &&
             (analysis.linearises || has_reduced_bodies());
    }

    /**
     * Entries that take values which the analysis gives them.
     */
    std::vector<TableAxis> axes() const;

    /**
     * Points of a body whose velocities a run records: those of an elastic body
     * of a transient run with inertia.
     */
    std::vector<VelocityPoint> velocity_points(const Side side) const;

    /** Points with velocities of both bodies. */
    PerSide<std::vector<VelocityPoint>> points_with_velocities() const
    {
      return {velocity_points(Side::wheel), velocity_points(Side::rail)};
    }

    /**
     * Whether a run ends with spectra, see Spectrum/Write.
     */
    bool wants_spectra() const;

    /**
     * Why the vibrations of the state that a run starts from are not to be
     * compared with its spectra, a part of a sentence; empty if they are.
     */
    std::string why_no_eigenvalues() const;

    /**
     * How friction follows what changes in time or is disturbed, see
     * Contact/Friction response; constant with a law that does not fall.
     */
    FrictionResponse friction_response() const;

    /**
     * Rules for forces of friction that are given in place of creepages, by the
     * entries @p asked for them, lateral ones or moments if @p across. Throws
     * InputError.
     */
    void check_forces(const std::string &asked, const bool across) const;

  private:
    std::list<OwnSection> own_sections;

    /** Rules of the analysis alone. */
    void check_rules() const;

    /**
     * Rules for bodies in contact that hold in all analyses.
     */
    void check_contact() const;

    /**
     * Rules for Time/Bodies = reduced, and for friction and a load that follow
     * the state that a run starts from.
     */
    void check_reduced_bodies() const;

    void check_excitation() const;

    void check_friction_response() const;

    void check_pair() const;

    void check_covers() const;

    void check_curvatures() const;

    /**
     * Rules for profiles on bodies from files; @p given names the profiles.
     * Throws InputError.
     */
    void check_profiles_on_files(const std::string &given) const;

    void check_profiles() const;

    void check_body_solver() const;

    void check_target_error() const;

    void check_hubs() const;

    void check_speed() const;

    void check_hot_friction() const;

    void check_mesh_files() const;
  };
} // namespace RollingContact

#endif
