#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/modes/wave_products.h>
#include <rolling_contact/modes/waveguide_response.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>

namespace RollingContact
{
  namespace
  {
    using Complex = std::complex<double>;

    /// of exp(-x), where nothing is left of a wave
    const double faded = 14.;

    /// pads that are looked at, and the motion of the farthest over that of the
    /// one at the load
    const unsigned int most_pads = 4096;
    const double       farthest  = 1e-5;

    /** How many waves, those that fade least first, get as far as this. */
    Eigen::Index n_reaching(const ComplexVector &wavenumbers,
                            const double         distance)
    {
      Eigen::Index n = wavenumbers.size();
      while (n > 0 && -wavenumbers[n - 1].imag() * distance > faded)
        --n;
      return n;
    }

    /** The values of those @p waves that get there. */
    ComplexVector fading(const ComplexVector &waves, const double distance)
    {
      return (Complex(0., -distance) *
              waves.head(n_reaching(waves, distance)).array())
        .exp();
    }

    /**
     * r_n of n from -N/2 to N/2 - 1, by columns, by transforms at N points xi
     * = pi ((2 m + 1) / N - 1), by rows.
     */
    ComplexMatrix back_from_transforms(const unsigned int N)
    {
      ComplexVector roots(2 * N);
      for (unsigned int j = 0; j < 2 * N; ++j)
        roots[j] = std::exp(Complex(0., -pi * j / N)) / double(N);
      ComplexMatrix result(N, N);
      for (unsigned int pad = 0; pad < N; ++pad)
        for (unsigned int m = 0; m < N; ++m)
          // (2 m + 1 - N) (pad - N / 2), not below 0
          result(m, pad) =
            roots[(std::uint64_t(2 * m + 1 + N) * (pad + 3 * N / 2)) % (2 * N)];
      return result;
    }
  } // namespace

  WaveguideResponse::WaveguideResponse(const Waveguide &guide,
                                       const Complex    s,
                                       const double     added_damping)
    : guide(guide)
    , s(s)
    , added_damping(added_damping)
  {
    const auto         waves = guide.waves(s, added_damping);
    const Eigen::Index n = waves.size(), n_t = guide.size().n_along;
    wavenumbers.resize(n);
    u.resize(n_t + guide.size().n_across, n);
    v.resize(u.rows(), n);
    for (Eigen::Index j = 0; j < n; ++j)
      {
        wavenumbers[j] = waves[j].wavenumber;
        u.col(j)       = waves[j].amplitudes;
        v.col(j)       = waves[j].received;
      }
    // behind a force u_t and v_t turn their signs
    u_behind = u;
    v_behind = v;
    u_behind.topRows(n_t) *= -1.;
    v_behind.topRows(n_t) *= -1.;
    if (!guide.has_pads())
      return;
    Z = stiffness_of_pad();
    next_pad =
      (Complex(0., -guide.foundation().pad_spacing) * wavenumbers.array())
        .exp();
    foot        = guide.pads().shapes * u;
    foot_behind = guide.pads().shapes * u_behind;
  }

  ComplexMatrix WaveguideResponse::stiffness_of_pad() const
  {
    const Waveguide::Pads &pads       = guide.pads();
    const Foundation      &foundation = guide.foundation();
    const auto             of_length  = [&](const double loss_factor) {
      return guide.stiffening(s, loss_factor, added_damping) *
             foundation.pad_spacing;
    };
    const Complex pad     = of_length(foundation.loss_factor),
                  ballast = of_length(foundation.ballast_loss_factor);
    const Eigen::Index n = pads.stiffness.size(), n_lines = pads.lines.size();
    ComplexMatrix      result = ComplexMatrix::Zero(n * n_lines, n * n_lines),
                  sleeper     = ComplexMatrix::Zero(3, 3),
                  coupling    = ComplexMatrix::Zero(n * n_lines, 3);
    const DenseMatrix of_sleeper =
      pads.stiffness.asDiagonal() * pads.translations;
    for (Eigen::Index line = 0; line < n_lines; ++line)
      {
        result.diagonal().segment(line * n, n) =
          pad / double(n_lines) * pads.stiffness;
        coupling.middleRows(line * n, n) = pad / double(n_lines) * of_sleeper;
      }
    if (!foundation.has_sleepers())
      return result;
    sleeper = pad * (pads.translations.transpose() * of_sleeper);
    for (unsigned int a = 0; a < 3; ++a)
      sleeper(a, a) += ballast * foundation.ballast_stiffness[a] +
                       guide.rate_of_inertia(s) * foundation.sleeper_mass;
    ComplexMatrix   moved = coupling.transpose();
    const ComplexLU factor(sleeper);
    factor.solve(moved);
    return result - coupling * moved;
  }

