#ifndef rolling_contact_references_carter_h
#define rolling_contact_references_carter_h

#include <rolling_contact/references/hertz_line.h>

#include <utility>

namespace RollingContact::References
{
  /**
   * Steady rolling of a line contact between half-planes of equal elasticity,
   * or of which one is rigid and the other incompressible (Carter 1926; Johnson
   * 1985, section 8.3). The wheel slides over the rail by
   *   s(x) = creepage + f d/dx(u^W - u^R),  f the flow direction,
   * sliding speed over |rolling speed|, positive in +x; the traction on the
   * wheel opposes it. Material flows in the direction f along x (1 or -1), so
   * the leading edge is x = -f a and the stick zone touches it. x (m) is
   * measured from the middle of the patch.
   */
  class Carter
  {
  public:
    Carter(const HertzLine &contact,
           const double     relative_radius,
           const double     friction_coefficient,
           const double     creepage,
           const int        flow_direction = 1);

    /**
     * Creepage mu a/R from which the whole patch slides.
     */
    double saturation_creepage() const;

    /**
     * Half-width of the stick zone, c = a (1 - |creepage|/saturation) (m), zero
     * in full sliding.
     */
    double stick_half_width() const;

    /**
     * Ends of the stick zone (m), the smaller first; empty (both ends on the
     * leading edge) in full sliding.
     */
    std::pair<double, double> stick_interval() const;

    /**
     * Force on the wheel over its largest, T/(mu N) = -sign(creepage) (1 -
     * c^2/a^2).
     */
    double force_ratio() const;

    /**
     * Traction on the wheel (Pa), q = -sign(creepage) mu p0
     * [sqrt(1 - x^2/a^2) - (c/a) sqrt(1 - (x - m)^2/c^2)], the second term in
     * the stick zone only, m its middle; zero outside the patch.
     */
    double traction(const double x) const;

    /**
     * Relative slip s(x), dimensionless: zero in the stick zone. Outside the
     * patch it is that of the free surfaces.
     */
    double slip(const double x) const;

  private:
    double stick_middle() const;

    HertzLine contact;
    double    relative_radius;
    double    friction_coefficient;
    double    creepage;
    double    flow_direction;
  };
} // namespace RollingContact::References

#endif
