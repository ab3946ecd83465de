"""Spectra of runs against sums of one's own over history.csv.

lines FOLDER FREQUENCY GROWTH: densities, levels, lines and the eigenvalue beside the strongest.
spectrogram FOLDER FREQUENCY COLUMN: the highest line of each window and its level.
compare FULL REDUCED POINT...: velocities of points in two runs.
beside FOLDER STABILITY: phases of forces and shapes that Analysis = stability tells of the vibration
that a run began in, from its history."""
import cmath
import csv
import math
import os
import sys

import vtu

wrong = []


def check(name, good, *what):
    if not good:
        wrong.append(name)
        print("FAILED:", name, *what)


def read(*path):
    with open(os.path.join(*path)) as file:
        rows = list(csv.DictReader(file))
    return rows


def column(rows, name):
    return [float(row[name]) for row in rows]


def hann(n):
    return [(1 - math.cos(2 * math.pi * j / n)) / 2 for j in range(n)]


def density(values, step, segment, lines):
    """Welch's at some lines, overlapping by half."""
    window = hann(segment)
    squares = sum(w * w for w in window)
    mean = sum(values) / len(values)
    sums = {k: 0.0 for k in lines}
    n = 0
    first = 0
    while first + segment <= len(values):
        part = [w * (v - mean) for w, v in zip(window, values[first:first + segment])]
        for k in lines:
            sums[k] += abs(sum(x * cmath.exp(-2j * math.pi * k * j / segment)
                               for j, x in enumerate(part))) ** 2
        n += 1
        first += segment - segment // 2
    return {k: 2 * step / squares / n * value for k, value in sums.items()}


def lines(folder, frequency, growth):
    history, spectrum = read(folder, "history.csv"), read(folder, "spectrum.csv")
    found, bands = read(folder, "lines.csv"), read(folder, "third_octaves.csv")
    step = float(history[0]["time_s"])
    skipped = round(2e-3 / step)
    rows = history[skipped:]
    segment = round(14e-3 / step)
    df = float(spectrum[1]["frequency_Hz"])
    check("distance of the lines", abs(df * segment * step - 1) < 1e-6)
    (speed,) = set(column(history, "speed_m/s"))
    for row in spectrum[1:]:
        check("wavelength of a line", abs(float(row["wavelength_m"]) * float(row["frequency_Hz"]) / speed - 1) < 1e-6, row)
    for row in bands:
        centre = float(row["centre_frequency_Hz"])
        check("a band's centre", abs(float(row["lower_edge_Hz"]) * float(row["upper_edge_Hz"]) / centre**2 - 1) < 1e-6, row)
        check("a band's wavelength", abs(float(row["centre_wavelength_m"]) * centre / speed - 1) < 1e-6, row)
    references = {"velocity": (1e-9, "dB_re_1nm/s", "(m/s)2/Hz"), "normal_force": (1, "dB_re_1N", "N2/Hz"),
                  "force": (1, "dB_re_1N", "N2/Hz")}
    signals = {row["signal"] for row in found}
    for axis in "xyz":
        for signal in ("velocity_rim_", "velocity_end_", "velocity_"):
            name = f"{signal}{axis}"
            check(f"{name} has a spectrum", f"{name}_psd_(m/s)2/Hz" in spectrum[0]
                  and f"{name}_dB_re_1nm/s" in bands[0])
    check("columns of history", {"velocity_rim_x_m/s", "velocity_end_z_m/s"} <= set(history[0]))
    for signal in ("velocity_y_m/s", "velocity_rim_y_m/s", "velocity_end_z_m/s", "normal_force_N"):
        mine = [row for row in found if row["signal"] == signal]
        check(f"{signal}: it has lines", mine)
        if not mine:
            continue
        name = signal.rsplit("_", 1)[0]
        reference, level, unit = references[name.split("_")[0] if name != "normal_force" else name]
        strongest = max(mine, key=lambda row: float(row["level_dB"]))
        at = float(strongest["frequency_Hz"])
        check(f"{signal}: the strongest is the vibration", abs(at - frequency) < 0.3 * df, at, frequency, df)
        check(f"{signal}: its eigenvalue", abs(float(strongest["eigenvalue_Hz"]) - frequency) < 1e-6 * frequency
              and abs(float(strongest["eigenvalue_growth_1/s"]) - growth) < 1e-4 * abs(growth))
        check(f"{signal}: difference", abs(float(strongest["difference_Hz"]) - (at - frequency)) < 1e-5)
        check(f"{signal}: multiple", strongest["multiple"] == "1" and strongest["fundamental_Hz"] == strongest["frequency_Hz"])
        check(f"{signal}: reference", strongest["reference"] == level)
        check(f"{signal}: prominence", float(strongest["prominence_dB"]) > 10)
        k = round(at / df)
        around = density(column(rows, signal), step, segment, range(k - 2, k + 3))
        for i, value in around.items():
            check(f"{signal}: density", abs(float(spectrum[i][f"{name}_psd_{unit}"]) / value - 1) < 1e-5)
        mean_square = df * sum(around.values())
        check(f"{signal}: level", abs(float(strongest["level_dB"])
                                      - 10 * math.log10(mean_square / reference ** 2)) < 0.05)
        (band,) = [row for row in bands if float(row["lower_edge_Hz"]) < at < float(row["upper_edge_Hz"])]
        if abs(at / float(band["lower_edge_Hz"]) - 1) > 0.02 and abs(at / float(band["upper_edge_Hz"]) - 1) > 0.02:
            check(f"{signal}: band", abs(float(band[f"{name}_{level}"]) - float(strongest["level_dB"])) < 0.5,
                  band[f"{name}_{level}"], strongest["level_dB"])
    check("some signals", len(signals) > 6, signals)


