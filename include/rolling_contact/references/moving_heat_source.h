#ifndef rolling_contact_references_moving_heat_source_h
#define rolling_contact_references_moving_heat_source_h

#include <vector>

namespace RollingContact
{
  namespace References
  {
    /**
     * Steady rise of the surface temperature of a half-space that moves along x
     * at a speed V under a plane source of heat, after Jaeger (1942):
     *
     *   theta(x) = 1/(pi k) integral of f(x') exp(u) K_0(|u|) dx',
     *   u = V (x - x')/(2 kappa),
     *
     * of a flux f that is linear between the points of a line and zero beyond
     * its ends, integrated exactly. @p x rises, V > 0 moves the material along
     * +x. For V a/kappa above 20 this is f's convolution with 1/(b sqrt(pi V
     * x)), b = k / sqrt(kappa). Units: m, W/m^2, m/s, W/(m K), m^2/s; K.
     */
    std::vector<double> moving_heat_source(const std::vector<double> &x,
                                           const std::vector<double> &flux,
                                           const double               speed,
                                           const double conductivity,
                                           const double diffusivity);
  } // namespace References
} // namespace RollingContact

#endif
