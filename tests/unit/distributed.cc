#include "scene_run.h"

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/ranks.h>
#include <rolling_contact/bodies/body_dynamics.h>
#include <rolling_contact/bodies/distributed_body.h>
#include <rolling_contact/solvers/compliance_update.h>

#include <cmath>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(distributed)

namespace
{
  const Material steel{210e9, 0.3, 7850.};

  std::shared_ptr<const BodyShape> disc()
  {
    ShapeParameters parameters;
    parameters.radius         = 0.46;
    parameters.lateral_radius = 0.3;
    parameters.hub_radius     = 0.1;
    parameters.width          = 0.12;
    return make_body_shape("disc", parameters);
  }

  /**
   * Ranks that each solve the body directly as well take a smaller one in 3D.
   */
  template <int dim>
  double usual_growth()
  {
    return dim == 3 && Ranks::count() > 1 ? 0.7 : 0.35;
  }

  /**
   * A zone of about 6 mm, hanging nodes around it.
   */
  template <int dim>
  Grading<dim> grading(const double growth)
  {
    Grading<dim> result;
    result.element_size_x = 1e-3;
    result.element_size_y = 1.5e-3;
    result.zone_x = result.zone_y = 3e-3;
    result.zone_depth             = 2e-3;
    result.growth                 = growth;
    return result;
  }

  /**
   * The same body solved directly and distributed, with contact nodes.
   */
  template <int dim>
  struct Bodies
  {
    using Nodes = std::vector<typename ElasticBody<dim>::SurfaceNode>;

    DirectBody<dim>           direct;
    DistributedBody<dim>      spread;
    Nodes                     nodes, spread_nodes;
    std::vector<unsigned int> components;

    explicit Bodies(const double     growth = usual_growth<dim>(),
                    const BodyModel &model  = {})
      : direct(disc(), steel, 0.02, grading<dim>(growth), true, model)
      , spread(disc(), steel, 0.02, grading<dim>(growth), 0, model)
    {
      std::vector<typename ElasticBody<dim>::SurfaceFace> faces;
      direct.surface(grading<dim>(growth), nodes, faces);
      spread.surface(grading<dim>(growth), spread_nodes, faces);
      for (unsigned int d = 0; d < dim; ++d)
        components.push_back(d);
    }

    std::size_t n_forces() const
    {
      return nodes.size() * dim;
    }
  };

  std::vector<double> some_forces(const std::size_t n, const double phase = 1.)
  {
    std::vector<double> forces(n);
    for (std::size_t i = 0; i < n; ++i)
      forces[i] = 1e3 * std::sin(phase + 3. * i);
    return forces;
  }

  double relative_difference(const std::vector<double> &x,
                             const std::vector<double> &y)
  {
    BOOST_REQUIRE_EQUAL(x.size(), y.size());
    double difference = 0.;
    for (std::size_t i = 0; i < x.size(); ++i)
      difference = std::hypot(difference, x[i] - y[i]);
    return difference / norm(x);
  }

  template <int dim>
  void check_same_body(const BodyModel &model = {})
  {
    Bodies<dim> bodies(usual_growth<dim>(), model);
    BOOST_TEST(bodies.direct.n_unknowns() == bodies.spread.n_unknowns());
    BOOST_REQUIRE_EQUAL(bodies.nodes.size(), bodies.spread_nodes.size());
    for (std::size_t i = 0; i < bodies.nodes.size(); ++i)
      BOOST_TEST(bodies.nodes[i].position == bodies.spread_nodes[i].position);

    const auto forces = some_forces(bodies.n_forces());
    const auto more   = some_forces(bodies.n_forces(), 2.);
    bodies.direct.compliance(bodies.nodes, bodies.components);
    const auto exact = bodies.direct.response(bodies.nodes,
                                              bodies.components,
                                              {forces, more},
                                              false);
    bodies.spread.analyse();
    const auto solved = bodies.spread.response(bodies.spread_nodes,
                                               bodies.components,
                                               {forces, more},
                                               false);
    BOOST_TEST(relative_difference(exact[0], solved[0]) < 1e-9);
    BOOST_TEST(relative_difference(exact[1], solved[1]) < 1e-9);
    const BodyField field = bodies.direct.recover(bodies.nodes,
                                                  bodies.components,
                                                  {forces})[0],
                    other = bodies.spread.recover(bodies.spread_nodes,
                                                  bodies.components,
                                                  {forces})[0];
    BOOST_TEST(std::abs(field.l2_norm() / other.l2_norm() - 1) < 1e-8);
  }

