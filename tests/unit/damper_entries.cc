#include <boost/test/unit_test.hpp>

#include "complaint.h"

#include <rolling_contact/scene/body_parameters.h>

#include <functional>

using namespace RollingContact;

/** Entries of section Wheel for dampers. */
BOOST_AUTO_TEST_SUITE(damper_entries)

BOOST_AUTO_TEST_CASE(lists_of_dampers_fit_each_other)
{
  BodyParameters wheel("Wheel");
  wheel.radius     = 0.46;
  wheel.hub_radius = 0.1;
  wheel.width      = 0.1;
  BOOST_TEST(wheel.absorbers().empty());
  wheel.dampers.number        = {12., 8.};
  wheel.dampers.mass          = {1.};
  wheel.dampers.frequency     = {400., 1000.};
  wheel.dampers.damping_ratio = {0.1};
  wheel.dampers.radius        = {0.4};
  wheel.dampers.position      = {0.01};
  wheel.dampers.direction     = "axial, radial";
  const auto rings            = wheel.absorbers();
  BOOST_REQUIRE(rings.size() == 2u);
  BOOST_TEST(rings[1].number == 8u);
  BOOST_TEST(rings[1].most_diameters() == 3u);
  BOOST_TEST(rings[1].frequency == 1000.);
  BOOST_TEST(rings[1].mass == 1.);
  BOOST_TEST((rings[1].direction == AbsorberDirection::radial));
  const auto says = [&](const std::function<void(BodyParameters &)> &change,
                        const std::string                           &text,
                        const unsigned int                           dim = 3) {
    BodyParameters changed = wheel;
    change(changed);
    const std::string said = complaint([&]() { changed.check(dim); });
    BOOST_TEST(said.find(text) != std::string::npos, said);
  };
  says(
    [](auto &it) {
      it.dampers.mass = {1., 1., 1.};
    },
    "Wheel/Damper mass: 3 values, and Dampers has 2");
  says([](auto &it) { it.dampers.mass.clear(); },
       "Wheel/Damper mass: 0 values");
  says([](auto &it) { it.dampers.direction = "axial, radial, axial"; },
       "Wheel/Damper direction");
  says([](auto &it) { it.dampers.number = {12., 2.}; }, "Wheel/Dampers = 2");
  says([](auto &it) { it.dampers.number = {4.5, 5.}; }, "Wheel/Dampers = 4.5");
  says([](auto &it) { it.dampers.mass = {0.}; }, "Wheel/Damper mass = 0");
  says([](auto &it) { it.dampers.frequency = {0.}; },
       "Wheel/Damper frequency = 0");
  says([](auto &it) { it.dampers.damping_ratio = {1.}; },
       "Wheel/Damper damping ratio = 1");
  says([](auto &it) { it.dampers.radius = {0.}; }, "Wheel/Damper radius = 0");
  says([](auto &) {}, "Dimension = 3", 2);
  says([](auto &it) { it.rigid = true; }, "a rigid wheel");
}

BOOST_AUTO_TEST_SUITE_END()
