"""The sound of a small pair in time: levels against each other and against the WAV file, runs that
are killed and resumed, other air and distances on the same steps, and what is refused."""

import cmath
import math
import random
import re
import wave

import pytest
from conftest import HERE, RESUME, VALIDATE, charts, kill_and_resume, same_files, same_results

DENSITY, SPEED, DISTANCE, SKIPPED, STEP = 1.2, 343, 7.5, 2e-3, 1e-5
PAIR = (HERE / "pair.prm", {
    "Analysis": "transient", "Time/Bodies": "reduced", "Time/Approach": "", "Time/Excite mode": 1850, "Time/Excite velocity": 0.05,
    "Time/Time step": "1e-5", "Spectrum/Write": "never", "Stability/Rotation": "true"})
HEARD = (*PAIR, {"Sound/Estimate": "true", "Sound/Skipped time": "2e-3", "Time/End time": "30e-3", "Time/Checkpoint interval": 50})


def power(level):
    return 0.0 if math.isnan(level) else 1e-12 * 10 ** (level / 10)


def level_of(value):
    return 10 * math.log10(value / 1e-12)


def rounding(value):
    """Half of the last of nine digits."""
    return 0.5 * 10.0 ** (math.floor(math.log10(abs(value))) - 8)


def near(value, expected, tolerance):
    assert abs(value - expected) <= tolerance, f"{value:.9g}, expected {expected:.9g} to {tolerance:.2g}"


def a_weight(f):
    """In dB, IEC 61672-1."""
    r = 12194.217**2 * f**4 / (f**2 + 20.598997**2) / (f**2 + 12194.217**2) / math.sqrt((f**2 + 107.65265**2) * (f**2 + 737.86223**2))
    return 20 * math.log10(r) + 2.0


@pytest.fixture(scope="module")
def whole(shared):
    return shared(*HEARD, output="whole")


@pytest.fixture(scope="module")
def result(whole):
    """The last row of the results, as numbers."""
    table = whole.results
    return {column: table.last(column) for column in table.columns if "sound" in column or "wav" in column}


@pytest.fixture(scope="module")
def total(result):
    return power(result["sound_power_dB_re_1pW"])


@pytest.fixture(scope="module")
def pressure(whole, result):
    """What the file holds, in Pa."""
    with wave.open(str(whole / "pressure.wav")) as file:
        assert (file.getnchannels(), file.getsampwidth(), file.getframerate()) == (1, 3, 44100)
        data = file.readframes(file.getnframes())
    return [int.from_bytes(data[i:i + 3], "little", signed=True) / 2**23 * result["wav_full_scale_Pa"] for i in range(0, len(data), 3)]


def test_files_and_pictures(whole):
    for file in ("sound.csv", "sound_modes.csv", "sound.svg", "pressure.wav", "modal_velocities.csv"):
        assert (whole / file).stat().st_size, file
    charts("sound", whole.folder)


def test_the_powers_of_bodies_add_up(result, total):
    """To half of the last digit of each number."""
    parts = [result[f"sound_power_{body}_dB_re_1pW"] for body in ("wheel", "rail")]
    digits = sum(power(level) * rounding(level) * math.log(10) / 10 for level in [*parts, result["sound_power_dB_re_1pW"]])
    near(sum(map(power, parts)), total, digits)


def test_the_pressure_of_the_power(result, total):
    """What reaches the place is weighted alike."""
    heard = result["sound_pressure_Pa"]
    digits = rounding(result["sound_power_dB_re_1pW"]) * math.log(10) / 10 + 2 * rounding(heard) / heard
    near(heard**2, DENSITY * SPEED * total / (2 * math.pi * DISTANCE**2), heard**2 * digits)
    near(result["sound_pressure_dBA_re_20uPa"] - result["sound_power_dBA_re_1pW"],
         20 * math.log10(heard / 20e-6) - level_of(total), 1e-5)


def test_third_octaves(whole, result, total):
    bands = whole.table("sound.csv")
    wheel, rail, both, weighted, lower, upper, centre = (bands[name] for name in (
        "wheel_dB_re_1pW", "rail_dB_re_1pW", "total_dB_re_1pW", "total_dBA_re_1pW", "lower_edge_Hz", "upper_edge_Hz", "centre_frequency_Hz"))
    for k in range(len(bands)):
        near(power(wheel[k]) + power(rail[k]), power(both[k]), 1e-6 * total)
        near(upper[k] / lower[k], 10**0.1, 1e-6)
    heard = [k for k, level in enumerate(both) if not math.isnan(level)]
    near(level_of(sum(power(both[k]) for k in heard)), level_of(total), 0.02)
    near(level_of(sum(power(weighted[k]) for k in heard)), result["sound_power_dBA_re_1pW"], 0.02)
    loudest = max(heard, key=lambda k: both[k])
    tilt = a_weight(upper[loudest]) - a_weight(lower[loudest])
    near(weighted[loudest] - both[loudest], a_weight(centre[loudest]), abs(tilt) + 0.02)


