#include "time_run.h"

#include <rolling_contact/pair/patch_estimate.h>
#include <rolling_contact/results/error_bounds.h>

#include <cmath>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(dissimilar_bodies)

namespace
{
  /**
   * A disc of steel on one of aluminium, as prm/steel_on_aluminium_2d.prm.
   */
  struct Run : public SceneRun<2>
  {
    explicit Run(const Change &change)
      : SceneRun<2>(
          [](SceneParameters &scene) {
            scene.rail.material              = {70e9, 0.34};
            scene.contact.approach           = 0.22e-3;
            scene.mesh.elements_across_patch = 24;
          },
          change)
    {}
  };
} // namespace

/**
 * A pressure p strains the surface of a half-plane by -(1 - 2 nu) p / (2 G):
 * wheel over rail, by -2 beta p / E*.
 */
BOOST_AUTO_TEST_CASE(pressure_strains_the_surfaces_by_dundurs_constant)
{
  const Run               run([](SceneParameters &) {});
  const ContactOperators &problem   = run.steady.problem.operators;
  const PairConstants     constants = pair_constants(run.situation());
  const auto             &pressure  = run.steady.state.pressure;
  const auto              displacement =
    problem.tangential_displacement_of_pressure(pressure);
  double force = 0., stretch = 0.;
  for (unsigned int i = 0; i + 1 < problem.n_nodes(); ++i)
    {
      const double left  = problem.positions()[i][0],
                   right = problem.positions()[i + 1][0];
      if (std::abs(left + right) > run.steady.result.half_width_x)
        continue;
      force += (right - left) * (pressure[i] + pressure[i + 1]) / 2;
      stretch += displacement[{0, i + 1}] - displacement[{0, i}];
    }
  // shear moduli 80.769 and 26.119 GPa, by hand
  BOOST_TEST(constants.dundurs_beta == -0.10754,
             boost::test_tools::tolerance(1e-4));
  BOOST_TEST(stretch ==
               -2 * constants.dundurs_beta / constants.contact_modulus * force,
             boost::test_tools::tolerance(0.05));
}

/**
 * Forces over N on 384 elements, mean over positions, which differ by 1e-4. The
 * wrong sign of Dundurs' constant in the edge law errs by 9 % of mu N here.
 */
BOOST_AUTO_TEST_CASE(coarse_meshes_have_the_force_of_fine_ones)
{
  for (const auto &converged : {std::make_pair(0., -0.11176),
                                std::make_pair(0.001, -0.18166),
                                std::make_pair(-0.002, 0.08266)})
    for (const double offset : {0., 0.25, 0.5, 0.75})
      {
        const Run    run([&](SceneParameters &scene) {
          scene.mesh.patch_offset   = offset;
          scene.contact.creepages.x = converged.first;
        });
        const double error = std::abs(run.force_x() - converged.second / 0.3);
        BOOST_TEST_CONTEXT("creepage " << converged.first << ", offset "
                                       << offset)
        BOOST_TEST(error < *error_bounds(run.situation(), run.steady).force);
      }
}

namespace
{
  /**
   * F_x over mu N of steel that is pressed on aluminium in two steps, as Spence
   * has it: nothing rolls but for a path of the given length.
   */
  template <int dim>
  double force_of_pressing(const double path)
  {
    TimeRun<dim> run([&](SceneParameters &scene) {
      scene.rail.material              = {70e9, 0.34};
      scene.mesh.elements_across_patch = 12;
      scene.contact.speed              = path;
      scene.time.approach  = dim == 2 ? "0.15e-3 * t" : "0.07e-3 * t";
      scene.time.time_step = 0.5;
    });
    return run.march(2).back();
  }
} // namespace

// the mesh has its middle below the wheel, and nothing else tells both sides
// apart if nothing rolls: not the leading edge either
BOOST_AUTO_TEST_CASE(pressing_alone_drives_to_neither_side)
{
  BOOST_TEST(std::abs(force_of_pressing<2>(1e-9)) < 1e-6);
  BOOST_TEST(std::abs(force_of_pressing<3>(1e-9)) < 1e-6);
  // as soon as it rolls, the leading edge differs from the trailing one
  BOOST_TEST(std::abs(force_of_pressing<3>(1e-3)) > 1e-3);
}

BOOST_AUTO_TEST_SUITE_END()
