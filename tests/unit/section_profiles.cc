#include <deal.II/grid/grid_tools.h>

#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include "scene_run.h"
#include "section_files.h"

#include <rolling_contact/mesh/file_body_mesh.h>
#include <rolling_contact/mesh/profiled_section.h>
#include <rolling_contact/pair/places.h>
#include <rolling_contact/pair/section_in_contact.h>

#include <cmath>
#include <random>

using namespace RollingContact;

/** Sections from files under profiles, and several places on one of them. */
BOOST_AUTO_TEST_SUITE(section_profiles)

namespace
{
  const double mm = 1e-3;

  /** S1002 on 60E1, plain bodies. */
  void plain(SceneParameters &scene)
  {
    scene.dimension                  = 3;
    scene.wheel.hub_radius           = 0.0925;
    scene.wheel.width                = 0.1;
    scene.rail.shape                 = "block";
    scene.rail.radius                = 0.;
    scene.rail.width                 = 0.1;
    scene.rail.block_length          = 0.4;
    scene.rail.block_depth           = 0.15;
    scene.contact.normal_load        = 50e3;
    scene.contact.creepages          = {1e-3, 1e-3, 0.19};
    scene.mesh.elements_across_patch = 8;
    scene.mesh.growth                = 1.5;
    scene.output.body_fields         = false;
    scene.profiles.wheel_profile     = "S1002";
    scene.profiles.rail_profile      = "60E1";
    scene.profiles.shift             = 3 * mm;
    scene.profiles.roll              = 0.;
  }

  void take_sections(SceneParameters &scene)
  {
    BodyParameters wheel = section_body("Wheel", "wheel_s1002.msh"),
                   rail  = section_body("Rail", "rail_60e1.msh");
    wheel.cells_along    = 144;
    rail.cells_along     = 20;
    rail.block_length    = 0.4;
    scene.wheel          = wheel;
    scene.rail           = rail;
  }

  void sections(SceneParameters &scene)
  {
    plain(scene);
    take_sections(scene);
  }

  void mirror(SceneParameters &scene)
  {
    scene.profiles.is_left = true;
    scene.profiles.shift   = -scene.profiles.shift;
    scene.contact.creepages.y *= -1;
    scene.contact.creepages.spin *= -1;
  }

  using Change = std::function<void(SceneParameters &)>;

  const Change as_it_is = [](SceneParameters &) {};

  /** A scene of sections at a place. */
  Situation scene_of(const Change &change)
  {
    SceneParameters scene;
    sections(scene);
    change(scene);
    scene.check();
    return Situation(scene);
  }

  Grading<3> grading_of(const PairSpec &scene)
  {
    return make_grading<3>(scene,
                           StateDemands(),
                           estimate_patch(scene),
                           scene.mesh.elements_across_patch,
                           0.);
  }

  PairDemands kept_factors()
  {
    PairDemands demands;
    demands.displacements = demands.factors = true;
    return demands;
  }
} // namespace

BOOST_AUTO_TEST_CASE(points_of_profiles_are_found_by_length)
{
  const Situation       scene = scene_of(as_it_is);
  const ProfiledSection wheel(*scene.wheel.profile, true),
    rail(*scene.rail.profile, false);
  for (const ProfiledSection *body : {&wheel, &rail})
    {
      BOOST_TEST(std::hypot(body->at(0.)[0], body->at(0.)[1]) < 1e-6);
      for (const double along : {-45e-3, -38e-3, -20e-3, -3e-3, 10e-3, 25e-3})
        {
          const auto on = body->at(along), t = body->tangent(along);
          // out of the body and into it, beside the profile
          for (const double off : {-2e-3, 0., 2e-3})
            {
              const auto foot =
                body->nearest({{on[0] - off * t[1], on[1] + off * t[0]}});
              BOOST_TEST(std::abs(foot.along - along) < 1e-9);
              BOOST_TEST(std::abs(foot.distance - std::abs(off)) < 1e-12);
            }
        }
      BOOST_TEST(std::abs(body->coordinate(body->contact())) < 1e-12);
      // the plane of contact is a tangent: lengths are alike beside it
      const ZoneBox box =
        body->on_profile({{{-5 * mm, -1 * mm}}, {{6 * mm, 2 * mm}}});
      BOOST_TEST(box.lower[0] == -5 * mm);
      BOOST_TEST(std::abs(box.lower[1] - body->contact() + 1 * mm) < 0.05 * mm);
      BOOST_TEST(std::abs(box.upper[1] - body->contact() - 2 * mm) < 0.05 * mm);
    }
  // the flange hangs below the tape circle, the rail's sides below its crown
  BOOST_TEST(wheel.at(-60e-3)[1] > 20e-3);
  BOOST_TEST(rail.at(-40e-3)[1] < -10e-3);
}

