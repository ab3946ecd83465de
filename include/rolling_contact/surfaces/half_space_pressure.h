#ifndef rolling_contact_surfaces_half_space_pressure_h
#define rolling_contact_surfaces_half_space_pressure_h

#include <cstddef>
#include <optional>
#include <vector>

namespace RollingContact
{
  /**
   * Equal rectangles in the plane of contact, n_x along x and n_y along y, with
   * the middle of the first at (first_x, first_y). Values at them are given row
   * by row, x running fastest. Units: m.
   */
  struct ContactGrid
  {
    std::size_t n_x, n_y;
    double      first_x, first_y;
    double      size_x, size_y;

    double x(const std::size_t i) const
    {
      return first_x + i * size_x;
    }

    double y(const std::size_t j) const
    {
      return first_y + j * size_y;
    }
  };

  /**
   * Frictionless contact of half-spaces: pressures of the rectangles (Pa), the
   * approach (m) and the load (N).
   */
  struct HalfSpacePressure
  {
    std::vector<double> pressure;
    double              approach;
    double              load;
  };

  /**
   * Contact of half-spaces with the undeformed gap h (m) and the contact
   * modulus E* (Pa), with constant pressure on each rectangle:
   *
   *   u = h - approach + 1/(pi E*) int p / r dA,  u >= 0, p >= 0, p u = 0.
   *
   * Under a load (N), or with an approach (m) if there is none. With shares,
   * the cosines between the normals of a curved surface and the direction of
   * approach and load, the approach closes a gap by its share and the load is
   * the integral of share times p. The influence
   * of a rectangle is Love's (1929); solved by the constrained conjugate
   * gradients of Polonsky and Keer (Wear 231, 1999) until pressures change by
   * less than 1e-4 of their sum; a round costs two products by Fourier
   * transforms. Throws std::runtime_error if that takes more than 1000 rounds.
   */
  HalfSpacePressure half_space_pressure(const ContactGrid         &grid,
                                        const std::vector<double> &gap,
                                        const double contact_modulus,
                                        const std::optional<double> &load,
                                        const double                 approach,
                                        const std::vector<double> &shares = {});
} // namespace RollingContact

#endif
