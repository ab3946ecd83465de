#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/ranks.h>
#include <rolling_contact/base/stopwatch.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/bodies/distributed_body.h>
#include <rolling_contact/bodies/distributed_theta_system.h>
#include <rolling_contact/bodies/theta_motion.h>

#include <algorithm>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /** Relative residuals of body solves; contact laws hold to 1e-10. Columns
     * of W, which are corrected for the forces of a state but not for what the
     * edge law reads from W, are solved to the rough one. */
    const double solve_tolerance = 1e-11, rough_tolerance = 1e-9;

    /** Least growth of the model's elements near the contact and away from it.
     */
    const double near_growth = 0.08, far_growth = 0.5;
  } // namespace

  template <int dim>
  DistributedBody<dim>::DistributedBody(
    const std::shared_ptr<const BodyShape> &shape,
    const Materials                        &materials,
    const double                            thickness,
    const Grading<dim>                     &grading,
    const unsigned int                      model_rank,
    const BodyModel                        &model)
    : ElasticBody<dim>(shape,
                       materials,
                       thickness,
                       grading,
                       MeshKind::distributed,
                       model)
    , shape(shape)
    , grading(grading)
    , model_rank(model_rank)
  {
    if (shape->hub() == Hub::elastic || shape->hub() == Hub::mass)
      throw InputError(
        "Body solver = distributed and Hub = " +
        std::string(shape->hub() == Hub::elastic ? "elastic" : "mass") +
        ": a body spread over ranks has no springs and masses at its hub; take "
        "Body solver = direct, on one rank for each body.");
    double n = 0.;
    for (const auto dof : this->dofs.locally_owned_dofs())
      n += !this->constraints.is_constrained(dof);
    total_unknowns = Ranks::sum(n);
  }

  template <int dim>
  std::vector<DistributedVector> DistributedBody<dim>::rigid_modes() const
  {
    // turning about the contact point, the largest motions are of size 1
    return rigid_motions(discretisation(),
                         Point<dim>(),
                         shape->thickness_below());
  }

  template <int dim>
  void DistributedBody<dim>::analyse()
  {
    if (multigrid != nullptr)
      return;
    this->require_held();
    const Stopwatch watch;
    assemble_stiffness(discretisation(), K);
    this->assembly_s += watch.seconds();
    assembly_cpu_s = watch.cpu_seconds();
    const Stopwatch setup;
    multigrid   = std::make_unique<MultigridSolver>(K, rigid_modes(), dim);
    setup_cpu_s = setup.cpu_seconds();
  }

  template <int dim>
  std::unique_ptr<DirectBody<dim>> DistributedBody<dim>::make_model() const
  {
    if (Ranks::rank() != model_rank)
      return nullptr;
    Grading<dim> coarser = grading;
    coarser.far_distance = 2 * grading.semi_axis_x();
    coarser.growth       = std::max(grading.growth, near_growth);
    coarser.far_growth   = std::max(grading.growth, far_growth);
    return std::make_unique<DirectBody<dim>>(
      shape, this->materials, this->thickness, coarser, false, this->model);
  }

  template <int dim>
  auto
  DistributedBody<dim>::model_nodes(const DirectBody<dim>          &model,
                                    const std::vector<SurfaceNode> &nodes) const
    -> std::vector<SurfaceNode>
  {
    std::vector<SurfaceNode> result;
    std::vector<SurfaceFace> faces;
    model.surface(grading, result, faces);
    AssertThrow(result.size() == nodes.size(),
                ExcMessage("The model of a distributed body carries other "
                           "contact nodes than the body."));
    for (std::size_t i = 0; i < nodes.size(); ++i)
      AssertThrow(result[i].position.distance(nodes[i].position) <
                    1e-9 * grading.zone_x,
                  ExcMessage("The contact nodes of a distributed body and its "
                             "model do not match."));
    return result;
  }

  template <int dim>
  DenseMatrix
  DistributedBody<dim>::compliance(const std::vector<SurfaceNode>  &nodes,
                                   const std::vector<unsigned int> &components,
                                   const SparseRows                &P)
  {
    analyse();
    const Stopwatch watch;
    DenseMatrix     W;
    if (const auto model = make_model())
      {
        n_model_unknowns = model->n_unknowns();
        W = model->compliance(model_nodes(*model, nodes), components, P);
      }
    model_s = watch.seconds();
    return W;
  }

  template <int dim>
  std::vector<types::global_dof_index> DistributedBody<dim>::contact_dofs(
    const std::vector<SurfaceNode>  &nodes,
    const std::vector<unsigned int> &components)
  {
    std::vector<types::global_dof_index> result;
    for (const unsigned int component : components)
      for (const SurfaceNode &node : nodes)
        result.push_back(node.dofs[component]);
    return result;
  }

  template <int dim>
  void DistributedBody<dim>::add_forces(
    const std::vector<types::global_dof_index> &contact,
    const std::vector<double>                  &forces,
    DistributedVector                          &b) const
  {
    for (std::size_t i = 0; i < contact.size(); ++i)
      if (b.in_local_range(contact[i]))
        b(contact[i]) += forces[i];
  }

  template <int dim>
  std::vector<double> DistributedBody<dim>::on_contact(
    const std::vector<types::global_dof_index> &contact,
    const DistributedVector                    &values) const
  {
    std::vector<double> result(contact.size(), 0.);
    for (std::size_t i = 0; i < contact.size(); ++i)
      if (values.in_local_range(contact[i]))
        result[i] = values(contact[i]);
    Ranks::sum(result);
    return result;
  }

  template <int dim>
  void DistributedBody<dim>::solve(
    const std::vector<types::global_dof_index> &contact,
    const std::vector<std::vector<double>>     &forces,
    const double                                tolerance,
    std::vector<DistributedVector>             &x)
  {
    const Stopwatch watch;
    x.resize(std::min(x.size(), forces.size()));
    std::vector<DistributedVector> b;
    for (const std::vector<double> &load : forces)
      {
        b.push_back(vector());
        add_forces(contact, load, b.back());
        if (x.size() < b.size())
          x.push_back(vector());
        n_solves += norm(load) > 0.;
      }
    const auto report = multigrid->solve(x, b, tolerance);
    n_iterations += report.iterations;
    most_iterations = std::max(most_iterations, report.most);
    solve_s += watch.seconds();
    solve_cpu_s += watch.cpu_seconds();
  }

  template <int dim>
  std::vector<std::vector<double>>
  DistributedBody<dim>::response(const std::vector<SurfaceNode>  &nodes,
                                 const std::vector<unsigned int> &components,
                                 const std::vector<std::vector<double>> &forces,
                                 const bool roughly)
  {
    const auto                     contact = contact_dofs(nodes, components);
    std::vector<DistributedVector> rough;
    if (roughly)
      solve(contact, forces, rough_tolerance, rough);
    else if (forces != loads)
      {
        loads.clear(); // should the solve fail
        solve(contact, forces, solve_tolerance, solutions);
        loads = forces;
      }
    std::vector<std::vector<double>> displacements;
    for (const DistributedVector &solution : roughly ? rough : solutions)
      displacements.push_back(on_contact(contact, solution));
    return displacements;
  }

  namespace
  {
    /**
     * True if x = y + sign z.
     */
    bool is_sum(const std::vector<double> &x,
                const std::vector<double> &y,
                const double               sign,
                const std::vector<double> &z)
    {
      for (std::size_t i = 0; i < x.size(); ++i)
        if (x[i] != y[i] + sign * z[i])
          return false;
      return true;
    }
  } // namespace

  template <int dim>
  BodyField
  DistributedBody<dim>::recovered(const std::vector<SurfaceNode>  &nodes,
                                  const std::vector<unsigned int> &components,
                                  const std::vector<double>       &forces)
  {
    for (std::size_t k = 0; k < loads.size(); ++k)
      {
        if (loads[k] == forces)
          return field(solutions[k]);
        // tangential and normal parts, as twins are asked for them
        for (const double sign : {1., -1.})
          for (std::size_t j = 0; j < loads.size(); ++j)
            if (is_sum(forces, loads[k], sign, loads[j]))
              {
                DistributedVector sum = solutions[k];
                sum.add(sign, solutions[j]);
                return field(sum);
              }
      }
    loads.clear();
    solve(contact_dofs(nodes, components),
          {forces},
          solve_tolerance,
          solutions);
    loads = {forces};
    return field(solutions[0]);
  }

  template <int dim>
  std::vector<BodyField>
  DistributedBody<dim>::recover(const std::vector<SurfaceNode>  &nodes,
                                const std::vector<unsigned int> &components,
                                const std::vector<std::vector<double>> &forces)
  {
    std::vector<BodyField> displacements;
    displacements.reserve(forces.size()); // copies have no values at ghosts
    for (const std::vector<double> &load : forces)
      displacements.push_back(recovered(nodes, components, load));
    return displacements;
  }

  template <int dim>
  BodyField DistributedBody<dim>::field(const DistributedVector &solution) const
  {
    DistributedVector distributed = solution;
    this->constraints.distribute(distributed);
    BodyField result(this->dofs.locally_owned_dofs(),
                     this->relevant_dofs,
                     this->dofs.get_communicator());
    result.copy_locally_owned_data_from(distributed);
    result.update_ghost_values();
    return result;
  }

  template <int dim>
  std::unique_ptr<BodyDynamics>
  DistributedBody<dim>::in_time(const ThetaScheme               &scheme,
                                const MassKind                   mass,
                                const std::vector<SurfaceNode>  &nodes,
                                const std::vector<unsigned int> &components)
  {
    const BodyDamping &damping = this->model.damping;
    if (damping.has_sponge())
      throw InputError(
        "Body solver = distributed and Sponge length = " +
        significant(damping.sponge_length, 4) +
        " m: a body spread over ranks has no absorbing ends; take Body solver "
        "= direct, on one rank for each body, or a length of 0.");
    ThetaScheme damped = scheme;
    damped.mass_damping += damping.mass_damping;
    damped.stiffness_damping += damping.stiffness_damping;
    if (damping.loss_factor > 0.)
      damped.stiffness_damping +=
        damping.loss_factor / (2 * numbers::PI * damping.loss_frequency);
    return std::make_unique<ThetaMotion<DistributedBody>>(
      *this,
      std::make_shared<DistributedThetaSystem<dim>>(
        *this, damped, mass, nodes, components));
  }

  template <int dim>
  void DistributedBody<dim>::release_solver()
  {
    multigrid.reset();
    K.clear();
    loads.clear();
    solutions.clear();
  }

  template <int dim>
  std::string DistributedBody<dim>::description() const
  {
    if (n_solves == 0)
      return "";
    std::string text =
      std::to_string(total_unknowns) + " unknowns on " +
      std::to_string(Ranks::count()) +
      (Ranks::count() == 1 ? " rank; " : " ranks; ") +
      std::to_string(n_solves) + " solves, " +
      significant(double(n_iterations) / n_solves, 3) +
      " iterations each, at most " + std::to_string(most_iterations) +
      "; CPU of this rank: assembly " + human_seconds(assembly_cpu_s) +
      ", multigrid " + human_seconds(setup_cpu_s) + ", solves " +
      human_seconds(solve_cpu_s);
    if (n_model_unknowns > 0)
      text += "; model of " + std::to_string(n_model_unknowns) + " unknowns " +
              human_seconds(model_s);
    return text + ".";
  }

  template <int dim>
  std::size_t DistributedBody<dim>::solver_memory() const
  {
    return (multigrid ? multigrid->memory_consumption() : 0) +
           K.memory_consumption();
  }

  template <int dim>
  double DistributedBody<dim>::solver_seconds() const
  {
    return (multigrid ? multigrid->setup_seconds() : 0.) + solve_s + model_s;
  }

  template class DistributedBody<2>;
  template class DistributedBody<3>;
} // namespace RollingContact
