"""Rolling contact with friction between a wheel and a rail.

States and time steps of the program rolling-contact for programs in Python:
see doc/python.md. SI units; forces are those on the wheel.
"""

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
)

__all__ = [
    "ConvergenceError",
    "ErrorBounds",
    "Fields",
    "InputError",
    "SavedState",
    "Scene",
    "Session",
    "State",
    "Transient",
    "TransientState",
    "Wheelset",
    "WheelsetState",
    "print_parameters",
]
