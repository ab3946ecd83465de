#include <rolling_contact/algebra/fourier.h>
#include <rolling_contact/time/modal_sound.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace RollingContact::Sound
{
  namespace
  {
    using Complex = std::complex<double>;

    /// s; no shorter where the record allows, so that bands have lines
    const double short_segment = 0.1;

    /**
     * Amplitudes of the modes at lines of frequencies, in one or more segments
     * of a record: the squares, summed over segments, are mean squares.
     */
    struct Lines
    {
      double      step    = 0.; ///< Hz
      std::size_t n_lines = 0;  ///< those that are kept

      /** By mode, segment and line. */
      std::vector<std::vector<std::vector<Complex>>> amplitudes;
    };

    Lines lines_of_segments(const std::vector<std::vector<double>> &velocities,
                            const double                            time_step,
                            const AudibleRange                     &range)
    {
      const std::size_t n       = velocities.front().size(),
                        segment = std::min<std::size_t>(
                          n,
                          std::max<std::size_t>(Signals::chosen_segment(n),
                                                std::llround(short_segment /
                                                             time_step)));
      Lines lines;
      lines.step    = 1 / (segment * time_step);
      lines.n_lines = 1 + segment / 2;
      // up to the end of the band of a third octave that the range ends in
      lines.n_lines =
        std::min<std::size_t>(lines.n_lines,
                              std::ceil(1.3 * range.highest / lines.step) + 1);
      for (const auto &velocity : velocities)
        {
          lines.amplitudes.push_back(
            Signals::segment_amplitudes(velocity, segment));
          for (auto &amplitudes : lines.amplitudes.back())
            amplitudes.resize(lines.n_lines);
        }
      return lines;
    }

    Lines lines_of_record(const std::vector<std::vector<double>> &velocities,
                          const double                            time_step,
                          const AudibleRange                     &range)
    {
      const std::size_t n = velocities.front().size();
      Lines             lines;
      lines.step = 1 / (n * time_step);
      lines.n_lines =
        std::min<std::size_t>(1 + n / 2, range.highest / lines.step + 2);
      for (const auto &velocity : velocities)
        {
          auto amplitudes = Signals::fourier_sums(velocity);
          amplitudes.resize(lines.n_lines);
          for (std::size_t k = 0; k < lines.n_lines; ++k)
            amplitudes[k] *= (k > 0 && 2 * k < n ? std::sqrt(2.) : 1.) /
                             static_cast<double>(n);
          lines.amplitudes.push_back({std::move(amplitudes)});
        }
      return lines;
    }

    /**
     * Powers by line and by mode.
     */
    struct Powers
    {
      Powers(const std::size_t n_lines, const std::size_t n_modes)
        : of_line(n_lines, 0.)
        , alone(n_modes, 0.)
        , part(n_modes, 0.)
      {}

      void add(const RadiatingPart        &radiating,
               const std::vector<Complex> &velocities,
               const double                factor,
               const std::size_t           line)
      {
        const DenseMatrix &R = radiating.surface;
        for (std::size_t i = 0; i < velocities.size(); ++i)
          {
            Complex sum = 0.;
            for (std::size_t j = 0; j < velocities.size(); ++j)
              sum += R(i, j) * velocities[j];
            const double power =
              factor * std::real(std::conj(velocities[i]) * sum);
            of_line[line] += power;
            part[radiating.modes[i]] += power;
            alone[radiating.modes[i]] +=
              factor * R(i, i) * std::norm(velocities[i]);
          }
      }

      std::vector<double> of_line, alone, part;
    };

    /** Calls @p action with a part, line, rho c sigma and the velocities. */
    template <class Action>
    void for_each_line(const RadiatingBody &body,
                       const Lines         &lines,
                       const Air           &air,
                       const AudibleRange  &range,
                       const Action        &action)
    {
      const std::size_t n_segments =
        lines.amplitudes.empty() ? 0 : lines.amplitudes.front().size();
      for (const RadiatingPart &part : body.parts)
        for (std::size_t k = 0; k < lines.n_lines; ++k)
          {
            const double f = k * lines.step;
            if (!range.contains(f))
              continue;
            const double factor = air.density * air.speed * part.efficiency(f);
            std::vector<Complex> velocities(part.modes.size());
            for (std::size_t s = 0; s < n_segments; ++s)
              {
                for (std::size_t i = 0; i < velocities.size(); ++i)
                  velocities[i] = lines.amplitudes[part.modes[i]][s][k];
                action(part, k, factor, velocities);
              }
          }
    }
  } // namespace

  double radiated_power(const RadiatingBody    &body,
                        const Eigen::MatrixXcd &velocities,
                        const double            frequency,
                        const Air              &air)
  {
    double power = 0.;
    for (const RadiatingPart &part : body.parts)
      {
        const Eigen::MatrixXcd of_part = velocities(part.modes, Eigen::all);
        power += part.efficiency(frequency) *
                 (of_part.conjugate().cwiseProduct(part.surface * of_part))
                   .real()
                   .sum();
      }
    return air.density * air.speed * power;
  }

  BodySound body_sound(const RadiatingBody                    &body,
                       const std::vector<std::vector<double>> &velocities,
                       const double                            time_step,
                       const Air                              &air,
                       const AudibleRange                     &range)
  {
    const std::size_t n_modes = velocities.size();
    BodySound         sound;
    if (n_modes == 0)
      return sound;
    const Lines record = lines_of_record(velocities, time_step, range);
    Powers      whole(record.n_lines, n_modes);
    sound.line_signals.assign(record.n_lines, 0.);
    for_each_line(
      body,
      record,
      air,
      range,
      [&](const auto &part, const auto k, const double factor, const auto &v) {
        whole.add(part, v, factor, k);
        for (std::size_t i = 0; i < v.size(); ++i)
          sound.line_signals[k] +=
            std::sqrt(factor * std::max(part.surface(i, i), 0.)) * v[i];
      });
    sound.line_powers = std::move(whole.of_line);
    for (double &power : sound.line_powers) // but for rounding
      power = std::max(power, 0.);
    sound.power =
      std::accumulate(sound.line_powers.begin(), sound.line_powers.end(), 0.);

    const Lines segments = lines_of_segments(velocities, time_step, range);
    Powers      mean(segments.n_lines, n_modes);
    for_each_line(body,
                  segments,
                  air,
                  range,
                  [&](const auto  &part,
                      const auto   k,
                      const double factor,
                      const auto  &v) { mean.add(part, v, factor, k); });
    const double sum =
      std::accumulate(mean.of_line.begin(), mean.of_line.end(), 0.);
    const double scale        = sum > 0. ? sound.power / sum : 0.;
    sound.spectrum.step       = segments.step;
    sound.spectrum.n_segments = segments.amplitudes.front().size();
    for (const double power : mean.of_line)
      sound.spectrum.density.push_back(std::max(power, 0.) * scale /
                                       segments.step);
    for (std::size_t i = 0; i < n_modes; ++i)
      {
        sound.alone.push_back(scale * mean.alone[i]);
        sound.part.push_back(scale * mean.part[i]);
      }
    return sound;
  }
} // namespace RollingContact::Sound
