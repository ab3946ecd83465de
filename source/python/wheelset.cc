#include "bindings.h"

#include <rolling_contact/wheelset/wheelset_solver.h>

namespace RollingContact::Bindings
{
  namespace
  {
    /** A wheelset in balance and its wheels, copies of their own. */
    struct PlacedWheelset
    {
      FoundEquilibrium     found; ///< without the states of the wheels
      double               radius, speed;
      std::array<State, 2> wheels; ///< right, left
    };

    PlacedWheelset placed(const FoundEquilibrium &found, const PairSpec &scene)
    {
      PlacedWheelset result{found,
                            scene.wheel.radius,
                            scene.contact.rolling_speed(),
                            {}};
      for (unsigned int wheel = 0; wheel < 2; ++wheel)
        {
          const SteadyState<3> &steady = found.steady[wheel];
          result.wheels[wheel]         = {{},
                                          session_state(*found.scenes[wheel], steady),
                                          std::make_shared<const Fields>(steady.problem,
                                                                 steady.state),
                                          {}};
          result.found.scenes[wheel].reset();
          result.found.steady[wheel] = SteadyState<3>();
        }
      return result;
    }

    class PyWheelset : public InZeroedMemory
    {
    public:
      explicit PyWheelset(std::shared_ptr<const Scene> scene)
        : scene(std::move(scene))
      {}

      std::vector<PlacedWheelset> solve() const
      {
        if (!scene)
          throw std::runtime_error("This wheelset has no scene: make another "
                                   "one.");
        const Situation                &situation = *scene->situation;
        std::unique_ptr<WheelsetSolver> solver;
        {
          const py::gil_scoped_release others_run;
          solver = std::make_unique<WheelsetSolver>(situation);
        }
        std::vector<PlacedWheelset> all;
        for (std::size_t k = 0; k < solver->n_cases(); ++k)
          {
            std::vector<FoundEquilibrium> found;
            {
              const py::gil_scoped_release others_run;
              found = solver->next();
            }
            for (const FoundEquilibrium &one : found)
              all.push_back(placed(one, situation));
          }
        return all;
      }

    private:
      std::shared_ptr<const Scene> scene;
    };

    void define_place(py::class_<PlacedWheelset> &state)
    {
      const auto add = [&](const char *name, auto give, const char *help) {
        state.def_property_readonly(name, give, help);
      };
      using Placed = const PlacedWheelset &;
      add(
        "name",
        [](Placed self) { return self.found.name; },
        "\"leading\" or \"trailing\" for a bogie, else empty.");
      add(
        "curvature",
        [](Placed self) { return self.found.state.acting.curvature; },
        "Curvature of the track, positive to the right. Unit: 1/m.");
      add(
        "lateral_shift",
        [](Placed self) { return self.found.state.place.shift; },
        "Lateral shift to the right. Unit: m.");
      add(
        "yaw",
        [](Placed self) { return self.found.state.place.yaw; },
        "Yaw against the radial direction, right-handed about z, which points "
        "down. Unit: rad.");
      add(
        "roll", [](Placed self) { return self.found.roll; }, "Unit: rad.");
      add(
        "pitch_rate",
        [](Placed self) {
          return self.found.state.place.pitch_rate(self.speed, self.radius);
        },
        "Angular velocity of the axle. Unit: rad/s.");
      add(
        "bounds",
        [](Placed self) -> py::object {
          if (!self.found.bounds)
            return py::none();
          const auto &bounds = *self.found.bounds;
          return py::make_tuple(bounds[0], bounds[1], bounds[2]);
        },
        "Bounds of the errors of shift, yaw and the axle's turn over V/r0; "
        "None where no bound is known. Units: m, rad, 1.");
      add(
        "frame_shift",
        [](Placed self) { return self.found.frame[0]; },
        "Lateral shift of the frame of a bogie. Unit: m.");
      add(
        "frame_yaw",
        [](Placed self) { return self.found.frame[1]; },
        "Yaw of the frame of a bogie. Unit: rad.");
      add(
        "lateral_force",
        [](Placed self) { return self.found.state.lateral_force; },
        "Force of the suspension to the right. Unit: N.");
      add(
        "yaw_moment",
        [](Placed self) { return self.found.state.yaw_moment; },
        "Moment of the suspension, right-handed about z, which points down. "
        "Unit: N m.");
      add(
        "drag",
        [](Placed self) { return self.found.drag(); },
        "Force on both wheels against the direction of travel. Unit: N.");
      add(
        "creep_work",
        [](Placed self) { return self.found.creep_work(); },
        "T gamma of both wheels. Unit: J/m.");
      add(
        "residual",
        [](Placed self) { return self.found.residual(); },
        "Largest residual of the balances over the axle load. Unit: 1.");
    }
  } // namespace

  void define_wheelset(py::module_ &module)
  {
    py::class_<PlacedWheelset> state(module,
                                     "WheelsetState",
                                     "A wheelset in balance and its wheels, "
                                     "as copies. SI units.");
    define_place(state);
    for (const auto &[name, wheel] :
         {std::pair("right", 0), std::pair("left", 1)})
      state.def_property_readonly(
        name,
        [wheel = wheel](const PlacedWheelset &self) {
          return self.wheels[wheel];
        },
        "The state of this wheel, see State.");
    state.def("__repr__", [](const PlacedWheelset &self) {
      const WheelsetPlace &place = self.found.state.place;
      return py::str("<rolling_contact.WheelsetState: curvature {:.6g} 1/m, "
                     "lateral_shift {:.6g} m, yaw {:.6g} rad>")
        .format(self.found.state.acting.curvature, place.shift, place.yaw);
    });
    py::class_<PyWheelset>(
      module,
      "Wheelset",
      "A wheelset or bogie of a scene, whose equilibria are found. Analysis "
      "becomes wheelset. See doc/howto/wheelset.md.")
      .def(py::init([](const py::object &scene, const py::object &settings) {
             return std::make_unique<PyWheelset>(
               make_scene_of("wheelset", scene, settings));
           }),
           py::arg("scene"),
           py::arg("settings") = py::none(),
           "Make it of the path of a .prm file, of its text or of a Scene. "
           "Raises InputError.")
      .def("solve",
           &PyWheelset::solve,
           "Find the equilibria in one curve after the other; returns a "
           "WheelsetState for each wheelset. Raises ConvergenceError in a "
           "curve without an equilibrium.");
  }
} // namespace RollingContact::Bindings
