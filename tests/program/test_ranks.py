"""Runs under mpirun."""

import os
import re
import signal

import pytest
from conftest import QUICK, QUIET, RESUME, n_lines, same_files, same_results
from ranks import near_history, near_results, pids, told_once

DISCS = "carter_2d_partial_slip"
DISTRIBUTED = {**QUICK, "Body solver": "distributed"}
POINTS = {"Analysis": "creep curve", "Creep curve/Creepage x": "0 : 0.008 : 5"}
LOUD = {"Output/Verbosity": "normal"}


@pytest.mark.parametrize("ranks", [1, 2, 3])
def test_what_is_said_once(program, ranks):
    version = program(None, options=("--version",), ranks=ranks)
    assert len(re.findall("^rolling-contact ", version.out, re.M)) == 1
    typo = program.write("typo.prm", "subsection Contact\n  set Aproach = 1\nend\n").name
    told_once(program(typo, code=1, ranks=ranks), "typo.prm: ")
    foreign = program.folder / "foreign"
    foreign.mkdir()
    (foreign / "thesis.tex").touch()
    told_once(program(DISCS, output="foreign", code=1, ranks=ranks), 'Cannot use "foreign"')
    assert os.listdir(foreign) == ["thesis.tex"]


def pieces(files, ranks):
    """The files of one rank, every body in so many pieces."""
    of_bodies = [name for name in files if name.endswith("-0.vtu")]
    return sorted([*set(files).difference(of_bodies),
                   *(f"{name[:-6]}-{piece}.vtu" for name in of_bodies for piece in range(ranks))])


def test_a_steady_state_and_a_curve(program):
    alone = program(DISCS, DISTRIBUTED, output="alone")
    assert "all_ranks" not in alone.text("run.json")
    curve_alone = program(DISCS, DISTRIBUTED, POINTS, output="curve_alone")
    for ranks in (1, 2, 3):
        many = program(DISCS, DISTRIBUTED, LOUD, output="many", ranks=ranks)
        near_results(alone, many)
        assert many.files() == pieces(alone.files(), ranks)
        same_files(alone, many, "bodies.pvd")
        assert many.json["ranks"] == ranks
        assert len(re.findall("^files  many", many.out, re.M)) == 1
        if ranks == 1:
            same_results(alone, many)
        curve = program(DISCS, DISTRIBUTED, POINTS, output="many", ranks=ranks)
        near_results(curve_alone, curve)
        if ranks == 1:
            same_results(curve_alone, curve)
    memory = curve.json["all_ranks"]
    largest = memory["largest_peak_memory_bytes"]
    assert 2 * largest < memory["peak_memory_bytes"] <= 3 * largest
    longest = memory["largest_cpu_seconds"]
    assert 0 < longest < memory["cpu_seconds"] <= 3 * longest


def test_ranks_that_a_small_scene_does_not_need(program):
    needless = program(DISCS, QUICK, LOUD, output="needless", ranks=2)
    assert re.search("2 ranks were started.*without mpirun takes less", needless.screen), needless
    assert "without mpirun" not in program(DISCS, DISTRIBUTED, LOUD, output="asked", ranks=2).out


def test_validation_and_a_study_of_one_rank(program):
    assert program(DISCS, options=("--validate",), ranks=2).out.rstrip("\n") == f"{program.scene(DISCS)}: valid"
    told_once(program.refuses("accuracy_2d", "", output="study_of_ranks", ranks=2), "Analysis = accuracy study runs on one rank")


def test_no_convergence(program):
    run = program(DISCS, DISTRIBUTED, {"Contact/Solver": "fixed point", "Contact/Slip operator": "galerkin", "Contact/Maximal iterations": 50},
                  output="stopped", code=2, ranks=3)
    told_once(run, "The contact solver did not converge")
    assert run.json["status"] == "not converged"


def test_the_launcher_of_another_mpi(program):
    told_once(program(DISCS, code=1, env={"PMI_SIZE": "3"}), "The launcher started 3 ranks, MPI knows 1")


