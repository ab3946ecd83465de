#ifndef rolling_contact_stability_unstable_count_h
#define rolling_contact_stability_unstable_count_h

#include <rolling_contact/algebra/dense_matrix.h>
#include <rolling_contact/stability/linear_contact.h>
#include <rolling_contact/stability/reduced_pair.h>

#include <functional>

namespace RollingContact
{
  /**
   * The part of the complex plane in which eigenvalues are counted: frequencies
   * between two limits, growth above one, and below 2 pi times the highest
   * frequency.
   */
  struct CountOptions
  {
    double lowest_frequency  = 60.;   ///< Hz
    double highest_frequency = 5000.; ///< Hz
    double least_growth      = 0.;    ///< 1/s

    /** Motions of the patch by less than this of the largest, in quasi-static
     * flexibility, are left out. */
    double motion_tolerance = 1e-6;
  };

  /**
   * A number of eigenvalues, and how well it is founded.
   */
  struct UnstableCount
  {
    int  count    = 0;
    bool resolved = true; ///< false: an eigenvalue lies on the contour

    /** Turns of the determinant around the contour; an integer but for
     * rounding, as the contour is closed. */
    double turns = 0.;

    double       largest_step    = 0.;   ///< of its phase, rad; a turn is 2 pi
    unsigned int n_points        = 0;    ///< on the contour
    unsigned int n_contact_poles = 0;    ///< of the contact by itself in there
    unsigned int n_body_poles    = 0;    ///< of the bodies by themselves
    bool         fitted          = true; ///< false: no rational fit was found
  };

  /**
   * Counts the unstable eigenvalues of a pair by the argument principle,
   * independent of any eigenvalue solver of the whole. The patch sees only p
   * motions U of the modes, the singular vectors of Phi K^-1/2. With L = Phi^T
   * U,
   *
   *   H(s) = L^T (s^2 + s C_m + K_m)^-1 L,
   * and G(s) the ContactResponse, the eigenvalues are the zeros of
   * det(I - H G), whose poles are those of H and G: zeros = turns + poles in
   * the contour. H comes from its poles and residues, once for a pair; G from a
   * rational fit of some 130 values, for each contact. The contour is divided
   * where the phase of the determinant steps by more than 0.8 or its logarithm
   * by more than 1; it begins with points clustered about each lightly damped
   * mode.
   */
  class UnstableCounter
  {
  public:
    /**
     * Throws InputError for frequencies that are not 0 < lowest < highest. See
     * also check() of the pair.
     */
    explicit UnstableCounter(const ReducedPair  &pair,
                             const CountOptions &options = {});

    UnstableCount count(const LinearContact &contact) const;

    /**
     * Number p of motions of the patch.
     */
    unsigned int n_motions() const
    {
      return U.cols();
    }

    /**
     * False if H is solved for with the modes each time, as poles that share a
     * vector give no residues.
     */
    bool uses_residues() const
    {
      return poles_hold;
    }

  private:
    using MatrixFunction =
      std::function<ComplexMatrix(const std::complex<double>)>;

    void find_motions();

    void find_poles();

    void set_contour();

    ComplexMatrix body_response(const std::complex<double> s) const;

    /**
     * H by a solution with the modes.
     */
    ComplexMatrix solved_response(const std::complex<double> s) const;

    /**
     * Points for the rational fit of G.
     */
    ComplexValues fit_points() const;

    bool inside(const std::complex<double> s) const;

    CountOptions               options;
    ReducedPair                pair;
    DenseMatrix                U, L;
    ComplexValues              poles;
    ComplexMatrix              left, right; ///< residues of H
    bool                       poles_hold = true;
    ComplexValues              contour;  ///< counter-clockwise, closed
    std::vector<ComplexMatrix> response; ///< H there
  };
} // namespace RollingContact

#endif
