"""What the tests share that run under mpirun: settings, what ranks say at the end, and bodies solved in another way."""

import re
import subprocess

from conftest import QUIET, near

DIRECT, SPREAD = {"Body solver": "direct"}, {"Body solver": "distributed"}
SOLID = {"Mesh/Elements across patch": 8, "Mesh/Growth": 0.4, "Output/Body fields": "false", **QUIET}
COARSEST = {"Mesh/Elements across patch": 6, "Mesh/Growth": 0.7}
SAME = ("level", "dofs", "contact_nodes", "elements_across", "slip_operator", "creepage_x", "creepage_y", "spin_1/m",
        "nodes_in_contact", "converged")


def told_once(run, says, code=None):
    """One message of all ranks begins with a text; what mpirun adds is not the program's."""
    assert code in (None, run.code), run
    assert f"rolling-contact: {says}" in run.messages, run
    assert len(re.findall("^rolling-contact: ", run.err, re.M)) == 1, run
    return run


def pids(run):
    """The processes of mpirun, in the order of their ranks."""
    found = subprocess.run(["pgrep", "-P", str(run.process.pid)], capture_output=True, text=True, check=False)
    return [int(pid) for pid in found.stdout.split()]


def numbers(table, column):
    return [float(text or 0) for text in table.texts(column)]


def near_results(run, other, mu=0.3):
    """The same meshes and counts, N to 1e-8, T to 1e-8 of mu N; in the other a natural residual of at most 1e-10 after
    at most 12 corrections."""
    known, found = run.results, other.results
    assert "corrections" in known and "corrections" in found
    assert len(known) == len(found) > 0
    for row, its in zip(known.records(), found.records()):
        for column in SAME:
            assert its[column] == row[column], column
        load = row["normal_force_N"]
        assert load > 0
        for column, scale in (("normal_force_N", load), ("force_x_N", mu * load), ("force_y_N", mu * load),
                              ("spin_moment_Nm", mu * load * row["half_width_x_m"]), ("approach_m", row["approach_m"])):
            near(its[column] or 0, row[column] or 0, absolute=1e-8 * scale, what=column)
        for column, limit in (("residual_normal", 1e-10), ("residual_tangential", 1e-10), ("corrections", 12)):
            assert (its[column] or 0) <= limit, column


def near_history(run, other, balance=1e-12, ratio=1e-8):
    """The same steps and counts, every other column to 1e-8 of its largest value. Energies, which add up errors, to 1e-6,
    and several_solutions_ratio, which depends on slopes of the friction law, to `ratio`.

    What vanishes but for rounding: energies to 1e-12 of the largest one, forces and moments to 1e-12 of the load (times
    1 m). Velocities, differences of displacements over a step, to 1e-9 of the approach over the step. In the other an
    energy_balance_error of at most `balance`."""
    known, found = run.table("history.csv"), other.table("history.csv")
    assert found.columns == known.columns and len(found) == len(known) > 0
    largest = {column: max(map(abs, numbers(known, column))) for column in known.columns}
    energy = max([value for column, value in largest.items() if column.endswith("_J")], default=0)
    step = abs(numbers(known, "time_s")[0]) if "time_s" in known else 0
    for column in known.columns:
        values, its = numbers(known, column), numbers(found, column)
        if re.match("step|nodes_|impacts|parts", column):
            assert its == values, column
        elif column == "energy_balance_error":
            assert all(abs(value) <= balance for value in its), f"{column} {max(map(abs, its))}"
        elif column != "iterations":
            relative, floor = 1e-8, 0
            if column.endswith("_J"):
                relative, floor = 1e-6, 1e-12 * energy
            elif re.search("_Nm?$", column):
                floor = 1e-12 * largest.get("normal_force_N", 0)
            elif column == "several_solutions_ratio":
                relative = ratio
            elif column.startswith("velocity_") and step > 0:
                floor = 1e-9 * largest.get("approach_m", 0) / step
            bound = max(relative * largest[column], floor)
            worst = [abs(a - b) for a, b in zip(its, values)]
            assert all(difference <= bound for difference in worst), f"{column} differs by {max(worst)}, more than {bound}"
