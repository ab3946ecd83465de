#ifndef rolling_contact_contact_mortar_h
#define rolling_contact_contact_mortar_h

#include <rolling_contact/contact/trace.h>

namespace RollingContact
{
  /**
   * A contact surface whose nodes are not those of the interface, seen along z:
   * convex quadrilaterals, in 2D segments with y = 0. Units: m.
   */
  struct SurfaceMesh
  {
    unsigned int                             n_dimensions = 1;
    std::vector<std::array<double, 2>>       nodes;
    std::vector<std::array<unsigned int, 4>> faces; ///< as corners of a Trace
  };

  /**
   * Mortar projection P = (1 + D^-1 L) D^-1 M, which takes nodal values on a
   * surface to nodal values on the interface, and its transpose nodal forces
   * back:
   *
   *   D_i = integral N_i,  M_ij = integral psi_i N_j,
   *
   * psi_i the dual functions of the N_i, integral psi_i N_j = delta_ij D_i
   * (Wohlmuth 2000). A nodal force at the interface is spread by psi_i and
   * gathered by the N_j; its second moment, h_surface^2 / 6 - h^2 / 6, is that
   * of no force on nodes that match. Where it is negative, on finer surfaces,
   * L, second differences with neighbours, takes it away: otherwise normal and
   * tangential displacements of bodies with unlike meshes do not cancel as
   * they should, and forces are off by 4e-4 of mu N with 48 elements across.
   * D p of a constant pressure p becomes its consistent nodal forces on the
   * surface. Constant fields are taken exactly, linear ones at nodes inside the
   * interface, and there quadratic ones from equal faces not larger than the
   * interface's.
   */
  struct MortarProjection
  {
    SparseRows                rows;    ///< one for each interface node
    std::vector<unsigned int> nodes;   ///< of the surface: the columns
    std::vector<double>       covered; ///< share of each interface cell
  };

  /**
   * The projection from @p surface to @p interface, which may overlap in part.
   * The corners of the interface's cells must be nodes: none hangs.
   */
  MortarProjection mortar_projection(const Trace       &interface,
                                     const SurfaceMesh &surface);
} // namespace RollingContact

#endif
