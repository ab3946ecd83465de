"""The folder of a run against what others put there: nothing foreign is written
to, cut, replaced or removed, nothing waits without end, and runs of its own,
killed ones too, are replaced and resumed as ever. Ends of batch jobs,
inclusions and bytes of table.h5 besides."""

import os
import pathlib
import re
import shutil
import signal
import stat
import time

import pytest
from conftest import LIGHT, QUIET, RESUME, limited, n_lines, same_files

DISCS = "carter_2d_partial_slip"
STATE = {**LIGHT, "Output/Plot": "false"}
VIBRATION = ("oscillating_creepage_2d", STATE, {"Time/Field interval": 1000, "Time/Checkpoint interval": 10})
KINDS = ["link", "dangling", "link_to_folder", "folder", "pipe", "socket", "own"]
MINE = "mine\n"


def look(path):
    """What stands under a name, of which nothing is to change."""
    try:
        found = path.lstat()
    except OSError as error:
        return error.strerror
    return found.st_mode, found.st_ino, found.st_size, found.st_mtime_ns, path.is_symlink() and os.readlink(path)


def ends(steps):
    return {"Time/End time": f"{steps * 2e-6:.9g}"}


def temporary(run):
    return [name for name in run.files() if name.endswith(".part")]


@pytest.fixture(scope="module")
def ours(shared):
    return shared(DISCS, STATE, output="ours")


class Attack:
    """The program and what is not its own: a file, a folder and no file that links point to."""

    def __init__(self, program):
        self.program, self.folder = program, program.folder
        self.victim = program.write("victim", MINE)
        self.treasure = self.folder / "treasure"
        self.treasure.mkdir()
        program.write("treasure/kept.csv", MINE)

    def plant(self, kind, path):
        targets = {"link": self.victim, "dangling": self.folder / "nowhere", "link_to_folder": self.treasure}
        if kind in targets:
            path.symlink_to(targets[kind])
        elif kind == "folder":
            path.mkdir()
            (path / "inner").write_text(MINE)
        elif kind == "pipe":
            os.mkfifo(path)
        elif kind == "socket":
            os.mknod(path, stat.S_IFSOCK | 0o600)
        else:
            path.write_text(MINE)

    def __call__(self, code, says, thing, *settings, scene=DISCS, state=STATE, **how):
        """The program ends by itself with this exit code and says this, and what it was to fall for is as before."""
        before = look(thing)
        run = self.program(scene, state, *settings, code=code, says=says, seconds=60, **how)
        assert look(thing) == before
        assert self.victim.read_text() == MINE
        assert os.listdir(self.treasure) == ["kept.csv"] and (self.treasure / "kept.csv").read_text() == MINE
        assert not (self.folder / "nowhere").exists() and not (self.folder / "hit").exists()
        return run

    def copy(self, ours, name="folder"):
        """A folder of ours to spoil."""
        folder = self.folder / name
        shutil.rmtree(folder, ignore_errors=True)
        return shutil.copytree(ours.folder, folder)


@pytest.fixture
def attack(program):
    return Attack(program)


@pytest.mark.parametrize("kind", KINDS)
def test_what_stands_under_a_name_of_ours_in_a_folder_of_ours(attack, ours, kind):
    names = ["history.csv", "history.csv.part", ".checkpoint.bin.part", "wheel_mode_001_07.vtu"]
    if kind != "own":
        names += ["results.csv", ".results.csv.part", "used.prm", ".run.json.part", "run.json"]
    for name in names:
        thing = attack.copy(ours) / name
        thing.unlink(missing_ok=True)
        attack.plant(kind, thing)
        text = f"did not write {name} in it" if kind == "own" else f"{name} in it is "
        attack(1, text, thing, output="folder")
        if name in ("history.csv.part", ".checkpoint.bin.part"):
            attack(1, text, thing, *VIBRATION[1:], scene=VIBRATION[0], output="folder", options=RESUME)


@pytest.mark.parametrize("kind", ["link", "pipe", "own"])
def test_a_run_that_is_refused_changes_no_file(attack, ours, kind):
    folder = attack.copy(ours)
    attack.plant(kind, folder / "history.csv")
    attack(1, "history.csv", folder / "history.csv", output="folder")
    (folder / "history.csv").unlink()
    assert sorted(os.listdir(folder)) == ours.files()
    same_files(ours, folder, *ours.files())


@pytest.mark.parametrize("kind", KINDS)
def test_folders_that_are_not_ours(attack, kind):
    for name in ["run.json", "results.csv", "thesis.txt"] + [".run.json.part"] * (kind != "own"):  # that: of a run that was killed
        foreign = attack.folder / "foreign"
        foreign.mkdir()
        attack.plant(kind, foreign / name)
        attack(1, 'Cannot use "foreign"', foreign / name, output="foreign")
        assert os.listdir(foreign) == [name]
        shutil.rmtree(foreign)


@pytest.mark.parametrize("kind", ["link", "pipe", "socket", "own"])
def test_a_file_where_the_folder_is_to_be(attack, kind):
    place = attack.folder / "place"
    attack.plant(kind, place)
    attack(1, "is a file", place, output="place")
    attack(1, "is a file", place, output="place/below")


