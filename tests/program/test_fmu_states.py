"""FMUs whose states the program solves: against states that the program solves by itself, against the equilibrium in a curve, to the bit
after what was saved, and when there is no state, no program, or no process any more."""

import contextlib
import math
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess

import numpy
import pytest
from test_fmu import FUNCTIONS, OF_STATES, SCENE, SIX, refused, tool

from fmu import DISCARD, Fmu, Refused

STATES = {**SIX, "FMU/Kind": "states"}
SIDES = ("right", "left")


@pytest.fixture(scope="module")
def run(shared):
    return shared(SCENE, STATES)


@pytest.fixture(scope="module")
def fmu(run):
    with Fmu(run / OF_STATES[1]) as made:
        yield made


@contextlib.contextmanager
def ready(fmu, **texts):
    """An instance between steps."""
    one = fmu.instantiate()
    if texts:
        one.set_text(**texts)
    one.initialise()
    try:
        yield one
    finally:
        one.free()


def outputs(one):
    names = [v.name for v in one.fmu.variables if v.causality == "output" and v.type == "Real"]
    return dict(zip(names, one.get(*names)))


def places(source, shift=2.5e-3):
    """Inputs of a wheelset on the tread, with rails that have moved."""
    return {"lateral_shift": source.uniform(-shift, shift), "yaw": source.uniform(-5e-4, 5e-4), "lateral_velocity": source.uniform(-0.03, 0.03),
            "yaw_rate": source.uniform(-1e-3, 1e-3), "axle_speed": -20 / 0.46 * (1 + source.uniform(-2e-3, 2e-3)), "curvature": source.uniform(-1e-3, 1e-3),
            "friction": source.uniform(0.2, 0.4), "right.load": source.uniform(50e3, 70e3), "left.load": source.uniform(50e3, 70e3),
            "left.rail_y": source.uniform(-2e-4, 2e-4)}


def children():
    """Processes of this one that solve states."""
    listed = pathlib.Path(f"/proc/self/task/{os.getpid()}/children").read_text(encoding="utf-8").split()
    return [int(pid) for pid in listed if b"--states" in pathlib.Path(f"/proc/{pid}/cmdline").read_bytes().split(b"\0")]


def test_what_is_written_and_packed(run, tmp_path):
    """No table is computed; the binary is that of all FMUs and knows no deal.II; the licence of the program is told."""
    assert run.has(*OF_STATES) and not {"results.csv", "wheelset_fmi2.fmu"} & set(run.files())
    folders = [tmp_path / version for version in "23"]
    for folder, name in zip(folders, OF_STATES):
        tool("unzip", "-q", run / name, "-d", folder)
        tool("xmllint", "--noout", folder / "modelDescription.xml")
        assert 'needsExecutionTool="true"' in (folder / "modelDescription.xml").read_text(encoding="utf-8")
    assert sorted(path.name for path in (folders[0] / "resources").iterdir()) == ["scene.prm", "token.txt", "wheelset.values"]
    binary = folders[1] / "binaries/x86_64-linux/rolling_contact_wheelset.so"
    for line in tool("ldd", binary).splitlines():
        assert re.search(r"linux-vdso|libstdc\+\+|libgcc_s|libm\.|libc\.|ld-linux", line)
    shown = [line.split()[2] for line in tool("nm", "-D", "--defined-only", binary).splitlines()]
    assert len(shown) == sum(len(names.split()) for names in FUNCTIONS.values())
    page = (folders[0] / "documentation/index.html").read_text(encoding="utf-8")
    assert "CHOLMOD" in page and "GNU General Public License" in page and "ROLLING_CONTACT_PROGRAM" in page


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_states_of_the_program(program, fmu, seed):
    """An FMU that begins with a place has the forces of a run of that place alone."""
    inputs = {**places(random.Random(seed)), "right.rail_z": 1e-4 * seed}
    with ready(fmu) as one:
        one.set(inputs)
        one.step(1e-3)
        found = outputs(one)
        assert one.get("right.inside_table", "left.inside_table") == [True, True]
    for side in SIDES:
        turn = inputs["curvature"] + inputs["yaw_rate"] / 20
        state = program(SCENE, SIX, {
            "Analysis": "quasi-static", "Profiles/Side": side, "Profiles/Lateral shift": inputs["lateral_shift"] - inputs.get(f"{side}.rail_y", 0.0), "Profiles/Yaw": inputs["yaw"],
            "Profiles/Roll": found["roll"],
            "Profiles/Curve radius": 1 / turn, "Profiles/Pitch rate": inputs["axle_speed"], "Profiles/Lateral velocity": inputs["lateral_velocity"],
            "Contact/Vertical load": inputs[f"{side}.load"], "Contact/Friction coefficient": inputs["friction"]}, output=side).results.record()
        carried = inputs["friction"] * state["normal_force_N"]
        force = [found[f"{side}.force_{axis}"] for axis in "xyz"]
        expected = [state["force_track_x_N"], state["force_track_y_N"], -state["force_track_z_N"]]
        assert math.dist(force, expected) < 1e-6 * carried, side
        for name, column, tolerance in (("t_gamma", "creep_work_J/m", 1e-5), ("max_pressure", "max_pressure_Pa", 1e-5), ("normal_force", "normal_force_N", 1e-8),
                                        ("contact_angle", "pressure_angle_rad", 1e-5)):
            assert abs(found[f"{side}.{name}"] / state[column] - 1) < tolerance, (side, name)
        assert abs(found[f"{side}.contact_y"] - inputs.get(f"{side}.rail_y", 0.0) - state["pressure_y_track_m"]) < 1e-7
        bound = state["bound_force/muN"] * carried
        assert abs(found[f"{side}.force_bound"] / bound - 1) < 1e-3


