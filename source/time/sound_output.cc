#include <deal.II/lac/vector.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/time/radiating_surface.h>
#include <rolling_contact/time/run_spectra.h>
#include <rolling_contact/time/sound_output.h>
#include <rolling_contact/time/sound_pressure.h>

namespace RollingContact
{
  namespace
  {
    const std::string time_column = "time_s";

    std::string column_of(const Side side, const std::size_t mode)
    {
      return name_of(side) + "_" + std::to_string(mode + 1) + "_m*sqrt(kg)/s";
    }

    /** In 2D, where no sound is estimated, there is none. */
    SoundingBody sounding_body(const Situation &, const VibratingBody<2> &)
    {
      return {};
    }

    SoundingBody sounding_body(const Situation        &scene,
                               const VibratingBody<3> &body)
    {
      SoundingBody sounding;
      sounding.side       = body.side;
      sounding.characters = body.characters;
      sounding.radiating  = Sound::radiating_body(body,
                                                 audible_range(scene).highest,
                                                 air_of(scene.inputs->sound));
      return sounding;
    }
  } // namespace

  template <int dim>
  SoundOutput<dim>::SoundOutput(const Situation           &scene,
                                const ContactStepper<dim> &stepper,
                                const Checkpoint          &checkpoint,
                                RunContext                &context)
    : scene(scene)
    , context(context)
  {
    PhaseTimer::Scope        phase(context.timer, Phase::modes);
    std::vector<std::string> names{time_column};
    const ModalBodies<dim>  &modes = *stepper.modes();
    for (const Side side : both_sides)
      {
        if (modes.n_modes(side) == 0)
          continue;
        SoundingBody body = sounding_body(scene, *modes.body(side));
        if (body.radiating.frequencies.empty())
          continue;
        bodies.push_back(std::move(body));
        const std::size_t first =
          side == Side::wheel ? 0 : modes.n_coordinates(Side::wheel);
        for (std::size_t j = 0; j < bodies.back().radiating.frequencies.size();
             ++j)
          {
            kept.push_back(first + j);
            names.push_back(column_of(side, j));
          }
      }
    if (bodies.empty())
      throw InputError("Modes/Maximum frequency = " +
                       significant(scene.inputs->modes.maximum_frequency, 6) +
                       " Hz: no body has a mode below it, and the sound is "
                       "estimated from modes; give a higher frequency.");
    if (context.resume)
      table.emplace(context.folder,
                    modal_velocities_name,
                    names,
                    checkpoint.modal_velocities);
    else
      table.emplace(context.folder, modal_velocities_name, names);
  }

  template <int dim>
  void SoundOutput<dim>::add_row(const ContactStepper<dim> &stepper,
                                 const double               time)
  {
    const std::vector<double> &velocities =
      stepper.bodies().reduced_state()->rate;
    std::vector<double> row{time};
    for (const std::size_t mode : kept)
      row.push_back(velocities[mode]);
    table->add_row(row);
  }

  template <int dim>
  void SoundOutput<dim>::finish(const double period)
  {
    PhaseTimer::Scope phase(context.timer, Phase::fields);
    table->publish();
    const double      step    = step_of_history(scene);
    const std::size_t n_rows  = table->size(),
                      skipped = scene.inputs->sound.skipped_rows(step);
    if (n_rows < skipped + SoundParameters::least_rows)
      return; // a run that was cut short
    const std::size_t n =
      Sound::steps_of_whole_samples(n_rows - skipped,
                                    step,
                                    scene.inputs->sound.sampling_rate);
    for (SoundingBody &body : bodies)
      {
        std::vector<std::string> columns;
        for (std::size_t j = 0; j < body.radiating.frequencies.size(); ++j)
          columns.push_back(column_of(body.side, j));
        HistoryColumns                   record = table->columns(columns);
        std::vector<std::vector<double>> velocities;
        for (const std::string &column : columns)
          {
            std::vector<double> &all = record.at(column);
            velocities.emplace_back(all.end() - n, all.end());
            all = {};
          }
        body.sound = Sound::body_sound(body.radiating,
                                       velocities,
                                       step,
                                       air_of(scene.inputs->sound),
                                       audible_range(scene));
      }
    report_sound(scene, bodies, n * step, period, context);
  }

  template class SoundOutput<2>;
  template class SoundOutput<3>;
} // namespace RollingContact
