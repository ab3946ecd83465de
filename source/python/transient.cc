#include "bindings.h"

#include <rolling_contact/tables/transient_session.h>

namespace RollingContact::Bindings
{
  namespace
  {
    BetweenValues between_of(const std::string &name)
    {
      if (name == "linear")
        return BetweenValues::linear;
      if (name == "held")
        return BetweenValues::held;
      throw InputError("between = " + name +
                       ": inputs are linear over the step, or held.");
    }

    /** A state of a session in time, to be given back to it. */
    struct Saved : public InZeroedMemory
    {
      std::shared_ptr<const TransientSession::Saved> state;
    };

    class PyTransient : public InZeroedMemory
    {
    public:
      PyTransient(std::shared_ptr<const Scene> scene,
                  const std::string           &verbosity)
        : speech(verbosity)
        , warnings(scene->warnings)
      {
        session.open(*scene, speech);
      }

      TransientState step(const std::optional<double> length,
                          const StepInputs           &inputs,
                          const std::string          &between)
      {
        const BetweenValues          way = between_of(between);
        const InUse                  mine(flag);
        const py::gil_scoped_release others_run;
        const TransientState         found = session->step(inputs, length, way);
        if (speech.stream())
          speech.stream()->flush();
        return found;
      }

      TransientState state()
      {
        const InUse mine(flag);
        return session->current();
      }

      std::shared_ptr<Fields> fields()
      {
        const InUse mine(flag);
        if (session->current().progress.step == 0)
          throw std::runtime_error("There are fields after the first step: "
                                   "take one.");
        return std::make_shared<Fields>(session->problem(), session->state());
      }

      Saved save()
      {
        const InUse mine(flag);
        return {{}, session->save()};
      }

      TransientState restore(const Saved &saved)
      {
        const InUse                  mine(flag);
        const py::gil_scoped_release others_run;
        if (!saved.state)
          throw InputError("This is no state that a session saved.");
        session->restore(*saved.state);
        return session->current();
      }

      Speech                   speech;
      std::vector<std::string> warnings;

    private:
      std::atomic_flag       flag = ATOMIC_FLAG_INIT;
      Open<TransientSession> session;
    };

    template <typename Value>
    void define(py::class_<TransientState> &state,
                const char                 *name,
                const Value                &value,
                const char                 *help)
    {
      state.def_property_readonly(name, value, help);
    }

    void define_forces(py::class_<TransientState> &state)
    {
      using S = const TransientState &;
      define(
        state,
        "force",
        [](S s) {
          return py::make_tuple(s.forces.force_x,
                                s.forces.force_y,
                                s.forces.normal_force);
        },
        "(force_x, force_y, normal_force). Unit: N.");
      define(
        state, "force_x", [](S s) { return s.forces.force_x; }, "Unit: N.");
      define(
        state, "force_y", [](S s) { return s.forces.force_y; }, "Unit: N.");
      define(
        state,
        "normal_force",
        [](S s) { return s.forces.normal_force; },
        "Unit: N.");
      define(
        state,
        "spin_moment",
        [](S s) { return s.forces.spin_moment; },
        "Moment about +z through the origin. Unit: N m.");
      define(
        state,
        "max_pressure",
        [](S s) { return s.forces.max_pressure; },
        "Unit: Pa.");
      define(
        state,
        "creepages",
        [](S s) {
          return py::make_tuple(s.creepages.x, s.creepages.y, s.creepages.spin);
        },
        "(creepage x, creepage y, spin), given or found for given forces. "
        "Units: 1, 1, 1/m.");
    }

    void define_energies(py::class_<TransientState> &state)
    {
      using S = const TransientState &;
      define(
        state,
        "kinetic_energy",
        [](S s) { return s.kinetic_energy; },
        "Now. Unit: J.");
      define(
        state,
        "strain_energy",
        [](S s) { return s.strain_energy; },
        "Now. Unit: J.");
      define(
        state,
        "supplied_energy",
        [](S s) { return s.progress.supplied_energy; },
        "Unit: J.");
      define(
        state,
        "friction_energy",
        [](S s) { return s.progress.friction_energy; },
        "Energy that friction has turned into heat. Unit: J.");
      define(
        state,
        "damping_energy",
        [](S s) { return s.progress.damping_energy; },
        "Unit: J.");
      define(
        state,
        "numerical_energy",
        [](S s) { return s.progress.numerical_energy; },
        "Energy that the theta-scheme has dissipated. Unit: J.");
    }

    void define_steps(py::class_<TransientState> &state)
    {
      using S = const TransientState &;
      define(
        state, "time", [](S s) { return s.time; }, "Unit: s.");
      define(
        state,
        "force_time",
        [](S s) { return s.force_time; },
        "Time of the forces, which lies (1 - theta) of a step before the end. "
        "Unit: s.");
      define(
        state,
        "step",
        [](S s) { return s.progress.step; },
        "Number of steps done.");
      define(
        state, "approach", [](S s) { return s.approach; }, "Unit: m.");
      define(
        state, "speed", [](S s) { return s.speed; }, "Unit: m/s.");
      define(
        state,
        "rolled_distance",
        [](S s) { return s.progress.rolled_distance; },
        "Unit: m.");
      define(
        state,
        "n_touching",
        [](S s) { return s.forces.n_touching; },
        "Number of nodes in contact.");
      define(
        state,
        "n_sticking",
        [](S s) { return s.n_sticking; },
        "Number of nodes that stick.");
      define(
        state,
        "n_parts",
        [](S s) { return s.n_parts; },
        "Number of parts of the step: 1 unless it was halved.");
      define(
        state,
        "wheel_velocity",
        [](S s) { return s.wheel_velocity; },
        "Velocity along z of the centre of mass of a free wheel, else None. "
        "Unit: m/s.");
      define(
        state,
        "seconds",
        [](S s) { return s.seconds; },
        "Wall time of the step. Unit: s.");
    }

