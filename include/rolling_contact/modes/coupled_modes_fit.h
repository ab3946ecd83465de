#ifndef rolling_contact_modes_coupled_modes_fit_h
#define rolling_contact_modes_coupled_modes_fit_h

#include <rolling_contact/modes/modal_fit.h>

#include <array>
#include <cmath>
#include <complex>

namespace RollingContact
{
  /**
   * Modes of a few motions by least squares, see fit_modes(). They have a row
   * of parameters each: ln omega, ln zeta, phi / omega. The first rows are as
   * many as there are motions and have no frequency: what follows forces at
   * once. Differences at a frequency are weighted by the receptances of both
   * motions there, those of imaginary parts by the imaginary parts of these.
   */
  class CoupledModesFit
  {
  public:
    using Complex = std::complex<double>;

    CoupledModesFit(const std::vector<double>        &frequencies,
                    const std::vector<ComplexMatrix> &receptances,
                    const ModalFitControls           &controls);

    /** Add and adapt modes until the differences are small enough. */
    void run();

    /** Values of the fit, a row for each frequency. */
    ComplexMatrix fit() const
    {
      return answers() * products();
    }

    /** Weighted differences at each frequency. */
    const Eigen::VectorXd &off() const
    {
      return differences;
    }

    std::size_t n_modes() const
    {
      return parameters.rows() - n_motions;
    }

    /** rad/s. */
    double omega(const std::size_t j) const
    {
      return std::exp(parameters(n_motions + j, 0));
    }

    double damping(const std::size_t j) const
    {
      return std::exp(parameters(n_motions + j, 1));
    }

    Eigen::VectorXd motion(const std::size_t j) const
    {
      return omega(j) *
             parameters.row(n_motions + j).tail(n_motions).transpose();
    }

    /** R of FittedModes. */
    DenseMatrix rest() const;

  private:
    /** Weight of an entry, so that norms are those of matrices. */
    static double times(const Eigen::Index a, const Eigen::Index b)
    {
      return a == b ? 1. : std::sqrt(2.);
    }

    void begin();

    /** v of the rank-one matrix v v^T nearest to a symmetric one, of which
     * nothing is left if it has no positive eigenvalue. */
    Eigen::RowVectorXd leading(const Eigen::RowVectorXd &entries) const;

    /** What each mode answers a force with, over phi phi^T / omega^2. */
    ComplexMatrix answers() const;

    ComplexVector answer(const double ln_omega, const double ln_zeta) const;

    /** The entries of phi phi^T / omega^2, a row for each mode. */
    ComplexMatrix products() const;

    ComplexMatrix weighted(const ComplexMatrix &E) const
    {
      return weights.cwiseProduct(E.real()) +
             Complex(0., 1.) * losses.cwiseProduct(E.imag());
    }

    Eigen::VectorXd residual();

    /** Derivatives of the residual by all parameters, row by row. */
    DenseMatrix derivatives() const;

    /** Least squares by at most so many steps. */
    void adapt(const unsigned int most_steps);

    DenseMatrix change(const DenseMatrix     &normal,
                       const Eigen::VectorXd &slope,
                       const double           trust) const;

    void keep_in_bounds();

    /** The damping ratio of a mode that the frequencies around it can tell.
     */
    double sharpest(const double ln_omega) const;

    /** The mode that takes most of the difference around its largest. */
    void add_one();

    /** Real parts over imaginary ones, weighted, of these frequencies. */
    DenseMatrix parts_of(const ComplexMatrix   &E,
                         const Eigen::VectorXd &near) const;

    Eigen::RowVectorXd entries_of(const Eigen::RowVectorXd &v) const;

    const ModalFitControls      controls;
    const Eigen::Index          n_motions, n_points;
    const std::array<double, 2> bounds; ///< of ln omega
    ComplexVector               s;
    ComplexMatrix               values;          ///< upper triangles by rows
    DenseMatrix                 weights, losses; ///< of both parts
    Eigen::VectorXd             given_up;        ///< 1 where no mode helps
    Eigen::VectorXd             differences;     ///< at each frequency
    DenseMatrix                 parameters;
    double                      worst    = 0.;
    Eigen::Index                worst_at = 0;
  };
} // namespace RollingContact

#endif
