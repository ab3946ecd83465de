"""Creep curves and load curves, in 2D and 3D."""

import math
import re

import pytest
from conftest import COARSE, QUICK, QUIET, summary_has

DISCS = "carter_2d_partial_slip"
CROWN = """
set Dimension = 3
set Analysis = creep curve
subsection Wheel
  set Hub radius = 0.10
  set Width      = 0.08
end
subsection Rail
  set Young modulus  = 70e9
  set Shape          = block
  set Radius         = 0
  set Lateral radius = 0.3
  set Block length   = 0.3
  set Block depth    = 0.16
  set Width          = 0.08
end
subsection Contact
  set Normal load = 100e3
end
subsection Mesh
  set Elements across patch = 12
  set Patch offset = 0 # here the first points fit into the zone
  set Growth = 1
end
subsection Creep curve
  set Creepage y = 0.0005, 0.004, 0.01
end
"""


def test_creep_curve(program):
    run = program("lateral_3d_creep_curve", COARSE)
    summary_has(run, "of mu N (estimate: ")
    assert len(run.results) == 20
    assert (run / "creep_curve.svg").stat().st_size > 0


def test_creep_curve_in_2d_ends_in_full_slip(program):
    run = program(DISCS, QUICK, {"Analysis": "creep curve", "Creep curve/Creepage x": "0 : 0.008 : 9"})
    assert 0.2999 <= run.results.last("traction_coefficient") <= 0.3


def test_stiffness_is_that_of_hertz_and_the_bulk(program):
    """1/k less Hertz's, 2 approach/(3 N), is the bulk's, whatever the load."""
    run = program("load_curve_3d", {"Load curve/Shares of load": "0.2 : 1 : 5"})
    table = run.results
    assert (run / "load_curve.svg").stat().st_size > 0
    soft = [1 / k for k in table["contact_stiffness_N/m"]]
    bulk = [a - 2 / 3 * d / n for a, d, n in zip(soft, table["reference_approach_m"], table["normal_force_N"])]
    assert len(bulk) == 5 and min(bulk) > 0
    assert max(bulk) - min(bulk) < 0.04 * soft[-1]


def test_stiffness_in_2d_is_that_of_clamped_discs(program):
    """k against the difference quotient of the exact load."""
    table = program(DISCS, QUICK, {"Analysis": "load curve", "Load curve/Shares of load": "0.5 : 1 : 11"}).results
    k, d, n = table["contact_stiffness_N/m"], table["approach_m"], table["reference_normal_force_N"]
    errors = [(k[i] + k[i + 1]) / 2 * (d[i + 1] - d[i]) / (n[i + 1] - n[i]) - 1 for i in range(10)]
    assert abs(math.fsum(errors) / 10) < 0.003


def keeps(run, target, rows):
    """Every point keeps the target, the smallest load and spin too, on a mesh that is expected to be no finer than that."""
    bounds = run.results["bound_force/muN"]
    assert len(bounds) == rows and all(bound <= target for bound in bounds)
    expected = float(re.search(r"expected bound (\S+) ", run.screen)[1])
    assert 0.6 <= expected / target <= 1
    assert any(re.match("mesh with [0-9]* elements across the patch", item["object"]) for item in run.json["objects"])


def test_load_curve_to_a_target(program):
    run = program(DISCS, {"Analysis": "load curve", "Load curve/Shares of load": "0.3 : 1 : 3", "Mesh/Target error": 1e-2})
    keeps(run, 1e-2, 3)


def test_creep_curve_to_a_target(program):
    run = program("lateral_3d_creep_curve",
                  {"Creep curve/Creepage y": "0.001, 0.002", "Creep curve/Spin": "0, 0.5", "Mesh/Target error": 6e-2,
                   "Mesh/Elements across patch": 24, "Mesh/Growth": 0.1})
    keeps(run, 6e-2, 2)
    assert max(run.results["elements_across"]) <= 12, "fewer elements than the scene's do"


def test_load_beyond_the_mesh(program):
    program(DISCS, {"Analysis": "load curve", "Load curve/Shares of load": "0.5, 2"}, code=1, says="Load curve/Shares of load")


@pytest.fixture(scope="module")
def grown(shared):
    """A curve whose later points outgrow the zone of the first ones."""
    return shared(shared.write("crown.prm", CROWN), output="grown")


def test_a_zone_that_a_point_outgrows_is_enlarged(program, grown):
    """The forces are those of a zone that had room."""
    assert "the zone is enlarged to" in grown.screen
    roomy = program(program.write("crown.prm", CROWN), {"Mesh/Candidate zone": 1.33}, QUIET)
    assert "enlarged" not in roomy.screen
    forces, others = grown.results["force_y_N"], roomy.results["force_y_N"]
    assert len(forces) == 3
    assert forces[0] == pytest.approx(others[0], rel=3.2e-3)
    assert forces[1:] == pytest.approx(others[1:], rel=3.2e-4)


def test_creepages_of_the_contact_beside_a_curve(program, grown):
    run = program(program.write("crown.prm", CROWN), {"Contact/Creepage y": 0.01}, QUIET, says="has no effect")
    assert run.results.texts("force_y_N") == grown.results.texts("force_y_N")


def test_a_study_that_outgrows_its_zone(program):
    run = program(program.write("crown.prm", CROWN),
                  {"Analysis": "accuracy study", "Accuracy study/Offsets": 1, "Accuracy study/Elements across patch": 10,
                   "Accuracy study/Reference elements across patch": 12, "Accuracy study/Extrapolate reference": "false",
                   "Accuracy study/Directions": "lateral", "Accuracy study/Creepages over saturation": "0.2, 0.9",
                   "Accuracy study/Slip operators": "calibrated", "Creep curve/Creepage y": 0})
    assert "the zone is enlarged to" in run.screen
    assert len(run.results) == 4


ROLL = {"Mesh/Elements across patch": 8, "Output/Plot": "false", "Creep curve/Spin": 0.4, "Creep curve/Creepage y": 0}


def test_forces_as_input(program):
    """The creepages found give back the forces."""
    asked = program("lateral_3d_creep_curve", ROLL, {"Creep curve/Lateral force": "-1000, -4000, -7000",
                                                     "Creep curve/Longitudinal force": "500, -2000, 4000"}, output="asked").results
    assert min(asked["force_rounds"]) >= 2
    assert min(asked["bound_creepage_x"]) > 0 and min(asked["bound_creepage_y"]) > 0
    assert "bound_spin_1/m" not in asked
    given = program("lateral_3d_creep_curve", ROLL, {f"Creep curve/Creepage {axis}": ", ".join(asked.texts(f"creepage_{axis}"))
                                                     for axis in "xy"}, output="given").results
    forces = list(zip(given["force_x_N"], given["force_y_N"]))
    assert len(forces) == 3
    for force, wanted in zip(forces, [(500, -1000), (-2000, -4000), (4000, -7000)]):
        assert math.dist(force, wanted) <= 1


def test_a_force_beyond_friction(program):
    program("lateral_3d_creep_curve", ROLL, {"Creep curve/Lateral force": "-1000, -20000"}, code=1, says="friction carries less than")


def test_of_several_states_the_worst_error_is_told(program):
    run = program(DISCS, {"Mesh/Elements across patch": 24, "Analysis": "load curve", "Load curve/Shares of load": "0.2, 0.5, 1"})
    bounds = run.results["bound_force/muN"]
    assert max(bounds) > 2 * min(bounds)
    assert f"error force {max(bounds):.1e} of mu N" in run.screen
