#include <rolling_contact/algebra/factorisation.h>
#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/modes/structural_modes.h>
#include <rolling_contact/modes/waveguide.h>
#include <rolling_contact/modes/waveguide_response.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    using Complex = std::complex<double>;

    /// wave numbers of the fields, over that of shear waves of the highest
    /// frequency
    const std::array<double, 6> shares_of_shear{{0., 0.125, 0.25, 0.5, 1., 2.}};

    /// of the largest, below which what fields add to others is left out
    const double least_amplitude = 1e-3;

    /// motions of a section that stays as it is
    const Eigen::Index n_rigid = 6;

    /// of the stiffest, below which springs of a pad are left out
    const double least_spring = 1e-3;

    /// of the real part, above which the imaginary one tells a wave's way
    const double clearly_fading = 0.3;

    /// of a shear wave, the longest edge of a quadrilateral
    const double edges_in_wave = 0.25;

    SectionMesh divided_for(const StraightBody &body, const double highest)
    {
      const double wave =
        std::sqrt(body.material.shear_modulus() / body.material.density) /
        highest;
      return body.shape.section.divided(edges_in_wave * wave);
    }

    SymmetricSparseMatrix sum_of(const double                 a,
                                 const SymmetricSparseMatrix &A,
                                 const double                 b,
                                 const SymmetricSparseMatrix &B)
    {
      SymmetricSparseMatrix result = A;
      as_vector(result.values) =
        a * as_vector(A.values) + b * as_vector(B.values);
      return result;
    }
  } // namespace

  struct Waveguide::Section
  {
    /** @p unit: a wave number, 1/m, with which K is taken apart. */
    Section(const HarmonicSection       &section,
            const std::array<double, 3> &stiffness,
            const double                 unit)
    {
      std::tie(K_0, M)  = section.matrices(0.);
      const auto ahead  = section.matrices(unit).first,
                 behind = section.matrices(-unit).first;
      K_1               = sum_of(0.5 / unit, ahead, -0.5 / unit, behind);
      K_2 = sum_of(0.5 / (unit * unit), ahead, 0.5 / (unit * unit), behind);
      K_2 = sum_of(1., K_2, -1 / (unit * unit), K_0);
      K_s = section.springs(stiffness);
    }

    SymmetricSparseMatrix at(const double k) const
    {
      return sum_of(1.,
                    sum_of(1., sum_of(1., K_0, 1., K_s), k, K_1),
                    k * k,
                    K_2);
    }

    SymmetricSparseMatrix K_0, K_1, K_2, K_s, M;
  };

  Waveguide::Waveguide(const StraightBody          &body,
                       const double                 highest,
                       const std::vector<Place>    &loaded,
                       const std::function<void()> &interrupt,
                       const unsigned int           degree)
    : placement(body.shape.placement)
    , section(divided_for(body, highest),
              body.material,
              false,
              degree,
              HarmonicSection::Axis::straight)
    , damping(body.damping)
    , springs(body.foundation)
  {
    const double shear =
      2 * pi * highest *
      std::sqrt(body.material.density / body.material.shear_modulus());
    const auto   &across = body.foundation.stiffness;
    const Section whole(section, {{across[1], across[2], across[0]}}, shear);

    std::vector<DenseMatrix> found;
    ModeControls             controls;
    controls.cut_off   = highest;
    controls.count     = true;
    controls.interrupt = interrupt;
    const double shift = shift_of_free_body(highest);
    DenseMatrix  loads =
      DenseMatrix::Zero(section.nodes_of_unknowns().size(), 3 * loaded.size());
    for (std::size_t p = 0; p < loaded.size(); ++p)
      {
        const auto point = placement.to_section(loaded[p]);
        const auto parts = section.at(point[0], point[1]);
        for (std::size_t j = 0; j < parts.weights.size(); ++j)
          for (unsigned int a = 0; a < 3; ++a)
            loads(parts.unknowns[j][a], 3 * p + a) += parts.weights[j];
      }
    found.push_back(rigid_motions());
    for (const double share : shares_of_shear)
      {
        interrupt();
        const SymmetricSparseMatrix K = whole.at(share * shear);
        Factorisation factor(linear_combination(1., K, shift, whole.M),
                             section.nodes_of_unknowns());
        factor.factorise();
        found.push_back(
          structural_modes(
            K, whole.M, factor, shift, section.nodes_of_unknowns(), controls)
            .shapes);
        DenseMatrix at_rest(loads.rows(), loads.cols() + n_rigid);
        at_rest << loads, times(whole.K_s, found.front());
        factor.solve(at_rest);
        found.push_back(std::move(at_rest));
      }
    reduce(whole, found);
  }

  void Waveguide::reduce(const Section                  &whole,
                         const std::vector<DenseMatrix> &found)
  {
    Eigen::Index n_found = 0;
    for (const DenseMatrix &some : found)
      n_found += some.cols();
    const Eigen::Index n = whole.M.size();
    DenseMatrix        along(n, n_found), across(n, n_found);
    Eigen::Index       next = 0;
    for (const DenseMatrix &some : found)
      {
        along.middleCols(next, some.cols())  = some;
        across.middleCols(next, some.cols()) = some;
        next += some.cols();
      }
    for (Eigen::Index i = 0; i < n; ++i)
      (i % 3 == 2 ? across : along).row(i).setZero();
    const SymmetricSparseMatrix energy      = whole.at(0.);
    const auto                  independent = [&](DenseMatrix X) {
      for (Eigen::Index j = 0; j < X.cols(); ++j)
        {
          const double size = std::sqrt(
            X.col(j).dot(times(energy, DenseMatrix(X.col(j))).col(0)));
          X.col(j) *= size > 0. ? 1 / size : 0.;
        }
      DenseMatrix               gram = projected(energy, X);
      const std::vector<double> values = symmetric_eigenpairs(gram);
      const Eigen::Index        kept =
        values.end() -
        std::lower_bound(values.begin(),
                         values.end(),
                         least_amplitude * least_amplitude * values.back());
      DenseMatrix result = X * gram.rightCols(kept);
      for (Eigen::Index j = 0; j < kept; ++j)
        result.col(j) /= std::sqrt(values[values.size() - kept + j]);
      return result;
    };
    const DenseMatrix t = independent(std::move(along)),
                      y = independent(std::move(across));
    fields.resize(n, t.cols() + y.cols());
    fields << t, y;
    sizes = {std::size_t(n), std::size_t(t.cols()), std::size_t(y.cols())};
    across_alone = DenseMatrix::Zero(n, fields.cols());
    for (Eigen::Index i = 0; i < n; i += 3)
      across_alone.row(i) = fields.row(i);
    across_alone = projected(whole.M, across_alone);
    matrices     = {projected(whole.K_0, fields),
                    projected(whole.K_1, fields),
                    projected(whole.K_2, fields),
                    projected(whole.K_s, fields),
                    projected(whole.M, fields)};
    if (has_pads())
      find_pads(whole);
    DenseMatrix leading = matrices.K_2;
    leading.bottomLeftCorner(sizes.n_across, sizes.n_along) =
      matrices.K_1.bottomLeftCorner(sizes.n_across, sizes.n_along);
    solved = DenseMatrix::Identity(leading.rows(), leading.rows());
    if (!solve_general(leading, solved))
      throw ConvergenceError("The fields of a section that waves are made of "
                             "depend on each other.");
  }

  DenseMatrix Waveguide::rigid_motions() const
  {
    const auto &nodes  = section.nodes_of_unknowns();
    const auto  at     = section.places();
    DenseMatrix result = DenseMatrix::Zero(nodes.size(), n_rigid);
    for (std::size_t i = 0; i < nodes.size(); i += 3)
      {
        const auto [y, z] = at[nodes[i]];
        result(i, 0) = result(i + 1, 1) = result(i + 2, 2) = 1.;
        result(i, 3)                                       = -z; // about x
        result(i + 1, 3)                                   = y;
        result(i + 2, 4) = z; // the section turns about y and z
        result(i + 2, 5) = y;
      }
    return result;
  }

  void Waveguide::find_pads(const Section &whole)
  {
    DenseMatrix               shapes = matrices.K_s;
    const std::vector<double> values = symmetric_eigenpairs(shapes);
    const Eigen::Index        n =
      values.end() - std::lower_bound(values.begin(),
                                      values.end(),
                                      least_spring * values.back());
    pad_springs.stiffness = as_vector(values).tail(n);
    pad_springs.shapes    = shapes.rightCols(n).transpose();
    pad_springs.translations =
      pad_springs.stiffness.cwiseInverse().asDiagonal() * pad_springs.shapes *
      fields.transpose() *
      times(whole.K_s,
            DenseMatrix(rigid_motions()(Eigen::all, std::array{2, 0, 1})));
    for (const double way : {-1., 1.}) // the points of Gauss
      pad_springs.lines.push_back(
        springs.pad_offset + way * springs.pad_length / (2 * std::sqrt(3.)));
  }

  bool Waveguide::leaves(const Wave &wave, const Complex s) const
  {
    const Complex k = wave.wavenumber;
    if (std::abs(k.imag()) > clearly_fading * std::abs(k.real()))
      return k.imag() < 0.;
    // where a vibration grows, what leaves fades: i dk / ds
    const Complex inertia =
      (2. * s + damping.mass_damping) *
      Complex((wave.received.transpose() * (matrices.M * wave.amplitudes))(0));
    return inertia.real() > 0.;
  }

  Complex Waveguide::stiffening(const Complex s,
                                const double  loss_factor,
                                const double  added_damping) const
  {
    const Complex turned =
      s.imag() == 0. ? Complex(0.) : s / std::abs(s.imag());
    return 1. + turned * (loss_factor + 2 * added_damping) +
           s * damping.stiffness_damping;
  }

  std::vector<Waveguide::Wave>
  Waveguide::waves(const Complex s, const double added_damping) const
  {
    const Complex kappa    = stiffening(s, damping.loss_factor, added_damping);
    const Eigen::Index n_t = sizes.n_along, n_y = sizes.n_across;
    ComplexMatrix A = kappa * matrices.K_0 + rate_of_inertia(s) * matrices.M;
    if (!has_pads())
      A += stiffening(s, springs.loss_factor, added_damping) * matrices.K_s;
    A.topRightCorner(n_t, n_y) = kappa * matrices.K_1.topRightCorner(n_t, n_y);
    A.bottomLeftCorner(n_y, n_t).setZero();
    const Eigenpairs pairs = eigenpairs(ComplexMatrix(-solved * A / kappa));
    // by the inverse of the vectors, as those of waves that are alike mix
    ComplexMatrix   received = solved.cast<Complex>();
    const ComplexLU vectors(pairs.vectors);
    if (vectors.singular())
      throw ConvergenceError("Two waves of a section are one at this "
                             "frequency; take another.");
    vectors.solve(received);
    std::vector<Wave> result;
    for (std::size_t j = 0; j < pairs.values.size(); ++j)
      {
        const Complex k = std::sqrt(pairs.values[j]);
        Wave          wave{k,
                  pairs.vectors.col(j),
                  received.row(j).transpose() / (Complex(0., 2.) * kappa * k)};
        wave.amplitudes.head(n_t) *= k;
        wave.received.head(n_t) /= k;
        if (!leaves(wave, s))
          {
            wave.wavenumber = -k;
            wave.amplitudes.head(n_t) *= -1.;
            wave.received.tail(n_y) *= -1.;
          }
        result.push_back(std::move(wave));
      }
    std::sort(result.begin(), result.end(), [](const Wave &a, const Wave &b) {
      return a.wavenumber.imag() > b.wavenumber.imag();
    });
    return result;
  }

  std::array<double, 3> Waveguide::shares(const Wave &wave) const
  {
    const auto energy = [&](const DenseMatrix &M) {
      return std::real(
        Complex((wave.amplitudes.adjoint() * (M * wave.amplitudes))(0)));
    };
    DenseMatrix along = matrices.M;
    along.bottomRightCorner(sizes.n_across, sizes.n_across).setZero();
    const double all = energy(matrices.M), x = energy(along) / all,
                 y = energy(across_alone) / all;
    return {{x, y, 1. - x - y}};
  }

  const ComplexMatrix &Waveguide::motion_at(const Place &place) const
  {
    const std::lock_guard<std::mutex> lock(learning);
    const auto                        point = placement.to_section(place);
    const auto [known, is_new]              = known_motions.try_emplace(point);
    if (!is_new)
      return known->second;
    const auto  parts   = section.at(point[0], point[1]);
    DenseMatrix motions = DenseMatrix::Zero(3, fields.cols());
    for (std::size_t j = 0; j < parts.weights.size(); ++j)
      for (unsigned int a = 0; a < 3; ++a)
        motions.row(a) += parts.weights[j] * fields.row(parts.unknowns[j][a]);
    ComplexMatrix turned = motions.cast<Complex>();
    turned.row(2) *= Complex(0., 1.);
    DenseMatrix directions(3, 3);
    const auto  rows = placement.directions();
    for (unsigned int c = 0; c < 3; ++c)
      for (unsigned int a = 0; a < 3; ++a)
        directions(c, a) = rows[c][a];
    return known->second = directions * turned;
  }

  ComplexMatrix Waveguide::receptances(const Complex             s,
                                       const std::vector<Place> &places,
                                       const double added_damping) const
  {
    const WaveguideResponse response(*this, s, added_damping);
    ComplexMatrix           alpha(3 * places.size(), 3 * places.size());
    for (std::size_t q = 0; q < places.size(); ++q)
      alpha.middleCols(3 * q, 3) =
        response.field(places, places[q], ComplexMatrix::Identity(3, 3));
    return alpha;
  }
} // namespace RollingContact
