"""Tables of sound and the WAV file of a run against each other.

Usage: sound.py FOLDER DENSITY SPEED_OF_SOUND DISTANCE SKIPPED TIME_STEP. Levels are taken back to
powers, the file to pressures, and the modes' own powers are compared with their velocities."""
import cmath
import csv
import math
import re
import sys
import wave

folder = sys.argv[1]
density, speed, distance, skipped, step = map(float, sys.argv[2:])
failures = []


def rows(name):
    with open(f"{folder}/{name}", newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def near(what, value, expected, tolerance):
    if not abs(value - expected) <= tolerance:
        failures.append(what)
        print(f"{what}: {value:.9g}, expected {expected:.9g} to {tolerance:.2g}")


def rounding(text):  # half of the last of nine digits
    return 0.5 * 10.0 ** (math.floor(math.log10(abs(float(text)))) - 8)


def power(level):
    return 1e-12 * 10 ** (float(level) / 10) if level else 0.0


def level(value):
    return 10 * math.log10(value / 1e-12)


def a_weight(f):
    """In dB, IEC 61672-1."""
    r = (12194.217**2 * f**4 / (f**2 + 20.598997**2) / (f**2 + 12194.217**2)
         / math.sqrt((f**2 + 107.65265**2) * (f**2 + 737.86223**2)))
    return 20 * math.log10(r) + 2.0


result = rows("results.csv")[-1]
bands = rows("sound.csv")
modes = rows("sound_modes.csv")
history = rows("modal_velocities.csv")

# bodies and their sum, to half of the last digit of each number
total = power(result["sound_power_dB_re_1pW"])
parts = [result[f"sound_power_{body}_dB_re_1pW"] for body in ("wheel", "rail")]
near("wheel and rail", sum(power(level) for level in parts), total,
     sum(power(level) * rounding(level) * math.log(10) / 10 for level in [*parts, result["sound_power_dB_re_1pW"]]))
pressure = result["sound_pressure_Pa"]
near("pressure of the power", float(pressure) ** 2, density * speed * total / (2 * math.pi * distance**2),
     float(pressure) ** 2 * (rounding(result["sound_power_dB_re_1pW"]) * math.log(10) / 10
                             + 2 * rounding(pressure) / float(pressure)))
# what reaches the place is weighted alike
near("weighted pressure", float(result["sound_pressure_dBA_re_20uPa"])
     - float(result["sound_power_dBA_re_1pW"]),
     20 * math.log10(float(result["sound_pressure_Pa"]) / 20e-6) - level(total), 1e-5)
for band in bands:
    near("a band's bodies", power(band["wheel_dB_re_1pW"]) + power(band["rail_dB_re_1pW"]),
         power(band["total_dB_re_1pW"]), 1e-6 * total)
    near("a band's edges", float(band["upper_edge_Hz"]) / float(band["lower_edge_Hz"]), 10**0.1, 1e-6)
in_bands = [band for band in bands if band["total_dB_re_1pW"]]
near("bands", level(sum(power(b["total_dB_re_1pW"]) for b in in_bands)), level(total), 0.02)
near("weighted bands", level(sum(power(b["total_dBA_re_1pW"]) for b in in_bands)),
     float(result["sound_power_dBA_re_1pW"]), 0.02)
loudest = max(in_bands, key=lambda b: power(b["total_dB_re_1pW"]))
tilt = a_weight(float(loudest["upper_edge_Hz"])) - a_weight(float(loudest["lower_edge_Hz"]))
near("weight of the loudest band", float(loudest["total_dBA_re_1pW"]) - float(loudest["total_dB_re_1pW"]),
     a_weight(float(loudest["centre_frequency_Hz"])), abs(tilt) + 0.02)

# modes: parts of the power, and what their own powers have in common with their velocities
near("shares", sum(float(mode["power_share"]) for mode in modes), 1.0, 1e-6)
near("share of the wheel", sum(float(m["power_share"]) for m in modes if m["body"] == "wheel") * total,
     power(result["sound_power_wheel_dB_re_1pW"]), 1e-6 * total)
columns = [name for name in history[0] if name != "time_s"]
names = [f"{mode['body']}_{mode['mode']}_m*sqrt(kg)/s" for mode in modes]
if columns != names:
    failures.append("columns")
    print("modes:", columns, names)
near("times", float(history[0]["time_s"]), step, 1e-12)
near("last time", float(history[-1]["time_s"]), len(history) * step, 1e-9)
if not all(0 < float(mode["frequency_Hz"]) <= 4000 for mode in modes):
    failures.append("frequencies")
    print("modes above Modes/Maximum frequency")
for mode in modes:
    if (mode["nodal_diameters"] == "") != (mode["body"] == "rail"):
        failures.append("nodal diameters")
        print("nodal diameters of", mode)

# the file
with wave.open(f"{folder}/pressure.wav") as file:
    form = (file.getnchannels(), file.getsampwidth(), file.getframerate())
    rate, data = file.getframerate(), file.readframes(file.getnframes())
if form != (1, 3, 44100):
    failures.append("form")
    print("form of the file:", form)
full_scale = float(result["wav_full_scale_Pa"])
pressure = [int.from_bytes(data[i:i + 3], "little", signed=True) / 2**23 * full_scale
            for i in range(0, len(data), 3)]
recorded = (len(history) - round(skipped / step)) * step
near("duration", len(pressure) / rate, recorded, 0.011 * recorded)
mean_square = sum(p * p for p in pressure) / len(pressure)
near("level of the file in dB", 10 * math.log10(mean_square),
     20 * math.log10(float(result["sound_pressure_Pa"])), 0.001)
if not max(map(abs, pressure)) < full_scale <= 5.01 * max(map(abs, pressure)):
    failures.append("full scale")
    print("full scale:", full_scale, max(map(abs, pressure)))
with open(f"{folder}/pressure.wav", "rb") as file:
    comment = re.search(rb"at ([\d.]+) m, an estimate; full scale \(2\^23\) is ([\d.e-]+) Pa", file.read(400))
if not comment:
    failures.append("comment")
    print("no comment in the file")
else:
    near("distance in the comment", float(comment.group(1)), distance, 1e-6)
    near("full scale in the comment", float(comment.group(2)), full_scale, 1e-6 * full_scale)

# The wheel is a disc of one thickness: int phi^2 over both faces is 2 / (density thickness) times
# the axial share of the unit modal mass. Its power, with the efficiencies of Thompson and Jones at
# the frequencies of the record, from the velocities alone. On so coarse a mesh, where the mass is
# that of nodes, the mean square of what is interpolated between them is some 8 % smaller.
DISC_DENSITY, THICKNESS, RADIUS, HIGHEST = 7800.0, 0.03, 0.2, 4000.0
used = round(len(pressure) / rate / step)
by_hand = 0.0
for mode in modes:
    if mode["body"] != "wheel":
        continue
    velocity = [float(row[f"wheel_{mode['mode']}_m*sqrt(kg)/s"]) for row in history[-used:]]
    diameters = int(mode["nodal_diameters"])
    critical = speed * (1.9 + 1.015 * diameters - 0.0189 * diameters**2) / (2 * math.pi * RADIUS)
    form = 2 * float(mode["axial_share"]) / (DISC_DENSITY * THICKNESS)
    for k in range(1, int(HIGHEST * used * step) + 1):
        f = k / (used * step)
        if f < 20:
            continue
        turn, w, amplitude = 1, cmath.exp(-2j * math.pi * k / used), 0
        for value in velocity:
            amplitude += value * turn
            turn *= w
        by_hand += (density * speed / (1 + (critical / f) ** (2 * diameters + 4)) * form
                    * 2 * abs(amplitude / used) ** 2)
near("power of a disc by hand", power(result["sound_power_wheel_dB_re_1pW"]) / by_hand, 0.92, 0.05)

# the loudest line of the file is where the contact vibrates
n = len(pressure)
contact = rows("history.csv")
contact = [float(row["velocity_x_m/s"]) for row in contact[-round(recorded / step):]]


def peak(values, interval):
    """Frequency of the largest amplitude in a Hann window, on a grid of 5 Hz."""
    mean = sum(values) / len(values)
    window = [1 - math.cos(2 * math.pi * (k + 0.5) / len(values)) for k in range(len(values))]
    best = (0.0, 0.0)
    for f in range(1700, 2000, 5):
        w = cmath.exp(-2j * math.pi * f * interval)
        turn, total_sum = 1, 0
        for value, weight in zip(values, window):
            total_sum += weight * (value - mean) * turn
            turn *= w
        best = max(best, (abs(total_sum), f))
    return best[1]


near("pitch", peak(pressure, 1 / rate), peak(contact, step), 5.1)

# the summary
with open(f"{folder}/out", encoding="utf-8") as file:
    said = " ".join(file.read().split())
found = re.search(r"sound power of the wheel (-?[\d.]+) dB\(A\), the rail (-?[\d.]+) dB\(A\), together "
                  r"(-?[\d.]+) dB\(A\) re 1 pW; at ([\d.]+) m (-?[\d.]+) dB\(A\) re 20 uPa: an estimate", said)
if not found:
    failures.append("summary")
    print("summary:", said)
else:
    wheel, rail, both, place, here = map(float, found.groups())
    near("summary: both", both, float(result["sound_power_dBA_re_1pW"]), 0.06)
    near("summary: sum", level(power(wheel) + power(rail)), both, 0.15)
    near("summary: place", place, distance, 1e-9)
    near("summary: pressure", here, float(result["sound_pressure_dBA_re_20uPa"]), 0.06)
sys.exit(bool(failures))
