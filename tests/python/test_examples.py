"""The scripts of doc/python, in small versions."""

import pathlib
import sys
import unittest

from cases import LOADED_2D, PATCH_3D, ROOT, Case

sys.path.insert(0, str(ROOT / "doc/python"))

import cosimulation  # noqa: E402
import creep_curve  # noqa: E402
import force_table  # noqa: E402
import profile_series  # noqa: E402
import theories  # noqa: E402

SMALL = {"elements": 12, "n_cycles": 2, "steps_per_cycle": 40, "amplitude": 1e-4}


class CoSimulation(Case):
    def test_grows_as_its_closed_form(self):
        heavy = cosimulation.compare(**SMALL, mass=20000.0)
        self.assertGreater(heavy["sigma"], 1.0)
        self.assert_close(heavy["sigma_found"], heavy["sigma"], 1e-3)
        self.assert_close(heavy["omega_found"], heavy["omega"], 5e-4)

    def test_differs_from_it_by_the_elasticity_of_the_bodies(self):
        """By sigma tau of the frequency, tau = C T'/V whatever the mass."""
        errors = []
        for mass in (5000.0, 20000.0):
            found = cosimulation.compare(**SMALL, mass=mass)
            errors.append(found["omega_found"] / found["omega"] - 1)
        self.assert_close(errors[0] / errors[1], 4.0, 0.03)

    def test_decays_where_friction_rises(self):
        """On the rising part of the curve the contact is a damper."""
        found = cosimulation.compare(**SMALL, mass=4e6, creepage=0.0005)
        self.assertLess(found["sigma"], -0.05)
        self.assert_close(found["sigma_found"], found["sigma"], 0.1)


class Curves(Case):
    def test_creep_curve(self):
        rows = creep_curve.creep_curve(PATCH_3D, (0.0005, 0.001, 0.004), {"Contact/Spin": 0})
        forces = [row[1] for row in rows]
        self.assertEqual(forces, sorted(forces, reverse=True))
        self.assertTrue(all(0.0 < row[2] < 1.0 for row in rows))

    def test_force_table(self):
        rows, n_bodies = force_table.force_table(PATCH_3D, {}, (36e3, 35e3), (0.0, 0.5))
        self.assertEqual((len(rows), n_bodies), (8, 1))
        for load, force_x, force_y, creepage_x, creepage_y, bound in rows:
            self.assertIn(round(-force_x / (0.3 * load), 6), (0.0, 0.5))
            self.assertIn(round(-force_y / (0.3 * load), 6), (0.0, 0.5))
            self.assertGreater(bound, 0.0)
        self.assertGreater(rows[2][3], 0.0)

    def test_theories(self):
        settings = {"Mesh/Elements across patch": 12}
        table = theories.theories(creepages=(0.0001, 0.002, 0.02), settings=settings)
        self.assert_close(table["program"][0], table["kalker"][0], 0.08)
        for name in ("fastsim", "polach", "shen_hedrick_elkins"):
            self.assertLess(abs(table["program"][1] - table[name][1]), 0.12)
            self.assert_close(table[name][2], 1.0, 0.05)
        self.assert_close(table["program"][2], 1.0, 1e-3)
        self.assertTrue(all(table["bound"] > 0.0))

    def test_profile_series(self):
        rows, n_bodies = profile_series.series(shifts=(-0.002, 0.002), settings={"Mesh/Elements across patch": 8})
        self.assertEqual(len(rows[0]), len(profile_series.COLUMNS))
        self.assertLess(rows[1][1], rows[0][1])  # to the right: towards the flange
        self.assertGreater(rows[0][4], 500.0)
        self.assertLessEqual(n_bodies, 2)


if __name__ == "__main__":
    unittest.main()
