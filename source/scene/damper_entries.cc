#include <boost/algorithm/string.hpp>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/scene/body_parameters.h>
#include <rolling_contact/scene/entries.h>
#include <rolling_contact/scene/scene_parameters.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    const std::vector<NamedValue<AbsorberDirection>> named_directions{
      {"axial", AbsorberDirection::axial},
      {"radial", AbsorberDirection::radial},
      {"circumferential", AbsorberDirection::circumferential}};

    const unsigned int fewest_dampers = 3;

    std::vector<std::string> parts_of(const std::string &text,
                                      const char         separator)
    {
      std::vector<std::string> parts;
      boost::split(parts, text, [&](const char c) { return c == separator; });
      for (std::string &part : parts)
        boost::trim(part);
      return parts;
    }

    /** "frequency : ratio, ..." */
    std::vector<std::pair<double, double>>
    mode_damping(const std::string &entry, const std::string &text)
    {
      std::vector<std::pair<double, double>> modes;
      if (text.empty())
        return modes;
      for (const std::string &pair : parts_of(text, ','))
        {
          const auto values = parts_of(pair, ':');
          const auto f = number(values[0]), zeta = values.size() == 2
                                                     ? number(values[1])
                                                     : std::optional<double>();
          if (!f || !zeta || !(*f > 0.) || !(*zeta >= 0. && *zeta < 1.))
            throw InputError(
              entry + " = " + text + ": `" + pair +
              "` is no `frequency : damping ratio`; give the first in Hz, "
              "above 0, the second at least 0 and below 1, as in 392 : 5e-3, "
              "1046 : 2e-3.");
          modes.emplace_back(*f, *zeta);
        }
      return modes;
    }

    /** The value of ring k of a list with one for each or one for all. */
    double value_of_ring(const std::vector<double> &values, const std::size_t k)
    {
      return values[values.size() == 1 ? 0 : k];
    }
  } // namespace

  void BodyParameters::declare_dampers(Entries &entries)
  {
    const auto read = [this](const std::string &text) {
      model.damping.of_modes = mode_damping(section + "/Mode damping", text);
    };
    entries.parsed("Mode damping", Entry::Kind::text, "", "Hz, 1", read)
      .read_by(analyses_of_modes())
      .read_by(reader(
        [](const BodyParameters &body) {
          return body.modes != ModeModel::waveguide;
        },
        "a rail with Model = waveguide has waves in place of modes"))
      .help =
      "Damping ratios of single modes in addition to Modal damping, such as "
      "those by a ring damper: `frequency : ratio, ...`. Each holds for the "
      "mode nearest to that frequency and for its pair.";
    if (section != "Wheel")
      return;
    const Reader hang_on_modes{
      [](const SceneParameters &scene) {
        return scene.analysis.has_dampers || scene.has_reduced_bodies();
      },
      "dampers need modes: Analysis = receptance, stability or stability map, "
      "or Time/Bodies = reduced"};
    entries.list("Dampers", dampers.number, "", "1")
      .read_by(hang_on_modes)
      .help =
      "Number of tuned dampers (point masses on springs and dashpots) on the "
      "wheel, equally spaced on a circle. For several circles give a list. "
      "Dampers need modes: Analysis = stability, stability map, receptance, "
      "and Time/Bodies = reduced.";
    const std::vector<Reader> there{
      hang_on_modes,
      {[](const SceneParameters &scene) {
         return !scene.wheel.dampers.number.empty();
       },
       "there are no dampers, Dampers is empty"}};
    entries.list("Damper mass", dampers.mass, "", "kg")
      .read_by(there)
      .renewing(Renews::loads)
      .help =
      "Mass of each damper. This and all other lists of dampers have one "
      "value for each circle, or one for all circles.";
    entries.list("Damper frequency", dampers.frequency, "", "Hz")
      .read_by(there)
      .renewing(Renews::loads)
      .help = "Eigenfrequency of a damper on a wheel that does not move.";
    entries.list("Damper damping ratio", dampers.damping_ratio, "", "1")
      .read_by(there)
      .renewing(Renews::loads)
      .help = "Damping ratio of a damper on a wheel that does not move.";
    entries.list("Damper radius", dampers.radius, "", "m").read_by(there).help =
      "Radius of the circle that the dampers are fixed on. The nearest circle "
      "of nodes is taken.";
    entries.list("Damper position", dampers.position, "", "m")
      .read_by(there)
      .help =
      "Position of the circle of dampers along the axle: y of the wheel's "
      "section, or for a disc the distance from its middle.";
    entries.add("Damper direction", dampers.direction)
      .one_of(choice_names(named_directions))
      .several(0)
      .read_by(there)
      .help = "Direction in which springs and dashpots act: `axial`, `radial` "
              "or `circumferential`. In the other directions the dampers have "
              "no effect. For several circles give a list, or one for all.";
  }

  std::vector<AbsorberRing> BodyParameters::absorbers() const
  {
    const std::size_t n = dampers.number.size();
    for (const auto &[entry, values] :
         {std::pair("Damper mass", &dampers.mass),
          std::pair("Damper frequency", &dampers.frequency),
          std::pair("Damper damping ratio", &dampers.damping_ratio),
          std::pair("Damper radius", &dampers.radius),
          std::pair("Damper position", &dampers.position)})
      if (n > 0 && values->size() != n && values->size() != 1)
        throw InputError(section + '/' + entry + ": " +
                         std::to_string(values->size()) +
                         " values, and Dampers has " + std::to_string(n) +
                         "; give as many, or one for all circles.");
    const auto directions = parts_of(dampers.direction, ',');
    if (n > 0 && directions.size() != n && directions.size() != 1)
      throw InputError(section + "/Damper direction = " + dampers.direction +
                       ": Dampers has " + std::to_string(n) +
                       " values; give as many, or one for all circles.");
    std::vector<AbsorberRing> rings(n);
    for (std::size_t k = 0; k < n; ++k)
      {
        AbsorberRing &ring = rings[k];
        require(dampers.number[k] >= fewest_dampers &&
                  dampers.number[k] < 1000. &&
                  dampers.number[k] == std::round(dampers.number[k]),
                "Dampers",
                dampers.number[k],
                "give a whole number of at least 3 for each circle, and at "
                "least 2 d + 1 to act on modes with d nodal diameters; leave "
                "it empty for no dampers.");
        ring.number        = dampers.number[k];
        ring.mass          = value_of_ring(dampers.mass, k);
        ring.frequency     = value_of_ring(dampers.frequency, k);
        ring.damping_ratio = value_of_ring(dampers.damping_ratio, k);
        ring.radius        = value_of_ring(dampers.radius, k);
        ring.position      = value_of_ring(dampers.position, k);
        ring.direction     = choice(named_directions,
                                directions[directions.size() == 1 ? 0 : k],
                                section + "/Damper direction")
                           .kind;
        require(ring.mass > 0.,
                "Damper mass",
                ring.mass,
                "it must be above 0 kg; a wheel of 300 kg has dampers of 1 to "
                "3 kg each.");
        require(ring.frequency > 0.,
                "Damper frequency",
                ring.frequency,
                "it must be above 0 Hz; take one near the vibration to be "
                "damped.");
        require(ring.damping_ratio >= 0. && ring.damping_ratio < 1.,
                "Damper damping ratio",
                ring.damping_ratio,
                "it is at least 0 and below 1; rubber has some 0.1.");
        require(ring.radius > 0.,
                "Damper radius",
                ring.radius,
                "it must be above 0 m and within the wheel.");
      }
    return rings;
  }

  void BodyParameters::check_dampers(const BodyShape   *body_shape,
                                     const unsigned int dimension) const
  {
    if (absorbers().empty())
      return;
    const std::string why = section + "/Dampers: ";
    if (dimension == 2)
      throw InputError(why + "dampers are on circles round an axle, which have "
                             "a meaning in 3D only; leave it empty, or take "
                             "Dimension = 3.");
    if (rigid)
      throw InputError(why + "a rigid wheel has no vibrations to damp; leave "
                             "it empty, or take Rigid = false.");
    if (body_shape && !body_shape->axle())
      throw InputError(why + "a wheel of Shape = " + shape +
                       " and Radius = " + text_of(radius) +
                       " has no axle that dampers could be placed round; take "
                       "disc or section.");
  }
} // namespace RollingContact
