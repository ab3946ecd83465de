#include <rolling_contact/pair/pair_integrator.h>
#include <rolling_contact/pair/parallel_bodies.h>

namespace RollingContact
{
  namespace
  {
    template <int dim>
    class InertialRolling : public PairIntegrator<dim>
    {
    public:
      InertialRolling(const BodySpec         &wheel,
                      const TimeParameters   &time,
                      const RollingPair<dim> &pair)
        : pair(pair)
        , n_threads(pair.bodies().n_threads())
        , theta(time.theta)
        , shifted(time.contact_law == ContactLaw::shifted)
        , free_wheel(!wheel.rigid && is_loose(wheel.hub))
      {
        const ThetaScheme scheme{theta,
                                 time.rayleigh_alpha,
                                 time.rayleigh_beta};
        const MassKind    mass = time.mass;
        for_both_bodies(
          n_threads,
          [&]() { bodies.wheel = pair.in_time(Side::wheel, scheme, mass); },
          [&]() {
            if (!pair.bodies().twins())
              bodies.rail = pair.in_time(Side::rail, scheme, mass);
          });
        if (pair.bodies().twins())
          bodies.rail = bodies.wheel->make_twin();
        // the initial velocity of a free wheel
        if (bodies.wheel)
          bodies.wheel->set_flight_velocity(-time.initial_velocity);
      }

      void set_time_step(const double step) override
      {
        h = step;
        for_each([&](BodyDynamics &body, Side) { body.set_time_step(h); });
      }

      bool compliance_depends_on_step() const override
      {
        return true;
      }

      DenseMatrix compliance() const override
      {
        PerSide<DenseMatrix> W;
        for (const Side side : both_sides)
          if (bodies[side] && pair.bodies().has_own_body(side))
            W[side] = bodies[side]->contact_compliance();
        return pair.pair_compliance(std::move(W));
      }

      double displacement_factor() const override
      {
        return theta;
      }

      FreeMotion begin_step(const double hub_acceleration, const bool) override
      {
        if (bodies.wheel) // towards the rail: along z of its own frame
          bodies.wheel->accelerate_hub(hub_acceleration);
        if (bodies.wheel && pair.bodies().twins())
          bodies.wheel->begin_twin_steps();
        else
          for_each([](BodyDynamics &body, Side) { body.begin_step(); });
        start = relative(
          [](const auto &body) { return body.contact_displacement(); });
        const auto &u0 = start;
        const auto  v0 =
          relative([](const auto &body) { return body.contact_velocity(); });
        const auto u1 = relative(
          [](const auto &body) { return body.free_contact_displacement(); });
        const auto v1 = relative(
          [](const auto &body) { return body.free_contact_velocity(); });
        const std::size_t n       = pair.trace().nodes.size(),
                          n_first = u0.size() - n;
        FreeMotion motion;
        motion.displacement.assign(u1.begin(), u1.begin() + n_first);
        motion.velocity.assign(v1.begin(), v1.begin() + n_first);
        for (std::size_t i = n_first; i < u0.size(); ++i)
          motion.gap.push_back(u0[i] + h * v1[i] +
                               (shifted ? h * (1 - theta) * v0[i] : 0.));
        return motion;
      }

      std::vector<std::vector<double>>
      response(const std::vector<std::vector<double>> &forces) override
      {
        std::vector<std::vector<double>> result;
        for (const std::vector<double> &load : forces)
          {
            PerSide<std::vector<double>> motion;
            for_each([&](BodyDynamics &body, const Side side) {
              motion[side] = body.response(pair.forces_on_body(side, load));
            });
            result.push_back(pair.relative_motion(std::move(motion)));
          }
        return result;
      }

      StepEnergy end_step(const ContactProblem &problem,
                          const ContactState   &state) override
      {
        const auto forces = [&](const Side side) {
          return pair.forces_on_body(side, nodal_forces(problem, state));
        };
        if (bodies.wheel && pair.bodies().twins())
          bodies.wheel->end_twin_steps(forces(Side::wheel), forces(Side::rail));
        else
          for_each([&](BodyDynamics &body, const Side side) {
            body.end_step(forces(side));
          });
        return energy();
      }

      std::vector<double> contact_velocity() const override
      {
        std::vector<double> velocity = relative(
          [](const auto &body) { return body.contact_displacement(); });
        if (start.empty())
          return std::vector<double>(velocity.size(), 0.);
        for (std::size_t i = 0; i < velocity.size(); ++i)
          velocity[i] = (velocity[i] - start[i]) / h;
        return velocity;
      }

