#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <boost/test/unit_test.hpp>

#include "../references/slender_bodies.h"
#include "plain_stepper.h"
#include "scene_run.h"

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/bodies/direct_body.h>
#include <rolling_contact/modes/body_places.h>
#include <rolling_contact/program/analysis_table.h>
#include <rolling_contact/scene/body_parameters.h>
#include <rolling_contact/scene/known_entries.h>
#include <rolling_contact/scene/plausibility.h>

#include <cmath>
#include <set>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(supports)

namespace
{
  const double   pi = std::acos(-1.);
  const Material steel{210e9, 0.3, 7850.};

  const double length = 1.2, depth = 0.15, width = 0.1;

  template <int dim>
  Grading<dim> grading()
  {
    Grading<dim> result;
    result.element_size_x = result.element_size_y = 5e-3;
    result.zone_x = result.zone_y = 1e-2;
    result.zone_depth             = 5e-3;
    result.growth                 = 0.7;
    return result;
  }

  std::shared_ptr<const BodyShape> block(const Hub    hub,
                                         const double block_length = length)
  {
    ShapeParameters parameters;
    parameters.radius       = 0.;
    parameters.block_length = block_length;
    parameters.block_depth  = depth;
    parameters.width        = width;
    parameters.hub          = hub;
    return make_body_shape("block", parameters);
  }

  std::shared_ptr<const BodyShape> disc(const Hub hub)
  {
    ShapeParameters parameters;
    parameters.radius     = 0.46;
    parameters.hub_radius = 0.08;
    parameters.width      = width;
    parameters.hub        = hub;
    return make_body_shape("disc", parameters);
  }

  BodyModel
  on_layer(const double x = 2e8, const double y = 3e8, const double z = 5e8)
  {
    BodyModel model;
    model.foundation.stiffness   = {{x, y, z}};
    model.foundation.loss_factor = 0.2;
    return model;
  }

  BodyModel on_sleepers()
  {
    BodyModel model                      = on_layer();
    model.foundation.pad_spacing         = 0.4;
    model.foundation.pad_length          = 0.11;
    model.foundation.sleeper_mass        = 120.;
    model.foundation.ballast_stiffness   = {{3e7, 4e7, 6e7}};
    model.foundation.ballast_loss_factor = 0.7;
    return model;
  }

  BodyModel with_axle()
  {
    BodyModel model;
    model.hub_mass = {300., {{40., 12., 40.}}};
    return model;
  }

  double product(const std::vector<double>   &x,
                 const SymmetricSparseMatrix &matrix,
                 const std::vector<double>   &y)
  {
    std::vector<double> result(y.size());
    matrix.multiply(y, result);
    return dot(x, result);
  }

  template <int dim>
  DirectBody<dim>
  make_block(const Hub hub, const BodyModel &model, const Material &of = steel)
  {
    return DirectBody<dim>(block(hub), of, width, grading<dim>(), true, model);
  }

  template <int dim>
  DenseMatrix compliance(DirectBody<dim> &body)
  {
    std::vector<typename ElasticBody<dim>::SurfaceNode> nodes;
    std::vector<typename ElasticBody<dim>::SurfaceFace> faces;
    body.surface(grading<dim>(), nodes, faces);
    std::vector<unsigned int> components;
    for (unsigned int d = 0; d < dim; ++d)
      components.push_back(d);
    return body.compliance(nodes, components);
  }

  double relative_difference(const DenseMatrix &A, const DenseMatrix &B)
  {
    return (A - B).cwiseAbs().maxCoeff() / A.cwiseAbs().maxCoeff();
  }

  /**
   * What a translation costs: foundation and, under sleepers, ballast.
   */
  template <int dim>
  void check_translations()
  {
    const auto axis = [](const int d) { return d == dim - 1 ? 2 : d; };
    const auto check =
      [&](const BodyModel &model, const double total, const bool ballast) {
        const auto                  body = make_block<dim>(Hub::elastic, model);
        const SymmetricSparseMatrix K    = body.stiffness(),
                                    D    = body.loss_stiffness();
        for (int d = 0; d < dim; ++d)
          {
            const auto  &layer = ballast ? model.foundation.ballast_stiffness
                                         : model.foundation.stiffness;
            const double k     = layer[axis(d)] * total;
            const auto   e     = body.uniform(d, 1.);
            BOOST_TEST(std::abs(product(e, K, e) / k - 1) < 1e-9);
            const double eta = ballast ? model.foundation.ballast_loss_factor
                                       : model.foundation.loss_factor;
            BOOST_TEST(std::abs(product(e, D, e) / (eta * k) - 1) < 1e-9);
          }
      };
    BodyModel pads = on_layer();
    check(pads, length, false);
    pads.foundation.pad_spacing = 0.4; // at -0.4, 0, 0.4
    check(pads, 1.2, false);
    pads.foundation.pad_offset = 0.2; // at -0.2, 0.2; half pads at the ends not
    check(pads, 0.8, false);
    check(on_sleepers(), 1.2, true);
  }

