"""A wheelset as FMUs of both versions: what a run writes, what importers ask of them, states against those of sessions, a curve against
its equilibrium, and what is refused."""

import ctypes
import math
import pathlib
import random
import re
import shutil
import subprocess
import sys
import time

from ctypes import c_bool, c_double, c_int, c_size_t, c_uint32, c_void_p

import numpy
import pytest
from conftest import PROJECT, same_files

sys.path.insert(0, str(PROJECT / "doc/python"))

from fmu import Fmu, Refused
from fmu_in_curve import co_simulate

SCENE = "wheelset_fmu"
SIX = {"Mesh/Elements across patch": 6}
SMALL = {**SIX, "FMU/Kind": "both", "FMU/Lateral shift": "-0.003 : 0.003 : 3", "FMU/Slip along": "-0.01, 0, 0.01", "FMU/Slip across": "-0.01, 0, 0.01",
         "FMU/Load": "60e3", "FMU/Yaw": 0, "FMU/Curvature": 0, "FMU/Points": 6}
NAMES = ("wheelset_fmi2.fmu", "wheelset_fmi3.fmu")
OF_STATES = ("wheelset_states_fmi2.fmu", "wheelset_states_fmi3.fmu")
BASE_UNITS = {"m": "m", "rad": "rad", "s": "s", "N": "kg m s-2", "Pa": "kg m-1 s-2", "N.m": "kg m2 s-2"}
FUNCTIONS = {  # that FMI 2.0 (44) and 3.0 (75) name
    2: """
        CancelStep CompletedIntegratorStep DeSerializeFMUstate DoStep EnterContinuousTimeMode EnterEventMode EnterInitializationMode
        ExitInitializationMode FreeFMUstate FreeInstance GetBoolean GetBooleanStatus GetContinuousStates GetDerivatives
        GetDirectionalDerivative GetEventIndicators GetFMUstate GetInteger GetIntegerStatus GetNominalsOfContinuousStates GetReal
        GetRealOutputDerivatives GetRealStatus GetStatus GetString GetStringStatus GetTypesPlatform GetVersion Instantiate NewDiscreteStates
        Reset SerializeFMUstate SerializedFMUstateSize SetBoolean SetContinuousStates SetDebugLogging SetFMUstate SetInteger SetReal
        SetRealInputDerivatives SetString SetTime SetupExperiment Terminate""",
    3: """
        ActivateModelPartition CompletedIntegratorStep DeserializeFMUState DoStep EnterConfigurationMode EnterContinuousTimeMode
        EnterEventMode EnterInitializationMode EnterStepMode EvaluateDiscreteStates ExitConfigurationMode ExitInitializationMode
        FreeFMUState FreeInstance GetAdjointDerivative GetBinary GetBoolean GetClock GetContinuousStateDerivatives GetContinuousStates
        GetDirectionalDerivative GetEventIndicators GetFMUState GetFloat32 GetFloat64 GetInt16 GetInt32 GetInt64 GetInt8 GetIntervalDecimal
        GetIntervalFraction GetNominalsOfContinuousStates GetNumberOfContinuousStates GetNumberOfEventIndicators
        GetNumberOfVariableDependencies GetOutputDerivatives GetShiftDecimal GetShiftFraction GetString GetUInt16 GetUInt32 GetUInt64
        GetUInt8 GetVariableDependencies GetVersion InstantiateCoSimulation InstantiateModelExchange InstantiateScheduledExecution Reset
        SerializeFMUState SerializedFMUStateSize SetBinary SetBoolean SetClock SetContinuousStates SetDebugLogging SetFMUState SetFloat32
        SetFloat64 SetInt16 SetInt32 SetInt64 SetInt8 SetIntervalDecimal SetIntervalFraction SetShiftDecimal SetShiftFraction SetString
        SetTime SetUInt16 SetUInt32 SetUInt64 SetUInt8 Terminate UpdateDiscreteStates""",
}


@pytest.fixture(scope="module")
def small(shared):
    """A table of few states."""
    return shared(SCENE, SMALL, output="small")


@pytest.fixture(scope="module", params=NAMES, ids=["fmi2", "fmi3"])
def fmu(request, small):
    with Fmu(small / request.param) as made:
        yield made


@pytest.fixture(scope="module", params=[*NAMES, *OF_STATES], ids=["fmi2", "fmi3", "fmi2 of states", "fmi3 of states"])
def any_fmu(request, small):
    """One of either kind."""
    with Fmu(small / request.param) as made:
        yield made


def tool(*command):
    """What a tool prints that takes its input."""
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, check=True).stdout


