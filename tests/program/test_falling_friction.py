"""Friction that falls with the sliding speed, and with the temperature that it makes."""

import re

import pytest
from conftest import COARSE, LIGHT, QUICK, RESUME, same_run

DISCS, HOT = "carter_2d_partial_slip", "friction_heat_3d"
FALL = {"Contact/Friction law": "exponential", "Contact/Kinetic friction coefficient": 0.12, "Contact/Friction decay speed": 1}
OVER = "Contact/Friction over temperature"


@pytest.mark.parametrize("scene, says, settings", [
    (DISCS, "Contact/Friction law = exponential and Contact/Speed is empty", FALL),
    (DISCS, "Contact/Kinetic friction coefficient = 0:", {**FALL, "Contact/Speed": 20, "Contact/Kinetic friction coefficient": 0}),
    (DISCS, "Contact/Speed = fast", {"Contact/Speed": "fast"}),
    (DISCS, "Friction law", {"Contact/Friction law": "magic"}),
    (HOT, "Contact/Speed is empty: how hot", {"Contact/Speed": ""}),
    ("oscillating_creepage_2d", "temperature of vibrating surfaces; leave it empty", {OVER: "293: 1, 600: 0.5"}),
    ("squeal_stability", "Analysis = stability cannot follow the temperature of vibrating surfaces", {OVER: "293: 1, 600: 0.5"}),
    (HOT, "20 K is colder than rails are; 0 degrees Celsius are 273.15 K", {OVER: "20: 1, 500: 0.5"}),
    (HOT, '"0.6" is not a pair. Give temperatures in K', {OVER: "300: 1, 0.6"}),
])
def test_refused(program, scene, says, settings):
    program.refuses(scene, says, settings)


def test_friction_that_rises(program):
    """mu = 0.4 + (0.1 - 0.4) exp(-20 0.02 / 0.1) = 0.3945 where all slides by 2 %, less the strain."""
    table = program(DISCS, QUICK, FALL, {"Contact/Speed": 20, "Contact/Friction coefficient": 0.1, "Contact/Creepage x": 0.02,
                                         "Contact/Kinetic friction coefficient": 0.4, "Contact/Friction decay speed": 0.1}).results
    assert 0.388 <= table.last("traction_coefficient") <= 0.3946


def fields(run):
    return re.findall('Name="([^"]*)"', (run / "interface.vtu").read_text(encoding="utf-8"))


def test_friction_that_falls(program):
    run = program("falling_friction_2d")
    # a half-plane with 768 elements has 0.65788 of mu_s N; discs differ by 3e-4
    assert 0.19716 <= run.results.last("traction_coefficient") <= 0.19756
    assert 2 <= run.results.last("friction_rounds") <= 30
    assert 0.1 <= run.results.last("several_solutions_ratio") <= 0.8
    assert "error_force_x/muN" not in run.results, "no comparison with Carter"
    assert '"they have constant friction"' in (run / "run.json").read_text(encoding="utf-8")
    assert {"sliding_speed", "friction_coefficient"} <= set(fields(run))


def test_constant_friction_has_no_fields_of_its_own(program):
    names = fields(program(DISCS, QUICK))
    assert names and "sliding_speed" not in names


def test_friction_that_falls_in_3d(program):
    run = program("falling_friction_3d", COARSE)
    # 0.55 (0.6 exp(-0.6 20 0.1) + 0.4) at the last creepage
    assert 0.3187 <= run.results.last("traction_coefficient") <= 0.3201
    assert 0.49 < max(run.results["traction_coefficient"]) < 0.52
    program("falling_friction_3d", output="fine")


STEEP = ("oscillating_creepage_2d", LIGHT, FALL, {"Time/Field interval": 20, "Time/Checkpoint interval": 5})


def test_friction_that_falls_in_time_may_have_several_solutions(program):
    whole = program(*STEEP, {"Time/End time": 60e-6}, output="whole", says="may have several solutions")
    assert re.search("Friction falls with the sliding speed of each node at once.* "
                     "neither smaller steps nor finer elements have a limit", whole.messages), whole
    told = (whole / "run.json").read_text(encoding="utf-8")
    assert "may have several solutions" in told and "of each node at once" in told
    program(*STEEP, {"Time/End time": 40e-6}, output="parts")
    for _ in ("the rest", "nothing is left"):
        parts = program(*STEEP, {"Time/End time": 60e-6}, output="parts", options=RESUME)
        same_run(parts, whole)
        for column in ("force_x_N", "stick_area_m2"):
            assert parts.results.texts(column)[-1] == whole.results.texts(column)[-1]


def test_friction_that_remembers_has_nothing_to_complain_of(program):
    run = program(*STEEP, {"Contact/Friction memory length": 5e-6, "Time/End time": 20e-6})
    assert "of each node at once" not in run.messages


@pytest.fixture(scope="module")
def hot(shared):
    """Friction that follows the temperature."""
    return shared(HOT, {"Mesh/Elements across patch": 8}, output="hot")


def test_hot_friction_follows(hot):
    assert re.search("^heat   surfaces of 293.1 to 43[0-9].* K, mu from 0.3 to 0.2[78]", hot.out, re.M), hot
    table = hot.results
    assert 141 <= table.last("flash_temperature_K") <= 149
    assert 0.291 <= table.last("traction_coefficient") <= 0.296
    assert 3 <= table.last("friction_rounds") <= 20
    assert table.texts("bound_force/muN")[-1] == "", "no bound is known"
    assert "friction_coefficient" in fields(hot)
    assert "shen_force_x_N" not in table, "no closed forms of one mu"


def test_friction_that_does_not_follow(program):
    table = program(HOT, {"Mesh/Elements across patch": 8, OVER: ""}).results
    # 1 m/s of sliding at 30 m/s, half of 30 kW for each body
    assert 14950 <= table.last("heat_to_wheel_W") <= 15050
    # the fast semi-elliptic source of 0.3 p_0 1 m/s / 2 = 115.6 W/mm^2: 150.3 K and what elasticity slides
    assert 147 <= table.last("flash_temperature_K") <= 156
    assert "shen_force_x_N" in table


def test_temperatures_of_warm_bodies_add_up_from_their_mean(program):
    table = program(HOT, {"Mesh/Elements across patch": 8, "Wheel/Temperature": 450, "Rail/Temperature": 300}).results
    assert 505 <= table.last("surface_temperature_K") <= 525


def test_friction_that_would_fall_like_a_stone(program):
    program(HOT, {"Mesh/Elements across patch": 8, OVER: "293: 1, 380: 1, 380.001: 0.01"}, code=2,
            says="friction and the temperature of the surfaces did not settle")
