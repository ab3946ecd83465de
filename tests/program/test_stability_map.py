"""Maps of stability: what a row tells, symmetry, threads, a stopped run, root loci, and that a state of a map is the one of
Analysis = stability."""

import math
import re

import pytest
from conftest import HERE, RESUME, VALIDATE, charts

PAIR = HERE / "pair.prm"
MAP = {"Analysis": "stability map"}
AXES = {"Table/Axis 1": "Contact/Friction coefficient = 0.2, 0.41", "Table/Axis 2": "Contact/Creepage y = -0.02, 0, 0.02"}
REDUCED = {"Stability/Full model": "false"}
NO_STIFFNESS = {"Wheel/Rayleigh stiffness": 0, "Rail/Rayleigh stiffness": 0}
ADDED = "Stability/Added damping"


def states(run):
    rows = run.results.records()
    assert [row["state"] for row in rows] == list(range(len(rows)))
    return rows


def vibrations(row):
    """Frequency (Hz) and growth (1/s) of each that a row lists."""
    return [tuple(map(float, pair.split(":"))) for pair in row["vibrations"].split()]


@pytest.fixture(scope="module")
def friction_map(shared):
    """Friction over lateral creepage, which has two signs."""
    return shared(PAIR, MAP, AXES, {"Table/Threads": 1}, output="map")


@pytest.fixture(scope="module")
def alone(shared):
    return shared(PAIR, {"Analysis": "stability"}, output="one")


def test_states_mirror_each_other(friction_map):
    rows = states(friction_map)
    for k in (0, 3):
        for column in ("n_unstable", "largest_growth_1/s", "fastest_Hz", "least_damping_ratio", "least_damped_Hz"):
            assert rows[k][column] == pytest.approx(rows[k + 2][column], rel=1e-6, abs=0), f"{k}: {column}"
    assert (rows[0]["n_unstable"], rows[3]["n_unstable"]) == (0, 1), "it squeals with much friction only"


def test_pictures_of_a_map(friction_map):
    """A cell of growth for each state, at its friction and creepage; the line of no growth is between states that grow and others."""
    assert friction_map.has("stability_map.svg", "stability_map_frequency.svg", "stability_map_count.svg")
    assert "set yrange [-0.03:0.03]" in friction_map.text("stability_map_frequency.gp"), "states without a vibration that grows are in it"
    assert "set cblabel '1/s; grey: none grows' " in friction_map.text("stability_map.gp")
    lines = friction_map.points("stability_map.dat")
    zero = [line for line in lines if len(line) == 2]
    cells = [line for line in lines if len(line) == 3]
    rows = states(friction_map)
    assert zero
    for mu, y in zero:
        near = [row["largest_growth_1/s"] for row in rows
                if abs(row["Contact/Friction coefficient"] - mu) < 0.2001 and abs(row["Contact/Creepage y"] - y) < 0.02001]
        assert min(near) < 0 < max(near), (mu, y)
    for row in rows:
        mu, y, growth = row["Contact/Friction coefficient"], row["Contact/Creepage y"], row["largest_growth_1/s"]
        corners = [v for a, b, v in cells if abs(a - mu) < 0.106 and abs(b - y) < 0.0101]
        assert sum(abs(v - growth) < 1e-6 * abs(v) for v in corners) >= 4, row
        listed = vibrations(row)
        assert sum(growth > 0 for _, growth in listed) == row["n_unstable"]
        ratio = -listed[0][1] / (2 * math.pi * listed[0][0])
        assert abs(ratio - row["least_damping_ratio"]) < 1e-3 * abs(ratio)


def test_a_map_without_vibrations_that_grow(program):
    run = program(PAIR, MAP, REDUCED, {"Table/Axis 1": "Contact/Friction coefficient = 0.05, 0.1",
                                       "Table/Axis 2": "Contact/Creepage y = -0.02, 0.02"})
    assert "set cblabel '1/s; none grows' " in run.text("stability_map.gp")


def test_a_state_is_that_of_the_stability_analysis(friction_map, alone):
    row = alone.table("stability.csv").record(unstable="true")
    assert 0.98 <= states(friction_map)[3]["largest_growth_1/s"] / row["growth_1/s"] <= 1.02
    assert re.search(f"the fastest at [0-9.]* Hz, mode {re.escape(row['wheel_mode_name'])}, by", friction_map.screen)
    assert re.search("growth of the fastest vibration.*the whole bodies, state 3", friction_map.text("run.json"))


def test_pictures_of_the_stability_analysis(alone):
    charts("stability", alone.folder)
    files = "\n".join(alone.files())
    assert re.search("^vibration_.*_wheel_23.vtu$", files, re.M) and re.search("^vibration_.*_rail_00.vtu$", files, re.M), "both bodies move"
    assert len(re.findall(r"\.pvd$", files, re.M)) == 1, "one vibration grows, one moves"


def same_numbers(run, other, relative):
    columns = ["state", "n_unstable", "largest_growth_1/s", "fastest_Hz", "least_damping_ratio", "force_x_N", "force_y_N", "n_border"]
    assert len(run.results) == len(other.results) == 6
    for column in columns:
        for x, y in zip(other.results[column], run.results[column]):
            assert abs(x - y) <= relative * max(abs(x), 1e-3), column


def test_two_threads(program, friction_map):
    same_numbers(program(PAIR, MAP, AXES, {"Table/Threads": 2}), friction_map, 0)


def test_a_stopped_map(program, friction_map):
    """Its states start from others than before."""
    folder = program.folder / "map"
    folder.mkdir()
    for path in friction_map.folder.iterdir():
        (folder / path.name).write_bytes(path.read_bytes())
    whole = (friction_map / "results.csv").read_bytes()
    (folder / "results.csv").write_bytes(b"".join(whole.splitlines(keepends=True)[:4]))
    same_numbers(program(PAIR, MAP, AXES, output="map", options=RESUME), friction_map, 1e-6)