def test_what_a_run_writes(small):
    assert re.search("^points +[0-9] of [0-9] states", small.out, re.M), "how many points are within the bound"
    files = (*NAMES, *OF_STATES, "fmu_points.csv", "results.csv")
    assert small.has(*files)
    assert all(f'"{file}"' in small.text("run.json") for file in files)
    assert len(small.table("fmu_points.csv")) == 6


def test_no_points_no_rows(program):
    run = program(SCENE, SMALL, {"Table/Threads": 1, "FMU/Points": 0})
    assert not (run / "fmu_points.csv").exists()


def test_the_same_bytes_again(program, small):
    same_files(program(SCENE, SMALL, output="small_too"), small, *NAMES, *OF_STATES)


def test_what_is_packed(tmp_path, small):
    """One table and one binary, which is linked to the libraries of C and C++ alone and shows nothing but the interface."""
    folders = [tmp_path / f"v{version}" for version in (2, 3)]
    for folder, name in zip(folders, NAMES):
        tool("unzip", "-q", small / name, "-d", folder)
        tool("xmllint", "--noout", folder / "modelDescription.xml")
    tables = [(folder / "resources/wheelset.table").read_bytes() for folder in folders]
    assert tables[0] == tables[1]
    binaries = [folder / "binaries" / place / "rolling_contact_wheelset.so" for folder, place in zip(folders, ("linux64", "x86_64-linux"))]
    assert binaries[0].read_bytes() == binaries[1].read_bytes()
    for line in tool("ldd", binaries[1]).splitlines():
        assert re.search(r"linux-vdso|libstdc\+\+|libgcc_s|libm\.|libc\.|ld-linux", line)
    shown = [line.split()[2] for line in tool("nm", "-D", "--defined-only", binaries[1]).splitlines()]
    assert sorted(shown) == sorted(f"fmi{version}{name}" for version, names in FUNCTIONS.items() for name in names.split())


def refused(function, *words):
    """A call that the FMU refuses, with these words in its message."""
    with pytest.raises(Refused) as refusal:
        function()
    assert all(word in str(refusal.value) for word in words)


def test_description(any_fmu):
    """References and names are unique, units are declared, what is unknown is listed, starts are numbers."""
    assert any_fmu.function("GetVersion", ctypes.c_char_p)() == b"%d.0" % any_fmu.version
    variables = any_fmu.variables
    assert len({v.reference for v in variables}) == len(any_fmu.by_name) == len(variables)
    units = {unit.get("name"): dict(unit[0].attrib) for unit in any_fmu.description.find("UnitDefinitions")}
    for name, exponents in units.items():
        if name in BASE_UNITS:
            assert " ".join(f"{base}{'' if e == '1' else e}" for base, e in exponents.items()) == BASE_UNITS[name]
    for v in variables:
        assert v.unit is None or v.unit in units, v.name
        assert (v.start is not None) == (v.causality in ("input", "parameter", "local")), v.name
        assert v.initial == {"input": None, "independent": None, "output": "calculated"}.get(v.causality, "exact"), v.name
        if v.type == "Boolean":
            assert v.variability == "discrete", v.name
    structure = any_fmu.description.find("ModelStructure")
    if any_fmu.version == 2:
        listed = [[variables[int(u.get("index")) - 1].name for u in structure.find(part)] for part in ("Outputs", "InitialUnknowns")]
    else:
        names = {v.reference: v.name for v in variables}
        listed = [[names[int(u.get("valueReference"))] for u in structure.findall(part)] for part in ("Output", "InitialUnknown")]
    outputs = [v.name for v in variables if v.causality == "output"]
    assert listed == [outputs, outputs]
    assert [v.name for v in variables if v.causality == "independent"] == ["time"]


def test_ways_in_words(any_fmu):
    """Directions are those of doc/howto/fmu.md: x forwards, y to the right, z down, on both sides."""
    words = {v.get("name"): v.get("description") for v in any_fmu.description.find("ModelVariables")}
    for side in ("right", "left"):
        assert words[f"{side}.rail_y"] == f"displacement of the {side}-hand rail to the right"
        assert words[f"{side}.rail_z"] == f"displacement of the {side}-hand rail down"
        assert words[f"{side}.load"] == f"vertical load of the {side}-hand wheel on its rail"
        for axis, way in (("x", "forwards"), ("y", "to the right"), ("z", "down")):
            assert words[f"{side}.force_{axis}"].endswith(f"force on the wheel {way}"), axis
            assert re.search(f", {way}(:|$)", words[f"{side}.moment_{axis}"]), axis


