"""Bodies from files in time, and resumed."""

import shutil

import pytest
from conftest import QUIET, RESUME

ROLLING = {"Analysis": "transient", "Time/Inertia": "true", "Time/Initial state": "steady", "Contact/Speed": 10, "Time/Time step": 1e-5,
           "Output/Body fields": "false", **QUIET}


@pytest.fixture
def scene(program):
    """A copy of the scene and of its meshes."""
    shutil.copytree(program.prm / "meshes", program.folder / "meshes")
    return shutil.copy(program.scene("own_mesh_2d"), program.folder)


def test_a_mesh_in_time_is_resumed_unless_it_has_changed(program, scene):
    run = program(scene, ROLLING, {"Time/End time": 2e-4}, output="run")
    load = run.table("history.csv")["normal_force_N"]
    assert load[-1] / load[0] == pytest.approx(1, rel=0, abs=1e-9), "the steady state is held"
    program(scene, ROLLING, {"Time/End time": 4e-4}, output="run", options=RESUME)
    mesh = program.folder / "meshes/rail_2d.msh"
    text = mesh.read_text()
    assert "\n100 -100 0\n" in text
    mesh.write_text(text.replace("\n100 -100 0\n", "\n100 -101 0\n"))
    program(scene, ROLLING, {"Time/End time": 6e-4}, output="run", options=RESUME, code=1, says="Rail/Mesh file (mesh)")


def test_a_mesh_too_coarse_for_the_elements(program):
    program("own_mesh_2d", {"Mesh/Elements across patch": 60, "Output/Body fields": "false"}, says="too large for the interface")
