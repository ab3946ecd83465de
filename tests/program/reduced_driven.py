"""Histories of driven bodies by their modes.

compare FULL REDUCED FROM COLUMN...: of each column rms difference and difference of the extremes
over the standard deviation of the full bodies', from a time (s) on, at the times that forces act.
onset HISTORY FREQUENCY MAP: logarithm of the amplitude of the velocity along z at that frequency
(Hz) while a creepage changes, against the growth of a stability map: prints the time (s) from
which on it grows, that of the map, growth from there over what the map says, and the growth."""
import bisect
import cmath
import csv
import math
import sys


def read(path):
    with open(path) as file:
        rows = list(csv.DictReader(file))
    return {name: [float(row[name]) for row in rows if row[name] != ""] for name in rows[0]
            if name not in ("status", "solver", "vibrations", "slip_operator", "converged")}


def between(x, xs, ys):
    i = min(max(bisect.bisect_left(xs, x), 1), len(xs) - 1)
    w = (x - xs[i - 1]) / (xs[i] - xs[i - 1])
    return (1 - w) * ys[i - 1] + w * ys[i]


def compare(full, reduced, start, names):
    full, reduced = read(full), read(reduced)
    times, others = full["force_time_s"], reduced["force_time_s"]
    chosen = [t for t in times if t >= max(start, others[0]) and t <= others[-1]]
    for name in names:
        a = [between(t, times, full[name]) for t in chosen]
        b = [between(t, others, reduced[name]) for t in chosen]
        mean = sum(a) / len(a)
        spread = math.sqrt(sum((x - mean) ** 2 for x in a) / len(a))
        yield math.sqrt(sum((x - y) ** 2 for x, y in zip(a, b)) / len(a)) / spread
        yield max(abs(max(a) - max(b)), abs(min(a) - min(b))) / spread


def envelope(times, values, frequency):
    """Logarithms of the amplitude in Hann windows of ten periods."""
    step = times[1] - times[0]
    n = round(10 / frequency / step)
    window = [1 - math.cos(2 * math.pi * (k + 0.5) / n) for k in range(n)]
    for start in range(0, len(times) - n, n // 4):
        part = values[start:start + n]
        mean = sum(w * v for w, v in zip(window, part)) / sum(window)
        amplitude = abs(sum(w * (v - mean) * cmath.exp(-2j * math.pi * frequency * t)
                            for w, v, t in zip(window, part, times[start:start + n])))
        yield times[start] + n * step / 2, math.log(amplitude)


def onset(history, frequency, table):
    run, states = read(history), read(table)
    points = list(envelope(run["force_time_s"], run["velocity_z_m/s"], frequency))
    creepages, growth = states["creepage_y"], states["largest_growth_1/s"]
    sigma = [between(between(t, run["force_time_s"], run["creepage_y"]), creepages, growth)
             for t, _ in points]
    said = [points[0][1]]
    for k in range(1, len(points)):
        said.append(said[-1] + (points[k][0] - points[k - 1][0]) * (sigma[k] + sigma[k - 1]) / 2)
    least = min(range(len(points)), key=lambda k: points[k][1])
    turns = min(range(len(points)), key=lambda k: said[k])
    return (points[least][0], points[turns][0],
            (points[-1][1] - points[turns][1]) / (said[-1] - said[turns]),
            points[-1][1] - points[turns][1])


if sys.argv[1] == "compare":
    print(*compare(sys.argv[2], sys.argv[3], float(sys.argv[4]), sys.argv[5:]))
else:
    print(*onset(sys.argv[2], float(sys.argv[3]), sys.argv[4]))
