#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/stopwatch.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/linear_algebra/block_lanczos.h>
#include <rolling_contact/linear_algebra/block_products.h>
#include <rolling_contact/linear_algebra/indefinite_factor.h>
#include <rolling_contact/modes/structural_modes.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace RollingContact
{
  namespace
  {
    /// of the shifted and inverted problem, over that of K phi = lambda M phi:
    /// the factor blows up what is rough in space
    const double sharper = 1e-3;

    /// of the cut-off, below which no mode is elastic
    const double rigid = 1e-6;



    double
    eigenvalue_of(const double frequency)
    {
      return 4 * pi * pi * frequency * frequency;
    }



    /**
     * Residual of each mode, and how far the modes are from orthonormal.
     */
    void
    examine(const SymmetricSparseMatrix &K,
            const SymmetricSparseMatrix &M,
            StructuralModes             &modes)
    {
      const std::size_t n = K.size(), m = modes.size();
      const DenseMatrix KX = times(K, modes.shapes),
                        MX = times(M, modes.shapes),
                        G  = transposed_product(modes.shapes, MX);
      for (std::size_t j = 0; j < m; ++j)
        {
          const double lambda = modes.eigenvalue(j),
                       scale  = modes.frequencies[j] < rigid * modes.cut_off
                                  ? eigenvalue_of(modes.cut_off)
                                  : lambda;
          double rest = 0., inertia = 0.;
          for (std::size_t i = 0; i < n; ++i)
            {
              rest += std::pow(KX(i, j) - lambda * MX(i, j), 2);
              inertia += std::pow(MX(i, j), 2);
            }
          modes.residuals.push_back(std::sqrt(rest / inertia) / scale);
          for (std::size_t i = 0; i < m; ++i)
            modes.orthogonality =
              std::max(modes.orthogonality, std::abs(G(i, j) - (i == j)));
        }
    }



    /** How many modes there are below the cut-off, by inertia. */
    std::size_t
    count(const SymmetricSparseMatrix     &K,
          const SymmetricSparseMatrix     &M,
          const std::vector<unsigned int> &node_of_unknown,
          const double                     cut_off)
    {
      return n_negative_eigenvalues(
        linear_combination(1., K, -eigenvalue_of(cut_off), M), node_of_unknown);
    }
  } // namespace



  double
  StructuralModes::eigenvalue(const std::size_t j) const
  {
    return eigenvalue_of(frequencies[j]);
  }



  double
  shift_of_free_body(const double cut_off)
  {
    return eigenvalue_of(cut_off / 50);
  }



  StructuralModes
  structural_modes(const SymmetricSparseMatrix     &K,
                   const SymmetricSparseMatrix     &M,
                   const Factorisation             &factor,
                   const double                     shift,
                   const std::vector<unsigned int> &node_of_unknown,
                   const ModeControls              &controls)
  {
    StructuralModes modes;
    const Stopwatch counting;
    if (controls.count)
      modes.counted = count(K, M, node_of_unknown, controls.cut_off);
    modes.count_seconds = counting.seconds();
    if (modes.counted)
      controls.counted(*modes.counted);

    const Stopwatch watch;
    LanczosControls lanczos;
    lanczos.largest    = eigenvalue_of(controls.cut_off);
    lanczos.shift      = shift;
    lanczos.tolerance  = sharper * controls.tolerance;
    lanczos.block_size = controls.block_size;
    lanczos.number     = modes.counted;
    lanczos.interrupt  = controls.interrupt;
    EigenPairs pairs   = block_lanczos(factor, M, lanczos);
    for (const double lambda : pairs.values)
      modes.frequencies.push_back(std::sqrt(std::max(0., lambda)) / (2 * pi));
    modes.shapes          = std::move(pairs.vectors);
    modes.cut_off         = controls.cut_off;
    modes.n_solves        = pairs.n_solves;
    modes.n_basis         = pairs.n_basis;
    modes.lanczos_seconds = watch.seconds();
    if (modes.counted && *modes.counted != modes.size())
      throw ConvergenceError(
        "Of " + std::to_string(*modes.counted) + " modes below " +
        significant(modes.cut_off, 6) +
        " Hz, counted by the inertia of K - omega^2 M, " +
        std::to_string(modes.size()) +
        " were found. A mode may lie at that frequency: change Modes/Maximum "
        "frequency or Cut-off ratio a little.");
    examine(K, M, modes);
    return modes;
  }
} // namespace RollingContact
