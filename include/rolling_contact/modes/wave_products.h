#ifndef rolling_contact_modes_wave_products_h
#define rolling_contact_modes_wave_products_h

#include <rolling_contact/algebra/dense_matrix.h>

#include <map>

namespace RollingContact
{
  /**
   * Integrals of a quadratic form F of the amplitudes of a section's fields
   * over stretches of a straight body, along which waves fade: with the waves
   * a that go ahead, at the begin of a stretch of the length L, and those b
   * that go behind, at its end,
   *
   *   int_0^L U^H F U dx,
   *   U(x) = sum_j u_j exp(-i k_j x) a_j + u'_j exp(-i k_j (L - x)) b_j.
   */
  class WaveProducts
  {
  public:
    /** u and u' by columns; Im k < 0. Units: 1/m. */
    WaveProducts(const ComplexMatrix &form,
                 const ComplexVector &wavenumbers,
                 const ComplexMatrix &u,
                 const ComplexMatrix &u_behind);

    /** Adds the integral over a stretch, which may have no end, for each pair
     * of columns; nullptr where no waves go that way. Units: m. */
    void add(const double         length,
             const ComplexMatrix *ahead,
             const ComplexMatrix *behind,
             ComplexMatrix       &sum);

  private:
    struct Stretch
    {
      ComplexMatrix ahead_ahead, behind_behind, ahead_behind;
    };

    Stretch stretch(const double length) const;

    ComplexVector             k;
    ComplexMatrix             ahead_ahead, behind_behind, ahead_behind;
    std::map<double, Stretch> known; ///< by length, rounded
  };
} // namespace RollingContact

#endif
