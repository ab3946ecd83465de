#include <deal.II/grid/grid_tools.h>

#include <boost/test/unit_test.hpp>

#include "../references/section_properties.h"
#include "complaint.h"
#include "scene_run.h"
#include "scratch_folder.h"
#include "true_sections_scene.h"

#include <rolling_contact/base/ranks.h>
#include <rolling_contact/contact/patch_area.h>
#include <rolling_contact/mesh/body_mesh.h>
#include <rolling_contact/mesh/rail_section_mesh.h>
#include <rolling_contact/mesh/running_surfaces.h>
#include <rolling_contact/mesh/section_shapes.h>
#include <rolling_contact/mesh/wheel_section_mesh.h>
#include <rolling_contact/pair/mesh_limits.h>
#include <rolling_contact/scene/known_entries.h>
#include <rolling_contact/surfaces/nominal_profiles.h>
#include <rolling_contact/surfaces/rail_section.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace RollingContact;
using namespace RollingContact::Profiles;

BOOST_AUTO_TEST_SUITE(true_sections)

namespace
{
  const double mm = 1e-3;

  /** A scene whose bodies are known. */
  Situation scene_with(const std::function<void(SceneParameters &)> &change)
  {
    SceneParameters scene;
    set_true_sections(scene);
    change(scene);
    scene.check();
    return Situation(scene);
  }

  Grading<3> small_patch()
  {
    Grading<3> grading;
    grading.element_size_x = 0.9 * mm;
    grading.element_size_y = 0.7 * mm;
    grading.zone_x         = 5 * mm;
    grading.zone_y         = 3 * mm;
    grading.zone_depth     = 3 * mm;
    grading.growth         = 0.8;
    return grading;
  }

  /** A profile with its contact at an arc length, coordinates along it. */
  PlacedProfile placed_at(const ProfileCurve &profile, const double contact)
  {
    return {profile,
            [contact, length = profile.length()](
              const double across) -> std::optional<double> {
              const double arc = contact + across;
              if (arc < 0. || arc > length)
                return {};
              return arc;
            }};
  }

  CoarseCells cells_of(const double size)
  {
    CoarseCells cells;
    cells.size = size;
    return cells;
  }

  /** Area and moments about the origin of quadrilaterals in parts. */
  SectionProperties properties_of(const SectionMesh &mesh,
                                  const unsigned int parts)
  {
    double area = 0., first_y = 0., first_z = 0., yy = 0., zz = 0.;
    for (unsigned int quad = 0; quad < mesh.quads().size(); ++quad)
      for (unsigned int i = 0; i < parts; ++i)
        for (unsigned int j = 0; j < parts; ++j)
          {
            std::vector<Outline::Point> corners;
            for (const auto &[di, dj] :
                 {std::pair<int, int>{0, 0}, {1, 0}, {1, 1}, {0, 1}})
              {
                const auto at =
                  mesh.at(quad, double(i + di) / parts, double(j + dj) / parts);
                corners.push_back({{at[0], at[1]}});
              }
            const auto part = section_properties(corners);
            double     y    = 0.; // of the part's centroid
            {
              double sum = 0.;
              for (unsigned int v = 0; v < 4; ++v)
                {
                  const auto [y0, z0] = corners[v];
                  const auto [y1, z1] = corners[(v + 1) % 4];
                  const double c      = (y0 * z1 - y1 * z0) / 2;
                  sum += c;
                  y += c * (y0 + y1) / 3;
                }
              y /= sum;
            }
            area += part.area;
            first_y += part.area * y;
            first_z += part.area * part.height;
            zz += part.I_y + part.area * part.height * part.height;
            yy += part.I_z + part.area * y * y;
          }
    return {area,
            first_z / area,
            zz - first_z * first_z / area,
            yy - first_y * first_y / area};
  }

  double relative(const double value, const double expected)
  {
    return std::abs(value / expected - 1);
  }
} // namespace

