#ifndef rolling_contact_wheelset_fmu_parameters_h
#define rolling_contact_wheelset_fmu_parameters_h

#include <rolling_contact/fmu/wheel_table.h>
#include <rolling_contact/scene/situation.h>

namespace RollingContact
{
  class Entries;

  /** What FMUs are written: those of a table, those whose states the program
   * solves when they are asked for, or both. */
  enum class FmuKind
  {
    table,
    states,
    both
  };

  /**
   * Section `FMU`: the axes of the table of an FMU, as of a right-hand wheel,
   * and how many states between its states are solved to see how far it is off.
   */
  struct FmuParameters
  {
    void declare(Entries &entries);

    /**
     * Throws InputError if an axis has two values, or they do not ascend or are
     * out of range.
     */
    void check() const;

    /** The axes; loads and friction coefficients of the scene where none are
     * given. */
    std::array<std::vector<double>, Fmu::n_axes>
    all_axes(const PairSpec &scene) const;

    FmuKind                                      kind = FmuKind::table;
    std::array<std::vector<double>, Fmu::n_axes> axes;
    unsigned int                                 n_points = 30;
  };

  /**
   * Throws InputError if the scene is none that an FMU can be made of.
   */
  void check_fmu(const Situation &scene);
} // namespace RollingContact

#endif
