#ifndef rolling_contact_tables_stability_map_h
#define rolling_contact_tables_stability_map_h

#include <rolling_contact/scene/situation.h>
#include <rolling_contact/tables/bodies_of_places.h>
#include <rolling_contact/tables/table.h>
#include <rolling_contact/vibration/vibrations.h>

#include <memory>
#include <optional>

namespace RollingContact
{
  /**
   * Analysis = stability map: a table whose states are disturbed as well. Each
   * has in its row how many vibrations grow and which fastest; bodies are
   * reduced to their modes once for all states on them, and the state that
   * squeals most is proved by the whole bodies.
   */
  template <int dim>
  class StabilityMap : public Table<dim>
  {
  public:
    StabilityMap(const Situation &scene, RunContext &context)
      : Table<dim>(scene, context)
      , places(scene, plan, this->bands)
    {}

    StabilityMap(const Situation   &scene,
                 const TableStates &states,
                 RunContext        &context)
      : Table<dim>(scene, states, context)
      , places(scene, plan, this->bands)
    {}

  private:
    /** What the whole bodies say of the vibration that grows fastest. */
    struct Proof
    {
      std::size_t state = 0;
      Finding     finding;
      std::string mode; ///< its name
    };

    void take_bodies(const Situation        &scene,
                     const SteadyState<dim> &base) override;

    void add_columns(const Situation        &scene,
                     const SteadyState<dim> &steady,
                     ResultsTable           &row) const override;

    void leave_bodies(const LoadBand         &band,
                      const Situation        &scene,
                      const SteadyState<dim> &base) override;

    /**
     * If the state that squeals most of all is one of the band.
     */
    void prove_worst(const LoadBand         &band,
                     const Situation        &scene,
                     const SteadyState<dim> &base);

    /**
     * When all rows are there: on bodies that have been kept for all places, or
     * on others where each rank had its own.
     */
    void prove_in_the_end();

    PairMaker<dim> pair_maker(const LoadBand &band) override
    {
      return places.pair_maker(band, demands(), context);
    }

    /** Modes take longer than states do with more elements. */
    double smallest_share() const override
    {
      return 0.7;
    }

    std::string sets(const std::size_t n) const override;

    /** With factors, and a zone that is seldom too small. */
    StateDemands demands() const override;

    /** The mode of the wheel, or of the rail under a rigid one, that has most
     * of a vibration. */
    std::string mode_of(const Vibrations          &vibrations,
                        const std::complex<double> s) const;

    void draw() override;

    void summarise() override;

    using Table<dim>::context;
    using Table<dim>::plan;

    BodiesOfPlaces<dim>                places;
    std::optional<BodyPair<dim>>       touching; ///< whose modes these are
    std::unique_ptr<ModalBodies<dim>>  bodies;
    std::unique_ptr<RollingModes<dim>> rolling;
    std::optional<Proof>               proof;
  };

  AnalysisKind stability_map_kind();
} // namespace RollingContact

#endif
