#include <rolling_contact/analyses/modes.h>
#include <rolling_contact/analyses/receptance.h>
#include <rolling_contact/analyses/track_decay.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/input/rows_file.h>
#include <rolling_contact/modes/measuring_point.h>
#include <rolling_contact/modes/modal_damping.h>
#include <rolling_contact/run/figure.h>
#include <rolling_contact/scene/shared_rules.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    using Complex = std::complex<double>;

    const char receptances_file[] = "receptances.csv";

    /// of the half-width of a resonance: frequencies added around it
    const std::array<double, 7> around{{-10., -3., -1., 0., 1., 3., 10.}};

    /// damping ratio below which they are, and the least one they are made for
    const double sharp = 0.02, sharpest = 1e-5;

    const char axis_names[] = "xyz";

    /// over the largest receptance: what is not drawn
    const double nothing = 1e-6;

    /**
     * The wanted frequencies and those that sharp resonances need.
     */
    std::vector<double>
    frequencies_with_peaks(std::vector<double>        frequencies,
                           const StructuralModes     &modes,
                           const std::vector<double> &damping)
    {
      const double lowest = frequencies.front(), highest = frequencies.back();
      for (std::size_t j = 0; j < modes.size(); ++j)
        for (const double width : around)
          {
            const double f = modes.frequencies[j] *
                             (1 + width * std::max(damping[j], sharpest));
            if (damping[j] < sharp && f > lowest && f < highest)
              frequencies.push_back(f);
          }
      std::sort(frequencies.begin(), frequencies.end());
      frequencies.erase(std::unique(frequencies.begin(), frequencies.end()),
                        frequencies.end());
      return frequencies;
    }

    std::vector<double> column(const NamedRows   &table,
                               const std::string &name,
                               const std::string &entry)
    {
      const auto found =
        std::find(table.names.begin(), table.names.end(), name);
      if (found == table.names.end())
        throw InputError(entry + ": the file has no column " + name +
                         "; give the columns frequency_Hz and receptance_m/N.");
      std::vector<double> values;
      for (const auto &row : table.rows)
        values.push_back(row[found - table.names.begin()]);
      return values;
    }
  } // namespace

  template <int dim>
  void Receptance<dim>::read_measured(const Side side)
  {
    const std::string &file =
      side == Side::wheel ? section.measured_wheel : section.measured_rail;
    if (file.empty())
      return;
    const std::string entry =
      std::string("Receptance/Measured ") + name_of(side) + " = " + file;
    const NamedRows rows = read_rows(entry, scene.inputs->prm_folder / file);
    measured[side]       = Curve{"measured: " + file,
                           column(rows, "frequency_Hz", entry),
                           column(rows, "receptance_m/N", entry)};
  }

  template <int dim>
  void Receptance<dim>::run()
  {
    for (const Side side : both_sides)
      read_measured(side);
    ResultsTable table(context.folder, receptances_file);
    for (const Side side : both_sides)
      {
        if (scene.body(side).rigid)
          continue;
        throw_if_interrupted();
        const VibratingBody<dim> body(scene,
                                      side,
                                      scene.inputs->modes,
                                      scene.inputs->modes.cut_off_ratio *
                                        section.highest_frequency,
                                      context);
        if (body.waves)
          sweep_waves(body, table);
        else
          sweep(body, table);
      }
    table.flush();
  }

  template <int dim>
  std::vector<std::vector<double>>
  Receptance<dim>::loads(const VibratingBody<dim> &body,
                         std::vector<Station>     &stations) const
  {
    const double                     up = body.side == Side::wheel ? -1. : 1.;
    std::vector<std::vector<double>> forces;
    for (const auto &place : section.places(body.side))
      {
        const MeasuringPoint point(
          *body.body,
          {{place.point[0], place.point[1], up * place.point[2]}},
          section.load_radius);
        const std::string where = "Receptance: the place " + place.name +
                                  " of the " + name_of(body.side);
        if (point.distance() > 0.)
          context.log.warning(
            where + " is " + millimetres(point.distance()) +
            " away from the body, whose nearest point stands for it: correct "
            "the place, or raise Receptance/Load radius.");
        else
          context.log.detail(where + " is a mean of " +
                             std::to_string(point.n_nodes()) + " nodes.");
        for (const unsigned int axis : section.axes())
          {
            stations.push_back({place.name, axis, axis == 2 ? up : 1.});
            forces.push_back(point.load(axis, body.K.size()));
            for (double &force : forces.back())
              force *= stations.back().sign;
          }
      }
    return forces;
  }

  template <int dim>
  void Receptance<dim>::sweep(const VibratingBody<dim> &body,
                              ResultsTable             &table)
  {
    std::vector<Station> stations;
    auto                 forces = loads(body, stations);
    const auto           ratios = body.given_damping();
    const auto           rings  = body.parameters.absorbers();
    const AbsorberPlaces hanging =
      body.absorbers(section.highest_frequency, context);
    for (std::size_t k = 0; k < hanging.n_coordinates(); ++k)
      {
        const double *load = hanging.loads.data() + k * body.K.size();
        forces.emplace_back(load, load + body.K.size());
      }
    VibratingStructure structure{
      body.K, body.M, body.H, body.C, body.body->nodes_of_unknowns()};
    PhaseTimer::Scope       phase(context.timer, Phase::response);
    const FrequencyResponse response(
      structure, *body.factor, body.shift, body.modes, ratios, forces);
    const std::vector<double> frequencies =
      frequencies_with_peaks(section.frequencies(),
                             body.modes,
                             total_damping(body.modes, ratios, body.H, body.C));
    std::vector<ComplexMatrix> alpha;
    for (const double frequency : frequencies)
      {
        throw_if_interrupted();
        alpha.push_back(response.receptances(frequency));
        if (!rings.empty())
          alpha.back() = receptances_with(
            alpha.back(),
            absorber_stiffness(
              hanging, rings, 0., Complex(0., 2 * pi * frequency)),
            stations.size());
        add_rows(body.side, stations, frequency, alpha.back(), table);
      }
    note_peak(body,
              std::to_string(body.modes.size()) + " modes",
              stations,
              frequencies,
              alpha);
    check(body, structure, response, forces);
    if (scene.inputs->output.plot)
      plot(body.side, stations, frequencies, alpha);
    if constexpr (dim == 3)
      if (section.decay_rates && body.side == Side::rail)
        TrackDecay(body, section, context).write(scene.inputs->output.plot);
  }

  template <int dim>
  void Receptance<dim>::note_peak(const VibratingBody<dim>         &body,
                                  const std::string                &found_by,
                                  const std::vector<Station>       &stations,
                                  const std::vector<double>        &frequencies,
                                  const std::vector<ComplexMatrix> &alpha) const
  {
    std::size_t peak = 0;
    for (std::size_t k = 0; k < alpha.size(); ++k)
      if (std::abs(alpha[k](0, 0)) > std::abs(alpha[peak](0, 0)))
        peak = k;
    context.report.set_finding(
      name_of(body.side),
      found_by + "; " + stations[0].place + " " + axis_names[stations[0].axis] +
        ": " + significant(std::abs(alpha[peak](0, 0)), 4) + " m/N at " +
        significant(frequencies[peak], 5) + " Hz, the largest");
  }

  template <int dim>
  void Receptance<dim>::add_rows(const Side                  side,
                                 const std::vector<Station> &stations,
                                 const double                frequency,
                                 const ComplexMatrix        &alpha,
                                 ResultsTable               &table) const
  {
    const std::size_t n = stations.size();
    for (std::size_t q = 0; q < n; ++q)
      for (std::size_t p = 0; p < n; ++p)
        {
          const Complex value = alpha(p, q);
          table.set("body", name_of(side));
          table.set("frequency_Hz", frequency);
          table.set("force_at", stations[q].place);
          table.set("force_along",
                    std::string(1, axis_names[stations[q].axis]));
          table.set("motion_at", stations[p].place);
          table.set("motion_along",
                    std::string(1, axis_names[stations[p].axis]));
          table.set("receptance_m/N", std::abs(value));
          table.set("phase_rad", std::arg(value));
          table.set("real_m/N", value.real());
          table.set("imaginary_m/N", value.imag());
          table.end_row();
        }
  }

  template <int dim>
  void
  Receptance<dim>::check(const VibratingBody<dim>               &body,
                         const VibratingStructure               &structure,
                         const FrequencyResponse                &response,
                         const std::vector<std::vector<double>> &forces) const
  {
    double worst = 0., at = 0.;
    for (const double frequency : section.check_frequencies)
      {
        throw_if_interrupted();
        const auto direct = direct_receptances(structure, forces, frequency),
                   modal  = response.receptances(frequency, false);
        const double error =
          (direct - modal).cwiseAbs().maxCoeff() / direct.cwiseAbs().maxCoeff();
        context.log.detail("The " + name_of(body.side) + " solved whole at " +
                           significant(frequency, 5) + " Hz: modes differ by " +
                           significant(error, 2) +
                           " of the largest receptance.");
        if (error >= worst)
          {
            worst = error;
            at    = frequency;
          }
      }
    const bool known = !section.check_frequencies.empty();
    context.report.errors.push_back(
      {"receptance of the " + name_of(body.side),
       known ? worst : std::nan(""),
       "the largest at that frequency",
       known
         ? "the whole structure solved at " + significant(at, 5) + " Hz"
         : "modes up to " + significant(scene.inputs->modes.cut_off_ratio, 3) +
             " times the highest frequency and the compliance of the rest; "
             "Receptance/Check frequencies tells it",
       !known,
       ""});
  }

  template <int dim>
  void Receptance<dim>::plot(const Side                        side,
                             const std::vector<Station>       &stations,
                             const std::vector<double>        &frequencies,
                             const std::vector<ComplexMatrix> &alpha) const
  {
    const std::size_t n       = stations.size();
    double            largest = 0.;
    for (const auto &matrix : alpha)
      largest = std::max(largest, matrix.cwiseAbs().maxCoeff());
    Figure figure("Receptances of the " + name_of(side),
                  "frequency (Hz)",
                  "receptance (m/N)"),
      phases("", "frequency (Hz)", "phase (\u00b0)");
    figure.set_scales(AxisScale::logarithmic, AxisScale::logarithmic);
    phases.set_scales(AxisScale::logarithmic, AxisScale::linear);
    for (std::size_t q = 0; q < n; ++q)
      for (std::size_t p = q; p < n; ++p)
        {
          // forces at the contact point alone, to be read
          if (stations[q].place != "contact" ||
              (stations[p].place != "contact" &&
               stations[p].axis != stations[q].axis))
            continue;
          std::vector<double> size, angle;
          for (const auto &matrix : alpha)
            {
              size.push_back(std::abs(matrix(p, q)));
              angle.push_back(180 / pi * std::arg(matrix(p, q)));
            }
          // none, but for rounding, by symmetry
          if (*std::max_element(size.begin(), size.end()) < nothing * largest)
            continue;
          const std::string name =
            stations[p].place + " " + axis_names[stations[p].axis] + " / " +
            stations[q].place + " " + axis_names[stations[q].axis];
          figure.add_curve(name, frequencies, size);
          phases.add_curve("", frequencies, angle);
        }
    if (const auto &curve = measured[side])
      figure.add_curve(curve->label,
                       curve->frequencies,
                       curve->sizes,
                       CurveStyle::reference);
    figure.add_panel(phases);
    figure.draw(context, "receptances_" + name_of(side));
  }

  template class Receptance<2>;
  template class Receptance<3>;

  namespace
  {
    void check_directions(const SceneParameters &scene)
    {
      const auto &section = scene.own<ReceptanceParameters>();
      if (scene.dimension == 2)
        section.check_in_2d();
      if (section.decay_rates)
        TrackDecay::check(scene.rail, scene.dimension, section);
    }
  } // namespace

  AnalysisKind receptance_kind()
  {
    AnalysisKind kind = kind_of<Receptance>(
      "receptance",
      "how each body moves under harmonic forces, see section Receptance");
    kind.sections = {"Modes", "Receptance"};
    kind.own_section.emplace(ReceptanceParameters());
    kind.has_contact = false;
    kind.has_dampers = true;
    kind.on_ranks    = false;
    kind.rules       = {&check_directions, &check_lone_bodies};
    return kind;
  }
} // namespace RollingContact
