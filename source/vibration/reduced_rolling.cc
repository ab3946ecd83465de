#include <rolling_contact/vibration/reduced_rolling.h>

namespace RollingContact
{
  template <int dim>
  ReducedRolling<dim>::ReducedRolling(std::shared_ptr<ModalBodies<dim>> modes,
                                      const RollingPair<dim>           &pair,
                                      const DenseMatrix                &W,
                                      const RollingConditions &conditions)
    : modal(std::move(modes))
    , bodies(*modal, pair, W)
    , pair(pair)
    , conditions(conditions)
    , motion(bodies.reduced(conditions))
  {
    motion.set_hub_inertia(bodies.hub_inertia());
  }

  template <int dim>
  void ReducedRolling<dim>::set_time_step(const double step)
  {
    h = step;
    motion.set_time_step(step);
  }

  template <int dim>
  bool ReducedRolling<dim>::compliance_depends_on_step() const
  {
    return true;
  }

  template <int dim>
  DenseMatrix ReducedRolling<dim>::compliance() const
  {
    return motion.compliance();
  }

  template <int dim>
  std::vector<std::vector<double>>
  ReducedRolling<dim>::response(const std::vector<std::vector<double>> &forces)
  {
    std::vector<std::vector<double>> result;
    for (const std::vector<double> &load : forces)
      result.push_back(motion.compliance() * load);
    return result;
  }

  template <int dim>
  double ReducedRolling<dim>::displacement_factor() const
  {
    return 1.;
  }

  template <int dim>
  bool ReducedRolling<dim>::laws_in_the_middle() const
  {
    return true;
  }

  template <int dim>
  FreeMotion ReducedRolling<dim>::begin_step(const double hub_acceleration,
                                             const bool   smooth)
  {
    motion.begin_step(smooth, hub_acceleration);
    const auto &u = motion.free_displacement(), &v = motion.free_velocity();
    const std::size_t n_tangential = u.size() - pair.trace().nodes.size();
    FreeMotion        free;
    free.displacement.assign(u.begin(), u.begin() + n_tangential);
    free.velocity.assign(v.begin(), v.begin() + n_tangential);
    free.gap.assign(u.begin() + n_tangential, u.end());
    free.velocity_factor = ReducedMotion::velocity_factor;
    return free;
  }

  template <int dim>
  StepEnergy ReducedRolling<dim>::end_step(const ContactProblem &problem,
                                           const ContactState   &state)
  {
    return motion.end_step(nodal_forces(problem, state));
  }

  template <int dim>
  void ReducedRolling<dim>::start_from(const ContactProblem &problem,
                                       const ContactState   &state)
  {
    const std::vector<double> forces = nodal_forces(problem, state);
    motion.rest_at(bodies.static_amplitudes(forces, conditions), forces);
  }

  template <int dim>
  double ReducedRolling<dim>::stored_energy() const
  {
    return motion.energy().kinetic + motion.energy().strain;
  }

  template <int dim>
  std::vector<double> ReducedRolling<dim>::contact_velocity() const
  {
    return motion.contact_velocity();
  }

  template <int dim>
  std::optional<double> ReducedRolling<dim>::wheel_velocity() const
  {
    const auto along_z = bodies.wheel_velocity(motion.state().rate);
    return along_z ? -*along_z : along_z; // towards the rail in its own frame
  }

  template <int dim>
  BodyDynamics::Memory ReducedRolling<dim>::memory_consumption() const
  {
    BodyDynamics::Memory memory;
    memory.matrices = motion.memory_consumption();
    return memory;
  }

  template <int dim>
  BodyField ReducedRolling<dim>::displacement(const Side            side,
                                              const ContactProblem &problem,
                                              const ContactState   &state) const
  {
    // static under the forces, and the modes' motion about that
    BodyField field = pair.displacement(side, problem, state);
    if (modal->body(side) == nullptr)
      return field;
    field += bodies.displacement(
      side,
      RollingContact::sum(motion.state().eta,
                          -1.,
                          bodies.static_amplitudes(nodal_forces(problem, state),
                                                   conditions)));
    return field;
  }

  template <int dim>
  void ReducedRolling<dim>::watch(const WatchedPoints<dim> &points)
  {
    watched = DenseMatrix::Zero(points.n_values(), motion.bodies().n_modes());
    for (const Side side : both_sides)
      {
        if (!points.has_any(side) || modal->n_modes(side) == 0)
          continue;
        const auto &body = *modal->body(side);
        DenseMatrix moved =
          DenseMatrix::Zero(points.n_values(side), modal->n_modes(side));
        for (Eigen::Index j = 0; j < moved.cols(); ++j)
          moved.col(j) = as_vector(points.values_of(
            side, body.body->field(column_of(body.mode_shapes(), j))));
        if (const AxleMotion *axle = modal->axle(side))
          axle->join(moved, DenseMatrix::Zero(moved.rows(), axle->size()));
        // absorbers move no point of the body; the rail's are behind the
        // wheel's
        watched.block(side == Side::wheel ? 0 : watched.rows() - moved.rows(),
                      bodies.first_column(side),
                      moved.rows(),
                      moved.cols()) = moved;
      }
  }

  template <int dim>
  std::vector<double> ReducedRolling<dim>::watched_displacement() const
  {
    return watched.size() == 0 ? std::vector<double>()
                               : watched * motion.state().eta;
  }

  template <int dim>
  void ReducedRolling<dim>::remember()
  {
    kept = motion.state();
  }

  template <int dim>
  void ReducedRolling<dim>::go_back()
  {
    motion.set_state(kept);
  }

  template <int dim>
  PairMotion ReducedRolling<dim>::save() const
  {
    return {{}, {}, motion.state()};
  }

  template <int dim>
  void ReducedRolling<dim>::restore(const PairMotion &saved,
                                    const ContactProblem &,
                                    const ContactState &)
  {
    motion.set_state(saved.modes);
  }

  template class ReducedRolling<2>;
  template class ReducedRolling<3>;
} // namespace RollingContact
