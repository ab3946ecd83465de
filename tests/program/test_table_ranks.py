"""A table under mpirun: the same bytes as on one rank, whatever their number, and nothing that is done is lost."""

import os
import re
import shutil
import signal
import time

import pytest
from conftest import HERE, RESUME, same_files, same_results
from ranks import pids, told_once

# three sets of bodies, states without contact, and columns of numbers that only some rows have
FEW = {"Output/Plot": "false", "Mesh/Elements across patch": 6}
TABLE = ("table_3d", FEW, {"Output/Verbosity": "normal", "Table/Threads": 1})
LONG = (*TABLE, {"Table/Axis 2": "Contact/Creepage x = -0.006 : 0.006 : 121"})
N_LONG = 1936


def same_table(run, other):
    same_results(run, other)
    same_files(run, other, "table.h5")
    assert run.files() == other.files()


@pytest.fixture(scope="module")
def whole(shared):
    return shared(*TABLE, output="whole")


def test_a_table(program, whole):
    for ranks in (1, 2, 4):
        run = program(*TABLE, output="many", ranks=ranks)
        same_table(whole, run)
        assert run.json["ranks"] == ranks
        assert len(re.findall("^files  many", run.out, re.M)) == 1
    assert "1 thread on each of 4 ranks" in run.screen
    assert re.search("; 4 ranks, [0-9]* to [0-9]* states each", run.screen), run


def test_parts_on_ranks_joined_on_ranks(program, whole):
    for k in (1, 2):
        program(*TABLE, {"Table/Part": f"{k}/2"}, output=f"part_{k}", ranks=2)
    same_results(whole, program(*TABLE, {"Table/Join": "part_*"}, output="joined", ranks=2))


def test_rows_of_a_file(program):
    """States that do not touch or are not solved stand first."""
    file = ["Wheel/Young modulus, Contact/Approach, Contact/Creepage x"]
    for modulus, approach in (("100e9", "-1e-5"), ("150e9", "-1e-5"), ("150e9", "6e-5"), ("200e9", "-1e-5"), ("200e9", "6e-5")):
        file += [f"{modulus}, {approach}, {k * 1e-5:.6g}" for k in range(1, 41)]
    rows = ("table_3d", FEW, {f"Table/Axis {k}": "" for k in (1, 2, 3, 4)},
            {"Contact/Normal load": "", "Table/File of rows": program.write("rows.csv", "\n".join(file) + "\n")})
    alone = program(*rows, output="rows_whole")
    assert "no contact" in alone.text("results.csv")
    same_table(alone, program(*rows, output="rows_many", ranks=2))
    for k in (1, 2):
        program(*rows, {"Table/Part": f"{k}/2"}, output=f"rows_{k}")
    for order in ("rows_1, rows_2", "rows_2, rows_1"):
        same_results(alone, program(*rows, {"Table/Join": order}, output="rows_joined"))


def test_states_that_are_not_solved(program):
    few = (*TABLE, {"Contact/Maximal iterations": 1, "Contact/Solver": "fixed point"})
    many = told_once(program(*few, output="many", code=2, ranks=3), "Of 112 states of the table")
    same_results(program(*few, output="whole", code=2), many)
    assert many.json["status"] == "not converged"


def test_a_wrong_axis(program):
    told_once(program(*TABLE, {"Table/Axis 4": "Contact/Nothing = 1, 2"}, output="wrong", code=1, ranks=2), "Table/Axis 4")


@pytest.fixture(scope="module")
def long_whole(shared):
    return shared(*LONG, output="long_whole")


def lines_of(folder, files="results*.csv"):
    """The cells of all rows in the files of any rank, of which one may be removed meanwhile."""
    lines = []
    for file in folder.glob(files):
        try:
            lines += [line.split(",") for line in file.read_text(encoding="utf-8").splitlines()[1:]]
        except FileNotFoundError:
            pass
    return lines


def states_in(folder):
    return {cells[0] for cells in lines_of(folder)}


def times(folder, files):
    """States and the seconds that they took, the last column."""
    return {(cells[0], cells[-1]) for cells in lines_of(folder, files)}


