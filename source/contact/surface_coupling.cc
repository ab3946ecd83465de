#include <rolling_contact/contact/surface_coupling.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  void SurfaceCoupling::turn_values(double           *across,
                                    double           *normal,
                                    const std::size_t stride,
                                    const bool        backwards) const
  {
    for (std::size_t i = 0; i < angles.size(); ++i)
      {
        const double c = std::cos(angles[i]),
                     s = std::sin(backwards ? -angles[i] : angles[i]);
        double      &y = across[i * stride], &z = normal[i * stride];
        const double along_tangent = c * y - s * z;
        z                          = s * y + c * z;
        y                          = along_tangent;
      }
  }

  std::vector<double>
  SurfaceCoupling::to_interface(std::vector<double> body_values) const
  {
    std::vector<double> values;
    if (is_identity())
      values = std::move(body_values);
    else
      for (std::size_t offset = 0; offset < body_values.size();
           offset += n_body_nodes)
        for (unsigned int i = 0; i < P.size(); ++i)
          values.push_back(apply(P[i], body_values, offset));
    if (const std::size_t n = angles.size(); n > 0 && !values.empty())
      turn_values(&values[n], &values[2 * n], 1, false);
    return values;
  }

  std::vector<double>
  SurfaceCoupling::to_body(std::vector<double> interface_forces) const
  {
    if (const std::size_t n = angles.size(); n > 0)
      turn_values(&interface_forces[n], &interface_forces[2 * n], 1, true);
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

  DenseMatrix SurfaceCoupling::projected(const DenseMatrix &W) const
  {
    const std::size_t n_components = W.rows() / n_body_nodes,
                      n            = n_components * P.size();
    DenseMatrix         result     = DenseMatrix::Zero(n, n);
    std::vector<double> column(W.rows());
    for (std::size_t c = 0; c < n_components; ++c)
      for (unsigned int j = 0; j < P.size(); ++j)
        {
          std::fill(column.begin(), column.end(), 0.);
          for (const auto &[k, value] : P[j])
            as_vector(column) += value * W.col(c * n_body_nodes + k);
          for (std::size_t b = 0; b < n_components; ++b)
            for (unsigned int i = 0; i < P.size(); ++i)
              result(b * P.size() + i, c * P.size() + j) =
                apply(P[i], column, b * n_body_nodes);
        }
    return result.selfadjointView<Eigen::Lower>();
  }

  DenseMatrix SurfaceCoupling::to_interface(DenseMatrix W) const
  {
    return turned(is_identity() || W.rows() == 0 ? std::move(W) : projected(W));
  }

  DenseMatrix SurfaceCoupling::turned(DenseMatrix W) const
  {
    const std::size_t n = angles.size(), n_rows = W.rows();
    if (n == 0 || n_rows == 0)
      return W;
    for (std::size_t j = 0; j < n_rows; ++j)
      turn_values(&W(n, j), &W(2 * n, j), 1, false);
    for (std::size_t i = 0; i < n_rows; ++i)
      turn_values(&W(i, n), &W(i, 2 * n), n_rows, false);
    return W.selfadjointView<Eigen::Lower>();
  }
} // namespace RollingContact
