#include <deal.II/lac/vector.h>

#include <boost/test/unit_test.hpp>

#include "vibrating_pair.h"

#include <algorithm>
#include <cmath>

using namespace RollingContact;
using namespace VibratingPair;

/** Vibrations of bodies whose compliance is split, on meshes that do not know
 * the patch, against those of finite elements refined to it. */
BOOST_AUTO_TEST_SUITE(split_vibration)

namespace
{
  using Complex = std::complex<double>;

  /** A disc on a block whose edges are far from a sliding patch. */
  Change pair_with(const Compliance compliance)
  {
    return [=](SceneParameters &scene) {
      unstable_pair(scene);
      scene.wheel.width = 0.05;
      scene.rail.width  = 0.05;
      scene.contact.approach.reset();
      scene.contact.normal_load        = 600.;
      scene.mesh.growth                = 0.8;
      scene.mesh.compliance            = compliance;
      scene.mesh.elements_across_patch = 8;
      scene.contact.creepages.y        = -0.02;
      // well beyond the onset, where growth is not the difference of two modes
      scene.contact.friction_coefficient = 0.5;
    };
  }

  const double cut_off = 12000.; // Hz

  /** Nodal forces that are nowhere alike. */
  ComplexVector any_forces(const Eigen::Index n)
  {
    ComplexVector forces(n);
    for (Eigen::Index i = 0; i < n; ++i)
      forces[i] = std::polar(1. + 0.3 * std::sin(1.7 * i), 0.4 * std::sin(i));
    return forces;
  }
} // namespace

BOOST_AUTO_TEST_CASE(whole_bodies_at_rest_have_the_static_compliance)
{
  Eigenvalues<3> split(pair_with(Compliance::split), cut_off);
  BOOST_TEST_REQUIRE(split.steady.pair->bodies().is_split());
  const DenseMatrix   W      = split.steady.problem.operators.W().dense();
  const ComplexVector forces = any_forces(W.rows()),
                      u = split.whole->response({Complex(1e-6)}, {forces})[0];
  BOOST_TEST((u - W * forces).norm() < 1e-7 * u.norm());
}

BOOST_AUTO_TEST_CASE(modes_and_whole_bodies_answer_alike)
{
  Eigenvalues<3>      split(pair_with(Compliance::split), cut_off);
  const auto          n      = split.steady.problem.operators.W().rows();
  const ComplexVector forces = any_forces(n);
  for (const double f : {500., 1500., 3000.})
    {
      const Complex       s(-5., 2 * pi * f);
      const ComplexVector whole = split.whole->response({s}, {forces})[0],
                          modes = reduced_response(split.reduced, s, forces);
      BOOST_TEST((whole - modes).norm() < 2e-3 * whole.norm());
    }
}

BOOST_AUTO_TEST_CASE(vibrations_are_those_of_finite_elements)
{
  const auto least_damped = [](const Compliance compliance) {
    const Eigenvalues<3> pair(pair_with(compliance), cut_off);
    ComplexValues        found;
    for (const auto &s :
         StabilityPencil(pair.reduced, pair.contact).eigenvalues())
      if (s.imag() > 2 * pi * 1300 && s.imag() < 2 * pi * 2100 &&
          s.real() > -22)
        found.push_back(s);
    std::sort(found.begin(), found.end(), [](const auto &a, const auto &b) {
      return a.imag() < b.imag();
    });
    return found;
  };
  const ComplexValues split    = least_damped(Compliance::split),
                      elements = least_damped(Compliance::finite_elements);
  BOOST_TEST_REQUIRE(elements.size() >= 4u);
  for (const auto &s : elements)
    {
      const auto nearest =
        *std::min_element(split.begin(), split.end(), [&](auto a, auto b) {
          return std::abs(a - s) < std::abs(b - s);
        });
      BOOST_TEST_MESSAGE("elements " << s << ", split " << nearest);
      // the one that grows does as the contact is stiff
      const bool grows = s.real() > 0.;
      BOOST_TEST(std::abs(nearest.real() / s.real() - 1) <
                 (grows ? 0.07 : 0.025));
      BOOST_TEST(std::abs(nearest.imag() / s.imag() - 1) <
                 (grows ? 0.01 : 0.003));
    }
}

BOOST_AUTO_TEST_SUITE_END()