    void define_state(py::module_ &module)
    {
      using S = const TransientState &;
      py::class_<TransientState> state(
        module,
        "TransientState",
        "The state at the end of a time step, as a copy. Forces are those on "
        "the wheel; energies and distances count from the start. SI units.");
      define_steps(state);
      define_forces(state);
      define_energies(state);
      state.def("__repr__", [](S s) {
        return py::str("<rolling_contact.TransientState: t = {:.6g} s, force_x "
                       "{:.6g} N, force_y {:.6g} N, normal_force {:.6g} N>")
          .format(s.time,
                  s.forces.force_x,
                  s.forces.force_y,
                  s.forces.normal_force);
      });
      py::class_<Saved>(module,
                        "SavedState",
                        "A state that Transient.save() returns and "
                        "Transient.restore() takes.");
    }

    void define_step(py::class_<PyTransient> &transient)
    {
      using Value     = std::optional<double>;
      const auto none = py::none();
      transient.def(
        "step",
        [](PyTransient       &self,
           const Value        dt,
           const Value        normal_load,
           const Value        approach,
           const Value        creepage_x,
           const Value        creepage_y,
           const Value        spin,
           const Value        speed,
           const Value        longitudinal_force,
           const Value        lateral_force,
           const Value        spin_moment,
           const std::string &between) {
          return self.step(dt,
                           {normal_load,
                            approach,
                            creepage_x,
                            creepage_y,
                            spin,
                            speed,
                            longitudinal_force,
                            lateral_force,
                            spin_moment},
                           between);
        },
        py::arg("dt") = none,
        py::kw_only(),
        py::arg("normal_load")        = none,
        py::arg("approach")           = none,
        py::arg("creepage_x")         = none,
        py::arg("creepage_y")         = none,
        py::arg("spin")               = none,
        py::arg("speed")              = none,
        py::arg("longitudinal_force") = none,
        py::arg("lateral_force")      = none,
        py::arg("spin_moment")        = none,
        py::arg("between")            = "linear",
        "Take one step of dt (s). Without dt it has the length of the scene; "
        "another length factorises anew. The arguments are the values at the "
        "end of the step. On the way there they are linear, or constant from "
        "its start on with between=\"held\". An argument that is left out "
        "keeps the value that it was given last; if it was never given, it "
        "follows the history of the scene. A force takes the place of its "
        "creepage, which is found for it, and a creepage that of its force. "
        "Units: N, m, 1, 1, 1/m, m/s, N, N, N m. Raises InputError, "
        "ConvergenceError or KeyboardInterrupt; the session is then as it was "
        "before the step.");
    }
  } // namespace

  void define_transient(py::module_ &module)
  {
    define_state(module);
    py::class_<PyTransient> transient(
      module,
      "Transient",
      "A scene in time whose steps are taken one by one from Python. Only one "
      "thread at a time may use it.");
    transient.def(
      py::init([](const py::object           &scene,
                  const py::object           &settings,
                  const std::optional<double> time_step,
                  const std::string          &verbosity) {
        if (time_step && !(*time_step > 0.))
          throw InputError("time_step = " + std::to_string(*time_step) +
                           " s: it must be above 0 s.");
        return std::make_unique<PyTransient>(
          make_scene_in_time(scene, settings, time_step), verbosity);
      }),
      py::arg("scene"),
      py::arg("settings")  = py::none(),
      py::arg("time_step") = py::none(),
      py::arg("verbosity") = "quiet",
      "Make it of the path of a .prm file, of its text or of a Scene; "
      "Analysis becomes transient. time_step (s) takes the place of Time/Time "
      "step. End time and Rolled distance may be left out; they do not end "
      "the run. Raises InputError.");
    define_step(transient);
    transient
      .def_property_readonly("state",
                             &PyTransient::state,
                             "The state at the end of the last step.")
      .def_property_readonly(
        "time", [](PyTransient &self) { return self.state().time; }, "Unit: s.")
      .def("fields",
           &PyTransient::fields,
           "Fields at the end of the last step.")
      .def("save",
           &PyTransient::save,
           "A copy of the state, kept in memory, for master algorithms that "
           "repeat steps.")
      .def(
        "restore",
        &PyTransient::restore,
        py::arg("saved"),
        "Return to a state that this session saved, and return it. The steps "
        "from there give the same numbers, bit by bit. Raises InputError if "
        "another session saved it.")
      .def_readonly("warnings",
                    &PyTransient::warnings,
                    "Warnings: entries of the scene without effect, and "
                    "values that look wrong.");
  }
} // namespace RollingContact::Bindings