BOOST_AUTO_TEST_CASE(the_section_of_the_60e1_is_that_of_the_standard)
{
  const Outline half   = half_section_60e1();
  auto          points = half.points();
  const auto    mirror = half.scaled(-1., 1.);
  points.insert(points.end(), mirror.points().rbegin(), mirror.points().rend());
  const auto section = section_properties(points);
  BOOST_TEST(relative(section.area, 7670e-6) < 5e-4);
  BOOST_TEST(relative(section.height, 80.92e-3) < 1e-3);
  BOOST_TEST(relative(section.I_y, 3038.3e-8) < 1e-3);
  BOOST_TEST(relative(section.I_z, 512.3e-8) < 1e-3);
  // its head is the profile
  const ProfileCurve head = rail_head("60E1");
  for (double s = 10 * mm; s < head.length() / 2; s += 1 * mm)
    {
      const auto point = head.at(head.length() - s);
      if (rail_60e1_height - point.z < landmarks_60e1().side_end[1])
        continue;
      const Outline::Point there{{point.y, rail_60e1_height - point.z}};
      const auto           on = half.at(half.nearest(there));
      BOOST_TEST(std::hypot(on[0] - there[0], on[1] - there[1]) < 1e-6);
    }
}

BOOST_AUTO_TEST_CASE(coarse_sections_are_not_distorted_and_fill_the_outline)
{
  const ProfileCurve rail = rail_head("60E1"), wheel = s1002();
  for (const double size : {9 * mm, 11 * mm, 14 * mm, 17.9 * mm})
    for (double share = 0.3; share < 0.8; share += 0.1)
      {
        const auto on_rail =
          rail_surface(placed_at(rail, share * rail.length()));
        const auto quads = rail_section_mesh(on_rail, cells_of(size), size);
        BOOST_TEST_CONTEXT("size " << size << ", at " << share)
        {
          BOOST_TEST(quads.least_quality(1) > 0.2);
          BOOST_TEST(quads.least_quality(4) > 0.2);
          // the mesh's own error: coarse, and halved twice
          BOOST_TEST(relative(properties_of(quads, 1).area, 7670e-6) < 0.03);
          const auto section = properties_of(quads, 4);
          BOOST_TEST(relative(section.area, 7670e-6) < 2e-3);
          BOOST_TEST(relative(section.I_y, 3038.3e-8) < 3e-3);
          BOOST_TEST(relative(section.I_z, 512.3e-8) < 8e-3);
        }
        auto placed         = placed_at(wheel, share * wheel.length());
        placed.radius       = 0.46;
        placed.bow          = share > 0.5 ? 25 * mm : 0.;
        const auto on_wheel = wheel_surface(placed);
        const auto section  = wheel_section_mesh(
          placed, on_wheel, {0.46, 0.095}, 0.46, cells_of(size), size);
        BOOST_TEST_CONTEXT("wheel, size " << size << ", at " << share)
        {
          BOOST_TEST(section.least_quality(1) > 0.17);
          BOOST_TEST(section.least_quality(4) > 0.17);
        }
      }
}

namespace
{
  using Node = std::array<double, 2>;

  /** Vertices of the contact surface in the zone by (x, s). */
  std::map<Node, dealii::Point<3>> surface_nodes(const BodyMesh<3> &mesh,
                                                 const Grading<3>  &zone)
  {
    std::map<Node, dealii::Point<3>> nodes;
    const auto                       rounded = [](const double value) {
      return std::round(value / 1e-10) * 1e-10;
    };
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        {
          if (!cell->face(f)->at_boundary() ||
              cell->face(f)->boundary_id() != contact_boundary)
            continue;
          const auto box = mesh.chart_box(cell);
          if (!zone.in_zone({box.first[0], box.first[1]},
                            {box.second[0], box.second[1]}))
            continue;
          BOOST_TEST(
            relative(box.second[0] - box.first[0], zone.element_size_x) < 1e-9);
          BOOST_TEST(
            relative(box.second[1] - box.first[1], zone.element_size_y) < 1e-9);
          for (unsigned int v = 0; v < 4; ++v)
            {
              const unsigned int corner =
                dealii::GeometryInfo<3>::face_to_cell_vertices(f, v);
              const auto at = mesh.chart_point(cell, corner);
              BOOST_TEST(std::abs(at[2]) < 1e-12);
              nodes[{{rounded(at[0]), rounded(at[1])}}] = cell->vertex(corner);
            }
        }
    return nodes;
  }

