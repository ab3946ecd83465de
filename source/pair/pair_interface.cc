#include <deal.II/base/exceptions.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/mesh/file_body_mesh.h>
#include <rolling_contact/pair/interface_mesh.h>
#include <rolling_contact/pair/pair_interface.h>
#include <rolling_contact/pair/profile_surface.h>

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
     * Throws unless they do: InputError for true sections, whose cells are not
     * alike at the ends of their running surfaces.
     */
    void
    check_matching_nodes(const SceneParameters &scene,
                         const Trace           &wheel,
                         const Trace           &rail,
                         const double           tolerance)
    {
      if (nodes_match(wheel, rail, tolerance))
        return;
      if (scene.profiles.has_true_sections())
        throw InputError(
          "Profiles/Body sections = true: the contact zone reaches where the "
          "elements of wheel and rail are not alike, at the end of a running "
          "surface: check load and shift, or take Body sections = plain.");
      AssertThrow(false,
                  ExcMessage("The surface nodes of wheel and rail do not "
                             "match."));
    }



    /**
     * The mesh of a body from a file; that of a section is made again on ranks
     * that do not hold the body.
     */
    template <int dim>
    std::shared_ptr<const FileMesh>
    mesh_of(const BodyParameters   &parameters,
            const ElasticBody<dim> *body,
            const Grading<dim>     &grading)
    {
      if constexpr (dim == 3)
        if (parameters.is_section())
          return std::make_shared<const FileMesh>(
            body ? as_file_mesh(body->mesh())
                 : as_file_mesh(
                     make_body_mesh<3>(parameters.body_shape(), grading)));
      return parameters.mesh;
    }



    template <int dim>
    std::array<double, 2>
    xy(const Point<dim> &point)
    {
      return {{point[0], dim == 2 ? point[dim - 1] : 0.}};
    }
  } // namespace



  template <int dim>
  PairInterface<dim>::PairInterface(const SceneParameters &scene,
                                    const Grading<dim>    &grading,
                                    const BodyPair<dim>   &bodies)
  {
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
            check_matching_nodes(scene, trace, surface, 1e-9 * grading.zone_x);
        }
    const bool has_own_mesh =
      !is_generated(Side::wheel) && !is_generated(Side::rail);
    if (has_own_mesh)
      trace = interface_mesh(grading);
    for (const Side side : both_sides)
      if (scene.body(side).is_from_file())
        {
          const FileSurface surface = couple_to_interface(
            scene,
            side,
            *mesh_of(scene.body(side), bodies.body(side), grading),
            trace);
          if (has_own_mesh)
            check_resolution(scene,
                             side,
                             surface,
                             grading.element_size_x,
                             grading.element_size_y);
          coupling[side] = surface.coupling;
          heights[side]  = surface.heights;
          note[side]     = surface.note;
          if (bodies.body(side))
            nodes[side] = bodies.body(side)->nodes_at(surface.vertices);
        }
    turn_nodes(scene, bodies);
  }



  template <int dim>
  void
  PairInterface<dim>::turn_nodes(const SceneParameters &scene,
                                 const BodyPair<dim>   &bodies)
  {
    const SurfaceFrames frames = surface_frames(scene, trace.nodes);
    for (const Side side : both_sides)
      if (!frames.is_plane() && bodies.is_elastic(side) &&
          scene.body(side).body_shape()->is_swept())
        {
          // z of the wheel is that of the rail mirrored
          std::vector<double> angles;
          for (const SurfaceFrames::Node &node : frames.nodes)
            angles.push_back(side == Side::rail ? node.angle : -node.angle);
          coupling[side].turn(std::move(angles));
          nodes_turned = true;
        }
  }



  template <int dim>
  Trace
  PairInterface<dim>::surface_of(const Side           side,
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