@pytest.fixture
def claimed(attack):
    """A folder with files that are not ours and no run.json yet."""
    folder = attack.folder / "claimed"
    folder.mkdir()
    (folder / "thesis.txt").write_text(MINE)
    (folder / "results.csv.bak").write_text(MINE)
    return folder


@pytest.mark.parametrize("names", [
    '"thesis.txt"', '"results.csv.bak"', '"../victim"', '"../treasure/kept.csv"', '"./thesis.txt"', '"{victim}"', '"", ".", ".."',
    '".thesis.txt"', r'"thesis.txt\u0000results.csv"', '"results.csv/../thesis.txt"', '["thesis.txt"]', '{"a": "thesis.txt"}',
    '1, null, true, 1e99', '"*", "*.txt", "?"', r'"thesis.txt\n"', f'"{"a" * 100000}"'], ids=lambda names: names[:30].strip())
def test_a_list_of_files_that_are_not_ours(attack, claimed, names):
    names = names.replace("{victim}", str(attack.victim))
    (claimed / "run.json").write_text(f'{{"program": "rolling-contact", "status": "done", "files": [{names}]}}')
    attack(0, "", claimed / "thesis.txt", output="claimed")
    assert (claimed / "thesis.txt").read_text() == (claimed / "results.csv.bak").read_text() == MINE
    assert (claimed / "results.csv").stat().st_size


@pytest.mark.parametrize("files", ["5", "null", '"results.csv"', '{"a": 1}'])
def test_a_list_of_files_that_is_none(attack, claimed, files):
    (claimed / "run.json").write_text(f'{{"program": "rolling-contact", "files": {files}}}')
    (claimed / "results.csv").write_text(MINE)
    attack(1, "did not write results.csv in it", claimed / "results.csv", output="claimed")


def test_a_run_json_that_is_none(attack, claimed):
    for text in [b"", b"{", b"[]", b"[" * 20000, b'{"program": "other"}', b"\377\376",
                 b'{"files": ["thesis.txt"], "program": "rolling-contact"}']:
        (claimed / "run.json").write_bytes(text)
        attack(1, "did not write", claimed / "run.json", output="claimed")


def test_files_with_a_second_name(attack, ours):
    for name in ["results.csv", "run.json", "used.prm"]:
        linked = attack.folder / f"linked_{name}"
        os.link(attack.copy(ours) / name, linked)
        attack(0, "", linked, output="folder")
        assert linked.read_bytes() == (ours / name).read_bytes()


def test_files_that_are_read_only_are_replaced(attack, ours):
    for file in attack.copy(ours).iterdir():
        file.chmod(0o444)
    attack(0, "", attack.victim, output="folder")


def test_a_folder_without_permission(another_user):
    """Another user may see neither the build nor the scenes."""
    scene = another_user.write("scene.prm", another_user.scene(DISCS).read_text(encoding="utf-8"))
    scene.chmod(0o644)
    (another_user.folder / "closed").mkdir(0o555)
    another_user("scene.prm", STATE, output="closed/run", code=1, says="no permission to write", before=another_user.before)


@pytest.mark.parametrize("name", [
    "with space", "two\nlines", "Grüße 車輪", "'quoted' \"twice\" $(touch hit) `touch hit`", "%s%n", "a;touch hit", "=1+1",
    "run.json", "results.csv", "...", "{a,b}", "\x1b[31mred", os.fsdecode(b"\xff\xfe")], ids=ascii)
def test_names_of_folders(attack, name):
    run = attack(0, "", attack.victim, {"Output/Plot": "true"}, output=name)
    assert (run / "run.json").stat().st_size and (run / "tractions.svg").stat().st_size
    attack(0, "", attack.victim, output=name)


def test_a_name_with_a_leading_dash(attack):
    attack(0, "", attack.victim, output="-rf")
    attack(0, "", attack.victim, options=["--output=-rf"])
    assert (attack.folder / "-rf/results.csv").stat().st_size


@pytest.mark.parametrize("name, says", [
    ("x" * 300, "Cannot use"), ("x/" * 3000, "Cannot use"), ("", "--output is empty"), ("treasure/..", "Cannot use"), ("/", "Cannot use"),
    ("/dev/null", "is a file"), ("/proc/self", "Cannot use")], ids=lambda text: text[:20])
def test_names_that_are_refused(attack, name, says):
    attack(1, says, attack.victim, output=name)


def test_a_link_to_a_folder_of_ours_which_the_user_names(attack, ours):
    link = attack.folder / "link_to_ours"
    link.symlink_to(attack.copy(ours))
    attack(0, "", link, output="link_to_ours")


