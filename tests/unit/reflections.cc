#include <boost/test/unit_test.hpp>

#include "ring_with_dampers.h"
#include "springs.h"

#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/algebra/reflection.h>
#include <rolling_contact/mesh/shape_parameters.h>
#include <rolling_contact/modes/body_reflections.h>
#include <rolling_contact/modes/structural_modes.h>

#include <cmath>
#include <utility>

using namespace RollingContact;
using namespace SpringStructures;

BOOST_AUTO_TEST_SUITE(reflections)

namespace
{
  /** Across the middle of each side of a line, square or cube. */
  std::vector<Reflection> reflections_of(const Springs &springs)
  {
    std::vector<Reflection> result;
    const std::size_t       n      = springs.n;
    std::size_t             stride = 1;
    for (unsigned int d = 0; d < springs.dimensions; ++d, stride *= n)
      {
        Reflection R;
        for (std::size_t i = 0; i < springs.K.size(); ++i)
          {
            const std::size_t at = (i / stride) % n;
            R.image.push_back(i - at * stride + (n - 1 - at) * stride);
            R.sign.push_back(1.);
          }
        result.push_back(R);
      }
    return result;
  }

  DenseMatrix dense(const SymmetricSparseMatrix &A)
  {
    DenseMatrix result = DenseMatrix::Zero(A.size(), A.size());
    for (std::size_t j = 0; j < A.size(); ++j)
      for (std::int64_t k = A.column_starts[j]; k < A.column_starts[j + 1]; ++k)
        result(A.row_indices[k], j) = result(j, A.row_indices[k]) = A.values[k];
    return result;
  }

  std::vector<double> image_of(const Reflection &R, const double *x)
  {
    std::vector<double> result(R.image.size());
    for (std::size_t i = 0; i < result.size(); ++i)
      result[R.image[i]] = R.sign[i] * x[i];
    return result;
  }

  /** Modes of a body in parts and as a whole. */
  struct BothWays
  {
    BothWays(const std::shared_ptr<const BodyShape> &shape,
             const BodyModel                        &model,
             const Grading<3>                       &grading,
             const double                            cut_off)
      : body(shape, Material{210e9, 0.3, 7850.}, 0.1, grading, true, model)
      , K(body.stiffness())
      , M(body.mass())
      , planes(body_reflections(BodyPlaces(body), K, M))
    {
      Factorisation factor(K, body.nodes_of_unknowns());
      factor.factorise();
      ModeControls controls;
      controls.cut_off = cut_off;
      whole =
        structural_modes(K, M, factor, 0., body.nodes_of_unknowns(), controls);
      parts = structural_modes(
        K, M, factor, 0., body.nodes_of_unknowns(), controls, planes);
    }

    void check() const
    {
      BOOST_TEST_REQUIRE(parts.size() == whole.size());
      BOOST_TEST(*parts.counted == whole.size());
      for (std::size_t j = 0; j < whole.size(); ++j)
        {
          BOOST_TEST(parts.frequencies[j] == whole.frequencies[j],
                     boost::test_tools::tolerance(1e-9));
          BOOST_TEST(parts.residuals[j] < 1e-8);
        }
      BOOST_TEST(parts.orthogonality < 1e-12);
      const DenseMatrix G = projected(M, parts.shapes);
      BOOST_TEST(
        (G - DenseMatrix::Identity(G.rows(), G.cols())).cwiseAbs().maxCoeff() <
        1e-12);
    }

    /** Each shape is even or odd across each plane, and both are there. */
    void check_parity() const
    {
      for (const Reflection &R : planes)
        {
          unsigned int n_even = 0, n_odd = 0;
          for (std::size_t j = 0; j < parts.size(); ++j)
            {
              const double *x     = parts.shapes.data() + j * K.size();
              const auto    image = image_of(R, x);
              double        even = 0., odd = 0., size = 0.;
              for (std::size_t i = 0; i < image.size(); ++i)
                {
                  even = std::max(even, std::abs(image[i] - x[i]));
                  odd  = std::max(odd, std::abs(image[i] + x[i]));
                  size = std::max(size, std::abs(x[i]));
                }
              BOOST_TEST(std::min(even, odd) < 1e-14 * size);
              ++(even < odd ? n_even : n_odd);
            }
          BOOST_TEST(n_even > 2u);
          BOOST_TEST(n_odd > 2u);
        }
    }

    DirectBody<3>           body;
    SymmetricSparseMatrix   K, M;
    std::vector<Reflection> planes;
    StructuralModes         whole, parts;
  };

  std::shared_ptr<const BodyShape> block(const Hub hub)
  {
    ShapeParameters parameters;
    parameters.radius       = 0.;
    parameters.block_length = 1.2;
    parameters.block_depth  = 0.15;
    parameters.width        = 0.1;
    parameters.hub          = hub;
    return make_body_shape("block", parameters);
  }

  BodyModel on_sleepers()
  {
    BodyModel model;
    model.foundation.stiffness         = {{2e8, 3e8, 5e8}};
    model.foundation.pad_spacing       = 0.4;
    model.foundation.pad_length        = 0.11;
    model.foundation.sleeper_mass      = 120.;
    model.foundation.ballast_stiffness = {{3e7, 4e7, 6e7}};
    return model;
  }
} // namespace

/** Eigenvalues of K restricted to each space are those of K, each once; an odd
 * number of places has some in the planes. */
