#include <rolling_contact/base/text.h>
#include <rolling_contact/pair/track_forces.h>
#include <rolling_contact/results/profile_columns.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    void set_patch(const std::string            &patch,
                   const ContactPatch           &found,
                   const Profiles::ContactFrame &frame,
                   ResultsTable                 &table)
    {
      const auto [across, upwards] =
        frame.in_track(found.in_plane.y, found.in_plane.z);
      table.set(patch + "_x_m", found.centre_x);
      table.set(patch + "_y_m", found.centre_y);
      table.set(patch + "_angle_rad",
                frame.angle() + frame.surface(found.centre_y).angle);
      table.set(patch + "_area_m2", found.area);
      table.set(patch + "_max_pressure_Pa", found.max_pressure);
      table.set(patch + "_normal_force_N", found.normal_force);
      table.set(patch + "_force_x_N", found.force_x);
      table.set(patch + "_force_y_N", found.force_y);
      table.set(patch + "_force_track_y_N", across);
      table.set(patch + "_force_track_z_N", upwards);
      table.set(patch + "_dissipation_J/m", found.dissipation);
    }

    /**
     * Note the heat of friction of all patches together and, where there are
     * several, of each.
     */
    template <int dim>
    void note_heat(const SteadyState<dim>          &steady,
                   const std::vector<ContactPatch> &patches,
                   RunReport                       &report)
    {
      if (steady.problem.n_tangential() == 0)
        return;
      std::string of_each;
      for (const ContactPatch &patch : patches)
        of_each +=
          (of_each.empty() ? ": " : " + ") + significant(patch.dissipation, 4);
      report.set_finding("heat",
                         "friction takes " +
                           significant(steady.result.dissipation, 4) +
                           " J per metre rolled (T gamma in N)" +
                           (patches.size() > 1 ? of_each : ""));
    }
  } // namespace

  template <int dim>
  void set_profile_columns(const PairSpec         &scene,
                           const SteadyState<dim> &steady,
                           ResultsTable           &table)
  {
    const Profiles::ContactFrame *frame = scene.frame.get();
    if (!frame)
      return;
    table.set("contact_angle_rad", frame->angle());
    table.set("contact_y_track_m", frame->track_y());
    table.set("contact_y_wheel_m", frame->origin().y_wheel);
    const TrackForces forces =
      track_forces(scene, steady.problem, steady.state);
    table.set("force_track_x_N", forces.force_x);
    table.set("force_track_y_N", forces.force_y);
    table.set("force_track_z_N", -forces.force_z);
    table.set("moment_track_x_Nm", forces.moment_x);
    table.set("moment_track_z_Nm", forces.moment_z);
    table.set("axle_torque_Nm", forces.axle_torque);
    table.set("pressure_y_track_m", forces.pressure_y);
    table.set("pressure_angle_rad", forces.pressure_angle);
    const std::vector<ContactPatch> patches = patches_of(steady);
    table.set("patches", patches.size());
    for (std::size_t k = 0; k < patches.size(); ++k)
      set_patch("patch_" + std::to_string(k + 1), patches[k], *frame, table);
  }

  template <int dim>
  void note_profiles(const PairSpec         &scene,
                     const SteadyState<dim> &steady,
                     RunReport              &report)
  {
    const Profiles::ContactFrame *frame = scene.frame.get();
    if (!frame || steady.result.n_touching == 0)
      return;
    const double degree = std::acos(-1.) / 180;
    report.set_finding("touch",
                       "first at " + millimetres(frame->track_y(), 6) +
                         " from the middle of the track, " +
                         millimetres(frame->origin().y_wheel, 4) +
                         " on the wheel's profile, at an angle of " +
                         significant(frame->angle() / degree, 3) + " degrees");
    const std::vector<ContactPatch> patches = patches_of(steady);
    std::string                     text    = std::to_string(patches.size()) +
                       (patches.size() == 1 ? " patch: " : " patches: ");
    for (std::size_t k = 0; k < patches.size(); ++k)
      text += (k == 0 ? "" : "; ") + significant(patches[k].normal_force, 6) +
              " N on " + significant(1e6 * patches[k].area, 3) +
              " mm2 at y = " + millimetres(patches[k].centre_y, 3);
    report.set_finding("patch", text);
    note_heat(steady, patches, report);
    const TrackForces forces =
      track_forces(scene, steady.problem, steady.state);
    report.set_finding("track",
                       "forces on the wheel, forwards " +
                         significant(forces.force_x, 6) + " N, to the right " +
                         significant(forces.force_y, 6) + " N, upwards " +
                         significant(-forces.force_z, 6) + " N");
  }

  template void
  set_profile_columns(const PairSpec &, const SteadyState<2> &, ResultsTable &);
  template void
  set_profile_columns(const PairSpec &, const SteadyState<3> &, ResultsTable &);
  template void
  note_profiles(const PairSpec &, const SteadyState<2> &, RunReport &);
  template void
  note_profiles(const PairSpec &, const SteadyState<3> &, RunReport &);
} // namespace RollingContact
