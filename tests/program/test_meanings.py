"""Every number a user reads means what its name and unit say: columns, summaries and fields of runs against formulas
written here again. Every column of results.csv and history.csv must have been looked at by name once."""

import csv
import functools
import math
import re

import pytest
import vtu
from conftest import HERE, LIGHT, QUICK, near

MU, STEEL, NU, RADIUS, CROWN, WIDTH = 0.3, 210e9, 0.3, 0.46, 0.3, 0.02
MODULUS, SHEAR = STEEL / 2 / (1 - NU**2), STEEL / 2 / (1 + NU)
CONDUCTIVITY, DENSITY, HEAT_CAPACITY = 50.0, 7800.0, 460.0
UNITS = {"traction": "Pa", "pressure": "Pa", "traction_size": "Pa", "traction_bound": "Pa", "recovered_traction": "Pa",
         "recovered_pressure": "Pa", "slip": None, "gap": "m", "area": "m^2", "state": None,
         "friction_coefficient": None, "sliding_speed": "m/s", "flash_temperature": "K"}
OPEN, STICK = 0, 2
known, looked_at = set(), set()

SHORT = {"Output/Body fields": "false", "Time/Field interval": 0}
STEPS = {**SHORT, "Time/End time": 80e-6}
RUNS = {
    "state_2d": ("carter_2d_partial_slip", {"Mesh/Patch offset": 0.25, "Contact/Speed": 20}),
    "levels_2d": ("adaptive_2d", {"Mesh/Adaptive levels": 2}),
    "state_3d": ("combined_3d", {"Mesh/Elements across patch": 14}),
    "loads": ("carter_2d_partial_slip", {**QUICK, "Analysis": "load curve", "Load curve/Shares of load": 1}),
    "damped": ("oscillating_creepage_2d", {**STEPS, "Time/Theta": 0.5, "Time/Rayleigh beta": 1e-9}),
    "numerical": ("oscillating_creepage_2d", {**STEPS, "Time/Theta": 0.7}),
    "falling": ("oscillating_creepage_2d", {**STEPS, "Contact/Friction law": "exponential", "Contact/Kinetic friction coefficient": 0.12,
                                            "Contact/Friction decay speed": 1}),
    "impact": ("impact_2d", {**SHORT, "Mesh/Growth": 0.4, "Time/Time step": 1e-6, "Time/End time": 20e-6}),
    "rolling_3d": ("start_up_3d", {**SHORT, **LIGHT, "Time/Rolled distance": 8e-3, "Contact/Spin": 0.4})}


class Row(dict):
    """A row of a table that notes which of its columns are read."""

    def __getitem__(self, name):
        looked_at.add(name)
        text = super().__getitem__(name)
        try:
            return float(text)
        except ValueError:
            return text


def rows(run, name="results.csv"):
    table = run.table(name)
    known.update(table.columns)
    return [Row(zip(table.columns, row)) for row in table.rows]


def all_near(row, relative, expected):
    """Columns of a row by their names."""
    for name, value in expected.items():
        near(row[name], value, relative, what=name)


def line_contact(load):
    """Half-width, pressure and creepage at saturation of two equal discs."""
    a = math.sqrt(4 * load / WIDTH * RADIUS / 2 / math.pi / MODULUS)
    return a, 2 * load / WIDTH / math.pi / a, MU * a / (RADIUS / 2)


def elliptic(m):
    """Complete elliptic integrals K and E by the arithmetic-geometric mean."""
    a, g, c, total, power = 1.0, math.sqrt(1 - m), math.sqrt(m), m / 2, 0.5
    while c > 1e-16:
        a, g, c, power = (a + g) / 2, math.sqrt(a * g), (a - g) / 2, 2 * power
        total += power * c * c
    return math.pi / 2 / a, math.pi / 2 / a * (1 - total)


