"""Bodies by their modes in time: growth against the eigenvalue, the same motion as that of full bodies, runs that are resumed,
energies, and what is refused."""

import pytest
from conftest import QUIET, RESUME, VALIDATE, same_files, same_results
from reduced_bodies import difference, growth

SCENE = "carter_2d_full_slip"
DISCS = {"Analysis": "transient", "Contact/Speed": 10, "Mesh/Elements across patch": 10, "Contact/Creepage x": 0.02,
         "Modes/Maximum frequency": 8000, **QUIET, "Wheel/Rayleigh mass": 40, "Rail/Rayleigh mass": 40, "Output/Body fields": "false",
         "Time/Initial state": "steady", "Time/Time step": 4e-6, "Time/End time": 4e-3, "Spectrum/Write": "never", "Output/Plot": "false"}
REDUCED = {**DISCS, "Time/Bodies": "reduced"}
FALLS = {"Contact/Friction law": "exponential", "Contact/Kinetic friction coefficient": 0.2, "Contact/Friction decay speed": 0.2}
EXCITE = {"Time/Excite mode": 500, "Time/Excite velocity": 1e-3}
EXCITED = {**REDUCED, **FALLS, "Time/Excite mode": 500, "Time/Excite velocity": 1e-4}
BUMP = {"Surfaces/Rail height": "2e-6*exp(-((x+0.015)/0.002)^2)", "Time/Time step": 2e-6, "Time/End time": 3e-3}
# full bodies have no edge law
MEMORY = {**FALLS, "Contact/Slip operator": "upwind 2", **BUMP, "Contact/Friction response": "patch mean"}


def test_a_vibration_that_grows(program):
    run = program(SCENE, EXCITED, {"Time/End time": 8e-3})
    history, eigenvalue = run.table("history.csv"), run.results.last("excited_growth_1/s")
    assert 1 <= eigenvalue <= 1e4
    assert 0.99 <= growth(history, run.results.last("excited_frequency_Hz")) / eigenvalue <= 1.01
    assert abs(history.last("energy_balance_error")) <= 1e-10
    assert 0.6 <= history.last("friction_share") <= 1


def test_where_nothing_grows_a_vibration_begins_all_the_same_and_decays(program):
    run = program(SCENE, REDUCED, EXCITE, {"Time/End time": 40e-3, "Output/Verbosity": "normal"})
    assert "Hz that decays by" in run.screen
    eigenvalue = run.results.last("excited_growth_1/s")
    assert -1e4 <= eigenvalue <= -1e-3
    assert 0.999 <= growth(run.table("history.csv"), run.results.last("excited_frequency_Hz")) / eigenvalue <= 1.001


@pytest.mark.parametrize("settings", [BUMP, MEMORY], ids=["bump", "memory"])
def test_as_full_bodies(program, settings):
    """A bump of 2 um that passes; the same with friction that falls with a memory, where full bodies are resumed as well."""
    full = program(SCENE, DISCS, settings, output="full")
    reduced = program(SCENE, REDUCED, settings, output="reduced").table("history.csv")
    for column, bound in (("normal_force_N", 0.005), ("force_x_N", 0.005), ("velocity_x_m/s", 0.01), ("velocity_z_m/s", 0.01)):
        assert 1e-9 <= difference(reduced[column], full.table("history.csv")[column]) <= bound, column
    if settings is MEMORY:
        program(SCENE, DISCS, settings, {"Time/End time": 1e-3}, output="part")
        same_files(program(SCENE, DISCS, settings, output="part", options=RESUME), full, "history.csv")


@pytest.mark.parametrize("bodies", ["full", "reduced"])
def test_a_held_approach(program, bodies):
    """A load that gives the steady state alone: the approach stays, the load does not."""
    table = program(SCENE, DISCS, BUMP, {"Contact/Approach": "", "Contact/Normal load": 1.4e5, "Time/Hold approach": "true",
                                         "Time/End time": 1.6e-3, "Time/Bodies": bodies}).table("history.csv")
    assert 140001 <= table.last("normal_force_N") <= 145000
    assert len(set(table.texts("approach_m"))) == 1


def test_resumed_in_the_middle(program):
    whole = program(SCENE, EXCITED, {"Time/End time": 2e-3}, output="whole")
    program(SCENE, EXCITED, {"Time/End time": 1e-3}, output="part")
    rest = program(SCENE, EXCITED, {"Time/End time": 2e-3}, output="part", options=RESUME)
    same_files(rest, whole, "history.csv")
    same_results(rest, whole)


@pytest.mark.parametrize("settings, says", [
    ({"Time/Initial state": "rest"}, "take Time/Initial state = steady"),
    ({"Time/Theta": 0.6}, "Time/Theta = 0.6"),
    ({"Time/Inertia": "false"}, "leaves nothing to reduce"),
    ({"Time/Rayleigh alpha": 3}, "give Rayleigh mass and stiffness of Wheel and Rail"),
    ({"Contact/Speed": ""}, "give a constant Contact/Speed"),
    ({"Time/Mass": "consistent"}, "take lumped"),
    ({"Body solver": "distributed"}, "modes are found with a factor"),
    ({"Time/Excite velocity": 1e-3}, "one needs the other"),
    ({"Time/Hold approach": "true"}, "give Contact/Normal load"),
    ({"Contact/Approach": "", "Contact/Normal load": 1e5, **EXCITE}, "set Time/Hold approach = true"),
    ({**FALLS, "Contact/Friction memory": 2e-5}, "longer than a tenth of it"),
    ({**FALLS, "Contact/Friction memory": 0}, "Contact/Friction memory = 0"),
    ({"Time/Bodies": "full", **EXCITE}, "they are for Time/Bodies = reduced"),
])
def test_refused(program, settings, says):
    program.refuses(SCENE, says, REDUCED, settings, options=VALIDATE)
