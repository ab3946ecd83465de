#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include "scratch_folder.h"

#include <rolling_contact/base/constants.h>
#include <rolling_contact/elasticity/direct_body.h>
#include <rolling_contact/linear_algebra/block_products.h>
#include <rolling_contact/linear_algebra/dense_eigenvalues.h>
#include <rolling_contact/modes/absorber_places.h>
#include <rolling_contact/modes/frequency_response.h>
#include <rolling_contact/modes/full_dynamics.h>
#include <rolling_contact/modes/rotation.h>
#include <rolling_contact/scene/body_parameters.h>
#include <rolling_contact/stability/reduced_pair.h>
#include <rolling_contact/vibration/reduced_motion.h>

#include <algorithm>
#include <cmath>
#include <fstream>

using namespace RollingContact;
using Complex = std::complex<double>;

/** Tuned dampers on a wheel. */
BOOST_AUTO_TEST_SUITE(absorbers)

namespace
{
  /** Places on modes of a free ring whose coordinates of order d = 0 ... D move
   * by p_d: a mode for order 0, two for each other. */
  AbsorberPlaces
  places_on_ring(const std::vector<double> &p)
  {
    const std::size_t c = 2 * p.size() - 1;
    AbsorberPlaces    places;
    places.diameters = {static_cast<unsigned int>(p.size() - 1)};
    places.motions   = DenseMatrix(c, c);
    places.residual  = DenseMatrix(c, c);
    for (std::size_t i = 0; i < c; ++i)
      places.motions(i, i) = p[(i + 1) / 2];
    return places;
  }



  /** eta'' + C eta' + K eta = 0. */
  ComplexVector
  vibrations(const DenseMatrix &K, const DenseMatrix &C)
  {
    const std::size_t m = K.n_rows();
    const double      w = 1e3;
    DenseMatrix       A(2 * m, 2 * m);
    for (std::size_t j = 0; j < m; ++j)
      {
        A(j, m + j) = w;
        for (std::size_t i = 0; i < m; ++i)
          {
            A(m + i, j)     = -K(i, j) / w;
            A(m + i, m + j) = -C(i, j);
          }
      }
    return eigenvalues(std::move(A));
  }



  /** How far each of some values is from the nearest of others, at most. */
  double
  farthest(const ComplexVector &some, const ComplexVector &others)
  {
    double worst = 0.;
    for (const Complex &s : some)
      {
        double nearest = 1e300;
        for (const Complex &other : others)
          nearest = std::min(nearest, std::abs(s - other));
        worst = std::max(worst, nearest);
      }
    return worst;
  }



  /** A modal amplitude under a unit force on it. */
  Complex
  response(const DenseMatrix &K, const DenseMatrix &C, const Complex s)
  {
    ComplexMatrix D(K, s, C), x(K.n_rows(), 1);
    for (std::size_t j = 0; j < K.n_rows(); ++j)
      D(j, j) += s * s;
    x(0, 0) = 1.;
    ComplexLU(std::move(D)).solve(x);
    return x(0, 0);
  }
} // namespace



/** Den Hartog: with a frequency of 1/(1 + mu) of the mode's two points of the
 * response, at sqrt(1 + 2/mu) of the static one, do not depend on the damping;
 * with his damping they are its peaks. */
BOOST_AUTO_TEST_CASE(one_mode_with_the_best_damper)
{
  const double host = 3.2, mu = 0.05, omega = 2 * pi * 500.; // kg, 1, rad/s
  auto         places = places_on_ring({1 / std::sqrt(host)});
  AbsorberRing ring;
  ring.number           = 4;
  ring.mass             = mu * host / 4;
  ring.frequency        = 500. / (1 + mu);
  const double expected = std::sqrt(1 + 2 / mu),
               best     = std::sqrt(3 * mu / (8 * (1 + mu)));
  double largest        = 0.;
  for (const double damping : {0.02, best, 0.6})
    {
      ring.damping_ratio = damping;
      DenseMatrix K(1, 1), C(1, 1);
      K(0, 0) = omega * omega;
      hang_absorbers(places, {ring}, 0., K, C);
      for (const double sign : {-1., 1.})
        {
          const double g =
            std::sqrt((1 + sign * std::sqrt(mu / (2 + mu))) / (1 + mu));
          const Complex s(0., g * omega);
          BOOST_TEST(std::abs(response(K, C, s)) * omega * omega == expected,
                     boost::test_tools::tolerance(1e-10));
          // as a dynamic stiffness on the same mode
          const Complex Z = absorber_stiffness(places, {ring}, 0., s)(0, 0);
          BOOST_TEST(std::abs(omega * omega /
                              (omega * omega + s * s + Z / host)) == expected,
                     boost::test_tools::tolerance(1e-10));
        }
      if (damping == best)
        for (double g = 0.5; g < 1.5; g += 1e-3)
          largest = std::max(largest,
                             std::abs(response(K, C, Complex(0., g * omega))) *
                               omega * omega);
    }
  BOOST_TEST(largest == expected, boost::test_tools::tolerance(2e-3));
}



