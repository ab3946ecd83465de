#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <rolling_contact/analyses/receptance_parameters.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/input/number_list.h>
#include <rolling_contact/scene/entries.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    const char place_form[] =
      "name: wheel or rail, x, y, z in m, several separated by semicolons, such "
      "as \"web: wheel, 0, 0, 0.3; foot: rail, 0.3, 0, -0.17\".";

    ReceptanceParameters::Place read_place(const std::string &text)
    {
      const auto fail = [&](const std::string &what) {
        throw InputError("Receptance/Points: \"" + text + "\" " + what +
                         "; give " + place_form);
      };
      const auto parts = Utilities::split_string_list(text, ':');
      if (parts.size() != 2 || parts[0].empty())
        fail("is no named place");
      const auto words = Utilities::split_string_list(parts[1], ',');
      if (words.size() != 4)
        fail("needs a body and three coordinates");
      if (words[0] != "wheel" && words[0] != "rail")
        fail("names the body " + words[0] + ", not wheel or rail");
      ReceptanceParameters::Place place{
        parts[0], words[0] == "wheel" ? Side::wheel : Side::rail, {}};
      for (unsigned int d = 0; d < 3; ++d)
        {
          const auto value = number(words[1 + d]);
          if (!value)
            fail("has no number in \"" + words[1 + d] + "\"");
          place.point[d] = *value;
        }
      return place;
    }

    std::vector<ReceptanceParameters::Place>
    read_places(const std::string &text)
    {
      std::vector<ReceptanceParameters::Place> places;
      for (const std::string &part : Utilities::split_string_list(text, ';'))
        if (!part.empty())
          places.push_back(read_place(part));
      return places;
    }
  } // namespace

  void ReceptanceParameters::declare(Entries &entries)
  {
    entries.section("Receptance").read_by_analyses("receptance");
    entries.add("Lowest frequency", lowest_frequency, "Hz").at_least(0.).help =
      "First frequency of the receptances.";
    entries.add("Highest frequency", highest_frequency, "Hz")
      .at_least(0.)
      .help =
      "Last frequency of the receptances. Modes are found up to Modes/Cut-off "
      "ratio times it.";
    entries.add("Frequencies per octave", per_octave, "1")
      .between(1, 1000)
      .help =
      "Number of frequencies in an octave, with equal ratios. Frequencies of "
      "lightly damped modes are added.";
    entries.add("Points", points).help =
      "Named places beside `contact`, the contact point of "
      "each body: " +
      std::string(place_form);
    entries.add("Directions", directions).help =
      "Directions of forces and motions: x along the track, y across it, z "
      "vertical, separated by commas.";
    entries.add("Load radius", load_radius, "m").at_least(0.).help =
      "A force is spread over the part of the body within this distance of "
      "its place, and a motion is the mean over that part. A force on a point "
      "would give a receptance that grows with every refinement of the mesh.";
    entries.list("Check frequencies", check_frequencies, "", "Hz").help =
      "Frequencies at which the equations of the whole body are solved as "
      "well, with a complex factorisation, to tell the error of the modes: " +
      std::string(number_list_form) + ".";
    entries.add("Decay rates", decay_rates).help =
      "Whether track_decay.csv is written: by how many dB/m the vertical and "
      "the lateral vibration of the rail fade from its contact point, in "
      "third octaves from 100 Hz to 5 kHz, as EN 15461 measures it.";
    entries.add("Measured wheel", measured_wheel).help =
      "File with columns of frequency (Hz) and absolute receptance (m/N), "
      "relative to the folder of the .prm file. It is drawn beside the "
      "wheel's point receptance in the first of Directions.";
    entries.add("Measured rail", measured_rail).help =
      "File with columns of frequency (Hz) and absolute receptance (m/N), "
      "relative to the folder of the .prm file. It is drawn beside the rail's "
      "point receptance in the first of Directions.";
  }

  void ReceptanceParameters::check_in_2d() const
  {
    for (const unsigned int axis : axes())
      if (axis == 1)
        throw InputError("Receptance/Directions = " + directions +
                         ": in 2D nothing moves along y; give z or x.");
  }

  void ReceptanceParameters::check() const
  {
    axes();
    if (!(lowest_frequency > 0.))
      throw InputError(
        "Receptance/Lowest frequency = " + text_of(lowest_frequency) +
        ": it must be above 0 Hz; hammers reach down to 20 Hz.");
    if (!(highest_frequency > lowest_frequency))
      throw InputError(
        "Receptance/Highest frequency = " + text_of(highest_frequency) +
        ": it must be above Lowest frequency = " + text_of(lowest_frequency) +
        " Hz.");
    for (const double frequency : check_frequencies)
      if (!(frequency > 0. && frequency <= highest_frequency))
        throw InputError("Receptance/Check frequencies contains " +
                         text_of(frequency) +
                         "; each must be above 0 Hz and at most "
                         "Highest frequency = " +
                         text_of(highest_frequency) + " Hz.");
    const auto named = read_places(points);
    for (const Place &place : named)
      if (place.name == "contact" ||
          std::count_if(named.begin(), named.end(), [&](const Place &other) {
            return other.name == place.name && other.side == place.side;
          }) > 1)
        throw InputError("Receptance/Points: there is more than one place "
                         "with the name " +
                         place.name + " on the " + name_of(place.side) + ".");
  }

  std::vector<ReceptanceParameters::Place>
  ReceptanceParameters::places(const Side side) const
  {
    std::vector<Place> result{{"contact", side, {}}};
    for (const Place &place : read_places(points))
      if (place.side == side)
        result.push_back(place);
    return result;
  }

  std::vector<unsigned int> ReceptanceParameters::axes() const
  {
    std::vector<unsigned int> result;
    for (const std::string &word :
         Utilities::split_string_list(directions, ','))
      {
        const std::size_t axis = std::string("xyz").find(word);
        if (word.size() != 1 || axis == std::string::npos)
          throw InputError("Receptance/Directions = " + directions + ": \"" +
                           word +
                           "\" is not x, y or z; separate "
                           "directions by commas.");
        if (std::count(result.begin(), result.end(), axis) == 0)
          result.push_back(axis);
      }
    if (result.empty())
      throw InputError("Receptance/Directions is empty: give some of x, y and "
                       "z, separated by commas.");
    return result;
  }

  std::vector<double> ReceptanceParameters::frequencies() const
  {
    const double octaves = std::log2(highest_frequency / lowest_frequency);
    const auto   n       = std::max<long>(1, std::lround(octaves * per_octave));
    std::vector<double> result;
    for (long k = 0; k <= n; ++k)
      result.push_back(lowest_frequency * std::exp2(octaves * k / n));
    return result;
  }
} // namespace RollingContact
