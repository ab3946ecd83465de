#ifndef rolling_contact_pair_rolling_pair_h
#define rolling_contact_pair_rolling_pair_h

#include <rolling_contact/bodies/bulk_errors.h>
#include <rolling_contact/contact/contact_problem.h>
#include <rolling_contact/pair/body_pair.h>
#include <rolling_contact/pair/moving_surfaces.h>
#include <rolling_contact/pair/pair_interface.h>
#include <rolling_contact/scene/pair_spec.h>

#include <memory>
#include <vector>

namespace RollingContact
{
  /**
   * Wheel and rail, the interface between them, and the contact problem there,
   * which is the same on every rank. Quantities of a body are in its own frame
   * (z out of the body) and on its contact nodes; quantities of the pair are in
   * the rail's frame and on the nodes of the interface: forces act on the
   * wheel, displacements are those of the wheel relative to the rail, and what
   * opens the gap is positive. Values are given component by component, the
   * tangential ones first; a frictionless pair has the normal one only.
   */
  template <int dim>
  class RollingPair
  {
  public:
    /**
     * Build the bodies, with what solves K if @p statics are wanted, and the
     * interface between them. Throws InputError if they do not suit the zone of
     * contact nodes. Keeps a copy of the scene. Collective.
     */
    RollingPair(const PairSpec     &scene,
                const Grading<dim> &grading,
                const PairDemands  &demands,
                const bool          statics = true);

    /**
     * Pair of the same bodies at another place: the scene differs from theirs
     * only in where and how they touch, and the interface is its own. What was
     * built for the bodies is shared, so that their factors serve all places
     * (PairDemands::displacements keeps them) and they are condensed for each.
     * Their mesh must have small elements where this pair touches, see
     * grading_of_places(). Throws InputError unless elastic bodies have
     * sections from files, which are coupled by mortars, and live on one rank.
     */
    RollingPair(const PairSpec      &scene,
                const Grading<dim>  &grading,
                const PairDemands   &demands,
                const BodyPair<dim> &bodies);

    /**
     * The pair of another scene that differs from that of @p other in loads and
     * in where profiles touch: bodies, interface and the compliance between
     * them are the same. Throws std::logic_error if a body has the section of
     * its profile, whose place in the contact is another one then.
     */
    RollingPair(const PairSpec &scene, const RollingPair &other);

    const BodyPair<dim> &bodies() const
    {
      return body_pair;
    }

    const PairInterface<dim> &interface() const
    {
      return pair_interface;
    }

    /**
     * Nodes and elements of the interface.
     */
    const Trace &trace() const
    {
      return pair_interface.trace;
    }

    /**
     * True for the nodes at borders of the zone beyond which bodies go on: all
     * but those at the ends of a line contact.
     */
    std::vector<bool> border_nodes() const;

    /**
     * Directions of a body's displacement that are among the values of the
     * contact: all, or z alone without friction. Numbers of axes, from 0.
     */
    const std::vector<unsigned int> &contact_directions() const
    {
      return components;
    }

    /**
     * Surfaces that move with the material, on the elements of this pair.
     */
    const MovingSurfaces &moving_surfaces() const
    {
      return surfaces;
    }

    /**
     * Free what only static solutions need, see BodyPair.
     */
    void release_statics()
    {
      body_pair.release_statics();
    }

    /**
     * The contact problem for a load, creepages and operators, on all ranks.
     * The first overload condenses the bodies to the compliance W of the pair,
     * which takes long: later problems of the same pair should be made from the
     * W of the first one by the second overload. Units of W: m/N. The first
     * overload is collective.
     */
    ContactProblem contact_problem(const ContactParameters &contact);

    ContactProblem contact_problem(const ContactParameters &contact,
                                   ContactCompliance        W) const;

    /**
     * mu, mu_s of a law that falls, of the nodes after the material moved by
     * @p travelled along x since t = 0. Units: m.
     */
    std::vector<double> friction_at_nodes(const ContactParameters &contact,
                                          const double travelled) const;

    /**
     * Give a problem on this interface the gap, the rigid slip and the frames
     * of the surfaces of this scene.
     */
    void set_surfaces(ContactProblem &problem) const;

    /**
     * The frame of the profiles' contact; none without profiles.
     */
    const std::shared_ptr<const Profiles::ContactFrame> &frame() const
    {
      return scene.frame;
    }

    /**
     * Whether the profiles of another scene touch in the same frame and move
     * alike, so that set_surfaces() would change nothing.
     */
    bool is_placed_as(const PairSpec &other) const
    {
      return scene.frame == other.frame && scene.motion == other.motion;
    }

