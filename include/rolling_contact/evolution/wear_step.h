#ifndef rolling_contact_evolution_wear_step_h
#define rolling_contact_evolution_wear_step_h

#include <rolling_contact/evolution/duty_row.h>
#include <rolling_contact/evolution/evolution_parameters.h>

#include <functional>
#include <memory>
#include <vector>

namespace RollingContact
{
  /**
   * All rows of a duty on the same surfaces.
   */
  using DutyStates = std::vector<DutyState>;

  /**
   * A step of the wear of profiles under a duty,
   *
   *     h(s) = sum_j w_j L D_j p_j(h),
   *
   * with D_j the wear of row j over its pressure, both at the beginning of the
   * step. The step is implicit in the pressures, so that any length is stable:
   * each p_j is the pressure of a contact with a compliance added, see
   * WearingContact::depths_at_end(). The order is 1. Two half steps give the
   * error; extrapolation from them and the whole step gives order 2.
   */
  class WearStep
  {
  public:
    /** Keeps references. */
    WearStep(const EvolutionParameters   &section,
             const std::vector<DutyCase> &duty);

    /** The balances of all rows on these surfaces, see DutyState. Throws as
     * DutyRow::stand_on() does. Collective, as are all that find something. */
    DutyStates stand_on(const RunningSurfaces &surfaces);

    /** What wears of these surfaces over a part of the whole way. */
    RunningSurfaces::Amounts worn(const RunningSurfaces &surfaces,
                                  const DutyStates      &states,
                                  const double           share) const;

    /** Without feedback: explicit. */
    RunningSurfaces::Amounts worn_at_once(const RunningSurfaces &surfaces,
                                          const DutyStates      &states,
                                          const double           share) const;

    /** A step of the whole and two of half the way, extrapolated. */
    struct Found
    {
      RunningSurfaces::Amounts amounts;
      double                   error; ///< misplaced depth of two halves, m
      double                   depth; ///< largest, m

      template <class Archive>
      void serialize(Archive &archive, const unsigned int)
      {
        archive &amounts &error &depth;
      }
    };

    /** Throws ConvergenceError or InputError where the surfaces half way have
     * no balance. */
    Found find(const RunningSurfaces &surfaces,
               const DutyStates      &states,
               const double           share);

    /** Evolution/Smoothing, or half of the largest distance of neighbouring
     * centres of wear that are less than 5 mm apart. Units: m. */
    double smoothing(const DutyStates &states) const;

    /** How many states all ranks have solved. Collective. */
    unsigned int n_states() const;

    unsigned int n_threads() const;

  private:
    /** What all rows wear together. Collective. */
    RunningSurfaces::Amounts total_of(
      const RunningSurfaces                                      &surfaces,
      const std::function<RunningSurfaces::Amounts(std::size_t)> &of_row) const;

    /** What a row wears, by the depths of the rail for a passage that @p
     * depths_of finds for its contacts. */
    RunningSurfaces::Amounts
    worn_by(const RunningSurfaces &surfaces,
            const DutyState       &state,
            const WearingWay      &way,
            const std::function<std::vector<double>(const WearingContact &)>
                        &depths_of,
            const double smoothing) const;

    /** The way of a row for a share of the whole. */
    WearingWay way_of(const std::size_t row, const double share) const;

    /** What a contact wears by depths of the rail for a passage. */
    RunningSurfaces::Amounts amounts_of(const RunningSurfaces     &surfaces,
                                        const WearingContact      &contact,
                                        const WearingWay          &way,
                                        const std::vector<double> &depths,
                                        const double smoothing) const;

    /** Depths of both bodies under the lines of a contact. Units: m. */
    std::vector<double>
    depths_of_others(const RunningSurfaces          &surfaces,
                     const WearingContact           &contact,
                     const RunningSurfaces::Amounts &others) const;

    const EvolutionParameters            &section;
    const std::vector<DutyCase>          &duty;
    std::vector<std::unique_ptr<DutyRow>> rows; ///< null on other ranks
  };
} // namespace RollingContact

#endif