  struct Pair
  {
    std::shared_ptr<const BodyShape> wheel, rail;
    BodyMesh<3>                      wheel_mesh, rail_mesh;
  };

  Pair bodies_of(const PairSpec &scene, const Grading<3> &grading)
  {
    Pair pair;
    pair.wheel      = scene.wheel.body_shape();
    pair.rail       = scene.rail.body_shape();
    pair.wheel_mesh = make_body_mesh<3>(pair.wheel, grading);
    pair.rail_mesh  = make_body_mesh<3>(pair.rail, grading);
    return pair;
  }

  /** Nodes of both bodies at the same places, and on their profiles. */
  void check_nodes(const PairSpec &scene, const Grading<3> &grading)
  {
    const Pair pair  = bodies_of(scene, grading);
    const auto wheel = surface_nodes(pair.wheel_mesh, grading),
               rail  = surface_nodes(pair.rail_mesh, grading);
    BOOST_TEST(wheel.size() > 50);
    BOOST_TEST(wheel.size() == rail.size());
    const auto &frame = *scene.frame;
    for (const auto &[at, vertex] : rail)
      {
        BOOST_TEST(wheel.count(at) == 1);
        BOOST_TEST(std::abs(vertex[0] - at[0]) < 1e-9);
        // the rail's point in the track, and from there in the frame
        const auto point =
          frame.wheel_on_rail().rail_profile().at(frame.rail_arc_length(at[1]));
        const auto here = frame.point_in_track(vertex[1], vertex[2]);
        BOOST_TEST(std::abs(here[0] - (frame.is_left() ? -point.y : point.y)) <
                   1e-9);
        BOOST_TEST(std::abs(here[1] + point.z) < 1e-9);
      }
    for (const auto &[at, vertex] : wheel)
      {
        const auto  &profile = frame.wheel_on_rail().wheel_profile();
        const double arc     = frame.wheel_arc_length(at[1]).value(),
                     radius  = 0.46 + profile.at(arc).z;
        BOOST_TEST(std::abs(vertex[0] - at[0]) < 1e-9);
        // along the axle it is where the profile is, and so far from it
        const double turn   = frame.roll() - frame.origin().angle,
                     y      = frame.is_left() ? -vertex[1] : vertex[1];
        const double axial  = y * std::cos(turn) + vertex[2] * std::sin(turn),
                     radial = -y * std::sin(turn) + vertex[2] * std::cos(turn);
        BOOST_TEST(std::abs(std::hypot(radial + frame.origin().rolling_radius,
                                       vertex[0]) -
                            radius) < 1e-9);
        BOOST_TEST(std::abs(axial - (profile.at(arc).y -
                                     frame.origin().y_wheel)) < 1e-9);
      }
  }
} // namespace

BOOST_AUTO_TEST_CASE(nodes_of_wheel_and_rail_face_each_other_on_the_profiles)
{
  Grading<3> grading = small_patch();
  grading.offset     = 0.3;
  for (const double shift : {-4 * mm, 3 * mm, 7 * mm})
    for (const SurfaceKind kind : {SurfaceKind::plane, SurfaceKind::curved})
      for (const bool left : {false, true})
        {
          if (left && shift < 0.)
            continue;
          BOOST_TEST_CONTEXT("shift " << shift << ", left " << left)
          check_nodes(scene_with([&](SceneParameters &scene) {
                        scene.profiles.shift        = left ? -shift : shift;
                        scene.profiles.surface_kind = kind;
                        scene.profiles.is_left      = left;
                      }),
                      grading);
        }
}

