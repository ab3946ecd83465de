#include "bindings.h"

#include <array>
#include <stdexcept>

namespace RollingContact::Bindings
{
  namespace
  {
    /** Doubles of a state, in the order in which copies have them. */
    std::array<double *, 24> doubles_of(SessionState &state)
    {
      Resultants &all = state.forces;
      return {{&all.normal_force,
               &all.force_x,
               &all.force_y,
               &all.spin_moment,
               &all.friction_force,
               &all.tangential_force,
               &all.traction_coefficient,
               &all.max_pressure,
               &all.centre_x,
               &all.centre_y,
               &all.edge_begin_x,
               &all.edge_end_x,
               &all.half_width_x,
               &all.half_width_y,
               &all.creep_work,
               &all.dissipation,
               &state.areas.contact,
               &state.areas.stick,
               &state.approach,
               &state.creepages.x,
               &state.creepages.y,
               &state.creepages.spin,
               &state.elements_across,
               &state.seconds}};
    }

    std::array<double *, 6> doubles_of(TrackForces &forces)
    {
      return {{&forces.force_x,
               &forces.force_y,
               &forces.force_z,
               &forces.moment_x,
               &forces.moment_z,
               &forces.axle_torque}};
    }

    template <typename Type>
    py::tuple values_of(Type values)
    {
      const auto doubles = doubles_of(values);
      py::tuple  all(doubles.size());
      for (std::size_t i = 0; i < doubles.size(); ++i)
        all[i] = *doubles[i];
      return all;
    }

    template <typename Type>
    void set_values(const py::tuple &all, Type &values)
    {
      const auto doubles = doubles_of(values);
      if (all.size() != doubles.size())
        throw std::runtime_error("A copy of another version of this module.");
      for (std::size_t i = 0; i < doubles.size(); ++i)
        *doubles[i] = all[i].cast<double>();
    }

    void require_size(const py::tuple &all, const std::size_t size)
    {
      if (all.size() != size)
        throw std::runtime_error("A copy of another version of this module.");
    }

    py::tuple values_of_state(const State &state)
    {
      const SessionState &found = state.found;
      return py::make_tuple(found.touches,
                            found.converged,
                            found.reason,
                            values_of(found),
                            found.forces.n_touching,
                            found.track_forces
                              ? py::object(values_of(*found.track_forces))
                              : py::object(py::none()),
                            found.bounds,
                            found.new_bodies,
                            std::const_pointer_cast<Fields>(state.fields),
                            state.columns);
    }

    State state_of(const py::tuple &all)
    {
      require_size(all, 10);
      State         state;
      SessionState &found = state.found;
      found.touches       = all[0].cast<bool>();
      found.converged     = all[1].cast<bool>();
      found.reason        = all[2].cast<std::string>();
      set_values(all[3].cast<py::tuple>(), found);
      found.forces.n_touching = all[4].cast<unsigned int>();
      if (!all[5].is_none())
        set_values(all[5].cast<py::tuple>(), found.track_forces.emplace());
      found.bounds     = all[6].cast<ErrorBounds>();
      found.new_bodies = all[7].cast<std::string>();
      state.fields     = all[8].cast<std::shared_ptr<Fields>>();
      state.columns =
        all[9].cast<std::optional<std::vector<Session::NamedValue>>>();
      return state;
    }
  } // namespace

  py::dict dict_of(const std::vector<NamedValue> &columns)
  {
    py::dict found;
    for (const auto &[column, value] : columns)
      found[column.c_str()] = value;
    return found;
  }

  void define_copies(py::class_<ErrorBounds> &bounds)
  {
    bounds.def(py::pickle(
      [](const ErrorBounds &self) {
        return py::make_tuple(self.force,
                              self.moment,
                              self.max_pressure,
                              self.normal_force,
                              self.dissipation,
                              self.text,
                              self.first_order);
      },
      [](const py::tuple &all) {
        require_size(all, 7);
        using Bound = std::optional<double>;
        return ErrorBounds{all[0].cast<Bound>(),
                           all[1].cast<Bound>(),
                           all[2].cast<Bound>(),
                           all[3].cast<Bound>(),
                           all[4].cast<Bound>(),
                           all[5].cast<std::string>(),
                           all[6].cast<double>()};
      }));
  }

  void define_copies(py::class_<Fields, std::shared_ptr<Fields>> &fields)
  {
    fields.def(py::pickle(
      [](const Fields &self) {
        return py::make_tuple(self.positions,
                              self.pressure,
                              self.traction,
                              self.gap,
                              self.slip,
                              self.areas,
                              self.forces,
                              self.node_states);
      },
      [](const py::tuple &all) {
        require_size(all, 8);
        using Doubles = py::array_t<double>;
        Fields      copy;
        std::size_t next = 0;
        for (Doubles *field : {&copy.positions,
                               &copy.pressure,
                               &copy.traction,
                               &copy.gap,
                               &copy.slip,
                               &copy.areas,
                               &copy.forces})
          *field = all[next++].cast<Doubles>();
        copy.node_states = all[next].cast<py::array_t<std::int8_t>>();
        return copy;
      }));
  }

  void define_copies(py::class_<State> &state)
  {
    state.def(py::pickle(&values_of_state, &state_of));
  }
} // namespace RollingContact::Bindings
