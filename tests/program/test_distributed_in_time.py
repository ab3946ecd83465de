"""Transients of bodies spread over ranks."""

import pytest
from conftest import QUIET, RESUME, same_files
from ranks import COARSEST, DIRECT, SOLID, SPREAD, near_history

STEPS = {"Mesh/Elements across patch": 12, **QUIET}
VIBRATION = "oscillating_creepage_2d"
MATERIALS = (VIBRATION, STEPS, {"Rail/Young modulus": "70e9", "Time/End time": "40e-6", "Body threads": 1})


def on_ranks(program, numbers, balance, *scene):
    direct = program(*scene, DIRECT, output="direct")
    for ranks in numbers:
        near_history(direct, program(*scene, SPREAD, output="spread", ranks=ranks), balance)
    return direct


@pytest.mark.parametrize("scene, ranks, balance, settings", [
    ("start_up_2d", (1, 2, 3), 1e-12, {**STEPS, "Time/Rolled distance": 0.008}),
    ("rolling_at_speed_2d", (1, 2, 3), 1e-12, {**STEPS, "Time/End time": "20e-6"}),
    ("impact_2d", (1, 2, 3), 1e-10, {**STEPS, "Time/End time": "4e-6"}),
    ("start_up_3d", (2,), 1e-12, {**SOLID, **COARSEST, "Time/Rolled distance": 2.4e-3}),
])
def test_as_bodies_solved_directly(program, scene, ranks, balance, settings):
    on_ranks(program, ranks, balance, scene, settings)


def test_two_materials_and_a_body_on_each_of_two_ranks(program):
    direct = on_ranks(program, (1, 3), 1e-12, *MATERIALS)
    same_files(program(*MATERIALS, DIRECT, output="each", ranks=2), direct, "history.csv", "checkpoint.bin")


WHOLE = (VIBRATION, STEPS, {"Time/Checkpoint interval": 5})


@pytest.fixture(scope="module")
def whole(shared):
    return shared(*WHOLE, DIRECT, {"Time/End time": "40e-6"}, output="whole")


@pytest.mark.parametrize("first, begun, second, ended", [
    (2, "distributed", 3, "distributed"),
    (2, "distributed", 1, "distributed"),
    (2, "distributed", 1, "direct"),
    (1, "direct", 2, "distributed"),
    (3, "automatic", 1, "automatic"),
])
def test_begun_in_one_way_and_ended_in_another(program, whole, first, begun, second, ended):
    program(*WHOLE, {"Time/End time": "20e-6", "Body solver": begun}, output="parts", ranks=first)
    parts = program(*WHOLE, {"Time/End time": "40e-6", "Body solver": ended}, output="parts", ranks=second, options=RESUME)
    near_history(whole, parts)
