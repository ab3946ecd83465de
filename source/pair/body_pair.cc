#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/memory.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/pair/body_pair.h>
#include <rolling_contact/pair/interface_mesh.h>
#include <rolling_contact/pair/mesh_file_coupling.h>
#include <rolling_contact/pair/parallel_bodies.h>

#include <cmath>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /**
     * The bodies that the program meshes carry the same surface nodes.
     */
    void
    check_matching_nodes(const Trace &wheel,
                         const Trace &rail,
                         const double tolerance)
    {
      AssertThrow(wheel.nodes.size() == rail.nodes.size(),
                  ExcMessage("The surfaces of wheel and rail carry different "
                             "numbers of nodes."));
      for (std::size_t i = 0; i < rail.nodes.size(); ++i)
        AssertThrow(std::hypot(wheel.nodes[i][0] - rail.nodes[i][0],
                               wheel.nodes[i][1] - rail.nodes[i][1]) <
                      tolerance,
                    ExcMessage("The surface nodes of wheel and rail do not "
                               "match."));
    }



    template <int dim>
    void
    check_room_on_file(const BodyParameters &body, const Grading<dim> &grading)
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
          if (body->is_from_file())
            {
              check_room_on_file(*body, grading);
              continue;
            }
          const auto   shape = body->body_shape();
          const double reach = shape->reach_x();
          if (grading.zone_x > reach)
            throw InputError(
              body->section + ": the contact zone reaches " +
              significant(grading.zone_x, 3) +
              " m from its middle, beyond what the body offers (" +
              significant(reach, 3) +
              " m along x): check load, radii and Block length.");
          if (dim == 3 && grading.zone_y > shape->reach_y())
            throw InputError(
              body->section + "/Width = " + significant(body->width, 4) +
              ": the contact zone is " + significant(2 * grading.zone_y, 3) +
              " m wide; the patch must not reach the edges of "
              "the body.");
        }
    }
  } // namespace



  template <int dim>
  BodyPair<dim>::BodyPair(const SceneParameters &scene,
                          const Grading<dim>    &grading,
                          const PairDemands     &demands,
                          const bool             statics)
    : scene(scene)
    , demands(demands)
    , solver(scene.body_solver)
    , are_twins(
        !scene.wheel.rigid && !scene.rail.rigid &&
        scene.wheel.body_shape()->is_twin_of(*scene.rail.body_shape()) &&
        scene.wheel.material == scene.rail.material)
  {
    check_room(scene, grading);
    part(Side::wheel).elastic = !scene.wheel.rigid;
    part(Side::rail).elastic  = !scene.rail.rigid;
    choose_and_build(grading, statics);
    pair_surfaces(grading);
  }



  template <int dim>
  bool
  BodyPair<dim>::needs_factors() const
  {
    const auto needs = [](const BodyParameters &body) {
      return body.is_from_file() ||
             (!body.rigid &&
              body.material.poisson_ratio > distributed_poisson_limit);
    };
    return demands.factors || needs(scene.wheel) || needs(scene.rail);
  }



  template <int dim>
  void
  BodyPair<dim>::choose_and_build(const Grading<dim> &grading,
                                  const bool          statics)
  {
    const bool open = solver == BodySolver::automatic && !needs_factors();
    if (!open || Ranks::count() > 1)
      {
        if (solver == BodySolver::automatic)
          solver = open ? BodySolver::distributed : BodySolver::direct;
        build(grading, statics);
        return;
      }
    try
      {
        solver = BodySolver::direct;
        build(grading, statics);
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
    for (Part &part : parts)
      part.body.reset();
    total_unknowns = 0;
    release_free_memory();
    solver = BodySolver::distributed;
    build(grading, statics);
  }



  template <int dim>
  double
  BodyPair<dim>::factor_memory(const bool analysed) const
  {
    double bytes = 0.;
    for (const Side side : {Side::wheel, Side::rail})
      if (body(side) && !(side == Side::rail && are_twins))
        bytes += analysed ? body(side)->solver_memory()
                          : direct_memory<dim>(body(side)->n_unknowns());
    return bytes;
  }



  template <int dim>
  void
  BodyPair<dim>::build(const Grading<dim> &grading, const bool statics)
  {
    const bool         direct  = solver == BodySolver::direct;
    const unsigned int n_ranks = Ranks::count(), here = Ranks::rank();
    const unsigned int n_bodies =
      is_elastic(Side::wheel) && is_elastic(Side::rail) && !are_twins ? 2 : 1;
    if (direct && n_ranks > n_bodies)
      throw InputError("Body solver = direct on " + std::to_string(n_ranks) +
                       " ranks: it takes one rank for each body, " +
                       std::to_string(n_bodies) + " here. Start fewer" +
                       (needs_factors()
                          ? "; this scene needs direct bodies."
                          : ", or take Body solver = distributed."));
    part(Side::rail).rank = n_bodies == 2 && n_ranks > 1 ? 1 : 0;
    const auto make       = [&](const Side side, const BodyParameters &body) {
      Part &it = part(side);
      if (!it.elastic || (side == Side::rail && are_twins) ||
          (direct && it.rank != here))
        return;
      it.body = make_body<dim>(solver,
                               body.body_shape(),
                               body.material,
                               body.thickness,
                               grading,
                               demands.displacements,
                               it.rank);
      if (statics)
        it.body->analyse();
    };
    for_both_bodies(
      n_threads(),
      [&]() { make(Side::wheel, scene.wheel); },
      [&]() { make(Side::rail, scene.rail); });
    if (are_twins)
      part(Side::rail).body = part(Side::wheel).body;
    for (const Side side : {Side::wheel, Side::rail})
      if (is_elastic(side) && !(side == Side::rail && are_twins))
        {
          double n = body(side) ? body(side)->n_unknowns() : 0;
          if (direct)
            n = Ranks::sum(n);
          total_unknowns += std::llround(n);
        }
  }



  namespace
  {
    template <int dim>
    std::array<double, 2>
    xy(const Point<dim> &point)
    {
      return {{point[0], dim == 2 ? point[dim - 1] : 0.}};
    }



    template <int dim>
    Trace
    trace_of(const std::vector<typename ElasticBody<dim>::SurfaceNode> &nodes,
             const std::vector<typename ElasticBody<dim>::SurfaceFace> &faces)
    {
      Trace trace;
      trace.n_dimensions = dim - 1;
      for (const auto &node : nodes)
        trace.nodes.push_back(xy(node.position));
      for (const auto &face : faces)
        trace.cells.push_back({xy(face.lower), xy(face.upper), face.corners});
      return trace;
    }
  } // namespace



  template <int dim>
  void
  BodyPair<dim>::pair_surfaces(const Grading<dim> &zone)
  {
    std::vector<Trace> traces;
    for (const Side side : {Side::wheel, Side::rail})
      if (is_elastic(side) && !parameters(side).is_from_file())
        {
          Trace trace;
          if (body(side))
            {
              std::vector<typename ElasticBody<dim>::SurfaceFace> faces;
              body(side)->surface(zone, part(side).nodes, faces);
              trace = trace_of<dim>(part(side).nodes, faces);
            }
          traces.push_back(on_all_ranks(side, std::move(trace)));
        }
    contact_trace = traces.empty() ? interface_mesh(zone) : traces[0];
    if (traces.size() == 2)
      check_matching_nodes(traces[0], traces[1], 1e-9 * zone.zone_x);
    for (const Side side : {Side::wheel, Side::rail})
      if (parameters(side).is_from_file())
        {
          const FileSurface surface =
            couple_to_interface(scene, side == Side::wheel, contact_trace);
          if (traces.empty())
            check_resolution(scene,
                             side == Side::wheel,
                             surface,
                             zone.element_size_x,
                             zone.element_size_y);
          part(side).coupling = surface.coupling;
          part(side).heights  = surface.heights;
          part(side).note     = surface.note;
          if (body(side))
            part(side).nodes = body(side)->nodes_at(surface.vertices);
        }
  }



  template <int dim>
  void
  BodyPair<dim>::release_statics()
  {
    for (const Part &part : parts)
      if (part.body)
        part.body->release_solver();
    release_free_memory();
  }



  template class BodyPair<2>;
  template class BodyPair<3>;
} // namespace RollingContact
