"""Bodies spread over ranks against bodies solved directly."""

import os
import re
import signal
import time
import xml.etree.ElementTree as Xml

import pytest
import vtu
from conftest import QUIET, same_files, same_results
from ranks import COARSEST, DIRECT, SOLID, SPREAD, near_results, pids, told_once

DISCS, MATERIALS, SPHERES = "carter_2d_partial_slip", "steel_on_aluminium_2d", "combined_3d"
FLAT = {"Mesh/Elements across patch": 16, **QUIET}
LEVELS = {"Mesh/Elements across patch": 12, "Mesh/Adaptive levels": 2}
UPWIND = {**SOLID, "Contact/Slip operator": "upwind 2"}
CURVE = {"Analysis": "creep curve"}
STATES = [
    ("partial slip", (1, 2, 3), DISCS, FLAT),
    ("two materials", (1, 2, 3), MATERIALS, FLAT),
    ("a given load", (2,), DISCS, {**FLAT, "Contact/Approach": "", "Contact/Normal load": "100e3"}),
    ("a rigid rail", (1, 3), DISCS, {**FLAT, "Rail/Rigid": "true"}),
    ("a rigid wheel", (2,), DISCS, {**FLAT, "Wheel/Rigid": "true"}),
    ("frictionless", (2,), DISCS, {**FLAT, "Contact/Friction coefficient": 0}),
    ("a curve", (1, 3), DISCS, {**FLAT, **CURVE, "Creep curve/Creepage x": "0 : 0.008 : 9"}),
    ("levels", (1, 2, 3), "adaptive_2d", LEVELS),
    ("levels of two materials", (2,), MATERIALS, LEVELS),
    ("lateral creepage", (2,), "lateral_3d_partial_slip", UPWIND),
    # not 8: its edges settle after 19 passes only, and rounding decides where
    ("creepages and spin", (1, 3), SPHERES, {**SOLID, "Mesh/Elements across patch": 10}),
    ("a curve in 3D", (2,), "lateral_3d_creep_curve", {**UPWIND, **COARSEST, "Creep curve/Creepage y": "0.001 : 0.01 : 3"}),
    ("falling friction", (1, 2), "falling_friction_2d", {"Mesh/Elements across patch": 16}),
]


@pytest.fixture(scope="module")
def discs(shared):
    return shared(DISCS, FLAT, DIRECT, output="direct")


def test_states(program):
    """One test, as enough of them all must need corrections."""
    corrected = 0
    for name, numbers, scene, settings in STATES:
        direct = program(scene, settings, DIRECT, output="direct")
        if name == "levels":
            assert len(direct.results) == 3
        for ranks in numbers:
            print(f"{name} on {ranks} ranks")
            spread = program(scene, settings, SPREAD, output="spread", ranks=ranks)
            near_results(direct, spread, 0 if name == "frictionless" else 0.3)
            corrected += spread.results.last("corrections") != 0
    assert corrected > 10


def test_the_log_counts_corrections(program):
    run = program(DISCS, FLAT, SPREAD, {"Output/Verbosity": "verbose"}, output="spread")
    assert re.search(f" {run.results.texts('corrections')[-1]} corrections? of the compliance", run.screen), run


def test_automatic_is_direct_on_one_rank(program, discs):
    same_results(program(DISCS, FLAT, output="by_itself"), discs)


def read(path, fields):
    """Number of cells; adds least, largest, sum and number of values."""
    cells = 0
    for piece in Xml.parse(path).getroot().iter("Piece"):
        cells += int(piece.get("NumberOfCells"))
        for name, n, _, numbers in vtu.arrays(piece):
            for d in range(n):
                part = numbers[d::n]
                low, high, total, count = fields.get((name, d), (part[0], part[0], 0.0, 0))
                fields[name, d] = min(low, *part), max(high, *part), total + sum(part), count + len(part)
    return cells


