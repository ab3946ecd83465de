"""Pictures with gnuplot, without it, and when it fails."""

import re
import shutil
import subprocess

import pytest
from conftest import COARSER, QUICK, charts, written

DISCS = "carter_2d_partial_slip"
SMALL = {**COARSER, "Output/Body fields": "false"}
HOW = '"gnuplot tractions.gp" in "run" draws tractions.svg.'


def text_of(path):
    return path.read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def drawn(shared):
    """A run with its picture."""
    return shared(DISCS, SMALL, output="run")


@pytest.fixture
def before(program, drawn):
    """A picture of before in the folder that a test runs to."""
    shutil.copytree(drawn.folder, program.folder / "run")


def test_title_for_readers(drawn):
    assert re.search(r"<title>N = .* kN, T / \(μN\) = ", text_of(drawn / "tractions.svg"))


@pytest.mark.parametrize("creepage", ["0.0017", "-0.0017"])
def test_the_title_has_the_signs(program, creepage):
    run = program(DISCS, QUICK, {"Contact/Creepage x": creepage})
    force, load = run.results.last("force_x_N"), run.results.last("normal_force_N")
    title = f"# N = {load / 1e3:.4g} kN, T / (μN) = {force / load / 0.3:.4g} at creepage {creepage}".replace("-", "−")
    assert title in text_of(run / "tractions.dat")


def test_the_gnuplot_settings_of_the_user_do_not_matter(program, drawn):
    run = program(DISCS, SMALL, output="run", env={"GNUTERM": "nonsense", "GNUPLOT_LIB": "/nowhere"})
    assert text_of(run / "tractions.svg") == text_of(drawn / "tractions.svg")


@pytest.mark.usefixtures("before")
def test_the_script_alone_draws_the_same_picture(program, drawn):
    picture = program.folder / "run/tractions.svg"
    picture.unlink()
    subprocess.run(["gnuplot", "tractions.gp"], cwd=picture.parent, check=True)
    alone, first = (re.sub("<title>.*", "", text_of(path)) for path in (picture, drawn / "tractions.svg"))
    assert alone == first


def test_a_patch_in_3d(program):
    settings = {"Output/Body fields": "false", "Mesh/Elements across patch": 8}
    run = program("combined_3d", settings, output="patch")
    charts("patch_3d", run.folder)
    assert re.search(r"<title>N = .* kN, T = \(.*\) kN, p up to .* MPa", text_of(run / "patch.svg"))
    program("combined_3d", settings, {"Output/Plot": "false"}, output="patch")
    program("combined_3d", settings, {"Output/Interface fields": "false"}, output="patch")
    assert (run / "patch.svg").exists() and not (run / "nodes.csv").exists(), "nodes.csv is a field of the interface"


def test_a_patch_that_slides_under_a_small_load(program):
    """Loads in N, 0 for what is no force, and the colour of slip whether or not a node sticks."""
    run = program("combined_3d", {"Output/Body fields": "false", "Mesh/Elements across patch": 8, "Contact/Approach": "",
                                  "Contact/Normal load": 60, "Contact/Creepage x": 0.05, "Contact/Creepage y": 0, "Contact/Spin": 0})
    assert re.search(r"<title>N = 60 N, T = \(\u221218, 0\) N, p up to .* MPa", text_of(run / "patch.svg"))
    script = text_of(run / "patch.gp")
    assert 0 < script.index("q, sticks") < script.index("q, slides")


def left_undrawn(run):
    """What gnuplot needs, and no picture of before."""
    record = text_of(run / "run.json")
    written(run, "tractions.dat", "tractions.gp")
    assert '"tractions.dat"' in record and '"tractions.gp"' in record
    assert '"tractions.svg"' not in record
    assert not (run / "tractions.svg").exists() and not (run / ".tractions.svg.part").exists()


@pytest.mark.usefixtures("before")
def test_without_gnuplot(program):
    run = program(DISCS, SMALL, output="run", env={"PATH": "/nowhere"})
    assert f"No picture without gnuplot: {HOW}" in run.screen
    left_undrawn(run)


@pytest.mark.usefixtures("before")
def test_gnuplot_fails(program):
    (program.folder / "bin").mkdir()
    program.write("bin/gnuplot", '#!/bin/sh\necho "<svg></svg>" >.tractions.svg.part; exit 1\n').chmod(0o755)
    left_undrawn(program(DISCS, SMALL, output="run", env={"PATH": str(program.folder / "bin")}, says=f"gnuplot did not draw: {HOW}"))
