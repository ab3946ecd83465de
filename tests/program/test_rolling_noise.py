"""Rolling noise: tables, picture, what belongs together, and what is refused."""

import math
import re
import shutil

import pytest
from conftest import documented, same_files

SCENE = "squeal_small"
COMMON = {"Analysis": "rolling noise", "Contact/Creepage x": 0, "Contact/Creepage y": 0, "Contact/Slip operator": "calibrated",
          "Contact/Speed": 20}
ONE = {"Rolling noise/Speeds": 15, "Output/Plot": "false"}
LEVELS = {"levels.csv": "wavelength_m,level_dB\n0.4,10\n0.004,-10\n",
          "twice.csv": "wavelength_m,level_dB\n0.4,16.0205999\n0.004,-3.9794001\n"}  # 6.02 dB more
TABLE, SPEEDS = "rolling_noise.csv", "rolling_noise_speeds.csv"
TOTAL = "total_dBA_re_1pW"


def band(run, speed, frequency, column):
    """Of the row with this speed and the centre nearest to a frequency."""
    return min(run.table(TABLE).records(**{"speed_m/s": speed}), key=lambda row: abs(row["centre_frequency_Hz"] - frequency))[column]


def last(run, column=TOTAL):
    return run.table(SPEEDS).last(column)


def level(power):
    return 10 * math.log10(power)


def power(decibels):
    return 10 ** (decibels / 10)


@pytest.fixture(scope="module")
def two(shared):
    return shared(SCENE, COMMON, {"Rolling noise/Speeds": "30, 15"}, output="two")


def test_its_columns_are_documented(two):
    documented(two)


def test_bands(two):
    """From waves of 0.4 m (and half a third octave) up to 3150 Hz: 40 and 80 Hz."""
    rows = two.table(TABLE).records()
    assert two.table(SPEEDS)["speed_m/s"] == [15, 30], "the slow one first"
    assert len(rows) == 37
    assert 79 <= last(two, "lowest_band_Hz") <= 80 and 3150 <= last(two, "highest_band_Hz") <= 3170
    for row in rows:
        assert abs(row["speed_m/s"] / row["centre_frequency_Hz"] / row["wavelength_m"] - 1) <= 1e-8
        both = level(power(row["wheel_dB_re_1pW"]) + power(row["rail_dB_re_1pW"]))
        assert abs(both - row["total_dB_re_1pW"]) <= 1e-6
        assert row["load_N"] != 0 and abs(math.log10(row["load_N"] ** 2)) <= 6
    assert max(abs(math.log10(row["load_N"] ** 2)) for row in rows) >= 2.5
    # the limit: 4.9 dB at 0.1 m, -1.1 dB at 50 mm, straight in between
    assert 4.44 <= band(two, 15, 158, "roughness_dB_re_1um") <= 4.46


def test_levels(two):
    """A takes nothing of the band of 1 kHz, and 19 dB of that of 100 Hz.

    rho c W / (2 pi r^2) re 20 uPa and 1 pW: 7.5 m is 25.35 dB below the power."""
    assert abs(band(two, 30, 1000, TOTAL) - band(two, 30, 1000, "total_dB_re_1pW")) <= 0.1
    assert -19.4 <= band(two, 30, 100, TOTAL) - band(two, 30, 100, "total_dB_re_1pW") <= -18.5
    bands = two.table(TABLE).records(**{"speed_m/s": 30})
    assert abs(level(sum(power(row[TOTAL]) for row in bands)) - last(two)) <= 1e-4
    away = [row[TOTAL] - row["sound_pressure_dBA_re_20uPa"] for row in two.table(SPEEDS).records()]
    assert all(abs(difference) <= 25.4 for difference in away) and max(map(abs, away)) >= 25.3
    assert 0.1 <= last(two, "uncertainty_dB") <= 4
    assert re.search("at 30 m/s power of the wheel .* dB per decade of speed: radiation is an estimate to 3 dB", two.screen)
    assert re.search(r"sound power .* of itself \(estimate: elements of twice the length; .* dB, without", two.screen)


def test_the_curves_are_the_rows(two):
    assert two.has("rolling_noise.svg")
    total = band(two, 30, 1000, TOTAL)
    assert sum(999 < point[0] < 1001 and abs(point[1] - total) < 1e-4 for point in two.points("rolling_noise.dat")) == 1


def here(program, output, *settings, **how):
    """At one speed, with the scene and levels in its folder."""
    scene = shutil.copy(program.scene(SCENE), program.folder / "here.prm")
    for name, text in LEVELS.items():
        program.write(name, text)
    return program(scene, COMMON, ONE, *settings, output=output, **how)


@pytest.fixture(scope="module")
def rough_rail(shared):
    return here(shared, "rail", {"Rolling noise/Rail roughness": "levels.csv", "Rolling noise/Wheel roughness": ""})


def test_it_does_not_matter_who_is_rough(program, rough_rail):
    wheel = here(program, "wheel", {"Rolling noise/Wheel roughness": "levels.csv", "Rolling noise/Rail roughness": ""})
    same_files(rough_rail, wheel, TABLE)
    assert not (rough_rail / "rolling_noise.svg").exists(), "no picture where none is wanted"


