#include <deal.II/base/data_out_base.h>
#include <deal.II/base/symmetric_tensor.h>

#include <rolling_contact/base/ranks.h>
#include <rolling_contact/contact/recovered_tractions.h>
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
      names.insert(names.end(), {"von_mises", "stress_error"});
      return names;
    }

    /** In the order of field_names(). */
    template <int dim>
    std::vector<double> stress_fields(const StressValue &value,
                                      const bool         mirrored)
    {
      const SymmetricTensor<2, 3> &stress = value.stress;
      const double                 sign   = mirrored ? -1. : 1.;
      std::vector<double>          fields{stress[0][0],
                                 stress[1][1],
                                 stress[2][2],
                                 sign * stress[0][2]};
      if (dim == 3)
        fields.insert(fields.end(), {stress[0][1], sign * stress[1][2]});
      fields.push_back(std::sqrt(1.5) * deviator(stress).norm());
      fields.push_back(value.error);
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

    /** A mirrored cell swaps its bottom and top to keep its orientation. */
    template <int dim>
    DataOutBase::Patch<dim, dim>
    make_patch(const typename DoFHandler<dim>::active_cell_iterator &cell,
               const BodyField        &displacement,
               const BodyPlacement    &placement,
               const NodalStress<dim> &stress)
    {
      const double       sign = placement.mirrored ? -1. : 1.;
      const unsigned int swap = placement.mirrored ? 1 << (dim - 1) : 0;

      DataOutBase::Patch<dim, dim> patch;
      patch.n_subdivisions = 1;
      patch.reference_cell = ReferenceCells::get_hypercube<dim>();
      patch.data.reinit(field_names<dim>().size(), cell->n_vertices());
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
          const auto stresses =
            stress_fields<dim>(stress.at(cell->vertex_index(v)),
                               placement.mirrored);
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
      const NodalStress<dim> stress(body,
                                    displacement,
                                    placement.axes.angle,
                                    placement.tractions);

      std::vector<DataOutBase::Patch<dim, dim>> patches;
      patches.reserve(dofs.get_triangulation().n_active_cells());
      for (const auto &cell : dofs.active_cell_iterators())
        {
          if (!cell->is_locally_owned())
            continue;
          patches.push_back(
            make_patch<dim>(cell, displacement, placement, stress));
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
  SurfaceTractions surface_tractions(const SteadyState<dim> &steady,
                                     const Side              side)
  {
    const PairInterface<dim> &interface = steady.pair->interface();
    if (!steady.problem.operators.frames().is_plane() ||
        interface.turns_nodes() || !interface.coupling[side].is_identity())
      return {};
    const RecoveredTractions recovered =
      recovered_tractions(steady.problem, steady.state);
    const double     sign  = side == Side::wheel ? 1. : -1.;
    const auto      &nodes = interface.nodes[side];
    SurfaceTractions tractions;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      {
        auto &traction = tractions[nodes[i].dofs[0]];
        traction       = {{-recovered.pressure[i], 0., 0.}};
        for (unsigned int c = 0; c < recovered.traction.n_components(); ++c)
          traction[1 + c] = sign * recovered.traction(c, i);
      }
    return tractions;
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
                                    steady.pair->interface().axes[side],
                                    surface_tractions(steady, side)},
                                   folder,
                                   file_name(name_of(side)));
          blocks.push_back({time, part++, name_of(side), file});
        }
    return blocks;
  }

  template std::string      write_body_fields(const ElasticBody<2> *,
                                              const unsigned int,
                                              const BodyField &,
                                              const BodyPlacement &,
                                              RunFolder &,
                                              const std::string &);
  template std::string      write_body_fields(const ElasticBody<3> *,
                                              const unsigned int,
                                              const BodyField &,
                                              const BodyPlacement &,
                                              RunFolder &,
                                              const std::string &);
  template SurfaceTractions surface_tractions(const SteadyState<2> &,
                                              const Side);
  template SurfaceTractions surface_tractions(const SteadyState<3> &,
                                              const Side);
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