def test_modes(whole, result, total):
    """Parts of the power, and columns of their velocities."""
    modes, history = whole.table("sound_modes.csv"), whole.table("modal_velocities.csv")
    bodies, shares = modes.texts("body"), modes["power_share"]
    near(sum(shares), 1, 1e-6)
    near(sum(share for share, body in zip(shares, bodies) if body == "wheel") * total,
         power(result["sound_power_wheel_dB_re_1pW"]), 1e-6 * total)
    names = [f"{body}_{mode}_m*sqrt(kg)/s" for body, mode in zip(bodies, modes.texts("mode"))]
    assert [column for column in history.columns if column != "time_s"] == names
    near(history["time_s"][0], STEP, 1e-12)
    near(history.last("time_s"), len(history) * STEP, 1e-9)
    assert all(0 < frequency <= 4000 for frequency in modes["frequency_Hz"])
    assert all((text == "") == (body == "rail") for text, body in zip(modes.texts("nodal_diameters"), bodies))


def test_the_file(whole, result, pressure):
    history = whole.table("modal_velocities.csv")
    recorded = (len(history) - round(SKIPPED / STEP)) * STEP
    near(len(pressure) / 44100, recorded, 0.011 * recorded)
    near(10 * math.log10(sum(p * p for p in pressure) / len(pressure)), 20 * math.log10(result["sound_pressure_Pa"]), 0.001)
    full_scale = result["wav_full_scale_Pa"]
    assert max(map(abs, pressure)) < full_scale <= 5.01 * max(map(abs, pressure))
    comment = re.search(rb"at ([\d.]+) m, an estimate; full scale \(2\^23\) is ([\d.e-]+) Pa", (whole / "pressure.wav").read_bytes()[:400])
    near(float(comment[1]), DISTANCE, 1e-6)
    near(float(comment[2]), full_scale, 1e-6 * full_scale)


def test_the_power_of_a_disc_by_hand(whole, result, pressure):
    """Of one thickness: int phi^2 over both faces is 2 / (density thickness) times the axial share of the unit modal mass.

    With the efficiencies of Thompson and Jones at the frequencies of the record, from the velocities alone. On so coarse a mesh,
    where the mass is that of nodes, the mean square of what is interpolated between them is some 8 % smaller."""
    modes, history = whole.table("sound_modes.csv"), whole.table("modal_velocities.csv")
    thickness, radius, highest = 0.03, 0.2, 4000.0
    used = round(len(pressure) / 44100 / STEP)
    by_hand = 0.0
    for body, mode, diameters, share in zip(modes.texts("body"), modes.texts("mode"), modes["nodal_diameters"], modes["axial_share"]):
        if body != "wheel":
            continue
        velocity = history[f"wheel_{mode}_m*sqrt(kg)/s"][-used:]
        critical = SPEED * (1.9 + 1.015 * diameters - 0.0189 * diameters**2) / (2 * math.pi * radius)
        for k in range(1, int(highest * used * STEP) + 1):
            f = k / (used * STEP)
            if f < 20:
                continue
            turn, w, amplitude = 1, cmath.exp(-2j * math.pi * k / used), 0
            for value in velocity:
                amplitude += value * turn
                turn *= w
            by_hand += (DENSITY * SPEED / (1 + (critical / f) ** (2 * diameters + 4)) * 2 * share / (7800 * thickness)
                        * 2 * abs(amplitude / used) ** 2)
    near(power(result["sound_power_wheel_dB_re_1pW"]) / by_hand, 0.92, 0.05)


def peak(values, interval):
    """Frequency of the largest amplitude in a Hann window, on a grid of 5 Hz."""
    mean = sum(values) / len(values)
    windowed = [(1 - math.cos(2 * math.pi * (k + 0.5) / len(values))) * (value - mean) for k, value in enumerate(values)]

    def amplitude(f):
        w, turn, found = cmath.exp(-2j * math.pi * f * interval), 1, 0
        for value in windowed:
            found += value * turn
            turn *= w
        return abs(found)

    return max(range(1700, 2000, 5), key=amplitude)


def test_the_pitch_is_that_of_the_contact(whole, pressure):
    recorded = len(whole.table("modal_velocities.csv")) - round(SKIPPED / STEP)
    contact = whole.table("history.csv")["velocity_x_m/s"][-recorded:]
    near(peak(pressure, 1 / 44100), peak(contact, STEP), 5.1)


def test_the_summary(whole, result):
    found = re.search(r"sound power of the wheel (-?[\d.]+) dB\(A\), the rail (-?[\d.]+) dB\(A\), together "
                      r"(-?[\d.]+) dB\(A\) re 1 pW; at ([\d.]+) m (-?[\d.]+) dB\(A\) re 20 uPa: an estimate", whole.screen)
    wheel, rail, both, place, here = map(float, found.groups())
    near(both, result["sound_power_dBA_re_1pW"], 0.06)
    near(level_of(power(wheel) + power(rail)), both, 0.15)
    near(place, DISTANCE, 1e-9)
    near(here, result["sound_pressure_dBA_re_20uPa"], 0.06)


