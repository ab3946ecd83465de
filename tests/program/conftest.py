"""The program as a process: what all its tests share.

    pytest tests/program/test_curves.py --program build/rolling-contact

A test takes the fixture `program` and calls it: `program("carter_2d_partial_slip", coarse, output="x")` runs a
scene of prm with settings, asserts the exit code, and returns a Run with its screen, messages, folder and tables.
Each test has a folder of its own; runs that several tests of a file look at come from `shared`.
"""

import csv
import json
import math
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import pytest

HERE = pathlib.Path(__file__).resolve().parent
PROJECT = HERE.parents[1]
sys.dont_write_bytecode = True
AS_ROOT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_mpi_yield_when_idle": "1"}

# settings that many tests share
QUIET = {"Output/Verbosity": "quiet"}
QUICK = {"Mesh/Elements across patch": 12, **QUIET}
COARSE = {"Mesh/Elements across patch": 10, "Mesh/Growth": 0.7}
COARSER = {"Mesh/Elements across patch": 12, "Mesh/Growth": 0.5}
LIGHT = {**COARSER, **QUIET}

# options that many tests share
VALIDATE = ("--validate",)
RESUME = ("--resume",)


def pytest_addoption(parser):
    parser.addoption("--program", default=os.environ.get("ROLLING_CONTACT_PROGRAM", PROJECT / "build/rolling-contact"))
    parser.addoption("--prm", default=PROJECT / "prm")


def words(text):
    """A text on one line, however the screen has broken it."""
    return " ".join(text.split())


def number(text):
    """The number that a text is, or the text."""
    try:
        return float(text)
    except ValueError:
        return text


class Table:
    """A CSV file: `table["column"]` are its numbers, nan where a cell is empty."""

    def __init__(self, path):
        self.path = pathlib.Path(path)
        with open(path, newline="", encoding="utf-8") as file:
            lines = list(csv.reader(file))
        self.columns, self.rows = lines[0], lines[1:]
        uneven = [k + 2 for k, row in enumerate(self.rows) if len(row) != len(self.columns)]
        assert not uneven, f"{path}: lines {uneven} have not {len(self.columns)} cells"

    def __len__(self):
        return len(self.rows)

    def __contains__(self, column):
        return column in self.columns

    def texts(self, column):
        assert column in self.columns, f"{self.path} has no column {column}; it has {', '.join(self.columns)}"
        at = self.columns.index(column)
        return [row[at] for row in self.rows]

    def __getitem__(self, column):
        return [float(text) if text else math.nan for text in self.texts(column)]

    def last(self, column):
        """The number in the last row."""
        return self[column][-1]

    def without(self, *columns):
        """All cells but those of columns that differ from run to run."""
        kept = [k for k, name in enumerate(self.columns) if name not in columns]
        return [[row[k] for k in kept] for row in [self.columns, *self.rows]]

    def records(self, **cells):
        """Its rows by the names of columns, those that have these cells; what is a number is one."""
        rows = [{name: number(text) for name, text in zip(self.columns, row)} for row in self.rows]
        return [row for row in rows if all(row[name] == value for name, value in cells.items())]

    def record(self, **cells):
        """The one row that has these cells."""
        found = self.records(**cells)
        assert len(found) == 1, f"{self.path}: {len(found)} rows have {cells}"
        return found[0]


DOCUMENTED = set(re.findall(r"`([^`\n]+)`", (PROJECT / "doc/reference/output.md").read_text(encoding="utf-8")))


class Run:
    """What a run has left: exit code, screen, messages and the files of its folder."""

    def __init__(self, command, folder, code, out, err, seconds):
        self.command, self.folder, self.code, self.seconds = command, folder, code, seconds
        self.out, self.err = out, err
        self.screen, self.messages = words(out), words(err)

    def __truediv__(self, name):
        return self.folder / name

    def __repr__(self):
        return f"{' '.join(map(str, self.command))}\nexit code {self.code}\n{self.out[-3000:]}\n{self.err[-3000:]}"

    def table(self, name):
        return Table(self.folder / name)

    def text(self, name):
        return (self.folder / name).read_text(encoding="utf-8")

    def has(self, *names):
        """All of these files are there and not empty."""
        return all((self.folder / name).is_file() and (self.folder / name).stat().st_size > 0 for name in names)

    def points(self, name):
        """The numbers of each line of the data of a picture."""
        return [tuple(map(float, line.split())) for line in self.text(name).splitlines() if re.match(r"\s*[-+]?[.\d]", line)]

    @property
    def results(self):
        return self.table("results.csv")

    @property
    def json(self):
        return json.loads((self.folder / "run.json").read_text(encoding="utf-8"))

    def files(self):
        return sorted(path.name for path in self.folder.iterdir())


