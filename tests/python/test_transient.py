"""Steps under control from outside: the program's histories, forces, repeated steps."""

import math
import unittest

import numpy as np

import rolling_contact as rc
from cases import CARTER, COARSE_2D, LOADED_2D, PRM, Case, rows_of_program

ROLLING = {
    **COARSE_2D,
    "Contact/Speed": 10,
    "Time/Inertia": False,
    "Time/Initial state": "steady",
}
STEP = 1e-4


def state_of(state):
    return state.force + state.creepages + (state.approach, state.friction_energy)


class Steps(Case):
    def compare(self, state, row):
        for value, column, scale in [
            (state.time, "time_s", None),
            (state.force_time, "force_time_s", None),
            (state.normal_force, "normal_force_N", None),
            (state.force_x, "force_x_N", None),
            (state.creepages[0], "creepage_x", 1e-3),
            (state.friction_energy, "friction_J", None),
            (state.strain_energy, "strain_J", None),
        ]:
            self.assert_close(value, float(row[column]), 2e-8, scale)

    def test_without_inputs_are_those_of_the_program(self):
        settings = {
            "Mesh/Elements across patch": 12,
            "Time/End time": 1e-5,
            "Time/Time step": 2e-6,
        }
        scene = PRM / "oscillating_creepage_2d.prm"
        transient = rc.Transient(scene, settings)
        for row in rows_of_program(scene, {**settings, "Time/Field interval": 0}, "history.csv"):
            self.compare(transient.step(), row)
        self.assertEqual(transient.state.step, 5)

    def test_with_inputs_are_those_of_a_history(self):
        """Creepage and approach on lines, given step by step or as expressions."""
        history = {
            **ROLLING,
            "Analysis": "transient",
            "Time/Time step": STEP,
            "Time/End time": 6 * STEP,
            "Time/Creepage x": "0.0017 + 2 * t",
            "Time/Approach": "0.22e-3 - 0.01 * t",
        }
        for inertia in (False, True):
            with self.subTest(inertia=inertia):
                history["Time/Inertia"] = str(inertia).lower()
                if inertia:
                    history.update({"Time/Time step": 2e-6, "Time/End time": 12e-6})
                step = history["Time/Time step"]
                rows = rows_of_program(CARTER, {**history, "Time/Initial state": "steady"}, "history.csv")
                transient = rc.Transient(CARTER, {**ROLLING, "Time/Inertia": inertia}, time_step=step)
                for row in rows:
                    t = float(row["time_s"])
                    state = transient.step(creepage_x=0.0017 + 2 * t, approach=0.22e-3 - 0.01 * t)
                    self.compare(state, row)

    def test_find_creepages_for_forces_and_go_back(self):
        transient = rc.Transient(CARTER, ROLLING, time_step=STEP)
        start = transient.state
        force = start.force_x + 2e3
        for _ in range(3):
            state = transient.step(longitudinal_force=force, between="held")
            self.assert_close(state.force_x, force, 1e-7)
        self.assertNotEqual(state.creepages[0], 0.0017)
        kept = transient.step()
        self.assert_close(kept.force_x, force, 1e-7)
        back = transient.step(creepage_x=0.0017)
        self.assertEqual(back.creepages[0], 0.0017)
        self.assertNotEqual(back.force_x, force)

    def test_come_to_the_steady_state(self):
        transient = rc.Transient(CARTER, ROLLING, time_step=2e-3)
        for _ in range(60):
            state = transient.step(creepage_x=0.001, between="held")
        steady = rc.Session(CARTER, {**COARSE_2D, "Contact/Creepage x": 0.001}).solve()
        self.assert_close(state.force_x, steady.force_x, 5e-3)
        self.assert_close(state.rolled_distance, 60 * 2e-3 * 10, 1e-12)

    def test_follow_the_load(self):
        transient = rc.Transient(LOADED_2D, ROLLING, time_step=STEP)
        state = transient.step(normal_load=130e3)
        self.assert_close(state.normal_force, 130e3, 1e-9)
        fields = transient.fields()
        self.assert_close(fields.areas @ fields.pressure, 130e3, 1e-9)
        self.assert_close(fields.areas @ fields.traction[:, 0], state.force_x, 1e-9)


