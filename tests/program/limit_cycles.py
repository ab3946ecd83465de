"""Limit cycles against their histories.

cycle FOLDER: frequency, amplitudes, forces, shares and energies in results.csv, harmonics in cycle.csv
the summary, the curves of cycle.svg and the record of the patch, from history.csv by other means.
sweep FOLDER CYCLE: rows of Analysis = limit cycle up and down; the first is the run in CYCLE."""
import cmath
import csv
import json
import math
import re
import sys

failures = []


def read(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def columns(path):
    rows = read(path)
    return {name: [float(row[name]) for row in rows] for name in rows[0]}


def near(what, value, expected, relative, absolute=0.0):
    if not abs(value - expected) <= relative * abs(expected) + absolute:
        failures.append(f"{what}: {value:.9g}, expected {expected:.9g}")


def crossings(times, values):
    """Times at which values rise through their mean, between the rows."""
    mean = sum(values) / len(values)
    return [t + (u - t) * (mean - a) / (b - a)
            for t, u, a, b in zip(times, times[1:], values, values[1:]) if a <= mean < b]


def at(times, values, time):
    """Linear between the rows."""
    k = max(i for i, t in enumerate(times) if t <= time + 1e-15)
    k = min(k, len(times) - 2)
    part = (time - times[k]) / (times[k + 1] - times[k])
    return values[k] + part * (values[k + 1] - values[k])


def check_cycle(folder):
    run, found = columns(f"{folder}/history.csv"), read(f"{folder}/results.csv")[-1]
    result = {name: float(text) for name, text in found.items()
              if name.startswith("cycle_") and text}
    end = run["time_s"][-1]
    period = 1 / result["cycle_frequency_Hz"]
    n = min(16, int(len(run["time_s"]) / 4 / (period / run["time_s"][0])))
    first = next(i for i, t in enumerate(run["time_s"]) if t > end - n * period - 1e-12)
    last = {name: values[first:] for name, values in run.items()}
    times, v = last["time_s"], last["velocity_x_m/s"]

    rises = crossings(times, v)
    once = len([1 for a, b in zip(rises, rises[1:]) if b - a > 0.5 * period])
    near("frequency", once / (rises[-1] - rises[0]), result["cycle_frequency_Hz"], 1e-3)
    near("amplitude", (max(v) - min(v)) / 2, result["cycle_velocity_x_amplitude_m/s"], 1e-6)
    mean = sum(v) / len(v)
    near("rms", math.sqrt(sum((x - mean)**2 for x in v) / len(v)),
         result["cycle_velocity_x_rms_m/s"], 3e-3)
    near("least N", min(last["normal_force_N"]), result["cycle_normal_force_least_N"], 1e-6)
    near("most N", max(last["normal_force_N"]), result["cycle_normal_force_most_N"], 1e-6)
    near("least T", min(last["force_x_N"]), result["cycle_force_x_least_N"], 1e-6)
    near("most T", max(last["force_x_N"]), result["cycle_force_x_most_N"], 1e-6)
    stick = [s > 0 for s in last["nodes_sticking"]]
    near("stick", sum(stick) / len(stick), result["cycle_stick_time_share"], 0, 1e-3)
    parts = [s / c for s, c in zip(last["nodes_sticking"], last["nodes_in_contact"]) if c > 0]
    near("sticking nodes", sum(parts) / len(parts), result["cycle_stick_node_share"], 0, 1e-3)
    with open(f"{folder}/run.json", encoding="utf-8") as file:
        errors = [error["value"] for error in json.load(file)["errors"]
                  if error["quantity"] == "amplitude of the cycle"]
    near("statements of the amplitude's error", len(errors), 1, 0)
    near("error of the amplitude", errors[0], 1.5 * sum(stick) / sum(last["nodes_sticking"]), 1e-3)
    near("open", sum(not f > 0 for f in last["normal_force_N"]) / len(times),
         result["cycle_open_time_share"], 0, 1e-3)

    def change(name):
        return (run[name][-1] - at(run["time_s"], run[name], end - n * period)) / n

    heat, drive = change("friction_J"), change("supplied_J")
    near("heat", result["cycle_heat_J"], heat, 1e-6)
    near("drive", result["cycle_drive_J"], drive, 1e-6)
    near("damping", result["cycle_damping_J"], change("damping_J"), 1e-6)
    left = (result["cycle_drive_J"] - result["cycle_heat_J"] - result["cycle_damping_J"] -
            result["cycle_numerical_J"] - result["cycle_stored_J"])
    near("balance", left, 0, 0, 1e-4 * result["cycle_damping_J"])
    near("vibration", result["cycle_vibration_J"], result["cycle_damping_J"], 0.02)
    # heat again: traction times the sliding of the patch as a whole
    sliding = [10 * c + x for c, x in zip(last["creepage_x"], v)]
    power = [abs(f * s) for f, s in zip(last["force_x_N"], sliding)]
    near("heat by the mean sliding", sum(power) / len(power) * period, heat, 0.05)
    # with no load that changes the drive is that of the creepage, T V per time
    near("drive by the creepage", abs(sum(f * 10 * c for f, c in zip(last["force_x_N"],
         last["creepage_x"])) / len(times) * period), drive, 5e-3)

    harmonics = columns(f"{folder}/cycle.csv")
    near("mean", harmonics["normal_force_N"][0],
         sum(last["normal_force_N"]) / len(times), 1e-4)
    for k in (1, 2, 3):
        for name in ("velocity_x_m/s", "force_x_N"):
            total = sum(x * cmath.exp(-2j * math.pi * k * (t - end) / period)
                        for t, x in zip(times, last[name]))
            near(f"harmonic {k} of {name}", 2 * abs(total) / len(times), harmonics[name][k],
                 0.02, 0.01 * harmonics[name][1])
        near(f"frequency {k}", harmonics["frequency_Hz"][k], k / period, 1e-6)

    patch = columns(f"{folder}/cycle_patch.csv")
    near("record", max(patch["phase"]), 1, 0, 0.02)
    near("record in s", max(patch["time_s"]), period, 0.02)
    steps = sorted(set(patch["time_s"]))
    sticks = {t for t, s in zip(patch["time_s"], patch["state"]) if s == 2}
    near("record: stick", len(sticks) / len(steps), result["cycle_stick_time_share"], 0, 0.03)


    check_summary(folder, result)
    check_portrait(folder, run, period)


def check_summary(folder, result):
    """What the screen tells, to the digits that it has."""
    with open(f"{folder}/out", encoding="utf-8") as file:
        said = " ".join(file.read().split())
    number = r"(-?[\d.]+(?:e[+-]?\d+)?)"
    found = re.search(
        f"along x {number} m/s \\(amplitude\\), {number} m/s \\(rms\\); N {number} to {number} N, "
        f"T_x {number} to {number} N; nodes stick {number} % of the time, {number} % of those that "
        f"touch; no contact {number} % of the time work in a cycle: drive {number} J, heat {number} J, "
        f"to the vibration {number} J, of which damping {number} J and the scheme {number} J", said)
    if not found:
        failures.append(f"summary: {said}")
        return
    names = ["velocity_x_amplitude_m/s", "velocity_x_rms_m/s", "normal_force_least_N",
             "normal_force_most_N", "force_x_least_N", "force_x_most_N", "stick_time_share",
             "stick_node_share", "open_time_share", "drive_J", "heat_J", "vibration_J", "damping_J",
             "numerical_J"]
    for name, text in zip(names, found.groups()):
        percent = 100 if name.endswith("_share") else 1
        near(f"summary: {name}", float(text), percent * result["cycle_" + name], 0.05)
    if not result["cycle_stick_time_share"] > 1.5 * result["cycle_stick_node_share"]:
        failures.append("the shares of sticking cannot be told apart")


def blocks(path):
    """Curves of the data of a picture, each with its lines of names."""
    with open(path, encoding="utf-8") as file:
        for text in file.read().split("\n\n\n"):
            lines = text.strip("\n").split("\n")
            yield ([line for line in lines if line.startswith("#")],
                   [tuple(map(float, line.split())) for line in lines if line and line[0] not in "#N"])


def check_portrait(folder, run, period):
    """The velocity is the rate of the displacement in um; T in kN is over the sliding velocity."""
    (names, portrait), (_, loop) = list(blocks(f"{folder}/cycle.dat"))[:2]
    if "displacement (\u00b5m)" not in names[-1] or "velocity (m/s)" not in names[-1]:
        failures.append(f"names of the portrait: {names}")
    step = run["time_s"][0]
    last = slice(len(run["time_s"]) - len(portrait), None)
    mean = sum(run["velocity_x_m/s"][last]) / len(portrait)
    for (x, v), (y, w) in zip(portrait, portrait[1:]):
        near("portrait", (y - x) * 1e-6 / step, (v + w) / 2 - mean, 0, 5e-3)
    near("a cycle of the portrait", len(portrait) * step, period, 0, 2.1 * step)
    for (sliding, force), (_, v), c, t in zip(loop, portrait, run["creepage_x"][last],
                                              run["force_x_N"][last]):
        near("loop", sliding, v + 10 * c, 1e-6, 1e-6)
        near("loop", 1e3 * force, t, 1e-6)


def check_sweep(folder, cycle):
    rows, run = read(f"{folder}/results.csv"), read(f"{cycle}/results.csv")[-1]
    axis = [float(row["Stability/Added damping"]) for row in rows]
    if axis != [0, 0.08, 0.11, 0.08, 0]:
        failures.append(f"axis: {axis}")
    if [row["direction"] for row in rows] != ["up"] * 3 + ["down"] * 2:
        failures.append("directions")
    # the same start as the run by itself
    for name in ("cycle_frequency_Hz", "cycle_velocity_x_amplitude_m/s"):
        near(name, float(rows[0][name]), float(run[name]), 5e-3)
    # the start is the vibration that grows without more damping, as the run by itself began in
    for row in rows:
        near("start", float(row["start_Hz"]), float(run["excited_frequency_Hz"]), 1e-3)
    # at 0.08 the steady state is stable, but so is the cycle
    growths = [float(row["largest_growth_1/s"]) for row in rows]
    if not growths[0] > 0 > growths[1] > growths[2]:
        failures.append(f"growths: {growths}")
    kinds = [row["cycle"] for row in rows]
    if kinds != ["periodic", "periodic", "decayed", "decayed", "periodic"]:
        failures.append(f"kinds: {kinds}")
    if int(rows[2]["steps"]) == 0 or int(rows[3]["steps"]) != 0:
        failures.append("the cycle is to die away at 0.11, and nothing begins at 0.08")
    near("up and down", float(rows[0]["cycle_velocity_x_amplitude_m/s"]),
         float(rows[4]["cycle_velocity_x_amplitude_m/s"]), 0.01)
    for row in (rows[0], rows[1], rows[4]):
        near("damping takes what the vibration gets", float(row["cycle_vibration_J"]),
             float(row["cycle_damping_J"]), 0.02)


{"cycle": check_cycle, "sweep": check_sweep}[sys.argv[1]](*sys.argv[2:])
print("\n".join(failures))
sys.exit(1 if failures else 0)