namespace
{
  /** Modes of order d and n single absorbers on them in the wheel's own frame,
   * each mass a coordinate at its angle. */
  ComplexVector
  in_the_wheels_frame(const unsigned int  d,
                      const double        omega,
                      const double        p,
                      const AbsorberRing &ring)
  {
    const unsigned int n  = ring.number;
    const double       w0 = 2 * pi * ring.frequency, k = ring.mass * w0 * w0,
                 c = 2 * ring.damping_ratio * ring.mass * w0;
    DenseMatrix K(2 + n, 2 + n), C(2 + n, 2 + n);
    for (unsigned int j = 0; j < 2; ++j)
      {
        K(j, j) = omega * omega;
        C(j, j) = 2e-3 * omega;
      }
    for (unsigned int q = 0; q < n; ++q)
      {
        const double        angle = 0.3 + 2 * pi * q / n;
        std::vector<double> e(2 + n, 0.);
        e[0]     = -p * std::sqrt(2.) * std::cos(d * angle);
        e[1]     = -p * std::sqrt(2.) * std::sin(d * angle);
        e[2 + q] = 1 / std::sqrt(ring.mass);
        for (unsigned int i = 0; i < 2 + n; ++i)
          for (unsigned int j = 0; j < 2 + n; ++j)
            {
              K(i, j) += k * e[i] * e[j];
              C(i, j) += c * e[i] * e[j];
            }
      }
    return vibrations(K, C);
  }
} // namespace



/** A wheel that turns under the place it is seen from: a vibration with d nodal
 * diameters at s in the wheel's own frame, where the dampers are points, is at
 * s +- i d Omega here, where they are a ring. */
BOOST_AUTO_TEST_CASE(dampers_turn_with_the_wheel)
{
  const double              rate = 21.;
  const std::vector<double> p{0.05, 0.07, 0.06}, omegas{1500., 2100., 3000.};
  for (const unsigned int n : {5u, 6u, 12u})
    for (const unsigned int d : {1u, 2u})
      {
        AbsorberRing ring;
        ring.number        = n;
        ring.mass          = 1.5;
        ring.frequency     = omegas[d] / (2 * pi) * 0.97;
        ring.damping_ratio = 0.06;
        const auto  places = places_on_ring(p);
        ReducedPair wheel;
        wheel.K_m = wheel.C_m = DenseMatrix(5, 5);
        DenseMatrix S(5, 5);
        for (unsigned int j = 0; j < 5; ++j)
          {
            const unsigned int order = (j + 1) / 2;
            wheel.K_m(j, j)          = omegas[order] * omegas[order];
            wheel.C_m(j, j)          = 2e-3 * omegas[order];
            if (j % 2 == 1)
              {
                S(j, j + 1) = order;
                S(j + 1, j) = -double(order);
              }
          }
        add_rotation(wheel, S, rate);
        hang_absorbers(places, {ring}, rate, wheel.K_m, wheel.C_m);
        const ComplexVector here = vibrations(wheel.K_m, wheel.C_m);

        const double  w0 = 2 * pi * ring.frequency;
        const Complex alone(-ring.damping_ratio * w0,
                            w0 *
                              std::sqrt(1 - std::pow(ring.damping_ratio, 2.)));
        ComplexVector expected;
        for (const Complex &s : in_the_wheels_frame(d, omegas[d], p[d], ring))
          if (s.imag() > 0. && std::abs(s - alone) > 1.) // not of other orders
            for (const double way : {-1., 1.})
              expected.push_back(s + Complex(0., way * d * rate));
        BOOST_TEST(expected.size() == 8u); // two pairs in the wheel's frame
        BOOST_TEST(farthest(expected, here) < 1e-5);
      }
}



