"""Every kind of scene in 3D."""

import functools
import math
import re

import pytest
from conftest import COARSE, QUICK, near, own_mesh, same_files, same_results, summary_has, words, written

WHEEL = "wheel_on_rail_3d"
FEW = {"Mesh/Elements across patch": 8, "Output/Body fields": "false"}


@pytest.mark.parametrize("name", ["lateral_3d_pure_rolling", "lateral_3d_partial_slip", "lateral_3d_full_slip", "combined_3d", WHEEL])
def test_files_and_summary(program, name):
    run = program(name, COARSE)
    written(run, "results.csv", "bodies.pvd", "interface.pvd")
    summary_has(run, "of mu N (estimate: ")
    summary_has(run, "of p0 against Hertz")
    if name == "lateral_3d_full_slip":
        assert 0.2998 <= run.results.last("traction_coefficient") <= 0.3


@pytest.mark.parametrize("settings, says", [({}, "of p0 against Hertz"),
                                            ({"Rail/Foundation stiffness z": 0.46e9}, "of its peak (estimate: 2/n^2")])
def test_pads_so_soft_that_friction_tilts_the_rail(program, settings, says):
    """Its patch is not where Hertz's is."""
    summary_has(program("squeal_small", {"Analysis": "quasi-static"}, settings), says)


def test_a_rail_from_a_file(program):
    own_mesh(program("own_mesh_3d"))


@pytest.fixture
def no_growth(program):
    """The scene of a wheel without its growth of elements."""
    text = program.scene(WHEEL).read_text(encoding="utf-8")
    return program.write("growth.prm", re.sub(".*set Growth.*\n", "", text))


def test_elements_grow_by_themselves_by_a_given_number(program, no_growth):
    """By 0.4, in 2D by 0.1."""
    automatic = program(no_growth, FEW, output="automatic")
    given = program(no_growth, FEW, {"Mesh/Growth": 0.4}, output="given")
    same_results(automatic, given)
    same_files(automatic, given, "used.prm")
    program(no_growth, {"Mesh/Growth": 0.001}, options=["--validate"], code=1,
            says="Mesh/Growth = 0.001: give a number from 0.01 to 10, or `automatic`.")


@pytest.mark.parametrize("wheel, rail", [(0.018, 0.08), (0.018, 0.0183), (0.0165, 0.017), (0.04, 0.018)])
def test_a_wheel_that_ends_near_the_patch(program, no_growth, wheel, rail):
    """On a wider rail, on one hardly wider and on a narrower one; the force against that of twice the elements."""
    coarse, fine = (program(no_growth, FEW, {"Mesh/Elements across patch": n, "Mesh/Growth": 0.8, "Wheel/Width": wheel,
                                             "Rail/Width": rail}, output=f"width_{n}").results for n in (8, 16))
    near(coarse.last("force_x_N"), fine.last("force_x_N"), 0, 0.03 * 0.3 * coarse.last("normal_force_N"))


def test_edges_left_to_upwind_2_are_in_the_bound_of_the_force(program):
    """Three of 17: 2.47e-2 of mu N off with 8 elements and a level, against 24."""
    run = program("accuracy_3d", FEW, {"Analysis": "quasi-static", "Contact/Spin": 1.48017576, "Mesh/Adaptive levels": 1,
                                       "Mesh/Target change": 0, "Mesh/Patch offset": 0}, says="At 3 of 17 leading edges")
    assert 0.0247 <= run.results.last("bound_force/muN") <= 0.05


def test_a_concave_rail_of_6_elements(program):
    """Its patch grows, and its zone of nodes ends where the rail does."""
    program("carter_2d_partial_slip", QUICK, {
        "Rail/Shape": "block", "Rail/Radius": -0.5, "Rail/Block depth": 0.5, "Rail/Block length": 0.8,
        "Mesh/Elements across patch": 6, "Mesh/Growth": 0.8, "Contact/Approach": "", "Contact/Normal load": 1.6e6})


def test_many_unknowns_are_told_before_they_are_solved(program):
    out = program(WHEEL, {"Mesh/Elements across patch": 24}).out
    assert re.match("Meshing the wheel with [0-9]+ cells or more, the rail with [0-9]+ cells or more", words(" ".join(out.split("\n")[:2])))
    assert re.search("Condensing bodies of [0-9]+ unknowns to [0-9]+ contact nodes", out)