BOOST_AUTO_TEST_CASE(vertices_lie_on_the_profile_from_flange_to_field_side)
{
  for (const bool left : {false, true})
    for (const double shift : {-4 * mm, 3 * mm, 6 * mm})
      {
        const Situation  scene   = scene_of([&](SceneParameters &scene) {
          scene.profiles.shift   = shift;
          scene.profiles.is_left = left;
        });
        const Grading<3> grading = grading_of(scene);
        for (const Side side : both_sides)
          {
            const auto             shape = scene.body(side).body_shape();
            const BodyMesh<3>      cells = make_body_mesh<3>(shape, grading);
            const SectionInContact section(scene, side);
            const double           angle = section.axes().angle;
            const FileMesh         mesh  = as_file_mesh(
              cells, dealii::Point<3>(0., std::sin(angle), std::cos(angle)));
            const FileMesh seen = section.seen_from_contact(mesh);
            unsigned int   n = 0, off = 0;
            double         largest = 0., highest = 0.;
            for (const auto &face : mesh.contact_faces)
              {
                double size = 0., away = 0.;
                for (unsigned int v = 0; v < 4; ++v)
                  {
                    const auto &p = seen.vertices[face[v]],
                               &q = seen.vertices[face[0]];
                    size          = std::max(
                      {size, std::abs(p[0] - q[0]), std::abs(p[1] - q[1])});
                    away = std::max(away, std::hypot(p[0], p[1]));
                  }
                if (away > 3 * mm)
                  continue;
                ++n;
                largest = std::max(largest, size);
                for (const unsigned int v : face)
                  {
                    off += section.off_profile(mesh.vertices[v]) > 1e-8;
                    highest = std::max(highest, std::abs(seen.vertices[v][2]));
                  }
              }
            BOOST_TEST_CONTEXT(name_of(side)
                               << " at " << shift << ", left " << left)
            {
              BOOST_TEST(n > 5);
              BOOST_TEST(off == 0);
              // the plane of contact touches it, with small elements there
              BOOST_TEST(highest < 0.6 * mm);
              BOOST_TEST(largest < grading.element_size_x);
            }
          }
      }
}

BOOST_AUTO_TEST_CASE(sections_under_profiles_have_their_volumes)
{
  // independently: S1002 and 60E1 between the nodes of the files
  const Situation scene = scene_of(as_it_is);
  const auto      wheel = make_body_mesh<3>(scene.wheel.body_shape(),
                                       Grading<3>::unrefined()),
             rail       = make_body_mesh<3>(scene.rail.body_shape(),
                                      Grading<3>::unrefined());
  const double volume   = dealii::GridTools::volume(*rail.triangulation);
  BOOST_TEST(relative(volume / 0.4, 76.70e-4) < 0.005);
  BOOST_TEST(wheel.triangulation->n_active_cells() == 76 * 144);
  const auto left = make_body_mesh<3>(scene_of([](SceneParameters &scene) {
                                        mirror(scene);
                                      }).wheel.body_shape(),
                                      Grading<3>::unrefined());
  BOOST_TEST(relative(dealii::GridTools::volume(*left.triangulation),
                      dealii::GridTools::volume(*wheel.triangulation)) < 1e-12);
}

BOOST_AUTO_TEST_CASE(rims_flow_along_x_on_either_side)
{
  for (const bool left : {false, true})
    for (const bool generated : {false, true})
      {
        SceneParameters scene;
        plain(scene);
        scene.wheel.hub_radius       = 0.095;
        scene.rail.block_length      = 0.6;
        scene.profiles.true_sections = generated;
        if (!generated)
          take_sections(scene);
        if (left)
          mirror(scene);
        // omega x (0, 0, 1) points along +x
        const auto axle = Situation(scene).wheel.body_shape()->axle();
        BOOST_TEST(axle->direction[1] > 0.9);
        BOOST_TEST(axle->point[2] < -0.4);
      }
}

