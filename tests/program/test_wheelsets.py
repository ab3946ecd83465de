"""A wheelset in curves: what a run finds and says, its files against each other, the mirror image, the trailing wheelset, and what is
refused."""

import pytest
from conftest import VALIDATE, documented

SCENE = "wheelset_curve"
FEW = {"Mesh/Elements across patch": 6, "Wheelset/Search for others": "false"}
SIDES = ("right", "left")


def row_of(run):
    return run.table("wheelset.csv").records()[-1]


def near(value, expected, tolerance):
    return abs(value - expected) < tolerance


@pytest.fixture(scope="module")
def right(shared):
    """A leading wheelset in a curve to the right."""
    return shared(SCENE, FEW, output="right")


def test_its_columns_are_documented(right):
    documented(right)


def test_equilibrium_in_a_curve(right):
    """Shift and yaw as with 16 elements."""
    row = row_of(right)
    y, yaw = row["lateral_shift_m"], row["yaw_rad"]
    assert near(y, -5.743e-3, 2e-5)
    assert near(yaw, -1.442e-3, 3e-5)
    assert row["residual"] < 1e-8
    assert abs(row["energy_error"]) < 1e-9
    assert near(row["yaw_moment_Nm"], 1e7 * (-0.9 / 300 - yaw), 1e-3), "moment of the suspension"
    assert near(row["pitch_rate_rad/s"], -(1 + row["axle_excess"]) * 20 / 0.46, 1e-5), "rolling radius"
    assert near(row["right_creep_work_J/m"], 28.65, 0.5) and near(row["left_creep_work_J/m"], 62.1, 2)
    assert row["bound_lateral_shift_m"] > abs(y + 5.743e-3), "the error covers it"
    assert near(row["creep_work_J/m"], row["drag_N"] + row["yaw_moment_Nm"] / 300, 0.3), "drag and moment do the work of friction"
    assert row["right_force_y_N"] < -8e3 and row["left_force_y_N"] > 8e3, "one side of the other"
    assert row["left_steepest_angle_rad"] > 0.3, "the flange is at the left"


@pytest.mark.parametrize("side", SIDES)
def test_states_of_the_wheels(right, side):
    row, wheel = row_of(right), right.results.record(side=side)
    force, load = row[f"{side}_force_y_N"], row[f"{side}_load_N"]
    assert near(row[f"{side}_force_y/load"], force / load, 1e-5)
    assert near(wheel["force_track_y_N"], force, 150)
    assert near(wheel["force_track_z_N"], load, 1)
    assert near(wheel["max_pressure_Pa"] / row[f"{side}_max_pressure_Pa"], 1, 0.02)
    files = f"interface_{side}.vtu", f"across_{side}.csv", f"profiles_{side}.svg"
    assert right.has(*files)
    assert all(f'"{file}"' in right.text("run.json") for file in files)


def test_the_curve_to_the_left_is_the_mirror_image(program, right):
    """To the last digit."""
    mine, others = row_of(program(SCENE, FEW, {"Wheelset/Curve radius": -300})), row_of(right)
    for name in ("load_N", "creep_work_J/m", "max_pressure_Pa", "force_x_N"):
        assert mine[f"right_{name}"] == others[f"left_{name}"] != "", name
    for name in ("lateral_shift_m", "yaw_rad", "roll_rad", "yaw_moment_Nm"):
        assert mine[name] == -others[name] != 0, name


def test_rails_that_give_way(program, right):
    """Both stay in balance with the suspension at about the same place on their rails. Damage is linear from 15 N to 1e-5 at 65 N."""
    run = program(SCENE, FEW, {"Wear/Report": "true", "Output/Body fields": "false", "Wheelset/Rail lateral stiffness": 2e7},
                  says="a wheelset writes fields of its contacts only")
    row, y = row_of(run), row_of(right)["lateral_shift_m"]
    for side in SIDES:
        assert near(row[f"{side}_rail_shift_m"], -row[f"{side}_force_y_N"] / 2e7, 2e-8), f"{side}: moved by its wheel"
        assert run.has(f"shakedown_{side}.svg")
        assert "wear_rail_usfd_m" in run.text(f"across_{side}.csv")
    assert row["lateral_shift_m"] < y - 0.2e-3, "further out"
    assert near(row["lateral_shift_m"] - row["left_rail_shift_m"], y, 4e-4), "on its rail, as before"
    assert row["residual"] < 1e-7
    inner, outer = (run.results.record(side=side) for side in SIDES)
    assert near(inner["t_gamma_damage"], (inner["dissipation_J/m"] - 15) * 2e-7, 1e-11)
    assert outer["wear_usfd_mm2/km"] > inner["wear_usfd_mm2/km"]


