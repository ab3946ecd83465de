#include "scene_run.h"

#include <rolling_contact/base/constants.h>
#include <rolling_contact/references/carter.h>
#include <rolling_contact/references/line_contact_stress.h>
#include <rolling_contact/results/body_fields.h>
#include <rolling_contact/results/local_fit.h>
#include <rolling_contact/results/reference_2d.h>
#include <rolling_contact/results/reference_3d.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace RollingContact;
using namespace dealii;

BOOST_AUTO_TEST_SUITE(nodal_stress)

namespace
{
  std::vector<KnownPlace> grid(const int n_layers)
  {
    std::vector<KnownPlace> places;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        for (int k = 0; k < n_layers; ++k)
          places.push_back({{{i - 1.4, 0.5 * j - 0.8, 0.1 * k + 0.05}},
                            i == 1 || i == 2 ? 1. : 0.1});
    return places;
  }

  double value(const std::vector<double>                           &weights,
               const std::vector<KnownPlace>                       &places,
               const std::function<double(double, double, double)> &f)
  {
    double sum = 0.;
    for (std::size_t s = 0; s < places.size(); ++s)
      sum += weights[s] * f(places[s].at[0], places[s].at[1], places[s].at[2]);
    return sum;
  }
} // namespace

BOOST_AUTO_TEST_CASE(polynomials_are_fitted_exactly)
{
  const auto       places = grid(3);
  const FitWeights fit    = fit_in_origin(places, 3);
  const auto quadratic    = [](const double x, const double y, const double z) {
    return 3 + x - 2 * y + 10 * z + x * x - y * y + x * y + 50 * z * z - z * x;
  };
  const auto linear = [](const double x, const double y, const double z) {
    return 3 + x - 2 * y + 10 * z;
  };
  BOOST_TEST(std::abs(value(fit.quadratic, places, quadratic) - 3) < 1e-3);
  BOOST_TEST(std::abs(value(fit.quadratic, places, linear) - 3) < 1e-6);
  BOOST_TEST(std::abs(value(fit.linear, places, linear) - 3) < 1e-6);
  BOOST_TEST(std::abs(value(fit.linear, places, quadratic) - 3) > 0.1);
}

// in one layer nothing tells a slope across it, in two no curvature
BOOST_AUTO_TEST_CASE(layers_leave_out_what_they_do_not_determine)
{
  const auto f = [](const double x, const double y, const double) {
    return 3 + x - 2 * y + x * x;
  };
  const auto with_slope = [](const double x, const double y, const double z) {
    return 3 + x - 2 * y + 10 * z + x * y;
  };
  const auto one = grid(1), two = grid(2);
  BOOST_TEST(std::abs(value(fit_in_origin(one, 3).quadratic, one, f) - 3) <
             1e-3);
  BOOST_TEST(std::abs(value(fit_in_origin(two, 3).quadratic, two, with_slope) -
                      3) < 1e-3);
}

namespace
{
  /**
   * Discs whose patch is so small that they are half-planes around it, but for
   * the stress N/(pi R t) along x that the load gives them.
   */
  struct SmallLine : public SceneRun<2>
  {
    explicit SmallLine(const double friction)
      : SceneRun<2>(
          [&](SceneParameters &scene) {
            scene.contact.normal_load          = 1000.;
            scene.contact.friction_coefficient = friction;
            scene.contact.creepages.x          = 1.4e-4;
            scene.mesh.elements_across_patch   = 48;
            scene.output.body_fields           = true;
          },
          [](SceneParameters &) {})
      , reference(reference_2d(situation(), steady))
      , of_disc(reference.hertz.load_per_length() / (pi * scene.wheel.radius))
    {}