    /**
     * Give a problem of this pair the load or approach, the creepages and the
     * friction of @p contact, as a new problem would have them. What operators
     * and gap are made of must be as it was: slip operator, contact matrices,
     * direction of the flow, roughness, and whether there is friction.
     */
    void set_loads(const ContactParameters &contact,
                   ContactProblem          &problem) const;

    /**
     * Compliance W of the pair from those of the bodies. Inputs: for each body
     * on the rank of BodyPair::rank_of(), empty elsewhere, for a rigid body and
     * for the rail of twins. Result: on all ranks. Units: m/N. Collective.
     */
    DenseMatrix pair_compliance(PerSide<DenseMatrix> body_compliances) const;

    /**
     * Motion of the wheel relative to the rail from the motions of the bodies.
     * Inputs: of a direct body on its rank, of a distributed one on all ranks;
     * empty for a rigid body. Result: on all ranks, in the units of the inputs.
     * Collective.
     */
    std::vector<double>
    relative_motion(PerSide<std::vector<double>> body_motions) const;

    /**
     * The part of one elastic body in relative_motion(). Collective.
     */
    std::vector<double> relative_motion_of(const Side          side,
                                           std::vector<double> motion) const;

    /**
     * False if the W of contact_problem() is an approximation that the
     * response() of the bodies corrects.
     */
    bool compliance_is_exact() const;

    /**
     * Static displacement W r of the pair for each of several sets of nodal
     * forces r, which are the same on all ranks; to all digits, or @p roughly,
     * see ElasticBody::response(). Result: on all ranks. Units: N to m.
     * Collective.
     */
    std::vector<std::vector<double>>
    response(const std::vector<std::vector<double>> &forces,
             const bool                              roughly) const;

    /**
     * Forces on the contact nodes of a body from the nodal forces of the pair,
     * see nodal_forces(). Units: N.
     */
    std::vector<double> forces_on_body(const Side          side,
                                       std::vector<double> forces) const;

    /**
     * A body in time, with the pair's contact nodes; nullptr for a rigid body
     * and on ranks that hold nothing of it. Collective for distributed bodies.
     */
    std::unique_ptr<BodyDynamics> in_time(const Side         side,
                                          const ThetaScheme &scheme,
                                          const MassKind     mass) const;

    /**
     * Static displacement of a body under the reactions of a contact state,
     * without the rigid approach of the wheel. Empty on ranks that hold nothing
     * of the body. Units: m. Collective for distributed bodies.
     */
    BodyField displacement(const Side            side,
                           const ContactProblem &problem,
                           const ContactState   &state) const;

    /**
     * How much the compliance of contact_problem() lacks for want of elements
     * in the bulk, if that was demanded; not known of distributed bodies.
     */
    const BulkErrors &bulk_errors() const
    {
      return errors;
    }

  private:
    RollingPair(BodyPair<dim>       bodies,
                const PairSpec     &scene,
                const Grading<dim> &grading,
                const PairDemands  &demands);

    /**
     * The smooth forces of BulkErrors, if these were demanded.
     */
    void prepare_bulk_errors();

    /**
     * The parts of BulkErrors that a body on this rank brings, side by side,
     * while it has its factor, which is freed if nobody else needs it. Empty if
     * it has none or errors were not demanded.
     */
    DenseMatrix bulk_errors_of(const Side side) const;

    /**
     * The errors of the pair from those of its bodies. Collective.
     */
    void add_bulk_errors(PerSide<DenseMatrix> of_bodies);

    std::vector<BodyField>
    displacements(const Side                              side,
                  const std::vector<std::vector<double>> &forces) const;

    /**
     * W of the pair from those of the bodies on the interface, each on the rank
     * of its body. Collective.
     */
    DenseMatrix added_compliance(PerSide<DenseMatrix> at_interface) const;

    /**
     * W of bodies on so many nodes that products by Fourier transforms take
     * less time than a matrix; empty for others and where bodies ask for one.
     */
    std::optional<GridInfluence> influence_on_grid() const;

    void choose_components();

    const PairSpec            scene;
    BodyPair<dim>             body_pair;
    PairInterface<dim>        pair_interface;
    const MovingSurfaces      surfaces;
    std::vector<unsigned int> components;
    const PairDemands         demands;
    const double              element_size; ///< the larger one, m
    BulkErrors                errors;
  };
} // namespace RollingContact

#endif