BOOST_AUTO_TEST_CASE(a_left_side_is_the_mirror_image_of_a_right_one)
{
  const auto side = [](const bool left) {
    return scene_with([&](SceneParameters &scene) {
      scene.profiles.is_left = left;
      scene.profiles.shift   = left ? -3 * mm : 3 * mm;
    });
  };
  const Pair right = bodies_of(side(false), small_patch()),
             left  = bodies_of(side(true), small_patch());
  for (const auto &[one, other] :
       {std::pair<const BodyMesh<3> *, const BodyMesh<3> *>{&right.wheel_mesh,
                                                            &left.wheel_mesh},
        {&right.rail_mesh, &left.rail_mesh}})
    {
      auto p = one->triangulation->get_vertices(),
           q = other->triangulation->get_vertices();
      BOOST_TEST(p.size() == q.size());
      for (auto &vertex : q)
        vertex[1] *= -1;
      const auto before = [](const auto &a, const auto &b) {
        for (unsigned int d = 0; d < 3; ++d)
          if (std::abs(a[d] - b[d]) > 1e-9)
            return a[d] < b[d];
        return false;
      };
      std::sort(p.begin(), p.end(), before);
      std::sort(q.begin(), q.end(), before);
      double largest = 0.;
      for (std::size_t i = 0; i < p.size(); ++i)
        largest = std::max(largest, p[i].distance(q[i]));
      BOOST_TEST(largest < 1e-9);
    }
}

BOOST_AUTO_TEST_CASE(a_wheel_has_the_volume_of_its_section_swept_round_the_axle)
{
  const auto scene = scene_with(
    [](SceneParameters &scene) { scene.profiles.web_bow = 20 * mm; });
  const auto grading = small_patch();
  const auto shape =
    std::dynamic_pointer_cast<const WheelShape>(scene.wheel.body_shape());
  BOOST_TEST_REQUIRE(shape != nullptr);
  const auto  mesh    = make_body_mesh<3>(shape, grading);
  const auto &section = mesh.swept->of_section();
  const auto  flat    = properties_of(section, 4);
  // Pappus: area by the way of its centroid
  const double volume = 2 * M_PI * flat.height * flat.area,
               meshed = dealii::GridTools::volume(*mesh.triangulation);
  BOOST_TEST(relative(meshed, volume) < 0.01);
  BOOST_TEST(meshed < volume);
  double least = 1e300;
  for (const auto &cell : mesh.triangulation->active_cell_iterators())
    least = std::min(least, cell->measure());
  BOOST_TEST(least > 0.);
  // a rail: prism
  const auto rail = make_body_mesh<3>(scene.rail.body_shape(), grading);
  BOOST_TEST(relative(dealii::GridTools::volume(*rail.triangulation),
                      0.6 * 7670e-6) < 0.03);
}

BOOST_AUTO_TEST_CASE(cells_are_foretold_and_the_same_when_distributed)
{
  const auto scene   = scene_with([](SceneParameters &) {});
  const auto grading = small_patch();
  for (const auto &shape : {scene.wheel.body_shape(), scene.rail.body_shape()})
    {
      const auto   serial = make_body_mesh<3>(shape, grading);
      const double n      = serial.triangulation->n_active_cells(),
                   least  = least_cells<3>(shape, grading);
      BOOST_TEST(least <= n);
      BOOST_TEST(n < 1.4 * least);
      BOOST_TEST(!shape->is_twin_of(*shape));
      if (Ranks::count() > 1)
        continue;
      const auto distributed =
        make_body_mesh<3>(shape, grading, MeshKind::distributed);
      BOOST_TEST(distributed.triangulation->n_global_active_cells() == n);
      BOOST_TEST(relative(dealii::GridTools::volume(*distributed.triangulation),
                          dealii::GridTools::volume(*serial.triangulation)) <
                 1e-12);
      BOOST_TEST(surface_nodes(distributed, grading).size() ==
                 surface_nodes(serial, grading).size());
    }
}

