#include <rolling_contact/analyses/decay_energies.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/modes/fading_waves.h>
#include <rolling_contact/modes/frequency_response.h>
#include <rolling_contact/modes/measuring_point.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  const std::array<DecayDirection, 2> decay_directions{
    {{2, "vertical"}, {1, "lateral"}}};

  namespace
  {
    using Complex = std::complex<double>;

    /**
     * Energies of a rail without ends. Beside a force waves say all; under it
     * they lack a compliance that is the same at all frequencies, but for the
     * losses of the material.
     */
    class EnergiesOfWaves : public DecayEnergies
    {
    public:
      EnergiesOfWaves(const VibratingBody<3> &rail,
                      const DecayGrid        &grid,
                      const double            load_radius)
        : waves(*rail.waves)
      {
        const MeasuringPoint contact(*rail.body, {{0., 0., 0.}}, load_radius);
        const std::size_t    n = rail.K.size();
        std::vector<std::vector<double>> loads;
        for (const DecayDirection &direction : decay_directions)
          loads.push_back(contact.load(direction.axis, n));
        const auto middle =
          middle_of(rail.places, decay_directions[0].axis, as_vector(loads[0]));
        for (const double x : grid.distances())
          places.push_back({{middle[0] + x, middle[1], middle[2]}});
        const Complex     s(0., 2 * pi * beginning);
        const DenseMatrix beyond =
          waves.beyond_mesh(*rail.body, *rail.factor, {middle});
        const ComplexMatrix unlike =
          waves.stiffening(s) * (waves.change(s, {middle}) -
                                 waves.waveguide().receptances(s, {middle}));
        for (std::size_t d = 0; d < loads.size(); ++d)
          {
            const unsigned int axis  = decay_directions[d].axis;
            const auto         moved = rail.factor->solve(loads[d]);
            local[d] = as_vector(loads[d]).dot(as_vector(moved)) +
                       beyond(axis, axis) + unlike(axis, axis).real();
          }
      }

      std::vector<double> at(const double frequency) override
      {
        throw_if_interrupted();
        const Complex       s(0., 2 * pi * frequency);
        ComplexMatrix       forces = ComplexMatrix::Zero(3, local.size());
        std::vector<double> result;
        for (std::size_t d = 0; d < local.size(); ++d)
          forces(decay_directions[d].axis, d) = 1.;
        const ComplexMatrix moved = WaveguideResponse(waves.waveguide(), s)
                                      .field(places, places[0], forces);
        for (std::size_t d = 0; d < local.size(); ++d)
          for (std::size_t p = 0; p < places.size(); ++p)
            result.push_back(
              std::norm(s * (moved(3 * p + decay_directions[d].axis, d) +
                             (p == 0 ? local[d] / waves.stiffening(s) : 0.))));
        return result;
      }

    private:
      static constexpr double beginning = 100.; // Hz

      const RailWaves              &waves;
      std::vector<RailWaves::Place> places;
      std::array<double, 2>         local{}; ///< m/N
    };

    /**
     * Energies of a rail that ends: at places before its absorbing ends as its
     * modes say, further on by waves fitted to its motion from 1 m on.
     */
    class EnergiesOfMesh : public DecayEnergies
    {
    public:
      EnergiesOfMesh(const VibratingBody<3> &rail,
                     const DecayGrid        &grid,
                     const double            load_radius)
        : grid(grid)
        , step(grid.distances()[1] / 2)
        , first(std::ceil(begin_of_fit / step))
        , in_period(rail.parameters.model.foundation.pad_spacing > 0. ? in_bay
                                                                      : 1)
      {
        const BodySpec &body = rail.parameters;
        const double    ends = body.model.damping.sponge_length,
                     reach   = body.body_shape()->reach_x() - ends;
        n_places             = 1 + std::max(0., std::floor(reach / step));
        const unsigned int least =
          first + 1 + (in_period > 1 ? 4 * in_bay : least_samples);
        if (body.body_shape()->extruded_section() == nullptr)
          throw InputError(
            "Receptance/Decay rates = true: the rail does not have one "
            "section along x; take Rail/Shape = section with Radius = 0, or Body "
            "sections = true.");
        if (n_places < least)
          throw InputError(body.section + "/Block length = " +
                           significant(2 * (reach + ends), 6) +
                           " m: Receptance/Decay rates need " +
                           significant((least - 1) * step, 3) +
                           " m from the contact to where Sponge length = " +
                           significant(ends, 4) + " m begins; give " +
                           significant(2 * ((least - 1) * step + ends), 4) +
                           " m or more, or Model = waveguide.");
        std::vector<std::vector<double>> loads;
        for (const DecayDirection &direction : decay_directions)
          for (std::size_t m = 0; m < n_places; ++m)
            loads.push_back(
              MeasuringPoint(*rail.body, {{m * step, 0., 0.}}, load_radius)
                .load(direction.axis, rail.K.size()));
        response = std::make_unique<FrequencyResponse>(
          VibratingStructure{
            rail.K, rail.M, rail.H, rail.C, rail.body->nodes_of_unknowns()},
          *rail.factor,
          rail.shift,
          rail.modes,
          rail.given_damping(),
          loads);
      }

      std::vector<double> at(const double frequency) override
      {
        throw_if_interrupted();
        const ComplexMatrix alpha = response->receptances(frequency);
        std::vector<double> result;
        for (std::size_t d = 0; d < decay_directions.size(); ++d)
          {
            const ComplexVector A =
              alpha.col(d * n_places).segment(d * n_places, n_places);
            const std::size_t periods = (n_places - first) / in_period;
            const FadingWaves waves(A.segment(first, periods * in_period)
                                      .reshaped(in_period, periods),
                                    most_waves);
            fits[d].push_back(
              {frequency, waves.misfit(), waves.returning() / std::abs(A[0])});
            for (const double x : grid.distances())
              {
                const std::size_t m = std::lround(x / step), beyond = m - first;
                result.push_back(std::norm(
                  2 * pi * frequency *
                  (m < n_places
                     ? A[m]
                     : waves.at(beyond % in_period, beyond / in_period))));
              }
          }
        return result;
      }

      void tell(Log &log) const override
      {
        log.message("Receptance/Decay rates: vibration is that of the mesh up "
                    "to " +
                    significant((n_places - 1) * step, 3) +
                    " m from the contact, where the rail has no absorbing "
                    "end. Beyond, it is that of waves fitted from " +
                    significant(first * step, 3) + " m on.");
        for (std::size_t d = 0; d < decay_directions.size(); ++d)
          {
            std::vector<double> doubtful; // Hz
            double              misfit = 0., returning = 0.;
            for (const Fit &fit : fits[d])
              {
                misfit    = std::max(misfit, fit.misfit);
                returning = std::max(returning, fit.returning);
                if (fit.misfit > allowed_misfit ||
                    fit.returning > allowed_return)
                  doubtful.push_back(fit.frequency);
              }
            const std::string what =
              "these waves are off by " + significant(100 * misfit, 2) +
              " % of the " + decay_directions[d].name +
              " motion at most, and the reflection from the end is up to " +
              significant(100 * returning, 2) +
              " % of the motion at the contact";
            if (doubtful.empty())
              log.detail("Receptance/Decay rates: " + what + ".");
            else
              log.warning(
                "Receptance/Decay rates: " + what + ": " +
                decay_directions[d].name + " rates are doubtful from " +
                significant(doubtful.front(), 3) + " to " +
                significant(doubtful.back(), 3) + " Hz, by " +
                std::to_string(doubtful.size()) + " of " +
                std::to_string(fits[d].size()) +
                " frequencies. Give the rail a larger Block length and Sponge "
                "length, or take Model = waveguide.");
          }
      }

    private:
      static constexpr double       begin_of_fit = 1.; // m
      static constexpr unsigned int in_bay = 8, least_samples = 12,
                                    most_waves = 6;
      static constexpr double allowed_misfit = 0.02, allowed_return = 0.03;

      struct Fit
      {
        double frequency, misfit, returning; ///< the last over A(0)
      };

      const DecayGrid                   &grid;
      const double                       step; ///< m
      const std::size_t                  first, in_period;
      std::size_t                        n_places = 0;
      std::unique_ptr<FrequencyResponse> response;
      std::array<std::vector<Fit>, 2>    fits;
    };
  } // namespace

  std::array<double, 3> middle_of(const BodyPlaces      &places,
                                  const unsigned int     axis,
                                  const Eigen::VectorXd &forces)
  {
    std::array<double, 3> middle{{0., 0., 0.}};
    double                sum = 0.;
    for (const BodyPlaces::Node &node : places.nodes)
      if (const int unknown = node.unknowns[axis]; unknown >= 0)
        {
          sum += forces[unknown];
          for (unsigned int c = 0; c < 3; ++c)
            middle[c] += forces[unknown] * node.point[c];
        }
    for (double &coordinate : middle)
      coordinate /= sum;
    return middle;
  }

  std::unique_ptr<DecayEnergies>
  decay_energies(const VibratingBody<3>     &rail,
                 const DecayGrid            &grid,
                 const ReceptanceParameters &section)
  {
    if (rail.waves)
      return std::make_unique<EnergiesOfWaves>(rail, grid, section.load_radius);
    return std::make_unique<EnergiesOfMesh>(rail, grid, section.load_radius);
  }
} // namespace RollingContact
