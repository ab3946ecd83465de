"""Columns, summaries and fields of runs against formulas written here again.

Usage: meanings.py RUN_FOLDER..., those of the script beside this file. Every
column of results.csv and history.csv must have been looked at by name once.
"""
import csv
import json
import math
import os
import re
import sys

import vtu

MU, STEEL, NU, RADIUS, CROWN, WIDTH = 0.3, 210e9, 0.3, 0.46, 0.3, 0.02
MODULUS, SHEAR = STEEL / 2 / (1 - NU**2), STEEL / 2 / (1 + NU)
CONDUCTIVITY, DENSITY, HEAT_CAPACITY = 50.0, 7800.0, 460.0
UNITS = {"traction": "Pa", "pressure": "Pa", "traction_size": "Pa", "traction_bound": "Pa", "recovered_traction": "Pa",
         "recovered_pressure": "Pa",
         "slip": None, "gap": "m", "area": "m^2", "state": None,
         "friction_coefficient": None, "sliding_speed": "m/s", "flash_temperature": "K"}
OPEN, STICK = 0, 2
known, looked_at, failures = set(), set(), []


class Row(dict):
    """A row of a table that notes which of its columns are read."""

    def __getitem__(self, name):
        looked_at.add(name)
        text = super().__getitem__(name)
        try:
            return float(text)
        except ValueError:
            return text


def rows(path):
    with open(path, newline="", encoding="utf-8") as file:
        result = [Row(row) for row in csv.DictReader(file)]
    known.update(result[0])
    return result


def check(what, good):
    if not good:
        failures.append(what)
        print(what)


def near(what, value, expected, relative, absolute=0.0):
    check(f"{what}: {value:.9g}, expected {expected:.9g}",
          abs(value - expected) <= relative * abs(expected) + absolute)


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
    path = os.path.join(os.path.dirname(__file__), "..", "data", "kalker_table_e3.csv")
    with open(path, encoding="utf-8") as file:
        table = list(csv.DictReader(line for line in file if line[0] != "#"))
    at = {(float(r["b_over_a"] or r["a_over_b"]), float(r["poisson_ratio"])): r
          for r in table if r["b_over_a"] or r["a_over_b"] == "1"}
    low = math.floor(10 / a_over_b) / 10
    weight, result = 10 * (1 / a_over_b - low), []
    for name in ("C11", "C22", "C23", "C33"):
        zero, quarter, half = (
            (1 - weight) * float(at[low, nu][name])
            + weight * float(at[round(low + 0.1, 1), nu][name]) for nu in (0.0, 0.25, 0.5))
        result.append(1 / (8 * (NU - 0.25) * (NU - 0.5) / zero
                           - 16 * NU * (NU - 0.5) / quarter + 8 * NU * (NU - 0.25) / half))
    return result


def check_summary(folder, row, two_forces):
    """The lines on the screen against the row: millimetres, MPa, percent."""
    with open(os.path.join(folder, "out"), encoding="utf-8") as file:
        text = " ".join(file.read().split())
    number = r"(-?[\d.]+(?:e[-+]\d+)?)"
    load = re.search(f"N = {number} N at an approach of {number} mm; peak pressure {number} "
                     f"MPa, half-width {number} mm, {number} nodes", text)
    forces = (f"\\({number}, {number}\\)" if two_forces else f"{number}()")
    force = re.search(f"T = {forces} N, \\|T\\|/N = {number}, \\|T\\|/\\(mu N\\) = {number}; "
                      f"stick on {number} %", text)
    check(f"{folder}: summary: {text}", load and force)
    if not (load and force):
        return
    said = [float(group) if group else 0.0 for group in load.groups() + force.groups()]
    expected = [row["normal_force_N"], 1e3 * row["approach_m"], 1e-6 * row["max_pressure_Pa"],
                1e3 * row["half_width_x_m"], row["nodes_in_contact"], row["force_x_N"],
                row["force_y_N"], row["traction_coefficient"], row["traction_coefficient"] / MU,
                100 * row["stick_area_m2"] / row["contact_area_m2"]]
    for i, pair in enumerate(zip(said, expected)):
        near(f"{folder}: number {i} of the summary", *pair, 5e-3 if i == 9 else 1e-4, 1e-9)


