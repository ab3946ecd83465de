#ifndef rolling_contact_tables_outside_drive_h
#define rolling_contact_tables_outside_drive_h

#include <rolling_contact/scene/pair_spec.h>
#include <rolling_contact/tables/transient_session.h>

#include <array>
#include <utility>
#include <vector>

namespace RollingContact
{
  /**
   * Makes the histories of a time step from what is given from outside and what
   * was before: lines through the ends of the last steps and of this one, and
   * beyond it as far again. What was never given keeps the scene's history.
   */
  class OutsideDrive
  {
  public:
    /**
     * The quantities of StepInputs, in their order.
     */
    enum Quantity
    {
      normal_load,
      approach,
      creepage_x,
      creepage_y,
      spin,
      speed,
      longitudinal_force,
      lateral_force,
      spin_moment,
      n_quantities
    };

    OutsideDrive(const PairSpec &scene, const DrivingFunctions &of_scene);

    /**
     * The histories of a step. Throws InputError, nothing changed, if the
     * inputs do not suit the scene. Units: s.
     */
    DrivingFunctions next(const StepInputs   &inputs,
                          const double        time,
                          const double        length,
                          const BetweenValues between);

    /**
     * Remember what was at the end of a step, or before the first: creepages
     * that were found, forces that came out.
     */
    void remember(const double            time,
                  const DrivingFunctions &histories,
                  const Creepages        &creepages,
                  const Resultants       &forces);

  private:
    using Points = std::vector<std::pair<double, double>>;

    void check(const StepInputs &inputs) const;

    void check_forces(const DrivingFunctions &histories,
                      const double            time) const;

    const PairSpec                  *scene;
    DrivingFunctions                 histories; ///< of the last step
    std::array<Points, n_quantities> past;      ///< ends of three steps at most
    std::array<bool, n_quantities>   from_outside{};
  };
} // namespace RollingContact

#endif
