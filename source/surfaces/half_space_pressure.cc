#include <rolling_contact/algebra/fourier.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/surfaces/half_space_pressure.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace RollingContact
{
  namespace
  {
    /**
     * The integral of 1/r over the rectangle that has a corner at the origin
     * and the opposite one at (x, y), with the sign of x y. Units: m.
     */
    double integral_to_corner(const double x, const double y)
    {
      return x * std::asinh(y / std::abs(x)) + y * std::asinh(x / std::abs(y));
    }

    /**
     * What a pressure of 1 Pa on one rectangle moves the middle of another, so
     * many rectangles along and across away. Units: m/Pa.
     */
    double influence_at(const ContactGrid &grid,
                        const double       contact_modulus,
                        const int          along,
                        const int          across)
    {
      const double left   = (along - 0.5) * grid.size_x,
                   right  = (along + 0.5) * grid.size_x,
                   lower  = (across - 0.5) * grid.size_y,
                   higher = (across + 0.5) * grid.size_y;
      return (integral_to_corner(right, higher) -
              integral_to_corner(left, higher) -
              integral_to_corner(right, lower) +
              integral_to_corner(left, lower)) /
             (pi * contact_modulus);
    }

    /**
     * Polonsky and Keer's iteration.
     */
    class Iteration
    {
    public:
      Iteration(const ContactGrid           &grid,
                const std::vector<double>   &gap,
                const double                 contact_modulus,
                const std::optional<double> &load,
                const double                 approach,
                const std::vector<double>   &shares)
        : influence(grid.n_x,
                    grid.n_y,
                    1,
                    [&](const int along, const int across, int, int) {
                      return influence_at(grid,
                                          contact_modulus,
                                          std::abs(along),
                                          std::abs(across));
                    })
        , shares(shares)
        , area(grid.size_x * grid.size_y)
        , gap(gap)
        , load(load)
        , state{std::vector<double>(gap.size(), 0.), approach, 0.}
        , direction(gap.size(), 0.)
      {
        start(contact_modulus * std::sqrt(area));
      }

      HalfSpacePressure solve()
      {
        const unsigned int max_rounds = 1000;
        const double       accuracy   = 1e-4;
        for (unsigned int k = 0; k < max_rounds; ++k)
          {
            if (state.load == 0.)
              return state;
            if (advance() < accuracy)
              return state;
          }
        throw std::runtime_error(
          "The contact of half-spaces was not found in " +
          std::to_string(max_rounds) + " rounds.");
      }

    private:
      /**
       * Pressure where the surfaces would overlap, in proportion.
       */
      void start(const double stiffness)
      {
        double level = state.approach;
        if (load)
          {
            std::vector<double> sorted = gap;
            const auto          middle = sorted.begin() + sorted.size() / 4;
            std::nth_element(sorted.begin(), middle, sorted.end());
            level = *middle;
          }
        for (std::size_t i = 0; i < gap.size(); ++i)
          state.pressure[i] = std::max(0., level - gap[i]) * stiffness / area;
        rescale();
      }

      void rescale()
      {
        state.load =
          area *
          std::accumulate(state.pressure.begin(), state.pressure.end(), 0.);
        if (!load || state.load == 0.)
          return;
        for (double &p : state.pressure)
          p *= *load / state.load;
        state.load = *load;
      }

      double mean_of_touching(const std::vector<double> &values) const
      {
        double      sum = 0.;
        std::size_t n   = 0;
        for (std::size_t i = 0; i < values.size(); ++i)
          if (state.pressure[i] > 0.)
            {
              sum += values[i];
              ++n;
            }
        return sum / n;
      }

      double advance();

      /** What pressures times shares move, over the shares. */
      std::vector<double> displacement(std::vector<double> pressure)
      {
        for (std::size_t i = 0; i < shares.size(); ++i)
          pressure[i] /= shares[i];
        std::vector<double> result = influence.multiply(pressure);
        for (std::size_t i = 0; i < shares.size(); ++i)
          result[i] /= shares[i];
        return result;
      }

      Signals::GridConvolution    influence;
      const std::vector<double>  &shares;
      const double                area;
      const std::vector<double>  &gap;
      const std::optional<double> load;
      HalfSpacePressure           state;
      std::vector<double>         direction;
      double                      old_square = 1.;
      bool                        restarts   = true;
    };

    /**
     * One round; what it changed of the load, over the load.
     */
    double Iteration::advance()
    {
      std::vector<double> opening = displacement(state.pressure);
      for (std::size_t i = 0; i < gap.size(); ++i)
        opening[i] += gap[i];
      if (load)
        state.approach = mean_of_touching(opening);
      double square = 0.;
      for (std::size_t i = 0; i < gap.size(); ++i)
        {
          opening[i] -= state.approach;
          if (state.pressure[i] > 0.)
            square += opening[i] * opening[i];
        }
      for (std::size_t i = 0; i < gap.size(); ++i)
        direction[i] =
          state.pressure[i] > 0.
            ? opening[i] + (restarts ? 0. : square / old_square * direction[i])
            : 0.;
      old_square                 = square;
      std::vector<double> change = displacement(direction);
      const double        mean   = load ? mean_of_touching(change) : 0.;
      double              above = 0., below = 0.;
      for (std::size_t i = 0; i < gap.size(); ++i)
        if (state.pressure[i] > 0.)
          {
            above += opening[i] * direction[i];
            below += (change[i] - mean) * direction[i];
          }
      const double              step = below > 0. ? above / below : 0.;
      const std::vector<double> old  = state.pressure;
      restarts                       = false;
      for (std::size_t i = 0; i < gap.size(); ++i)
        {
          double &p = state.pressure[i];
          if (p > 0.)
            p = std::max(0., p - step * direction[i]);
          if (p == 0. && opening[i] < 0.)
            {
              p        = -step * opening[i];
              restarts = true;
            }
        }
      rescale();
      double changed = 0.;
      for (std::size_t i = 0; i < gap.size(); ++i)
        changed += std::abs(state.pressure[i] - old[i]);
      return changed * area / state.load;
    }
  } // namespace

  HalfSpacePressure half_space_pressure(const ContactGrid         &grid,
                                        const std::vector<double> &gap,
                                        const double contact_modulus,
                                        const std::optional<double> &load,
                                        const double                 approach,
                                        const std::vector<double>   &shares)
  {
    // with gaps and displacements over the shares and pressures times them it
    // is the problem of a plane with another, still symmetric, influence
    std::vector<double> scaled = gap;
    for (std::size_t i = 0; i < shares.size(); ++i)
      scaled[i] /= shares[i];
    HalfSpacePressure found =
      Iteration(grid, scaled, contact_modulus, load, approach, shares).solve();
    for (std::size_t i = 0; i < shares.size(); ++i)
      found.pressure[i] /= shares[i];
    return found;
  }
} // namespace RollingContact