namespace
{
  /** A stout ring clamped at its inner side, with some damping. */
  BodyParameters
  stout_ring(const std::filesystem::path &folder)
  {
    std::ofstream mesh(folder / "ring.msh");
    mesh << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n9\n";
    for (int i = 0; i < 9; ++i)
      mesh << i + 1 << ' ' << 0.01 * (i % 3 - 1) << ' ' << 0.03 * (i / 3)
           << " 0\n";
    mesh << "$EndNodes\n$Elements\n8\n1 1 2 1 1 1 2\n2 1 2 1 1 2 3\n"
         << "7 1 2 2 2 7 8\n8 1 2 2 2 8 9\n";
    for (int i = 0; i < 4; ++i)
      {
        const int corner = 1 + i % 2 + 3 * (i / 2);
        mesh << i + 3 << " 3 2 3 3 " << corner << ' ' << corner + 1 << ' '
             << corner + 4 << ' ' << corner + 3 << '\n';
      }
    mesh << "$EndElements\n";
    mesh.close();
    BodyParameters ring("Wheel");
    ring.shape                           = "section";
    ring.mesh_file                       = "ring.msh";
    ring.radius                          = 0.2;
    ring.cells_along                     = 24;
    ring.model.elements                  = ElementKind::enhanced;
    ring.model.damping.mass_damping      = 20.;
    ring.model.damping.stiffness_damping = 1e-6;
    ring.material                        = {210e9, 0.3, 7850.};
    ring.dampers.number                  = {12., 9.};
    ring.dampers.mass                    = {0.02, 0.01};
    ring.dampers.frequency               = {2500., 4000.};
    ring.dampers.damping_ratio           = {0.1};
    ring.dampers.radius                  = {0.2, 0.17};
    ring.dampers.position                = {0.01, -0.01};
    ring.dampers.direction               = "axial, radial";
    ring.check(3);
    ring.read_mesh(3, folder);
    return ring;
  }



  /** The ring, its modes up to a frequency (Hz) and where its dampers hang. */
  struct Ring
  {
    explicit Ring(const double cut_off)
      : parameters(stout_ring(scratch.scratch))
      , axle(*parameters.body_shape()->axle())
      , body(parameters.body_shape(),
             parameters.material,
             parameters.thickness,
             Grading<3>::unrefined(),
             true,
             parameters.model)
      , at(body)
      , K(body.stiffness())
      , M(body.mass())
      , C(body.damping())
      , S(body.rotation(axle))
      , factor(K, body.nodes_of_unknowns())
    {
      factor.factorise();
      ModeControls controls;
      controls.cut_off = cut_off;
      modes =
        structural_modes(K, M, factor, 0., body.nodes_of_unknowns(), controls);
      places = absorber_places(parameters.absorbers(),
                               "Wheel",
                               at,
                               axle,
                               modes,
                               mode_characters(at, axle, modes),
                               factor,
                               0.,
                               notes);
    }

    /** Of the modes, with damping and rotation. */
    ReducedPair
    reduced(const double rate) const
    {
      ReducedPair alone;
      alone.K_m = DenseMatrix(modes.size(), modes.size());
      alone.C_m = projected(C, modes.shapes);
      for (std::size_t j = 0; j < modes.size(); ++j)
        alone.K_m(j, j) = modes.eigenvalue(j);
      add_rotation(alone, modal_rotation(S, modes.shapes), rate);
      return alone;
    }

    ScratchFolder            scratch;
    BodyParameters           parameters;
    Axle                     axle;
    DirectBody<3>            body;
    BodyPlaces               at;
    SymmetricSparseMatrix    K, M, C;
    SkewSparseMatrix         S;
    Factorisation            factor;
    StructuralModes          modes;
    AbsorberPlaces           places;
    std::vector<std::string> notes;
  };



