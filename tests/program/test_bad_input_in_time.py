"""Input of transient runs and mesh files that is refused; nothing is written then."""

import os

import pytest
from conftest import QUICK, RESUME, VALIDATE

SPEED, START, OWN_2D, OWN_3D = "rolling_at_speed_2d", "start_up_2d", "own_mesh_2d", "own_mesh_3d"


@pytest.mark.parametrize("scene, says, settings", [
    ("carter_2d_partial_slip", "Wheel/Hub = free", {"Wheel/Hub": "free"}),  # without inertia
    (SPEED, "Time step", {"Time/Time step": 0}),
    (SPEED, "Step length", {"Time/Step length": 1e-5}),  # beside a time step
    (SPEED, "Theta", {"Time/Theta": 0.4}),
    (SPEED, "Initial velocity", {"Time/Initial velocity": -1}),  # of a wheel that is clamped
    (START, "Rayleigh", {"Time/Rayleigh beta": 1e-9}),  # damping without inertia
    (START, "Time/Creepage x", {"Time/Creepage x": "0.001 * sin("}),
    (OWN_2D, 'none.msh" cannot be read: there is no such file', {"Rail/Mesh file": "meshes/none.msh"}),
    (OWN_3D, "Rail/Contact boundary id = 7", {"Rail/Contact boundary id": 7}),
    (OWN_3D, "Dimension = 3", {"Rail/Mesh file": "meshes/rail_2d.msh"}),
    (OWN_2D, "Body solver = distributed", {"Body solver": "distributed"}),
    (OWN_2D, "Rail/Mesh unit", {"Rail/Mesh unit": 1}),  # millimetres taken for metres
])
def test_a_run_is_refused(program, scene, says, settings):
    program.refuses(scene, says, settings)


@pytest.mark.parametrize("unit", ["1", "1e-6"])
def test_validation_refuses_a_unit_of_a_mesh(program, unit):
    program.refuses(OWN_2D, "Rail/Mesh unit", {"Rail/Mesh unit": unit}, options=VALIDATE)


def test_tables_of_a_history(program):
    def refused(value, says):
        program.refuses(START, says, {"Time/Creepage x": value})

    os.mkfifo(program.folder / "pipe.csv")
    (program.folder / "folder.csv").mkdir()
    program.write("short.csv", "t,a,b\n0,1,2\n1,2\n")
    refused(program.folder / "pipe.csv", 'pipe.csv" cannot be read: it is a pipe')
    refused(program.folder / "folder.csv", 'folder.csv" cannot be read: it is a folder')
    refused(program.folder / "none.csv", 'none.csv" cannot be read: there is no such file')
    refused(f"table: {program.folder / 'short.csv'} b", "line 3: there is no column b")


def test_no_checkpoint(program):
    program.refuses(START, "no such folder", options=RESUME)
    steady = program("carter_2d_partial_slip", QUICK, output="steady")
    before = steady.files(), program.names()
    program(START, code=1, says="no checkpoint", output="steady", options=RESUME)
    assert (steady.files(), program.names()) == before
