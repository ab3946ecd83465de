#include <boost/test/unit_test.hpp>

#include "wheel_frequencies.h"

#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/modes/harmonic_modes.h>
#include <rolling_contact/modes/harmonic_section.h>
#include <rolling_contact/modes/mode_character.h>
#include <rolling_contact/references/bracketed_root.h>
#include <rolling_contact/scene/body_parameters.h>

#include <algorithm>
#include <cmath>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(harmonic_modes)

namespace
{
  BodySpec section(const std::string &file,
                   const Hub          hub         = Hub::clamped,
                   const unsigned int cells_along = 48)
  {
    BodyParameters parameters("Wheel");
    parameters.shape          = "section";
    parameters.mesh_file      = file;
    parameters.radius         = 0.46;
    parameters.cells_along    = cells_along;
    parameters.hub            = hub;
    parameters.model.elements = ElementKind::enhanced;
    parameters.material       = {210e9, 0.3, 7850.};
    BodySpec spec(parameters);
    spec.read_mesh(3, std::string(TEST_DATA) + "/../../prm/sections");
    return spec;
  }

  BodySpec disc(const double width)
  {
    BodyParameters parameters("Wheel");
    parameters.shape          = "disc";
    parameters.radius         = 0.46;
    parameters.hub_radius     = 0.12;
    parameters.lateral_radius = 0.3;
    parameters.width          = width;
    parameters.material       = {210e9, 0.3, 7850.};
    return BodySpec(parameters);
  }

  /** The modes of a body at the nodes of its mesh. */
  struct ByHarmonics
  {
    ByHarmonics(const BodySpec &spec,
                const double    cut_off,
                const double    size = 0.)
      : body(spec.body_shape(),
             spec.material,
             spec.thickness,
             size > 0. ? Grading<3>::uniform(size, size)
                       : Grading<3>::unrefined(),
             true,
             spec.model)
      , places(body)
      , axle(*spec.body_shape()->axle())
    {
      ModeControls controls;
      controls.cut_off          = cut_off;
      std::tie(modes, accuracy) = RollingContact::harmonic_modes(
        {*spec.body_shape()->section_about_axle(),
         axle,
         spec.material,
         spec.hub == Hub::clamped},
        places,
        body.n_unknowns(),
        controls);
      characters = mode_characters(places, axle, modes);
    }

    std::vector<double> with_diameters(const unsigned int n) const
    {
      std::vector<double> result;
      for (std::size_t j = 0; j < modes.size(); ++j)
        if (characters[j].nodal_diameters == n &&
            !(characters[j].partner && *characters[j].partner < j))
          result.push_back(modes.frequencies[j]);
      return result;
    }

    DirectBody<3>              body;
    BodyPlaces                 places;
    Axle                       axle;
    StructuralModes            modes;
    HarmonicAccuracy           accuracy;
    std::vector<ModeCharacter> characters;
  };
} // namespace

/** Within the section it interpolates, beside it the place is told. */
BOOST_AUTO_TEST_CASE(a_place_beside_the_section_is_refused)
{
  const BodySpec        spec = disc(0.1); // from radius 0.12 to 0.46 m
  const HarmonicSection section(*spec.body_shape()->section_about_axle(),
                                spec.material,
                                true,
                                2);
  double                sum = 0.;
  for (const double weight : section.at(0.01, 0.3).weights)
    sum += weight;
  BOOST_TEST(sum == 1., boost::test_tools::tolerance(1e-12));
  BOOST_CHECK_EXCEPTION(
    section.at(0.01, 0.52), InputError, [](const InputError &error) {
      const std::string said = error.what();
      return said.find("0.01 m across and 0.52 m outwards") !=
               std::string::npos &&
             said.find("Take Model = mesh") != std::string::npos;
    });
}

/** The reference knows no more of sharp corners: with finer cells there the
 * frequencies fall by up to 7e-4 below those here. */
BOOST_AUTO_TEST_CASE(a_wheel_has_its_frequencies_to_a_thousandth)
{
  const ByHarmonics wheel(section("wheel_2.msh"), 5800.);
  double            mean = 0., largest = 0.;
  unsigned int      count = 0;
  for (const auto &[n, exact] : frequencies_of_wheel_2())
    {
      const auto computed = wheel.with_diameters(n);
      BOOST_TEST_REQUIRE(computed.size() >= exact.size());
      for (std::size_t k = 0; k < exact.size(); ++k)
        {
          const double error = std::abs(computed[k] / exact[k] - 1);
          mean += error;
          ++count;
          largest = std::max(largest, error);
        }
    }
  mean /= count;
  BOOST_TEST_MESSAGE("mean " << mean << ", largest " << largest
                             << ", said to be within "
                             << wheel.accuracy.lower_degree_error);
  BOOST_TEST(count == 32u);
  BOOST_TEST(mean < 5e-4);
  BOOST_TEST(largest < 2e-3);
  BOOST_TEST(largest < wheel.accuracy.lower_degree_error);
  BOOST_TEST(wheel.accuracy.lower_degree_error < 3e-3);
  BOOST_TEST(*wheel.modes.counted == wheel.modes.size());
  for (const ModeCharacter &character : wheel.characters)
    if (character.partner)
      BOOST_TEST(character.split < 1e-12);
}