def test_values(any_fmu):
    """Every variable answers, starts are those of the description, what is not set from outside is refused."""
    one = any_fmu.instantiate()
    refused(lambda: one.get("lateral_shift"), "before initialisation")
    one.initialise()
    for v in any_fmu.variables:
        value = one.get(v.name)
        if v.start is not None:
            assert value == (v.start.encode() if v.type == "String" else float(v.start)), v.name
        if v.type == "Real" and v.causality == "input":
            one.set({v.name: value})
        elif v.type == "Real":
            refused(lambda: one.set({v.name: value}), v.name)
    for bad in (math.nan, math.inf):
        refused(lambda: one.set(lateral_shift=bad), "finite")
    refused(lambda: one.set(friction=0.0), "above 0")
    kept = one.get("lateral_shift", "yaw")
    refused(lambda: one.set({"lateral_shift": 1e-3, "yaw": math.nan}), "yaw")
    assert one.get("lateral_shift", "yaw") == kept, "of two values, one of which is none, none is set"
    one.free()


def test_calls_out_of_order(any_fmu):
    """Never a crash."""
    one = any_fmu.instantiate()
    for name in ("ExitInitializationMode", "Terminate"):
        refused(lambda: one.call(name), "before initialisation")
    refused(lambda: one.step(1e-3), "before initialisation")
    if any_fmu.version == 2:
        refused(lambda: one.call("EnterInitializationMode"), "fmi2SetupExperiment")
        refused(lambda: one.initialise(1.0, 0.5), "stop time")
    one.initialise(0.5, 1.0, least_speed=0.2)
    assert one.get("least_speed") == 0.2 and one.get("time") == 0.5
    refused(lambda: one.set(least_speed=0.3), "fixed")
    for size in (0.0, -1e-3, math.nan, math.inf):
        refused(lambda: one.step(size))
    one.time = 0.7
    refused(lambda: one.step(1e-3), "begins")
    one.time = 0.5
    refused(lambda: one.step(0.6), "stop time")
    one.step(0.3)
    one.step(0.2)
    assert abs(one.get("time") - 1.0) < 1e-12
    refused(one.initialise, "between steps")
    refuses_null(any_fmu, one)
    one.terminate()
    assert one.get("right.force_z") < 0, "values after the end"
    refused(lambda: one.step(1e-3), "after termination")
    refused(lambda: one.set(yaw=0.0), "after termination")
    one.reset()
    refused(lambda: one.step(1e-3), "before initialisation")
    handle = one.handle
    one.free()
    for dead in (None, handle, c_void_p(8)):
        for name in ("Terminate", "Reset", "ExitInitializationMode"):
            assert any_fmu.function(name)(dead) != 0, name
        any_fmu.function("FreeInstance", None)(dead)
    refused(lambda: any_fmu.instantiate(token="{0}"), "{0}")
    refused(lambda: any_fmu.instantiate(resources="/nowhere"), "no such file")
    refused(lambda: any_fmu.instantiate(name=""), "no name")


def refuses_null(fmu, one):
    """Arrays that are NULL, variables and states that there are not."""
    is_2 = fmu.version == 2
    lengths = () if is_2 else (c_size_t(1),)
    real, state = ("Real", "FMUstate") if is_2 else ("Float64", "FMUState")
    reference, unknown = (c_uint32 * 1)(1), (c_uint32 * 1)(99999)
    for name in (f"Get{real}", f"Set{real}"):
        refused(lambda: one.call(name, None, c_size_t(1), None, *lengths), "NULL")
        refused(lambda: one.call(name, reference, c_size_t(1), None, *lengths), "NULL")
        one.call(name, None, c_size_t(0), None, *(() if is_2 else (c_size_t(0),)))
        refused(lambda: one.call(name, unknown, c_size_t(1), (c_double * 1)(), *lengths), "99999")
    refused(lambda: one.call("GetBoolean", reference, c_size_t(1), (c_int * 1)(), *lengths), "boolean")
    for name in (f"Get{state}", f"Set{state}"):
        refused(lambda: one.call(name, None))
    refused(lambda: one.call(f"Set{state}", c_void_p(12345)), "has not kept this state")
    if not is_2:
        assert fmu.function("Reset")(one.handle) == 0
        one.initialise()
        step = fmu.function("DoStep")
        assert step(one.handle, c_double(0), c_double(1e-3), c_bool(True), None, None, None, None) == 0, "without places for what it tells"
        refused(lambda: one.call("GetFloat64", reference, c_size_t(1), (c_double * 2)(), c_size_t(2)), "nValues")


