#ifndef rolling_contact_scene_stability_parameters_h
#define rolling_contact_scene_stability_parameters_h

namespace RollingContact
{
  class Entries;

  /**
   * Wheels of a wheelset whose place is found, see section `Wheelset`; none:
   * the place is that of section `Profiles`.
   */
  enum class WheelsFound
  {
    none,
    right,
    left,
    both
  };

  /**
   * Section `Stability`: what the steady rolling state is disturbed by, and how
   * its eigenvalues are proved.
   */
  struct StabilityParameters
  {
    void declare(Entries &entries);

    /**
     * Throws InputError.
     */
    void check() const;

    double lowest_frequency = 60.; ///< Hz
    bool   rotation         = true;
    bool   count            = true;
    bool   correct          = true;
    bool   thresholds       = true;
    double damping_margin   = 0.;
    double added_damping    = 0.; ///< of all modes, damping ratio

    WheelsFound wheels = WheelsFound::none;
  };
} // namespace RollingContact

#endif