class Running:
    """A run that goes on while a test looks on."""

    def __init__(self, command, folder, process, out, err):
        self.command, self.folder, self.process, self.files = command, folder, process, (out, err)
        self.start = time.monotonic()

    def __truediv__(self, name):
        return self.folder / name

    def wait_until(self, condition, seconds=30):
        """Waits for a condition, or until the run has ended by itself."""
        end = time.monotonic() + seconds
        while not condition() and self.process.poll() is None and time.monotonic() < end:
            time.sleep(0.02)
        return condition()

    def wait_for_rows(self, n, name="results.csv", seconds=30):
        """Waits until a table has n rows."""
        return self.wait_until(lambda: n_lines(self.folder / name) > n, seconds)

    def send(self, signal_number):
        self.process.send_signal(signal_number)

    def end(self, seconds=300):
        """Waits for the end of the run."""
        code = self.process.wait(timeout=seconds)
        out, err = (path.read_text(encoding="utf-8", errors="replace") for path in self.files)
        return Run(self.command, self.folder, code, out, err, time.monotonic() - self.start)


def n_lines(path):
    try:
        return pathlib.Path(path).read_bytes().count(b"\n")
    except OSError:
        return 0


class Program:
    """Runs the program in a folder."""

    def __init__(self, path, prm, folder):
        self.path, self.prm, self.folder = pathlib.Path(path).resolve(), pathlib.Path(prm).resolve(), folder
        self.running = []

    def scene(self, name):
        """A scene of prm by its name, or a file."""
        return self.prm / f"{name}.prm" if isinstance(name, str) and not name.endswith(".prm") else pathlib.Path(name)

    def write(self, name, text):
        """A file in the folder of the test."""
        path = self.folder / name
        path.write_text(text, encoding="utf-8")
        return path

    def command(self, scene, settings, output, options, before, ranks):
        """What is run, and the folder that it writes to."""
        file = [] if scene is None else [self.scene(scene)]
        name = output or (f"output/{file[0].stem}" if file else "output/none")
        line = [*before, *(["mpirun", "--oversubscribe", "--bind-to", "none", "-n", str(ranks)] if ranks else []), self.path, *file]
        for setting in settings:
            for entry, value in setting.items():
                line += ["--set", f"{entry}={value}"]
        if output is not None:
            line += ["--output", output]
        return [str(part) for part in [*line, *options]], self.folder / name

    def start(self, scene, *settings, output=None, options=(), before=(), ranks=0, env=None):
        """A run that goes on; it is killed with the test."""
        line, folder = self.command(scene, settings, output, options, before, ranks)
        out, err = (self.folder / f".{kind}.{len(self.running)}" for kind in ("out", "err"))
        with open(out, "wb") as out_file, open(err, "wb") as err_file:
            process = subprocess.Popen(line, cwd=self.folder, stdout=out_file, stderr=err_file, stdin=subprocess.DEVNULL,
                                       env={**os.environ, **AS_ROOT, **(env or {})})
        self.running.append(Running(line, folder, process, out, err))
        return self.running[-1]

    def __call__(self, scene, *settings, code=0, says="", seconds=300, **how):
        """A run to its end: its exit code is asserted, and a text of its messages."""
        run = self.start(scene, *settings, **how).end(seconds)
        assert run.code == code, run
        assert says in run.messages, run
        return run

    def names(self):
        """What is in the folder of the test, but for what this class writes."""
        return sorted(path.name for path in self.folder.iterdir() if not path.name.startswith("."))

    def refuses(self, scene, says, *settings, **how):
        """Input that is refused before anything is written."""
        here = self.names()
        run = self(scene, *settings, code=1, says=says, **how)
        assert not run.folder.exists(), f"{run.folder} was written"
        assert self.names() == here
        return run

    def stop(self):
        for run in self.running:
            if run.process.poll() is None:
                run.process.send_signal(signal.SIGKILL)
                run.process.wait()


