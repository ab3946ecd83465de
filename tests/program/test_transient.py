"""Every kind of transient scene."""

import re

import pytest
from conftest import COARSER, LIGHT, QUIET, RESUME, same_results, same_run, summary_has

START, VIBRATION, IMPACT = "start_up_2d", "oscillating_creepage_2d", "impact_2d"


@pytest.mark.parametrize("scene, rows, settings", [
    (START, 50, {"Time/Rolled distance": 0.02}),
    ("start_up_3d", 10, {"Time/Rolled distance": 8e-3, "Mesh/Growth": 1}),
    ("rolling_at_speed_2d", 50, {"Time/End time": 50e-6}),
    (VIBRATION, 60, {"Time/End time": 120e-6}),
    (IMPACT, 100, {"Time/End time": 10e-6}),
])
def test_scenes(program, scene, rows, settings):
    run = program(scene, LIGHT, settings)
    history = run.table("history.csv")
    assert len(history) == rows
    assert not re.search("nan|inf|,,|,$", (run / "history.csv").read_text().lower(), re.M)
    for file in ("history.svg", "bodies.pvd", "interface.pvd", "results.csv", "checkpoint.bin"):
        assert (run / file).stat().st_size, file
    assert not (run / "history.csv.part").exists()
    if scene == "rolling_at_speed_2d":
        assert -1e-11 <= history.last("energy_balance_error") <= 1e-11, "the steady state stays put"
    if scene == IMPACT:
        assert 1e-3 <= history.last("strain_J") <= 0.4, "kinetic energy turns into strain"


def test_steps_are_halved(program):
    """The load is between the 14484 N of whole ones and the limit."""
    history = program(IMPACT, QUIET, {"Time/Time step": 1e-6, "Time/End time": 60e-6, "Contact/Solver": "fixed point",
                                      "Contact/Maximal iterations": 40, "Contact/Tolerance": 1e-8,
                                      "Output/Body fields": "false"}).table("history.csv")
    assert history.last("parts") > 1
    assert 14500 <= history.last("normal_force_N") <= 14555
    assert -1e-12 <= history.last("energy_balance_error") <= 1e-12


def test_the_error_of_the_time_step(program):
    """Its estimate changes nothing but the time that the run takes."""
    rolling = program(START, COARSER, {"Time/Rolled distance": 0.01}, output="rolling")
    summary_has(rolling, "for the time step")
    assert any(phase["phase"] == "error of the time step" for phase in rolling.json["phases"])
    plain = program(START, COARSER, {"Time/Rolled distance": 0.01, "Time/Step estimate": "false"}, output="plain")
    summary_has(plain, "time step not estimated")
    same_run(rolling, plain)
    same_results(rolling, plain)
    resumed = program(START, COARSER, {"Time/Rolled distance": 0.012}, output="plain", options=RESUME)
    summary_has(resumed, "time step not estimated")


def test_the_error_of_the_time_step_without_friction(program):
    summary_has(program(IMPACT, COARSER, {"Time/End time": 10e-6, "Time/Field interval": 0}), "of N for the time step")


def test_longer_steps_that_fail_estimate_nothing(program):
    """9 steps, or 4 of 9/4 of their length: one ends where the approach is too much."""
    run = program(START, COARSER, {"Time/Step length": 0, "Time/Rolled distance": 0, "Time/Time step": 1e-4, "Time/End time": 9e-4,
                                   "Time/Approach": "if(abs(t - 4.5e-4) < 1e-5, 3e-3, 0.22e-3)"},
                  says="The error of the time step is not known")
    summary_has(run, "time step not estimated")


def friction_creates_nothing(run, part=1e-16):
    """friction_J falls by rounding only, of its nine digits and of the energy."""
    history = run.table("history.csv")
    before = 0
    for heat, kinetic, strain in zip(history["friction_J"], history["kinetic_J"], history["strain_J"]):
        assert heat - before >= -1e-9 * before - part * (heat + kinetic + strain)
        before = heat


@pytest.mark.parametrize("scene", [START, VIBRATION])
@pytest.mark.parametrize("operator", ["upwind 1", "upwind 2", "galerkin", "calibrated"])
def test_friction_creates_no_energy(program, scene, operator):
    """Where the traction answers the slip of the edge law, by the error of the mesh."""
    run = program(scene, LIGHT, {"Contact/Slip operator": operator, "Output/Plot": "false", "Time/Field interval": 0})
    friction_creates_nothing(run, 1e-9 if operator == "calibrated" else 1e-16)


def test_friction_in_an_impact_creates_no_energy(program):
    friction_creates_nothing(program(IMPACT, LIGHT, {"Contact/Friction coefficient": 0.3, "Contact/Creepage x": 0.1, "Contact/Speed": 1,
                                                     "Time/Field interval": 0}))