def check_fields(path, row):
    """Fields at the nodes against the row: units, extremes and sums."""
    field, units = vtu.nodes(path)
    for name, unit in units.items():
        if name != "points":
            check(f"{path}: unit of {name}: {unit}", unit == UNITS[name])
    area, state = field["area"], field["state"]
    p, q = field["pressure"], field["traction"]

    def total(values):
        return sum(a * value for a, value in zip(area, values))

    load = row["normal_force_N"]
    near(f"{path}: peak", max(p), row["max_pressure_Pa"], 1e-6)
    near(f"{path}: load", total(p), load, 1e-5)
    near(f"{path}: force x", total(t[0] for t in q), row["force_x_N"], 0, 1e-5 * load)
    near(f"{path}: force y", total(t[1] for t in q), row["force_y_N"], 0, 1e-5 * load)
    if "centre_x_m" in row:
        for axis, name in enumerate(("centre_x_m", "centre_y_m")):
            if axis == 0 or row["half_width_y_m"] > 0:
                near(f"{path}: {name}", total(x[axis] * pressed for x, pressed in
                                              zip(field["points"], p)) / load, row[name], 1e-5, 1e-9)
    moment = total(x[0] * t[1] - x[1] * t[0] for x, t in zip(field["points"], q))
    if "spin_moment_Nm" in row and "half_width_y_m" in row and row["half_width_y_m"] > 0:
        near(f"{path}: moment", moment, row["spin_moment_Nm"], 1e-4, 1e-8 * load)
    near(f"{path}: traction", max(field["traction_size"]),
         max(math.hypot(*t) for t in q), 1e-6)
    bound = field["traction_bound"]
    check(f"{path}: bound", all(b <= MU * (1 + 1e-6) * s for b, s in zip(bound, p)))
    near(f"{path}: sum of bounds", total(bound), MU * load, 0.05)
    recovered_p, recovered_q = field["recovered_pressure"], field["recovered_traction"]
    near(f"{path}: recovered peak", max(recovered_p), max(p), 0.02)
    check(f"{path}: recovered pressure where none is",
          all(r == 0 for r, s in zip(recovered_p, state) if s == OPEN))
    check(f"{path}: friction of recovered tractions",
          all(math.hypot(*t) <= MU * (1 + 1e-5) * r + 1 for t, r in zip(recovered_q, recovered_p)))
    near(f"{path}: recovered force x", total(t[0] for t in recovered_q), row["force_x_N"], 0, 0.04 * load)
    near(f"{path}: recovered force y", total(t[1] for t in recovered_q), row["force_y_N"], 0, 0.04 * load)
    open_gaps = [g for g, s in zip(field["gap"], state) if s == OPEN]
    check(f"{path}: open gaps", not open_gaps or 0 < min(open_gaps) and max(open_gaps) < 1e-3)
    touching = [s != OPEN for s in state]
    near(f"{path}: nodes", sum(touching), row["nodes_in_contact"], 0)
    if "contact_area_m2" in row:
        # inside the outlines, which cut the boxes of the nodes at them
        whole, stick = row["contact_area_m2"], row["stick_area_m2"]
        check(f"{path}: area", 0.7 * total(touching) < whole < 1.02 * total(touching))
        sticking = total(s == STICK for s in state)
        check(f"{path}: stick", 0.7 * sticking <= stick <= 1.1 * sticking)
        check(f"{path}: stick is part of the patch", 0 <= stick <= whole)
        near(f"{path}: contact nodes", len(state), row["contact_nodes"], 0)
    else:
        near(f"{path}: sticking", state.count(STICK), row["nodes_sticking"], 0)
    return field


