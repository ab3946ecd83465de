#include <rolling_contact/analyses/rolling_noise_parameters.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/input/number_list.h>
#include <rolling_contact/scene/entries.h>
#include <rolling_contact/scene/scene_parameters.h>

namespace RollingContact
{
  namespace
  {
    const std::vector<NamedValue<ContactFilter>> contact_filters{
      {"random across", ContactFilter::random_across},
      {"patch", ContactFilter::patch},
      {"table", ContactFilter::table}};
  } // namespace

  void RollingNoiseParameters::declare(Entries &entries)
  {
    entries.section("Rolling noise").read_by_analyses("rolling noise");
    entries.add("Speeds", speeds, "m/s").help = "Rolling speeds, " +
                                                std::string(number_list_form) +
                                                "; empty: Contact/Speed alone.";
    const std::string forms =
      "`ISO 3095 limit`, the limit curve of rails; FILE.csv with the columns "
      "wavelength_m and level_dB (third octaves, re 1 um); or a record "
      "FILE.csv of heights over positions, both in m. Empty: smooth.";
    entries.add("Rail roughness", rail_roughness).help =
      "Roughness of the rail: " + forms;
    entries.add("Wheel roughness", wheel_roughness).help =
      "Roughness of the wheel, whose energy is added to that of the rail: " +
      forms;
    entries.choice("Contact filter", filter, contact_filters).help =
      "How the contact filters waves. `random across`: waves cohere across "
      "the track by Coherence across; `patch`: waves are alike across it; "
      "both use the patch itself. `table`: the tables of the directive (EU) "
      "2021/1226 for wheels of 920 mm.";
    entries.add("Coherence across", coherence, "1")
      .at_least(0.)
      .read_by({asks_own<RollingNoiseParameters>([](const auto &noise) {
                  return noise.filter == ContactFilter::random_across;
                }),
                "Contact filter = random across reads it"})
      .help = "Decay c of the coherence across the track: places y and y' "
              "cohere by exp(-c k |y - y'|), k = 2 pi over the wavelength. 0 "
              "is the same as `patch`.";
    entries.add("Pad offsets", pad_offsets, "m").help =
      "Places of the wheel in a bay between sleepers, as Rail/Pad offset, "
      "each with a rail of its own. Their sound powers are averaged. Give " +
      std::string(number_list_form) + "; empty: Rail/Pad offset alone.";
  }

  void RollingNoiseParameters::check() const
  {
    speeds_or(1.);
    places();
    if (rail_roughness.empty() && wheel_roughness.empty())
      throw InputError("Rolling noise/Rail roughness and Wheel roughness are "
                       "empty: smooth bodies roll without noise; give one, as "
                       "`" +
                       std::string(iso_3095_limit) + "`.");
  }

  std::vector<double>
  RollingNoiseParameters::speeds_or(const double given) const
  {
    return RollingContact::speeds_or(given, "Rolling noise/Speeds", speeds);
  }
} // namespace RollingContact