def point_contact(load):
    """Semi-axes a > b, pressure and approach; gap A x^2 + B y^2."""
    A, B, low, high = 1 / RADIUS, 1 / CROWN, 1.0, 10.0
    for _ in range(200):
        ratio = (low + high) / 2
        K, E = elliptic(1 - 1 / ratio**2)
        if (ratio**2 * E - K) / (K - E) < B / A:
            low = ratio
        else:
            high = ratio
    b = (3 * load * E / (2 * math.pi * ratio * MODULUS * (A + B))) ** (1 / 3)
    pressure = 1.5 * load / math.pi / (ratio * b * b)
    return ratio * b, b, pressure, pressure / MODULUS * b * K


def kalker(a_over_b):
    """C11, C22, C23, C33 at nu = 0.3 and a > b from the published table."""
    with open(HERE.parent / "data/kalker_table_e3.csv", encoding="utf-8") as file:
        table = list(csv.DictReader(line for line in file if line[0] != "#"))
    at = {(float(r["b_over_a"] or r["a_over_b"]), float(r["poisson_ratio"])): r
          for r in table if r["b_over_a"] or r["a_over_b"] == "1"}
    low = math.floor(10 / a_over_b) / 10
    weight, result = 10 * (1 / a_over_b - low), []
    for name in ("C11", "C22", "C23", "C33"):
        zero, quarter, half = ((1 - weight) * float(at[low, nu][name]) + weight * float(at[round(low + 0.1, 1), nu][name])
                               for nu in (0.0, 0.25, 0.5))
        result.append(1 / (8 * (NU - 0.25) * (NU - 0.5) / zero - 16 * NU * (NU - 0.5) / quarter + 8 * NU * (NU - 0.25) / half))
    return result


def check_summary(run, row, two_forces):
    """The lines on the screen against the row: millimetres, MPa, percent."""
    number = r"(-?[\d.]+(?:e[-+]\d+)?)"
    load = re.search(f"N = {number} N at an approach of {number} mm; peak pressure {number} MPa, half-width {number} mm, {number} nodes",
                     run.screen)
    forces = f"\\({number}, {number}\\)" if two_forces else f"{number}()"
    force = re.search(f"T = {forces} N, \\|T\\|/N = {number}, \\|T\\|/\\(mu N\\) = {number}; stick on {number} %", run.screen)
    assert load and force, run
    said = [float(group) if group else 0.0 for group in load.groups() + force.groups()]
    expected = [row["normal_force_N"], 1e3 * row["approach_m"], 1e-6 * row["max_pressure_Pa"], 1e3 * row["half_width_x_m"],
                row["nodes_in_contact"], row["force_x_N"], row["force_y_N"], row["traction_coefficient"],
                row["traction_coefficient"] / MU, 100 * row["stick_area_m2"] / row["contact_area_m2"]]
    assert len(said) == len(expected)
    for i, pair in enumerate(zip(said, expected)):
        near(*pair, 5e-3 if i == 9 else 1e-4, 1e-9)


