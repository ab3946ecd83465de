"""kill -9 at random moments of reduced runs, sweeps of limit cycles and maps of stability: the resumed
end is that of a run in one go. Two processes in one folder: one of them is refused."""

import random
import shutil
import signal

import pytest
from conftest import HERE, LIGHT, QUIET, RESUME, Table, kill_and_resume, same_files, same_results

STATE = "carter_2d_partial_slip"
DISCS = {"Contact/Speed": 10, "Contact/Slip operator": "upwind 2", "Mesh/Elements across patch": 8, "Contact/Creepage x": 0.02,
         "Modes/Maximum frequency": 4000, "Wheel/Rayleigh mass": 300, "Rail/Rayleigh mass": 300, "Wheel/Rayleigh stiffness": 1e-5,
         "Rail/Rayleigh stiffness": 1e-5, "Contact/Friction law": "exponential", "Contact/Kinetic friction coefficient": 0.2,
         "Contact/Friction decay speed": 0.2, "Output/Body fields": "false", "Output/Plot": "false", **QUIET, "Time/Bodies": "reduced",
         "Time/Initial state": "steady", "Contact/Friction memory": 120e-6, "Time/Time step": 1.2e-5, "Time/End time": 0.4,
         "Time/Excite velocity": 0.05}
EXCITED = ("carter_2d_full_slip", DISCS, {"Analysis": "transient", "Time/Excite mode": 566})
CYCLE = (*EXCITED, {"Time/Stop when periodic": "true"})
SWEEP = ("carter_2d_full_slip", DISCS, {"Analysis": "limit cycle", "Limit cycle/Axis": "Stability/Added damping",
                                        "Limit cycle/Values": "0, 0.08, 0.11", "Limit cycle/Direction": "both"})
MAP = (HERE / "pair.prm", QUIET, {"Analysis": "stability map", "Output/Plot": "false",
                                  "Table/Axis 1": "Contact/Friction coefficient = 0.2, 0.41",
                                  "Table/Axis 2": "Contact/Creepage y = -0.02, 0, 0.02"})


def has_whole_rows(folder):
    for name in ("results.csv", "history.csv"):
        if (folder / name).exists():
            assert (folder / name).read_bytes().endswith(b"\n")
            Table(folder / name)


def killed_and_whole(program, scene, file, killed=has_whole_rows):
    """A run that was killed twice, if it lasts, and one in one go: they have the same files."""
    whole = program(*scene, output="whole")
    moments = [0.05 + whole.seconds * random.random() for _ in range(2)]
    run, _ = kill_and_resume(program, moments, *scene, output="killed", file=file, killed=killed)
    assert run.files() == whole.files()
    return run, whole


def test_a_killed_reduced_run(program):
    run, whole = killed_and_whole(program, CYCLE, "checkpoint.bin")
    same_files(run, whole, "history.csv", "cycle.csv", "cycle_patch.csv", "cycle-07.vtu")
    same_results(run, whole)


def test_a_killed_sweep(program):
    """Killed between a row and the state behind it, that row is taken again."""
    early = program.folder / "early_state"

    def keep(folder):
        if (folder / "limit_cycle_state.txt").exists():
            shutil.copy(folder / "limit_cycle_state.txt", early)
        has_whole_rows(folder)

    run, whole = killed_and_whole(program, SWEEP, "limit_cycle_state.txt", keep)
    same_files(run, whole, "results.csv")
    if not early.exists():  # no kill found one
        _, second, *_ = (whole / "limit_cycle_state.txt").read_text().splitlines()
        early.write_text(f"0 0\n{second}\n")
    shutil.copy(early, run / "limit_cycle_state.txt")
    same_files(program(*SWEEP, output="killed", options=RESUME), whole, "results.csv")


def test_a_killed_map(program):
    runs = killed_and_whole(program, MAP, "results.csv")
    for column in ("state", "n_unstable", "largest_growth_1/s", "fastest_Hz", "least_damping_ratio", "force_x_N"):
        values, wanted = (run.results[column] for run in runs)
        assert len(values) == len(wanted) == 6
        for a, b in zip(wanted, values):
            assert abs(a - b) <= 1e-6 * max(abs(a), 1e-3), column


@pytest.mark.parametrize("file, scene", [
    ("checkpoint.bin", (*EXCITED, {"Time/End time": 40})),
    ("results.csv", (*MAP, {"Table/Axis 2": "Contact/Creepage y = -0.02 : 0.02 : 401"})),
], ids=["a reduced run", "a map"])
def test_a_folder_in_which_a_run_is_going_on(program, file, scene):
    """Neither a new run nor a resumed one touches it; the first one goes on until it is stopped."""
    run = program.start(*scene, output="first")
    assert run.wait_until((run / file).exists)
    run.send(signal.SIGSTOP)
    assert run.process.poll() is None
    before = (run / "used.prm").stat().st_ino
    for other, options in ((scene, ()), (scene, RESUME), ((STATE,), ())):
        program(*other, output="first", options=options, code=1, says="another run is writing to it")
    assert (run / "used.prm").stat().st_ino == before
    run.send(signal.SIGTERM)
    run.send(signal.SIGCONT)
    done = run.end()
    assert (done.code, done.json["status"]) == (2, "interrupted")


def test_four_at_once(program):
    """Who comes too late is refused, and nothing is mixed."""
    alone = program(STATE, LIGHT, output="alone")
    runs = [run.end() for run in [program.start(STATE, LIGHT, output="at_once") for _ in range(4)]]
    assert all(run.code == 0 or "another run is writing to it" in run.messages for run in runs), runs
    assert any(run.code == 0 for run in runs) and runs[0].json["status"] == "done"
    same_results(alone, runs[0])
    assert alone.files() == runs[0].files()
