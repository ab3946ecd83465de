#ifndef rolling_contact_mesh_rim_coordinate_h
#define rolling_contact_mesh_rim_coordinate_h

#include <rolling_contact/mesh/surface_chart.h>

#include <vector>

namespace RollingContact
{
  /**
   * The coordinate x around a rim. In the contact sector, made of coarse cells
   * of one size, it is the Cartesian x, outside of it arc length; with cells of
   * equal angles there is no sector. A chart counts it from the begin of the
   * sector, where it is closed. Units: m, rad.
   */
  class RimCoordinate
  {
  public:
    RimCoordinate(const double radius, const CoarseCells &cells);

    /**
     * Angle from the contact, of an x counted from the begin of the sector.
     */
    double angle(const double chart_x) const;

    /**
     * Inverse of angle().
     */
    double from_angle(const double angle) const;

    /**
     * Angle at which an x counted from the contact is the Cartesian x on a
     * circle of another radius, in the sector; outside of it in proportion to
     * what is left of the circle.
     */
    double angle_on(const double x, const double other_radius) const;

    /**
     * Ends of the coarse cells, counted from the begin of the sector: growing
     * away from it, or all alike.
     */
    std::vector<double> edges() const;

    double length() const
    {
      return circumference;
    }

    /**
     * Angle of the contact, counted from the beginning of the sector. Units:
     * rad.
     */
    double contact() const
    {
      return -sector_begin;
    }

  private:
    CoarseCells cells;
    double      radius, half_sector, sector_begin, sector_end, angle_begin,
      angle_end, circumference;
  };
} // namespace RollingContact

#endif
