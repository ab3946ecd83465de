#ifndef rolling_contact_pair_split_choice_h
#define rolling_contact_pair_split_choice_h

#include <rolling_contact/bodies/split_body.h>
#include <rolling_contact/pair/pair_demands.h>
#include <rolling_contact/scene/pair_spec.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

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
   * Split bodies that were made, which serve again wherever the same bodies
   * touch: their half-spaces fade out as far from the contact point as edges
   * and what holds the body allow, whatever the patch. For several threads.
   */
  class SplitBodies
  {
  public:
    std::shared_ptr<SplitBody> body_of(const BodySpec   &body,
                                       const Grading<3> &grading,
                                       const bool        vibrates,
                                       const bool        is_half_space);

  private:
    std::mutex                              alone;
    std::vector<std::shared_ptr<SplitBody>> bodies;
  };
} // namespace RollingContact

#endif