    /**
     * The exact stresses of a body at x and a depth, z out of it.
     */
    References::PlaneStresses
    exact(const Side side, const double x, const double depth) const
    {
      const double a  = reference.hertz.half_width,
                   p0 = reference.hertz.max_pressure;
      auto result     = References::stresses_of_pressure(x, depth, a, p0);
      result.xx += of_disc;
      if (!reference.carter)
        return result;
      // on the wheel friction is against the creepage
      const double q0 = (side == Side::wheel ? -1. : 1.) *
                        scene.contact.friction_coefficient * p0,
                   c      = reference.carter->stick_half_width();
      const auto   stick  = reference.carter->stick_interval();
      const double middle = (stick.first + stick.second) / 2;
      const auto   of_traction =
                   References::stresses_of_traction(x, depth, a, q0),
                 of_stick = References::stresses_of_traction(x - middle,
                                                             depth,
                                                             c,
                                                             -q0 * c / a);
      result.xx += of_traction.xx + of_stick.xx;
      result.zz += of_traction.zz + of_stick.zz;
      result.xz += of_traction.xz + of_stick.xz;
      return result;
    }

    Reference2D reference;
    double      of_disc;
  };

  /**
   * The stress of a body of a state at its vertices, with their places.
   */
  template <int dim>
  std::vector<std::pair<Point<dim>, StressValue>>
  nodal_stresses(const SteadyState<dim> &steady, const Side side)
  {
    const ElasticBody<dim> &body = *steady.pair->bodies().body(side);
    const NodalStress<dim>  stress(body,
                                  steady.pair->displacement(side,
                                                            steady.problem,
                                                            steady.state),
                                  0.,
                                  surface_tractions(steady, side));
    const auto             &vertices =
      body.dof_handler().get_triangulation().get_vertices();
    std::vector<std::pair<Point<dim>, StressValue>> found;
    for (unsigned int v = 0; v < vertices.size(); ++v)
      found.emplace_back(vertices[v], stress.at(v));
    return found;
  }

  /**
   * The largest errors over p0 of xx, zz and xz in a layer of nodes, far from
   * the ends of patch and stick zone and near them, and the share of nodes
   * where the estimated error is above the true one, as far as that is known.
   */
  struct LayerErrors
  {
    std::array<double, 3> far{}, near{};
    double                covered = 0.;

    LayerErrors(const SmallLine &run, const Side side, const unsigned int layer)
    {
      const auto  &hertz = run.reference.hertz;
      const double a = hertz.half_width, h = run.steady.grading.element_size_x,
                   R      = run.scene.wheel.radius;
      const auto stresses = nodal_stresses(run.steady, side);
      const auto depth    = [&](const Point<2> &at) {
        return std::max(0., -at[1] - at[0] * at[0] / (2 * R));
      };
      std::vector<double> depths; // below the middle
      for (const auto &[at, stress] : stresses)
        if (std::abs(at[0]) < 0.1 * h && depth(at) < a)
          depths.push_back(depth(at));
      std::sort(depths.begin(), depths.end());
      const double below  = depths.at(layer);
      unsigned int n_seen = 0;
      for (const auto &[at, stress] : stresses)
        {
          const double x = at[0], z = depth(at);
          if (std::abs(x) > 1.25 * a || std::abs(z - below) > 0.05 * h)
            continue;
          double to_end = std::abs(std::abs(x) - a);
          if (run.reference.carter)
            to_end =
              std::min(to_end,
                       std::abs(x -
                                run.reference.carter->stick_interval().second));
          const auto                  exact = run.exact(side, x, z);
          const std::array<double, 3> errors{
            {std::abs(stress.stress[0][0] - exact.xx),
             std::abs(stress.stress[2][2] - exact.zz),
             std::abs(stress.stress[0][2] - exact.xz)}};
          for (unsigned int c = 0; c < 3; ++c)
            {
              double &largest = (to_end > 3 * h ? far : near)[c];
              largest = std::max(largest, errors[c] / hertz.max_pressure);
            }
          // discs are half-planes but for parts a/R
          const double known = a / R * hertz.max_pressure;
          covered +=
            stress.error + known >
            std::hypot(errors[0], errors[1], std::sqrt(2.) * errors[2]);
          ++n_seen;
        }
      BOOST_TEST(n_seen > 50u);
      covered /= n_seen;
    }
  };

  void print(const LayerErrors &errors)
  {
    for (const auto &of : {errors.far, errors.near})
      BOOST_TEST_MESSAGE("xx " << of[0] << ", zz " << of[1] << ", xz "
                               << of[2]);
    BOOST_TEST_MESSAGE("covered " << errors.covered);
  }
} // namespace

