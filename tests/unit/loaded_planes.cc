#include <boost/test/unit_test.hpp>

#include "scene_run.h"
#include "wheel_on_block.h"

#include <rolling_contact/mesh/profile_patch.h>
#include <rolling_contact/surfaces/nominal_profiles.h>

#include <cmath>

using namespace RollingContact;
using namespace RollingContact::Profiles;

BOOST_AUTO_TEST_SUITE(loaded_planes)

namespace
{
  const double mm = 1e-3, load = 50e3;

  const PressedHalfSpaces steel{Material{210e9, 0.3},
                                Material{210e9, 0.3},
                                load,
                                0.};

  std::shared_ptr<const ContactFrame>
  first_contact(const double shift, const double yaw, const bool is_left)
  {
    const auto profiles = std::make_shared<const WheelOnRail>(
      s1002(),
      placed_rail(rail_head("60E1"), 1. / 40, 1.435, 0.014),
      0.46,
      0.75);
    return std::make_shared<const ContactFrame>(
      profiles, WheelsetPosition{shift, 0., yaw}, is_left);
  }

  /** The wheel S1002 on 60E1 at 1 mm, as squeal_limit_cycle has it. */
  void in_the_curve(SceneParameters &scene)
  {
    scene                              = wheel_on_block(10);
    scene.contact.vertical_load        = load;
    scene.contact.friction_coefficient = 0.;
    scene.profiles.wheel_profile       = "S1002";
    scene.profiles.rail_profile        = "60E1";
    scene.profiles.shift               = 1 * mm;
    scene.profiles.roll                = 0.;
  }

  /** Force on the wheel to the right in the track. */
  double to_the_right(const SceneRun<3> &run)
  {
    const Resultants &found = run.steady.result;
    return run.situation().frame->in_track(found.force_y,
                                           found.normal_force)[0];
  }

  SceneRun<3> on(const SurfaceKind kind)
  {
    return SceneRun<3>(in_the_curve, [&](SceneParameters &scene) {
      scene.profiles.surface_kind = kind;
    });
  }
} // namespace

/** At 1 mm wheel and rail touch first where the slope is 0.069; the state on a
 * curved surface has the patch of 50 kN 2.84 mm away, and pushes to the side by
 * 0.0579 of its vertical force. */
BOOST_AUTO_TEST_CASE(the_patch_is_beside_the_first_contact)
{
  const auto first = first_contact(1 * mm, 0., false),
             plane = frame_at_patch(first, steel);
  BOOST_TEST(std::abs(first->angle()) == 0.069,
             boost::test_tools::tolerance(0.02));
  BOOST_TEST(std::abs(plane->track_y() - first->track_y()) == 2.84 * mm,
             boost::test_tools::tolerance(0.03));
  BOOST_TEST(std::abs(plane->angle()) == 0.0579,
             boost::test_tools::tolerance(0.01));
  const double       modulus = 210e9 / (2 * 0.91);
  const ProfilePatch patch   = profile_patch(*plane, modulus, load, 0.);
  BOOST_TEST_MESSAGE("middle " << patch.middle << ", slope " << patch.slope);
  BOOST_TEST(std::abs(patch.middle) < 5e-6);
  BOOST_TEST(std::abs(patch.slope) < 5e-6);
  // the surfaces still touch where they touched
  double least = 1.;
  for (double s = -0.02; s <= 0.02; s += 1e-4)
    if (const auto gap = plane->gap(0., s))
      least = std::min(least, *gap);
  BOOST_TEST(std::abs(least) < 1e-8);
}

BOOST_AUTO_TEST_CASE(without_load_it_is_the_plane_of_the_first_contact)
{
  const auto        first = first_contact(3 * mm, 0., false);
  PressedHalfSpaces light = steel;
  light.load              = 1.;
  const auto plane        = frame_at_patch(first, light);
  BOOST_TEST(std::abs(plane->angle() - first->angle()) < 5e-4);
  BOOST_TEST(std::abs(plane->track_y() - first->track_y()) < 0.1 * mm);
  light.load = 0.;
  BOOST_TEST(frame_at_patch(first, light) == first);
}

BOOST_AUTO_TEST_CASE(the_left_side_mirrors_the_right)
{
  const auto right = frame_at_patch(first_contact(1 * mm, 5e-3, false), steel),
             left  = frame_at_patch(first_contact(-1 * mm, -5e-3, true), steel);
  const auto same  = boost::test_tools::tolerance(1e-8);
  BOOST_TEST(left->angle() == -right->angle(), same);
  BOOST_TEST(left->track_y() == -right->track_y(), same);
  for (const double s : {-3 * mm, 2 * mm})
    BOOST_TEST(left->gap(1 * mm, -s).value() == right->gap(1 * mm, s).value(),
               same);
  // the frame has turned with the wheelset: least gaps are at x = 0 there
  const double h = 1e-4;
  BOOST_TEST(std::abs(*right->gap(h, 0.) - *right->gap(-h, 0.)) < 1e-9);
}

/** Without friction each node of a curved surface presses along its own normal:
 * by so much the track is pushed aside. One plane at the patch has the mean. */
BOOST_AUTO_TEST_CASE(the_lateral_force_is_that_of_a_curved_surface)
{
  const double curved   = to_the_right(on(SurfaceKind::curved)),
               at_patch = to_the_right(on(SurfaceKind::loaded_plane)),
               at_first = to_the_right(on(SurfaceKind::plane));
  BOOST_TEST_MESSAGE("lateral force "
                     << curved << ", in the plane at the patch " << at_patch
                     << ", at the first contact " << at_first);
  BOOST_TEST(std::abs(at_patch - curved) < 2e-4 * load);
  BOOST_TEST(std::abs(at_first - curved) > 0.01 * load);
}

BOOST_AUTO_TEST_SUITE_END()
