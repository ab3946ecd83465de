#include <boost/test/unit_test.hpp>

#include "vibrating_pair.h"

#include <rolling_contact/base/constants.h>
#include <rolling_contact/modes/outer_surface.h>
#include <rolling_contact/time/radiating_surface.h>

#include <cmath>

using namespace RollingContact;
using namespace RollingContact::Sound;

BOOST_AUTO_TEST_SUITE(radiating_surfaces)

namespace
{
  /** Unit translations along x, y and z, by columns. */
  DenseMatrix translations(const DirectBody<3> &body)
  {
    DenseMatrix result = DenseMatrix::Zero(body.n_unknowns(), 3);
    for (unsigned int d = 0; d < 3; ++d)
      {
        const auto column = body.uniform(d, 1.);
        std::copy(column.begin(),
                  column.end(),
                  result.data() + d * result.rows());
      }
    return result;
  }

  DirectBody<3> make_body(const std::string     &shape,
                          const ShapeParameters &parameters)
  {
    Grading<3> grading;
    grading.element_size_x = grading.element_size_y = 5e-3;
    grading.zone_x = grading.zone_y = 1e-2;
    grading.zone_depth              = 5e-3;
    grading.growth                  = 0.7;
    return DirectBody<3>(make_body_shape(shape, parameters),
                         Material{210e9, 0.3, 7850.},
                         1.,
                         grading);
  }

  OuterSurface::Direction along(const unsigned int component)
  {
    return [=](const dealii::Point<3> &) {
      dealii::Tensor<1, 3> e;
      e[component] = 1.;
      return e;
    };
  }
} // namespace

BOOST_AUTO_TEST_CASE(surface_of_a_block)
{
  const double    length = 0.5, width = 0.1, depth = 0.15;
  ShapeParameters parameters;
  parameters.radius       = 0.;
  parameters.block_length = length;
  parameters.block_depth  = depth;
  parameters.width        = width;
  parameters.hub          = Hub::free;
  const auto         body = make_body("block", parameters);
  const OuterSurface surface(body, translations(body), 3);
  const auto across = surface.form(along(1)), upwards = surface.form(along(2));
  const auto near = [](const double value, const double expected) {
    BOOST_TEST(std::abs(value - expected) < 1e-9);
  };
  near(across(1, 1), 2 * length * depth);
  near(upwards(2, 2), length * width); // its foot does not count
  for (const auto &[i, j] :
       std::vector<std::pair<int, int>>{{0, 0}, {0, 1}, {1, 2}, {0, 2}})
    {
      near(across(i, j), 0.);
      near(upwards(j, i), 0.);
    }
  near(surface.area(along(1)), 2 * length * depth);
  near(surface.volume(), length * width * depth);
  near(surface.box()[1][1] - surface.box()[0][1], width);
  near(surface.box()[1][2] - surface.box()[0][2], depth);
}

BOOST_AUTO_TEST_CASE(surface_of_a_disc)
{
  const double    R = 0.46, r = 0.08, width = 0.1;
  ShapeParameters parameters;
  parameters.radius       = R;
  parameters.hub_radius   = r;
  parameters.width        = width;
  parameters.hub          = Hub::free;
  const auto         body = make_body("disc", parameters);
  const OuterSurface surface(body, translations(body), 3);
  const auto         outward = [&](const dealii::Point<3> &at) {
    dealii::Tensor<1, 3> out;
    out[0] = at[0];
    out[2] = at[2] + R;
    return out / out.norm();
  };
  const auto axial = surface.form(along(1)), radial = surface.form(outward);
  const auto near = [](const double value, const double expected) {
    BOOST_TEST(value == expected, boost::test_tools::tolerance(0.025));
  };
  near(axial(1, 1), 2 * pi * (R * R - r * r)); // both faces
  near(radial(0, 0), pi * R * width);          // the rim, cos^2 on the mean
  near(radial(2, 2), pi * R * width);
  near(surface.area(outward), 2 * pi * R * width); // without the bore
  // what holds for the polygon of the mesh as well
  BOOST_TEST(axial(1, 1) == 2 * surface.volume() / width,
             boost::test_tools::tolerance(1e-6));
  BOOST_TEST(radial(0, 0) + radial(2, 2) == surface.area(outward),
             boost::test_tools::tolerance(1e-9));
  BOOST_TEST(std::abs(radial(0, 2)) < 1e-3 * radial(0, 0));
  BOOST_TEST(std::abs(axial(0, 0)) < 1e-12);
}

/** Slowly a beam is a line of dipoles: per length and v^2 it radiates
 * rho c k^3 (S + pi w^2 / 4)^2 / 8, with its section S and its width w across
 * the motion. */
BOOST_AUTO_TEST_CASE(a_rail_radiates_by_its_width_across_the_motion)
{
  const double  width = 0.03, depth = 0.08;
  SceneInMemory run;
  standard<3>(run.scene);
  VibratingPair::unstable_pair(run.scene);
  run.scene.rail.width         = width;
  run.scene.rail.block_depth   = depth;
  run.scene.modes.element_size = 0.03;
  const VibratingBody<3> rail(
    run.situation(), Side::rail, run.scene.modes, 4000., run.context);
  const RadiatingBody radiating = radiating_body(rail, 4000., Air());
  BOOST_TEST_REQUIRE(radiating.parts.size() == 2u);
  const double f = 5., k = 2 * pi * f / Air().speed;
  const auto   dipoles = [&](const double w) {
    return k * k * k * std::pow(width * depth + pi * w * w / 4, 2) / 8;
  };
  // both sides of the block, but not its foot
  BOOST_TEST(radiating.parts[0].efficiency(f) * 2 * depth == dipoles(depth),
             boost::test_tools::tolerance(1e-3));
  BOOST_TEST(radiating.parts[1].efficiency(f) * width == dipoles(width),
             boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_SUITE_END()