def test_several_curves_in_one_walk(program):
    """Nothing holds the wheelset, so that it hunts, with the wavelength of its frequency."""
    run = program(SCENE, FEW, {"Wheelset/Curve radius": "3000, 1500", "Wheelset/Yaw stiffness": 0, "Wheelset/Mass": 1500,
                               "Wheelset/Yaw inertia": 1000, "Wheelset/Axle inertia": 100})
    row = row_of(run)
    assert len(run.table("wheelset.csv")) == 2 and len(run.results) == 4
    assert run.has("wheelset.svg", "interface_left_2.vtu")
    assert abs(row["yaw_moment_Nm"]) < 1e-6, "free to turn"
    assert near(row["lateral_shift_m"], -1.247e-3, 5e-5)
    assert row["hunting_growth_1/s"] > 0.05 and row["critical_speed_m/s"] < 20
    assert near(row["hunting_wavelength_m"] * row["hunting_frequency_Hz"], 20, 1e-5)
    assert 3 < row["hunting_wavelength_m"] < 40


def test_a_shift_that_is_given(program):
    """It has no error, and the force that holds it is found."""
    row = row_of(program(SCENE, FEW, {"Wheelset/Curve radius": 2000, "Wheelset/Lateral shift": -0.002}))
    assert row["bound_lateral_shift_m"] == "" and row["lateral_shift_m"] == -0.002
    assert near(row["lateral_force_N"], -row["right_force_y_N"] - row["left_force_y_N"], 1)


DISTURBED = {"Mesh/Elements across patch": 5, "Wheel/Density": 7850, "Rail/Density": 7850, "Modes/Maximum frequency": 3500,
             "Stability/Count check": "false"}
ROWS = """name, Contact/Speed, Stability/Added damping, Wheelset/Half wheelbase
as it is, 20, 0, 0.9
damped, 20, 0.01, 0.9
trailing, 10, 0, -0.9
"""


@pytest.fixture(scope="module")
def rows(shared):
    """Both wheels of that place disturbed, as they are and damped, and those of the trailing wheelset."""
    return shared(SCENE, DISTURBED, {"Analysis": "stability map", "Stability/Wheel": "both",
                                     "Table/File of rows": shared.write("rows.csv", ROWS)}, output="rows")


def test_rows_of_both_wheels(rows):
    """There is an equilibrium for each row that moves the wheelset, whose axle turns as the row rolls."""
    leading, trailing = rows.table("wheelset.csv").records()
    for row, speed in ((leading, 20), (trailing, 10)):
        assert near(row["pitch_rate_rad/s"], -(1 + row["axle_excess"]) * speed / 0.46, 1e-5)
    assert near(leading["lateral_shift_m"], -5.743e-3, 3e-5)
    assert trailing["lateral_shift_m"] > leading["lateral_shift_m"] + 2e-3
    left, right = (rows.results.record(wheel=side, name="damped") for side in ("left", "right"))
    assert left["Profiles/Lateral shift"] + right["Profiles/Lateral shift"] == 0, "the left-hand wheel in the mirror"
    assert left["largest_growth_1/s"] < -30
    assert rows.results.record(wheel="left", name="as it is")["largest_growth_1/s"] > 2


def test_bars_with_names(rows):
    assert "'as it is' 1, 'damped' 2, 'trailing' 3" in rows.text("growth.gp") and rows.has("growth.svg")
    bars, wheel = [], ""
    for line in rows.text("growth.dat").splitlines():
        if "hand wheel" in line:
            wheel = line.split()[1]
        elif line[:1] in set("-0123456789"):
            bars.append((wheel, float(line.split()[0])))
    assert bars == [(f"{side}-hand", rows.results.record(wheel=side, name=name)["largest_growth_1/s"])
                    for side in SIDES for name in ("as it is", "damped", "trailing")]


def test_the_left_hand_wheel_alone_is_the_same_but_for_its_mesh(program, rows):
    run = program(SCENE, DISTURBED, {"Analysis": "stability", "Stability/Wheel": "left"})
    of_row = rows.results.record(wheel="left", name="as it is")
    fastest = max(run.table("stability.csv").records(), key=lambda row: row["growth_1/s"])
    assert abs(fastest["frequency_Hz"] / of_row["fastest_Hz"] - 1) < 1e-3
    assert abs(fastest["growth_1/s"] / of_row["largest_growth_1/s"] - 1) < 0.08
    assert of_row["fastest_mode"] != "" and of_row["fastest_mode"] == fastest["wheel_mode_name"]
    assert row_of(run)["curve_radius_m"] == 300 and row_of(run)["left_load_N"] == 60e3


BOGIE = {"Mesh/Elements across patch": 5, "Wheelset/Secondary yaw stiffness": 1e6}
INERTIA = {"Wheelset/Mass": 1500, "Wheelset/Yaw inertia": 1000, "Wheelset/Axle inertia": 100}


def wheelsets(run):
    return [run.table("wheelset.csv").record(wheelset=name) for name in ("leading", "trailing")]


