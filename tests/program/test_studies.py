"""Accuracy studies."""

import collections
import itertools
import math
import re
import statistics

import pytest
from conftest import near, summary_has

SMALL = {"Accuracy study/Offsets": 2, "Mesh/Growth": 1}


def study(program, name, n_states, n_summary, *settings):
    """A study, its tables and what it says."""
    run = program(name, *settings)
    assert len(run.results) == n_states
    assert len(run.table("summary.csv")) == n_summary
    assert re.match("[0-9]+ (states|runs), .* reference", run.out.split("\n")[0]), "says at once how much there is to do"
    for table in run.folder.glob("*.csv"):
        assert not re.search("nan|inf", table.read_text(encoding="utf-8"), re.I), f"{table} has numbers only"
    assert "Pareto front" in (run / "error_cpu.svg").read_text(encoding="utf-8")
    best = run / "best.csv"
    assert best.exists() and best.stat().st_size > 0 or "No method reaches" in run.screen
    summary_has(run, "force ")
    return run


@pytest.fixture(scope="module")
def flat(shared):
    """A study in 2D: reference and two meshes to extrapolate; 4 operators and a solver on 2 meshes; 2 graded, 2 adaptive;
    times 2 positions and 2 creepages."""
    return study(shared, "accuracy_2d", 68, 34, SMALL, {
        "Accuracy study/Elements across patch": "10, 20", "Accuracy study/Reference elements across patch": 64,
        "Accuracy study/Creepages over saturation": "0.3, 0.7", "Accuracy study/Adaptive levels": 1})


def test_methods_of_a_study(flat):
    methods = flat.table("methods.csv")
    assert len(methods) == 14
    (error,) = [error for method, n, error in zip(methods.texts("method"), methods["elements"], methods["force_error_max"])
                if method == "calibrated" and n == 20]
    assert 1e-5 <= error <= 5e-3


def test_each_state_names_the_operator_it_was_solved_with(flat):
    operators = {(row["operator"], row["slip_operator"]) for row in flat.table("results.csv").records()}
    assert len(operators) == 4
    assert all(solved == ("galerkin" if operator == "paper" else operator) for operator, solved in operators)


def mean(states, column):
    return statistics.fmean(state[column] for state in states)


def states_of(row, states):
    """Those that a row of summary.csv is of: automatic and extragradient find the same ones.
    Carter's force is z^2 - 2 z over mu N, z the creepage over saturation."""
    own = [state for state in states if [state["mesh"], state["operator"], state["elements_across"]] ==
           [row["mesh"], row["slip_operator"], row["elements"]]
           and abs(1 - math.sqrt(1 + state["reference_force_x/muN"]) - row["creepage_over_saturation"]) < 0.02]
    assert own and len(own) % row["states"] == 0 and row["not_converged"] == 0
    return own


def test_the_summary_is_that_of_the_states(flat):
    states, summary = flat.table("results.csv").records(), flat.table("summary.csv").records()
    assert sum(row["states"] for row in summary) >= 10
    for row in summary:
        own = states_of(row, states)
        for error, column in (("load_error", "error_normal_force"), ("pressure_l2", "error_pressure_l2"),
                              ("traction_l2", "error_traction_l2"), ("sawtooth", "error_sawtooth"),
                              ("stick_boundary_elements", "error_stick_boundary_elements")):
            values = [abs(state[column]) if error == "stick_boundary_elements" else state[column] for state in own] # a distance
            near(row[f"{error}_max"], max(map(abs, values)), 1e-5, 1e-9)
            near(row[f"{error}_mean"], statistics.fmean(values), 1e-5, 1e-8)
        limit = row["reference_force_x/muN"]
        near(row["reference_force_y/muN"], 0, 0, 1e-9)
        near(limit, mean(own, "reference_force_x/muN"), 0, 4e-3) # Carter's
        off = [math.copysign(1, limit) * (state["force_x_N"] / (0.3 * state["normal_force_N"]) - limit) for state in own]
        near(row["force_error_max"], max(map(abs, off)), 1e-5, 2e-8)
        near(row["force_error_mean"], statistics.fmean(off), 1e-5, 2e-8)
        near(row["unknowns"], mean(own, "dofs"), 0, 0.51)
        near(row["contact_nodes"], mean(own, "contact_nodes"), 0, 0.51)
        residual = max(state[f"residual_{part}"] for state in own for part in ("normal", "tangential"))
        assert 0 <= row["residual_max"] <= residual * (1 + 1e-6)
        if row["states"] == len(own):
            near(row["residual_max"], residual, 1e-6, 1e-30)
        near(row["cpu_s"], sum(row[f"cpu_{part}_s"] for part in ("mesh_assembly", "factorisation_condensation", "contact")), 1e-6, 1e-9)
        assert [row[f"{what}_reference"] for what in ("force", "load", "pressure", "traction")] == [
            "64 elements, mean of 2 positions, extrapolated", "load against the exact clamped discs", "Hertz", "Carter"]


def test_the_order_of_a_method_is_that_of_its_errors(flat):
    summary, n_orders = flat.table("summary.csv").records(), 0
    for row in summary:
        coarser = [it["force_error_mean"] for it in summary
                   if list(it.values())[:5] == list(row.values())[:5] and 2 * it["elements"] == row["elements"]]
        if not coarser or row["elements"] == 64:
            assert row["order_of_mean"] == "", "an order of nothing"
        else:
            n_orders += 1
            near(row["order_of_mean"], math.log2(abs(coarser[0] / row["force_error_mean"])), 1e-5, 1e-6)
    assert n_orders >= 10


