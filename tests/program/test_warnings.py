"""Values, defaults and files that are hardly meant and entries without effect: the program
warns, on the screen and in run.json, and goes on; no scene that comes with it is warned of."""

import random
import re

import pytest
from conftest import QUICK, VALIDATE

DISCS, ON_RAIL, MODES = "carter_2d_partial_slip", "wheel_on_rail_3d", "wheel_modes"
START, CURVE, TABLE = "start_up_2d", "lateral_3d_creep_curve", "table_3d"


def doubted(program, says, scene, *settings):
    run = program(scene, *settings, options=VALIDATE, says=says)
    assert re.search("^Warning: ", run.err, re.M), run
    return run


def not_doubted(program, scene, *settings):
    run = program(scene, *settings, options=VALIDATE)
    assert not run.err, run


@pytest.mark.parametrize("scene, entry, value, says", [
    (DISCS, "Wheel/Young modulus", 210, "Wheel/Young modulus = 210 Pa is unlikely: rubber has 1e6 Pa; meant 210e9 (GPa)?"),
    (DISCS, "Wheel/Young modulus", 210000, "meant 210000e6 (MPa)?"),
    (DISCS, "Contact/Friction coefficient", 30,
     "Contact/Friction coefficient = 30 is unlikely: dry steel has 0.3 to 0.6, rubber 1; meant 0.3 (30 %)?"),
    (DISCS, "Contact/Creepage x", 17, "meant 0.17 (17 %)?"),
    (CURVE, "Creep curve/Creepage y", "0, -2", "Creep curve/Creepage y = -2 is unlikely"),
    ("oscillating_creepage_2d", "Time/Creepage x", "1.7*sin(2*pi*1000*t)", "Time/Creepage x = "),
    # rho g pi (R^2 - r^2) B of the disc in the scene: 7800 x 9.81 x pi (0.46^2 - 0.08^2) 0.1 N = 4933 N
    (ON_RAIL, "Contact/Normal load", 100,
     "Contact/Normal load = 100 N is unlikely: the wheel alone weighs 4.93e+03 N; meant 100e3 (kN)?"),
    (DISCS, "Wheel/Radius", 460, "Wheel/Radius = 460 m is unlikely: lengths are in m; meant 0.46 (460 mm)?"),
    (DISCS, "Contact/Approach", 0.22, "it is 0.478 times the smallest radius, and it is in m; meant 0.22e-3 (mm)?"),
    ("rolling_at_speed_2d", "Rail/Density", 7.8, "meant 7.8e3 (g/cm^3)?"),
    (MODES, "Wheel/Density", 7.85, "meant 7.85e3 (g/cm^3)?"),
    (MODES, "Wheel/Modal damping", "0.1, 0.5, 0.01",
     "Wheel/Modal damping = 0.5 is unlikely: damping ratios of steel wheels are 1e-4 to 1e-2; meant 0.5e-2 (0.5 %)?"),
    # a cone rolls with the spin 1/radius: 1/400 m
    ("combined_3d", "Contact/Spin", 400, "Contact/Spin = 400 1/m is unlikely: it is that of a cone of 2.5 mm that does not roll."),
    # not of the first state
    (TABLE, "Table/Axis 2", "Contact/Creepage x = 0 : 4 : 5",
     "Contact/Creepage x = 4 is unlikely: a wheel that is blocked has a creepage of 1; meant 0.04 (4 %)?"),
    (TABLE, "Table/Axis 1", "Contact/Normal load = 80e3, 40", "Contact/Normal load = 40 N is unlikely"),
    ("profiles_tread_and_flange", "Contact/Vertical load", 80, "Contact/Vertical load = 80 N is unlikely"),
])
def test_units(program, scene, entry, value, says):
    doubted(program, says, scene, {entry: value})


