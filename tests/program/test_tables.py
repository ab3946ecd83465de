"""Analysis = table: the same numbers whatever the threads, a run that is killed and resumed, the files, and what is refused."""

import re
import shutil
import subprocess

import pytest
from conftest import PROJECT, QUICK, QUIET, RESUME, Table, kill_and_resume, n_lines, near, same_results, summary_has, written

try:
    import h5py
    import numpy as np
except ImportError:
    h5py = None

needs_h5py = pytest.mark.skipif(h5py is None, reason="table.h5 is not read: there is no h5py (python3-h5py)")
TABLE = "table_3d"
SMALL = {"Mesh/Elements across patch": 8, "Mesh/Growth": 0.8, **QUIET}
NO_AXES = {f"Table/Axis {k}": "" for k in (1, 2, 3, 4)}


@pytest.fixture(scope="module")
def grid(shared):
    return shared(TABLE)


def test_files_and_summary(grid):
    written(grid, "table.h5", "table_1.svg", "table_2.svg", "table_3.svg", "table_4.svg")
    summary_has(grid, "of mu N (estimate: the largest of column")
    assert "112 states" in grid.out


def test_a_row_for_each_state(grid):
    rows, force = grid.results.records(), {}
    assert len(rows) == 112
    for k, row in enumerate(rows):
        assert row["state"] == k and row["status"] == "solved"
        assert row["Contact/Creepage x"] == row["creepage_x"]
        assert row["elements_across"] >= 10
        assert row["bound_force/muN"] <= (0.02 if row["spin_1/m"] == 0 else 0.035)
        near(row["normal_force_N"] / row["Contact/Normal load"], 1, 1e-8)
        if row["creepage_y"] == 0 and row["spin_1/m"] == 0:
            force[row["Contact/Normal load"], row["Contact/Creepage x"]] = row["force_x_N"]
    # symmetric in x without lateral creepage and spin
    there, back = force[80000, 0.006], force[80000, -0.006]
    assert there < 0 < back
    near(back, -there, 5e-3)


def test_threads_change_nothing(program, grid):
    one, three = (program(TABLE, {"Table/Threads": n}, output=f"threads_{n}") for n in (1, 3))
    same_results(one, three)
    same_results(grid, three)


def test_threads_change_nothing_of_a_mesh_file_and_an_expression(program):
    one, four = (program("own_mesh_2d", QUIET, {
        "Analysis": "table", "Table/Axis 1": "Contact/Creepage x = 0.0002 : 0.004 : 12",
        "Table/Axis 2": "Contact/Normal load = 80e3 : 100e3 : 11", "Mesh/Elements across patch": 12,
        "Contact/Roughness": "1e-7*cos(x/1e-3)", "Table/Threads": n}, output=f"threads_{n}") for n in (1, 4))
    same_results(one, four)


def test_a_state_is_that_of_a_run_of_its_own(program, grid):
    """But for its start."""
    state = {"Contact/Normal load": 40e3, "Contact/Creepage x": 0.002, "Contact/Creepage y": 0.004, "Contact/Spin": 0.4}
    alone = program(TABLE, NO_AXES, state, {"Analysis": "quasi-static"}, output="state").results
    row = grid.results.record(**state)
    for column in ("force_x_N", "force_y_N", "spin_moment_Nm", "max_pressure_Pa"):
        near(row[column] / alone.last(column), 1, 1e-5, what=column)


def test_killed_again_and_again(program):
    """The rows stay, and the end is the same."""
    long = (TABLE, SMALL, {"Table/Threads": 2, "Table/Axis 2": "Contact/Creepage x = -0.006 : 0.006 : 25"})
    whole, kept, n_rows = program(*long, output="whole"), {}, [1]

    def killed(folder):
        file = folder / "results.csv"
        n_rows[0] = n_lines(file)
        table = Table(file)  # all lines are whole
        assert len(table) > 0 and n_rows[0] < 401, "killed in the middle"
        kept.clear()
        kept.update(zip(table.texts("state"), table.texts("wall_s")))

    run, kills = kill_and_resume(program, [0, 0, 0], *long, output="killed", file="results.csv",
                                 begun=lambda run: n_lines(run / "results.csv") > n_rows[0], killed=killed)
    assert kills >= 1 and kept
    same_results(whole, run)
    times = dict(zip(run.results.texts("state"), run.results.texts("wall_s")))
    assert all(times[state] == seconds for state, seconds in kept.items()), "no row was computed again"

    finished = program(*long, {"Output/Verbosity": "normal"}, output="killed", options=RESUME)
    assert "400 states are there already" in finished.screen
    same_results(whole, finished)
    program(*long, {"Table/Axis 4": "Contact/Spin = 0, 0.5"}, output="killed", options=RESUME, code=1, says="Table/Axis 4")
    (run / "results.csv").write_text(re.sub("(?m)^3,", "3000,", run.text("results.csv")), encoding="utf-8")
    program(*long, output="killed", options=RESUME, code=1, says="not one of its states")


