#ifndef rolling_contact_pair_rolling_pair_h
#define rolling_contact_pair_rolling_pair_h

#include <rolling_contact/contact/contact_problem.h>
#include <rolling_contact/pair/body_pair.h>

#include <memory>
#include <vector>

namespace RollingContact
{
  /**
   * Wheel and rail and the contact problem between them, which is the same on
   * every rank; a frictionless contact has only normal compliance.
   */
  template <int dim>
  class RollingPair : public BodyPair<dim>
  {
  public:
    /**
     * See BodyPair.
     */
    RollingPair(const SceneParameters &scene,
                const Grading<dim>    &grading,
                const PairDemands     &demands,
                const bool             statics = true);

    /**
     * The contact problem for a load, creepages and operators. Condenses the
     * bodies: once, take W of the problem for the next.
     */
    ContactProblem
    contact_problem(const ContactParameters &contact);

    /**
     * The same with a given compliance of the pair. Units: m/N.
     */
    ContactProblem
    contact_problem(const ContactParameters &contact, DenseMatrix W) const;

    /**
     * Of compliances of the bodies in their own frames, on the ranks that have
     * them, that of the pair on all, for the gap and the displacement of the
     * wheel over the rail; an empty matrix for a rigid body, and for the rail
     * of twins. Units: m/N.
     */
    DenseMatrix
    combined(DenseMatrix wheel, DenseMatrix rail) const;

    /**
     * Of motions of the contact nodes of the bodies in their own frames, on the
     * ranks that have them, that of the wheel over the rail at the interface's
     * nodes on all: tangential components, and what opens the gap. Empty for a
     * rigid body.
     */
    std::vector<double>
    relative(std::vector<double> wheel, std::vector<double> rail) const;

    /**
     * False if W of a problem is an approximation that response() corrects.
     */
    bool
    compliance_is_exact() const;

    /**
     * W r of the bodies for nodal forces r of the pair, tangential components
     * first, for each of the given sets; see ElasticBody::response(). Units: N
     * to m.
     */
    std::vector<std::vector<double>>
    response(const std::vector<std::vector<double>> &forces,
             const bool                              roughly) const;

    /**
     * Nodal forces of the pair (see nodal_forces()) as those on a body's
     * contact nodes in its own frame, component by component. Units: N.
     */
    std::vector<double>
    on_body(const Side side, std::vector<double> forces) const;

    /**
     * A body in time, with the pair's contact nodes; nullptr where the body is
     * not.
     */
    std::unique_ptr<BodyDynamics>
    in_time(const Side         side,
            const ThetaScheme &scheme,
            const MassKind     mass) const;

    /**
     * Displacement of a body in its own frame (z out of the body) under the
     * reactions of a state; without the wheel's rigid approach. Empty on ranks
     * that hold nothing of the body.
     */
    BodyField
    displacement(const Side            side,
                 const ContactProblem &problem,
                 const ContactState   &state) const;

  private:
    /**
     * W = W_W + W_R. Units: m/N.
     */
    DenseMatrix
    pair_compliance();

    std::vector<unsigned int> components;
  };
} // namespace RollingContact

#endif
