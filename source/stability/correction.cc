#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/linear_algebra/dense_eigenvalues.h>
#include <rolling_contact/stability/correction.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <list>
#include <optional>

namespace RollingContact
{
  bool
  CorrectedMode::undecided() const
  {
    // a comparison with NaN must not pass for a decision
    return !(std::abs(growth()) > uncertainty);
  }



  bool
  CorrectedMode::unstable() const
  {
    return growth() > uncertainty;
  }



  namespace
  {
    ComplexLU
    modal_factors(const ReducedPair &pair, const std::complex<double> s)
    {
      ComplexMatrix D(pair.K_m, s, pair.C_m);
      for (std::size_t k = 0; k < pair.n_modes(); ++k)
        D(k, k) += s * s;
      return ComplexLU(std::move(D));
    }



    /**
     * T(s) of the reduced pair.
     */
    ComplexMatrix
    reduced_matrix(const ReducedPair         &pair,
                   const LinearContact       &contact,
                   const std::complex<double> s)
    {
      ComplexMatrix modal(transposed(pair.Phi) * contact.forces);
      modal_factors(pair, s).solve(modal);
      ComplexMatrix     motion   = ComplexMatrix(pair.Phi) * modal;
      const DenseMatrix residual = pair.W_res * contact.forces;
      for (std::size_t k = 0; k < residual.n_rows() * residual.n_columns(); ++k)
        motion.data()[k] += residual.data()[k];
      ComplexMatrix T = ComplexMatrix(contact.N_u, s, contact.N_v) * motion;
      for (std::size_t j = 0; j < T.n_columns(); ++j)
        for (std::size_t i = 0; i < T.n_rows(); ++i)
          T(i, j) += contact.N_r(i, j) + s * contact.N_s(i, j);
      return T;
    }



    /**
     * T'(s) x of the reduced pair, with W' = -Phi D^-1 (2 s + C_m) D^-1 Phi^T.
     */
    ComplexVector
    reduced_derivative(const ReducedPair         &pair,
                       const LinearContact       &contact,
                       const std::complex<double> s,
                       const ComplexVector       &x)
    {
      const ComplexVector forces  = contact.forces * x;
      const ComplexLU     factors = modal_factors(pair, s);
      ComplexVector       modal   = transposed_product(pair.Phi, forces);
      factors.solve(modal);
      ComplexVector rate = pair.C_m * modal;
      add(rate, 2. * s, modal);
      factors.solve(rate);
      const ComplexVector change = pair.Phi * rate;
      ComplexVector       result = contact.N_s * x;
      add(result, 1., contact.N_v * reduced_response(pair, s, forces));
      add(result, -1., contact.N_u * change);
      add(result, -s, contact.N_v * change);
      return result;
    }



    /**
     * (N_u + s N_v) u + (N_r + s N_s) x.
     */
    ComplexVector
    contact_residual(const LinearContact       &contact,
                     const std::complex<double> s,
                     const ComplexVector       &u,
                     const ComplexVector       &x)
    {
      ComplexVector residual = contact.N_u * u;
      add(residual, s, contact.N_v * u);
      add(residual, 1., contact.N_r * x);
      add(residual, s, contact.N_s * x);
      return residual;
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
        , rows(x.size(), 0.)
        , columns(x.size())
      {
        set_scales(contact, x);
        const std::size_t   n = x.size();
        const ComplexVector derivative =
          reduced_derivative(pair, contact, s, x);
        ComplexMatrix M(n + 1, n + 1);
        for (std::size_t j = 0; j < n; ++j)
          {
            for (std::size_t i = 0; i < n; ++i)
              M(i, j) = rows[i] * T(i, j) * columns[j];
            M(j, n) = rows[j] * derivative[j] * size_of_s;
            M(n, j) = std::conj(x[j]) / columns[j];
          }
        factors.emplace(std::move(M));
      }

      /**
       * What a residual changes x and s by.
       */
      std::complex<double>
      step(const ComplexVector &residual, ComplexVector &x) const
      {
        const std::size_t n = x.size();
        ComplexVector     change(n + 1);
        for (std::size_t i = 0; i < n; ++i)
          change[i] = -rows[i] * residual[i];
        factors->solve(change);
        for (std::size_t j = 0; j < n; ++j)
          x[j] += columns[j] * change[j];
        return change[n] * size_of_s;
      }

      double
      backward_error(const ComplexVector &residual,
                     const ComplexVector &x) const
      {
        double error = 0., largest = 0.;
        for (std::size_t i = 0; i < x.size(); ++i)
          {
            double sum = 0.;
            for (std::size_t j = 0; j < x.size(); ++j)
              sum += std::abs(T(i, j)) * std::abs(x[j]);
            error += std::norm(rows[i] * residual[i]);
            largest += rows[i] * rows[i] * sum * sum;
          }
        return largest > 0. ? std::sqrt(error / largest) : error;
      }

    private:
      /**
       * Columns: the largest traction or pressure, and what else there is by
       * itself; rows: largest entry one.
       */
      void
      set_scales(const LinearContact &contact, const ComplexVector &x)
      {
        const std::size_t n_tractions =
          (contact.n_tangential + 1) * contact.touching.size();
        double largest = 0.;
        for (std::size_t j = 0; j < n_tractions; ++j)
          largest = std::max(largest, std::abs(x[j]));
        for (std::size_t j = 0; j < x.size(); ++j)
          {
            columns[j] = j < n_tractions ? largest : std::abs(x[j]);
            if (!(columns[j] > 0.))
              columns[j] = 1.;
          }
        for (std::size_t i = 0; i < x.size(); ++i)
          {
            for (std::size_t j = 0; j < x.size(); ++j)
              rows[i] = std::max(rows[i], std::abs(T(i, j)) * columns[j]);
            rows[i] = rows[i] > 0. ? 1 / rows[i] : 1.;
          }
      }

      const double             size_of_s;
      const ComplexMatrix      T;
      std::vector<double>      rows, columns;
      std::optional<ComplexLU> factors;
    };
  } // namespace



  ComplexVector
  reduced_response(const ReducedPair         &pair,
                   const std::complex<double> s,
                   const ComplexVector       &forces)
  {
    ComplexVector modal = transposed_product(pair.Phi, forces);
    modal_factors(pair, s).solve(modal);
    ComplexVector u = pair.W_res * forces;
    add(u, 1., pair.Phi * modal);
    return u;
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

      bool
      goes_on() const
      {
        return !ended && now.n_responses < options.most_steps;
      }

      std::complex<double>
      s() const
      {
        return now.s;
      }

      ComplexVector
      forces() const
      {
        return contact.forces * now.unknowns;
      }

      /**
       * Step by the answer of the full bodies to these forces.
       */
      void
      take(const ComplexVector &u)
      {
        if (u.size() != contact.forces.n_rows())
          throw InputError("The response of the full bodies has " +
                           std::to_string(u.size()) + " values; the contact " +
                           "needs " + std::to_string(contact.forces.n_rows()) +
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

      CorrectedMode
      result() const
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
    void
    step(std::vector<Correction *> &active, const BodyResponse &response)
    {
      ComplexVector              rates;
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



  std::vector<CorrectedMode>
  correct(const ReducedPair                &pair,
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
