#include <boost/test/unit_test.hpp>

#include "../references/slender_bodies.h"
#include "scratch_folder.h"
#include "wheel_frequencies.h"

#include <rolling_contact/base/constants.h>
#include <rolling_contact/bodies/direct_body.h>
#include <rolling_contact/modes/body_places.h>
#include <rolling_contact/modes/frequency_response.h>
#include <rolling_contact/modes/measuring_point.h>
#include <rolling_contact/modes/mode_character.h>
#include <rolling_contact/modes/rotation.h>
#include <rolling_contact/scene/body_parameters.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(vibrating_bodies)

namespace
{
  BodySpec section(const std::string &body,
                   const std::string &file,
                   const double       radius,
                   const unsigned int cells_along)
  {
    BodyParameters parameters(body);
    parameters.shape          = "section";
    parameters.mesh_file      = file;
    parameters.radius         = radius;
    parameters.cells_along    = cells_along;
    parameters.model.elements = ElementKind::enhanced;
    parameters.material       = {210e9, 0.3, 7850.};
    BodySpec spec(parameters);
    spec.read_mesh(3, std::string(TEST_DATA) + "/../../prm/sections");
    return spec;
  }

  /** A body, its modes and what they look like. */
  struct Vibrating
  {
    Vibrating(const BodySpec &parameters,
              const double    cut_off,
              const double    size = 0.)
      : body(parameters.body_shape(),
             parameters.material,
             parameters.thickness,
             size > 0. ? Grading<3>::uniform(size, size)
                       : Grading<3>::unrefined(),
             true,
             parameters.model)
      , places(body)
      , K(body.stiffness())
      , M(body.mass())
      , shift(is_loose(parameters.hub) ? shift_of_free_body(cut_off) : 0.)
      , factor(linear_combination(1., K, shift, M), body.nodes_of_unknowns())
    {
      factor.factorise();
      ModeControls controls;
      controls.cut_off = cut_off;
      modes            = structural_modes(
        K, M, factor, shift, body.nodes_of_unknowns(), controls);
      characters =
        mode_characters(places, parameters.body_shape()->axle(), modes);
    }

    /** The frequencies with so many nodal diameters, one of each pair. */
    std::vector<double> with_diameters(const unsigned int n) const
    {
      std::vector<double> found;
      for (std::size_t j = 0; j < modes.size(); ++j)
        if (characters[j].nodal_diameters == n &&
            !(characters[j].partner && *characters[j].partner < j))
          found.push_back(modes.frequencies[j]);
      return found;
    }

    double largest_split() const
    {
      double largest = 0.;
      for (const ModeCharacter &character : characters)
        largest = std::max(largest, character.split);
      return largest;
    }

    DirectBody<3>              body;
    BodyPlaces                 places;
    SymmetricSparseMatrix      K, M;
    double                     shift;
    Factorisation              factor;
    StructuralModes            modes;
    std::vector<ModeCharacter> characters;
  };

  /** Relative errors; those of the first family of each number apart. */
  struct Errors
  {
    Errors(const Vibrating &found, const FrequenciesByDiameters &exact)
    {
      for (const auto &[n, frequencies] : exact)
        {
          const auto computed = found.with_diameters(n);
          BOOST_TEST_REQUIRE(computed.size() >= frequencies.size());
          for (std::size_t k = 0; k < frequencies.size(); ++k)
            {
              const double error = std::abs(computed[k] / frequencies[k] - 1);
              mean += error;
              ++count;
              largest = std::max(largest, error);
              if (k == 0)
                first[n] = error;
            }
        }
      mean /= count;
    }

    double                         mean = 0., largest = 0.;
    unsigned int                   count = 0;
    std::map<unsigned int, double> first;
  };
} // namespace

/** Against a Fourier expansion round the axle, linear elasticity in three
 * dimensions, converged; Kirchhoff's plate is 1 % above it. */
