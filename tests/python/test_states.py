"""What states are for Python: copies, comparison, text and pictures; entries as attributes, theories, tables, pip."""

import os
import pathlib
import pickle
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

import numpy as np

import rolling_contact as rc
from cases import CARTER, COARSE_2D, LOADED_2D, PATCH_3D, PRM, PROGRAM, ROOT, Case, rows_of_program

ON_PROFILES = {"Mesh/Elements across patch": 8}
TWO_POINTS = PRM / "profiles_two_points.prm"


class Copies(Case):
    def test_pickled_states_are_equal_to_the_bit(self):
        for scene, settings in ((CARTER, COARSE_2D), (PATCH_3D, None), (TWO_POINTS, ON_PROFILES)):
            with rc.Session(scene, settings) as session:
                state = session.solve()
            copy = pickle.loads(pickle.dumps(state))
            self.assertEqual(copy, state)
            self.assertEqual(copy.to_dict(), state.to_dict())
            self.assertEqual(copy.columns, state.columns)
            np.testing.assert_array_equal(copy.fields.forces, state.fields.forces)
            self.assertEqual(copy.node_states.dtype, np.int8)
            bounds = pickle.loads(pickle.dumps(state.bounds))
            self.assertEqual((bounds.force, bounds.moment, bounds.text), (state.bounds.force, state.bounds.moment, state.bounds.text))

    def test_a_state_without_contact_is_copied(self):
        state = rc.Session(CARTER, {**COARSE_2D, "Contact/Approach": 0}).solve()
        copy = pickle.loads(pickle.dumps(state))
        self.assertEqual(copy, state)
        self.assertFalse(copy.touches)
        self.assertIn("nothing touches", state._repr_svg_())
        with self.assertRaises(ValueError):
            state.plot()

    def test_other_states_are_not_equal(self):
        session = rc.Session(LOADED_2D)
        first = session.solve()
        session.contact.creepage_x = 0.00101
        second = session.solve()
        self.assertNotEqual(first, second)
        self.assertNotEqual(first, "a state")
        with self.assertRaises(TypeError):
            hash(first)
        # by a field alone, of which there is not a number
        other = pickle.loads(pickle.dumps(first))
        other.fields.traction[3, 0] += 1.0
        self.assertNotEqual(first, other)

    def test_objects_that_no_constructor_made_raise(self):
        for kind in (rc.Session, rc.Transient, rc.Wheelset):
            for name in ("solve", "row", "step", "save", "fields", "state", "n_bodies_made"):
                if not hasattr(kind, name):
                    continue
                with self.assertRaises(RuntimeError, msg=f"{kind.__name__}.{name}"):
                    member = getattr(kind.__new__(kind), name)
                    member()
        with self.assertRaises(RuntimeError):
            rc.Session.__new__(rc.Session)["Contact/Creepage x"] = 0
        with self.assertRaises(RuntimeError):
            rc.State.__new__(rc.State).pressure

    def test_a_closed_session_says_so(self):
        with rc.Session(LOADED_2D) as session:
            state = session.solve()
        for use in (session.solve, session.row, lambda: session.set({"Contact/Creepage x": 0})):
            with self.assertRaises(RuntimeError) as raised:
                use()
            self.assertIn("closed", str(raised.exception))
        self.assertGreater(state.pressure.max(), 0.0)


class Columns(Case):
    def test_states_on_profiles_have_those_of_results(self):
        state = rc.Session(TWO_POINTS, ON_PROFILES).solve()
        row = rows_of_program(TWO_POINTS, ON_PROFILES)[0]
        self.assertEqual(set(state.columns), set(row))
        for value, column in (
            (state.contact_angle, "contact_angle_rad"),
            (state.contact_y_track, "contact_y_track_m"),
            (state.contact_y_wheel, "contact_y_wheel_m"),
            (state.patches[0]["normal_force_N"], "patch_1_normal_force_N"),
            (state.patches[1]["force_track_y_N"], "patch_2_force_track_y_N"),
            (state.patches[1]["y_m"], "patch_2_y_m"),
        ):
            self.assert_close(value, float(row[column]), 1e-6)
        self.assertEqual(len(state.patches), 2)
        self.assert_close(sum(patch["normal_force_N"] for patch in state.patches), state.normal_force, 1e-9)

    def test_others_have_them_if_asked_for(self):
        session = rc.Session(LOADED_2D)
        self.assertIsNone(session.solve().columns)
        self.assertIsNone(session.solve().contact_angle)
        state = session.solve(columns=True)
        self.assertEqual(state.columns["force_x_N"], state.force_x)
        self.assertIsNone(rc.Session(TWO_POINTS, ON_PROFILES).solve(columns=False).columns)


