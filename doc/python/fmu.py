"""Loads an FMU for co-simulation, FMI 2.0 or 3.0, with ctypes: enough for those of `Analysis = fmu`.

    with Fmu("output/wheelset_fmu/wheelset_fmi3.fmu") as fmu:
        wheelset = fmu.instantiate()
        wheelset.initialise(speed=20.0)
        wheelset.set(lateral_shift=-0.001)
        wheelset.step(1e-3)
        print(wheelset.get("right.force_y"))
"""

import ctypes
import pathlib
import shutil
import tempfile
import xml.etree.ElementTree
import zipfile

from ctypes import byref, c_bool, c_char, c_char_p, c_double, c_int, c_size_t, c_uint32, c_void_p

OK, DISCARD = 0, 2

Logger2 = ctypes.CFUNCTYPE(None, c_void_p, c_char_p, c_int, c_char_p, c_char_p, c_char_p)
Logger3 = ctypes.CFUNCTYPE(None, c_void_p, c_int, c_char_p, c_char_p)


class Callbacks2(ctypes.Structure):
    """fmi2CallbackFunctions."""

    _fields_ = [
        ("logger", Logger2),
        ("allocateMemory", c_void_p),
        ("freeMemory", c_void_p),
        ("stepFinished", c_void_p),
        ("componentEnvironment", c_void_p),
    ]


class Variable:
    """A variable of modelDescription.xml."""

    def __init__(self, element, real):
        self.name = element.get("name")
        self.reference = int(element.get("valueReference"))
        self.causality = element.get("causality", "local")
        self.variability = element.get("variability", "continuous")
        self.initial = element.get("initial")
        self.type = real.tag.replace("Float64", "Real")
        self.unit = real.get("unit")
        self.start = real.get("start")
        if self.type == "String" and real.find("Start") is not None:
            self.start = real.find("Start").get("value")


class Refused(RuntimeError):
    """A function did not answer OK; the text has what it logged. Attribute status: DISCARD where a step to other inputs
    is possible."""

    def __init__(self, text, status=None):
        super().__init__(text)
        self.status = status


class Fmu:
    """An unpacked FMU with its library; `with` removes what was unpacked."""

    def __init__(self, path):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="fmu_"))
        with zipfile.ZipFile(path) as archive:
            archive.extractall(self.folder)
        self.xml = self.folder / "modelDescription.xml"
        self.description = xml.etree.ElementTree.parse(self.xml).getroot()
        self.version = int(float(self.description.get("fmiVersion")))
        self.prefix = f"fmi{self.version}"
        self.token = self.description.get("guid" if self.version == 2 else "instantiationToken")
        model = self.description.find("CoSimulation").get("modelIdentifier")
        platform = "linux64" if self.version == 2 else "x86_64-linux"
        self.binary = self.folder / "binaries" / platform / f"{model}.so"
        self.library = ctypes.CDLL(str(self.binary))
        elements = self.description.find("ModelVariables")
        self.variables = [Variable(e, e[0] if self.version == 2 else e) for e in elements]
        self.by_name = {variable.name: variable for variable in self.variables}

    def __enter__(self):
        return self

    def __exit__(self, *_):
        shutil.rmtree(self.folder)

    def function(self, name, result=c_int):
        """fmi2NAME or fmi3NAME."""
        found = getattr(self.library, self.prefix + name)
        found.restype = result
        return found

    def instantiate(self, name="wheelset", token=None, resources=None):
        return Instance(self, name, token or self.token, resources or self.folder / "resources")