def begin_long(program, folder, ranks):
    """Waits for rows of two files."""
    run = program.start(*LONG, output=folder, ranks=ranks)
    run.wait_until(lambda: len(list(run.folder.glob("results*csv"))) >= 2)
    return run


def test_a_rank_that_is_killed_ends_them_all(program, long_whole):
    """And every chain that was done is there."""
    run = begin_long(program, "killed", 3)
    os.kill(pids(run)[1], signal.SIGKILL)
    assert run.end().code != 0
    assert list(run.folder.glob("results_rank_*.csv"))
    assert 0 < len(states_in(run.folder)) < N_LONG
    (run / "results.csv").unlink(missing_ok=True)  # as if the root had none yet
    n, before = len(states_in(run.folder)), times(run.folder, "results_rank_*.csv")
    resumed = program(*LONG, output="killed", options=RESUME, ranks=2)
    assert f"{n} states are there already" in resumed.screen
    same_table(long_whole, resumed)
    assert before and before <= times(run.folder, "results.csv"), "no row was computed again"


def test_killed_again_while_it_goes_on_then_resumed_without_mpirun(program, long_whole):
    run = begin_long(program, "again", 2)
    os.kill(pids(run)[0], signal.SIGKILL)
    run.end()
    if (run / "results_rank_1.csv").exists():  # killed before it was removed
        shutil.copy(run / "results.csv", run / "results_rank_1.csv")
    n = len(states_in(run.folder))
    run = program.start(*LONG, output="again", options=RESUME, ranks=4)
    run.wait_until(lambda: len(states_in(run.folder)) > n, 8)
    for pid in pids(run)[2:3]:
        os.kill(pid, signal.SIGKILL)
    run.end()
    assert len(states_in(run.folder)) >= n, "no row is lost"
    same_table(long_whole, program(*LONG, output="again", options=RESUME))


def test_a_rank_that_is_terminated(program, long_whole):
    for rank in (0, 1):
        shutil.rmtree(program.folder / "stopped", ignore_errors=True)
        run = begin_long(program, "stopped", 2)
        os.kill(pids(run)[rank], signal.SIGTERM)
        done = told_once(run.end(), "Interrupted by SIGTERM", code=2)
        assert done.json["status"] == "interrupted"
        assert "--resume goes on from here" in done.screen
        assert [name for name in done.files() if name.startswith("results")] == ["results.csv"], "all rows are in one file"
        assert 0 < len(done.results) < N_LONG
        assert len(done.results) < 1500, "the other rank stops as well"
    same_table(long_whole, program(*LONG, output="stopped", options=RESUME, ranks=2))


def test_all_killed_at_once(program, whole):
    """As when the power is lost: each rank's rows are there; the next run removes them."""
    run = begin_long(program, "next", 2)
    for pid in (*pids(run)[:2], run.process.pid):
        os.kill(pid, signal.SIGKILL)
    done = run.end()
    assert done.has("results.csv", "results_rank_1.csv")
    time.sleep(1)
    same_table(whole, program(*TABLE, output="next"))
    (run / "results_rank_1.csv").touch()
    program(*TABLE, output="next", code=1, says="the former run did not write results_rank_1.csv")


def test_a_map(program):
    """The state that squeals most is proved by the whole bodies, whichever rank solved it."""
    stability = (HERE / "pair.prm", {"Analysis": "stability map", "Output/Verbosity": "normal",
                                     "Table/Axis 1": "Contact/Friction coefficient = 0.2 : 0.41 : 22",
                                     "Table/Axis 2": "Contact/Creepage y = -0.02, 0, 0.02"})

    def said(run):
        return re.search("squeal .* error ", run.screen).group(), len(re.findall("^Warning", run.err, re.M))

    alone = program(*stability, output="map_whole")
    assert "by the whole bodies" in said(alone)[0]
    for ranks in (2, 3):
        run = program(*stability, output="map_many", ranks=ranks)
        same_table(alone, run)
        assert said(run) == said(alone)
