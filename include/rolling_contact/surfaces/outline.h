#ifndef rolling_contact_surfaces_outline_h
#define rolling_contact_surfaces_outline_h

#include <array>
#include <vector>

namespace RollingContact::Profiles
{
  /**
   * A line through points in the plane, by its length. Units: m.
   */
  class Outline
  {
  public:
    using Point = std::array<double, 2>;

    /**
     * Outline through two points or more; a point that repeats the one before
     * is left out.
     */
    explicit Outline(const std::vector<Point> &points);

    double length() const
    {
      return arc.back();
    }

    const std::vector<Point> &points() const
    {
      return nodes;
    }

    /**
     * The point at this length from the begin; an end for lengths beyond it.
     */
    Point at(const double length) const;

    /**
     * The length at which the line is nearest to a point.
     */
    double nearest(const Point &point) const;

    /**
     * The part between two lengths, upwards or downwards.
     */
    Outline part(const double begin, const double end) const;

    /**
     * With both coordinates multiplied by these factors.
     */
    Outline scaled(const double first, const double second) const;

  private:
    std::vector<Point>  nodes;
    std::vector<double> arc;
  };
} // namespace RollingContact::Profiles

#endif
