"""Bodies with sections from files: a state, in time, on two ranks, refused."""

import pytest
from conftest import QUIET, near, own_mesh, same_results

SCENE = "section_wheel_on_rail"


def test_a_wheel_on_a_rail(program):
    run = program(SCENE)
    own_mesh(run)
    results = run.results
    near(results.last("normal_force_N"), 60e3, 0, 0.1)
    near(results.last("max_pressure_Pa") / results.last("reference_max_pressure_Pa"), 1, 0.02)
    assert 93e-6 <= results.last("approach_m") <= 98e-6, "web and neck give way"
    assert -11350 <= results.last("force_y_N") <= -11000


@pytest.fixture(scope="module")
def small(shared):
    """A small wheel of five by eight quadrilaterals, R = 0.1 m, on a crowned block."""
    nodes = [f"{1 + 6 * j + i} {-15 + 6 * i} {8.75 * j} 0" for j in range(9) for i in range(6)]
    cells = [f"1 2 {edge} {edge} {i + up} {i + up + 1}" for i in range(1, 6) for edge, up in ((1, 0), (2, 48))]
    cells += [f"3 2 3 3 {k} {k + 1} {k + 7} {k + 6}" for j in range(8) for k in range(6 * j + 1, 6 * j + 6)]
    mesh = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes", len(nodes), *nodes, "$EndNodes",
            "$Elements", len(cells), *(f"{n} {cell}" for n, cell in enumerate(cells, 1)), "$EndElements"]
    return {"Mesh/Elements across patch": 8, "Mesh/Growth": 0.8, **QUIET, "Output/Body fields": "false",
            "Wheel/Mesh file": shared.write("small.msh", "\n".join(map(str, mesh)) + "\n"), "Wheel/Mesh unit": 0.001,
            "Wheel/Radius": 0.1, "Rail/Shape": "block", "Rail/Mesh file": "", "Rail/Lateral radius": 0.1,
            "Rail/Block length": 0.1, "Rail/Block depth": 0.05, "Rail/Width": 0.03, "Contact/Normal load": 5e3}


def test_a_section_on_each_of_two_ranks(program, small):
    same_results(program(SCENE, small, output="one"), program(SCENE, small, output="two", ranks=2))


@pytest.mark.parametrize("inertia", ["false", "true"])
def test_the_steady_state_is_held_in_time(program, small, inertia):
    run = program(SCENE, small, {"Rail/Rigid": "true", "Wheel/Surface": "nodes", "Analysis": "transient",
                                 "Time/Initial state": "steady", "Contact/Speed": 10, "Time/Time step": 2e-5,
                                 "Time/End time": 1e-4, "Time/Inertia": inertia})
    forces = run.table("history.csv")["force_y_N"]
    near(forces[-1] / forces[0], 1, 1e-7)


def test_sections_under_profiles(program):
    run = program("section_profiles")
    own_mesh(run) # the log tells of the surface
    results = run.results
    near(results.last("normal_force_N"), 50e3, 0, 0.1)
    assert 1231e6 <= results.last("max_pressure_Pa") <= 1256e6, "that of plain bodies"
    assert -6700 <= results.last("force_x_N") <= -6400
    assert -2850 <= results.last("force_y_N") <= -2550
    assert 105e-6 <= results.last("approach_m") <= 120e-6, "web and neck give way"


def test_surfaces_that_are_not_where_they_should_be(program):
    for scene, says, settings in [
            ("section_profiles", "off the profile at y =", {"Wheel/Mesh file": "sections/wheel_2.msh"}),
            (SCENE, "off the surface of Rail/Radius = 0 m and Lateral radius = 0.1 m",
             {"Wheel/Rigid": "true", "Rail/Lateral radius": 0.1})]:
        assert not (program(scene, settings, code=1, says=says) / "results.csv").exists()


UNNAMED = {"Wheel/Mesh file": "unnamed.msh", "Wheel/Radius": 0.3}


@pytest.mark.parametrize("says, settings", [
    ("it is the section of a body of radius 0.46 m, as the name of a group in it says, and Wheel/Radius = 0.3 m: set Wheel/Radius = 0.46",
     {"Wheel/Radius": 0.3}),
    ("crosses or touches its axle, which is Wheel/Radius = 0.3 m above", UNNAMED),
    ("this file needs a Radius above 0.3675 m", UNNAMED),
    ("Wheel/Mesh unit (0.001 m)", {"Wheel/Mesh unit": 0.001}),
    ("no face of its boundary has Rail/Hub boundary id = 5; its boundary has 0, 1, 2", {"Rail/Hub boundary id": 5}),
    ('none.msh" cannot be read: there is no such file', {"Rail/Mesh file": "none.msh"}),
    ("cannot read it as a mesh of quadrilaterals (Shape = section)", {"Rail/Mesh file": "meshes/rail_3d.msh"}),
    ("a body with a section from a file (Wheel/Shape) lives on one rank", {"Body solver": "distributed"}),
    ("is refined for the estimated patch only", {"Mesh/Adaptive levels": 1}),
    ("Rail/Lateral radius = 0.3: the surface across the track is that of Profiles/Rail profile",
     {"Profiles/Wheel profile": "S1002", "Profiles/Rail profile": "60E1"})])
def test_what_is_refused(program, says, settings):
    if settings is UNNAMED:
        named = (program.prm / "sections/wheel_2.msh").read_text(encoding="utf-8")
        settings = {**UNNAMED, "Wheel/Mesh file": program.write("unnamed.msh", named.replace(", radius 0.46", ""))}
    program.refuses(SCENE, says, settings, options=["--validate"])