// within three elements of where patch and stick zone end, where stresses are
// singular at the surface, those of the elements are 0.5 % of p0 off
BOOST_AUTO_TEST_CASE(stresses_below_a_line_are_those_of_mcewen)
{
  for (const double friction : {0., 0.3})
    {
      const SmallLine run(friction);
      for (const Side side : both_sides)
        for (const unsigned int layer : {2u, 3u, 5u})
          BOOST_TEST_CONTEXT("friction " << friction << ", " << name_of(side)
                                         << ", layer " << layer)
          {
            const LayerErrors errors(run, side, layer);
            print(errors);
            for (unsigned int c = 0; c < 3; ++c)
              {
                BOOST_TEST(errors.far[c] < 2e-3);
                BOOST_TEST(errors.near[c] < 8e-3);
              }
            BOOST_TEST(errors.covered > 0.95);
          }
    }
}

BOOST_AUTO_TEST_CASE(stresses_at_the_surface_are_its_tractions)
{
  for (const double friction : {0., 0.3})
    {
      const SmallLine run(friction);
      for (const Side side : both_sides)
        BOOST_TEST_CONTEXT("friction " << friction << ", " << name_of(side))
        {
          const LayerErrors errors(run, side, 0);
          print(errors);
          BOOST_TEST(errors.far[0] < 2.2e-3);
          BOOST_TEST(errors.covered > 0.95);
          BOOST_TEST(std::max(errors.far[1], errors.near[1]) < 1e-3);
          BOOST_TEST(errors.near[2] < 2e-3);
          // beyond the zone of contact nodes what elements say
          BOOST_TEST(errors.far[2] < 3e-3);
        }
    }
}

// Johnson 1985, (3.45): a circle, on its axis
BOOST_AUTO_TEST_CASE(stresses_below_a_point_are_those_of_hertz)
{
  const SceneRun<3> run(
    [](SceneParameters &scene) {
      scene.dimension                    = 3;
      scene.mesh.elements_across_patch   = 24;
      scene.mesh.growth                  = 0.3;
      scene.contact.normal_load          = 100.;
      scene.contact.friction_coefficient = 0.;
      scene.wheel.lateral_radius = scene.rail.lateral_radius = 0.46;
      scene.output.body_fields                               = true;
    },
    [](SceneParameters &) {});
  const auto hertz =
    reference_3d(run.situation(), run.steady.result.normal_force, {}).hertz;
  const double a = hertz.half_width_x, p0 = hertz.max_pressure,
               nu = run.scene.rail.material.poisson_ratio;
  for (const Side side : both_sides)
    {
      std::map<double, StressValue> on_axis;
      for (const auto &[at, stress] : nodal_stresses(run.steady, side))
        if (std::hypot(at[0], at[1]) < 1e-3 * a && at[2] > -0.8 * a)
          on_axis[std::max(0., -at[2] / a)] = stress;
      unsigned int layer = 0;
      for (const auto &[depth, stress] : on_axis)
        BOOST_TEST_CONTEXT(name_of(side)
                           << ", layer " << layer << ", depth " << depth)
        {
          const double axial  = 1 / (1 + depth * depth),
                       radial = (1 + nu) * (1 - depth * std::atan2(1., depth)) -
                                axial / 2;
          for (const auto &[error, tolerance] :
               {std::pair(stress.stress[2][2] / p0 + axial, 2e-3),
                std::pair(stress.stress[0][0] / p0 + radial, 2e-3),
                std::pair(stress.stress[1][1] / p0 + radial, 2e-3),
                std::pair(stress.stress[0][2] / p0, 1e-3),
                std::pair(stress.stress[1][2] / p0, 1e-3),
                std::pair(stress.stress[0][1] / p0, 1e-3)})
            {
              BOOST_TEST_MESSAGE(layer << " " << depth << " " << error << " +- "
                                       << stress.error / p0);
              BOOST_TEST(std::abs(error) < tolerance);
            }
          ++layer;
        }
      BOOST_TEST(layer > 5u);
    }
}

BOOST_AUTO_TEST_SUITE_END()