def test_against_a_table(program):
    """Forces of both kinds of FMUs agree within the bound of the table."""
    slips = "-0.02, -0.008, -0.003, 0, 0.003, 0.008, 0.02"
    run = program(SCENE, SIX, {"FMU/Kind": "both", "FMU/Lateral shift": "-0.0006, 0, 0.0006", "FMU/Yaw": 0, "FMU/Curvature": 0, "FMU/Load": 60e3,
                               "FMU/Slip along": slips, "FMU/Slip across": slips, "FMU/Points": 20})
    source = random.Random(8)
    n_within = n = 0
    with Fmu(run / "wheelset_fmi3.fmu") as table, Fmu(run / OF_STATES[1]) as states, ready(table) as light, ready(states) as full:
        for _ in range(12):
            inputs = {"lateral_shift": source.uniform(-4e-4, 4e-4), "lateral_velocity": source.uniform(-0.03, 0.03),
                      "axle_speed": -20 / 0.46 * (1 + source.uniform(-1e-3, 1e-3))}
            for one in (light, full):
                one.set(inputs)
                one.step(1e-3)
            told, found = outputs(light), outputs(full)
            for side in SIDES:
                if not light.get(f"{side}.inside_table"):
                    continue
                error = math.dist(*([all_of[f"{side}.force_{axis}"] for axis in "xyz"] for all_of in (told, found)))
                n += 1
                n_within += error <= told[f"{side}.force_bound"]
                assert found[f"{side}.force_bound"] < told[f"{side}.force_bound"]
    assert n >= 12 and n_within >= 0.9 * n


def test_repeated_steps(fmu):
    """From a state that was saved, the same step has the same numbers to the bit, on bodies that are kept or made again, here and in another
    process; to look at outputs changes nothing."""
    source = random.Random(6)
    far = {"lateral_shift": -5.5e-3}
    with ready(fmu) as one, ready(fmu) as other:
        for _ in range(3):
            one.set(places(source))
            one.step(1e-3)
        saved = one.save()
        data = one.serialise(saved)
        steps = [places(source), {**places(source), **far}, places(source)]
        expected = []
        for inputs in steps:
            one.set(inputs)
            one.step(1e-3)
            expected.append(outputs(one))
        for _ in range(6):  # other bodies take the places of those that are kept
            one.set(places(source, 6e-3))
            one.step(1e-3)
        one.restore(saved)
        again = []
        for inputs in steps:
            one.set(places(source))
            outputs(one)
            one.set(inputs)
            one.step(1e-3)
            again.append(outputs(one))
        assert again == expected
        other.restore(other.deserialise(data, saved[1]))
        fresh = []
        for inputs in steps:
            other.set(inputs)
            other.step(1e-3)
            fresh.append(outputs(other))
        assert fresh == expected


def test_the_start_matters_less_than_the_bound(fmu):
    """A state that begins with another one, or with none, is the same within its bound."""
    source = random.Random(11)
    with ready(fmu) as one:
        for _ in range(8):
            inputs = places(source)
            one.set(inputs)
            one.step(1e-3)
            warm = outputs(one)
            one.reset()
            one.initialise(**inputs)
            cold = outputs(one)
            for side in SIDES:
                error = math.dist(*([all_of[f"{side}.force_{axis}"] for axis in "xyz"] for all_of in (warm, cold)))
                assert error <= warm[f"{side}.force_bound"]