def check_fields(path, row):
    """Fields at the nodes against the row: units, extremes and sums."""
    field, units = vtu.nodes(path)
    assert {name: unit for name, unit in units.items() if name != "points"} == {name: UNITS[name] for name in units if name != "points"}
    area, state = field["area"], field["state"]
    p, q = field["pressure"], field["traction"]

    def total(values):
        return sum(a * value for a, value in zip(area, values))

    load = row["normal_force_N"]
    near(max(p), row["max_pressure_Pa"], 1e-6)
    near(total(p), load, 1e-5)
    near(total(t[0] for t in q), row["force_x_N"], 0, 1e-5 * load)
    near(total(t[1] for t in q), row["force_y_N"], 0, 1e-5 * load)
    if "centre_x_m" in row:
        for axis, name in enumerate(("centre_x_m", "centre_y_m")):
            if axis == 0 or row["half_width_y_m"] > 0:
                near(total(x[axis] * pressed for x, pressed in zip(field["points"], p)) / load, row[name], 1e-5, 1e-9)
    moment = total(x[0] * t[1] - x[1] * t[0] for x, t in zip(field["points"], q))
    if "spin_moment_Nm" in row and "half_width_y_m" in row and row["half_width_y_m"] > 0:
        near(moment, row["spin_moment_Nm"], 1e-4, 1e-8 * load)
    near(max(field["traction_size"]), max(math.hypot(*t) for t in q), 1e-6)
    bound = field["traction_bound"]
    assert all(b <= MU * (1 + 1e-6) * s for b, s in zip(bound, p))
    near(total(bound), MU * load, 0.05)
    recovered_p, recovered_q = field["recovered_pressure"], field["recovered_traction"]
    near(max(recovered_p), max(p), 0.02)
    assert all(r == 0 for r, s in zip(recovered_p, state) if s == OPEN), "pressure where none is"
    assert all(math.hypot(*t) <= MU * (1 + 1e-5) * r + 1 for t, r in zip(recovered_q, recovered_p))
    near(total(t[0] for t in recovered_q), row["force_x_N"], 0, 0.04 * load)
    near(total(t[1] for t in recovered_q), row["force_y_N"], 0, 0.04 * load)
    assert all(0 < gap < 1e-3 for gap, s in zip(field["gap"], state) if s == OPEN)
    touching = [s != OPEN for s in state]
    assert sum(touching) == row["nodes_in_contact"]
    if "contact_area_m2" in row: # inside the outlines, which cut the boxes of the nodes at them
        whole, stick = row["contact_area_m2"], row["stick_area_m2"]
        assert 0.7 * total(touching) < whole < 1.02 * total(touching)
        sticking = total(s == STICK for s in state)
        assert 0.7 * sticking <= stick <= 1.1 * sticking
        assert 0 <= stick <= whole
        assert len(state) == row["contact_nodes"]
    else:
        assert state.count(STICK) == row["nodes_sticking"]
    return field


def check_solution(row):
    """What every solved state has."""
    assert row["converged"] == "true" and row["solver"] != ""
    assert 0 <= row["residual_normal"] < 1e-9 and 0 <= row["residual_tangential"] < 1e-9
    assert row["iterations"] == row["normal_solves"] + row["tangential_solves"]
    assert 1 <= row["passes"] <= row["iterations"]
    assert row["corrections"] == 0
    assert 0 < row["wall_s"] < 600
    assert all(abs(row[name]) < 1e-8 for name in row if name.startswith("invariant_"))
    load, force = row["normal_force_N"], math.hypot(row["force_x_N"], row["force_y_N"])
    near(row["traction_coefficient"], force / load, 1e-8)
    work, heat = row["creep_work_J/m"], row["dissipation_J/m"]
    near(work, -(row["force_x_N"] * row["creepage_x"] + row["force_y_N"] * row["creepage_y"]
                 + row["spin_moment_Nm"] * row["spin_1/m"]), 1e-7)
    near(heat, work, 2e-3) # bodies that mirror each other roll without resistance
    near(row["energy_error"], abs(work - heat) / max(work, heat), 1e-4, 1e-8)


def check_bounds(run, row, mesh, n, growth, tolerance):
    """Smooth thick bodies of one steel: the state's own estimate is below c/n^p, and not
    by orders of magnitude; the peak has 2/n^2, the mesh's growth and the residual. The approach is given."""
    bulk = growth * min(1, 4 * growth)
    growth_share, residual = 2e-3 * growth + 1e-2 * bulk, 4 * row["residual_tangential"]
    for name in ["bound_force/muN"] + (["bound_moment/muNa"] if "bound_moment/muNa" in row else []):
        assert 0.05 * mesh < row[name] < mesh + growth_share + residual
    error = next(e for e in run.json["errors"] if e["quantity"] == "force")
    near(error["value"], row["bound_force/muN"], 1e-6)
    near(sum(map(float, re.findall(r"([\d.]+e-\d+) for", error["reference"]))), error["value"], 0.02)
    near(row["bound_max_pressure"], 2 / n**2 + 4e-3 * growth + 1.6e-2 * bulk + 4 * row["residual_normal"], tolerance)
    heat = mesh + residual + 2e-3 * growth / MU
    assert heat < row["bound_dissipation"] < 10 * heat
    assert 0 < row["bound_normal_force"] < 0.05, "the load follows from an approach: a few per cent on coarse meshes"


