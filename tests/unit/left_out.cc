#include <deal.II/lac/vector.h>

#include "scene_run.h"

#include <rolling_contact/algebra/factorisation.h>

using namespace RollingContact;

/** What a scene does not need does not exist. */
BOOST_AUTO_TEST_SUITE(left_out)

namespace
{
  struct WorkBefore
  {
    const Factorisation::Work at_start = Factorisation::work_done();
  };

  /** The inferred data set S2D at 12 elements, solved, and the work it took. */
  struct Run
    : public WorkBefore
    , public SceneRun<2>
  {
    explicit Run(const Change &change)
      : SceneRun<2>(
          [](SceneParameters &scene) {
            scene.mesh.elements_across_patch = 12;
            scene.contact.approach           = 0.22e-3;
          },
          change)
      , at_end(Factorisation::work_done())
    {}

    std::uint64_t n_factorisations() const
    {
      return at_end.n_factorisations - at_start.n_factorisations;
    }

    std::uint64_t n_columns() const
    {
      return at_end.n_condensed_columns - at_start.n_condensed_columns;
    }

    std::uint64_t n_solves() const
    {
      return at_end.n_solves - at_start.n_solves;
    }

    const Factorisation::Work at_end;
  };

  void separate_bodies(SceneParameters &scene)
  {
    scene.rail.material.young_modulus *= 1.01;
  }
} // namespace

BOOST_AUTO_TEST_CASE(twins_are_factorised_once)
{
  const Run twins([](SceneParameters &) {});
  BOOST_TEST(twins.n_factorisations() == 1u);
  BOOST_TEST(twins.n_columns() == 2 * twins.steady.problem.n_nodes());
  BOOST_TEST(twins.n_solves() == 0u);

  const Run different(separate_bodies);
  BOOST_TEST(different.n_factorisations() == 2u);
  BOOST_TEST(different.n_columns() == 4 * different.steady.problem.n_nodes());
}

BOOST_AUTO_TEST_CASE(a_frictionless_contact_condenses_normal_columns)
{
  const Run             run([](SceneParameters &scene) {
    separate_bodies(scene);
    scene.contact.friction_coefficient = 0.;
  });
  const ContactProblem &problem = run.steady.problem;
  BOOST_TEST(run.n_columns() == 2 * problem.n_nodes());
  BOOST_TEST(problem.operators.W().rows() == problem.n_nodes());
  BOOST_TEST(problem.operators.W().memory_consumption() ==
             problem.n_nodes() * problem.n_nodes() * sizeof(double));
  BOOST_TEST(problem.operators.slip_operator().rows().size() == 0u);
  BOOST_TEST(problem.rigid_slip().empty());
  BOOST_TEST(run.steady.state.traction.empty());
}

BOOST_AUTO_TEST_CASE(a_rigid_rail_is_neither_factorised_nor_condensed)
{
  const Run run([](SceneParameters &scene) { scene.rail.rigid = true; });
  BOOST_TEST(run.n_factorisations() == 1u);
  BOOST_TEST(run.n_columns() == 2 * run.steady.problem.n_nodes());
  BOOST_TEST((run.steady.pair->bodies().body(Side::rail) == nullptr));
}

BOOST_AUTO_TEST_CASE(a_factor_lives_only_for_displacements)
{
  const auto displacement = [](const Run &run) {
    return run.steady.pair->displacement(Side::wheel,
                                         run.steady.problem,
                                         run.steady.state);
  };
  const Run fields([](SceneParameters &) {});
  BOOST_TEST(displacement(fields).l2_norm() > 0.);
  BOOST_TEST(Factorisation::work_done().n_solves == fields.at_end.n_solves + 1);

  const Run none(
    [](SceneParameters &scene) { scene.output.body_fields = false; });
  BOOST_CHECK_THROW(displacement(none), std::logic_error);
  BOOST_TEST(none.steady.result.normal_force ==
             fields.steady.result.normal_force);
  BOOST_TEST(none.steady.pair->bodies().body(Side::wheel)->solver_memory() >
             0u);
}

BOOST_AUTO_TEST_SUITE_END()
