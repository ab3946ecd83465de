#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/modes/measuring_point.h>
#include <rolling_contact/vibration/rail_waves.h>

#include <cmath>
#include <map>

namespace RollingContact
{
  namespace
  {
    using Complex = std::complex<double>;

    /// of the two points that tell translation and turning of the head: m
    const double beside_contact = 5e-3;

    /// of the frequency below which nothing is looked at, where waves are so
    /// slow that the body is at rest; and where samples begin
    const double slow = 0.1, first_sample = 0.2;

    /// samples in an octave to begin with, the closest, of ln f, and what is
    /// left between two of them, over the receptance
    const unsigned int in_octave = 6;
    const double       closest = 6e-4, between = 0.01;

    /// of the highest frequency, up to which modes stand for waves
    const double beyond = 1.2;

    const double fit_tolerance = 0.02;

    /// of the cut-off of the fields that a coarse section is reduced to, and
    /// where it is compared
    const double       fewer_fields = 0.7;
    const unsigned int n_compared = 9, highest_degree = 3;

    /// distances along the rail at which mesh and waves are compared, m, and
    /// the weights of once to five times that: of a quartic at 0
    const double                distance_aside = 0.08;
    const std::array<double, 5> extrapolation{{5., -10., 10., -5., 1.}};

    /// so far beyond the end of a mesh its end stands for a place: m
    const double beside_end = 1e-3;

    const BodySpec &extruded(const BodySpec &body)
    {
      if (body.body_shape()->extruded_section() == nullptr)
        throw InputError(body.section +
                         "/Model = waveguide: this body is not extruded; take "
                         "Shape = section with Radius = 0, or Body sections = "
                         "true.");
      return body;
    }

    /** The four motions by the displacements of both points. */
    DenseMatrix motions_of_points()
    {
      DenseMatrix result = DenseMatrix::Zero(RailWaves::n_motions, 6);
      for (unsigned int c = 0; c < 3; ++c)
        result(c, c) = result(c, 3 + c) = 0.5;
      result(3, 2) = -0.5;
      result(3, 5) = 0.5;
      return result;
    }

    /** How far the middle of three values is from what both others tell. */
    double left_between(const ComplexMatrix &before,
                        const ComplexMatrix &middle,
                        const ComplexMatrix &after)
    {
      double largest = 0.;
      for (Eigen::Index i = 0; i < middle.rows(); ++i)
        {
          const Complex mean = std::sqrt(before(i, i) * after(i, i));
          largest            = std::max(largest,
                             std::min(std::abs(middle(i, i) - mean),
                                      std::abs(middle(i, i) + mean)) /
                               std::abs(middle(i, i)));
        }
      return largest;
    }
  } // namespace

  RailWaves::RailWaves(const BodySpec              &body,
                       const WaveRange             &range,
                       const std::function<void()> &interrupt)
    : body(extruded(body))
    , damping(this->body.model.damping)
    , range(range)
  {
    const auto shape = body.body_shape();
    for (const double y : {-beside_contact, beside_contact})
      places.push_back({{0., y, shape->surface_height(0., y)}});
    waves = waveguide_of(range.cut_off, interrupt, highest_degree);
    // reciprocal, on pads but for what the farthest of them bear
    const DenseMatrix slow_motion = at_contact(at_rest_rate()).real();
    rest                          = (slow_motion + slow_motion.transpose()) / 2;
  }

  std::unique_ptr<const Waveguide>
  RailWaves::waveguide_of(const double                 cut_off,
                          const std::function<void()> &interrupt,
                          const unsigned int           degree) const
  {
    return std::make_unique<const Waveguide>(
      StraightBody{*body.body_shape()->extruded_section(),
                   body.material,
                   body.model.foundation,
                   damping},
      cut_off,
      places,
      interrupt,
      degree);
  }

