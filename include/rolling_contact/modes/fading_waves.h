#ifndef rolling_contact_modes_fading_waves_h
#define rolling_contact_modes_fading_waves_h

#include <rolling_contact/algebra/dense_matrix.h>

namespace RollingContact
{
  /**
   * A few waves fitted to equidistant samples along a line, to continue them
   * beyond: sample c of period n is
   *
   *   a_c(n) = sum_j a_cj z_j^n,
   *
   * with as many c as there are places in a period of the line, one in a
   * uniform one. The z_j span the largest left singular vectors of the block
   * Hankel matrix of all samples, which is the same one period further (ESPRIT)
   * but for these factors; the a_cj are least squares. Waves with |z_j| < 1
   * fade; others return from an end of the line.
   *
   * Source: R. Roy, T. Kailath, ESPRIT: estimation of signal parameters via
   * rotational invariance techniques, IEEE Trans. Acoust. 37 (1989).
   */
  class FadingWaves
  {
  public:
    /**
     * @p samples: by places in a period and periods, at least four of them; as
     * many waves as @p most at most, fewer where the samples have fewer.
     */
    FadingWaves(const ComplexMatrix &samples, const unsigned int most);

    /** What those that fade make of a place in a period, so many periods after
     * the first. */
    std::complex<double> at(const Eigen::Index place,
                            const double       periods) const;

    /** What the waves leave of the samples, over these: root of the mean
     * squares. */
    double misfit() const
    {
      return left_over;
    }

    /** Size of those that return, where the samples end: root of the mean
     * square in the last period. */
    double returning() const
    {
      return reflected;
    }

  private:
    ComplexVector factors;    ///< z_j
    ComplexMatrix amplitudes; ///< a_cj
    double        left_over = 0., reflected = 0.;
  };
} // namespace RollingContact

#endif