def test_a_bogie(program):
    """Two rows of its wheelsets, whose forces hold its frame; in the mirror."""
    run = program("bogie_curve", BOGIE, INERTIA, {"Wheelset/Curve radius": 3000, "Wheelset/Frame yaw": -1e-4, "Wheelset/Frame mass": 2500,
                                                  "Wheelset/Frame yaw inertia": 2500}, output="bogie")
    leading, trailing = wheelsets(run)
    yf, psi = leading["frame_shift_m"], leading["frame_yaw_rad"]
    for name, row, a in (("leading", leading, 1.28), ("trailing", trailing, -1.28)):
        force = 7.8e6 * (yf + a * psi - 1.28 ** 2 / 6000 - row["lateral_shift_m"])
        assert (row["lateral_force_N"] - force) ** 2 < 0.1, f"force on the {name} wheelset"
        moment = 1e7 * (psi - a / 3000 - row["yaw_rad"])
        assert (row["yaw_moment_Nm"] - moment) ** 2 < 0.1, f"moment on the {name} wheelset"
        assert run.has(f"interface_{name}_left.vtu", f"profiles_{name}_right.svg")
    h1, h2 = leading["lateral_force_N"], trailing["lateral_force_N"]
    assert abs(h1 + h2) < 1e-2 and h1 > 1e3, "forces on its frame"
    moments = 1.28 * (h1 - h2) + leading["yaw_moment_Nm"] + trailing["yaw_moment_Nm"]
    assert near(moments, 1e6 * (-1e-4 - psi), 0.1), "moments on its frame"
    assert leading["hunting_frequency_Hz"] > 0.5 and leading["critical_speed_m/s"] > 40 and leading["hunting_growth_1/s"] < -1
    assert run.results.columns[:2] == ["wheelset", "side"]
    assert [row[:2] for row in run.results.rows] == [[name, side] for name in ("leading", "trailing") for side in SIDES]
    mirrored, last = wheelsets(program("bogie_curve", BOGIE, {"Wheelset/Curve radius": -3000, "Wheelset/Frame yaw": 1e-4}, output="left"))
    assert last["frame_shift_m"] == -yf and mirrored["frame_yaw_rad"] == -psi
    assert mirrored["lateral_force_N"] == -h1


MAP = {"Analysis": "stability map", "Stability/Wheel": "left"}
ONE = {"Analysis": "stability", "Stability/Wheel": "left"}
FRAME = {"Wheelset/Vehicle": "bogie"}


@pytest.mark.parametrize("settings, says", [
    ({"Contact/Vertical load": 5e4}, "Wheelset/Axle load; leave Contact/Normal load"),
    ({"Profiles/Contact surface": "plane"}, "set Profiles/Contact surface = curved"),
    ({"Wheelset/Curve radius": 5}, "Wheelset/Curve radius = 5: give metres, at least 10"),
    ({"Wheelset/Curve radius": "300, -300"}, "go to the same side"),
    ({"Contact/Friction coefficient": 0}, "nothing steers"),
    ({"Wheelset/Axle load": 0}, "Wheelset/Axle load = 0"),
    ({"Wheelset/Rail lateral stiffness": 2e7, **INERTIA}, "leave it empty with Wheelset/Mass"),
    ({"Wheelset/Mass": 1500}, "give Wheelset/Yaw inertia"),
    (FRAME, "Wheelset/Lateral stiffness = 0"),
    ({**FRAME, "Wheelset/Half wheelbase": -0.9}, "Wheelset/Half wheelbase = -0.9: that of a bogie"),
    ({"Wheelset/Secondary yaw stiffness": 1e5}, "set Wheelset/Vehicle = bogie"),
    ({**FRAME, **INERTIA, "Wheelset/Lateral stiffness": 1e6}, "give Wheelset/Frame mass"),
    ({**ONE, **FRAME, "Wheelset/Lateral stiffness": 1e6, "Wheel/Density": 7850, "Rail/Density": 7850},
     "it disturbs wheels of one wheelset"),
    ({"Wheelset/Yaw": 0.001}, "Wheelset/Yaw and Wheelset/Yaw stiffness"),
    ({**MAP, "Stability/Wheel": "both", "Table/Axis 1": "Wheelset/Curve radius=300 : 600 : 2"}, "a grid has one wheel"),
    ({**MAP, "Table/Axis 1": "Profiles/Lateral shift=0 : 0.001 : 2"},
     "Profiles/Lateral shift has no effect: place and motion of a wheelset are found"),
    ({**MAP, "Table/Axis 1": "Profiles/Pitch rate=-43 : -42 : 2", "Profiles/Creepages": "from kinematics"},
     "Profiles/Pitch rate has no effect"),
    ({**ONE, "Wheelset/Curve radius": "300, 600"}, "has several values"),
    ({**ONE, "Contact/Vertical load": 5e4}, "leave Contact/Normal load"),
])
def test_refused(program, settings, says):
    program.refuses(SCENE, says, settings)


def test_files_that_are_refused(program):
    program.refuses(SCENE, "Wheelset/Left wheel profile or Left rail profile", {"Wheelset/Left wheel profile": "none.txt"}, options=VALIDATE)
    twice = program.write("twice.csv", "name, Stability/Added damping\none, 0\none, 0.01\n")
    program.refuses(SCENE, "line 3: its name, 'one', is empty or that of another row", MAP, {"Table/File of rows": twice})


def test_beyond_what_friction_and_flange_carry(program):
    run = program(SCENE, FEW, {"Wheelset/Lateral force": "-300e3"}, code=2, says="lift a wheel off its rail")
    assert not (run / "wheelset.csv").exists()