BOOST_AUTO_TEST_CASE(a_patch_on_the_tread_is_that_of_plain_bodies)
{
  const auto state = [](const bool sections, const bool left) {
    return SceneRun<3>(&set_true_sections, [&](SceneParameters &scene) {
      scene.profiles.true_sections = sections;
      scene.wheel.width = scene.rail.width = 0.1;
      scene.rail.block_depth               = 0.15;
      scene.profiles.is_left               = left;
      scene.profiles.shift                 = left ? -3 * mm : 3 * mm;
      scene.contact.creepages              = {1e-3,
                                 left ? -1e-3 : 1e-3,
                                 left ? -0.19 : 0.19};
    });
  };
  const auto plain = state(false, false), real = state(true, false),
             mirrored = state(true, true);
  BOOST_TEST(relative(real.steady.result.max_pressure,
                      plain.steady.result.max_pressure) < 0.01);
  BOOST_TEST(
    relative(patch_areas(real.steady.problem, real.steady.state).contact,
             patch_areas(plain.steady.problem, plain.steady.state).contact) <
    0.02);
  BOOST_TEST(std::abs(real.force_x() - plain.force_x()) < 0.03);
  BOOST_TEST(std::abs(real.force_y() - plain.force_y()) < 0.03);
  // web and neck give way: an approach of a quarter more
  BOOST_TEST(real.steady.state.approach > 1.1 * plain.steady.state.approach);
  BOOST_TEST(real.steady.state.approach < 1.6 * plain.steady.state.approach);
  BOOST_TEST(relative(mirrored.steady.state.approach,
                      real.steady.state.approach) < 1e-7);
  BOOST_TEST(std::abs(mirrored.force_x() - real.force_x()) < 1e-6);
  BOOST_TEST(std::abs(mirrored.force_y() + real.force_y()) < 1e-6);
}

BOOST_AUTO_TEST_CASE(measured_profiles_are_meshed_or_refused)
{
  const auto worn = scene_with([](SceneParameters &scene) {
    scene.prm_folder             = TEST_DATA "/../../prm";
    scene.profiles.wheel_profile = "profiles/worn_wheel.txt";
  });
  check_nodes(worn, small_patch());

  // a wheel cut before the tip of its flange, a head far from a 60E1's
  const auto cut = [](const ProfileCurve &curve, const auto &keep) {
    std::vector<CurvePoint> points;
    for (const CurvePoint &point : curve.points())
      if (keep(point))
        points.push_back(point);
    return ProfileCurve(points);
  };
  auto wheel =
    placed_at(cut(s1002(), [](const auto &p) { return p.y > -55 * mm; }),
              60 * mm);
  BOOST_TEST(contains(complaint([&]() { wheel_surface(wheel); }),
                      "before the back of its flange"));
  const auto rail = placed_at(cut(rail_head("60E1").shifted(15 * mm, 0.),
                                  [](const auto &p) { return p.z < 20 * mm; }),
                              55 * mm);
  BOOST_TEST(contains(complaint([&]() { rail_surface(rail); }),
                      "from the head of a 60E1"));
  // a head measured down to the gauge corner only
  const auto short_head =
    placed_at(cut(rail_head("60E1"),
                  [](const auto &p) { return p.z < 8 * mm; }),
              35 * mm);
  const auto surface = rail_surface(short_head);
  BOOST_TEST(
    rail_section_mesh(surface, cells_of(12 * mm), 12 * mm).least_quality(4) >
    0.2);
}

namespace
{
  /** The hollow wheel's file, with a rim that ends so far from y = 0, mm. */
  std::string hollow_wheel(const double end)
  {
    std::istringstream lines(
      read(TEST_DATA "/../../prm/profiles/hollow_wheel.txt"));
    std::string text;
    for (std::string line; std::getline(lines, line);)
      if (line[0] == '#' || std::stod(line) < end)
        text += line + "\n";
    return text;
  }
} // namespace

