#include <deal.II/lac/vector.h>

#include <boost/test/unit_test.hpp>

#include "time_run.h"

#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/pair/watched_points.h>
#include <rolling_contact/program/analysis_table.h>
#include <rolling_contact/scene/run_signals.h>

#include <cmath>

using namespace RollingContact;

/** Named points of bodies and their velocities in time. */
BOOST_AUTO_TEST_SUITE(velocity_points)

namespace
{
  bool says(const InputError &error, const std::string &text)
  {
    BOOST_TEST_MESSAGE(error.what());
    return std::string(error.what()).find(text) != std::string::npos;
  }

  void refused(const std::string &section,
               const std::string &text,
               const std::string &why,
               const unsigned int dimension = 3)
  {
    BOOST_CHECK_EXCEPTION(read_velocity_points(section, text, dimension),
                          InputError,
                          [&](const InputError &error) {
                            return says(error, why) &&
                                   says(error, section + "/Velocity points");
                          });
  }

  /** Discs with inertia whose hubs approach and leave each other, and whose
   * creepage oscillates. */
  template <int dim>
  void shaken(SceneParameters &scene)
  {
    scene.wheel.material.density = 7800.;
    scene.rail.material.density  = 7800.;
    scene.time.inertia           = true;
    scene.time.theta             = 0.5;
    scene.time.initial_state     = InitialState::steady;
    scene.contact.slip_operator  = SlipOperatorKind::upwind_2;
    scene.contact.creepages.x    = 0.01;
    scene.time.creepage_x        = "0.01 * cos(1e5 * t)";
    scene.time.approach          = significant(*scene.contact.approach, 12) +
                          " * (1 + 0.01 * sin(2e5 * t)^2)";
    scene.time.time_step             = 2e-6;
    scene.mesh.elements_across_patch = 6;
  }
} // namespace

BOOST_AUTO_TEST_CASE(points_are_read_or_refused)
{
  const auto points =
    read_velocity_points("Wheel",
                         "tread: 0.45, 90, 0.0; rim_2 : 0.4,-30,1e-2;",
                         3);
  BOOST_TEST_REQUIRE(points.size() == 2u);
  BOOST_TEST(points[0].name == "tread");
  BOOST_TEST(points[1].name == "rim_2");
  BOOST_TEST(points[1].place[0] == 0.4);
  BOOST_TEST(points[1].place[1] == -30.);
  BOOST_TEST(points[1].place[2] == 0.01);
  BOOST_TEST(read_velocity_points("Rail", "", 2).empty());
  BOOST_TEST(velocity_column("tread", 'y') == "velocity_tread_y_m/s");
  refused("Wheel", "0.45, 90, 0", "is not a named point");
  refused("Wheel", "a: 0.4, 1, 0; a: 0.3, 1, 0", "more than one point");
  refused("Rail", "foot: 0.3, 0", "three numbers, and has 2");
  refused("Rail", "foot: 0.3, 0, low", "no number in \"low\"");
  refused("Rail", "my foot: 0.3, 0, -0.1", "a name that cannot name a column");
  refused("Rail", "2nd: 0.3, 0, -0.1", "a name that cannot name a column");
  refused("Wheel", "a: -0.3, 0, 0", "a radius below 0 m");
  refused("Wheel", "a: 0.3, 0, 0.1", "its third number is 0", 2);
  refused("Rail", "a: 0.3, 0.1, 0", "its second number is 0", 2);
}

/** The same name on both bodies would be the same column. */
BOOST_AUTO_TEST_CASE(names_differ_between_bodies)
{
  SceneParameters scene;
  scene.analysis = analysis_kind("transient");
  standard<2>(scene);
  shaken<2>(scene);
  scene.wheel.velocity_points = "a: 0.45, 90, 0";
  scene.rail.velocity_points  = "a: 0, 0, -0.1";
  BOOST_CHECK_EXCEPTION(scene.check(), InputError, [](const InputError &e) {
    return says(e, "both have a point a");
  });
  scene.rail.velocity_points = "b: 0, 0, -0.1";
  scene.check();
  // contact x, z; a and b
  BOOST_TEST(run_signals(scene).size() == 2u + 2u + 4u);
  scene.spectrum.spectrogram = true;
  BOOST_TEST(spectrogram_signal(scene).column == "velocity_x_m/s");
  scene.spectrum.spectrogram_signal = "velocity_b_z_m/s";
  BOOST_TEST(spectrogram_signal(scene).label == "b z");
  scene.spectrum.spectrogram_signal = "velocity_c_z_m/s";
  BOOST_CHECK_EXCEPTION(scene.check(), InputError, [](const InputError &e) {
    return says(e, "Spectrum/Spectrogram signal = velocity_c_z_m/s") &&
           says(e, "velocity_b_z_m/s");
  });
  scene.time.inertia = false; // no velocities
  BOOST_TEST(scene.velocity_points(Side::wheel).empty());
  BOOST_TEST(run_signals(scene).size() == 2u);
}

