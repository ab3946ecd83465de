#ifndef rolling_contact_bodies_fading_region_h
#define rolling_contact_bodies_fading_region_h

#include <algorithm>
#include <limits>

namespace RollingContact
{
  /**
   * Distances from the contact point between which the field of a half-space is
   * faded out by chi, 1 up to inner and 0 from outer on: a polynomial of degree
   * five whose first two derivatives are steady. Units: m.
   */
  struct FadingRegion
  {
    double inner, outer;

    /**
     * Where the surface of a body may become steep: its tractions are those of
     * first order in its height up to inner and, with weights that fade like
     * chi, to here, and those at the surface itself beyond. Infinite where the
     * surface is nearly plane as far as outer.
     */
    double steep_from = std::numeric_limits<double>::infinity();

    /** The inner radius over that of the farthest load, at the least. */
    static constexpr double beyond_loads = 1.2;

    /** How far loads may be from the contact point. */
    double loads_end() const
    {
      return inner / beyond_loads;
    }

    /** chi at a distance. */
    double at(const double distance) const
    {
      const double t = place(distance);
      return 1 - t * t * t * (10 - 15 * t + 6 * t * t);
    }

    /** Its derivative along the distance. Units: 1/m. */
    double slope(const double distance) const
    {
      const double t = place(distance);
      return -30 * t * t * (1 - t) * (1 - t) / (outer - inner);
    }

    /** Whether tractions are those at the surface itself anywhere. */
    bool may_be_steep() const
    {
      return steep_from < outer;
    }

    /** The weight of tractions to first order. */
    FadingRegion first_order() const
    {
      return {inner, may_be_steep() ? steep_from : outer};
    }

    /** Its value at a distance. */
    double first_order_at(const double distance) const
    {
      return may_be_steep() ? first_order().at(distance) : 1.;
    }

    /** Its derivative along the distance. Units: 1/m. */
    double first_order_slope(const double distance) const
    {
      return may_be_steep() ? first_order().slope(distance) : 0.;
    }

  private:
    double place(const double distance) const
    {
      return std::clamp((distance - inner) / (outer - inner), 0., 1.);
    }
  };
} // namespace RollingContact

#endif
