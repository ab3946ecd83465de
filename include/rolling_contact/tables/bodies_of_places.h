#ifndef rolling_contact_tables_bodies_of_places_h
#define rolling_contact_tables_bodies_of_places_h

#include <rolling_contact/scene/situation.h>
#include <rolling_contact/state/state_finder.h>
#include <rolling_contact/tables/load_bands.h>

#include <memory>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * The bodies of states that differ in where the profiles touch: with sections
   * from files they keep one mesh, with small elements at all places, and one
   * factor.
   */
  template <int dim>
  class BodiesOfPlaces
  {
  public:
    /** Keeps references to all of them. */
    BodiesOfPlaces(const Situation             &scene,
                   const TablePlan             &plan,
                   const std::vector<LoadBand> &bands)
      : scene(scene)
      , plan(plan)
      , bands(bands)
    {}

    /**
     * What makes pairs of a band on the shared bodies, which are built unless
     * they are there; empty if the band shares none.
     */
    PairMaker<dim> pair_maker(const LoadBand     &band,
                              const StateDemands &demands,
                              RunContext         &context);

    /**
     * Whether wheel and rail are such bodies.
     */
    bool may_share() const;

    /**
     * Whether bodies are kept for another band.
     */
    bool keeps_bodies() const
    {
      return kept != nullptr;
    }

  private:
    /** What the bodies of a band depend on besides the place: its text. */
    std::string structure_of(const LoadBand &band) const;

    /** The bands on the same bodies that touch. */
    std::vector<const LoadBand *> sharing(const std::string &structure) const;

    const Situation               &scene;
    const TablePlan               &plan;
    const std::vector<LoadBand>   &bands;
    std::string                    structure;
    std::shared_ptr<BodyPair<dim>> kept;
  };
} // namespace RollingContact

#endif
