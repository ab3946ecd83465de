"""Named points, spectra of velocities, their lines beside eigenvalues, spectrograms: against sums of one's own over history.csv."""

import cmath
import math

import pytest
import vtu
from conftest import HERE, QUIET, RESUME, VALIDATE, charts, same_files

LEAN = {**QUIET, "Output/Body fields": "false", "Output/Interface fields": "false"}
DISCS = ("carter_2d_full_slip", LEAN, {
    "Analysis": "transient", "Contact/Speed": 10, "Mesh/Elements across patch": 10, "Contact/Creepage x": 0.02,
    "Modes/Maximum frequency": 8000, "Wheel/Rayleigh mass": 40, "Rail/Rayleigh mass": 40, "Time/Initial state": "steady",
    "Time/Time step": "2e-6", "Time/End time": "3e-3", "Output/Plot": "false",
    "Surfaces/Rail height": "2e-6*exp(-((x+0.015)/0.002)^2)",
    "Wheel/Velocity points": "tread: 0.45, 90, 0; top: 0.4, 180, 0; low: 0.42, 5, 0", "Rail/Velocity points": "deep: 0.02, 0, -0.05"})


@pytest.fixture(scope="module")
def vibration(shared):
    """One that grows, in the contact and at points of both bodies."""
    return shared(HERE / "pair.prm", LEAN, {
        "Analysis": "transient", "Time/Bodies": "reduced", "Time/Approach": "", "Time/Excite mode": 1900,
        "Time/Excite velocity": "1e-4", "Time/End time": 0.03, "Time/Time step": "1e-5",
        "Wheel/Velocity points": "rim: 0.19, 60, 0.015", "Rail/Velocity points": "end: 0.06, 0, -0.01",
        "Spectrum/Spectrogram": "true", "Spectrum/Skipped time": "2e-3", "Spectrum/Segment length": "14e-3"})


def hann(n):
    return [(1 - math.cos(2 * math.pi * j / n)) / 2 for j in range(n)]