def check_solution(folder, row):
    """What every solved state has."""
    check(f"{folder}: converged", row["converged"] == "true" and row["solver"] != "")
    for name in ("residual_normal", "residual_tangential"):
        check(f"{folder}: {name}", 0 <= row[name] < 1e-9)
    near(f"{folder}: iterations", row["iterations"],
         row["normal_solves"] + row["tangential_solves"], 0)
    check(f"{folder}: passes", 1 <= row["passes"] <= row["iterations"])
    check(f"{folder}: corrections", row["corrections"] == 0)
    check(f"{folder}: wall time", 0 < row["wall_s"] < 600)
    for name in row:
        if name.startswith("invariant_"):
            check(f"{folder}: {name}", abs(row[name]) < 1e-8)
    load, force = row["normal_force_N"], math.hypot(row["force_x_N"], row["force_y_N"])
    near(f"{folder}: T/N", row["traction_coefficient"], force / load, 1e-8)
    work, heat = row["creep_work_J/m"], row["dissipation_J/m"]
    near(f"{folder}: creep work", work,
         -(row["force_x_N"] * row["creepage_x"] + row["force_y_N"] * row["creepage_y"]
           + row["spin_moment_Nm"] * row["spin_1/m"]), 1e-7)
    # bodies that mirror each other roll without resistance
    near(f"{folder}: dissipation", heat, work, 2e-3)
    near(f"{folder}: energy error", row["energy_error"],
         abs(work - heat) / max(work, heat), 1e-4, 1e-8)


def check_bounds(folder, row, mesh, n, growth, tolerance, approach):
    """Smooth thick bodies of one steel: the state's own estimate is below c/n^p, and not
    by orders of magnitude; the peak has 2/n^2, the mesh's growth and the residual."""
    bulk = growth * min(1, 4 * growth) if approach else 0
    growth_share = 2e-3 * growth + 1e-2 * bulk
    residual = 4 * row["residual_tangential"]
    names = ["bound_force/muN"] + (["bound_moment/muNa"] if "bound_moment/muNa" in row else [])
    for name in names:
        check(f"{folder}: {name}", 0.05 * mesh < row[name] < mesh + growth_share + residual)
    with open(os.path.join(folder, "run.json"), encoding="utf-8") as file:
        error = next(e for e in json.load(file)["errors"] if e["quantity"] == "force")
    near(f"{folder}: the error is the column's", error["value"], row["bound_force/muN"], 1e-6)
    parts = [float(number) for number in re.findall(r"([\d.]+e-\d+) for", error["reference"])]
    near(f"{folder}: parts of the error", sum(parts), error["value"], 0.02)
    near(f"{folder}: bound of the peak", row["bound_max_pressure"],
         2 / n**2 + 4e-3 * growth + 1.6e-2 * bulk + 4 * row["residual_normal"], tolerance)
    heat = mesh + residual + 2e-3 * growth / MU
    check(f"{folder}: bound of the heat", heat < row["bound_dissipation"] < 10 * heat)
    # of the load, which follows from an approach: a few per cent on coarse meshes
    check(f"{folder}: bound of the load", (0 < row["bound_normal_force"] < 0.05) == approach)


