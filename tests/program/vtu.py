"""Reads the .vtu files of deal.II: zlib-compressed blocks in base64."""
import base64
import struct
import xml.etree.ElementTree as Xml
import zlib

LETTERS = {"Float32": "f", "Float64": "d"}


def values(array):
    """Numbers of a compressed DataArray."""
    text = array.text.strip()
    n_blocks = struct.unpack("<I", base64.b64decode(text[:8])[:4])[0]
    n_header = 4 * ((4 * (3 + n_blocks) + 2) // 3)
    sizes = struct.unpack(
        f"<{3 + n_blocks}I", base64.b64decode(text[:n_header])[: 4 * (3 + n_blocks)]
    )[3:]
    data, raw, at = base64.b64decode(text[n_header:]), b"", 0
    for size in sizes:
        raw += zlib.decompress(data[at : at + size])
        at += size
    letter = LETTERS[array.get("type")]
    return struct.unpack(f"<{len(raw) // struct.calcsize(letter)}{letter}", raw)


def arrays(piece):
    """Points and fields of a piece: name, number of components, unit, numbers."""
    for array in piece.iter("DataArray"):
        if array.get("type") in LETTERS:
            yield (array.get("Name") or "points", int(array.get("NumberOfComponents") or 1),
                   array.get("units"), values(array))


def nodes(path):
    """Fields at the nodes of a file, each node once, and their units."""
    fields, units = {}, {}
    for piece in Xml.parse(path).iter("Piece"):
        for name, n, units[name], numbers in arrays(piece):
            column = list(zip(*(numbers[d::n] for d in range(n))))
            fields.setdefault(name, []).extend(column if n > 1 else [v for v, in column])
    first = {}
    for at, point in enumerate(fields["points"]):
        first.setdefault(point, at)
    return {name: [column[at] for at in first.values()] for name, column in fields.items()}, units
