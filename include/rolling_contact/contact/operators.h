#ifndef rolling_contact_contact_operators_h
#define rolling_contact_contact_operators_h

#include <rolling_contact/contact/trace.h>

#include <string>
#include <vector>

namespace RollingContact
{
  enum class ContactMatrices
  {
    lumped,
    consistent,
    balanced
  };

  enum class SlipOperatorKind
  {
    upwind_1,
    upwind_2,
    galerkin,
    calibrated
  };

  /**
   * An operator as its entry of the .prm file and --print-parameters know it.
   */
  template <class Kind>
  struct OperatorChoice
  {
    std::string name;
    std::string help;
    Kind        kind;
  };

  const std::vector<OperatorChoice<ContactMatrices>> &
  contact_matrices_choices();

  const std::vector<OperatorChoice<SlipOperatorKind>> &slip_operator_choices();

  const std::string &name_of(const SlipOperatorKind kind);

  /**
   * Contact matrix H: nodal forces from nodal values of pressure or traction,
   * eq. (12) of Lai et al. 2017, integral of N^T N, or its row sums when
   * lumped; balanced row sums stay exact on linear fields where element sizes
   * change, and are no longer symmetric there. @p thickness multiplies the
   * length in 2D. Units: m^2.
   */
  SparseRows contact_matrix(const Trace          &trace,
                            const ContactMatrices kind,
                            const double          thickness);

  /**
   * Rows of B1, d/dx of a nodal field along the flow (@p flow = +1 or -1), at
   * nodes whose upstream points lie on the trace. Second order upstream:
   * (3 u(x) - 4 u(x-d) + u(x-2d)) / (2d), first order (u(x) - u(x-d)) / d, d
   * the upstream element size, u at points between nodes interpolated. Where
   * the point at x-d hangs between two nodes of the line, d is doubled.
   */
  struct UpstreamRows
  {
    SparseRows        order_1, order_2;
    SparseRows        near, far; ///< values at x-d, x-2d; empty off the trace
    std::vector<bool> defined;   ///< false at the upstream border of the trace
  };

  UpstreamRows upstream_rows(const Trace &trace, const int flow);

  /**
   * The Galerkin B1 of Lai et al. 2017: the derivative projected on the shape
   * functions, H^-1 integral of N^T dN/dx, with H of the given @p kind: row
   * sums for lumped and balanced H. Units: 1/m.
   */
  SparseRows galerkin_rows(const Trace &trace, const ContactMatrices kind);
} // namespace RollingContact

#endif
