#include <rolling_contact/pair/mesh_limits.h>
#include <rolling_contact/pair/parallel_bodies.h>
#include <rolling_contact/pair/patch_estimate.h>
#include <rolling_contact/pair/places.h>
#include <rolling_contact/pair/profile_surface.h>
#include <rolling_contact/pair/rolling_pair.h>
#include <rolling_contact/surfaces/roughness.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace RollingContact
{
  using namespace dealii;

  template <int dim>
  RollingPair<dim>::RollingPair(const PairSpec     &scene,
                                const Grading<dim> &grading,
                                const PairDemands  &demands,
                                const bool          statics)
    : RollingPair(BodyPair<dim>(scene, grading, demands, statics),
                  scene,
                  grading,
                  demands)
  {}

  template <int dim>
  RollingPair<dim>::RollingPair(const PairSpec      &scene,
                                const Grading<dim>  &grading,
                                const PairDemands   &demands,
                                const BodyPair<dim> &bodies)
    : RollingPair(for_several_places(scene, bodies), scene, grading, demands)
  {}

  template <int dim>
  RollingPair<dim>::RollingPair(BodyPair<dim>       bodies,
                                const PairSpec     &scene,
                                const Grading<dim> &grading,
                                const PairDemands  &demands)
    : scene(scene)
    , body_pair(std::move(bodies))
    , pair_interface(scene, grading, body_pair)
    , surfaces(scene,
               {{grading.element_size_x, grading.element_size_y},
                {grading.zone_x, grading.zone_y}})
    , demands(demands)
    , element_size(std::max(grading.element_size_x, grading.element_size_y))
  {
    choose_components();
  }

  template <int dim>
  RollingPair<dim>::RollingPair(const PairSpec &scene, const RollingPair &other)
    : scene(scene)
    , body_pair(other.body_pair)
    , pair_interface(other.pair_interface)
    , surfaces(other.surfaces)
    , components(other.components)
    , demands(other.demands)
    , element_size(other.element_size)
    , errors(other.errors)
  {
    if (scene.frame != other.scene.frame && scene.follows_profiles())
      throw std::logic_error("Bodies that know their place are at another.");
  }

  template <int dim>
  void RollingPair<dim>::choose_components()
  {
    if (scene.contact.friction_coefficient > 0. || pair_interface.turns_nodes())
      for (unsigned int d = 0; d < dim - 1; ++d)
        components.push_back(d);
    components.push_back(dim - 1);
  }

  template <int dim>
  std::vector<double>
  RollingPair<dim>::relative_motion(PerSide<std::vector<double>> bodies) const
  {
    std::vector<double> result(components.size() * trace().nodes.size(), 0.);
    for (const Side side : both_sides)
      {
        const auto part = relative_motion_of(side, std::move(bodies[side]));
        as_vector(result).head(part.size()) += as_vector(part);
      }
    return result;
  }

  template <int dim>
  std::vector<double>
  RollingPair<dim>::relative_motion_of(const Side          side,
                                       std::vector<double> motion) const
  {
    motion = pair_interface.coupling[side].to_interface(
      body_pair.on_all_ranks(side, std::move(motion)));
    const std::size_t first_normal = motion.size() - trace().nodes.size();
    for (std::size_t i = 0; i < motion.size(); ++i)
      if (side == Side::rail || i >= first_normal)
        motion[i] = -motion[i];
    return motion;
  }

  template <int dim>
  std::vector<bool> RollingPair<dim>::border_nodes() const
  {
    std::vector<bool> border = trace().border_nodes();
    for (unsigned int i = 0; i < border.size(); ++i)
      if (border[i] && scene.touches_in_line())
        border[i] =
          !trace().element_size(i, +1) || !trace().element_size(i, -1);
    return border;
  }

  template <int dim>
  bool RollingPair<dim>::compliance_is_exact() const
  {
    return body_pair.body_solver() != BodySolver::distributed;
  }

  namespace
  {
    using Loads = std::vector<std::vector<double>>;

    /**
     * The tangential and the normal part of each set of forces, one after the
     * other: twins answer tangential forces with opposite motions, normal ones
     * with equal motions.
     */
    Loads split(const Loads &forces, const std::size_t n_nodes)
    {
      Loads parts;
      for (const std::vector<double> &load : forces)
        {
          const std::size_t n_tangential = load.size() - n_nodes;
          for (const bool normal : {false, true})
            {
              std::vector<double> part = load;
              std::fill(normal ? part.begin() : part.begin() + n_tangential,
                        normal ? part.begin() + n_tangential : part.end(),
                        0.);
              parts.push_back(part);
            }
        }
      return parts;
    }
  } // namespace

  template <int dim>
  std::vector<std::vector<double>>
  RollingPair<dim>::response(const Loads &forces, const bool roughly) const
  {
    const auto displacements = [&](const Side side, const Loads &pair_forces) {
      Loads loads;
      for (const std::vector<double> &load : pair_forces)
        loads.push_back(forces_on_body(side, load));
      return body_pair.body(side)->response(pair_interface.nodes[side],
                                            components,
                                            loads,
                                            roughly);
    };
    Loads result;
    if (body_pair.twins())
      {
        const Loads parts =
          displacements(Side::rail, split(forces, trace().nodes.size()));
        for (std::size_t k = 0; k < forces.size(); ++k)
          {
            // under mirrored forces the wheel moves by -(tangential) + normal
            const std::vector<double> &tangential = parts[2 * k],
                                      &normal     = parts[2 * k + 1];
            PerSide<std::vector<double>> motion{normal, normal};
            for (std::size_t i = 0; i < normal.size(); ++i)
              {
                motion.wheel[i] -= tangential[i];
                motion.rail[i] += tangential[i];
              }
            result.push_back(relative_motion(std::move(motion)));
          }
        return result;
      }
    PerSide<Loads> motions;
    for (const Side side : both_sides)
      motions[side] = body_pair.body(side) ? displacements(side, forces)
                                           : Loads(forces.size());
    for (std::size_t k = 0; k < forces.size(); ++k)
      result.push_back(relative_motion({motions.wheel[k], motions.rail[k]}));
    return result;
  }

  template <int dim>
  ContactProblem
  RollingPair<dim>::contact_problem(const ContactParameters &contact)
  {
    const std::size_t                  n_nodes = std::max({trace().nodes.size(),
                                                           pair_interface.nodes.wheel.size(),
                                                           pair_interface.nodes.rail.size()});
    const std::optional<GridInfluence> on_grid = influence_on_grid();
    if (!on_grid)
      check_contact_memory(double(n_nodes) * components.size(), false);
    PerSide<DenseMatrix> W, lacking;
    prepare_bulk_errors();
    const auto condense = [&](const Side side) {
      const SurfaceCoupling &coupling = pair_interface.coupling[side];
      if (!body_pair.body(side) || !body_pair.has_own_body(side))
        return;
      if (!on_grid)
        W[side] = coupling.turned(body_pair.body(side)->compliance(
          pair_interface.nodes[side], components, coupling.projection()));
      lacking[side] = bulk_errors_of(side);
    };
    for_both_bodies(
      body_pair.n_threads(),
      [&]() { condense(Side::wheel); },
      [&]() { condense(Side::rail); });
    add_bulk_errors(std::move(lacking));
    if (on_grid)
      return contact_problem(
        contact,
        ContactCompliance(std::make_shared<const GridCompliance>(*on_grid)));
    return contact_problem(contact, added_compliance(std::move(W)));
  }

  template <int dim>
  ContactProblem
  RollingPair<dim>::contact_problem(const ContactParameters &contact,
                                    ContactCompliance        W) const
  {
    const bool          friction  = components.size() > 1;
    const auto         &at        = trace().nodes;
    const PairConstants constants = pair_constants(scene);
    ContactProblem      problem;
    problem.operators =
      ContactOperators(at,
                       contact_matrix(trace(),
                                      contact.contact_matrices,
                                      dim == 2 ? scene.thickness() : 1.),
                       std::move(W),
                       friction ? SlipOperator(trace(),
                                               contact.slip_operator,
                                               contact.contact_matrices,
                                               contact.flow())
                                : SlipOperator(contact.slip_operator),
                       {!body_pair.twins() && friction,
                        constants.dundurs_beta,
                        1 / (1 - constants.elasticity.poisson_ratio)},
                       body_pair.is_split() ? NodalForces::hats
                                            : NodalForces::of_elements);
    set_surfaces(problem);
    set_loads(contact, problem);
    return problem;
  }

  template <int dim>
  void RollingPair<dim>::set_surfaces(ContactProblem &problem) const
  {
    const auto &at = trace().nodes;
    problem.operators.set_frames(surface_frames(scene, at));
    const auto wheel = scene.wheel.body_shape(), rail = scene.rail.body_shape();
    const Roughness roughness(scene.contact.roughness);
    const auto      height =
      [&](const Side side, const BodyShape &shape, const std::size_t i) {
        const std::vector<double> &given = pair_interface.heights[side];
        return given.empty() ? shape.surface_height(at[i][0], at[i][1])
                             : given[i];
      };
    ContactLoads &loads    = problem.loads;
    const auto   *profiles = scene.frame.get();
    loads.gap.clear();
    for (std::size_t i = 0; i < at.size(); ++i)
      loads.gap.push_back((profiles ? gap_of_profiles(scene, at[i])
                                    : -height(Side::wheel, *wheel, i) -
                                        height(Side::rail, *rail, i)) +
                          roughness.value(at[i][0], at[i][1]) -
                          surfaces.standing_height(at[i][0], at[i][1]) -
                          (demands.surfaces_in_time || !surfaces.in_use()
                             ? 0.
                             : surfaces.height(at[i][0], at[i][1], 0.)));
    loads.slip_of_profile = slip_of_profiles(scene, problem.operators);
  }

  template <int dim>
  std::vector<double>
  RollingPair<dim>::friction_at_nodes(const ContactParameters &contact,
                                      const double             travelled) const
  {
    std::vector<double> friction =
      surfaces.friction_shares(trace().nodes, travelled);
    for (double &mu : friction)
      mu *= contact.friction_coefficient;
    return friction;
  }

  template <int dim>
  void RollingPair<dim>::set_loads(const ContactParameters &contact,
                                   ContactProblem          &problem) const
  {
    ContactLoads &loads = problem.loads;
    loads.friction      = friction_at_nodes(contact, 0.);
    loads.friction_law  = contact.falling_friction();
    loads.memory_length = contact.friction_memory_length;
    loads.speed         = std::abs(contact.rolling_speed());
    // what was given and not found before is no place to begin at
    const Creepages found =
      start_of_search(loads.forces, loads.creepages, contact.creepages);
    loads.forces      = contact.forces;
    loads.creepages   = start_of_search(loads.forces, found, contact.creepages);
    loads.normal_load = contact.normal_load;
    loads.approach    = contact.approach.value_or(0.);
    loads.inclined_load.reset();
    if (contact.vertical_load)
      loads.inclined_load = {*contact.vertical_load, scene.frame->angle()};
    else if (contact.normal_load && !problem.operators.frames().is_plane())
      loads.inclined_load = {*contact.normal_load, 0.};
  }

  template <int dim>
  std::vector<double>
  RollingPair<dim>::forces_on_body(const Side          side,
                                   std::vector<double> forces) const
  {
    const std::size_t n_tangential = forces.size() - trace().nodes.size();
    for (std::size_t i = 0; i < forces.size(); ++i)
      if (side == Side::rail || i >= n_tangential)
        forces[i] = -forces[i];
    return pair_interface.coupling[side].to_body(std::move(forces));
  }

  template <int dim>
  BodyField RollingPair<dim>::displacement(const Side            side,
                                           const ContactProblem &problem,
                                           const ContactState   &state) const
  {
    if (!body_pair.body(side))
      return {};
    // moved, as a copy of a field has no values at ghosts
    return std::move(
      displacements(side, {nodal_forces(problem, state)}).front());
  }

  template <int dim>
  std::vector<BodyField> RollingPair<dim>::displacements(
    const Side                              side,
    const std::vector<std::vector<double>> &forces) const
  {
    std::vector<std::vector<double>> on_body;
    for (const std::vector<double> &load : forces)
      on_body.push_back(forces_on_body(side, load));
    return body_pair.body(side)->recover(pair_interface.nodes[side],
                                         components,
                                         on_body);
  }

  template <int dim>
  std::unique_ptr<BodyDynamics>
  RollingPair<dim>::in_time(const Side         side,
                            const ThetaScheme &scheme,
                            const MassKind     mass) const
  {
    if (!body_pair.body(side))
      return nullptr;
    return body_pair.body(side)->in_time(scheme,
                                         mass,
                                         pair_interface.nodes[side],
                                         components);
  }

  template class RollingPair<2>;
  template class RollingPair<3>;
} // namespace RollingContact
