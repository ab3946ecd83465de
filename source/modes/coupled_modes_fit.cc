#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/modes/coupled_modes_fit.h>

#include <algorithm>
#include <limits>

namespace RollingContact
{
  namespace
  {
    /// modes to begin with, and their damping ratio
    const unsigned int first_modes   = 16;
    const double       first_damping = 0.2;

    /// bounds of damping ratios, and of frequencies over those of the fit
    const std::array<double, 2> dampings{{2e-4, 5.}}, reaches{{0.3, 4.}};

    /// damping ratios that a new mode is tried with, and where: frequencies off
    /// the largest difference, in units of the damping ratio
    const std::array<double, 5> tried{{0.001, 0.003, 0.01, 0.03, 0.1}},
      offsets{{-2., -1., 0., 1., 2.}};

    const unsigned int steps_to_begin = 30, steps_of_one = 6;

    /// of the squares, below which a step is the last
    const double small_gain = 1e-3;

    /// longest step of the logarithm of a frequency or damping ratio
    const double longest_step = 0.3;

    /// of the largest difference, what a new mode leaves of it at most, and how
    /// far around no other is tried: of ln omega
    const double useful = 0.9, around = 0.02;

    /// damping ratio over the distance of frequencies of ln omega
    const double resolved = 0.7;

    /// of the receptance, below which what it loses counts less
    const double least_loss = 0.05;

    const double weight_below = 0.3;
  } // namespace

  CoupledModesFit::CoupledModesFit(
    const std::vector<double>        &frequencies,
    const std::vector<ComplexMatrix> &receptances,
    const ModalFitControls           &controls)
    : controls(controls)
    , n_motions(receptances.front().rows())
    , n_points(frequencies.size())
    , bounds{{std::log(2 * pi * controls.lowest * reaches[0]),
              std::log(2 * pi * frequencies.back() * reaches[1])}}
    , s(n_points)
    , values(n_points, n_motions * (n_motions + 1) / 2)
    , weights(n_points, values.cols())
    , losses(n_points, values.cols())
    , given_up(Eigen::VectorXd::Zero(n_points))
  {
    for (Eigen::Index i = 0; i < n_points; ++i)
      {
        s[i]                = Complex(0., 2 * pi * frequencies[i]);
        Eigen::Index column = 0;
        for (Eigen::Index a = 0; a < n_motions; ++a)
          for (Eigen::Index b = a; b < n_motions; ++b)
            values(i, column++) = receptances[i](a, b) * times(a, b);
        const double weight =
          frequencies[i] < controls.lowest ? weight_below : 1.;
        column = 0;
        for (Eigen::Index a = 0; a < n_motions; ++a)
          for (Eigen::Index b = a; b < n_motions; ++b, ++column)
            {
              const std::complex<double> own_a = receptances[i](a, a),
                                         own_b = receptances[i](b, b);
              const double size  = std::sqrt(std::abs(own_a) * std::abs(own_b)),
                           loss  = std::sqrt(std::abs(own_a.imag()) *
                                            std::abs(own_b.imag()));
              weights(i, column) = weight / size;
              losses(i, column)  = weight / std::max(loss, least_loss * size);
            }
      }
    begin();
  }

  void CoupledModesFit::run()
  {
    adapt(steps_to_begin);
    while (worst > controls.tolerance &&
           parameters.rows() < controls.most_modes)
      {
        controls.interrupt();
        const double       before = worst;
        const Eigen::Index at     = worst_at;
        const DenseMatrix  kept   = parameters;
        add_one();
        adapt(steps_of_one);
        if (differences[at] > useful * before)
          {
            // what modes cannot do there more of them cannot do either
            parameters = kept;
            given_up   = given_up.cwiseMax(
              ((s.array().imag().log() - std::log(s[at].imag())).abs() < around)
                .select(Eigen::VectorXd::Ones(n_points), 0.));
            residual();
          }
      }
    adapt(steps_to_begin);
  }

  DenseMatrix CoupledModesFit::rest() const
  {
    const DenseMatrix parts = parameters.topRightCorner(n_motions, n_motions);
    return parts.transpose() * parts;
  }

  void CoupledModesFit::begin()
  {
    const double highest = bounds[1] - std::log(reaches[1]),
                 step    = (highest - bounds[0]) / (first_modes - 1);
    parameters = DenseMatrix::Zero(n_motions + first_modes, 2 + n_motions);
    parameters.topRightCorner(n_motions, n_motions) =
      std::sqrt(values.row(n_points - 1).norm()) *
      DenseMatrix::Identity(n_motions, n_motions);
    for (unsigned int j = 0; j < first_modes; ++j)
      {
        auto row = parameters.row(n_motions + j);
        row[0]   = bounds[0] + j * step;
        row[1]   = std::log(first_damping);
        Eigen::Index nearest;
        (s.array().imag().log() - row[0]).abs().minCoeff(&nearest);
        row.tail(n_motions) =
          leading(-2 / pi * step * values.row(nearest).imag());
      }
  }