BOOST_AUTO_TEST_CASE(an_annular_plate_has_its_frequencies)
{
  const Vibrating plate(section("Wheel", "annular_plate.msh", 0.46, 96), 2300.);
  const Errors    errors(plate,
                      {{0, {114.99, 567.71, 699.75, 1999.9}},
                          {1, {103.80, 750.83, 1645.57}},
                          {2, {143.80, 928.13, 2279.95}}});
  BOOST_TEST_MESSAGE("mean " << errors.mean << " largest " << errors.largest);
  BOOST_TEST(errors.count == 10u);
  BOOST_TEST(errors.mean < 0.01);
  BOOST_TEST(errors.largest < 0.025);
  BOOST_TEST(plate.largest_split() < 1e-6);
  // the first family bends, that at 568 Hz turns
  BOOST_TEST(plate.characters[0].axial_share > 0.99);
  for (std::size_t j = 0; j < plate.modes.size(); ++j)
    if (std::abs(plate.modes.frequencies[j] - 567.71) < 6.)
      BOOST_TEST(plate.characters[j].circumferential_share > 0.9);
}

BOOST_AUTO_TEST_CASE(a_wheel_has_its_frequencies)
{
  const Vibrating wheel(section("Wheel", "wheel_2.msh", 0.46, 96), 5800.);
  const Errors    errors(wheel, frequencies_of_wheel_2());
  BOOST_TEST_MESSAGE("mean " << errors.mean << " largest " << errors.largest);
  BOOST_TEST(errors.count == 32u);
  BOOST_TEST(errors.mean < 0.012);
  BOOST_TEST(errors.first.at(2) < 0.008);
  for (unsigned int n = 3; n <= 7; ++n)
    BOOST_TEST(errors.first.at(n) < 0.004);
  BOOST_TEST(wheel.largest_split() < 1e-6);
  BOOST_TEST(wheel.modes.orthogonality < 1e-12);
  for (const double residual : wheel.modes.residuals)
    BOOST_TEST(residual < 1e-8);
}

namespace
{
  /** A ring of two by two cells through a square section of 20 mm, in a file of
   * its own. */
  void write_ring(const std::filesystem::path &file)
  {
    std::ofstream mesh(file);
    mesh << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n9\n";
    for (int i = 0; i < 9; ++i)
      mesh << i + 1 << ' ' << 0.01 * (i % 3 - 1) << ' ' << 0.01 * (i / 3)
           << " 0\n";
    mesh << "$EndNodes\n$Elements\n6\n1 1 2 1 1 1 2\n2 1 2 1 1 2 3\n";
    for (int i = 0; i < 4; ++i)
      {
        const int corner = 1 + i % 2 + 3 * (i / 2);
        mesh << i + 3 << " 3 2 3 3 " << corner << ' ' << corner + 1 << ' '
             << corner + 4 << ' ' << corner + 3 << '\n';
      }
    mesh << "$EndElements\n";
  }
} // namespace

/** A slender ring that nothing holds bends in its plane as Hoppe has it. */
BOOST_AUTO_TEST_CASE(a_free_ring_bends_in_its_plane)
{
  const ScratchFolder scratch;
  write_ring(scratch.scratch / "ring.msh");
  BodyParameters ring("Wheel");
  ring.shape          = "section";
  ring.mesh_file      = "ring.msh";
  ring.radius         = 0.41;
  ring.cells_along    = 96;
  ring.hub            = Hub::free;
  ring.model.elements = ElementKind::enhanced;
  ring.material       = {210e9, 0.3, 7850.};
  BodySpec spec(ring);
  spec.read_mesh(3, scratch.scratch);
  const Vibrating body(spec, 1500.);
  BOOST_TEST(body.modes.frequencies[5] < 1e-4 * body.modes.frequencies[6]);
  References::Bar section;
  section.width         = 0.02;
  section.depth         = 0.02;
  section.young_modulus = 210e9;
  section.density       = 7850.;
  for (unsigned int n = 2; n <= 5; ++n)
    {
      const double exact   = References::free_ring_frequency(section, 0.4, n);
      double       nearest = 0.;
      for (std::size_t j = 6; j < body.modes.size(); ++j)
        if (body.characters[j].nodal_diameters == n &&
            body.characters[j].axial_share < 0.01 &&
            std::abs(body.modes.frequencies[j] - exact) <
              std::abs(nearest - exact))
          nearest = body.modes.frequencies[j];
      BOOST_TEST_MESSAGE("ring n = " << n << ": " << nearest << " against "
                                     << exact);
      BOOST_TEST(nearest == exact, boost::test_tools::tolerance(0.02));
    }
}

