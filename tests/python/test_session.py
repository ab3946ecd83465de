"""Steady states: the numbers of the program, bodies that are kept, fields, errors."""

import subprocess
import threading
import time
import unittest

import numpy as np

import rolling_contact as rc
from cases import CARTER, COARSE_2D, LOADED_2D, PATCH_3D, PROGRAM, Case, rows_of_program


FAILING = {
    "Contact/Solver": "fixed point",
    "Contact/Slip operator": "galerkin",
    "Contact/Maximal iterations": 20,
}


class States(Case):
    def compare(self, state, row):
        for value, column in [
            (state.force_x, "force_x_N"),
            (state.force_y, "force_y_N"),
            (state.normal_force, "normal_force_N"),
            (state.spin_moment, "spin_moment_Nm"),
            (state.max_pressure, "max_pressure_Pa"),
            (state.contact_area, "contact_area_m2"),
            (state.stick_area, "stick_area_m2"),
            (state.half_width_x, "half_width_x_m"),
            (state.half_width_y, "half_width_y_m"),
            (state.dissipation, "dissipation_J/m"),
            (state.approach, "approach_m"),
        ]:
            self.assert_close(value, float(row[column]), 2e-8)

    def test_is_that_of_the_program_in_2d(self):
        state = rc.Session(CARTER, COARSE_2D).solve()
        self.assertTrue(state.converged)
        self.compare(state, rows_of_program(CARTER, COARSE_2D)[0])
        self.assertEqual(state.force, (state.force_x, state.force_y, state.normal_force))

    def test_is_that_of_the_program_in_3d(self):
        state = rc.Session(PATCH_3D).solve()
        row = rows_of_program(PATCH_3D)[0]
        self.compare(state, row)
        # which no other could stand for
        self.assertNotAlmostEqual(state.half_width_x / state.half_width_y, 1.0, 2)
        self.assertNotAlmostEqual(state.stick_area / state.contact_area, 1.0, 2)
        self.assertEqual(state.creepages, (0.001, -0.0007, 0.4))

    def test_has_the_row_of_the_program(self):
        settings = {"Contact/Speed": 20, "Wear/Report": "true"}
        session = rc.Session(PATCH_3D, settings)
        with self.assertRaises(RuntimeError):
            session.row()
        session.solve()
        found, row = session.row(), rows_of_program(PATCH_3D, settings)[0]
        self.assertEqual(set(found), set(row))
        for column, text in row.items():
            if column in ("wall_s", "iterations") or column.startswith(("residual", "invariant", "energy")):
                continue
            if isinstance(found[column], float):
                self.assert_close(found[column], float({"true": 1, "false": 0}.get(text, text)), 1e-6)
            else:
                self.assertEqual(found[column] or "", text)
        self.assertGreater(found["flash_temperature_K"], 0)
        self.assertGreater(found["wear_brr_mm2/km"], 0)
        session["Contact/Creepage y"] = 0.0012
        with self.assertRaises(RuntimeError):
            session.row()

    def test_keeps_its_bodies(self):
        session = rc.Session(PATCH_3D)
        self.assertEqual(session.n_bodies_made, 0)
        first = session.solve()
        self.assertEqual(session.n_bodies_made, 1)
        self.assertNotEqual(first.new_bodies, "")
        session["Contact/Creepage y"] = 0.0012
        session["Contact/Normal load"] = np.float64(34e3)
        session["Contact/Friction coefficient"] = "0.35"
        second = session.solve()
        self.assertEqual(session.n_bodies_made, 1)
        self.assertEqual(second.new_bodies, "")
        self.assert_close(second.normal_force, 34e3, 1e-9)
        self.assert_close(second.friction_force, 0.35 * 34e3, 1e-9)
        self.assertNotEqual(first.force_y, second.force_y)
        print(f"first state {first.seconds:.3f} s, a further one {1e3 * second.seconds:.1f} ms")
        session["Wheel/Young modulus"] = 200e9
        session.solve()
        self.assertEqual(session.n_bodies_made, 2)

    def test_has_its_bounds(self):
        bounds = rc.Session(PATCH_3D).solve().bounds
        for bound in (bounds.force, bounds.moment, bounds.max_pressure):
            self.assertTrue(0.0 < bound < 1.0)
        self.assertIn("n", bounds.text)
        thin = rc.Session(CARTER, {**COARSE_2D, "Wheel/Hub radius": 0.459}).solve()
        self.assertIsNone(thin.bounds.force)

    def test_finds_creepages_for_forces(self):
        session = rc.Session(LOADED_2D, {"Contact/Creepage x": 0, "Contact/Longitudinal force": -20e3})
        found = session.solve()
        self.assert_close(found.force_x, -20e3, 1e-8)
        given = rc.Session(LOADED_2D, {"Contact/Creepage x": found.creepages[0]}).solve()
        self.assert_close(given.force_x, -20e3, 1e-6)

    def test_without_contact(self):
        state = rc.Session(CARTER, {**COARSE_2D, "Contact/Approach": 0}).solve()
        self.assertFalse(state.touches)
        self.assertEqual(state.force, (0.0, 0.0, 0.0))
        self.assertIsNone(state.fields)
        with self.assertRaises(RuntimeError):
            state.pressure

    def test_two_sessions_do_not_know_of_each_other(self):
        one, other = rc.Session(LOADED_2D), rc.Session(LOADED_2D, {"Contact/Creepage x": -0.001})
        a, b = one.solve(), other.solve()
        self.assert_close(a.force_x, -b.force_x, 0.05)
        self.assertEqual(one.solve().normal_force, a.normal_force)
        self.assertLess(a.force_x, 0.0)

    def test_threads(self):
        """The interpreter runs on, and two threads cannot share a session."""
        session, refused, states = rc.Session(PATCH_3D), [], []
        thread = threading.Thread(target=lambda: states.append(session.solve()))
        thread.start()
        ticks = 0
        while thread.is_alive():
            ticks += 1
            try:
                session["Contact/Spin"] = 0.4
            except RuntimeError as error:
                refused.append(str(error))
            time.sleep(1e-3)
        thread.join()
        self.assertGreater(ticks, 3)
        self.assertTrue(refused and "another thread" in refused[0])
        self.assertTrue(states[0].converged)

    def test_two_sessions_in_two_threads(self):
        """Each has the numbers that it has alone, bodies and roughness made at once."""
        rough = {"Contact/Roughness": "1e-7*cos(x/1e-3)"}
        scenes = [(PATCH_3D, rough), (PATCH_3D, {"Wheel/Young modulus": 200e9, **rough})]
        alone = [rc.Session(*scene).solve().force for scene in scenes]
        together = [None, None]

        def solve(k):
            together[k] = rc.Session(*scenes[k]).solve().force

        threads = [threading.Thread(target=solve, args=(k,)) for k in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(together, alone)
        self.assertNotEqual(alone[0], alone[1])


class FieldsOfStates(Case):
    def test_integrate_to_the_forces(self):
        for scene, columns in ((LOADED_2D, 1), (PATCH_3D, 2)):
            state = rc.Session(scene).solve()
            n = len(state.pressure)
            self.assertEqual(state.positions.shape, (n, 2))
            self.assertEqual(state.slip.shape, (n, 2))
            areas = state.areas
            self.assert_close(areas @ state.pressure, state.normal_force, 1e-9)
            self.assert_close(areas @ state.traction[:, 0], state.force_x, 1e-9)
            if columns == 2:
                self.assert_close(areas @ state.traction[:, 1], state.force_y, 1e-9)
                x, y = state.positions.T
                moment = areas @ (x * state.traction[:, 1] - y * state.traction[:, 0])
                self.assert_close(moment, state.spin_moment, 1e-9)
            sums = state.fields.forces.sum(axis=0)
            for value, force in zip(sums, state.force):
                self.assert_close(value, force, 1e-9, state.normal_force)

    def test_keep_the_contact_laws(self):
        state = rc.Session(PATCH_3D).solve()
        touches = state.pressure > 0
        size = np.hypot(*state.traction.T)
        self.assertTrue(np.all(state.pressure >= 0))
        self.assertLess(np.abs(state.gap[touches]).max(), 1e-8 * state.approach)
        self.assertTrue(np.all(state.gap[~touches] > -1e-8 * state.approach))
        self.assertTrue(np.all(size <= 0.3 * state.pressure * (1 + 1e-8)))
        self.assertTrue(np.all((state.node_states == 0) == ~touches))
        self.assertEqual(set(state.node_states), {0, 1, 2})
        slips = state.node_states == 1
        # nodes that stick do not slip, others do so against the traction
        speed = np.hypot(*state.slip.T)
        self.assertLess(speed[state.node_states == 2].max(), 1e-6 * speed.max())
        power = np.sum(state.traction[slips] * state.slip[slips], axis=1)
        self.assertTrue(np.all(power <= -(1 - 1e-6) * size[slips] * speed[slips]))

    def test_are_copies(self):
        session = rc.Session(LOADED_2D)
        first = session.solve()
        pressure = first.pressure.copy()
        session["Contact/Normal load"] = 130e3
        session.solve()
        self.assertTrue(np.array_equal(first.pressure, pressure))


class Errors(Case):
    def test_are_exceptions(self):
        self.assertTrue(issubclass(rc.InputError, ValueError))
        self.assertTrue(issubclass(rc.ConvergenceError, RuntimeError))
        for source, settings, said in [
            ("no_such_file.prm", {}, "no such file"),
            ("set Dimension = 5\n", {}, "Dimension"),
            (LOADED_2D, {"Contact/Creepage": 1}, "Contact/Creepage"),
            (LOADED_2D, {"Contact/Creepage x": "much"}, 'settings["Contact/Creepage x"] = much'),
            (LOADED_2D, {"Contact/Approach": 1e-4}, "Contact/Normal load"),
            (LOADED_2D, {"Mesh/Adaptive levels": 2}, "Adaptive levels"),
        ]:
            with self.assertRaises(rc.InputError) as raised:
                rc.Session(source, settings)
            self.assertIn(said, str(raised.exception))
        for wrong in (3, None, ["a"]):
            with self.assertRaises(TypeError):
                rc.Session(wrong)
        with self.assertRaises(TypeError):
            rc.Session(LOADED_2D, {"Contact/Creepage x": [1e-3]})
        with self.assertRaises(rc.InputError):
            rc.Session(LOADED_2D, verbosity="loud")

    def test_leave_the_session_usable(self):
        session = rc.Session(LOADED_2D)
        before = session.solve()
        with self.assertRaises(rc.InputError):
            session["Contact/Normal load"] = "heavy"
        with self.assertRaises(rc.InputError):
            session["Contact/No such entry"] = 1
        self.assertEqual(session["Contact/Normal load"], "140e3")
        with self.assertRaises(KeyError):
            session["Wheel/Radius"]
        session["Contact/Creepage y"] = 0.001  # there is none in 2D
        with self.assertRaises(rc.InputError):
            session.solve()
        session["Contact/Creepage y"] = 0
        self.assert_close(session.solve().force_x, before.force_x, 1e-8)

    def test_not_converged(self):
        session = rc.Session(LOADED_2D, FAILING)
        with self.assertRaises(rc.ConvergenceError):
            session.solve()
        state = session.solve(check=False)
        self.assertFalse(state.converged)
        self.assertNotEqual(state.reason, "")


class Scenes(Case):
    def test_of_paths_texts_and_scenes(self):
        scene = rc.Scene(LOADED_2D, {"Contact/Creepage x": 0.002})
        self.assertEqual(scene.dimension, 2)
        self.assertEqual(scene.entries["Contact/Creepage x"], "0.002")
        self.assertEqual(scene.entries["Contact/Normal load"], "140e3")
        again = rc.Scene(scene, {"Contact/Normal load": 100000})
        self.assertEqual(again.entries["Contact/Creepage x"], "0.002")
        self.assertEqual(again.entries["Contact/Normal load"], "100000")
        self.assertEqual(scene.warnings, [])
        unused = rc.Scene(LOADED_2D, {"Load curve/Shares of load": "0.5 : 1 : 3"})
        self.assertEqual(len(unused.warnings), 1)
        self.assertEqual(rc.Scene(str(CARTER)).entries, rc.Scene(CARTER).entries)

    def test_files_of_a_text_are_in_its_folder(self):
        text = (CARTER.parent / "own_mesh_2d.prm").read_text()
        self.assertEqual(rc.Scene.from_text(text, str(CARTER.parent)).dimension, 2)
        with self.assertRaises(rc.InputError):
            rc.Scene.from_text(text, "/nowhere")

    def test_parameters(self):
        said = subprocess.run([PROGRAM, "--print-parameters"], capture_output=True, text=True, check=True)
        self.assertEqual(rc.print_parameters(), said.stdout)


if __name__ == "__main__":
    unittest.main()