  Eigen::RowVectorXd
  CoupledModesFit::leading(const Eigen::RowVectorXd &entries) const
  {
    DenseMatrix  A(n_motions, n_motions);
    Eigen::Index column = 0;
    for (Eigen::Index a = 0; a < n_motions; ++a)
      for (Eigen::Index b = a; b < n_motions; ++b)
        A(a, b) = A(b, a) = entries[column++] / times(a, b);
    const double least  = 1e-6 * A.norm();
    const auto   values = symmetric_eigenpairs(A);
    return std::sqrt(std::max(values.back(), least)) *
           A.col(n_motions - 1).transpose();
  }

  ComplexMatrix CoupledModesFit::answers() const
  {
    ComplexMatrix h(n_points, parameters.rows());
    for (Eigen::Index j = 0; j < parameters.rows(); ++j)
      h.col(j) =
        j < n_motions
          ? ComplexVector(
              (1. + controls.retardation * s.array()).inverse().matrix())
          : answer(parameters(j, 0), parameters(j, 1));
    return h;
  }

  ComplexVector CoupledModesFit::answer(const double ln_omega,
                                        const double ln_zeta) const
  {
    const double w = std::exp(ln_omega), damping = std::exp(ln_zeta);
    return w * w *
           (s.array().square() + 2 * damping * w * s.array() + w * w)
             .inverse()
             .matrix();
  }

  ComplexMatrix CoupledModesFit::products() const
  {
    ComplexMatrix result(parameters.rows(), values.cols());
    Eigen::Index  column = 0;
    for (Eigen::Index a = 0; a < n_motions; ++a)
      for (Eigen::Index b = a; b < n_motions; ++b)
        result.col(column++) =
          (times(a, b) *
           parameters.col(2 + a).cwiseProduct(parameters.col(2 + b)))
            .cast<Complex>();
    return result;
  }

  Eigen::VectorXd CoupledModesFit::residual()
  {
    const ComplexMatrix E = weighted(fit() - values);
    differences           = E.rowwise().norm();
    worst = differences.cwiseProduct((1. - given_up.array()).matrix())
              .maxCoeff(&worst_at);
    Eigen::VectorXd result(2 * E.size());
    result << E.real().reshaped(), E.imag().reshaped();
    return result;
  }

  DenseMatrix CoupledModesFit::derivatives() const
  {
    const Eigen::Index  n_rows = values.size(), width = 2 + n_motions;
    const ComplexMatrix h = answers(), p = products();
    DenseMatrix         J   = DenseMatrix::Zero(2 * n_rows, parameters.size());
    const auto          set = [&](const Eigen::Index   parameter,
                         const Eigen::Index   entry,
                         const ComplexVector &column) {
      J.col(parameter).segment(entry * n_points, n_points) =
        weights.col(entry).cwiseProduct(column.real());
      J.col(parameter).segment(n_rows + entry * n_points, n_points) =
        losses.col(entry).cwiseProduct(column.imag());
    };
    for (Eigen::Index j = 0; j < parameters.rows(); ++j)
      {
        const ComplexVector answer = h.col(j);
        Eigen::Index        entry  = 0;
        for (Eigen::Index a = 0; a < n_motions; ++a)
          for (Eigen::Index b = a; b < n_motions; ++b, ++entry)
            {
              set(j * width + 2 + a,
                  entry,
                  answer *
                    (times(a, b) * parameters(j, 2 + b) * (a == b ? 2. : 1.)));
              if (a != b)
                set(j * width + 2 + b,
                    entry,
                    answer * (times(a, b) * parameters(j, 2 + a)));
            }
        if (j < n_motions)
          continue;
        const double w                 = std::exp(parameters(j, 0)),
                     damping           = std::exp(parameters(j, 1));
        const auto            friction = 2 * damping * w * s.array();
        const Eigen::ArrayXcd scaled   = h.col(j).array() / (w * w);
        const ComplexVector   by_omega = answer.array() *
                                       (2. - scaled * (friction + 2 * w * w)),
                            by_zeta = -answer.array() * scaled * friction;
        for (entry = 0; entry < values.cols(); ++entry)
          {
            set(j * width, entry, by_omega * p(j, entry));
            set(j * width + 1, entry, by_zeta * p(j, entry));
          }
      }
    return J;
  }

