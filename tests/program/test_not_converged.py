"""A solver that does not converge."""

import re
import shutil

import pytest
from conftest import QUICK, near

DISCS = "carter_2d_partial_slip"
FIXED_POINT = {"Contact/Solver": "fixed point"}
STOPS = {**FIXED_POINT, "Contact/Maximal iterations": 10}


@pytest.fixture(scope="module")
def stopped(shared):
    """The fixed point in partial slip."""
    return shared(DISCS, QUICK, FIXED_POINT, {"Contact/Slip operator": "galerkin", "Contact/Maximal iterations": 200},
                  code=2, says="did not converge", output="stopped")


def test_what_is_left_of_a_run_that_did_not_converge(stopped):
    assert stopped.results.texts("converged")[-1] == "false"
    for column in ("normal_force_N", "force_x_N", "traction_coefficient", "max_pressure_Pa"):
        assert stopped.results.texts(column)[-1] == ""
    assert "Not converged" in (stopped / "tractions.svg").read_text(encoding="utf-8")
    assert len(stopped.table("residuals.csv")) == 200
    assert stopped.json["status"] == "not converged"


def test_the_fixed_point_solves_full_slip(program):
    program(DISCS, QUICK, FIXED_POINT, {"Contact/Creepage x": 0.05, "Contact/Tolerance": 1e-6})


def test_a_force_above_that_of_falling_friction(program):
    """The state that it names as the closest has that force."""
    run = program("falling_friction_2d", QUICK, {"Contact/Creepage x": "", "Contact/Longitudinal force": 38000}, code=2)
    told = re.search(r"no state with Longitudinal force = 38000 N was found; the closest has Longitudinal force = (\S+) N at creepages "
                     r"(\S+), 0 and spin 0 1/m\. Friction falls with the sliding speed: give less\.", run.messages)
    force, creepage = map(float, told.groups())
    assert 20000 < force < 38000 and -0.01 < creepage < 0
    found = program("falling_friction_2d", QUICK, {"Contact/Creepage x": creepage}, output="found").results
    near(found.last("force_x_N"), force, 1e-3)


@pytest.mark.parametrize("curve, says", [("load", "Load curve, the largest load"), ("creep", "Creep curve, the state to start from")])
def test_a_curve_from_nothing(program, curve, says):
    program(DISCS, QUICK, STOPS, {"Analysis": f"{curve} curve"}, code=2, says=says)


@pytest.mark.parametrize("curve", ["load", "creep"])
def test_a_curve_of_rough_bodies_apart(program, curve):
    program(DISCS, QUICK, {"Analysis": f"{curve} curve", "Contact/Roughness": 1e-3}, code=1, says="needs contact")


def test_a_run_folder_is_replaced(program, stopped):
    shutil.copytree(stopped.folder, program.folder / "stopped")
    run = program(DISCS, QUICK, output="stopped")
    assert not (run / "residuals.csv").exists()
