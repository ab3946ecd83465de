#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/contact/tangential_problem.h>
#include <rolling_contact/stability/linear_contact.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  unsigned int LinearContact::n_slip() const
  {
    return std::count(slips.begin(), slips.end(), true);
  }

  namespace
  {
    void check_operators(const ContactProblem &problem)
    {
      const ContactOperators &operators = problem.operators;
      const SlipOperatorKind  kind      = operators.slip_operator().kind();
      if (problem.n_tangential() > 0 && kind == SlipOperatorKind::galerkin)
        throw InputError("Contact/Slip operator = " + name_of(kind) +
                         ": the stability of a state needs `calibrated`, "
                         "`upwind 2` or `upwind 1`, with which the state must "
                         "be found, too.");
      if (operators.time_scaling().rate != 0. ||
          operators.time_scaling().convection != 1. ||
          !problem.loads.slip_share.empty())
        throw InputError("The stability of a time step was asked for; only "
                         "steady states have one.");
    }

    void check_options(const ContactProblem       &problem,
                       const LinearContactOptions &options)
    {
      if (!(options.speed > 0.) || !std::isfinite(options.speed))
        throw InputError("Contact/Speed = " + significant(options.speed, 6) +
                         " m/s: the stability of a rolling state needs a "
                         "speed > 0 m/s.");
      if (!problem.loads.friction_law ||
          options.friction == FrictionResponse::constant)
        return;
      if (problem.loads.memory_length > 0.)
        throw InputError("Contact/Friction memory length = " +
                         significant(problem.loads.memory_length, 6) +
                         " m: the stability of friction that remembers a "
                         "sliding distance is not known here; set it to 0 m.");
      if (options.friction == FrictionResponse::patch_mean &&
          (!(options.memory > 0.) || !std::isfinite(options.memory)))
        throw InputError("The memory of friction is " +
                         significant(options.memory, 6) +
                         " s: it must be > 0 s.");
    }

    /**
     * Builds the rows node by node.
     */
    class Linearisation
    {
    public:
      Linearisation(const ContactProblem       &problem,
                    const ContactState         &state,
                    const LinearContactOptions &options);

      LinearContact build();

    private:
      void find_touching();

      void find_slip();

      void add_forces();

      void add_normal_rows();

      void add_slip_rows(const unsigned int k);

      void add_stick_rows(const unsigned int k);

      void add_memory();

      /**
       * Add @p factor times dv_c of node @p i to a row, with what the edge law
       * makes of tractions and pressures at a leading edge, its extrapolation
       * as it is in the state.
       */
      void add_sliding(const std::size_t  row,
                       const unsigned int c,
                       const unsigned int i,
                       const double       factor);

      void find_edges_by_pressure();

      void add_edge_row(const std::size_t  row,
                        const unsigned int c,
                        const unsigned int i,
                        const double       factor);

      double sliding_speed(const unsigned int i) const
      {
        return slip.norm_at(i) * options.speed;
      }

      /**
       * Direction of the sliding velocity.
       */
      double direction(const unsigned int c, const unsigned int i) const
      {
        return slip(c, i) / slip.norm_at(i);
      }

      const ContactProblem       &problem;
      const ContactState         &state;
      const LinearContactOptions &options;
      const ContactOperators     &operators;
      const TangentialProblem     tangential;
      const NodalField            slip;
      const bool                  falls, remembers;
      const std::size_t           N, T;
      std::size_t                 n_touching = 0;
      std::vector<std::size_t>    place; ///< of nodes among the touching ones
      std::vector<NodalField> edges_by_pressure; ///< of touching nodes, 1/Pa
      LinearContact           contact;
    };

    Linearisation::Linearisation(const ContactProblem       &problem,
                                 const ContactState         &state,
                                 const LinearContactOptions &options)
      : problem(problem)
      , state(state)
      , options(options)
      , operators(problem.operators)
      , tangential(tangential_problem(problem, state))
      , slip(problem.n_tangential() > 0 ? tangential.slip(state.traction)
                                        : NodalField())
      , falls(problem.n_tangential() > 0 && problem.loads.friction_law &&
              options.friction != FrictionResponse::constant)
      , remembers(falls && options.friction == FrictionResponse::patch_mean)
      , N(problem.n_nodes())
      , T(problem.n_tangential())
    {}

    void Linearisation::find_touching()
    {
      const std::vector<double> gap = normal_gap(problem, state);
      const double              largest =
        *std::max_element(state.pressure.begin(), state.pressure.end());
      const double rho =
        operators.normal_norm() > 0. ? 1 / operators.normal_norm() : 0.;
      for (unsigned int i = 0; i < N; ++i)
        {
          // of the two one is zero
          const double trial = state.pressure[i] - rho * gap[i];
          if (trial > 0.)
            contact.touching.push_back(i);
          if (std::abs(trial) < options.border * largest)
            ++contact.n_opening;
        }
      n_touching = contact.touching.size();
      if (n_touching == 0)
        throw InputError("The bodies do not touch: there is no state whose "
                         "stability could be asked for.");
      place.assign(N, n_touching);
      for (std::size_t k = 0; k < n_touching; ++k)
        place[contact.touching[k]] = k;
    }

    void Linearisation::find_slip()
    {
      contact.slips.assign(n_touching, false);
      if (T == 0)
        return;
      const NodalField trial = tangential.trial(state.traction, slip);
      for (std::size_t k = 0; k < n_touching; ++k)
        {
          const unsigned int i     = contact.touching[k];
          const double       bound = tangential.bound[i];
          contact.slips[k] =
            bound <= 0. || (trial.norm_at(i) > bound && slip.norm_at(i) > 0.);
          if (bound <= 0.)
            continue;
          const bool near =
            std::abs(trial.norm_at(i) - bound) < options.border * bound;
          if (near)
            ++(contact.slips[k] ? contact.n_sticking : contact.n_slipping);
        }
    }

    void Linearisation::add_forces()
    {
      for (std::size_t c = 0; c <= T; ++c)
        for (unsigned int i = 0; i < N; ++i)
          for (const auto &entry : operators.H()[i])
            if (place[entry.first] < n_touching)
              contact.forces(c * N + i, c * n_touching + place[entry.first]) +=
                entry.second;
    }

    void Linearisation::add_normal_rows()
    {
      for (std::size_t k = 0; k < n_touching; ++k)
        contact.N_u(k, T * N + contact.touching[k]) = 1.;
    }

    void Linearisation::add_sliding(const std::size_t  row,
                                    const unsigned int c,
                                    const unsigned int i,
                                    const double       factor)
    {
      const double flow = operators.slip_operator().flow_direction();
      for (const auto &entry : tangential.rows.B1[i])
        contact.N_u(row, c * N + entry.first) +=
          factor * options.speed * flow * entry.second;
      for (const auto &entry : tangential.rows.B2[i])
        contact.N_v(row, c * N + entry.first) += factor * entry.second;
      if (!tangential.rows.edge_rows.empty())
        add_edge_row(row, c, i, factor * options.speed);
    }

    void Linearisation::add_edge_row(const std::size_t  row,
                                     const unsigned int c,
                                     const unsigned int i,
                                     const double       factor)
    {
      const auto &weights = tangential.rows.edge_rows[c][i];
      for (const auto &[node, weight] : weights)
        contact.N_r(row, c * n_touching + place[node]) += factor * weight;
      if (weights.empty())
        return;
      for (std::size_t k = 0; k < n_touching; ++k)
        contact.N_r(row, T * n_touching + k) +=
          factor * edges_by_pressure[k](c, i);
    }

    /**
     * What pressures change of the edge law, by differences: the tangentially
     * equivalent pressures in it answer all of them, also where the surface
     * does not move along under a pressure, as a traction moves the surface by
     * another amount than the pressure does along the normal.
     */
    void Linearisation::find_edges_by_pressure()
    {
      const double step =
        1e-6 * *std::max_element(state.pressure.begin(), state.pressure.end());
      const auto law = [&](const unsigned int node, const double change) {
        std::vector<double> pressure = state.pressure;
        pressure[node] += change;
        const SlipRows rows  = slip_rows(problem,
                                        pressure,
                                        state.scheme,
                                        state.edge_law,
                                        tangential.rows.edges);
        NodalField     value = rows.edge_constants;
        for (unsigned int c = 0; c < T; ++c)
          for (unsigned int i = 0; i < N; ++i)
            value(c, i) += apply(rows.edge_rows[c][i], state.traction, c);
        return value;
      };
      for (const unsigned int node : contact.touching)
        {
          NodalField change = law(node, step);
          change.add(-1., law(node, -step));
          change *= 1 / (2 * step);
          edges_by_pressure.push_back(std::move(change));
        }
    }

    void Linearisation::add_slip_rows(const unsigned int k)
    {
      const unsigned int i        = contact.touching[k];
      const double       pressure = state.pressure[i];
      const bool         carries  = tangential.bound[i] > 0.;
      const double       mu       = carries ? tangential.friction[i] : 0.;
      const double       slope =
        falls && !remembers && carries
                ? -problem.loads.friction[i] *
              problem.loads.friction_law->slope(sliding_speed(i))
                : 0.;
      for (std::size_t c = 0; c < T; ++c)
        {
          const std::size_t row = n_touching + c * n_touching + k;
          contact.N_r(row, c * n_touching + k) = 1.;
          if (!carries)
            continue;
          const double t                       = direction(c, i);
          contact.N_r(row, T * n_touching + k) = mu * t;
          for (std::size_t e = 0; e < T; ++e)
            {
              const double along  = t * direction(e, i);
              const double across = (c == e ? 1. : 0.) - along;
              add_sliding(row,
                          e,
                          i,
                          pressure *
                            (mu / sliding_speed(i) * across + slope * along));
            }
          if (remembers)
            contact.N_r(row, (T + 1) * n_touching) =
              pressure * problem.loads.friction[i] * t;
        }
    }

    void Linearisation::add_stick_rows(const unsigned int k)
    {
      for (std::size_t c = 0; c < T; ++c)
        add_sliding(n_touching + c * n_touching + k,
                    c,
                    contact.touching[k],
                    1.);
    }

    void Linearisation::add_memory()
    {
      const std::vector<double> &pressure = state.pressure;
      const std::vector<double> &areas    = operators.areas();
      double                     load = 0., mean = 0.;
      for (const unsigned int i : contact.touching)
        {
          load += areas[i] * pressure[i];
          mean += areas[i] * pressure[i] * sliding_speed(i);
        }
      mean /= load;
      const std::size_t row   = (T + 1) * n_touching;
      const double      slope = problem.loads.friction_law->slope(mean);
      contact.N_r(row, row)   = 1.;
      contact.N_s(row, row)   = options.memory;
      for (std::size_t k = 0; k < n_touching; ++k)
        {
          const unsigned int i     = contact.touching[k];
          const double       share = slope * areas[i] / load;
          contact.N_r(row, T * n_touching + k) +=
            share * (sliding_speed(i) - mean);
          if (!contact.slips[k] || tangential.bound[i] <= 0.)
            continue;
          for (std::size_t c = 0; c < T; ++c)
            add_sliding(row, c, i, share * pressure[i] * direction(c, i));
        }
    }

    LinearContact Linearisation::build()
    {
      contact.n_nodes      = N;
      contact.n_tangential = T;
      find_touching();
      find_slip();
      if (!tangential.rows.edge_rows.empty())
        find_edges_by_pressure();
      const std::size_t n = (T + 1) * n_touching + (remembers ? 1 : 0);
      contact.N_u = contact.N_v = DenseMatrix::Zero(n, (T + 1) * N);
      contact.N_r = contact.N_s = DenseMatrix::Zero(n, n);
      contact.forces            = DenseMatrix::Zero((T + 1) * N, n);
      add_forces();
      add_normal_rows();
      for (std::size_t k = 0; T > 0 && k < n_touching; ++k)
        if (contact.slips[k])
          add_slip_rows(k);
        else
          add_stick_rows(k);
      if (remembers)
        add_memory();
      return std::move(contact);
    }
  } // namespace

  LinearContact linear_contact(const ContactProblem       &problem,
                               const ContactState         &state,
                               const LinearContactOptions &options)
  {
    check_operators(problem);
    check_options(problem, options);
    return Linearisation(problem, state, options).build();
  }
} // namespace RollingContact
