#include <Eigen/Cholesky>

#include <rolling_contact/algebra/block_lanczos.h>
#include <rolling_contact/algebra/indefinite_factor.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/stopwatch.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/modes/structural_modes.h>

#include <algorithm>
#include <array>
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

    double eigenvalue_of(const double frequency)
    {
      return 4 * pi * pi * frequency * frequency;
    }

    /** K and M of one invariant subspace. */
    struct Restricted
    {
      SymmetricSparseMatrix     K, M;
      std::vector<unsigned int> node_of_unknown;
    };

    /**
     * Where modes are looked for, the whole structure or one of its parts; a
     * factor of K + shift M if there is one, and their number if it is known.
     */
    struct Problem
    {
      const SymmetricSparseMatrix     &K, &M;
      const std::vector<unsigned int> &node_of_unknown;
      const Factorisation             *factor;
      std::optional<std::size_t>       number;
    };

    /** How many modes there are below the cut-off, by inertia. */
    void count(std::vector<Problem> &problems, StructuralModes &modes)
    {
      const Stopwatch watch;
      modes.counted = 0;
      for (Problem &problem : problems)
        {
          problem.number = n_negative_eigenvalues(
            linear_combination(
              1., problem.K, -eigenvalue_of(modes.cut_off), problem.M),
            problem.node_of_unknown);
          *modes.counted += *problem.number;
        }
      modes.count_seconds = watch.seconds();
    }

    double orthogonality_of(const DenseMatrix           &X,
                            const SymmetricSparseMatrix &M)
    {
      const DenseMatrix G = projected(M, X);
      return G.size() == 0 ? 0.
                           : (G - DenseMatrix::Identity(G.rows(), G.cols()))
                               .cwiseAbs()
                               .maxCoeff();
    }

    /** Find them; adds to what the search of all took. */
    EigenPairs modes_of(const Problem      &problem,
                        const double        shift,
                        const ModeControls &controls,
                        StructuralModes    &modes)
    {
      const Stopwatch              watch;
      const auto                  &K = problem.K, &M = problem.M;
      const Factorisation         *factor = problem.factor;
      const auto                  &number = problem.number;
      std::optional<Factorisation> own;
      if (factor == nullptr)
        {
          own.emplace(shift > 0. ? linear_combination(1., K, shift, M) : K,
                      problem.node_of_unknown);
          own->factorise();
          factor = &*own;
        }
      LanczosControls lanczos;
      lanczos.largest    = eigenvalue_of(controls.cut_off);
      lanczos.shift      = shift;
      lanczos.tolerance  = sharper * controls.tolerance;
      lanczos.block_size = controls.block_size;
      lanczos.number     = number;
      lanczos.interrupt  = controls.interrupt;
      EigenPairs pairs   = block_lanczos(*factor, M, lanczos);
      if (number && *number != pairs.values.size())
        throw ConvergenceError(
          "Of " + std::to_string(*number) + " modes below " +
          significant(modes.cut_off, 6) +
          " Hz, counted by the inertia of K - omega^2 M, " +
          std::to_string(pairs.values.size()) +
          " were found. A mode may lie at that frequency: change Modes/Maximum "
          "frequency or Cut-off ratio a little.");
      modes.n_solves += pairs.n_solves;
      modes.n_basis = std::max(modes.n_basis, pairs.n_basis);
      modes.basis_bytes =
        std::max(modes.basis_bytes, pairs.n_basis * K.size() * sizeof(double));
      modes.orthogonality =
        std::max(modes.orthogonality, orthogonality_of(pairs.vectors, M));
      modes.lanczos_seconds += watch.seconds();
      return pairs;
    }

    /** Residual of each mode, of K and M of the whole structure. */
    void examine(const SymmetricSparseMatrix &K,
                 const SymmetricSparseMatrix &M,
                 StructuralModes             &modes)
    {
      const std::size_t   n = K.size();
      std::vector<double> Kphi(n), Mphi(n);
      for (std::size_t j = 0; j < modes.size(); ++j)
        {
          const std::vector<double> phi = column_of(modes.shapes, j);
          K.multiply(phi, Kphi);
          M.multiply(phi, Mphi);
          const double lambda = modes.eigenvalue(j),
                       scale  = modes.frequencies[j] < rigid * modes.cut_off
                                  ? eigenvalue_of(modes.cut_off)
                                  : lambda;
          modes.residuals.push_back(norm(sum(Kphi, -lambda, Mphi)) /
                                    norm(Mphi) / scale);
        }
    }

    /** Modes of several spaces by ascending frequency, as shapes of the whole.
     */
    void merge(const std::vector<InvariantSubspace> &spaces,
               const std::vector<EigenPairs>        &parts,
               const std::size_t                     n_unknowns,
               StructuralModes                      &modes)
    {
      std::vector<std::array<std::size_t, 2>> order;
      for (std::size_t p = 0; p < parts.size(); ++p)
        for (std::size_t k = 0; k < parts[p].values.size(); ++k)
          order.push_back({{p, k}});
      std::stable_sort(order.begin(),
                       order.end(),
                       [&](const auto &a, const auto &b) {
                         return parts[a[0]].values[a[1]] <
                                parts[b[0]].values[b[1]];
                       });
      modes.shapes = DenseMatrix::Zero(n_unknowns, order.size());
      modes.at_rest.resize(n_unknowns, 0);
      for (std::size_t j = 0; j < order.size(); ++j)
        {
          const auto [p, k] = order[j];
          modes.frequencies.push_back(
            std::sqrt(std::max(0., parts[p].values[k])) / (2 * pi));
          spaces[p].extend(parts[p].vectors, k, modes.shapes, j);
        }
    }
  } // namespace

  double StructuralModes::eigenvalue(const std::size_t j) const
  {
    return eigenvalue_of(frequencies[j]);
  }

  DenseMatrix StructuralModes::statics(const DenseMatrix &motions,
                                       const DenseMatrix &motions_at_rest,
                                       const double       shift) const
  {
    DenseMatrix result                      = motions;
    result.leftCols(motions_at_rest.cols()) = motions_at_rest;
    for (Eigen::Index j = motions_at_rest.cols(); j < motions.cols(); ++j)
      result.col(j) /= std::sqrt(eigenvalue(j) + shift);
    return result;
  }

  void StructuralModes::find_at_rest(const SymmetricSparseMatrix &K,
                                     const SymmetricSparseMatrix &M,
                                     const Factorisation         &factor,
                                     const double                 shift,
                                     const double                 highest)
  {
    const auto n =
      std::upper_bound(frequencies.begin(), frequencies.end(), highest) -
      frequencies.begin();
    at_rest = times(M, DenseMatrix(shapes.leftCols(n)));
    factor.solve(at_rest);
    DenseMatrix energy = projected(K, at_rest);
    if (shift > 0.)
      energy += shift * projected(M, at_rest);
    const Eigen::LLT<DenseMatrix> root(energy);
    root.matrixU().solveInPlace<Eigen::OnTheRight>(at_rest);
  }

  double shift_of_free_body(const double cut_off)
  {
    return eigenvalue_of(cut_off / 50);
  }

  StructuralModes
  structural_modes(const SymmetricSparseMatrix     &K,
                   const SymmetricSparseMatrix     &M,
                   const Factorisation             &factor,
                   const double                     shift,
                   const std::vector<unsigned int> &node_of_unknown,
                   const ModeControls              &controls,
                   const std::vector<Reflection>   &reflections)
  {
    StructuralModes modes;
    modes.cut_off     = controls.cut_off;
    const auto spaces = invariant_subspaces(reflections, K.size());
    modes.n_subspaces = spaces.size();
    std::vector<Restricted> restricted;
    std::vector<Problem>    problems;
    if (spaces.size() == 1)
      problems.push_back({K, M, node_of_unknown, &factor, {}});
    else
      for (const InvariantSubspace &space : spaces)
        restricted.push_back({space.restricted(K),
                              space.restricted(M),
                              space.nodes_of_columns(node_of_unknown)});
    for (const Restricted &part : restricted)
      problems.push_back({part.K, part.M, part.node_of_unknown, nullptr, {}});
    if (controls.count)
      {
        count(problems, modes);
        controls.counted(*modes.counted);
      }
    std::vector<EigenPairs> parts;
    for (const Problem &problem : problems)
      parts.push_back(modes_of(problem, shift, controls, modes));
    merge(spaces, parts, K.size(), modes);
    examine(K, M, modes);
    return modes;
  }
} // namespace RollingContact