  /**
   * The rotation of a body on its axle about the hub, by nodes: what one unit
   * of the extra unknown does.
   */
  template <int dim>
  std::vector<double> rotation(const DirectBody<dim> &body,
                               const unsigned int     about)
  {
    const std::size_t   n = body.n_unknowns();
    std::vector<double> values(n, 0.);
    const unsigned int  n_turns                  = dim == 2 ? 1 : 3;
    values[n - n_turns + (dim == 2 ? 0 : about)] = 1.;
    std::vector<dealii::Point<dim>> points(body.dof_handler().n_dofs());
    dealii::DoFTools::map_dofs_to_support_points(dealii::MappingQ1<dim>(),
                                                 body.dof_handler(),
                                                 points);
    // of the hub's nodes u_a = -phi r_b and u_b = phi r_a, a and b after about
    const BodyField hub       = body.field(values);
    const auto      component = [](const unsigned int axis) {
      return axis == 2 ? dim - 1 : axis;
    };
    const unsigned int a = (about + 1) % 3, b = (about + 2) % 3;
    const auto line = [&](const unsigned int of, const unsigned int along) {
      // slope and zero of the motion of component `of` along the hub
      std::array<std::array<double, 2>, 2> ends{{{{1e9, 0.}}, {{-1e9, 0.}}}};
      for (std::size_t i = 0; i < points.size(); i += dim)
        {
          double moves = 0.;
          for (unsigned int c = 0; c < dim; ++c)
            moves += std::abs(hub[i + c]);
          const double at = points[i][component(along)];
          if (moves > 1e-12 && std::abs(points[i][0]) < 0.081 &&
              at < ends[0][0])
            ends[0] = {{at, hub[i + component(of)]}};
          if (moves > 1e-12 && std::abs(points[i][0]) < 0.081 &&
              at > ends[1][0])
            ends[1] = {{at, hub[i + component(of)]}};
        }
      const double slope =
        (ends[1][1] - ends[0][1]) / (ends[1][0] - ends[0][0]);
      return std::array<double, 2>{{slope, ends[0][0] - ends[0][1] / slope}};
    };
    const auto   of_a = line(a, b), of_b = line(b, a);
    const double phi = of_b[0];
    BOOST_TEST(std::abs(of_a[0] / phi + 1) < 1e-9);
    BOOST_TEST(phi > 0.);
    BodyField turned(hub);
    for (std::size_t i = 0; i < points.size(); ++i)
      {
        turned[i] = 0.;
        if (i % dim == component(a))
          turned[i] = -(points[i][component(b)] - of_a[1]);
        if (i % dim == component(b))
          turned[i] = points[i][component(a)] - of_b[1];
      }
    auto result = body.unknowns_of(turned);
    for (std::size_t i = n - (dim == 2 ? 3 : 6); i < n; ++i)
      result[i] = values[i] / phi;
    return result;
  }

  template <int dim>
  void check_axle()
  {
    DirectBody<dim> body(
      disc(Hub::mass), steel, width, grading<dim>(), true, with_axle());
    const DirectBody<dim> loose(disc(Hub::free), steel, width, grading<dim>());
    BOOST_CHECK_THROW(body.analyse(), InputError);
    const SymmetricSparseMatrix K       = body.stiffness(),
                                K_loose = loose.stiffness();
    const double scale = *std::max_element(K.values.begin(), K.values.end());
    for (const MassKind kind : {MassKind::lumped, MassKind::consistent})
      {
        const SymmetricSparseMatrix M = body.mass(kind), N = loose.mass(kind);
        BOOST_TEST(M.size() == body.n_unknowns());
        for (int d = 0; d < dim; ++d)
          {
            const auto e = body.uniform(d, 1.), f = loose.uniform(d, 1.);
            BOOST_TEST(std::abs(product(e, M, e) / (product(f, N, f) + 300.) -
                                1) < 1e-12);
            BOOST_TEST(std::abs(product(e, K, e)) < 1e-12 * scale);
          }
        for (unsigned int about = 0; about < 3; ++about)
          {
            if (dim == 2 && about != 1)
              continue;
            const auto turn = rotation(body, about);
            // the same on the body that nothing holds
            const BodyField field = body.field(turn);
            BodyField       nodal(loose.dof_handler().n_dofs());
            for (std::size_t i = 0; i < nodal.size(); ++i)
              nodal[i] = field[i];
            const auto   free_turn = loose.unknowns_of(nodal);
            const double inertia   = with_axle().hub_mass.inertia[about];
            BOOST_TEST(std::abs(product(turn, M, turn) /
                                  (product(free_turn, N, free_turn) + inertia) -
                                1) < 1e-9);
            // hanging nodes of curved surfaces do not turn without strain
            BOOST_TEST(std::abs(product(turn, K, turn) -
                                product(free_turn, K_loose, free_turn)) <
                       1e-12 * scale);
          }
      }
  }

