#include <deal.II/base/data_out_base.h>

#include <rolling_contact/base/ranks.h>
#include <rolling_contact/results/interface_fields.h>
#include <rolling_contact/results/nodal_values.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <tuple>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /** Place (x, y, z) of a point of the interface with these coordinates. */
    using SurfacePlace =
      std::function<std::array<double, 3>(const std::array<double, 2> &)>;

    /** Fields as VTU has them: one row for each component. */
    struct NodalRows
    {
      std::vector<std::string>           names;
      std::vector<std::vector<double>>   values;
      std::map<std::string, std::string> units;
      std::vector<
        std::tuple<unsigned int,
                   unsigned int,
                   std::string,
                   DataComponentInterpretation::DataComponentInterpretation>>
        vectors;
    };

    template <int dim>
    NodalRows nodal_rows(const NodalState &state)
    {
      NodalRows rows;
      for (const NodalQuantity &quantity : nodal_quantities())
        {
          const auto field = quantity.of(state);
          if (!field)
            continue;
          const unsigned int n     = quantity.is_vector ? dim - 1 : 1,
                             first = rows.names.size();
          for (unsigned int c = 0; c < n; ++c)
            {
              rows.names.push_back(quantity.name);
              rows.values.push_back(
                field->empty() ? std::vector<double>(field->n_nodes(), 0.)
                               : field->component(c));
            }
          if (quantity.is_vector)
            rows.vectors.emplace_back(
              first,
              first + n - 1,
              quantity.name,
              DataComponentInterpretation::component_is_part_of_vector);
          if (quantity.unit != "1")
            rows.units[quantity.name] = quantity.unit;
        }
      return rows;
    }

    unsigned int first_master(const SparseRows::Row &corner)
    {
      return std::max_element(corner.begin(),
                              corner.end(),
                              [](const auto &a, const auto &b) {
                                return a.second < b.second;
                              })
        ->first;
    }

    /** Values at a hanging corner are interpolated, the state is a master's. */
    template <int dim>
    DataOutBase::Patch<dim - 1, dim> make_patch(const Trace::Cell  &cell,
                                                const NodalRows    &fields,
                                                const SurfacePlace &place)
    {
      const std::size_t n_fields = fields.values.size();

      DataOutBase::Patch<dim - 1, dim> patch;
      patch.n_subdivisions = 1;
      patch.reference_cell = ReferenceCells::get_hypercube<dim - 1>();
      patch.data.reinit(n_fields, cell.corners.size());
      for (std::size_t v = 0; v < cell.corners.size(); ++v)
        {
          const double x = v % 2 == 1 ? cell.upper[0] : cell.lower[0];
          const double y = v / 2 == 1 ? cell.upper[1] : cell.lower[1];

          const auto  at     = place({{x, y}});
          Point<dim> &vertex = patch.vertices[v];
          vertex[0]          = at[0];
          vertex[1]          = at[1];
          vertex[dim - 1]    = at[2];
          for (std::size_t i = 0; i + 1 < n_fields; ++i)
            patch.data(i, v) = apply(cell.corners[v], fields.values[i]);
          patch.data(n_fields - 1, v) =
            fields.values.back()[first_master(cell.corners[v])];
        }
      return patch;
    }

    DataOutBase::VtkFlags
    interface_flags(const std::map<std::string, std::string> &units)
    {
      DataOutBase::VtkFlags flags;
      flags.print_date_and_time = false;
      flags.compression_level   = DataOutBase::VtkFlags::best_speed;
      flags.physical_units      = units;
      return flags;
    }

    template <int dim>
    void write_interface_fields(const Trace        &trace,
                                const NodalState   &state,
                                const SurfacePlace &place,
                                RunFolder          &folder,
                                const std::string  &file_name)
    {
      AssertDimension(trace.n_dimensions, dim - 1);
      AssertDimension(trace.nodes.size(), state.problem.n_nodes());
      Ranks::on_root([&]() {
        const NodalRows fields = nodal_rows<dim>(state);
        std::vector<DataOutBase::Patch<dim - 1, dim>> patches;
        for (const Trace::Cell &cell : trace.cells)
          {
            patches.push_back(make_patch<dim>(cell, fields, place));
            patches.back().patch_index = patches.size() - 1;
          }
        std::ostringstream vtu;
        DataOutBase::write_vtu(patches,
                               fields.names,
                               fields.vectors,
                               interface_flags(fields.units),
                               vtu);
        folder.write_atomically(file_name, vtu.str());
      });
    }
  } // namespace

  template <int dim>
  void write_interface(const PairSpec         &scene,
                       const SteadyState<dim> &steady,
                       RunFolder              &folder,
                       const std::string      &file)
  {
    const auto rail = scene.rail.body_shape();
    write_interface_fields<dim>(
      steady.pair->trace(),
      NodalState(steady.problem, steady.state, !steady.restored, &scene),
      [&](const std::array<double, 2> &at) -> std::array<double, 3> {
        const Profiles::ContactFrame *frame = scene.frame.get();
        if (frame && frame->kind() == Profiles::SurfaceKind::curved &&
            frame->covers(at[1]))
          {
            const Profiles::SurfacePoint point = frame->surface(at[1]);
            return {{at[0], point.y, point.z}};
          }
        return {{at[0], at[1], rail->surface_height(at[0], at[1])}};
      },
      folder,
      file);
  }

  template void write_interface(const PairSpec &,
                                const SteadyState<2> &,
                                RunFolder &,
                                const std::string &);
  template void write_interface(const PairSpec &,
                                const SteadyState<3> &,
                                RunFolder &,
                                const std::string &);
} // namespace RollingContact
