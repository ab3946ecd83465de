#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/stability/correction.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <list>
#include <optional>

namespace RollingContact
{
  ModalFactors::ModalFactors(const ReducedPair         &pair,
                             const std::complex<double> s)
    : n_of_wheel(pair.n_wheel_modes)
  {
    const Eigen::Index m = pair.n_modes();
    for (const auto &[first, n] :
         {std::pair<Eigen::Index, Eigen::Index>(0, n_of_wheel),
          std::pair<Eigen::Index, Eigen::Index>(n_of_wheel, m - n_of_wheel)})
      {
        ComplexMatrix D = pair.K_m.block(first, first, n, n) +
                          s * pair.C_m.block(first, first, n, n);
        D.diagonal().array() += s * s;
        if (pair.H_m.size() > 0)
          D += std::complex<double>(0., std::copysign(1., s.imag())) *
               pair.H_m.block(first, first, n, n);
        of_bodies.emplace_back(std::move(D));
      }
  }

  void ModalFactors::solve(Eigen::Ref<ComplexMatrix> B) const
  {
    of_bodies[0].solve(B.topRows(n_of_wheel));
    of_bodies[1].solve(B.bottomRows(B.rows() - n_of_wheel));
  }

  bool CorrectedMode::undecided() const
  {
    // a comparison with NaN must not pass for a decision
    return !(std::abs(growth()) > uncertainty);
  }

  bool CorrectedMode::unstable() const
  {
    return growth() > uncertainty;
  }

  namespace
  {
    /**
     * T(s) of the reduced pair.
     */
    ComplexMatrix reduced_matrix(const ReducedPair         &pair,
                                 const LinearContact       &contact,
                                 const std::complex<double> s)
    {
      using Complex = std::complex<double>;
      ComplexMatrix modal =
        (pair.Phi.transpose() * contact.forces).cast<Complex>();
      ModalFactors(pair, s).solve(modal);
      const ComplexMatrix motion = pair.Phi.cast<Complex>() * modal +
                                   pair.W_res * contact.forces /
                                     (1. + s * pair.retardation),
                          N = contact.N_u + s * contact.N_v;
      return N * motion + contact.N_r + s * contact.N_s;
    }

    /**
     * T'(s) x of the reduced pair, with W' = -Phi D^-1 (2 s + C_m) D^-1 Phi^T
     * - tau W_res / (1 + s tau)^2.
     */
    ComplexVector reduced_derivative(const ReducedPair         &pair,
                                     const LinearContact       &contact,
                                     const std::complex<double> s,
                                     const ComplexVector       &x)
    {
      const ComplexVector forces = contact.forces * x;
      const ModalFactors  factors(pair, s);
      ComplexVector       modal = pair.Phi.transpose() * forces;
      factors.solve(modal);
      ComplexVector rate = pair.C_m * modal + 2. * s * modal;
      factors.solve(rate);
      const std::complex<double> follows = 1. + s * pair.retardation;
      const ComplexVector        change =
        pair.Phi * rate +
        pair.W_res * forces * (pair.retardation / (follows * follows));
      return contact.N_s * x - contact.N_u * change +
             contact.N_v * (reduced_response(pair, s, forces) - s * change);
    }

    /**
     * (N_u + s N_v) u + (N_r + s N_s) x.
     */
    ComplexVector contact_residual(const LinearContact       &contact,
                                   const std::complex<double> s,
                                   const ComplexVector       &u,
                                   const ComplexVector       &x)
    {
      return contact.N_u * u + contact.N_r * x +
             s * (contact.N_v * u + contact.N_s * x);
    }

    /**
     * The bordered matrix of the reduced pair at one eigenvalue, and the scales
     * of its rows and columns.
     */
    class BorderedSystem
    {
    public:
      BorderedSystem(const ReducedPair         &pair,
                     const LinearContact       &contact,
                     const std::complex<double> s,
                     const ComplexVector       &x)
        : size_of_s(std::abs(s))
        , T(reduced_matrix(pair, contact, s))
      {
        set_scales(contact, x);
        const Eigen::Index n = x.size();
        ComplexMatrix      M(n + 1, n + 1);
        M << rows.asDiagonal() * T * columns.asDiagonal(),
          size_of_s *
            rows.cwiseProduct(reduced_derivative(pair, contact, s, x)),
          x.cwiseQuotient(columns).adjoint(), 0.;
        factors.emplace(std::move(M));
      }

      /**
       * What a residual changes x and s by.
       */
      std::complex<double> step(const ComplexVector &residual,
                                ComplexVector       &x) const
      {
        const Eigen::Index n = x.size();
        ComplexVector      change(n + 1);
        change << -rows.cwiseProduct(residual), 0.;
        factors->solve(change);
        x += columns.cwiseProduct(change.head(n));
        return change[n] * size_of_s;
      }

      double backward_error(const ComplexVector &residual,
                            const ComplexVector &x) const
      {
        const double error = rows.cwiseProduct(residual).norm(),
                     largest =
                       rows.cwiseProduct(T.cwiseAbs() * x.cwiseAbs()).norm();
        return largest > 0. ? error / largest : error * error;
      }