  template <int dim>
  void check_same_motion(const MassKind mass)
  {
    Bodies<dim>       bodies;
    const ThetaScheme scheme{0.6, 20., 1e-8};
    const auto        direct =
      bodies.direct.in_time(scheme, mass, bodies.nodes, bodies.components);
    const auto spread = bodies.spread.in_time(scheme,
                                              mass,
                                              bodies.spread_nodes,
                                              bodies.components);
    for (BodyDynamics *motion : {direct.get(), spread.get()})
      {
        motion->set_flight_velocity(-0.2);
        motion->set_time_step(1e-6);
        for (unsigned int step = 0; step < 5; ++step)
          {
            motion->accelerate_hub(3. * step);
            motion->begin_step();
            motion->end_step(some_forces(bodies.n_forces(), step));
          }
        motion->begin_step();
      }
    const auto forces = some_forces(bodies.n_forces());
    BOOST_TEST(relative_difference(direct->response(forces),
                                   spread->response(forces)) < 1e-9);
    BOOST_TEST(relative_difference(direct->contact_displacement(),
                                   spread->contact_displacement()) < 1e-8);
    BOOST_TEST(relative_difference(direct->free_contact_velocity(),
                                   spread->free_contact_velocity()) < 1e-8);
    BOOST_TEST(relative_difference(direct->free_contact_displacement(),
                                   spread->free_contact_displacement()) < 1e-8);
    const StepEnergy &one = direct->energy(), &other = spread->energy();
    BOOST_TEST(std::abs(one.kinetic / other.kinetic - 1) < 1e-8);
    BOOST_TEST(std::abs(one.strain / other.strain - 1) < 1e-8);
    BOOST_TEST(std::abs(one.contact_work / other.contact_work - 1) < 1e-7);
    BOOST_TEST(std::abs(one.damping / other.damping - 1) < 1e-7);
    BOOST_TEST(std::abs(other.balance_error) < 1e-8 * other.kinetic);

    // checkpoints are the same, and each goes on from the other's
    const BodyMotion first = direct->save(), second = spread->save();
    spread->restore(first);
    const BodyMotion restored = spread->save();
    if (!Ranks::is_root()) // who has what is saved
      return;
    BOOST_TEST(relative_difference(first.displacement, second.displacement) <
               1e-8);
    BOOST_TEST(relative_difference(first.velocity, second.velocity) < 1e-8);
    BOOST_TEST((restored.displacement == first.displacement));
    BOOST_TEST((restored.velocity == first.velocity));
  }
} // namespace

BOOST_AUTO_TEST_CASE(a_distributed_body_is_the_direct_one_in_2d)
{
  check_same_body<2>();
}

BOOST_AUTO_TEST_CASE(a_distributed_body_is_the_direct_one_in_3d)
{
  check_same_body<3>();
}

BOOST_AUTO_TEST_CASE(a_distributed_body_has_enhanced_elements_as_the_direct_one)
{
  BodyModel enhanced;
  enhanced.elements = ElementKind::enhanced;
  check_same_body<2>(enhanced);
  check_same_body<3>(enhanced);
}

BOOST_AUTO_TEST_CASE(a_distributed_body_has_no_springs_at_its_hub)
{
  for (const Hub hub : {Hub::elastic, Hub::mass})
    {
      ShapeParameters parameters;
      parameters.radius = 0.46;
      parameters.hub    = hub;
      BOOST_CHECK_THROW(DistributedBody<2>(make_body_shape("disc", parameters),
                                           steel,
                                           0.02,
                                           grading<2>(0.7),
                                           0),
                        InputError);
    }
}

BOOST_AUTO_TEST_CASE(a_distributed_body_moves_like_the_direct_one)
{
  check_same_motion<2>(MassKind::lumped);
  check_same_motion<2>(MassKind::consistent);
  check_same_motion<3>(MassKind::lumped);
}

namespace
{
  ContactOperators frictional_operators(const DenseMatrix &W,
                                        const bool         coupled)
  {
    const unsigned int n = W.rows() / 2;
    SparseRows         H(n);
    for (unsigned int i = 0; i < n; ++i)
      H.add(i, i, 1.);
    Trace trace;
    for (unsigned int i = 0; i < n; ++i)
      trace.nodes.push_back({{double(i), 0.}});
    return {trace.nodes,
            H,
            W,
            SlipOperator(
              trace, SlipOperatorKind::upwind_1, ContactMatrices::lumped, 1),
            {coupled, 0.}};
  }
} // namespace

