"""States on wheel and rail profiles: what a run says, columns against each other and against the wheelset's motion,
all analyses, and what is refused."""

import math

import pytest
import vtu
from conftest import charts, near, written

TREAD = "profiles_tread"
SMALL = {"Mesh/Elements across patch": 10}


@pytest.fixture(scope="module")
def right(shared):
    return shared(TREAD, SMALL, output="right")


@pytest.fixture(scope="module")
def left(shared):
    """The mirror image."""
    return shared(TREAD, SMALL, {"Profiles/Side": "left", "Profiles/Lateral shift": -0.003, "Contact/Creepage y": -0.001,
                                 "Contact/Spin": -0.191791}, output="left")


def of(run):
    """Numbers of the last row of results.csv by their names."""
    return run.results.last


def in_the_track(run, load):
    """Forces to the right and upwards by the rotation of those in the axes of the contact."""
    last = of(run)
    angle, force = last("contact_angle_rad"), last("force_y_N")
    return force * math.cos(angle) + load * math.sin(angle), load * math.cos(angle) - force * math.sin(angle)


def test_what_is_said_and_forces_in_the_axes_of_the_track(right):
    assert ("touch first at 740.47 mm from the middle of the track, -12.53 mm on the wheel's profile, "
            "at an angle of -5.07 degrees") in right.screen
    assert "patch 1 patch: 16000 N on " in right.screen
    assert "track forces on the wheel, forwards 26" in right.screen
    last = of(right)
    assert last("patches") == 1
    to_the_right, upwards = in_the_track(right, last("normal_force_N"))
    near(last("force_track_x_N"), -last("force_x_N"), 0, 1e-3)
    near(last("force_track_y_N"), to_the_right, 0, 0.01)
    near(last("force_track_z_N"), upwards, 0, 0.01)


def test_picture(right):
    written(right, "profiles.svg", "profiles.dat")
    assert '"profiles.svg"' in (right / "run.json").read_text(encoding="utf-8")
    charts("profiles", right.folder)


def test_the_left_wheel_is_the_mirror_image(left, right):
    assert "at an angle of 5.07 degrees" in left.screen
    for name in ("normal_force_N", "force_x_N", "max_pressure_Pa", "approach_m", "contact_y_wheel_m", "force_track_x_N",
                 "force_track_z_N"):
        near(of(right)(name), of(left)(name), 1e-5)
    for name in ("force_y_N", "spin_moment_Nm", "contact_angle_rad", "contact_y_track_m", "force_track_y_N", "patch_1_y_m"):
        near(-of(right)(name), of(left)(name), 1e-4)


def lines_across(run):
    """Lines of nodes across, a dictionary each."""
    return run.table("across.csv").records()


@pytest.mark.parametrize("side", ["right", "left"])
def test_lines_of_nodes_across_are_the_state(request, side):
    run = request.getfixturevalue(side)
    lines, last = lines_across(run), of(run)
    near(sum(line["load_N/m"] * line["width_m"] for line in lines), 16000, 0, 0.01)
    near(sum(line["dissipation_J/m2"] * line["width_m"] for line in lines), last("dissipation_J/m"), 0, 1e-4)
    near(sum(line["width_m"] for line in lines), 2 * last("half_width_y_m"), 0, 6e-4) # a line is 4.8e-4 wide
    assert sum(line["nodes_in_contact"] for line in lines) == last("nodes_in_contact")
    assert sum(line["nodes_in_stick"] for line in lines) == vtu.nodes(run / "interface.vtu")[0]["state"].count(2)
    near(max(line["max_pressure_Pa"] for line in lines), last("max_pressure_Pa"), 0, 10)
    cos, sin = math.cos(last("contact_angle_rad")), math.sin(last("contact_angle_rad"))
    heights = [line["height_m"] + line["y_m"] * sin for line in lines]
    for line, height in zip(lines, heights):
        near(line["y_track_m"], last("contact_y_track_m") + line["y_m"] * cos, 0, 2e-5)
        near(line["y_wheel_m"], last("contact_y_wheel_m") + (1 if side == "right" else -1) * line["y_m"] * cos, 0, 1e-4)
        near(height, math.fsum(heights) / len(heights), 0, 4e-5) # the curvature of the patch


