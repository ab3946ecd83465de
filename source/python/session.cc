#include "bindings.h"

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/ranks.h>
#include <rolling_contact/tables/session.h>

namespace RollingContact::Bindings
{
  namespace
  {
    class PySession : public InZeroedMemory
    {
    public:
      PySession(std::shared_ptr<const Scene> scene,
                const std::string           &verbosity)
        : speech(verbosity)
        , entries(scene->entries)
        , warnings(scene->warnings)
      {
        if (Ranks::count() > 1)
          throw InputError("A session is for one rank, MPI has " +
                           std::to_string(Ranks::count()) +
                           ": start Python without mpirun.");
        const py::gil_scoped_release others_run;
        session.open(*scene->situation, speech.stream(), speech.verbosity);
      }

      void close()
      {
        const InUse mine(flag);
        session.close();
      }

      void set(const std::string &entry, const py::object &value)
      {
        const InUse       mine(flag);
        const std::string text = text_of_value(entry, value);
        session->set(entry, text);
        entries[entry] = text;
      }

      std::string get(const std::string &entry) const
      {
        const auto found = entries.find(entry);
        if (found == entries.end())
          throw py::key_error(entry + ": neither scene nor settings give it; "
                                      "it has its default, if it is one of "
                                      "rolling_contact.print_parameters().");
        return found->second;
      }

      /** The columns of results.csv take as long as a further state in 2D. */
      State solve(const std::optional<bool> &columns)
      {
        const InUse mine(flag);
        State       state;
        {
          const py::gil_scoped_release others_run;
          state.found = session->solve();
          if (state.found.touches &&
              columns.value_or(state.found.track_forces.has_value()))
            state.columns = session->row();
          if (speech.stream())
            speech.stream()->flush();
        }
        if (state.found.touches)
          state.fields = std::make_shared<const Fields>(session->problem(),
                                                        session->state());
        return state;
      }

      py::dict row() const
      {
        return dict_of(session->row());
      }

      unsigned int n_bodies_made() const
      {
        return session->n_bodies_made();
      }

      Speech                             speech;
      std::map<std::string, std::string> entries;
      std::vector<std::string>           warnings;

    private:
      std::atomic_flag flag = ATOMIC_FLAG_INIT;
      Open<Session>    session;
    };

    template <typename Type>
    void define(py::class_<State> &state,
                const char        *name,
                Type Resultants::*const member,
                const char             *help)
    {
      state.def_property_readonly(
        name,
        [member](const State &self) { return self.found.forces.*member; },
        help);
    }

    void define_bounds(py::module_ &module)
    {
      py::class_<ErrorBounds> bounds(
        module,
        "ErrorBounds",
        "How far a state may be off from that of an infinitely fine mesh of "
        "the same bodies; None where no bound is known. See doc/explanation/errors.md.");
      define_copies(bounds);
      bounds
        .def_readonly("force",
                      &ErrorBounds::force,
                      "Of the forces of friction, over mu N. Unit: 1.")
        .def_readonly("moment",
                      &ErrorBounds::moment,
                      "Of the spin moment in 3D, over mu N a. Unit: 1.")
        .def_readonly("max_pressure",
                      &ErrorBounds::max_pressure,
                      "Of the peak pressure, over that. Unit: 1.")
        .def_readonly("text",
                      &ErrorBounds::text,
                      "What the bound of the force is made of.");
    }

    void define_columns(py::class_<State> &state)
    {
      state.def_property_readonly(
        "columns",
        [](const State &self) -> py::object {
          return self.columns ? py::object(dict_of(*self.columns))
                              : py::object(py::none());
        },
        "The columns of results.csv of the state, as a dict, see "
        "Session.row(); None unless the bodies have profiles or solve() was "
        "asked for them.");
    }

