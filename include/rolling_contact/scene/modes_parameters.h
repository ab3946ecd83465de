#ifndef rolling_contact_scene_modes_parameters_h
#define rolling_contact_scene_modes_parameters_h

#include <optional>

namespace RollingContact
{
  class Entries;

  /**
   * Section `Modes`: which modes of the bodies are wanted.
   */
  struct ModesParameters
  {
    void declare(Entries &entries);

    /**
     * Throws InputError.
     */
    void check() const;

    /** Modes up to here are the basis, Hz. */
    double cut_off() const
    {
      return cut_off_ratio * maximum_frequency;
    }

    double maximum_frequency = 5000.; ///< Hz
    double cut_off_ratio     = 2.;    ///< of a basis over the maximum frequency
    double tolerance         = 1e-8;
    bool   count             = true;

    /**
     * Largest size of the cells of bodies without a zone of contact nodes;
     * empty for as few as resolve the shape. Units: m.
     */
    std::optional<double> element_size;

    unsigned int animated = 4; ///< modes of each body
  };
} // namespace RollingContact

#endif
