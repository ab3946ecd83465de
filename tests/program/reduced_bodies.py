"""Histories of bodies by their modes.

growth FILE FREQUENCY: growth of the velocity along x, in 1/s, from its amplitude at that frequency
in the first and the last quarter of the run.
compare FULL REDUCED: rms differences of N, T, and the velocities along x and z over the standard
deviation of the full bodies', at the times their forces act."""
import cmath
import csv
import math
import sys


def read(path):
    with open(path) as file:
        rows = list(csv.DictReader(file))
    return {name: [float(row[name]) for row in rows] for name in rows[0]}


def amplitude(times, values, frequency):
    """Of the vibration in a Hann window, from the mean on."""
    n = len(values)
    window = [1 - math.cos(2 * math.pi * (k + 0.5) / n) for k in range(n)]
    mean = sum(w * v for w, v in zip(window, values)) / sum(window)
    return abs(sum(w * (v - mean) * cmath.exp(-2j * math.pi * frequency * t)
                   for w, v, t in zip(window, values, times)))


def growth(path, frequency):
    run = read(path)
    times, values = run["force_time_s"], run["velocity_x_m/s"]
    periods = int(len(times) * (times[1] - times[0]) * frequency / 2)
    n = round(periods / frequency / (times[1] - times[0]))
    first = amplitude(times[:n], values[:n], frequency)
    last = amplitude(times[-n:], values[-n:], frequency)
    return math.log(last / first) / (times[-1] - times[n - 1])


def compare(full, reduced):
    full, reduced = read(full), read(reduced)
    for name in ("normal_force_N", "force_x_N", "velocity_x_m/s", "velocity_z_m/s"):
        a, b = full[name], reduced[name]
        mean = sum(a) / len(a)
        spread = math.sqrt(sum((x - mean) ** 2 for x in a) / len(a))
        difference = math.sqrt(sum((x - y) ** 2 for x, y in zip(a, b)) / len(a))
        yield difference / spread


if sys.argv[1] == "growth":
    print(growth(sys.argv[2], float(sys.argv[3])))
else:
    print(*compare(sys.argv[2], sys.argv[3]))
