#ifndef rolling_contact_modes_harmonic_section_h
#define rolling_contact_modes_harmonic_section_h

#include <rolling_contact/algebra/symmetric_sparse_matrix.h>
#include <rolling_contact/mesh/material.h>
#include <rolling_contact/mesh/section_mesh.h>

#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace RollingContact
{
  class SectionElements;

  /**
   * The section of a body of revolution, whose displacement is a Fourier series
   * round the axle: along the axle, away from it and around it
   *
   *   u_y = U_y cos(n theta), u_r = U_r cos(n theta), u_t = U_t sin(n theta),
   *
   * or the same turned by a quarter of a wave. The amplitudes U are continuous
   * polynomials on the quadrilaterals of the section, which are isoparametric
   * and divided towards corners where stresses are singular.
   * Numbers n of nodal diameters do not couple, so that each is a problem of
   * the section alone:
   *
   *   eps_yy = d_y U_y, eps_rr = d_r U_r, eps_tt = (U_r + n U_t) / r,
   *   gamma_yr = d_r U_y + d_y U_r, gamma_rt = d_r U_t - (U_t + n U_r) / r,
   *   gamma_yt = d_y U_t - n U_y / r.
   *
   * The section of a body that is straight is the same far from the axle: the
   * number of waves in 2 pi metres, k = n / r, takes the place of n, t is the
   * direction along the body, and 1 / r is 0.
   *
   * Source: O. C. Zienkiewicz, R. L. Taylor, The Finite Element Method, vol. 2,
   * semi-analytical processes.
   */
  class HarmonicSection
  {
  public:
    enum class Axis
    {
      revolved,
      straight
    };

    /**
     * The quadrilaterals have coordinates along the axle and from it, the
     * second above 0 unless the body is straight. @p clamped: nothing moves on
     * their hub boundary. Units: m.
     */
    HarmonicSection(const SectionMesh &section,
                    const Material    &material,
                    const bool         clamped,
                    const unsigned int degree,
                    const Axis         axis = Axis::revolved);

    ~HarmonicSection();

    /**
     * Stiffness and consistent mass of the unknowns for @p waves nodal
     * diameters, integrated round the axle, or for that many waves in 2 pi
     * metres of a straight body, those of a metre. Units: N/m and kg, N/m^2 and
     * kg/m.
     */
    std::pair<SymmetricSparseMatrix, SymmetricSparseMatrix>
    matrices(const double waves) const;

    /**
     * Stiffness of springs that are spread evenly over the hub boundary of a
     * straight body, in all of these stiffnesses across, outwards and along.
     * Units: N/m^2.
     */
    SymmetricSparseMatrix springs(const std::array<double, 3> &stiffness) const;

    /** The nodes of the unknowns, those of a node one after the other. */
    const std::vector<unsigned int> &nodes_of_unknowns() const
    {
      return node_of_unknown;
    }

    /**
     * How the amplitudes at a place follow from those at nodes: for each node
     * with a share in them its weight and its unknowns of U_y, U_r, U_t, -1
     * where it is held.
     */
    struct Interpolation
    {
      std::vector<double>             weights;
      std::vector<std::array<int, 3>> unknowns;
    };

    /**
     * At the place of the section nearest to this one in the quadrilateral that
     * holds it. Throws InputError if that is more than a tenth of the
     * quadrilateral away. Units: m.
     */
    Interpolation at(const double along, const double radius) const;

    /** Coordinates of the nodes of unknowns, m. */
    std::vector<std::array<double, 2>> places() const;

  private:
    void find_pattern();

    const std::unique_ptr<SectionElements> elements;
    const bool                             is_straight;
    std::vector<std::array<int, 3>>        unknowns; ///< of each node
    std::vector<unsigned int>              node_of_unknown;
    SymmetricSparseMatrix                  pattern; ///< of K and M, with zeros
  };
} // namespace RollingContact

#endif
