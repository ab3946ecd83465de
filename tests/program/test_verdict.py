"""Which pair squeals, in words: thresholds of friction, creepages and damping against runs of their own on both sides,
by the whole bodies."""

import math
import re

import pytest
from conftest import VALIDATE, same_files

SCENE = "squeal_small"


def pair(program, output, *settings):
    return program(SCENE, {"Analysis": "stability", "Stability/Count check": "false", "Output/Plot": "false", "Modes/Animated modes": 0},
                   *settings, output=output)


def threshold(run, quantity, direction):
    """The row of a quantity that is changed upwards (1) or downwards (-1)."""
    found = [row for row in run.table("thresholds.csv").records(quantity=quantity) if (row["followed_to"] - row["now"]) * direction > 0]
    assert len(found) == 1
    return found[0]


def n_unstable(run):
    """Those that may be unstable too."""
    return sum("true" in (row["unstable"], row["undecided"]) for row in run.table("stability.csv").records())


def has_line(page, pattern):
    return re.search(f"^{pattern}", page, re.M) is not None


@pytest.fixture(scope="module")
def squeals(shared):
    return pair(shared, "as_it_is")


def test_the_verdict_is_a_page(squeals):
    page = squeals.text("verdict.md")
    assert re.search(r"cures least change: friction 0\.[0-9]* \+- 0\.[0-9]* in place of 0.41", squeals.screen), "the strongest cure is first"
    assert has_line(page, "# It squeals") and has_line(page, r"\| friction \| 0.41 \|")
    name = squeals.table("stability.csv").record(unstable="true")["wheel_mode_name"]
    assert has_line(page, rf"\| {re.escape(name)} \| [0-9.]* \| [0-9.]* \| [0-9.e-]* \| 0.00[0-9]* \|"), "growth, its change and damping"


def test_shares_and_order_of_thresholds(squeals):
    """Shares are of the value, and of all creepage; the page has them by their shares."""
    rows = squeals.table("thresholds.csv").records()
    assert [row["quantity"] for row in rows] == ["friction", "lateral creepage", "longitudinal creepage", "longitudinal creepage",
                                                 "added damping"]
    for row in rows:
        now, at, u = row["now"], row["threshold"], row["uncertainty"]
        assert row["found"] == "true" and 0 < u < 0.1 * abs(at), row
        assert abs(abs(row["stable_from"] - at) / u - 1) < 1e-6, row
        if row["share"]:
            whole = math.hypot(0.05, 0.02) if at > now > 0 else now
            assert abs(abs(at - now) / abs(whole) - row["share"]) < 1e-6, row
    assert rows[-1]["share"] == ""
    page = [float(line.split("|")[3]) for line in squeals.text("verdict.md").splitlines()
            if line.startswith(("| fric", "| l", "| added"))]
    assert page == [float(f"{row['threshold']:.4g}") for row in sorted(rows, key=lambda row: row["share"] or 9)]


@pytest.mark.parametrize("quantity, direction, entry", [
    ("friction", -1, "Contact/Friction coefficient"),
    ("lateral creepage", 1, "Contact/Creepage y"),
    ("longitudinal creepage", 1, "Contact/Creepage x"),
    ("longitudinal creepage", -1, "Contact/Creepage x"),
    ("added damping", 1, "Stability/Added damping"),
])
def test_the_cured_pair_is_stable_the_one_not_quite_cured_is_not(program, squeals, quantity, direction, entry):
    row = threshold(squeals, quantity, direction)
    at, stable = row["threshold"], row["stable_from"]
    no_thresholds = {"Stability/Thresholds": "false"}
    assert n_unstable(pair(program, "cured", {entry: stable}, no_thresholds)) == 0
    assert n_unstable(pair(program, "less", {entry: f"{2 * at - stable:.9g}"}, no_thresholds)) == 1


def test_a_stable_pair_is_told_what_would_start_it(program, squeals):
    run = pair(program, "stable", {"Contact/Friction coefficient": 0.12})
    assert "onset begins at friction" in run.screen
    assert has_line(run.text("verdict.md"), "# It does not squeal")
    end, onset = threshold(squeals, "friction", -1), threshold(run, "friction", 1)
    assert abs(end["threshold"] - onset["threshold"]) <= end["uncertainty"] + onset["uncertainty"], "onset and end of growth over friction"
    creepage = threshold(run, "lateral creepage", -1)
    assert creepage["found"] == "false" and creepage["followed_to"] == -0.04, "followed to twice the creepage"


def test_thresholds_are_left_out(program, squeals):
    run = pair(program, "without", {"Stability/Thresholds": "false"})
    assert not (run / "thresholds.csv").exists() and run.has("verdict.md")
    same_files(run, squeals, "stability.csv")


def test_without_friction_there_are_no_thresholds(program):
    run = pair(program, "smooth", {"Contact/Friction coefficient": 0})
    assert not (run / "thresholds.csv").exists() and has_line(run.text("verdict.md"), "# It does not squeal")


def test_a_map_has_no_thresholds(program):
    program(SCENE, {"Analysis": "stability map", "Table/Axis 1": "Contact/Friction coefficient = 0.2, 0.41", "Stability/Thresholds": "false"},
            options=VALIDATE, says="Stability/Thresholds = false has no effect")
