"""Wheelsets in balance: the numbers of the program, wheels as states, what is refused."""

import unittest

import rolling_contact as rc
from cases import PRM, Case, rows_of_program

CURVE = PRM / "wheelset_curve.prm"
FEW = {
    "Mesh/Elements across patch": 5,
    "Wheelset/Curve radius": "-2000",
    "Wheelset/Search for others": "false",
}


class Wheelsets(Case):
    def test_is_that_of_the_program(self):
        (state,) = rc.Wheelset(CURVE, FEW).solve()
        right, left = rows_of_program(CURVE, FEW)
        (row,) = rows_of_program(CURVE, FEW, "wheelset.csv")
        for value, column in [
            (state.curvature, "curvature_1/m"),
            (state.lateral_shift, "lateral_shift_m"),
            (state.yaw, "yaw_rad"),
            (state.roll, "roll_rad"),
            (state.pitch_rate, "pitch_rate_rad/s"),
            (state.lateral_force, "lateral_force_N"),
            (state.yaw_moment, "yaw_moment_Nm"),
            (state.drag, "drag_N"),
            (state.creep_work, "creep_work_J/m"),
            (state.bounds[0], "bound_lateral_shift_m"),
            (state.bounds[1], "bound_yaw_rad"),
            (state.bounds[2], "bound_axle_excess"),
        ]:
            self.assert_close(value, float(row[column]), 2e-8)
        self.assertLess(state.residual, 1e-5)
        self.assertEqual(state.name, "")
        for wheel, row in [(state.right, right), (state.left, left)]:
            self.assert_close(wheel.force_track[1], float(row["force_track_y_N"]), 2e-8)
            self.assert_close(wheel.max_pressure, float(row["max_pressure_Pa"]), 2e-8)
            self.assert_close(wheel.creepages[0], float(row["creepage_x"]), 2e-8)
            self.assertEqual(wheel.pressure.max(), wheel.max_pressure)
        # to the left the right-hand wheel is the outer one
        self.assertGreater(state.lateral_shift, 0.0)
        self.assertGreater(state.right.max_pressure, state.left.max_pressure)

    def test_refuses_what_the_program_refuses(self):
        with self.assertRaisesRegex(rc.InputError, "Axle load"):
            rc.Wheelset(CURVE, {"Wheelset/Axle load": 0})
        with self.assertRaisesRegex(rc.ConvergenceError, "lift a wheel off"):
            rc.Wheelset(CURVE, {**FEW, "Wheelset/Lateral force": 3e5}).solve()


if __name__ == "__main__":
    unittest.main()
