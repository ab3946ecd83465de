#include <Eigen/LU>

#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/references/bracketed_root.h>
#include <rolling_contact/references/checks.h>
#include <rolling_contact/references/hertz_line.h>
#include <rolling_contact/references/layered_line.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace RollingContact::References
{
  namespace
  {
    using Matrix = Eigen::MatrixXd;
    using Vector = Eigen::VectorXd;

    /// thinnest layer over the half-width
    const double thinnest = 0.01;

    double sign(const unsigned int j)
    {
      return j % 2 == 0 ? 1. : -1.;
    }

    /**
     * The equations for the terms of pressure, those of traction and the
     * creepage.
     */
    class Collocation
    {
    public:
      Collocation(const LayeredPair &bodies,
                  const double       half_width,
                  const unsigned int n,
                  const bool         sticks);

      /** Terms of the pressure, of the traction and the creepage. */
      Vector solve(const double relative_radius) const;

    private:
      double angle(const unsigned int i, const unsigned int n_points) const
      {
        return pi * (2 * i + 1) / (4 * n_points);
      }

      void add_materials(const SurfaceCompliance &C);

      void add_layers(const LayeredPair &bodies);

      const double       a;
      const unsigned int n;
      const bool         sticks;
      Matrix             system;
    };

    Collocation::Collocation(const LayeredPair &bodies,
                             const double       half_width,
                             const unsigned int n,
                             const bool         sticks)
      : a(half_width)
      , n(n)
      , sticks(sticks)
      , system(Matrix::Zero(sticks ? 2 * n + 1 : n, sticks ? 2 * n + 1 : n))
    {
      add_materials(of_materials(bodies));
      add_layers(bodies);
      if (sticks)
        system.col(2 * n).tail(n + 1).setConstant(-1.);
    }

    void Collocation::add_materials(const SurfaceCompliance &C)
    {
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          {
            const double theta = angle(i, n);
            system(i, j) += C.normal * std::cos((2 * j + 1) * theta);
            if (sticks)
              system(i, n + j) += C.coupling * std::sin((2 * j + 2) * theta);
          }
      for (unsigned int i = 0; sticks && i < n + 1; ++i)
        for (unsigned int j = 0; j < n; ++j)
          {
            const double theta = angle(i, n + 1);
            system(n + i, j) += C.coupling * std::sin((2 * j + 1) * theta);
            system(n + i, n + j) -=
              C.tangential * std::cos((2 * j + 2) * theta);
          }
    }

    void Collocation::add_layers(const LayeredPair &bodies)
    {
      over_wave_numbers(bodies, a, [&](const double k, const double weight) {
        const SurfaceCompliance C = beyond_materials(bodies, k);
        const Vector            J = bessel_functions(2 * n, k * a);
        Vector                  p(n), q(n);
        for (unsigned int j = 0; j < n; ++j)
          {
            p[j] = sign(j) * (2 * j + 1) * J[2 * j] / k * weight;
            q[j] = sign(j) * (2 * j + 2) * J[2 * j + 1] / k * weight;
          }
        for (unsigned int i = 0; i < n; ++i)
          {
            const double sine = std::sin(k * a * std::cos(angle(i, n)));
            system.row(i).head(n) += C.normal * sine * p.transpose();
            if (sticks)
              system.row(i).segment(n, n) += C.coupling * sine * q.transpose();
          }
        for (unsigned int i = 0; sticks && i < n + 1; ++i)
          {
            const double cosine = std::cos(k * a * std::cos(angle(i, n + 1)));
            system.row(n + i).head(n) += C.coupling * cosine * p.transpose();
            system.row(n + i).segment(n, n) +=
              C.tangential * cosine * q.transpose();
          }
      });
    }

    Vector Collocation::solve(const double relative_radius) const
    {
      Vector right = Vector::Zero(system.rows());
      for (unsigned int i = 0; i < n; ++i)
        right[i] = a * std::cos(angle(i, n)) / relative_radius;
      return system.partialPivLu().solve(right);
    }

    /**
     * Approach of the layer of one body beyond that of its core under Hertz's
     * pressure of the same load; @p side: 1, or -1 of the body on which q acts
     * the other way round.
     */
    double approach_of(const LayeredPlane &body,
                       const LayeredLine  &line,
                       const double        side)
    {
      const double            a = line.half_width, h = body.thickness;
      const SurfaceCompliance core =
                                half_plane_compliance(body.core_young_modulus,
                                                      body.core_poisson_ratio),
                              own = material_compliance(body);
      const double change         = own.normal - core.normal,
                   Theta          = std::asinh(2 * h / a);
      const unsigned int n        = line.pressure_terms.size();
      const auto         traction = [&](const unsigned int j) {
        return line.traction_terms.empty() ? 0. : line.traction_terms[j];
      };
      double approach = 0.;
      for (unsigned int j = 0; j < n; ++j)
        {
          const double m = 2. * j + 1, p = sign(j) * line.pressure_terms[j],
                       q       = sign(j) * side * traction(j),
                       above   = -std::expm1(-(m + 1) * Theta) / (m + 1),
                       below   = j == 0 ? Theta
                                        : -std::expm1(-(m - 1) * Theta) / (m - 1),
                       of_core = j == 0 ? 0. : core.normal * a / (m * m - 1);
          approach += p * (change * a / 2 * (below + above) + m * of_core) +
                      q * own.coupling * (m + 1) * a / (m * (m + 2));
        }
      if (h == 0.)
        return approach;
      over_wave_numbers(LayeredPair{{body, {0., 1., 0., 1., 0.}}},
                        a,
                        [&](const double k, const double weight) {
                          const SurfaceCompliance all = compliance(body, k);
                          const Vector J      = bessel_functions(2 * n, k * a);
                          const double normal = all.normal - core.normal +
                                                change * std::expm1(-2 * k * h);
                          for (unsigned int j = 0; j < n; ++j)
                            approach +=
                              sign(j) * weight / (k * k) *
                              ((2 * j + 1) * J[2 * j] * line.pressure_terms[j] *
                                 normal +
                               (2 * j + 2) * J[2 * j + 1] * side * traction(j) *
                                 (all.coupling - own.coupling));
                        });
      return approach;
    }

    /** sqrt(1-t^2) times a sum of the U of numbers first, first + 2, ... */
    double series(const double               x,
                  const double               half_width,
                  const std::vector<double> &terms,
                  const unsigned int         first)
    {
      if (std::abs(x) >= half_width)
        return 0.;
      const double theta = std::acos(x / half_width);
      double       sum   = 0.;
      for (unsigned int j = 0; j < terms.size(); ++j)
        sum += terms[j] * std::sin((2 * j + 1 + first) * theta);
      return sum;
    }
  } // namespace

  double LayeredLine::pressure(const double x) const
  {
    return series(x, half_width, pressure_terms, 0);
  }

  double LayeredLine::traction(const double x) const
  {
    return series(x, half_width, traction_terms, 1);
  }

  double LayeredLine::load_per_length() const
  {
    return pi * half_width * pressure_terms.at(0) / 2;
  }

  double LayeredLine::least_friction() const
  {
    const unsigned int n_places = 400;
    double             largest  = 0.;
    for (unsigned int i = 1; i < n_places; ++i)
      {
        const double x = half_width * std::cos(pi * i / (2 * n_places));
        largest        = std::max(largest, std::abs(traction(x)) / pressure(x));
      }
    return largest;
  }

  LayeredLine layered_line_of_half_width(const double       half_width,
                                         const LayeredPair &bodies,
                                         const double       relative_radius,
                                         const LineFriction friction,
                                         const unsigned int n_terms)
  {
    check_positive("Half-width", half_width, "m");
    check_positive("Relative radius", relative_radius, "m");
    double thin = std::numeric_limits<double>::infinity();
    for (const LayeredPlane &body : bodies)
      if (body.thickness > 0.)
        thin = std::min(thin, body.thickness / half_width);
    if (thin < thinnest)
      reject("Thickness of a layer",
             thin * half_width,
             "m",
             "at least a hundredth of the half-width of the patch, " +
               significant(half_width, 3) + " m");
    const bool         sticks = friction == LineFriction::sticks;
    const unsigned int n = n_terms > 0 ? n_terms : std::min(80., 12 + 4 / thin);
    const Vector       found =
      Collocation(bodies, half_width, n, sticks).solve(relative_radius);
    LayeredLine line;
    line.half_width = half_width;
    line.pressure_terms.assign(found.data(), found.data() + n);
    if (sticks)
      {
        line.traction_terms.assign(found.data() + n, found.data() + 2 * n);
        line.creepage = found[2 * n];
      }
    line.approach_of_layers =
      approach_of(bodies[0], line, 1.) + approach_of(bodies[1], line, -1.);
    return line;
  }

  LayeredLine layered_line(const double       load_per_length,
                           const LayeredPair &bodies,
                           const double       relative_radius,
                           const LineFriction friction,
                           const unsigned int n_terms)
  {
    check_positive("Load per length", load_per_length, "N/m");
    const auto hertz = [&](const double compliance) {
      return hertz_line(load_per_length, relative_radius, 2 / compliance)
        .half_width;
    };
    double core = 0., largest = std::numeric_limits<double>::infinity();
    for (const LayeredPlane &body : bodies)
      {
        core += half_plane_compliance(body.core_young_modulus,
                                      body.core_poisson_ratio)
                  .normal;
        if (body.thickness > 0.)
          largest = std::min(largest, 0.999 * body.thickness / thinnest);
      }
    const double both  = of_materials(bodies).normal,
                 slack = 2., // for what sticks
      upper            = std::min(largest, slack * hertz(std::max(core, both)));
    const auto excess  = [&](const double log_half_width) {
      return std::log(
        layered_line_of_half_width(
          std::exp(log_half_width), bodies, relative_radius, friction, n_terms)
          .load_per_length() /
        load_per_length);
    };
    if (excess(std::log(upper)) < 0.)
      reject("Load per length",
             load_per_length,
             "N/m",
             "so small that a layer is no thinner than a hundredth of the "
             "patch's half-width");
    double lower = upper / 2;
    while (excess(std::log(lower)) > 0.)
      lower /= 2;
    return layered_line_of_half_width(
      std::exp(bracketed_root(excess, std::log(lower), std::log(2 * lower))),
      bodies,
      relative_radius,
      friction,
      n_terms);
  }

  double load_of_thin_layer(const double half_width,
                            const double thickness,
                            const double young_modulus,
                            const double poisson_ratio,
                            const double relative_radius)
  {
    check_elasticity(young_modulus, poisson_ratio);
    check_positive("Thickness of the layer", thickness, "m");
    const double a = half_width, h = thickness, nu = poisson_ratio;
    return nu == 0.5 ? 2 * young_modulus * std::pow(a, 5) /
                         (45 * relative_radius * std::pow(h, 3))
                     : 2 * young_modulus * (1 - nu) * std::pow(a, 3) /
                         (3 * (1 + nu) * (1 - 2 * nu) * relative_radius * h);
  }
} // namespace RollingContact::References
