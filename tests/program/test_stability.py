"""Stability of a rolling state: the table, its picture, and what is refused."""

import math
import re

import pytest
from conftest import HERE, VALIDATE, documented

SCENE, PAIR = "carter_2d_full_slip", HERE / "pair.prm"
COMMON = {"Analysis": "stability", "Contact/Speed": 10, "Contact/Slip operator": "upwind 2", "Mesh/Elements across patch": 16,
          "Modes/Maximum frequency": 6000, "Wheel/Rayleigh mass": 40, "Rail/Rayleigh mass": 40}
S = ("frequency_Hz", "growth_1/s", "damping_ratio", "corrected_frequency_Hz", "corrected_growth_1/s")


@pytest.fixture(scope="module")
def damped(shared):
    return shared(SCENE, COMMON, output="damped")


def test_its_columns_are_documented(damped):
    documented(damped)


def test_damped_discs(damped):
    assert damped.has("stability.svg")
    assert "no vibration grows between 60 and 6000 Hz, as many as the argument principle counts" in damped.screen
    first = damped.table("stability.csv").records()[0]
    assert 60 <= first["frequency_Hz"] <= 6000
    growth = -first["damping_ratio"] * 2 * math.pi * first["frequency_Hz"]
    assert 0.999 <= first["growth_1/s"] / growth <= 1.001, "damping ratio and growth belong together"
    assert -30 <= first["growth_1/s"] <= -19, "not more than the bodies' damping"
    assert first["unstable"] == "false" and first["damping_needed"] == 0
    assert 0 <= first["backward_error"] <= 1e-4
    assert 1 <= first["wheel_mode"] <= 60
    assert re.fullmatch("[RC][0-9]+", first["wheel_mode_name"]), "its name, in the plane"
    assert 0.29 <= damped.results.last("traction_coefficient") <= 0.3


def test_bounds_are_those_of_the_steady_state(program, damped):
    alone = program(SCENE, COMMON, {"Analysis": "quasi-static"})
    for bound in ("bound_force/muN", "bound_normal_force", "bound_dissipation"):
        assert alone.results.texts(bound)[-1] == damped.results.texts(bound)[-1] != "", bound


def pair_of(program, output, *settings):
    """A small pair that vibrates by itself."""
    return program(PAIR, {"Analysis": "stability", "Stability/Count check": "false", "Output/Plot": "false"}, *settings, output=output)


def unstable(run):
    """The one vibration that grows or may grow."""
    row, = (row for row in run.table("stability.csv").records() if "true" in (row["unstable"], row["undecided"]))
    return row


@pytest.fixture(scope="module")
def pair(shared):
    return pair_of(shared, "as_it_is")


def test_a_wheel_by_its_section(program):
    """The modes it is given are not those of its mesh, whose compliance is counted once."""
    row = unstable(pair_of(program, "harmonic", {"Wheel/Model": "harmonic"}))
    assert 14 <= row["growth_1/s"] <= 15
    assert 0.998 <= row["growth_1/s"] / row["corrected_growth_1/s"] <= 1.002


def test_a_loss_factor_of_the_support(program):
    """It takes what it says at the frequency of the vibration, wherever Loss frequency is: viscous at 1846.2 Hz it is 30.3153 1/s.

    Modes lose each at its own frequency."""
    run = pair_of(program, "lossy", {"Rail/Foundation loss factor": 0.002, "Rail/Loss frequency": 50})
    row = unstable(run)
    assert 30.3 <= row["corrected_growth_1/s"] <= 30.33
    assert 0.91 <= row["growth_1/s"] / row["corrected_growth_1/s"] <= 0.93
    assert "Loss frequency = 50 has no effect" in run.messages


def test_correction_of_vibrations(pair):
    """The last change of s is the whole of it after one step; more steps make it smaller, and the error too."""
    table = pair.table("stability.csv")
    assert "true" in table.texts("unstable")
    kinds = set()
    for row in table.records():
        s, corrected = (complex(row[f"{name}growth_1/s"], 2 * math.pi * row[f"{name}frequency_Hz"]) for name in ("", "corrected_"))
        change, last = abs(corrected - s), row["uncertainty_1/s"]
        first, now = row["reduced_backward_error"], row["backward_error"]
        kinds.add(first == now)
        if first == now:
            assert abs(last - change) < 1e-8 * abs(s) and last <= 1e-7 * abs(s), row
        else:
            assert now < 0.1 * first < 1e-2 and 0 < last < 0.1 * change, row
    assert kinds == {True, False}


@pytest.mark.parametrize("settings", [
    {"Contact/Creepage y": 0.02},
    {"Contact/Creepage x": -0.05, "Contact/Speed": -10, "Rail/Pad offset": 0.039},
], ids=["across", "along"])
def test_mirror_images_have_the_same_eigenvalues(program, pair, settings):
    table, mirrored = pair.table("stability.csv"), pair_of(program, "mirrored", settings).table("stability.csv")
    assert len(table) == len(mirrored) >= 4
    for name in S:
        assert table[name] == pytest.approx(mirrored[name], rel=1e-6, abs=0), name


def test_no_friction_is_the_limit_of_little(program):
    """C = 10 / s M + 1e-7 s K of both: s^2 + (10 + 1e-7 omega^2) s + omega^2 = 0."""
    frequencies = []
    for mu in ("1e-9", "0"):
        table = pair_of(program, f"smooth_{mu}", {"Contact/Friction coefficient": mu}).table("stability.csv")
        frequencies.append(table["corrected_frequency_Hz"])
        assert len(table) >= 4
        assert set(table.texts("unstable")) == {"false"}
        for f, growth in zip(frequencies[-1], table["corrected_growth_1/s"]):
            assert abs(growth / (-(10 + 1e-7 * (2 * math.pi * f) ** 2) / 2) - 1) <= 2e-5, f"mu = {mu}: each growth is that of the damping"
    assert frequencies[1] == pytest.approx(frequencies[0], rel=1e-6, abs=0)


@pytest.mark.parametrize("settings, says", [
    ({"Contact/Speed": ""}, "Contact/Speed is empty"),
    ({"Contact/Slip operator": "galerkin"}, "must be `calibrated`, `upwind 2` or"),
    ({"Contact/Friction memory": 0, "Contact/Friction law": "exponential", "Contact/Kinetic friction coefficient": 0.2,
      "Contact/Friction decay speed": 0.2}, "Contact/Friction memory = 0"),
    ({"Stability/Lowest frequency": 0}, "Stability/Lowest frequency = 0"),
    ({"Body solver": "distributed"}, "modes are found with a factor"),
    ({"Mesh/Adaptive levels": 1}, "Mesh/Adaptive levels and Target error are not for it"),
])
def test_refused(program, settings, says):
    program.refuses(SCENE, says, COMMON, settings, options=VALIDATE)
