"""A wheel over a dip at several speeds: rows, history, picture, what belongs together, and what is refused."""

import pytest
from conftest import charts, documented, summary_has

SCENE = "corrugation_2d"
BODIES = {"Time/Bodies": "reduced", "Time/Theta": 0.5, "Contact/Friction coefficient": 0, "Surfaces/Rail height": "",
          "Surfaces/Wheel height": "dip : 0.04, 30e-6", "Surfaces/Position": -0.06, "Time/Rolled distance": 0.2,
          "Modes/Maximum frequency": 4000, "Mesh/Elements across patch": 12, "Mesh/Candidate zone": 4}
COMMON = {**BODIES, "Analysis": "impact", "Impact/Speeds": "20, 5"}
HISTORY = "impact_history.csv"


@pytest.fixture(scope="module")
def two(shared):
    return shared(SCENE, COMMON, output="two")


def test_its_columns_are_documented(two):
    documented(two)


def test_two_speeds(two):
    slow, fast = two.results.records()
    assert two.results.texts(two.results.columns[0])[0] == "5", "the slow one first"
    summary_has(two, "largest load")
    assert fast["n_steps"] == 500 and fast["time_step_s"] == 2e-5
    assert 1 <= fast["largest_load_error_N"] <= 400
    assert 1e4 <= fast["largest_pressure_error_Pa"] <= 5e7
    for row in (slow, fast):
        assert abs(row["largest_load_N"] / row["load_at_rest_N"] / row["largest_load/at_rest"] - 1) <= 1e-8
        assert abs(row["largest_pressure_Pa"] / row["pressure_at_rest_Pa"] / row["largest_pressure/at_rest"] - 1) <= 1e-8
    charts("impacts", two.folder)


def test_rows_are_those_of_runs_in_time(program, two):
    for row, speed in zip(two.results.records(), (5, 20)):
        history = program(SCENE, BODIES, {"Contact/Speed": speed}, output=f"time{speed}").table("history.csv")
        loads = history["normal_force_N"]
        assert abs(row["largest_load_N"] / max(loads) - 1) <= 1e-6
        assert abs(row["least_load_N"] / min(loads) - 1) <= 1e-6
        assert abs(row["largest_pressure_Pa"] / max(history["max_pressure_Pa"]) - 1) <= 1e-6
    assert abs(row["largest_load_at_m"] - history["rolled_m"][loads.index(max(loads))]) <= 1e-9, "at 20 m/s"


def test_history_of_the_worst(two):
    """The dip is as deep as it is in its middle."""
    history = two.table(HISTORY)
    heights = history["surface_height_m"]
    assert len(history) == 500
    assert abs(two.results.last("largest_load_N") / max(history["normal_force_N"]) - 1) <= 1e-8
    assert 0.0599 <= history["rolled_m"][heights.index(min(heights))] <= 0.0604
    assert -30.1e-6 <= min(heights) <= -29.9e-6


def test_the_error_holds_what_steps_of_half_the_length_find(program, two):
    short = program(SCENE, COMMON, {"Time/Time step": 10e-6, "Output/Plot": "false"}, output="short")
    for row, shorter in zip(two.results.records(), short.results.records(), strict=True):
        assert abs(row["largest_load_N"] - shorter["largest_load_N"]) <= row["largest_load_error_N"]
        assert abs(row["largest_pressure_Pa"] - shorter["largest_pressure_Pa"]) <= row["largest_pressure_error_Pa"]
    assert not (short / "impacts.svg").exists(), "no picture where none is wanted"


MASS = {"Wheel/Hub": "mass", "Wheel/Hub mass": 50, "Wheel/Hub inertia y": 1}


def test_an_axle_that_is_free_to_move(program, two):
    """It feels less of a slow dip than a hub that is held, and falls towards the rail."""
    run = program(SCENE, COMMON, MASS, {"Impact/Speeds": 5})
    assert 100 <= run.results.last("least_load_N") - two.results["least_load_N"][0] <= 1e9
    assert -1 <= min(run.table(HISTORY)["wheel_velocity_m/s"]) <= -1e-4


def test_contact_that_is_lost(program):
    run = program(SCENE, COMMON, MASS, {"Impact/Speeds": 30, "Surfaces/Wheel height": "dip : 0.04, 0.4e-3"})
    assert 1e-4 <= run.results.last("parted_s") <= 0.1
    assert run.results.last("least_load_N") == 0
    assert "contact is lost from 30 m/s on" in run.screen


def test_a_flat(program):
    """The wheel turns about its edges."""
    run = program(SCENE, COMMON, {"Surfaces/Wheel height": "flat : 0.02", "Impact/Speeds": 5}, says="pressures on the edges of a fresh flat")
    assert -108.8e-6 <= min(run.table(HISTORY)["surface_height_m"]) <= -108e-6


LOAD = {"Contact/Approach": "", "Contact/Normal load": 1e5}


@pytest.mark.parametrize("settings, says", [
    ({"Surfaces/Wheel height": ""}, "give a flat, a dip"),
    ({"Time/Bodies": "full"}, "take Time/Bodies = reduced"),
    (LOAD, "the load stays what it is"),
    ({"Surfaces/Position": 0}, "is under the wheel at the start"),
    ({"Time/Rolled distance": 0.03}, "m before the middle of Surfaces/Wheel height"),
    ({"Impact/Speeds": "0, 15"}, "Impact/Speeds = 0, 15: 0 is among them"),
    ({"Time/Time step": 4e-3}, "m/s has 3 steps of"),
    ({"Wheel/Cover thickness": 0.01}, "take covers; for impact set it to 0 m"),
    ({"Surfaces/Rail height": "flat : 0.03", "Surfaces/Wheel height": ""}, "a flat is that of a disc"),
    ({"Surfaces/Wheel height": "dip : 1e-3, 1e-6"}, "shorter than eight elements"),
    ({"Surfaces/Wheel height": "flat : 0.8"}, "longer than a quarter of a turn"),
    ({"Surfaces/Wheel height": "dip : 0.1"}, "give length and depth of the dip"),
    ({"Analysis": "transient", **MASS, **LOAD}, "nothing moves the axle"),
    ({"Analysis": "transient", **MASS, "Time/Approach": 1e-4}, "would move the axle"),
])
def test_what_cannot_be(program, settings, says):
    program.refuses(SCENE, says, COMMON, settings)