  double
  RailWaves::lower_degree_error(const std::function<void()> &interrupt) const
  {
    const auto coarse =
      waveguide_of(fewer_fields * range.cut_off, interrupt, highest_degree - 1);
    const DenseMatrix rest_of_coarse =
      coarse->receptances(at_rest_rate(), places).real();
    double largest = 0.;
    for (unsigned int i = 0; i < n_compared; ++i)
      {
        const Complex       s(0.,
                        2 * pi * range.lowest *
                          std::pow(range.highest / range.lowest,
                                   i / (n_compared - 1.)));
        const ComplexMatrix fine  = change(s, places),
                            other = coarse->receptances(s, places) -
                                    rest_of_coarse / stiffening(s);
        largest = std::max(largest,
                           (fine - other).cwiseAbs().maxCoeff() /
                             fine.cwiseAbs().maxCoeff());
      }
    return largest;
  }

  Complex RailWaves::at_rest_rate() const
  {
    return 2 * pi * slow * range.lowest; // real: loss factors do not count
  }

  void RailWaves::require_mesh_around(const std::vector<Place> &at) const
  {
    const double aside = extrapolation.size() * distance_aside,
                 reach = body.body_shape()->reach_x();
    for (const Place &place : at)
      if (const double x = std::abs(place[0]); x + aside > reach + beside_end)
        throw InputError(
          body.section + "/Block length = " + significant(2 * reach, 6) +
          " m: with Model = waveguide the mesh must reach " +
          significant(aside, 3) + " m beyond the contact and each place of " +
          "Receptance/Points; give " + significant(2 * (x + aside), 4) +
          " m or more.");
  }

  DenseMatrix RailWaves::beyond_mesh(const DirectBody<3>      &mesh,
                                     const Factorisation      &factor,
                                     const std::vector<Place> &at) const
  {
    require_mesh_around(at);
    const std::size_t n = 3 * at.size();
    DenseMatrix       moved(mesh.n_unknowns(), n);
    for (std::size_t i = 0; i < n; ++i)
      moved.col(i) = as_vector(
        MeasuringPoint(mesh, at[i / 3], 0.).load(i % 3, mesh.n_unknowns()));
    factor.solve(moved);
    const WaveguideResponse response(*waves, at_rest_rate());
    DenseMatrix             difference = DenseMatrix::Zero(n, n);
    for (unsigned int i = 0; i < extrapolation.size(); ++i)
      for (const double way : {-1., 1.})
        {
          std::vector<Place> aside = at;
          for (Place &place : aside)
            place[0] += way * (i + 1) * distance_aside;
          DenseMatrix here(n, n);
          for (std::size_t q = 0; q < at.size(); ++q)
            here.middleCols(3 * q, 3) =
              response.field(aside, at[q], ComplexMatrix::Identity(3, 3))
                .real();
          for (std::size_t p = 0; p < at.size(); ++p)
            {
              const MeasuringPoint point(mesh, aside[p], 0.);
              for (unsigned int c = 0; c < 3; ++c)
                for (std::size_t q = 0; q < n; ++q)
                  here(3 * p + c, q) -= point.motion(c, moved.col(q).data());
            }
          difference += extrapolation[i] / 2 * here;
        }
    return (difference + difference.transpose()) / 2;
  }

  DenseMatrix RailWaves::beyond_mesh(const DirectBody<3> &mesh,
                                     const Factorisation &factor) const
  {
    const DenseMatrix motions = motions_of_points();
    return motions * beyond_mesh(mesh, factor, places) * motions.transpose();
  }

  ComplexMatrix RailWaves::change(const Complex             s,
                                  const std::vector<Place> &at) const
  {
    const auto [known, is_new] = known_rest.try_emplace(at);
    if (is_new)
      known->second = waves->receptances(at_rest_rate(), at).real();
    return waves->receptances(s, at) - known->second / stiffening(s);
  }

  ComplexMatrix RailWaves::at_contact(const Complex s,
                                      const double  added_damping) const
  {
    const DenseMatrix motions = motions_of_points();
    return motions * waves->receptances(s, places, added_damping) *
           motions.transpose();
  }