def check_line_contact(row, elements):
    a, pressure, saturation = line_contact(row["normal_force_N"])
    z = row["creepage_x"] / saturation
    assert row["creepage_x"] == 0.0017
    assert all(row[name] == 0 for name in ("creepage_y", "spin_1/m", "half_width_y_m", "force_y_N", "spin_moment_Nm"))
    near(row["approach_m"], 0.22e-3, 1e-8)
    near(row["half_width_x_m"], a, 0.02)
    near(row["max_pressure_Pa"], pressure, 0.01)
    size = 2 * a / elements * WIDTH
    near(row["contact_area_m2"], 2 * a * WIDTH, 0, size / 4)
    near(row["stick_area_m2"], 2 * a * (1 - z) * WIDTH, 0, size / 2)
    near(row["nodes_in_contact"], elements, 0, 2)
    near(row["reference_half_width_x_m"], a, 1e-6)
    near(row["reference_max_pressure_Pa"], pressure, 1e-6)
    assert 0 < row["error_pressure_l2"] < 0.05
    near(row["reference_normal_force_N"], 140760, 1e-4)
    near(row["error_normal_force"], row["normal_force_N"] / row["reference_normal_force_N"] - 1, 1e-5, 1e-8)
    near(row["reference_force_x/muN"], z * z - 2 * z, 1e-6) # Carter's
    near(row["error_force_x/muN"], row["force_x_N"] / (MU * row["normal_force_N"]) - row["reference_force_x/muN"], 1e-4, 1e-8)
    assert 0 < row["error_traction_l2"] < 0.05
    assert 0 <= row["error_sawtooth"] < 0.035
    assert abs(row["error_stick_boundary_elements"]) <= 1


def state_2d(run):
    (row,) = rows(run)
    check_solution(row)
    check_line_contact(row, 48)
    check_bounds(run, row, 1.3 / 48**2, 48, 0.1, 0.05)
    assert abs(row["error_force_x/muN"]) < row["bound_force/muN"] + 5e-4, "Carter is inside the bound and what discs differ by"
    assert (row["level"], row["elements_across"], row["patch_offset"], row["slip_operator"]) == (0, 48, 0.25, "calibrated")
    # of one of the twins; nodes of the hub have none
    near(row["dofs"], 2 * len(vtu.nodes(run / "wheel.vtu")[0]["points"]), 0.07)
    check_summary(run, row, False)
    field = check_fields(run / "interface.vtu", row)
    near(row["flash_temperature_K"], max(field["flash_temperature"]), 1e-6)
    near(row["surface_temperature_K"], 293.15 + row["flash_temperature_K"], 1e-6)
    for body in ("wheel", "rail"):
        near(row[f"heat_to_{body}_W"], row["dissipation_J/m"] * 20 / 2, 1e-6)
    touching = [k for k, p in enumerate(field["pressure"]) if p > 0]
    near(row["mean_flash_temperature_K"], sum(field["flash_temperature"][k] * field["area"][k] for k in touching)
         / sum(field["area"][k] for k in touching), 1e-6)
    # a band of even heat, a half of it for each body, at 20 m/s: 2 q sqrt(l / (pi k rho c V))
    slips = 2 * row["half_width_x_m"] * (1 - row["stick_area_m2"] / row["contact_area_m2"])
    heat = row["dissipation_J/m"] * 20 / (2 * slips * WIDTH)
    near(row["flash_temperature_K"], 2 * heat * math.sqrt(slips / (math.pi * CONDUCTIVITY * DENSITY * HEAT_CAPACITY * 20)), 0.15)


def levels_2d(run):
    levels = rows(run)
    assert [(row["level"], row["elements_across"]) for row in levels] == [(0, 24), (1, 24), (2, 24)] # of the first
    before, row = levels[-2:]
    load = row["normal_force_N"]
    near(row["change"], abs(row["force_x_N"] - before["force_x_N"]) / (MU * load), 0.5, 1e-4)
    near(row["extrapolated_normal_force_N"], load, 1e-3)
    near(row["extrapolated_force_x_N"], row["reference_force_x/muN"] * MU * load, 5e-3)
    assert row["extrapolated_force_y_N"] == 0
    near(row["extrapolated_approach_m"], 0.22e-3, 1e-8)
    near(row["estimated_error"], 0, 0, 5e-3)
    near(row["extrapolation_error"], 0, 0, 5e-3)


