"""Every kind of scene in 2D: files, forces and what is said of the error."""

import functools

import h5py
import numpy as np
import pytest
from conftest import COARSER, QUICK, near, own_mesh, summary_has, written

DISCS = "carter_2d_partial_slip"


@pytest.fixture(scope="module")
def state(shared):
    """A scene of prm as it is, run once."""
    return functools.cache(shared)


@pytest.mark.parametrize("name", ["carter_2d_pure_rolling", DISCS, "carter_2d_full_slip", "carter_2d_paper_operator",
                                  "steel_on_aluminium_2d"])
def test_files_and_summary(state, name):
    run = state(name)
    written(run, "results.csv", "run.json", "used.prm", "original.prm", "bodies.pvd", "interface.pvd", "tractions.svg")
    assert run.json["status"] == "done"
    assert not (run / "contact_problem.h5").exists(), "not asked for"
    summary_has(run, "of mu N (estimate: ")


@pytest.mark.parametrize("name, column, low, high", [
    (DISCS, "normal_force_N", 140060, 141460), # at 0.22 mm
    (DISCS, "error_force_x/muN", -1e-3, 1e-3),
    ("carter_2d_full_slip", "traction_coefficient", 0.29997, 0.3),
    (DISCS, "error_sawtooth", 0, 0.035),
    ("carter_2d_paper_operator", "error_sawtooth", 0.035, 1)])
def test_results(state, name, column, low, high):
    assert low <= state(name).results.last(column) <= high


@pytest.mark.parametrize("scene, settings", [(DISCS, {"Mesh/Elements across patch": 12}), ("steel_on_aluminium_2d", QUICK)])
def test_the_solution_fulfils_the_laws_of_its_contact_problem(program, scene, settings):
    """Forces in equilibrium, no gap under pressure; tractions that move the surfaces of unlike bodies apart are in the gap."""
    run = program(scene, settings, {"Output/Contact problem": "true"})
    with h5py.File(run / "contact_problem.h5") as file:
        W = file["operators/W"][:]
        n = len(file["operators/positions"])
        H = np.zeros((n, n))
        for row, column, value in file["operators/H"][:]:
            H[int(row), int(column)] += value
        gap, mu = file["loads/gap"][:], file["loads/friction"][:]
        p, approach = file["solution/pressure"][:], file["solution/approach"][0]
        q = file["solution/traction"][:].reshape(-1, n)
        found_gap = file["solution/gap"][:]
        assert file["operators/W"].attrs["unit"] == "m/N"
    assert len(q) == len(W) // n - 1
    displacement = (W @ np.concatenate([H @ component for component in [*q, p]]))[len(q) * n:]
    size = np.max(np.abs(displacement))
    assert np.allclose(gap - approach + displacement, found_gap, atol=1e-9 * size)
    touching = p > 0
    assert touching.any() and not touching.all()
    assert np.max(np.abs(found_gap[touching])) < 1e-6 * size
    assert np.min(found_gap) > -1e-6 * size
    assert np.all(np.sqrt((q**2).sum(axis=0)) <= mu * p * (1 + 1e-9) + 1e-9 * np.max(p))
    assert np.isclose((H @ p).sum(), run.results["normal_force_N"][0], rtol=1e-8)
    assert np.isclose((H @ q[0]).sum(), run.results["force_x_N"][0], rtol=1e-8)


def test_a_mesh_from_a_file_is_as_good_as_a_generated_one(program):
    run = program("own_mesh_2d")
    own_mesh(run)
    generated = program("own_mesh_2d", {"Rail/Shape": "block", "Rail/Mesh file": "", "Rail/Block length": 0.2,
                                        "Rail/Block depth": 0.1}, output="generated")
    near(run.results.last("force_x_N"), generated.results.last("force_x_N"), 0, 1e-3 * 30e3)


def test_error_without_friction(program):
    summary_has(program(DISCS, COARSER, {"Contact/Friction coefficient": 0}), "of N against the exact clamped discs")


def test_error_of_levels_without_closed_form(program):
    run = program("steel_on_aluminium_2d", COARSER, {"Mesh/Adaptive levels": 2})
    summary_has(run, "for the elements across the patch,")
    (force,) = [error["value"] for error in run.json["errors"] if error["quantity"] == "force"]
    assert 0 < run.results.last("bound_force/muN") == force, "what the line says is what the column has"


def approach_gives_back_the_load(program, settings, load, tolerance):
    """A load, and what its approach carries; the state under the load."""
    loaded = program(DISCS, settings, {"Contact/Approach": "", "Contact/Normal load": load}, output="loaded").results
    pressed = program(DISCS, settings, {"Contact/Approach": loaded.texts("approach_m")[-1]}, output="pressed").results
    near(pressed.last("normal_force_N") / load, 1, 0, tolerance)
    return loaded


@pytest.mark.parametrize("hub, load", [(0.40, 1e3), (0.40, 1e4), (0.44, 1e4), (0.45, 1e3)])
def test_a_rim_of_rubber_whose_closed_form_falls_off(program, hub, load):
    rim = {**QUICK, "Wheel/Young modulus": 1e7, "Wheel/Poisson ratio": 0.49, "Wheel/Hub radius": hub}
    approach_gives_back_the_load(program, rim, load, 0.02)


@pytest.mark.parametrize("modulus, nu, load", [(5e6, 0.3, 400), (5e6, 0.4999, 900), (210e9, 0.3, 8e6)])
def test_a_block_as_thin_as_the_patch_is_wide(program, modulus, nu, load):
    layer = {**QUICK, "Mesh/Elements across patch": 24, "Rail/Shape": "block", "Rail/Radius": 0, "Rail/Block length": 0.5,
             "Rail/Block depth": 0.02, "Rail/Young modulus": modulus, "Rail/Poisson ratio": nu}
    assert 0.015 <= approach_gives_back_the_load(program, layer, load, 0.005).last("half_width_x_m") <= 0.05


def test_a_force_in_place_of_a_creepage(program):
    """An entry that is left empty is none."""
    run = program(DISCS, QUICK, {"Contact/Creepage x": "", "Contact/Longitudinal force": -2e4})
    near(run.results.last("force_x_N"), -20000, 0, 0.1)


ROLLER = "rubber_roller_2d"


def test_a_covered_roller_beside_the_exact_layer(program):
    run = program(ROLLER)
    results = run.results
    assert -0.0216 <= results.last("creepage_x") <= -0.0212, "of free rolling"
    assert -0.0184 <= results.last("free_creepage_x") <= -0.0182, "that of the plane layer"
    near(results.last("half_width_x_m") / results.last("reference_half_width_x_m"), 1, 0.005)
    assert results.texts("bound_force/muN")[-1] == "", "no bound is told"
    assert "half-planes with covers" in run.screen


def test_a_covered_roller_keeps_its_steady_state_in_time(program):
    run = program(ROLLER, {"Analysis": "transient", "Contact/Longitudinal force": "", "Contact/Creepage x": -0.02,
                           "Contact/Speed": 2, "Time/Initial state": "steady", "Time/Hold approach": "true",
                           "Time/Time step": 1e-5, "Time/End time": 2e-4, "Time/Inertia": "true", "Mesh/Elements across patch": 16})
    forces = run.table("history.csv")["force_x_N"]
    near(forces[-1] / forces[0], 1, 1e-6)


def test_a_cover_without_elements(program):
    program.refuses(ROLLER, "Wheel/Cover thickness = 0.01: Rigid = true has no mesh", {"Wheel/Rigid": "true"})
