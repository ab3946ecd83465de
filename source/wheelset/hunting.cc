#include <rolling_contact/wheelset/hunting.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  Hunting::Forces Hunting::forces(const double speed) const
  {
    const HuntingWheelset &wheelset = vehicle.hunting;
    const unsigned int     n = derivatives.size(), at_frame = 2 * n,
                       n_q = vehicle.is_bogie ? 2 * n + 2 : 2 * n;
    Forces by{Eigen::MatrixXd::Zero(n_q, n_q), Eigen::MatrixXd::Zero(n_q, n_q)};
    const BogieFrame frame(vehicle);
    for (unsigned int i = 0; i < n; ++i)
      {
        const Derivatives G      = vehicle.axle_load * derivatives[i];
        auto              places = by.of_places.block<2, 2>(2 * i, 2 * i),
             velocities          = by.of_velocities.block<2, 2>(2 * i, 2 * i);
        places                   = G.topLeftCorner<2, 2>();
        velocities               = G.block<2, 2>(0, 3) / speed;
        velocities(0, 0) -= wheelset.lateral_damping;
        velocities(1, 1) -= wheelset.yaw_damping;
        if (!vehicle.is_bogie)
          {
            places(0, 0) -= wheelset.lateral_stiffness;
            continue;
          }
        const Eigen::Matrix2d spring                  = frame.coupling(i),
                              dashpot                 = frame.coupling(i,
                                                       wheelset.lateral_damping,
                                                       wheelset.yaw_damping);
        by.of_places.block<2, 2>(2 * i, at_frame)     = spring;
        by.of_places.block<2, 2>(at_frame, 2 * i)     = spring.transpose();
        by.of_velocities.block<2, 2>(2 * i, at_frame) = dashpot;
        by.of_velocities.block<2, 2>(at_frame, 2 * i) = dashpot.transpose();
      }
    if (vehicle.is_bogie)
      {
        auto places     = by.of_places.bottomRightCorner<2, 2>();
        auto velocities = by.of_velocities.bottomRightCorner<2, 2>();
        places          = frame.own();
        velocities = frame.own(wheelset.lateral_damping, wheelset.yaw_damping);
        places(0, 0) -= vehicle.frame.lateral_stiffness;
        velocities(0, 0) -= vehicle.frame.lateral_damping;
        velocities(1, 1) -= vehicle.frame.yaw_damping;
      }
    return by;
  }

  std::vector<std::complex<double>>
  Hunting::eigenvalues(const double speed) const
  {
    // places, velocities, and omega of each axle; omega = - excess V / r0
    const Forces       by = forces(speed);
    const unsigned int n = derivatives.size(), n_q = by.of_places.rows(),
                       n_all = 2 * n_q + n;
    Eigen::MatrixXd A        = Eigen::MatrixXd::Zero(n_all, n_all);
    A.block(0, n_q, n_q, n_q).setIdentity();
    A.block(n_q, 0, n_q, n_q)   = by.of_places;
    A.block(n_q, n_q, n_q, n_q) = by.of_velocities;
    Eigen::VectorXd inertia     = Eigen::VectorXd::Ones(n_all);
    for (unsigned int i = 0; i < n; ++i)
      {
        const Derivatives  G    = vehicle.axle_load * derivatives[i];
        const unsigned int axle = 2 * n_q + i;
        A.block<2, 1>(n_q + 2 * i, axle) =
          -G.block<2, 1>(0, 2) * radius / speed;
        A.block<1, 2>(axle, 2 * i)       = G.block<1, 2>(2, 0);
        A.block<1, 2>(axle, n_q + 2 * i) = G.block<1, 2>(2, 3) / speed;
        A(axle, axle)                    = -G(2, 2) * radius / speed;
        inertia.segment<2>(n_q + 2 * i) << vehicle.hunting.mass,
          vehicle.hunting.yaw_inertia;
        inertia[axle] = vehicle.hunting.axle_inertia;
      }
    if (vehicle.is_bogie)
      inertia.segment<2>(2 * n_q - 2) << vehicle.frame.mass,
        vehicle.frame.yaw_inertia;
    A = inertia.cwiseInverse().asDiagonal() * A;
    const auto found =
      Eigen::EigenSolver<Eigen::MatrixXd>(A, false).eigenvalues();
    std::vector<std::complex<double>> all(found.data(),
                                          found.data() + found.size());
    std::sort(all.begin(), all.end(), [](const auto &a, const auto &b) {
      return a.real() != b.real() ? a.real() > b.real() : a.imag() > b.imag();
    });
    return all;
  }

  bool Hunting::grows(const std::vector<std::complex<double>> &eigenvalues)
  {
    double largest = 0.;
    for (const auto &value : eigenvalues)
      largest = std::max(largest, std::abs(value));
    const auto first = eigenvalues.front();
    return first.real() > 1e-9 * std::abs(first) + 1e-13 * largest;
  }

  std::optional<double> Hunting::critical_speed(const double most) const
  {
    const unsigned int n    = 400;
    double             last = most / n;
    if (grows(eigenvalues(last)))
      return 0.;
    for (unsigned int k = 2; k <= n; ++k)
      {
        double next = most * k / n;
        if (grows(eigenvalues(next)))
          {
            while (next - last > 1e-6 * next)
              (grows(eigenvalues((last + next) / 2)) ? next : last) =
                (last + next) / 2;
            return next;
          }
        last = next;
      }
    return {};
  }
} // namespace RollingContact
