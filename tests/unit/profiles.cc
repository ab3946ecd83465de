#include <boost/algorithm/string.hpp>
#include <boost/test/unit_test.hpp>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/profiles/conicity.h>
#include <rolling_contact/profiles/contact_search.h>
#include <rolling_contact/profiles/nominal_profiles.h>
#include <rolling_contact/profiles/profile_file.h>
#include <rolling_contact/profiles/smoothing_spline.h>

#include <cmath>
#include <fstream>
#include <random>

using namespace RollingContact;
using namespace RollingContact::Profiles;

BOOST_AUTO_TEST_SUITE(profiles)

namespace
{
  const double mm = 1e-3, radius = 0.46, tape_circle = 0.75;

  const std::string data = TEST_DATA;

  ProfileCurve
  placed(const ProfileCurve &section, const double inclination = 1. / 40)
  {
    return placed_rail(section, inclination, 1.435, 0.014);
  }

  /** The profile's z at a y. */
  double
  z_at(const ProfileCurve &curve, const double y)
  {
    return curve.at(ArcLengthAtY(curve)(y)).z;
  }

  /** A row of a table of numbers. */
  using Values = std::vector<double>;

  std::vector<Values>
  table(const std::string &name)
  {
    std::vector<Values> rows;
    std::ifstream       file(data + "/" + name);
    for (std::string line; std::getline(file, line);)
      {
        if (line.empty() || line[0] == '#')
          continue;
        std::vector<std::string> words;
        boost::split(words, line, boost::is_any_of(","));
        rows.emplace_back();
        for (const std::string &word : words)
          rows.back().push_back(std::stod(word));
      }
    BOOST_REQUIRE(!rows.empty());
    return rows;
  }

  struct Noisy
  {
    explicit Noisy(const double amplitude)
      : normal(0., amplitude)
    {}

    double
    operator()()
    {
      return normal(engine);
    }

    std::mt19937                     engine{7};
    std::normal_distribution<double> normal;
  };
} // namespace

BOOST_AUTO_TEST_CASE(the_silhouette_touches_where_contact_finds_it)
{
  const ProfileCurve rail = placed(rail_60e1_manchester());
  const WheelOnRail  side(s1002(), rail, radius, tape_circle);
  for (const Values &row : table("manchester_a22.csv"))
    {
      const double           sign = row[0];
      const WheelsetPosition position{sign * mm * row[2],
                                      sign * row[4],
                                      sign * row[3]};
      const RigidContact     found = side.first_contact(position);
      BOOST_TEST_MESSAGE(row[0]
                         << ' ' << row[1] << " height " << 1e3 * found.height
                         << ' ' << row[5] << " approach " << row[8]
                         << " diff um " << 1e3 * (row[5] - 1e3 * found.height)
                         << " angle " << found.angle << ' ' << row[6] << " yw "
                         << found.y_wheel * 1e3 << ' ' << row[7]);
    }
}

BOOST_AUTO_TEST_SUITE_END()
