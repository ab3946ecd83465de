#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q1.h>

#include <rolling_contact/bodies/faded_fields.h>
#include <rolling_contact/bodies/hookes_law.h>
#include <rolling_contact/bodies/moment_fields.h>
#include <rolling_contact/bodies/rigid_work.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /**
     * Height of a surface over the distance from the contact point from which
     * on it is not the one that runs through that point.
     */
    const double most_slope = 0.5;

    /**
     * chi and its gradient.
     */
    struct Fading
    {
      Fading(const Point<3> &point, const FadingRegion &region)
        : value(region.at(point.norm()))
        , gradient(region.slope(point.norm()) / point.norm() *
                   Tensor<1, 3>(point))
      {}

      double       value;
      Tensor<1, 3> gradient;
    };

    DenseMatrix as_unknowns(const DirectBody<3>          &body,
                            const std::vector<BodyField> &fields)
    {
      DenseMatrix result(body.n_unknowns(), fields.size());
      for (std::size_t k = 0; k < fields.size(); ++k)
        result.col(k) = as_vector(body.unknowns_of(fields[k]));
      return result;
    }

    std::vector<BodyField> zero_fields(const DirectBody<3> &body)
    {
      return std::vector<BodyField>(
        force_moments().size(),
        body.field(std::vector<double>(body.n_unknowns(), 0.)));
    }

    Tensor<2, 3> stress(const Tensor<2, 3> &gradient, const Material &material)
    {
      return stress_of(symmetrize(gradient), material);
    }

    /**
     * A vector and a tensor for each moment, side by side: forces and stresses
     * against gradients, or displacements and their gradients.
     */
    using Pairs = Eigen::Matrix<double, Eigen::Dynamic, 12>;

    Eigen::Matrix<double, 1, 12> pair_of(const Tensor<1, 3> &vector,
                                         const Tensor<2, 3> &tensor)
    {
      Eigen::Matrix<double, 1, 12> pair;
      for (unsigned int k = 0; k < 3; ++k)
        {
          pair[k] = vector[k];
          for (unsigned int l = 0; l < 3; ++l)
            pair[3 + 3 * k + l] = tensor[k][l];
        }
      return pair;
    }

    /**
     * F of each moment, field by field over the unknowns of a body, and the
     * part of Q from within the body.
     */
    class Loads
    {
    public:
      Loads(const DirectBody<3> &body,
            const BodyShape     &shape,
            const FadingRegion  &region);

      std::vector<BodyField> F;
      DenseMatrix            Q;

    private:
      using Cell = DoFHandler<3>::active_cell_iterator;

      void add_cell(const Cell &cell);

      void add_inside(const unsigned int point);

      /**
       * What tractions on the surface to first order in its height count, over
       * those at the surface itself.
       */
      double share_of_first_order(const unsigned int point) const;

      void add_first_order(const unsigned int point);

      void add_exact(const unsigned int point);

      /**
       * Let forces and stresses work on the shape functions at a point.
       */
      void add(const FEValuesBase<3> &at,
               const unsigned int     point,
               const Pairs           &loads);

      const DirectBody<3> &body;
      const BodyShape     &shape;
      const FadingRegion   region;
      const std::size_t    n;
      FEValues<3>          values;
      FEFaceValues<3>      on_face;
      DenseMatrix          on_cell; ///< moment by unknown
    };

    Loads::Loads(const DirectBody<3> &body,
                 const BodyShape     &shape,
                 const FadingRegion  &region)
      : F(zero_fields(body))
      , Q(DenseMatrix::Zero(force_moments().size(), force_moments().size()))
      , body(body)
      , shape(shape)
      , region(region)
      , n(force_moments().size())
      , values(body.dof_handler().get_fe(),
               QGauss<3>(2),
               update_values | update_gradients | update_quadrature_points |
                 update_JxW_values)
      , on_face(body.dof_handler().get_fe(),
                QGauss<2>(3),
                update_values | update_gradients | update_quadrature_points |
                  update_JxW_values | update_normal_vectors)
    {
      for (const auto &cell : body.dof_handler().active_cell_iterators())
        if (cell->center().norm() - cell->diameter() / 2 < region.outer)
          add_cell(cell);
    }

    void Loads::add_cell(const Cell &cell)
    {
      values.reinit(cell);
      on_cell = DenseMatrix::Zero(n, values.dofs_per_cell);
      for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
        add_inside(q);
      for (const unsigned int face : cell->face_indices())
        if (cell->face(face)->at_boundary())
          {
            on_face.reinit(cell, face);
            for (unsigned int q = 0; q < on_face.n_quadrature_points; ++q)
              {
                add_first_order(q);
                add_exact(q);
              }
          }
      if (on_cell.isZero(0.))
        return;
      std::vector<types::global_dof_index> dofs(values.dofs_per_cell);
      cell->get_dof_indices(dofs);
      Vector<double> load(values.dofs_per_cell);
      for (std::size_t k = 0; k < n; ++k)
        {
          for (unsigned int i = 0; i < load.size(); ++i)
            load(i) = on_cell(k, i);
          body.ties().distribute_local_to_global(load, dofs, F[k]);
        }
    }

    void Loads::add(const FEValuesBase<3> &at,
                    const unsigned int     point,
                    const Pairs           &loads)
    {
      Eigen::Matrix<double, 12, Eigen::Dynamic> shapes =
        DenseMatrix::Zero(12, at.dofs_per_cell);
      for (unsigned int i = 0; i < at.dofs_per_cell; ++i)
        {
          const unsigned int c = at.get_fe().system_to_component_index(i).first;
          shapes(c, i)         = at.shape_value(i, point);
          for (unsigned int d = 0; d < 3; ++d)
            shapes(3 + 3 * c + d, i) = -at.shape_grad(i, point)[d];
        }
      on_cell.noalias() += at.JxW(point) * (loads * shapes);
    }

    void Loads::add_inside(const unsigned int point)
    {
      Point<3> at = values.quadrature_point(point);
      if (!region.may_be_steep())
        at[2] = std::min(at[2], 0.);
      const Fading chi(at, region);
      if (chi.gradient.norm_square() == 0.)
        return;
      const Material &material = body.elasticity().core;
      const auto      fields   = moment_fields(at, material);
      Pairs           loads(n, 12), faded(n, 12);
      for (std::size_t k = 0; k < n; ++k)
        {
          const auto &[u, gradient] = fields[k];
          loads.row(k) =
            pair_of(stress(gradient, material) * chi.gradient,
                    stress(outer_product(u, chi.gradient), material));
          faded.row(k) =
            pair_of(chi.value * u,
                    -chi.value * gradient - outer_product(u, chi.gradient));
        }
      add(values, point, loads);
      Q.noalias() += values.JxW(point) * (loads * faded.transpose());
    }

    double Loads::share_of_first_order(const unsigned int point) const
    {
      if (!region.may_be_steep())
        return 1.;
      const Point<3> &at = on_face.quadrature_point(point);
      const double    r  = std::hypot(at[0], at[1]);
      return std::abs(at[2]) < most_slope * r ? region.first_order_at(r) : 0.;
    }

    void Loads::add_first_order(const unsigned int point)
    {
      Point<3> at        = on_face.quadrature_point(point);
      at[2]              = 0.;
      const double share = share_of_first_order(point);
      const Fading chi(at, region);
      if (share == 0. || chi.value == 0. || at.norm() < region.loads_end())
        return;
      const Material &material = body.elasticity().core;
      const auto      fields   = moment_fields(at, material);
      // h dx dy, and derivatives along x and y only
      const double weight =
        -shape.height_as_made(at[0], at[1]) * on_face.normal_vector(point)[2];
      const Tensor<1, 3> slope =
        share * chi.gradient + chi.value * region.first_order_slope(at.norm()) /
                                 at.norm() * Tensor<1, 3>(at);
      Pairs loads(n, 12);
      for (std::size_t k = 0; k < n; ++k)
        {
          Tensor<2, 3> sigma = stress(fields[k].gradient, material);
          for (unsigned int d = 0; d < 3; ++d)
            sigma[d][2] = 0.;
          loads.row(k) = pair_of(weight * (sigma * slope),
                                 -weight * share * chi.value * sigma);
        }
      add(on_face, point, loads);
    }

    void Loads::add_exact(const unsigned int point)
    {
      const Point<3> &at    = on_face.quadrature_point(point);
      const double    share = 1 - share_of_first_order(point);
      const Fading    chi(at, region);
      if (share == 0. || chi.value == 0.)
        return;
      const Material &material = body.elasticity().core;
      const auto      fields   = moment_fields(at, material);
      Pairs           loads(n, 12), faded(n, 12);
      for (std::size_t k = 0; k < n; ++k)
        {
          const auto &[u, gradient] = fields[k];
          loads.row(k)              = pair_of(-share * chi.value *
                                   (stress(gradient, material) *
                                    Tensor<1, 3>(on_face.normal_vector(point))),
                                 Tensor<2, 3>());
          faded.row(k)              = pair_of(chi.value * u, Tensor<2, 3>());
        }
      add(on_face, point, loads);
      Q.noalias() += on_face.JxW(point) * (loads * faded.transpose());
    }

    /// of the inner radius, within which fields are those at this distance
    const double spread = 0.25;

    /**
     * chi u_hs of each moment by component, 18 x 3; none where chi is 0.
     */
    DenseMatrix
    faded_at(Point<3> at, const Material &material, const FadingRegion &fading)
    {
      at[2]                 = std::min(at[2], 0.);
      const double distance = at.norm(), chi = fading.at(distance),
                   least = spread * fading.inner;
      if (chi == 0.)
        return {};
      if (distance < least)
        at = distance > 0. ? least / distance * at : Point<3>(0., 0., -least);
      const auto  fields = moment_fields(at, material);
      DenseMatrix faded(fields.size(), 3);
      for (std::size_t k = 0; k < fields.size(); ++k)
        for (unsigned int d = 0; d < 3; ++d)
          faded(k, d) = chi * fields[k].value[d];
      return faded;
    }
  } // namespace

  FadedFields::FadedFields(const DirectBody<3> &body,
                           const BodyShape     &shape,
                           const FadingRegion  &fading)
  {
    const Loads loads(body, shape, fading);
    F = as_unknowns(body, loads.F);
    if (fading.may_be_steep())
      F += missing_rigid_work(body, shape, fading, F);
    Q = (loads.Q + loads.Q.transpose()) / 2;
  }

  FadedInertia::FadedInertia(const DirectBody<3> &body,
                             const FadingRegion  &fading)
  {
    const auto            &dofs     = body.dof_handler();
    const Material        &material = body.elasticity().core;
    const std::size_t      n        = force_moments().size();
    std::vector<BodyField> of_loads = zero_fields(body), of_nodes = of_loads;
    std::vector<Point<3>>  positions(dofs.n_dofs());
    DoFTools::map_dofs_to_support_points(MappingQ1<3>(), dofs, positions);
    for (std::size_t i = 0; i < positions.size(); ++i)
      if (const DenseMatrix faded = faded_at(positions[i], material, fading);
          faded.size() > 0)
        for (std::size_t k = 0; k < n; ++k)
          of_nodes[k][i] = faded(k, i % 3);
    at_nodes = as_unknowns(body, of_nodes);

    FEValues<3>                          values(dofs.get_fe(),
                       QIterated<3>(QGauss<1>(2), 2),
                       update_values | update_quadrature_points |
                         update_JxW_values);
    std::vector<types::global_dof_index> numbers(values.dofs_per_cell);
    mutual = DenseMatrix::Zero(n, n);
    for (const auto &cell : dofs.active_cell_iterators())
      {
        if (cell->center().norm() - cell->diameter() / 2 > fading.outer)
          continue;
        values.reinit(cell);
        cell->get_dof_indices(numbers);
        DenseMatrix on_cell = DenseMatrix::Zero(numbers.size(), n);
        for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
          {
            const DenseMatrix faded =
              faded_at(values.quadrature_point(q), material, fading);
            if (faded.size() == 0)
              continue;
            const double mass = material.density * values.JxW(q);
            mutual.noalias() += mass * faded * faded.transpose();
            for (std::size_t i = 0; i < numbers.size(); ++i)
              on_cell.row(i) +=
                mass * values.shape_value(i, q) *
                faded.col(dofs.get_fe().system_to_component_index(i).first);
          }
        for (std::size_t k = 0; k < n; ++k)
          {
            Vector<double> load(numbers.size());
            for (std::size_t i = 0; i < numbers.size(); ++i)
              load(i) = on_cell(i, k);
            body.ties().distribute_local_to_global(load, numbers, of_loads[k]);
          }
      }
    loads = as_unknowns(body, of_loads);
  }
} // namespace RollingContact