  template <class Matrix>
  DenseMatrix
  dense(const Matrix &A)
  {
    DenseMatrix identity(A.size(), A.size());
    for (std::size_t i = 0; i < A.size(); ++i)
      identity(i, i) = 1.;
    return times(A, identity);
  }



  /** All unknowns of the ring and of the masses of its dampers, by a dense
   * complex matrix. */
  ComplexVector
  solved_densely(const Ring          &ring,
                 const double         rate,
                 const Complex        s,
                 const ComplexVector &b)
  {
    const std::size_t n = b.size(), c = ring.places.n_coordinates();
    const DenseMatrix K = dense(ring.K), M = dense(ring.M), C = dense(ring.C),
                      S = dense(ring.S);
    DenseMatrix flow    = S; // M^-1 S
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i)
        flow(i, j) /= M(i, i);
    const DenseMatrix S_flow = dense_product(S, flow),
                      C_flow = dense_product(C, flow);
    ComplexMatrix D(n + c, n + c);
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i)
        D(i, j) = K(i, j) + s * C(i, j) + s * s * M(i, j) +
                  2. * s * rate * S(i, j) + rate * rate * S_flow(i, j) +
                  rate * C_flow(i, j);
    std::size_t first = 0;
    const auto  rings = ring.parameters.absorbers();
    for (std::size_t r = 0; r < rings.size(); ++r)
      {
        const double mass = rings[r].number * rings[r].mass,
                     w0 = 2 * pi * rings[r].frequency, k = mass * w0 * w0,
                     loss      = 2 * rings[r].damping_ratio * mass * w0;
        const std::size_t size = 2 * ring.places.diameters[r] + 1;
        ComplexMatrix     sigma(size, size); // s + Omega d/dtheta
        for (std::size_t i = 0; i < size; ++i)
          {
            sigma(i, i) = s;
            if (i % 2 == 1)
              {
                sigma(i, i + 1) = rate * (i + 1) / 2;
                sigma(i + 1, i) = -rate * (i + 1) / 2;
              }
          }
        const ComplexMatrix twice = sigma * sigma;
        for (std::size_t j = 0; j < size; ++j)
          for (std::size_t i = 0; i < size; ++i)
            {
              const Complex g = (i == j ? k : 0.) + loss * sigma(i, j);
              D(n + first + i, n + first + j) += mass * twice(i, j) + g;
              for (std::size_t p = 0; p < n; ++p)
                {
                  D(n + first + i, p) -= g * ring.places.loads(p, first + j);
                  D(p, n + first + j) -= g * ring.places.loads(p, first + i);
                  for (std::size_t q = 0; q < n; ++q)
                    D(p, q) += g * ring.places.loads(p, first + i) *
                               ring.places.loads(q, first + j);
                }
            }
        first += size;
      }
    ComplexVector x = b;
    x.resize(n + c, 0.);
    ComplexLU(std::move(D)).solve(x);
    x.resize(n);
    return x;
  }



  /** A force on the contact point along the axle. */
  ComplexVector
  force_on_contact(const Ring &ring, int &unknown)
  {
    unknown = -1;
    for (const auto &node : ring.at.nodes)
      if (std::abs(node.point[0]) + std::abs(node.point[1]) +
            std::abs(node.point[2]) <
          1e-6)
        unknown = node.unknowns[1];
    BOOST_REQUIRE(unknown >= 0);
    ComplexVector b(ring.K.size(), 0.);
    b[unknown] = 1.;
    return b;
  }
} // namespace



