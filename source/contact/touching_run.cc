#include <rolling_contact/contact/touching_run.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /**
     * True if the point with these weights is in contact.
     */
    bool touches(const SparseRows::Row     &weights,
                 const std::vector<double> &pressure)
    {
      return !weights.empty() &&
             std::all_of(weights.begin(),
                         weights.end(),
                         [&](const auto &entry) {
                           return pressure[entry.first] > 0.;
                         });
    }
  } // namespace

  std::vector<TouchingRun> touching_runs(const SlipOperator &slip_operator,
                                         const std::vector<double> &pressure)
  {
    std::vector<TouchingRun> runs;
    for (const auto &line : slip_operator.lines())
      {
        bool touching = false;
        for (const unsigned int node : line)
          {
            if (pressure[node] > 0. && !touching)
              {
                runs.emplace_back();
                runs.back().leading =
                  !touches(slip_operator.one_upstream()[node], pressure);
              }
            touching = pressure[node] > 0.;
            if (touching)
              runs.back().nodes.push_back(node);
          }
        if (touching)
          runs.back().cut = true;
      }
    return runs;
  }

  std::vector<double> places(const TouchingRun      &run,
                             const ContactOperators &operators)
  {
    std::vector<double> x;
    for (const unsigned int node : run.nodes)
      x.push_back(operators.slip_operator().flow_direction() *
                  operators.positions()[node][0]);
    return x;
  }

  double change_of_curvature(const TouchingRun         &run,
                             const std::vector<double> &x,
                             const std::vector<double> &gap)
  {
    const std::size_t n = run.nodes.size();
    if (n < 4)
      return 0.;
    const auto slope = [&](const std::size_t k) {
      return (gap[run.nodes[k + 1]] - gap[run.nodes[k]]) / (x[k + 1] - x[k]);
    };
    const auto curvature = [&](const std::size_t k) {
      return 2 * (slope(k + 1) - slope(k)) / (x[k + 2] - x[k]);
    };
    double largest = 0.;
    for (std::size_t k = 0; k + 3 < n; ++k)
      largest = std::max(largest, std::abs(curvature(k + 1) - curvature(k)));
    // the mean over the run from its end slopes
    const double mean =
      (slope(n - 2) - slope(0)) / ((x[n - 1] + x[n - 2] - x[1] - x[0]) / 2);
    return mean != 0. ? largest / std::abs(mean) : 0.;
  }
} // namespace RollingContact