  /**
   * Largest relative error of the energy balance over some steps from a state
   * without pattern.
   */
  template <int dim>
  double balance_error(const DirectBody<dim> &body, double &damping)
  {
    PlainStepper stepper(
      std::make_shared<ThetaSystem>(ThetaScheme{0.6, 3., 1e-6},
                                    body.stiffness(),
                                    body.mass(),
                                    body.nodes_of_unknowns(),
                                    std::vector<std::size_t>(),
                                    body.damping_in_time()));
    stepper.set_time_step(1e-5);
    std::vector<double> u(body.n_unknowns()), v(u);
    for (std::size_t i = 0; i < u.size(); ++i)
      {
        u[i] = 1e-6 * std::sin(1. + 7.3 * i * i);
        v[i] = 1e-2 * std::sin(2. + 5.1 * i * i);
      }
    stepper.set_state(u, v);
    const double scale   = stepper.energy().kinetic + stepper.energy().strain;
    double       largest = 0.;
    for (unsigned int step = 0; step < 20; ++step)
      {
        stepper.begin_step();
        stepper.end_step({});
        largest = std::max(largest, std::abs(stepper.energy().balance_error));
        damping += stepper.energy().damping / scale;
      }
    return largest / scale;
  }
} // namespace

BOOST_AUTO_TEST_CASE(a_translation_costs_what_the_supports_say)
{
  check_translations<2>();
  check_translations<3>();
}

BOOST_AUTO_TEST_CASE(a_stiff_foundation_is_a_clamped_sole)
{
  auto clamped        = make_block<3>(Hub::clamped, {}),
       stiff          = make_block<3>(Hub::elastic, on_layer(1e18, 1e18, 1e18)),
       soft           = make_block<3>(Hub::elastic, on_layer());
  const DenseMatrix W = compliance(clamped);
  BOOST_TEST(relative_difference(W, compliance(stiff)) < 1e-6);
  BOOST_TEST(relative_difference(W, compliance(soft)) > 0.1);
}

BOOST_AUTO_TEST_CASE(pads_and_ballast_are_springs_in_series)
{
  const BodyModel model = on_sleepers();
  const auto      body  = make_block<3>(Hub::elastic, model);
  BOOST_TEST(body.n_unknowns() ==
             make_block<3>(Hub::elastic, on_layer()).n_unknowns() + 9);
  const auto K = body.stiffness();
  for (const unsigned int c : {0, 1, 2})
    {
      const double pads    = model.foundation.stiffness[c],
                   ballast = model.foundation.ballast_stiffness[c];
      // the sleepers where they are in equilibrium
      auto moved = body.uniform(c, 1.);
      for (std::size_t i = moved.size() - 9; i < moved.size(); ++i)
        moved[i] *= pads / (pads + ballast);
      BOOST_TEST(std::abs(product(moved, K, moved) /
                            (length * pads * ballast / (pads + ballast)) -
                          1) < 1e-9);
    }
}

/** Pads stiffen what tilts as they lie, wherever the nodes of coarse cells are:
 * a field z = x - x_0 stretches the springs of a pad by its own second moment.
 */
BOOST_AUTO_TEST_CASE(pads_lie_where_they_are_on_coarse_cells)
{
  Grading<3> coarse = grading<3>();
  coarse.growth     = 10.;
  for (const double offset : {0., 0.013, 0.05, 0.11})
    {
      BodyModel model              = on_layer();
      model.foundation.pad_spacing = 0.4;
      model.foundation.pad_length  = 0.11;
      model.foundation.pad_offset  = offset;
      BodyModel twice              = model;
      for (double &k : twice.foundation.stiffness)
        k *= 2;
      const auto make = [&](const BodyModel &of) {
        return DirectBody<3>(
          block(Hub::elastic), steel, width, coarse, true, of);
      };
      const auto body = make(model), stiffer = make(twice);
      const auto field_of = [&](const auto &value) {
        std::vector<double> field(body.n_unknowns(), 0.);
        for (const auto &node : BodyPlaces(body).nodes)
          field[node.unknowns[2]] = value(node.point);
        return field;
      };
      const auto one = field_of([](const auto &) { return 1.; }),
                 x   = field_of([](const auto &at) { return at[0]; }),
                 y   = field_of([](const auto &at) { return at[1]; });
      const auto K = body.stiffness(), K_2 = stiffer.stiffness();
      const auto of_pads = [&](const auto &a, const auto &b) {
        return product(a, K_2, b) - product(a, K, b);
      };
      // springs of the pads that lie wholly under the body
      double force = 0., moment = 0., tilting = 0.;
      for (int k = -2; k <= 2; ++k)
        {
          const double middle = offset + 0.4 * k, per_pad = 5e8 * 0.4;
          if (std::abs(middle) + 0.055 > length / 2)
            continue;
          force += per_pad;
          moment += per_pad * middle;
          tilting += per_pad * (middle * middle + 0.11 * 0.11 / 12);
        }
      BOOST_TEST(of_pads(one, one) == force,
                 boost::test_tools::tolerance(1e-9));
      BOOST_TEST(std::abs(of_pads(one, x) - moment) < 1e-8 * force * length);
      BOOST_TEST(of_pads(x, x) == tilting, boost::test_tools::tolerance(1e-7));
      BOOST_TEST(of_pads(y, y) == force * width * width / 12,
                 boost::test_tools::tolerance(1e-7));
    }
}