def check_line_contact(folder, row, elements):
    a, pressure, saturation = line_contact(row["normal_force_N"])
    z = row["creepage_x"] / saturation
    near(f"{folder}: creepages", row["creepage_x"], 0.0017, 0)
    check(f"{folder}: none of 3D", row["creepage_y"] == row["spin_1/m"] == 0
          and row["half_width_y_m"] == row["force_y_N"] == row["spin_moment_Nm"] == 0)
    near(f"{folder}: approach", row["approach_m"], 0.22e-3, 1e-8)
    near(f"{folder}: half-width", row["half_width_x_m"], a, 0.02)
    near(f"{folder}: peak", row["max_pressure_Pa"], pressure, 0.01)
    size = 2 * a / elements * WIDTH
    near(f"{folder}: area", row["contact_area_m2"], 2 * a * WIDTH, 0, size / 4)
    near(f"{folder}: stick", row["stick_area_m2"], 2 * a * (1 - z) * WIDTH, 0, size / 2)
    near(f"{folder}: nodes", row["nodes_in_contact"], elements, 0, 2)
    near(f"{folder}: Hertz's a", row["reference_half_width_x_m"], a, 1e-6)
    near(f"{folder}: Hertz's p0", row["reference_max_pressure_Pa"], pressure, 1e-6)
    check(f"{folder}: pressure", 0 < row["error_pressure_l2"] < 0.05)
    near(f"{folder}: load of clamped discs", row["reference_normal_force_N"], 140760, 1e-4)
    near(f"{folder}: error of the load", row["error_normal_force"],
         row["normal_force_N"] / row["reference_normal_force_N"] - 1, 1e-5, 1e-8)
    near(f"{folder}: Carter", row["reference_force_x/muN"], z * z - 2 * z, 1e-6)
    near(f"{folder}: error of the force", row["error_force_x/muN"],
         row["force_x_N"] / (MU * row["normal_force_N"]) - row["reference_force_x/muN"],
         1e-4, 1e-8)
    check(f"{folder}: traction", 0 < row["error_traction_l2"] < 0.05)
    check(f"{folder}: sawtooth", 0 <= row["error_sawtooth"] < 0.035)
    check(f"{folder}: stick border", abs(row["error_stick_boundary_elements"]) <= 1)


def state_2d(folder):
    (row,) = rows(os.path.join(folder, "results.csv"))
    check_solution(folder, row)
    check_line_contact(folder, row, 48)
    check_bounds(folder, row, 1.3 / 48**2, 48, 0.1, 0.05, True)
    check(f"{folder}: Carter is inside the bound and what discs differ by",
          abs(row["error_force_x/muN"]) < row["bound_force/muN"] + 5e-4)
    check(f"{folder}: mesh", row["level"] == 0 and row["elements_across"] == 48
          and row["patch_offset"] == 0.25 and row["slip_operator"] == "calibrated")
    points = vtu.nodes(os.path.join(folder, "wheel.vtu"))[0]["points"]
    # of one of the twins; nodes of the hub have none
    near(f"{folder}: unknowns", row["dofs"], 2 * len(points), 0.07)
    check_summary(folder, row, False)
    field = check_fields(os.path.join(folder, "interface.vtu"), row)
    near(f"{folder}: hottest place", row["flash_temperature_K"], max(field["flash_temperature"]), 1e-6)
    near(f"{folder}: bodies of 20 degrees", row["surface_temperature_K"], 293.15 + row["flash_temperature_K"], 1e-6)
    for body in ("wheel", "rail"):
        near(f"{folder}: half of the heat", row[f"heat_to_{body}_W"], row["dissipation_J/m"] * 20 / 2, 1e-6)
    touching = [k for k, p in enumerate(field["pressure"]) if p > 0]
    near(f"{folder}: mean of the temperature", row["mean_flash_temperature_K"],
         sum(field["flash_temperature"][k] * field["area"][k] for k in touching) / sum(field["area"][k] for k in touching),
         1e-6)
    # a band of even heat, a half of it for each body, at 20 m/s: 2 q sqrt(l / (pi k rho c V))
    slips = 2 * row["half_width_x_m"] * (1 - row["stick_area_m2"] / row["contact_area_m2"])
    heat = row["dissipation_J/m"] * 20 / (2 * slips * WIDTH)
    near(f"{folder}: flash temperature", row["flash_temperature_K"],
         2 * heat * math.sqrt(slips / (math.pi * CONDUCTIVITY * DENSITY * HEAT_CAPACITY * 20)), 0.15)


