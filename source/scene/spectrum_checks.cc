#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/input/prm_declarations.h>
#include <rolling_contact/scene/run_signals.h>
#include <rolling_contact/scene/scene_parameters.h>

namespace RollingContact
{
  std::vector<VelocityPoint>
  SceneParameters::velocity_points(const Side side) const
  {
    const BodyParameters &parameters = body(side);
    if (analysis != "transient" || !time.inertia || parameters.rigid)
      return {};
    return read_velocity_points(parameters.section,
                                parameters.velocity_points,
                                dimension);
  }



  bool
  SceneParameters::wants_spectra() const
  {
    return analysis == "transient" &&
           spectrum.wanted(surfaces.in_use() || time.excite_mode > 0. ||
                           !velocity_points(Side::wheel).empty() ||
                           !velocity_points(Side::rail).empty());
  }



  std::string
  SceneParameters::why_no_eigenvalues() const
  {
    if (!has_reduced_bodies())
      return "Time/Bodies = reduced has eigenvalues";
    if (contact.friction_coefficient == 0.)
      return "there is no friction";
    if (contact.normal_load && !time.hold_approach)
      return "eigenvalues are those under a constant approach, and the load is "
             "given";
    if (contact.forces.any() || !time.longitudinal_force.empty() ||
        !time.lateral_force.empty() || !time.spin_moment.empty())
      return "eigenvalues are those under constant creepages, and forces are "
             "given";
    if (contact.friction_memory > 0. || !surfaces.friction_share.empty())
      return "friction that moves with the material is not linearised";
    if (contact.slip_operator == SlipOperatorKind::galerkin)
      return "Contact/Slip operator = galerkin is not linearised";
    return "";
  }



  void
  SceneParameters::check_spectra() const
  {
    if (analysis != "transient")
      return;
    const auto points = velocity_points(Side::wheel);
    for (const VelocityPoint &other : velocity_points(Side::rail))
      for (const VelocityPoint &point : points)
        if (point.name == other.name)
          throw InputError("Wheel/Velocity points and Rail/Velocity points "
                           "both have a point " +
                           point.name +
                           "; each has a column of its own, give "
                           "them different names.");
    if (body_solver == BodySolver::distributed &&
        !(points.empty() && velocity_points(Side::rail).empty()))
      throw InputError("Body solver = distributed: Velocity points of Wheel "
                       "and Rail need all nodes of a body on one rank; take "
                       "direct or automatic, or name no points.");
    const TimeSteps steps =
      time.steps(time.histories(contact, prm_folder).speed);
    if (spectrum.write == WriteSpectrum::always)
      if (const std::string why = spectrum.why_none(steps); !why.empty())
        throw InputError("Spectrum/Write = always, Skipped time = " +
                         text_of(spectrum.skipped_time) +
                         " s, Segment length = " +
                         text_of(spectrum.segment_length) + " s: " + why);
    if (!wants_spectra() || !spectrum.spectrogram)
      return;
    spectrogram_signal(*this);
    const std::size_t window =
      spectrum.rows_in_window(steps.length, steps.number);
    if (spectrum.spectrogram_window > 0. &&
        (window < SpectrumParameters::least_rows || window > steps.number))
      throw InputError("Spectrum/Spectrogram window = " +
                       text_of(spectrum.spectrogram_window) + " s: it has " +
                       std::to_string(window) + " steps of " +
                       significant(steps.length, 4) +
                       " s; give from 32 to the " +
                       std::to_string(steps.number) + " steps of the run.");
  }
} // namespace RollingContact
