"""Reversed flow, roughness, and the warning of large strains."""

from conftest import QUICK, near

DISCS = "carter_2d_partial_slip"


def test_reversed_flow_reverses_the_force(program):
    deep = {"Contact/Approach": 5e-4, "Mesh/Elements across patch": 24}
    forth = program(DISCS, QUICK, deep).results
    back = program(DISCS, QUICK, deep, {"Contact/Speed": -1, "Contact/Creepage x": -0.0017}).results
    near(forth.last("force_x_N"), -back.last("force_x_N"), 0, 1e-4)


def test_roughness_adds_to_the_gap(program):
    rough = program(DISCS, QUICK, {"Contact/Approach": 2.3e-4, "Contact/Roughness": "1e-5 + 0*x*y"}).results
    smooth = program(DISCS, QUICK, {"Contact/Approach": 2.2e-4}).results
    near(rough.last("normal_force_N") / smooth.last("normal_force_N"), 1, 1e-3)


def test_roughness_that_is_none(program):
    program.refuses(DISCS, "cannot be understood", {"Contact/Roughness": "2e-6*wave(x)"}, options=["--validate"])


def test_large_strains(program):
    program(DISCS, QUICK, {"Contact/Approach": 0.1}, says="beyond the small strains")