def levels_2d(folder):
    levels = rows(os.path.join(folder, "results.csv"))
    near(f"{folder}: levels", len(levels), 3, 0)
    for number, row in enumerate(levels):
        near(f"{folder}: level", row["level"], number, 0)
        near(f"{folder}: elements of the first", row["elements_across"], 24, 0)
    before, row = levels[-2:]
    load = row["normal_force_N"]
    near(f"{folder}: change", row["change"],
         abs(row["force_x_N"] - before["force_x_N"]) / (MU * load), 0.5, 1e-4)
    near(f"{folder}: extrapolated load", row["extrapolated_normal_force_N"], load, 1e-3)
    near(f"{folder}: extrapolated force", row["extrapolated_force_x_N"],
         row["reference_force_x/muN"] * MU * load, 5e-3)
    near(f"{folder}: extrapolated force y", row["extrapolated_force_y_N"], 0, 0)
    near(f"{folder}: extrapolated approach", row["extrapolated_approach_m"], 0.22e-3, 1e-8)
    near(f"{folder}: estimated error", row["estimated_error"], 0, 0, 5e-3)
    near(f"{folder}: error of the limit", row["extrapolation_error"], 0, 0, 5e-3)


def state_3d(folder):
    (row,) = rows(os.path.join(folder, "results.csv"))
    check_solution(folder, row)
    load = row["normal_force_N"]
    a, b, pressure, approach = point_contact(load)
    near(f"{folder}: a", row["half_width_x_m"], a, 0.04)
    near(f"{folder}: b", row["half_width_y_m"], b, 0.08)
    near(f"{folder}: area", row["contact_area_m2"], math.pi * a * b, 0.01)
    near(f"{folder}: peak", row["max_pressure_Pa"], pressure, 0.01)
    near(f"{folder}: Hertz's a", row["reference_half_width_x_m"], a, 1e-6)
    near(f"{folder}: Hertz's b", row["reference_half_width_y_m"], b, 1e-6)
    near(f"{folder}: Hertz's p0", row["reference_max_pressure_Pa"], pressure, 1e-6)
    near(f"{folder}: Hertz's approach", row["reference_approach_m"], approach, 1e-6)
    near(f"{folder}: approach", row["approach_m"], 7e-5, 1e-8)
    x, y, spin = row["creepage_x"], row["creepage_y"], row["spin_1/m"]
    check(f"{folder}: creepages", (x, y, spin) == (0.001, -0.0015, 0.4))
    c11, c22, c23, c33 = kalker(a / b)
    c = math.sqrt(a * b)
    linear = (-SHEAR * c * c * c11 * x, -SHEAR * c * c * (c22 * y - c * c23 * spin))
    near(f"{folder}: linear x", row["kalker_force_x_N"], linear[0], 1e-6)
    near(f"{folder}: linear y", row["kalker_force_y_N"], linear[1], 1e-6)
    near(f"{folder}: linear moment", row["kalker_spin_moment_Nm"],
         -SHEAR * c**3 * (c23 * y + c * c33 * spin), 1e-6)
    share = math.hypot(*linear) / (MU * load)
    saturated = (1 - share / 3 + share**2 / 27) if share < 3 else 1 / share
    for axis, value in zip("xy", linear):
        near(f"{folder}: saturated {axis}", row[f"shen_force_{axis}_N"], value * saturated, 1e-6)
        near(f"{folder}: force {axis}", row[f"force_{axis}_N"], value * saturated, 0.1)
        near(f"{folder}: brush {axis}", row[f"fastsim_force_{axis}_N"],
             row[f"force_{axis}_N"], 0.05)
    check_bounds(folder, row, 0.5 / 14**1.5, 14, 0.4, 0.1, True)
    check_summary(folder, row, True)
    check_fields(os.path.join(folder, "interface.vtu"), row)


def loads(folder):
    (row,) = rows(os.path.join(folder, "results.csv"))
    # dN/d(approach) of a line contact that grows as N^1.1
    stiffness = row["normal_force_N"] / row["approach_m"]
    near(f"{folder}: stiffness", row["contact_stiffness_N/m"], 1.11 * stiffness, 0.03)


