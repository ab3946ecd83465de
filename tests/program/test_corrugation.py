"""Growth of waves by wear: tables, picture, what belongs together, and what is refused."""

import math
import re

import pytest

SCENE, SQUEAL = "carter_2d_partial_slip", "squeal_small"
COMMON = {"Analysis": "corrugation", "Contact/Speed": 40, "Mesh/Elements across patch": 16,
          "Corrugation/Wavelengths": "0.02 : 0.1 : 8", "Corrugation/Speeds": "20, 40", "Modes/Maximum frequency": 4000}
REDUCED = {"Stability/Full model": "false"}
NO_PLOT = {"Output/Plot": "false"}
TABLE, CHECK = "corrugation.csv", "corrugation_check.csv"


def wave(run, speed, wavelength, column="growth"):
    """Of the row with this speed that is nearest to a wavelength."""
    rows = run.table(TABLE).records(**{"speed_m/s": speed})
    return min(rows, key=lambda row: abs(row["wavelength_m"] - wavelength))[column]


def sizes(run, expression, name=TABLE):
    """Sizes of an expression of each row."""
    return [abs(expression(row)) for row in run.table(name).records()]


def all_within(values, most):
    return len(values) > 0 and all(value <= most for value in values)


def of_whole_bodies(run):
    """How far growths of whole bodies are off, where there are any."""
    return [abs(row["growth_of_whole_bodies"] / row["growth"] - 1) for row in run.table(TABLE).records()
            if row["growth_of_whole_bodies"] != ""]


@pytest.fixture(scope="module")
def line(shared):
    return shared(SCENE, COMMON, output="line")


def test_what_belongs_together(line):
    table = line.table(TABLE)
    assert len(table) == 16
    assert (table["speed_m/s"][0], table["wavelength_m"][0]) == (20, 0.02), "the slowest and the shortest first"
    lengths = table["wavelength_m"][:8]
    ratios = [b / a for a, b in zip(lengths, lengths[1:])]
    assert all_within([abs(ratio / ratios[0] - 1) for ratio in ratios], 1e-7)
    assert all_within(sizes(line, lambda row: row["speed_m/s"] / row["wavelength_m"] / row["frequency_Hz"] - 1), 1e-8)
    assert all_within(sizes(line, lambda row: (row["growth_by_traction"] + row["growth_by_slip"] - row["growth"]) / 1e-5), 1e-7)
    assert all_within(sizes(line, lambda row: row["growth_of_passages"] - 1e6 * row["growth"]), 1e-6)
    assert all_within(sizes(line, lambda row: (row["growth_dB/1e6"] - 8.685889638e6 * row["growth"]) / 1e2), 1e-6)
    assert all(row["growth_uncertainty"] > 0 and row["pad_offset_m"] == "" for row in table.records())
    assert 0.15 <= line.results.last("traction_coefficient") <= 0.165


def test_long_waves_grow_short_ones_are_worn_flat(line):
    """100 mm at 40 m/s lies below 450 Hz, the resonance of both discs on the contact; J0(k a) of a half-width of 4.24 mm is 0.606."""
    assert 2e-6 <= wave(line, 40, 0.1) <= 3.5e-6
    assert -2e-5 <= wave(line, 20, 0.02) <= -8e-6
    assert -0.3 <= wave(line, 40, 0.1, "contact_filter_dB") <= 0
    assert -5.2 <= wave(line, 20, 0.02, "contact_filter_dB") <= -4


def test_whole_bodies_where_it_grows_most(line):
    off, = of_whole_bodies(line)
    assert 1e-9 <= off <= 2e-3
    assert re.search(r"8 of 16 waves grow, [67] beyond their uncertainty; most that of 100 mm \(400 Hz\) at 40 m/s, exp\(2.9", line.screen)
    assert re.search(r"growth of waves by modes .* of the largest \|G\| against whole bodies", line.screen)


def test_the_curves_are_the_rows(line):
    assert 2 <= len(line.table("corrugation_peaks.csv")) <= 7
    assert line.has("corrugation.svg")
    growth = wave(line, 20, 0.02, "growth_of_passages")
    assert sum(point[0] == 20 and abs(point[1] - growth) < 1e-4 for point in line.points("corrugation.dat")) == 1