def test_twice_as_rough(program, rough_rail):
    twice = here(program, "twice", {"Rolling noise/Rail roughness": "twice.csv"})
    assert 6.02059 <= last(twice) - last(rough_rail) <= 6.02061
    assert abs(last(twice, "load_N") / last(rough_rail, "load_N") - 2) <= 1e-5


def test_both_rough(program, rough_rail):
    both = here(program, "both", {"Rolling noise/Rail roughness": "levels.csv", "Rolling noise/Wheel roughness": "levels.csv"})
    assert 3.01029 <= last(both) - last(rough_rail) <= 3.01031


def test_filters(program, two):
    """What is alike across is felt as much as c = 0, and most at short waves."""
    patch, table = (here(program, name, {"Rolling noise/Contact filter": name, "Contact/Normal load": load})
                    for name, load in (("patch", 3035), ("table", 30e3)))
    same_files(here(program, "alike", {"Rolling noise/Coherence across": 0}), patch, TABLE)
    assert abs(band(patch, 15, 40, "contact_filter_dB")) <= 0.01
    # sin(k a) / (k a) of a half-width of 1.81 mm: -3.6 dB
    assert -4.5 <= band(patch, 15, 2000, "contact_filter_dB") <= -2.5
    assert -4 <= band(two, 15, 2000, "contact_filter_dB") - band(patch, 15, 2000, "contact_filter_dB") <= -1, "random waves are felt less"
    # 30 kN at 10 mm: between -16.8 and -17.7 dB
    assert -17.8 <= band(table, 15, 1585, "contact_filter_dB") <= -16.8, "the table of the directive"


def test_a_rigid_wheel_radiates_nothing(program):
    run = program(SCENE, COMMON, ONE, {"Wheel/Rigid": "true"})
    assert "power of the wheel nothing, the rail" in run.out
    assert run.table(SPEEDS).texts("wheel_dBA_re_1pW")[-1] == ""


def test_a_rail_without_ends_radiates_with_all_its_length(program):
    """However long its mesh is, and more than a wheel."""
    endless = {"Output/Plot": "false", "Rail/Shape": "section", "Rail/Mesh file": "sections/rail_2.msh", "Rail/Lateral radius": 0.3,
               "Rail/Cells along": 48, "Rail/Model": "waveguide", "Rail/Pad spacing": 0, "Rail/Foundation stiffness x": 5e7,
               "Rail/Foundation stiffness y": 5e7, "Rail/Foundation stiffness z": 3.3e8, "Rail/Foundation loss factor": 0.2,
               "Rail/Loss factor": 0.02, "Rail/Rayleigh mass": 0, "Rail/Elements": "enhanced", "Modes/Maximum frequency": 2000,
               "Modes/Cut-off ratio": 1.5}
    short, long = (program(SCENE, COMMON, endless, {"Rail/Block length": length}, output=f"endless{length}") for length in (1.2, 1.6))
    assert abs(last(short, "rail_dBA_re_1pW") - last(long, "rail_dBA_re_1pW")) <= 0.2
    assert 20 <= last(short, "rail_dBA_re_1pW") - last(short, "wheel_dBA_re_1pW") <= 45


def test_places_of_a_pad(program):
    """Powers in the mean, and how far they lie apart."""
    one, other, both = (here(program, f"pads{k}", {"Rolling noise/Pad offsets": offsets})
                        for k, offsets in enumerate(("-0.039", "-0.03", "-0.039, -0.03")))
    assert abs(level((power(last(one)) + power(last(other))) / 2) - last(both)) <= 1e-6
    apart = last(both, "range_over_bay_dB")
    assert abs(abs(last(one) - last(other)) - apart) <= 1e-6 and 0.01 <= apart <= 20
    assert "range_over_bay" not in other.text(SPEEDS), "one place has no range"


@pytest.mark.parametrize("settings, says", [
    ({**ONE, "Rolling noise/Contact filter": "table"}, "the load is 3035 N, and the tables are for 25 to 100 kN"),
    ({"Rolling noise/Rail roughness": ""}, "smooth bodies roll without noise"),
    ({"Rolling noise/Rail roughness": "rough"}, "Rolling noise/Rail roughness = rough: give"),
    ({"Rolling noise/Rail roughness": "nothing.csv"}, "nothing.csv"),
    ({"Rolling noise/Speeds": 2000}, "no third octave up to Modes/Maximum frequency = 4000 Hz has waves of"),
    ({"Rolling noise/Speeds": "0, 15"}, "Rolling noise/Speeds = 0, 15: 0 is among them"),
    ({"Sound/Density of air": 0}, "Sound/Density of air = 0"),
    ({"Surfaces/Rail height": "1e-6*sin(100*x)"}, "surfaces that pass"),
    ({"Rolling noise/Pad offsets": "0, 0.1", "Rail/Pad spacing": 0}, "the rail lies on no pads"),
])
def test_what_cannot_be(program, settings, says):
    program.refuses(SCENE, says, COMMON, settings)


def test_in_2d(program):
    program.refuses("carter_2d_partial_slip", "take Dimension = 3", {"Analysis": "rolling noise", "Contact/Speed": 20})