def check_energy(folder, history):
    """What was supplied is stored or gone; one column each."""
    first = history[0]
    for row in history[1:]:
        gain = sum(row[name] - first[name] for name in ("kinetic_J", "strain_J"))
        given = row["supplied_J"] - first["supplied_J"]
        for name in ("friction_J", "damping_J", "numerical_J"):
            given -= row[name] - first[name]
            check(f"{folder}: {name}", row[name] >= first[name] >= 0)
        near(f"{folder}: balance", gain, given, 1e-5, 1e-7 * (row["kinetic_J"] + row["strain_J"]))
        check(f"{folder}: balance error", abs(row["energy_balance_error"]) < 1e-10)


def vibration(folder, theta, smooth=True):
    """Discs at 10 m/s, the creepage oscillates at 1 kHz."""
    history = rows(os.path.join(folder, "history.csv"))
    near(f"{folder}: steps", len(history), 40, 0)
    heat = 0.0
    for number, row in enumerate(history, 1):
        time, where = number * 2e-6, f"{folder}, step {number}"
        near(f"{where}: number", row["step"], number, 0)
        near(f"{where}: time", row["time_s"], time, 1e-8)
        near(f"{where}: forces act", row["force_time_s"], time - (1 - theta) * 2e-6, 1e-8)
        near(f"{where}: distance", row["rolled_m"], 10 * time, 1e-8)
        near(f"{where}: speed", row["speed_m/s"], 10, 0)
        near(f"{where}: approach", row["approach_m"], 0.22e-3, 1e-8)
        near(f"{where}: creepage", row["creepage_x"],
             0.0017 + 0.001 * math.sin(2000 * math.pi * time), 1e-8)
        load, force = row["normal_force_N"], abs(row["force_x_N"])
        near(f"{where}: load", load, 140760, 5e-3)
        near(f"{where}: peak", row["max_pressure_Pa"], line_contact(load)[1], 0.01)
        near(f"{where}: T/N", row["traction_coefficient"], force / load, 1e-8)
        near(f"{where}: nodes", row["nodes_in_contact"], 24, 0, 2)
        check(f"{where}: solver", row["iterations"] >= 1 and row["parts"] == 1)
        check(f"{where}: impacts", row["impacts"] <= 1)
        # a contact softer than linear stores a little less than half
        near(f"{where}: strain", row["strain_J"], load * 0.22e-3 / 2, 0.08)
        if smooth:
            check(f"{where}: sticking", 0 < row["nodes_sticking"] < row["nodes_in_contact"])
            check(f"{where}: kinetic", 0 < row["kinetic_J"] < 1e-3 * row["strain_J"])
            near(f"{where}: friction", row["friction_J"] - heat,
                 force * row["creepage_x"] * 20e-6, 0.25)
        heat = row["friction_J"]
    check_energy(folder, history)
    last, (row,) = history[-1], rows(os.path.join(folder, "results.csv"))
    for name in ("time_s", "rolled_m", "approach_m", "creepage_x", "normal_force_N", "force_x_N",
                 "max_pressure_Pa", "nodes_in_contact", "traction_coefficient"):
        near(f"{folder}: {name} at the end", row[name], last[name], 1e-8)
    if smooth:
        check_fields(os.path.join(folder, "interface-0000040.vtu"), last)
    return history


def damped(folder):
    last = vibration(folder, 0.5)[-1]
    check(f"{folder}: damping", last["damping_J"] > 0)
    near(f"{folder}: no numerical dissipation", last["numerical_J"], 0, 0)


def numerical(folder):
    last = vibration(folder, 0.7)[-1]
    check(f"{folder}: numerical dissipation", last["numerical_J"] > 0)
    near(f"{folder}: no damping", last["damping_J"], 0, 0)
    check(f"{folder}: forces act before the end of a step", last["force_time_s"] < last["time_s"])
    check(f"{folder}: a constant load has no peak", " N at t = " not in words(folder))


