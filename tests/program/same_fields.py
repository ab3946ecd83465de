"""The same fields of bodies in one file each and in pieces.

Usage: same_fields.py ONE.pvd PIECES.pvd NUMBER_OF_PIECES, fields of deal.II
(zlib-compressed blocks in base64). Compares the numbers of cells, and ranges
to a unit in the last place of their single precision, 2^-23 of the largest
value, and means to 1e-8 of it.
"""
import os
import sys
import xml.etree.ElementTree as Xml

import vtu


def read(path, fields):
    """Number of cells; adds least, largest, sum and number of values."""
    root, cells = Xml.parse(path).getroot(), 0
    for piece in root.iter("Piece"):
        cells += int(piece.get("NumberOfCells"))
        for name, n, _, numbers in vtu.arrays(piece):
            for d in range(n):
                part = numbers[d::n]
                low, high, total, count = fields.get(
                    (name, d), (part[0], part[0], 0.0, 0)
                )
                fields[name, d] = (
                    min(low, *part),
                    max(high, *part),
                    total + sum(part),
                    count + len(part),
                )
    return cells


def bodies(pvd):
    """Of each body: number of files with cells, cells, ranges."""
    result, folder = [], os.path.dirname(pvd)
    for block in Xml.parse(pvd).getroot().iter("DataSet"):
        name, fields = os.path.join(folder, block.get("file")), {}
        files = [name]
        if name.endswith(".pvtu"):
            pieces = Xml.parse(name).getroot().iter("Piece")
            files = [os.path.join(folder, piece.get("Source")) for piece in pieces]
        cells = [read(file, fields) for file in files]
        result.append((len(files), sum(cells), fields))
    return result


whole, spread = bodies(sys.argv[1]), bodies(sys.argv[2])
assert len(whole) == len(spread) == 2, "two bodies"
for (_, cells, fields), (n_files, other_cells, others) in zip(whole, spread):
    assert n_files == int(sys.argv[3]), f"{n_files} pieces"
    assert cells == other_cells > 0, f"{other_cells} cells, not {cells}"
    assert fields.keys() == others.keys() and len(fields) > 8, "fields"
    for name, (low, high, total, count) in fields.items():
        other_low, other_high, other_total, other_count = others[name]
        assert count == other_count, f"{name}: {other_count} values"
        scale = max(abs(low), abs(high))
        error = max(abs(low - other_low), abs(high - other_high))
        shift = abs(total - other_total) / count
        print(name, low, high, error, shift)
        assert error <= 2**-23 * scale, f"{name}: {error} of {scale}"
        assert shift <= 1e-8 * scale, f"mean {name}: {shift} of {scale}"