  auto WaveguideResponse::source_of(const double         x,
                                    const ComplexMatrix &force) const -> Source
  {
    return {x, v.transpose() * force, v_behind.transpose() * force};
  }

  auto WaveguideResponse::on_lines(const Source &source) const
    -> std::vector<AtLine>
  {
    const double        spacing = guide.foundation().pad_spacing;
    const Complex       i(0., 1.);
    std::vector<AtLine> result;
    for (const double line : guide.pads().lines)
      {
        const double d      = line - source.x,
                     first  = std::ceil(-d / spacing); // pad at or ahead of it
        const auto arriving = [&](const double         way,
                                  const double         begin,
                                  const ComplexMatrix &given) {
          return ComplexMatrix(
            (-i * wavenumbers.array() * (begin * spacing + way * d))
              .exp()
              .matrix()
              .asDiagonal() *
            given);
        };
        result.push_back({first,
                          arriving(1., first, source.ahead),
                          arriving(-1., 1. - first, source.behind)});
      }
    return result;
  }

  ComplexMatrix
  WaveguideResponse::motions_of_pads(const std::vector<AtLine> &lines,
                                     const double               xi) const
  {
    // sums of exp(i way xi n - i k (n spacing + way d)) from a pad n on
    const Eigen::Index n      = foot.rows();
    const auto         series = [&](const double way, const double begin) {
      const Complex turn = std::polar(1., way * xi);
      return ComplexVector(std::polar(1., way * xi * begin) *
                           (1. - turn * next_pad.array()).inverse());
    };
    ComplexMatrix result(n * lines.size(), lines.front().ahead.cols());
    for (std::size_t line = 0; line < lines.size(); ++line)
      {
        const AtLine &at = lines[line];
        result.middleRows(line * n, n) =
          foot * (series(1., at.first).asDiagonal() * at.ahead) +
          foot_behind * (series(-1., 1. - at.first).asDiagonal() * at.behind);
      }
    return result;
  }

  void WaveguideResponse::add_pads(const double         x,
                                   const ComplexMatrix &force,
                                   std::vector<Source> &sources) const
  {
    const Waveguide::Pads &pads    = guide.pads();
    const double           spacing = guide.foundation().pad_spacing;
    const Eigen::Index     n = pads.stiffness.size(), n_all = Z.rows(),
                       n_loads = force.cols();
    const double nearest       = spacing * std::round(x / spacing);
    const auto   load          = on_lines(source_of(x - nearest, force));
    std::vector<std::vector<AtLine>> on_pad;
    for (const double line : pads.lines)
      on_pad.push_back(
        on_lines(source_of(line, pads.shapes.transpose().cast<Complex>())));
    const auto at = [&](const double xi) {
      ComplexMatrix system(n_all, n_all), r = motions_of_pads(load, xi);
      for (std::size_t line = 0; line < on_pad.size(); ++line)
        system.middleCols(line * n, n) = motions_of_pads(on_pad[line], xi);
      system = (system * Z).eval();
      system.diagonal().array() += 1.;
      const ComplexLU factor(std::move(system));
      factor.solve(r);
      return r;
    };
    for (unsigned int n_pads = enough_pads; n_pads <= most_pads; n_pads *= 2)
      {
        // xi between the points, none of which is 0, where free waves are slow
        ComplexMatrix transforms(n_all * n_loads, n_pads);
        for (unsigned int m = 0; m < n_pads; ++m)
          transforms.col(m) = at(pi * ((2 * m + 1.) / n_pads - 1.)).reshaped();
        const ComplexMatrix motions = transforms * back_from_transforms(n_pads);
        if (motions.col(0).norm() > farthest * motions.col(n_pads / 2).norm())
          continue;
        enough_pads = n_pads;
        for (unsigned int pad = 0; pad < n_pads; ++pad)
          {
            const ComplexMatrix forces =
              -Z * motions.col(pad).reshaped(n_all, n_loads);
            for (std::size_t line = 0; line < pads.lines.size(); ++line)
              sources.push_back(source_of(
                nearest + pads.lines[line] + (pad - n_pads / 2.) * spacing,
                pads.shapes.transpose() * forces.middleRows(line * n, n)));
          }
        return;
      }
    throw ConvergenceError(
      "A rail on pads: its vibration at " +
      significant(std::abs(s.imag()) / (2 * pi), 5) +
      " Hz does not fade within " + std::to_string(most_pads / 2) +
      " pads; give the rail a larger Loss factor, or take Pad spacing = 0.");
  }

