#include <rolling_contact/interface/surface_coupling.h>

#include <algorithm>

namespace RollingContact
{
  std::vector<double>
  SurfaceCoupling::to_interface(std::vector<double> body_values) const
  {
    if (is_identity())
      return body_values;
    std::vector<double> values;
    for (std::size_t offset = 0; offset < body_values.size();
         offset += n_body_nodes)
      for (unsigned int i = 0; i < P.size(); ++i)
        values.push_back(apply(P[i], body_values, offset));
    return values;
  }



  std::vector<double>
  SurfaceCoupling::to_body(std::vector<double> interface_forces) const
  {
    if (is_identity())
      return interface_forces;
    const std::size_t   n_components = interface_forces.size() / P.size();
    std::vector<double> forces(n_components * n_body_nodes, 0.);
    for (std::size_t c = 0; c < n_components; ++c)
      for (unsigned int i = 0; i < P.size(); ++i)
        for (const auto &entry : P[i])
          forces[c * n_body_nodes + entry.first] +=
            entry.second * interface_forces[c * P.size() + i];
    return forces;
  }



  DenseMatrix
  SurfaceCoupling::to_interface(DenseMatrix W) const
  {
    if (is_identity() || W.n_rows() == 0)
      return W;
    const std::size_t n_components = W.n_rows() / n_body_nodes,
                      n            = n_components * P.size();
    DenseMatrix         result(n, n);
    std::vector<double> column(W.n_rows());
    for (std::size_t c = 0; c < n_components; ++c)
      for (unsigned int j = 0; j < P.size(); ++j)
        {
          std::fill(column.begin(), column.end(), 0.);
          for (const auto &entry : P[j])
            for (std::size_t i = 0; i < column.size(); ++i)
              column[i] += entry.second * W(i, c * n_body_nodes + entry.first);
          for (std::size_t b = 0; b < n_components; ++b)
            for (unsigned int i = 0; i < P.size(); ++i)
              result(b * P.size() + i, c * P.size() + j) =
                apply(P[i], column, b * n_body_nodes);
        }
    result.mirror_lower_triangle();
    return result;
  }
} // namespace RollingContact
