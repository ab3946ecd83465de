#ifndef rolling_contact_evolution_duty_h
#define rolling_contact_evolution_duty_h

#include <rolling_contact/scene/situation.h>

#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * A row of a duty: a wheelset in a case of its own, and the share of the
   * distance that it runs so.
   */
  struct DutyCase
  {
    std::string name;
    double      share;
    Situation   scene;
  };

  /**
   * The rows of Evolution/File of rows: columns are entries of sections
   * Wheelset and Contact with their values, `share`, and `name` where rows have
   * one; the scene itself where there is no file. Throws InputError, naming the
   * row, if a column is no such entry, a value is not allowed, or shares do not
   * sum to 1.
   */
  std::vector<DutyCase> read_duty(const Situation &scene);
} // namespace RollingContact

#endif
