#include <deal.II/lac/vector.h>

#include <boost/test/unit_test.hpp>

#include "../references/sliding_half_space.h"
#include "complaint.h"
#include "stability_bodies.h"

#include <rolling_contact/bodies/direct_body.h>
#include <rolling_contact/references/falling_half_spaces.h>

#include <algorithm>

using namespace RollingContact;
using namespace StabilityBodies;

/** A block that slides on a rigid flat: all waves that its mesh can carry. */
BOOST_AUTO_TEST_SUITE(sliding_block)

namespace
{
  const Material steel{210e9, 0.3, 7850.};

  const double sliding_speed = 0.1; ///< m/s

  const double length = 8e-3, depth = 4e-3, patch = 4e-3; ///< m

  /// stiffness-proportional damping over the time a shear wave takes across an
  /// element
  const double damping_time = 0.05;

  double shear_wave_speed()
  {
    return std::sqrt(steel.young_modulus / (2 * (1 + steel.poisson_ratio)) /
                     steel.density);
  }

  /**
   * Damping that takes what runs out of the patch, dashpots of rho c below, as
   * losses of a soft layer, and absorbing ends; and some in the stiffness
   * against waves as short as two elements.
   */
  BodyModel absorbing(const double size)
  {
    const double nu = steel.poisson_ratio, c_2 = shear_wave_speed(),
                 c_1 = c_2 * std::sqrt(2 * (1 - nu) / (1 - 2 * nu));
    BodyModel model;
    model.elements             = ElementKind::enhanced;
    model.foundation.stiffness = {
      {size * steel.density * c_2, 0., size * steel.density * c_1}};
    model.foundation.loss_factor    = 1.;
    model.damping.loss_frequency    = 1 / (2 * pi);
    model.damping.stiffness_damping = damping_time * size / c_2;
    model.damping.sponge_length     = 0.5 * (length - patch);
    model.damping.sponge_rate       = 2 * c_2 / depth;
    return model;
  }

  DenseMatrix dense(const SymmetricSparseMatrix &S,
                    const std::vector<double>   &mass)
  {
    DenseMatrix M = DenseMatrix::Zero(S.size(), S.size());
    for (std::size_t j = 0; j < S.size(); ++j)
      for (auto k = S.column_starts[j]; k < S.column_starts[j + 1]; ++k)
        {
          const std::size_t i = S.row_indices[k];
          M(i, j) = M(j, i) = S.values[k] / std::sqrt(mass[i] * mass[j]);
        }
    return M;
  }

  /**
   * The block with all its unknowns as modes, on a contact that is stiffer than
   * an element by far along its normal.
   */
  struct Block
  {
    explicit Block(const unsigned int elements)
    {
      const double    size = patch / elements;
      ShapeParameters shape;
      shape.section      = "Rail";
      shape.radius       = 0.;
      shape.block_length = length;
      shape.block_depth  = depth;
      shape.hub          = Hub::elastic;
      Grading<2> zone    = Grading<2>::uniform(1.001 * size, 1.001 * size);
      zone.zone_x        = 0.501 * patch;
      DirectBody<2> body(make_body_shape("block", shape),
                         steel,
                         size, // as the contact's
                         zone,
                         true,
                         absorbing(size));
      std::vector<ElasticBody<2>::SurfaceNode> nodes;
      std::vector<ElasticBody<2>::SurfaceFace> faces;
      body.surface(zone, nodes, faces);
      grid = {static_cast<unsigned int>(nodes.size()), 1, size};
      BOOST_TEST(grid.n_x == elements + 1);
      std::vector<double> mass;
      const auto          M = body.mass();
      for (std::size_t j = 0; j < M.size(); ++j)
        mass.push_back(M.values[M.column_starts[j]]);
      pair.K_m            = dense(body.stiffness(), mass);
      pair.C_m            = dense(body.damping_in_time(), mass);
      const auto unknowns = body.unknowns(nodes, {0, 1});
      pair.Phi            = DenseMatrix::Zero(unknowns.size(), mass.size());
      pair.W_res          = DenseMatrix::Zero(unknowns.size(), unknowns.size());
      for (std::size_t i = 0; i < unknowns.size(); ++i)
        {
          pair.Phi(i, unknowns[i]) = -1 / std::sqrt(mass[unknowns[i]]);
          if (i >= nodes.size())
            pair.W_res(i, i) = 1e-3 / (steel.young_modulus * size);
        }
      check(pair);
    }

    /** The eigenvalue of greatest growth, sliding with this friction on a flat
     * that has the form which leaves the pressure (Pa) uniform; with a law, at
     * 0.1 m/s and each node at once. */
    std::complex<double>
    fastest(const double                              mu,
            const double                              pressure = 1e6,
            const std::shared_ptr<const FrictionLaw> &law      = nullptr) const
    {
      const unsigned int n = grid.n_nodes();
      ContactProblem     problem =
        rolling_problem(grid, static_compliance(pair), mu, {1e3, 0., 0.}, 0.);
      problem.loads.friction_law = law;
      problem.loads.speed        = sliding_speed / 1e3;
      const double now   = law ? mu * (1 - law->drop(sliding_speed)) : mu;
      ContactState state = open_state(problem);
      state.pressure.assign(n, pressure);
      state.friction.assign(n, now);
      for (unsigned int i = 0; i < n; ++i)
        state.traction(0, i) = -now * pressure;
      problem.loads.gap.assign(n, 0.);
      std::vector<double> opening = normal_gap(problem, state);
      for (unsigned int i = 0; i < n; ++i)
        problem.loads.gap[i] = -opening[i];
      LinearContactOptions options = at_speed(FrictionResponse::node);
      options.speed                = problem.loads.speed;
      const auto contact           = linear_contact(problem, state, options);
      BOOST_TEST(contact.touching.size() == n);
      BOOST_TEST(contact.n_slip() == n);
      return StabilityPencil(pair, contact).eigenvalues().at(0);
    }

