#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/stability/reduced_pair.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    void check_size(const DenseMatrix &M,
                    const std::string &name,
                    const Eigen::Index n_rows,
                    const Eigen::Index n_columns)
    {
      if (M.rows() != n_rows || M.cols() != n_columns)
        throw InputError(
          name + " of the reduced bodies has " + std::to_string(M.rows()) +
          " x " + std::to_string(M.cols()) + " entries; it needs " +
          std::to_string(n_rows) + " x " + std::to_string(n_columns) + ".");
      if (!M.allFinite())
        throw InputError(name + " of the reduced bodies has an entry that is "
                                "no number.");
    }
  } // namespace

  void check(const ReducedPair &pair)
  {
    const std::size_t m = pair.n_modes(), n = pair.W_res.rows();
    check_size(pair.K_m, "The stiffness", m, m);
    check_size(pair.C_m, "The damping", m, m);
    check_size(pair.Phi, "The modes at the contact", n, m);
    check_size(pair.W_res, "The residual compliance", n, n);
    if (pair.n_wheel_modes > m)
      throw InputError("There are " + std::to_string(pair.n_wheel_modes) +
                       " modes of the wheel, more than the " +
                       std::to_string(m) + " of both bodies.");
    if (!(pair.retardation >= 0.) || !std::isfinite(pair.retardation))
      throw InputError("The retardation time of the bodies is " +
                       significant(pair.retardation, 6) +
                       " s; it must be >= 0 s.");
    if (n == 0)
      return;

    const std::vector<double> values  = symmetric_eigenvalues(pair.W_res);
    const double              largest = values.back();
    const double              skew =
      (pair.W_res - pair.W_res.transpose()).lpNorm<Eigen::Infinity>();
    if (skew > 1e-8 * std::abs(largest))
      throw InputError("The residual compliance is not symmetric: entries "
                       "differ by " +
                       significant(skew, 3) + " m/N from their mirror image.");
    if (values.front() < -1e-10 * std::max(largest, 0.))
      throw InputError(
        "The residual compliance of the bodies has a negative eigenvalue, " +
        significant(values.front(), 3) + " m/N, where its largest is " +
        significant(largest, 3) +
        " m/N; at least -1e-10 of that is allowed. Modes and compliance must "
        "come from the same stiffness matrix.");
  }

  ReducedPair at_nodes(const ReducedPair &pair, const SurfaceCoupling &coupling)
  {
    ReducedPair result      = pair;
    result.W_res            = coupling.to_interface(pair.W_res);
    const auto at_interface = [&](const DenseMatrix &motions) {
      DenseMatrix moved(result.W_res.rows(), motions.cols());
      for (Eigen::Index j = 0; j < motions.cols(); ++j)
        moved.col(j) = as_vector(coupling.to_interface(column_of(motions, j)));
      return moved;
    };
    result.Phi = at_interface(pair.Phi);
    if (pair.watched.size() > 0)
      result.watched = at_interface(pair.watched);
    return result;
  }

  std::vector<double> CondensedPair::expanded(const std::vector<double> &values,
                                              const std::size_t n_modes) const
  {
    std::vector<double> all(n_modes, 0.);
    for (std::size_t k = 0; k < kept.size(); ++k)
      all[kept[k]] = values[k];
    return all;
  }

  CondensedPair condensed(const ReducedPair &pair, const double highest)
  {
    CondensedPair             result;
    std::vector<unsigned int> fast;
    for (unsigned int k = 0; k < pair.n_modes(); ++k)
      (pair.K_m(k, k) > highest * highest ? fast : result.kept).push_back(k);
    const std::size_t m    = result.kept.size();
    ReducedPair      &slow = result.pair;
    const auto        part = [&](const DenseMatrix &M) {
      DenseMatrix kept(M.size() == 0 ? 0 : m, M.size() == 0 ? 0 : m);
      for (Eigen::Index i = 0; i < kept.rows(); ++i)
        for (Eigen::Index j = 0; j < kept.cols(); ++j)
          kept(i, j) = M(result.kept[i], result.kept[j]);
      return kept;
    };
    slow.K_m = part(pair.K_m);
    slow.C_m = part(pair.C_m);
    slow.H_m = part(pair.H_m);
    slow.Phi.resize(pair.Phi.rows(), m);
    for (std::size_t k = 0; k < m; ++k)
      slow.Phi.col(k) = pair.Phi.col(result.kept[k]);
    DenseMatrix followers(pair.Phi.rows(), fast.size());
    for (std::size_t k = 0; k < fast.size(); ++k)
      followers.col(k) =
        pair.Phi.col(fast[k]) / std::sqrt(pair.K_m(fast[k], fast[k]));
    slow.W_res         = pair.W_res + followers * followers.transpose();
    slow.retardation   = pair.retardation;
    slow.n_wheel_modes = std::lower_bound(result.kept.begin(),
                                          result.kept.end(),
                                          pair.n_wheel_modes) -
                         result.kept.begin();
    return result;
  }

  void add_rotation(ReducedPair &pair, const DenseMatrix &S, const double rate)
  {
    const std::size_t m = pair.n_modes();
    check_size(S, "The matrix of rotation", m, m);
    pair.K_m += rate * rate * S * S + rate * pair.C_m * S;
    pair.C_m += 2 * rate * S;
  }
} // namespace RollingContact