/** The modes of a plate with so many diameters have one circle more each, as
 * long as they bend it; those that stretch it are radial or circumferential. */
BOOST_AUTO_TEST_CASE(modes_have_the_names_of_their_circles)
{
  const Vibrating plate(section("Wheel", "annular_plate.msh", 0.46, 48), 1500.);
  std::map<unsigned int, unsigned int> circles;
  unsigned int                         n_named = 0;
  for (std::size_t j = 0; j < plate.modes.size(); ++j)
    {
      const ModeCharacter &character = plate.characters[j];
      const unsigned int   n         = *character.nodal_diameters;
      if (character.partner && *character.partner < j)
        continue;
      if (character.axial_share < 0.5)
        {
          BOOST_TEST(
            (character.name()[0] == 'R' || character.name()[0] == 'C'));
          continue;
        }
      const std::string name =
        std::to_string(circles[n]) + "L" + std::to_string(n);
      BOOST_TEST(character.name() == name);
      ++circles[n];
      ++n_named;
    }
  BOOST_TEST(n_named > 8u);
  BOOST_TEST(circles[0] >= 2u);
}

/** The second of a pair does not move the contact point, so that shapes do not
 * depend on the random start. */
BOOST_AUTO_TEST_CASE(pairs_are_turned_to_the_contact)
{
  Vibrating plate(section("Wheel", "annular_plate.msh", 0.46, 48), 800.);
  const MeasuringPoint contact(plate.body, {{0., 0., 0.}}, 0.);
  align_pairs(plate.characters, contact, 1e-6, plate.modes);
  unsigned int n_pairs = 0;
  for (std::size_t j = 0; j < plate.modes.size(); ++j)
    {
      const auto partner = plate.characters[j].partner;
      if (!partner || *partner < j)
        continue;
      ++n_pairs;
      const std::size_t n     = plate.modes.shapes.rows();
      const double     *first = plate.modes.shapes.data() + j * n,
                   *second    = plate.modes.shapes.data() + *partner * n;
      BOOST_TEST(contact.motion(1, first) > 0.1);
      BOOST_TEST(std::abs(contact.motion(1, second)) < 1e-9);
      std::vector<double> image(n);
      plate.M.multiply(std::vector<double>(first, first + n), image);
      BOOST_TEST(std::abs(dot(image, std::vector<double>(second, second + n))) <
                 1e-9);
    }
  BOOST_TEST(n_pairs >= 4u);
}

BOOST_AUTO_TEST_CASE(a_free_wheel_has_six_rigid_modes)
{
  auto parameters = section("Wheel", "wheel_2.msh", 0.46, 48);
  parameters.hub  = Hub::free;
  const Vibrating wheel(parameters, 1500.);
  BOOST_TEST(wheel.modes.frequencies[5] < 1e-4 * wheel.modes.frequencies[6]);
  BOOST_TEST(wheel.modes.frequencies[6] > 100.);
}

/** The flow round the axle turns the two modes of a pair into each other, n
 * times as fast as itself where they move along the axle alone, and no others.
 */
