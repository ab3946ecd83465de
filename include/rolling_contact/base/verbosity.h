#ifndef rolling_contact_base_verbosity_h
#define rolling_contact_base_verbosity_h

namespace RollingContact
{
  /**
   * How much the program says while it runs.
   */
  enum class Verbosity
  {
    quiet,
    normal,
    verbose
  };
} // namespace RollingContact

#endif
