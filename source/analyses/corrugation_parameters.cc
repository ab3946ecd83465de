#include <rolling_contact/analyses/corrugation_parameters.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/input/number_list.h>
#include <rolling_contact/scene/entries.h>
#include <rolling_contact/scene/scene_parameters.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    const std::vector<NamedValue<Side>> worn_bodies{{"rail", Side::rail},
                                                    {"wheel", Side::wheel}};

    /// slope of a wave that is followed in time
    const double steepest = 0.1;

    /** The length nearest to this one that fits a wheel. Units: m. */
    double length_round(const double radius, const double length)
    {
      return 2 * pi * radius /
             std::max(1., std::round(2 * pi * radius / length));
    }
  } // namespace

  void CorrugationParameters::declare(Entries &entries)
  {
    entries.section("Corrugation").read_by_analyses("corrugation");
    entries.add("Wavelengths", wavelengths, "m").help =
      "Lengths of the waves on the surface: numbers separated by commas, or "
      "`shortest : longest : number`, in equal ratios.";
    entries.add("Speeds", speeds, "m/s").help = "Rolling speeds, " +
                                                std::string(number_list_form) +
                                                "; empty: Contact/Speed alone.";
    entries.choice("Worn body", worn, worn_bodies).help =
      "Body whose surface has the waves. On the `rail` each wheel is a "
      "passage; on the `wheel` each turn is one, and whole waves fit round it.";
    entries.add("Wear coefficient", wear_coefficient, "m^3/J")
      .at_least(0.)
      .help =
      "Volume that wears off the body per energy of friction. 6.75e-13 is "
      "mild wear of rail steel in twin-disc tests (5.3 ug/(m mm^2) per "
      "N/mm^2).";
    entries.add("Passages", passages, "1").at_least(0.).help =
      "Number of passages over which a column of the results gives the growth.";
    entries.add("Pad offsets", pad_offsets, "m").help =
      "Places of the wheel in a bay between sleepers, as Rail/Pad offset, "
      "each with a rail of its own: " +
      std::string(number_list_form) + "; empty: Rail/Pad offset alone.";
    entries.add("Check wavelength", check_wavelength, "m").at_least(0.).help =
      "Wavelength of a wave that is followed in time as well, with the wear "
      "of its passage, at all Speeds and Pad offsets. corrugation_check.csv "
      "compares its growth with that of small waves. 0: none.";
    entries.add("Check amplitude", check_amplitude, "m")
      .at_least(0.)
      .read_by({asks_own<CorrugationParameters>(
                  [](const auto &section) { return section.follows_wave(); }),
                "Check wavelength = 0 follows no wave in time"})
      .help = "Amplitude of the wave of Check wavelength. Some 1e-8 m is "
              "small, as all other waves are taken to be. At micrometres the "
              "growth tells how far that assumption holds.";
  }

  void CorrugationParameters::check() const
  {
    wavelengths_round(1.);
    speeds_or(1.);
    places();
    for (const auto &[name, value] :
         {std::pair("Wear coefficient", wear_coefficient),
          std::pair("Passages", passages)})
      if (value == 0.)
        throw InputError(std::string("Corrugation/") + name +
                         " = 0: no wave would change; give a number above 0.");
    const double most = steepest * check_wavelength / (2 * pi);
    if (follows_wave() && !(check_amplitude > 0. && check_amplitude <= most))
      throw InputError(
        "Corrugation/Check amplitude = " + text_of(check_amplitude) +
        " m: on waves of Corrugation/Check wavelength = " +
        text_of(check_wavelength) + " m it must be above 0 and at most " +
        significant(most, 2) + " m, a slope of 0.1; 1e-8 m is a small wave.");
  }

  double
  CorrugationParameters::check_wavelength_round(const double radius) const
  {
    return worn == Side::rail ? check_wavelength
                              : length_round(radius, check_wavelength);
  }

  std::vector<double>
  CorrugationParameters::wavelengths_round(const double radius) const
  {
    auto lengths =
      positive_numbers("Corrugation/Wavelengths", wavelengths, "m");
    if (wavelengths.find(':') != std::string::npos)
      {
        const std::size_t last  = lengths.size() - 1;
        const double      ratio = lengths[last] / lengths[0];
        for (std::size_t i = 1; i < last; ++i)
          lengths[i] =
            lengths[0] * std::pow(ratio, static_cast<double>(i) / last);
      }
    if (worn == Side::rail)
      return lengths;
    for (double &length : lengths)
      length = length_round(radius, length);
    lengths.erase(std::unique(lengths.begin(), lengths.end()), lengths.end());
    return lengths;
  }

  std::vector<double> CorrugationParameters::speeds_or(const double given) const
  {
    return RollingContact::speeds_or(given, "Corrugation/Speeds", speeds);
  }
} // namespace RollingContact