  void CoupledModesFit::adapt(const unsigned int most_steps)
  {
    double          trust = 1e-2;
    Eigen::VectorXd r     = residual();
    for (unsigned int step = 0; step < most_steps; ++step)
      {
        const DenseMatrix     J      = derivatives();
        const DenseMatrix     normal = J.transpose() * J;
        const Eigen::VectorXd slope  = J.transpose() * r;
        const double          before = r.squaredNorm();
        const DenseMatrix     kept   = parameters;
        bool                  better = false;
        for (unsigned int k = 0; k < 8 && !better; ++k)
          {
            parameters = kept + change(normal, slope, trust);
            keep_in_bounds();
            const Eigen::VectorXd next = residual();
            better                     = next.squaredNorm() < before;
            if (better)
              r = next;
            else
              trust *= 4;
          }
        if (!better)
          {
            parameters = kept;
            r          = residual();
            return;
          }
        trust = std::max(trust / 4, 1e-7);
        if (before - r.squaredNorm() < small_gain * before)
          return;
      }
  }

  DenseMatrix CoupledModesFit::change(const DenseMatrix     &normal,
                                      const Eigen::VectorXd &slope,
                                      const double           trust) const
  {
    DenseMatrix damped = normal;
    damped.diagonal()  = (1 + trust) * normal.diagonal().array() +
                        1e-10 * normal.diagonal().maxCoeff();
    DenseMatrix right = -slope;
    if (!solve_positive_definite(damped, right))
      return DenseMatrix::Zero(parameters.rows(), parameters.cols());
    DenseMatrix step =
      right.reshaped(parameters.cols(), parameters.rows()).transpose();
    step.leftCols(2) =
      step.leftCols(2).cwiseMax(-longest_step).cwiseMin(longest_step);
    return step;
  }

  void CoupledModesFit::keep_in_bounds()
  {
    parameters.col(0) =
      parameters.col(0).cwiseMax(bounds[0]).cwiseMin(bounds[1]);
    for (Eigen::Index j = n_motions; j < parameters.rows(); ++j)
      parameters(j, 1) = std::clamp(parameters(j, 1),
                                    std::log(sharpest(parameters(j, 0))),
                                    std::log(dampings[1]));
  }

  double CoupledModesFit::sharpest(const double ln_omega) const
  {
    const auto after =
      std::lower_bound(s.begin() + 1,
                       s.end() - 1,
                       std::exp(ln_omega),
                       [](const Complex &a, const double omega) {
                         return a.imag() < omega;
                       });
    return std::max(dampings[0],
                    resolved * std::log(after->imag() / (after - 1)->imag()));
  }

  void CoupledModesFit::add_one()
  {
    const ComplexMatrix E      = values - fit();
    const double        middle = std::log(s[worst_at].imag());
    double              best   = std::numeric_limits<double>::max();
    Eigen::RowVectorXd  row    = Eigen::RowVectorXd::Zero(2 + n_motions);
    for (const double damping : tried)
      {
        const Eigen::VectorXd near =
          ((s.array().imag().log() - middle).abs() <
           std::max(4 * damping, 0.02))
            .select(Eigen::VectorXd::Ones(n_points), 0.);
        const DenseMatrix off = parts_of(E, near);
        for (const double shift : offsets)
          {
            const double             at  = middle + shift * damping;
            const ComplexVector      h   = answer(at, std::log(damping));
            const Eigen::VectorXd    own = parts_of(h, near).col(0);
            const Eigen::RowVectorXd v =
              leading(own.transpose() * off / own.squaredNorm());
            const double left =
              (off - own * entries_of(v)).squaredNorm() / off.squaredNorm();
            if (left < best)
              {
                best                = left;
                row[0]              = at;
                row[1]              = std::log(damping);
                row.tail(n_motions) = v;
              }
          }
      }
    parameters.conservativeResize(parameters.rows() + 1, Eigen::NoChange);
    parameters.bottomRows(1) = row;
    keep_in_bounds();
  }

  DenseMatrix CoupledModesFit::parts_of(const ComplexMatrix   &E,
                                        const Eigen::VectorXd &near) const
  {
    DenseMatrix result(2 * E.rows(), E.cols());
    // of a single column the first weights
    result << near.asDiagonal() *
                weights.leftCols(E.cols()).cwiseProduct(E.real()),
      near.asDiagonal() * losses.leftCols(E.cols()).cwiseProduct(E.imag());
    return result;
  }

  Eigen::RowVectorXd
  CoupledModesFit::entries_of(const Eigen::RowVectorXd &v) const
  {
    Eigen::RowVectorXd result(values.cols());
    Eigen::Index       column = 0;
    for (Eigen::Index a = 0; a < n_motions; ++a)
      for (Eigen::Index b = a; b < n_motions; ++b)
        result[column++] = times(a, b) * v[a] * v[b];
    return result;
  }
} // namespace RollingContact