@pytest.fixture
def program(request, tmp_path):
    made = Program(request.config.getoption("program"), request.config.getoption("prm"), tmp_path)
    yield made
    made.stop()


@pytest.fixture
def another_user(program):
    """As program, in a folder that all may enter, with `before` for a run by one who is not root."""
    with tempfile.TemporaryDirectory() as folder:
        os.chmod(folder, 0o755)
        made = Program(shutil.copy(program.path, folder), program.prm, pathlib.Path(folder))
        made.path.chmod(0o755)
        made.before = ("setpriv", "--reuid=65534", "--clear-groups") if os.getuid() == 0 else ()
        yield made
        made.stop()


@pytest.fixture(scope="module")
def shared(request, tmp_path_factory):
    """As program, for runs that several tests of a file look at."""
    made = Program(request.config.getoption("program"), request.config.getoption("prm"), tmp_path_factory.mktemp("shared"))
    yield made
    made.stop()


def near(value, expected, relative=0.0, absolute=0.0, what=""):
    """A number is another one but for the sum of two tolerances."""
    assert abs(value - expected) <= relative * abs(expected) + absolute, f"{what} {value:.9g}, expected {expected:.9g}"


def written(run, *names):
    """Files that are there, and not empty."""
    for name in names:
        assert (run / name).is_file() and (run / name).stat().st_size > 0, f"{run.folder} has no {name}"


def own_mesh(run):
    """What a run with a rail from a file says and writes."""
    assert "are coupled to the interface" in run.screen, run
    written(run, "results.csv", "bodies.pvd", "rail.vtu", "interface.pvd")
    summary_has(run, "of mu N (estimate: ")


def limited(words):
    """A run in a shell that sets limits first, as `before`."""
    return "bash", "-c", f'{words} && exec "$@"', "limited"


def kill_and_resume(program, moments, *scene, output, file="checkpoint.bin", begun=lambda run: True, killed=lambda folder: None):
    """A run that is killed so many seconds after it has begun, each time resumed if there is a file for that, to its end.

    Returns the run and how often it was killed."""
    for kills, moment in enumerate([*moments, None]):
        run = program.start(*scene, output=output, options=RESUME if (program.folder / output / file).exists() else ())
        if moment is not None:
            run.wait_until(lambda: begun(run))
            run.wait_until(lambda: False, moment)
            run.send(signal.SIGKILL)
        done = run.end()
        if done.code == 0:
            break
        assert moment is not None and done.code == -signal.SIGKILL, done
        killed(run.folder)
    return done, kills


def summary_has(run, text):
    """The screen tells the error, seconds and memory; the shares of the time add up in run.json."""
    assert text in run.screen, run
    assert re.search(r"^time   [0-9.]+ \w+.*, [0-9.]+ m?s of CPU, [0-9.]+ [MG]B of memory$", run.out, re.M), run
    assert sum(part["cpu_percent"] for part in run.json["phases"]) == 100
    assert run.json["errors"] and all(error["quantity"] for error in run.json["errors"])


def same_files(run, other, *names):
    """Files of two runs are the same to the byte."""
    for name in names:
        assert (run / name).read_bytes() == (other / name).read_bytes(), f"{name} differs: {run.folder}, {other.folder}"


def same_run(run, other):
    """The history and all fields of two runs are the same to the byte."""
    same_files(run, other, "history.csv", "bodies.pvd", "interface.pvd")
    for collection in ("bodies.pvd", "interface.pvd"):
        same_files(run, other, *re.findall(r'file="([^"]*)"', (other / collection).read_text(encoding="utf-8")))


def same_results(run, other):
    """All columns of results.csv but the seconds."""
    assert len(run.results) > 0
    assert run.results.without("wall_s") == other.results.without("wall_s")


def documented(run):
    """doc/reference/output.md names all columns of the tables of a run; axes are entries, and left is as right."""
    for path in run.folder.glob("*.csv"):
        unknown = [name for name in Table(path).columns if not {name, name.replace("left_", "right_", 1)} & DOCUMENTED
                   and not re.match(r"[A-Z]\w+/[A-Z]", name)]
        assert not unknown, f"{path}: {unknown} are not in output.md"


def charts(*arguments):
    """The curves of a picture against the tables of its run, by charts.py."""
    done = subprocess.run(["/usr/bin/python3", "-B", HERE / "charts.py", *map(str, arguments)], capture_output=True, text=True, check=False)
    assert not done.stdout + done.stderr
