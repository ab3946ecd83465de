#include <rolling_contact/scene/scene_parameters.h>

namespace RollingContact
{
  std::vector<VelocityPoint>
  SceneParameters::velocity_points(const Side side) const
  {
    const BodyParameters &parameters = body(side);
    if (!analysis.records_run || !time.inertia || parameters.rigid)
      return {};
    return read_velocity_points(parameters.section,
                                parameters.velocity_points,
                                dimension);
  }

  bool SceneParameters::wants_spectra() const
  {
    return analysis.records_run &&
           spectrum.wanted(surfaces.in_use() || time.excite_mode > 0. ||
                           !velocity_points(Side::wheel).empty() ||
                           !velocity_points(Side::rail).empty());
  }

  std::string SceneParameters::why_no_eigenvalues() const
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
    if (contact.friction_memory_length > 0. || !surfaces.friction_share.empty())
      return "friction that moves with the material is not linearised";
    if (contact.slip_operator == SlipOperatorKind::galerkin)
      return "Contact/Slip operator = galerkin is not linearised";
    return "";
  }
} // namespace RollingContact
