#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/pair/mesh_unit_check.h>
#include <rolling_contact/pair/patch_estimate.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace RollingContact
{
  namespace
  {
    /// in half-widths of the patch; a zone admits less, see
    /// couple_to_interface()
    const double largest_smallest_face = 4.;

    double smallest_face(const FileMesh &mesh, const unsigned int d)
    {
      double smallest = std::numeric_limits<double>::infinity();
      for (const FileMesh::Face &face : mesh.contact_faces)
        {
          double size = 0.;
          for (unsigned int v = 1; v < mesh.n_corners(); ++v)
            size = std::max(size,
                            std::abs(mesh.vertices[face[v]][d] -
                                     mesh.vertices[face[0]][d]));
          smallest = std::min(smallest, size);
        }
      return smallest;
    }

    /**
     * Throw InputError if the contact boundary does not suit the estimated
     * patch along axis @p d, x or y.
     */
    void check(const BodySpec    &body,
               const double       zone,
               const double       half_width,
               const unsigned int d)
    {
      const auto   shape = body.body_shape();
      const double reach = d == 0 ? shape->reach_x() : shape->reach_y(),
                   // a section's are divided as needed
        size = body.is_section() ? 0. : smallest_face(*body.mesh, d),
                   limit =
                     largest_smallest_face * std::max(1., zone) * half_width;
      const auto complain = [&](const std::string &what) {
        throw InputError(body.section + "/Mesh file = " + body.mesh_file +
                         ": along " + (d == 0 ? "x" : "y") +
                         " the estimated patch reaches " +
                         significant(half_width, 3) + " m from the origin, " +
                         what + ": check " + body.section + "/Mesh unit (" +
                         significant(body.mesh_unit, 4) +
                         " m), load, radii and the file's origin.");
      };
      if (reach <= half_width)
        complain("the contact boundary only " + significant(reach, 3) + " m");
      if (size > limit)
        complain("and the smallest face of the contact boundary is " +
                 significant(size, 3) + " m long, more than " +
                 significant(limit, 3) + " m");
    }

    /**
     * estimate_patch(), whose error also names the mesh unit of @p body.
     */
    PatchEstimate estimate(const PairSpec &scene, const BodySpec &body)
    {
      try
        {
          return estimate_patch(scene);
        }
      catch (const InputError &error)
        {
          throw InputError(
            std::string(error.what()) + " Or check " + body.section +
            "/Mesh unit (" + significant(body.mesh_unit, 4) +
            " m): the contact boundary is " +
            significant(2 * body.body_shape()->reach_x(), 3) + " m long.");
        }
    }
  } // namespace

  void check_mesh_units(const PairSpec &scene)
  {
    for (const BodySpec *body : {&scene.wheel, &scene.rail})
      if (body->is_from_file())
        {
          const PatchEstimate patch = estimate(scene, *body);
          const double        zone  = scene.mesh.candidate_zone;
          if (patch.half_width_x > 0.)
            check(*body, zone, patch.half_width_x, 0);
          if (patch.half_width_y > 0.)
            check(*body, zone, patch.half_width_y, 1);
        }
  }
} // namespace RollingContact