def test_modes_have_the_numbers_of_stability(program, whole):
    table = program(HERE / "pair.prm", {"Analysis": "stability", "Output/Plot": "false", "Stability/Count check": "false",
                                        "Stability/Full model": "false"}).table("stability.csv")
    modes = whole.table("sound_modes.csv")
    frequencies = dict(zip(zip(modes.texts("body"), modes.texts("mode")), modes["frequency_Hz"]))
    found = [(frequencies[body, mode], frequency) for body in ("wheel", "rail")
             for mode, frequency in zip(table.texts(f"{body}_mode"), table[f"{body}_mode_Hz"]) if frequency < 3900]
    assert len(found) > 8
    for a, b in found:
        assert abs(a / b - 1) < 1e-3


def test_a_killed_run_and_other_air_and_distances_on_its_steps(program, whole, result):
    def begun(run):
        path = run / "modal_velocities.csv.part"
        return path.exists() and path.stat().st_size

    run, _ = kill_and_resume(program, [random.uniform(0.1, 0.6) for _ in range(2)], *HEARD, output="killed", begun=begun)
    same_files(run, whole, "history.csv", "modal_velocities.csv", "sound.csv", "sound_modes.csv", "pressure.wav")
    same_results(run, whole)
    farther = program(*HEARD, {"Sound/Distance": 15, "Sound/Full scale pressure": 0.001}, output="killed", options=RESUME,
                      says="samples of pressure.wav are higher and were cut").results
    assert 1.9999 <= result["sound_pressure_Pa"] / farther.last("sound_pressure_Pa") <= 2.0001
    assert farther.last("wav_full_scale_Pa") == 0.001
    denser = program(*HEARD, {"Sound/WAV file": "false", "Sound/Density of air": 2.4}, output="killed", options=RESUME).results
    assert 3.0102 <= denser.last("sound_power_dB_re_1pW") - result["sound_power_dB_re_1pW"] <= 3.0104
    assert "wav_full_scale_Pa" not in denser


def test_without_a_sound_there_are_no_velocities_of_modes(program):
    silent = program(*PAIR, {"Time/End time": "1e-3"}, output="silent")
    assert not (silent / "modal_velocities.csv").exists() and not (silent / "sound.csv").exists()
    program(*PAIR, {"Time/End time": "2e-3", "Sound/Estimate": "true"}, output="silent", options=RESUME, code=1, says="Sound/Estimate")


@pytest.mark.parametrize("says, settings", [
    ("set Time/Bodies = reduced", {"Time/Bodies": "full", "Time/Excite mode": 0, "Time/Excite velocity": 0}),
    ("Sound/Sampling rate = 7000 Hz: Modes/Maximum frequency = 4000 Hz needs at least twice", {"Sound/Sampling rate": 7000}),
    ("needs steps of at most half a period", {"Time/Time step": "2e-4"}),
    ("Sound/Skipped time = 0.03 s: the run lasts 0.03 s", {"Sound/Skipped time": 0.03}),
    ("Sound/Distance = 0: it must be above 0", {"Sound/Distance": 0}),
    ("Sound/Density of air = 0: it must be above 0", {"Sound/Density of air": 0}),
    ("Sound/Speed of sound = 0: it must be above 0", {"Sound/Speed of sound": 0}),
    ("Sound/Full scale pressure = 0: it must be above 0", {"Sound/Full scale pressure": 0}),
])
def test_refused(program, says, settings):
    program.refuses(HEARD[0], says, *HEARD[1:], settings, options=VALIDATE)


def test_plane_strain_has_no_axial_motion(program):
    program.refuses("carter_2d_full_slip", "in plane strain (Dimension = 2) a wheel has no axial motion", {
        "Analysis": "transient", "Time/Bodies": "reduced", "Contact/Speed": 10, "Time/Initial state": "steady", "Time/Time step": "4e-6",
        "Time/End time": "4e-3", "Time/Theta": 0.5, "Sound/Estimate": "true"}, options=VALIDATE)


@pytest.mark.parametrize("scene, says, settings", [
    (PAIR, "Sound/Distance = 3 has no effect: Sound/Estimate = false", {"Sound/Distance": 3}),
    (HEARD, "Sound/Sampling rate = 48000 has no effect: Sound/WAV file = false", {"Sound/WAV file": "false", "Sound/Sampling rate": 48000}),
    (PAIR[:1], "Sound/Estimate = true has no effect: Analysis = transient and rolling", {"Analysis": "stability", "Sound/Estimate": "true"}),
])
def test_entries_without_effect(program, scene, says, settings):
    program(*scene, settings, options=VALIDATE, says=says)
