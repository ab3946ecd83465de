#include <rolling_contact/analyses/modes.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/modes/measuring_point.h>
#include <rolling_contact/modes/modal_damping.h>
#include <rolling_contact/results/mode_animation.h>
#include <rolling_contact/results/mode_sections.h>
#include <rolling_contact/run/figure.h>
#include <rolling_contact/scene/shared_rules.h>

#include <map>

namespace RollingContact
{
  namespace
  {
    const char modes_file[] = "modes.csv";

    const std::map<char, std::string> families{{'L', "axial"},
                                               {'R', "radial"},
                                               {'C', "circumferential"}};

    /**
     * Eigenfrequencies over the nodal diameters, by the direction in which most
     * of the energy is.
     */
    void plot_diameters(const std::string                &section,
                        const StructuralModes            &modes,
                        const std::vector<ModeCharacter> &characters,
                        RunContext                       &context)
    {
      std::map<std::string, std::array<std::vector<double>, 2>> found;
      for (std::size_t j = 0; j < modes.size(); ++j)
        if (characters[j].nodal_diameters)
          {
            auto &[n, f] = found[families.at(characters[j].family())];
            n.push_back(*characters[j].nodal_diameters);
            f.push_back(modes.frequencies[j] / 1000);
          }
      if (found.empty())
        return;
      Figure figure("Modes of the " + section,
                    "nodal diameters",
                    "frequency (kHz)");
      for (const auto &[name, points] : found)
        figure.add_curve("mostly " + name,
                         points[0],
                         points[1],
                         CurveStyle::points);
      figure.draw(context, "modes_" + section);
    }
  } // namespace

  namespace
  {
    /** The first shapes, of pairs one, in the section at the contact. */
    void plot_shapes(const VibratingBody<3> &body, RunContext &context)
    {
      const unsigned int     most = 8;
      std::vector<ShownMode> shown;
      const DenseMatrix     &shapes = body.modes.shapes;
      for (std::size_t j = 0; j < body.modes.size() && shown.size() < most; ++j)
        {
          const ModeCharacter &character = body.characters[j];
          if (character.partner && *character.partner < j)
            continue;
          shown.push_back(
            {significant(body.modes.frequencies[j], 4) + " Hz" +
               (character.nodal_diameters ? ", " + character.name() : ""),
             body.body->field(column_of(shapes, j))});
        }
      plot_mode_sections(*body.body,
                         shown,
                         body.side == Side::wheel,
                         "Modes of the " + name_of(body.side) +
                           " in the section at the contact",
                         context,
                         "mode_shapes_" + name_of(body.side));
    }
  } // namespace

  template <int dim>
  void Modes<dim>::run()
  {
    ResultsTable table(context.folder, modes_file);
    for (const Side side : both_sides)
      {
        if (scene.body(side).rigid)
          continue;
        throw_if_interrupted();
        const VibratingBody<dim> body(scene,
                                      side,
                                      scene.inputs->modes,
                                      scene.inputs->modes.maximum_frequency,
                                      context);
        add_rows(body, table);
        summarise(body);
        PhaseTimer::Scope phase(context.timer, Phase::fields);
        if (scene.inputs->output.plot)
          {
            plot_diameters(name_of(side), body.modes, body.characters, context);
            if constexpr (dim == 3)
              plot_shapes(body, context);
          }
        animate(body);
      }
    table.flush();
    context.log.message(table.screen_table({"body",
                                            "mode",
                                            "frequency_Hz",
                                            "name",
                                            "axial_share",
                                            "radial_share",
                                            "damping_ratio"}));
    if (table.n_rows() == 0)
      throw InputError("Modes/Maximum frequency = " +
                       significant(scene.inputs->modes.maximum_frequency, 6) +
                       " Hz: no body has a mode below; raise it.");
  }

  template <int dim>
  void Modes<dim>::add_rows(const VibratingBody<dim> &body,
                            ResultsTable             &table) const
  {
    const StructuralModes &modes = body.modes;
    const auto             damping =
      total_damping(modes, body.given_damping(), body.H, body.C);
    const MeasuringPoint contact(*body.body, {{0., 0., 0.}}, 0.);
    const double         up = body.side == Side::wheel ? -1. : 1.;
    for (std::size_t j = 0; j < modes.size(); ++j)
      {
        const ModeCharacter &character = body.characters[j];
        table.set("body", name_of(body.side));
        table.set("mode", j + 1);
        table.set("frequency_Hz", modes.frequencies[j]);
        table.set("nodal_diameters", character.nodal_diameters);
        table.set_if(character.nodal_diameters.has_value(),
                     "diameter_share",
                     character.diameter_share);
        table.set("name", character.name());
        table.set("axial_share", character.axial_share);
        table.set("radial_share", character.radial_share);
        table.set("circumferential_share", character.circumferential_share);
        table.set("damping_ratio", damping[j]);
        const bool paired = character.partner.has_value();
        table.set_if(paired, "pair_mode", character.partner.value_or(0) + 1);
        table.set_if(paired, "pair_split", character.split);
        const double *shape = modes.shapes.col(j).data();
        table.set("contact_x_1/sqrt(kg)", contact.motion(0, shape));
        table.set("contact_y_1/sqrt(kg)", contact.motion(1, shape));
        table.set("contact_z_1/sqrt(kg)", up * contact.motion(2, shape));
        table.set("residual", modes.residuals[j]);
        table.end_row();
      }
  }

  template <int dim>
  void Modes<dim>::animate(const VibratingBody<dim> &body) const
  {
    const std::size_t n =
      std::min<std::size_t>(scene.inputs->modes.animated, body.modes.size());
    for (std::size_t j = 0; j < n; ++j)
      {
        write_mode_animation<dim>(
          {{body.body,
            body.body->field(column_of(body.modes.shapes, j)),
            {},
            body.side == Side::wheel,
            ""}},
          context.folder,
          name_of(body.side) + "_mode_" + zero_padded(j + 1, 3));
      }
  }

  template <int dim>
  void Modes<dim>::summarise(const VibratingBody<dim> &body) const
  {
    const StructuralModes &modes = body.modes;
    double                 worst = 0.;
    for (const double residual : modes.residuals)
      worst = std::max(worst, residual);
    context.report.set_finding(
      name_of(body.side),
      std::to_string(modes.size()) + " modes up to " +
        significant(modes.cut_off, 5) + " Hz" +
        (modes.size() > 0
           ? ", the first at " + significant(modes.frequencies[0], 5) + " Hz"
           : "") +
        (modes.counted ? ", none missed" : ""));
    context.report.errors.push_back(
      {"eigenvalue of the " + name_of(body.side),
       worst,
       "omega^2",
       "its residual; the mesh's own error is not in it",
       true,
       ""});
  }

  template class Modes<2>;
  template class Modes<3>;

  AnalysisKind modes_kind()
  {
    AnalysisKind kind = kind_of<Modes>(
      "modes",
      "eigenfrequencies and mode shapes of each body, see section Modes");
    kind.sections    = {"Modes"};
    kind.has_contact = false;
    kind.on_ranks    = false;
    kind.rules       = {&check_lone_bodies, &check_bodies_with_modes};
    return kind;
  }
} // namespace RollingContact
