#ifndef rolling_contact_modes_waveguide_response_h
#define rolling_contact_modes_waveguide_response_h

#include <rolling_contact/modes/waveguide.h>

namespace RollingContact
{
  /**
   * How a Waveguide answers forces that go as exp(s t): by the waves that leave
   * them, and on pads by those that leave the pads as well. Pads are L apart,
   * each two lines of springs Z that stand for its length, which take forces
   * -Z r from the motions r of the foot. With the Floquet transforms r(xi) =
   * sum_n r_n exp(i xi n) over pads, G(xi) of what forces on pads move of pads
   * and h(xi) of what the load moves of them, both sums of geometric series of
   * waves,
   *
   *   r(xi) = (1 + G Z)^-1 h,
   *
   * at equidistant xi, twice as many until the pads farthest off do not move.
   * Rates far below that of the rail on its pads are told less exactly, as free
   * waves are so long then that the little which far pads bear counts.
   *
   * Source: K. L. Knothe, S. L. Grassie, Modelling of railway track and
   * vehicle/track interaction at high frequencies, Vehicle Syst. Dyn. 22
   * (1993); the waves' sums are geometric series.
   */
  class WaveguideResponse
  {
  public:
    using Complex = Waveguide::Complex;
    using Place   = Waveguide::Place;

    /** Keeps a reference to @p guide. @p added_damping: a ratio as modes have
     * it, half a loss factor. Units: 1/s. */
    WaveguideResponse(const Waveguide &guide,
                      const Complex    s,
                      const double     added_damping = 0.);

    /**
     * Displacements along x, y and z of places, one after the other, that
     * @p forces along x, y and z at another make, column by column. Units: N,
     * m. Throws ConvergenceError where nothing on pads fades.
     */
    ComplexMatrix field(const std::vector<Place> &places,
                        const Place              &loaded,
                        const ComplexMatrix      &forces) const;

    /**
     * The motion of the whole body under forces on the fields of its section at
     * x, column by column, as quadratic forms F of the amplitudes U of these
     * fields at each place: int U^H F U dx, exact by waves. Units: m; those of
     * F times N^2 m^3.
     */
    std::vector<ComplexMatrix>
    integrals(const double                      x,
              const ComplexMatrix              &force,
              const std::vector<ComplexMatrix> &forms) const;

  private:
    /**
     * Forces at one x, by what they give to waves ahead and behind: rows by
     * waves.
     */
    struct Source
    {
      double        x;
      ComplexMatrix ahead, behind;
    };

    /** What @p force on the fields of the section, column by column, gives. */
    Source source_of(const double x, const ComplexMatrix &force) const;

    /** Forces of pads under a load at x. */
    void add_pads(const double         x,
                  const ComplexMatrix &force,
                  std::vector<Source> &sources) const;

    /** Forces at x, and of the pads under them. */
    std::vector<Source> sources_of(const double         x,
                                   const ComplexMatrix &force) const;

    /** What arrives of a source at one line of pads: at the first pad ahead,
     * which this is the number of, and at the one behind that. */
    struct AtLine
    {
      double        first;
      ComplexMatrix ahead, behind;
    };

    std::vector<AtLine> on_lines(const Source &source) const;

    /** Motions r of the foot at all lines of a pad, summed over pads with
     * exp(i xi n). */
    ComplexMatrix motions_of_pads(const std::vector<AtLine> &lines,
                                  const double               xi) const;

    /** Z of all lines of a pad. */
    ComplexMatrix stiffness_of_pad() const;

    const Waveguide &guide;
    const Complex    s;
    const double     added_damping;
    ComplexVector    wavenumbers;
    ComplexMatrix    u, u_behind, v, v_behind; ///< by columns
    ComplexMatrix    Z;
    ComplexMatrix    foot, foot_behind; ///< motions of the foot by waves
    ComplexVector    next_pad;          ///< what waves are from pad to pad

    mutable unsigned int enough_pads = 32;
  };
} // namespace RollingContact

#endif