def test_directions_in_degrees(program):
    turned = {"Contact/Creepage x": "", "Contact/Creepage y": "", "Contact/Creepage size": 0.001}
    doubted(program, "Contact/Creepage direction = 90 rad is unlikely: a full circle has 6.28 rad; meant 1.5708 (90 degrees)?",
            "combined_3d", {**turned, "Contact/Creepage direction": 90})
    not_doubted(program, "combined_3d", {**turned, "Contact/Creepage direction": -6})


@pytest.mark.parametrize("scene, entry, value, says", [
    (DISCS, "Time/Creepage x", 0.003, " = 0.003 has no effect: Analysis = transient reads that section, not quasi-static."),
    (DISCS, "Creep curve/Creepage x", "0 : 0.01 : 3", " = 0 : 0.01 : 3 has no effect"),  # without Analysis
    (CURVE, "Contact/Creepage y", 0.003, " = 0.003 has no effect"),
    (DISCS, "Wheel/Width", 0.3, " = 0.3 has no effect"),
    ("combined_3d", "Rail/Thickness", 0.3, " = 0.3 has no effect"),
    (START, "Mesh/Target error", "1e-2", " = 1e-2 has no effect: the error of a time step is not known beforehand"),
    ("accuracy_2d", "Mesh/Target error", "1e-2", " = 1e-2 has no effect: a study has its own"),
])
def test_entries_without_effect(program, scene, entry, value, says):
    doubted(program, entry + says, scene, {entry: value})


def test_a_wheel_of_unsaid_density_is_not_weighed_unless_of_steel(program):
    soft = program(ON_RAIL, {"Contact/Normal load": 100, "Wheel/Young modulus": 1e9, "Rail/Young modulus": 1e9}, options=VALIDATE)
    assert "weighs" not in soft.err
    for modulus in ("70e9", "110e9"):
        not_doubted(program, ON_RAIL, {"Contact/Normal load": 500, "Wheel/Young modulus": modulus})
    doubted(program, "the wheel alone weighs 1.71e+03 N", ON_RAIL,
            {"Contact/Normal load": 100, "Wheel/Young modulus": "70e9", "Wheel/Density": 2700})


def test_defaults_of_another_scene(program):
    scene = program.scene(ON_RAIL).read_text(encoding="utf-8")
    program.write("roller.prm", re.sub("(?ms)^subsection Rail\n.*?^end", lambda rail: re.sub(".*set Radius.*\n", "", rail[0]), scene))
    doubted(program, "Rail/Shape = block without Rail/Radius: the block is curved along x by the default of 0.46 m", "roller.prm")
    not_doubted(program, "roller.prm", {"Rail/Radius": 0.46})
    program.write("fine.prm", re.sub("(?ms)^subsection Mesh\n.*?^end\n", "", scene))
    doubted(program, "without Mesh/Elements across patch: the default, 48, is for 2D", "fine.prm")
    not_doubted(program, "fine.prm", {"Mesh/Elements across patch": 16})  # as the growth is that of 3D
    not_doubted(program, "fine.prm", {"Mesh/Target error": 1e-2})


def test_a_section_of_another_wheel(program):
    """It does not name the radius of its own."""
    section = (program.prm / "sections/wheel_2.msh").read_text(encoding="utf-8")
    unnamed = program.write("unnamed.msh", section.replace(", radius 0.46", ""))
    doubted(program, f"Wheel/Radius = 0.8 m is hardly that of Wheel/Mesh file = {unnamed}: its bore, 0.3675 m behind the contact point, "
            "would have a radius of 0.433 m, 54 % of the wheel's, where 15 to 30 % are usual; is it the section of a wheel of about 0.46 m?",
            MODES, {"Wheel/Radius": 0.8, "Wheel/Mesh file": unnamed})
    doubted(program, "would have a radius of 0.0325 m, 8.1 % of the wheel's", MODES, {"Wheel/Radius": 0.4, "Wheel/Mesh file": unnamed})
    not_doubted(program, MODES)


def profile(program):
    """Points of a measured profile, as texts."""
    lines = (program.prm / "profiles/worn_wheel.txt").read_text(encoding="utf-8").splitlines()
    return [line.split() for line in lines if not line.startswith("#")]


