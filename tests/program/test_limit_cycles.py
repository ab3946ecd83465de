"""Runs that end when their motion repeats itself: the limit cycle they measure against their histories, by other means, resumed
ones, starts, cycles along an axis, and what is refused."""

import cmath
import math
import re
import signal

import pytest
from conftest import QUIET, RESUME, VALIDATE, charts, n_lines, same_files, same_results

SCENE = "carter_2d_full_slip"
# one vibration grows; friction that falls makes it stick and slip
DISCS = {"Contact/Speed": 10, "Contact/Slip operator": "upwind 2", "Mesh/Elements across patch": 8, "Contact/Creepage x": 0.02,
         "Modes/Maximum frequency": 4000, "Wheel/Rayleigh mass": 300, "Rail/Rayleigh mass": 300, "Wheel/Rayleigh stiffness": 1e-5,
         "Rail/Rayleigh stiffness": 1e-5, "Contact/Friction law": "exponential", "Contact/Kinetic friction coefficient": 0.2,
         "Contact/Friction decay speed": 0.2, "Output/Body fields": "false", **QUIET, "Time/Bodies": "reduced",
         "Time/Initial state": "steady", "Contact/Friction memory": 120e-6, "Time/Time step": 1.2e-5, "Time/End time": 0.4}
RUN = {**DISCS, "Analysis": "transient", "Time/Stop when periodic": "true"}
LOUD = {"Output/Verbosity": "normal"}
EXCITED = {**RUN, "Time/Excite mode": 566, "Time/Excite velocity": 0.05}
CYCLES = {"Analysis": "limit cycle", "Time/Excite velocity": 0.05}
AXIS = {"Limit cycle/Axis": "Stability/Added damping"}
SWEEP = {**DISCS, **CYCLES, **AXIS, "Limit cycle/Values": "0, 0.08, 0.11", "Limit cycle/Direction": "both", "Output/Plot": "true"}


@pytest.fixture(scope="module")
def cycle(shared):
    return shared(SCENE, EXCITED, LOUD, output="cycle")


@pytest.fixture(scope="module")
def sweep(shared):
    return shared(SCENE, SWEEP, LOUD, output="sweep")


def near(value, expected, relative, absolute=0.0):
    assert abs(value - expected) <= relative * abs(expected) + absolute


def mean(values):
    return sum(values) / len(values)


def crossings(times, values):
    """Times at which values rise through their mean, between the rows."""
    level = mean(values)
    return [t + (u - t) * (level - a) / (b - a) for t, u, a, b in zip(times, times[1:], values, values[1:]) if a <= level < b]


def at(times, values, time):
    """Linear between the rows."""
    k = min(max(i for i, t in enumerate(times) if t <= time + 1e-15), len(times) - 2)
    part = (time - times[k]) / (times[k + 1] - times[k])
    return values[k] + part * (values[k + 1] - values[k])


class Cycle:
    """What a run found of its cycle, and its history: all of it, and that of the last cycles."""

    def __init__(self, run):
        table = run.table("history.csv")
        self.found = {name[6:]: value for name, value in run.results.records()[-1].items() if name.startswith("cycle_")}
        self.history = {name: table[name] for name in table.columns}
        times = self.history["time_s"]
        self.period, self.step, self.end = 1 / self.found["frequency_Hz"], times[0], times[-1]
        self.n = min(16, int(len(times) / 4 / (self.period / self.step)))
        first = next(i for i, t in enumerate(times) if t > self.end - self.n * self.period - 1e-12)
        self.last = {name: values[first:] for name, values in self.history.items()}
        self.times, self.v = self.last["time_s"], self.last["velocity_x_m/s"]

    def change(self, name):
        """In one cycle."""
        values = self.history[name]
        return (values[-1] - at(self.history["time_s"], values, self.end - self.n * self.period)) / self.n


@pytest.fixture(scope="module")
def measured(cycle):
    return Cycle(cycle)


