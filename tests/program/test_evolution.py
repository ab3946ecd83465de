"""Wheels and rails that wear: files of an evolution against each other and against the law, how it ends, ranks, a run that was killed,
and what is refused."""

import math
import signal
import xml.etree.ElementTree as Xml

import pytest
import vtu
from conftest import RESUME, documented, near, same_files

SCENE = "wear_main_line"
TWO = """name, share, Wheelset/Curve radius, Contact/Speed
wide, 0.9, 4000, 40
narrow, 0.1, 900, 25
"""
FEW = {"Mesh/Elements across patch": 6}
ENERGY = {**FEW, "Evolution/Law": "t-gamma", "Evolution/Equal steps": 1}
ONE_STEP = {**ENERGY, "Evolution/Scheme": "explicit", "Evolution/Distance": 2e4}
ROLLED = 2 * math.pi * 0.46


def evolve(program, output, *settings, rows=TWO, **how):
    """With a file of rows."""
    return program(SCENE, *settings, {"Evolution/File of rows": program.write(f"{output}.csv", rows)}, output=output, **how)


def of_step(run, step=1, side="both"):
    return run.results.record(step=step, side=side)


def duty(run, row):
    return run.table("duty.csv").record(step=0, row=row)


def close(value, wanted, tolerance):
    assert abs(value / wanted - 1) < tolerance


@pytest.fixture(scope="module")
def first(shared):
    """One explicit step."""
    return evolve(shared, "first", ONE_STEP)


def test_its_columns_are_documented(first):
    documented(first)


def worn_area(run):
    """Of a passage, by the law of energy: the mean of both wheels, 5.3e-9 kg/J, 7850 kg/m^3."""
    energy = sum(share / 2 * duty(run, row)[f"{side}_creep_work_J/m"]
                 for row, share in (("wide", 0.9), ("narrow", 0.1)) for side in ("right", "left"))
    return energy * 5.3e-9 / 7850


def test_one_step_wears_what_the_law_of_energy_says(first):
    """Once a revolution."""
    close(of_step(first)["wheel_worn_area_m2"], worn_area(first) * 2e4 / ROLLED, 6e-3)
    files = "wheel_000.txt", "wheel_001.txt", "wheel.whl", "wheel.prw", "evolution.svg", "worn_wheel.svg"
    assert first.has(*files)
    assert all(f'"{file}"' in first.text("run.json") for file in files)
    assert abs(of_step(first, 0)["flange_height_m"] - 0.028) < 1e-7, "Sh of S1002"


def test_profiles_are_as_much_deeper(program, first):
    """They are read with their own axes."""
    new, worn = first.points("wheel_000.txt"), first.points("wheel_001.txt")
    depth, place = max(((math.dist(a[:2], b[:2]) * 1e-3, a[0] * 1e-3) for a, b in zip(new, worn, strict=True)), key=lambda pair: pair[0])
    step, narrow = of_step(first), duty(first, "narrow")
    assert abs(step["wheel_deepest_y_m"] - place) < 1e-7
    assert narrow["left_centre_of_wear_y_m"] < place < narrow["right_centre_of_wear_y_m"]
    close(step["wheel_depth_m"], depth, 1e-5)
    for file in ("wheel_001.txt", "wheel.whl", "wheel.prw"):
        again = program("contact_table", {"Profiles/Wheel profile": first / file, "Profiles/Smoothing length": 0}, output=f"again_{file}")
        close(again.table("contact_table.csv").record(lateral_shift_m=0.003)["conicity_harmonic"], step["conicity_harmonic"], 1e-5)


def test_picture_of_a_worn_wheel(first):
    """Depths over the place on the new profile, of the step, as the files of the profiles have them."""
    new, worn = first.points("wheel_000.txt"), first.points("wheel_001.txt")
    last = [line for line in first.text("worn_wheel.dat").strip("\n").split("\n\n\n")[-1].split("\n") if line]
    header, lines = [line for line in last if line[0] == "#"][-1], [line for line in last if line[0] != "#"]
    assert header.strip("# ").split("\t") == ["y, to the field side (mm)", "depth (mm)"]
    for line, a, b in zip(lines, new, worn, strict=True):
        place, depth = map(float, line.split())
        near(place, a[0], absolute=1e-4)
        near(depth, math.dist(a[:2], b[:2]), absolute=2e-4)


