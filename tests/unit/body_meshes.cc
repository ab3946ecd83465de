#include <boost/test/unit_test.hpp>

#include <rolling_contact/mesh/body_mesh.h>

#include <algorithm>
#include <cmath>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(body_meshes)

BOOST_AUTO_TEST_CASE(break_points_grow_away_from_their_core)
{
  CoarseCells cells{0.1, 1., 2.5, 20.};
  cells.allowed = [](const double position) {
    return 0.5 * std::abs(position);
  };
  const std::vector<double> points = break_points(-30., 50., cells);
  BOOST_TEST(points.front() == -30.);
  BOOST_TEST(points.back() == 50.);
  BOOST_TEST(points.size() < 25u);
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    {
      const double length = points[i + 1] - points[i],
                   nearer =
                     std::min(std::abs(points[i]), std::abs(points[i + 1]));
      BOOST_TEST(length > 0.5);
      BOOST_TEST(length <= std::max(1. + 1e-12, 0.5 * nearer));
    }
  for (int k = -3; k <= 3; ++k) // the lattice of the core
    BOOST_TEST(std::any_of(points.begin(), points.end(), [&](const double x) {
      return std::abs(x - 0.1 - k) < 1e-14;
    }));
  // no room to grow: remainders of at least half a cell
  const std::vector<double> few = break_points(-1.3, 2.9, cells);
  BOOST_TEST(few == (std::vector<double>{-1.3, 0.1, 1.1, 2.1, 2.9}),
             boost::test_tools::per_element());
}

namespace
{
  std::shared_ptr<const BodyShape> disc(const double radius,
                                        const double hub_radius)
  {
    ShapeParameters parameters;
    parameters.radius     = radius;
    parameters.hub_radius = hub_radius;
    return make_body_shape("disc", parameters);
  }

  /**
   * Cells of bodies with @p shape for a patch with semi-axes of 3.6 mm and @p
   * aspect times that.
   */
  double cells_in_space(const std::shared_ptr<const BodyShape> &shape,
                        const unsigned int                      n_elements,
                        const double                            aspect)
  {
    const double a = 3.6e-3;
    Grading<3>   grading;
    grading.element_size_x = 2 * a / n_elements;
    grading.element_size_y = aspect * grading.element_size_x;
    grading.zone_x         = 1.15 * a;
    grading.zone_y         = aspect * grading.zone_x;
    grading.zone_depth     = 0.75 * a;
    grading.growth         = 0.4;
    return least_cells<3>(shape, grading);
  }
} // namespace

BOOST_AUTO_TEST_CASE(finer_elements_take_no_fewer_cells)
{
  ShapeParameters thin, rail;
  thin.hub_radius   = 0.44;
  rail.block_length = 0.4;
  rail.block_depth  = 0.2;
  const std::vector<std::pair<std::shared_ptr<const BodyShape>, double>> bodies{
    {disc(0.46, 0.08), 0.81},
    {disc(0.46, 0.08), 1.19},
    {disc(0.3, 0.05), 1.},
    {make_body_shape("block", rail), 1.3},
    {make_body_shape("disc", thin), 1.}};
  for (const auto &[shape, aspect] : bodies)
    {
      std::vector<double> cells;
      for (unsigned int n = 4; n <= 40; n += 2)
        cells.push_back(cells_in_space(shape, n, aspect));
      BOOST_TEST_CONTEXT("thickness " << shape->thickness_below() << ", aspect "
                                      << aspect)
      for (std::size_t k = 1; k < cells.size(); ++k)
        {
          BOOST_TEST(cells[k] > 0.89 * cells[k - 1]);
          if (k > 1)
            BOOST_TEST(cells[k] >= cells[k - 2]);
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
