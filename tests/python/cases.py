"""What the tests of the Python module share: small scenes, and the program."""

import csv
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True

ROOT = pathlib.Path(__file__).resolve().parents[2]
PRM = ROOT / "prm"
PROGRAM = os.environ.get("ROLLING_CONTACT_PROGRAM", str(ROOT / "build/rolling-contact"))

CARTER = PRM / "carter_2d_partial_slip.prm"
COARSE_2D = {"Mesh/Elements across patch": 16}

LOADED_2D = """
set Dimension = 2
subsection Contact
  set Normal load = 140e3
  set Creepage x  = 0.001
end
subsection Mesh
  set Elements across patch = 12
end
"""

PATCH_3D = """
set Dimension = 3
subsection Wheel
  set Lateral radius = 0.3
end
subsection Rail
  set Lateral radius = 0.3
end
subsection Contact
  set Normal load = 36e3
  set Creepage x  = 0.001
  set Creepage y  = -0.0007
  set Spin        = 0.4
end
subsection Mesh
  set Elements across patch = 8
  set Growth                = 0.8
end
"""


def rows_of_program(scene, settings=None, table="results.csv"):
    """The rows of results.csv of a run of the program, of a path or a text."""
    with tempfile.TemporaryDirectory() as folder:
        if isinstance(scene, str):
            text, scene = scene, pathlib.Path(folder) / "scene.prm"
            scene.write_text(text)
        output = pathlib.Path(folder) / "run"
        command = [PROGRAM, str(scene), "--output", str(output)]
        for entry, value in (settings or {}).items():
            command += ["--set", f"{entry}={value}"]
        subprocess.run(command, check=True, capture_output=True, cwd=folder)
        with open(output / table) as rows:
            return list(csv.DictReader(rows))


class Case(unittest.TestCase):
    def assert_close(self, value, expected, relative, scale=None):
        """|value - expected| is at most relative times the scale, |expected| by default."""
        size = abs(expected) if scale is None else scale
        self.assertLessEqual(abs(value - expected), relative * size, f"{value} is not {expected}")
