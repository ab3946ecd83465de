"""A vibration that grows in time does so as the stability analysis says: its eigenvalues and the steps of the theta-scheme have
nothing in common but the matrices of the bodies."""

import math

import numpy as np
from conftest import HERE

PAIR = HERE / "pair.prm"


def exponents(history, start, order):
    """Exponents that a history is the sum of from a time (s) on, from which nothing drives the run any more, by ESPRIT.

    The span of the windows of a sum of exponentials does not change by a step later. A step h of theta = 1/2 multiplies by
    (1 + s h / 2) / (1 - s h / 2)."""
    times = np.array(history["force_time_s"])
    step = (times[-1] - times[0]) / (len(times) - 1)
    windows = []
    for column in ("normal_force_N", "force_x_N", "force_y_N"):
        force = np.array(history[column])
        force = (force - force[0])[times > start]  # the first one is hardly disturbed
        force /= abs(force).max()
        length = len(force) // 3
        windows += [force[i:i + length] for i in range(len(force) - length)]
    span = np.linalg.svd(np.array(windows).T, full_matrices=False)[0][:, :order]
    z = np.linalg.eigvals(np.linalg.lstsq(span[:-1], span[1:], rcond=None)[0])
    return 2 / step * (z - 1) / (z + 1)


def test_growth_in_time(program):
    run = program(PAIR, {"Analysis": "stability"}, output="stability")
    assert "1 mode grows, as many as the argument principle counts" in run.screen
    row = run.table("stability.csv").record(unstable="true")
    frequency, growth = row["corrected_frequency_Hz"], row["corrected_growth_1/s"]
    assert 1800 <= frequency <= 1900 and 25 <= growth <= 50
    history = program(PAIR, {"Analysis": "transient"}, output="time").table("history.csv")
    found = min(exponents(history, 6e-4, 22), key=lambda s: abs(s - complex(growth, 2 * math.pi * frequency)))
    assert 0.9999 <= found.imag / (2 * math.pi) / frequency <= 1.0001
    assert 0.99 <= found.real / growth <= 1.01