class Shown(Case):
    def test_texts_have_units(self):
        state = rc.Session(LOADED_2D).solve()
        self.assertRegex(repr(state), r"^<rolling_contact\.State: force_x -\S+ N, force_y 0 N, normal_force 140000 N>$")
        page = xml.etree.ElementTree.fromstring(state._repr_html_())
        rows = {row[0].text: (row[1].text, row[2].text) for row in page[1:]}
        self.assertEqual(rows["normal_force"], ("140000", "N"))
        self.assertEqual(rows["max_pressure"][1], "Pa")
        self.assertEqual(rows["contact_area"][1], "m^2")
        self.assertEqual(rows["bound_force"][1], None)
        transient = rc.Transient(PRM / "start_up_2d.prm", {"Mesh/Elements across patch": 8})
        self.assertRegex(repr(transient.step()), r"^<rolling_contact\.TransientState: time \S+ s, force_x \S+ N, ")
        self.assertIn("<td>kinetic_energy</td>", transient.state._repr_html_())

    def test_the_picture_of_a_line_has_its_nodes(self):
        state = rc.Session(LOADED_2D).solve()
        picture = xml.etree.ElementTree.fromstring(state._repr_svg_())
        lines = [line for line in picture.iter() if line.tag.endswith("polyline")]
        self.assertEqual(len(lines), 2)
        points = [np.array([point.split(",") for point in line.get("points").split()], float) for line in lines]
        self.assertEqual(len(points[0]), len(state.pressure))
        zero = next(float(line.get("y1")) for line in picture.iter() if line.tag.endswith("line") and line.get("stroke") == "black")
        # SVG counts down: mu p above the axis, the traction of a positive creepage below
        self.assertLess(points[0][:, 1].min(), zero - 50)
        self.assertGreater(points[1][:, 1].max(), zero + 50)
        # mu p and q in one scale: they meet where all slides
        ratio = (points[1][:, 1].max() - zero) / (zero - points[0][:, 1].min())
        expected = -state.traction[:, 0].min() / (0.3 * state.pressure.max())
        self.assert_close(ratio, expected, 0.01)

    def test_the_picture_of_a_patch_has_its_tractions(self):
        state = rc.Session(PATCH_3D).solve()
        picture = xml.etree.ElementTree.fromstring(state._repr_svg_())
        touching = int(np.count_nonzero(state.pressure))
        boxes = [box for box in picture.iter() if box.tag.endswith("rect")][1:]
        lines = [line for line in picture.iter() if line.tag.endswith("line")]
        self.assertEqual((len(boxes), len(lines)), (touching, touching))
        colours = [line.get("stroke") for line in lines]
        self.assertEqual(colours.count("#1f5a94"), int(np.count_nonzero(state.node_states == 2)))
        # y is up: a traction to +y has a smaller coordinate at its end
        line = lines[int(np.argmax(state.traction[state.pressure > 0, 1]))]
        self.assertLess(float(line.get("y2")), float(line.get("y1")))

    def test_plots(self):
        import matplotlib

        matplotlib.use("Agg")
        line = rc.Session(LOADED_2D).solve()
        axes = line.plot()
        self.assert_close(axes.lines[1].get_ydata().min(), 1e-6 * line.traction[:, 0].min(), 1e-12)
        self.assert_close(axes.lines[0].get_ydata().max(), 0.3e-6 * line.pressure.max(), 1e-9)
        patch = rc.Session(PATCH_3D).solve()
        own = matplotlib.pyplot.figure().add_subplot()
        self.assertIs(patch.plot(own), own)
        arrows = next(child for child in own.get_children() if isinstance(child, matplotlib.quiver.Quiver))
        np.testing.assert_allclose(arrows.U, patch.traction[patch.pressure > 0, 0])
        matplotlib.pyplot.close("all")


