#ifndef rolling_contact_pair_file_surface_checks_h
#define rolling_contact_pair_file_surface_checks_h

#include <rolling_contact/contact/mortar.h>
#include <rolling_contact/pair/section_in_contact.h>
#include <rolling_contact/scene/body_parameters.h>
#include <rolling_contact/scene/pair_spec.h>

#include <array>
#include <vector>

namespace RollingContact
{
  /** Lower and upper corner in the plane of contact. Units: m. */
  using Box = std::array<std::array<double, 2>, 2>;

  /**
   * Throws InputError if faces of a file's contact boundary, the largest of
   * which has this size in x and y, are too large for the zone, or folded.
   */
  void check_faces(const BodySpec              &body,
                   const SurfaceMesh           &surface,
                   const std::array<double, 2> &face_size,
                   const Box                   &zone);

  /**
   * Throws InputError unless the contact boundary covers the interface once.
   */
  void check_cover(const BodySpec         &body,
                   const Trace            &interface,
                   const MortarProjection &projection);

  /**
   * Throws InputError if one of the contact nodes is on the hub.
   */
  void check_free_of_hub(const BodySpec                  &body,
                         const FileMesh                  &mesh,
                         const std::vector<unsigned int> &vertices);

  /**
   * Largest gap between the surfaces that the radii give, at the nodes of the
   * interface. Units: m.
   */
  double largest_gap(const PairSpec &scene, const Trace &interface);

  /**
   * Largest distance of the contact nodes from the surface given by the
   * radii. Throws InputError if it is more than allowed for this largest @p
   * gap. Units: m.
   */
  double check_heights(const BodySpec                  &body,
                       const FileMesh                  &mesh,
                       const std::vector<unsigned int> &vertices,
                       const double                     gap);

  /**
   * Largest distance of the contact nodes, given in the axes of the body, from
   * the profile. Throws InputError if they are not on it. Units: m.
   */
  double check_on_profile(const PairSpec                  &scene,
                          const Side                       side,
                          const FileMesh                  &mesh,
                          const std::vector<unsigned int> &vertices,
                          const SectionInContact          &section);
} // namespace RollingContact

#endif
