#!/usr/bin/env python3
"""Forces between the states of a table, linear in each axis, with their error
bounds. Needs numpy and h5py (Debian: python3-h5py).

Usage: interpolate_table.py table.h5 AXIS=VALUE..., for example
interpolate_table.py output/table_3d/table.h5 contact_normal_load=60e3 \
  contact_creepage_x=0.003 contact_creepage_y=0.001 contact_spin=0.1
"""
import itertools
import sys

import h5py
import numpy as np


class Table:
    def __init__(self, path):
        self.file = h5py.File(path)
        self.names = self.file.attrs["axes"].split(", ")
        self.axes = [self.file["axes/" + name][:] for name in self.names]

    def weights(self, point):
        """The corners of the cell of a point (values by axis name) and their
        weights."""
        if sorted(point) != sorted(self.names):
            raise ValueError("give a value for each of " + ", ".join(self.names))
        places = []
        for name, axis in zip(self.names, self.axes):
            if not axis[0] <= point[name] <= axis[-1]:
                raise ValueError(f"{name} = {point[name]}: the table has "
                                 f"{axis[0]} to {axis[-1]}")
            k = min(max(np.searchsorted(axis, point[name]) - 1, 0),
                    max(len(axis) - 2, 0))
            t = (point[name] - axis[k]) / (axis[k + 1] - axis[k]) \
                if len(axis) > 1 else 0.
            places.append([(k, 1 - t)] + ([(k + 1, t)] if t > 0 else []))
        for corner in itertools.product(*places):
            yield tuple(k for k, _ in corner), \
                np.prod([weight for _, weight in corner])

    def value(self, quantity, point):
        array = self.file[quantity]
        return sum(weight * array[corner]
                   for corner, weight in self.weights(point))


def main(words):
    if len(words) < 2:
        sys.exit(__doc__)
    table = Table(words[0])
    at = {name: float(value) for name, value in
          (word.split("=") for word in words[1:])}
    for quantity in ("force_x_N", "force_y_N", "spin_moment_Nm"):
        print(f"{quantity:15} {table.value('results/' + quantity, at):12.6g}"
              f" +- {table.value('bounds/' + quantity, at):.2g}")


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except (OSError, ValueError) as error:
        sys.exit(f"interpolate_table.py: {error}")
