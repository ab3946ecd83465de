#ifndef rolling_contact_wheelset_wheelset_report_h
#define rolling_contact_wheelset_wheelset_report_h

#include <rolling_contact/results/error_bounds.h>
#include <rolling_contact/run/run_context.h>
#include <rolling_contact/wheelset/equilibrium.h>

#include <array>
#include <optional>
#include <vector>

namespace RollingContact
{
  /**
   * An equilibrium with what is told of it, in the axes of the track. Units: m,
   * rad, 1.
   */
  struct FoundEquilibrium
  {
    WheelsetState state;
    double        roll = 0.;

    /** See Equilibrium::motion_derivatives(). */
    std::optional<Hunting::Derivatives> derivatives;

    /** Both wheels, right and left, on meshes and in scenes of their own. */
    std::array<std::optional<PairSpec>, 2> scenes;
    std::array<SteadyState<3>, 2>          steady;

    /** How far shift, yaw and excess may be off by the errors of forces; empty
     * if these are not known. */
    std::optional<Eigen::Vector3d> bounds;

    std::optional<WheelsetState> another; ///< equilibrium of the same case

    std::optional<Hunting> hunting; ///< if it was asked for and found

    unsigned int n_steps = 0, n_states = 0, n_bodies = 0;

    /**
     * Find the bounds from those of the forces, for an axle load, half the
     * distance of the wheels and their radius. Units: N, m.
     */
    void find_bounds(const double axle_load,
                     const double half_base,
                     const double radius);

    /** The sum of T gamma less the work of the forces that hold the wheelset on
     * its way, over the friction that both wheels can carry. */
    double energy_error(const double radius) const;
  };

  /**
   * What the equilibria of a run are told by: wheelset.csv, results.csv,
   * wheelset.svg, findings and warnings.
   */
  class WheelsetReport
  {
  public:
    WheelsetReport(const Situation          &scene,
                   const WheelsetParameters &wheelset,
                   RunContext               &context);

    void add(const FoundEquilibrium &found);

    /** A row of wheelset.csv alone, of a place in this scene. */
    void add_row(const PairSpec &at, const FoundEquilibrium &found);

    /** What the wheelset does there, in the summary and as warnings. */
    void tell(const FoundEquilibrium &found)
    {
      all.push_back(found.state);
      note(found);
      warn(found);
    }

    /** Once all are there. */
    void finish();

  private:
    void add_wheel(const FoundEquilibrium &found, const unsigned int wheel);

    void note(const FoundEquilibrium &found);

    void add_hunting(const FoundEquilibrium &found);

    void warn(const FoundEquilibrium &found);

    void plot() const;

    const Situation           &scene;
    const WheelsetParameters  &wheelset;
    RunContext                &context;
    ResultsTable               table;
    std::vector<WheelsetState> all;
  };
} // namespace RollingContact

#endif