BOOST_AUTO_TEST_CASE(they_hang_on_the_nearest_circles_of_nodes)
{
  const Ring ring(9e3);
  BOOST_TEST(ring.places.diameters.size() == 2u);
  BOOST_TEST(ring.places.diameters[0] >= 2u);
  BOOST_TEST(ring.places.diameters[1] <= 4u); // nine tell four apart
  BOOST_TEST(ring.notes[0].find("radius 0.2 m, position 0.01 m, 0 mm") !=
             std::string::npos);
  // all that moves along the axle by 1 moves the mean of the first ring by 1
  const std::size_t n    = ring.K.size();
  double            mean = 0., others = 0.;
  for (const auto &node : ring.at.nodes)
    if (node.unknowns[1] >= 0)
      for (std::size_t i = 0; i < 2 * ring.places.diameters[0] + 1; ++i)
        (i == 0 ? mean : others) += ring.places.loads(node.unknowns[1], i);
  BOOST_TEST(mean == 1., boost::test_tools::tolerance(1e-12));
  BOOST_TEST(std::abs(others) < 1e-12);
  BOOST_TEST(n > 300u);
  // modes of a pair turn into each other as the ring's coordinates do
  const DenseMatrix S   = modal_rotation(ring.S, ring.modes.shapes),
                    P_S = dense_product(ring.places.motions, S);
  double error = 0., size = 0.;
  for (std::size_t j = 0; j < ring.modes.size(); ++j)
    for (unsigned int d = 1; d <= 3; ++d)
      {
        const double cosine = ring.places.motions(2 * d - 1, j),
                     sine   = ring.places.motions(2 * d, j);
        error += std::pow(P_S(2 * d - 1, j) - d * sine, 2.) +
                 std::pow(P_S(2 * d, j) + d * cosine, 2.);
        size += d * d * (cosine * cosine + sine * sine);
      }
  BOOST_TEST_MESSAGE("flow: " << std::sqrt(error / size));
  BOOST_TEST(std::sqrt(error / size) < 0.1);
}



/** Of all unknowns at once, by the modes as a preconditioner and by a dense
 * factor of the bodies and the masses of the dampers. */
BOOST_AUTO_TEST_CASE(whole_bodies_have_their_dampers)
{
  const Ring                ring(9e3);
  const double              rate  = 50.;
  const ReducedPair         modal = ring.reduced(rate);
  const std::vector<double> no_ratios(ring.modes.size(), 0.);
  const auto                rings = ring.parameters.absorbers();
  const FullDynamics        full(
    TurningStructure{ring.K, ring.M, ring.C, ring.S, rate},
    ring.factor,
    ring.modes,
    no_ratios,
    modal.K_m,
    modal.C_m,
    AttachedDynamics{ring.places.loads,
                     ring.places.deflected,
                     ring.places.compliance,
                     ring.places.motions,
                     [&](const Complex s) {
                       return absorber_stiffness(ring.places, rings, rate, s);
                     }});
  int                 unknown;
  const ComplexVector b = force_on_contact(ring, unknown);
  for (const double f : {2400., 4100.})
    {
      const Complex       s(15., 2 * pi * f);
      const ComplexVector x     = full.solve(s, b, 1e-11),
                          exact = solved_densely(ring, rate, s, b);
      ComplexVector error       = x;
      for (std::size_t i = 0; i < x.size(); ++i)
        error[i] -= exact[i];
      BOOST_TEST(norm(error) / norm(exact) < 1e-8);
    }
}



/** What the modes leave out is in series with the springs: without it the
 * dampers of the reduced equations would be out of tune. */
BOOST_AUTO_TEST_CASE(the_modes_leave_out_little)
{
  Ring                ring(9e3);
  int                 unknown;
  const ComplexVector b     = force_on_contact(ring, unknown);
  const auto          rings = ring.parameters.absorbers();
  const double        rate  = 50.;
  const auto          error = [&]() {
    ReducedPair modal = ring.reduced(rate);
    hang_absorbers(ring.places, rings, rate, modal.K_m, modal.C_m);
    const std::size_t n     = modal.K_m.n_rows();
    double            worst = 0.;
    for (const double f : {2300., 2500., 2700.})
      {
        const Complex s(0., 2 * pi * f);
        ComplexMatrix D(modal.K_m, s, modal.C_m), eta(n, 1);
        for (std::size_t j = 0; j < n; ++j)
          D(j, j) += s * s;
        for (std::size_t j = 0; j < ring.modes.size(); ++j)
          eta(j, 0) = ring.modes.shapes(unknown, j);
        ComplexLU(std::move(D)).solve(eta);
        // the motion of the ring of dampers: a residual at the contact itself
        // is no matter
        const ComplexVector exact = solved_densely(ring, rate, s, b);
        Complex             W = 0., W_exact = 0.;
        for (std::size_t j = 0; j < ring.modes.size(); ++j)
          W += ring.places.motions(5, j) * eta(j, 0);
        for (std::size_t i = 0; i < exact.size(); ++i)
          W_exact += ring.places.loads(i, 5) * exact[i];
        worst = std::max(worst, std::abs(W / W_exact - 1.));
      }
    return worst;
  };
  const double with = error(), soft = softening(ring.places, rings);
  ring.places.residual =
    DenseMatrix(ring.places.n_coordinates(), ring.places.n_coordinates());
  const double without = error();
  BOOST_TEST_MESSAGE("softening " << soft << ": error " << with << ", without "
                                  << without);
  BOOST_TEST(soft > 0.);
  BOOST_TEST(with < 0.05);
}



