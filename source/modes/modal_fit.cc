#include <rolling_contact/base/constants.h>
#include <rolling_contact/modes/coupled_modes_fit.h>
#include <rolling_contact/modes/modal_fit.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /// of a receptance, over the mean of both motions, that couples them
    const double coupling = 3e-3;

    /** Numbers of motions that answer each other's forces, set by set. */
    std::vector<std::vector<Eigen::Index>>
    coupled(const std::vector<ComplexMatrix> &receptances)
    {
      const Eigen::Index n       = receptances.front().rows();
      DenseMatrix        largest = DenseMatrix::Zero(n, n);
      for (const ComplexMatrix &alpha : receptances)
        {
          const Eigen::VectorXd own = alpha.diagonal().cwiseAbs().cwiseSqrt();
          largest                   = largest.cwiseMax(
            alpha.cwiseAbs().cwiseQuotient(own * own.transpose()));
        }
      std::vector<std::vector<Eigen::Index>> sets;
      std::vector<bool>                      taken(n, false);
      for (Eigen::Index first = 0; first < n; ++first)
        {
          if (taken[first])
            continue;
          std::vector<Eigen::Index> set{first};
          taken[first] = true;
          for (std::size_t k = 0; k < set.size(); ++k)
            for (Eigen::Index j = 0; j < n; ++j)
              if (!taken[j] && largest(set[k], j) > coupling)
                {
                  taken[j] = true;
                  set.push_back(j);
                }
          sets.push_back(std::move(set));
        }
      return sets;
    }
  } // namespace

  FittedModes fit_modes(const std::vector<double>        &frequencies,
                        const std::vector<ComplexMatrix> &receptances,
                        const ModalFitControls           &controls)
  {
    const Eigen::Index n      = receptances.front().rows();
    Eigen::VectorXd    scales = Eigen::VectorXd::Zero(n);
    for (const ComplexMatrix &alpha : receptances)
      scales += alpha.diagonal().cwiseAbs().array().log().matrix() /
                (-2. * receptances.size());
    scales = scales.array().exp();
    FittedModes result;
    result.motions.resize(n, 0);
    result.rest = DenseMatrix::Zero(n, n);
    for (const auto &set : coupled(receptances))
      {
        const auto                 units = scales(set);
        std::vector<ComplexMatrix> of_set;
        for (const ComplexMatrix &alpha : receptances)
          of_set.push_back(units.asDiagonal() * alpha(set, set) *
                           units.asDiagonal());
        CoupledModesFit group(frequencies, of_set, controls);
        group.run();
        const Eigen::VectorXd back = units.cwiseInverse();
        result.rest(set, set) =
          back.asDiagonal() * group.rest() * back.asDiagonal();
        for (std::size_t j = 0; j < group.n_modes(); ++j)
          {
            result.frequencies.push_back(group.omega(j) / (2 * pi));
            result.damping_ratios.push_back(group.damping(j));
            result.motions.conservativeResize(Eigen::NoChange,
                                              result.motions.cols() + 1);
            result.motions.rightCols(1).setZero();
            for (std::size_t k = 0; k < set.size(); ++k)
              result.motions(set[k], result.motions.cols() - 1) =
                back[k] * group.motion(j)[k];
          }
        const Eigen::VectorXd &off = group.off();
        for (std::size_t i = 0; i < frequencies.size(); ++i)
          if (frequencies[i] >= controls.lowest && off[i] > result.error)
            {
              result.error    = off[i];
              result.error_at = frequencies[i];
            }
      }
    return result;
  }
} // namespace RollingContact
