#ifndef rolling_contact_results_cover_columns_h
#define rolling_contact_results_cover_columns_h

#include <rolling_contact/references/layered_line.h>
#include <rolling_contact/run/results_table.h>
#include <rolling_contact/run/run_report.h>
#include <rolling_contact/scene/pair_spec.h>
#include <rolling_contact/state/steady_state.h>

#include <optional>

namespace RollingContact
{
  /**
   * The exact line contacts of half-planes with covers under the load of a 2D
   * state.
   */
  struct CoverReference
  {
    References::LayeredLine frictionless;
    /** Free rolling with friction that nothing slides by; none without. */
    std::optional<References::LayeredLine> rolling;
    /** Creepage of it along x; none without friction. */
    std::optional<double> creepage;
    /** Difference of the recovered pressure from the frictionless one, its L2
     * norm over p0 as in Errors2D; none with friction. */
    std::optional<double> pressure_l2;
  };

  /**
   * The reference of a state of bodies with covers whose gap is that of their
   * radii; none for other states and without load.
   */
  std::optional<CoverReference> cover_reference(const PairSpec       &scene,
                                                const SteadyState<2> &steady);

  /** Columns of cover_reference(), if the state has one. */
  void set_cover_columns(const PairSpec       &scene,
                         const SteadyState<2> &steady,
                         ResultsTable         &table);

  /** Say how far the state is from cover_reference(), if it has one. */
  void note_cover(const PairSpec       &scene,
                  const SteadyState<2> &steady,
                  RunReport            &report);
} // namespace RollingContact

#endif
