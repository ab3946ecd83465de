"""summary.csv of an accuracy study against the states in results.csv, methods.csv against summary.csv.

Usage: studies.py RUN_FOLDER REFERENCE_ELEMENTS, of a study in 2D where Carter holds."""
import csv
import math
import sys

folder, reference_elements = sys.argv[1], int(sys.argv[2])
MU, failures, counts = 0.3, [], {"orders": 0, "states": 0, "methods": 0}


def read(name):
    with open(f"{folder}/{name}", newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def near(what, value, expected, relative=1e-6, absolute=1e-9):
    if not abs(float(value) - expected) <= relative * abs(expected) + absolute:
        failures.append(f"{what}: {value}, expected {expected:.9g}")


def mean(values):
    return sum(values) / len(values)


def largest(values):
    return max(map(abs, values))


states, summary = read("results.csv"), read("summary.csv")


def creepage(state):
    """Over saturation: Carter's force is z^2 - 2 z over mu N."""
    return 1 - math.sqrt(1 + float(state["reference_force_x/muN"]))


for row in summary:
    name = " ".join(list(row.values())[:6])
    # automatic and extragradient find the same states
    own = [state for state in states if [state["mesh"], state["operator"], state["elements_across"]] ==
           [row["mesh"], row["slip_operator"], row["elements"]]
           and abs(creepage(state) - float(row["creepage_over_saturation"])) < 0.02]
    if not own or len(own) % int(row["states"]) != 0 or row["not_converged"] != "0":
        failures.append(f"{name}: {len(own)} states")
        continue
    counts["states"] += int(row["states"])
    for error, column in (("load_error", "error_normal_force"), ("pressure_l2", "error_pressure_l2"),
                          ("traction_l2", "error_traction_l2"), ("sawtooth", "error_sawtooth"),
                          ("stick_boundary_elements", "error_stick_boundary_elements")):
        values = [float(state[column]) for state in own]
        if error == "stick_boundary_elements": # a distance
            values = [abs(value) for value in values]
        near(f"{name} {error}_max", row[f"{error}_max"], largest(values), 1e-5)
        near(f"{name} {error}_mean", row[f"{error}_mean"], mean(values), 1e-5, 1e-8)
    limit = float(row["reference_force_x/muN"])
    near(f"{name}: force y of the reference", row["reference_force_y/muN"], 0)
    near(f"{name}: Carter", limit, mean([float(s["reference_force_x/muN"]) for s in own]), 0, 4e-3)
    off = [math.copysign(1, limit) * (float(s["force_x_N"]) / (MU * float(s["normal_force_N"])) - limit) for s in own]
    near(f"{name} force_error_max", row["force_error_max"], largest(off), 1e-5, 2e-8)
    near(f"{name} force_error_mean", row["force_error_mean"], mean(off), 1e-5, 2e-8)
    near(f"{name} unknowns", row["unknowns"], mean([float(s["dofs"]) for s in own]), 0, 0.51)
    near(f"{name} contact_nodes", row["contact_nodes"], mean([float(s["contact_nodes"]) for s in own]), 0, 0.51)
    residual = max(float(s[f"residual_{part}"]) for s in own for part in ("normal", "tangential"))
    if not 0 <= float(row["residual_max"]) <= residual * (1 + 1e-6):
        failures.append(f"{name} residual_max: {row['residual_max']}, that of the states is {residual}")
    elif int(row["states"]) == len(own):
        near(f"{name} residual_max", row["residual_max"], residual, 1e-6, 1e-30)
    parts = [float(row[f"cpu_{part}_s"]) for part in ("mesh_assembly", "factorisation_condensation", "contact")]
    near(f"{name} cpu_s", row["cpu_s"], sum(parts))
    for column, said in (("force_reference", f"{reference_elements} elements, mean of 2 positions, extrapolated"),
                         ("load_reference", "load against the exact clamped discs"), ("pressure_reference", "Hertz"),
                         ("traction_reference", "Carter")):
        if row[column] != said:
            failures.append(f"{name} {column}: {row[column]}")
    coarser = [float(it["force_error_mean"]) for it in summary if list(it.values())[:5] == list(row.values())[:5]
               and 2 * int(it["elements"]) == int(row["elements"])]
    if not coarser or int(row["elements"]) == reference_elements:
        if row["order_of_mean"]:
            failures.append(f"{name}: an order of nothing")
    else:
        counts["orders"] += 1
        near(f"{name} order_of_mean", row["order_of_mean"],
             math.log2(abs(coarser[0] / float(row["force_error_mean"]))), 1e-5, 1e-6)

for row in read("methods.csv"):
    operator, *others = row["method"].split(", ")
    own = [it for it in summary if it["slip_operator"] == operator and it["elements"] == row["elements"]
           and (it["mesh"] if it["mesh"] != "uniform" else it["solver"]) == (others or ["automatic"])[0]]
    name = f"{row['method']} {row['elements']}"
    if not own:
        failures.append(f"{name}: no rows in summary.csv")
        continue
    counts["methods"] += 1
    for error in ("force_error", "load_error", "pressure_l2", "traction_l2", "stick_boundary_elements"):
        near(f"{name} {error}_max", row[f"{error}_max"], max(float(it[f"{error}_max"]) for it in own))
        near(f"{name} {error}_mean", row[f"{error}_mean"], mean([abs(float(it[f"{error}_mean"])) for it in own]))
    for column in ("cpu_mesh_assembly_s", "cpu_factorisation_condensation_s", "cpu_contact_s", "cpu_s"):
        near(f"{name} {column}", row[column], mean([float(it[column]) for it in own]))
    for column, value in (("states", sum), ("not_converged", sum), ("residual_max", max), ("peak_memory_bytes", max)):
        near(f"{name} {column}", row[column], value([float(it[column]) for it in own]), 1e-6, 1e-30)

if min(counts.values()) < 10:
    failures.append(f"few of {counts}")
print("\n".join(failures))
sys.exit(bool(failures))
