#ifndef rolling_contact_references_checks_h
#define rolling_contact_references_checks_h

#include <string>

namespace RollingContact::References
{
  /**
   * Throws an InputError "quantity is value unit: it must be allowed".
   */
  [[noreturn]] void reject(const std::string &quantity,
                           const double       value,
                           const std::string &unit,
                           const std::string &allowed);

  /**
   * Throws an InputError unless the value is finite and > 0.
   */
  void check_positive(const std::string &quantity,
                      const double       value,
                      const std::string &unit = "");

  /**
   * Throws an InputError unless the value is finite and >= 0.
   */
  void check_not_negative(const std::string &quantity,
                          const double       value,
                          const std::string &unit = "");

  /**
   * Throws an InputError unless the value is finite.
   */
  void check_finite(const std::string &quantity,
                    const double       value,
                    const std::string &unit = "");

  /**
   * Throws an InputError unless E > 0 (infinite: a rigid body) and
   * -1 < nu <= 1/2.
   */
  void check_elasticity(const double young_modulus, const double poisson_ratio);

  /**
   * Throws an InputError unless the direction is 1 or -1.
   */
  void check_flow_direction(const int flow_direction);
} // namespace RollingContact::References

#endif
