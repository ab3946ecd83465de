#ifndef rolling_contact_tests_ring_with_dampers_h
#define rolling_contact_tests_ring_with_dampers_h

#include <boost/test/unit_test.hpp>

#include "scratch_folder.h"

#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/bodies/direct_body.h>
#include <rolling_contact/modes/absorber_places.h>
#include <rolling_contact/modes/full_dynamics.h>
#include <rolling_contact/modes/rotation.h>
#include <rolling_contact/scene/body_parameters.h>
#include <rolling_contact/stability/reduced_pair.h>

#include <cmath>
#include <fstream>

/** A small body of revolution with dampers. */
namespace RingWithDampers
{
  using namespace RollingContact;
  using Complex = std::complex<double>;

  /** A stout ring clamped at its inner side, with some damping. */
  inline BodySpec stout_ring(const std::filesystem::path &folder)
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
    BodySpec spec(ring);
    spec.read_mesh(3, folder);
    return spec;
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
    ReducedPair reduced(const double rate) const
    {
      ReducedPair alone;
      alone.K_m = DenseMatrix::Zero(modes.size(), modes.size());
      alone.C_m = projected(C, modes.shapes);
      for (std::size_t j = 0; j < modes.size(); ++j)
        alone.K_m(j, j) = modes.eigenvalue(j);
      add_rotation(alone, modal_rotation(S, modes.shapes), rate);
      return alone;
    }

    ScratchFolder            scratch;
    BodySpec                 parameters;
    Axle                     axle;
    DirectBody<3>            body;
    BodyPlaces               at;
    SymmetricSparseMatrix    K, M, C, H; ///< no losses H unless given
    SkewSparseMatrix         S;
    Factorisation            factor;
    StructuralModes          modes;
    AbsorberPlaces           places;
    std::vector<std::string> notes;
  };

  template <class Matrix>
  DenseMatrix dense(const Matrix &A)
  {
    return times(A, DenseMatrix::Identity(A.size(), A.size()));
  }

  /** All unknowns of the ring and of the masses of its dampers, by a dense
   * complex matrix. */
  inline ComplexVector solved_densely(const Ring          &ring,
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
    const DenseMatrix S_flow = S * flow, C_flow = C * flow,
                      H = ring.H.size() > 0 ? dense(ring.H) : 0. * K;
    const Complex loss  = s / std::abs(s.imag());
    ComplexMatrix D     = ComplexMatrix::Zero(n + c, n + c);
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i)
        D(i, j) = K(i, j) + loss * H(i, j) + s * C(i, j) + s * s * M(i, j) +
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
        ComplexMatrix     sigma =
          ComplexMatrix::Zero(size, size); // s + Omega d/dtheta
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
    ComplexVector x = ComplexVector::Zero(n + c);
    x.head(n)       = b;
    ComplexLU(std::move(D)).solve(x);
    return x.head(n);
  }

  /** A force on the contact point along the axle. */
  inline ComplexVector force_on_contact(const Ring &ring, int &unknown)
  {
    unknown = -1;
    for (const auto &node : ring.at.nodes)
      if (std::abs(node.point[0]) + std::abs(node.point[1]) +
            std::abs(node.point[2]) <
          1e-6)
        unknown = node.unknowns[1];
    BOOST_REQUIRE(unknown >= 0);
    return ComplexVector::Unit(ring.K.size(), unknown);
  }
} // namespace RingWithDampers

#endif
