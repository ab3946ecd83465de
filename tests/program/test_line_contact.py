"""A roller on a race: columns, load over its length, what is said and refused."""

import pytest

ROLLER = ("roller_lundberg_3d", {"Mesh/Elements across patch": 5, "Mesh/Growth": 0.8})


def test_a_crown_takes_load_off_the_ends(program):
    run = program(*ROLLER)
    assert 0.004999 <= run.results.last("length_m") <= 0.005001
    excess = run.results.last("end_load_excess")
    assert -0.8 <= excess <= -0.2
    assert f"at an end {-100 * excess:.3g} % below the middle's" in " ".join(run.screen.split())
    assert run.results.texts("bound_max_pressure")[-1] == ""
    across = run.table("across.csv")
    assert 2499.9 <= sum(load * width for load, width in zip(across["load_N/m"], across["width_m"])) <= 2500.1
    assert "straight across" in run.screen or "endless cylinders" in run.screen, "what it is compared with"


def test_without_a_crown_the_ends_take_more_load(program):
    run = program(*ROLLER, {"Surfaces/Wheel height": ""})
    table = run.results
    assert "% above the middle's" in " ".join(run.screen.split())
    assert 0.1 <= table.last("end_load_excess") <= 0.5
    assert 0.93 <= table.last("middle_pressure_Pa") / table.last("reference_max_pressure_Pa") <= 1


@pytest.mark.parametrize("says, settings", [
    ("Analysis = quasi-static, creep curve and load curve take that",
     {"Analysis": "transient", "Time/Rolled distance": 1e-4, "Time/Step length": 1e-5, "Surfaces/Wheel height": ""}),
    ("give the load in N", {"Surfaces/Wheel height": "lundberg : x"}),
    ("a crown is for bodies that touch from side to side", {"Rail/Lateral radius": 0.1}),
])
def test_refused(program, says, settings):
    program.refuses(ROLLER[0], says, settings)