class Instance:
    """An instance; its functions raise Refused where the FMU answers an error."""

    def __init__(self, fmu, name, token, resources):
        self.fmu, self.messages, self.time = fmu, [], 0.0
        if fmu.version == 2:
            self.logger = Logger2(lambda _e, _n, _s, _c, _f, text: self.messages.append(text.decode()))
            self.callbacks = Callbacks2(logger=self.logger)
            create = fmu.function("Instantiate", c_void_p)
            location = pathlib.Path(resources).absolute().as_uri()
            handle = create(
                name.encode(), 1, token.encode(), location.encode(), byref(self.callbacks), c_int(0), c_int(1)
            )
        else:
            self.logger = Logger3(lambda _e, _s, _c, text: self.messages.append(text.decode()))
            create = fmu.function("InstantiateCoSimulation", c_void_p)
            flags = [c_bool(False), c_bool(True), c_bool(False), c_bool(False)]
            handle = create(
                name.encode(), token.encode(), f"{resources}/".encode(), *flags, None, c_size_t(0), None, self.logger,
                None,
            )
        if not handle:
            raise Refused("; ".join(self.messages))
        self.handle = c_void_p(handle)

    def call(self, name, *arguments):
        """A function of the instance, which must answer OK."""
        n_before = len(self.messages)
        status = self.fmu.function(name)(self.handle, *arguments)
        if status != OK:
            raise Refused(f"{name}: status {status}: " + "; ".join(self.messages[n_before:]), status)

    def initialise(self, start=0.0, stop=None, **values):
        """From its beginning to where steps are taken, with values of variables."""
        self.time = start
        has_stop, flag = stop is not None, c_int if self.fmu.version == 2 else c_bool
        experiment = (flag(False), c_double(0), c_double(start), flag(has_stop), c_double(stop or 0))
        if self.fmu.version == 2:
            self.call("SetupExperiment", *experiment)
            self.call("EnterInitializationMode")
        else:
            self.call("EnterInitializationMode", *experiment)
        if values:
            self.set(values)
        self.call("ExitInitializationMode")

    def _references(self, names):
        references = [self.fmu.by_name[name].reference for name in names]
        return (c_uint32 * len(names))(*references), c_size_t(len(names))

    def set(self, values=None, **more):
        """Real inputs and parameters by name."""
        values = {**(values or {}), **more}
        array = (c_double * len(values))(*values.values())
        lengths = () if self.fmu.version == 2 else (c_size_t(len(values)),)
        name = "SetReal" if self.fmu.version == 2 else "SetFloat64"
        self.call(name, *self._references(list(values)), array, *lengths)

    def set_text(self, **values):
        """String parameters by name."""
        array = (c_char_p * len(values))(*(value.encode() for value in values.values()))
        lengths = () if self.fmu.version == 2 else (c_size_t(len(values)),)
        self.call("SetString", *self._references(list(values)), array, *lengths)

    def get(self, *names):
        """Values of variables of one type; one value for one name."""
        kind = self.fmu.by_name[names[0]].type
        is_2 = self.fmu.version == 2
        element = {"Real": c_double, "Boolean": c_int if is_2 else c_bool, "String": c_char_p}[kind]
        array = (element * len(names))()
        lengths = () if is_2 else (c_size_t(len(names)),)
        self.call("Get" + (kind if is_2 else kind.replace("Real", "Float64")), *self._references(names), array, *lengths)
        values = [bool(value) if kind == "Boolean" else value for value in array]
        return values[0] if len(values) == 1 else values

    def step(self, size):
        """One communication step."""
        if self.fmu.version == 2:
            self.call("DoStep", c_double(self.time), c_double(size), c_int(1))
            self.time += size
            return
        flags, last = [c_bool() for _ in range(3)], c_double()
        self.call(
            "DoStep", c_double(self.time), c_double(size), c_bool(True), *[byref(f) for f in flags], byref(last)
        )
        self.time = last.value

    def _state_name(self, pattern):
        return pattern.format("FMUstate" if self.fmu.version == 2 else "FMUState")

    def save(self):
        state = c_void_p()
        self.call(self._state_name("Get{}"), byref(state))
        return state, self.time

    def restore(self, saved):
        state, self.time = saved
        self.call(self._state_name("Set{}"), state)

    def forget(self, saved):
        self.call(self._state_name("Free{}"), byref(saved[0]))

    def serialise(self, saved):
        size = c_size_t()
        self.call(self._state_name("Serialized{}Size"), saved[0], byref(size))
        data = (c_char * size.value)()
        self.call(self._state_name("Serialize{}"), saved[0], data, size)
        return data.raw

    def deserialise(self, data, time):
        state = c_void_p()
        name = "DeSerializeFMUstate" if self.fmu.version == 2 else "DeserializeFMUState"
        self.call(name, data, c_size_t(len(data)), byref(state))
        return state, time

    def terminate(self):
        self.call("Terminate")

    def reset(self):
        self.call("Reset")

    def free(self):
        self.fmu.function("FreeInstance", None)(self.handle)
