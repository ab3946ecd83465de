"""What a machine may do to a run: a screen that goes away, signals while the
bodies are set up, a kill, a full disk, too little memory."""

import re
import shutil
import signal
import subprocess
import time

import pytest
from conftest import COARSE, COARSER, HERE, LIGHT, RESUME, limited, n_lines, same_run

VIBRATION, ON_RAIL, DISCS = "oscillating_creepage_2d", "wheel_on_rail_3d", "carter_2d_partial_slip"
LONG = {**LIGHT, "Time/Field interval": 1000}
OFTEN = {"Time/Checkpoint interval": 10, "Output/Plot": "false"}
ONE_LINE = ("bash", "-c", '"$@" | head -n 1; exit "${PIPESTATUS[0]}"', "piped")


def ends(steps):
    """The setting for so many steps."""
    return {"Time/End time": f"{steps * 2e-6:.9g}"}


def test_a_screen_that_goes_away(program):
    run = program(VIBRATION, COARSER, output="piped", before=ONE_LINE)
    assert run.json["status"] == "done"
    assert (run / "results.csv").stat().st_size and (run / "history.svg").stat().st_size
    program(None, options=["--print-parameters"], before=ONE_LINE)


def test_sigterm_twice_while_the_bodies_are_factorised(program):
    run = program.start(ON_RAIL)
    run.wait_until((run / "used.prm").exists, 10)
    run.send(signal.SIGTERM)
    time.sleep(0.2)
    run.send(signal.SIGTERM)
    done = run.end()
    assert (done.code, done.json["status"]) == (2, "interrupted")


def test_a_kill_loses_a_second_or_two(program):
    """Rows can be read while the run goes on."""
    run = program.start(VIBRATION, LONG, {"Time/End time": 1}, output="killed")
    assert run.wait_until((run / "checkpoint.bin").exists, 10)
    assert not (run / "history.csv").exists()
    rows = n_lines(run / "history.csv.part")
    time.sleep(1)
    assert n_lines(run / "history.csv.part") > rows
    run.send(signal.SIGKILL)
    run.end()
    steps = n_lines(run / "history.csv.part")
    program(VIBRATION, LONG, ends(steps + 100), output="killed", options=RESUME)
    assert n_lines(run / "history.csv") > steps


def stops_where_there_is_no_room(program, reason, output, before=()):
    """The file and the reason are told, and whole rows stay; the number of steps."""
    run = program(VIBRATION, LONG, OFTEN, {"Time/End time": 10e-3}, output=output, before=before, code=1)
    assert re.search(f'Cannot write "{output}/(history.csv|history.bin|checkpoint.bin)": {reason}', run.messages), run
    assert run.json["status"] == "failed" and re.match(f"Cannot write .*{reason}", run.json["failure"])
    assert not (run / "history.csv.part").exists()
    assert (run / "history.csv").read_bytes().endswith(b"\n")
    steps = int(run.table("history.csv").last("step"))
    assert steps >= 20
    return steps


def goes_on_with_room(program, steps, output):
    resumed = program(VIBRATION, LONG, OFTEN, ends(steps + 20), output=output, options=RESUME)
    whole = program(VIBRATION, LONG, {"Output/Plot": "false"}, ends(steps + 20), output="whole")
    same_run(resumed, whole)


def test_files_that_are_too_large(program):
    steps = stops_where_there_is_no_room(program, "File too large", "large", limited("ulimit -f 280"))
    goes_on_with_room(program, steps, "large")


def test_a_full_disk(program):
    disk = program.folder / "disk"
    disk.mkdir()
    if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=800k", "none", disk], check=False, capture_output=True).returncode:
        pytest.skip("no permission to mount a small disk: only a limit of the file size is tried")
    try:
        steps = stops_where_there_is_no_room(program, "No space left on device", "disk/run")
        shutil.copytree(disk / "run", program.folder / "roomy")
    finally:
        program.stop()
        subprocess.run(["umount", disk], check=True)
    goes_on_with_room(program, steps, "roomy")


@pytest.mark.parametrize("scene, says, settings", [
    (ON_RAIL, "would have .* cells or more", {"Mesh/Elements across patch": 30, "Mesh/Growth": 0.05}),
    ("squeal_stability", "The meshes of wheel and rail would have .* cells or more",  # each fits alone
     {"Mesh/Elements across patch": 12, "Mesh/Growth": 0.6}),
    (ON_RAIL, "for their compliance", {"Mesh/Elements across patch": 70, "Mesh/Growth": 1}),
    (ON_RAIL, "for their compliance", {"Mesh/Elements across patch": 700, "Mesh/Compliance": "split", "Output/Body fields": "false"}),
])
def test_what_is_too_large_is_counted_not_built(program, scene, says, settings):
    run = program(scene, settings, code=1, before=limited("ulimit -v 8000000"), seconds=20)
    assert re.search(says, run.messages), run
    assert run.json["cpu_seconds"] <= 3


def test_loads_for_which_rounding_would_decide_on_the_nodes(program):
    block = {**COARSE, "Rail/Shape": "block", "Rail/Radius": 0, "Contact/Approach": ""}
    run = program(DISCS, block, {"Contact/Normal load": 1e-7}, code=1, says="too small beside bodies of")
    least = re.search("at least.*load = (.*) N", run.messages)[1]
    program(DISCS, block, {"Contact/Normal load": least})
    program(DISCS, COARSE, {"Contact/Approach": 1e-16}, code=1, says="at least Contact/Approach = ")
    program("combined_3d", COARSE, {"Contact/Normal load": 1e-8, "Contact/Approach": "", "Body solver": "distributed"}, code=1,
            says="p4est halves them 18 times")


def test_less_memory_than_the_factor_needs(program):
    """OpenBLAS must not wait for it."""
    run = program(ON_RAIL, {"Mesh/Growth": 0.25}, code=1, before=limited("ulimit -v 1331200"), seconds=60)
    assert re.search("more than 70 % of the|There is not enough memory", run.messages), run
    assert run.json["status"] == "failed"


def test_less_memory_than_both_true_sections_need(program):
    """Each would fit; both are added up before either is meshed."""
    run = program("profiles_true_sections", {"Mesh/Elements across patch": 40}, code=1, before=limited("ulimit -v 3000000"), seconds=60)
    assert re.search("The meshes of wheel and rail would have .* more than 70 % of the", run.messages), run


def test_less_memory_than_modes_need(program):
    """MPI would end the process."""
    run = program(HERE / "pair.prm", {"Analysis": "modes", "Output/Plot": "false"}, code=1, before=limited("ulimit -v 800000"), seconds=60)
    assert re.search(r"of address space, of which .* are left: raise the limit \(ulimit -v\)", run.messages), run
    assert run.json["status"] == "failed" and not (run / "modes.csv").exists()


def test_no_room_for_the_last_file_of_a_table(program):
    """What was computed stays, and no half file."""
    run = program(DISCS, LIGHT, {"Analysis": "table", "Output/Plot": "false", "Table/Axis 1": "Contact/Creepage x = 0, 0.001, 0.002"},
                  output="table", before=limited("ulimit -f 20"), code=1, says='Cannot write "table/table.h5": File too large')
    assert run.json["status"] == "failed"
    assert len(run.results) == 3
    assert not [name for name in run.files() if "table.h5" in name or name.endswith(".part")]
