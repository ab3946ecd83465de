#include <rolling_contact/base/constants.h>
#include <rolling_contact/mesh/wheel_web.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {

    /// lengths over which the web widens to rim and hub, and by how much on
    /// each side; cells of the web
    const double rim_fillet = 18 * mm, rim_widening = 14 * mm,
                 hub_fillet = 25 * mm, hub_widening = 22 * mm,
                 longest_cell = 9 * mm;
  } // namespace

  WebSides wheel_web(const WheelMeasures &measures,
                     const double         bow,
                     const double         outwards)
  {
    const double rim = measures.rim_inside, hub = measures.hub_outside,
                 t = std::clamp((rim - outwards) / (rim - hub), 0., 1.),
                 s = std::sin(std::acos(-1.) * t),
                 to_rim =
                   std::max(0., outwards - (rim - rim_fillet)) / rim_fillet,
                 to_hub =
                   std::max(0., hub + hub_fillet - outwards) / hub_fillet;
    return {measures.middle_at_rim +
              (measures.middle_at_hub - measures.middle_at_rim) * t +
              bow * s * s,
            (measures.web_at_rim +
             (measures.web_at_hub - measures.web_at_rim) * t) /
                2 +
              rim_widening * to_rim * to_rim + hub_widening * to_hub * to_hub};
  }

  std::vector<double> radii_of_web(const WheelMeasures &measures)
  {
    std::vector<double> radii{measures.rim_inside};
    for (const double end : {measures.rim_inside - rim_fillet,
                             measures.hub_outside + hub_fillet,
                             measures.hub_outside})
      {
        const double begin = radii.back();
        const int    n     = std::ceil((begin - end) / longest_cell);
        for (int k = 1; k <= n; ++k)
          radii.push_back(begin + (end - begin) * k / n);
      }
    return radii;
  }
} // namespace RollingContact