def test_twice_the_wear_half_the_passages(program, line):
    run = program(SCENE, COMMON, REDUCED, NO_PLOT, {"Corrugation/Wear coefficient": 13.5e-13, "Corrugation/Passages": 5e5})
    assert abs(wave(run, 20, 0.05) / wave(line, 20, 0.05) - 2) <= 1e-7
    assert abs(wave(run, 20, 0.05, "growth_of_passages") / wave(line, 20, 0.05, "growth_of_passages") - 1) <= 1e-7
    assert not (run / "corrugation.svg").exists(), "where none is wanted"
    assert of_whole_bodies(run) == [], "left out"


def test_waves_on_the_wheel_fit_round_it(program):
    run = program(SCENE, COMMON, REDUCED, NO_PLOT, {"Corrugation/Worn body": "wheel"})
    assert all_within(sizes(run, lambda row: (2 * math.pi * 0.46 / row["wavelength_m"] + 0.5) % 1 - 0.5), 1e-6)


def test_a_wave_in_time(program, line):
    run = program(SCENE, COMMON, REDUCED, NO_PLOT, {"Corrugation/Check wavelength": 0.05})
    assert len(run.table(CHECK)) == 2, "a row for each speed"
    assert all_within(sizes(run, lambda row: row["growth_ratio"] - 1, CHECK), 0.01)
    phases, loads = sizes(run, lambda row: row["growth_phase_deg"], CHECK), sizes(run, lambda row: row["load_ratio"] - 1, CHECK)
    assert all_within(phases, 0.5) and max(phases) >= 1e-9, "at the same places"
    assert all_within(loads, 2e-3) and max(loads) >= 1e-12
    assert all_within(sizes(run, lambda row: row["growth_ratio"] ** 2 * (row["growth"] ** 2 + row["growth_imaginary"] ** 2)
                            / (row["growth_in_time"] ** 2 + row["growth_in_time_imaginary"] ** 2) - 1, CHECK), 1e-6)
    assert all_within(sizes(run, lambda row: row["change"], CHECK), 2e-4), "settled"
    assert re.search("A wave of 50 mm at 20 m/s: in time .* times the growth of a small wave", run.screen)
    assert re.search("check farthest off: 50 mm at .*0 m/s, in time", run.screen)
    assert 0.95 <= run.table(CHECK).last("growth_imaginary") / wave(run, 40, 0.05, "growth_imaginary") <= 1.05, "beside its neighbour"
    mine, others = run.table(TABLE), line.table(TABLE)
    assert mine.columns == others.columns
    assert mine.without("growth_of_whole_bodies") == others.without("growth_of_whole_bodies"), "it leaves the others as they are"
    assert not any(mine.texts("growth_of_whole_bodies"))
    assert not (line / CHECK).exists(), "none where none is wanted"


AXLE = {"Wheel/Hub": "mass", "Wheel/Hub mass": 20}
PADS = {"Analysis": "corrugation", **AXLE, "Corrugation/Wavelengths": "0.008, 0.016", "Modes/Maximum frequency": 2000,
        "Corrugation/Pad offsets": "-0.039, -0.02"}


def test_a_disc_on_its_axle_a_rail_on_a_pad(program):
    run = program(SQUEAL, PADS, output="axle")
    table = run.table(TABLE)
    assert [row[:3] for row in table.rows] == [[place, "10", length] for place in ("-0.039", "-0.02") for length in ("0.008", "0.016")]
    assert len(run.results) == 2, "a state for each place"
    off = of_whole_bodies(run)
    assert all_within(off, 5e-3) and max(off) >= 1e-9
    assert "Pads at -0.039 m" in run.out
    program(SQUEAL, AXLE, {"Analysis": "stability"}, output="squeal")


def test_a_disc_that_turns_is_driven_the_other_way_in_the_mirror(program):
    one, other = (
        program(SQUEAL, REDUCED, NO_PLOT, {"Analysis": "corrugation", "Corrugation/Wavelengths": 0.012, "Modes/Maximum frequency": 2000,
                                           "Stability/Rotation": "true", "Contact/Speed": 10 * way, "Contact/Creepage x": 0.05 * way,
                                           "Rail/Pad offset": -0.039 * way}, output=f"turns{way}").table(TABLE) for way in (1, -1))
    assert abs(one.last("load_N/m") / other.last("load_N/m") - 1) <= 1e-4
    assert abs(one.last("growth_imaginary") / other.last("growth_imaginary") - 1) <= 1e-3


