#ifndef rolling_contact_scene_scene_parameters_h
#define rolling_contact_scene_scene_parameters_h

#include <rolling_contact/base/choices.h>
#include <rolling_contact/base/side.h>
#include <rolling_contact/distributed/body_solver.h>
#include <rolling_contact/scene/body_parameters.h>
#include <rolling_contact/scene/contact_parameters.h>
#include <rolling_contact/scene/creep_curve_parameters.h>
#include <rolling_contact/scene/limit_cycle_parameters.h>
#include <rolling_contact/scene/load_curve_parameters.h>
#include <rolling_contact/scene/mesh_parameters.h>
#include <rolling_contact/scene/modes_parameters.h>
#include <rolling_contact/scene/output_parameters.h>
#include <rolling_contact/scene/profile_parameters.h>
#include <rolling_contact/scene/receptance_parameters.h>
#include <rolling_contact/scene/solver_parameters.h>
#include <rolling_contact/scene/sound_parameters.h>
#include <rolling_contact/scene/spectrum_parameters.h>
#include <rolling_contact/scene/stability_parameters.h>
#include <rolling_contact/scene/study_parameters.h>
#include <rolling_contact/scene/surface_parameters.h>
#include <rolling_contact/scene/table_parameters.h>
#include <rolling_contact/scene/time_parameters.h>
#include <rolling_contact/scene/velocity_points.h>
#include <rolling_contact/stability/linear_contact.h>

#include <filesystem>

namespace dealii
{
  class ParameterHandler;
}

namespace RollingContact
{
  /**
   * A scene: the whole .prm file. Nothing changes it once it is read; who wants
   * another takes a copy.
   */
  struct SceneParameters
  {
    /**
     * Declare all entries; @p prm sets the members when it reads a file, so it
     * must not outlive the scene. @p analyses: what `Analysis` may be.
     */
    void
    declare(dealii::ParameterHandler           &prm,
            const std::vector<DescribedChoice> &analyses);

    /**
     * Rules within and across sections. Throws InputError.
     */
    void
    check() const;

    /**
     * Read the mesh files of the bodies. Throws InputError.
     */
    void
    read_meshes();

    /**
     * Read expressions and records of the surfaces that move. Throws
     * InputError.
     */
    void
    read_surfaces();

    /**
     * Where the bodies have profiles find their contact; and what follows from
     * other entries for section Contact: creepages of a size or of kinematics,
     * the normal load of a vertical load without friction. Throws InputError.
     */
    void
    read_profiles();

    /**
     * What follows for section Contact, with the contact of profiles that was
     * found, see read_profiles().
     */
    void
    take_derived_contact();

    /**
     * The angle of load and approach against the normal of the plane in which
     * bodies touch first, on a curved surface of contact under a vertical load;
     * else 0. Units: rad.
     */
    double
    load_angle() const;

    /**
     * Whether the undeformed gap is that of the radii of wheel and rail, so
     * that closed forms have something to say.
     */
    bool
    has_plain_surfaces() const
    {
      return contact.roughness.empty() && !profiles.in_use() &&
             !surfaces.in_use() && surfaces.friction_share.empty();
    }

    /**
     * Thickness in 2D of the bodies that are not rigid. Units: m.
     */
    double
    thickness() const
    {
      return wheel.rigid ? rail.thickness : wheel.thickness;
    }

    const BodyParameters &
    body(const Side side) const
    {
      return side == Side::wheel ? wheel : rail;
    }

    unsigned int dimension    = 2;
    std::string  analysis     = "quasi-static";
    BodySolver   body_solver  = BodySolver::automatic;
    unsigned int body_threads = 2;
    /**
     * Folder of the .prm file, where the files it names are.
     */
    std::filesystem::path prm_folder;

    BodyParameters       wheel{"Wheel"};
    BodyParameters       rail{"Rail"};
    ContactParameters    contact;
    SolverParameters     solver;
    MeshParameters       mesh;
    CreepCurveParameters creep_curve;
    LoadCurveParameters  load_curve;
    StudyParameters      study;
    TableParameters      table;
    TimeParameters       time;
    SurfaceParameters    surfaces;
    SpectrumParameters   spectrum;
    SoundParameters      sound;
    ProfileParameters    profiles;
    ModesParameters      modes;
    ReceptanceParameters receptance;
    StabilityParameters  stability;
    LimitCycleParameters limit_cycle;
    OutputParameters     output;

    /**
     * Whether the analysis is of many states, those of section Table.
     */
    bool
    is_of_table() const
    {
      return analysis == "table" || analysis == "stability map";
    }

    /**
     * Whether the analysis is of vibrations about a rolling state.
     */
    bool
    is_of_stability() const
    {
      return analysis == "stability" || analysis == "stability map";
    }

    /**
     * Whether steps are taken until the motion repeats itself.
     */
    bool
    looks_for_cycles() const
    {
      return analysis == "limit cycle" ||
             (analysis == "transient" && time.stop_when_periodic);
    }

    /**
     * Whether a transient run takes the bodies by their modes.
     */
    bool
    has_reduced_bodies() const
    {
      return is_transient() && time.bodies == BodiesInTime::reduced;
    }

    /**
     * Points of a body whose velocities a run records: those of an elastic body
     * of a transient run with inertia.
     */
    std::vector<VelocityPoint>
    velocity_points(const Side side) const;

    /**
     * Whether a run ends with spectra, see Spectrum/Write.
     */
    bool
    wants_spectra() const;

    /**
     * Why the vibrations of the state that a run starts from are not to be
     * compared with its spectra, a part of a sentence; empty if they are.
     */
    std::string
    why_no_eigenvalues() const;

    /**
     * How friction follows what changes in time or is disturbed, see
     * Contact/Friction response; constant with a law that does not fall.
     */
    FrictionResponse
    friction_response() const;

    /**
     * Whether the analysis is one of each body alone, without contact.
     */
    bool
    is_of_structures() const
    {
      return analysis == "modes" || analysis == "receptance";
    }

  private:
    /**
     * Whether section Time is in use.
     */
    bool
    is_transient() const
    {
      return analysis == "transient" || analysis == "limit cycle" ||
             (analysis == "accuracy study" && study.varies_time_step);
    }

    /**
     * Rules for analyses of each body alone.
     */
    void
    check_structures() const;

    /**
     * Rules for vibrations about a rolling state.
     */
    void
    check_stability() const;

    /**
     * Rules for Time/Bodies = reduced, and for friction and a load that follow
     * the state that a run starts from.
     */
    void
    check_reduced_bodies() const;

    void
    check_excitation() const;

    /**
     * Rules for runs until the motion repeats itself.
     */
    void
    check_cycles() const;

    void
    check_friction_response() const;

    /**
     * Rules for named points, spectra and spectrograms of a transient run.
     */
    void
    check_spectra() const;

    void
    check_sound() const;

    void
    check_pair() const;

    void
    check_curvatures() const;

    /** Of bodies from files; @p given names the profiles. */
    void
    check_profiles_on_files(const std::string &given) const;

    void
    check_profiles() const;

    void
    check_body_solver() const;

    void
    check_study() const;

    void
    check_forces() const;

    void
    check_table() const;

    void
    check_target_error() const;

    void
    check_hubs() const;

    void
    check_speed() const;

    void
    check_mesh_files() const;

    void
    check_surfaces() const;
  };
} // namespace RollingContact

#endif
