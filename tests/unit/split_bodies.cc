#include <boost/test/unit_test.hpp>

#include <rolling_contact/bodies/half_space_influence.h>
#include <rolling_contact/bodies/moment_fields.h>

#include <cmath>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(split_bodies)

namespace
{
  Material steel()
  {
    Material material;
    material.young_modulus = 210e9;
    material.poisson_ratio = 0.3;
    return material;
  }

  /**
   * Surface displacement at (x, y) by unit point forces at the origin, row by
   * column, by the formulas of Boussinesq and Cerruti at z = 0.
   */
  Eigen::Matrix3d point_forces(const double x, const double y)
  {
    const double G = steel().shear_modulus(), nu = 0.3, r = std::hypot(x, y),
                 k = 1 / (2 * std::acos(-1.) * G), c = k / 2 * (1 - 2 * nu);
    Eigen::Matrix3d W;
    W << (1 - nu) / r + nu * x * x / std::pow(r, 3),
      nu * x * y / std::pow(r, 3),
      c / k * x / (r * r), //
      nu * x * y / std::pow(r, 3), (1 - nu) / r + nu * y * y / std::pow(r, 3),
      c / k * y / (r * r), //
      -c / k * x / (r * r), -c / k * y / (r * r), (1 - nu) / r;
    return k * W;
  }
} // namespace

/**
 * Closed forms against a hat of 160 000 point forces.
 */
BOOST_AUTO_TEST_CASE(hats_are_sums_of_point_forces)
{
  const std::array<double, 2> size{{1e-3, 0.7e-3}};
  const HalfSpaceInfluence    hats(steel(), size);
  const int                   n = 200;
  for (const auto &at : std::vector<std::array<int, 2>>{{{1, 0}},
                                                        {{0, 1}},
                                                        {{3, 2}},
                                                        {{-3, 2}},
                                                        {{3, -2}},
                                                        {{-4, 0}},
                                                        {{0, -5}}})
    {
      const double    x = at[0] * size[0], y = at[1] * size[1];
      Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
      for (int i = 0; i < 2 * n; ++i)
        for (int j = 0; j < 2 * n; ++j)
          {
            const double s = (i + 0.5) / n - 1, t = (j + 0.5) / n - 1;
            sum += (1 - std::abs(s)) * (1 - std::abs(t)) / (n * n) *
                   point_forces(x - s * size[0], y - t * size[1]);
          }
      BOOST_TEST((hats.at(x, y) - sum).cwiseAbs().maxCoeff() <
                 2e-5 * sum.cwiseAbs().maxCoeff());
    }
  // on its own node a mean of 1/r over the hat, by polar rings
  BOOST_TEST(hats.at(0., 0.)(0, 2) == 0.);
  BOOST_TEST(hats.at(0., 0.)(2, 2) > hats.at(size[0], 0.)(2, 2));
}

BOOST_AUTO_TEST_CASE(half_spaces_are_symmetric_and_positive)
{
  std::vector<std::array<double, 2>> at;
  for (int i = 0; i < 9; ++i)
    for (int j = 0; j < 7; ++j)
      at.push_back({{1e-3 * (i - 0.3), 0.7e-3 * j}});
  const DenseMatrix W =
    HalfSpaceInfluence(steel(), {{1e-3, 0.7e-3}}).compliance(at, {0, 1, 2});
  BOOST_TEST((W - W.transpose()).cwiseAbs().maxCoeff() <
             1e-12 * W.cwiseAbs().maxCoeff());
  const Eigen::VectorXd some = Eigen::VectorXd::Random(W.rows());
  BOOST_TEST(some.dot(W * some) > 0.);
  const DenseMatrix normal =
    HalfSpaceInfluence(steel(), {{1e-3, 0.7e-3}}).compliance(at, {2});
  BOOST_TEST((W.bottomRightCorner(at.size(), at.size()) - normal).norm() == 0.);
}

/**
 * Fields of moments are derivatives of those of forces, gradients those of
 * displacements, and at the surface the forces' are Boussinesq's and Cerruti's.
 */
BOOST_AUTO_TEST_CASE(fields_of_moments_are_derivatives)
{
  const dealii::Point<3> at(0.011, -0.006, -0.009);
  const auto            &moments = force_moments();
  const auto             fields  = moment_fields(at, steel());
  const double           step    = 1e-6;
  for (unsigned int l = 0; l < 3; ++l)
    {
      dealii::Point<3> before = at, after = at;
      before[l] -= step;
      after[l] += step;
      const auto below = moment_fields(before, steel()),
                 above = moment_fields(after, steel());
      for (std::size_t m = 0; m < fields.size(); ++m)
        {
          const auto slope = (above[m].value - below[m].value) / (2 * step);
          for (unsigned int k = 0; k < 3; ++k)
            BOOST_TEST(std::abs(slope[k] - fields[m].gradient[k][l]) <
                       1e-6 * fields[m].gradient.norm());
          for (std::size_t n = 0; n < fields.size() && l < 2; ++n)
            if (moments[n].component == moments[m].component &&
                moments[n].i == moments[m].i + (l == 0) &&
                moments[n].j == moments[m].j + (l == 1))
              BOOST_TEST((fields[n].value + slope).norm() <
                         1e-6 * fields[n].value.norm());
        }
    }
  const auto at_surface =
    moment_fields(dealii::Point<3>(0.011, -0.006, 0.), steel());
  const Eigen::Matrix3d expected = point_forces(0.011, -0.006);
  for (unsigned int c = 0; c < 3; ++c)
    for (unsigned int k = 0; k < 3; ++k)
      BOOST_TEST(std::abs(at_surface[c].value[k] - expected(k, c)) <
                 1e-12 * expected.norm());
}

BOOST_AUTO_TEST_SUITE_END()
