"""Input that is refused, and that nothing is written then."""

import os
import pathlib

import pytest
from conftest import VALIDATE

DISCS = "carter_2d_partial_slip"
CURVE = "lateral_3d_creep_curve"
START = "start_up_2d"
TARGET = {"Mesh/Target error": 1e-2}
LOADS = {"Analysis": "load curve"}

REFUSED = [
    (DISCS, "Wheel/Radius = -1", {"Wheel/Radius": -1}),
    (DISCS, "Rail/Poisson ratio = 0.7: give a number from 0 to 0.5.", {"Rail/Poisson ratio": 0.7}),
    (DISCS, "below 0.5", {"Rail/Poisson ratio": 0.5}),
    (DISCS, "Wheel/Young modulus = -1: give a number of at least 0 Pa.", {"Wheel/Young modulus": -1}),
    (DISCS, "Rail/Density = 0: it must be above 0 kg/m^3.", {"Rail/Density": 0}),
    (DISCS, "Wheel/Radius = 1e+308: at most 1e6 m; a flat surface has 0.", {"Wheel/Radius": 1e308}),
    (DISCS, "Wheel/Hub radius = 0: it must lie above 0 m and below the Radius.", {"Wheel/Hub radius": 0}),
    (DISCS, "Contact/Friction coefficient = 0,3: give a number of at least 0; decimals take a point.", {"Contact/Friction coefficient": "0,3"}),
    (DISCS, "a value has no '#'", {"Contact/Approach": "1e-4 # m"}),
    (DISCS, "give `automatic`, `economical`, ", {"Contact/Solver": "newton"}),
    (DISCS, "give `true` or `false`.", {"Output/Plot": "maybe"}),
    (DISCS, "one of them", {"Contact/Normal load": 1}),
    (DISCS, "both empty", {"Contact/Approach": ""}),
    (DISCS, "Mesh/Elements across patch", {"Mesh/Elements across patch": 0}),
    (DISCS, "3D only", {"Contact/Spin": 1}),
    (DISCS, "Dimension", {"Dimension": 4}),
    (DISCS, "Lateral radius", {"Dimension": 3, "Analysis": "transient", "Time/End time": 1e-3, "Time/Time step": 1e-4}),
    (DISCS, "Wheel/Lateral radius = 0.3: in 2D", {"Wheel/Lateral radius": 0.3}),
    (DISCS, "there is no entry Contact/Nrmal load; did you mean Contact/Normal load?", {"Contact/Nrmal load": 1}),
    (DISCS, "did you mean Contact/Spin?", {"Cntact/Spin": 1}),
    (DISCS, "did you mean Contact/Friction coefficient or FMU/Friction coefficient?", {"Friction coefficient": 1}),
    (DISCS, "did you mean Rail/Radius or Wheel/Radius?", {"Contact/Radius": 1}),
    (CURVE, "the list is empty", {"Creep curve/Creepage y": ""}),
    (CURVE, "'fast' is not a number", {"Creep curve/Creepage y": "0, fast"}),
    (CURVE, "a range needs at least 2 points", {"Creep curve/Creepage y": "0 : 0.01"}),
    (CURVE, "a range has at most a million points", {"Creep curve/Creepage y": "0 : 0.01 : 1e7"}),
    (CURVE, "same length", {"Creep curve/Spin": "1, 2"}),
    (DISCS, "Creep curve/Creepage y contains 0.005", {"Analysis": "creep curve", "Creep curve/Creepage y": "0 : 0.01 : 3"}),
    ("wheel_modes", "Receptance/Frequencies per octave = 100000000: give a whole number from 1 to 1000.",
     {"Analysis": "receptance", "Receptance/Frequencies per octave": 100000000}),
    (CURVE, "Load curve/Shares of load = 0.1; 1: '0.1; 1' is not a number", {**LOADS, "Load curve/Shares of load": "0.1; 1"}),
    (CURVE, "Load curve/Shares of load contains 0: give shares above 0 and at most 1", {**LOADS, "Load curve/Shares of load": "0 : 1 : 3"}),
]
NOT_VALID = [
    (DISCS, "Contact/Normal load = -5", {"Contact/Approach": "", "Contact/Normal load": -5}),
    (DISCS, "it is one expression", {"Contact/Roughness": "x; y"}),
    (DISCS, "cannot be repeated", {"Contact/Roughness": "1e-6 * rand()"}),
    (DISCS, "Contact/Roughness = 0,5e-6*cos(x): decimals take a point", {"Contact/Roughness": "0,5e-6*cos(x)"}),
    (DISCS, "Contact/Roughness = x=5: a '=' would assign", {"Contact/Roughness": "x=5"}),
    (DISCS, "'t' is not known here; there are x, y, pi", {"Contact/Roughness": "1e-6*cos(t)"}),
    (START, "Time/Creepage x = t=5: a '=' would assign", {"Time/Creepage x": "t=5"}),
    (START, "'x' is not known here; there are t, pi", {"Time/Creepage x": "0.001*x"}),
    (DISCS, "Mesh/Target error = 0: give a number above 0 and below 1", {"Mesh/Target error": 0}),
    (DISCS, "Mesh/Target error = fine: give a number", {"Mesh/Target error": "fine"}),
    (DISCS, "and Contact/Friction coefficient = 0", {**TARGET, "Contact/Friction coefficient": 0}),
    (DISCS, "and Mesh/Adaptive levels = 2", {**TARGET, "Mesh/Adaptive levels": 2}),
    ("own_mesh_2d", "a body from a mesh file (Rail/Shape) has elements of its own", TARGET),
]
WHILE_IT_RUNS = [
    (DISCS, "it is not finite at", {"Contact/Roughness": "1/x"}),
    (DISCS, "free: take fewer", {"Mesh/Elements across patch": 100000}),
    (CURVE, "Wheel/Width", {"Wheel/Width": 0.006}),
    (DISCS, "Contact node budget", {"Mesh/Adaptive levels": 1, "Mesh/Contact node budget": 5}),
]
FILES = {
    "empty.prm": ("", "empty.prm: the file is empty"),
    "typo.prm": ("set Dimension = 2\nsubsection Contact\n  set Aproach = 1\nend\n",
                 "typo.prm: line 3: there is no entry Contact/Aproach; did you mean Contact/Approach?"),
    "section.prm": ("subsection Contct\nend\n", "section.prm: line 1: there is no section Contct; did you mean Contact?"),
    "statement.prm": ("sbsection Contact\nend\n", "statement.prm: line 1: 'sbsection Contact' is no line"),
    "twice.prm": ("subsection Contact\n set Approach = 1e-4\n set Approach = 2e-4\nend\n",
                  "twice.prm: line 3: Contact/Approach is given here and in line 2"),
    "range.prm": ("subsection Contact\n set Friction coefficient = -1\nend\n",
                  "range.prm: line 2: Contact/Friction coefficient = -1: give a number of at least 0."),
    "type.prm": ("subsection Mesh\n  set Growth = steep\nend\n", "steep"),
    "open.prm": ("subsection Mesh\n  set Growth = 0.1\n", "open.prm: section Mesh is not ended"),
    "closed.prm": ("end\n", "closed.prm: line 1: 'end' without a section"),
    "self.prm": ("include self.prm\n", "self.prm: line 1: more than 100"),
    "brace.prm": ("set Analysis = {quasi-static creep curve}\n", "brace.prm: line 1: '{'"),
    "large.prm": ("\n" * 17000000, "more than 16 MiB"),
}


