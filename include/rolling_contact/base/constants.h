#ifndef rolling_contact_base_constants_h
#define rolling_contact_base_constants_h

namespace RollingContact
{
  constexpr double pi = 3.14159265358979323846;
  constexpr double mm = 1e-3; ///< m
} // namespace RollingContact

#endif