  void RailWaves::find_modes(const std::function<void()> &interrupt)
  {
    const DenseMatrix near =
      at_contact(Complex(0., 2 * pi * beyond * range.highest)).real();
    std::map<double, ComplexMatrix> found; // by ln f
    const auto at = [&](const double ln_f) -> const ComplexMatrix & {
      const auto [place, is_new] = found.try_emplace(ln_f);
      if (is_new)
        {
          // what is near the contact loses as the compliance beyond modes does
          const Complex s(0., 2 * pi * std::exp(ln_f));
          place->second =
            at_contact(s) +
            near * (1. / (1. + s * damping.retardation()) - 1. / stiffening(s));
        }
      return place->second;
    };
    const double begin   = std::log(first_sample * range.lowest),
                 length  = std::log(beyond * range.highest) - begin;
    const unsigned int n = std::ceil(in_octave * length / std::log(2.));
    std::vector<std::array<double, 2>> open;
    for (unsigned int i = 0; i < n; ++i)
      open.push_back({{begin + i * length / n, begin + (i + 1) * length / n}});
    while (!open.empty())
      {
        interrupt();
        const auto [a, b] = open.back();
        open.pop_back();
        if (b - a < closest)
          continue;
        const double middle = (a + b) / 2;
        if (left_between(at(a), at(middle), at(b)) > between)
          {
            open.push_back({{a, middle}});
            open.push_back({{middle, b}});
          }
      }
    std::vector<double>        frequencies;
    std::vector<ComplexMatrix> receptances;
    for (const auto &[ln_f, alpha] : found)
      {
        frequencies.push_back(std::exp(ln_f));
        receptances.push_back(alpha);
      }
    sampled = frequencies.size();
    ModalFitControls controls;
    controls.lowest      = range.lowest;
    controls.tolerance   = fit_tolerance;
    controls.retardation = damping.retardation();
    controls.interrupt   = interrupt;
    fit                  = fit_modes(frequencies, receptances, controls);
  }

  ComplexMatrix RailWaves::change(const Complex s,
                                  const double  added_damping) const
  {
    return at_contact(s, added_damping) - rest / stiffening(s, added_damping);
  }

  DenseMatrix RailWaves::motions_at(const Place &point) const
  {
    DenseMatrix result = DenseMatrix::Zero(3, n_motions);
    result.leftCols(3).setIdentity();
    // turning about x
    result(1, 3) = -point[2] / beside_contact;
    result(2, 3) = point[1] / beside_contact;
    return result;
  }

  ComplexMatrix RailWaves::field(const Complex             s,
                                 const std::vector<Place> &at) const
  {
    return field(WaveguideResponse(*waves, s),
                 at,
                 motions_of_points().transpose().cast<Complex>());
  }

  ComplexMatrix RailWaves::field(const WaveguideResponse  &response,
                                 const std::vector<Place> &at,
                                 const ComplexMatrix      &forces) const
  {
    return response.field(at, places[0], forces.topRows(3)) +
           response.field(at, places[1], forces.bottomRows(3));
  }

  std::vector<ComplexMatrix>
  RailWaves::integrals(const Complex                     s,
                       const std::vector<ComplexMatrix> &forms,
                       const double                      added_damping) const
  {
    const DenseMatrix on_points = motions_of_points().transpose();
    return WaveguideResponse(*waves, s, added_damping)
      .integrals(places[0][0],
                 waves->motion_at(places[0]).adjoint() * on_points.topRows(3) +
                   waves->motion_at(places[1]).adjoint() *
                     on_points.bottomRows(3),
                 forms);
  }

  DenseMatrix RailWaves::shapes(const std::vector<Place> &at) const
  {
    DenseMatrix result(3 * at.size(), fit.frequencies.size());
    for (std::size_t j = 0; j < fit.frequencies.size(); ++j)
      {
        const Complex   s(0., 2 * pi * fit.frequencies[j]);
        const ComplexLU here(at_contact(s));
        ComplexMatrix   forces = fit.motions.col(j).cast<Complex>();
        here.solve(forces);
        forces        = motions_of_points().transpose() * forces;
        result.col(j) = field(WaveguideResponse(*waves, s), at, forces).real();
      }
    return result;
  }
} // namespace RollingContact
