#ifndef rolling_contact_pair_split_choice_h
#define rolling_contact_pair_split_choice_h

#include <rolling_contact/bodies/split_body.h>
#include <rolling_contact/pair/pair_demands.h>
#include <rolling_contact/scene/pair_spec.h>

#include <string>

namespace RollingContact
{
  /**
   * Whether the compliance of a pair is split, see SplitBody, and why not where
   * `automatic` decided: a part of a sentence.
   */
  struct ComplianceChoice
  {
    bool        split = false;
    std::string reason;
  };

  /**
   * Throws InputError if it is to be split and cannot.
   */
  template <int dim>
  ComplianceChoice choose_compliance(const PairSpec     &scene,
                                     const Grading<dim> &grading,
                                     const PairDemands  &demands);

  /**
   * A body for contact nodes of this grading, whose half-space fades out as far
   * from the contact point as edges and what holds the body allow.
   */
  std::shared_ptr<SplitBody> make_split_body(const BodySpec   &body,
                                             const Grading<3> &grading);
} // namespace RollingContact

#endif
