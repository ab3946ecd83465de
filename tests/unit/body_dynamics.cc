#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/lac/vector.h>

#include <boost/test/unit_test.hpp>

#include "plain_stepper.h"

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/bodies/direct_body.h>
#include <rolling_contact/scene/body_parameters.h>

#include <cmath>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(dynamics)

namespace
{
  const double   pi         = std::acos(-1.);
  const double   half_width = 4e-3;
  const Material steel{210e9, 0.3, 7850.};

  template <int dim>
  Grading<dim> grading(const double growth)
  {
    Grading<dim> result;
    result.element_size_x = half_width / 6;
    result.element_size_y = half_width / 6;
    result.zone_x         = 1.5 * half_width;
    result.zone_y         = 1.5 * half_width;
    result.zone_depth     = 0.75 * half_width;
    result.growth         = growth;
    return result;
  }

  std::shared_ptr<const BodyShape> disc(const bool clamped = true)
  {
    ShapeParameters parameters;
    parameters.radius     = 0.46;
    parameters.hub_radius = 0.08;
    parameters.hub        = clamped ? Hub::clamped : Hub::free;
    return make_body_shape("disc", parameters);
  }

  const double block_length = 0.4, block_depth = 0.2, block_width = 0.1;

  std::shared_ptr<const BodyShape> block(const bool clamped)
  {
    ShapeParameters parameters;
    parameters.radius       = 0.;
    parameters.block_length = block_length;
    parameters.block_depth  = block_depth;
    parameters.width        = block_width;
    parameters.hub          = clamped ? Hub::clamped : Hub::free;
    return make_body_shape("block", parameters);
  }