BOOST_AUTO_TEST_CASE(sleepers_have_their_masses)
{
  const auto   body = make_block<3>(Hub::elastic, on_sleepers());
  const double mass = steel.density * length * depth * width + 3 * 120.;
  for (const MassKind kind : {MassKind::lumped, MassKind::consistent})
    {
      const auto e = body.uniform(2, 1.);
      BOOST_TEST(std::abs(product(e, body.mass(kind), e) / mass - 1) < 1e-12);
    }
  const auto order = body.portable_dof_order();
  BOOST_TEST(order.size() == body.n_unknowns());
  BOOST_TEST(std::set<std::size_t>(order.begin(), order.end()).size() ==
             order.size());
  auto values = body.uniform(0, 1.);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = i + 1.;
  BOOST_TEST(body.unknowns_of(body.field(values)) == values);
}

namespace
{
  /**
   * Stiffness or masses of the supports alone, of a mesh with one boundary as
   * the hub, turned about x by an @p angle.
   */
  struct TurnedMesh
  {
    explicit TurnedMesh(const double angle)
      : element(dealii::FE_Q<3>(1), 3)
      , up({0., -std::sin(angle), std::cos(angle)})
      , across({0., std::cos(angle), std::sin(angle)})
      , angle(angle)
    {}

    void turn()
    {
      dealii::GridTools::rotate(dealii::Tensor<1, 3>({1., 0., 0.}),
                                angle,
                                mesh);
      dofs.reinit(mesh);
      dofs.distribute_dofs(element);
    }

    dealii::FESystem<3>      element;
    dealii::Triangulation<3> mesh;
    dealii::DoFHandler<3>    dofs;
    dealii::Tensor<1, 3>     up, across;
    double                   angle;
  };

  /** What a translation of all nodes along @p direction costs. */
  double cost(const TurnedMesh           &turned,
              const Supports<3>          &supports,
              const dealii::Tensor<1, 3> &direction)
  {
    dealii::AffineConstraints<double> none;
    none.close();
    dealii::DynamicSparsityPattern pattern(turned.dofs.n_dofs() +
                                           supports.n_extra());
    dealii::DoFTools::make_sparsity_pattern(turned.dofs, pattern);
    supports.add_couplings(none, pattern);
    dealii::SparsityPattern sparsity;
    sparsity.copy_from(pattern);
    dealii::SparseMatrix<double> K(sparsity);
    supports.add_stiffness(none, 1., 1., K);
    dealii::Vector<double> moved(K.m());
    for (unsigned int i = 0; i < turned.dofs.n_dofs(); ++i)
      moved[i] = direction[i % 3];
    return K.matrix_norm_square(moved);
  }
} // namespace

BOOST_AUTO_TEST_CASE(springs_of_a_turned_sole_are_along_its_normal)
{
  for (const double angle : {0., 0.3, -1.1})
    {
      TurnedMesh turned(angle);
      dealii::GridGenerator::subdivided_hyper_rectangle(
        turned.mesh,
        {12, 2, 2},
        dealii::Point<3>(-0.6, -0.1, -0.2),
        dealii::Point<3>(0.6, 0.1, 0.));
      for (const auto &cell : turned.mesh.active_cell_iterators())
        if (cell->face(4)->at_boundary())
          cell->face(4)->set_boundary_id(hub_boundary);
      turned.turn();
      BodyModel         model = on_layer(1e8, 2e8, 5e8);
      const Supports<3> layer(turned.dofs, Hub::elastic, model);
      BOOST_TEST(std::abs(cost(turned, layer, turned.up) / 6e8 - 1) < 1e-9);
      BOOST_TEST(std::abs(cost(turned, layer, turned.across) / 2.4e8 - 1) <
                 1e-9);
      model                        = on_sleepers();
      model.foundation.pad_spacing = 0.4;
      const Supports<3> sleepers(turned.dofs, Hub::elastic, model);
      BOOST_TEST(sleepers.n_extra() == 9u);
      // sleepers at rest: the pads alone
      BOOST_TEST(std::abs(cost(turned, sleepers, turned.up) / 6e8 - 1) < 1e-9);
    }
}

