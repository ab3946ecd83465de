#include <rolling_contact/pair/pair_integrator.h>

namespace RollingContact
{
  namespace
  {
    /**
     * r . W r' with the nodal forces r of a state and r' of @p other. Units: J.
     */
    double
    work(const ContactProblem &problem,
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

      void
      set_time_step(const double step) override
      {
        h = step;
      }

      bool
      compliance_depends_on_step() const override
      {
        return false;
      }

      DenseMatrix
      compliance() const override
      {
        return {};
      }

      double
      displacement_factor() const override
      {
        return 1.;
      }

      FreeMotion
      begin_step(const double) override
      {
        FreeMotion motion;
        motion.velocity = u;
        for (double &value : motion.velocity)
          value /= -h;
        return motion;
      }

      StepEnergy
      end_step(const ContactProblem &problem,
               const ContactState   &state) override
      {
        if (previous.pressure.empty())
          previous = open_state(problem);
        const double now    = work(problem, state, state),
                     before = work(problem, previous, previous),
                     mixed  = work(problem, state, previous);
        StepEnergy energy;
        energy.strain                = now / 2;
        energy.contact_work          = now - mixed;
        energy.numerical_dissipation = (now - 2 * mixed + before) / 2;
        start_from(problem, state);
        return energy;
      }

      void
      start_from(const ContactProblem &problem,
                 const ContactState   &state) override
      {
        u = problem.operators
              .tangential_displacement(state.traction, state.pressure)
              .values();
        previous = state;
        strain   = work(problem, state, state) / 2;
      }

      double
      stored_energy() const override
      {
        return strain;
      }

      BodyDynamics::Memory
      memory_consumption() const override
      {
        return {};
      }

      BodyField
      displacement(const Side            side,
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

      void
      remember() override
      {
        kept        = previous;
        kept_u      = u;
        kept_strain = strain;
      }

      void
      go_back() override
      {
        previous = kept;
        u        = kept_u;
        strain   = kept_strain;
      }

      PerSide<BodyMotion>
      save() const override
      {
        return {};
      }

      void
      restore(const PerSide<BodyMotion> &,
              const ContactProblem &problem,
              const ContactState   &state) override
      {
        start_from(problem, state);
      }

    private:
      const RollingPair<dim> &pair;
      std::vector<double>     u, kept_u;
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
