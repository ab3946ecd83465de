"""Bodies by their modes that are driven: by an approach, loads and forces over time, by waves that pass. They move as full bodies do,
also in steps that are halved and without friction."""

import math

from conftest import QUIET, RESUME, same_files
from reduced_bodies import between, deviation, difference

SCENE = "oscillating_creepage_2d"
RUN = {"Spectrum/Write": "never", "Output/Plot": "false", **QUIET, "Time/Field interval": 0, "Time/Time step": 2e-6,
       "Modes/Count check": "false"}
DISCS = {**RUN, "Mesh/Elements across patch": 12, "Mesh/Candidate zone": 2.2, "Time/Theta": 0.5, "Time/End time": 1e-3}
REDUCED = {"Time/Bodies": "reduced", "Time/Theta": 0.5, "Modes/Maximum frequency": 10000}


def alike(full, reduced, start, rms, extremes, *columns):
    """Columns of reduced bodies against those of full ones from a time (s) on, at the times that forces act: differences and those of
    the extremes, over the deviation of the full bodies'."""
    times, others = full["force_time_s"], reduced["force_time_s"]
    chosen = [t for t in times if max(start, others[0]) <= t <= others[-1]]
    for column in columns:
        whole, part = full[column], reduced[column]
        a, b = [between(t, times, whole) for t in chosen], [between(t, others, part) for t in chosen]
        spread = deviation(a) / math.sqrt(len(a))
        assert 1e-12 <= difference(b, a) <= rms, column
        assert max(abs(max(a) - max(b)), abs(min(a) - min(b))) / spread <= extremes, f"extremes of {column}"


def history(program, output, *settings, scene=SCENE, **how):
    return program(scene, *settings, output=output, **how).table("history.csv")


def both(program, *settings):
    """Histories of full and reduced bodies."""
    return history(program, "full", DISCS, *settings), history(program, "reduced", DISCS, *settings, REDUCED)


def test_waves_that_pass(program):
    """Of 30 mm and 5 um: forces and where they peak; nodes with mass bounce unless theta is above 0.5."""
    waves = {**RUN, "Time/Rolled distance": 0.04}
    full = history(program, "full", waves, {"Time/Theta": 0.51}, scene="corrugation_2d")
    reduced = history(program, "reduced", waves, REDUCED, scene="corrugation_2d")
    alike(full, reduced, 0, 0.01, 0.02, "normal_force_N", "force_x_N", "velocity_z_m/s")


def test_a_hub_that_moves(program):
    alike(*both(program, {"Time/Approach": "0.22e-3*(1+0.05*sin(2*pi*1000*t)^2)"}), 0, 0.003, 0.003,
          "normal_force_N", "force_x_N", "velocity_z_m/s")


def test_a_hub_that_moves_so_far_that_contact_is_lost(program):
    full, reduced = both(program, {"Time/Approach": "0.22e-3*cos(2*pi*1000*t)"})
    alike(full, reduced, 0, 0.01, 0.02, "normal_force_N", "force_x_N")
    assert min(reduced["normal_force_N"]) == 0
    assert abs(reduced.last("energy_balance_error")) <= 1e-10


def test_a_load_that_is_given(program):
    load = {"Contact/Approach": "", "Contact/Normal load": 1.4e5, "Time/Normal load": "1.4e5*(1+0.1*sin(2*pi*800*t)^2)"}
    alike(*both(program, load, {"Time/End time": 6e-4}), 0, 0.005, 0.005, "force_x_N", "velocity_z_m/s")


def test_a_force_that_is_given(program):
    full, reduced = both(program, {"Contact/Creepage x": 0, "Time/Creepage x": "", "Time/End time": 6e-4,
                                   "Time/Longitudinal force": "-2e4-1e3*sin(2*pi*800*t)^2"})
    alike(full, reduced, 0, 0.01, 0.01, "velocity_x_m/s")
    alike(full, reduced, 0, 0.025, 0.02, "creepage_x")  # that of full bodies belongs to the end of a step
    asked = -2e4 - 1e3 * math.sin(2 * math.pi * 800 * reduced.last("force_time_s")) ** 2
    assert abs(reduced.last("force_x_N") / asked - 1) <= 1e-6


def test_where_nothing_vibrates(program):
    """Bodies by their modes have the tractions of bodies without mass, with the edge law as well: `upwind 2` is 0.16 of this off."""
    slow = {**DISCS, "Contact/Slip operator": "calibrated", "Time/Creepage x": "0.0008*(1+0.3*sin(2*pi*20*t))", "Time/Time step": 1e-4,
            "Time/End time": 0.03}
    alike(history(program, "full", slow, {"Time/Inertia": "false"}), history(program, "reduced", slow, REDUCED), 2e-3, 0.004, 0.004, "force_x_N")


def test_steps_that_are_halved(program):
    """Those in which the solver stops too early; a run goes on behind them."""
    hard = {**DISCS, **REDUCED, "Contact/Solver": "fixed point", "Contact/Tolerance": 1e-8, "Time/Approach": "0.22e-3*cos(2*pi*1000*t)",
            "Time/End time": 1.1e-4}
    few = {**hard, "Contact/Maximal iterations": 700, "Time/Checkpoint interval": 1}
    whole = history(program, "whole", hard, {"Contact/Maximal iterations": 2000})
    halved = program(SCENE, few, output="halved")
    table = halved.table("history.csv")
    assert max(table["parts"]) > 1 and max(whole["parts"]) == 1
    alike(whole, table, 0, 1e-3, 2e-3, "normal_force_N")
    assert abs(table.last("energy_balance_error")) <= 1e-10
    program(SCENE, few, {"Time/End time": 9e-5}, output="part")
    same_files(program(SCENE, few, output="part", options=RESUME), halved, "history.csv")


def test_a_wheel_that_meets_the_rail_without_friction(program):
    meets = {**RUN, "Wheel/Hub": "clamped", "Wheel/Hub radius": 0.02, "Time/Initial velocity": 0, "Time/Initial state": "steady",
             "Contact/Speed": 10, "Time/Time step": 0.2e-6, "Time/End time": 120e-6, "Time/Approach": "-1e-6+0.035e-3*sin(pi*t/120e-6)^2"}
    full = history(program, "full", meets, scene="impact_2d")
    reduced = history(program, "reduced", meets, {"Time/Bodies": "reduced", "Modes/Maximum frequency": 50000}, scene="impact_2d")
    alike(full, reduced, 0, 0.01, 0.01, "normal_force_N")
    assert min(reduced["normal_force_N"]) == 0, "it starts without contact"
