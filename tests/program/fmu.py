#!/usr/bin/env python3
"""What importers ask of the FMUs of a folder, both versions: the description against the library, sequences that are
refused, states to the bit, several instances, values of both versions, the time of a step.
Usage: fmu.py FOLDER [WHEELSET.CSV: the equilibrium that a wheelset in R = 1500 m comes to]"""

import csv
import ctypes
import math
import pathlib
import random
import sys
import time

from ctypes import byref, c_bool, c_double, c_int, c_size_t, c_uint32, c_void_p

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "doc/python"))

from fmu import Fmu, Refused
from fmu_in_curve import co_simulate

BASE_UNITS = {"m": "m", "rad": "rad", "s": "s", "N": "kg m s-2", "Pa": "kg m-1 s-2", "N.m": "kg m2 s-2"}
failed = 0


def check(what, holds):
    global failed
    if not holds:
        failed += 1
        print(f"FAILED: {what}")


def refused(what, function, *words):
    """A call that the FMU refuses, with these words in its message."""
    try:
        function()
    except Refused as refusal:
        check(f"{what}: {refusal}", all(word in str(refusal) for word in words))
        return
    check(f"{what} is refused", False)


def check_description(fmu):
    """References and names are unique, units are declared, what is unknown is listed, starts are numbers."""
    is_2 = fmu.version == 2
    variables = fmu.variables
    check("unique references", len({v.reference for v in variables}) == len(variables))
    check("unique names", len(fmu.by_name) == len(variables))
    units = {unit.get("name"): dict(unit[0].attrib) for unit in fmu.description.find("UnitDefinitions")}
    for name, exponents in units.items():
        if name in BASE_UNITS:
            text = " ".join(f"{base}{'' if e == '1' else e}" for base, e in exponents.items())
            check(f"{name} in base units: {text}", text == BASE_UNITS[name])
    for v in variables:
        check(f"{v.name}: unit {v.unit}", v.unit is None or v.unit in units)
        with_start = v.causality in ("input", "parameter", "local")
        check(f"{v.name}: start", (v.start is not None) == with_start)
        check(f"{v.name}: initial {v.initial}", v.initial == {
            "input": None, "independent": None, "output": "calculated"}.get(v.causality, "exact"))
        if v.type == "Boolean":
            check(f"{v.name} is discrete", v.variability == "discrete")
    structure = fmu.description.find("ModelStructure")
    if is_2:
        listed = [[variables[int(u.get("index")) - 1].name for u in structure.find(part)]
                  for part in ("Outputs", "InitialUnknowns")]
    else:
        by_reference = {v.reference: v.name for v in variables}
        listed = [[by_reference[int(u.get("valueReference"))] for u in structure.findall(part)]
                  for part in ("Output", "InitialUnknown")]
    outputs = [v.name for v in variables if v.causality == "output"]
    check("outputs are listed", listed == [outputs, outputs])
    check("one independent variable", [v.name for v in variables if v.causality == "independent"] == ["time"])


def check_values(fmu):
    """Every variable answers, starts are those of the description, what is not set from outside is refused."""
    one = fmu.instantiate()
    refused("get before initialisation", lambda: one.get("lateral_shift"), "before initialisation")
    one.initialise()
    for v in fmu.variables:
        value = one.get(v.name)
        if v.start is not None:
            expected = v.start.encode() if v.type == "String" else float(v.start)
            check(f"{v.name} starts at {value}, not {v.start}", value == expected)
        if v.type != "Real":
            continue
        if v.causality == "input":
            one.set({v.name: value})
        else:
            refused(f"set {v.name}", lambda: one.set({v.name: value}), v.name)
    for bad in (math.nan, math.inf):
        refused(f"a shift of {bad}", lambda: one.set(lateral_shift=bad), "finite")
    refused("friction of 0", lambda: one.set(friction=0.0), "above 0")
    kept = one.get("lateral_shift", "yaw")
    refused("one of two values is none", lambda: one.set({"lateral_shift": 1e-3, "yaw": math.nan}), "yaw")
    check("then none is set", one.get("lateral_shift", "yaw") == kept)
    one.free()


