#include <rolling_contact/mesh/shared_edges.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace RollingContact
{
  void SharedEdges::add(const std::vector<long> &corners)
  {
    for (std::size_t v = 0; v < corners.size(); ++v)
      edges.push_back(
        std::minmax(corners[v], corners[(v + 1) % corners.size()]));
  }

  void SharedEdges::check() const
  {
    auto sorted = edges;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t k = 2; k < sorted.size(); ++k)
      if (sorted[k] == sorted[k - 2])
        throw std::runtime_error(
          "the edge between its nodes " + std::to_string(sorted[k].first) +
          " and " + std::to_string(sorted[k].second) +
          " belongs to three quadrilaterals or more; cells may share it two by "
          "two only: take out what overlaps, or is there twice.");
  }
} // namespace RollingContact