def test_ranks_without_a_file(program):
    """The first rank solves its scene."""
    run = program(DISCS, QUICK, output="half", ranks=1, options=(":", "-n", "2", program.path, "missing.prm"), code=1)
    told_once(run, "rank 1 of 3: missing.prm")
    assert run.seconds <= 30


def test_ranks_with_other_parameters(program):
    other = (":", "-n", "1", program.path, program.scene(DISCS), "--output", "half")
    told_once(program(DISCS, QUICK, output="half", ranks=1, options=other, code=1), "The ranks read different parameters")


@pytest.fixture
def endless(program):
    """Three ranks with some rows of many."""
    run = program.start(DISCS, DISTRIBUTED, POINTS, {"Creep curve/Creepage x": "0 : 0.008 : 1000000"}, output="endless", ranks=3)
    run.wait_for_rows(2)
    return run


def test_the_root_loses_its_folder(program, endless):
    endless.folder.rename(program.folder / "moved")
    told_once(endless.end(), "rank 0 of 3: Cannot write", code=1)


def test_a_killed_rank(program, endless):
    """The rows done are kept, and the folder can be used again."""
    os.kill(pids(endless)[1], signal.SIGKILL)
    assert endless.end().code != 0
    assert n_lines(endless / "results.csv") > 2
    program(DISCS, QUICK, output="endless", ranks=2)


def interrupted(run):
    assert run.json["status"] == "interrupted"
    assert len(run.results) > 1


def test_a_rank_that_is_terminated(endless):
    os.kill(pids(endless)[2], signal.SIGTERM)
    interrupted(told_once(endless.end(), "Interrupted by SIGTERM", code=2))


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_mpirun_that_is_interrupted(endless, number):
    endless.send(number)
    run = endless.end()
    assert run.code != 0
    assert len(re.findall("^rolling-contact: Interrupted by SIGTERM", run.err, re.M)) == 1, run
    interrupted(run)


ROLLING = ("oscillating_creepage_2d", {"Body solver": "distributed", "Mesh/Elements across patch": 12, "Mesh/Growth": 0.5, **QUIET,
                                       "Time/Field interval": 20, "Time/Checkpoint interval": 5})


def test_a_transient_of_three_ranks_resumed_on_two(program):
    alone = program(*ROLLING, {"Time/End time": "60e-6"}, output="alone")
    program(*ROLLING, {"Time/End time": "40e-6"}, output="many", ranks=3)
    many = program(*ROLLING, {"Time/End time": "60e-6"}, output="many", options=RESUME, ranks=2)
    near_history(alone, many)
    assert (alone / "checkpoint.bin").stat().st_size == (many / "checkpoint.bin").stat().st_size
    program(*ROLLING, {"Time/End time": "60e-6", "Contact/Speed": 11}, output="many", options=RESUME, ranks=2, code=1)


def test_a_transient_stopped_on_three_ranks_resumed_on_one(program):
    long = (*ROLLING, {"Time/End time": "800e-6", "Time/Checkpoint interval": 0})
    alone = program(*long, output="alone")
    run = program.start(*long, output="many", ranks=3)
    run.wait_until(lambda: list(run.folder.glob("interface-*.vtu")))
    os.kill(pids(run)[1], signal.SIGTERM)
    told_once(run.end(), "Interrupted by SIGTERM", code=2)
    assert n_lines(run / "history.csv") < 401, "in the middle"
    near_history(alone, program(*long, output="many", options=RESUME))


def test_the_last_good_state_is_written_by_the_root_when_all_have_failed(program):
    swelling = (*ROLLING, {"Time/End time": "800e-6", "Time/Approach": "0.22e-3 * (1 + 3e3 * t)"})
    first = told_once(program(*swelling, output="swollen", ranks=2, code=2), "The patch reaches the border")
    again = program(*swelling, output="swollen", options=RESUME, code=2, says="reaches the border")
    at = [re.findall(" t = [^ ]* s", run.messages) for run in (first, again)]
    assert at[0] and at[0] == at[1]
