#ifndef rolling_contact_elasticity_elastic_body_h
#define rolling_contact_elasticity_elastic_body_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/lac/affine_constraints.h>

#include <rolling_contact/base/dense_matrix.h>
#include <rolling_contact/elasticity/body_matrices.h>
#include <rolling_contact/elasticity/factorisation.h>
#include <rolling_contact/elasticity/material.h>
#include <rolling_contact/mesh/body_mesh.h>

#include <functional>
#include <memory>

namespace RollingContact
{
  /**
   * One elastic body in its own frame (z out of the body), hub clamped or free:
   * linear elements with B-bar, in 2D plane strain with a thickness. Owns mesh,
   * unknowns and the factorisation of K; contact space sees it only through
   * compliance() and recover(). Dynamics asks for stiffness() and mass(), which
   * are assembled on demand and not kept.
   */
  template <int dim>
  class ElasticBody
  {
  public:
    /**
     * A contact node: an unconstrained vertex of the contact surface. The chart
     * coordinates are x and, in 3D, y.
     */
    struct SurfaceNode
    {
      dealii::Point<dim - 1>                           position;
      std::array<dealii::types::global_dof_index, dim> dofs;
    };

    /**
     * A face of the contact surface, a box of the chart. Each corner is a
     * combination of surface nodes: itself, or the nodes it hangs between.
     */
    struct SurfaceFace
    {
      dealii::Point<dim - 1>                                    lower, upper;
      std::vector<std::vector<std::pair<unsigned int, double>>> corners;
    };

    /**
     * Mesh and distribute. @p thickness is used in 2D. Units: m.
     */
    ElasticBody(const BodyGeometry &geometry,
                const Material     &material,
                const double        thickness,
                const Grading<dim> &grading);

    /**
     * Faces of the contact surface in the zone of contact nodes and the nodes
     * they touch, in ascending x (then y).
     */
    void
    surface(const Grading<dim>       &zone,
            std::vector<SurfaceNode> &nodes,
            std::vector<SurfaceFace> &faces) const;

    /**
     * Assemble K and analyse its factorisation for compliance(), which does so
     * itself if need be. Throws InputError if the hub is free.
     */
    void
    analyse();

    /**
     * Compliance of the given nodes: displacement of component @p components[i]
     * at node n for unit nodal forces; row and column i * N + n. Factorises K
     * on first use; L is kept for recover() unless @p recovers is false. Units:
     * m/N.
     */
    DenseMatrix
    compliance(const std::vector<SurfaceNode>  &nodes,
               const std::vector<unsigned int> &components,
               const bool                       recovers = true);

    /**
     * Displacement of the whole body under nodal forces (component i of node n
     * at components[i] * N + n). Units: N to m.
     */
    dealii::Vector<double>
    recover(const std::vector<SurfaceNode>  &nodes,
            const std::vector<unsigned int> &components,
            const std::vector<double>       &forces) const;

    /**
     * K of the unknowns, assembled anew. Units: N/m.
     */
    SymmetricSparseMatrix
    stiffness() const;

    /**
     * M of the unknowns. Units: kg.
     */
    SymmetricSparseMatrix
    mass(const MassKind kind = MassKind::lumped) const;

    /**
     * The node of each unknown, for the order of elimination.
     */
    const std::vector<unsigned int> &
    nodes_of_unknowns() const
    {
      return node_of_unknown;
    }

    /**
     * Number of the unknown behind a degree of freedom, -1 if it is
     * constrained.
     */
    int
    unknown(const dealii::types::global_dof_index dof) const
    {
      return unknown_of_dof[dof];
    }

    /**
     * The unknown of component @p components[i] at node n, at i * N + n.
     */
    std::vector<std::size_t>
    unknowns(const std::vector<SurfaceNode>  &nodes,
             const std::vector<unsigned int> &components) const;

    /**
     * The unknowns of a field that is @p value in one component and zero in the
     * others, away from a clamped hub.
     */
    std::vector<double>
    uniform(const unsigned int component, const double value) const;

    /**
     * The field of given unknowns on all nodes, hanging and clamped ones
     * included.
     */
    dealii::Vector<double>
    field(const std::vector<double> &values) const;

    const dealii::DoFHandler<dim> &
    dof_handler() const
    {
      return dofs;
    }

    const Material &
    elasticity() const
    {
      return material;
    }

    const BodyMesh<dim> &
    mesh() const
    {
      return body_mesh;
    }

    std::size_t
    n_unknowns() const
    {
      return unknown_of_dof.size() - n_constrained;
    }

    /**
     * Give the memory of the factor back; compliance() would compute it again.
     */
    void
    release_factorisation()
    {
      factor.reset();
    }

    /**
     * Sizes and seconds of the factorisation; nullptr before it exists.
     */
    const Factorisation *
    factorisation() const
    {
      return factor.get();
    }

    double
    assembly_seconds() const
    {
      return assembly_s;
    }

  private:
    using CellIterator = typename dealii::DoFHandler<dim>::active_cell_iterator;

    void
    for_each_surface_face(
      const std::function<void(const CellIterator &, const unsigned int)>
        &action) const;

    void
    distribute();

    Discretisation<dim>
    discretisation() const;

    Material                          material;
    double                            thickness;
    bool                              hub_clamped;
    BodyMesh<dim>                     body_mesh;
    dealii::FESystem<dim>             element;
    dealii::DoFHandler<dim>           dofs;
    dealii::AffineConstraints<double> constraints;
    std::vector<int>                  unknown_of_dof; ///< -1 if constrained
    std::vector<unsigned int>         node_of_unknown;
    std::size_t                       n_constrained = 0;
    double                            assembly_s    = 0.;
    std::unique_ptr<Factorisation>    factor;
  };
} // namespace RollingContact

#endif
