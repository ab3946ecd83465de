"""Rigid contact of profiles: the table, its pictures, files and what is refused."""

import re

import pytest
from conftest import charts, documented, near, same_files, written

TABLE = "contact_table"
WORN = {"Profiles/Wheel profile": "profiles/worn_wheel.txt"}


def at(run, column, shift):
    """The number in the row of a lateral shift in mm."""
    table = run.table("contact_table.csv")
    (found,) = [value for value, its in zip(table[column], table["lateral_shift_m"]) if abs(its - shift / 1e3) < 1e-8]
    return found


@pytest.fixture(scope="module")
def nominal(shared):
    return shared(TABLE)


def test_its_columns_are_documented(nominal):
    documented(nominal)


@pytest.fixture(scope="module")
def worn(shared):
    return shared(TABLE, WORN, output="worn")


def points(program):
    """Those of the worn wheel."""
    lines = (program.prm / "profiles/worn_wheel.txt").read_text(encoding="utf-8").splitlines()
    return [tuple(map(float, line.split())) for line in lines if not line.startswith("#")]


def profile(program, name, lines):
    """A wheel profile of one's own."""
    return {"Profiles/Wheel profile": program.write(name, "".join(f"{y:.6g} {z:.6g}\n" for y, z in lines))}


def test_files_and_summary_of_nominal_profiles(nominal):
    assert len(nominal.table("contact_table.csv")) == 81
    written(nominal, "contact_points.svg", "gaps.svg", "steering.svg")
    charts("contact_table", nominal.folder)
    assert "conicity 0.17" in nominal.screen
    assert "flange height Sh 28 mm, thickness Sd 32.5 mm, qR 10.79" in nominal.screen


def test_a_table_for_the_screen(nominal):
    """Some twenty shifts, and where the others are."""
    table = nominal.table("contact_table.csv")
    stride, n = map(int, re.search(r"One shift in (\d+) is shown; all (\d+) are in contact_table.csv", nominal.screen).groups())
    assert n == len(table) and 10 <= n / stride <= 21
    shown = nominal.screen[nominal.screen.index("lateral_shift_m"):nominal.screen.index("One shift in")].split()
    assert shown[0] == "lateral_shift_m" and shown[3] == "conicity_en_15302"
    assert list(map(float, shown[4::4])) == [float(f"{shift:.4g}") for shift in table["lateral_shift_m"][::stride]]
    assert list(map(float, shown[6::4])) == [float(f"{change:.4g}") for change in table["rolling_radius_difference_m"][::stride]]


@pytest.mark.parametrize("shift, column, low, high", [ # tread, flange root, flange
    (2, "height_m", 0.0001312, 0.0001318), (2, "roll_rad", -1.1380e-4, -1.1365e-4),
    (2, "right_y_wheel_m", -0.010808, -0.010794), (2, "right_y_rail_m", -0.01930, -0.01927), # from the top of the rail
    (2, "right_y_track_m", 0.741240, 0.741265), (2, "left_y_track_m", -0.756680, -0.756655),
    (2, "right_angle_rad", -0.07872, -0.07860), (2, "left_angle_rad", -0.01290, -0.01286),
    (2, "right_rolling_radius_m", 0.460583, 0.460585), (2, "left_rolling_radius_m", 0.459806, 0.459808),
    (2, "right_spin_1/m", 0.1700, 0.1712), (2, "left_spin_1/m", -0.02810, -0.02796),
    (2, "right_rail_lateral_radius_m", 0.0799, 0.0801), (2, "rolling_radius_difference_m", 7.75e-4, 7.79e-4),
    (7, "right_angle_rad", -1.0735, -1.0722), (-7, "left_angle_rad", -1.0735, -1.0722), # the same on the left
    (7, "right_wheel_lateral_radius_m", 0.0199, 0.0201), # convex
    (3, "conicity_harmonic", 0.177, 0.181), (3, "conicity_en_15302", 0.174, 0.181)])
def test_against_an_independent_program(nominal, shift, column, low, high):
    assert low <= at(nominal, column, shift) <= high


def test_conicity_of_an_inclination_of_1_in_20(program):
    run = program(TABLE, {"Profiles/Rail inclination": "1/20"})
    assert 0.009 <= at(run, "conicity_harmonic", 3) <= 0.010


def test_a_measured_wheel(worn):
    """A hollow of 0.6 mm: the contact at 0 leaves it, and the radius is the worn one."""
    assert 0.4585 <= at(worn, "left_rolling_radius_m", 0) <= 0.4605
    assert "5 um of noise in a file" in worn.screen, "what noise does"