def test_given_forces_are_as_their_creepage(program, line):
    run = program(SCENE, COMMON, NO_PLOT, {"Contact/Creepage x": 0, "Contact/Longitudinal force": "-22e3"})
    assert 0.99 <= wave(run, 20, 0.02) / wave(line, 20, 0.02) <= 1.01


def test_entries_that_have_no_effect(program):
    program(SCENE, COMMON, NO_PLOT, {"Corrugation/Check amplitude": "1e-6"}, output="idle2",
            says="Corrugation/Check amplitude = 1e-6 has no effect")
    run = program(SCENE, COMMON, NO_PLOT, {"Stability/Count check": "false", "Stability/Damping margin": 0.1,
                                           "Stability/Lowest frequency": 1000}, output="idle",
                  says="Stability/Lowest frequency = 1000 has no effect: surfaces with waves give the frequencies themselves")
    for entry in ("Count check = false", "Damping margin = 0.1"):
        assert f"Stability/{entry} has no effect" in run.messages


NO_MODES = {"Modes/Maximum frequency": 400, "Modes/Cut-off ratio": 1.2, "Corrugation/Wavelengths": 0.11}
FIFTY = {"Corrugation/Check wavelength": 0.05}
FAST = {"Modes/Maximum frequency": 50000}


@pytest.mark.parametrize("settings, says", [
    ({"Corrugation/Wavelengths": "0.001, 0.1", **FAST}, "the shortest must have at least"),
    ({"Modes/Maximum frequency": 1000}, "Modes/Maximum frequency = 1000 Hz: waves of 20 mm at 40 m/s pass with 2000 Hz"),
    ({"Contact/Friction coefficient": 0}, "without friction nothing wears"),
    (NO_MODES, "has no mode below the cut-off"),
    ({**NO_MODES, "Wheel/Hub": "mass", "Wheel/Hub mass": 300, **REDUCED}, "whose axle moves, has no mode below the cut-off"),
    ({"Contact/Creepage x": 0}, "without creepage nothing wears"),
    ({"Contact/Speed": ""}, "Contact/Speed is empty"),
    ({"Corrugation/Wavelengths": "0, 0.1"}, "Corrugation/Wavelengths = 0, 0.1: 0 is among them"),
    ({"Corrugation/Wear coefficient": 0}, "Corrugation/Wear coefficient = 0: no wave would change"),
    ({**FIFTY, "Corrugation/Check amplitude": 0.01}, "Check amplitude = 0.01 m: on waves of Corrugation/Check wavelength = 0.05"),
    ({**FIFTY, "Corrugation/Check amplitude": 0}, "it must be above 0 and at most"),
    ({"Corrugation/Check wavelength": 0.005}, "Check wavelength = 0.005 m: at 40 m/s it passes with 8000 Hz"),
    ({"Corrugation/Check wavelength": 0.001, **FAST}, "Check wavelength = 0.001 m: elements along x are"),
    ({"Corrugation/Pad offsets": 0.1}, "the rail lies on no pads"),
    ({"Contact/Friction law": "exponential", "Contact/Friction decay speed": 1, "Contact/Kinetic friction coefficient": 0.2},
     "has a state of its own at each"),
])
def test_what_cannot_be(program, settings, says):
    run = program(SCENE, COMMON, settings, code=1, says=says, output="bad")
    assert not (run / TABLE).exists()


@pytest.mark.parametrize("settings, says", [
    ({"Corrugation/Pad offsets": "-0.039, 0.5"}, "Pad offset = 0.5"),
    ({"Wheel/Dampers": 8, "Wheel/Damper mass": 0.1, "Wheel/Damper radius": 0.15, "Wheel/Damper position": 0, "Wheel/Damper frequency": 1000,
      "Wheel/Damper damping ratio": 0.1}, "dampers are known on a wheel whose hub is held"),
])
def test_what_cannot_be_of_a_disc_on_its_axle(program, settings, says):
    run = program(SQUEAL, PADS, settings, code=1, says=says, output="bad")
    assert not (run / TABLE).exists() and not (run / "results.csv").exists(), "nothing is computed before"