ROWS = """Contact/Normal load; Rail/Lateral radius; Contact/Spin; Contact/Friction coefficient
40e3; 0.3; 0; 0.3
0; 0.3; 0; 0.3
40e3; 0.3; 0.5; 0
41e3; 0.2; 0.5; 0.5
"""
OF_FILE = ("rows.prm", SMALL, NO_AXES, {"Table/File of rows": "rows.csv", "Contact/Creepage y": 0.001})


@pytest.fixture(scope="module")
def rows(shared):
    """Bodies that differ and states that do not touch; then with a row that is added."""
    shutil.copy(shared.scene(TABLE), shared.folder / "rows.prm")
    shared.write("rows.csv", ROWS)
    run = shared(*OF_FILE, {"Output/Verbosity": "normal"}, output="rows")
    first = run.results.records(), run.out, run.text("results.csv").splitlines()
    shared.write("rows.csv", ROWS + "1;1;1;1\n")
    return first, shared(*OF_FILE, output="rows", options=RESUME)


def test_rows_of_a_file(rows):
    states, out, lines = rows[0]
    assert sum(row["status"] == "solved" for row in states) == 3
    assert lines[2].startswith("1,0,0.3,0,0.3,no contact,")
    assert len(re.findall("^.*Bodies made for", out, re.M)) == 3


def test_a_file_of_rows_that_was_changed(rows, shared):
    assert len(rows[1].results) == 5, "rows that were added are solved"
    shared.write("rows.csv", (ROWS + "1;1;1;1\n").replace("41e3", "42e3"))
    shared(*OF_FILE, output="rows", options=RESUME, code=1, says="was a file changed")


def test_where_profiles_touch_is_no_matter_of_bodies(program):
    touching = ("profiles_tread", {"Mesh/Elements across patch": 8, "Output/Verbosity": "normal", "Profiles/Yaw": 0.002})
    places = program(*touching, {"Analysis": "table", "Table/Axis 1": "Profiles/Lateral shift = 0.0028, 0.003, 0.0032"}, output="places")
    assert len(re.findall("^.*Bodies made for", places.out, re.M)) == 1
    alone = program(*touching, {"Profiles/Lateral shift": 0.0032}, output="place").results
    row = places.results.record(**{"Profiles/Lateral shift": 0.0032})
    for column in ("force_x_N", "force_y_N", "contact_angle_rad"):
        near(row[column] / alone.last(column), 1, 1e-2, what=column)


def test_in_2d_under_an_approach(program):
    run = program("carter_2d_partial_slip", QUICK, {"Analysis": "table", "Table/Axis 1": "Contact/Creepage x = 0, 0.001, 0.002",
                                                    "Table/Axis 2": "Contact/Approach = 0.2e-3, 0.22e-3"}, output="plane")
    assert len(run.results) == 6


@pytest.fixture(scope="module")
def unsolved(shared):
    return shared(TABLE, SMALL, {"Table/Axis 2": "Contact/Maximal iterations = 2, 10000", "Contact/Solver": "extragradient",
                                 "Contact/Creepage x": 0.001}, output="unsolved", code=2, says="are not solved (column status")


def test_states_that_are_not_solved(unsolved):
    """All others are there, and it is not silent: one sentence says why."""
    said = re.findall(r"The state of the table with (.*?) did not converge: \w", unsolved.messages)
    assert len(said) == 1 and "Contact/Maximal iterations = 2" in said[0], unsolved.messages
    assert unsolved.json["status"] == "not converged"
    assert len(unsolved.results) == 32
    written(unsolved, "table.h5")
    failed = unsolved.results.records(status="not converged")
    assert failed and all(row["converged"] == "false" and row["force_x_N"] == "" for row in failed)


@pytest.mark.parametrize("says, settings", [
    ("Table/Axis 2 = Contact/Creepage x = : the list is empty", {"Table/Axis 2": "Contact/Creepage x ="}),
    ("did you mean Contact/Creepage x", {"Table/Axis 2": "Contact/Creepage xx = 0, 1"}),
    ("Table/Axis 1 and Table/File of rows are both empty", NO_AXES),
    ("leave one of them empty", {"Table/File of rows": "x.csv"}),
    ("cannot be read: there is no such file", {"Table/File of rows": "x.csv", **NO_AXES}),
    ("Wheel/Poisson ratio = 0.5", {"Table/Axis 2": "Wheel/Poisson ratio = 0.3, 0.5"}),
    ("leave the other empty", {"Table/Axis 2": "Contact/Approach = 1e-5, 2e-5"}),
    ("Mesh/Target error", {"Mesh/Target error": 1e-2}),
    ("Mesh/Adaptive levels", {"Mesh/Adaptive levels": 1}),
])
def test_refused_before_anything_is_solved(program, says, settings):
    program.refuses(TABLE, says, settings, output="refused")