def check_sequences(fmu):
    """Calls out of order and arrays that are NULL are refused, never a crash."""
    is_2 = fmu.version == 2
    one = fmu.instantiate()
    for name in ("ExitInitializationMode", "Terminate"):
        refused(f"{name} at first", lambda: one.call(name), "before initialisation")
    refused("a step at first", lambda: one.step(1e-3), "before initialisation")
    if is_2:
        refused("no setup", lambda: one.call("EnterInitializationMode"), "fmi2SetupExperiment")
        refused("stop before start", lambda: one.initialise(1.0, 0.5), "stop time")
    one.initialise(0.5, 1.0, least_speed=0.2)
    check("the parameter", one.get("least_speed") == 0.2)
    refused("the parameter later", lambda: one.set(least_speed=0.3), "fixed")
    check("time", one.get("time") == 0.5)
    for size in (0.0, -1e-3, math.nan, math.inf):
        refused(f"a step of {size}", lambda: one.step(size))
    one.time = 0.7
    refused("a step from elsewhere", lambda: one.step(1e-3), "begins")
    one.time = 0.5
    refused("a step beyond the end", lambda: one.step(0.6), "stop time")
    one.step(0.3)
    one.step(0.2)
    check("time after steps", abs(one.get("time") - 1.0) < 1e-12)
    refused("initialise twice", lambda: one.initialise(), "between steps")
    lengths = () if is_2 else (c_size_t(1),)
    real = "Real" if is_2 else "Float64"
    reference = (c_uint32 * 1)(1)
    for name in (f"Get{real}", f"Set{real}"):
        refused(f"{name} of NULL", lambda: one.call(name, None, c_size_t(1), None, *lengths), "NULL")
        refused(f"{name} to NULL", lambda: one.call(name, reference, c_size_t(1), None, *lengths), "NULL")
        one.call(name, None, c_size_t(0), None, *((c_size_t(0),) if not is_2 else ()))
        unknown = (c_uint32 * 1)(99999)
        value = (c_double * 1)()
        refused(f"{name} of no variable", lambda: one.call(name, unknown, c_size_t(1), value, *lengths), "99999")
    refused("Boolean of a real", lambda: one.call(
        "GetBoolean", reference, c_size_t(1), (c_int * 1)(), *lengths), "boolean")
    state = "FMUstate" if is_2 else "FMUState"
    for name in (f"Get{state}", f"Set{state}"):
        refused(f"{name} of NULL", lambda: one.call(name, None))
    refused("a state of another", lambda: one.call(f"Set{state}", c_void_p(12345)), "none that")
    if not is_2:
        check("NULL for what a step tells", fmu.function("Reset")(one.handle) == 0)
        one.initialise()
        step = fmu.function("DoStep")
        check("a step without places", step(
            one.handle, c_double(0), c_double(1e-3), c_bool(True), None, None, None, None) == 0)
        refused("two values for one", lambda: one.call(
            "GetFloat64", reference, c_size_t(1), (c_double * 2)(), c_size_t(2)), "nValues")
    one.terminate()
    check("values after the end", one.get("right.force_z") < 0)
    refused("a step after the end", lambda: one.step(1e-3), "after termination")
    refused("set after the end", lambda: one.set(yaw=0.0), "after termination")
    one.reset()
    refused("a step after a reset", lambda: one.step(1e-3), "before initialisation")
    handle = one.handle
    one.free()
    for dead in (None, handle, c_void_p(8)):
        check("functions of no instance", all(
            fmu.function(name)(dead) != 0 for name in ("Terminate", "Reset", "ExitInitializationMode")))
        fmu.function("FreeInstance", None)(dead)
    refused("another token", lambda: fmu.instantiate(token="{0}"), "{0}")
    refused("no resources", lambda: fmu.instantiate(resources="/nowhere"), "no such file")
    refused("no name", lambda: fmu.instantiate(name=""), "no name")


def check_all_functions(fmu):
    """Every function of the version answers an error, and no crash, to a NULL instance."""
    names = (pathlib.Path(__file__).parent / "fmu_functions").read_text().split("\n")
    zeros = [c_void_p(0)] * 12
    for name in names:
        if not name.startswith(fmu.prefix) or "Version" in name or "TypesPlatform" in name:
            continue
        function = getattr(fmu.library, name)
        is_new = "Instantiate" in name
        function.restype = c_void_p if is_new or name.endswith("FreeInstance") else c_int
        answer = function(*zeros)
        if not name.endswith("FreeInstance"):
            check(f"{name} of NULL: {answer}", answer is None if is_new else answer == 3)


