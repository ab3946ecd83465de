#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/memory.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/bodies/distributed_body.h>
#include <rolling_contact/mesh/mesh_memory.h>
#include <rolling_contact/pair/body_pair.h>
#include <rolling_contact/pair/mesh_limits.h>
#include <rolling_contact/pair/parallel_bodies.h>

#include <cmath>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    void check_room_on_file(const BodySpec &body, const Grading<dim> &grading)
    {
      const auto shape = body.body_shape();
      const auto check =
        [&](const std::string &axis, const double zone, const double reach) {
          if (zone > reach)
            throw InputError(
              body.section + "/Mesh file = " + body.mesh_file +
              ": the contact zone reaches " + significant(zone, 3) +
              " m from the origin along " + axis + ", the contact boundary " +
              significant(reach, 3) + " m: check load, radii, Mesh unit (" +
              significant(body.mesh_unit, 4) + " m) and the file's origin.");
        };
      check("x", grading.zone_x, shape->reach_x());
      if (dim == 3)
        check("y", grading.zone_y, shape->reach_y());
    }

    /**
     * Throws InputError if a body does not reach as far across as the candidate
     * zone.
     */
    template <int dim>
    void check_room_across(const BodySpec     &body,
                           const BodyShape    &shape,
                           const Grading<dim> &grading)
    {
      const auto zone = grading.zone_across(), room = shape.room_across();
      if (dim == 2 || (zone[0] >= room[0] && zone[1] <= room[1]))
        return;
      if (!shape.is_swept())
        throw InputError(
          body.section + "/Width = " + significant(body.width, 4) +
          " m: the contact zone is " + significant(2 * grading.zone_y, 3) +
          " m wide, and the patch must not reach the edges of the body. Take " +
          at_least(2 * grading.zone_y) +
          ", a smaller load or smaller radii across.");
      throw InputError(
        "Profiles/Body sections = true: the contact zone reaches from " +
        significant(zone[0], 3) + " to " + significant(zone[1], 3) +
        " m across from the first contact, the " + body.section +
        "'s surface faces the other body from " + significant(room[0], 3) +
        " to " + significant(room[1], 3) +
        " m only: check load and shift, or take Body sections = plain.");
    }

    /**
     * Throws InputError if the candidate zone does not fit on a body.
     */
    template <int dim>
    void check_room(const PairSpec &scene, const Grading<dim> &grading)
    {
      for (const BodySpec *body : {&scene.wheel, &scene.rail})
        {
          if (body->rigid)
            continue;
          if (body->is_from_file())
            {
              check_room_on_file(*body, grading);
              continue;
            }
          const auto   shape = body->body_shape();
          const double reach = shape->reach_x();
          if (grading.zone_x > reach && body->shape == "block")
            throw InputError(
              body->section +
              "/Block length = " + significant(body->block_length, 4) +
              " m: the contact zone is " + significant(2 * grading.zone_x, 3) +
              " m long, beyond what the body offers. Take " +
              at_least(room_for_zone(grading)[0]) +
              ", a smaller load or smaller radii.");
          if (grading.zone_x > reach)
            throw InputError(
              body->section + ": the contact zone reaches " +
              significant(grading.zone_x, 3) +
              " m from its middle, beyond what the body offers (" +
              significant(reach, 3) + " m along x): check load and radii.");
          check_room_across(*body, *shape, grading);
        }
    }
  } // namespace

  template <int dim>
  BodyPair<dim>::BodyPair(const PairSpec     &scene,
                          const Grading<dim> &grading,
                          const PairDemands  &demands,
                          const bool          statics)
    : compliance(choose_compliance(scene, grading, demands))
    , solver(scene.body_solver)
    , body_threads(scene.body_threads)
    , are_twins(
        !scene.wheel.rigid && !scene.rail.rigid &&
        scene.wheel.body_shape()->is_twin_of(*scene.rail.body_shape()) &&
        scene.wheel.materials() == scene.rail.materials() &&
        scene.wheel.model == scene.rail.model)
    , elastic{!scene.wheel.rigid, !scene.rail.rigid}
  {
    check_room(scene, grading);
    if (!is_split())
      check_element_size(scene, grading);
    check_contact_memory(scene, grading, is_split());
    choose_and_build(scene, grading, demands, statics);
  }

  namespace
  {
    /**
     * True if no other way than a factorisation will do.
     */
    bool needs_factors(const PairSpec &scene, const PairDemands &demands)
    {
      const auto needs = [](const BodySpec &body) {
        return body.is_from_file() ||
               (!body.rigid &&
                (body.material.poisson_ratio > distributed_poisson_limit ||
                 body.has_cover() || body.hub == Hub::elastic ||
                 body.hub == Hub::mass || body.model.damping.has_sponge()));
      };
      return demands.factors || demands.modes || needs(scene.wheel) ||
             needs(scene.rail);
    }

    /**
     * What speaks against spreading bodies of so many unknowns over the ranks,
     * whose factors would need @p bytes; empty if nothing does.
     */
    std::string reason_of_ranks(const std::size_t n_unknowns,
                                const double      bytes)
    {
      const std::size_t as_fast =
        600000; // measured: doc/measurements/distributed.md
      if (n_unknowns > as_fast || bytes > 0.7 * available_memory())
        return "";
      return std::to_string(Ranks::count()) +
             " ranks were started. One has room for the factors, about " +
             human_bytes(bytes) + ", and without mpirun takes less time for " +
             std::to_string(n_unknowns) + " unknowns";
    }
  } // namespace

  namespace
  {
    const std::string remedy_of_memory =
      "take fewer Mesh/Elements across patch or a larger Mesh/Growth; in 3D 16 "
      "and 0.4 are usual.";

    /**
     * Throws MemoryError if the factors of both bodies, of which each may fit
     * alone, need more than 70 % of the free memory.
     */
    void check_factors(const double bytes)
    {
      const double free = available_memory();
      if (free > 0. && bytes > 0.7 * free)
        throw MemoryError("The factors of wheel and rail need " +
                          human_bytes(bytes) +
                          " together, more than 70 % of the " +
                          human_bytes(free) + " free: " + remedy_of_memory);
    }

    /**
     * Throws MemoryError if the meshes of both bodies, of which each may fit
     * alone, are too large together.
     */
    template <int dim>
    void check_meshes(const PairSpec     &scene,
                      const Grading<dim> &grading,
                      const bool          are_twins,
                      const MeshKind      kind)
    {
      const double both = cells_to_mesh(scene, grading).total;
      check_mesh_memory<dim>(are_twins ? both / 2 : both,
                             kind,
                             remedy_of_memory,
                             are_twins ? "The mesh of wheel and rail"
                                       : "The meshes of wheel and rail");
    }
  } // namespace

  template <int dim>
  void BodyPair<dim>::choose_and_build(const PairSpec     &scene,
                                       const Grading<dim> &grading,
                                       const PairDemands  &demands,
                                       const bool          statics)
  {
    const bool open = !is_split() && solver == BodySolver::automatic &&
                      !needs_factors(scene, demands);
    if (!open || Ranks::count() > 1)
      {
        if (solver == BodySolver::automatic)
          solver = open ? BodySolver::distributed : BodySolver::direct;
        const bool on_one_rank =
          solver == BodySolver::direct && Ranks::count() == 1 && !is_split();
        if (on_one_rank)
          check_meshes(scene, grading, are_twins, MeshKind::serial);
        build(scene, grading, demands, statics);
        if (on_one_rank)
          check_factors(factor_memory(true)); // 0 of bodies not analysed
        if (open)
          reason = reason_of_ranks(total_unknowns, factor_memory(false));
        return;
      }
    try
      {
        solver = BodySolver::direct;
        check_meshes(scene, grading, are_twins, MeshKind::serial);
        build(scene, grading, demands, statics);
        const double needed = factor_memory(statics),
                     free   = 0.7 * available_memory();
        reason = "bodies whose factors need " + human_bytes(needed) +
                 ", 70 % of the free memory is " + human_bytes(free);
        if (free <= 0. || needed < free)
          return;
      }
    catch (const MemoryError &error)
      {
        reason = error.what();
      }
    bodies         = {};
    total_unknowns = 0;
    release_free_memory();
    solver = BodySolver::distributed;
    check_meshes(scene, grading, are_twins, MeshKind::distributed);
    build(scene, grading, demands, statics);
  }

  namespace
  {
    /**
     * Estimated memory in bytes for factor and condensation of a direct body
     * that was not analysed, fitted to runs of bodies in 2D and 3D.
     */
    double direct_memory(const int dim, const double n)
    {
      return dim == 2 ? 100 * n * std::log2(n + 2) : 200 * std::pow(n, 4. / 3);
    }
  } // namespace

  template <int dim>
  double BodyPair<dim>::factor_memory(const bool analysed) const
  {
    double bytes = 0.;
    for (const Side side : both_sides)
      if (body(side) && has_own_body(side))
        bytes += analysed ? body(side)->solver_memory()
                          : direct_memory(dim, body(side)->n_unknowns());
    return bytes;
  }

  template <int dim>
  void BodyPair<dim>::build(const PairSpec     &scene,
                            const Grading<dim> &grading,
                            const PairDemands  &demands,
                            const bool          statics)
  {
    const bool         direct  = solver == BodySolver::direct;
    const unsigned int n_ranks = Ranks::count();
    const unsigned int n_bodies =
      is_elastic(Side::wheel) && has_own_body(Side::rail) ? 2 : 1;
    if (direct && n_ranks > n_bodies)
      throw InputError("Body solver = direct on " + std::to_string(n_ranks) +
                       " ranks: it takes one rank for each body, " +
                       std::to_string(n_bodies) + " here. Start fewer" +
                       (needs_factors(scene, demands)
                          ? "; this scene needs direct bodies."
                          : ", or take Body solver = distributed."));
    ranks.rail              = n_bodies == 2 && n_ranks > 1 ? 1 : 0;
    const auto split_bodies = demands.split_bodies
                                ? demands.split_bodies
                                : std::make_shared<SplitBodies>();
    const auto make         = [&](const Side side) {
      if (!has_own_body(side) || (direct && ranks[side] != Ranks::rank()))
        return;
      const BodySpec &parameters = scene.body(side);
      if constexpr (dim == 3)
        if (is_split())
          bodies[side] = split_bodies->body_of(parameters,
                                               grading,
                                               demands.modes,
                                               scene.mesh.compliance ==
                                                 Compliance::half_spaces);
      if (!bodies[side] && direct)
        bodies[side] =
          std::make_shared<DirectBody<dim>>(parameters.body_shape(),
                                            parameters.materials(),
                                            parameters.thickness,
                                            grading,
                                            demands.whole_bodies() ||
                                              demands.bulk_errors,
                                            parameters.model);
      if (!bodies[side])
        bodies[side] =
          std::make_shared<DistributedBody<dim>>(parameters.body_shape(),
                                                 parameters.materials(),
                                                 parameters.thickness,
                                                 grading,
                                                 ranks[side],
                                                 parameters.model);
      if (statics)
        bodies[side]->analyse();
    };
    for_both_bodies(
      n_threads(), [&]() { make(Side::wheel); }, [&]() { make(Side::rail); });
    if (are_twins)
      bodies.rail = bodies.wheel;
    for (const Side side : both_sides)
      if (has_own_body(side))
        total_unknowns +=
          on_all_ranks(side, body(side) ? body(side)->n_unknowns() : 0);
  }

  template <int dim>
  void BodyPair<dim>::release_statics()
  {
    for (const Side side : both_sides)
      if (body(side))
        body(side)->release_solver();
    release_free_memory();
  }

  template class BodyPair<2>;
  template class BodyPair<3>;
} // namespace RollingContact
