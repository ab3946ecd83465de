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

  /**
   * What a beam of this section needs: area (m^2), height of its centroid (m),
   * and second moments of area about the axes across and up through it (m^4).
   */
  struct SectionProperties
  {
    double area, height, I_y, I_z;
  };

  /**
   * Properties of the section inside the polygon of these points (across, up),
   * in either sense.
   */
  SectionProperties
  section_properties(const std::vector<Outline::Point> &polygon);
} // namespace RollingContact::Profiles

#endif
