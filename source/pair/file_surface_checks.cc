#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/contact/overlap.h>
#include <rolling_contact/pair/file_surface_checks.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace RollingContact
{
  namespace
  {
    const double largest_face_of_zone = 0.25; ///< of the zone's length
    const double limit_of_radii = 0.01, limit_of_nodes = 0.5; ///< of the gap
    const double on_profile = 1e-6; // m, a node may be off it

    [[noreturn]] void reject_file(const BodySpec    &body,
                                  const std::string &reason)
    {
      throw InputError(body.section + "/Mesh file = " + body.mesh_file + ": " +
                       reason);
    }

    std::string place(const double x, const double y)
    {
      return "x = " + millimetres(x) + ", y = " + millimetres(y);
    }
  } // namespace

  void check_faces(const BodySpec              &body,
                   const SurfaceMesh           &surface,
                   const std::array<double, 2> &face_size,
                   const Box                   &zone)
  {
    for (unsigned int d = 0; d < surface.n_dimensions; ++d)
      {
        const double length = zone[1][d] - zone[0][d];
        if (face_size[d] > largest_face_of_zone * length)
          reject_file(body,
                      "in the contact zone, " + millimetres(length) +
                        (d == 0 ? " long" : " wide") +
                        ", a face of its contact boundary is " +
                        millimetres(face_size[d]) +
                        (d == 0 ? " long" : " wide") +
                        ". Refine it there to a quarter of the zone at most, "
                        "better to Mesh/Elements across patch, or check " +
                        body.section + "/Mesh unit (" +
                        significant(body.mesh_unit, 4) + " m).");
      }
    if (surface.n_dimensions == 1)
      return;
    for (const auto &face : surface.faces)
      {
        std::array<Point2, 4> corners;
        for (unsigned int v = 0; v < 4; ++v)
          corners[v] = surface.nodes[face[v]];
        if (!is_convex(corners))
          reject_file(body,
                      "the face of its contact boundary at " +
                        place(corners[0][0], corners[0][1]) +
                        " is no convex quadrilateral seen along z.");
      }
  }

  void check_cover(const BodySpec         &body,
                   const Trace            &interface,
                   const MortarProjection &projection)
  {
    for (std::size_t c = 0; c < interface.cells.size(); ++c)
      {
        const Trace::Cell &cell   = interface.cells[c];
        const double       excess = projection.covered[c] - 1;
        if (std::abs(excess) > 1e-6)
          reject_file(body,
                      std::string("its contact boundary ") +
                        (excess < 0. ? "ends" : "lies twice") +
                        " inside the contact zone, near " +
                        place((cell.lower[0] + cell.upper[0]) / 2,
                              (cell.lower[1] + cell.upper[1]) / 2) +
                        ". Extend the boundary " + body.section +
                        "/Contact boundary id = " +
                        std::to_string(body.contact_boundary) +
                        ", or check Mesh unit, load and "
                        "Mesh/Candidate zone.");
      }
  }

  void check_free_of_hub(const BodySpec                  &body,
                         const FileMesh                  &mesh,
                         const std::vector<unsigned int> &vertices)
  {
    std::set<unsigned int> clamped;
    for (const FileMesh::Face &face : mesh.hub_faces)
      clamped.insert(face.begin(), face.begin() + mesh.n_corners());
    for (const unsigned int vertex : vertices)
      if (clamped.count(vertex) > 0)
        reject_file(
          body,
          "its hub (" + body.section +
            "/Hub boundary id = " + std::to_string(body.hub_boundary) +
            ") reaches into the contact zone, at " +
            place(mesh.vertices[vertex][0], mesh.vertices[vertex][1]) + ".");
  }

  double largest_gap(const PairSpec &scene, const Trace &interface)
  {
    const auto wheel = scene.wheel.body_shape(), rail = scene.rail.body_shape();
    double     largest = 0.;
    for (const auto &node : interface.nodes)
      largest = std::max(largest,
                         -wheel->surface_height(node[0], node[1]) -
                           rail->surface_height(node[0], node[1]));
    return largest;
  }

  double check_heights(const BodySpec                  &body,
                       const FileMesh                  &mesh,
                       const std::vector<unsigned int> &vertices,
                       const double                     gap)
  {
    const auto   shape   = body.body_shape();
    double       largest = 0.;
    unsigned int worst   = 0;
    for (const unsigned int vertex : vertices)
      {
        const auto  &at = mesh.vertices[vertex];
        const double distance =
          std::abs(at[2] - shape->surface_height(at[0], at[1]));
        if (distance >= largest)
          worst = vertex;
        largest = std::max(largest, distance);
      }
    const bool   by_radii = body.surface == SurfaceSource::radii;
    const double limit    = (by_radii ? limit_of_radii : limit_of_nodes) * gap;
    if (largest > limit)
      {
        const auto &at = mesh.vertices[worst];
        reject_file(
          body,
          "the node of its contact boundary at " + place(at[0], at[1]) +
            " lies " + millimetres(largest) + " off the surface of " +
            body.section + "/Radius = " + significant(body.radius, 6) + " m" +
            (mesh.dimension == 3 ? " and Lateral radius = " +
                                     significant(body.lateral_radius, 6) + " m"
                                 : std::string()) +
            "; " + millimetres(limit) + " is allowed, " +
            (by_radii ? "1 %" : "half") +
            " of the largest gap in the contact zone. Check the radii, Mesh "
            "unit (" +
            significant(body.mesh_unit, 4) +
            " m), the contact point (the origin) and the axes (z from rail "
            "to wheel)" +
            (by_radii ? ", or take " + body.section + "/Surface = nodes."
                      : "."));
      }
    return largest;
  }

  double check_on_profile(const PairSpec                  &scene,
                          const Side                       side,
                          const FileMesh                  &mesh,
                          const std::vector<unsigned int> &vertices,
                          const SectionInContact          &section)
  {
    double       largest = 0.;
    unsigned int worst   = 0;
    for (const unsigned int vertex : vertices)
      {
        const double distance = section.off_profile(mesh.vertices[vertex]);
        if (distance >= largest)
          worst = vertex;
        largest = std::max(largest, distance);
      }
    if (largest <= on_profile)
      return largest;
    const BodySpec &body     = scene.body(side);
    const auto      at       = section.in_file(mesh.vertices[worst]);
    const bool      is_wheel = side == Side::wheel;
    reject_file(body,
                "its contact boundary lies " + millimetres(largest) +
                  " off the profile at y = " + millimetres(at[0]) +
                  ", z = " + millimetres(is_wheel ? -at[1] : at[1]) +
                  " of the file, in the contact zone; nodes of the file "
                  "within " +
                  millimetres(ProfiledSection::largest_offset) +
                  " are put on it. Draw the section by Profiles/" +
                  body.section + " profile = " +
                  (is_wheel ? scene.profiles.wheel_profile
                            : scene.profiles.rail_profile) +
                  ", with nodes on it, or check Mesh unit (" +
                  significant(body.mesh_unit, 4) +
                  " m) and the axes: y from the gauge side to the field "
                  "side, z from rail to wheel, the origin " +
                  (is_wheel ? "at the tape circle."
                            : "at the middle of the top of the head of a rail "
                              "that is not inclined."));
  }
} // namespace RollingContact