def state_3d(run):
    (row,) = rows(run)
    check_solution(row)
    load = row["normal_force_N"]
    a, b, pressure, approach = point_contact(load)
    near(row["half_width_x_m"], a, 0.04)
    near(row["half_width_y_m"], b, 0.08)
    all_near(row, 0.01, {"contact_area_m2": math.pi * a * b, "max_pressure_Pa": pressure})
    all_near(row, 1e-6, {"reference_half_width_x_m": a, "reference_half_width_y_m": b, "reference_max_pressure_Pa": pressure,
                         "reference_approach_m": approach})
    near(row["approach_m"], 7e-5, 1e-8)
    x, y, spin = row["creepage_x"], row["creepage_y"], row["spin_1/m"]
    assert (x, y, spin) == (0.001, -0.0015, 0.4)
    c11, c22, c23, c33 = kalker(a / b)
    c = math.sqrt(a * b)
    linear = (-SHEAR * c * c * c11 * x, -SHEAR * c * c * (c22 * y - c * c23 * spin))
    all_near(row, 1e-6, {"kalker_force_x_N": linear[0], "kalker_force_y_N": linear[1],
                         "kalker_spin_moment_Nm": -SHEAR * c**3 * (c23 * y + c * c33 * spin)})
    share = math.hypot(*linear) / (MU * load)
    saturated = (1 - share / 3 + share**2 / 27) if share < 3 else 1 / share
    for axis, value in zip("xy", linear):
        near(row[f"shen_force_{axis}_N"], value * saturated, 1e-6)
        near(row[f"force_{axis}_N"], value * saturated, 0.1)
        near(row[f"fastsim_force_{axis}_N"], row[f"force_{axis}_N"], 0.05)
    check_bounds(run, row, 0.5 / 14**1.5, 14, 0.4, 0.1)
    check_summary(run, row, True)
    check_fields(run / "interface.vtu", row)


def loads(run):
    """dN/d(approach) of a line contact that grows as N^1.1."""
    (row,) = rows(run)
    near(row["contact_stiffness_N/m"], 1.11 * row["normal_force_N"] / row["approach_m"], 0.03)


def check_energy(history):
    """What was supplied is stored or gone; one column each."""
    first = history[0]
    for row in history[1:]:
        gain = sum(row[name] - first[name] for name in ("kinetic_J", "strain_J"))
        given = row["supplied_J"] - first["supplied_J"]
        for name in ("friction_J", "damping_J", "numerical_J"):
            given -= row[name] - first[name]
            assert row[name] >= first[name] >= 0
        near(gain, given, 1e-5, 1e-7 * (row["kinetic_J"] + row["strain_J"]))
        assert abs(row["energy_balance_error"]) < 1e-10


def vibration(run, theta, smooth=True):
    """Discs at 10 m/s, the creepage oscillates at 1 kHz."""
    history, heat = rows(run, "history.csv"), 0.0
    assert len(history) == 40
    for number, row in enumerate(history, 1):
        time = number * 2e-6
        assert row["step"] == number
        assert row["speed_m/s"] == 10
        load, force = row["normal_force_N"], abs(row["force_x_N"])
        all_near(row, 1e-8, {"time_s": time, "force_time_s": time - (1 - theta) * 2e-6, "rolled_m": 10 * time, "approach_m": 0.22e-3,
                             "creepage_x": 0.0017 + 0.001 * math.sin(2000 * math.pi * time), "traction_coefficient": force / load})
        near(load, 140760, 5e-3)
        near(row["max_pressure_Pa"], line_contact(load)[1], 0.01)
        near(row["nodes_in_contact"], 24, 0, 2)
        assert row["iterations"] >= 1 and row["parts"] == 1
        assert row["impacts"] <= 1
        near(row["strain_J"], load * 0.22e-3 / 2, 0.08) # a contact softer than linear stores a little less than half
        if smooth:
            assert 0 < row["nodes_sticking"] < row["nodes_in_contact"]
            assert 0 < row["kinetic_J"] < 1e-3 * row["strain_J"]
            near(row["friction_J"] - heat, force * row["creepage_x"] * 20e-6, 0.25)
        heat = row["friction_J"]
    check_energy(history)
    last, (row,) = history[-1], rows(run)
    all_near(row, 1e-8, {name: last[name] for name in ("time_s", "rolled_m", "approach_m", "creepage_x", "normal_force_N", "force_x_N",
                                                       "max_pressure_Pa", "nodes_in_contact", "traction_coefficient")})
    if smooth:
        check_fields(run / "interface-0000040.vtu", last)
    return last