BOOST_AUTO_TEST_CASE(inertia_of_an_axle_is_about_its_bore)
{
  const double angle = 0.7;
  TurnedMesh   turned(angle);
  dealii::GridGenerator::cylinder_shell(turned.mesh, 0.2, 0.1, 0.3, 12, 1);
  // from the axis z to y
  dealii::GridTools::rotate(dealii::Tensor<1, 3>({1., 0., 0.}),
                            -pi / 2,
                            turned.mesh);
  for (const auto &cell : turned.mesh.active_cell_iterators())
    for (const auto f : cell->face_indices())
      {
        const auto middle = cell->face(f)->center();
        if (cell->face(f)->at_boundary() &&
            std::hypot(middle[0], middle[2]) < 0.11 &&
            std::abs(std::abs(middle[1] - 0.1) - 0.1) > 0.01)
          cell->face(f)->set_boundary_id(hub_boundary);
      }
  turned.turn();
  BodyModel model;
  model.hub_mass = {10., {{3., 7., 3.}}};
  const Supports<3> axle(turned.dofs, Hub::mass, model);
  BOOST_TEST(axle.n_extra() == 6u);
  double along = 0., about_x = 0., sum = 0.;
  for (const auto &[i, j, value] : axle.masses())
    if (i > 2)
      {
        along += turned.across[i - 3] * value * turned.across[j - 3];
        about_x += i == 3 && j == 3 ? value : 0.;
        sum += i == j ? value : 0.;
      }
  BOOST_TEST(std::abs(along / sum - 7. / 13) < 1e-9);
  BOOST_TEST(std::abs(about_x / sum - 3. / 13) < 1e-9);
}

BOOST_AUTO_TEST_CASE(a_body_on_its_axle_moves_as_one)
{
  check_axle<2>();
  check_axle<3>();
}

BOOST_AUTO_TEST_CASE(what_nothing_holds_has_no_compliance)
{
  for (const unsigned int c : {0, 1, 2})
    {
      BodyModel model               = on_layer();
      model.foundation.stiffness[c] = 0.;
      auto body                     = make_block<3>(Hub::elastic, model);
      BOOST_CHECK_THROW(body.analyse(), InputError);
    }
  BodyModel model                       = on_sleepers();
  model.foundation.ballast_stiffness[1] = 0.;
  auto body                             = make_block<3>(Hub::elastic, model);
  BOOST_CHECK_THROW(body.analyse(), InputError);
  model                        = on_layer();
  model.foundation.pad_spacing = 5.;
  model.foundation.pad_offset  = 2.;
  BOOST_CHECK_THROW(make_block<2>(Hub::elastic, model), InputError);
}

BOOST_AUTO_TEST_CASE(a_long_block_bends_on_its_foundation)
{
  BodyModel model = on_layer(1e7, 0., 1e7);
  model.elements  = ElementKind::enhanced;
  Grading<2> fine = grading<2>();
  fine.growth     = 0.35;
  DirectBody<2> body(block(Hub::elastic, 12.), steel, width, fine, true, model);
  std::vector<ElasticBody<2>::SurfaceNode> nodes;
  std::vector<ElasticBody<2>::SurfaceFace> faces;
  body.surface(fine, nodes, faces);
  const DenseMatrix W = body.compliance(nodes, {1});
  const double      E = steel.young_modulus / (1 - 0.09),
               I      = width * std::pow(depth, 3) / 12;
  double mean         = 0.;
  for (std::size_t j = 0; j < nodes.size(); ++j)
    for (std::size_t i = 0; i < nodes.size(); ++i)
      mean += W(i, j) / (nodes.size() * nodes.size());
  const double ratio = mean / References::winkler_beam_compliance(E * I, 1e7);
  BOOST_TEST_MESSAGE("block on a foundation over Winkler: " << ratio);
  BOOST_TEST(std::abs(ratio - 1) < 0.03);
}

BOOST_AUTO_TEST_CASE(the_energy_balance_closes_with_all_damping)
{
  BodyModel model                 = on_sleepers();
  model.damping.loss_factor       = 0.01;
  model.damping.mass_damping      = 20.;
  model.damping.stiffness_damping = 1e-6;
  model.damping.sponge_length     = 0.3;
  double lost = 0., axle_lost = 0.;
  BOOST_TEST(balance_error(make_block<2>(Hub::elastic, model), lost) < 1e-12);
  BOOST_TEST(lost > 0.01);
  BodyModel axle           = with_axle();
  axle.damping.loss_factor = 0.1;
  const DirectBody<2> body(
    disc(Hub::mass), steel, width, grading<2>(), true, axle);
  BOOST_TEST(balance_error(body, axle_lost) < 1e-12);
  BOOST_TEST(axle_lost > 0.01);
}

