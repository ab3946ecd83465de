#include <rolling_contact/contact/slip_operator.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace RollingContact
{
  namespace
  {
    /**
     * Group the nodes by y, sort each group along the flow and cut it where the
     * point one element upstream (@p near) is not the node before.
     */
    std::vector<std::vector<unsigned int>>
    lines_along_flow(const Trace &trace, const SparseRows &near, const int flow)
    {
      std::vector<unsigned int> order(trace.nodes.size());
      std::iota(order.begin(), order.end(), 0);
      double extent = 0.;
      for (const auto &node : trace.nodes)
        extent = std::max(extent, std::abs(node[1]));
      const double tolerance = 1e-9 * extent;
      std::sort(order.begin(), order.end(), [&](const auto i, const auto j) {
        const auto &a = trace.nodes[i], &b = trace.nodes[j];
        return std::abs(a[1] - b[1]) > tolerance ? a[1] < b[1]
                                                 : flow * a[0] < flow * b[0];
      });
      std::vector<std::vector<unsigned int>> lines;
      for (const unsigned int i : order)
        {
          if (lines.empty() || near[i].size() != 1 ||
              near[i][0].first != lines.back().back())
            lines.emplace_back();
          lines.back().push_back(i);
        }
      return lines;
    }
  } // namespace

  SlipOperator::SlipOperator(const Trace           &trace,
                             const SlipOperatorKind kind,
                             const ContactMatrices  matrices,
                             const int              flow)
    : operator_kind(kind)
    , flow(flow)
  {
    UpstreamRows upstream = upstream_rows(trace, flow);
    flow_lines            = lines_along_flow(trace, upstream.near, flow);
    upstream_defined      = std::move(upstream.defined);
    near_rows             = std::move(upstream.near);
    far_rows              = std::move(upstream.far);
    mean_rows             = galerkin_rows(trace, ContactMatrices::lumped);
    base_rows =
      kind == SlipOperatorKind::galerkin   ? galerkin_rows(trace, matrices)
      : kind == SlipOperatorKind::upwind_1 ? std::move(upstream.order_1)
                                           : std::move(upstream.order_2);
  }
} // namespace RollingContact