def test_methods_are_means_of_the_summary(flat):
    summary, methods = flat.table("summary.csv").records(), flat.table("methods.csv").records()
    for row in methods:
        operator, *others = row["method"].split(", ")
        own = [it for it in summary if it["slip_operator"] == operator and it["elements"] == row["elements"]
               and (it["mesh"] if it["mesh"] != "uniform" else it["solver"]) == (others or ["automatic"])[0]]
        assert own
        for error in ("force_error", "load_error", "pressure_l2", "traction_l2", "stick_boundary_elements"):
            near(row[f"{error}_max"], max(it[f"{error}_max"] for it in own), 1e-6, 1e-9)
            near(row[f"{error}_mean"], statistics.fmean(abs(it[f"{error}_mean"]) for it in own), 1e-6, 1e-9)
        for column in ("cpu_mesh_assembly_s", "cpu_factorisation_condensation_s", "cpu_contact_s", "cpu_s"):
            near(row[column], statistics.fmean(it[column] for it in own), 1e-6, 1e-9)
        for column, value in (("states", sum), ("not_converged", sum), ("residual_max", max), ("peak_memory_bytes", max)):
            near(row[column], value(it[column] for it in own), 1e-6, 1e-30)


def test_a_study_in_3d(program):
    """Reference and two; calibrated, paper and adaptive; 2 directions."""
    study(program, "accuracy_3d", 24, 12, SMALL, {
        "Accuracy study/Elements across patch": 6, "Accuracy study/Adaptive starts": 5,
        "Accuracy study/Reference elements across patch": 16, "Accuracy study/Directions": "lateral, combined",
        "Accuracy study/Creepages over saturation": 0.5, "Accuracy study/Slip operators": "calibrated, paper",
        "Accuracy study/Meshes": "uniform, adaptive"})


def test_a_study_in_time(program):
    """An error of second order with theta = 0.5, of first with 1; the load does not change; cost adds up."""
    run = study(program, "accuracy_time_2d", 6, 4, {
        "Mesh/Growth": 0.5, "Mesh/Elements across patch": 12, "Time/End time": 64e-6, "Accuracy study/Time steps": "4e-6, 8e-6",
        "Accuracy study/Thetas": "0.5, 1", "Accuracy study/Reference time step": 2e-6})
    errors = collections.defaultdict(list)
    for row in run.table("summary.csv").records():
        near(row["cpu_set_up_s"] + row["cpu_steps_s"], row["cpu_s"], 0, 1e-6)
        near(row["time_step_s"] * row["steps"], 64e-6, 0, 1e-9)
        assert row["iterations_per_step"] >= 1
        assert 0 < row["common_times"] <= row["steps"]
        assert 0 < row["force_error_mean"] <= row["force_error_max"]
        assert 0 <= row["load_error_mean"] <= row["load_error_max"] < 1e-9
        errors[1 if row["theta"] == 1 else 2].append(row["force_error_max"])
    for order, found in errors.items():
        for before, after in itertools.pairwise(found):
            assert 2 ** (order - 0.5) < before / after < 2 ** (order + 0.5)


def test_a_state_that_is_not_solved_is_counted(program):
    run = program("accuracy_2d", SMALL, {
        "Accuracy study/Elements across patch": 10, "Accuracy study/Reference elements across patch": 32,
        "Accuracy study/Creepages over saturation": 0.5, "Accuracy study/Slip operators": "calibrated",
        "Accuracy study/Meshes": "uniform", "Accuracy study/Solvers": "automatic, fixed point", "Contact/Maximal iterations": 100})
    assert [row["not_converged"] for row in run.table("methods.csv").records() if "fixed point" in row["method"]] == [2]


@pytest.mark.parametrize("scene, entry, value, says", [
    ("accuracy_2d", "Accuracy study/Vary", "load", "Vary"),
    ("accuracy_2d", "Accuracy study/Meshes", "uniform, fine", "Meshes"),
    ("accuracy_2d", "Accuracy study/Slip operators", "upwind 3", "Slip operators"),
    ("accuracy_2d", "Accuracy study/Solvers", "newton", "Solvers"),
    ("accuracy_2d", "Accuracy study/Directions", "lateral", "Accuracy study/Directions contains lateral"),
    ("accuracy_2d", "Accuracy study/Elements across patch", "12, 400", "Accuracy study/Elements across patch contains 400"),
    ("accuracy_2d", "Accuracy study/Elements across patch", "12, 12", "contains 12 twice"),
    ("accuracy_2d", "Accuracy study/Reference elements across patch", "383", "Reference elements across patch = 383"),
    ("accuracy_2d", "Accuracy study/Creepages over saturation", "0", "Creepages over saturation"),
    ("accuracy_2d", "Mesh/Adaptive levels", "1", "Mesh/Adaptive levels"),
    ("accuracy_time_2d", "Accuracy study/Time steps", "1e-6, 3e-7", "Accuracy study/Time steps contains 3e-07"),
    ("accuracy_time_2d", "Accuracy study/Reference time step", "0", "Accuracy study/Reference time step"),
    ("accuracy_time_2d", "Accuracy study/Thetas", "0.4", "Thetas"),
    ("accuracy_time_2d", "Time/End time", "0", "Time/End time")])
def test_what_is_refused(program, scene, entry, value, says):
    program.refuses(scene, says, {entry: value})


def test_a_study_without_friction(program):
    program("accuracy_2d", {"Contact/Friction coefficient": 0}, code=1, says="Contact/Friction coefficient")