    void define_fields_of(py::class_<State> &state)
    {
      const auto add = [&](const char *name, auto member, const char *help) {
        state.def_property_readonly(
          name,
          [member, name](const State &self) {
            if (!self.fields)
              throw std::runtime_error(std::string(name) +
                                       ": nothing touches in this state.");
            return (*self.fields).*member;
          },
          help);
      };
      add("positions", &Fields::positions, "See Fields. Unit: m.");
      add("pressure", &Fields::pressure, "See Fields. Unit: Pa.");
      add("traction", &Fields::traction, "See Fields. Unit: Pa.");
      add("gap", &Fields::gap, "See Fields. Unit: m.");
      add("slip", &Fields::slip, "See Fields. Unit: 1.");
      add("node_states", &Fields::node_states, "See Fields.");
      add("areas", &Fields::areas, "See Fields. Unit: m^2.");
      state.def_property_readonly(
        "fields",
        [](const State &self) {
          return std::const_pointer_cast<Fields>(self.fields);
        },
        "All fields; None if nothing touches.");
    }

    void define_resultants(py::class_<State> &state)
    {
      define(state, "force_x", &Resultants::force_x, "Unit: N.");
      define(state, "force_y", &Resultants::force_y, "Unit: N.");
      define(state, "normal_force", &Resultants::normal_force, "Unit: N.");
      define(state,
             "spin_moment",
             &Resultants::spin_moment,
             "About +z through the origin. Unit: N m.");
      define(state, "max_pressure", &Resultants::max_pressure, "Unit: Pa.");
      define(state,
             "friction_force",
             &Resultants::friction_force,
             "mu N, the most that friction can carry. Unit: N.");
      define(state,
             "creep_work",
             &Resultants::creep_work,
             "Work of friction on the rigid slip per metre rolled. Unit: J/m.");
      state.def_property_readonly(
        "contact_area",
        [](const State &self) { return self.found.areas.contact; },
        "Unit: m^2.");
      state.def_property_readonly(
        "stick_area",
        [](const State &self) { return self.found.areas.stick; },
        "Unit: m^2.");
      define(state, "half_width_x", &Resultants::half_width_x, "Unit: m.");
      define(state, "half_width_y", &Resultants::half_width_y, "Unit: m.");
      define(state,
             "dissipation",
             &Resultants::dissipation,
             "Heat of friction per metre rolled. Unit: J/m.");
    }

    void define_forces_and_creepages(py::class_<State> &state)
    {
      state
        .def_property_readonly(
          "force",
          [](const State &self) {
            const Resultants &result = self.found.forces;
            return py::make_tuple(result.force_x,
                                  result.force_y,
                                  result.normal_force);
          },
          "(force_x, force_y, normal_force). Unit: N.")
        .def_property_readonly(
          "creepages",
          [](const State &self) {
            const Creepages &creepages = self.found.creepages;
            return py::make_tuple(creepages.x, creepages.y, creepages.spin);
          },
          "(creepage x, creepage y, spin), found where forces are given. "
          "Units: 1, 1, 1/m.");
    }

    /** Forces in the axes of the track; None without profiles. */
    template <typename Give>
    void define_in_track(py::class_<State> &state,
                         const char        *name,
                         const Give         give,
                         const char        *help)
    {
      state.def_property_readonly(
        name,
        [give](const State &self) -> py::object {
          const auto &forces = self.found.track_forces;
          return forces ? py::object(py::cast(give(*forces)))
                        : py::object(py::none());
        },
        help);
    }

    void define_track_forces(py::class_<State> &state)
    {
      using Vector = std::array<double, 3>;
      define_in_track(
        state,
        "force_track",
        [](const TrackForces &found) {
          return Vector{{found.force_x, found.force_y, found.force_z}};
        },
        "Force on the wheel forwards, to the right and down, None without "
        "profiles. Unit: N.");
      define_in_track(
        state,
        "moment_track",
        [](const TrackForces &found) {
          return std::array<double, 2>{{found.moment_x, found.moment_z}};
        },
        "Its moments about the direction of travel and about the vertical, "
        "right-handed about forwards and down through the middle of the track "
        "at the top of the rails. Unit: N m.");
      define_in_track(
        state,
        "axle_torque",
        [](const TrackForces &found) { return found.axle_torque; },
        "Torque of friction about the axle, right-handed about the axis to "
        "the right. Unit: N m.");
    }

