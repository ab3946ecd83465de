"""Tables of states, table.h5, as numpy arrays with their axes; see doc/howto/tables.md. Needs h5py."""

import pathlib

import numpy

from ._core import InputError

STATUS = {0: "not computed", 1: "solved", 2: "no contact", 3: "not solved"}


class Table:
    """The arrays of a table over its axes.

    axes: {name: values}, in the order of the arrays' dimensions; entries: {name: "Section/Entry"};
    units: {column or axis: unit}; results and bounds: {column: array}; status: array of STATUS's keys. SI units.
    """

    def __init__(self, path):
        import h5py

        path = pathlib.Path(path)
        path = path / "table.h5" if path.is_dir() else path
        if not path.is_file():
            raise InputError(f"{path}: no such table; give table.h5 or the folder of a run with Analysis = table.")
        self.path = path
        try:
            with h5py.File(path, "r") as file:
                self._read(file)
        except (OSError, KeyError) as error:
            raise InputError(f"{path}: this is no table.h5 of this program: {error}.") from None

    def _read(self, file):
        def text(value):
            return value.decode() if isinstance(value, bytes) else str(value)

        self.kind = text(file.attrs["kind"])
        names = [name for name in text(file.attrs["axes"]).split(", ") if name]
        self.axes = {name: file["axes"][name][...] for name in names}
        self.entries = {name: text(file["axes"][name].attrs["entry"]) for name in names}
        self.units = {name: text(file["axes"][name].attrs["unit"]) for name in names}
        self.results = {name: file["results"][name][...] for name in file["results"]}
        self.units.update({name: text(file["results"][name].attrs.get("unit", "")) for name in file["results"]})
        self.bounds = {name: file["bounds"][name][...] for name in file.get("bounds", {})}
        self.status = file["status"][...]

    def __getitem__(self, column):
        """The array of a column; NaN in states that are not solved."""
        try:
            return self.results[column]
        except KeyError:
            raise KeyError(f"{column}: {self.path} has {', '.join(sorted(self.results))}") from None

    @property
    def shape(self):
        """Numbers of states along the axes."""
        return self.status.shape

    def __repr__(self):
        axes = ", ".join(f"{name} ({len(values)})" for name, values in self.axes.items())
        return f"<rolling_contact.tables.Table: {self.kind} over {axes}; {numpy.count_nonzero(self.status == 1)} states solved>"

    def to_pandas(self):
        """A pandas.DataFrame with a row for each state, axes and columns by name. Raises ImportError without pandas."""
        import pandas

        columns = {}
        if self.kind == "grid":
            grid = numpy.meshgrid(*self.axes.values(), indexing="ij")
            columns = {name: values.ravel() for name, values in zip(self.axes, grid)}
        else:
            columns = dict(self.axes)
        columns["status"] = [STATUS[int(number)] for number in self.status.ravel()]
        columns.update({name: values.ravel() for name, values in self.results.items()})
        columns.update({"bound_" + name: values.ravel() for name, values in self.bounds.items()})
        return pandas.DataFrame(columns)

    def to_xarray(self):
        """An xarray.Dataset over the axes of a grid, units among the attributes. Raises ImportError without xarray."""
        import xarray

        if self.kind != "grid":
            raise ValueError(f"{self.path} has rows, no grid: take to_pandas().")
        dimensions = tuple(self.axes)
        variables = {
            name: (dimensions, values, {"units": self.units.get(name, "")}) for name, values in self.results.items()
        }
        variables.update({"bound_" + name: (dimensions, values) for name, values in self.bounds.items()})
        coordinates = {name: (name, values, {"units": self.units[name]}) for name, values in self.axes.items()}
        return xarray.Dataset(variables, coordinates)


def read_table(path):
    """The table of a run: table.h5 or the run's folder. Raises InputError, ImportError without h5py."""
    return Table(path)