  /**
   * Coordinate @p d of the node of each unknown.
   */
  template <int dim>
  std::vector<double> coordinates(const DirectBody<dim> &body,
                                  const unsigned int     d)
  {
    std::vector<dealii::Point<dim>> points(body.dof_handler().n_dofs());
    dealii::DoFTools::map_dofs_to_support_points(
      dealii::StaticMappingQ1<dim>::mapping, body.dof_handler(), points);
    BodyField field(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      field[i] = points[i][d];
    return body.unknowns_of(field);
  }

  double product(const std::vector<double>   &x,
                 const SymmetricSparseMatrix &matrix,
                 const std::vector<double>   &y)
  {
    std::vector<double> result(y.size());
    matrix.multiply(y, result);
    return dot(x, result);
  }

  /**
   * Mass, first and, for the consistent one, second moments of a free block,
   * over the exact ones.
   */
  template <int dim>
  void check_mass_of_a_block(const double thickness)
  {
    const DirectBody<dim> body(block(false),
                               steel,
                               thickness,
                               grading<dim>(0.7));
    BOOST_REQUIRE(body.n_unknowns() < body.dof_handler().n_dofs());
    const double width = dim == 2 ? thickness : block_width,
                 mass  = steel.density * block_length * block_depth * width;
    const std::vector<double> x = coordinates(body, 0),
                              z = coordinates(body, dim - 1);
    for (const MassKind kind : {MassKind::lumped, MassKind::consistent})
      {
        const SymmetricSparseMatrix M = body.mass(kind);
        BOOST_TEST((M.values.size() == M.size()) == (kind == MassKind::lumped));
        for (int d = 0; d < dim; ++d)
          {
            const auto one = body.uniform(d, 1.);
            BOOST_TEST(std::abs(product(one, M, one) / mass - 1) < 1e-12);
            BOOST_TEST(std::abs(product(one, M, x)) < 1e-12 * mass);
            BOOST_TEST(std::abs(product(one, M, z) / mass + block_depth / 2) <
                       1e-12);
            auto moment = one;
            for (std::size_t i = 0; i < x.size(); ++i)
              moment[i] *= x[i];
            const double ratio = product(moment, M, moment) /
                                 (mass * std::pow(block_length, 2) / 12);
            BOOST_TEST(std::abs(ratio - 1) <
                       (kind == MassKind::lumped ? 0.1 : 1e-12));
            BOOST_TEST((kind == MassKind::consistent || ratio > 1.));
          }
        if (kind == MassKind::lumped)
          BOOST_TEST(*std::min_element(M.values.begin(), M.values.end()) > 0.);
      }
  }

  /**
   * First longitudinal frequency of a clamped block with nu = 0 by time
   * stepping, the scheme's own period error taken out, over c / (4 L).
   */
  double frequency_ratio(const MassKind kind, const double growth)
  {
    const Material      material{210e9, 0., 7850.};
    const DirectBody<2> body(block(true), material, 0.02, grading<2>(growth));
    const double        length       = block_depth,
                 period              = 4 * length / std::sqrt(210e9 / 7850.),
                 h                   = period / 100;
    const SymmetricSparseMatrix M    = body.mass(kind);
    const std::vector<double>   z    = coordinates(body, 1);
    std::vector<double>         mode = body.uniform(1, 1.), M_mode(mode.size());
    for (std::size_t i = 0; i < mode.size(); ++i)
      mode[i] *= std::sin(pi / 2 * (z[i] + length) / length);
    M.multiply(mode, M_mode);
    PlainStepper stepper(
      std::make_shared<ThetaSystem>(ThetaScheme(),
                                    body.stiffness(),
                                    M,
                                    body.nodes_of_unknowns(),
                                    std::vector<std::size_t>()));
    stepper.set_time_step(h);
    stepper.set_state(mode, std::vector<double>(mode.size(), 0.));
    // the amplitude passes through zero after 1/4, 3/4, ... periods
    double       before = dot(M_mode, mode), last_zero = 0.;
    unsigned int n_zeros = 0;
    for (unsigned int step = 1; n_zeros < 7; ++step)
      {
        stepper.begin_step();
        stepper.end_step({});
        const double after = dot(M_mode, stepper.displacements());
        if (after * before < 0.)
          {
            ++n_zeros;
            last_zero = h * (step - 1 + before / (before - after));
          }
        before = after;
      }
    const double omega = (n_zeros - 0.5) * pi / last_zero;
    return 2 / h * std::tan(omega * h / 2) / (2 * pi / period);
  }
} // namespace

BOOST_AUTO_TEST_CASE(mass_is_density_times_volume)
{
  check_mass_of_a_block<2>(0.02);
  check_mass_of_a_block<3>(1.);

  const double exact      = 7850. * 0.02 * pi * (0.46 * 0.46 - 0.08 * 0.08);
  double       last_error = 1.;
  for (const double growth : {0.4, 0.1})
    {
      const DirectBody<2> body(disc(false), steel, 0.02, grading<2>(growth));
      const auto          one  = body.uniform(1, 1.);
      const double        mass = product(one, body.mass(), one),
                   meshed =
                     7850. * 0.02 *
                     dealii::GridTools::volume(*body.mesh().triangulation);
      BOOST_TEST(std::abs(mass / meshed - 1) < 1e-12);
      BOOST_TEST(std::abs(mass / exact - 1) < last_error / 2);
      last_error = std::abs(mass / exact - 1);
      BOOST_TEST_MESSAGE("disc " << last_error);
    }
  BOOST_TEST(last_error < 3e-3);
}

BOOST_AUTO_TEST_CASE(first_longitudinal_frequency)
{
  const double lumped     = frequency_ratio(MassKind::lumped, 0.1),
               consistent = frequency_ratio(MassKind::consistent, 0.1),
               coarse     = frequency_ratio(MassKind::lumped, 0.4);
  BOOST_TEST_MESSAGE("lumped " << lumped << ", coarse " << coarse
                               << ", consistent " << consistent);
  BOOST_TEST(std::abs(lumped - 1) < 1e-3);
  BOOST_TEST(std::abs(consistent - 1) < 1e-3);
  BOOST_TEST(std::abs(lumped - 1) < std::abs(coarse - 1) / 4);
  // linear elements with their consistent mass bound frequencies from above
  BOOST_TEST(consistent > 1.);
  BOOST_TEST(lumped < 1.);
}

BOOST_AUTO_TEST_CASE(a_slow_step_is_static)
{
  DirectBody<2> body(disc(), steel, 0.02, grading<2>(0.5));
  std::vector<ElasticBody<2>::SurfaceNode> nodes;
  std::vector<ElasticBody<2>::SurfaceFace> faces;
  body.surface(grading<2>(0.5), nodes, faces);
  const std::vector<unsigned int> components{0, 1};
  const auto                      contact = body.unknowns(nodes, components);
  const DenseMatrix               W       = body.compliance(nodes, components);
  PlainStepper stepper(std::make_shared<ThetaSystem>(ThetaScheme{1., 0., 0.},
                                                     body.stiffness(),
                                                     body.mass(),
                                                     body.nodes_of_unknowns(),
                                                     contact));
  stepper.set_time_step(10.);
  const DenseMatrix &shifted    = stepper.system->contact_compliance();
  double             difference = 0.;
  for (std::size_t j = 0; j < contact.size(); ++j)
    for (std::size_t i = 0; i < contact.size(); ++i)
      difference = std::max(difference, std::abs(shifted(i, j) - W(i, j)));
  BOOST_TEST(difference < 1e-8 * W(0, 0));

  // and so is the response to reactions, everywhere in the body
  std::vector<double> forces(contact.size());
  for (std::size_t i = 0; i < forces.size(); ++i)
    forces[i] = 1e3 * std::sin(1. + i);
  stepper.begin_step();
  stepper.end_step(forces);
  BodyField field = body.field(stepper.displacements()),
            exact = body.recover(nodes, components, {forces}).front();
  field -= exact;
  BOOST_TEST(field.linfty_norm() < 1e-7 * exact.linfty_norm());
}

BOOST_AUTO_TEST_CASE(a_static_state_stays_put)
{
  const DirectBody<2> body(disc(), steel, 0.02, grading<2>(0.5));
  std::vector<ElasticBody<2>::SurfaceNode> nodes;
  std::vector<ElasticBody<2>::SurfaceFace> faces;
  body.surface(grading<2>(0.5), nodes, faces);
  const auto    contact = body.unknowns(nodes, {0, 1});
  Factorisation K(body.stiffness(), body.nodes_of_unknowns());
  K.factorise();
  std::vector<double> load(body.n_unknowns(), 0.);
  for (const std::size_t i : contact)
    load[i] = -1e3;
  const std::vector<double> initial = K.solve(load);
  PlainStepper              stepper(std::make_shared<ThetaSystem>(ThetaScheme(),
                                                     body.stiffness(),
                                                     body.mass(),
                                                     body.nodes_of_unknowns(),
                                                     contact));
  stepper.set_time_step(1e-6);
  stepper.set_state(initial, std::vector<double>(initial.size(), 0.));
  for (unsigned int step = 0; step < 1000; ++step)
    {
      stepper.begin_step();
      stepper.end_step(std::vector<double>(contact.size(), -1e3));
    }
  double drift = 0., largest = 0.;
  for (std::size_t i = 0; i < initial.size(); ++i)
    {
      drift =
        std::max(drift, std::abs(stepper.displacements()[i] - initial[i]));
      largest = std::max(largest, std::abs(initial[i]));
    }
  BOOST_TEST(drift < 1e-8 * largest);
}

BOOST_AUTO_TEST_CASE(a_free_body_flies_on)
{
  DirectBody<2> body(block(false), steel, 0.02, grading<2>(0.7));
  BOOST_CHECK_THROW(body.compliance({}, {}), InputError);
  PlainStepper stepper(
    std::make_shared<ThetaSystem>(ThetaScheme(),
                                  body.stiffness(),
                                  body.mass(),
                                  body.nodes_of_unknowns(),
                                  std::vector<std::size_t>()));
  stepper.set_time_step(1e-5);
  stepper.set_state(body.uniform(0, 0.), body.uniform(1, -3.));
  const double mass = 7850. * 0.4 * 0.2 * 0.02;
  BOOST_TEST(std::abs(stepper.energy().kinetic / (mass * 4.5) - 1) < 1e-12);
  for (unsigned int step = 0; step < 20; ++step)
    {
      stepper.begin_step();
      stepper.end_step({});
    }
  const auto expected = body.uniform(1, -3. * 20 * 1e-5);
  double     largest  = 0.;
  for (std::size_t i = 0; i < expected.size(); ++i)
    largest =
      std::max(largest, std::abs(stepper.displacements()[i] - expected[i]));
  BOOST_TEST(largest < 1e-9 * 6e-4);
}

BOOST_AUTO_TEST_CASE(parameters_of_a_body_in_time)
{
  BodySpec body{BodyParameters("Body of this test")};
  BOOST_TEST(body.body_shape()->hub_clamped());
  body.hub = Hub::free;
  body.check(2);
  BOOST_TEST(!body.body_shape()->hub_clamped());
  const BodySpec another{BodyParameters("Another")};
  BOOST_TEST(!body.body_shape()->is_twin_of(*another.body_shape()));
  body.rigid = true;
  BOOST_CHECK_THROW(body.check(2), InputError);
  BodyParameters weightless("A third");
  weightless.material.density = 0.;
  BOOST_CHECK_THROW(weightless.check(2), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
