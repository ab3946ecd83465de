#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/references/checks.h>

#include <cmath>
#include <sstream>

namespace RollingContact::References
{
  void reject(const std::string &quantity,
              const double       value,
              const std::string &unit,
              const std::string &allowed)
  {
    std::ostringstream message;
    message.precision(9);
    message << quantity << " is " << value << (unit.empty() ? "" : " ") << unit
            << ": it must be " << allowed << '.';
    throw InputError(message.str());
  }

  void check_positive(const std::string &quantity,
                      const double       value,
                      const std::string &unit)
  {
    if (!(std::isfinite(value) && value > 0))
      reject(quantity, value, unit, "finite and positive");
  }

  void check_not_negative(const std::string &quantity,
                          const double       value,
                          const std::string &unit)
  {
    if (!(std::isfinite(value) && value >= 0))
      reject(quantity, value, unit, "finite and not negative");
  }

  void check_finite(const std::string &quantity,
                    const double       value,
                    const std::string &unit)
  {
    if (!std::isfinite(value))
      reject(quantity, value, unit, "finite");
  }

  void check_elasticity(const double young_modulus, const double poisson_ratio)
  {
    if (!(young_modulus > 0))
      reject("Young modulus",
             young_modulus,
             "Pa",
             "positive (infinite for a rigid body)");
    if (!(poisson_ratio > -1 && poisson_ratio <= 0.5))
      reject("Poisson ratio",
             poisson_ratio,
             "",
             "larger than -1 and not larger than 0.5");
  }

  void check_flow_direction(const int flow_direction)
  {
    if (flow_direction != 1 && flow_direction != -1)
      reject("Flow direction",
             flow_direction,
             "",
             "1 (material flows in +x) or -1 (in -x)");
  }
} // namespace RollingContact::References