@pytest.mark.parametrize("name", OF_STATES)
def test_no_state(run, name):
    """A step to where there is none is discarded with the program's message; others go on from where it was."""
    with Fmu(run / name) as made, ready(made) as one:
        one.step(1e-3)
        before = outputs(one)
        for bad, says in (({"lateral_shift": 0.5}, "wheel"), ({"yaw": 1.5}, "wheel")):
            good = {key: one.get(key) for key in bad}
            one.set(bad)
            with pytest.raises(Refused) as refusal:
                one.step(1e-3)
            assert refusal.value.status == DISCARD and says in str(refusal.value), refusal.value
            assert one.get("time") == 1e-3
            refused(lambda: one.get("right.force_y"), says)
            one.set(good)
            assert outputs(one) != {} and math.isclose(outputs(one)["right.force_y"], before["right.force_y"], rel_tol=1e-6)
        one.step(1e-3)
        assert one.get("time") == 2e-3


def test_a_state_that_does_not_converge(program):
    """Its step is discarded, and says how far it came."""
    run = program(SCENE, STATES, {"Contact/Solver": "fixed point", "Contact/Maximal iterations": 5})
    with Fmu(run / OF_STATES[0]) as made, ready(made) as one, pytest.raises(Refused) as refusal:
        one.step(1e-3)
    assert refusal.value.status == DISCARD and "residual" in str(refusal.value), refusal.value


def test_wheels_without_load_and_slow_ones(fmu):
    with ready(fmu) as one:
        one.set({"left.load": 0.0})
        found = outputs(one)
        assert found["left.force_z"] == 0 and found["left.force_bound"] == 0
        assert abs(found["right.force_z"] + found["right.normal_force"]) < 1e3 and one.get("right.inside_table")
        one.set({"right.load": 0.0, "lateral_shift": 1e-3})
        roll = outputs(one)["roll"]
        assert roll != 0
        one.set({"right.rail_z": 1e-4})
        assert abs((outputs(one)["roll"] - roll) * 2 * one.get("tape_circle") / 1e-4 - 1) < 1e-9
        one.set({"right.rail_z": 0.0})
        one.set({"left.load": 60e3, "speed": 0.05, "axle_speed": -0.1 / 0.46})
        assert not one.get("left.inside_table") and outputs(one)["left.force_bound"] > 1e300


def test_a_process_that_is_killed(fmu):
    """It is told; the next step begins another one, with the same numbers."""
    with ready(fmu) as one:
        one.step(1e-3)
        saved = one.save()
        one.set(lateral_shift=1e-3)
        one.step(1e-3)
        expected = outputs(one)
        assert len(children()) == 1
        one.restore(saved)
        os.kill(children()[0], signal.SIGKILL)
        one.set(lateral_shift=1e-3)
        with pytest.raises(Refused) as refusal:
            one.step(1e-3)
        assert "ended by the signal 9" in str(refusal.value) and refusal.value.status == 3
        one.step(1e-3)
        assert outputs(one) == expected
    assert not children(), "no process is left behind"


def test_which_program(program, run, tmp_path, monkeypatch):
    """The parameter, the environment, the program that wrote the unit, PATH."""
    own = str(program.path)
    with Fmu(run / OF_STATES[0]) as made:
        assert made.by_name["program"].start == own
        monkeypatch.setenv("ROLLING_CONTACT_PROGRAM", "/nowhere/program")
        one = made.instantiate()
        refused(one.initialise, "/nowhere/program", "ROLLING_CONTACT_PROGRAM")
        one.set_text(program="/bin/false")
        refused(lambda: one.call("ExitInitializationMode"), "/bin/false", "exit code 1")
        one.set_text(program=own)
        one.call("ExitInitializationMode")
        assert one.get("program") == own.encode()
        refused(lambda: one.set_text(program=own), "fixed")
        refused(lambda: one.set_text(model="x"), "not set from outside")
        one.free()
        monkeypatch.delenv("ROLLING_CONTACT_PROGRAM")
        # of a machine where it is elsewhere
        values = made.folder / "resources/wheelset.values"
        values.write_bytes(values.read_bytes().replace(own.encode(), b"x" * len(own)))
        monkeypatch.setenv("PATH", f"relative:{tmp_path}")
        one = made.instantiate()
        refused(one.initialise, "is not installed", "PATH", "parameter program")
        (tmp_path / "rolling-contact").symlink_to(own)
        one.call("ExitInitializationMode")
        one.free()