def test_where_the_heat_is_mirrored(left, right):
    at_left, at_right = (sum(line["dissipation_J/m2"] * line["width_m"] * line["y_m"] for line in lines_across(run)) for run in (left, right))
    near(at_left, -at_right, 0, 1e-6)
    assert f"heat friction takes {of(left)('dissipation_J/m'):.4g} J per metre rolled" in left.screen


def test_two_patches_add_up(program):
    run = program("profiles_two_points", says="The rail's normal turns by 16")
    assert "patch 2 patches: " in run.screen
    last = of(run)
    assert last("patches") == 2
    for name in ("normal_force_N", "force_x_N", "force_y_N", "force_track_y_N", "force_track_z_N", "contact_area_m2", "dissipation_J/m"):
        part = name.replace("contact_area", "area")
        near(last(f"patch_1_{part}") + last(f"patch_2_{part}"), last(name), 1e-6)
    assert 0.0095 <= last("patch_2_y_m") <= 0.0115, "on the arc of 80 mm"


def forces_of_what_is_drawn(run):
    """force_y_N, normal_force_N and spin_moment_Nm of a state on a curved surface, from its interface.vtu alone: the normals
    are those of the surface that the file draws."""
    field, _ = vtu.nodes(run / "interface.vtu")
    section = sorted({(round(y, 9), round(z, 9)) for _, y, z in field["points"]})
    across = upwards = moment = 0.0
    for (x, y, _), area, p, (along, tangential, *_) in zip(*(field[name] for name in ("points", "area", "pressure", "traction"))):
        k = min(range(len(section)), key=lambda i, y=y: abs(section[i][0] - y))
        (y0, z0), (y1, z1) = section[max(0, k - 1)], section[min(len(section) - 1, k + 1)]
        turn = -math.atan2(z1 - z0, y1 - y0) # downwards positive
        force_y = area * (tangential * math.cos(turn) + p * math.sin(turn))
        across += force_y
        upwards += area * (p * math.cos(turn) - tangential * math.sin(turn))
        moment += x * force_y - y * area * along
    return across, upwards, moment


def test_tread_and_flange_in_one_state(program):
    run = program("profiles_tread_and_flange", SMALL)
    assert "patch 2 patches: " in run.screen
    last = of(run)
    across, upwards, moment = forces_of_what_is_drawn(run)
    mu_n = 0.3 * (last("patch_1_normal_force_N") + last("patch_2_normal_force_N"))
    near(last("force_y_N"), across, 0, 0.01 * mu_n)
    near(last("normal_force_N"), upwards, 0, 0.01 * mu_n)
    near(last("spin_moment_Nm"), moment, 0.01)
    for part in ("force_track_y_N", "force_track_z_N"):
        near(last(part), last(f"patch_1_{part}") + last(f"patch_2_{part}"), 0, 0.1)


# The wheel is turned to the right, so it slides to the left; the axle turns as a wheel of the nominal radius would, and its
# part along the normal is the spin
MOVING = {**SMALL, "Profiles/Creepages": "from kinematics", "Profiles/Roll": "automatic", "Contact/Creepage x": 0,
          "Contact/Creepage y": 0, "Contact/Spin": 0}


def test_creepages_of_yaw(program):
    last = of(program(TREAD, MOVING, {"Profiles/Yaw": 0.004}))
    near(last("creepage_y"), -0.004, 0, 3e-5)
    near(last("creepage_x"), 0, 0, 1e-12)


def test_creepages_of_a_driven_wheelset(program):
    rolling = program("contact_table", {"Output/Plot": "false", "Contact table/Lateral shift": 0.003}).table("contact_table.csv")
    for speed, sign in ((20, 1), (-20, -1)):
        last = of(program(TREAD, MOVING, {"Contact/Speed": speed, "Profiles/Pitch rate": f"{-speed / 0.46:.12g}"}))
        near(last("creepage_x"), (rolling.last("right_rolling_radius_m") / 0.46 - 1) * sign, 0, 2e-5)
        near(last("spin_1/m"), math.sin(rolling.last("roll_rad") - last("contact_angle_rad")) / 0.46 * sign, 0, 1e-6)


def test_a_vertical_load_on_the_flange_that_slides_all_over(program):
    run = program("profiles_flange", SMALL)
    near(of(run)("force_track_z_N"), 20000, 0, 0.01)
    assert "upwards 20000 N" in run.screen


