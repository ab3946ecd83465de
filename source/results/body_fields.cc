#include <deal.II/base/data_out_base.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/fe/fe_values.h>

#include <rolling_contact/base/ranks.h>
#include <rolling_contact/results/body_fields.h>

#include <cmath>
#include <sstream>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /**
     * Names of the fields of a patch of cells, row by row; the first dim rows
     * are the displacement.
     */
    template <int dim>
    std::vector<std::string> field_names()
    {
      std::vector<std::string> names(dim, "displacement");
      names.insert(names.end(),
                   {"stress_xx", "stress_yy", "stress_zz", "stress_xz"});
      if (dim == 3)
        names.insert(names.end(), {"stress_xy", "stress_yz"});
      names.push_back("von_mises");
      return names;
    }

    /** Mean over the cell; eps_yy = 0 in plane strain. */
    template <int dim>
    SymmetricTensor<2, 3> mean_strain(const FEValues<dim> &values,
                                      const BodyField     &displacement)
    {
      std::vector<Tensor<2, dim>> gradients(values.n_quadrature_points);
      values[FEValuesExtractors::Vector(0)].get_function_gradients(displacement,
                                                                   gradients);
      Tensor<2, dim> mean;
      double         volume = 0.;
      for (const unsigned int q : values.quadrature_point_indices())
        {
          mean += values.JxW(q) * gradients[q];
          volume += values.JxW(q);
        }
      mean /= volume;

      const auto axis = [](const unsigned int d) {
        return d == dim - 1 ? 2 : d;
      };
      SymmetricTensor<2, 3> strain;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j <= i; ++j)
          strain[axis(i)][axis(j)] = (mean[i][j] + mean[j][i]) / 2;
      return strain;
    }

    /** sigma = 2 G dev(eps) + k tr(eps) I, as B-bar has it. */
    SymmetricTensor<2, 3> stress_of(const SymmetricTensor<2, 3> &strain,
                                    const Material              &material)
    {
      return 2 * material.shear_modulus() * deviator(strain) +
             material.bulk_modulus() * trace(strain) *
               unit_symmetric_tensor<3>();
    }

    /** In the order of field_names(). */
    template <int dim>
    std::vector<double> stress_fields(const SymmetricTensor<2, 3> &stress,
                                      const bool                   mirrored)
    {
      const double        sign = mirrored ? -1. : 1.;
      std::vector<double> fields{stress[0][0],
                                 stress[1][1],
                                 stress[2][2],
                                 sign * stress[0][2]};
      if (dim == 3)
        fields.insert(fields.end(), {stress[0][1], sign * stress[1][2]});
      fields.push_back(std::sqrt(1.5) * deviator(stress).norm());
      return fields;
    }

    /** A vector of a body in the axes of the contact. */
    template <int dim>
    Tensor<1, dim> in_contact(const Tensor<1, dim> &vector, const double angle)
    {
      Tensor<1, dim> result = vector;
      if constexpr (dim == 3)
        {
          const double c = std::cos(angle), s = std::sin(angle);
          result[1] = c * vector[1] - s * vector[2];
          result[2] = s * vector[1] + c * vector[2];
        }
      return result;
    }

    SymmetricTensor<2, 3> in_contact(const SymmetricTensor<2, 3> &stress,
                                     const double                 angle)
    {
      if (angle == 0.)
        return stress;
      Tensor<2, 3> rows(stress); // its columns turned, then its rows
      for (unsigned int i = 0; i < 3; ++i)
        rows[i] = in_contact(rows[i], angle);
      rows = transpose(rows);
      for (unsigned int i = 0; i < 3; ++i)
        rows[i] = in_contact(rows[i], angle);
      return symmetrize(rows);
    }

    /** A mirrored cell swaps its bottom and top to keep its orientation. */
    template <int dim>
    DataOutBase::Patch<dim, dim>
    make_patch(const typename DoFHandler<dim>::active_cell_iterator &cell,
               const BodyField           &displacement,
               const BodyPlacement       &placement,
               const std::vector<double> &stresses)
    {
      const double       sign = placement.mirrored ? -1. : 1.;
      const unsigned int swap = placement.mirrored ? 1 << (dim - 1) : 0;

      DataOutBase::Patch<dim, dim> patch;
      patch.n_subdivisions = 1;
      patch.reference_cell = ReferenceCells::get_hypercube<dim>();
      patch.data.reinit(dim + stresses.size(), cell->n_vertices());
      for (const unsigned int v : cell->vertex_indices())
        {
          const unsigned int column = v ^ swap;
          Tensor<1, dim>     place  = cell->vertex(v), moved;
          for (unsigned int d = 0; d < dim; ++d)
            moved[d] = displacement[cell->vertex_dof_index(v, d)];
          if constexpr (dim == 3)
            place -= Point<3>(0., placement.axes.y, placement.axes.z);
          moved = in_contact(moved, placement.axes.angle);
          patch.vertices[column] =
            Point<dim>(in_contact(place, placement.axes.angle));
          patch.vertices[column][dim - 1] *= sign;
          for (unsigned int d = 0; d < dim - 1; ++d)
            patch.data(d, column) = moved[d];
          patch.data(dim - 1, column) =
            sign * moved[dim - 1] + placement.shift_z;
          for (std::size_t i = 0; i < stresses.size(); ++i)
            patch.data(dim + i, column) = stresses[i];
        }
      return patch;
    }

    template <int dim>
    std::vector<DataOutBase::Patch<dim, dim>>
    make_patches(const ElasticBody<dim> &body,
                 const BodyField        &displacement,
                 const BodyPlacement    &placement)
    {
      const DoFHandler<dim> &dofs = body.dof_handler();
      FEValues<dim>          values(dofs.get_fe(),
                           QGauss<dim>(2),
                           update_gradients | update_JxW_values);

      std::vector<DataOutBase::Patch<dim, dim>> patches;
      patches.reserve(dofs.get_triangulation().n_active_cells());
      for (const auto &cell : dofs.active_cell_iterators())
        {
          if (!cell->is_locally_owned())
            continue;
          values.reinit(cell);
          const SymmetricTensor<2, 3> stress =
            in_contact(stress_of(mean_strain(values, displacement),
                                 body.elasticity()),
                       placement.axes.angle);
          patches.push_back(
            make_patch<dim>(cell,
                            displacement,
                            placement,
                            stress_fields<dim>(stress, placement.mirrored)));
          patches.back().patch_index = patches.size() - 1;
        }
      return patches;
    }

    template <int dim>
    DataOutBase::VtkFlags body_flags()
    {
      DataOutBase::VtkFlags flags;
      flags.print_date_and_time = false;
      flags.compression_level   = DataOutBase::VtkFlags::best_speed;
      for (const std::string &name : field_names<dim>())
        flags.physical_units[name] = name == "displacement" ? "m" : "Pa";
      return flags;
    }
  } // namespace

  namespace
  {
    using VectorRange =
      std::tuple<unsigned int,
                 unsigned int,
                 std::string,
                 DataComponentInterpretation::DataComponentInterpretation>;

    template <int dim>
    std::vector<VectorRange> vector_ranges()
    {
      return {{0,
               dim - 1,
               "displacement",
               DataComponentInterpretation::component_is_part_of_vector}};
    }
  } // namespace

  template <int dim>
  std::string write_body_fields(const ElasticBody<dim> *body,
                                const unsigned int      rank,
                                const BodyField        &displacement,
                                const BodyPlacement    &placement,
                                RunFolder              &folder,
                                const std::string      &name)
  {
    const auto text = [&]() {
      AssertDimension(displacement.size(), body->dof_handler().n_dofs());
      std::ostringstream vtu;
      DataOutBase::write_vtu(make_patches(*body, displacement, placement),
                             field_names<dim>(),
                             vector_ranges<dim>(),
                             body_flags<dim>(),
                             vtu);
      return vtu.str();
    };
    if (body == nullptr || body->mesh().kind == MeshKind::serial)
      {
        std::string whole;
        Ranks::on(rank, [&]() { whole = text(); });
        if (rank != 0)
          Ranks::broadcast(whole, rank);
        Ranks::on_root(
          [&]() { folder.write_atomically(name + ".vtu", whole); });
        return name + ".vtu";
      }

    std::vector<std::string> pieces;
    for (unsigned int rank = 0; rank < Ranks::count(); ++rank)
      pieces.push_back(name + "-" + std::to_string(rank) + ".vtu");
    folder.write_pieces(pieces, text());
    Ranks::on_root([&]() {
      std::ostringstream record;
      DataOutBase::write_pvtu_record(record,
                                     pieces,
                                     field_names<dim>(),
                                     vector_ranges<dim>(),
                                     body_flags<dim>());
      folder.write_atomically(name + ".pvtu", record.str());
    });
    return name + ".pvtu";
  }

  template <int dim>
  std::vector<PvdBlock>
  write_bodies(const SteadyState<dim>               &steady,
               const std::function<BodyField(Side)> &displacement,
               const std::function<std::string(const std::string &)> &file_name,
               const double                                           time,
               RunFolder                                             &folder)
  {
    std::vector<PvdBlock> blocks;
    unsigned int          part = 0;
    for (const Side side : both_sides)
      if (steady.pair->bodies().is_elastic(side))
        {
          const bool        is_wheel = side == Side::wheel;
          const std::string file =
            write_body_fields<dim>(steady.pair->bodies().body(side),
                                   steady.pair->bodies().rank_of(side),
                                   displacement(side),
                                   {is_wheel,
                                    is_wheel ? -steady.state.approach : 0.,
                                    steady.pair->interface().axes[side]},
                                   folder,
                                   file_name(name_of(side)));
          blocks.push_back({time, part++, name_of(side), file});
        }
    return blocks;
  }

  template std::string write_body_fields(const ElasticBody<2> *,
                                         const unsigned int,
                                         const BodyField &,
                                         const BodyPlacement &,
                                         RunFolder &,
                                         const std::string &);
  template std::string write_body_fields(const ElasticBody<3> *,
                                         const unsigned int,
                                         const BodyField &,
                                         const BodyPlacement &,
                                         RunFolder &,
                                         const std::string &);
  template std::vector<PvdBlock>
  write_bodies(const SteadyState<2> &,
               const std::function<BodyField(Side)> &,
               const std::function<std::string(const std::string &)> &,
               const double,
               RunFolder &);
  template std::vector<PvdBlock>
  write_bodies(const SteadyState<3> &,
               const std::function<BodyField(Side)> &,
               const std::function<std::string(const std::string &)> &,
               const double,
               RunFolder &);
} // namespace RollingContact