@pytest.mark.parametrize("scene, says, settings", REFUSED)
def test_a_run_is_refused(program, scene, says, settings):
    program.refuses(scene, says, settings)


@pytest.mark.parametrize("scene, says, settings", NOT_VALID)
def test_validation_refuses(program, scene, says, settings):
    program.refuses(scene, says, settings, options=VALIDATE)


@pytest.mark.parametrize("scene, says, settings", WHILE_IT_RUNS)
def test_a_run_stops(program, scene, says, settings):
    program(scene, settings, code=1, says=says)


@pytest.mark.parametrize("name", FILES)
def test_a_file_is_refused(program, name):
    text, says = FILES[name]
    program.write(name, text)
    program.refuses(name, says)


@pytest.mark.parametrize("options, says", [
    ((), "no parameter file"),
    (("--nonsense",), "--help"),
    (("missing.prm",), "missing.prm"),
    (("/dev/zero",), "it is a pipe or a device"),
    ((".",), "cannot be read: it is a folder"),
    ((DISCS, DISCS), "one parameter file at a time"),
    ((DISCS, "--output", "", "--validate"), "--output is empty"),
    ((DISCS, "--set", "Contact"), "Section/Entry=value"),
    ((DISCS, "--resume"), "only a transient run"),
])
def test_a_command_is_refused(program, options, says):
    program.refuses(None, says, options=[program.scene(word) if word == DISCS else word for word in options])


def test_a_target_out_of_reach(program):
    run = program(DISCS, {"Mesh/Target error": 1e-6}, code=1, says="the smallest bound of any mesh is")
    assert not (run / "results.csv").exists()


def test_a_pipe_as_a_file(program):
    os.mkfifo(program.folder / "pipe")
    program.refuses(pathlib.Path("pipe"), "pipe: cannot be read: it is a pipe")


def test_a_file_without_permission(another_user):
    another_user.write("private.prm", "set Dimension = 2\n").chmod(0)
    another_user.refuses("private.prm", "private.prm: cannot be read: Permission denied", before=another_user.before)


def test_bytes_that_are_no_text(program):
    """What the screen shows of them is text, too."""
    (program.folder / "noise.prm").write_bytes(os.urandom(3000))
    program.refuses("noise.prm", "so it is no text")
    (program.folder / "latin.prm").write_bytes(b"\303\250t\351 \303\n")
    run = program.refuses("latin.prm", r"latin.prm: line 1: 'èt\xE9 \xC3' is no line")
    assert "\ufffd" not in run.err and not any("\x80" <= letter <= "\x9f" for letter in run.err)


def test_what_is_no_mistake(program):
    """An entry of an included file is overridden; a byte order mark and CRLF; a comparison in a history."""
    program.write("base.prm", "subsection Contact\n set Approach = 1e-4\nend\n")
    program.write("over.prm", "include base.prm\nsubsection Contact\n set Approach = 2e-4\nend\n")
    program("over.prm", options=VALIDATE)
    (program.folder / "windows.prm").write_bytes(b"\357\273\277" + program.scene(DISCS).read_bytes().replace(b"\n", b"\r\n"))
    program("windows.prm", options=VALIDATE)
    program(START, {"Time/Creepage x": "if(t>=1e-3,0.001,0.002)"}, options=VALIDATE)


def test_a_place_that_is_not_ours(program):
    program.write("a_file", "")
    program(DISCS, output="a_file", code=1, says="a_file")
    (program.folder / "foreign").mkdir()
    program.write("foreign/thesis.tex", "")
    run = program(DISCS, output="foreign", code=1, says="foreign")
    assert run.files() == ["thesis.tex"]