    void define_members(py::class_<State> &state)
    {
      const auto add = [&](const char *name, auto member, const char *help) {
        state.def_property_readonly(
          name,
          [member](const State &self) { return self.found.*member; },
          help);
      };
      add("touches", &SessionState::touches, "Else all is 0.");
      add("converged",
          &SessionState::converged,
          "Session.solve() raises where it is not, unless told not to.");
      add("reason", &SessionState::reason, "Why it did not converge.");
      add("approach", &SessionState::approach, "Unit: m.");
      add("bounds", &SessionState::bounds, "How far the state may be off.");
      add("elements_across",
          &SessionState::elements_across,
          "Elements over the patch that was found, along x.");
      add("new_bodies",
          &SessionState::new_bodies,
          "Why bodies were made for it; empty if they were kept.");
      add("seconds",
          &SessionState::seconds,
          "Wall time of the solve. Unit: s.");
    }

    void define_state(py::module_ &module)
    {
      py::class_<State> state(module,
                              "State",
                              "A steady state, a copy of its own. Forces are "
                              "those on the wheel. SI units.");
      define_resultants(state);
      define_forces_and_creepages(state);
      define_track_forces(state);
      define_members(state);
      define_fields_of(state);
      define_columns(state);
      define_copies(state);
    }
  } // namespace

  void define_session(py::module_ &module)
  {
    define_bounds(module);
    define_state(module);
    py::class_<PySession>(
      module,
      "Session",
      "A scene whose steady states are solved one after the other. Bodies are "
      "kept as long as they serve, so that a further load, creepage or "
      "friction takes milliseconds. To be used by one thread at a time.")
      .def(py::init([](const py::object  &scene,
                       const py::object  &settings,
                       const std::string &verbosity) {
             return std::make_unique<PySession>(make_scene(scene, settings),
                                                verbosity);
           }),
           py::arg("scene"),
           py::arg("settings")  = py::none(),
           py::arg("verbosity") = "quiet",
           "Of a path, a text or a Scene, see Scene. verbosity: quiet, normal "
           "or verbose, what is said while bodies are made. Raises InputError.")
      .def("__setitem__",
           &PySession::set,
           py::arg("entry"),
           py::arg("value"),
           "Give an entry, \"Section/Entry\", another value for the states "
           "from now on. Raises InputError, the entry unchanged.")
      .def("__getitem__",
           &PySession::get,
           py::arg("entry"),
           "The value that an entry was given last, as a text. Raises KeyError "
           "where it was given none.")
      .def(
        "set",
        [](PySession &self, const py::dict &settings) {
          for (const auto &[entry, value] : settings)
            self.set(entry.cast<std::string>(),
                     py::reinterpret_borrow<py::object>(value));
        },
        py::arg("settings"),
        "Give several entries other values, one after the other.")
      .def(
        "solve",
        [](PySession                 &self,
           const bool                 check,
           const std::optional<bool> &columns) {
          State state = self.solve(columns);
          if (check && !state.found.converged)
            throw ConvergenceError(
              "The state did not converge: " + state.found.reason +
              ". Take other entries, or solve(check="
              "False) to get it as it is.");
          return state;
        },
        py::arg("check")   = true,
        py::arg("columns") = py::none(),
        "Solve the state of the entries as they are. Raises InputError if they "
        "contradict each other, ConvergenceError; the session may be used "
        "further. With check=False a state that did not converge is returned "
        "and says so. With columns=True it has State.columns; on profiles it "
        "has them unless that is False.")
      .def("close",
           &PySession::close,
           "Give up the bodies that are kept; done at the end of a with "
           "statement. Any other use is an error from then on.")
      .def(
        "row",
        &PySession::row,
        "The columns of results.csv of the state that was solved last, as a "
        "dict: their names end with units, what is not known is None, what "
        "is true or false 1 or 0. With Wear/Report the wear and fatigue of "
        "the state, with Contact/Speed its temperatures, see doc/reference/output.md. "
        "Raises RuntimeError if no state that touches was solved, or an "
        "entry was set since.")
      .def_property_readonly("n_bodies_made",
                             &PySession::n_bodies_made,
                             "How many sets of bodies were made so far.")
      .def_readonly("warnings",
                    &PySession::warnings,
                    "Entries of the scene without effect and values that are "
                    "hardly meant so.");
  }
} // namespace RollingContact::Bindings
