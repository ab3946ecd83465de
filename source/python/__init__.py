"""Rolling contact with friction between a wheel and a rail.

States and time steps of the program rolling-contact for programs in Python:
see doc/howto/python.md. SI units; forces are those on the wheel.
"""

import sys

from . import _core, _entries, _states
from ._core import (
    ConvergenceError,
    ErrorBounds,
    Fields,
    InputError,
    SavedState,
    Scene,
    Session,
    State,
    Transient,
    TransientState,
    Wheelset,
    WheelsetState,
    __version__,
    print_parameters,
    references,
)
from .tables import Table, read_table

_states.dress(State, TransientState, WheelsetState)
_entries.dress(Session, Scene)
sys.modules[__name__ + ".references"] = references

__all__ = [
    "ConvergenceError",
    "ErrorBounds",
    "Fields",
    "InputError",
    "SavedState",
    "Scene",
    "Session",
    "State",
    "Table",
    "Transient",
    "TransientState",
    "Wheelset",
    "WheelsetState",
    "print_parameters",
    "read_table",
    "references",
]