class Entries(Case):
    def test_are_attributes_of_their_sections(self):
        session = rc.Session(LOADED_2D)
        self.assertEqual(session.contact.creepage_x, "0.001")
        self.assertEqual(session.contact.friction_coefficient, "0.3")  # the default
        session.contact.creepage_x = np.float64(0.0015)
        self.assertEqual(session["Contact/Creepage x"], "0.0015")
        self.assertIn("mesh", dir(session))
        self.assertIn("elements_across_patch", dir(session.mesh))
        self.assertIn("creepage_x = 0.0015", repr(session.contact))
        with self.assertRaises(rc.InputError):
            session.mesh.elements_across_patch = "many"
        for wrong in (lambda: session.contact.creep, lambda: session.kontakt, lambda: setattr(session.contact, "creep", 1)):
            with self.assertRaises(AttributeError):
                wrong()

    def test_those_of_a_scene_can_be_read(self):
        scene = rc.Scene(CARTER)
        self.assertEqual(scene.contact.creepage_x, scene.entries["Contact/Creepage x"])
        with self.assertRaises(TypeError):
            scene.contact.creepage_x = 1


class References(Case):
    def test_hertz_and_carter(self):
        modulus = rc.references.contact_modulus(210e9, 0.3, 210e9, 0.3)
        self.assert_close(modulus, 210e9 / (2 * 0.91), 1e-12)
        line = rc.references.hertz_line(2e6, 0.23, modulus)
        self.assert_close(line.half_width, np.sqrt(4 * 2e6 * 0.23 / (np.pi * modulus)), 1e-12)
        x = np.linspace(-line.half_width, line.half_width, 20001)
        self.assert_close(np.trapz(line.pressure(x), x), 2e6, 1e-5)
        carter = rc.references.Carter(line, 0.23, 0.3, 0.001)
        self.assert_close(np.trapz(carter.traction(x), x), carter.force_ratio * 0.3 * 2e6, 1e-4)
        self.assertLess(carter.force_ratio, 0.0)

    def test_theories_over_arrays(self):
        ellipse = rc.references.hertz_ellipse(80e3, 1.0, 1.5, 115e9)
        shear, small, large = 80e9, 1e-7, 0.1
        bound = 0.3 * ellipse.load()
        for name in ("shen_hedrick_elkins", "fastsim", "polach"):
            theory = getattr(rc.references, name)
            for along in ((1, 0), (0, 1)):
                forces = theory(np.array([small, large]) * along[0], np.array([small, large]) * along[1], 0, ellipse, shear, 0.28, 0.3)
                self.assertEqual(forces.shape, (2, 2))
                linear = rc.references.kalker(small * along[0], small * along[1], 0, ellipse, shear, 0.28)
                self.assert_close(forces[0] @ along, linear[:2] @ along, 2e-3)
                self.assert_close(forces[1] @ along, -bound, 0.02)
        # Polach's formula by hand, oblique
        s = np.array([0.001, 0.002])
        C11, C22, _, _ = rc.references.kalker_coefficients(ellipse.half_width_x / ellipse.half_width_y, 0.28)
        C = np.hypot(C11 * s[0], C22 * s[1]) / np.hypot(*s)
        e = shear * np.pi * ellipse.half_width_x * ellipse.half_width_y * C * np.hypot(*s) / (4 * bound)
        force = 2 * bound / np.pi * (e / (1 + e**2) + np.arctan(e))
        np.testing.assert_allclose(rc.references.polach(*s, 0, ellipse, shear, 0.28, 0.3), -force * s / np.hypot(*s), rtol=1e-12)
        # spin: (..., 3) in the shape of what is broadcast
        linear = rc.references.kalker(np.zeros((2, 1)), 0.0, np.array([0.1, 0.2, 0.3]), ellipse, shear, 0.28)
        self.assertEqual(linear.shape, (2, 3, 3))
        self.assert_close(linear[1, 2, 1], 3 * linear[0, 0, 1], 1e-12)
        with self.assertRaises(rc.InputError):
            rc.references.polach(0.001, 0.0, 0.1, ellipse, shear, 0.28, 0.3)
        coefficients = rc.references.kalker_coefficients(1.0, 0.25)
        self.assert_close(coefficients[0], 4.12, 2e-3)  # Kalker 1990, table E3