def test_it_stops_when_it_is_periodic(cycle):
    assert cycle.results.texts("cycle")[-1] == "periodic"
    assert 0.02 <= cycle.table("history.csv").last("time_s") <= 0.39
    assert cycle.has("cycle.csv", "cycle.svg", "cycle_patch.csv", "cycle_patch.svg", "cycle.pvd", "cycle-24.vtu")
    assert not (cycle / "cycle-25.vtu").exists(), "24 phases"
    charts("patch", cycle.folder)
    charts("spectrum", cycle.folder)


def test_measures_of_the_cycle(cycle, measured):
    found, last, v = measured.found, measured.last, measured.v
    rises = crossings(measured.times, v)
    once = sum(b - a > 0.5 * measured.period for a, b in zip(rises, rises[1:]))
    near(once / (rises[-1] - rises[0]), found["frequency_Hz"], 1e-3)
    near((max(v) - min(v)) / 2, found["velocity_x_amplitude_m/s"], 1e-6)
    near(math.sqrt(mean([(x - mean(v)) ** 2 for x in v])), found["velocity_x_rms_m/s"], 3e-3)
    for name in ("normal_force", "force_x"):
        near(min(last[f"{name}_N"]), found[f"{name}_least_N"], 1e-6)
        near(max(last[f"{name}_N"]), found[f"{name}_most_N"], 1e-6)
    stick = [s > 0 for s in last["nodes_sticking"]]
    near(mean(stick), found["stick_time_share"], 0, 1e-3)
    near(mean([s / c for s, c in zip(last["nodes_sticking"], last["nodes_in_contact"]) if c > 0]), found["stick_node_share"], 0, 1e-3)
    errors = [error for error in cycle.json["errors"] if error["quantity"] == "amplitude of the cycle"]
    assert len(errors) == 1
    error = errors[0]["value"]
    near(error, 2 * sum(stick) / sum(last["nodes_sticking"]), 1e-3)
    # power is as the square of the amplitude
    said = re.search(r"these limit it; so power (\S+) of itself, levels (\S+) dB", cycle.screen)
    near(float(said[1]), (1 + error) ** 2 - 1, 0.06)
    near(float(said[2]), 20 * math.log10(1 + error), 0.06)
    near(mean([not f > 0 for f in last["normal_force_N"]]), found["open_time_share"], 0, 1e-3)


def test_work_of_the_cycle(measured):
    """Heat again by traction times the sliding of the patch as a whole; with no load that changes the drive is that of the creepage,
    T V per time."""
    found, last = measured.found, measured.last
    heat, drive = measured.change("friction_J"), measured.change("supplied_J")
    near(found["heat_J"], heat, 1e-6)
    near(found["drive_J"], drive, 1e-6)
    near(found["damping_J"], measured.change("damping_J"), 1e-6)
    left = found["drive_J"] - found["heat_J"] - found["damping_J"] - found["numerical_J"] - found["stored_J"]
    near(left, 0, 0, 1e-4 * found["damping_J"])
    near(found["vibration_J"], found["damping_J"], 0.02)
    sliding = [10 * c + x for c, x in zip(last["creepage_x"], measured.v)]
    near(mean([abs(f * s) for f, s in zip(last["force_x_N"], sliding)]) * measured.period, heat, 0.05)
    near(abs(mean([f * 10 * c for f, c in zip(last["force_x_N"], last["creepage_x"])]) * measured.period), drive, 5e-3)


def test_harmonics_of_the_cycle(cycle, measured):
    harmonics, times = cycle.table("cycle.csv"), measured.times
    near(harmonics["normal_force_N"][0], mean(measured.last["normal_force_N"]), 1e-4)
    for k in (1, 2, 3):
        for name in ("velocity_x_m/s", "force_x_N"):
            total = sum(x * cmath.exp(-2j * math.pi * k * (t - measured.end) / measured.period) for t, x in zip(times, measured.last[name]))
            near(2 * abs(total) / len(times), harmonics[name][k], 0.02, 0.01 * harmonics[name][1])
        near(harmonics["frequency_Hz"][k], k / measured.period, 1e-6)


def test_record_of_the_patch(cycle, measured):
    patch = cycle.table("cycle_patch.csv")
    near(max(patch["phase"]), 1, 0, 0.02)
    near(max(patch["time_s"]), measured.period, 0.02)
    sticks = {t for t, s in zip(patch["time_s"], patch["state"]) if s == 2}
    near(len(sticks) / len(set(patch["time_s"])), measured.found["stick_time_share"], 0, 0.03)


