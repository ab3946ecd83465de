#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/run/run_context.h>
#include <rolling_contact/time/spectrum_lines.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    using Complex = std::complex<double>;

    /// of the fundamental: how far off a multiple may be at most
    const double multiple_share = 0.05;

    Complex nearest_eigenvalue(const ComplexValues &eigenvalues,
                               const double         frequency)
    {
      const Complex at(0., 2 * pi * frequency);
      Complex       best = 0.;
      for (const Complex &s : eigenvalues)
        if (s.imag() > 0. &&
            (best == 0. || std::abs(s - at) < std::abs(best - at)))
          best = s;
      return best;
    }

    void set_origin(const LineOrigin &origin,
                    const double      frequency,
                    const bool        knows_eigenvalues,
                    ResultsTable     &table)
    {
      table.set_if(origin.multiple > 0, "multiple", origin.multiple);
      table.set_if(origin.multiple > 0, "fundamental_Hz", origin.fundamental);
      if (!knows_eigenvalues)
        return;
      const bool   known = origin.eigenvalue != 0.;
      const double f     = origin.eigenfrequency();
      table.set_if(known, "eigenvalue_Hz", f);
      table.set_if(known, "eigenvalue_growth_1/s", origin.eigenvalue.real());
      table.set_if(known, "difference_Hz", frequency - f);
    }
  } // namespace

  double LineOrigin::eigenfrequency() const
  {
    return eigenvalue.imag() / (2 * pi);
  }

  std::size_t strongest_line(const SignalSpectrum &signal)
  {
    const auto &lines = signal.lines;
    return std::max_element(lines.begin(),
                            lines.end(),
                            [](const auto &a, const auto &b) {
                              return a.mean_square < b.mean_square;
                            }) -
           lines.begin();
  }

  const SignalSpectrum *loudest(const RunSpectra &spectra,
                                const SignalKind  kind)
  {
    const SignalSpectrum *best = nullptr;
    double                most = 0.;
    for (const SignalSpectrum &of : spectra.signals)
      if (of.signal.kind == kind && !of.lines.empty())
        if (const double here = of.lines[strongest_line(of)].mean_square;
            here > most)
          {
            most = here;
            best = &of;
          }
    return best;
  }

  LineOrigin origin_of(const SignalSpectrum &signal,
                       const std::size_t     line,
                       const ComplexValues  &eigenvalues)
  {
    const double frequency = signal.lines[line].frequency;
    LineOrigin   origin;
    origin.fundamental  = signal.lines[strongest_line(signal)].frequency;
    const double number = std::round(frequency / origin.fundamental),
                 off    = std::abs(frequency - number * origin.fundamental);
    if (number >= 1. && off < std::min(signal.spectrum.step / 2,
                                       multiple_share * origin.fundamental))
      origin.multiple = static_cast<unsigned int>(number);
    origin.eigenvalue = nearest_eigenvalue(eigenvalues, frequency);
    return origin;
  }

  void write_lines(const RunSpectra &spectra, RunContext &context)
  {
    ResultsTable table(context.folder, "lines.csv");
    for (const SignalSpectrum &of : spectra.signals)
      for (std::size_t i = 0; i < of.lines.size(); ++i)
        {
          const Signals::SpectralLine &line  = of.lines[i];
          const SignalUnits            units = units_of(of.signal.kind);
          table.set("signal", of.signal.column);
          table.set("frequency_Hz", line.frequency);
          table.set("level_dB",
                    Signals::level(line.mean_square, units.reference));
          table.set("reference", units.level);
          table.set("prominence_dB", line.prominence);
          set_origin(origin_of(of, i, spectra.eigenvalues),
                     line.frequency,
                     !spectra.eigenvalues.empty(),
                     table);
          table.end_row();
        }
    if (table.n_rows() > 0)
      table.flush();
    else
      context.log.message("The spectra have no lines: no peak rises by "
                          "Spectrum/Line prominence. Take a longer run or a "
                          "smaller prominence.");
  }

  void note_strongest_line(const RunSpectra &spectra, RunContext &context)
  {
    const SignalSpectrum *strongest = loudest(spectra, SignalKind::velocity);
    if (strongest == nullptr)
      return;
    const std::size_t            number = strongest_line(*strongest);
    const Signals::SpectralLine &line   = strongest->lines[number];
    const LineOrigin             origin =
      origin_of(*strongest, number, spectra.eigenvalues);
    std::string text = significant(line.frequency, 6) + " Hz, " +
                       significant(Signals::level(line.mean_square, 1e-9), 4) +
                       " dB re 1 nm/s in " + strongest->signal.column +
                       ", the strongest of the velocities";
    if (origin.eigenvalue != 0.)
      text += "; nearest eigenvalue " +
              significant(origin.eigenfrequency(), 6) + " Hz, growth " +
              significant(origin.eigenvalue.real(), 4) + " 1/s";
    context.report.set_finding("line", text);
  }
} // namespace RollingContact