def test_between_the_states(program):
    """Runs of their own at random points; the bends of a coarse grid are wide."""
    table = program(TABLE, SMALL, {"Table/Axis 1": "Contact/Normal load = 60e3, 70e3, 80e3",
                                   "Table/Axis 2": "Contact/Creepage x = 0.0005 : 0.0025 : 5",
                                   "Table/Axis 3": "Contact/Friction coefficient = 0.3, 0.35, 0.4", "Table/Axis 4": ""}, output="between")
    done = subprocess.run([PROJECT / "tests/campaigns/table_points", "--program", program.path, "--table", table.folder, "--points", "4",
                           "--median", "5e-3", "--largest", "2e-2"], cwd=program.folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done


def same(array, table, column):
    """An array holds the numbers of a column with all digits, of which its texts have nine; NaN where it is empty."""
    assert np.allclose(np.asarray(array).reshape(-1), table[column], rtol=5e-9, atol=0, equal_nan=True), column


@needs_h5py
def test_table_h5_of_a_grid(grid):
    file, table = h5py.File(grid / "table.h5"), grid.results
    axes = file.attrs["axes"].split(", ")
    assert axes == ["contact_normal_load", "contact_creepage_x", "contact_creepage_y", "contact_spin"]
    results = file["results"]
    force = results["force_y_N"]
    assert force.shape == tuple(len(file["axes/" + name]) for name in axes)
    for d, name in enumerate(axes):
        scale = force.dims[d][0]
        assert scale == file["axes/" + name] and h5py.h5ds.is_scale(scale.id)
        assert force.dims[d].label == name
        shape = [1] * len(axes)
        shape[d] = -1
        same(np.broadcast_to(scale[:].reshape(shape), force.shape), table, scale.attrs["entry"])
    for array in results.values():
        same(array, table, array.attrs["column"])
    assert len(results) > 30
    bound = file[force.attrs["bound"]]
    for array, unit in ((force, "N"), (bound, "N"), (file["axes/contact_spin"], "1/m"), (file["axes/contact_creepage_x"], "1"),
                        (results["spin_moment_Nm"], "Nm"), (results["contact_area_m2"], "m2"),
                        (results["bound_force_per_muN"], "mu N"), (results["traction_coefficient"], "1")):
        assert array.attrs["unit"] == unit, array
    traction = 0.3 * results["normal_force_N"][:]
    assert np.allclose(bound[:], traction * results["bound_force_per_muN"][:], rtol=1e-8)
    moment = traction * results["bound_moment_per_muNa"][:] * results["half_width_x_m"][:]
    assert np.allclose(file["bounds/spin_moment_Nm"][:], moment, rtol=1e-8)
    assert (file["status"][:] == 1).all()
    assert "Analysis" in file["scene"][()].decode()


@needs_h5py
def test_table_h5_of_states_that_are_not_solved(unsolved):
    file = h5py.File(unsolved / "table.h5")
    status = file["status"][:].reshape(-1)
    assert list(status) == [1 if text == "solved" else 3 for text in unsolved.results.texts("status")]
    force = file["results/force_x_N"][:].reshape(-1)
    assert np.isnan(force[status == 3]).all() and np.isfinite(force[status == 1]).all()
    assert (status == 3).any()


@needs_h5py
def test_table_h5_of_rows(rows):
    table, file = rows[1].results, h5py.File(rows[1] / "table.h5")
    assert file.attrs["kind"] == "rows"
    assert file["results/force_x_N"].shape == (len(table),)
    same(file["axes/contact_friction_coefficient"], table, "Contact/Friction coefficient")
    assert list(file["status"]) == [2 if text == "no contact" else 1 for text in table.texts("status")]
    mu = file["axes/contact_friction_coefficient"][:]
    solved = (file["status"][:] == 1) & (mu > 0)
    bound = mu * file["results/normal_force_N"][:] * file["results/bound_force_per_muN"][:]
    assert np.allclose(file["bounds/force_x_N"][:][solved], bound[solved])


@needs_h5py
def test_the_example_that_interpolates(grid):
    done = subprocess.run(["/usr/bin/python3", "-B", PROJECT / "doc/example/interpolate_table.py", grid / "table.h5", "contact_normal_load=60e3",
                           "contact_creepage_x=0.003", "contact_creepage_y=0.001", "contact_spin=0.1"],
                          capture_output=True, text=True, check=False)
    assert done.returncode == 0 and "force_x_N" in done.stdout, done
