#include <rolling_contact/pair/pair_integrator.h>

namespace RollingContact
{
  namespace
  {
    /**
     * r . W r' with the nodal forces r of a state and r' of @p other. Units: J.
     */
    double work(const ContactProblem &problem,
                const ContactState   &state,
                const ContactState   &other)
    {
      const std::vector<double> normal =
        problem.operators.normal_displacement(other.pressure);
      const std::vector<double> coupling =
        problem.operators.normal_displacement_of_traction(other.traction);
      const std::vector<double> forces =
        problem.operators.H().multiply(state.pressure);
      double sum = 0.;
      for (std::size_t i = 0; i < normal.size(); ++i)
        sum += forces[i] * (normal[i] + coupling[i]);
      if (problem.n_tangential() > 0)
        sum += dot(problem.operators.H() * state.traction,
                   problem.operators.tangential_displacement(other.traction,
                                                             other.pressure));
      return sum;
    }

    template <int dim>
    class QuasiStaticRolling : public PairIntegrator<dim>
    {
    public:
      explicit QuasiStaticRolling(const RollingPair<dim> &pair)
        : pair(pair)
      {}

      void set_time_step(const double step) override
      {
        h = step;
      }

      bool compliance_depends_on_step() const override
      {
        return false;
      }

      DenseMatrix compliance() const override
      {
        return {};
      }

      double displacement_factor() const override
      {
        return 1.;
      }

      FreeMotion begin_step(const double, const bool smooth) override
      {
        // BDF2 as Euler's rule and a share of how the velocity changes
        const bool   two_steps = smooth && !before.velocity.empty();
        const double ratio     = before.length > 0. ? h / before.length : 1.,
                     share     = two_steps ? ratio / (1 + ratio) : 0.;
        FreeMotion motion;
        motion.velocity_factor = 1 + share;
        motion.velocity        = u;
        for (double &value : motion.velocity)
          value *= -(1 + share) / h;
        if (two_steps)
          for (std::size_t i = 0; i < u.size(); ++i)
            motion.velocity[i] -= share * before.velocity[i];
        return motion;
      }

      StepEnergy end_step(const ContactProblem &problem,
                          const ContactState   &state) override
      {
        if (previous.pressure.empty())
          {
            previous = open_state(problem);
            u.assign(previous.traction.size(), 0.);
          }
        StepEnergy energy;
        energy.strain = work(problem, state, state) / 2;
        // of the mean of the reactions at the start and at the end
        energy.contact_work =
          energy.strain - work(problem, previous, previous) / 2;
        before = {u, h};
        take(problem, state, energy.strain);
        for (std::size_t i = 0; i < u.size(); ++i)
          before.velocity[i] = (u[i] - before.velocity[i]) / h;
        return energy;
      }

      void start_from(const ContactProblem &problem,
                      const ContactState   &state) override
      {
        take(problem, state, work(problem, state, state) / 2);
        before = {std::vector<double>(u.size(), 0.), 0.};
      }

      double stored_energy() const override
      {
        return strain;
      }

      BodyDynamics::Memory memory_consumption() const override
      {
        return {};
      }

      BodyField displacement(const Side            side,
                             const ContactProblem &problem,
                             const ContactState   &state) const override
      {
        return pair.displacement(side, problem, state);
      }

      std::vector<std::vector<double>>
      response(const std::vector<std::vector<double>> &forces) override
      {
        return pair.response(forces, false);
      }

      void remember() override
      {
        kept        = previous;
        kept_u      = u;
        kept_before = before;
        kept_strain = strain;
      }

      void go_back() override
      {
        previous = kept;
        u        = kept_u;
        before   = kept_before;
        strain   = kept_strain;
      }

      PairMotion save() const override
      {
        return {{}, before, {}};
      }

      void restore(const PairMotion     &motion,
                   const ContactProblem &problem,
                   const ContactState   &state) override
      {
        start_from(problem, state);
        before = motion.past;
      }

    private:
      void take(const ContactProblem &problem,
                const ContactState   &state,
                const double          energy)
      {
        u = problem.operators
              .tangential_displacement(state.traction, state.pressure)
              .values();
        previous = state;
        strain   = energy;
      }

      const RollingPair<dim> &pair;
      std::vector<double>     u, kept_u;
      PastStep                before, kept_before;
      ContactState            previous, kept;
      double                  strain = 0., kept_strain = 0.;
      double                  h = 0.;
    };
  } // namespace

  template <int dim>
  std::unique_ptr<PairIntegrator<dim>>
  make_quasi_static_rolling(const RollingPair<dim> &pair)
  {
    return std::make_unique<QuasiStaticRolling<dim>>(pair);
  }

  template std::unique_ptr<PairIntegrator<2>>
  make_quasi_static_rolling(const RollingPair<2> &);
  template std::unique_ptr<PairIntegrator<3>>
  make_quasi_static_rolling(const RollingPair<3> &);
} // namespace RollingContact
