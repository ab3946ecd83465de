#include <Eigen/LU>

#include <rolling_contact/references/checks.h>
#include <rolling_contact/references/layered_plane.h>

#include <cmath>

namespace RollingContact::References
{
  namespace
  {
    using Matrix2 = Eigen::Matrix2d;
    using Matrix4 = Eigen::Matrix4d;

    double shear_modulus(const double young_modulus, const double poisson_ratio)
    {
      return young_modulus / (2 * (1 + poisson_ratio));
    }

    /**
     * exp(A H - H) of u_x, u_z and of sigma_xz and sigma_zz over G k, of which
     * those in phase with sin kx and cos kx are u_x, sigma_xz and u_z,
     * sigma_zz.
     */
    Matrix4 transfer(const double poisson_ratio, const double H)
    {
      const double nu = poisson_ratio, m = nu / (1 - nu),
                   g = (1 - 2 * nu) / (2 * (1 - nu));
      Matrix4 A;
      A << 0, 1, 1, 0,         //
        -m, 0, 0, g,           //
        2 / (1 - nu), 0, 0, m, //
        0, 0, -1, 0;
      const double fall = std::exp(-2 * H), cosh = (1 + fall) / 2,
                   sinh = -std::expm1(-2 * H) / 2, scale = std::exp(-H);
      // the last is small by cancellation: its series where H is small
      const double  cubic  = H < 0.05 ? scale * H * H * H / 6 * (1 + H * H / 10)
                                      : (H * cosh - sinh) / 2;
      const Matrix4 square = A * A;
      return (cosh - H * sinh / 2) * Matrix4::Identity() + (sinh - cubic) * A +
             H * sinh / 2 * square + cubic * square * A;
    }
  } // namespace

  SurfaceCompliance half_plane_compliance(const double young_modulus,
                                          const double poisson_ratio)
  {
    check_elasticity(young_modulus, poisson_ratio);
    const double nu = poisson_ratio, both = 2 * (1 - nu * nu) / young_modulus;
    return {both, both, -(1 + nu) * (1 - 2 * nu) / young_modulus};
  }

  SurfaceCompliance compliance(const LayeredPlane &plane,
                               const double        wave_number)
  {
    check_positive("Wave number", wave_number, "1/m");
    check_not_negative("Thickness of the layer", plane.thickness, "m");
    const double            H = wave_number * plane.thickness;
    const SurfaceCompliance core =
      half_plane_compliance(plane.core_young_modulus, plane.core_poisson_ratio);
    if (H == 0.)
      return core;
    const SurfaceCompliance surface =
      half_plane_compliance(plane.young_modulus, plane.poisson_ratio);
    const double deep = 40.; // k h, from where the core is not felt
    if (H > deep)
      return surface;
    const double  G = shear_modulus(plane.young_modulus, plane.poisson_ratio);
    const Matrix4 T = transfer(plane.poisson_ratio, H);
    // at the core (u_x, u_z) k = -M (sigma_xz, sigma_zz)
    Matrix2 M;
    M << core.tangential, core.coupling, core.coupling, core.normal;
    const Eigen::Matrix<double, 2, 4> left =
      T.topRows<2>() + G * M * T.bottomRows<2>();
    const Matrix2 C = left.leftCols<2>().inverse() * left.rightCols<2>() / G;
    return {C(1, 1), C(0, 0), (C(0, 1) + C(1, 0)) / 2};
  }
} // namespace RollingContact::References