class Restored(Case):
    def repeat(self, transient, inputs):
        for _ in range(2):
            transient.step(**inputs(transient))
        saved, before = transient.save(), transient.state
        first = [state_of(transient.step(**inputs(transient))) for _ in range(3)]
        back = transient.restore(saved)
        self.assertEqual(state_of(back), state_of(before))
        self.assertEqual(back.time, before.time)
        second = [state_of(transient.step(**inputs(transient))) for _ in range(3)]
        self.assertEqual(first, second)
        transient.step(creepage_x=-0.001)
        transient.restore(saved)
        self.assertEqual(first[0], state_of(transient.step(**inputs(transient))))

    def test_steps_are_the_same_to_the_bit(self):
        def creepage(transient):
            return {"creepage_x": 0.0017 + 1e-3 * math.sin(3e3 * transient.time)}

        self.repeat(rc.Transient(CARTER, ROLLING, time_step=STEP), creepage)
        self.repeat(
            rc.Transient(CARTER, {**ROLLING, "Time/Inertia": True}, time_step=2e-6), creepage
        )

    def test_forces_too(self):
        transient = rc.Transient(CARTER, ROLLING, time_step=STEP)
        force = transient.state.force_x
        self.repeat(transient, lambda it: {"longitudinal_force": force * (1 + 100 * it.time)})

    def test_from_the_start(self):
        for initial in ("steady", "rest"):
            for inputs in ({"creepage_x": 0.002}, {"longitudinal_force": -9e3}):
                settings = {**ROLLING, "Time/Initial state": initial}
                transient = rc.Transient(CARTER, settings, time_step=STEP)
                start = transient.save()
                first = [state_of(transient.step(**inputs)) for _ in range(3)]
                transient.restore(start)
                self.assertEqual(transient.time, 0.0)
                second = [state_of(transient.step(**inputs)) for _ in range(3)]
                self.assertEqual(first, second)

    def test_only_by_the_session_that_saved(self):
        one = rc.Transient(CARTER, ROLLING, time_step=STEP)
        other = rc.Transient(CARTER, ROLLING, time_step=STEP)
        with self.assertRaises(rc.InputError):
            other.restore(one.save())


class WrongInputs(Case):
    def test_are_refused_and_nothing_happens(self):
        transient = rc.Transient(CARTER, ROLLING, time_step=STEP)
        twin = rc.Transient(CARTER, ROLLING, time_step=STEP)
        for inputs, said in [
            ({"normal_load": 1e5}, "Contact/Approach"),
            ({"creepage_y": 1e-3}, "creepage_y = 0.001 1: it exists in 3D only"),
            ({"spin": 0.5}, "spin = 0.5 1/m: it exists in 3D only"),
            ({"lateral_force": 2e3}, "lateral_force = 2000 N: it exists in 3D only"),
            ({"spin_moment": 1.0}, "spin_moment = 1 N m: it exists in 3D only"),
            ({"speed": -10.0}, "speed = -10 m/s: it must keep the sign"),
            ({"creepage_x": math.nan}, "finite"),
            ({"creepage_x": 0.0, "longitudinal_force": 0.0}, "leave creepage_x out"),
            ({"dt": 0.0}, "above 0"),
            ({"dt": math.inf}, "finite"),
            ({"between": "cubic"}, "linear"),
        ]:
            with self.subTest(inputs=inputs):
                with self.assertRaises(rc.InputError) as raised:
                    transient.step(**inputs)
                self.assertIn(said, str(raised.exception))
                self.assertEqual(transient.time, 0.0)
        with self.assertRaises(TypeError):
            transient.step(creepage=1e-3)
        self.assertEqual(
            state_of(transient.step(creepage_x=0.002)), state_of(twin.step(creepage_x=0.002))
        )
        loaded = rc.Transient(LOADED_2D, ROLLING, time_step=STEP)
        for inputs, said in [
            ({"approach": 1e-4}, "approach = 0.0001 m: the scene gives the load"),
            ({"normal_load": -1.0}, "normal_load = -1 N: contact cannot pull"),
            ({"longitudinal_force": 50e3}, "mu N"),
        ]:
            with self.assertRaises(rc.InputError) as raised:
                loaded.step(**inputs)
            self.assertIn(said, str(raised.exception))

    def test_no_approach_moves_a_free_axle(self):
        settings = {
            "Wheel/Hub": "mass",
            "Wheel/Hub mass": 50.0,
            "Wheel/Hub inertia y": 1.0,
            "Time/Bodies": "reduced",
            "Time/Theta": 0.5,
            "Modes/Maximum frequency": 4000.0,
        }
        hung = rc.Transient(PRM / "corrugation_2d.prm", settings)
        with self.assertRaises(rc.InputError) as raised:
            hung.step(approach=1e-4)
        self.assertIn("the axle moves by the forces on it", str(raised.exception))
        self.assertEqual(hung.step().step, 1)

    def test_in_the_scene(self):
        for settings, step, said in [
            ({}, None, "Time/"),
            ({}, -1.0, "above 0"),
            ({"Contact/Approach": 0}, STEP, "patch"),
        ]:
            with self.assertRaises(rc.InputError) as raised:
                rc.Transient(CARTER, {**ROLLING, **settings}, time_step=step)
            self.assertIn(said, str(raised.exception))


if __name__ == "__main__":
    unittest.main()
