#ifndef rolling_contact_bodies_half_space_influence_h
#define rolling_contact_bodies_half_space_influence_h

#include <rolling_contact/algebra/dense_matrix.h>
#include <rolling_contact/mesh/material.h>

#include <array>
#include <cstdlib>
#include <vector>

namespace RollingContact
{
  /**
   * How the plane surface of an elastic half-space answers to forces on the
   * nodes of equal elements: tractions are bilinear, so that a nodal force is
   * spread over the four elements around its node as a hat, and displacements
   * are those at the nodes. In closed form: the kernels 1/r, x^2/r^3, y^2/r^3,
   * xy/r^3, x/r^2, y/r^2 of point forces (Johnson 1985, 3.2, 3.6), integrated
   * twice along x and y, and the second differences of that. Axes of a body, z
   * out of it. Units: m, N.
   */
  class HalfSpaceInfluence
  {
  public:
    HalfSpaceInfluence(const Material              &material,
                       const std::array<double, 2> &element_size)
      : material(material)
      , size(element_size)
    {}

    /**
     * Displacement (row) at (x, y) from the node of a unit force (column).
     * Units: m to m/N.
     */
    Eigen::Matrix3d at(const double x, const double y) const;

    /**
     * Compliance of nodes at these positions, all multiples of the element
     * sizes apart: displacement @p components[i] of node n in row i * N + n.
     * Units: m to m/N.
     */
    DenseMatrix compliance(const std::vector<std::array<double, 2>> &positions,
                           const std::vector<unsigned int> &components) const;

    /**
     * Influence at distances of whole elements, of which each was calculated
     * once.
     */
    class Table
    {
    public:
      /** To distances of @p reach elements along x and y. */
      Table(const HalfSpaceInfluence &half_space,
            const std::array<int, 2> &reach);

      /** One entry at a distance of (i, j) elements. Units: m/N. */
      double operator()(const int          i,
                        const int          j,
                        const unsigned int of,
                        const unsigned int by) const
      {
        const double value =
          entries[std::abs(i) * (reach_y + 1) + std::abs(j)](of, by);
        return of != by && ((of == 0 || by == 0) && i < 0) !=
                             ((of == 1 || by == 1) && j < 0)
                 ? -value
                 : value;
      }

    private:
      const int                    reach_y;
      std::vector<Eigen::Matrix3d> entries;
    };

  private:
    const Material              material;
    const std::array<double, 2> size;
  };
} // namespace RollingContact

#endif