def test_two_rows_alike_are_one(program):
    """Each takes what the other wears as its own."""
    settings = {**ENERGY, "Evolution/Distance": 4e4, "Evolution/Smoothing": 0}
    one, alike = (of_step(evolve(program, name, settings, rows=f"share, Wheelset/Curve radius\n{rows}"))["wheel_depth_m"]
                  for name, rows in (("one", "1, 900\n"), ("alike", "0.5, 900\n0.5, 900\n")))
    close(alike, one, 0.01)
    assert one > 5e-6, "deep enough to be felt"


def check_film(run):
    """As deep as the table says, where it says."""
    rows = run.results.records()
    film = list(Xml.parse(run / "profiles.pvd").iter("DataSet"))
    assert len(film) >= len(rows) > 1 and len(film) % len(rows) == 0
    for number, one in enumerate(film):
        row = rows[number * len(rows) // len(film)]
        km, body = row["distance_m"] / 1e3, one.get("name").split("_")[0]
        side = -1 if one.get("name").endswith("left") else 1
        assert abs(float(one.get("timestep")) - km) <= 1e-8 * km
        fields, units = vtu.nodes(run / one.get("file"))
        assert units["depth"] == units["wear"] == "m"
        depth = max(fields["depth"])
        assert abs(depth - row[f"{body}_depth_m"]) < 1e-4 * depth + 1e-12
        if depth > 0:
            at = fields["depth"].index(depth)
            (_, y, _), (along, across, up) = fields["points"][at], fields["wear"][at]
            # wheels tell y from the tape circle, 1.5 m apart
            place = side * (y - across) - (0.75 if body == "wheel" else 0)
            assert abs(place - row[f"{body}_deepest_y_m"]) < 1e-4
            # off a wheel, which is above its rail
            assert along == 0 and (up if body == "wheel" else -up) > 0.9 * depth
            assert abs(math.hypot(across, up) - depth) < 1e-5 * depth


def test_curves_to_one_side(program, first):
    """The outer wheel, left in curves to the right, wears most; curves to the other side are the mirror image to the last digit."""
    settings = {**ONE_STEP, "Evolution/Both directions": "false"}
    sides = evolve(program, "sides", settings)
    right, left = (of_step(sides, side=side)["wheel_worn_area_m2"] for side in ("right", "left"))
    assert left > 2 * right > 0
    close((left + right) / 2, of_step(first)["wheel_worn_area_m2"], 5e-3)
    assert sides.has("wheel_001_left.txt", "wheel_right.whl")
    check_film(sides)
    mirrored = evolve(program, "mirrored", settings, rows=TWO.replace("4000", "-4000").replace("900", "-900"))
    assert of_step(mirrored, side="right")["wheel_worn_area_m2"] == left
    mine, others = duty(mirrored, "narrow"), duty(sides, "narrow")
    assert mine["lateral_shift_m"] == -others["lateral_shift_m"] and others["lateral_shift_m"] < -1e-3
    assert mine["curve_radius_m"] == -900
    assert mine["left_creep_work_J/m"] == others["right_creep_work_J/m"]


def test_a_rail(program, first):
    """Passages, and the wheel stays."""
    run = evolve(program, "rail", ONE_STEP, {"Evolution/Bodies": "rail", "Evolution/Distance": "", "Evolution/Passages": 7e3})
    close(of_step(run)["rail_worn_area_m2"], worn_area(first) * 7e3, 0.012)
    assert run.has("rail_001.txt") and not (run / "wheel_001.txt").exists()


def test_what_wheels_and_rails_of_a_bogie_lose_is_one_amount_of_energy(program):
    """3459.9 turns."""
    run = program("bogie_curve", ENERGY, {"Analysis": "profile evolution", "Evolution/Bodies": "both", "Evolution/Distance": 1e4,
                                          "Evolution/Passages": 3459.9, "Wheelset/Curve radius": 1000})
    for wheelset in ("leading", "trailing"):
        assert sum(wheelset in line for line in run.text("duty.csv").splitlines()) == 2
    close(of_step(run)["rail_worn_area_m2"], of_step(run)["wheel_worn_area_m2"], 5e-3)
    assert run.has("rail.prr", "wheel.prw", "worn_rail.svg")
    check_film(run)


STEPS = {**FEW, "Evolution/Distance": 9e6, "Evolution/Largest depth": 5e-5}


@pytest.fixture(scope="module")
def depth(shared):
    """Steps by the tolerance, to a depth."""
    return evolve(shared, "depth", STEPS)


def test_to_a_depth(depth):
    assert "Largest depth is reached" in depth.out
    last = depth.results.records()[-1]
    assert 5e-5 <= last["wheel_depth_m"] < 1e-4
    assert last["distance_m"] < 9e6 and last["step_error_m"] < 2e-5
    check_film(depth)


def test_a_run_that_is_killed_goes_on_on_other_ranks(program, depth):
    """And ends again when it had ended."""
    steps = {**STEPS, "Evolution/File of rows": program.write("two.csv", TWO)}
    run = program.start(SCENE, steps, output="killed")
    run.wait_until(lambda: b"Step 1," in run.files[0].read_bytes(), 300)
    run.send(signal.SIGKILL)
    run.end()
    assert '"done"' not in (run / "run.json").read_text(encoding="utf-8")
    rest = program(SCENE, steps, output="killed", options=RESUME, ranks=2)
    worn, wanted = ((row["wheel_worn_area_m2"] / row["distance_m"]) for row in (rest.results.records()[-1], depth.results.records()[-1]))
    close(worn, wanted, 0.15)
    assert of_step(rest)["wheel_depth_m"] == of_step(depth)["wheel_depth_m"], "it keeps what there was"
    assert "Largest depth is reached" in program(SCENE, steps, output="killed", options=RESUME).out


@pytest.mark.parametrize("ranks", [2, 3])
def test_the_same_files_whatever_the_number_of_ranks(program, depth, ranks):
    run = evolve(program, "depth", STEPS, ranks=ranks)
    same_files(run, depth, "results.csv", "duty.csv", "wheel.whl", "wheel_001.txt", "wheel_001.vtu", "profiles.pvd", "evolution_state.bin")


# the second row is that of the second rank, the third one of the first
THREE = """name, share, Wheelset/Curve radius, Wheelset/Load transfer
stays, 0.5, 4000, 0
second, 0.3, 2000, 70e3
third, 0.2, 900, 70e3
"""
LIFTING = TWO.replace("Contact/Speed", "Wheelset/Load transfer").replace(", 40\n", ", 0\n").replace(", 25\n", ", 70e3\n")


@pytest.mark.parametrize("rows, says", [(LIFTING, "Duty, narrow"), (THREE, "Duty, second")], ids=["of_the_second_rank", "the_lowest"])
def test_a_row_that_is_lifted_is_told(program, rows, says):
    run = evolve(program, "lifting", FEW, rows=rows, ranks=2, code=2, says=f"rolling-contact: {says}")
    assert sum(line.startswith("rolling-contact: ") for line in run.err.splitlines()) == 1


def test_three_rows_on_two_ranks(program):
    settings, rows = {**FEW, "Evolution/Equal steps": 1, "Evolution/Distance": 1e5}, THREE.replace("70e3", "1e3")
    same_files(evolve(program, "three2", settings, rows=rows, ranks=2), evolve(program, "three", settings, rows=rows),
               "results.csv", "duty.csv", "wheel.whl")


BODY = TWO.replace("Contact/Speed", "Wheelset/Left wheel radius").replace(", 40\n", ", 0.46\n").replace(", 25\n", ", 0.46\n")


@pytest.mark.parametrize("rows, settings, says", [
    (TWO.replace("0.9,", "0.8,"), {}, "the shares sum to 0.9"),
    (TWO.replace("4000", "5"), {}, "row 1: Wheelset/Curve radius = 5"),
    (TWO.replace("Contact/Speed", "Mesh/Growth"), {}, "Mesh/Growth is no column of a duty"),
    (TWO.replace("share", "part"), {}, "no column `share`"),
    (BODY, {"Evolution/Both directions": "false"}, "all rows wear the same wheels"),
    (None, {"Evolution/Distance": ""}, "Evolution/Distance is empty"),
    (None, {"Evolution/Bodies": "both"}, "Evolution/Passages is empty"),
    (None, {"Wheelset/Left wheel radius": 0.459}, "both sides wear alike"),
    (None, {"Profiles/Body sections": "true"}, "Body sections"),
    (None, {"Evolution/Law": "archard", "Contact/Speed": ""}, "archard asks for Contact/Speed or Wear/Archard"),
])
def test_refused(program, rows, settings, says):
    program.refuses(SCENE, says, settings, {"Evolution/File of rows": program.write("rows.csv", rows)} if rows else {}, output="refused")


def test_an_own_coefficient_needs_no_speed(program):
    program(SCENE, {"Evolution/Law": "archard", "Contact/Speed": "", "Wear/Archard coefficient": 1e-4}, options=("--validate",))


def test_a_wheelset_that_is_lifted(program):
    evolve(program, "lifting", FEW, {"Wheelset/Load transfer": "70e3"}, code=2, says="Duty, wide")