/** Receptances of the wheel and of the motions its dampers follow give those
 * with dampers. */
BOOST_AUTO_TEST_CASE(receptances_with_dampers)
{
  const Ring                       ring(9e3);
  const auto                       rings = ring.parameters.absorbers();
  int                              unknown;
  const ComplexVector              b = force_on_contact(ring, unknown);
  const std::size_t                n = b.size();
  std::vector<std::vector<double>> loads{std::vector<double>(n, 0.)};
  loads[0][unknown] = 1.;
  for (std::size_t k = 0; k < ring.places.n_coordinates(); ++k)
    loads.emplace_back(ring.places.loads.data() + k * n,
                       ring.places.loads.data() + (k + 1) * n);
  const VibratingStructure structure{
    ring.K, ring.M, {}, ring.C, ring.body.nodes_of_unknowns()};
  const FrequencyResponse response(structure,
                                   ring.factor,
                                   0.,
                                   ring.modes,
                                   std::vector<double>(ring.modes.size(), 0.),
                                   loads);
  for (const double f : {1900., 2450.})
    {
      const Complex s(0., 2 * pi * f),
        exact             = solved_densely(ring, 0., s, b)[unknown];
      const auto    alpha = response.receptances(f);
      const Complex found =
        receptances_with(alpha,
                         absorber_stiffness(ring.places, rings, 0., s),
                         1)[0];
      BOOST_TEST_MESSAGE(f << " Hz: " << std::abs(found / exact - 1.)
                           << ", without dampers "
                           << std::abs(alpha[0] / exact - 1.));
      BOOST_TEST(std::abs(found / exact - 1.) < 2e-3);
      BOOST_TEST(std::abs(alpha[0] / exact - 1.) > 2e-2);
    }
}



/** Dampers that are carried along at rest carry nothing, and what a vibration
 * loses is what the dashpots take. */
BOOST_AUTO_TEST_CASE(energies_in_time)
{
  const auto   places = places_on_ring({0.05, 0.07, 0.06});
  AbsorberRing ring;
  ring.number        = 7;
  ring.mass          = 2.;
  ring.frequency     = 300.;
  ring.damping_ratio = 0.1;
  for (const double rate : {0., 20.})
    {
      ReducedPair pair;
      pair.K_m = pair.C_m = DenseMatrix(5, 5);
      DenseMatrix S(5, 5);
      for (unsigned int j = 0; j < 5; ++j)
        pair.K_m(j, j) = std::pow(2 * pi * (250. + 40. * ((j + 1) / 2)), 2.);
      for (unsigned int j = 1; j < 5; j += 2)
        {
          S(j, j + 1) = (j + 1) / 2;
          S(j + 1, j) = -S(j, j + 1);
        }
      add_rotation(pair, S, rate);
      hang_absorbers(places, {ring}, rate, pair.K_m, pair.C_m);
      pair.Phi   = DenseMatrix(2, 10);
      pair.W_res = DenseMatrix(2, 2);
      for (unsigned int i = 0; i < 2; ++i)
        pair.W_res(i, i) = 1e-9;
      for (unsigned int j = 0; j < 5; ++j)
        pair.Phi(0, j) = 0.1;
      ReducedMotion motion(pair);
      if (rate == 0.)
        {
          const std::vector<double> forces{100., 0.};
          std::vector<double>       eta(5);
          // statics of the modes alone, without the springs of the dampers
          for (unsigned int j = 0; j < 5; ++j)
            eta[j] = 10. / std::pow(2 * pi * (250. + 40. * ((j + 1) / 2)), 2.);
          std::vector<double> all = eta;
          for (const double z : absorbers_at_rest(places, {ring}, eta))
            all.push_back(z);
          motion.rest_at(all, forces);
          double load = 0., scale = 0.;
          for (std::size_t k = 0; k < 10; ++k)
            {
              load  = std::max(load, std::abs(motion.state().load[k]));
              scale = std::max(scale, std::abs(pair.K_m(k, k) * all[k]));
            }
          BOOST_TEST(load < 1e-9 * scale);
        }
      ReducedState state = motion.state();
      state.load.assign(10, 0.);
      state.forces = state.forces_before = {0., 0.};
      for (unsigned int k = 0; k < 10; ++k)
        {
          state.eta[k]  = k < 5 ? 1e-5 * (1. + k) : 0.;
          state.rate[k] = 0.;
        }
      motion.set_state(state);
      motion.set_time_step(1e-5);
      const double start = motion.energy().kinetic + motion.energy().strain;
      double       lost = 0., most = 0.;
      for (unsigned int k = 0; k < 3000; ++k)
        {
          motion.begin_step();
          const StepEnergy &energy = motion.end_step({0., 0.});
          lost += energy.damping;
          most = std::max(most, std::abs(energy.balance_error));
        }
      const double left = motion.energy().kinetic + motion.energy().strain;
      BOOST_TEST(most < 1e-12 * start);
      BOOST_TEST(lost == start - left, boost::test_tools::tolerance(1e-9));
      BOOST_TEST(left < 0.01 * start);
    }
}