  auto WaveguideResponse::sources_of(const double         x,
                                     const ComplexMatrix &force) const
    -> std::vector<Source>
  {
    std::vector<Source> sources{source_of(x, force)};
    if (guide.has_pads())
      add_pads(x, force, sources);
    return sources;
  }

  ComplexMatrix WaveguideResponse::field(const std::vector<Place> &places,
                                         const Place              &loaded,
                                         const ComplexMatrix      &forces) const
  {
    const ComplexMatrix force = guide.motion_at(loaded).adjoint() * forces;
    const std::vector<Source> sources = sources_of(loaded[0], force);
    // what a place of the section and a place along it say, each once
    std::map<const ComplexMatrix *, std::array<ComplexMatrix, 2>> moved;
    std::map<double, std::array<ComplexMatrix, 2>>                arriving;
    ComplexMatrix result(3 * places.size(), forces.cols());
    for (std::size_t p = 0; p < places.size(); ++p)
      {
        const double x             = places[p][0];
        const auto [known, is_new] = arriving.try_emplace(x);
        if (is_new)
          {
            auto &[ahead, behind] = known->second;
            ahead                 = behind =
              ComplexMatrix::Zero(wavenumbers.size(), forces.cols());
            for (const Source &source : sources)
              {
                const ComplexVector part =
                  fading(wavenumbers, std::abs(x - source.x));
                const bool is_ahead = x >= source.x;
                (is_ahead ? ahead : behind).topRows(part.size()) +=
                  part.asDiagonal() * (is_ahead ? source.ahead : source.behind)
                                        .topRows(part.size());
              }
          }
        const ComplexMatrix &motion   = guide.motion_at(places[p]);
        const auto [at, is_new_place] = moved.try_emplace(&motion);
        if (is_new_place)
          at->second = {{motion * u, motion * u_behind}};
        result.middleRows(3 * p, 3) =
          at->second[0] * known->second[0] + at->second[1] * known->second[1];
      }
    return result;
  }

  std::vector<ComplexMatrix>
  WaveguideResponse::integrals(const double                      x,
                               const ComplexMatrix              &force,
                               const std::vector<ComplexMatrix> &forms) const
  {
    std::vector<Source> sources = sources_of(x, force);
    std::sort(sources.begin(), sources.end(), [](const auto &a, const auto &b) {
      return a.x < b.x;
    });
    std::vector<WaveProducts> products;
    for (const ComplexMatrix &form : forms)
      products.emplace_back(form, wavenumbers, u, u_behind);
    std::vector<ComplexMatrix> result(forms.size(),
                                      ComplexMatrix::Zero(force.cols(),
                                                          force.cols()));
    const auto                 add = [&](const double         length,
                         const ComplexMatrix *ahead,
                         const ComplexMatrix *behind) {
      for (std::size_t i = 0; i < products.size(); ++i)
        products[i].add(length, ahead, behind, result[i]);
    };
    // what passes the sources ahead, from each of them on, and behind
    std::vector<ComplexMatrix> behind(sources.size());
    for (std::size_t i = sources.size(); i-- > 0;)
      {
        behind[i] = sources[i].behind;
        if (i + 1 < sources.size())
          behind[i] +=
            (Complex(0., sources[i].x - sources[i + 1].x) * wavenumbers.array())
              .exp()
              .matrix()
              .asDiagonal() *
            behind[i + 1];
      }
    const double infinity = std::numeric_limits<double>::infinity();
    add(infinity, nullptr, &behind.front());
    ComplexMatrix ahead;
    for (std::size_t i = 0; i < sources.size(); ++i)
      {
        if (i == 0)
          ahead = sources[i].ahead;
        else
          ahead = ((Complex(0., sources[i - 1].x - sources[i].x) *
                    wavenumbers.array())
                       .exp()
                       .matrix()
                       .asDiagonal() *
                     ahead +
                   sources[i].ahead)
                    .eval();
        if (i + 1 < sources.size())
          add(sources[i + 1].x - sources[i].x, &ahead, &behind[i + 1]);
        else
          add(infinity, &ahead, nullptr);
      }
    return result;
  }
} // namespace RollingContact