BOOST_AUTO_TEST_CASE(an_inclined_contact_turns_forces_and_keeps_work)
{
  // the root of the flange, some 20 degrees
  const Situation      scene = scene_of([](SceneParameters &scene) {
    scene.profiles.shift               = 6 * mm;
    scene.contact.normal_load          = 10e3;
    scene.contact.friction_coefficient = 0.;
  });
  const RollingPair<3> pair(scene, grading_of(scene), PairDemands(), false);
  const std::size_t    n = pair.trace().nodes.size();
  const double delta = scene.frame->angle(), inclination = std::atan(1. / 40);
  BOOST_TEST_MESSAGE("angle " << delta << ", " << n << " nodes");
  BOOST_TEST(std::abs(delta) > 0.2);
  // without friction as well, as the normal is no axis of the bodies
  BOOST_TEST(pair.interface().turns_nodes());
  std::vector<double> forces(3 * n, 0.);
  for (std::size_t i = 0; i < n; ++i)
    forces[2 * n + i] = 1. + 0.1 * i;
  const double total = n + 0.05 * n * (n - 1);
  for (const Side side : both_sides)
    {
      const auto        on_body = pair.forces_on_body(side, forces);
      const std::size_t m       = on_body.size() / 3;
      double            sum[3]{};
      for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < m; ++i)
          sum[c] += on_body[c * m + i];
      // into the body: y to the right, z out of it; a slope of delta downwards
      // to the right has its upward normal at (sin, cos)
      const double angle = side == Side::rail ? delta + inclination : -delta;
      BOOST_TEST(std::abs(sum[0]) < 1e-9 * total);
      BOOST_TEST(std::abs(sum[1] + total * std::sin(angle)) < 1e-6 * total);
      BOOST_TEST(std::abs(sum[2] + total * std::cos(angle)) < 1e-6 * total);
      // transposed: the work of any forces in any motion of the body
      std::mt19937                           random(7);
      std::uniform_real_distribution<double> number(-1., 1.);
      std::vector<double>                    motion(3 * m), any(3 * n);
      for (double &value : motion)
        value = number(random);
      for (double &value : any)
        value = number(random);
      PerSide<std::vector<double>> motions{std::vector<double>(),
                                           std::vector<double>()};
      motions[side]              = motion;
      const auto relative_motion = pair.relative_motion(motions);
      const auto any_on_body     = pair.forces_on_body(side, any);
      double     at_interface = 0., on_nodes = 0.;
      for (std::size_t i = 0; i < any.size(); ++i)
        at_interface += any[i] * relative_motion[i];
      for (std::size_t i = 0; i < motion.size(); ++i)
        on_nodes += any_on_body[i] * motion[i];
      BOOST_TEST(std::abs(at_interface - on_nodes) <
                 1e-10 * std::abs(on_nodes));
    }
}

namespace
{
  /** Plain bodies differ from these by up to 5 % of mu N. */
  void true_sections(SceneParameters &scene)
  {
    plain(scene);
    scene.profiles.true_sections = true;
  }

  /** On the field side of the wheel. */
  void far_away(SceneParameters &scene)
  {
    scene.profiles.shift             = -3 * mm;
    scene.mesh.elements_across_patch = 6;
  }

  void check_alike(const SceneRun<3> &run,
                   const SceneRun<3> &expected,
                   const double       pressure,
                   const double       force)
  {
    const auto &one = run.steady.result, &other = expected.steady.result;
    BOOST_TEST_MESSAGE(
      "pressure " << one.max_pressure << " " << other.max_pressure
                  << ", forces " << run.force_x() << " " << expected.force_x()
                  << " " << run.force_y() << " " << expected.force_y()
                  << ", unknowns " << run.steady.pair->bodies().n_unknowns());
    BOOST_TEST(relative(one.max_pressure, other.max_pressure) < pressure);
    BOOST_TEST(std::abs(run.force_x() - expected.force_x()) < force);
    BOOST_TEST(std::abs(run.force_y() - expected.force_y()) < force);
  }
} // namespace