def test_the_screen_tells_the_cycle(cycle, measured):
    """To the digits that it has."""
    x = r"(-?[\d.]+(?:e[+-]?\d+)?)"
    said = re.search(
        rf"along x {x} m/s \(amplitude\), {x} m/s \(rms\); N {x} to {x} N, T_x {x} to {x} N; nodes stick {x} % of the time, "
        rf"{x} % of those that touch; no contact {x} % of the time work in a cycle: drive {x} J, heat {x} J, "
        rf"to the vibration {x} J, of which damping {x} J and the scheme {x} J", cycle.screen)
    assert said, cycle
    names = ["velocity_x_amplitude_m/s", "velocity_x_rms_m/s", "normal_force_least_N", "normal_force_most_N", "force_x_least_N",
             "force_x_most_N", "stick_time_share", "stick_node_share", "open_time_share", "drive_J", "heat_J", "vibration_J", "damping_J",
             "numerical_J"]
    for name, text in zip(names, said.groups()):
        near(float(text), (100 if name.endswith("_share") else 1) * measured.found[name], 0.05)
    assert measured.found["stick_time_share"] > 1.5 * measured.found["stick_node_share"], "the shares can be told apart"


def test_portrait_of_the_cycle(cycle, measured):
    """The velocity is the rate of the displacement in um; T in kN is over the sliding velocity."""
    blocks = [text.strip("\n").split("\n") for text in cycle.text("cycle.dat").split("\n\n\n")[:2]]
    portrait, loop = ([tuple(map(float, line.split())) for line in lines if line and line[0] not in "#N"] for lines in blocks)
    names = [line for line in blocks[0] if line.startswith("#")]
    assert "displacement (\u00b5m)" in names[-1] and "velocity (m/s)" in names[-1]
    last = {name: values[-len(portrait):] for name, values in measured.history.items()}
    level, step = mean(last["velocity_x_m/s"]), measured.step
    for (x, v), (y, w) in zip(portrait, portrait[1:]):
        near((y - x) * 1e-6 / step, (v + w) / 2 - level, 0, 5e-3)
    near(len(portrait) * step, measured.period, 0, 2.1 * step)
    for (sliding, force), (_, v), c, t in zip(loop, portrait, last["creepage_x"], last["force_x_N"]):
        near(sliding, v + 10 * c, 1e-6, 1e-6)
        near(1e3 * force, t, 1e-6)


def test_a_part_of_it_and_the_rest(program, cycle):
    """And all of it again."""
    program(SCENE, EXCITED, {"Time/End time": 0.03}, output="part")
    rest = program(SCENE, EXCITED, output="part", options=RESUME)
    same_files(rest, cycle, "history.csv", "cycle.csv", "cycle_patch.csv")
    same_results(rest, cycle)
    same_files(program(SCENE, EXCITED, output="part", options=RESUME), cycle, "history.csv")


def test_full_bodies_begun_in_another_way_come_to_the_same_cycle(program, cycle):
    full = program(SCENE, RUN, {"Time/Bodies": "full", "Contact/Friction response": "patch mean",
                                "Time/Creepage x": "0.02*(1+0.2*exp(-((t-1e-3)/2e-4)^2))", "Output/Plot": "false"}).results
    assert full.texts("cycle")[-1] == "periodic"
    for column in ("frequency_Hz", "velocity_x_amplitude_m/s", "vibration_J", "heat_J"):
        assert 0.99 <= full.last(f"cycle_{column}") / cycle.results.last(f"cycle_{column}") <= 1.01, column


def test_what_has_not_come_to_its_end(program):
    run = program(SCENE, EXCITED, LOUD, {"Time/End time": 0.0121, "Time/Excite velocity": 1e-4},
                  says="The motion is not known to be a limit cycle")
    assert run.results.texts("cycle")[-1] == "changing"
    assert not (run / "cycle.csv").exists()


