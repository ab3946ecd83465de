#ifndef rolling_contact_bodies_error_indicator_h
#define rolling_contact_bodies_error_indicator_h

#include <rolling_contact/bodies/elastic_body.h>

#include <vector>

namespace RollingContact
{
  /**
   * Boxes that halve the elements of @p body where the jumps of the
   * displacement gradient are largest (Kelly et al. 1983): the fewest cells
   * that make up @p fraction of the sum of squared indicators. Only cells
   * outside the zone of contact nodes and no smaller than those in it, so that
   * the zone stays as it is. Collective over the
   * ranks that hold a part of the body; all get the boxes of all. Units: m.
   */
  template <int dim>
  std::vector<RefinedBox<dim>> bulk_boxes(const ElasticBody<dim> &body,
                                          const BodyField        &displacement,
                                          const Grading<dim>     &grading,
                                          const double            fraction);
} // namespace RollingContact

#endif