BOOST_AUTO_TEST_CASE(damping_is_the_sum_of_its_parts)
{
  BodyModel model                 = on_layer();
  model.foundation.loss_factor    = 0.;
  model.damping.mass_damping      = 20.;
  model.damping.stiffness_damping = 1e-6;
  const auto body                 = make_block<2>(Hub::elastic, model);
  BOOST_TEST(make_block<2>(Hub::elastic, {}).damping_in_time().size() == 0u);
  std::vector<double> u(body.n_unknowns());
  for (std::size_t i = 0; i < u.size(); ++i)
    u[i] = std::sin(1. + 7.3 * i * i);
  const double uMu = product(u, body.mass(), u),
               uKu = product(u, body.stiffness(), u);
  BOOST_TEST(
    std::abs(product(u, body.damping_in_time(), u) / (20. * uMu + 1e-6 * uKu) -
             1) < 1e-12);

  BodyModel lossy              = on_layer();
  lossy.foundation.loss_factor = lossy.damping.loss_factor = 0.03;
  lossy.damping.loss_frequency                             = 500.;
  const auto hysteretic = make_block<2>(Hub::elastic, lossy);
  BOOST_TEST(
    std::abs(product(u, hysteretic.loss_stiffness(), u) / (0.03 * uKu) - 1) <
    1e-12);
  BOOST_TEST(std::abs(product(u, hysteretic.damping_in_time(), u) /
                        (0.03 * uKu / (2 * pi * 500.)) -
                      1) < 1e-12);
  BOOST_TEST(product(u, hysteretic.damping(), u) == 0.);
}

BOOST_AUTO_TEST_CASE(the_ends_of_a_rail_absorb)
{
  BodyModel model;
  model.damping.sponge_length = 0.4;
  model.damping.sponge_rate   = 2500.;
  const auto   body           = make_block<2>(Hub::free, model);
  const auto   e              = body.uniform(0, 1.);
  const double mass           = steel.density * depth * width * 2 * 0.4;
  // lumped at the nodes, so the integral of the square is that of a mesh
  BOOST_TEST(std::abs(product(e, body.damping(), e) / (mass * 2500. / 3) - 1) <
             0.05);
  const auto  C        = body.damping();
  std::size_t n_damped = 0;
  for (const double value : C.values)
    n_damped += value > 0.;
  BOOST_TEST(n_damped > 0u);
  BOOST_TEST(n_damped < C.size() * 2 / 3);
}

BOOST_AUTO_TEST_CASE(a_pulse_loses_in_the_ends_what_their_rate_says)
{
  // a wave has half of its energy in motion, dE/dt = -a E, more while it turns
  const Material bar{210e9, 0., 7850.};
  const double   c = std::sqrt(bar.young_modulus / bar.density), long_bar = 4.;
  BodyModel      model;
  model.damping.sponge_length = 1.2;
  model.damping.sponge_rate   = 3 * c / (2 * 1.2); // for a factor of e
  const DirectBody<2> body(
    block(Hub::free, long_bar), bar, width, grading<2>(), true, model);
  PlainStepper stepper(std::make_shared<ThetaSystem>(ThetaScheme(),
                                                     body.stiffness(),
                                                     body.mass(),
                                                     body.nodes_of_unknowns(),
                                                     std::vector<std::size_t>(),
                                                     body.damping_in_time()));
  std::vector<dealii::Point<2>> points(body.dof_handler().n_dofs());
  dealii::DoFTools::map_dofs_to_support_points(dealii::MappingQ1<2>(),
                                               body.dof_handler(),
                                               points);
  BodyField pulse(points.size());
  for (std::size_t i = 0; i < points.size(); i += 2)
    pulse[i] = 1e-6 * std::exp(-std::pow(points[i][0] / 0.1, 2));
  stepper.set_state(body.unknowns_of(pulse),
                    std::vector<double>(body.n_unknowns(), 0.));
  const double       before  = stepper.energy().strain;
  const unsigned int n_steps = 300;
  stepper.set_time_step(long_bar / c / n_steps);
  for (unsigned int step = 0; step < n_steps; ++step)
    {
      stepper.begin_step();
      stepper.end_step({});
    }
  const double after = stepper.energy().strain + stepper.energy().kinetic;
  BOOST_TEST_MESSAGE("pulse: " << std::log(before / after));
  BOOST_TEST(std::abs(std::log(before / after) - 1) < 0.05);
}