BOOST_AUTO_TEST_CASE(spaces_have_the_eigenvalues_of_the_whole)
{
  for (const unsigned int n : {4u, 5u})
    {
      const Springs springs(n, 3, true);
      const auto    planes = reflections_of(springs);
      const auto    spaces = invariant_subspaces(planes, springs.K.size());
      std::vector<double> found;
      std::size_t         size = 0;
      BOOST_TEST(spaces.size() == 8u);
      for (const InvariantSubspace &space : spaces)
        {
          DenseMatrix K = dense(space.restricted(springs.K));
          for (const double value : symmetric_eigenpairs(K))
            found.push_back(value / springs.mass);
          size += space.size();
          const auto M = space.restricted(springs.M);
          BOOST_TEST(M.values.size() == space.size());
          for (const double m : M.values)
            BOOST_TEST(m == springs.mass, boost::test_tools::tolerance(1e-14));
        }
      BOOST_TEST(size == springs.K.size());
      std::sort(found.begin(), found.end());
      const auto exact = springs.eigenvalues();
      for (std::size_t j = 0; j < exact.size(); ++j)
        BOOST_TEST(found[j] == exact[j], boost::test_tools::tolerance(1e-12));
    }
}

BOOST_AUTO_TEST_CASE(all_modes_of_a_cube_are_found_in_its_parts)
{
  const Springs springs(9, 3, true);
  const auto    exact   = springs.eigenvalues();
  const double  largest = gap_after(exact, 150);
  ModeControls  controls;
  controls.cut_off = frequency(largest);
  const auto modes = structural_modes(springs.K,
                                      springs.M,
                                      springs.factor(0.),
                                      0.,
                                      springs.nodes,
                                      controls,
                                      reflections_of(springs));
  const auto n =
    std::upper_bound(exact.begin(), exact.end(), largest) - exact.begin();
  BOOST_TEST(modes.n_subspaces == 8u);
  BOOST_TEST(*modes.counted == static_cast<std::size_t>(n));
  BOOST_TEST_REQUIRE(modes.size() == static_cast<std::size_t>(n));
  for (std::size_t j = 0; j < modes.size(); ++j)
    {
      BOOST_TEST(modes.eigenvalue(j) == exact[j],
                 boost::test_tools::tolerance(1e-11));
      BOOST_TEST(modes.residuals[j] < 1e-8);
    }
  BOOST_TEST(modes.orthogonality < 1e-12);
}

/** A matrix is off by what one of its entries is changed, over the diagonal. */
BOOST_AUTO_TEST_CASE(what_is_no_mirror_image_is_measured)
{
  const Springs springs(4, 2, true);
  const auto    R = reflections_of(springs)[0];
  BOOST_TEST(asymmetry(springs.K, R) == 0.);
  auto K = springs.K;
  K.values[K.column_starts[5]] *= 1.01;
  BOOST_TEST(asymmetry(K, R) == 0.01, boost::test_tools::tolerance(1e-10));
  K = springs.K;
  K.values[K.column_starts[5] + 2] += 0.1; // along the plane; 4 on diagonals
  BOOST_TEST(asymmetry(K, R) == 0.1 / 4, boost::test_tools::tolerance(1e-10));
  auto turned    = R;
  turned.sign[0] = turned.sign[3] = -1.;
  BOOST_TEST(asymmetry(springs.K, turned) == 2. / 4,
             boost::test_tools::tolerance(1e-10));
}

/** A wheel is its own mirror image along and across, and where the section is
 * even along its axle. */
BOOST_AUTO_TEST_CASE(a_wheel_vibrates_in_parts_as_it_does_whole)
{
  const ScratchFolder scratch;
  const BodySpec      ring = RingWithDampers::stout_ring(scratch.scratch);
  const BothWays      both(ring.body_shape(),
                      ring.model,
                      Grading<3>::unrefined(),
                      25000.);
  BOOST_TEST(both.planes.size() == 3u);
  BOOST_TEST(both.parts.n_subspaces == 8u);
  both.check();
  both.check_parity();
}

/** Sleepers are mirrored with the pads that tie them. */
BOOST_AUTO_TEST_CASE(a_rail_on_sleepers_vibrates_in_parts_as_it_does_whole)
{
  const auto     cells = Grading<3>::uniform(0.05, 0.05);
  const BothWays both(block(Hub::elastic), on_sleepers(), cells, 4000.);
  BOOST_TEST(both.planes.size() == 2u); // not across the height
  both.check();
  both.check_parity();
}

BOOST_AUTO_TEST_CASE(bodies_that_are_not_even_are_not_taken_for_it)
{
  const auto cells            = Grading<3>::uniform(0.05, 0.05);
  BodyModel  model            = on_sleepers();
  model.foundation.pad_offset = 0.1;
  const BothWays shifted(block(Hub::elastic), model, cells, 3000.);
  BOOST_TEST(shifted.planes.size() == 1u);
  shifted.check();
  BodyModel axle;
  axle.hub_mass = {300., {{40., 12., 40.}}};
  const DirectBody<3> hung(
    block(Hub::mass), Material{210e9, 0.3, 7850.}, 0.1, cells, true, axle);
  BOOST_TEST(
    body_reflections(BodyPlaces(hung), hung.stiffness(), hung.mass()).empty());

  // small elements on one side, and as many on both
  Grading<3> grading;
  grading.element_size_x = grading.element_size_y = 0.02;
  grading.zone_x = grading.zone_y = 0.04;
  grading.zone_depth              = 0.02;
  grading.growth                  = 0.7;
  grading.upstream                = -1;
  for (const auto &[it, n_planes] :
       {std::make_pair(grading, 1u),
        std::make_pair(grading.of_coupled_body(), 2u)})
    {
      const DirectBody<3> body(
        block(Hub::clamped), Material{210e9, 0.3, 7850.}, 0.1, it, true, {});
      BOOST_TEST(
        body_reflections(BodyPlaces(body), body.stiffness(), body.mass())
          .size() == n_planes);
    }
}

BOOST_AUTO_TEST_SUITE_END()
