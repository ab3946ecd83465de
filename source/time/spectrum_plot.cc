#include <rolling_contact/base/text.h>
#include <rolling_contact/run/figure.h>
#include <rolling_contact/time/spectrum_lines.h>
#include <rolling_contact/time/spectrum_plot.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace RollingContact
{
  namespace
  {
    using Values = std::vector<double>;

    const double nothing = std::numeric_limits<double>::quiet_NaN();

    /// over the largest mean square of bands, and the largest density: what is
    /// not drawn, rounding
    const double least_band = 1e-10, least_density = 1e-12;

    /// lines that have a name in the picture
    const std::size_t most_named = 4;

    const char frequency_label[] = "frequency (Hz)";

    /** Levels of bands for the eye: none of rounding, far below the rest. */
    Values shown_levels(const std::vector<Signals::ThirdOctave> &bands,
                        const double                             reference)
    {
      double most = 0.;
      for (const Signals::ThirdOctave &band : bands)
        most = std::max(most, band.mean_square.value_or(0.));
      Values levels;
      for (const Signals::ThirdOctave &band : bands)
        levels.push_back(band.mean_square.value_or(0.) > least_band * most
                           ? Signals::level(*band.mean_square, reference)
                           : nothing);
      return levels;
    }

    /** Third octaves of the signals of a kind. */
    Figure bands_of(const RunSpectra  &spectra,
                    const SignalKind   kind,
                    const std::string &title)
    {
      const SignalUnits units = units_of(kind);
      Figure            figure(title, frequency_label, units.axis);
      for (const SignalSpectrum &of : spectra.signals)
        {
          if (of.signal.kind != kind)
            continue;
          std::vector<Signals::ThirdOctave> shown;
          for (const Signals::ThirdOctave &band : of.bands)
            if (band.lower_edge() < spectra.highest)
              shown.push_back(band);
          Values centres;
          for (const Signals::ThirdOctave &band : shown)
            centres.push_back(band.centre);
          figure.add_curve(of.signal.label,
                           centres,
                           shown_levels(shown, units.reference),
                           CurveStyle::line_and_points);
        }
      figure.set_scales(AxisScale::logarithmic, AxisScale::linear);
      return figure;
    }

    /** The density of a signal as far as it is looked at, without rounding far
     * below the highest. */
    void add_density(const RunSpectra     &spectra,
                     const SignalSpectrum &of,
                     const double          highest,
                     Figure               &figure)
    {
      Values frequencies, densities;
      for (std::size_t k = 0; k < of.spectrum.density.size() &&
                              k * of.spectrum.step <= spectra.highest;
           ++k)
        {
          const double density = of.spectrum.density[k];
          frequencies.push_back(k * of.spectrum.step);
          densities.push_back(density > least_density * highest ? density
                                                                : nothing);
        }
      figure.add_curve(of.signal.label, frequencies, densities);
    }

    double highest_density(const SignalSpectrum &of)
    {
      return *std::max_element(of.spectrum.density.begin(),
                               of.spectrum.density.end());
    }

    Figure densities_of_forces(const RunSpectra &spectra)
    {
      Figure figure("", frequency_label, "density (N\u00b2/Hz)");
      double highest = 0.;
      for (const SignalSpectrum &of : spectra.signals)
        if (of.signal.kind == SignalKind::force)
          highest = std::max(highest, highest_density(of));
      for (const SignalSpectrum &of : spectra.signals)
        if (of.signal.kind == SignalKind::force)
          add_density(spectra, of, highest, figure);
      figure.set_scales(AxisScale::logarithmic, AxisScale::logarithmic);
      return figure;
    }

    std::string name_of_line(const SignalSpectrum &of,
                             const std::size_t     line,
                             const ComplexValues  &eigenvalues)
    {
      const LineOrigin origin = origin_of(of, line, eigenvalues);
      std::string      text = significant(of.lines[line].frequency, 5) + " Hz";
      if (origin.multiple > 1)
        return text + " = " + std::to_string(origin.multiple) + " \u00d7 " +
               significant(origin.fundamental, 5) + " Hz";
      if (origin.eigenvalue != 0.)
        text += ": eigenvalue " + significant(origin.eigenfrequency(), 5) +
                " Hz, " + (origin.eigenvalue.real() > 0. ? "+" : "") +
                significant(origin.eigenvalue.real(), 3) + " 1/s";
      return text;
    }

    /** The strongest lines of a signal, each by a point with its name. */
    void mark_lines(const SignalSpectrum &of,
                    const ComplexValues  &eigenvalues,
                    Figure               &figure)
    {
      std::vector<std::size_t> order(of.lines.size());
      for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
      std::sort(order.begin(), order.end(), [&](const auto a, const auto b) {
        return of.lines[a].mean_square > of.lines[b].mean_square;
      });
      order.resize(std::min(order.size(), most_named));
      std::sort(order.begin(), order.end());
      for (const std::size_t i : order)
        {
          const double frequency = of.lines[i].frequency;
          const auto   k =
            static_cast<std::size_t>(std::lround(frequency / of.spectrum.step));
          figure.add_curve(name_of_line(of, i, eigenvalues),
                           {frequency},
                           {of.spectrum.density.at(k)},
                           CurveStyle::points);
        }
    }
  } // namespace

  void draw_spectrum(const RunSpectra &spectra, RunContext &context)
  {
    const auto has = [&](const SignalKind kind) {
      return std::any_of(spectra.signals.begin(),
                         spectra.signals.end(),
                         [&](const SignalSpectrum &of) {
                           return of.signal.kind == kind;
                         });
    };
    const SignalKind velocity = SignalKind::velocity;
    Figure           figure   = bands_of(spectra,
                             SignalKind::force,
                             "Third octaves and power spectral density");
    if (has(SignalKind::height))
      figure.add_separate_panel(bands_of(spectra, SignalKind::height, ""));
    if (has(velocity))
      figure.add_separate_panel(bands_of(spectra, velocity, ""));
    figure.add_separate_panel(densities_of_forces(spectra));
    if (const SignalSpectrum *of = loudest(spectra, velocity))
      {
        Figure lines("", frequency_label, "density ((m/s)\u00b2/Hz)");
        lines.set_scales(AxisScale::logarithmic, AxisScale::logarithmic);
        add_density(spectra, *of, highest_density(*of), lines);
        mark_lines(*of, spectra.eigenvalues, lines);
        figure.add_separate_panel(lines);
      }
    figure.draw(context, "spectrum");
  }
} // namespace RollingContact