def table(program, points):
    """A scene beside its profile of a wheel, and the setting that takes that."""
    program.write("here.prm", program.scene("contact_table").read_text(encoding="utf-8"))
    program.write("points.txt", "".join(f"{y} {z}\n" for y, z in points))
    return "here.prm", {"Profiles/Wheel profile": "points.txt"}


@pytest.mark.parametrize("name, change, says", [
    ("gap", lambda y, z: None if -12 <= y <= 0 else (y, z), "no points for 12.3 mm, from y = -12.3 to 0.0014 mm"),
    ("moved", lambda y, z: (y + 60, z), "the tip of the flange is at y = 4.89 mm; from the tape circle"),
    ("columns", lambda y, z: (z, y), "mm high; is the first column y, across, and the second z?"),
    ("inches", lambda y, z: (y / 25.4, z / 25.4),
     "mm wide, wheels have 100 to 150 mm; is Profiles/File unit right (0.0254 for inches)?"),
])
def test_measured_profiles(program, name, change, says):
    points = [change(float(y), float(z)) for y, z in profile(program)]
    scene, settings = table(program, [point for point in points if point])
    doubted(program, says, scene, settings)
    if name == "inches":
        not_doubted(program, scene, settings, {"Profiles/File unit": 0.0254})


def test_points_that_scatter(program):
    chance = random.Random(7)
    run = doubted(program, "um about a smooth line; 5 um move the contact",
                  *table(program, [(y, float(z) + chance.gauss(0, 0.02)) for y, z in profile(program)]))
    assert 16 <= float(re.search(r"scatter by about ([0-9.]*) um", run.messages)[1]) <= 25


def test_points_in_no_order(program):
    scene, settings = table(program, sorted(profile(program), key=lambda point: point[1]))
    program(scene, settings, code=1, says="they must follow each other along the section", options=VALIDATE)


def test_profiles_from_a_spreadsheet(program):
    text = "".join(f"{y};{z}\r\n" for y, z in [("y [mm]", "z [mm]"), *profile(program)])
    scene, settings = table(program, [])
    program.write("points.txt", text)
    not_doubted(program, scene, settings, {"Profiles/File unit": 0.001})
    program.write("points.txt", text.translate(str.maketrans(";.", " ,")))
    program(scene, settings, code=1, says="has decimal commas; decimals take a point", options=VALIDATE)


def test_the_warning_is_in_run_json(program):
    run = program(DISCS, QUICK, {"Contact/Friction coefficient": 30}, says="Warning: Contact/Friction coefficient = 30")
    assert any("Contact/Friction coefficient = 30 is unlikely" in warning for warning in run.json["warnings"])


def test_a_patch_beside_the_first_contact(program):
    slope = {"Profiles/Lateral shift": 0.001, "Profiles/Roll": 0, "Contact/Normal load": "50e3", "Mesh/Elements across patch": 8,
             "Output/Plot": "false"}
    program("profiles_tread", slope, says="where the rail slopes by 0.012 rad against the plane of contact")
    run = program("profiles_tread", slope, {"Profiles/Contact surface": "loaded plane"})
    assert "slopes by" not in run.messages


def test_a_load_on_a_curved_surface(program):
    """It is followed by steady states; in time an approach is."""
    scene, settings = "squeal_limit_cycle", {"Time/Excite mode": 0, "Time/Excite velocity": 0}
    program(scene, settings, options=VALIDATE)
    settings["Time/Hold approach"] = "false"
    program(scene, settings, options=VALIDATE, code=1, says="friction carries a part of the load there")
    program(scene, settings, {"Contact/Normal load": "", "Contact/Approach": 2e-4}, options=VALIDATE)


def test_scenes_that_come_with_the_program(program):
    scenes = sorted([*program.prm.glob("*.prm"), *program.prm.glob("extreme/*.prm")])
    assert scenes
    for scene in scenes:
        not_doubted(program, scene)