BOOST_AUTO_TEST_CASE(a_secant_update_keeps_earlier_ones)
{
  // W0 a part of W: the change is positive, and of low rank here
  const unsigned int n     = 6;
  DenseMatrix        first = DenseMatrix::Zero(2 * n, 2 * n),
              exact        = DenseMatrix::Zero(2 * n, 2 * n);
  for (unsigned int j = 0; j < 2 * n; ++j)
    for (unsigned int i = 0; i < 2 * n; ++i)
      {
        first(i, j) = 1. / (1 + std::abs(double(i) - j));
        exact(i, j) = first(i, j) + 0.1 +
                      0.05 * std::cos(0.3 * i) * std::cos(0.3 * j) +
                      0.02 * std::sin(1. + i) * std::sin(1. + j);
      }
  ContactOperators operators = frictional_operators(first, true);
  const auto product = [](const DenseMatrix &W, const std::vector<double> &r) {
    return W * r;
  };
  std::vector<std::vector<double>> known;
  for (unsigned int k = 0; k < 3; ++k)
    {
      std::vector<double> forces(2 * n);
      for (unsigned int i = 0; i < 2 * n; ++i)
        forces[i] = std::sin((1. + k) * (1. + i));
      known.push_back(forces);
      BOOST_TEST(relative_difference(product(exact, forces),
                                     product(operators.W().dense(), forces)) >
                 1e-3);
      operators.correct(forces, product(exact, forces));
      for (const auto &forces : known)
        BOOST_TEST(relative_difference(product(exact, forces),
                                       product(operators.W().dense(), forces)) <
                   1e-12);
    }
  // three forces tell all about a change of rank three
  for (unsigned int j = 0; j < 2 * n; ++j)
    for (unsigned int i = 0; i < 2 * n; ++i)
      {
        BOOST_TEST(std::abs(operators.W()(i, j) - exact(i, j)) < 1e-10);
        BOOST_TEST(operators.W()(i, j) == operators.W()(j, i));
      }
}

BOOST_AUTO_TEST_CASE(the_error_of_a_response_does_not_change_the_compliance)
{
  // twins pressed together: no traction, or rounding of it, and what a
  // difference of two equal motions leaves
  const unsigned int n = 4;
  for (const double traction : {0., 1e-14})
    {
      const DenseMatrix   identity  = DenseMatrix::Identity(2 * n, 2 * n);
      ContactOperators    operators = frictional_operators(identity, false);
      std::vector<double> forces(2 * n, 1.), displacement(2 * n, 2.);
      for (unsigned int i = 0; i < n; ++i)
        {
          forces[i]       = i % 2 == 0 ? traction : -traction;
          displacement[i] = 1e-12 * std::cos(3. * i);
        }
      operators.correct(forces, displacement);
      for (unsigned int j = 0; j < 2 * n; ++j)
        for (unsigned int i = 0; i < 2 * n; ++i)
          if (i < n || j < n)
            BOOST_TEST(operators.W()(i, j) == (i == j ? 1. : 0.));
      const std::vector<double> answer =
        operators.W().product(n, n, n, std::vector<double>(n, 1.));
      for (const double value : answer)
        BOOST_TEST(std::abs(value - 2.) < 1e-14);
    }
}

namespace
{
  /**
   * The same scene with both kinds of bodies.
   */
  template <int dim>
  void check_same_state(const std::function<void(SceneParameters &)> &scene)
  {
    const auto run = [&](const BodySolver solver) {
      return SceneRun<dim>(scene, [&](SceneParameters &parameters) {
        parameters.body_solver = solver;
      });
    };
    const auto direct = run(BodySolver::direct),
               spread = run(BodySolver::distributed);
    BOOST_TEST(direct.steady.solver.converged);
    BOOST_TEST(spread.steady.solver.converged);
    const Resultants &one = direct.steady.result, &other = spread.steady.result;
    BOOST_TEST_MESSAGE(spread.steady.solver.corrections << " corrections");
    const double friction =
      direct.steady.problem.loads.friction[0] * one.normal_force;
    BOOST_TEST(std::abs(one.normal_force - other.normal_force) <
               1e-8 * one.normal_force);
    BOOST_TEST(std::abs(one.force_x - other.force_x) < 1e-8 * friction);
    BOOST_TEST(std::abs(one.force_y - other.force_y) < 1e-8 * friction);
    BOOST_TEST(spread.steady.solver.corrections <= 12u);
  }
} // namespace

BOOST_AUTO_TEST_CASE(states_in_2d_are_the_same)
{
  check_same_state<2>([](SceneParameters &scene) {
    scene.mesh.elements_across_patch = 24;
    scene.contact.approach           = 0.22e-3;
  });
}

BOOST_AUTO_TEST_CASE(coupled_states_in_2d_are_the_same)
{
  check_same_state<2>([](SceneParameters &scene) {
    scene.mesh.elements_across_patch  = 24;
    scene.contact.approach            = 0.22e-3;
    scene.rail.material.young_modulus = 70e9;
    scene.rail.material.poisson_ratio = 0.33;
  });
}

BOOST_AUTO_TEST_SUITE_END()
