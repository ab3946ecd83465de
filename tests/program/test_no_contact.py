"""Contact that is not, or hardly."""

import pytest

DISCS = "carter_2d_partial_slip"


def test_bodies_apart(program):
    run = program(DISCS, {"Contact/Approach": -1e-4})
    assert "do not touch" in run.screen
    assert "no contact, no error" in run.screen
    assert run.results.texts("normal_force_N")[-1] == "0"


def test_zero_load(program):
    program(DISCS, {"Contact/Approach": "", "Contact/Normal load": 0})


@pytest.mark.parametrize("n", [1, 2, 3])
def test_few_elements(program, n):
    program(DISCS, {"Mesh/Elements across patch": n}, says="unresolved")
