#include <rolling_contact/wheelset/hunting.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  std::vector<std::complex<double>>
  Hunting::eigenvalues(const double speed) const
  {
    // y, psi, y', psi', omega; omega = - excess V / r0
    const Derivatives           G = axle_load * derivatives;
    Eigen::Matrix<double, 5, 5> A = Eigen::Matrix<double, 5, 5>::Zero();
    A(0, 2) = A(1, 3)      = 1.;
    const double inertia[] = {wheelset.mass,
                              wheelset.yaw_inertia,
                              wheelset.axle_inertia};
    for (unsigned int i = 0; i < 3; ++i)
      {
        const unsigned int row = 2 + i;
        A(row, 0)              = G(i, 0);
        A(row, 1)              = G(i, 1);
        A(row, 2)              = G(i, 3) / speed;
        A(row, 3)              = G(i, 4) / speed;
        A(row, 4)              = -G(i, 2) * radius / speed;
      }
    A(2, 0) -= wheelset.lateral_stiffness;
    A(2, 2) -= wheelset.lateral_damping;
    A(3, 3) -= wheelset.yaw_damping;
    for (unsigned int i = 0; i < 3; ++i)
      A.row(2 + i) /= inertia[i];
    const auto found =
      Eigen::EigenSolver<Eigen::Matrix<double, 5, 5>>(A, false).eigenvalues();
    std::vector<std::complex<double>> all(found.data(), found.data() + 5);
    std::sort(all.begin(), all.end(), [](const auto &a, const auto &b) {
      return a.real() != b.real() ? a.real() > b.real() : a.imag() > b.imag();
    });
    return all;
  }

  std::optional<double> Hunting::critical_speed(const double most) const
  {
    const auto grows = [&](const double speed) {
      return eigenvalues(speed).front().real() > 0.;
    };
    const unsigned int n    = 400;
    double             last = most / n;
    if (grows(last))
      return 0.;
    for (unsigned int k = 2; k <= n; ++k)
      {
        double next = most * k / n;
        if (grows(next))
          {
            while (next - last > 1e-6 * next)
              (grows((last + next) / 2) ? next : last) = (last + next) / 2;
            return next;
          }
        last = next;
      }
    return {};
  }
} // namespace RollingContact