def words(folder):
    with open(os.path.join(folder, "out"), encoding="utf-8") as file:
        return " ".join(file.read().split())


def falling(folder):
    """Friction that falls makes the discs jerk: a ratio, rounds of the law."""
    last = vibration(folder, 0.505, smooth=False)[-1]
    check(f"{folder}: ratio", last["several_solutions_ratio"] > 0)
    (row,) = rows(os.path.join(folder, "results.csv"))
    check(f"{folder}: rounds", 1 <= row["friction_rounds"] < 100)


def impact(folder):
    """A ring of 40 mm dropped with 1 m/s, its hub free, on a block."""
    history = rows(os.path.join(folder, "history.csv"))
    energy = 0.5 * 7800 * math.pi * (0.05**2 - 0.01**2) * 0.01
    near(f"{folder}: kinetic energy", history[0]["kinetic_J"], energy, 0.02)
    near(f"{folder}: energy kept", sum(history[-1][n] for n in ("kinetic_J", "strain_J")),
         energy, 0.02)
    check(f"{folder}: falls into strain", history[-1]["strain_J"] > 1e-3)
    check(f"{folder}: nodes close", sum(row["impacts"] for row in history)
          >= history[-1]["nodes_in_contact"] > 0)
    check(f"{folder}: nodes that close in a step", any(row["impacts"] == 0 for row in history[3:])
          and all(row["impacts"] <= row["nodes_in_contact"] for row in history))
    check(f"{folder}: the contact comes to rest", -1 < history[0]["velocity_z_m/s"] < -0.5
          and abs(history[-1]["velocity_z_m/s"]) < 1e-3)
    check(f"{folder}: no friction, no motion along", history[-1]["velocity_x_m/s"] == 0
          and history[-1]["velocity_y_m/s"] == 0)
    mass = 2 * (history[0]["kinetic_J"] + history[0]["strain_J"])  # at 1 m/s
    impulse = sum(row["normal_force_N"] for row in history) * 1e-6
    last = history[-1]["wheel_velocity_m/s"]
    near(f"{folder}: momentum", mass * (last + 1), impulse, 5e-4)
    check(f"{folder}: it still falls", -1 < last < -0.5)
    (row,) = rows(os.path.join(folder, "results.csv"))
    near(f"{folder}: velocity at the end", row["wheel_velocity_m/s"], last, 1e-8)
    check(f"{folder}: it says so", f"moves along z at {last:.6g} m/s" in words(folder))
    largest = max(history, key=lambda row: row["normal_force_N"])
    check(f"{folder}: the peak", f"N = {largest['normal_force_N']:.6g} N at t = {largest['force_time_s']:.6g} s" in words(folder))
    check_energy(folder, history)


def rolling_3d(folder):
    history = rows(os.path.join(folder, "history.csv"))
    last, (row,) = history[-1], rows(os.path.join(folder, "results.csv"))
    near(f"{folder}: distance", last["rolled_m"], 8e-3, 1e-8)
    near(f"{folder}: forces act at the end", last["force_time_s"], last["time_s"], 1e-12)
    check(f"{folder}: creepages", (last["creepage_y"], last["spin_1/m"]) == (0.003, 0.4))
    for name in ("force_y_N", "spin_moment_Nm", "creepage_y", "spin_1/m"):
        near(f"{folder}: {name} at the end", row[name], last[name], 1e-8)
    check_fields(os.path.join(folder, "interface-0000010.vtu"), row)
    near(f"{folder}: side force / mu N", last["force_y_N"] / MU / last["normal_force_N"], -0.35, 0, 0.3)
    near(f"{folder}: supplied", last["supplied_J"], last["strain_J"] + last["friction_J"]
         + last["numerical_J"], 1e-6)


for run_folder in sys.argv[1:]:
    globals()[run_folder](run_folder)
for column in sorted(known - looked_at):
    check(f"nothing checks the column {column}", False)
sys.exit(len(failures) > 0)
