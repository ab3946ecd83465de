#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/mesh/file_body_mesh.h>
#include <rolling_contact/pair/interface_mesh.h>
#include <rolling_contact/pair/mesh_limits.h>
#include <rolling_contact/pair/pair_interface.h>
#include <rolling_contact/pair/profile_surface.h>
#include <rolling_contact/pair/refined_coupling.h>
#include <rolling_contact/pair/section_in_contact.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /**
     * Whether the surfaces of two generated bodies have the same nodes to
     * within @p tolerance. Units: m.
     */
    bool
    nodes_match(const Trace &wheel, const Trace &rail, const double tolerance)
    {
      return std::equal(wheel.nodes.begin(),
                        wheel.nodes.end(),
                        rail.nodes.begin(),
                        rail.nodes.end(),
                        [&](const auto &one, const auto &other) {
                          return std::hypot(one[0] - other[0],
                                            one[1] - other[1]) < tolerance;
                        });
    }

    /**
     * Whether the nodes of two surfaces are at the same places along x or, @p
     * d = 1, across.
     */
    bool same_places(const Trace       &wheel,
                     const Trace       &rail,
                     const unsigned int d,
                     const double       tolerance)
    {
      const auto places = [&](const Trace &trace) {
        std::vector<long long> found;
        for (const auto &node : trace.nodes)
          found.push_back(std::llround(node[d] / tolerance));
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
      };
      return places(wheel) == places(rail);
    }

    /**
     * The blocks or, in 3D, the sides that end less than an element away from
     * the zone where nodes do not match, and what this zone takes.
     */
    template <int dim>
    std::string where_bodies_end(const PairSpec     &scene,
                                 const Grading<dim> &grading,
                                 const Trace        &wheel,
                                 const Trace        &rail)
    {
      const auto [length, width] = room_for_zone(grading);
      const auto alike           = [&](const unsigned int d) {
        return same_places(wheel, rail, d, 1e-3 * grading.element_size_x);
      };
      std::string text;
      for (const BodySpec *body : {&scene.wheel, &scene.rail})
        if (body->shape == "block" && body->block_length < length && !alike(0))
          text += " " + body->section +
                  "/Block length = " + significant(body->block_length, 6) +
                  " m: this zone takes " + at_least(length) + ".";
      if (dim == 3 && std::min(scene.wheel.width, scene.rail.width) < width &&
          !alike(1))
        text += " Wheel/Width = " + significant(scene.wheel.width, 6) +
                " m and Rail/Width = " + significant(scene.rail.width, 6) +
                " m: this zone takes " + at_least(width) +
                " of both, or equal widths.";
      return text;
    }

    /**
     * Throws InputError unless they do: the cells of bodies are not alike near
     * the end of a running surface, and near the sides and ends of bodies that
     * are nearly as wide or long as each other.
     */
    template <int dim>
    void check_matching_nodes(const PairSpec     &scene,
                              const Grading<dim> &grading,
                              const Trace        &wheel,
                              const Trace        &rail)
    {
      if (nodes_match(wheel, rail, 1e-9 * grading.zone_x))
        return;
      if (scene.profiles.has_true_sections())
        throw InputError(
          "Profiles/Body sections = true: the contact zone reaches the end of "
          "a running surface, where the elements of wheel and rail differ: "
          "check load and shift, or take Body sections = plain.");
      throw InputError(
        "The contact zone reaches the ends of bodies, where the elements of "
        "wheel and rail differ." +
        where_bodies_end(scene, grading, wheel, rail) +
        " Take that, other Mesh/Elements across patch, or check radii and load.");
    }

    /**
     * Couple a body from a file; the mesh of a section is made again on ranks
     * that do not hold the body.
     */
    template <int dim>
    FileSurface surface_of_file(const PairSpec         &scene,
                                const Side              side,
                                const ElasticBody<dim> *body,
                                const Grading<dim>     &grading,
                                const Trace            &interface)
    {
      const BodySpec &parameters = scene.body(side);
      if constexpr (dim == 3)
        if (parameters.is_section())
          {
            BodyMesh<3> made;
            if (body == nullptr)
              made = make_body_mesh<3>(parameters.body_shape(), grading);
            const BodyMesh<3> &mesh  = body ? body->mesh() : made;
            const double       angle = SectionInContact::is_on(scene, side)
                                         ? SectionInContact(scene, side).axes().angle
                                         : 0.;
            const Point<3> towards_other(0., std::sin(angle), std::cos(angle));
            return couple_refined_to_interface(
              scene,
              side,
              as_file_mesh(mesh, towards_other),
              hanging_vertices(*mesh.triangulation),
              interface);
          }
      return couple_to_interface(scene, side, *parameters.mesh, interface);
    }

    template <int dim>
    std::array<double, 2> xy(const Point<dim> &point)
    {
      return {{point[0], dim == 2 ? point[dim - 1] : 0.}};
    }
  } // namespace

  template <int dim>
  PairInterface<dim>::PairInterface(const PairSpec      &scene,
                                    const Grading<dim>  &grading,
                                    const BodyPair<dim> &bodies)
  {
    if (bodies.is_split())
      {
        take_nodes_of_interface(grading, bodies);
        return;
      }
    const auto is_generated = [&](const Side side) {
      return bodies.is_elastic(side) && !scene.body(side).is_from_file();
    };
    for (const Side side : both_sides)
      if (is_generated(side))
        {
          const Trace surface = surface_of(side, grading, bodies);
          if (trace.nodes.empty())
            trace = surface;
          else
            check_matching_nodes(scene, grading, trace, surface);
        }
    const bool has_own_mesh =
      !is_generated(Side::wheel) && !is_generated(Side::rail);
    if (has_own_mesh)
      trace = interface_mesh(grading);
    for (const Side side : both_sides)
      if (scene.body(side).is_from_file())
        {
          const FileSurface surface =
            surface_of_file(scene, side, bodies.body(side), grading, trace);
          if (has_own_mesh)
            check_resolution(scene,
                             side,
                             surface,
                             grading.element_size_x,
                             grading.element_size_y);
          coupling[side] = surface.coupling;
          heights[side]  = surface.heights;
          axes[side]     = surface.axes;
          note[side]     = surface.note;
          if (bodies.body(side))
            nodes[side] = bodies.body(side)->nodes_at(surface.vertices);
        }
    turn_nodes(scene, bodies);
  }

  template <int dim>
  void PairInterface<dim>::take_nodes_of_interface(const Grading<dim>  &grading,
                                                   const BodyPair<dim> &bodies)
  {
    trace = interface_mesh(grading);
    for (const Side side : both_sides)
      if (bodies.is_elastic(side))
        for (const auto &at : trace.nodes)
          {
            nodes[side].emplace_back();
            for (unsigned int d = 0; d < dim - 1; ++d)
              nodes[side].back().position[d] = at[d];
          }
  }

  template <int dim>
  void PairInterface<dim>::turn_nodes(const PairSpec      &scene,
                                      const BodyPair<dim> &bodies)
  {
    const SurfaceFrames frames = surface_frames(scene, trace.nodes);
    for (const Side side : both_sides)
      {
        const bool curved = !frames.is_plane() && bodies.is_elastic(side) &&
                            scene.body(side).body_shape()->is_swept();
        if (!curved && axes[side].angle == 0.)
          continue;
        std::vector<double> angles(trace.nodes.size(), axes[side].angle);
        // z of the wheel is that of the rail mirrored
        if (curved)
          for (std::size_t i = 0; i < angles.size(); ++i)
            angles[i] += (side == Side::rail ? 1 : -1) * frames.nodes[i].angle;
        coupling[side].turn(std::move(angles));
        nodes_turned = true;
      }
  }

  template <int dim>
  Trace PairInterface<dim>::surface_of(const Side           side,
                                       const Grading<dim>  &grading,
                                       const BodyPair<dim> &bodies)
  {
    Trace surface;
    if (bodies.body(side))
      {
        std::vector<typename ElasticBody<dim>::SurfaceFace> faces;
        bodies.body(side)->surface(grading, nodes[side], faces);
        surface.n_dimensions = dim - 1;
        for (const auto &node : nodes[side])
          surface.nodes.push_back(xy(node.position));
        for (const auto &face : faces)
          surface.cells.push_back(
            {xy(face.lower), xy(face.upper), face.corners});
      }
    return bodies.on_all_ranks(side, std::move(surface));
  }

  template struct PairInterface<2>;
  template struct PairInterface<3>;
} // namespace RollingContact
