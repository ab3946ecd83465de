#ifndef rolling_contact_scene_hot_friction_h
#define rolling_contact_scene_hot_friction_h

#include <string>
#include <utility>
#include <vector>

namespace RollingContact
{
  /**
   * How friction follows the temperature of the surfaces: the share of mu over
   * T, linear between points and constant beyond them.
   */
  class HotFriction
  {
  public:
    /**
     * From what stands in Contact/Friction over temperature, "T: share, T:
     * share, ..." with T in K, rising; empty for none. Throws InputError.
     */
    explicit HotFriction(const std::string &text);

    bool is_constant() const
    {
      return points.empty();
    }

    /**
     * The share of mu at a temperature. Units: K to 1.
     */
    double share(const double temperature) const;

  private:
    std::vector<std::pair<double, double>> points;
  };
} // namespace RollingContact

#endif
