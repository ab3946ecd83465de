#include <rolling_contact/modes/modal_damping.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    /// of the cut-off, below which a mode is rigid_share
    const double rigid_share = 1e-6;

    /** phi_j^T A phi_j; 0 if A is empty. */
    double modal_entry(const SymmetricSparseMatrix &A,
                       const DenseMatrix           &shapes,
                       const std::size_t            j)
    {
      if (A.size() == 0)
        return 0.;
      const std::vector<double> phi = column_of(shapes, j);
      std::vector<double>       image(phi.size());
      A.multiply(phi, image);
      return dot(phi, image);
    }
  } // namespace

  std::vector<double> total_damping(const StructuralModes       &modes,
                                    const std::vector<double>   &given,
                                    const SymmetricSparseMatrix &H,
                                    const SymmetricSparseMatrix &C)
  {
    std::vector<double> ratios(modes.size(), 0.);
    for (std::size_t j = 0; j < modes.size(); ++j)
      {
        if (modes.frequencies[j] <= rigid_share * modes.cut_off)
          continue;
        const double lambda = modes.eigenvalue(j);
        ratios[j] = given[j] + modal_entry(H, modes.shapes, j) / (2 * lambda) +
                    modal_entry(C, modes.shapes, j) / (2 * std::sqrt(lambda));
      }
    return ratios;
  }

  DenseMatrix in_modes(const StructuralModes       &modes,
                       const SymmetricSparseMatrix &A)
  {
    return A.size() > 0 ? projected(A, modes.shapes)
                        : DenseMatrix::Zero(modes.size(), modes.size());
  }

  DenseMatrix modal_damping_matrix(const StructuralModes &modes,
                                   const DenseMatrix     &H_m,
                                   const DenseMatrix     &viscous)
  {
    Eigen::VectorXd shares = Eigen::VectorXd::Zero(modes.size());
    for (std::size_t j = 0; j < modes.size(); ++j)
      if (modes.frequencies[j] > rigid_share * modes.cut_off)
        shares[j] = std::pow(modes.eigenvalue(j), -0.25);
    return viscous + shares.asDiagonal() * H_m * shares.asDiagonal();
  }
} // namespace RollingContact
