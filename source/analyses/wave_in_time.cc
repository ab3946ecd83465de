#include <rolling_contact/analyses/wave_in_time.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/contact/resultants.h>
#include <rolling_contact/state/steady_state.h>
#include <rolling_contact/time/patch_friction.h>
#include <rolling_contact/vibration/reduced_motion.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace RollingContact
{
  namespace
  {
    using Complex = std::complex<double>;

    /// change of growth in a period at which it is settled, and how many
    /// periods one after the other must have it
    const double       settled_change  = 2e-4;
    const unsigned int settled_periods = 2;

    /// steps of a period of the wave, and of those of modes
    const double least_steps = 60., least_steps_of_modes = 2.;

    /// of normal and tangential motion, over the compliance
    const double least_coupling = 1e-10;

    /** The pair with dampers that do at the rate i w what its loss stiffness
     * does. */
    ReducedPair viscous(ReducedPair pair, const double w)
    {
      if (pair.H_m.size() > 0)
        pair.C_m += pair.H_m / w;
      pair.H_m = DenseMatrix();
      return pair;
    }

    /** The real part of amplitudes that go as exp(s t). */
    std::vector<double> at_time(const ComplexVector &amplitudes,
                                const Complex        factor)
    {
      std::vector<double> result(amplitudes.size());
      as_vector(result) = (factor * amplitudes).real();
      return result;
    }

    /**
     * The bodies and their contact, step after step.
     */
    class Passage
    {
    public:
      Passage(const ContactProblem       &problem,
              const ContactState         &state,
              const LinearContactOptions &options,
              const WaveSweep            &waves,
              const std::size_t           speed,
              const FollowedWave         &wave,
              const std::vector<bool>    &border);

      /** Growth and load by the steps of a period. */
      WaveInTime period();

    private:
      /** The compliance over a step in place of that at rest. */
      void set_operators(const ContactOperators &steady);

      void hold(const LinearContactOptions &options);

      /** The static motion of the nodes that the modes at rest at zero do not
       * have. */
      void find_offset(const ContactProblem &steady);

      /** Begin in the linear answer, half a step before the first laws. */
      void begin(const WaveSweep &waves, const std::size_t number);

      void take_step(const double time);

      void set_loads(const double time);

      Complex wear(const TangentialProblem &tangential,
                   const double             time) const;

      const FollowedWave             wave;
      const std::vector<double>     &lengths;
      const std::vector<bool>       &border;
      const double                   V, h; ///< m/s, s
      const Complex                  s;    ///< i k V, 1/s
      ContactProblem                 problem;
      ContactState                   state;
      ReducedMotion                  motion;
      std::unique_ptr<ContactSolver> solver;
      std::optional<PatchFriction>   friction;
      std::vector<double>            along, gap, offset;
      unsigned int                   n_taken = 0;
    };

    Passage::Passage(const ContactProblem       &steady,
                     const ContactState         &state_at_rest,
                     const LinearContactOptions &options,
                     const WaveSweep            &waves,
                     const std::size_t           number,
                     const FollowedWave         &wave,
                     const std::vector<bool>    &border)
      : wave(wave)
      , lengths(waves.growth(number).lengths())
      , border(border)
      , V(wave.speed)
      , h(2 * pi / (wave.wave_number * V * wave.n_steps))
      , s(0., wave.wave_number * V)
      , problem(steady)
      , state(state_at_rest)
      , motion(viscous(waves.bodies(number), s.imag()))
      , gap(steady.loads.gap)
    {
      const int flow = problem.operators.slip_operator().flow_direction();
      for (const auto &at : problem.operators.positions())
        along.push_back(flow * at[0]);
      SolverControls controls;
      controls.tolerance = wave.tolerance;
      solver             = make_contact_solver("automatic", controls);
      hold(options);
      find_offset(steady);
      begin(waves, number);
      set_operators(steady.operators);
    }

    void Passage::set_operators(const ContactOperators &steady)
    {
      const DenseMatrix &W = motion.compliance();
      const Eigen::Index n = steady.n_nodes(), t = W.rows() - n;
      // bodies that are alike at rest need not be so as they turn
      NormalTangentialCoupling coupling = steady.coupling();
      coupling.exists =
        coupling.exists ||
        W.topRightCorner(t, n).cwiseAbs().maxCoeff() >
          least_coupling * W.bottomRightCorner(n, n).cwiseAbs().maxCoeff();
      problem.operators = ContactOperators(steady.positions(),
                                           steady.H(),
                                           W,
                                           steady.slip_operator(),
                                           coupling,
                                           steady.nodal_forces());
      problem.operators.set_frames(steady.frames());
      problem.operators.set_time_scaling(
        {1., ReducedMotion::velocity_factor / (h * V)});
    }

    void Passage::hold(const LinearContactOptions &options)
    {
      ContactLoads &loads = problem.loads;
      loads.normal_load.reset();
      loads.inclined_load.reset();
      loads.forces   = {};
      loads.approach = state.approach;
      loads.speed    = V;
      if (!loads.friction_law || options.friction == FrictionResponse::node)
        return;
      if (options.friction == FrictionResponse::patch_mean)
        friction.emplace(problem, state, options.memory);
      else
        loads.friction = tangential_problem(problem, state).friction;
      loads.friction_law.reset();
    }

    void Passage::find_offset(const ContactProblem &steady)
    {
      const std::vector<double> forces = nodal_forces(steady, state);
      motion.rest_at(std::vector<double>(motion.bodies().n_modes(), 0.),
                     forces);
      offset = sum(steady.operators.W().dense() * forces,
                   -1.,
                   motion.bodies().W_res * forces);
    }

    void Passage::begin(const WaveSweep &waves, const std::size_t number)
    {
      const WaveAnswer    answer = waves.answer(wave.wave_number, number);
      const ReducedPair  &pair   = motion.bodies();
      const ComplexVector forces =
        waves.contact().forces.cast<Complex>() * answer.unknowns;
      ComplexMatrix eta = pair.Phi.transpose().cast<Complex>() * forces;
      ModalFactors(waves.bodies(number), s).solve(eta);
      const ComplexVector followed = forces / (1. + s * pair.retardation);
      const double        r        = wave.amplitude;
      ReducedState        begin    = motion.state(), disturbed;
      disturbed.eta                = at_time(eta.col(0), r);
      disturbed.rate               = at_time(eta.col(0), r * s);
      disturbed.forces = at_time(followed, r * std::exp(-s * h / 2.));
      disturbed.forces_before =
        at_time(followed, r * std::exp(-s * 3. * h / 2.));
      begin.add(1., disturbed);
      motion.set_state(begin);
      motion.set_time_step(h);
      if (friction)
        {
          const Complex m = r * std::exp(-s * h / 2.) *
                            answer.unknowns[waves.contact().n_tractions()];
          friction->disturb(m.real(), (s * m).real());
        }
    }

    void Passage::set_loads(const double time)
    {
      motion.begin_step();
      const std::vector<double> u = sum(motion.free_displacement(), 1., offset),
                                &v = motion.free_velocity();
      const std::size_t N = problem.n_nodes(), n = u.size() - N;
      ContactLoads     &loads = problem.loads;
      loads.free_displacement = NodalField(N, {u.begin(), u.begin() + n});
      loads.free_slip         = NodalField(N, {v.begin(), v.begin() + n});
      loads.free_slip *= 1 / V;
      for (std::size_t i = 0; i < N; ++i)
        loads.gap[i] =
          gap[i] + u[n + i] -
          wave.amplitude * std::cos(wave.wave_number * (V * time - along[i]));
    }

    void Passage::take_step(const double time)
    {
      set_loads(time);
      if (friction)
        friction->begin_step(h);
      SolverReport report;
      do
        {
          if (friction)
            problem.loads.friction = friction->coefficients();
          report = solver->solve(problem, state);
      } while (report.converged && friction &&
               !friction->agrees(problem, state));
      const std::string when =
        "The wave of " + significant(2e3 * pi / wave.wave_number, 4) +
        " mm in time, at its step " + std::to_string(n_taken) + ": ";
      if (!report.converged)
        throw ConvergenceError(when + "no state of contact was found, " +
                               shortfall(report, wave.tolerance) + ".");
      if (friction && friction->failed())
        throw ConvergenceError(when + "friction and its memory do not agree.");
      if (reaches_border(border, problem, state.pressure))
        throw ConvergenceError(when + "the patch reaches the border of the "
                                      "candidate zone; take a larger "
                                      "Mesh/Candidate zone.");
      if (friction)
        friction->end_step();
      motion.end_step(nodal_forces(problem, state));
    }

    Complex Passage::wear(const TangentialProblem &tangential,
                          const double             time) const
    {
      const NodalField slip = tangential.mean_slip(state);
      Complex          sum  = 0.;
      for (unsigned int i = 0; i < problem.n_nodes(); ++i)
        {
          double power = 0.; // over V
          for (unsigned int c = 0; c < slip.n_components(); ++c)
            power += state.traction(c, i) * slip(c, i);
          sum += lengths[i] * power *
                 std::polar(1., wave.wave_number * (along[i] - V * time));
        }
      return sum;
    }

    WaveInTime Passage::period()
    {
      WaveInTime             result;
      std::vector<NodeState> first;
      std::vector<bool>      changed(problem.n_nodes(), false);
      for (unsigned int step = 0; step < wave.n_steps; ++step)
        {
          throw_if_interrupted();
          const double time = (n_taken + 0.5) * h;
          take_step(time);
          ++n_taken;
          const auto &forces = nodal_forces(problem, state);
          double      load   = 0.;
          for (std::size_t i = forces.size() - problem.n_nodes();
               i < forces.size();
               ++i)
            load += forces[i];
          const TangentialProblem tangential =
            tangential_problem(problem, state);
          result.growth += wear(tangential, time);
          const auto now = node_states(tangential, state);
          first          = first.empty() ? now : first;
          for (std::size_t i = 0; i < now.size(); ++i)
            changed[i] = changed[i] || now[i] != first[i];
          result.load += load * std::exp(-s * time);
        }
      result.n_changed = std::count(changed.begin(), changed.end(), true);
      result.growth *= 2 / (wave.n_steps * wave.amplitude);
      result.load *= 2 / (wave.n_steps * wave.amplitude);
      return result;
    }
  } // namespace

  unsigned int steps_of_period(const ReducedPair &pair,
                               const double       speed,
                               const double       wave_number,
                               const double       element)
  {
    const double fastest =
      pair.n_modes() > 0
        ? std::sqrt(std::max(0., pair.K_m.diagonal().maxCoeff()))
        : 0.;
    return static_cast<unsigned int>(std::ceil(
      std::max({least_steps,
                2 * pi / (wave_number * element),
                least_steps_of_modes * fastest / (wave_number * speed)})));
  }

  WaveInTime wave_in_time(const ContactProblem       &problem,
                          const ContactState         &state,
                          const LinearContactOptions &options,
                          const WaveSweep            &waves,
                          const std::size_t           speed,
                          const FollowedWave         &wave,
                          const std::vector<bool>    &border)
  {
    Passage      passage(problem, state, options, waves, speed, wave, border);
    WaveInTime   now;
    Complex      before    = 0.;
    unsigned int n_settled = 0;
    for (unsigned int n = 1; n <= wave.most_periods && !now.settled; ++n)
      {
        now           = passage.period();
        now.n_periods = n;
        now.change    = std::abs(now.growth - before) / std::abs(now.growth);
        n_settled     = now.change <= settled_change ? n_settled + 1 : 0;
        now.settled   = n_settled >= settled_periods;
        before        = now.growth;
      }
    return now;
  }
} // namespace RollingContact
