#ifndef rolling_contact_state_level_history_h
#define rolling_contact_state_level_history_h

#include <array>
#include <optional>
#include <vector>

namespace RollingContact
{
  /**
   * What a refinement level found: forces and approach, and the friction force
   * mu N that tractions are measured by (N when frictionless). Units: N, m.
   */
  struct LevelValues
  {
    enum Quantity
    {
      normal_force,
      force_x,
      force_y,
      approach,
      n_quantities
    };

    std::array<double, n_quantities> values{};
    double                           friction_force = 0.;
  };

  /**
   * The limit the levels point to, and what is to be expected of it.
   */
  struct LevelLimit
  {
    LevelValues limit;
    double      value_error = 0.; ///< of the last level's values
    double      limit_error = 0.; ///< of the limit itself
  };

  /**
   * The values of successive levels, each with half the element size of the one
   * before where it matters. Errors and changes are the largest of |dN|/N and
   * |dT|/(mu N), and of the approach's relative change where the load is given
   * and N does not change. Units: 1.
   */
  class LevelHistory
  {
  public:
    void add(const LevelValues &values)
    {
      levels.push_back(values);
    }

    /**
     * Change from the level before; none at the first.
     */
    std::optional<double> change() const;

    /**
     * Richardson's extrapolation, for two levels or more. The factor by which
     * errors shrink from level to level is measured on three levels and kept
     * between 1/8 and 2/3; with two it is 1/3, between first and second order.
     * The error of the limit is the distance from the limit the levels before
     * pointed to, or from the last values if there is none.
     */
    std::optional<LevelLimit> limit() const;

  private:
    std::vector<LevelValues> levels;
  };
} // namespace RollingContact

#endif
