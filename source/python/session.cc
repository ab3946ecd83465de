#include "bindings.h"

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
        session.open(*scene, speech);
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
        "Bounds of the error of a state against an infinitely fine mesh of "
        "the same bodies; None where no bound is known. See "
        "doc/explanation/errors.md.");
      define_copies(bounds);
      bounds
        .def_readonly("force",
                      &ErrorBounds::force,
                      "Bound for the friction force, over mu N. Unit: 1.")
        .def_readonly("moment",
                      &ErrorBounds::moment,
                      "Bound for the spin moment in 3D, over mu N a. Unit: 1.")
        .def_readonly("max_pressure",
                      &ErrorBounds::max_pressure,
                      "Bound for the peak pressure, relative to it. Unit: 1.")
        .def_readonly("text",
                      &ErrorBounds::text,
                      "The parts of the bound of the force, in words.");
    }

    void define_columns(py::class_<State> &state)
    {
      state.def_property_readonly(
        "columns",
        [](const State &self) -> py::object {
          return self.columns ? py::object(dict_of(*self.columns))
                              : py::object(py::none());
        },
        "The columns of results.csv of the state as a dict, see "
        "Session.row(). None, unless the bodies have profiles or solve() was "
        "asked for columns.");
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
        "All fields, see Fields; None if nothing touches.");
    }

    void define_resultants(py::class_<State> &state)
    {
      define(state, "force_x", &Resultants::force_x, "Unit: N.");
      define(state, "force_y", &Resultants::force_y, "Unit: N.");
      define(state, "normal_force", &Resultants::normal_force, "Unit: N.");
      define(state,
             "spin_moment",
             &Resultants::spin_moment,
             "Moment about +z through the origin. Unit: N m.");
      define(state, "max_pressure", &Resultants::max_pressure, "Unit: Pa.");
      define(state,
             "friction_force",
             &Resultants::friction_force,
             "mu N, the largest force that friction can carry. Unit: N.");
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
          "(creepage x, creepage y, spin), given or found for given forces. "
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
        "Force on the wheel (forwards, to the right, down); None without "
        "profiles. Unit: N.");
      define_in_track(
        state,
        "moment_track",
        [](const TrackForces &found) {
          return std::array<double, 2>{{found.moment_x, found.moment_z}};
        },
        "Moments of that force about the direction of travel and about the "
        "vertical, right-handed about forwards and down, through the middle "
        "of the track at the top of the rails. Unit: N m.");
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
      add("touches",
          &SessionState::touches,
          "Whether the bodies touch; if not, "
          "all results are 0.");
      add("converged",
          &SessionState::converged,
          "Whether the state converged. If not, Session.solve() raises, "
          "unless check=False.");
      add("reason", &SessionState::reason, "Why the state did not converge.");
      add("approach", &SessionState::approach, "Unit: m.");
      add("bounds", &SessionState::bounds, "Bounds of the error of the state.");
      add("elements_across",
          &SessionState::elements_across,
          "Number of elements along x across the patch that was found.");
      add(
        "new_bodies",
        &SessionState::new_bodies,
        "Why new bodies were made for this state; empty if bodies were kept.");
      add("seconds",
          &SessionState::seconds,
          "Wall time of the solve. Unit: s.");
    }

    void define_state(py::module_ &module)
    {
      py::class_<State> state(module,
                              "State",
                              "A steady state, as a copy. Forces are those on "
                              "the wheel. SI units.");
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
      "kept as long as possible, so that another load, creepage or friction "
      "takes milliseconds. Only one thread at a time may use it.")
      .def(py::init([](const py::object  &scene,
                       const py::object  &settings,
                       const std::string &verbosity) {
             return std::make_unique<PySession>(make_scene(scene, settings),
                                                verbosity);
           }),
           py::arg("scene"),
           py::arg("settings")  = py::none(),
           py::arg("verbosity") = "quiet",
           "Make it of the path of a .prm file, of its text or of a Scene. "
           "verbosity: quiet, normal or verbose, for what is printed while "
           "bodies are made. Raises InputError.")
      .def("__setitem__",
           &PySession::set,
           py::arg("entry"),
           py::arg("value"),
           "Give an entry, \"Section/Entry\", another value for all states "
           "from now on. Raises InputError and leaves the entry as it was.")
      .def("__getitem__",
           &PySession::get,
           py::arg("entry"),
           "The value that the entry was given last, as a text. Raises "
           "KeyError if it was never given one.")
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
        "Solve the state for the entries as they are now. Raises InputError "
        "if they contradict each other, and ConvergenceError; the session can "
        "be used further. With check=False a state that did not converge is "
        "returned, and its converged is False. columns=True gives "
        "State.columns; bodies with profiles have them unless columns=False.")
      .def("close",
           &PySession::close,
           "Release the bodies that are kept; the end of a with statement "
           "does this. The session cannot be used afterwards.")
      .def("row",
           &PySession::row,
           "The columns of results.csv of the state that was solved last, as "
           "a dict. Their names end with units; unknown values are None, true "
           "and false are 1 and 0. Wear/Report adds wear and fatigue, "
           "Contact/Speed adds temperatures, see doc/reference/output.md. "
           "Raises RuntimeError if no state that touches was solved, or if an "
           "entry was set since.")
      .def_property_readonly("n_bodies_made",
                             &PySession::n_bodies_made,
                             "Number of sets of bodies that were made so far.")
      .def_readonly("warnings",
                    &PySession::warnings,
                    "Warnings: entries of the scene without effect, and "
                    "values that look wrong.");
  }
} // namespace RollingContact::Bindings