/** Shapes are of unit mass by the section; the mesh has most of it. */
BOOST_AUTO_TEST_CASE(shapes_on_a_mesh_are_orthonormal_to_its_own_accuracy)
{
  const ByHarmonics           wheel(section("wheel_2.msh"), 3000.);
  const DenseMatrix          &shapes = wheel.modes.shapes;
  const SymmetricSparseMatrix M      = wheel.body.mass();
  const DenseMatrix           G      = projected(M, shapes);
  const double                off =
    (G - DenseMatrix::Identity(G.rows(), G.cols())).cwiseAbs().maxCoeff();
  BOOST_TEST_MESSAGE("orthonormal to " << off);
  BOOST_TEST(off < 0.02);
}

/** A clamped disc of constant section turns about its axle without change along
 * it, by J_1 and Y_1 of k r; its rim carries no shear:
 * J_1(k a) Y_2(k b) = Y_1(k a) J_2(k b). */
BOOST_AUTO_TEST_CASE(a_disc_turns_as_bessel_has_it)
{
  const double a = 0.12, b = 0.46, G = 210e9 / 2.6, density = 7850.;
  auto         parameters   = disc(0.05);
  parameters.lateral_radius = 0.;
  const ByHarmonics wheel(parameters, 9000., 0.06);
  const auto        mismatch = [&](const double k) {
    return std::cyl_bessel_j(1, k * a) * std::cyl_neumann(2, k * b) -
           std::cyl_neumann(1, k * a) * std::cyl_bessel_j(2, k * b);
  };
  std::vector<double> exact;
  for (double k = 0.5; k < 17.; k += 0.1)
    if (mismatch(k) * mismatch(k + 0.1) < 0.)
      exact.push_back(References::bracketed_root(mismatch, k, k + 0.1) *
                      std::sqrt(G / density) / (2 * pi));
  BOOST_TEST_REQUIRE(exact.size() >= 2u);
  for (const double f : exact)
    {
      if (f > 8900.)
        continue;
      double nearest = 0.;
      for (std::size_t j = 0; j < wheel.modes.size(); ++j)
        if (wheel.characters[j].circumferential_share > 0.99 &&
            std::abs(wheel.modes.frequencies[j] - f) < std::abs(nearest - f))
          nearest = wheel.modes.frequencies[j];
      BOOST_TEST(nearest == f, boost::test_tools::tolerance(1e-5));
    }
}

BOOST_AUTO_TEST_CASE(a_free_wheel_has_six_rigid_motions)
{
  const ByHarmonics wheel(section("wheel_2.msh", Hub::free), 1500.);
  const auto       &frequencies = wheel.modes.frequencies;
  BOOST_TEST(frequencies[5] < 1e-4 * frequencies[6]);
  BOOST_TEST(frequencies[6] > 100.);
}

/** The mesh converges to the harmonics with the square of the size of its
 * cells; a crowned rim is part of both. */
BOOST_AUTO_TEST_CASE(a_crowned_disc_in_three_dimensions_converges_to_harmonics)
{
  const auto                 spec    = disc(0.14);
  const double               cut_off = 2600.;
  std::vector<double>        errors;
  std::optional<ByHarmonics> exact;
  for (const double size : {0.04, 0.02})
    {
      const ByHarmonics own(spec, cut_off, size);
      const auto        K = own.body.stiffness(), M = own.body.mass();
      Factorisation     factor(K, own.body.nodes_of_unknowns());
      factor.factorise();
      ModeControls controls;
      controls.cut_off = cut_off;
      const auto modes = structural_modes(
        K, M, factor, 0., own.body.nodes_of_unknowns(), controls);
      double sum = 0.;
      for (std::size_t j = 0; j < 5; ++j)
        sum += modes.frequencies[j] / own.modes.frequencies[j] - 1;
      errors.push_back(sum / 5);
    }
  BOOST_TEST_MESSAGE("mesh over harmonics " << errors[0] << ", " << errors[1]);
  BOOST_TEST(std::abs(errors[1]) < 1e-3);
  BOOST_TEST(errors[0] / errors[1] > 3.5);
  BOOST_TEST(errors[0] / errors[1] < 4.3);
}

BOOST_AUTO_TEST_SUITE_END()