@pytest.fixture(scope="module")
def on_profiles(shared):
    """A scene of profiles, run once."""
    return functools.cache(shared)


@pytest.mark.parametrize("name, patches", [("tread", 1), ("true_sections", 1), ("two_points", 2), ("flange", 1), ("tread_and_flange", 2),
                                           ("false_flange", 1), ("worn", 1), ("creep_curve", 1)])
def test_patches_on_profiles(on_profiles, name, patches):
    run = on_profiles(f"profiles_{name}")
    assert run.results.last("patches") == patches
    summary_has(run, "of mu N (estimate: ")


@pytest.mark.parametrize("name, force, load, tolerance", [("tread", (-2707.0, -1636.6), 16000, 0.015),
                                                          ("true_sections", (-2707.0, -1636.6), 16000, 0.02),
                                                          ("two_points", (-2271.1, 9632.8), 80000, 0.027)])
def test_the_force_on_profiles_is_that_of_an_independent_half_space(on_profiles, name, force, load, tolerance):
    """It has 859.13 MPa on the tread, 2910.85 MPa in two points. There bodies of finite size share the load otherwise."""
    results = on_profiles(f"profiles_{name}").results
    assert math.dist((results.last("force_x_N"), results.last("force_y_N")), force) <= tolerance * 0.3 * load


@pytest.mark.parametrize("name, column, low, high", [
    ("tread", "max_pressure_Pa", 850.5e6, 867.7e6),
    ("true_sections", "max_pressure_Pa", 850.5e6, 867.7e6),
    ("true_sections", "approach_m", 40e-6, 45e-6), # web and neck give way
    ("two_points", "max_pressure_Pa", 2.867e9, 2.955e9),
    # all slides across: N (cos d + mu sin d) is the vertical load, d = 61.24 degrees, but for what the spin turns of the friction
    ("flange", "normal_force_N", 26840, 26890),
    ("flange", "traction_coefficient", 0.2995, 0.3),
    ("tread_and_flange", "force_track_z_N", 79999.9, 80000.1),
    ("tread_and_flange", "patch_2_angle_rad", -1.21, -1.11), # of the flange
    ("tread_and_flange", "patch_1_angle_rad", -0.37, -0.31), # of the shoulder
    ("false_flange", "contact_y_wheel_m", 28.8e-3, 29.0e-3),
    ("false_flange", "max_pressure_Pa", 2350e6, 2430e6),
    ("worn", "creepage_x", -1e-12, 1e-12),
    ("creep_curve", "traction_coefficient", 0.2995, 0.3)])
def test_results_on_profiles(on_profiles, name, column, low, high):
    assert low <= on_profiles(f"profiles_{name}").results.last(column) <= high


def test_true_sections_as_half_spaces_and_moments_of_meshes(program, on_profiles):
    """The force is that of finite elements; web and neck give way alike."""
    elements = on_profiles("profiles_true_sections").results
    run = program("profiles_true_sections", {"Mesh/Compliance": "automatic"})
    assert "The compliance is split" in run.screen
    forces = [(table.last("force_x_N"), table.last("force_y_N")) for table in (run.results, elements)]
    assert math.dist(*forces) <= 0.006 * 0.3 * 16000
    assert 42e-6 <= run.results.last("approach_m") <= 43.2e-6


def test_the_bound_of_split_true_sections_holds(program):
    """Against 24 finite elements with a growth of 0.4; the bound was smaller than the difference once."""
    results = program("profiles_true_sections", {"Mesh/Compliance": "split", "Mesh/Elements across patch": 24}).results
    difference = math.dist((results.last("force_x_N"), results.last("force_y_N")), (-2725.6, -1582.6)) / (0.3 * 16000)
    assert 2e-3 <= difference <= results.last("bound_force/muN") <= 2e-2


def test_the_root_of_a_flange_is_not_split(program):
    program("profiles_true_sections", {"Mesh/Compliance": "split", "Profiles/Lateral shift": 0.0062}, code=1,
            says="the next edge of the Wheel")
