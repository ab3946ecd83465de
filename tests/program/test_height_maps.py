"""Maps of heights: a rough rail, what is told of it, moving maps, files that are refused."""

import math
import re

import pytest
from conftest import LIGHT, QUIET, RESUME, VALIDATE, same_files

ROUGH = ("rough_rail_3d", {"Mesh/Elements across patch": 24, "Output/Interface fields": "false", "Output/Plot": "false"})
FINER = {"Mesh/Elements across patch": 48}


@pytest.fixture(scope="module")
def rough(shared):
    return shared(*ROUGH, says="Of the rough surface the peak pressure is")


def test_a_rough_rail(rough):
    for text in ("121 by 91 heights (88.1 kB) 0.1 mm by 0.1 mm apart, 5 of them filled in", "about a plane with a mean of",
                 "mm along and 1.0", "belong to waves of 1.4", "area E* slope / N = 0"):
        assert text in rough.screen
    # cut-off of four elements
    assert 1.39e-3 <= rough.results.last("cut_off_wavelength_x_m") <= 1.40e-3
    assert 1.04e-3 <= rough.results.last("cut_off_wavelength_y_m") <= 1.06e-3
    assert 1e-3 <= rough.results.last("rms_slope") <= 3e-3


def test_more_waves_have_less_area_and_more_pressure(program, rough):
    finer = program(*ROUGH, FINER).results
    assert finer.last("contact_area_m2") < 0.995 * rough.results.last("contact_area_m2")
    assert finer.last("max_pressure_Pa") > 1.03 * rough.results.last("max_pressure_Pa")


def test_the_same_waves_on_more_elements(program):
    run = program(*ROUGH, FINER, {"Surfaces/Shortest wavelength": "1.4e-3"})
    assert 1e-3 <= run.results.last("rms_slope") <= 2.5e-3


def test_a_smooth_rail_has_no_cut_off(program):
    assert not any("cut_off_wavelength" in column for column in program(*ROUGH, {"Contact/Roughness": ""}).results.columns)


def test_stronger_steel_does_not_yield(program):
    run = program(*ROUGH, {"Wear/Shear yield stress": "500e6"})
    assert "peak pressure is" not in run.messages and "no effect" not in run.messages


def write_maps(folder, change=lambda text: text):
    """Maps of 75 mm whose lines are all alike, and one of them as a record; heights in um."""
    heights = [f"{5 * math.cos(2 * math.pi * 0.25 * (i - 150) / 15):.12g}" for i in range(301)]
    grid = "mm," + ",".join(str(0.5 * j) for j in range(-10, 11)) + "\n"
    sdf = "aISO-1.0\nNumPoints = 301\nNumProfiles = 31\nXscale = 0.25e-3\nYscale = 0.5e-3\nZscale = 1e-6\n*\n"
    (folder / "line.csv").write_text("".join(f"{0.25 * i}, {height}\n" for i, height in enumerate(heights)))
    (folder / "map.csv").write_text(grid + "".join(f"{0.25 * i}" + f",{height}" * 21 + "\n" for i, height in enumerate(heights)))
    (folder / "map.sdf").write_text(sdf + change((" ".join(heights) + "\n") * 31) + "*\n")


def one_height(text):
    """A map of which one height differs."""
    assert " 5 " in text
    return text.replace(" 5 ", " 5.1 ", 1)


def test_the_middle_line_of_a_map_is_a_record(program):
    write_maps(program.folder)

    def rolled(height, **how):
        return program("corrugation_2d", LIGHT, {
            "Time/Inertia": "false", "Surfaces/Position unit": "1e-3", "Surfaces/Height unit": "1e-6", "Surfaces/Position": 0.0135,
            "Time/Time step": "45e-6", "Time/Rolled distance": "9e-3", "Spectrum/Write": "never", "Surfaces/Rail height": height}, **how)

    record = rolled(program.folder / "line.csv", output="record").table("history.csv")
    assert len(record) >= 10 and max(record["normal_force_N"]) > 1.001 * min(record["normal_force_N"])
    for map_of in (f"grid: {program.folder / 'map.csv'}", program.folder / "map.sdf"):
        middle = rolled(f"middle line: {map_of}", output="middle").table("history.csv")
        for column in ("force_time_s", "rolled_m", "approach_m", "creepage_x", "creepage_y", "spin_1/m", "surface_height_m",
                       "normal_force_N", "force_x_N"):
            assert middle[column] == pytest.approx(record[column], rel=1e-7, abs=1e-9), column
    rolled(program.folder / "map.sdf", code=1, says="write `middle line:` in front of the map")


