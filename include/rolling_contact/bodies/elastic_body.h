#ifndef rolling_contact_bodies_elastic_body_h
#define rolling_contact_bodies_elastic_body_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/lac/affine_constraints.h>

#include <rolling_contact/algebra/dense_matrix.h>
#include <rolling_contact/algebra/grid_compliance.h>
#include <rolling_contact/algebra/sparse_rows.h>
#include <rolling_contact/bodies/body_dynamics.h>
#include <rolling_contact/bodies/body_matrices.h>
#include <rolling_contact/bodies/supports.h>
#include <rolling_contact/mesh/body_mesh.h>
#include <rolling_contact/mesh/material.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace RollingContact
{
  template <int dim>
  class DirectBody;

  /**
   * One elastic body in its own frame (z out of the body): linear elements, in
   * 2D plane strain with a thickness, what is at its hub, damping; see
   * BodyModel. Contact space sees it only through compliance(), response() and
   * recover(), dynamics through in_time(). How K is solved is left to
   * DirectBody and DistributedBody. All members are called on all ranks that
   * hold a part of the body, and unless they say otherwise give the same on
   * each.
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

    virtual ~ElasticBody() = default;

    /**
     * The body if one rank has all of it and the factor of its stiffness;
     * nullptr for others. Not collective.
     */
    virtual const DirectBody<dim> *with_factor() const
    {
      return nullptr;
    }

    /**
     * Faces of the contact surface in the zone of contact nodes and the nodes
     * they touch, both in ascending x (then y).
     */
    void surface(const Grading<dim>       &zone,
                 std::vector<SurfaceNode> &nodes,
                 std::vector<SurfaceFace> &faces) const;

    /**
     * The contact nodes at given vertices of the contact surface, which are
     * numbered as in the mesh; in the order of the vertices.
     */
    std::vector<SurfaceNode>
    nodes_at(const std::vector<unsigned int> &vertices) const;

    /**
     * Assemble K and prepare its solution for compliance(), which does so
     * itself if need be. Throws InputError if nothing holds the body.
     */
    virtual void analyse() = 0;

    /**
     * Compliance of the given nodes: displacement of component @p components[i]
     * at node n for unit nodal forces; row and column i * N + n. Exact, or an
     * approximation that response() corrects. One rank does the work and has
     * the matrix, without the others, where it is empty. With @p P, whose rows
     * have numbers of nodes and shares, that of loads which are spread over the
     * nodes by it and of displacements taken by it, P W P^T in each pair of
     * components. Units: m/N.
     */
    virtual DenseMatrix compliance(const std::vector<SurfaceNode>  &nodes,
                                   const std::vector<unsigned int> &components,
                                   const SparseRows                &P) = 0;

    /**
     * The compliance() without a matrix, of bodies whose nodes are on a grid.
     */
    virtual std::optional<GridInfluence>
    grid_influence(const std::vector<SurfaceNode> &,
                   const std::vector<unsigned int> &)
    {
      return {};
    }

    /** Compliance of nodes of the body, without a coupling to an interface. */
    DenseMatrix compliance(const std::vector<SurfaceNode>  &nodes,
                           const std::vector<unsigned int> &components)
    {
      return compliance(nodes, components, SparseRows());
    }

    /**
     * Displacement of the given nodes under nodal forces on them, in the order
     * of compliance(), for several loads at once; to all digits, or roughly, to
     * seven. Units: N to m.
     */
    virtual std::vector<std::vector<double>>
    response(const std::vector<SurfaceNode>         &nodes,
             const std::vector<unsigned int>        &components,
             const std::vector<std::vector<double>> &forces,
             const bool                              roughly) = 0;

    /**
     * Displacements of the whole body under each of several sets of nodal
     * forces (component i of node n at components[i] * N + n). Units: N to m.
     */
    virtual std::vector<BodyField>
    recover(const std::vector<SurfaceNode>         &nodes,
            const std::vector<unsigned int>        &components,
            const std::vector<std::vector<double>> &forces) = 0;

    /**
     * The motion of the body in time by @p scheme, with contact on the given
     * components of the given nodes, numbered as in compliance().
     */
    virtual std::unique_ptr<BodyDynamics>
    in_time(const ThetaScheme               &scheme,
            const MassKind                   mass,
            const std::vector<SurfaceNode>  &nodes,
            const std::vector<unsigned int> &components) = 0;

    /**
     * How far off compliance() may be for given sets of nodal forces on the
     * nodes, in parts that do not cancel each other, if the body knows by
     * itself: work of the forces of the row under those of the column. Units:
     * J.
     */
    virtual std::vector<DenseMatrix> compliance_errors(
      const std::vector<SurfaceNode> & /* nodes */,
      const std::vector<unsigned int> & /* components */,
      const std::vector<std::vector<double>> & /* forces */) const
    {
      return {};
    }

    /**
     * Free what solves K; compliance() would compute it again.
     */
    virtual void release_solver() = 0;

    /**
     * Free the factor of K for good, if there is one, when nothing is to be
     * solved any more; what is told of it stays.
     */
    virtual void release_factor()
    {}

    virtual std::size_t n_unknowns() const = 0;

    /**
     * What prepared the solution of K and what it took, for the log: "120000
     * unknowns; factorisation 3 s, ...". Empty before compliance().
     */
    virtual std::string description() const = 0;

    /**
     * Memory of what solves K. Units: bytes.
     */
    virtual std::size_t solver_memory() const = 0;

    /**
     * Wall time that it took to prepare the solution of K. Units: s.
     */
    virtual double solver_seconds() const = 0;

    /**
     * Degrees of freedom on this rank and its ghosts: number i is one of
     * component i modulo dim. Cells of other ranks are not locally owned.
     */
    const dealii::DoFHandler<dim> &dof_handler() const
    {
      return dofs;
    }

    /**
     * Hanging nodes and what is held.
     */
    const dealii::AffineConstraints<double> &ties() const
    {
      return constraints;
    }

    const Materials &elasticity() const
    {
      return materials;
    }

    const BodyMesh<dim> &mesh() const
    {
      return body_mesh;
    }

    double assembly_seconds() const
    {
      return assembly_s;
    }

  protected:
    /**
     * Mesh and distribute. @p thickness is used in 2D. Units: m.
     */
    ElasticBody(const std::shared_ptr<const BodyShape> &shape,
                const Materials                        &materials,
                const double                            thickness,
                const Grading<dim>                     &grading,
                const MeshKind                          kind,
                const BodyModel                        &model);

    /**
     * Throws InputError if nothing holds the body.
     */
    void require_held() const;

    Materials                         materials;
    double                            thickness;
    Hub                               hub;
    BodyModel                         model;
    BodyMesh<dim>                     body_mesh;
    dealii::FESystem<dim>             element;
    dealii::DoFHandler<dim>           dofs;
    dealii::IndexSet                  relevant_dofs;
    Supports<dim>                     supports;
    dealii::AffineConstraints<double> constraints;
    double                            assembly_s = 0.;

  private:
    using CellIterator = typename dealii::DoFHandler<dim>::active_cell_iterator;

    void for_each_surface_face(
      const std::function<void(const CellIterator &, const unsigned int)>
        &action) const;
  };
} // namespace RollingContact

#endif