BOOST_AUTO_TEST_CASE(lists_of_dampers_fit_each_other)
{
  BodyParameters wheel("Wheel");
  wheel.radius     = 0.46;
  wheel.hub_radius = 0.1;
  wheel.width      = 0.1;
  BOOST_TEST(wheel.absorbers().empty());
  wheel.dampers.number        = {12., 8.};
  wheel.dampers.mass          = {1.};
  wheel.dampers.frequency     = {400., 1000.};
  wheel.dampers.damping_ratio = {0.1};
  wheel.dampers.radius        = {0.4};
  wheel.dampers.position      = {0.01};
  wheel.dampers.direction     = "axial, radial";
  const auto rings            = wheel.absorbers();
  BOOST_REQUIRE(rings.size() == 2u);
  BOOST_TEST(rings[1].number == 8u);
  BOOST_TEST(rings[1].most_diameters() == 3u);
  BOOST_TEST(rings[1].frequency == 1000.);
  BOOST_TEST(rings[1].mass == 1.);
  BOOST_TEST((rings[1].direction == AbsorberDirection::radial));
  const auto says = [&](const std::function<void(BodyParameters &)> &change,
                        const std::string                           &text,
                        const unsigned int                           dim = 3) {
    BodyParameters changed = wheel;
    change(changed);
    const std::string said = complaint([&]() { changed.check(dim); });
    BOOST_TEST(said.find(text) != std::string::npos, said);
  };
  says(
    [](auto &it) {
      it.dampers.mass = {1., 1., 1.};
    },
    "Wheel/Damper mass: 3 values, and Dampers has 2");
  says([](auto &it) { it.dampers.mass.clear(); },
       "Wheel/Damper mass: 0 values");
  says([](auto &it) { it.dampers.direction = "axial, radial, axial"; },
       "Wheel/Damper direction");
  says([](auto &it) { it.dampers.number = {12., 2.}; }, "Wheel/Dampers = 2");
  says([](auto &it) { it.dampers.number = {4.5, 5.}; }, "Wheel/Dampers = 4.5");
  says([](auto &it) { it.dampers.mass = {0.}; }, "Wheel/Damper mass = 0");
  says([](auto &it) { it.dampers.frequency = {0.}; },
       "Wheel/Damper frequency = 0");
  says([](auto &it) { it.dampers.damping_ratio = {1.}; },
       "Wheel/Damper damping ratio = 1");
  says([](auto &it) { it.dampers.radius = {0.}; }, "Wheel/Damper radius = 0");
  says([](auto &) {}, "Dimension = 3", 2);
  says([](auto &it) { it.rigid = true; }, "a rigid wheel");
}

BOOST_AUTO_TEST_SUITE_END()