def test_all_functions_answer_an_error_to_a_null_instance(any_fmu):
    for name in FUNCTIONS[any_fmu.version].split():
        if "Version" in name or "TypesPlatform" in name:
            continue
        is_new, is_free = "Instantiate" in name, name.endswith("FreeInstance")
        answer = any_fmu.function(name, c_void_p if is_new or is_free else c_int)(*[c_void_p(0)] * 12)
        if not is_free:
            assert answer == (None if is_new else 3), name


def random_inputs(source):
    return {
        "lateral_shift": source.uniform(-2e-3, 2e-3), "yaw": source.uniform(-2e-4, 2e-4),
        "lateral_velocity": source.uniform(-0.02, 0.02), "yaw_rate": source.uniform(-1e-3, 1e-3),
        "axle_speed": -20 / 0.46 * (1 + source.uniform(-2e-3, 2e-3)), "friction": 0.3,
        "right.load": source.uniform(50e3, 70e3), "left.load": source.uniform(50e3, 70e3),
        "left.rail_y": source.uniform(-2e-4, 2e-4), "right.rail_z": source.uniform(-1e-4, 1e-4)}


def test_states(any_fmu):
    """A state that is kept, set again or read by another instance has the same values, to the bit."""
    source = random.Random(4)
    outputs = [v.name for v in any_fmu.variables if v.causality != "local" and v.type == "Real"]
    one, other = any_fmu.instantiate("one"), any_fmu.instantiate("other")
    for instance in (one, other):
        instance.initialise()
    one.set(random_inputs(source))
    one.step(0.0123)
    saved, values = one.save(), one.get(*outputs)
    data = one.serialise(saved)
    assert one.serialise(saved) == data
    one.set(random_inputs(source))
    one.step(0.1)
    assert one.get(*outputs) != values
    one.restore(saved)
    assert one.get(*outputs) == values
    other.restore(other.deserialise(data, one.time))
    assert other.get(*outputs) == values
    refused(lambda: other.deserialise(data[:-1], 0.0), "not a state")
    refused(lambda: other.deserialise(bytes(len(data)), 0.0), "not a state")
    one.forget(saved)
    assert saved[0].value is None
    for instance in (one, other):
        instance.free()


def forces(fmu, n=300):
    """Outputs of random inputs: loads are carried, friction is within its limit and its bound, a step takes its time."""
    source = random.Random(5)
    one = fmu.instantiate()
    one.initialise()
    values, names = [], [v.name for v in fmu.variables if v.causality == "output" and v.type == "Real"]
    begun = time.perf_counter()
    for _ in range(n):
        inputs = random_inputs(source)
        one.set(inputs)
        one.step(1e-3)
        found = dict(zip(names, one.get(*names)))
        for side in ("right", "left"):
            load, bound = inputs[f"{side}.load"], found[f"{side}.force_bound"]
            if one.get(f"{side}.inside_table"):
                assert abs(found[f"{side}.force_z"] + load) <= bound + 1e-3 * load
                assert 0 < bound < load
            else:
                assert bound > 1e300
            assert abs(found[f"{side}.y_over_q"] * load - found[f"{side}.force_y"]) < 1e-6
        values.append(found)
    assert (time.perf_counter() - begun) / n < 1e-3, "seconds of a step of both wheels, with ctypes"
    one.free()
    return values


def test_both_versions_have_the_same_forces(small):
    """To the bit."""
    values = []
    for name in NAMES:
        with Fmu(small / name) as made:
            values.append(forces(made))
    assert values[0] == values[1]


def test_states_of_the_table(fmu, small):
    """At them an FMU has their forces, and their bounds alone."""
    one = fmu.instantiate()
    one.initialise()
    errors = []
    for row in small.results.records(status="solved"):
        radius, load = row["Profiles/Curve radius"], row["normal_force_N"]
        one.set({"lateral_shift": row["Profiles/Lateral shift"], "yaw": row["Profiles/Yaw"], "curvature": 1 / radius if radius != 1e9 else 0.0,
                 "axle_speed": row["Profiles/Pitch rate"], "lateral_velocity": row["Profiles/Lateral velocity"],
                 "right.load": row["Contact/Vertical load"]})
        *force, bound = one.get("right.force_x", "right.force_y", "right.force_z", "right.force_bound")
        error = math.dist(force, (row["force_track_x_N"], row["force_track_y_N"], -row["force_track_z_N"]))
        errors += [error / load, abs(one.get("right.max_pressure") / row["max_pressure_Pa"] - 1)]
        assert one.get("right.inside_table")
        own = row["bound_force/muN"] * row["Contact/Friction coefficient"] * load
        assert abs(bound - own) <= 1e-3 * own + 1e-3
    assert max(errors) < 1e-6
    one.free()