BOOST_AUTO_TEST_CASE(flow_turns_a_pair_by_its_nodal_diameters)
{
  const auto      parameters = section("Wheel", "annular_plate.msh", 0.46, 96);
  const Vibrating plate(parameters, 500.);
  const auto      S =
    modal_rotation(plate.body.rotation(*parameters.body_shape()->axle()),
                   plate.modes.shapes);
  unsigned int n_pairs = 0;
  for (std::size_t j = 0; j < plate.modes.size(); ++j)
    {
      const ModeCharacter &character = plate.characters[j];
      for (std::size_t i = 0; i < plate.modes.size(); ++i)
        {
          BOOST_TEST(S(i, j) == -S(j, i));
          if (character.partner == i && *character.nodal_diameters <= 3)
            {
              ++n_pairs;
              BOOST_TEST(std::abs(S(i, j)) == *character.nodal_diameters,
                         boost::test_tools::tolerance(0.02));
            }
          else if (plate.characters[i].nodal_diameters !=
                   character.nodal_diameters)
            BOOST_TEST(std::abs(S(i, j)) < 1e-6);
        }
    }
  BOOST_TEST(n_pairs >= 6u);
}

/** A force on the mean over some nodes does what the mean of its work says. */
BOOST_AUTO_TEST_CASE(a_measuring_point_spreads_a_force_as_it_takes_a_mean)
{
  const Vibrating plate(section("Wheel", "annular_plate.msh", 0.46, 48), 200.);
  const MeasuringPoint point(plate.body, {{0., 0., -0.03}}, 0.05);
  BOOST_TEST(point.n_nodes() > 3u);
  for (unsigned int axis = 0; axis < 3; ++axis)
    {
      const auto force = point.load(axis, plate.K.size());
      double     sum   = 0.;
      for (const double value : force)
        sum += value;
      BOOST_TEST(sum == 1., boost::test_tools::tolerance(1e-12));
      std::vector<double> motion(plate.K.size());
      for (std::size_t i = 0; i < motion.size(); ++i)
        motion[i] = std::sin(0.1 * i);
      BOOST_TEST(point.motion(axis, motion.data()) == dot(force, motion),
                 boost::test_tools::tolerance(1e-12));
    }
}

/** Between nodes a body moves as its shape functions say: a linear field has
 * its own value wherever it is measured, at a point and as a mean round one,
 * and a mean of the square of the distance has that of the weights. */
BOOST_AUTO_TEST_CASE(a_measuring_point_is_where_it_is_asked_for)
{
  const auto parameters = section("Wheel", "annular_plate.msh", 0.46, 48);
  const DirectBody<3> body(parameters.body_shape(),
                           parameters.material,
                           parameters.thickness,
                           Grading<3>::unrefined(),
                           true,
                           parameters.model);
  const BodyPlaces    places(body);
  const auto motion = [&](const MeasuringPoint &point, const auto &field) {
    std::vector<double> values(body.n_unknowns());
    for (const auto &node : places.nodes)
      if (node.unknowns[1] >= 0)
        values[node.unknowns[1]] = field(node.point);
    return point.motion(1, values.data());
  };
  const auto linear = [](const std::array<double, 3> &at) {
    return 2. + 3. * at[0] - 5. * at[1] + 7. * at[2];
  };
  const std::array<double, 3> place{{0.013, 0.002, -0.0512}};
  const MeasuringPoint        point(body, place, 0.), mean(body, place, 0.02);
  BOOST_TEST(motion(point, linear) == linear(place),
             boost::test_tools::tolerance(1e-10));
  BOOST_TEST(point.distance() == 0.);
  // the plate is 5 mm to both sides of its middle
  auto middle = place;
  middle[1]   = 0.;
  BOOST_TEST(motion(mean, linear) == linear(middle),
             boost::test_tools::tolerance(2e-3));
  // beyond the plate, the nearest point of it, and how far it is
  const MeasuringPoint beyond(body, {{0., 0.1, -0.05}}, 0.01);
  BOOST_TEST(beyond.distance() > 0.08);
  BOOST_TEST(beyond.n_nodes() > 0u);
}

namespace
{
  const double pulse_length = 1e-3; // s

