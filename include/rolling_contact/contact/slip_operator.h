#ifndef rolling_contact_contact_slip_operator_h
#define rolling_contact_contact_slip_operator_h

#include <rolling_contact/contact/operators.h>

namespace RollingContact
{
  /**
   * B1 on a trace: its rows far from any edge of the contact, and the lines of
   * nodes along the flow that the edge law works on (see edge_law.h). Does not
   * depend on the state.
   */
  class SlipOperator
  {
  public:
    SlipOperator() = default;

    /**
     * An operator without rows, for contact without friction.
     */
    explicit SlipOperator(const SlipOperatorKind kind)
      : operator_kind(kind)
    {}

    SlipOperator(const Trace           &trace,
                 const SlipOperatorKind kind,
                 const ContactMatrices  matrices,
                 const int              flow);

    const SparseRows &rows() const
    {
      return base_rows;
    }

    SlipOperatorKind kind() const
    {
      return operator_kind;
    }

    /**
     * True if the rows at the edges of the contact follow the edge law.
     */
    bool has_edge_law() const
    {
      return operator_kind == SlipOperatorKind::calibrated &&
             base_rows.size() > 0;
    }

    /**
     * Direction of the material flow along x, +1 or -1.
     */
    int flow_direction() const
    {
      return flow;
    }

    /**
     * True for nodes whose upstream points lie on the trace.
     */
    const std::vector<bool> &defined() const
    {
      return upstream_defined;
    }

    /**
     * Weights of the nodes in the value one element upstream of each node, and
     * two; empty off the trace.
     */
    const SparseRows &one_upstream() const
    {
      return near_rows;
    }

    const SparseRows &two_upstream() const
    {
      return far_rows;
    }

    /**
     * d/dx in the mean around each node, 1/A_i integral of N_i du/dx, A_i the
     * integral of N_i: what a nodal traction's power is made of. The discrete
     * integral of q du/dx has the antisymmetry of the continuous one. Units:
     * 1/m.
     */
    const SparseRows &mean_derivative() const
    {
      return mean_rows;
    }

    /**
     * Nodes of the same y, each line in the order of the flow. A line ends
     * where the next point downstream is no node, as at the border of a refined
     * part; another may begin behind it.
     */
    const std::vector<std::vector<unsigned int>> &lines() const
    {
      return flow_lines;
    }

  private:
    SlipOperatorKind  operator_kind = SlipOperatorKind::upwind_2;
    int               flow          = 1;
    SparseRows        base_rows, near_rows, far_rows, mean_rows;
    std::vector<bool> upstream_defined;
    std::vector<std::vector<unsigned int>> flow_lines;
  };
} // namespace RollingContact

#endif
