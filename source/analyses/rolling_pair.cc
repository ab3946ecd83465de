#include <deal.II/lac/vector.h>

#include <rolling_contact/analyses/both_bodies.h>
#include <rolling_contact/analyses/patch_estimate.h>
#include <rolling_contact/analyses/rolling_pair.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/log.h>
#include <rolling_contact/base/memory.h>
#include <rolling_contact/contact/roughness.h>

#include <cmath>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /**
     * Throws InputError if the candidate zone does not fit on a body.
     */
    template <int dim>
    void
    check_room(const SceneParameters &scene, const Grading<dim> &grading)
    {
      for (const BodyParameters *body : {&scene.wheel, &scene.rail})
        {
          if (body->rigid)
            continue;
          const double length = body->shape == "disc" ? 0.55 * body->radius
                                                      : body->block_length / 2;
          if (grading.zone_x > length)
            throw InputError(
              body->section + ": the contact zone reaches " +
              significant(grading.zone_x, 3) +
              " m from its middle, beyond what the body offers (" +
              significant(length, 3) +
              " m along x): check load, radii and Block length.");
          if (dim == 3 && grading.zone_y > body->width / 2)
            throw InputError(
              body->section + "/Width = " + significant(body->width, 4) +
              ": the contact zone is " + significant(2 * grading.zone_y, 3) +
              " m wide; the patch must not reach the edges of "
              "the body.");
        }
    }
  } // namespace



  template <int dim>
  RollingPair<dim>::RollingPair(const SceneParameters &scene,
                                const Grading<dim>    &grading,
                                const bool             statics)
    : scene(scene)
  {
    check_room(scene, grading);
    const auto build = [&](const BodyParameters &body) {
      auto result = std::make_shared<ElasticBody<dim>>(body.geometry(),
                                                       body.material,
                                                       body.thickness,
                                                       grading);
      if (statics)
        result->analyse();
      return result;
    };
    const bool twins = !scene.wheel.rigid &&
                       scene.wheel.geometry() == scene.rail.geometry() &&
                       scene.wheel.material == scene.rail.material;
    for_both_bodies(
      scene.body_threads,
      [&]() {
        if (!scene.wheel.rigid)
          wheel_body = build(scene.wheel);
      },
      [&]() {
        if (!scene.rail.rigid && !twins)
          rail_body = build(scene.rail);
      });
    if (twins)
      rail_body = wheel_body;
    if (scene.contact.friction_coefficient > 0.)
      for (unsigned int d = 0; d < dim - 1; ++d)
        components.push_back(d);
    components.push_back(dim - 1);
    pair_surfaces(grading);
  }



  template <int dim>
  void
  RollingPair<dim>::pair_surfaces(const Grading<dim> &zone)
  {
    using Face = typename ElasticBody<dim>::SurfaceFace;
    std::vector<Face> faces;
    if (wheel_body)
      wheel_body->surface(zone, wheel_nodes, faces);
    if (twins())
      rail_nodes = wheel_nodes;
    else if (rail_body)
      rail_body->surface(zone, rail_nodes, faces);
    if (wheel_body && rail_body)
      {
        AssertThrow(wheel_nodes.size() == rail_nodes.size(),
                    ExcMessage("The surfaces of wheel and rail carry different "
                               "numbers of nodes."));
        for (std::size_t i = 0; i < wheel_nodes.size(); ++i)
          AssertThrow(wheel_nodes[i].position.distance(rail_nodes[i].position) <
                        1e-9 * zone.zone_x,
                      ExcMessage("The surface nodes of wheel and rail do not "
                                 "match."));
      }

    contact_trace              = Trace();
    contact_trace.n_dimensions = dim - 1;
    for (const auto &node : wheel_body ? wheel_nodes : rail_nodes)
      contact_trace.nodes.push_back(
        {{node.position[0], dim == 3 ? node.position[dim - 2] : 0.}});
    for (const Face &face : faces)
      {
        Trace::Cell cell;
        for (unsigned int d = 0; d < dim - 1; ++d)
          {
            cell.lower[d] = face.lower[d];
            cell.upper[d] = face.upper[d];
          }
        cell.corners = face.corners;
        contact_trace.cells.push_back(cell);
      }
  }



  namespace
  {
    /**
     * Add a body's compliance, given in its own frame. In the wheel's frame z
     * is mirrored: the blocks between tangential and normal components change
     * sign.
     */
    void
    add_compliance(const DenseMatrix &body,
                   const bool         mirrored,
                   const std::size_t  n_nodes,
                   DenseMatrix       &pair)
    {
      const std::size_t n = body.n_rows(), first_normal = n - n_nodes;
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i)
          {
            const bool flips =
              mirrored && ((i < first_normal) != (j < first_normal));
            pair(i, j) += flips ? -body(i, j) : body(i, j);
          }
    }
  } // namespace



  namespace
  {
    /**
     * Throws InputError if the dense matrices of contact space, W of each body
     * and of the pair and products of it, do not fit into 70 % of the free
     * memory.
     */
    void
    check_contact_memory(const std::size_t n_nodes,
                         const std::size_t n_components)
    {
      const double n = double(n_nodes) * n_components, n_matrices = 5;
      const double bytes = n_matrices * n * n * sizeof(double);
      const double free  = available_memory();
      if (free > 0. && bytes > 0.7 * free)
        throw InputError("The " + std::to_string(n_nodes) +
                         " contact nodes need about " + human_bytes(bytes) +
                         " for their compliance, more than 70 % of the " +
                         human_bytes(free) +
                         " free: take fewer Mesh/Elements across patch, a "
                         "smaller Mesh/Candidate zone or a smaller "
                         "Mesh/Contact node budget.");
    }



    /**
     * Whether anything after the contact solve asks for a displacement: fields,
     * the marks of the next level, the start of a motion with mass.
     */
    bool
    wants_displacements(const SceneParameters &scene)
    {
      const bool has_fields =
        scene.analysis == "quasi-static" || scene.is_transient();
      return scene.mesh.adaptive_levels > 0 ||
             (has_fields && scene.output.body_fields) ||
             (scene.is_transient() && scene.time.inertia);
    }
  } // namespace



  template <int dim>
  DenseMatrix
  RollingPair<dim>::pair_compliance()
  {
    check_contact_memory(contact_trace.nodes.size(), components.size());
    const bool  recovers = wants_displacements(scene);
    DenseMatrix wheel, rail;
    for_both_bodies(
      scene.body_threads,
      [&]() {
        if (wheel_body)
          wheel = wheel_body->compliance(wheel_nodes, components, recovers);
      },
      [&]() {
        if (rail_body && !twins())
          rail = rail_body->compliance(rail_nodes, components, recovers);
      });
    return combined(wheel, rail);
  }



  template <int dim>
  DenseMatrix
  RollingPair<dim>::combined(const DenseMatrix &wheel,
                             const DenseMatrix &rail) const
  {
    const std::size_t n_nodes = contact_trace.nodes.size();
    DenseMatrix W(components.size() * n_nodes, components.size() * n_nodes);
    if (wheel_body)
      add_compliance(wheel, true, n_nodes, W);
    if (rail_body)
      add_compliance(twins() ? wheel : rail, false, n_nodes, W);
    return W;
  }



  template <int dim>
  ContactProblem
  RollingPair<dim>::contact_problem(const SlipOperatorKind slip_operator)
  {
    return contact_problem(slip_operator, pair_compliance());
  }



  template <int dim>
  ContactProblem
  RollingPair<dim>::contact_problem(const SlipOperatorKind slip_operator,
                                    DenseMatrix            W) const
  {
    const ContactParameters &contact = scene.contact;
    ContactProblem           problem;
    problem.n_nodes      = contact_trace.nodes.size();
    problem.n_tangential = components.size() - 1;
    problem.positions    = contact_trace.nodes;
    problem.W            = std::move(W);
    problem.coupled      = !twins() && problem.n_tangential > 0;
    problem.dundurs_beta = pair_constants(scene).dundurs_beta;
    problem.H            = contact_matrix(contact_trace,
                               contact.contact_matrices_kind(),
                               dim == 2 ? scene.thickness() : 1.);
    if (problem.n_tangential > 0)
      problem.slip_operator = SlipOperator(contact_trace,
                                           slip_operator,
                                           contact.contact_matrices_kind(),
                                           contact.flow());
    const BodyGeometry wheel = scene.wheel.geometry(),
                       rail  = scene.rail.geometry();
    const Roughness roughness(contact.roughness);
    for (const auto &node : contact_trace.nodes)
      problem.gap.push_back(-wheel.surface_height(node[0], node[1]) -
                            rail.surface_height(node[0], node[1]) +
                            roughness.value(node[0], node[1]));
    problem.friction.assign(problem.n_nodes, contact.friction_coefficient);
    problem.set_creepages(contact.creepage_x, contact.creepage_y, contact.spin);
    problem.normal_load = contact.normal_load();
    problem.approach    = contact.approach().value_or(0.);
    problem.finish();
    return problem;
  }



  template <int dim>
  void
  RollingPair<dim>::release_statics()
  {
    for (const auto &body : {wheel_body, rail_body})
      if (body)
        body->release_factorisation();
    release_free_memory();
  }



  template <int dim>
  std::vector<double>
  RollingPair<dim>::reactions(const Side            side,
                              const ContactProblem &problem,
                              const ContactState   &state) const
  {
    std::vector<double> forces;
    if (problem.n_tangential > 0)
      forces = problem.H.multiply(state.traction);
    for (double &force : forces)
      force *= side == Side::wheel ? 1. : -1.;
    for (const double force : problem.H.multiply(state.pressure))
      forces.push_back(-force);
    return forces;
  }



  template <int dim>
  Vector<double>
  RollingPair<dim>::displacement(const Side            side,
                                 const ContactProblem &problem,
                                 const ContactState   &state) const
  {
    return body(side)->recover(nodes(side),
                               components,
                               reactions(side, problem, state));
  }



  template <int dim>
  std::vector<std::size_t>
  RollingPair<dim>::unknowns(const Side side) const
  {
    return body(side)->unknowns(nodes(side), components);
  }



  template class RollingPair<2>;
  template class RollingPair<3>;
} // namespace RollingContact
