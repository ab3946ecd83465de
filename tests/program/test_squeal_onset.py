"""A run into a curve: a lateral creepage that rises. A vibration dies away and grows from the moment on at which a stability map says
so, by as much as the map says."""

import math

from conftest import HERE
from reduced_bodies import amplitude, between

PAIR = HERE / "pair.prm"
FREQUENCY = 1846
CURVE = """time_s, creepage_y
0,      0.002
0.12,   0.02
0.13,   0.02
"""


def envelope(times, values):
    """Logarithms of the amplitude in windows of ten periods."""
    step = times[1] - times[0]
    n = round(10 / FREQUENCY / step)
    return [(times[k] + n * step / 2, math.log(amplitude(times[k:k + n], values[k:k + n], FREQUENCY))) for k in range(0, len(times) - n, n // 4)]


def test_squeal_begins_where_the_map_says(program):
    program.write("curve.csv", CURVE)
    in_time = "subsection Time\n  set Creepage y = table: curve.csv creepage_y\n  set Bodies = reduced"
    scene = program.write("curve.prm", PAIR.read_text(encoding="utf-8").replace("subsection Time", in_time))
    history = program(scene, {"Analysis": "transient", "Time/End time": 0.13, "Modes/Count check": "false",
                              "Spectrum/Write": "never"}, output="curve").table("history.csv")
    states = program(PAIR, {"Analysis": "stability map", "Table/Threads": 1, "Table/Axis 1":
                            "Contact/Creepage y = 0.002, 0.004, 0.006, 0.008, 0.010, 0.014, 0.02"}, output="map").results
    times, creepages = history["force_time_s"], history["creepage_y"]
    at, levels = zip(*envelope(times, history["velocity_z_m/s"]))
    of_map, growths = states["creepage_y"], states["largest_growth_1/s"]
    growth = [between(between(t, times, creepages), of_map, growths) for t in at]
    said = [levels[0]]
    for k in range(1, len(at)):
        said.append(said[-1] + (at[k] - at[k - 1]) * (growth[k] + growth[k - 1]) / 2)
    least, turns = levels.index(min(levels)), said.index(min(said))
    assert 0.02 <= at[turns] <= 0.05, "the eigenvalue turns positive"
    assert abs(at[least] - at[turns]) <= 4e-3, "growth begins then"
    assert 0.97 <= (levels[-1] - levels[turns]) / (said[-1] - said[turns]) <= 1.03, "by as much as the eigenvalues say"
    assert 1.2 <= levels[-1] - levels[turns] <= 2
