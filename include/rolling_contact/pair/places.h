#ifndef rolling_contact_pair_places_h
#define rolling_contact_pair_places_h

#include <rolling_contact/mesh/grading.h>
#include <rolling_contact/pair/body_pair.h>
#include <rolling_contact/scene/pair_spec.h>

#include <vector>

namespace RollingContact
{
  /**
   * Where bodies touch: a scene, and the grading of its interface.
   */
  template <int dim>
  struct PlaceOfContact
  {
    PairSpec     scene;
    Grading<dim> grading;
  };

  /**
   * A grading for bodies with sections from files that touch at all of these
   * places, one or more, which differ in their profiles' positions, loads and
   * creepages: a strip with the smallest of their elements. It makes the bodies
   * only; each RollingPair on them has the grading of its own place.
   */
  template <int dim>
  Grading<dim>
  grading_of_places(const std::vector<PlaceOfContact<dim>> &places);

  /**
   * The bodies, which may touch at several places. Throws InputError unless
   * those that are elastic have sections from files and live on one rank.
   */
  template <int dim>
  const BodyPair<dim> &for_several_places(const PairSpec      &scene,
                                          const BodyPair<dim> &bodies);
} // namespace RollingContact

#endif
