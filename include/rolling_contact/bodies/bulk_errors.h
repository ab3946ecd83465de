#ifndef rolling_contact_bodies_bulk_errors_h
#define rolling_contact_bodies_bulk_errors_h

#include <rolling_contact/algebra/dense_matrix.h>

#include <array>
#include <vector>

namespace RollingContact
{
  /**
   * Nodal forces that change smoothly over the zone of contact: in each of
   * several components those of an elliptical pressure and this times x and, in
   * 3D, times y; of degree 2, times x^2, x y, y^2 as well. Forces are alike
   * that have the same sums and the same moments with these. Units: m, N.
   */
  class SmoothForces
  {
  public:
    using Positions = std::vector<std::array<double, 2>>;

    SmoothForces() = default;

    /**
     * For nodes at these @p positions with these areas, within an ellipse of
     * @p half_widths about the origin; 0 across in 2D. Units: m.
     */
    SmoothForces(const Positions             &positions,
                 const std::vector<double>   &areas,
                 const std::array<double, 2> &half_widths,
                 const unsigned int           n_components,
                 const unsigned int           degree = 1);

    /**
     * Each of the smooth forces, component by component of the nodes. Its sum
     * is 1 N or its first moment about that of a half-width.
     */
    const std::vector<std::vector<double>> &forces() const
    {
      return all;
    }

    /**
     * How much of each smooth force there is in @p values at the nodes at these
     * positions, component by component: in nodal forces or in the weights of
     * nodal displacements.
     */
    Eigen::VectorXd amounts(const Positions           &positions,
                            const std::vector<double> &values) const;

  private:
    Eigen::VectorXd moments(const Positions           &positions,
                            const std::vector<double> &values) const;

    std::array<double, 2>            scale{};
    unsigned int                     n_components = 0, n_shapes = 0;
    std::vector<std::vector<double>> all;
    DenseMatrix                      of_moments; ///< amounts of unit moments
  };

  /**
   * How much the compliance of a pair lacks for want of elements in the bulk of
   * its bodies, for smooth nodal forces, in parts by the sizes of elements, see
   * energy_errors(); empty if it is not known.
   */
  struct BulkErrors
  {
    SmoothForces             smooth;
    std::vector<DenseMatrix> parts; ///< m/N

    /**
     * How far off a sum of displacements with these @p weights may be under
     * nodal @p forces, the sum of the sizes of the parts. Both are of nodes at
     * given places, component by component. Units: those of the sum.
     */
    double largest(const SmoothForces::Positions &at_weights,
                   const std::vector<double>     &weights,
                   const SmoothForces::Positions &at_forces,
                   const std::vector<double>     &forces) const;
  };
} // namespace RollingContact

#endif
