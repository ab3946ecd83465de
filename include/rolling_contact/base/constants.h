#ifndef rolling_contact_base_constants_h
#define rolling_contact_base_constants_h

namespace RollingContact
{
  constexpr double pi = 3.14159265358979323846;
  constexpr double mm = 1e-3; ///< m

  /// 20 lg e: the level of an amplitude that is e times another, dB
  constexpr double decibels_of_e = 8.68588963806503655;
} // namespace RollingContact

#endif
