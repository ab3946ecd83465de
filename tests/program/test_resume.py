"""A transient run that is extended, fails, is terminated or killed, and resumed."""

import random
import shutil
import signal

import pytest
from conftest import LIGHT, RESUME, Run, kill_and_resume, n_lines, same_files, same_results, same_run

VIBRATION = ("oscillating_creepage_2d", LIGHT, {"Time/Field interval": 20, "Time/Checkpoint interval": 5})
SIXTY = {"Time/End time": "120e-6"}
LONG = {"Time/End time": "800e-6"}
IMPACT = ("impact_2d", LIGHT, {"Time/End time": "10e-6"})


def same_force(run, other):
    assert run.results.texts("force_x_N")[-1] == other.results.texts("force_x_N")[-1]


def test_a_run_that_is_extended_is_that_in_one_go(program):
    whole = program(*VIBRATION, SIXTY, output="whole")
    program(*VIBRATION, {"Time/End time": "80e-6"}, output="extended")
    extended = program(*VIBRATION, SIXTY, output="extended", options=RESUME)
    same_run(extended, whole)
    same_results(extended, whole)
    again = program(*VIBRATION, SIXTY, {"Output/Verbosity": "normal"}, output="extended", options=RESUME)
    assert "no step is left" in again.out
    same_run(again, whole)
    same_results(again, whole)
    program(*VIBRATION, {"Time/End time": "60e-6"}, output="extended", options=RESUME, code=1,
            says="Time/End time = 6e-05 s is reached after 30")
    same_run(extended, whole)
    ends = [[line for line in (run / "used.prm").read_text().splitlines() if "End time" in line] for run in (extended, whole)]
    assert ends[0] == ends[1] != []


def copy_of(run):
    """What a run has left, before another one follows it in its folder."""
    folder = run.folder.with_name(f"{run.folder.name}.first")
    shutil.copytree(run.folder, folder)
    return Run(run.command, folder, run.code, run.out, run.err, run.seconds)


@pytest.mark.parametrize("scene", [
    ("start_up_2d", LIGHT),
    IMPACT,
    (*VIBRATION, {"Time/End time": "20e-6", "Contact/Friction law": "rational", "Contact/Kinetic friction coefficient": 0.2,
                  "Contact/Friction decay speed": 1}),
    ("start_up_2d", LIGHT, {"Contact/Creepage x": 0, "Contact/Longitudinal force": "-1e4"}),
], ids=["no inertia", "impact", "falling friction", "a force"])
def test_a_finished_run_that_is_resumed_stays_as_it_is(program, scene):
    first = copy_of(program(*scene, output="run"))
    again = program(*scene, output="run", options=RESUME)
    same_run(again, first)
    same_results(again, first)
    if scene is IMPACT:  # its two bodies differ: two threads must not round otherwise
        same_run(program(*scene, output="again"), first)
        same_run(program(*scene, {"Body threads": 1}, output="one_thread"), first)


def test_creepages_that_a_resumed_run_finds_for_a_force(program):
    scene = ("start_up_2d", LIGHT, {"Contact/Creepage x": 0, "Time/Longitudinal force": "-2e4*min(1, t/2e-3)",
                                    "Time/Checkpoint interval": 3, "Time/Field interval": 50})
    whole = program(*scene, output="whole")
    program(*scene, {"Time/Rolled distance": 0.02}, output="parts")
    same_run(program(*scene, output="parts", options=RESUME), whole)


def test_a_run_that_fails_keeps_its_last_good_state(program):
    """Resumed, it fails at the same step."""
    swelling = (*VIBRATION, LONG, {"Time/Approach": "0.22e-3 * (1 + 3e3 * t)"})
    first = copy_of(program(*swelling, output="swelling", code=2, says="reaches the border"))
    again = program(*swelling, output="swelling", code=2, options=RESUME)
    assert again.err == first.err
    same_files(again, first, "history.csv")


@pytest.fixture(scope="module")
def whole(shared):
    return shared(*VIBRATION, LONG, output="whole")


def test_a_run_that_is_terminated(program, whole):
    run = program.start(*VIBRATION, LONG, output="terminated")
    run.wait_until((run / "checkpoint.bin").exists, 4)
    run.send(signal.SIGTERM)
    done = run.end()
    assert (done.code, done.json["status"]) == (2, "interrupted")
    assert 5 < n_lines(done / "history.csv") < 401
    for says, settings in (('Contact/Speed was "10"', {"Contact/Speed": 11}), ("Time/Time step", {"Time/Time step": 1e-6})):
        program(*VIBRATION, LONG, settings, output="terminated", options=RESUME, code=1, says=says)
    resumed = program(*VIBRATION, LONG, output="terminated", options=RESUME)
    same_run(resumed, whole)
    same_force(resumed, whole)


def test_a_run_that_is_killed(program, whole):
    moments = [random.uniform(0.05, 0.2 if k == 0 else 0.55) for k in range(6)]  # the first one before any machine is done
    run, kills = kill_and_resume(program, moments, *VIBRATION, LONG, output="killed")
    assert kills >= 1
    same_run(run, whole)
    same_files(run, whole, "history.bin")
    same_force(run, whole)