def damped(run):
    last = vibration(run, 0.5)
    assert last["damping_J"] > 0 and last["numerical_J"] == 0


def numerical(run):
    last = vibration(run, 0.7)
    assert last["numerical_J"] > 0 and last["damping_J"] == 0
    assert last["force_time_s"] < last["time_s"], "forces act before the end of a step"
    assert " N at t = " not in run.screen, "a constant load has no peak"


def falling(run):
    """Friction that falls makes the discs jerk: a ratio, rounds of the law."""
    assert vibration(run, 0.505, smooth=False)["several_solutions_ratio"] > 0
    (row,) = rows(run)
    assert 1 <= row["friction_rounds"] < 100


def impact(run):
    """A ring of 40 mm dropped with 1 m/s, its hub free, on a block."""
    history = rows(run, "history.csv")
    first, last = history[0], history[-1]
    energy = 0.5 * 7800 * math.pi * (0.05**2 - 0.01**2) * 0.01
    near(first["kinetic_J"], energy, 0.02)
    near(last["kinetic_J"] + last["strain_J"], energy, 0.02)
    assert last["strain_J"] > 1e-3
    assert sum(row["impacts"] for row in history) >= last["nodes_in_contact"] > 0, "nodes close"
    assert any(row["impacts"] == 0 for row in history[3:]) and all(row["impacts"] <= row["nodes_in_contact"] for row in history)
    assert -1 < first["velocity_z_m/s"] < -0.5 and abs(last["velocity_z_m/s"]) < 1e-3, "the contact comes to rest"
    assert last["velocity_x_m/s"] == last["velocity_y_m/s"] == 0, "no friction, no motion along"
    mass = 2 * (first["kinetic_J"] + first["strain_J"])  # at 1 m/s
    impulse = sum(row["normal_force_N"] for row in history) * 1e-6
    velocity = last["wheel_velocity_m/s"]
    near(mass * (velocity + 1), impulse, 5e-4)
    assert -1 < velocity < -0.5, "it still falls"
    (row,) = rows(run)
    near(row["wheel_velocity_m/s"], velocity, 1e-8)
    assert f"moves along z at {velocity:.6g} m/s" in run.screen
    largest = max(history, key=lambda row: row["normal_force_N"])
    assert f"N = {largest['normal_force_N']:.6g} N at t = {largest['force_time_s']:.6g} s" in run.screen
    check_energy(history)


def rolling_3d(run):
    last, (row,) = rows(run, "history.csv")[-1], rows(run)
    near(last["rolled_m"], 8e-3, 1e-8)
    near(last["force_time_s"], last["time_s"], 1e-12)
    assert (last["creepage_y"], last["spin_1/m"]) == (0.003, 0.4)
    all_near(row, 1e-8, {name: last[name] for name in ("force_y_N", "spin_moment_Nm", "creepage_y", "spin_1/m")})
    check_fields(run / "interface-0000010.vtu", row)
    near(last["force_y_N"] / MU / last["normal_force_N"], -0.35, 0, 0.3)
    near(last["supplied_J"], last["strain_J"] + last["friction_J"] + last["numerical_J"], 1e-6)


@pytest.fixture(scope="module")
def meaning(shared):
    """A run and its function above, once, whoever asks."""
    return functools.cache(lambda name: globals()[name](shared(*RUNS[name], output=name)))


@pytest.mark.parametrize("name", RUNS)
def test_what_is_meant(meaning, name):
    meaning(name)


def test_every_column_was_looked_at(meaning):
    for name in RUNS:
        meaning(name)
    assert not known - looked_at