      void start_from(const ContactProblem &problem,
                      const ContactState   &state) override
      {
        for (const Side side : both_sides)
          if (bodies[side])
            bodies[side]->set_static_state(
              pair.displacement(side, problem, state));
      }

      double stored_energy() const override
      {
        const StepEnergy sum = energy();
        return sum.kinetic + sum.strain;
      }

      std::optional<double> wheel_velocity() const override
      {
        if (!free_wheel)
          return {};
        return pair.bodies().on_all_ranks(
          Side::wheel, bodies.wheel ? -bodies.wheel->mean_velocity() : 0.);
      }

      BodyDynamics::Memory memory_consumption() const override
      {
        BodyDynamics::Memory sum;
        for (const Side side : both_sides)
          if (bodies[side] && pair.bodies().has_own_body(side))
            {
              const BodyDynamics::Memory part =
                bodies[side]->memory_consumption();
              sum.matrices += part.matrices;
              sum.solver += part.solver;
              sum.columns += part.columns;
            }
        return sum;
      }

      std::string description() const override
      {
        std::string text;
        for (const Side side : both_sides)
          {
            const auto &body = bodies[side];
            if (body && !body->description().empty())
              text += (text.empty() ? "" : "; ") + name_of(side) + ": " +
                      body->description();
          }
        return text;
      }

      BodyField displacement(const Side side,
                             const ContactProblem &,
                             const ContactState &) const override
      {
        const auto &body = bodies[side];
        return body ? body->displacement() : BodyField();
      }

      void watch(const WatchedPoints<dim> &points) override
      {
        watched = points;
      }

      std::vector<double> watched_displacement() const override
      {
        return watched.values(pair.bodies(), [&](const Side side) {
          return bodies[side] ? bodies[side]->displacement() : BodyField();
        });
      }

      void remember() override
      {
        for_each([](BodyDynamics &body, Side) { body.remember(); });
      }

      void go_back() override
      {
        for_each([](BodyDynamics &body, Side) { body.go_back(); });
      }

      PairMotion save() const override
      {
        PairMotion motion;
        for (const Side side : both_sides)
          motion.bodies[side] = pair.bodies().on_all_ranks(
            side, bodies[side] ? bodies[side]->save() : BodyMotion());
        return motion;
      }

      void restore(const PairMotion &motion,
                   const ContactProblem &,
                   const ContactState &) override
      {
        for_each([&](BodyDynamics &body, const Side side) {
          body.restore(motion.bodies[side]);
        });
      }

    private:
      /**
       * Energies of both bodies, on all ranks. Collective.
       */
      StepEnergy energy() const
      {
        StepEnergy sum;
        for (const Side side : both_sides)
          {
            const auto      &body = bodies[side];
            const StepEnergy part =
              pair.bodies().on_all_ranks(side,
                                         body ? body->energy() : StepEnergy());
            sum.kinetic += part.kinetic;
            sum.strain += part.strain;
            sum.add_changes(part);
          }
        return sum;
      }

      template <typename Action>
      void for_each(const Action &action)
      {
        for_both_bodies(
          n_threads,
          [&]() {
            if (bodies.wheel)
              action(*bodies.wheel, Side::wheel);
          },
          [&]() {
            if (bodies.rail)
              action(*bodies.rail, Side::rail);
          });
      }

      template <typename Quantity>
      std::vector<double> relative(const Quantity &quantity) const
      {
        PerSide<std::vector<double>> motion;
        for (const Side side : both_sides)
          if (bodies[side])
            motion[side] = quantity(*bodies[side]);
        return pair.relative_motion(std::move(motion));
      }

      const RollingPair<dim>                &pair;
      const unsigned int                     n_threads;
      const double                           theta;
      const bool                             shifted, free_wheel;
      PerSide<std::unique_ptr<BodyDynamics>> bodies;
      double                                 h = 0.;
      std::vector<double>                    start; ///< u0 of the step, m
      WatchedPoints<dim>                     watched;
    };
  } // namespace

  template <int dim>
  std::unique_ptr<PairIntegrator<dim>>
  make_inertial_rolling(const BodySpec         &wheel,
                        const TimeParameters   &time,
                        const RollingPair<dim> &pair)
  {
    return std::make_unique<InertialRolling<dim>>(wheel, time, pair);
  }

  template std::unique_ptr<PairIntegrator<2>>
  make_inertial_rolling(const BodySpec &,
                        const TimeParameters &,
                        const RollingPair<2> &);
  template std::unique_ptr<PairIntegrator<3>>
  make_inertial_rolling(const BodySpec &,
                        const TimeParameters &,
                        const RollingPair<3> &);
} // namespace RollingContact
