#!/usr/bin/env python3
"""Write rail_roughness.csv: heights along a rail, random and repeatable.

Third octaves of wavelength from 100 to 3.15 mm, 3 dB re 1 um at 50 mm and 3 dB
less for each octave below: a smooth rail. Waves of random phase, eight in each
band, every 0.5 mm over 0.6 m. Usage: make_rail_roughness.py [FILE]
"""
import math
import random
import sys

SPACING_MM, LENGTH_MM = 0.5, 600.0
random.seed(1)

waves = []
for k in range(-10, 6):  # centres of 10^(-k/10) cm
    centre = 10.0 * 10 ** (-k / 10)  # mm
    level = 3.0 - 3.0 * math.log2(50.0 / centre)  # dB re 1 um
    rms = 10 ** (level / 20)  # um
    for _ in range(8):
        wavelength = centre * 10 ** random.uniform(-0.05, 0.05)
        waves.append((rms * math.sqrt(2 / 8), wavelength, random.uniform(0, 2 * math.pi)))

with open(sys.argv[1] if len(sys.argv) > 1 else "rail_roughness.csv", "w") as file:
    file.write("# made by make_rail_roughness.py\nposition_mm, height_um\n")
    for i in range(int(LENGTH_MM / SPACING_MM) + 1):
        x = i * SPACING_MM
        height = sum(a * math.cos(2 * math.pi * x / w + phase) for a, w, phase in waves)
        file.write(f"{x:g}, {height:.4f}\n")
