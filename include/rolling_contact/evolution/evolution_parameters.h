#ifndef rolling_contact_evolution_evolution_parameters_h
#define rolling_contact_evolution_evolution_parameters_h

#include <rolling_contact/damage/wear_laws.h>

#include <optional>
#include <string>

namespace RollingContact
{
  class Entries;

  enum class WearingBodies
  {
    wheel,
    rail,
    both
  };

  /**
   * Section `Evolution`: what wheels and rails go through, by which law they
   * wear, and how far. Units: m, 1.
   */
  struct EvolutionParameters
  {
    void declare(Entries &entries);

    /** Throws InputError if a value is out of its range. */
    void check() const;

    /** Throws InputError unless the way is given of what wears. */
    void check_way() const;

    bool wears_wheel() const
    {
      return bodies != WearingBodies::rail;
    }

    bool wears_rail() const
    {
      return bodies != WearingBodies::wheel;
    }

    /** A share of the way, "60000 km", "1e+06 passages", or both. */
    std::string text_of_way(const double share) const;

    /** The law of wear_laws() with this name. */
    const Damage::WearLaw &wear_law() const;

    std::string   file_of_rows; ///< of the duty
    bool          both_directions = true;
    WearingBodies bodies          = WearingBodies::wheel;
    std::string   law             = "usfd";

    std::optional<double> distance; ///< that the wheels roll
    std::optional<double> passages; ///< of wheelsets over the rails

    double                tolerance    = 5e-6; ///< of the depth of a step
    double                largest_step = 1e-4; ///< of depth
    unsigned int          equal_steps  = 0;    ///< in place of these; 0: none
    bool                  is_implicit  = true;
    std::optional<double> smoothing;   ///< least width of the kernel
    unsigned int          threads = 0; ///< 0: as many as processors

    /** Where it ends before the distance. */
    std::optional<double> largest_depth, least_thickness, largest_height,
      least_qr;

  private:
    void declare_duty(Entries &entries);

    void declare_steps(Entries &entries);

    void declare_ends(Entries &entries);
  };
} // namespace RollingContact

#endif
