#include <boost/test/unit_test.hpp>

#include "drawing_run.h"

#include <rolling_contact/base/constants.h>
#include <rolling_contact/program/analysis_table.h>
#include <rolling_contact/scene/scene_entries.h>
#include <rolling_contact/tables/stability_map_plot.h>

#include <cmath>

using namespace RollingContact;

/** Analysis = stability map: axes of its own, and what becomes of rows. */
BOOST_AUTO_TEST_SUITE(stability_maps)

BOOST_AUTO_TEST_CASE(a_creepage_by_size_and_direction)
{
  ContactParameters contact;
  contact.normal_load        = 1e4;
  contact.creepage_size      = 0.02;
  contact.creepage_direction = pi / 2;
  contact.creepages          = contact.asked_creepages();
  BOOST_TEST(contact.creepages.x == 0.);
  BOOST_TEST(contact.creepages.y == 0.02);
  contact.creepage_direction = -pi / 6;
  contact.creepages          = contact.asked_creepages();
  BOOST_TEST(contact.creepages.x == 0.01 * std::sqrt(3.),
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(contact.creepages.y == -0.01, boost::test_tools::tolerance(1e-12));
  contact.check(3); // what follows from it is no contradiction
  BOOST_TEST(complaint([&]() { contact.check(2); }).find("in 2D") !=
             std::string::npos);
  contact.creepages.y = 0.001;
  BOOST_TEST(complaint([&]() {
               contact.check(3);
             }).find("the size with its direction or the components") !=
             std::string::npos);
}

BOOST_AUTO_TEST_CASE(entries_that_states_of_a_map_may_differ_by)
{
  SceneParameters scene;
  scene.dimension             = 3;
  scene.contact.normal_load   = 1e4;
  scene.contact.creepages.y   = 0.;
  scene.contact.creepage_size = 0.01;
  scene.wheel.lateral_radius  = 0.3;
  scene.contact.speed         = 10.;
  scene.contact.slip_operator = SlipOperatorKind::upwind_2;
  scene.table.axis_texts[0]   = "Stability/Added damping = 0, 0.001";
  scene.analysis              = analysis_kind("stability map");
  SceneEntries      map{Situation(scene)};
  const std::string key = map.bodies_key();
  map.check_variable("Stability/Added damping", "");
  map.set("Stability/Added damping", "0.001");
  map.check_variable("Wheel/Damper mass", "");
  map.set("Wheel/Damper mass", "0.3");
  map.set("Contact/Creepage direction", "3.141592653589793");
  BOOST_TEST(map.bodies_key() == key); // on the same bodies
  const Situation changed = map.situation();
  BOOST_TEST(changed.inputs->stability.added_damping == 0.001);
  BOOST_TEST(changed.wheel.dampers.mass == std::vector<double>{0.3});
  map.set("Wheel/Damper radius", "0.3");
  BOOST_TEST(map.bodies_key() != key); // on another circle
  BOOST_TEST(changed.contact.creepages.x == -0.01);
  BOOST_TEST(changed.contact.creepages.y == 0.);

  scene.analysis = analysis_kind("table");
  const SceneEntries table{Situation(scene)};
  BOOST_TEST(complaint([&]() {
               table.check_variable("Stability/Added damping", "");
             }).find("cannot vary between states") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(vibrations_in_a_cell)
{
  const std::string text = text_of({{1035.125, 1.25}, {386., -0.5}});
  BOOST_TEST(text == "1035.125:1.25 386:-0.5");
  const auto read = vibrations_of(text, 0);
  BOOST_REQUIRE(read.size() == 2u);
  BOOST_TEST(read[0].frequency == 1035.125);
  BOOST_TEST(read[1].growth == -0.5);
  BOOST_TEST(vibrations_of("", 0).empty());
  BOOST_TEST(complaint([]() {
               vibrations_of("1035.1;1.2", 6);
             }).find("row 7: column vibrations has \"1035.1;1.2\"") !=
             std::string::npos);
}

/** Two vibrations whose frequencies come near each other, one of which leaves
 * the list for a value, and one that is far from both. */
BOOST_AUTO_TEST_CASE(branches_along_an_axis)
{
  const std::vector<double>                       mu{0.1, 0.2, 0.3, 0.4};
  const std::vector<std::vector<ListedVibration>> vibrations{
    {{1000., -1.}, {1012., -2.}},
    {{1010., -2.}, {1002., 0.5}}, // listed in another order
    {{1004., 2.}},
    {{1006., 4.}, {1500., 0.1}, {1007., -2.}}};
  const std::vector<Branch> all = branches(mu, vibrations);
  BOOST_REQUIRE(all.size() == 4u);
  BOOST_TEST(all[0].at == mu, boost::test_tools::per_element());
  BOOST_TEST(all[0].vibrations[1].frequency == 1002.);
  BOOST_TEST(all[0].vibrations[3].frequency == 1006.);
  BOOST_TEST(all[0].largest_growth() == 4.);
  BOOST_TEST(all[1].at.size() == 2u);
  BOOST_TEST(all[1].vibrations[1].frequency == 1010.);
  BOOST_TEST(all[1].largest_growth() == -2.);
  BOOST_TEST(all[2].at[0] == 0.4);
  BOOST_TEST(all[2].vibrations[0].frequency == 1500.);
}

BOOST_AUTO_TEST_SUITE_END()