def test_a_scene_that_is_refused(fmu):
    """The program's own message comes through."""
    scene = fmu.folder / "resources/scene.prm"
    text = scene.read_text(encoding="utf-8")
    try:
        scene.write_text(re.sub("set Friction coefficient *= 0.3", "set Friction coefficient = -1", text), encoding="utf-8")
        one = fmu.instantiate()
        refused(one.initialise, "Contact/Friction coefficient", "exit code 1")
        one.free()
    finally:
        scene.write_text(text, encoding="utf-8")


def test_profiles_from_files(program):
    """They are in the unit."""
    shutil.copy(program.prm / "profiles/worn_wheel.txt", program.folder / "own wheel.txt")
    scene = program.write("own.prm", (program.prm / f"{SCENE}.prm").read_text(encoding="utf-8").replace("= S1002", "= own wheel.txt"))
    run = program(str(scene), STATES)
    for name in ("own wheel.txt", "own.prm"):
        (program.folder / name).unlink()
    with Fmu(run / OF_STATES[1]) as made, ready(made) as one:
        assert outputs(one)["right.force_z"] < -5e4


def test_by_hand(program):
    """Nobody starts it so but an FMU."""
    program(SCENE, STATES, options=("--states",), code=1, says="standard input is not a socket")
    program("carter_2d_partial_slip", options=("--states",), code=1, says="Analysis = fmu")


def test_an_importer_that_is_gone(run, program):
    """The process ends by itself."""
    script = program.write("gone.py", f"import os, sys\nsys.path.insert(0, {str(pathlib.Path(Fmu.__init__.__code__.co_filename).parent)!r})\nfrom fmu import Fmu\n"
                           f"one = Fmu({str(run / OF_STATES[1])!r}).instantiate()\none.initialise()\none.get('right.force_y')\n"
                           "print(open(f'/proc/self/task/{os.getpid()}/children').read().split()[0], flush=True)\nos._exit(0)\n")
    pid = subprocess.run(["/usr/bin/python3", "-B", script], capture_output=True, text=True, check=True).stdout.strip()
    for _ in range(100):
        if not pathlib.Path(f"/proc/{pid}").exists() or ") Z" in pathlib.Path(f"/proc/{pid}/stat").read_text(encoding="utf-8"):
            return
        subprocess.run(["sleep", "0.1"], check=True)
    pytest.fail(f"process {pid} is still there")


def test_a_wheelset_in_a_curve_is_in_equilibrium(program, fmu):
    """Where the forces of the unit balance, Analysis = wheelset has its equilibrium."""
    expected = program("wheelset_curve", SIX, {"Wheelset/Curve radius": 1500, "Wheelset/Search for others": "false"}).table("wheelset.csv").records()[0]
    place = numpy.array([expected["lateral_shift_m"], expected["yaw_rad"], expected["pitch_rate_rad/s"]])
    names, steps = ("lateral_shift", "yaw", "axle_speed"), (2e-5, 2e-6, 1e-3)
    with ready(fmu) as one:
        one.set(curvature=1 / expected["curve_radius_m"])

        def balance(at):
            one.set(dict(zip(names, at)))
            one.step(1e-3)
            force, turn, torque = (one.get(f"right.{k}") + one.get(f"left.{k}") for k in ("force_y", "moment_z", "moment_y"))
            return numpy.array([force, turn + 10e6 * (-0.9 / 1500 - at[1]), torque])

        slopes = numpy.array([(balance(place + change) - balance(place - change)) / (2 * size)
                              for size, change in zip(steps, numpy.diag(steps))]).T
        found = place
        for _ in range(8):
            left_over = balance(found)
            found = found - numpy.linalg.solve(slopes, left_over)
        forces = outputs(one)
    assert all(abs(left_over) < 5), left_over
    bound = sum(forces[f"{side}.force_bound"] for side in SIDES)
    bounds = numpy.abs(numpy.linalg.inv(slopes)) @ (bound * numpy.array([1, 0.75, 0.46]))
    assert (abs(found - place) <= bounds).all(), (found - place, bounds)
    assert abs(found[0] - place[0]) < 1e-4
