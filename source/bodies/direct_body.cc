#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/mapping_q1.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/stopwatch.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/bodies/direct_body.h>
#include <rolling_contact/bodies/portable_dof_order.h>
#include <rolling_contact/bodies/theta_motion.h>

namespace RollingContact
{
  using namespace dealii;

  template <int dim>
  DirectBody<dim>::DirectBody(const std::shared_ptr<const BodyShape> &shape,
                              const Materials                        &materials,
                              const double                            thickness,
                              const Grading<dim>                     &grading,
                              const bool                              recovers,
                              const BodyModel                        &model)
    : ElasticBody<dim>(shape,
                       materials,
                       thickness,
                       grading,
                       MeshKind::serial,
                       model)
    , recovers(recovers)
    , unknown_of_dof(this->dofs.n_dofs() + this->supports.n_extra(), -1)
  {
    int unknown = 0;
    for (types::global_dof_index i = 0; i < unknown_of_dof.size(); ++i)
      if (this->constraints.is_constrained(i))
        ++n_constrained;
      else
        {
          unknown_of_dof[i]    = unknown++;
          const bool same_node = i % dim != 0 && !node_of_unknown.empty() &&
                                 unknown_of_dof[i - 1] >= 0;
          node_of_unknown.push_back(
            node_of_unknown.empty() ? 0 : node_of_unknown.back() + !same_node);
        }
  }

  template <int dim>
  std::vector<std::size_t>
  DirectBody<dim>::unknowns(const std::vector<SurfaceNode>  &nodes,
                            const std::vector<unsigned int> &components) const
  {
    std::vector<std::size_t> result;
    for (const unsigned int component : components)
      for (const SurfaceNode &node : nodes)
        result.push_back(unknown_of_dof[node.dofs[component]]);
    return result;
  }

  template <int dim>
  std::vector<double> DirectBody<dim>::uniform(const unsigned int component,
                                               const double       value) const
  {
    std::vector<double> result(n_unknowns(), 0.);
    const std::size_t   n_moving =
      this->dofs.n_dofs() + this->supports.n_translations();
    for (std::size_t i = 0; i < n_moving; ++i)
      if (unknown_of_dof[i] >= 0 && i % dim == component)
        result[unknown_of_dof[i]] = value;
    return result;
  }

  template <int dim>
  BodyField DirectBody<dim>::field(const std::vector<double> &values) const
  {
    BodyField result(unknown_of_dof.size());
    for (std::size_t i = 0; i < unknown_of_dof.size(); ++i)
      if (unknown_of_dof[i] >= 0)
        result[i] = values[unknown_of_dof[i]];
    this->constraints.distribute(result);
    return result;
  }

  template <int dim>
  std::vector<double> DirectBody<dim>::unknowns_of(const BodyField &field) const
  {
    std::vector<double> result(n_unknowns());
    for (std::size_t i = 0; i < unknown_of_dof.size(); ++i)
      if (unknown_of_dof[i] >= 0)
        result[unknown_of_dof[i]] = field[i];
    return result;
  }

  template <int dim>
  std::vector<double>
  DirectBody<dim>::loads_of_nodes(const BodyField   &nodes,
                                  const unsigned int component) const
  {
    BodyField loads(unknown_of_dof.size());
    for (types::global_dof_index i = 0; i < this->dofs.n_dofs(); i += dim)
      if (nodes[i] != 0.)
        this->constraints.distribute_local_to_global(i + component,
                                                     nodes[i],
                                                     loads);
    return unknowns_of(loads);
  }

  template <int dim>
  std::vector<std::size_t> DirectBody<dim>::portable_dof_order() const
  {
    std::vector<Point<dim>> positions(this->dofs.n_dofs());
    DoFTools::map_dofs_to_support_points(MappingQ1<dim>(),
                                         this->dofs,
                                         positions);
    std::vector<NodeValue<dim>> values;
    values.reserve(n_unknowns());
    for (std::size_t i = 0; i < positions.size(); ++i)
      if (unknown_of_dof[i] >= 0)
        values.push_back({positions[i],
                          static_cast<unsigned int>(i % dim),
                          static_cast<std::size_t>(unknown_of_dof[i])});
    std::vector<std::size_t> order =
      RollingContact::in_portable_order(std::move(values));
    for (std::size_t i = positions.size(); i < unknown_of_dof.size(); ++i)
      order.push_back(unknown_of_dof[i]);
    return order;
  }

  template <int dim>
  BodyMotion
  DirectBody<dim>::in_portable_order(const std::vector<double> &displacement,
                                     const std::vector<double> &velocity) const
  {
    BodyMotion motion;
    for (const std::size_t i : portable_dof_order())
      {
        motion.displacement.push_back(displacement[i]);
        motion.velocity.push_back(velocity[i]);
      }
    return motion;
  }

  template <int dim>
  std::pair<std::vector<double>, std::vector<double>>
  DirectBody<dim>::from_portable_order(const BodyMotion &motion) const
  {
    std::vector<double> u(n_unknowns()), v(n_unknowns());
    std::size_t         k = 0;
    for (const std::size_t i : portable_dof_order())
      {
        u[i] = motion.displacement[k];
        v[i] = motion.velocity[k++];
      }
    return {u, v};
  }