def test_a_root_locus(program, alone):
    """Damping of the bodies' modes stops a vibration where it is said to, for the share that their frequencies have in its own.

    Growth ends by a straight line between the last two values, of which the map has the growths."""
    row = alone.table("stability.csv").record(unstable="true")
    before, after = states(program(PAIR, MAP, {"Table/Axis 1": f"{ADDED} = 0, 1e-4"}, output="damping"))
    growth = [state["largest_growth_1/s"] for state in (before, after)]
    share = (growth[0] - growth[1]) / (1e-4 * 2 * math.pi * before["fastest_Hz"])
    assert 0.3 <= share <= 1
    needed = row["damping_needed"] * row["growth_1/s"] / row["corrected_growth_1/s"] / share
    run = program(PAIR, MAP, {"Table/Axis 1": f"{ADDED} = 0, {0.95 * needed:.8g}, {1.05 * needed:.8g}"}, output="locus")
    locus = states(run)
    assert [state["n_unstable"] for state in locus] == [1, 1, 0]
    (a, g), (b, h) = ((state[ADDED], state["largest_growth_1/s"]) for state in locus[1:])
    assert f"along {ADDED} growth ends between {a:.4g} and {b:.4g}, by a straight line at {a + g / (g - h) * (b - a):.3g}" in run.screen
    assert run.has("root_locus.svg") and re.search("^# .*Hz", run.text("root_locus.dat"), re.M)


ROTATION = {"Stability/Rotation": "true", **REDUCED}
SPEEDS = {**ROTATION, "Table/Axis 1": "Contact/Speed = 1, 10, 20"}


def test_the_speed_turns_the_wheel_in_each_state(program):
    state = states(program(PAIR, MAP, SPEEDS, output="speeds"))[2]
    run = program(PAIR, {"Analysis": "stability", "Contact/Speed": 20}, ROTATION, output="fast")
    fastest = max(run.table("stability.csv").records(), key=lambda row: row["growth_1/s"])
    assert 0.9999 <= state["fastest_Hz"] / fastest["frequency_Hz"] <= 1.0001
    assert 0.99 <= state["largest_growth_1/s"] / fastest["growth_1/s"] <= 1.01


def test_rotation_parts_a_pair_in_proportion_to_the_speed(program):
    """A pair with three nodal diameters that the contact splits by s_0: s^2 = s_0^2 + (c V)^2, where no friction couples it to others."""
    splits = []
    for row in states(program(PAIR, MAP, SPEEDS, {"Contact/Friction coefficient": 0})):
        low, high = ([f for f, growth in vibrations(row) if a < f < b and growth > -100] for a, b in ((2790, 2835), (2865, 2910)))
        splits.append(high[0] - low[0])
    rates = [math.sqrt(s * s - splits[0] ** 2) for s in splits[1:]]
    assert 25 < rates[0] < 6 * 10 / (2 * math.pi * 0.2), splits
    assert 1.95 < rates[1] / rates[0] < 2.05, splits


def test_without_friction_nothing_grows(program):
    """Other bodies, as the contact has fewer displacements. Damping by mass alone, 10 1/s: all decay by half of it, and the least
    damped one is the highest."""
    smooth, rough = states(program(PAIR, MAP, NO_STIFFNESS, {"Table/Axis 1": "Contact/Friction coefficient = 0, 0.41"}))
    assert smooth["n_unstable"] == 0 and smooth["largest_growth_1/s"] < 0
    assert rough["n_unstable"] == 1 and rough["largest_growth_1/s"] > 20
    highest = max(f for f, _ in vibrations(smooth))
    assert abs(smooth["largest_growth_1/s"] + 5) < 1e-5
    assert abs(smooth["least_damped_Hz"] / highest - 1) < 1e-6
    assert abs(smooth["least_damping_ratio"] * 2 * math.pi * highest / 5 - 1) < 1e-5


EXPONENTIAL = {"Contact/Friction law": "exponential"}


def test_friction_that_falls_faster_than_its_memory_allows(program):
    """A real eigenvalue grows, as in the state by itself."""
    falling = {**EXPONENTIAL, "Contact/Kinetic friction coefficient": 0.1, "Contact/Friction decay speed": 0.3,
               "Contact/Friction response": "patch mean", **REDUCED, "Output/Plot": "false", **NO_STIFFNESS}
    run = program(PAIR, MAP, falling, {"Table/Axis 1": "Contact/Friction memory = 1e-6, 1e-4"}, output="memory",
                  says="1 state is unstable without any vibration")
    assert run.results["n_contact_unstable"] == [1, 0]
    program(PAIR, falling, {"Analysis": "stability", "Stability/Count check": "false", "Contact/Friction memory": "1e-6"}, output="alone",
            says="the state is unstable: 1 real eigenvalue, up to")


@pytest.mark.parametrize("settings, says", [
    (MAP, "Table/Axis 1 and Table/File of rows are both empty"),
    ({**MAP, "Table/Axis 1": "Contact/Friction coefficient = 0.4, 0.5", **EXPONENTIAL, "Contact/Kinetic friction coefficient": 0.2,
      "Contact/Friction decay speed": 1, "Contact/Friction memory": 0}, "Contact/Friction memory = 0: patch mean needs a delay"),
    ({"Analysis": "table", "Table/Axis 1": f"{ADDED} = 0, 0.1"}, "cannot vary between states"),
])
def test_refused(program, settings, says):
    program.refuses(PAIR, says, settings, options=VALIDATE)
