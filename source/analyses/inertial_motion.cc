#include <deal.II/lac/vector.h>

#include <rolling_contact/analyses/both_bodies.h>
#include <rolling_contact/analyses/pair_motion.h>
#include <rolling_contact/base/exceptions.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    /**
     * A body in time, and what its hub's acceleration does to it: the inertia
     * of the rigid motion, -M e_z for the unit acceleration along z.
     */
    struct MovingBody
    {
      std::unique_ptr<ThetaStepper> stepper;
      std::vector<double>           inertia; ///< kg
    };



    template <int dim>
    class InertialMotion : public PairMotion<dim>
    {
    public:
      InertialMotion(const SceneParameters &scene, const RollingPair<dim> &pair)
        : pair(pair)
        , n_threads(pair.twins() ? 1 : scene.body_threads)
        , theta(scene.time.theta)
        , shifted(scene.time.contact_law == "shifted")
      {
        const auto make = [&](const Side side) {
          const ElasticBody<dim> &body = *pair.body(side);
          return std::make_shared<ThetaSystem>(
            ThetaScheme{theta,
                        scene.time.rayleigh_alpha,
                        scene.time.rayleigh_beta},
            body.stiffness(),
            body.mass(scene.time.mass == "lumped" ? MassKind::lumped
                                                  : MassKind::consistent),
            body.nodes_of_unknowns(),
            pair.unknowns(side));
        };
        std::shared_ptr<ThetaSystem> systems[2];
        for_both_bodies(
          n_threads,
          [&]() {
            if (pair.body(Side::wheel))
              systems[0] = make(Side::wheel);
          },
          [&]() {
            if (pair.body(Side::rail) && !pair.twins())
              systems[1] = make(Side::rail);
          });
        if (pair.twins())
          systems[1] = systems[0];
        for (unsigned int side = 0; side < 2; ++side)
          if (systems[side])
            bodies[side].stepper =
              std::make_unique<ThetaStepper>(systems[side]);
        prepare_wheel(scene);
      }

      void
      set_time_step(const double step) override
      {
        h = step;
        for_each([&](MovingBody &body) { body.stepper->set_time_step(h); });
      }

      bool
      compliance_depends_on_step() const override
      {
        return true;
      }

      DenseMatrix
      compliance() const override
      {
        const auto of = [&](const Side side) {
          const auto &stepper = bodies[static_cast<int>(side)].stepper;
          return stepper ? stepper->system().contact_compliance()
                         : DenseMatrix();
        };
        return pair.combined(of(Side::wheel), of(Side::rail));
      }

      double
      displacement_share() const override
      {
        return theta;
      }

      FreeMotion
      begin_step(const double hub_acceleration) override
      {
        if (hub_acceleration != last_acceleration)
          accelerate_hub(hub_acceleration);
        for_each([](MovingBody &body) { body.stepper->begin_step(); });
        const auto of = [&](const auto &quantity) {
          return relative([&](const ThetaStepper &s) { return quantity(s); });
        };
        const auto u0 =
          of([](const auto &s) { return s.contact_displacement(); });
        const auto v0 = of([](const auto &s) { return s.contact_velocity(); });
        const auto u1 =
          of([](const auto &s) { return s.free_contact_displacement(); });
        const auto v1 =
          of([](const auto &s) { return s.free_contact_velocity(); });
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

      StepEnergy
      end_step(const ContactProblem &problem,
               const ContactState   &state) override
      {
        const std::vector<double> reactions[2] = {
          pair.reactions(Side::wheel, problem, state),
          pair.reactions(Side::rail, problem, state)};
        for_each([&](MovingBody &body) {
          body.stepper->end_step(reactions[&body == &bodies[1]]);
        });
        StepEnergy sum;
        for (const MovingBody &body : bodies)
          if (body.stepper)
            {
              const StepEnergy &part = body.stepper->energy();
              sum.kinetic += part.kinetic;
              sum.strain += part.strain;
              sum.add_changes(part);
            }
        return sum;
      }

      void
      start_from(const ContactProblem &problem,
                 const ContactState   &state) override
      {
        for (const Side side : {Side::wheel, Side::rail})
          if (const auto *body = pair.body(side))
            {
              const auto    field   = pair.displacement(side, problem, state);
              ThetaStepper &stepper = *bodies[static_cast<int>(side)].stepper;
              std::vector<double> u(stepper.displacement().size());
              for (std::size_t dof = 0; dof < field.size(); ++dof)
                if (body->unknown(dof) >= 0)
                  u[body->unknown(dof)] = field[dof];
              stepper.set_state(u, std::vector<double>(u.size(), 0.));
            }
      }

      double
      stored_energy() const override
      {
        double sum = 0.;
        for (const MovingBody &body : bodies)
          if (body.stepper)
            sum +=
              body.stepper->energy().kinetic + body.stepper->energy().strain;
        return sum;
      }

      typename PairMotion<dim>::Memory
      memory_consumption() const override
      {
        typename PairMotion<dim>::Memory sum;
        for (unsigned int side = 0; side < (pair.twins() ? 1 : 2); ++side)
          if (bodies[side].stepper)
            {
              const ThetaSystem &system = bodies[side].stepper->system();
              sum.matrices += system.stiffness().memory_consumption() +
                              system.mass().memory_consumption();
              sum.factor += system.factorisation().size().memory_consumption();
              sum.columns += system.columns().memory_consumption();
            }
        return sum;
      }

      dealii::Vector<double>
      displacement(const Side side,
                   const ContactProblem &,
                   const ContactState &) const override
      {
        return pair.body(side)->field(
          bodies[static_cast<int>(side)].stepper->displacement());
      }

      void
      save(Checkpoint &checkpoint) const override
      {
        const auto motion = [](const MovingBody &body) {
          return body.stepper ? BodyMotion{body.stepper->displacement(),
                                           body.stepper->velocity()}
                              : BodyMotion();
        };
        checkpoint.wheel = motion(bodies[0]);
        checkpoint.rail  = motion(bodies[1]);
      }

      void
      restore(const Checkpoint &checkpoint,
              const ContactProblem &,
              const ContactState &) override
      {
        const BodyMotion *motions[2] = {&checkpoint.wheel, &checkpoint.rail};
        for (unsigned int side = 0; side < 2; ++side)
          if (bodies[side].stepper)
            bodies[side].stepper->set_state(motions[side]->displacement,
                                            motions[side]->velocity);
      }

    private:
      /**
       * Initial velocity of a free wheel and the inertia of its hub's motion.
       */
      void
      prepare_wheel(const SceneParameters &scene)
      {
        MovingBody &wheel = bodies[0];
        if (!wheel.stepper)
          return;
        const auto        &body    = *pair.body(Side::wheel);
        const ThetaSystem &system  = wheel.stepper->system();
        const auto         outward = body.uniform(dim - 1, 1.);
        wheel.inertia.resize(outward.size());
        system.mass().multiply(outward, wheel.inertia);
        for (double &mass : wheel.inertia)
          mass = -mass;
        std::vector<double> velocity = outward;
        for (double &value : velocity)
          value *= -scene.time.initial_velocity;
        wheel.stepper->set_state(std::vector<double>(outward.size(), 0.),
                                 velocity);
      }

      /**
       * The wheel's hub moves towards the rail: along z of its own frame.
       */
      void
      accelerate_hub(const double acceleration)
      {
        last_acceleration = acceleration;
        MovingBody &wheel = bodies[0];
        if (!wheel.stepper)
          return;
        std::vector<double> loads = wheel.inertia;
        for (double &load : loads)
          load *= acceleration;
        wheel.stepper->set_loads(loads);
      }

      template <typename Action>
      void
      for_each(const Action &action)
      {
        for_both_bodies(
          n_threads,
          [&]() {
            if (bodies[0].stepper)
              action(bodies[0]);
          },
          [&]() {
            if (bodies[1].stepper)
              action(bodies[1]);
          });
      }

      /**
       * Of the wheel over the rail: the difference of tangential components,
       * and what opens the gap.
       */
      template <typename Quantity>
      std::vector<double>
      relative(const Quantity &quantity) const
      {
        std::vector<double> result;
        const std::size_t   n = pair.trace().nodes.size();
        for (unsigned int side = 0; side < 2; ++side)
          if (bodies[side].stepper)
            {
              const std::vector<double> values =
                quantity(*bodies[side].stepper);
              result.resize(values.size(), 0.);
              for (std::size_t i = 0; i < values.size(); ++i)
                result[i] += (side == 1 || i + n >= values.size()) ? -values[i]
                                                                   : values[i];
            }
        return result;
      }

      const RollingPair<dim> &pair;
      const unsigned int      n_threads;
      const double            theta;
      const bool              shifted;
      MovingBody              bodies[2];
      double                  h                 = 0.;
      double                  last_acceleration = 0.;
    };
  } // namespace



  template <int dim>
  std::unique_ptr<PairMotion<dim>>
  make_inertial_motion(const SceneParameters  &scene,
                       const RollingPair<dim> &pair)
  {
    return std::make_unique<InertialMotion<dim>>(scene, pair);
  }



  template std::unique_ptr<PairMotion<2>>
  make_inertial_motion(const SceneParameters &, const RollingPair<2> &);
  template std::unique_ptr<PairMotion<3>>
  make_inertial_motion(const SceneParameters &, const RollingPair<3> &);
} // namespace RollingContact