def steps(start, end, step):
    """Numbers from the start on, the end is not among them."""
    return [start + k * math.copysign(step, end - start) for k in range(math.ceil(abs(end - start) / step - 1e-9))]


def grooved(keeper, first=-100):
    """A grooved rail: head of 56 mm, groove of 42 mm, keeper of 20 mm whose top is below that of the head by some mm;
    points from the first y on."""
    def crown(y):
        return 300 - math.sqrt(90000 - y * y)

    corner = crown(18) + 10
    points = [(-90, z) for z in steps(60, keeper, 0.5)] + [(y, keeper) for y in steps(-90, -70, 0.5)]
    points += [(-70, z) for z in steps(keeper, 42, 0.5)] + [(y, 42) for y in steps(-70, -28, 0.5)]
    points += [(-28, z) for z in steps(42, corner, 0.5)]
    points += [(-18 - 10 * math.cos(t), corner - 10 * math.sin(t)) for t in steps(0, 1.5, 0.05)]
    points += [(y, crown(y)) for y in steps(-18, 18.5, 0.5)]
    points += [(18 + 10 * math.cos(t), corner - 10 * math.sin(t)) for t in steps(1.5, 0, 0.05)]
    points += [(28, z) for z in steps(corner, 20, 0.5)]
    return [(y, z) for y, z in points if y >= first]


def rail(program, name, points):
    """Settings of a rail profile of one's own."""
    file = program.write(name, "".join(f"{y:.6f} {z:.6f}\n" for y, z in points))
    return {**SMALL, "Profiles/Rail inclination": 0, "Profiles/Rail profile": file}


def test_wheels_run_on_the_head_of_a_grooved_rail(program):
    head = program(TREAD, rail(program, "head.txt", grooved(2, -28)))
    assert head.err == "", "no warning"
    for name, keeper in (("low", 2), ("high", -8)):
        run = program(TREAD, rail(program, f"{name}.txt", grooved(keeper)), says=f"{name}.txt: the rail has a groove 4")
        assert "a flange that touches the keeper beyond it is not found" in run.messages
        for column in ("normal_force_N", "force_x_N", "force_y_N", "contact_y_track_m", "contact_angle_rad"):
            near(of(run)(column), of(head)(column), 1e-3)


@pytest.mark.parametrize("axis, y_sign, z_sign", [("y", -1, 1), ("z", 1, -1)])
def test_a_groove_on_the_wrong_side(program, axis, y_sign, z_sign):
    wrong = rail(program, "wrong.txt", [(y_sign * y, z_sign * z) for y, z in grooved(-8)])
    program.refuses(TREAD, f"set Profiles/Rail mirror = {axis}.", wrong, options=["--validate"])
    program(TREAD, wrong, {"Profiles/Rail mirror": axis}, says="a groove 42 mm deep", options=["--validate"])


def test_creep_curve(program):
    run = program("profiles_creep_curve", SMALL, {"Creep curve/Creepage y": "-0.001, 0.001", "Creep curve/Spin": "0.191791, 0.191791"})
    assert len(run.results) == 2
    written(run, "creep_curve.svg")
    near(of(run)("force_track_y_N"), in_the_track(run, 16000)[0], 0, 0.01) # the spin's force is added


def test_load_curve_ends_with_the_single_state(program, right):
    last = of(program(TREAD, SMALL, {"Analysis": "load curve", "Load curve/Shares of load": "0.5, 1"}))
    near(last("approach_m"), of(right)("approach_m"), 0, 2e-7)


def test_the_steady_state_is_held_in_time(program, right):
    run = program(TREAD, SMALL, {"Analysis": "transient", "Time/Inertia": "false", "Time/Initial state": "steady",
                                 "Time/Step length": "0.5e-3", "Time/Rolled distance": "1.5e-3"})
    near(of(run)("force_y_N"), of(right)("force_y_N"), 0, 48)
    near(of(run)("force_track_z_N"), in_the_track(run, 16000)[1], 0, 0.01)