@pytest.fixture(scope="module")
def curve(shared):
    """A finer table, for a curve."""
    slips = "-0.015, -0.003, 0, 0.003, 0.015"
    return shared(SCENE, SIX, {"FMU/Lateral shift": "-0.0028, -0.0025, -0.0022, -0.0017, 0, 0.0017, 0.0022, 0.0025, 0.0028",
                               "FMU/Yaw": "-2e-4, 0, 2e-4", "FMU/Curvature": "-0.001, 0, 0.001", "FMU/Load": "60e3", "FMU/Points": 24,
                               "FMU/Slip along": slips, "FMU/Slip across": slips}, output="curve")


def test_values_between_states(curve):
    within, n = map(int, re.search(r"^points +(\d+) of (\d+) states", curve.out, re.M).groups())
    assert n >= 10 and within >= n - 1
    assert "with a margin of 0." in curve.screen, "the bound is narrower than of straight lines over kinks"


def test_a_wheelset_in_a_curve_comes_to_rest_in_equilibrium(program, curve):
    """Its forces balance within the bounds, near the equilibrium."""
    run = program("wheelset_curve", SIX, {"Wheelset/Curve radius": 1500, "Wheelset/Search for others": "false"})
    expected = run.table("wheelset.csv").records()[0]
    radius = expected["curve_radius_m"]
    place = {"lateral_shift": expected["lateral_shift_m"], "yaw": expected["yaw_rad"], "axle_speed": expected["pitch_rate_rad/s"]}
    path = curve / NAMES[1]
    with Fmu(path) as made:
        one = made.instantiate()
        one.initialise(**place, curvature=1 / radius)
        for side in ("right", "left"):
            force, bound = one.get(f"{side}.force_y", f"{side}.force_bound")
            assert abs(force - expected[f"{side}_force_y_N"]) <= bound and one.get(f"{side}.inside_table"), f"{side}: at the equilibrium"
        # how far the place may be off: by its slopes, differences in y, psi, and the speed of the axle
        slopes = []
        for name, size in (("lateral_shift", 2e-5), ("yaw", 2e-6), ("axle_speed", 1e-3)):
            balance = []
            for sign in (1, -1):
                one.set({**place, name: place[name] + sign * size})
                force, turn, torque = (one.get(f"right.{k}") + one.get(f"left.{k}") for k in ("force_y", "moment_z", "moment_y"))
                balance.append([force, turn - 10e6 * (place["yaw"] + (sign * size if name == "yaw" else 0)), torque])
            slopes.append([(a - b) / (2 * size) for a, b in zip(*balance)])
        one.set(place)
        bound = one.get("right.force_bound") + one.get("left.force_bound")
        one.free()
    bounds = numpy.abs(numpy.linalg.inv(numpy.array(slopes).T)) @ (bound * numpy.array([1, 0.75, 0.46]))
    found = co_simulate(path, radius)
    assert abs(found["shift"] - place["lateral_shift"]) <= min(bounds[0], 3e-4)
    assert abs(found["yaw"] - place["yaw"]) <= bounds[1]
    assert found["inside"]
    assert all(abs(value) < 1 for value in found["left_over"]), "at rest"


@pytest.mark.parametrize("settings, says", [
    ({"FMU/Yaw": "0, 1e-3"}, "has two values"),
    ({"FMU/Yaw": "0, 1e-3, -1e-3"}, "values must ascend"),
    ({"FMU/Load": -1}, "give numbers above 0"),
    ({"FMU/Curvature": 25}, "give 1/m from -0.1 to 0.1"),
    ({"Table/Axis 1": "Contact/Speed=1,2"}, "leave them empty"),
    ({"Profiles/Creepages": "given"}, "from kinematics"),
    ({"Profiles/Side": "left"}, "take automatic and right"),
    ({"Contact/Friction law": "exponential", "Contact/Kinetic friction coefficient": 0.2, "Contact/Friction decay speed": 1},
     "a coefficient above 0 that is constant"),
    ({"Contact/Vertical load": "", "Contact/Normal load": "60e3"}, "Contact/Vertical load"),
])
def test_refused(program, settings, says):
    program.refuses(SCENE, says, SMALL, settings)


def test_a_program_without_the_binary_says_so(program):
    program.path = pathlib.Path(shutil.copy(program.path, program.folder / "alone"))
    program(SCENE, SMALL, code=1, says="build the target rolling_contact_wheelset")
