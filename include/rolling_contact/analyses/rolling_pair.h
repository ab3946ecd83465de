#ifndef rolling_contact_analyses_rolling_pair_h
#define rolling_contact_analyses_rolling_pair_h

#include <rolling_contact/analyses/scene_parameters.h>
#include <rolling_contact/contact/contact_problem.h>
#include <rolling_contact/contact/trace.h>
#include <rolling_contact/elasticity/elastic_body.h>

#include <memory>
#include <string>
#include <vector>

namespace RollingContact
{
  enum class Side
  {
    wheel,
    rail
  };

  /**
   * Wheel and rail on matching meshes and the contact problem between them.
   * Owns the elastic bodies; builds only what the scene needs: a rigid body has
   * none, mirror-identical bodies share one, a frictionless contact has only
   * normal compliance.
   */
  template <int dim>
  class RollingPair
  {
  public:
    /**
     * Mesh; assemble and analyse K as well if @p statics are wanted. Throws
     * InputError, before meshing, if the zone does not fit on the bodies.
     */
    RollingPair(const SceneParameters &scene,
                const Grading<dim>    &grading,
                const bool             statics = true);

    /**
     * The contact problem for the scene's load and creepages with this slip
     * operator. Factorises and condenses the bodies: once, take W of the
     * problem for the next.
     */
    ContactProblem
    contact_problem(const SlipOperatorKind slip_operator);

    /**
     * The same with a given compliance of the pair. Units: m/N.
     */
    ContactProblem
    contact_problem(const SlipOperatorKind slip_operator, DenseMatrix W) const;

    /**
     * Of compliances of the bodies in their own frames, that of the pair, for
     * the gap and the displacement of the wheel over the rail; an empty matrix
     * for a rigid body, and for the rail of twins. Units: m/N.
     */
    DenseMatrix
    combined(const DenseMatrix &wheel, const DenseMatrix &rail) const;

    /**
     * Give back what only static solutions need, the factors.
     */
    void
    release_statics();

    /**
     * Nodal forces of a state on a body in its own frame, component by
     * component. Units: N.
     */
    std::vector<double>
    reactions(const Side            side,
              const ContactProblem &problem,
              const ContactState   &state) const;

    /**
     * The unknowns of a body's contact nodes, in the order of the reactions.
     */
    std::vector<std::size_t>
    unknowns(const Side side) const;

    /**
     * Displacement of a body in its own frame (z out of the body) under the
     * reactions of a state; without the wheel's rigid approach.
     */
    dealii::Vector<double>
    displacement(const Side            side,
                 const ContactProblem &problem,
                 const ContactState   &state) const;

    /**
     * nullptr for a rigid body; the same pointer for both sides of twins.
     */
    const ElasticBody<dim> *
    body(const Side side) const
    {
      return side == Side::wheel ? wheel_body.get() : rail_body.get();
    }

    bool
    twins() const
    {
      return wheel_body != nullptr && wheel_body == rail_body;
    }

    const Trace &
    trace() const
    {
      return contact_trace;
    }

  private:
    const std::vector<typename ElasticBody<dim>::SurfaceNode> &
    nodes(const Side side) const
    {
      return side == Side::wheel ? wheel_nodes : rail_nodes;
    }

    void
    pair_surfaces(const Grading<dim> &zone);

    /**
     * W = W_W + W_R. Units: m/N.
     */
    DenseMatrix
    pair_compliance();

    const SceneParameters                              &scene;
    std::shared_ptr<ElasticBody<dim>>                   wheel_body, rail_body;
    Trace                                               contact_trace;
    std::vector<typename ElasticBody<dim>::SurfaceNode> wheel_nodes, rail_nodes;
    std::vector<unsigned int>                           components;
  };
} // namespace RollingContact

#endif