BOOST_AUTO_TEST_CASE(sections_roll_as_those_of_another_mesher)
{
  // which turns bodies, not nodes, has nodes on the interface, another web
  check_alike(SceneRun<3>(&sections, &far_away),
              SceneRun<3>(&true_sections, &far_away),
              0.02,
              0.025);
  const SceneRun<3> right(&sections, as_it_is);
  check_alike(right, SceneRun<3>(&true_sections, as_it_is), 0.02, 0.025);

  // on the tread a curved surface of contact is nearly plane
  const SceneRun<3> curved(&sections, [](SceneParameters &scene) {
    scene.profiles.surface_kind = Profiles::SurfaceKind::curved;
  });
  BOOST_TEST(curved.steady.pair->interface().turns_nodes());
  check_alike(curved, right, 0.01, 0.03);

  const SceneRun<3> left(&sections, &mirror);
  BOOST_TEST(relative(left.steady.result.max_pressure,
                      right.steady.result.max_pressure) < 1e-7);
  BOOST_TEST(relative(left.steady.state.approach, right.steady.state.approach) <
             1e-7);
  BOOST_TEST(std::abs(left.force_x() - right.force_x()) < 1e-6);
  BOOST_TEST(std::abs(left.force_y() + right.force_y()) < 1e-6);
}

namespace
{
  /** A state at a place on bodies that may be shared. */
  SteadyState<3> state_on(RollingPair<3> &&pair, const PlaceOfContact<3> &place)
  {
    SteadyState<3> steady;
    steady.grading = place.grading;
    steady.pair    = std::make_unique<RollingPair<3>>(std::move(pair));
    steady.problem = steady.pair->contact_problem(place.scene.contact);
    solve_contact(place.scene, StateDemands(), steady);
    BOOST_TEST(steady.solver.converged);
    steady.result = resultants(steady.problem, steady.state);
    return steady;
  }
} // namespace

BOOST_AUTO_TEST_CASE(bodies_serve_several_places_with_one_factor)
{
  std::vector<PlaceOfContact<3>> places;
  for (const double shift : {3 * mm, 4 * mm})
    {
      const Situation scene =
        scene_of([&](SceneParameters &scene) { scene.profiles.shift = shift; });
      places.push_back({scene, grading_of(scene)});
    }
  const BodyPair<3> bodies(places[0].scene,
                           grading_of_places(places),
                           kept_factors(),
                           true);
  double            last_pressure = 0.;
  for (const auto &place : places)
    {
      const auto &[scene, grading] = place;
      const SteadyState<3> shared =
                             state_on({scene, grading, kept_factors(), bodies},
                                      place),
                           own =
                             state_on({scene, grading, kept_factors()}, place);
      BOOST_TEST(shared.pair->bodies().body(Side::wheel) ==
                 bodies.body(Side::wheel));
      BOOST_TEST(shared.problem.loads.gap == own.problem.loads.gap);
      const auto  &one = shared.result, &other = own.result;
      const double limit =
        scene.contact.friction_coefficient * other.normal_force;
      BOOST_TEST_MESSAGE(
        "shift " << scene.profiles.shift << ": pressure " << one.max_pressure
                 << " " << other.max_pressure << ", forces "
                 << one.force_x / limit << " " << other.force_x / limit << " "
                 << one.force_y / limit << " " << other.force_y / limit
                 << ", unknowns " << bodies.n_unknowns() << " for all, "
                 << own.pair->bodies().n_unknowns());
      // the strip's elements are smaller, here and there by a half
      BOOST_TEST(relative(one.max_pressure, other.max_pressure) < 0.01);
      BOOST_TEST(std::abs(one.force_x - other.force_x) < 0.015 * limit);
      BOOST_TEST(std::abs(one.force_y - other.force_y) < 0.015 * limit);
      BOOST_TEST(relative(one.max_pressure, last_pressure) > 0.02);
      last_pressure = one.max_pressure;
    }
}