BOOST_AUTO_TEST_CASE(a_stiff_block_on_a_lossy_layer_decays)
{
  // one degree of freedom: m = rho V, k = 1e7 L, zeta = eta / 2 at its
  // frequency
  BodyModel    model = on_layer(1e7, 1e7, 1e7);
  const double eta = 0.1, k = 1e7 * length,
               m               = steel.density * length * depth * width,
               f               = std::sqrt(k / m) / (2 * pi);
  model.foundation.loss_factor = eta;
  model.damping.loss_frequency = f;
  const auto   body = make_block<2>(Hub::elastic, model, {1e15, 0.3, 7850.});
  PlainStepper stepper(std::make_shared<ThetaSystem>(ThetaScheme(),
                                                     body.stiffness(),
                                                     body.mass(),
                                                     body.nodes_of_unknowns(),
                                                     std::vector<std::size_t>(),
                                                     body.damping_in_time()));
  const unsigned int n_steps = 400, n_periods = 4;
  stepper.set_time_step(n_periods / f / n_steps);
  const auto e = body.uniform(1, 1.);
  stepper.set_state(body.uniform(1, 1e-5), body.uniform(1, 0.));
  const double before = stepper.energy().strain;
  for (unsigned int step = 0; step < n_steps; ++step)
    {
      stepper.begin_step();
      stepper.end_step({});
    }
  const double after = stepper.energy().strain + stepper.energy().kinetic,
               decay = std::log(before / after) / (2 * 2 * pi * n_periods);
  BOOST_TEST(std::abs(decay / (eta / 2) - 1) < 0.02);
}

namespace
{
  /** A disc that rolls on a block. */
  void disc_on_block(SceneParameters &scene)
  {
    scene.dimension                    = 2;
    scene.rail.shape                   = "block";
    scene.rail.radius                  = 0.;
    scene.rail.block_length            = 0.6;
    scene.rail.block_depth             = 0.15;
    scene.rail.thickness               = 0.02;
    scene.contact.normal_load          = 20e3;
    scene.contact.creepages.x          = 1e-3;
    scene.contact.friction_coefficient = 0.3;
    scene.mesh.elements_across_patch   = 12;
    scene.mesh.growth                  = 0.5;
  }

  void elastic_rail(SceneParameters &scene)
  {
    scene.rail.hub                        = Hub::elastic;
    scene.rail.model.foundation.stiffness = {{2e8, 2e8, 2e8}};
  }

  /**
   * Expects InputError with all @p words of a scene with a @p change.
   */
  void refused(const std::function<void(SceneParameters &)> &change,
               const std::vector<std::string>               &words)
  {
    SceneParameters scene;
    disc_on_block(scene);
    elastic_rail(scene);
    change(scene);
    try
      {
        scene.check();
        BOOST_ERROR("not refused: " << words[0]);
      }
    catch (const InputError &error)
      {
        for (const std::string &word : words)
          BOOST_TEST(std::string(error.what()).find(word) != std::string::npos,
                     error.what() << " lacks " << word);
      }
  }
} // namespace

BOOST_AUTO_TEST_CASE(rolling_on_a_foundation)
{
  const SceneRun<2> clamped(disc_on_block, [](SceneParameters &) {});
  const SceneRun<2> stiff(disc_on_block, [](SceneParameters &scene) {
    elastic_rail(scene);
    scene.rail.model.foundation.stiffness = {{1e18, 1e18, 1e18}};
  });
  BOOST_TEST(std::abs(stiff.force_x() - clamped.force_x()) < 1e-6);
  const SceneRun<2> soft(disc_on_block, elastic_rail);
  BOOST_TEST(std::abs(soft.force_x() - clamped.force_x()) < 0.1);
  // the block is short: it sinks by N / (k L), and turns a little
  const double sunk =
    soft.steady.state.approach - clamped.steady.state.approach;
  BOOST_TEST(std::abs(sunk / (20e3 / (2e8 * 0.6)) - 1) < 0.1);
  BOOST_TEST(!soft.steady.pair->bodies().twins());
}

BOOST_AUTO_TEST_CASE(bodies_with_unlike_models_are_no_twins)
{
  const auto equal_discs = [](SceneParameters &scene) {
    disc_on_block(scene);
    scene.rail.shape  = "disc";
    scene.rail.radius = scene.wheel.radius;
  };
  BOOST_TEST(SceneRun<2>(equal_discs, [](SceneParameters &) {})
               .steady.pair->bodies()
               .twins());
  const SceneRun<2> unlike(equal_discs, [](SceneParameters &scene) {
    scene.rail.model.elements = ElementKind::enhanced;
  });
  BOOST_TEST(!unlike.steady.pair->bodies().twins());
  const SceneRun<2> alike(equal_discs, [](SceneParameters &scene) {
    scene.wheel.model.elements = scene.rail.model.elements =
      ElementKind::enhanced;
  });
  BOOST_TEST(alike.steady.pair->bodies().twins());
  BOOST_TEST(std::abs(alike.force_x() / unlike.force_x() - 1) < 0.02);
}

