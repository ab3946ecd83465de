#ifndef rolling_contact_wheelset_fmu_export_h
#define rolling_contact_wheelset_fmu_export_h

#include <rolling_contact/tables/session.h>
#include <rolling_contact/tables/table.h>
#include <rolling_contact/wheelset/fmu_states.h>

namespace RollingContact
{
  /**
   * Analysis = fmu: states of one wheel on a grid, and from them a wheelset
   * with forces of contact as functional mock-up units of a table, which
   * vehicle codes load, and those of states if both kinds are asked for. Random
   * states between those of the grid are solved as well: fmu_points.csv, and
   * the share of them that is within the bound which the FMU tells. Throws
   * ConvergenceError if a state is not solved, InputError if there is no binary
   * to pack.
   */
  class FmuExport : public Table<3>
  {
  public:
    FmuExport(const Situation &scene, RunContext &context);

    void run() override;

  protected:
    void draw() override
    {}

    void summarise() override;

  private:
    FmuExport(const Situation &scene,
              const FmuStates &states,
              RunContext      &context);

    /** The states of all rows; nothing if one is not to be had. */
    std::optional<std::vector<Fmu::Quantities>> all_states();

    /**
     * A state that was not solved, as an edge jumps over its load: from a load
     * beside it, values over the load. What that adds to the bound is in it.
     */
    std::optional<Fmu::Quantities> beside(const Fmu::Coordinates &point,
                                          Session &session) const;

    const FmuStates states;
    bool            is_written = false;
  };

  AnalysisKind fmu_kind();
} // namespace RollingContact

#endif