    Grid        grid;
    ReducedPair pair;
  };
} // namespace

BOOST_AUTO_TEST_CASE(unstable_waves_grow_as_fast_as_elements_are_short)
{
  const double nu    = steel.poisson_ratio;
  const auto   waves = References::growing_sliding_waves(1.5, nu);
  BOOST_TEST_REQUIRE(waves.size() == 1u);
  BOOST_TEST(References::growing_sliding_waves(0.6, nu).empty());

  std::vector<double> growths;
  for (const unsigned int n : {8u, 12u})
    {
      const Block block(n);
      BOOST_TEST(block.fastest(0.6).real() < 0.);
      const auto   s    = block.fastest(1.5);
      const double time = patch / n / shear_wave_speed();
      // what a wave of an infinite half-space would have without damping
      const double ratio =
        (s.real() + damping_time * time * std::norm(s) / 2) / s.imag();
      BOOST_TEST_MESSAGE(n << " elements: growth " << s.real() * time
                           << ", frequency " << s.imag() * time
                           << " of an element's shear wave; growth over "
                              "frequency without damping "
                           << ratio << ", of a half-space "
                           << waves[0].imag() / waves[0].real());
      growths.push_back(s.real());
      BOOST_TEST(ratio == waves[0].imag() / waves[0].real(),
                 boost::test_tools::tolerance(n == 12 ? 0.05 : 0.15));
    }
  // elements shorter by 1.5: as much faster, and nearer to the half-space
  BOOST_TEST(growths[1] / growths[0] > 1.5);
  BOOST_TEST(growths[1] / growths[0] < 1.8);
}

/** Friction that falls at each node at once: unstable where it falls faster
 * than waves take it away, with no limit for short elements. */
BOOST_AUTO_TEST_CASE(friction_that_falls_at_each_node_has_no_limit)
{
  const double mu  = 0.1;
  const auto   law = std::shared_ptr<const FrictionLaw>(
    make_friction_law("exponential", 0., 1.));
  const std::vector<References::ShearedHalfSpace> rail{
    {steel.shear_modulus(), steel.density}};
  std::vector<double> growths;
  for (const unsigned int n : {8u, 12u})
    {
      const Block block(n);
      const auto  at = [&](const double gain) {
        const double fall = mu * law->slope(sliding_speed),
                     pressure =
                       gain / References::falling_friction_gain(fall, rail);
        return block.fastest(mu, pressure, law).real();
      };
      BOOST_TEST(at(0.2) < 0.);
      growths.push_back(at(2.));
      BOOST_TEST_MESSAGE(n << " elements: growth " << growths.back());
      BOOST_TEST(growths.back() > 0.);
    }
  BOOST_TEST(growths[1] / growths[0] == 1.5, // elements shorter by that
             boost::test_tools::tolerance(0.05));
}

BOOST_AUTO_TEST_CASE(growth_of_falling_friction_on_half_spaces)
{
  using namespace References;
  const ShearedHalfSpace body{80e9, 7800.}, other{26e9, 2700.};
  const double           c = std::sqrt(80e9 / 7800.), k = 2 * pi / 1e-3;
  for (const double gain : {0.2, 0.999, 1., 1.01, 2., 50.})
    {
      const double fall = gain * 7800. * c / 2;
      BOOST_TEST(falling_friction_gain(fall, {body, body}) == gain,
                 boost::test_tools::tolerance(1e-12));
      const double s = falling_friction_growth(fall, {body, body}, 1e-3);
      if (gain <= 1.)
        BOOST_TEST(s == 0.);
      else
        BOOST_TEST(s == c * k / std::sqrt(gain * gain - 1),
                   boost::test_tools::tolerance(1e-10));
      // a rigid body radiates nothing: half the gain
      BOOST_TEST(falling_friction_gain(fall, {body}) == gain / 2,
                 boost::test_tools::tolerance(1e-12));
    }
  const double fall = 5e7,
               s    = falling_friction_growth(fall, {body, other}, 1e-3),
               sum  = 1 / (80e9 * std::sqrt(k * k + s * s * 7800. / 80e9)) +
                     1 / (26e9 * std::sqrt(k * k + s * s * 2700. / 26e9));
  BOOST_TEST(fall * s * sum == 1., boost::test_tools::tolerance(1e-10));
  BOOST_TEST(falling_friction_growth(fall, {body, other}, 0.5e-3) == 2 * s,
             boost::test_tools::tolerance(1e-10));
  BOOST_TEST(
    contains(complaint([&]() { falling_friction_growth(fall, {body}, 0.); }),
             "Wavelength"));
}

BOOST_AUTO_TEST_SUITE_END()
