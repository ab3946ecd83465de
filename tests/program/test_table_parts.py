"""A table in parts that are joined: the same bytes as in one run, and parts that do not belong together."""

import re
import signal

import h5py
import pytest
from conftest import RESUME, n_lines, same_results

TABLE = ("table_3d", {"Output/Plot": "false", "Mesh/Elements across patch": 6})
SAY_HOW_MANY = "give the number of the part and how many there are"


def part(program, k, of, name="part", **how):
    return program(*TABLE, {"Table/Part": f"{k}/{of}"}, output=f"{name}_{k}", **how)


def join(program, folders, *settings, output="joined", **how):
    return program(*TABLE, {"Table/Join": folders}, *settings, output=output, **how)


def arrays(run):
    """All of table.h5 but the scene."""
    found = {}
    with h5py.File(run / "table.h5") as file:
        file.visititems(lambda name, it: found.update({name: it[...].tobytes()}) if isinstance(it, h5py.Dataset) else None)
    assert len(found) > 20
    assert found.pop("scene")
    return found


@pytest.fixture(scope="module")
def whole(shared):
    return shared(*TABLE, output="whole")


@pytest.fixture(scope="module")
def twelve(shared):
    """As many parts as there are chains, and more."""
    for k in range(1, 13):
        part(shared, k, 12)
    return shared


def test_three_parts(program, whole):
    counts = []
    for k in (1, 2, 3):
        run = part(program, k, 3)
        counts.append(len(run.results))
        assert 0 < counts[-1] < 112 and not (run / "table.h5").exists()
        assert re.search(rf"Part {k}/3 has {counts[-1]} of them", run.screen), run
    assert sum(counts) == 112
    joined = join(program, "part_1, part_3, part_2")
    same_results(whole, joined)
    assert arrays(whole) == arrays(joined)
    assert "112 of them from runs of parts" in joined.screen
    same_results(whole, join(program, "part_?"))


def test_twelve_parts_and_one_that_is_missing(twelve, whole):
    same_results(whole, join(twelve, "part_*"))
    missing = join(twelve, "part_[2-9], part_1?", code=1, says="states have no row, the first Contact/")
    assert not (missing / "table.h5").exists()


def test_a_part_that_was_killed_goes_on(twelve, whole):
    run = twelve.start(*TABLE, {"Table/Part": "2/12"}, output="killed_2")
    run.wait_for_rows(1, seconds=4)
    run.send(signal.SIGKILL)
    run.end()
    part(twelve, 2, 12, "killed", options=RESUME if n_lines(run / "results.csv") else ())
    same_results(whole, join(twelve, "part_1*, part_[3-9], killed_2", output="joined_of_killed"))


@pytest.mark.parametrize("folders, settings, says", [
    ("part_*, part_1", {}, 'row 1 of "part_1/results.csv" is no state of this table, or one that another folder has'),
    ("nowhere", {}, "Table/Join = nowhere: there is no folder nowhere"),
    ("empty", {}, '"empty" is no folder of a part: used.prm'),
    ("part_*", {"Contact/Friction coefficient": 0.31}, '"part_1" is of another scene: Contact/Friction coefficient'),
])
def test_folders_that_do_not_belong_together(twelve, folders, settings, says):
    (twelve.folder / "empty").mkdir(exist_ok=True)
    join(twelve, folders, settings, output="refused", code=1, says=says)


def test_other_threads(twelve):
    join(twelve, "part_*", {"Table/Threads": 1}, output="threads")


@pytest.mark.parametrize("wrong", ["0/3", "4/3", "3", "a/3", "1.5/3", "1/1000000", "/"])
def test_no_part(program, wrong):
    program.refuses(TABLE[0], f"Table/Part = {wrong}: {SAY_HOW_MANY}", TABLE[1], {"Table/Part": wrong}, output="wrong")


def test_a_part_that_joins(program):
    program.refuses(TABLE[0], "leave one of them empty", TABLE[1], {"Table/Part": "1/3", "Table/Join": "part_1"}, output="wrong")


def test_a_part_of_an_fmu(program):
    program.refuses("wheelset_fmu", "Table/Part = 4/3: give the number of the part", {"Table/Part": "4/3"}, output="wrong")


def test_another_part_resumed(twelve):
    twelve(*TABLE, {"Table/Part": "3/12"}, output="part_2", options=RESUME, code=1, says='Table/Part was "2/12" when the run began')
