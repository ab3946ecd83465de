#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/scene/run_signals.h>
#include <rolling_contact/scene/scene_parameters.h>

namespace RollingContact
{
  namespace
  {
    /** The axes along which something moves. */
    std::string axes_of(const SceneParameters &scene)
    {
      return scene.dimension == 3 ? "xyz" : "xz";
    }
  } // namespace

  std::vector<RunSignal> run_signals(const SceneParameters &scene)
  {
    const bool             slips = scene.contact.friction_coefficient > 0.;
    std::vector<RunSignal> signals{
      {"normal_force_N", "normal_force", "load N", SignalKind::force}};
    if (slips)
      signals.push_back(
        {"force_x_N", "force_x", "longitudinal T", SignalKind::force});
    if (slips && scene.dimension == 3)
      signals.push_back(
        {"force_y_N", "force_y", "lateral T", SignalKind::force});
    if (scene.surfaces.in_use())
      signals.push_back({"surface_height_m",
                         "surface_height",
                         "height of the surfaces",
                         SignalKind::height});
    if (!scene.time.inertia)
      return signals;
    for (const char axis : slips ? axes_of(scene) : "z")
      {
        const std::string name = std::string("velocity_") + axis;
        signals.push_back({name + "_m/s",
                           name,
                           std::string("contact ") + axis,
                           SignalKind::velocity});
      }
    for (const Side side : both_sides)
      for (const VelocityPoint &point : scene.velocity_points(side))
        for (const char axis : axes_of(scene))
          {
            const std::string column = velocity_column(point.name, axis);
            signals.push_back({column,
                               column.substr(0, column.rfind('_')),
                               point.name + ' ' + axis,
                               SignalKind::velocity});
          }
    return signals;
  }

  RunSignal spectrogram_signal(const SceneParameters &scene)
  {
    const std::string &wanted = scene.spectrum.spectrogram_signal;
    const std::string  column = !wanted.empty()       ? wanted
                                : !scene.time.inertia ? "normal_force_N"
                                : scene.contact.friction_coefficient == 0.
                                  ? "velocity_z_m/s"
                                : scene.dimension == 3 ? "velocity_y_m/s"
                                                       : "velocity_x_m/s";
    std::string        columns;
    for (const RunSignal &signal : run_signals(scene))
      {
        if (signal.column == column)
          return signal;
        columns += (columns.empty() ? "" : ", ") + signal.column;
      }
    throw InputError("Spectrum/Spectrogram signal = " + wanted +
                     ": spectra are made of columns of history.csv; this "
                     "scene has " +
                     columns +
                     ". Named points have columns where Wheel or "
                     "Rail/Velocity points gives them.");
  }
} // namespace RollingContact
