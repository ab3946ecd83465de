#include <deal.II/lac/vector.h>

#include <boost/test/unit_test.hpp>

#include "section_files.h"
#include "vibrating_pair.h"
#include <Eigen/Cholesky>

#include <cmath>

using namespace RollingContact;
using namespace VibratingPair;

/** Bodies of sections on a curved surface of contact, where each node has its
 * own normal: what moves across moves the patch, at rest and in vibrations. */
BOOST_AUTO_TEST_SUITE(curved_vibration)

namespace
{
  using Complex = std::complex<double>;

  const double mm = 1e-3, load = 50e3, length = 0.4;

  /** S1002 on a short 60E1 on springs. */
  void on_springs(SceneParameters &scene)
  {
    scene.dimension         = 3;
    scene.wheel             = section_body("Wheel", "wheel_s1002.msh");
    scene.rail              = section_body("Rail", "rail_60e1.msh");
    scene.wheel.radius      = 0.46;
    scene.wheel.cells_along = 72;
    scene.rail.cells_along  = 20;
    scene.rail.block_length = length;
    scene.rail.hub          = Hub::elastic;
    scene.rail.model.foundation.stiffness = {{1e9, 1e9, 3e9}};
    for (BodyParameters *body : {&scene.wheel, &scene.rail})
      {
        body->material.density                = 7850.;
        body->model.damping.mass_damping      = 10.;
        body->model.damping.stiffness_damping = 1e-7;
      }
    scene.contact.approach.reset();
    scene.contact.normal_load        = load;
    scene.contact.speed              = 10.;
    scene.contact.slip_operator      = SlipOperatorKind::upwind_2;
    scene.mesh.elements_across_patch = 6;
    scene.mesh.growth                = 1.5;
    scene.stability.rotation         = false;
    scene.profiles.wheel_profile     = "S1002";
    scene.profiles.rail_profile      = "60E1";
    scene.profiles.shift             = 3 * mm;
    scene.profiles.roll              = 0.;
    scene.profiles.surface_kind      = Profiles::SurfaceKind::curved;
  }

  SceneRun<3> without_friction(
    const double                stiffness,
    const double                shift,
    const Profiles::SurfaceKind kind = Profiles::SurfaceKind::curved)
  {
    return SceneRun<3>(&on_springs, [=](SceneParameters &scene) {
      scene.contact.friction_coefficient       = 0.;
      scene.rail.model.foundation.stiffness[1] = stiffness;
      scene.profiles.shift                     = shift;
      scene.profiles.surface_kind              = kind;
    });
  }

  /** Where on the rail the middle of the pressure is, as a length. */
  double place_on_rail(const SceneRun<3> &run)
  {
    const ContactProblem &problem = run.steady.problem;
    double                sum = 0., moment = 0.;
    for (unsigned int i = 0; i < problem.n_nodes(); ++i)
      {
        const double force =
          problem.operators.areas()[i] * run.steady.state.pressure[i];
        sum += force;
        moment += force * problem.operators.positions()[i][1];
      }
    return run.situation().frame->rail_arc_length(moment / sum);
  }

  /** Force on the wheel to the right in the track. */
  double to_the_right(const SceneRun<3> &run)
  {
    const Resultants &found = run.steady.result;
    return run.situation().frame->in_track(found.force_y,
                                           found.normal_force)[0];
  }

  void slide_sideways(SceneParameters &scene)
  {
    on_springs(scene);
    scene.contact.friction_coefficient = 0.4;
    scene.contact.creepages            = {0., -0.01, 0.};
    scene.modes.maximum_frequency      = 2000.;
  }
} // namespace

/** A rail on soft springs across goes to the side by the lateral force over
 * their stiffness; that is a wheelset which is shifted by as much less. In a
 * plane the patch stays where it is. */
BOOST_AUTO_TEST_CASE(a_rail_that_yields_takes_the_patch_with_it)
{
  const double      stiff = 1e9, soft = 3.5e7, shift = 3 * mm;
  const SceneRun<3> held     = without_friction(stiff, shift),
                    yielding = without_friction(soft, shift);
  const double moved         = -to_the_right(yielding) / (soft * length) +
                       to_the_right(held) / (stiff * length);
  BOOST_TEST_REQUIRE(moved > 0.2 * mm);
  const SceneRun<3> shifted   = without_friction(stiff, shift - moved);
  const double      place     = place_on_rail(yielding) - place_on_rail(held),
               expected       = place_on_rail(shifted) - place_on_rail(held),
               force          = to_the_right(yielding) - to_the_right(held),
               expected_force = to_the_right(shifted) - to_the_right(held);
  BOOST_TEST_MESSAGE("rail moved by " << moved << ", patch by " << place
                                      << ", expected " << expected
                                      << ", lateral force by " << force
                                      << ", expected " << expected_force);
  BOOST_TEST(relative(place, expected) < 0.03);
  BOOST_TEST(relative(force, expected_force) < 0.25);
  const auto plane = Profiles::SurfaceKind::plane;
  BOOST_TEST(std::abs(place_on_rail(without_friction(soft, shift, plane)) -
                      place_on_rail(without_friction(stiff, shift, plane))) <
             0.05 * expected);
}

BOOST_AUTO_TEST_CASE(modes_and_whole_bodies_answer_alike)
{
  Eigenvalues<3> pair(&slide_sideways, 5000.);
  BOOST_TEST_REQUIRE(pair.steady.pair->interface().turns_nodes());
  const DenseMatrix W = pair.steady.problem.operators.W().dense();
  const auto        n = W.rows();
  ComplexVector     forces(n);
  for (Eigen::Index i = 0; i < n; ++i)
    forces[i] = std::polar(1. + 0.3 * std::sin(1.7 * i), 0.4 * std::sin(i));
  const ComplexVector at_rest =
    pair.whole->response({Complex(1e-6)}, {forces})[0];
  BOOST_TEST((at_rest - W * forces).norm() < 1e-6 * at_rest.norm());
  for (const double f : {300., 600.})
    {
      const Complex       s(-5., 2 * pi * f);
      const ComplexVector whole = pair.whole->response({s}, {forces})[0],
                          modes = reduced_response(pair.reduced, s, forces);
      BOOST_TEST_MESSAGE("at " << f << " Hz the modes differ by "
                               << (whole - modes).norm() / whole.norm());
      BOOST_TEST((whole - modes).norm() < 1e-4 * whole.norm());
    }
}

/** Modes of the section in place of the mesh's are softer; their static
 * compliance is that of the reduced bodies, in which runs in time begin. */
BOOST_AUTO_TEST_CASE(reduced_bodies_by_harmonics_begin_at_rest)
{
  const Eigenvalues<3> pair(
    [](SceneParameters &scene) {
      slide_sideways(scene);
      scene.wheel.modes = ModeModel::harmonic;
    },
    5000.);
  const ReducedPair &reduced = pair.reduced;
  const DenseMatrix  W       = pair.steady.problem.operators.W().dense();
  const DenseMatrix  at_rest =
    reduced.W_res +
    reduced.Phi * reduced.K_m.ldlt().solve(reduced.Phi.transpose());
  BOOST_TEST((pair.rolling->compliance_at_rest(W) - at_rest).norm() <
             1e-8 * at_rest.norm());
  BOOST_TEST((W - at_rest).norm() > 1e-3 * at_rest.norm());
}

BOOST_AUTO_TEST_SUITE_END()