BOOST_AUTO_TEST_CASE(bad_supports_are_refused)
{
  refused([](auto &scene) { scene.rail.hub = Hub::mass; },
          {"Rail/Hub mass = 0", "kg"});
  refused(
    [](auto &scene) {
      scene.rail.hub                 = Hub::mass;
      scene.rail.model.hub_mass.mass = 1.;
    },
    {"Rail/Hub = mass", "inertia", "transient"});
  refused([](auto &scene) { scene.rail.model.foundation.stiffness[2] = 0.; },
          {"Rail/Foundation stiffness z = 0", "N/m^2"});
  refused([](auto &scene) { scene.rail.model.foundation.stiffness[0] = 0.; },
          {"Rail/Foundation stiffness x = 0", "along x"});
  refused([](auto &scene) { scene.rail.rigid = true; },
          {"Rail/Hub = elastic", "Rigid"});
  const auto pads = [](SceneParameters &scene) {
    scene.rail.model.foundation.pad_spacing = 0.2;
    scene.rail.model.foundation.pad_length  = 0.1;
  };
  refused(
    [&](auto &scene) {
      pads(scene);
      scene.rail.model.foundation.pad_length = 0.3;
    },
    {"Rail/Pad length = 0.3", "0.2 m"});
  refused(
    [&](auto &scene) {
      pads(scene);
      scene.rail.model.foundation.pad_spacing = 2.;
      scene.rail.model.foundation.pad_offset  = 1.;
    },
    {"Rail/Pad spacing = 2", "0.3 m"});
  refused([](auto &scene) { scene.rail.model.foundation.sleeper_mass = 100.; },
          {"Rail/Sleeper mass = 100", "Pad spacing"});
  refused(
    [&](auto &scene) {
      pads(scene);
      scene.rail.model.foundation.sleeper_mass = 100.;
    },
    {"Rail/Ballast stiffness z = 0"});
  refused(
    [](auto &scene) {
      scene.rail.model.damping.modal = {1e-3, 1.};
    },
    {"Rail/Modal damping = 1"});
  refused([](auto &scene) { scene.rail.model.damping.loss_frequency = 0.; },
          {"Rail/Loss frequency = 0", "Hz"});
  refused([](auto &scene) { scene.rail.model.damping.sponge_length = 0.3; },
          {"Rail/Sponge length = 0.3", "half"});
  refused([](auto &scene) { scene.wheel.model.damping.sponge_length = 0.1; },
          {"Wheel/Sponge length = 0.1", "closes"});
}

BOOST_AUTO_TEST_CASE(entries_of_supports_without_effect_are_told)
{
  SceneParameters scene;
  disc_on_block(scene);
  const auto told = [&](const std::string &entry) {
    PrmEntries given;
    given["Rail/" + entry] = "1";
    return unused_entries(scene, given).size();
  };
  for (const char *entry : {"Foundation stiffness z",
                            "Foundation stiffness y",
                            "Foundation loss factor",
                            "Pad spacing",
                            "Pad length",
                            "Sleeper mass",
                            "Ballast stiffness z",
                            "Hub mass",
                            "Hub inertia y",
                            "Loss factor",
                            "Rayleigh mass",
                            "Sponge length",
                            "Modal damping"})
    BOOST_TEST(told(entry) == 1u, entry);
  BOOST_TEST(told("Hub") == 0u);
  BOOST_TEST(told("Elements") == 0u);
  elastic_rail(scene);
  BOOST_TEST(told("Foundation stiffness z") == 0u);
  BOOST_TEST(told("Foundation stiffness y") == 1u); // in 2D
  BOOST_TEST(told("Pad spacing") == 0u);
  BOOST_TEST(told("Pad length") == 1u);
  scene.rail.model.foundation.pad_spacing = 0.2;
  BOOST_TEST(told("Pad length") == 0u);
  BOOST_TEST(told("Ballast stiffness z") == 1u);
  scene.analysis = analysis_kind("transient");
  BOOST_TEST(told("Loss factor") == 0u);
  BOOST_TEST(told("Sponge rate") == 1u);
  scene.time.inertia = false;
  BOOST_TEST(told("Loss factor") == 1u);

  scene                             = SceneParameters();
  scene.rail.model.elements         = ElementKind::enhanced;
  scene.rail.material.poisson_ratio = 0.49;
  BOOST_TEST(implausible_values(scene, {}).size() == 1u);
}

BOOST_AUTO_TEST_SUITE_END()
