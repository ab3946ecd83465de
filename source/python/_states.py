"""How states print themselves and are compared; see doc/howto/python.md."""

import re

import numpy

# properties that are no numbers of the state itself
_APART = {"fields", "bounds", "columns", "force", "right", "left"}
_ARRAYS = {"positions", "pressure", "traction", "gap", "slip", "node_states", "areas"}
# the clock, which differs from run to run
_CLOCK = {"seconds", "wall_s"}


def _names(kind):
    return [name for name, value in vars(kind).items() if isinstance(value, property) and not name.startswith("_")]


def unit(kind, name):
    """The unit of a property as its help gives it, "" without one."""
    found = re.search(r"Units?: ([^.]*)\.", getattr(kind, name).__doc__ or "")
    return found.group(1) if found else ""


def to_dict(self):
    """All numbers of the state by name, those of its bounds as bound_force and so on."""
    numbers = {
        name: getattr(self, name) for name in _names(type(self)) if name not in _APART and name not in _ARRAYS
    }
    bounds = getattr(self, "bounds", None)
    if bounds is not None and not isinstance(bounds, tuple):
        for name in ("force", "moment", "max_pressure"):
            numbers["bound_" + name] = getattr(bounds, name)
    return numbers


def _same(one, other):
    if isinstance(one, numpy.ndarray):
        return numpy.array_equal(one, other)
    if isinstance(one, dict):
        return one.keys() == other.keys() and all(_same(one[key], other[key]) for key in one if key not in _CLOCK)
    return one == other or (one != one and other != other)


def equal(self, other):
    """Whether two states have the same numbers, bit by bit; times of the clock aside."""
    if type(self) is not type(other):
        return NotImplemented
    mine, others = to_dict(self), to_dict(other)
    if not _same(mine, others) or not _same(getattr(self, "columns", None) or {}, getattr(other, "columns", None) or {}):
        return False
    fields = [getattr(state, "fields", None) for state in (self, other)]
    if fields[0] is None or fields[1] is None:
        return fields[0] is fields[1]
    return all(_same(getattr(fields[0], name), getattr(fields[1], name)) for name in _names(type(fields[0])))


def text(value, of_unit=""):
    """A number with its unit, six digits of it."""
    if isinstance(value, tuple):
        shown = "(" + ", ".join(text(one) for one in value) + ")"
    elif isinstance(value, float):
        shown = f"{value:.6g}"
    else:
        shown = str(value)
    return f"{shown} {of_unit}" if of_unit not in ("", "1") and value is not None else shown


_SHOWN = {
    "State": ("force_x", "force_y", "normal_force"),
    "TransientState": ("time", "force_x", "force_y", "normal_force"),
    "WheelsetState": ("curvature", "lateral_shift", "yaw"),
}


def represent(self):
    kind = type(self)
    numbers = ", ".join(f"{name} {text(getattr(self, name), unit(kind, name))}" for name in _SHOWN[kind.__name__])
    converged = "" if getattr(self, "converged", True) else ", not converged"
    return f"<rolling_contact.{kind.__name__}: {numbers}{converged}>"


def represent_html(self):
    """A table of all numbers with their units, for notebooks."""
    kind = type(self)
    rows = []
    for name, value in to_dict(self).items():
        if value in (None, ""):
            continue
        of = unit(kind, name) if hasattr(kind, name) else ""
        rows.append(f"<tr><td>{name}</td><td>{text(value)}</td><td>{of if of != '1' else ''}</td></tr>")
    head = f"<tr><th>{kind.__name__}</th><th>value</th><th>unit</th></tr>"
    return f"<table>{head}{''.join(rows)}</table>"


def _places(self):
    """What of the columns is about the patches on profiles, a dict for each."""
    columns = self.columns or {}
    count = int(columns.get("patches") or 0)
    found = []
    for patch in range(1, count + 1):
        start = f"patch_{patch}_"
        found.append({name[len(start):]: value for name, value in columns.items() if name.startswith(start)})
    return found


def _column(name, help):
    return property(lambda self: (self.columns or {}).get(name), doc=help)


def dress(state, transient_state, wheelset_state):
    """Give the classes of the library what Python expects of them."""
    for kind in (state, transient_state, wheelset_state):
        kind.to_dict = to_dict
        kind.__eq__ = equal
        kind.__hash__ = None
        kind.__repr__ = represent
        kind._repr_html_ = represent_html
    from . import _pictures

    state._repr_svg_ = _pictures.svg
    state.plot = _pictures.plot
    state.patches = property(
        _places,
        doc="The patches on profiles, a dict by column of results.csv for each; empty without columns.",
    )
    state.contact_angle = _column(
        "contact_angle_rad", "Angle of the plane of contact, None without profiles or columns. Unit: rad."
    )
    state.contact_y_track = _column(
        "contact_y_track_m", "The first contact from the middle of the track, None without profiles or columns. Unit: m."
    )
    state.contact_y_wheel = _column(
        "contact_y_wheel_m", "The first contact on the wheel's profile, None without profiles or columns. Unit: m."
    )
