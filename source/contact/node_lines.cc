#include <rolling_contact/contact/node_lines.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace RollingContact
{
  namespace
  {
    using Line = std::vector<unsigned int>;

    const double equal = 1e-3; // of the smallest element, across a line
  }                            // namespace

  std::vector<std::vector<unsigned int>>
  node_lines(const ContactOperators &operators, const unsigned int axis)
  {
    const auto &at = operators.positions();
    Line        nodes(at.size());
    std::iota(nodes.begin(), nodes.end(), 0u);
    const double same =
      equal * std::sqrt(*std::min_element(operators.areas().begin(),
                                          operators.areas().end()));
    const unsigned int across = 1 - axis;
    std::sort(nodes.begin(), nodes.end(), [&](const auto i, const auto j) {
      return at[i][across] < at[j][across];
    });
    std::vector<Line> lines;
    for (const unsigned int node : nodes)
      {
        if (lines.empty() ||
            at[node][across] - at[lines.back().back()][across] > same)
          lines.emplace_back();
        lines.back().push_back(node);
      }
    for (Line &line : lines)
      std::sort(line.begin(), line.end(), [&](const auto i, const auto j) {
        return at[i][axis] < at[j][axis];
      });
    return lines;
  }

  std::vector<double> widths_of_lines(const std::vector<double> &places)
  {
    std::vector<double> widths;
    for (std::size_t k = 0; k < places.size(); ++k)
      widths.push_back((places[k + 1 < places.size() ? k + 1 : k] -
                        places[k > 0 ? k - 1 : k]) /
                       2);
    return widths;
  }
} // namespace RollingContact