  double hammer(const double time)
  {
    return time < pulse_length ? 1e3 * std::sin(pi * time / pulse_length) : 0.;
  }

  /** The node at the contact point, as dynamics takes contact nodes. */
  DirectBody<3>::SurfaceNode contact_node(const DirectBody<3> &body)
  {
    for (const auto &cell : body.dof_handler().active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        if (cell->vertex(v).norm() < 1e-9)
          {
            DirectBody<3>::SurfaceNode node;
            for (unsigned int d = 0; d < 3; ++d)
              node.dofs[d] = cell->vertex_dof_index(v, d);
            return node;
          }
    throw std::logic_error("no node at the contact point");
  }

  /** Axial displacement of the contact point under the hammer by the
   * theta-scheme on all unknowns, with damping alpha M. */
  std::vector<double> by_steps(DirectBody<3> &body,
                               const double   alpha,
                               const double   h,
                               const double   length)
  {
    ThetaScheme scheme;
    scheme.theta        = 0.5;
    scheme.mass_damping = alpha;
    const auto motion =
      body.in_time(scheme, MassKind::lumped, {contact_node(body)}, {1});
    motion->set_time_step(h);
    std::vector<double> displacement{0.};
    for (unsigned int k = 0; k < std::lround(length / h); ++k)
      {
        motion->begin_step();
        motion->end_step({hammer((k + 0.5) * h)});
        displacement.push_back(motion->contact_displacement()[0]);
      }
    return displacement;
  }

  /** The same by modes, each stepped finely, and the compliance of the rest. */
  std::vector<double> by_modes(const Vibrating &plate,
                               const double     alpha,
                               const double     h,
                               const double     length)
  {
    const MeasuringPoint contact(plate.body, {{0., 0., 0.}}, 0.);
    const std::size_t    n    = plate.modes.shapes.rows(),
                      n_steps = std::lround(length / h);
    const auto load           = contact.load(1, n);
    double     rest = contact.motion(1, plate.factor.solve(load).data());
    std::vector<double> displacement(n_steps + 1, 0.);
    for (std::size_t j = 0; j < plate.modes.size(); ++j)
      {
        const double phi = contact.motion(1, plate.modes.shapes.data() + j * n),
                     lambda = plate.modes.eigenvalue(j);
        rest -= phi * phi / lambda;
        const unsigned int parts = 20;
        const double       fine  = h / parts;
        double             q = 0., v = 0.;
        for (std::size_t k = 0; k < n_steps; ++k)
          {
            for (unsigned int i = 0; i < parts; ++i)
              {
                const double force = phi * hammer(k * h + (i + 0.5) * fine);
                const double middle =
                  (v + fine / 2 * (force - lambda * q)) /
                  (1 + fine / 2 * alpha + fine * fine / 4 * lambda);
                q += fine * middle;
                v = 2 * middle - v;
              }
            displacement[k + 1] += phi * q;
          }
      }
    for (std::size_t k = 0; k <= n_steps; ++k)
      displacement[k] += rest * hammer(k * h);
    return displacement;
  }
} // namespace

/** 10 ms after the blow of a hammer. */
BOOST_AUTO_TEST_CASE(modes_answer_a_hammer_as_the_theta_scheme_does)
{
  Vibrating    plate(section("Wheel", "annular_plate.msh", 0.46, 24), 8000.);
  const double alpha = 40., h = 4e-6, length = 10e-3;
  const auto   steps = by_steps(plate.body, alpha, h, length),
             modes   = by_modes(plate, alpha, h, length);
  double largest = 0., difference = 0.;
  for (std::size_t k = 0; k < steps.size(); ++k)
    {
      largest    = std::max(largest, std::abs(steps[k]));
      difference = std::max(difference, std::abs(steps[k] - modes[k]));
    }
  BOOST_TEST_MESSAGE("difference " << difference / largest);
  BOOST_TEST(difference < 0.01 * largest);
  BOOST_TEST(largest > 1e-5);
}

BOOST_AUTO_TEST_SUITE_END()