  template <int dim>
  std::vector<double>
  DirectBody<dim>::lumped_momentum(const std::vector<double> &velocity) const
  {
    std::vector<double> momentum(velocity.size());
    mass(MassKind::lumped).multiply(velocity, momentum);
    return momentum;
  }

  template <int dim>
  void DirectBody<dim>::analyse()
  {
    if (factor != nullptr)
      return;
    this->require_held();
    throw_if_interrupted_alone();
    const Stopwatch watch;
    factor = std::make_unique<Factorisation>(stiffness(), node_of_unknown);
    this->assembly_s += watch.seconds() - factor->size().analysis_s;
    throw_if_interrupted_alone();
  }

  template <int dim>
  DenseMatrix DirectBody<dim>::solve(DenseMatrix columns)
  {
    DirectBody::analyse();
    factor->factorise();
    factor->solve(columns);
    return columns;
  }

  template <int dim>
  DenseMatrix
  DirectBody<dim>::compliance(const std::vector<SurfaceNode>  &nodes,
                              const std::vector<unsigned int> &components,
                              const SparseRows                &P)
  {
    analyse();
    factor->factorise();
    throw_if_interrupted_alone();
    const auto  loaded = unknowns(nodes, components);
    DenseMatrix W =
      P.size() == 0 ? factor->condense(loaded)
                    : factor->condense(of_components(P, loaded, nodes.size()));
    if (!recovers)
      factor->release();
    return W;
  }

  template <int dim>
  std::vector<std::vector<double>>
  DirectBody<dim>::response(const std::vector<SurfaceNode>         &nodes,
                            const std::vector<unsigned int>        &components,
                            const std::vector<std::vector<double>> &forces,
                            const bool)
  {
    const auto                       loaded = unknowns(nodes, components);
    std::vector<std::vector<double>> displacements;
    for (const std::vector<double> &load : forces)
      {
        std::vector<double> values(n_unknowns(), 0.);
        for (std::size_t i = 0; i < loaded.size(); ++i)
          values[loaded[i]] = load[i];
        values = factor->solve(values);
        displacements.emplace_back();
        for (const std::size_t unknown : loaded)
          displacements.back().push_back(values[unknown]);
      }
    return displacements;
  }

  template <int dim>
  std::vector<BodyField>
  DirectBody<dim>::recover(const std::vector<SurfaceNode>         &nodes,
                           const std::vector<unsigned int>        &components,
                           const std::vector<std::vector<double>> &forces)
  {
    const auto  loaded = unknowns(nodes, components);
    DenseMatrix block  = DenseMatrix::Zero(n_unknowns(), forces.size());
    for (std::size_t k = 0; k < forces.size(); ++k)
      for (std::size_t i = 0; i < loaded.size(); ++i)
        block(loaded[i], k) += forces[k][i];
    factor->solve(block);
    std::vector<BodyField> displacements;
    for (std::size_t k = 0; k < forces.size(); ++k)
      displacements.push_back(field(column_of(block, k)));
    return displacements;
  }

  template <int dim>
  std::unique_ptr<BodyDynamics>
  DirectBody<dim>::in_time(const ThetaScheme               &scheme,
                           const MassKind                   mass_kind,
                           const std::vector<SurfaceNode>  &nodes,
                           const std::vector<unsigned int> &components)
  {
    return std::make_unique<ThetaMotion<DirectBody>>(
      *this,
      std::make_shared<ThetaSystem>(scheme,
                                    stiffness(),
                                    mass(mass_kind),
                                    node_of_unknown,
                                    unknowns(nodes, components),
                                    damping_in_time(mass_kind)));
  }

  template <int dim>
  std::unique_ptr<ContactVibration> DirectBody<dim>::vibration_of(
    const std::vector<SurfaceNode>  &nodes,
    const std::vector<unsigned int> &components) const
  {
    return std::make_unique<VibrationOfUnknowns>(unknowns(nodes, components),
                                                 n_unknowns());
  }

  template <int dim>
  std::string DirectBody<dim>::description() const
  {
    if (factor == nullptr)
      return "";
    const Factorisation::Size &size = factor->size();
    return std::to_string(n_unknowns()) + " unknowns; factorisation " +
           human_seconds(size.factor_s) + ", condensation " +
           human_seconds(size.condensation_s) + ": together " +
           significant(1 + size.condensation_s / size.factor_s, 3) +
           " factorisations.";
  }

  template <int dim>
  std::size_t DirectBody<dim>::solver_memory() const
  {
    return factor ? factor->size().memory_consumption() : 0;
  }

  template <int dim>
  double DirectBody<dim>::solver_seconds() const
  {
    return factor ? factor->size().analysis_s + factor->size().factor_s : 0.;
  }

  template class DirectBody<2>;
  template class DirectBody<3>;
} // namespace RollingContact