BOOST_AUTO_TEST_CASE(bodies_of_a_place_stay_where_they_are)
{
  // a grading of one place is that of the place: the same mesh, the same W
  const Situation  scene   = scene_of(as_it_is);
  const Grading<3> grading = grading_of(scene),
                   alone   = grading_of_places<3>({{scene, grading}});
  for (const Side side : both_sides)
    {
      const auto shape = scene.body(side).body_shape();
      BOOST_TEST(
        make_body_mesh<3>(shape, grading).triangulation->n_vertices() ==
        make_body_mesh<3>(shape, alone).triangulation->n_vertices());
    }
  BOOST_CHECK_THROW(grading_of_places<3>({}), std::invalid_argument);
  SceneParameters plain_discs;
  plain(plain_discs);
  const Situation      discs(plain_discs);
  const RollingPair<3> pair(discs, grading_of(discs), PairDemands(), false);
  BOOST_TEST(contains(complaint([&]() {
                        RollingPair<3>(discs,
                                       grading_of(discs),
                                       PairDemands(),
                                       pair.bodies());
                      }),
                      "Wheel/Shape = disc: only bodies with a section"));
}

BOOST_AUTO_TEST_CASE(what_does_not_fit_a_profile_is_refused)
{
  const auto said = [](const Change &change) {
    return complaint([&]() { scene_of(change); });
  };
  BOOST_TEST(said(as_it_is) == "");
  const auto check = [](const std::string &text, const std::string &part) {
    BOOST_TEST(contains(text, part), text);
  };
  check(said(
          [](SceneParameters &scene) { scene.profiles.true_sections = true; }),
        "Wheel/Shape = section and Profiles/Body sections = true");
  check(
    said([](SceneParameters &scene) {
      scene.rail.surface = SurfaceSource::nodes;
    }),
    "Rail/Surface = nodes: the undeformed surface is that of Profiles/Rail");
  check(said([](SceneParameters &scene) { scene.rail.radius = 0.5; }),
        "Rail/Radius = 0.5: a rail with a profile is straight");
  check(said([](SceneParameters &scene) { scene.wheel.shape = "mesh file"; }),
        "brings its own surface");
  const auto in_contact = [](const Change &change) {
    return complaint([&]() {
      const Situation scene = scene_of(change);
      RollingPair<3>(scene, grading_of(scene), PairDemands(), false);
    });
  };
  // a tread that is straight is not an S1002
  check(in_contact([](SceneParameters &scene) {
          scene.wheel.mesh_file =
            section_body("Wheel", "wheel_2.msh").mesh_file;
        }),
        "off the profile at y = ");
  // the gauge corner of rail_2 is no part of its contact boundary
  check(in_contact([](SceneParameters &scene) {
          scene.rail.mesh_file = section_body("Rail", "rail_2.msh").mesh_file;
          scene.rail.contact_boundary = 1;
          scene.profiles.shift        = 7.5 * mm;
          scene.contact.normal_load   = 10e3;
        }),
        "its contact boundary ends inside the contact zone");
}

/**
 * On a steep flange the far side of the wheel faces the contact as the near one
 * does; it is no contact face.
 */
BOOST_AUTO_TEST_CASE(the_flange_beyond_the_axle_does_not_touch)
{
  SceneParameters scene;
  sections(scene);
  scene.profiles.shift        = 6.3 * mm;
  scene.profiles.surface_kind = Profiles::SurfaceKind::curved;
  const Situation        situation(scene);
  const SectionInContact section(situation, Side::wheel);
  FileMesh               mesh;
  mesh.dimension = 3;
  for (const double z : {0.01, -0.01 - 2 * scene.wheel.radius})
    {
      const unsigned int n = mesh.vertices.size();
      for (const double y : {-39 * mm, -37 * mm})
        for (const double x : {-1 * mm, 1 * mm})
          mesh.vertices.push_back({{x, y, z}});
      mesh.contact_faces.push_back({{n, n + 1, n + 2, n + 3}});
    }
  const FileMesh seen = section.seen_from_contact(mesh);
  BOOST_TEST(seen.contact_faces.size() == 1u);
  BOOST_TEST(seen.contact_faces.front()[0] == 0u);
}

BOOST_AUTO_TEST_SUITE_END()
