"""Entries of a scene as attributes: session.contact.creepage_x; see doc/howto/python.md."""

import functools
import json
import re

from . import _core


def _attribute(name):
    return re.sub(r"[^0-9a-z]+", "_", name.lower()).strip("_")


@functools.lru_cache(maxsize=None)
def _sections():
    """{section: {entry: (path, default)}}, section and entry as attributes."""
    return {
        _attribute(section): {
            _attribute(name): (f"{section}/{name}", entry["default"]) for name, entry in entries.items()
        }
        for section, entries in json.loads(_core.parameters_as_json()).items()
        if not isinstance(entries.get("default"), str)
    }


class Section:
    """The entries of one section of a scene as attributes. Each is a text: the value given last, or the default."""

    def __init__(self, owner, name):
        object.__setattr__(self, "_owner", owner)
        object.__setattr__(self, "_name", name)

    def _entry(self, attribute):
        try:
            return _sections()[self._name][attribute]
        except KeyError:
            raise AttributeError(f"section {self._name} has no entry {attribute}; it has {', '.join(dir(self))}") from None

    def __getattr__(self, attribute):
        return self._owner._given(*self._entry(attribute))

    def __setattr__(self, attribute, value):
        self._owner[self._entry(attribute)[0]] = value

    def __dir__(self):
        return sorted(_sections()[self._name])

    def __repr__(self):
        given = ", ".join(f"{name} = {getattr(self, name)}" for name in dir(self))
        return f"<{self._name}: {given}>"


def _section(self, name):
    if name in _sections():
        return Section(self, name)
    raise AttributeError(f"{type(self).__name__} has no attribute {name}")


def _given_of_session(self, path, default):
    try:
        return self[path]
    except KeyError:
        return default


def _given_of_scene(self, path, default):
    return self.entries.get(path, default)


def dress(session, scene):
    """Give sessions and scenes their sections; those of scenes cannot be changed."""
    session._given, scene._given = _given_of_session, _given_of_scene
    for kind in (session, scene):
        kind.__getattr__ = _section
        kind.__dir__ = lambda self: sorted(set(object.__dir__(self)) | set(_sections()))
    session.__enter__ = lambda self: self
    session.__exit__ = lambda self, *_: self.close()
