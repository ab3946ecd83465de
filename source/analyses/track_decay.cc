#include <rolling_contact/analyses/decay_energies.h>
#include <rolling_contact/analyses/track_decay.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/run/figure.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace RollingContact
{
  namespace
  {
    using Complex = std::complex<double>;

    const char decay_file[] = "track_decay.csv";

    /// of a rail without sleepers, m
    const double usual_bay = 0.6;

    /// lines in a band
    const unsigned int n_lines_of_band = 8;

    /// of the bands, those on the screen: Hz
    const std::array<double, 6> shown_bands{
      {125., 250., 500., 1000., 2000., 4000.}};

    double bay_of(const BodyParameters &rail)
    {
      const double spacing = rail.model.foundation.pad_spacing;
      return spacing > 0. ? spacing : usual_bay;
    }
  } // namespace

  TrackDecay::TrackDecay(const VibratingBody<3>     &rail,
                         const ReceptanceParameters &section,
                         RunContext                 &context)
    : rail(rail)
    , section(section)
    , context(context)
    , grid(bay_of(rail.parameters))
    , bands(decay_bands(section.lowest_frequency, section.highest_frequency))
  {}

  void TrackDecay::check(const BodyParameters       &rail,
                         const unsigned int          dimension,
                         const ReceptanceParameters &section)
  {
    const std::string entry = "Receptance/Decay rates = true: ";
    if (dimension == 2)
      throw InputError(entry + "rails fade along x and move across it as well; "
                               "take Dimension = 3.");
    if (rail.rigid)
      throw InputError(entry + "the rail is rigid; take Rail/Rigid = false, or "
                               "leave decay rates out.");
    if (decay_bands(section.lowest_frequency, section.highest_frequency)
          .empty())
      throw InputError(
        entry +
        "no third octave of 100 Hz to 5 kHz has its centre from "
        "Receptance/Lowest frequency = " +
        text_of(section.lowest_frequency) + " Hz to Highest frequency = " +
        text_of(section.highest_frequency) + " Hz; take more of them.");
  }

  double TrackDecay::least_decay(const unsigned int axis,
                                 const double       frequency) const
  {
    if (rail.waves && !rail.waves->waveguide().has_pads())
      for (const Waveguide::Wave &wave :
           rail.waves->waveguide().waves(Complex(0., 2 * pi * frequency)))
        {
          const auto shares = rail.waves->waveguide().shares(wave);
          if (std::max_element(shares.begin(), shares.end()) ==
              shares.begin() + axis)
            return -wave.wavenumber.imag() * decibels_of_e;
        }
    return std::numeric_limits<double>::quiet_NaN();
  }

  std::vector<TrackDecay::Curves> TrackDecay::curves() const
  {
    const auto          energies = decay_energies(rail, grid, section);
    const std::size_t   n        = grid.distances().size();
    std::vector<Curves> result(decay_directions.size());
    for (const DecayBand &band : bands)
      {
        const auto mean =
          band.mean(n_lines_of_band, [&](const double frequency) {
            return energies->at(frequency);
          });
        for (std::size_t d = 0; d < result.size(); ++d)
          {
            const auto begin = mean.begin() + d * n;
            result[d].centres.push_back(band.nominal);
            result[d].rates.push_back(grid.rate({begin, begin + n}));
            result[d].waves.push_back(
              least_decay(decay_directions[d].axis, band.exact().centre));
            result[d].limits.push_back(
              (d == 0 ? band.vertical_limit : band.lateral_limit)
                .value_or(std::numeric_limits<double>::quiet_NaN()));
          }
      }
    energies->tell(context.log);
    return result;
  }

  void TrackDecay::add_row(const std::vector<Curves> &curves,
                           const std::size_t          band,
                           ResultsTable              &table) const
  {
    table.set("third_octave_Hz", bands[band].nominal);
    for (std::size_t d = 0; d < curves.size(); ++d)
      {
        const auto set_rate = [&](const std::string &what, const double value) {
          table.set_if(!std::isnan(value),
                       what + "_" + decay_directions[d].name + "_dB/m",
                       value);
        };
        set_rate("decay", curves[d].rates[band]);
        set_rate("wave", curves[d].waves[band]);
        set_rate("limit", curves[d].limits[band]);
      }
    table.end_row();
  }

  void TrackDecay::write(const bool plot) const
  {
    PhaseTimer::Scope         phase(context.timer, Phase::response);
    const std::vector<Curves> found = curves();
    ResultsTable              table(context.folder, decay_file), shown;
    std::vector<std::string>  columns{"third_octave_Hz"};
    for (std::size_t band = 0; band < bands.size(); ++band)
      {
        add_row(found, band, table);
        if (std::count(shown_bands.begin(),
                       shown_bands.end(),
                       bands[band].nominal) > 0)
          add_row(found, band, shown);
      }
    table.flush();
    for (const DecayDirection &direction : decay_directions)
      columns.push_back("decay_" + direction.name + "_dB/m");
    context.log.message(shown.screen_table(columns));
    warn_of_floor(found);
    if (plot)
      draw(found);
  }

  void TrackDecay::warn_of_floor(const std::vector<Curves> &curves) const
  {
    for (std::size_t d = 0; d < curves.size(); ++d)
      {
        std::string which;
        for (std::size_t band = 0; band < bands.size(); ++band)
          if (curves[d].rates[band] < 2 * grid.floor())
            which +=
              (which.empty() ? "" : ", ") + significant(bands[band].nominal, 4);
        if (!which.empty())
          context.log.warning(
            "Receptance/Decay rates: " + decay_directions[d].name +
            " vibration in the bands " + which +
            " Hz fades by less than twice " + significant(grid.floor(), 2) +
            " dB/m, the least rate that the places of EN 15461 up to " +
            significant(grid.distances().back(), 3) +
            " m can show: these rates are upper bounds.");
      }
  }

  void TrackDecay::draw(const std::vector<Curves> &curves) const
  {
    Figure figure("Decay along the rail",
                  "third octave (Hz)",
                  "decay rate (dB/m)");
    figure.set_scales(AxisScale::logarithmic, AxisScale::logarithmic);
    const auto add = [&](const std::string  &name,
                         std::vector<double> Curves::*const what,
                         const std::size_t                  d,
                         const CurveStyle                   style) {
      const std::vector<double> &rates = curves[d].*what;
      if (std::any_of(rates.begin(), rates.end(), [](const double rate) {
            return !std::isnan(rate);
          }))
        figure.add_curve(name, curves[d].centres, rates, style);
    };
    for (std::size_t d = 0; d < curves.size(); ++d)
      add(decay_directions[d].name,
          &Curves::rates,
          d,
          CurveStyle::line_and_points);
    for (std::size_t d = 0; d < curves.size(); ++d)
      add("least of its " + decay_directions[d].name + " waves",
          &Curves::waves,
          d,
          CurveStyle::dashed);
    for (std::size_t d = 0; d < curves.size(); ++d)
      add("ISO 3095, " + decay_directions[d].name + ", at least",
          &Curves::limits,
          d,
          CurveStyle::reference);
    figure.draw(context, "track_decay");
  }
} // namespace RollingContact