BOOST_AUTO_TEST_CASE(a_hollow_tread_is_meshed_to_the_end_of_its_rim)
{
  for (const double end : {41., 42., 44., 59.})
    {
      const ScratchFolder folder;
      write(folder.scratch / "wheel.txt", hollow_wheel(end));
      const auto          scene   = scene_with([&](SceneParameters &scene) {
        scene.prm_folder             = folder.scratch;
        scene.profiles.wheel_profile = "wheel.txt";
      });
      const ProfileCurve &profile = scene.wheel.profile->profile;
      auto placed   = placed_at(profile, profile.length() - 4 * mm);
      placed.radius = 0.46;
      for (const double size : {5.2 * mm, 10.5 * mm})
        BOOST_TEST_CONTEXT("rim to " << end << " mm, size " << size)
        {
          BOOST_TEST(wheel_section_mesh(placed,
                                        wheel_surface(placed),
                                        {0.46, 0.095},
                                        0.46,
                                        cells_of(size),
                                        size)
                       .least_quality(4) > 0.05);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_zone_ends_where_sections_no_longer_face_each_other)
{
  const ScratchFolder folder;
  write(folder.scratch / "wheel.txt", hollow_wheel(41.4));
  const auto state = [&](const bool sections) {
    return SceneRun<3>(&set_true_sections, [&](SceneParameters &scene) {
      scene.prm_folder             = folder.scratch;
      scene.profiles.wheel_profile = "wheel.txt";
      scene.profiles.true_sections = sections;
      scene.wheel.width = scene.rail.width = 0.1;
      scene.rail.block_depth               = 0.15;
      scene.profiles.shift                 = -30 * mm;
      scene.profiles.roll.reset();
      scene.contact.normal_load = 60e3;
    });
  };
  const auto plain = state(false), real = state(true);
  const auto room = room_of_sections(real.situation());
  // the free side of the rim takes a little of the pressure
  BOOST_TEST(relative(real.steady.result.max_pressure,
                      plain.steady.result.max_pressure) < 0.01);
  BOOST_TEST(real.steady.grading.zone_across()[1] == room[1]);
  BOOST_TEST(plain.steady.grading.zone_across()[1] > room[1]);
}

BOOST_AUTO_TEST_CASE(what_makes_no_sense_is_refused_or_told)
{
  const auto refused = [](const std::function<void(SceneParameters &)> &change,
                          const std::string                            &text) {
    const std::string said = complaint([&]() { scene_with(change); });
    BOOST_TEST(contains(said, text), said);
  };
  refused([](SceneParameters &scene) { scene.wheel.shape = "block"; },
          "Wheel/Shape = block and Profiles/Body sections = true");
  refused([](SceneParameters &scene) { scene.wheel.hub_radius = 0.35; },
          "Wheel/Hub radius = 0.35: with Profiles/Body sections = true");
  refused([](SceneParameters &scene) { scene.wheel.hub_radius = 0.02; },
          "give 0.05 m up to 0.292 m");
  refused([](SceneParameters &scene) { scene.rail.block_length = 0.05; },
          "Rail/Block length = 0.05");
  refused([](SceneParameters &scene) { scene.profiles.web_bow = 0.1; },
          "Profiles/Web bow = 0.1");

  const auto scene = scene_with([](SceneParameters &scene) {
    scene.wheel.rigid = true; // as it is: a surface without a body
  });
  BOOST_TEST(!scene.wheel.body_shape()->is_swept());
  BOOST_TEST(scene.rail.body_shape()->is_swept());
  PrmEntries given;
  given["Rail/Block depth"]  = "0.2";
  given["Wheel/Width"]       = "0.2";
  given["Rail/Block length"] = "0.6";
  const auto told            = unused_entries(*scene.inputs, given);
  BOOST_TEST(told.size() == 2u);
  for (const std::string &sentence : told)
    BOOST_TEST(contains(sentence, "Profiles/Body sections = true"));
}

BOOST_AUTO_TEST_SUITE_END()
