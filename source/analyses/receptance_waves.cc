#include <rolling_contact/analyses/decay_energies.h>
#include <rolling_contact/analyses/receptance.h>
#include <rolling_contact/analyses/track_decay.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/run/figure.h>

#include <algorithm>

namespace RollingContact
{
  namespace
  {
    using Complex = std::complex<double>;

    const char waves_file[] = "waves.csv";

    /// beyond which waves are not told: dB/m
    const double strongest_decay = 100.;

    const std::array<std::string, 3> ways_of_waves{
      {"along", "lateral", "vertical"}};
  } // namespace

  template <int dim>
  void Receptance<dim>::sweep_waves(const VibratingBody<dim> &body,
                                    ResultsTable             &table)
  {
    if (!section.check_frequencies.empty())
      context.log.warning(
        "Receptance/Check frequencies has no effect on a rail without ends: "
        "its error is found with a coarser section.");
    std::vector<Station> stations;
    DenseMatrix          y = columns_of(loads(body, stations), body.K.size());
    std::vector<ComplexMatrix> alpha;
    const auto                 frequencies = section.frequencies();
    if constexpr (dim == 3)
      {
        PhaseTimer::Scope             phase(context.timer, Phase::response);
        const DenseMatrix             forces = y;
        std::vector<RailWaves::Place> places;
        for (std::size_t i = 0; i < stations.size(); i += section.axes().size())
          places.push_back(
            middle_of(body.places, stations[i].axis, forces.col(i)));
        DenseMatrix chosen =
          DenseMatrix::Zero(stations.size(), 3 * places.size());
        const auto n_axes = section.axes().size();
        for (std::size_t i = 0; i < stations.size(); ++i)
          chosen(i, 3 * (i / n_axes) + stations[i].axis) = stations[i].sign;
        body.factor->solve(y);
        const DenseMatrix at_rest =
          forces.transpose() * y +
          chosen * body.waves->beyond_mesh(*body.body, *body.factor, places) *
            chosen.transpose();
        for (const double frequency : frequencies)
          {
            throw_if_interrupted();
            const Complex s(0., 2 * pi * frequency);
            alpha.push_back(at_rest / body.waves->stiffening(s) +
                            chosen * body.waves->change(s, places) *
                              chosen.transpose());
            add_rows(body.side, stations, frequency, alpha.back(), table);
          }
        write_waves(*body.waves);
        if (section.decay_rates)
          TrackDecay(body, section, context).write(scene.inputs->output.plot);
      }
    note_peak(
      body, "waves in its section, without ends", stations, frequencies, alpha);
    context.report.errors.push_back(
      {"receptance of the " + name_of(body.side),
       body.waves->lower_degree_error(throw_if_interrupted),
       "the largest at that frequency",
       "a coarser section, without the error of the mesh at rest",
       true,
       ""});
    if (scene.inputs->output.plot)
      plot(body.side, stations, frequencies, alpha);
  }

  template <int dim>
  void Receptance<dim>::write_waves(const RailWaves &waves) const
  {
    if (waves.waveguide().has_pads())
      return; // its waves are those of the bays, not of the section
    ResultsTable table(context.folder, waves_file);
    std::array<std::array<std::vector<double>, 2>, 3> found; // by direction
    for (const double frequency : section.frequencies())
      {
        unsigned int number = 0;
        for (const Waveguide::Wave &wave :
             waves.waveguide().waves(Complex(0., 2 * pi * frequency)))
          {
            const double decay = -wave.wavenumber.imag() * decibels_of_e;
            if (decay > strongest_decay)
              break;
            const auto shares = waves.waveguide().shares(wave);
            table.set("frequency_Hz", frequency);
            table.set("wave", ++number);
            table.set("wavenumber_1/m", wave.wavenumber.real());
            table.set("decay_dB/m", decay);
            table.set("share_along", shares[0]);
            table.set("share_across", shares[1]);
            table.set("share_vertical", shares[2]);
            table.end_row();
            auto &[at, decays] =
              found[std::max_element(shares.begin(), shares.end()) -
                    shares.begin()];
            at.push_back(frequency);
            decays.push_back(decay);
          }
      }
    table.flush();
    if (!scene.inputs->output.plot)
      return;
    Figure figure("Waves in the rail", "frequency (Hz)", "decay (dB/m)");
    figure.set_scales(AxisScale::logarithmic, AxisScale::logarithmic);
    for (const unsigned int direction : {2, 1, 0})
      if (const auto &[at, decays] = found[direction]; !at.empty())
        figure.add_curve(std::string("mostly ") + ways_of_waves[direction],
                         at,
                         decays,
                         CurveStyle::points);
    figure.draw(context, "waves");
  }

  template void Receptance<2>::sweep_waves(const VibratingBody<2> &,
                                           ResultsTable &);
  template void Receptance<3>::sweep_waves(const VibratingBody<3> &,
                                           ResultsTable &);
} // namespace RollingContact