def random_inputs(source):
    return {
        "lateral_shift": source.uniform(-2e-3, 2e-3), "yaw": source.uniform(-2e-4, 2e-4),
        "lateral_velocity": source.uniform(-0.02, 0.02), "yaw_rate": source.uniform(-1e-3, 1e-3),
        "axle_speed": -20 / 0.46 * (1 + source.uniform(-2e-3, 2e-3)), "friction": 0.3,
        "right.load": source.uniform(50e3, 70e3), "left.load": source.uniform(50e3, 70e3),
        "left.rail_y": source.uniform(-2e-4, 2e-4), "right.rail_z": source.uniform(-1e-4, 1e-4)}


def check_states(fmu):
    """A state that is kept, set again or read by another instance has the same values, to the bit."""
    source = random.Random(4)
    outputs = [v.name for v in fmu.variables if v.causality != "local" and v.type == "Real"]
    one, other = fmu.instantiate("one"), fmu.instantiate("other")
    for instance in (one, other):
        instance.initialise()
    one.set(random_inputs(source))
    one.step(0.0123)
    saved, values = one.save(), one.get(*outputs)
    data = one.serialise(saved)
    check("the same bytes again", one.serialise(saved) == data)
    one.set(random_inputs(source))
    one.step(0.1)
    check("another state", one.get(*outputs) != values)
    one.restore(saved)
    check("the state to the bit", one.get(*outputs) == values)
    other.restore(other.deserialise(data, one.time))
    check("the state in another instance, to the bit", other.get(*outputs) == values)
    refused("part of a state", lambda: other.deserialise(data[:-1], 0.0), "no state")
    refused("bytes of nothing", lambda: other.deserialise(bytes(len(data)), 0.0), "no state")
    one.forget(saved)
    check("a state that is forgotten", saved[0].value is None)
    for instance in (one, other):
        instance.free()


def check_forces(fmu):
    """Loads are carried, friction is within its limit and its bound, a step takes its time. The values."""
    source = random.Random(5)
    one = fmu.instantiate()
    one.initialise()
    values, n = [], 300
    names = [v.name for v in fmu.variables if v.causality == "output" and v.type == "Real"]
    begun = time.perf_counter()
    for _ in range(n):
        inputs = random_inputs(source)
        one.set(inputs)
        one.step(1e-3)
        found = dict(zip(names, one.get(*names)))
        for side in ("right", "left"):
            load = inputs[f"{side}.load"]
            if one.get(f"{side}.inside_table"):
                bound = found[f"{side}.force_bound"]
                check("the load is carried", abs(found[f"{side}.force_z"] + load) <= bound + 1e-3 * load)
                check("a bound", 0 < bound < load)
            else:
                check("no bound", found[f"{side}.force_bound"] > 1e300)
            check("y over q", abs(found[f"{side}.y_over_q"] * load - found[f"{side}.force_y"]) < 1e-6)
        values.append(found)
    seconds = (time.perf_counter() - begun) / n
    print(f"FMI {fmu.version}: {1e3 * seconds:.3f} ms a step of both wheels, with ctypes")
    check(f"a step takes {seconds} s", seconds < 1e-3)
    one.free()
    return values


def check_table(fmu, results):
    """At the states of the table an FMU has their forces, and their bounds alone."""
    one = fmu.instantiate()
    one.initialise()
    with open(results, newline="") as file:
        rows = [row for row in csv.DictReader(file) if row["status"] == "solved"]
    errors = []
    for row in rows:
        number = lambda name: float(row[name])
        radius = number("Profiles/Curve radius")
        one.set({
            "lateral_shift": number("Profiles/Lateral shift"), "yaw": number("Profiles/Yaw"),
            "curvature": 1 / radius if radius != 1e9 else 0.0, "axle_speed": number("Profiles/Pitch rate"),
            "lateral_velocity": number("Profiles/Lateral velocity"), "right.load": number("Contact/Vertical load")})
        x, y, z, bound = one.get("right.force_x", "right.force_y", "right.force_z", "right.force_bound")
        pressure = one.get("right.max_pressure") / number("max_pressure_Pa") - 1
        error = math.dist((x, y, z), (number("force_track_x_N"), number("force_track_y_N"), -number("force_track_z_N")))
        errors.append(max(error / number("normal_force_N"), abs(pressure)))
        if one.get("right.inside_table"):
            own = number("bound_force/muN") * number("Contact/Friction coefficient") * number("normal_force_N")
            check(f"the bound {bound} is that of the state, {own}", abs(bound - own) <= 1e-3 * own + 1e-3)
        else:
            check("a state of the table is in it", False)
    check(f"states of the table are off by {max(errors)} of N", max(errors) < 1e-6)
    one.free()


