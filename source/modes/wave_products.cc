#include <rolling_contact/modes/wave_products.h>

#include <cmath>
#include <complex>

namespace RollingContact
{
  namespace
  {
    using Complex = std::complex<double>;

    /// rates times lengths below which there is nothing but the length
    const double small = 1e-9;

    /// lengths that differ by less are one, m
    const double same_length = 1e-9;

    /** int_0^length exp(rate x) dx. */
    Complex integral(const Complex rate, const double length)
    {
      if (!std::isfinite(length))
        return -1. / rate;
      return std::abs(rate) * length < small
               ? Complex(length)
               : (std::exp(rate * length) - 1.) / rate;
    }
  } // namespace

  WaveProducts::WaveProducts(const ComplexMatrix &form,
                             const ComplexVector &wavenumbers,
                             const ComplexMatrix &u,
                             const ComplexMatrix &u_behind)
    : k(wavenumbers)
    , ahead_ahead(u.adjoint() * form * u)
    , behind_behind(u_behind.adjoint() * form * u_behind)
    , ahead_behind(u.adjoint() * form * u_behind)
  {}

  void WaveProducts::add(const double         length,
                         const ComplexMatrix *ahead,
                         const ComplexMatrix *behind,
                         ComplexMatrix       &sum)
  {
    const auto [place, is_new] =
      known.try_emplace(std::round(length / same_length));
    Stretch &it = place->second;
    if (is_new)
      it = stretch(length);
    if (ahead != nullptr)
      sum += ahead->adjoint() * it.ahead_ahead * *ahead;
    if (behind != nullptr)
      sum += behind->adjoint() * it.behind_behind * *behind;
    if (ahead == nullptr || behind == nullptr)
      return;
    const ComplexMatrix both = ahead->adjoint() * it.ahead_behind * *behind;
    sum += both + both.adjoint();
  }

  WaveProducts::Stretch WaveProducts::stretch(const double length) const
  {
    const Complex i(0., 1.);
    const bool    ends = std::isfinite(length);
    Stretch       result{ahead_ahead, behind_behind, ahead_behind};
    for (Eigen::Index l = 0; l < k.size(); ++l)
      for (Eigen::Index j = 0; j < k.size(); ++j)
        {
          // int exp(i k_j^* x) exp(-i k_l x) dx
          const Complex rate  = i * (std::conj(k[j]) - k[l]);
          const Complex alike = integral(rate, length);
          result.ahead_ahead(j, l) *= alike;
          result.behind_behind(j, l) *= alike;
          // int exp(i k_j^* x) exp(-i k_l (length - x)) dx
          const Complex between = i * (std::conj(k[j]) + k[l]);
          if (ends)
            result.ahead_behind(j, l) *=
              std::abs(between) * length < small
                ? std::exp(-i * k[l] * length) * length
                : (std::exp(i * std::conj(k[j]) * length) -
                   std::exp(-i * k[l] * length)) /
                    between;
        }
    return result;
  }
} // namespace RollingContact
