#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/references/checks.h>
#include <rolling_contact/references/contact_modulus.h>

#include <cmath>

namespace RollingContact::References
{
  namespace
  {
    void check_pair(const double young_modulus_1,
                    const double poisson_ratio_1,
                    const double young_modulus_2,
                    const double poisson_ratio_2)
    {
      check_elasticity(young_modulus_1, poisson_ratio_1);
      check_elasticity(young_modulus_2, poisson_ratio_2);
      if (std::isinf(young_modulus_1) && std::isinf(young_modulus_2))
        throw InputError("Young modulus is infinite for both bodies: at least "
                         "one of them must be elastic.");
    }
  } // namespace

  double contact_modulus(const double young_modulus_1,
                         const double poisson_ratio_1,
                         const double young_modulus_2,
                         const double poisson_ratio_2)
  {
    check_pair(young_modulus_1,
               poisson_ratio_1,
               young_modulus_2,
               poisson_ratio_2);
    return 1 / ((1 - poisson_ratio_1 * poisson_ratio_1) / young_modulus_1 +
                (1 - poisson_ratio_2 * poisson_ratio_2) / young_modulus_2);
  }

  double dundurs_beta(const double young_modulus_1,
                      const double poisson_ratio_1,
                      const double young_modulus_2,
                      const double poisson_ratio_2)
  {
    check_pair(young_modulus_1,
               poisson_ratio_1,
               young_modulus_2,
               poisson_ratio_2);
    const double G1 = young_modulus_1 / (2 * (1 + poisson_ratio_1)),
                 G2 = young_modulus_2 / (2 * (1 + poisson_ratio_2));
    return 0.5 *
           ((1 - 2 * poisson_ratio_1) / G1 - (1 - 2 * poisson_ratio_2) / G2) /
           ((1 - poisson_ratio_1) / G1 + (1 - poisson_ratio_2) / G2);
  }

  double relative_radius(const double radius_1, const double radius_2)
  {
    for (const double radius : {radius_1, radius_2})
      if (std::isnan(radius) || radius == 0)
        reject("Radius",
               radius,
               "m",
               "positive (convex), infinite (flat) or negative (concave)");
    const double relative_curvature = 1 / radius_1 + 1 / radius_2;
    if (!(relative_curvature > 0))
      reject("Relative curvature 1/R1 + 1/R2",
             relative_curvature,
             "1/m",
             "positive");
    return 1 / relative_curvature;
  }

  CombinedElasticity combined_elasticity(const double young_modulus_1,
                                         const double poisson_ratio_1,
                                         const double young_modulus_2,
                                         const double poisson_ratio_2)
  {
    check_pair(young_modulus_1,
               poisson_ratio_1,
               young_modulus_2,
               poisson_ratio_2);
    // half of each body's 1/G = 2 (1+nu)/E
    const double compliance_1 = (1 + poisson_ratio_1) / young_modulus_1;
    const double compliance_2 = (1 + poisson_ratio_2) / young_modulus_2;
    const double compliance   = compliance_1 + compliance_2;
    return {1 / compliance,
            (poisson_ratio_1 * compliance_1 + poisson_ratio_2 * compliance_2) /
              compliance};
  }
} // namespace RollingContact::References
