#ifndef rolling_contact_analyses_limit_cycle_parameters_h
#define rolling_contact_analyses_limit_cycle_parameters_h

#include <string>
#include <vector>

namespace RollingContact
{
  class Entries;

  /**
   * In which order the values of the axis are taken, each from the cycle of the
   * one before.
   */
  enum class SweepDirection
  {
    up,
    down,
    both ///< up, and down again from the last cycle
  };

  /**
   * Section `Limit cycle`: which limit cycles are looked for, from which starts
   * and along which axis.
   */
  struct LimitCycleParameters
  {
    void declare(Entries &entries);

    /**
     * Throws InputError unless the starts are frequencies or `all`, and an axis
     * has numbers in their range.
     */
    void check() const;

    /** Whether each vibration that grows is a start. */
    bool starts_from_all() const
    {
      return starts == "all";
    }

    /** Frequencies of the starts; none if all vibrations that grow are. Throws
     * InputError. Units: Hz. */
    std::vector<double> start_frequencies() const;

    /** The entry that the cycles are followed along, as Section/Entry; empty
     * for none. */
    std::string axis_entry() const;

    /** Its values, ascending, each once. Throws InputError. */
    std::vector<double> axis_values() const;

    std::string    starts    = "all";
    std::string    axis      = "none";
    std::string    values    = "";
    SweepDirection direction = SweepDirection::up;
  };
} // namespace RollingContact

#endif
