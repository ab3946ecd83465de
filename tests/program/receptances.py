"""The picture of a body's receptances against receptances.csv: sizes, and phases in degrees in the same order.

Usage: receptances.py RUN_FOLDER BODY."""
import csv
import math
import sys

folder, body = sys.argv[1:]
failures = []
with open(f"{folder}/receptances.csv", newline="", encoding="utf-8") as file:
    table = [row for row in csv.DictReader(file) if row["body"] == body]
with open(f"{folder}/receptances_{body}.dat", encoding="utf-8") as file:
    blocks = file.read().strip("\n").split("\n\n\n")

sizes, phases = [], []
for block in blocks:
    lines = block.strip("\n").split("\n")
    names = [line[1:].strip() for line in lines if line.startswith("#")]
    curve = [tuple(map(float, line.split())) for line in lines if not line.startswith("#")]
    axes = names[-1].split("\t")
    if axes == ["frequency (Hz)", "receptance (m/N)"]:
        sizes.append((names[-2], curve))
    elif axes == ["frequency (Hz)", "phase (\u00b0)"]:
        phases.append(curve)
    else:
        failures.append(f"axes {axes}")
if not sizes or len(sizes) != len(phases):
    failures.append(f"{len(sizes)} sizes, {len(phases)} phases")

for (name, size), phase in zip(sizes, phases):
    motion, force = (part.split() for part in name.split(" / "))
    rows = [row for row in table if [row["motion_at"], row["motion_along"]] == motion
            and [row["force_at"], row["force_along"]] == force]
    if not len(rows) == len(size) == len(phase):
        failures.append(f"{name}: {len(rows)} rows, {len(size)} and {len(phase)} points")
    for row, (f, a), (g, angle) in zip(rows, size, phase):
        alpha = complex(float(row["real_m/N"]), float(row["imaginary_m/N"]))
        expected = math.degrees(math.atan2(alpha.imag, alpha.real))
        if not (f == g and abs(f / float(row["frequency_Hz"]) - 1) < 1e-8 and abs(a / abs(alpha) - 1) < 1e-7
                and abs((angle - expected + 180) % 360 - 180) < 1e-4):
            failures.append(f"{name} at {f} Hz: {a} m/N, {angle} degrees; expected {abs(alpha)}, {expected}")
print("\n".join(failures))
sys.exit(1 if failures else 0)