def test_what_dies_away(program):
    run = program(SCENE, RUN, {"Contact/Friction response": "constant", "Contact/Normal load": 1.4e5, "Contact/Approach": "",
                               "Time/Normal load": "1.4e5*(1+0.01*exp(-((t-1e-3)/2e-4)^2))"})
    assert run.results.texts("cycle")[-1] == "decayed"
    assert 0.01 <= run.table("history.csv").last("time_s") <= 0.39


def test_a_sweep_along_the_damping(cycle, sweep):
    """Up to where nothing grows and back: hysteresis. At 0.08 the steady state is stable, but so is the cycle."""
    assert "hysteresis: up and down end in different motions at 0.08" in sweep.screen
    assert sweep.has("limit_cycles.svg")
    charts("sweep", sweep.folder)
    rows, run = sweep.results.records(), cycle.results.records()[-1]
    assert [row["Stability/Added damping"] for row in rows] == [0, 0.08, 0.11, 0.08, 0]
    assert [row["direction"] for row in rows] == ["up"] * 3 + ["down"] * 2
    for name in ("cycle_frequency_Hz", "cycle_velocity_x_amplitude_m/s"):
        near(rows[0][name], run[name], 5e-3)  # the same start as the run by itself
    for row in rows:
        near(row["start_Hz"], run["excited_frequency_Hz"], 1e-3)  # the vibration that grows without more damping
    growths = [row["largest_growth_1/s"] for row in rows]
    assert growths[0] > 0 > growths[1] > growths[2]
    assert [row["cycle"] for row in rows] == ["periodic", "periodic", "decayed", "decayed", "periodic"]
    assert rows[2]["steps"] != 0 and rows[3]["steps"] == 0, "the cycle is to die away at 0.11, and nothing begins at 0.08"
    near(rows[0]["cycle_velocity_x_amplitude_m/s"], rows[4]["cycle_velocity_x_amplitude_m/s"], 0.01)
    for row in (rows[0], rows[1], rows[4]):
        near(row["cycle_vibration_J"], row["cycle_damping_J"], 0.02)  # damping takes what the vibration gets


def test_a_run_of_a_sweep_that_cannot_go_on_to_its_end(program):
    run = program(SCENE, DISCS, CYCLES, {"Time/Approach": "0.22e-3*(1+30*t)"}, code=2, says="Run 0 ended early")
    assert run.results.texts("cycle")[-1] == "not converged"


def test_a_sweep_that_is_killed_behind_its_first_row(program, sweep):
    """And all of it again; not without its state."""
    run = program.start(SCENE, SWEEP, output="killed")
    run.wait_for_rows(1, seconds=60)
    run.send(signal.SIGKILL)
    run.end()
    assert 1 <= n_lines(run / "results.csv") - 1 <= 4
    rest = program(SCENE, SWEEP, output="killed", options=RESUME)
    same_files(rest, sweep, "results.csv")
    state = rest / "limit_cycle_state.txt"
    state.write_bytes(state.read_bytes()[:30])
    program(SCENE, SWEEP, output="killed", options=RESUME, code=1, says="missing or damaged")


@pytest.mark.parametrize("settings, says", [
    ({"Time/End time": 1e-3}, "in the last quarter of at least 1000"),
    ({"Time/Periodic after": 0.5}, "leave less of it out"),
    ({"Time/Inertia": "false", "Time/Bodies": "full"}, "has no vibration"),
    ({**CYCLES, **AXIS}, "Values = : one needs the other"),
    ({**CYCLES, **AXIS, "Limit cycle/Values": "0.1, 0.1"}, "a value is there twice"),
    ({**CYCLES, "Limit cycle/Axis": "Contact/Friction coefficient", "Limit cycle/Values": "0, 0.1"},
     "is above 0 where cycles are looked for"),
    ({**CYCLES, "Limit cycle/Starts": "loud"}, "Limit cycle/Starts"),
    ({"Analysis": "limit cycle", "Time/Bodies": "full"}, "take Time/Bodies = reduced"),
    ({"Analysis": "limit cycle"}, "it is what each start begins with"),
    ({**CYCLES, "Time/Excite mode": 500}, "the starts are those of Limit cycle/Starts"),
])
def test_refused(program, settings, says):
    program.refuses(SCENE, says, RUN, settings, options=VALIDATE)
