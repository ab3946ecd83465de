#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/pair/places.h>

#include <algorithm>
#include <stdexcept>

namespace RollingContact
{
  template <int dim>
  Grading<dim> grading_of_places(const std::vector<PlaceOfContact<dim>> &places)
  {
    if (places.empty())
      throw std::invalid_argument("A grading of no place.");
    Grading<dim> result = places.front().grading;
    for (const auto &[scene, grading] : places)
      {
        result.element_size_x =
          std::min(result.element_size_x, grading.element_size_x);
        result.element_size_y =
          std::min(result.element_size_y, grading.element_size_y);
        result.zone_x     = std::max(result.zone_x, grading.zone_x);
        result.zone_y     = std::max(result.zone_y, grading.zone_y);
        result.zone_depth = std::max(result.zone_depth, grading.zone_depth);
        result.growth     = std::min(result.growth, grading.growth);
        const std::vector<ZoneBox> boxes = grading.of_coupled_body().zone_boxes;
        for (const Side side : both_sides)
          if (scene.body(side).is_section())
            for (const ZoneBox &box :
                 scene.body(side).body_shape()->on_surface(boxes))
              result.strips[side].push_back(box);
      }
    return result;
  }

  template <int dim>
  const BodyPair<dim> &for_several_places(const PairSpec      &scene,
                                          const BodyPair<dim> &bodies)
  {
    for (const Side side : both_sides)
      if (bodies.is_elastic(side) && !scene.body(side).is_section())
        throw InputError(scene.body(side).section +
                         "/Shape = " + scene.body(side).shape +
                         ": only bodies with a section from a file keep their "
                         "mesh at several places of the contact; take "
                         "section.");
    if (Ranks::count() > 1)
      throw InputError("Bodies that keep their mesh at several places of the "
                       "contact live on one rank; start one.");
    return bodies;
  }

  template const BodyPair<2> &for_several_places(const PairSpec &,
                                                 const BodyPair<2> &);
  template const BodyPair<3> &for_several_places(const PairSpec &,
                                                 const BodyPair<3> &);
  template Grading<2> grading_of_places(const std::vector<PlaceOfContact<2>> &);
  template Grading<3> grading_of_places(const std::vector<PlaceOfContact<3>> &);
} // namespace RollingContact
