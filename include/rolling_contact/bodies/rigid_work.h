#ifndef rolling_contact_bodies_rigid_work_h
#define rolling_contact_bodies_rigid_work_h

#include <rolling_contact/algebra/dense_matrix.h>
#include <rolling_contact/bodies/direct_body.h>
#include <rolling_contact/bodies/fading_region.h>

namespace RollingContact
{
  /**
   * What smooth loads within the fading region add to the loads @p F of
   * FadedFields so that these do on rigid motions of the body exactly the work
   * of their moments, forces being at the height of the surface: a body that
   * bends turns under the patch by so much that small sums of quadrature
   * errors would count. Unknown by moment.
   */
  DenseMatrix missing_rigid_work(const DirectBody<3> &body,
                                 const BodyShape     &shape,
                                 const FadingRegion  &fading,
                                 const DenseMatrix   &F);
} // namespace RollingContact

#endif
