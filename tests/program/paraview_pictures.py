"""What the pictures of runs show: parts of the picture in certain colours.

Usage: pvpython paraview_pictures.py RUN_FOLDER...
"""
import glob
import os
import sys

import numpy as np
from paraview.vtk.util.numpy_support import vtk_to_numpy
from paraview.vtk.vtkIOImage import vtkPNGReader

SIZE = (1200, 800)
GREY, ORANGE, BLUE = (209, 209, 209), (230, 158, 0), (0, 115, 179)
BLACK, RED, YELLOW, PURPLE = (0, 0, 0), (214, 48, 31), (253, 231, 37), (68, 1, 84)
GREEN = (53, 183, 121)  # of viridis, at two thirds
failures = 0


def report(what, good):
    global failures
    if not good:
        failures += 1
        print(f"FAILED: {what}")


def read(path):
    """Rows from below, columns, red, green and blue."""
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    report(f"{path}: size", image.GetDimensions()[:2] == SIZE)
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    return values.reshape(SIZE[1], SIZE[0], -1)[:, :, :3].astype(int)


def share(image, colour, tolerance=12):
    return (np.abs(image - colour).max(axis=2) <= tolerance).mean()


def check(path, wanted, unwanted=()):
    """Colours with the share of the drawing they must have, or must not."""
    is_chart = os.path.exists(os.path.join(os.path.dirname(path), "tractions.png")) and not (
        "von_mises" in path
    )
    margin, right = (70, 980) if is_chart else (150, 900)  # no axes, texts and legends
    drawing = read(path)[margin : SIZE[1] - margin, margin + 30 : right]
    for colour, least in wanted.items():
        part = share(drawing, colour)
        report(f"{path}: {part:.4f} of it in {colour}, at least {least}", part >= least)
    for colour in unwanted:
        part = share(drawing, colour)
        report(f"{path}: {part:.4f} of it in {colour}, nothing expected", part < 2e-4)
    return drawing


def check_run(folder):
    rolls = "frictionless" not in folder
    sticks = {BLUE: 0.05, ORANGE: 0.05} if rolls else {ORANGE: 0.05}
    marks = {colour: 2e-4 for colour in (BLACK, *sticks)}
    states = {GREY: 0.02, **sticks}
    arrows = {BLACK: 5e-3} if rolls else {}
    pictures = glob.glob(os.path.join(folder, "pictures", "*.png"))
    report(f"{folder}: has pictures", pictures)
    for path in pictures:
        name = os.path.basename(path).split(".")[0].split("-")[0]
        if name == "patch_state":
            check(path, states, () if rolls else (BLUE,))
        elif name == "pressure_and_traction":
            check(path, {RED: 1e-3, **arrows}, () if rolls else (BLACK,))
        elif name == "tractions":
            check(path, marks, () if rolls else (BLUE,))
        elif name in ("sliding", "friction"):
            is_flat = os.path.exists(os.path.join(folder, "pictures", "tractions.png"))
            check(path, {BLUE: 2e-4} if is_flat else {YELLOW: 1e-3, PURPLE: 1e-4})
        else:
            # with friction the stress may have its peak at a node of the surface
            most = PURPLE if "impact" in folder else GREEN if rolls else YELLOW
            drawing = check(path, {most: 1e-3})
            for body, half in zip(("rail", "wheel"), np.array_split(drawing, 2)):
                bare = share(half, (255, 255, 255))
                is_rigid = f"rigid_{body}" in folder
                report(f"{path}: {body} missing: {bare:.2f} bare", (bare > 0.5) == is_rigid)


for run_folder in sys.argv[1:]:
    check_run(run_folder)
sys.exit(failures > 0)
