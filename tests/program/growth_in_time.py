#!/usr/bin/env python3
"""Vibrations that a history.csv is the sum of, beside the eigenvalues of a stability.csv.

Usage: growth_in_time.py TRANSIENT STABILITY FROM ORDER, two run folders, the time (s) from which nothing drives the run any more, and how many exponentials
are looked for. Prints for each unstable row of stability.csv its corrected frequency (Hz) and growth (1/s) and those of the nearest exponential, found by ESPRIT:
the span of the windows of a sum of exponentials does not change by a step later. A step h of theta = 1/2 multiplies by (1 + s h / 2) / (1 - s h / 2).
"""
import csv
import math
import sys

import numpy as np

COLUMNS = ("normal_force_N", "force_x_N", "force_y_N")


def rows_of(folder, name):
    with open(folder + "/" + name, newline="") as file:
        return list(csv.DictReader(file))


def exponents(rows, start, order):
    times = np.array([float(row["force_time_s"]) for row in rows])
    step = (times[-1] - times[0]) / (len(times) - 1)
    windows = []
    for column in COLUMNS:
        force = np.array([float(row[column]) for row in rows])
        force = (force - force[0])[times > start]  # the first one is hardly disturbed
        force /= abs(force).max()
        length = len(force) // 3
        windows += [force[i:i + length] for i in range(len(force) - length)]
    span = np.linalg.svd(np.array(windows).T, full_matrices=False)[0][:, :order]
    z = np.linalg.eigvals(np.linalg.lstsq(span[:-1], span[1:], rcond=None)[0])
    return 2 / step * (z - 1) / (z + 1)


def main():
    transient, stability, start, order = sys.argv[1:]
    found = exponents(rows_of(transient, "history.csv"), float(start), int(order))
    for row in rows_of(stability, "stability.csv"):
        if row["unstable"] != "true":
            continue
        frequency, growth = float(row["corrected_frequency_Hz"]), float(row["corrected_growth_1/s"])
        s = complex(growth, 2 * math.pi * frequency)
        nearest = found[np.argmin(abs(found - s))]
        print("%.9g %.9g %.9g %.9g" % (frequency, growth, nearest.imag / (2 * math.pi), nearest.real))


main()