def density(values, step, segment, lines):
    """Welch's at some lines, overlapping by half."""
    window = hann(segment)
    mean = sum(values) / len(values)
    sums = dict.fromkeys(lines, 0.0)
    starts = range(0, len(values) - segment + 1, segment - segment // 2)
    for first in starts:
        part = [w * (v - mean) for w, v in zip(window, values[first:first + segment])]
        for k in lines:
            sums[k] += abs(sum(x * cmath.exp(-2j * math.pi * k * j / segment) for j, x in enumerate(part))) ** 2
    return {k: 2 * step / sum(w * w for w in window) / len(starts) * value for k, value in sums.items()}


def test_files_and_pictures(vibration):
    for file in ("spectrum.csv", "third_octaves.csv", "lines.csv", "spectrogram.csv", "spectrum.svg", "spectrogram.svg"):
        assert (vibration / file).stat().st_size, file
    charts("spectrum", vibration.folder)
    charts("spectrogram", vibration.folder)


def test_tables_of_spectra(vibration):
    history, spectrum, bands = (vibration.table(f"{name}.csv") for name in ("history", "spectrum", "third_octaves"))
    (speed,) = set(history["speed_m/s"])
    frequencies, centres = spectrum["frequency_Hz"], bands["centre_frequency_Hz"]
    assert frequencies[1] * round(14e-3 / history["time_s"][0]) * history["time_s"][0] == pytest.approx(1, rel=1e-6)
    assert [w * f for w, f in zip(spectrum["wavelength_m"], frequencies)][1:] == pytest.approx([speed] * (len(spectrum) - 1), rel=1e-6)
    assert [math.sqrt(a * b) for a, b in zip(bands["lower_edge_Hz"], bands["upper_edge_Hz"])] == pytest.approx(centres, rel=5e-7)
    assert [w * f for w, f in zip(bands["centre_wavelength_m"], centres)] == pytest.approx([speed] * len(bands), rel=1e-6)
    for name in (f"velocity_{point}{axis}" for point in ("rim_", "end_", "") for axis in "xyz"):
        assert f"{name}_psd_(m/s)2/Hz" in spectrum and f"{name}_dB_re_1nm/s" in bands
    assert "velocity_rim_x_m/s" in history and "velocity_end_z_m/s" in history
    assert len(set(vibration.table("lines.csv").texts("signal"))) > 6


@pytest.mark.parametrize("signal, reference, level, unit", [
    ("velocity_y_m/s", 1e-9, "dB_re_1nm/s", "(m/s)2/Hz"),
    ("velocity_rim_y_m/s", 1e-9, "dB_re_1nm/s", "(m/s)2/Hz"),
    ("velocity_end_z_m/s", 1e-9, "dB_re_1nm/s", "(m/s)2/Hz"),
    ("normal_force_N", 1, "dB_re_1N", "N2/Hz"),
])
def test_the_strongest_line_is_the_vibration(vibration, signal, reference, level, unit):
    history, spectrum, bands, found = (vibration.table(f"{name}.csv") for name in ("history", "spectrum", "third_octaves", "lines"))
    frequency, growth = (vibration.results.last(f"excited_{name}") for name in ("frequency_Hz", "growth_1/s"))
    step, df, name = history["time_s"][0], spectrum["frequency_Hz"][1], signal.rsplit("_", 1)[0]
    levels = found["level_dB"]
    strongest = max((k for k, text in enumerate(found.texts("signal")) if text == signal), key=lambda k: levels[k])
    line = dict(zip(found.columns, found.rows[strongest]))
    at = float(line["frequency_Hz"])
    assert abs(at - frequency) < 0.3 * df
    assert float(line["eigenvalue_Hz"]) == pytest.approx(frequency, rel=1e-6)
    assert float(line["eigenvalue_growth_1/s"]) == pytest.approx(growth, rel=1e-4)
    assert float(line["difference_Hz"]) == pytest.approx(at - frequency, rel=0, abs=1e-5)
    assert line["multiple"] == "1" and line["fundamental_Hz"] == line["frequency_Hz"]
    assert line["reference"] == level
    assert float(line["prominence_dB"]) > 10
    k = round(at / df)
    around = density(history[signal][round(2e-3 / step):], step, round(14e-3 / step), range(k - 2, k + 3))
    assert spectrum[f"{name}_psd_{unit}"][k - 2:k + 3] == pytest.approx(list(around.values()), rel=1e-5)
    assert abs(levels[strongest] - 10 * math.log10(df * sum(around.values()) / reference ** 2)) < 0.05
    ((lower, upper, value),) = [band for band in zip(bands["lower_edge_Hz"], bands["upper_edge_Hz"], bands[f"{name}_{level}"])
                                if band[0] < at < band[1]]
    if min(abs(at / lower - 1), abs(at / upper - 1)) > 0.02:
        assert abs(value - levels[strongest]) < 0.5


def test_the_highest_line_of_each_window_is_the_vibration(vibration):
    history, table = vibration.table("history.csv"), vibration.table("spectrogram.csv")
    frequency = vibration.results.last("excited_frequency_Hz")
    step, acts, values = history["time_s"][0], history["force_time_s"], history["velocity_y_m/s"]
    cells = {(t, f): level for t, f, level in zip(table["time_s"], table["frequency_Hz"], table["level_dB_re_1nm/s"])}
    times, frequencies = (sorted(set(table[name])) for name in ("time_s", "frequency_Hz"))
    assert len(table) == len(times) * len(frequencies)
    df = frequencies[1] - frequencies[0]
    assert 4000 - df < frequencies[-1] <= 4000, "to the highest frequency of modes"
    window = round(1 / (df * step))
    for time in times[len(times) // 2:]:
        at = max(frequencies, key=lambda f: cells[time, f])
        assert abs(at - frequency) < 0.6 * df
        begin = time - window * step / 2
        first = min(range(len(acts)), key=lambda i: abs(acts[i] - begin))
        k = round(at / df)
        value = density(values[first:first + window], step, window, [k])[k]
        assert abs(10 * math.log10(1.5 * df * value / 1e-18) - cells[time, at]) < 0.01


def test_forces_and_shapes_turn_in_time_as_stability_says(program, vibration):
    """Phases in the history of the vibration that a run began in."""
    stability = program(HERE / "pair.prm", {"Analysis": "stability", "Output/Plot": "false", "Stability/Count check": "false",
                                            "Stability/Full model": "false"})
    table, history = stability.table("stability.csv"), vibration.table("history.csv")
    (k,) = [k for k, text in enumerate(table.texts("unstable")) if text == "true"]
    s = complex(table["growth_1/s"][k], 2 * math.pi * table["frequency_Hz"][k])
    acts = history["force_time_s"]
    n = round(20 * 2 * math.pi / s.imag / (acts[1] - acts[0]))

    def in_time(name):
        """A of Re(A e^(s t)), by Hann's window over 20 periods."""
        values = history[name][-n:]
        mean = sum(values) / n
        return sum(w * (x - mean) * cmath.exp(-s * t) for w, x, t in zip(hann(n), values, acts[-n:]))

    phase = table["force_phase_rad"][k]
    assert abs(phase - cmath.phase(in_time("force_y_N") / in_time("normal_force_N"))) < 2e-3
    assert 0.1 < abs(phase) < 3, "the phase decides"
    (shape,) = [name[:-4] for name in stability.files() if name.startswith("vibration_") and name.endswith(".pvd")]
    for body, point, place in (("wheel", "rim", (0.19 * math.sin(math.pi / 3), 0.015, 0.2 - 0.19 / 2)), ("rail", "end", (0.06, 0, -0.01))):
        # u(0) = Re U, a quarter of a period later u = -Im U
        now, later = (vtu.nodes(stability / f"{shape}_{body}_{part}.vtu")[0] for part in ("00", "06"))
        distances = [math.dist(at, place) for at in now["points"]]
        node = distances.index(min(distances))
        assert distances[node] < 0.04
        y, z = (complex(now["displacement"][node][d], -later["displacement"][node][d]) for d in (1, 2))
        wanted = cmath.phase(in_time(f"velocity_{point}_y_m/s") / in_time(f"velocity_{point}_z_m/s"))
        assert abs(cmath.phase(y / z) - wanted) < 0.05, body
        assert 0.1 < abs(wanted) < 3, "the phase decides"


def test_points_move_in_full_and_reduced_bodies_alike(program):
    """Over a bump; in full bodies there are no eigenvalues."""
    run = program(*DISCS, {"Spectrum/Spectrogram": "true", "Spectrum/Spectrogram signal": "velocity_top_z_m/s",
                           "Spectrum/Highest frequency": 20000, "Spectrum/Line prominence": 1, "Spectrum/Segment length": "3e-3"},
                  output="full")
    full, reduced = run.table("history.csv"), program(*DISCS, {"Time/Bodies": "reduced"}, output="reduced").table("history.csv")
    for point in ("tread", "top", "low", "deep"):
        spread = off = 0.0
        for axis in "xz":
            a, b = (table[f"velocity_{point}_{axis}_m/s"] for table in (full, reduced))
            mean = sum(a) / len(a)
            spread += sum((x - mean) ** 2 for x in a)
            off += sum((x - y) ** 2 for x, y in zip(a, b))
        assert math.sqrt(spread / len(full)) > 1e-7, point
        # close to the patch the static part of the forces is missing in modes
        assert math.sqrt(off / spread) < (0.05 if point in ("low", "deep") else 0.01), point
    lines = run / "lines.csv"
    assert lines.stat().st_size and "eigenvalue" not in lines.read_text()
    assert int(run.table("spectrogram.csv").last("frequency_Hz")) <= 20000


def test_a_resumed_run_has_the_same_bytes(program):
    program(*DISCS, {"Time/End time": "2e-4"}, output="parts")
    parts = program(*DISCS, {"Time/End time": "4e-4"}, output="parts", options=RESUME)
    same_files(parts, program(*DISCS, {"Time/End time": "4e-4"}, output="whole"), "history.csv")


def test_without_points_and_spectra_there_is_nothing_of_it(program):
    run = program(*DISCS, {"Wheel/Velocity points": "", "Rail/Velocity points": "", "Spectrum/Write": "never", "Time/End time": "4e-6"})
    assert not any("velocity_tread" in column for column in run.table("history.csv").columns)
    assert not (run / "lines.csv").exists()


@pytest.mark.parametrize("says, settings", [
    ('Wheel/Velocity points: "0.45, 90, 0" is not a named point', {"Wheel/Velocity points": "0.45, 90, 0"}),
    ("more than one point with the name a", {"Wheel/Velocity points": "a: 0.45, 90, 0; a: 0.4, 0, 0"}),
    ("both have a point tread", {"Rail/Velocity points": "tread: 0, 0, -0.1"}),
    ("a name that cannot name a column", {"Wheel/Velocity points": "the tread: 0.45, 90, 0"}),
    ("in 2D its third number is 0", {"Wheel/Velocity points": "a: 0.45, 90, 0.01"}),
    ("need all nodes of a body on one rank", {"Body solver": "distributed"}),
    ("spectra are made of columns of history.csv", {"Spectrum/Spectrogram": "true", "Spectrum/Spectrogram signal": "velocity_side_x_m/s"}),
    ("give from 32 to the 1500 steps", {"Spectrum/Spectrogram": "true", "Spectrum/Spectrogram window": "1e-5"}),
])
def test_refused(program, says, settings):
    program.refuses(DISCS[0], says, *DISCS[1:], settings, options=VALIDATE)


def test_a_point_outside_of_its_body(program):
    run = program(*DISCS, {"Wheel/Velocity points": "a: 0.6, 90, 0"}, code=1, says="outside of the wheel")
    assert not (run / "history.csv").exists()


def test_points_without_effect(program):
    program(*DISCS, {"Time/Inertia": "false", "Output/Verbosity": "normal"}, options=VALIDATE, says="Wheel/Velocity points")
