#ifndef rolling_contact_contact_square_root_edge_h
#define rolling_contact_contact_square_root_edge_h

#include <rolling_contact/contact/contact_operators.h>

#include <array>
#include <optional>
#include <vector>

namespace RollingContact
{
  /**
   * How far a discrete field f >= 0 that ends like a square root is from the
   * exact one at the nodes next to its end: f_k^2 = f(x_k)^2 + s d_k(xi), k =
   * 0, 1, ... from the outermost node with f_k > 0 inwards, s the growth of
   * f(x)^2 over an element at the end, xi the distance from it to node 0 in
   * elements, below zero outside, where the area of the node reaches over the
   * end. d_k are polynomials in xi, those of linear elements or of hats on a
   * half-plane: the same for all loads and radii, and nearly so for all
   * materials. Their coefficients are fitted to Hertz and Carter: those of
   * elements by tests/campaigns/edge_deviations, those of hats, with 192
   * elements, on the half-planes of tests/unit/half_plane.h.
   */
  class SquareRootEdge
  {
  public:
    /**
     * The end of the pressure, where the gap opens.
     */
    static SquareRootEdge of_pressure(const NodalForces forces);

    /**
     * The end of the stick zone downstream: f = mu p - |q|.
     */
    static SquareRootEdge of_stick_zone(const NodalForces forces);

    /**
     * At one node.
     */
    struct Deviation
    {
      double of_square; ///< s d_k
      double growth;    ///< s
    };

    /**
     * The deviations at the nodes next to the end, for the discrete values @p
     * from_end at the nodes from there inwards in equal distances. Empty if
     * they are too few or do not end like a square root.
     */
    std::vector<Deviation> deviation(const std::vector<double> &from_end) const;

    /**
     * The distance xi of the outermost node from the end, in elements and
     * negative outside, for the same values. A parabola goes through the
     * squares of five nodes without their deviations, from the one at @p first
     * on: 1 is what deviation() takes; from 2 on depends less on d_1, which is
     * another where the end is curved. Empty if they are too few or do not end
     * like a square root.
     */
    std::optional<double> distance(const std::vector<double> &from_end,
                                   const std::size_t          first) const;

  private:
    using Quadratic = std::array<double, 3>; // highest power first
    static constexpr std::size_t n_disturbed = 5;

    /**
     * Where a field ends and how it grows there, xi and s.
     */
    struct Ending
    {
      double distance, growth;
    };

    SquareRootEdge(const std::array<Quadratic, n_disturbed> &deviations,
                   const std::array<double, 2>              &distances);

    /**
     * The end of hats on a half-plane, of pressures and stick zones alike.
     */
    static SquareRootEdge of_hats();

    std::optional<Ending> ending(const std::vector<double> &from_end,
                                 const std::size_t          first) const;

    /**
     * s d_k(xi) at node @p k.
     */
    double deviation_of(const std::size_t k, const Ending &ending) const;

    std::array<Quadratic, n_disturbed> deviations;
    std::array<double, 2>              distances; ///< where xi may lie
  };
} // namespace RollingContact

#endif
