#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/stability/contact_response.h>
#include <rolling_contact/stability/rational_fit.h>
#include <rolling_contact/stability/unstable_count.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    const double largest_phase_step   = 0.8;
    const double largest_modulus_step = 1.;

    double relative_difference(const ComplexMatrix &A, const ComplexMatrix &B)
    {
      const double size = B.norm(), difference = (A - B).norm();
      return size > 0. ? difference / size : difference;
    }
  } // namespace

  UnstableCounter::UnstableCounter(const ReducedPair  &pair,
                                   const CountOptions &options)
    : options(options)
    , pair(pair)
  {
    if (!(options.lowest_frequency > 0.) ||
        !(options.highest_frequency > options.lowest_frequency))
      throw InputError("Unstable modes are counted from " +
                       significant(options.lowest_frequency, 6) + " Hz to " +
                       significant(options.highest_frequency, 6) +
                       " Hz: both must be > 0 Hz, the second the higher one.");
    find_motions();
    find_poles();
    set_contour();
  }

  void UnstableCounter::find_motions()
  {
    DenseMatrix  flexible = pair.Phi;
    const double lowest   = std::pow(2 * pi * options.lowest_frequency, 2.);
    for (std::size_t k = 0; k < pair.n_modes(); ++k)
      flexible.col(k) /= std::sqrt(std::max(std::abs(pair.K_m(k, k)), lowest));
    std::vector<double> values;
    const DenseMatrix all = left_singular_vectors(std::move(flexible), values);
    std::size_t       p   = 0;
    while (p < values.size() &&
           values[p] > options.motion_tolerance * values[0])
      ++p;
    U = all.leftCols(p);
    L = pair.Phi.transpose() * U;
  }

  void UnstableCounter::find_poles()
  {
    const std::size_t m = pair.n_modes();
    const double      rate =
      2 * pi * std::sqrt(options.lowest_frequency * options.highest_frequency);
    DenseMatrix first_order(2 * m, 2 * m);
    first_order << DenseMatrix::Zero(m, m), rate * DenseMatrix::Identity(m, m),
      -pair.K_m / rate, -pair.C_m;
    const Eigenpairs pairs = eigenpairs(std::move(first_order));
    poles                  = pairs.values;
    right                  = ComplexMatrix::Zero(2 * m, n_motions());
    right.bottomRows(m)    = (L / rate).cast<std::complex<double>>();
    const ComplexLU factors(pairs.vectors);
    poles_hold = !factors.singular();
    if (poles_hold)
      {
        factors.solve(right);
        left =
          L.transpose().cast<std::complex<double>>() * pairs.vectors.topRows(m);
      }
    // vectors that nearly coincide, as those of rigid modes, give no residues
    for (const double share : {0.07, 0.31, 0.83})
      if (poles_hold)
        {
          const std::complex<double> s(0.02 * rate,
                                       2 * pi * share *
                                         options.highest_frequency);
          poles_hold =
            relative_difference(body_response(s), solved_response(s)) < 1e-8;
        }
  }

  ComplexMatrix
  UnstableCounter::solved_response(const std::complex<double> s) const
  {
    ComplexMatrix D = pair.K_m + s * pair.C_m;
    D.diagonal().array() += s * s;
    const ComplexMatrix forces = L.cast<std::complex<double>>();
    ComplexMatrix       X      = forces;
    ComplexLU(std::move(D)).solve(X);
    return forces.transpose() * X;
  }

  ComplexMatrix
  UnstableCounter::body_response(const std::complex<double> s) const
  {
    if (!poles_hold)
      return solved_response(s);
    ComplexMatrix weighted = right;
    for (std::size_t i = 0; i < poles.size(); ++i)
      weighted.row(i) /= s - poles[i];
    return left * weighted;
  }

  void UnstableCounter::set_contour()
  {
    const double low  = 2 * pi * options.lowest_frequency,
                 high = 2 * pi * options.highest_frequency,
                 from = options.least_growth, to = from + high;
    std::vector<double> rising;
    for (unsigned int k = 0; k <= 400; ++k)
      rising.push_back(low + (high - low) * k / 400);
    for (const auto &pole : poles)
      {
        const double distance = std::abs(pole.real() - from),
                     width    = std::max(distance, 1e-3);
        if (!(distance < 60.))
          continue;
        rising.push_back(pole.imag());
        const double reach = std::min(3000., 600 / width);
        for (unsigned int k = 0; k < 9; ++k)
          for (const double sign : {1., -1.})
            rising.push_back(pole.imag() + sign * width * 0.3 *
                                             std::pow(reach / 0.3, k / 8.));
      }
    rising.erase(std::remove_if(rising.begin(),
                                rising.end(),
                                [&](const double x) {
                                  return !(x >= low && x <= high);
                                }),
                 rising.end());
    std::sort(rising.begin(), rising.end());
    rising.erase(std::unique(rising.begin(), rising.end()), rising.end());

    const unsigned int n = 60;
    // near the imaginary axis things change fast
    const auto across = [&](const unsigned int k) {
      return from + (to - from) * std::expm1(8. * k / n) / std::expm1(8.);
    };
    for (unsigned int k = 0; k < n; ++k)
      contour.push_back({across(k), low});
    for (unsigned int k = 0; k < n; ++k)
      contour.push_back({to, low + (high - low) * k / n});
    for (unsigned int k = n; k > 0; --k)
      contour.push_back({across(k), high});
    for (std::size_t k = rising.size(); k-- > 0;)
      contour.push_back({from, rising[k]});
    for (const auto &s : contour)
      response.push_back(body_response(s));
  }

  ComplexValues UnstableCounter::fit_points() const
  {
    const double low  = 2 * pi * options.lowest_frequency,
                 high = 2 * pi * options.highest_frequency,
                 from = options.least_growth;
    ComplexValues points;
    const int     n = 40;
    for (int k = 0; k <= n; ++k)
      {
        const double share = static_cast<double>(k) / n;
        points.push_back({from, low * std::pow(high / low, share)});
        points.push_back({from, low * 1.003 + (high - low) * share});
      }
    for (int k = 1; k <= 18; ++k)
      {
        const double share = k / 18.;
        points.push_back({from + high * std::pow(1e-3, 1 - share), low});
        points.push_back({from + high * std::pow(1e-3, 1 - share), high});
        points.push_back({from + high, low + (high - low) * (share - 0.03)});
      }
    return points;
  }

  bool UnstableCounter::inside(const std::complex<double> s) const
  {
    return s.real() > options.least_growth &&
           s.real() <
             options.least_growth + 2 * pi * options.highest_frequency &&
           s.imag() > 2 * pi * options.lowest_frequency &&
           s.imag() < 2 * pi * options.highest_frequency;
  }

  namespace
  {
    /**
     * The phase of a function along the way between two points, divided until
     * no step is large.
     */
    class Turning
    {
    public:
      using Logarithm =
        std::function<std::complex<double>(const std::complex<double>)>;

      Turning(const Logarithm &logarithm, UnstableCount &result)
        : logarithm(logarithm)
        , result(result)
      {}

      double between(const std::complex<double> a,
                     const std::complex<double> at_a,
                     const std::complex<double> b,
                     const std::complex<double> at_b)
      {
        const double step   = std::remainder(at_b.imag() - at_a.imag(), 2 * pi),
                     growth = std::abs(at_b.real() - at_a.real());
        const bool small    = std::abs(step) <= largest_phase_step &&
                           growth <= largest_modulus_step;
        if (small || std::abs(b - a) < 1e-12 * std::abs(a))
          {
            if (!small)
              result.resolved = false;
            result.largest_step = std::max(result.largest_step, std::abs(step));
            return std::isfinite(step) ? step : 0.;
          }
        const std::complex<double> middle    = (a + b) / 2.,
                                   at_middle = logarithm(middle);
        ++result.n_points;
        return between(a, at_a, middle, at_middle) +
               between(middle, at_middle, b, at_b);
      }

    private:
      const Logarithm &logarithm;
      UnstableCount   &result;
    };

    RationalFit fit_of(const ContactResponse &direct,
                       const ComplexValues   &points,
                       const std::size_t      p)
    {
      ComplexMatrix values(points.size(), p * p);
      for (std::size_t i = 0; i < points.size(); ++i)
        values.row(i) = direct(points[i]).reshaped();
      return RationalFit(points, values);
    }

    /**
     * ln det(I - H G).
     */
    std::complex<double> log_determinant(const ComplexMatrix &H,
                                         const ComplexMatrix &G)
    {
      ComplexMatrix M = -H * G;
      M.diagonal().array() += 1.;
      return ComplexLU(std::move(M)).log_determinant();
    }
  } // namespace

  UnstableCount UnstableCounter::count(const LinearContact &contact) const
  {
    if (contact.forces.rows() != pair.W_res.rows())
      throw InputError("Bodies and contact of a count of unstable modes do not "
                       "have the same nodes.");
    UnstableCount         result;
    const ContactResponse direct(contact, pair, U);
    const std::size_t     p   = n_motions();
    const RationalFit     fit = fit_of(direct, fit_points(), p);
    // where no point of the fit is
    for (std::size_t k = 7; k < contour.size(); k += contour.size() / 23)
      if (relative_difference(fit(contour[k]).reshaped(p, p),
                              direct(contour[k])) > 1e-7)
        result.fitted = false;
    const MatrixFunction G = [&](const std::complex<double> s) {
      return result.fitted ? ComplexMatrix(fit(s).reshaped(p, p)) : direct(s);
    };
    const Turning::Logarithm logarithm = [&](const std::complex<double> s) {
      return log_determinant(body_response(s), G(s));
    };

    ComplexValues logarithms;
    for (std::size_t k = 0; k < contour.size(); ++k)
      logarithms.push_back(log_determinant(response[k], G(contour[k])));
    result.n_points = contour.size();
    Turning turning(logarithm, result);
    double  phase = 0.;
    for (std::size_t k = 0; k < contour.size(); ++k)
      {
        const std::size_t next = (k + 1) % contour.size();
        phase += turning.between(contour[k],
                                 logarithms[k],
                                 contour[next],
                                 logarithms[next]);
      }
    result.turns = phase / (2 * pi);
    for (const auto &pole : direct.poles(1.3 * contour.back().imag()))
      result.n_contact_poles += inside(pole);
    for (const auto &pole : poles)
      result.n_body_poles += inside(pole);
    result.count =
      std::lround(result.turns) + result.n_contact_poles + result.n_body_poles;
    return result;
  }
} // namespace RollingContact
