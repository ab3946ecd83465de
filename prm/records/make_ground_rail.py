#!/usr/bin/env python3
"""Write ground_rail.sdf: heights of 12 mm by 9 mm of a rail, random and repeatable.

Self-affine with a Hurst exponent of 0.8: 400 waves of random direction and phase,
from 6 mm down to 0.4 mm in equal ratios, with amplitudes as the power 0.8 of their
length; rms 1 um, points 0.1 mm apart, five of them not measured (BAD), as text after
ISO 25178-71. Usage: make_ground_rail.py [FILE]
"""
import math
import random
import sys

SPACING_MM, POINTS, LINES, N_WAVES, RMS_UM = 0.1, 121, 91, 400, 1.0
random.seed(2)

waves = []
for n in range(N_WAVES):
    length = 6.0 * (0.4 / 6.0) ** ((n + random.random()) / N_WAVES)  # mm
    angle = random.uniform(0, math.pi)
    k = 2 * math.pi / length
    waves.append((length**0.8, k * math.cos(angle), k * math.sin(angle), random.uniform(0, 2 * math.pi)))
scale = RMS_UM / math.sqrt(sum(a * a for a, _, _, _ in waves) / 2)
missing = {(random.randrange(POINTS), random.randrange(LINES)) for _ in range(5)}

with open(sys.argv[1] if len(sys.argv) > 1 else "ground_rail.sdf", "w") as file:
    file.write("aISO-1.0\nManufacID   = synthetic\nCreateDate  = 000000000000\nModDate     = 000000000000\n")
    file.write(f"NumPoints   = {POINTS}\nNumProfiles = {LINES}\n")
    file.write(f"Xscale      = {SPACING_MM * 1e-3:g}\nYscale      = {SPACING_MM * 1e-3:g}\nZscale      = 1e-08\n")
    file.write("Zresolution = -1\nCompression = 0\nDataType    = 6\nCheckType   = 0\n*\n")
    for j in range(LINES):
        line = []
        for i in range(POINTS):
            x, y = i * SPACING_MM, j * SPACING_MM
            height = scale * sum(a * math.cos(kx * x + ky * y + phase) for a, kx, ky, phase in waves)  # um
            line.append("BAD" if (i, j) in missing else f"{round(100 * height)}")
        file.write(" ".join(line) + "\n")
    file.write("*\n*\n")
