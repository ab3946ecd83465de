"""Vibrations in histories of bodies by their modes, for tests of them."""

import bisect
import cmath
import math


def between(x, xs, ys):
    """Linear between rows, and beyond the last ones."""
    i = min(max(bisect.bisect_left(xs, x), 1), len(xs) - 1)
    w = (x - xs[i - 1]) / (xs[i] - xs[i - 1])
    return (1 - w) * ys[i - 1] + w * ys[i]


def amplitude(times, values, frequency):
    """Of the vibration in a Hann window, from the mean on."""
    n = len(values)
    window = [1 - math.cos(2 * math.pi * (k + 0.5) / n) for k in range(n)]
    mean = sum(w * v for w, v in zip(window, values)) / sum(window)
    return abs(sum(w * (v - mean) * cmath.exp(-2j * math.pi * frequency * t) for w, v, t in zip(window, values, times)))


def growth(history, frequency):
    """Of the velocity along x, in 1/s, from its amplitude at that frequency in the first and the last half of a run."""
    times, values = history["force_time_s"], history["velocity_x_m/s"]
    step = times[1] - times[0]
    n = round(int(len(times) * step * frequency / 2) / frequency / step)
    first, last = amplitude(times[:n], values[:n], frequency), amplitude(times[-n:], values[-n:], frequency)
    return math.log(last / first) / (times[-1] - times[n - 1])


def difference(values, wanted):
    """Root mean square of the difference, over the standard deviation of what is wanted."""
    return math.dist(values, wanted) / deviation(wanted)


def deviation(values):
    """Standard deviation, times the root of the number of values."""
    mean = sum(values) / len(values)
    return math.sqrt(sum((x - mean) ** 2 for x in values))
