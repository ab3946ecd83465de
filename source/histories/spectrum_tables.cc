#include <rolling_contact/histories/spectrum_tables.h>
#include <rolling_contact/run/run_context.h>

namespace RollingContact
{
  namespace
  {
    /** Distance between crests; nothing where the speed changes. */
    void
    set_wavelength(const std::string           &column,
                   const std::optional<double> &speed,
                   const double                 frequency,
                   ResultsTable                &table)
    {
      if (speed && *speed > 0. && frequency > 0.)
        table.set(column, *speed / frequency);
      else
        table.leave_empty(column);
    }
  } // namespace



  void
  write_spectrum(const RunSpectra &spectra, RunContext &context)
  {
    ResultsTable table(context.folder, "spectrum.csv");
    const auto  &first = spectra.signals.front().spectrum;
    for (std::size_t k = 0; k < first.density.size(); ++k)
      {
        const double frequency = k * first.step;
        table.set("frequency_Hz", frequency);
        set_wavelength("wavelength_m", spectra.speed, frequency, table);
        for (const SignalSpectrum &of : spectra.signals)
          table.set(of.signal.name + "_psd_" + units_of(of.signal.kind).density,
                    of.spectrum.density[k]);
        table.end_row();
      }
    table.flush();
  }



  void
  write_third_octaves(const RunSpectra &spectra, RunContext &context)
  {
    ResultsTable table(context.folder, "third_octaves.csv");
    for (std::size_t k = 0; k < spectra.signals.front().bands.size(); ++k)
      {
        const Signals::ThirdOctave &band = spectra.signals.front().bands[k];
        table.set("centre_frequency_Hz", band.centre);
        table.set("lower_edge_Hz", band.lower_edge());
        table.set("upper_edge_Hz", band.upper_edge());
        set_wavelength("centre_wavelength_m",
                       spectra.speed,
                       band.centre,
                       table);
        for (const SignalSpectrum &of : spectra.signals)
          {
            const SignalUnits units  = units_of(of.signal.kind);
            const std::string column = of.signal.name + '_' + units.level;
            if (const auto value = of.bands[k].mean_square;
                value && *value > 0.)
              table.set(column, Signals::level(*value, units.reference));
            else
              table.leave_empty(column);
          }
        table.end_row();
      }
    table.flush();
  }
} // namespace RollingContact