@pytest.fixture
def moving(program):
    """A scene that rolls over a map."""
    write_maps(program.folder)
    return "rail_roughness_3d", QUIET, {
        "Surfaces/Rail height": program.folder / "map.sdf", "Mesh/Elements across patch": 8, "Output/Plot": "false",
        "Spectrum/Write": "never", "Surfaces/Position": 0.02, "Spectrum/Segment length": 0}


def test_a_moving_map_is_resumed_unless_it_has_changed(program, moving):
    end = {"Time/Rolled distance": "8e-3"}
    whole = program(*moving, end, output="whole")
    program(*moving, {"Time/Rolled distance": "4e-3"}, output="half")
    write_maps(program.folder, one_height)
    program(*moving, end, output="half", options=RESUME, code=1, says="Surfaces/Rail height (record)")
    write_maps(program.folder)
    same_files(program(*moving, end, output="half", options=RESUME), whole, "history.csv")


def test_a_standing_map_in_time(program, moving):
    standing = (*moving, {"Surfaces/Rail height": "", "Contact/Roughness": program.folder / "map.sdf"})
    program(*standing, {"Time/Rolled distance": "1.6e-3"}, output="standing")
    write_maps(program.folder, one_height)
    program(*standing, {"Time/Rolled distance": "3.2e-3"}, output="standing", options=RESUME, code=1, says="Contact/Roughness (record)")


def entry(name, value):
    return lambda text: re.sub(f"(?m)^{name}.*", f"{name} = {value}", text)


@pytest.mark.parametrize("options", [(), VALIDATE], ids=["run", "validated"])
@pytest.mark.parametrize("file, change, says", [
    ("cut.sdf", lambda text: text[:20000], 'cut.sdf", line 58: it ends without a line of *'),
    ("counts.sdf", entry("NumPoints", 122), 'counts.sdf", line 106: there are 11011 heights'),
    ("huge.sdf", entry("NumPoints", 9999999999), "9999999999 times 91 points; at most 16777216 are read, as they take 134 MB"),
    ("zero.sdf", entry("Yscale", 0), 'zero.sdf", line 8: Yscale = 0: it is a number above 0'),
    ("nan.sdf", lambda text: re.sub(r"\A((?:.*\n){19})\S*", r"\1nan", text), 'nan.sdf", line 20: "nan" is no finite height'),
    ("steep.sdf", entry("Zscale", "1e-6"), "have a slope of"),
    ("short.sdf", entry("Xscale", "1e-6"), "it goes from -6e-05 to 6e-05 m"),
    ("cut.h5:/scan", lambda text: text[:20000], "is no file of HDF5"),
])
def test_maps_that_are_refused(program, file, change, says, options):
    text = (program.prm / "records/ground_rail.sdf").read_text()
    program.write(file.split(":")[0], change(text))
    program.refuses(ROUGH[0], says, ROUGH[1], {"Contact/Roughness": program.folder / file}, options=options)


@pytest.mark.parametrize("options", [(), VALIDATE], ids=["run", "validated"])
def test_files_that_are_no_map(program, options):
    (program.folder / "binary.sdf").write_bytes(program.path.read_bytes()[:9000])
    for value, says in ((program.folder / "binary.sdf", "is no beginning of a file after ISO 25178-71"),
                        (program.folder / "none.sdf", "there is no such file"),
                        (f"mirrored: {program.folder}/cut.csv", "stand in front of a map")):
        program.refuses(ROUGH[0], says, ROUGH[1], {"Contact/Roughness": value}, options=options)


@pytest.mark.parametrize("says, settings", [
    ("or come from a file is not known beforehand", {"Mesh/Target error": "1e-2"}),
    ("or a file of Contact/Roughness", {"Analysis": "accuracy study"}),
])
def test_what_a_rough_rail_does_not_do(program, says, settings):
    program.refuses(ROUGH[0], says, ROUGH[1], settings, options=VALIDATE)
