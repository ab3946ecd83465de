#include <rolling_contact/run/run_context.h>
#include <rolling_contact/time/spectrum_tables.h>

namespace RollingContact
{
  namespace
  {
    /** Distance between crests; nothing where the speed changes. */
    std::optional<double> wavelength(const std::optional<double> &speed,
                                     const double                 frequency)
    {
      return speed && *speed > 0. && frequency > 0.
               ? std::optional<double>(*speed / frequency)
               : std::nullopt;
    }
  } // namespace

  void write_spectrum(const RunSpectra &spectra, RunContext &context)
  {
    ResultsTable table(context.folder, "spectrum.csv");
    const auto  &first = spectra.signals.front().spectrum;
    for (std::size_t k = 0; k < first.density.size(); ++k)
      {
        const double frequency = k * first.step;
        table.set("frequency_Hz", frequency);
        table.set("wavelength_m", wavelength(spectra.speed, frequency));
        for (const SignalSpectrum &of : spectra.signals)
          table.set(of.signal.name + "_psd_" + units_of(of.signal.kind).density,
                    of.spectrum.density[k]);
        table.end_row();
      }
    table.flush();
  }

  void write_third_octaves(const RunSpectra &spectra, RunContext &context)
  {
    ResultsTable table(context.folder, "third_octaves.csv");
    for (std::size_t k = 0; k < spectra.signals.front().bands.size(); ++k)
      {
        const Signals::ThirdOctave &band = spectra.signals.front().bands[k];
        table.set("centre_frequency_Hz", band.centre);
        table.set("lower_edge_Hz", band.lower_edge());
        table.set("upper_edge_Hz", band.upper_edge());
        table.set("centre_wavelength_m",
                  wavelength(spectra.speed, band.centre));
        for (const SignalSpectrum &of : spectra.signals)
          {
            const SignalUnits units = units_of(of.signal.kind);
            const double      value = of.bands[k].mean_square.value_or(0.);
            table.set_if(value > 0.,
                         of.signal.name + '_' + units.level,
                         Signals::level(value, units.reference));
          }
        table.end_row();
      }
    table.flush();
  }
} // namespace RollingContact
