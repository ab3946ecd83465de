#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/stability/passing_waves.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace RollingContact
{
  namespace
  {
    /// waves of a third octave at which reactions are found
    const int reactions_of_band = 9;

    /** By cubics in the logarithm of the wave number. */
    WaveResponse::Reaction reaction_at(const double        wave_number,
                                       const PassingWaves &waves)
    {
      const double at = std::log(wave_number / waves.first) /
                        std::log(waves.ratio),
                   last = waves.reactions.size() - 4.;
      const auto i      = static_cast<std::size_t>(
        std::clamp(std::floor(at) - 1., 0., std::max(last, 0.)));
      const double                t = at - i;
      const std::array<double, 4> weights{-(t - 1) * (t - 2) * (t - 3) / 6,
                                          t * (t - 2) * (t - 3) / 2,
                                          -t * (t - 1) * (t - 3) / 2,
                                          t * (t - 1) * (t - 2) / 6};
      WaveResponse::Reaction      result;
      result.by_motions = weights[0] * waves.reactions.at(i).by_motions;
      result.of_waves   = weights[0] * waves.reactions[i].of_waves;
      for (std::size_t j = 1; j < weights.size(); ++j)
        {
          result.by_motions +=
            weights[j] * waves.reactions.at(i + j).by_motions;
          result.of_waves += weights[j] * waves.reactions[i + j].of_waves;
        }
      return result;
    }
  } // namespace

  ComplexMatrix random_waves(const std::vector<double> &along,
                             const std::vector<double> &across,
                             const double               wave_number,
                             const double               coherence)
  {
    std::map<double, std::size_t> lines;
    for (const double y : across)
      lines.emplace(y, 0);
    // a Markov chain across: each line what the one before it was, less
    // coherent, and something new
    DenseMatrix of_line = DenseMatrix::Zero(lines.size(), lines.size());
    double      before  = 0.;
    std::size_t n       = 0;
    for (auto &[y, line] : lines)
      {
        line = n++;
        if (line == 0)
          of_line(0, 0) = 1.;
        else
          {
            const double kept =
              std::exp(-coherence * wave_number * (y - before));
            of_line.row(line)   = kept * of_line.row(line - 1);
            of_line(line, line) = std::sqrt(1 - kept * kept);
          }
        before = y;
      }
    ComplexMatrix b(along.size(), coherence > 0. ? n : 1);
    for (std::size_t i = 0; i < along.size(); ++i)
      b.row(i) = of_line.row(lines.at(across[i])).head(b.cols()) *
                 std::polar(1., -wave_number * along[i]);
    return b;
  }

  ModalFactors PassingWaves::modal(const double frequency) const
  {
    return ModalFactors(sweep.bodies(number), {0., 2 * pi * frequency});
  }

  PassingWaves::Passed PassingWaves::at(const double        frequency,
                                        const ModalFactors &modal) const
  {
    const auto         patch   = reaction_at(2 * pi * frequency / speed, *this);
    const DenseMatrix &motions = sweep.motions_of_coordinates(number);
    const Eigen::Index p       = motions.rows();
    ComplexMatrix driven = motions.transpose().cast<std::complex<double>>();
    modal.solve(driven);
    const ComplexMatrix response = motions * driven;
    ComplexMatrix       forces   = patch.of_waves.topRows(p);
    ComplexLU(ComplexMatrix::Identity(p, p) +
              patch.by_motions.topRows(p) * response)
      .solve(forces);
    const Eigen::Index  n = patch.of_waves.rows() - p;
    const ComplexMatrix others =
      patch.of_waves.bottomRows(n) -
      patch.by_motions.bottomRows(n) * (response * forces);
    return {driven * forces,
            others.row(0).transpose(),
            others.bottomRows(n - 1)};
  }

  std::vector<PassingWaves>
  passing_waves(const WaveSweep                              &sweep,
                const std::vector<double>                    &speeds,
                const std::vector<std::pair<double, double>> &wave_numbers,
                const WaveSweep::Waves                       &waves)
  {
    // all at powers of one ratio, with one more on either side for cubics
    const double ratio = std::pow(10., 0.1 / reactions_of_band);
    std::vector<std::pair<int, int>> ranges;
    std::set<int>                    all;
    for (const auto &[lowest, highest] : wave_numbers)
      {
        ranges.emplace_back(std::floor(std::log(lowest) / std::log(ratio)) - 1,
                            std::ceil(std::log(highest) / std::log(ratio)) + 1);
        for (int i = ranges.back().first; i <= ranges.back().second; ++i)
          all.insert(i);
      }
    std::vector<std::vector<WaveResponse::Reaction>> reactions(speeds.size());
    for (const int i : all)
      {
        throw_if_interrupted();
        std::vector<std::size_t> at;
        for (std::size_t v = 0; v < speeds.size(); ++v)
          if (ranges[v].first <= i && i <= ranges[v].second)
            at.push_back(v);
        auto found = sweep.reactions(std::pow(ratio, i), waves, at);
        for (std::size_t j = 0; j < at.size(); ++j)
          reactions[at[j]].push_back(std::move(found[j]));
      }
    std::vector<PassingWaves> result;
    for (std::size_t v = 0; v < speeds.size(); ++v)
      result.push_back({sweep,
                        v,
                        speeds[v],
                        std::pow(ratio, ranges[v].first),
                        ratio,
                        std::move(reactions[v])});
    return result;
  }
} // namespace RollingContact