def test_yaw_moves_the_flange_along_the_rail(program):
    """By r tan(yaw) tan(1.0626), the wheel's slope there, less 0.709 m sin(yaw)."""
    run = program(TABLE, {"Profiles/Yaw": 0.01, "Contact table/Lateral shift": "0, 0.007"})
    assert 0.00148 <= at(run, "right_x_m", 7) <= 0.00152


def test_a_wheel_upside_down(program, worn):
    up = profile(program, "up.txt", [(y, -z) for y, z in points(program)])
    program.refuses(TABLE, "set Profiles/Wheel mirror = z", up)
    same_files(program(TABLE, up, {"Profiles/Wheel mirror": "z"}), worn, "contact_table.csv")


def test_a_wheel_whose_tape_circle_is_elsewhere_in_the_file(program, worn):
    moved = profile(program, "moved.txt", [(y + 3, z) for y, z in points(program)])
    run = program(TABLE, moved, {"Profiles/Wheel profile shift": -0.003})
    assert 0.4585 <= at(run, "left_rolling_radius_m", 0) <= 0.4605
    near(at(run, "right_y_wheel_m", 3), at(worn, "right_y_wheel_m", 3), 0, 1e-7)
    near(at(run, "conicity_en_15302", 3), at(worn, "conicity_en_15302", 3), 0, 1e-6)
    program(TABLE, moved, {"Profiles/Wheel profile shift": 3}, code=1,
            says="Profiles/Wheel profile shift = 3: give it in m, from -0.2 to 0.2")
    commas = program.write("commas.txt", (program.folder / "moved.txt").read_text(encoding="utf-8").replace(".", ","))
    program(TABLE, {"Profiles/Wheel profile": commas}, code=1,
            says="has decimal commas; decimals take a point: convert the file, as by `tr , . <OLD >NEW`")


@pytest.mark.parametrize("rail", ["60E2", "54E1", "54E3", "49E1"])
def test_narrower_heads_keep_the_clearance_of_the_flange(program, rail):
    """For the width of the gauge stays."""
    assert -1.12 <= at(program(TABLE, {"Profiles/Rail profile": rail}), "right_angle_rad", 7) <= -1.05


@pytest.fixture(scope="module")
def difference(shared, nominal):
    """Settings of a difference of rolling radii from a file, in m."""
    table = nominal.table("contact_table.csv")
    rows = zip(table.texts("lateral_shift_m"), table.texts("rolling_radius_difference_m"))
    file = shared.write("dr.csv", "".join(f"{y}; {dr}\n" for y, dr in rows))
    return {"Contact table/Rolling radius difference": file, "Contact table/File unit": 1}


def test_the_conicity_of_a_difference_from_a_file(program, nominal, difference):
    run = program(TABLE, difference)
    found, wanted = run.table("contact_table.csv"), nominal.table("contact_table.csv")
    assert found.columns[1:4] == wanted.columns[-3:] and len(found) == len(wanted)
    for column in wanted.columns[-3:]:
        assert [text == "" for text in found.texts(column)] == [text == "" for text in wanted.texts(column)]
        assert all(abs(x - y) <= 1e-7 for x, y in zip(found[column], wanted[column]) if x == x)
    written(run, "steering.svg")
    assert "conicity 0.17" in run.screen


def test_entries_without_effect(program, difference):
    for says, settings in [
            ("has no effect: a scene without Contact table/Rolling radius difference reads that section",
             {**difference, "Profiles/Rail profile": "54E1"}),
            ("Contact table/Lateral shift = 0, 1e-3 has no effect", {**difference, "Contact table/Lateral shift": "0, 1e-3"}),
            ("Contact table/File unit = 1 has no effect", {"Contact table/File unit": 1}),
            ("Contact/Creepage x = 0.001 has no effect", {"Contact/Creepage x": 0.001})]:
        program(TABLE, settings, says=says, options=["--validate"])


@pytest.mark.parametrize("says, settings", [
    ("Contact table/Rolling radius difference = none.csv", {"Contact table/Rolling radius difference": "none.csv"}),
    ("Check Contact table/File unit", {"Contact table/File unit": 1, "Contact table/Rolling radius difference": "profiles/worn_wheel.txt"}),
    ("there is no such file", {"Profiles/Rail profile": "none.txt"}), ("Profiles/File unit", {**WORN, "Profiles/File unit": 1}),
    ("Profiles/Rail inclination = 40", {"Profiles/Rail inclination": 40}), ("Profiles/Gauge = 1435", {"Profiles/Gauge": 1435}),
    ("Contact table/Lateral shift contains -8", {"Contact table/Lateral shift": "-8:8:81"})])
def test_what_is_refused(program, says, settings):
    program.refuses(TABLE, says, settings)


def test_a_wheel_beside_the_rail(program):
    program(TABLE, {"Profiles/Gauge": 2}, code=1, says="the wheel is not above the rail")