class Tables(Case):
    def test_has_axes_bounds_and_frames(self):
        with tempfile.TemporaryDirectory() as folder:
            scene = pathlib.Path(folder) / "scene.prm"
            scene.write_text(
                PATCH_3D
                + "set Analysis = table\nsubsection Table\n"
                + "  set Axis 1 = Contact/Normal load = 34e3, 36e3\n  set Axis 2 = Contact/Creepage x = 0 : 0.002 : 3\nend\n"
            )
            subprocess.run([PROGRAM, str(scene), "--output", folder + "/run"], check=True, capture_output=True, cwd=folder)
            table = rc.read_table(folder + "/run")
            self.assertEqual(list(table.axes), ["contact_normal_load", "contact_creepage_x"])
            np.testing.assert_allclose(table.axes["contact_creepage_x"], (0.0, 0.001, 0.002))
            self.assertEqual(table.entries["contact_normal_load"], "Contact/Normal load")
            self.assertEqual(table.shape, (2, 3))
            np.testing.assert_allclose(table["normal_force_N"], [[34e3] * 3, [36e3] * 3], rtol=1e-9)
            self.assertTrue(np.all(np.diff(table["force_x_N"], axis=1) < 0))
            self.assertTrue(np.all(table.bounds["force_x_N"] > 0))
            self.assertEqual(table.units["force_x_N"], "N")
            self.assertIn("6 states solved", repr(table))
            with self.assertRaises(KeyError):
                table["force"]
            for package in ("pandas", "xarray"):
                try:
                    __import__(package)
                except ImportError:
                    with self.assertRaises(ImportError):
                        getattr(table, "to_" + package)()
                    continue
                frame = getattr(table, "to_" + package)()
                np.testing.assert_array_equal(np.ravel(frame["force_x_N"]), table["force_x_N"].ravel())
            with self.assertRaises(rc.InputError):
                rc.read_table(folder)
            wrong = pathlib.Path(folder) / "wrong.h5"
            wrong.write_text("no HDF5")
            with self.assertRaises(rc.InputError):
                rc.read_table(wrong)


class Packages(Case):
    def test_pip_installs_what_the_build_has(self):
        build = pathlib.Path(rc.__file__).resolve().parents[2]
        if not (build / "CMakeCache.txt").is_file():
            self.skipTest("the module is installed already")
        with tempfile.TemporaryDirectory() as folder:
            command = [sys.executable, "-m", "pip", "install", "--quiet", "--no-deps", "--no-index", "--target", folder]
            command += ["--config-settings", f"build-dir={build}", str(ROOT / "source/python")]
            subprocess.run(command, check=True, capture_output=True)
            code = "import rolling_contact, importlib.metadata as m; print(rolling_contact.__file__, m.version('rolling-contact'))"
            environment = {**os.environ, "PYTHONPATH": folder}
            said = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True, cwd=folder, env=environment)
            place, version = said.stdout.split()
            self.assertEqual(pathlib.Path(place).parent.parent, pathlib.Path(folder))
            self.assertEqual(version, rc.__version__)
            metadata = next(pathlib.Path(folder).glob("*.dist-info")) / "METADATA"
            self.assertTrue(re.search(r"^Requires-Dist: numpy$", metadata.read_text(), re.M))


if __name__ == "__main__":
    unittest.main()
