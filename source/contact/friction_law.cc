#include <boost/math/tools/minima.hpp>

#include <rolling_contact/base/choices.h>
#include <rolling_contact/contact/friction_law.h>

#include <cmath>

namespace RollingContact
{
  double FrictionLaw::steepest_fall(const double carried,
                                    const double speed) const
  {
    if (speed > 0.) // the drop is concave: steepest to rest
      return drop(speed) / speed;
    const auto fall = [&](const double logarithm) {
      const double w = decay_speed() * std::exp(logarithm);
      return -(carried - 1 + drop(w)) / w;
    };
    const double reach = 14.; // of the speeds in question: e^-14 to e^14 v_c
    const int    bits  = 24;
    return -boost::math::tools::brent_find_minima(fall, -reach, reach, bits)
              .second;
  }

  namespace
  {
    class FallingFriction : public FrictionLaw
    {
    public:
      FallingFriction(const double lowest_share, const double decay_speed)
        : range(1 - lowest_share)
        , v_c(decay_speed)
      {}

      double decay_speed() const override
      {
        return v_c;
      }

    protected:
      const double range, v_c;
    };

    class ExponentialFriction : public FallingFriction
    {
      using FallingFriction::FallingFriction;

    public:
      double drop(const double speed) const override
      {
        return -range * std::expm1(-speed / v_c);
      }

      double slope(const double speed) const override
      {
        return range / v_c * std::exp(-speed / v_c);
      }
    };

    class RationalFriction : public FallingFriction
    {
      using FallingFriction::FallingFriction;

    public:
      double drop(const double speed) const override
      {
        return range * speed / (v_c + speed);
      }

      double slope(const double speed) const override
      {
        return range * v_c / ((v_c + speed) * (v_c + speed));
      }
    };

    template <typename Law>
    std::unique_ptr<const FrictionLaw> make(const double kinetic_over_static,
                                            const double decay_speed)
    {
      return std::make_unique<Law>(kinetic_over_static, decay_speed);
    }
  } // namespace

  const std::vector<FrictionLawKind> &friction_law_kinds()
  {
    static const std::vector<FrictionLawKind> kinds{
      {"constant", "mu does not change", nullptr},
      {"exponential",
       "mu_k + (mu_s - mu_k) exp(-v/v_c), Polach's law with A = mu_k/mu_s and "
       "B = 1/v_c",
       &make<ExponentialFriction>},
      {"rational",
       "mu_k + (mu_s - mu_k)/(1 + v/v_c)",
       &make<RationalFriction>}};
    return kinds;
  }

  std::unique_ptr<const FrictionLaw>
  make_friction_law(const std::string &name,
                    const double       kinetic_over_static,
                    const double       decay_speed)
  {
    const FrictionLawKind &kind =
      choice(friction_law_kinds(), name, "Contact/Friction law");
    return kind.make ? kind.make(kinetic_over_static, decay_speed) : nullptr;
  }
} // namespace RollingContact
