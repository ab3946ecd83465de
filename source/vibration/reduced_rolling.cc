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
  void
  ReducedRolling<dim>::set_time_step(const double step)
  {
    h = step;
    motion.set_time_step(step);
  }



  template <int dim>
  bool
  ReducedRolling<dim>::compliance_depends_on_step() const
  {
    return true;
  }



  template <int dim>
  DenseMatrix
  ReducedRolling<dim>::compliance() const
  {
    return motion.compliance();
  }



  template <int dim>
  std::vector<std::vector<double>>
  ReducedRolling<dim>::response(const std::vector<std::vector<double>> &forces)
  {
    const DenseMatrix               &W = motion.compliance();
    std::vector<std::vector<double>> result;
    for (const std::vector<double> &load : forces)
      {
        result.emplace_back(W.n_rows());
        W.multiply_block(0, 0, load, result.back());
      }
    return result;
  }



  template <int dim>
  double
  ReducedRolling<dim>::displacement_factor() const
  {
    return 1.;
  }



  template <int dim>
  bool
  ReducedRolling<dim>::laws_in_the_middle() const
  {
    return true;
  }



  template <int dim>
  FreeMotion
  ReducedRolling<dim>::begin_step(const double hub_acceleration,
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
  StepEnergy
  ReducedRolling<dim>::end_step(const ContactProblem &problem,
                                const ContactState   &state)
  {
    return motion.end_step(nodal_forces(problem, state));
  }



  template <int dim>
  void
  ReducedRolling<dim>::start_from(const ContactProblem &problem,
                                  const ContactState   &state)
  {
    const std::vector<double> forces = nodal_forces(problem, state);
    motion.rest_at(bodies.static_amplitudes(forces, conditions), forces);
    rest = motion.state();
  }



  template <int dim>
  void
  ReducedRolling<dim>::excite(const Excitation &vibration, const double step)
  {
    ReducedState state = motion.state();
    vibration.add_to(state, step);
    motion.set_state(std::move(state));
  }



  namespace
  {
    /** x + a y of the parts of states that may be added. */
    ReducedState
    sum(ReducedState x, const double a, const ReducedState &y)
    {
      const auto add = [&](std::vector<double>       &to,
                           const std::vector<double> &from) {
        for (std::size_t i = 0; i < to.size(); ++i)
          to[i] += a * from[i];
      };
      add(x.eta, y.eta);
      add(x.rate, y.rate);
      add(x.forces, y.forces);
      add(x.forces_before, y.forces_before);
      return x;
    }
  } // namespace



  template <int dim>
  ReducedState
  ReducedRolling<dim>::disturbance() const
  {
    return sum(motion.state(), -1., rest);
  }



  template <int dim>
  void
  ReducedRolling<dim>::disturb(const ReducedState &differences)
  {
    motion.set_state(sum(motion.state(), 1., differences));
  }



  template <int dim>
  double
  ReducedRolling<dim>::stored_energy() const
  {
    return motion.energy().kinetic + motion.energy().strain;
  }



  template <int dim>
  std::vector<double>
  ReducedRolling<dim>::contact_velocity() const
  {
    return motion.contact_velocity();
  }



  template <int dim>
  BodyDynamics::Memory
  ReducedRolling<dim>::memory_consumption() const
  {
    BodyDynamics::Memory memory;
    memory.matrices = motion.memory_consumption();
    return memory;
  }



  template <int dim>
  BodyField
  ReducedRolling<dim>::displacement(const Side            side,
                                    const ContactProblem &problem,
                                    const ContactState   &state) const
  {
    // static under the forces, and the modes' motion about that
    BodyField field = pair.displacement(side, problem, state);
    if (modal->body(side) == nullptr)
      return field;
    std::vector<double> eta = motion.state().eta;
    const auto          at_rest =
      bodies.static_amplitudes(nodal_forces(problem, state), conditions);
    for (std::size_t k = 0; k < eta.size(); ++k)
      eta[k] -= at_rest[k];
    field += bodies.displacement(side, eta);
    return field;
  }



  template <int dim>
  void
  ReducedRolling<dim>::watch(const WatchedPoints<dim> &points)
  {
    const std::size_t n = motion.bodies().n_modes();
    watched             = DenseMatrix(points.n_values(), n);
    for (std::size_t j = 0; j < n; ++j)
      {
        const auto [side, mode] = bodies.coordinate_of(j);
        if (!points.has_any(side) || mode >= modal->n_modes(side))
          continue; // absorbers move no point of the body
        const auto        &body   = *modal->body(side);
        const DenseMatrix &shapes = body.modes.shapes;
        const double      *first  = shapes.data() + mode * shapes.n_rows();
        const std::vector<double> moved =
          points.values_of(side,
                           body.body->field({first, first + shapes.n_rows()}));
        // those of the rail are behind those of the wheel
        const std::size_t place =
          side == Side::wheel ? 0 : watched.n_rows() - moved.size();
        for (std::size_t i = 0; i < moved.size(); ++i)
          watched(place + i, j) = moved[i];
      }
  }



  template <int dim>
  std::vector<double>
  ReducedRolling<dim>::watched_displacement() const
  {
    std::vector<double> values(watched.n_rows());
    if (!values.empty())
      watched.multiply_block(0, 0, motion.state().eta, values);
    return values;
  }



  template <int dim>
  void
  ReducedRolling<dim>::remember()
  {
    kept = motion.state();
  }



  template <int dim>
  void
  ReducedRolling<dim>::go_back()
  {
    motion.set_state(kept);
  }



  template <int dim>
  PerSide<BodyMotion>
  ReducedRolling<dim>::save() const
  {
    PerSide<BodyMotion> saved; // the modes of both, with the wheel
    saved.wheel = {motion.state().eta, motion.state().rate};
    return saved;
  }



  template <int dim>
  void
  ReducedRolling<dim>::restore(const PerSide<BodyMotion> &saved,
                               const ContactProblem &,
                               const ContactState &)
  {
    require_size(saved.wheel, motion.bodies().n_modes());
    ReducedState state = motion.state();
    state.eta          = saved.wheel.displacement;
    state.rate         = saved.wheel.velocity;
    motion.set_state(std::move(state));
  }



  template <int dim>
  PastStep
  ReducedRolling<dim>::past() const
  {
    const ReducedState &state = motion.state();
    PastStep            past;
    past.length        = state.last_step;
    past.forces        = state.forces;
    past.forces_before = state.forces_before;
    past.load          = state.load;
    past.distance      = state.distance;
    return past;
  }



  template <int dim>
  void
  ReducedRolling<dim>::set_past(const PastStep &past)
  {
    ReducedState state  = motion.state();
    state.last_step     = past.length;
    state.forces        = past.forces;
    state.forces_before = past.forces_before;
    state.load          = past.load;
    state.distance      = past.distance;
    motion.set_state(std::move(state));
  }



  template class ReducedRolling<2>;
  template class ReducedRolling<3>;
} // namespace RollingContact