    private:
      /**
       * Columns: the largest traction or pressure, and what else there is by
       * itself; rows: largest entry one.
       */
      void set_scales(const LinearContact &contact, const ComplexVector &x)
      {
        const std::size_t n_tractions =
          (contact.n_tangential + 1) * contact.touching.size();
        columns = x.cwiseAbs();
        columns.head(n_tractions)
          .setConstant(columns.head(n_tractions).lpNorm<Eigen::Infinity>());
        columns = (columns.array() > 0.).select(columns, 1.);
        rows    = (T.cwiseAbs() * columns.asDiagonal()).rowwise().maxCoeff();
        rows    = (rows.array() > 0.).select(rows.cwiseInverse(), 1.);
      }

      const double             size_of_s;
      const ComplexMatrix      T;
      Eigen::VectorXd          rows, columns;
      std::optional<ComplexLU> factors;
    };
  } // namespace

  ComplexVector reduced_response(const ReducedPair         &pair,
                                 const std::complex<double> s,
                                 const ComplexVector       &forces)
  {
    ComplexVector modal = pair.Phi.transpose() * forces;
    ModalFactors(pair, s).solve(modal);
    return pair.W_res * forces / (1. + s * pair.retardation) + pair.Phi * modal;
  }

  namespace
  {
    /**
     * The steps of one mode.
     */
    class Correction
    {
    public:
      Correction(const ReducedPair       &pair,
                 const LinearContact     &contact,
                 const StabilityMode     &mode,
                 const CorrectionOptions &options)
        : contact(contact)
        , mode(mode)
        , options(options)
        , system(pair, contact, mode.s, mode.unknowns)
      {
        now.s = now.reduced = mode.s;
        now.unknowns        = mode.unknowns;
        now.uncertainty     = std::numeric_limits<double>::infinity();
      }

      bool goes_on() const
      {
        return !ended && now.n_responses < options.most_steps;
      }

      std::complex<double> s() const
      {
        return now.s;
      }

      ComplexVector forces() const
      {
        return contact.forces * now.unknowns;
      }

      /**
       * Step by the answer of the full bodies to these forces.
       */
      void take(const ComplexVector &u)
      {
        if (u.size() != contact.forces.rows())
          throw InputError("The response of the full bodies has " +
                           std::to_string(u.size()) + " values; the contact " +
                           "needs " + std::to_string(contact.forces.rows()) +
                           ".");
        const ComplexVector residual =
          contact_residual(contact, now.s, u, now.unknowns);
        now.backward_error = system.backward_error(residual, now.unknowns);
        if (++now.n_responses == 1)
          now.first_backward_error = now.backward_error;
        const double               before = now.uncertainty;
        const std::complex<double> change = system.step(residual, now.unknowns);
        now.s += change;
        now.uncertainty = std::abs(change);
        if (!(now.uncertainty < before))
          {
            now.uncertainty = std::numeric_limits<double>::infinity();
            ended           = true;
          }
        else
          ended = now.uncertainty <= options.tolerance * std::abs(now.s);
      }

      CorrectedMode result() const
      {
        CorrectedMode result = now;
        if (mode.is_real())
          result.s = result.s.real();
        result.damping_needed = std::max(0.,
                                         result.growth() / std::abs(result.s) +
                                           options.damping_margin);
        return result;
      }

    private:
      const LinearContact     &contact;
      const StabilityMode     &mode;
      const CorrectionOptions &options;
      const BorderedSystem     system;
      CorrectedMode            now;
      bool                     ended = false;
    };

    /**
     * The answers of the full bodies to all modes that go on.
     */
    void step(std::vector<Correction *> &active, const BodyResponse &response)
    {
      ComplexValues              rates;
      std::vector<ComplexVector> forces;
      for (const Correction *mode : active)
        {
          rates.push_back(mode->s());
          forces.push_back(mode->forces());
        }
      const std::vector<ComplexVector> u = response(rates, forces);
      for (std::size_t k = 0; k < active.size(); ++k)
        active[k]->take(u[k]);
    }
  } // namespace

  std::vector<CorrectedMode> correct(const ReducedPair                &pair,
                                     const LinearContact              &contact,
                                     const std::vector<StabilityMode> &modes,
                                     const BodyResponse               &response,
                                     const CorrectionOptions          &options)
  {
    std::list<Correction> corrections; // which hold references, and stay
    for (const StabilityMode &mode : modes)
      corrections.emplace_back(pair, contact, mode, options);
    while (true)
      {
        std::vector<Correction *> active;
        for (Correction &mode : corrections)
          if (mode.goes_on())
            active.push_back(&mode);
        if (active.empty())
          break;
        step(active, response);
      }
    std::vector<CorrectedMode> results;
    for (const Correction &mode : corrections)
      results.push_back(mode.result());
    return results;
  }
} // namespace RollingContact