def spectrogram(folder, frequency, signal):
    history, rows = read(folder, "history.csv"), read(folder, "spectrogram.csv")
    step = float(history[0]["time_s"])
    times = sorted({float(row["time_s"]) for row in rows})
    frequencies = sorted({float(row["frequency_Hz"]) for row in rows})
    check("all cells", len(rows) == len(times) * len(frequencies))
    df = frequencies[1] - frequencies[0]
    check("to the highest frequency of modes", 4000 - df < frequencies[-1] <= 4000)
    window = round(1 / (df * step))
    acts = column(history, "force_time_s")
    values = column(history, signal)
    for time in times[len(times) // 2:]:
        mine = {float(row["frequency_Hz"]): float(row["level_dB_re_1nm/s"]) for row in rows
                if float(row["time_s"]) == time}
        at = max(mine, key=mine.get)
        check("the highest line", abs(at - frequency) < 0.6 * df, time, at, frequency)
        first = min(range(len(acts)), key=lambda i: abs(acts[i] - (time - window * step / 2)))
        k = round(at / df)
        value = density(values[first:first + window], step, window, [k])[k]
        level = 10 * math.log10(1.5 * df * value / 1e-18)
        check("its level", abs(level - mine[at]) < 0.01, time, level, mine[at])


def compare(full, reduced, *points):
    full, reduced = read(full, "history.csv"), read(reduced, "history.csv")
    for point in points:
        spread = off = 0.0
        for axis in "xz":
            name = f"velocity_{point}_{axis}_m/s"
            a, b = column(full, name), column(reduced, name)
            mean = sum(a) / len(a)
            spread += sum((x - mean) ** 2 for x in a) / len(a)
            off += sum((x - y) ** 2 for x, y in zip(a, b)) / len(a)
        spread, off = math.sqrt(spread), math.sqrt(off)
        # close to the patch the static part of the forces is missing in modes
        most = 0.05 if point in ("low", "deep") else 0.01
        print(point, spread, off / spread)
        check(name, spread > 1e-7 and off < most * spread, spread, off)


def beside(folder, stability):
    history = read(folder, "history.csv")
    (row,) = [row for row in read(stability, "stability.csv") if row["unstable"] == "true"]
    s = complex(float(row["growth_1/s"]), 2 * math.pi * float(row["frequency_Hz"]))
    acts = column(history, "force_time_s")
    n = round(20 * 2 * math.pi / s.imag / (acts[1] - acts[0]))

    def in_time(name):
        """A of Re(A e^(s t)), by Hann's window over 20 periods."""
        values = column(history, name)[-n:]
        mean = sum(values) / n
        return sum(w * (x - mean) * cmath.exp(-s * t) for w, x, t in zip(hann(n), values, acts[-n:]))

    def turn(a, b):
        return cmath.phase(a / b)

    phase = float(row["force_phase_rad"])
    check("phase of T over N", abs(phase - turn(in_time("force_y_N"), in_time("normal_force_N"))) < 2e-3, phase)
    check("the phase decides", 0.1 < abs(phase) < 3)
    (pvd,) = [name[:-4] for name in os.listdir(stability) if name.startswith("vibration_") and name.endswith(".pvd")]
    for body, point, place in (("wheel", "rim", (0.19 * math.sin(math.pi / 3), 0.015, 0.2 - 0.19 / 2)),
                               ("rail", "end", (0.06, 0, -0.01))):
        # u(0) = Re U, a quarter of a period later u = -Im U
        now, later = (vtu.nodes(os.path.join(stability, f"{pvd}_{body}_{k}.vtu"))[0] for k in ("00", "06"))
        distances = [math.dist(at, place) for at in now["points"]]
        k = distances.index(min(distances))
        check(f"{body}: a node is near", distances[k] < 0.04, now["points"][k], place)
        y, z = (complex(now["displacement"][k][d], -later["displacement"][k][d]) for d in (1, 2))
        wanted = turn(in_time(f"velocity_{point}_y_m/s"), in_time(f"velocity_{point}_z_m/s"))
        print(body, now["points"][k], turn(y, z), wanted)
        check(f"{body}: y before z", abs(turn(y, z) - wanted) < 0.05, turn(y, z), wanted)
        check(f"{body}: the phase decides", 0.1 < abs(wanted) < 3)


if sys.argv[1] == "beside":
    beside(*sys.argv[2:])
elif sys.argv[1] == "lines":
    lines(sys.argv[2], float(sys.argv[3]), float(sys.argv[4]))
elif sys.argv[1] == "spectrogram":
    spectrogram(sys.argv[2], float(sys.argv[3]), sys.argv[4])
else:
    compare(*sys.argv[2:])
sys.exit(bool(wrong))