/** Where points are: a field that is linear in the coordinates has their
 * coordinates as values. */
BOOST_AUTO_TEST_CASE(points_are_where_they_are_said_to_be)
{
  TimeRun<3>          run([](SceneParameters &scene) {
    shaken<3>(scene);
    scene.wheel.velocity_points = "behind: 0.4, -90, 0.01; below: 0.35, 0, 0; "
                                           "above: 0.42, 180, -0.02; tread: 0.46, 40, 0";
    scene.rail.velocity_points = "deep: 0.02, 0.01, -0.1";
  });
  const auto         &pair = *run.stepper->current().pair;
  WatchedPoints<3>    points(run.situation(),
                          run.scene.points_with_velocities(),
                          pair.bodies(),
                          [](const auto &) {});
  std::vector<double> at = points.values(pair.bodies(), [&](const Side side) {
    const auto &dofs = pair.bodies().body(side)->dof_handler();
    BodyField   field;
    field.reinit(dofs.n_dofs());
    for (const auto &cell : dofs.active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        for (unsigned int d = 0; d < 3; ++d)
          field[cell->vertex_dof_index(v, d)] = cell->vertex(v)[d];
    return field;
  });
  const double R = run.scene.wheel.radius, c = pi / 180;
  const std::vector<std::array<double, 3>> expected{
    {{-0.4, 0.01, R}},
    {{0., 0., R - 0.35}},
    {{0., -0.02, R + 0.42}},
    {{0.46 * std::sin(40 * c), 0., R - 0.46 * std::cos(40 * c)}},
    {{0.02, 0.01, -0.1}}};
  BOOST_TEST_REQUIRE(at.size() == 3 * expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    for (unsigned int d = 0; d < 3; ++d)
      // the tread by its facets
      BOOST_TEST(std::abs(at[3 * i + d] - expected[i][d]) <
                 (i == 3 ? 5e-3 : 1e-10));
}

BOOST_AUTO_TEST_CASE(points_outside_are_refused)
{
  for (const std::string text :
       {"a: 0.2, 90, 0", "a: 0.5, 90, 0", "a: 0.4, 90, 0.5"})
    BOOST_CHECK_EXCEPTION(TimeRun<3>([&](SceneParameters &scene) {
                            shaken<3>(scene);
                            scene.wheel.velocity_points = text;
                          }),
                          InputError,
                          [](const InputError &error) {
                            return says(error, "outside of the wheel") &&
                                   says(error, "the point a (0.");
                          });
  BOOST_CHECK_EXCEPTION(TimeRun<2>([](SceneParameters &scene) {
                          shaken<2>(scene);
                          scene.wheel.shape           = "block";
                          scene.wheel.velocity_points = "a: 0.4, 0, 0";
                        }),
                        InputError,
                        [](const InputError &error) {
                          return says(error, "Shape = block has no axle");
                        });
}

/** At a node: how far it moved in the step over its length, z upwards. */
BOOST_AUTO_TEST_CASE(velocities_are_differences_of_displacements)
{
  TimeRun<2> run([](SceneParameters &scene) {
    shaken<2>(scene);
    scene.wheel.velocity_points = "a: 0.46, 0, 0";
    scene.rail.velocity_points  = "b: 0, 0, 0";
  });
  // the point below the axle is a node, or between two: by the shape functions
  const auto motion = [&](const Side side) {
    const auto     &contact = run.stepper->current();
    const auto     &body    = *contact.pair->bodies().body(side);
    const BodyField field =
      run.stepper->bodies().displacement(side, contact.problem, contact.state);
    std::array<double, 2> mean{};
    double                least = 1., sum = 0.;
    std::vector<std::pair<dealii::Point<2>, std::array<double, 2>>> nodes;
    for (const auto &cell : body.dof_handler().active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        if (std::abs(cell->vertex(v)[1]) < 1e-5)
          nodes.push_back({cell->vertex(v),
                           {{field[cell->vertex_dof_index(v, 0)],
                             field[cell->vertex_dof_index(v, 1)]}}});
    // the nearest on both sides
    for (const int way : {-1, 1})
      {
        least = 1.;
        std::array<double, 2> best{};
        for (const auto &[place, value] : nodes)
          if (way * place[0] >= 0. && std::abs(place[0]) < least)
            {
              least = std::abs(place[0]);
              best  = value;
            }
        const double weight = 1 / (least + 1e-12);
        sum += weight;
        for (unsigned int d = 0; d < 2; ++d)
          mean[d] += weight * best[d];
      }
    return std::array<double, 2>{{mean[0] / sum, mean[1] / sum}};
  };
  auto   wheel = motion(Side::wheel), rail = motion(Side::rail);
  double largest = 0.;
  for (unsigned int k = 0; k < 5; ++k)
    {
      run.march(1);
      const auto   w = motion(Side::wheel), r = motion(Side::rail);
      const auto  &v = run.last.point_velocity;
      const double h = run.scene.time.time_step;
      BOOST_TEST_REQUIRE(v.size() == 4u);
      for (const double value : v)
        largest = std::max(largest, std::abs(value));
      BOOST_TEST(std::abs(v[0] - (w[0] - wheel[0]) / h) < 1e-6 * largest);
      BOOST_TEST(std::abs(v[1] + (w[1] - wheel[1]) / h) < 1e-6 * largest);
      BOOST_TEST(std::abs(v[2] - (r[0] - rail[0]) / h) < 1e-6 * largest);
      BOOST_TEST(std::abs(v[3] - (r[1] - rail[1]) / h) < 1e-6 * largest);
      wheel = w;
      rail  = r;
    }
  BOOST_TEST(largest > 1e-3);
}

/** Twins that only press: both move as each other's mirror image. */
BOOST_AUTO_TEST_CASE(twins_mirror_each_other)
{
  TimeRun<2> run([](SceneParameters &scene) {
    shaken<2>(scene);
    scene.contact.friction_coefficient = 0.;
    scene.contact.creepages.x          = 0.;
    scene.time.creepage_x              = "";
    // a load, under which no hub accelerates
    scene.contact.approach.reset();
    scene.contact.normal_load = 1e5;
    scene.time.approach       = "";
    scene.time.normal_load    = "1e5 * (1 + 0.01 * sin(2e5 * t)^2)";
    const double deep         = 0.03;
    scene.wheel.velocity_points =
      "a: " + significant(scene.wheel.radius - deep, 12) + ", 0, 0";
    scene.rail.velocity_points = "b: 0, 0, -" + significant(deep, 12);
  });
  run.march(12);
  const auto &v = run.last.point_velocity;
  BOOST_TEST_REQUIRE(v.size() == 4u);
  BOOST_TEST(std::abs(v[1]) > 1e-3);
  BOOST_TEST(v[3] == -v[1], boost::test_tools::tolerance(1e-6));
}

/** From a checkpoint the velocities go on as they would have. */
BOOST_AUTO_TEST_CASE(velocities_go_on_from_a_checkpoint)
{
  const auto scene = [](SceneParameters &scene) {
    shaken<2>(scene);
    scene.wheel.velocity_points = "a: 0.45, 20, 0";
  };
  TimeRun<2> run(scene), rest(scene);
  run.march(3);
  Checkpoint checkpoint;
  checkpoint.progress.step      = 3;
  checkpoint.progress.time      = run.time;
  checkpoint.progress.time_step = run.scene.time.time_step;
  run.stepper->save(checkpoint);
  rest.stepper->restore(checkpoint);
  rest.time    = run.time;
  rest.n_steps = 3;
  run.march(1);
  rest.march(1);
  BOOST_TEST(run.last.point_velocity == rest.last.point_velocity,
             boost::test_tools::per_element());
  BOOST_TEST(std::abs(run.last.point_velocity[0]) > 0.);
}

BOOST_AUTO_TEST_SUITE_END()
