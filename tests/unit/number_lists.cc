#include <boost/test/unit_test.hpp>

#include "complaint.h"

#include <rolling_contact/input/number_list.h>

using namespace RollingContact;

/** Lists of numbers in one entry of a .prm file. */
BOOST_AUTO_TEST_SUITE(number_lists)

namespace
{
  std::string said_of(const std::string &text)
  {
    return complaint([&]() { number_list("Load curve/Shares of load", text); });
  }
} // namespace

BOOST_AUTO_TEST_CASE(a_list_is_taken_as_it_stands)
{
  const std::vector<double> list       = number_list("x", " 1,2.5 , -3e-3");
  const double              expected[] = {1., 2.5, -3e-3};
  BOOST_TEST(list == expected, boost::test_tools::per_element());
  BOOST_TEST(number_list("x", "7").size() == 1u);
  for (const char *text : {"", " ", "1, two", "1 2", "nan", "inf", "1e999"})
    BOOST_TEST(contains(said_of(text), "Load curve/Shares of load = "), text);
}

BOOST_AUTO_TEST_CASE(a_range_ends_at_its_ends)
{
  for (unsigned int n = 2; n < 200; ++n)
    for (const auto &[first, last] : {std::pair("0.2", "1"),
                                      std::pair("-0.3", "0.7"),
                                      std::pair("1", "0.1")})
      {
        const std::vector<double> list = number_list(
          "x", std::string(first) + " : " + last + " : " + std::to_string(n));
        BOOST_REQUIRE(list.size() == n);
        BOOST_TEST(list.front() == std::stod(first));
        BOOST_TEST(list.back() == std::stod(last));
      }
}

BOOST_AUTO_TEST_CASE(ranges_that_are_none)
{
  for (const char *text :
       {"1 : 2", "1 : 2 : 1", "1 : 2 : 2.5", "1 : 2 : 1e7", "1:2:3:4", "1::3"})
    BOOST_TEST(contains(said_of(text), "Load curve/Shares of load = "), text);
  // no point of these is a number
  for (const char *text : {"-1e308 : 1e308 : 3", "0 : 1e308 : 100"})
    BOOST_TEST(contains(said_of(text), "too far apart"), text);
}

BOOST_AUTO_TEST_CASE(speeds_are_sorted_and_above_zero)
{
  const std::vector<double> speeds = speeds_or(7., "Impact/Speeds", "3, 1, 3"),
                            one    = speeds_or(7., "Impact/Speeds", "");
  const double expected[]          = {1., 3.};
  BOOST_TEST(speeds == expected, boost::test_tools::per_element());
  BOOST_TEST(one == std::vector<double>{7.}, boost::test_tools::per_element());
  BOOST_TEST(complaint([]() { speeds_or(7., "Impact/Speeds", "2, -1"); }) ==
             "Impact/Speeds = 2, -1: -1 is among them; give numbers above 0 "
             "m/s.");
}

BOOST_AUTO_TEST_SUITE_END()
