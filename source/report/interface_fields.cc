#include <deal.II/base/data_out_base.h>

#include <rolling_contact/assessment/flash_temperature.h>
#include <rolling_contact/parallel/ranks.h>
#include <rolling_contact/patch/recovered_tractions.h>
#include <rolling_contact/patch/resultants.h>
#include <rolling_contact/report/interface_fields.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /** Place (x, y, z) of a point of the interface with these coordinates. */
    using SurfacePlace =
      std::function<std::array<double, 3>(const std::array<double, 2> &)>;



    /** Values at the nodes, one row for each component of a field. */
    struct NodalFields
    {
      std::vector<std::string>         names;
      std::vector<std::vector<double>> values;

      void
      add(const std::string &name, const std::vector<double> &nodal_values)
      {
        names.push_back(name);
        values.push_back(nodal_values);
      }

      /** The first @p n_components of a field; zero if it has none. */
      void
      add_vector(const std::string &name,
                 const NodalField  &field,
                 const unsigned int n_components)
      {
        for (unsigned int c = 0; c < n_components; ++c)
          add(name,
              field.empty() ? std::vector<double>(field.n_nodes(), 0.)
                            : field.component(c));
      }
    };



    std::vector<double>
    norms(const NodalField &field)
    {
      std::vector<double> values;
      for (std::size_t i = 0; i < field.n_nodes(); ++i)
        values.push_back(field.norm_at(i));
      return values;
    }



    /** All fields; those with dim - 1 components first, the state last. */
    template <int dim>
    NodalFields
    nodal_fields(const ContactProblem      &problem,
                 const ContactState        &state,
                 const bool                 step_is_known,
                 const std::vector<double> &temperature)
    {
      const auto known = [&](auto values) {
        if (!step_is_known)
          std::fill(values.begin(), values.end(), std::nan(""));
        return values;
      };
      const TangentialProblem tangential = tangential_problem(problem, state);
      NodalField              slip(problem.n_nodes(), 0);
      std::vector<double>     states;
      if (problem.n_tangential() > 0)
        slip = known(tangential.slip(state.traction));
      for (const NodeState node_state : node_states(tangential, state))
        states.push_back(static_cast<int>(node_state));

      const RecoveredTractions recovered =
        recovered_tractions(tangential, state);
      NodalFields fields;
      fields.add_vector("traction", state.traction, dim - 1);
      fields.add_vector("slip", slip, dim - 1);
      fields.add_vector("recovered_traction", recovered.traction, dim - 1);
      fields.add("pressure", state.pressure);
      fields.add("recovered_pressure", recovered.pressure);
      fields.add("traction_size", norms(state.traction));
      fields.add("traction_bound", tangential.bound);
      if (problem.loads.friction_law && problem.n_tangential() > 0)
        {
          fields.add("friction_coefficient", tangential.friction);
          fields.add("sliding_speed",
                     known(tangential.sliding_speeds(
                       tangential.slip(state.traction))));
        }
      if (!temperature.empty())
        fields.add("flash_temperature", temperature);
      fields.add("gap", known(normal_gap(problem, state)));
      fields.add("area", problem.operators.areas());
      fields.add("state", states);
      return fields;
    }



    unsigned int
    first_master(const SparseRows::Row &corner)
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
    DataOutBase::Patch<dim - 1, dim>
    make_patch(const Trace::Cell  &cell,
               const NodalFields  &fields,
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
    vtk_flags()
    {
      DataOutBase::VtkFlags flags;
      flags.print_date_and_time = false;
      flags.compression_level   = DataOutBase::VtkFlags::best_speed;
      flags.physical_units      = {{"traction", "Pa"},
                                   {"pressure", "Pa"},
                                   {"recovered_traction", "Pa"},
                                   {"recovered_pressure", "Pa"},
                                   {"traction_size", "Pa"},
                                   {"traction_bound", "Pa"},
                                   {"sliding_speed", "m/s"},
                                   {"flash_temperature", "K"},
                                   {"gap", "m"},
                                   {"area", "m^2"}};
      return flags;
    }



    template <int dim>
    void
    write_interface_fields(const Trace               &trace,
                           const ContactProblem      &problem,
                           const ContactState        &state,
                           const bool                 step_is_known,
                           const SurfacePlace        &place,
                           const std::vector<double> &temperature,
                           RunFolder                 &folder,
                           const std::string         &file_name)
    {
      AssertDimension(trace.n_dimensions, dim - 1);
      AssertDimension(trace.nodes.size(), problem.n_nodes());
      Ranks::on_root([&]() {
        const NodalFields fields =
          nodal_fields<dim>(problem, state, step_is_known, temperature);

        std::vector<DataOutBase::Patch<dim - 1, dim>> patches;
        for (const Trace::Cell &cell : trace.cells)
          {
            patches.push_back(make_patch<dim>(cell, fields, place));
            patches.back().patch_index = patches.size() - 1;
          }

        const auto is_vector =
          DataComponentInterpretation::component_is_part_of_vector;
        std::ostringstream vtu;
        DataOutBase::write_vtu(
          patches,
          fields.names,
          {{0, dim - 2, "traction", is_vector},
           {dim - 1, 2 * dim - 3, "slip", is_vector},
           {2 * dim - 2, 3 * dim - 4, "recovered_traction", is_vector}},
          vtk_flags(),
          vtu);
        folder.write_atomically(file_name, vtu.str());
      });
    }
  } // namespace



  template <int dim>
  void
  write_interface(const SceneParameters  &scene,
                  const SteadyState<dim> &steady,
                  RunFolder              &folder,
                  const std::string      &file)
  {
    const auto rail = scene.rail.body_shape();
    write_interface_fields<dim>(
      steady.pair->trace(),
      steady.problem,
      steady.state,
      !steady.restored,
      [&](const std::array<double, 2> &at) -> std::array<double, 3> {
        const Profiles::ContactFrame *frame = scene.profiles.frame.get();
        if (frame && frame->kind() == Profiles::SurfaceKind::curved &&
            frame->covers(at[1]))
          {
            const Profiles::SurfacePoint point = frame->surface(at[1]);
            return {{at[0], point.y, point.z}};
          }
        return {{at[0], at[1], rail->surface_height(at[0], at[1])}};
      },
      flash_temperature(scene, steady.problem, steady.state),
      folder,
      file);
  }



  template void
  write_interface(const SceneParameters &,
                  const SteadyState<2> &,
                  RunFolder &,
                  const std::string &);
  template void
  write_interface(const SceneParameters &,
                  const SteadyState<3> &,
                  RunFolder &,
                  const std::string &);
} // namespace RollingContact
