#include <rolling_contact/bodies/portable_dof_order.h>

#include <algorithm>

namespace RollingContact
{
  using namespace dealii;

  template <int dim>
  std::vector<std::size_t> in_portable_order(std::vector<NodeValue<dim>> values)
  {
    std::sort(values.begin(), values.end(), [](const auto &a, const auto &b) {
      for (unsigned int d = 0; d < dim; ++d)
        if (a.position[d] != b.position[d])
          return a.position[d] < b.position[d];
      return a.component < b.component;
    });
    std::vector<std::size_t> places;
    places.reserve(values.size());
    for (const auto &value : values)
      places.push_back(value.place);
    return places;
  }

  template std::vector<std::size_t>
    in_portable_order(std::vector<NodeValue<2>>);
  template std::vector<std::size_t>
    in_portable_order(std::vector<NodeValue<3>>);
} // namespace RollingContact