def test_pipes_where_a_file_is_read(attack):
    def refused(scene, name, settings, says=None):
        pipe = attack.folder / name
        os.mkfifo(pipe)
        attack(1, says or name, pipe, {entry: value.replace("PIPE", str(pipe)) for entry, value in settings.items()}, scene=scene, state={})
        pipe.unlink()

    refused(pathlib.Path("pipe"), "pipe", {}, "pipe: cannot be read: it is a pipe")
    attack.program.write("including.prm", "include pipe\n")
    refused("including.prm", "pipe", {}, "pipe: cannot be read: it is a pipe")
    refused("own_mesh_2d", "pipe.msh", {"Rail/Mesh file": "PIPE"})
    refused("start_up_2d", "pipe.csv", {"Time/Creepage x": "table: PIPE"})
    refused("table_3d", "pipe.csv", {**{f"Table/Axis {k}": "" for k in (1, 2, 3, 4)}, "Table/File of rows": "PIPE"})
    refused("profiles_true_sections", "pipe.txt", {"Profiles/Wheel profile": "PIPE"})
    refused("rolling_noise_track", "pipe.csv", {"Rolling noise/Wheel roughness": "PIPE"})
    refused(DISCS, "pipe.h5", {"Contact/Roughness": "file: PIPE:/z"})


@pytest.mark.parametrize("files", [
    {".run.json.part": ""},
    {".run.json.part": '{"program": "roll'},
    {"run.json": '{"program": "rolling-contact", "files": ["original.prm", "results.csv"]}', ".results.csv.part": "half"},
], ids=["first mark", "half a mark", "before files"])
def test_a_run_that_was_killed_as_it_began(program, ours, files):
    (program.folder / "killed").mkdir()
    for name, text in files.items():
        program.write(f"killed/{name}", text)
    assert program(DISCS, STATE, output="killed").files() == ours.files()


def begun(program, *settings, output, **how):
    """A run that goes on, with its first checkpoint."""
    run = program.start(*VIBRATION, *settings, output=output, **how)
    run.wait_until((run / "checkpoint.bin").exists, 20)
    return run


def test_a_run_that_was_killed_is_resumed_or_replaced(program):
    run = begun(program, {"Time/End time": 1}, output="going")
    run.send(signal.SIGKILL)
    run.end()
    shutil.copytree(run.folder, program.folder / "gone")
    for name in (".checkpoint.bin.part", ".run.json.part"):
        (run / name).write_text("half")
    steps = n_lines(run / "history.csv.part")
    snapshot = program.folder / "snapshot.csv"
    os.link(run / "history.csv.part", snapshot)
    content = snapshot.read_bytes()
    resumed = program(*VIBRATION, ends(steps + 50), output="going", options=RESUME)
    assert n_lines(resumed / "history.csv") > steps and not temporary(resumed)
    assert snapshot.read_bytes() == content
    assert not temporary(program(*VIBRATION, {"Time/End time": 1e-4}, output="gone"))
    other = program(DISCS, STATE, output="gone")
    assert not (other / "history.csv").exists()


@pytest.mark.parametrize("number, says, before", [
    (signal.SIGTERM, "SIGTERM", ()),
    (signal.SIGUSR1, "SIGUSR1", ()),
    (signal.SIGXCPU, "SIGXCPU", ()),
    (None, "SIGXCPU", limited("ulimit -S -t 4")),
], ids=["TERM", "USR1", "XCPU", "limit"])
def test_ends_of_batch_jobs(program, number, says, before):
    run = begun(program, {"Time/End time": 10, "Time/Checkpoint interval": 1000}, output="job", before=before)
    if number:
        run.send(number)
    done = run.end()
    assert done.code == 2 and says in done.messages, done
    assert done.json["status"] == "interrupted"
    program(*VIBRATION, ends(done.table("history.csv").last("step") + 20), output="job", options=RESUME)


def test_an_included_file_is_found_from_the_one_that_includes_it(program):
    for folder in ("scenes", "scenes/parts", "elsewhere"):
        (program.folder / folder).mkdir()
    program.write("scenes/parts/deep.prm", "subsection Contact\n  set Friction coefficient = 0.123\nend\n")
    program.write("scenes/parts/part.prm", "include deep.prm\n")
    program.write("scenes/scene.prm", program.scene(DISCS).read_text(encoding="utf-8") + "include parts/part.prm\n")
    program("../scenes/scene.prm", LIGHT, output="run", before=["env", "-C", "elsewhere"])
    used = (program.folder / "elsewhere/run/used.prm").read_text(encoding="utf-8")
    assert re.search("Friction coefficient *= 0.123", used)


@pytest.mark.parametrize("text", ["root:$6$secret:19000:0:99999:7:::\n", "set secret\n"])
def test_the_content_of_an_included_file_that_is_none_is_not_told(program, text):
    program.write("shadow", text)
    program.write("include.prm", "include shadow\n")
    run = program("include.prm", code=1, says="shadow: line 1: it ")
    assert "secret" not in run.err


def test_table_h5_has_the_same_bytes_in_every_run(program):
    table = ("table_3d", QUIET, {"Mesh/Elements across patch": 6, "Table/Axis 2": "Contact/Creepage x = -0.006 : 0.006 : 2",
                                 "Table/Threads": 1})
    first = program(*table, output="first")
    time.sleep(1.1)
    same_files(first, program(*table, output="second"), "table.h5")