def test_accuracy_study(program):
    run = program(TREAD, {
        "Analysis": "accuracy study", "Contact/Creepage x": 0, "Contact/Creepage y": 0, "Contact/Spin": 0,
        "Accuracy study/Elements across patch": "6, 8", "Accuracy study/Offsets": 1,
        "Accuracy study/Reference elements across patch": 12, "Accuracy study/Extrapolate reference": "false",
        "Accuracy study/Creepages over saturation": 0.3, "Accuracy study/Slip operators": "calibrated"})
    assert "pressure over its peak against the finest mesh" in run.screen
    assert '"12 elements, first position","12 elements, first position"' in (run / "summary.csv").read_text(encoding="utf-8")
    methods = run.table("methods.csv")
    assert len(methods) == 2
    near(methods.last("force_error_max"), 0, 0, 0.02)
    near(methods.last("pressure_l2_max"), 0.04, 0, 0.04)


IN_TIME = {"Analysis": "transient", "Time/Rolled distance": "1e-3", "Time/Step length": "5e-4"}


@pytest.mark.parametrize("says, settings", [
    ("give both or none of them", {"Profiles/Rail profile": ""}),
    ("take Dimension = 3", {"Dimension": 2}),
    ("an accuracy study has its own creepages", {"Analysis": "accuracy study", "Profiles/Creepages": "from kinematics"}),
    ("brings its own surface; leave the profiles empty", {"Rail/Shape": "mesh file", "Rail/Mesh file": "meshes/rail_3d.msh"}),
    ("a rail with a profile is straight; take Rail/Shape = block or section and Rail/Radius = 0", {"Rail/Shape": "disc", "Rail/Radius": 0.5}),
    ("Rail/Lateral radius = 0.3: the surface across the track is that of Profiles/Rail profile", {"Rail/Lateral radius": 0.3}),
    ("Contact/Normal load = 16000 and Contact/Vertical load = 16000: give one of them", {"Contact/Vertical load": "16e3"}),
    ("in time the load is along the normal; give Contact/Normal load", {"Contact/Normal load": "", "Contact/Vertical load": "16e3", **IN_TIME}),
    ("Contact/Vertical load = -16000: contact cannot pull", {"Contact/Normal load": "", "Contact/Vertical load": "-16e3"}),
    ("Profiles/Roll = abc: give a number in rad, or `automatic`", {"Profiles/Roll": "abc"}),
    ("Profiles/Pitch rate = fast: give a number in rad/s, or `automatic`", {"Profiles/Pitch rate": "fast"}),
    ("Profiles/Roll = 2: give it in rad", {"Profiles/Roll": 2}),
    ("Profiles/Lateral shift = 3: give it in m, from -0.05 to 0.05", {"Profiles/Lateral shift": 3}),
    ("Profiles/Yaw = 1: give it in rad", {"Profiles/Yaw": 1}),
    ("there is no such file as {prm}/none.txt", {"Profiles/Wheel profile": "none.txt"}),
    ("Profiles/Rail profile = UIC60: give 60E1, 60E2, 54E1, 54E3, 49E1 or 60E1 Manchester, or the name of a file",
     {"Profiles/Rail profile": "UIC60"}),
    ("web and foot of true sections are those of a 60E1", {"Profiles/Rail profile": "54E1", "Profiles/Body sections": "true"}),
    ("Profiles/Side", {"Profiles/Side": "middle"}),
    ("the wheel is not above the rail", {"Profiles/Gauge": 2})])
def test_what_is_refused(program, says, settings):
    program.refuses(TREAD, says.format(prm=program.prm), settings)


def test_a_vertical_load_without_profiles(program):
    program.refuses("combined_3d", "without profiles the vertical is the normal", {"Contact/Approach": "", "Contact/Vertical load": "16e3"})


@pytest.mark.parametrize("scene, says, settings", [
    ("combined_3d", "Profiles/Lateral shift = 0.003 has no effect: bodies with a Profiles/Wheel profile", {"Profiles/Lateral shift": 0.003}),
    (TREAD, "Profiles/Pitch rate = -40 has no effect", {"Profiles/Pitch rate": -40}),
    (TREAD, "Profiles/Smoothing length = 0.01 has no effect", {"Profiles/Smoothing length": 0.01}),
    (TREAD, "Contact/Creepage x = 0.001 has no effect", {"Profiles/Creepages": "from kinematics"}),
    ("contact_table", "Profiles/Lateral shift = 0.003 has no effect", {"Profiles/Lateral shift": 0.003})])
def test_entries_without_effect(program, scene, says, settings):
    program(scene, settings, says=says, options=["--validate"])