def bodies(folder):
    """Of each body: number of files with cells, cells, ranges."""
    for block in Xml.parse(folder / "bodies.pvd").getroot().iter("DataSet"):
        files, fields = [block.get("file")], {}
        if files[0].endswith(".pvtu"):
            files = [piece.get("Source") for piece in Xml.parse(folder / files[0]).getroot().iter("Piece")]
        yield len(files), sum(read(folder / file, fields) for file in files), fields


def test_fields(program, discs):
    """The same numbers of cells; ranges to a unit in the last place of their single precision, 2^-23 of the largest value,
    and means to 1e-8 of it."""
    whole = list(bodies(discs.folder))
    for ranks in (1, 2, 3):
        spread = list(bodies(program(DISCS, FLAT, SPREAD, output="spread", ranks=ranks).folder))
        assert len(whole) == len(spread) == 2
        for (_, cells, fields), (n_files, other_cells, others) in zip(whole, spread):
            assert n_files == ranks
            assert cells == other_cells > 0
            assert fields.keys() == others.keys() and len(fields) > 8
            for name, (low, high, total, count) in fields.items():
                other_low, other_high, other_total, other_count = others[name]
                assert count == other_count, name
                scale = max(abs(low), abs(high))
                assert max(abs(low - other_low), abs(high - other_high)) <= 2**-23 * scale, name
                assert abs(total - other_total) / count <= 1e-8 * scale, f"mean {name}"


TWO = (MATERIALS, FLAT, {"Body threads": 1}, DIRECT)  # two threads of one rank do not round alike


def test_a_body_on_each_of_two_ranks(program):
    direct, each = program(*TWO, output="direct"), program(*TWO, output="each", ranks=2)
    same_results(direct, each)
    assert direct.files() == each.files()
    same_files(direct, each, "wheel.vtu", "rail.vtu", "bodies.pvd")


def test_levels_of_a_body_on_each_of_two_ranks(program):
    levels = {"Mesh/Adaptive levels": 1}
    same_results(program(*TWO, levels, output="direct"), program(*TWO, levels, output="each", ranks=2))


@pytest.mark.parametrize("ranks, says, scene", [
    (3, "Body solver = direct on 3 ranks", TWO),
    (2, "Body solver = direct on 2 ranks", (DISCS, FLAT, DIRECT)),
    (2, "Body solver = distributed: an accuracy", ("accuracy_2d", SPREAD)),
    (1, "Rail/Poisson ratio = 0.4999", (DISCS, FLAT, SPREAD, {"Rail/Poisson ratio": 0.4999})),
    (2, "Rail/Poisson ratio = 0.4999", (DISCS, FLAT, SPREAD, {"Rail/Poisson ratio": 0.4999})),
    (3, "Approach is 0.00022 m", (DISCS, SPREAD, {"Rail/Shape": "block", "Rail/Radius": 0, "Rail/Block length": 5e-3})),
])
def test_what_distributed_bodies_cannot(program, ranks, says, scene):
    told_once(program(*scene, code=1, output="spread", ranks=ranks), says)


def test_no_such_solver(program):
    program(DISCS, {"Body solver": "multigrid"}, code=1, ranks=2)


def test_nearly_incompressible_bodies_are_solved_directly(program):
    program(DISCS, FLAT, {"Rail/Poisson ratio": 0.4999}, output="by_itself")


@pytest.mark.parametrize("victim", [0, 1, 2])
def test_a_killed_rank_of_distributed_bodies(program, victim):
    run = program.start(SPHERES, SOLID, COARSEST, SPREAD, CURVE, {"Creep curve/Creepage x": "0 : 0.008 : 100000"}, output="killed", ranks=3)
    run.wait_for_rows(1)
    time.sleep(0.1 * (victim + 1))
    pid = pids(run)[victim]
    killed = time.monotonic()
    os.kill(pid, signal.SIGKILL)
    assert run.end().code != 0
    assert time.monotonic() - killed <= 30
