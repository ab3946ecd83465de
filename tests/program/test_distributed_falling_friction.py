"""Falling friction of bodies spread over ranks: a run resumed is the one that was not interrupted, and its ranks agree on
whether a state holds its friction."""

import pytest
from conftest import QUIET, RESUME
from ranks import SPREAD, near_history

STEPS = {"Mesh/Elements across patch": 12, **QUIET, "Contact/Friction law": "exponential", "Contact/Kinetic friction coefficient": 0.12,
         "Time/Checkpoint interval": 5, **SPREAD}


@pytest.mark.parametrize("ranks", [2, 3])
@pytest.mark.parametrize("speed", [5, 10])
def test_a_run_that_is_resumed(program, ranks, speed):
    def to(end, output, **how):
        return program("oscillating_creepage_2d", STEPS, {"Contact/Friction decay speed": speed, "Time/End time": end},
                       output=output, ranks=ranks, **how)

    whole = to("40e-6", "whole")
    to("20e-6", "parts")
    near_history(whole, to("40e-6", "parts", options=RESUME), 1e-12, 5e-6)
