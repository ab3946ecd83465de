#include <rolling_contact/pair/places.h>
#include <rolling_contact/scene/entries.h>
#include <rolling_contact/scene/known_entries.h>
#include <rolling_contact/tables/bodies_of_places.h>

namespace RollingContact
{
  template <int dim>
  std::string BodiesOfPlaces<dim>::structure_of(const LoadBand &band) const
  {
    const std::vector<double> &values = plan.values[band.largest];
    std::string                text;
    for (std::size_t d = 0; d < plan.entries.size(); ++d)
      if (renewed_by(plan.entries[d]) == Renews::bodies)
        text += plan.entries[d] + " = " + exact_text(values[d]) + ", ";
    return text;
  }

  template <int dim>
  std::vector<const LoadBand *>
  BodiesOfPlaces<dim>::sharing(const std::string &wanted) const
  {
    std::vector<const LoadBand *> found;
    for (const LoadBand &band : bands)
      if (band.touches() && structure_of(band) == wanted)
        found.push_back(&band);
    return found;
  }

  template <int dim>
  bool BodiesOfPlaces<dim>::may_share() const
  {
    bool sections = scene.profiles.in_use();
    for (const Side side : both_sides)
      sections =
        sections && (scene.body(side).rigid || scene.body(side).is_section());
    return sections;
  }

  template <int dim>
  PairMaker<dim> BodiesOfPlaces<dim>::pair_maker(const LoadBand     &band,
                                                 const StateDemands &demands,
                                                 RunContext         &context)
  {
    const std::string wanted = structure_of(band);
    const auto        here   = sharing(wanted);
    if (!may_share() || here.size() < 2)
      {
        kept.reset();
        return {};
      }
    if (!kept || structure != wanted)
      {
        kept.reset();
        structure = wanted;
        SceneEntries                     entries(scene);
        std::vector<PlaceOfContact<dim>> places;
        for (const LoadBand *other : here)
          {
            const Situation at = other->scene(plan, entries);
            places.push_back({at,
                              make_grading<dim>(at,
                                                demands,
                                                estimate_patch(at),
                                                at.mesh.elements_across_patch,
                                                at.mesh.offset())});
          }
        PhaseTimer::Scope phase(context.timer, Phase::mesh);
        kept = std::make_shared<BodyPair<dim>>(places.front().scene,
                                               grading_of_places(places),
                                               demands.pair,
                                               true);
        context.log.message("Bodies for " + std::to_string(places.size()) +
                            " places of the contact: " +
                            std::to_string(kept->n_unknowns()) + " unknowns.");
      }
    return [bodies = kept, pair = demands.pair](const PairSpec     &at,
                                                const Grading<dim> &grading) {
      return std::make_shared<RollingPair<dim>>(at, grading, pair, *bodies);
    };
  }

  template class BodiesOfPlaces<2>;
  template class BodiesOfPlaces<3>;
} // namespace RollingContact