def check_equilibrium(path, equilibrium):
    """A wheelset in a curve comes to rest where its forces balance within the bounds, near the equilibrium."""
    with open(equilibrium, newline="") as file:
        expected = {name: float(value) for name, value in list(csv.DictReader(file))[0].items() if value.strip() and
                    name in ("lateral_shift_m", "yaw_rad", "axle_excess", "right_force_y_N", "left_force_y_N",
                             "curve_radius_m", "pitch_rate_rad/s")}
    radius = expected["curve_radius_m"]
    with Fmu(path) as fmu:
        one = fmu.instantiate()
        one.initialise(**{"lateral_shift": expected["lateral_shift_m"], "yaw": expected["yaw_rad"],
                          "axle_speed": expected["pitch_rate_rad/s"], "curvature": 1 / radius})
        for side in ("right", "left"):
            force, bound = one.get(f"{side}.force_y", f"{side}.force_bound")
            error = abs(force - expected[f"{side}_force_y_N"])
            print(f"{side}: {force:.1f} N across at the equilibrium, {error:.1f} N off, within {bound:.1f} N")
            check(f"{side}: the force at the equilibrium", error <= bound and one.get(f"{side}.inside_table"))
        # how far the place may be off: by its slopes, differences in y, psi, and the speed of the axle
        place = {"lateral_shift": expected["lateral_shift_m"], "yaw": expected["yaw_rad"],
                 "axle_speed": expected["pitch_rate_rad/s"]}
        sums = []
        for name, size in (("lateral_shift", 2e-5), ("yaw", 2e-6), ("axle_speed", 1e-3)):
            balance = []
            for sign in (1, -1):
                one.set({**place, name: place[name] + sign * size})
                f = {k: one.get(f"right.{k}") + one.get(f"left.{k}") for k in ("force_y", "moment_z", "moment_y")}
                f["moment_z"] -= 10e6 * (place["yaw"] + (sign * size if name == "yaw" else 0))
                balance.append([f["force_y"], f["moment_z"], f["moment_y"]])
            sums.append([(a - b) / (2 * size) for a, b in zip(*balance)])
        one.set(place)
        bound = one.get("right.force_bound") + one.get("left.force_bound")
        one.free()
    import numpy

    bounds = numpy.abs(numpy.linalg.inv(numpy.array(sums).T)) @ (bound * numpy.array([1, 0.75, 0.46]))
    found = co_simulate(path, radius)
    for k, (name, value, unit) in enumerate((("shift", expected["lateral_shift_m"], "m"), ("yaw", expected["yaw_rad"], "rad"))):
        error = abs(found[name] - value)
        print(f"{name}: {found[name]:.4g} {unit}, equilibrium {value:.4g}, {error:.2g} off, bound {bounds[k]:.2g}")
        check(f"{name} of the equilibrium", error <= bounds[k])
    check("inside the table", found["inside"])
    check(f"at rest: {found['left_over']}", all(abs(value) < 1 for value in found["left_over"]))
    check(f"a shift within 0.3 mm: {found['shift']}", abs(found["shift"] - expected["lateral_shift_m"]) < 3e-4)


def main():
    folder = pathlib.Path(sys.argv[1])
    if len(sys.argv) > 2:
        check_equilibrium(folder / "wheelset_fmi3.fmu", sys.argv[2])
        return
    values = []
    for version in (2, 3):
        with Fmu(folder / f"wheelset_fmi{version}.fmu") as fmu:
            check("version", fmu.version == version and fmu.function("GetVersion", ctypes.c_char_p)() == b"%d.0" % version)
            for examine in (check_description, check_values, check_sequences, check_all_functions, check_states):
                examine(fmu)
            check_table(fmu, folder / "results.csv")
            values.append(check_forces(fmu))
    check("both versions have the same values, to the bit", values[0] == values[1])


main()
print(f"{failed} failed")
sys.exit(failed > 0)
