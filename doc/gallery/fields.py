"""Pictures of fields that the gallery has beside those of prm/paraview/pictures.py.

    pvpython doc/gallery/fields.py operators PICTURE.png RUN_FOLDER RUN_FOLDER
    pvpython doc/gallery/fields.py mesh PICTURE.png RUN_FOLDER
    pvpython doc/gallery/fields.py bodies PICTURE.png RUN_FOLDER

operators: the traction of two runs over mu p0 as maps, and along y = 0; mesh:
pressure and mesh of a patch; bodies: wheel and rail with their meshes.
"""

import csv
import sys

import matplotlib

matplotlib.use("agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
import paraview.simple as pv  # noqa: E402
from paraview.servermanager import Fetch  # noqa: E402
from paraview.vtk.util.numpy_support import vtk_to_numpy  # noqa: E402


def patch(folder):
    """Points in mm, cells as rows of four points, and fields at the points."""
    grid = Fetch(pv.MergeBlocks(Input=pv.PVDReader(FileName=f"{folder}/interface.pvd")))
    points = 1000 * vtk_to_numpy(grid.GetPoints().GetData())[:, :2]
    cells = np.array([[grid.GetCell(i).GetPointId(k) for k in range(4)] for i in range(grid.GetNumberOfCells())])
    data = grid.GetPointData()
    return points, cells, {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)) for i in range(data.GetNumberOfArrays())}


def triangles(cells):
    return np.vstack([cells[:, [0, 1, 2]], cells[:, [0, 2, 3]]])


def last_row(folder):
    with open(f"{folder}/results.csv", encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))[-1]


def of_scene(folder, name, default):
    """An entry of used.prm, which leaves out defaults."""
    with open(f"{folder}/used.prm", encoding="utf-8") as file:
        for line in file:
            key, _, value = line.partition("=")
            if key.split() == ["set", *name.split()]:
                return value.strip()
    return default


def operators(picture, *folders):
    """Maps of two runs above, the line of nodes along y = 0 below."""
    figure, axes = plt.subplots(2, 2, figsize=(9.2, 6.4), sharex=True, layout="constrained")
    for folder, (above, below) in zip(folders, axes.T):
        points, cells, fields = patch(folder)
        bound = float(of_scene(folder, "Friction coefficient", "0.3")) * fields["pressure"].max()
        size = np.hypot(*fields["traction"][:, :2].T) / bound
        drawn = above.tripcolor(*points.T, triangles(cells), size, shading="gouraud", vmin=0, vmax=1)
        row = last_row(folder)
        above.contour(*hertz_ellipse(row), levels=[1], colors="white", linestyles="dashed", linewidths=1)
        above.set_aspect("equal")
        above.set_title(f"{of_scene(folder, 'Slip operator', 'calibrated')}, "
                        f"{of_scene(folder, 'Contact matrices', 'lumped')}", fontsize=10)
        line = np.flatnonzero(np.abs(points[:, 1]) < 1e-6)
        line = line[np.argsort(points[line, 0])]
        line = line[np.append(True, np.diff(points[line, 0]) > 1e-6)]
        below.plot(points[line, 0], fields["pressure"][line] / fields["pressure"].max(), "--", color="0.6", label="bound \u03bcp")
        below.plot(points[line, 0], size[line], "o-", color="#0072b2", markersize=3.5, label="|q|")
        below.set_xlabel("x (mm), material flows to the right")
        below.grid(alpha=0.3)
    axes[0, 0].set_ylabel("y (mm)")
    axes[1, 0].set_ylabel("|q| / (\u03bc p\u2080) along y = 0")
    axes[1, 0].legend(frameon=False)
    figure.colorbar(drawn, ax=axes[0, :], label="|q| / (\u03bc p\u2080)")
    figure.savefig(picture, dpi=100)


def hertz_ellipse(row):
    """x, y in mm and (x/a)^2 + (y/b)^2 of the Hertz ellipse."""
    a, b = (1000 * float(row[name]) for name in ("reference_half_width_x_m", "reference_half_width_y_m"))
    x, y = np.meshgrid(np.linspace(-1.1 * a, 1.1 * a, 101), np.linspace(-1.1 * b, 1.1 * b, 101))
    return x, y, (x / a) ** 2 + (y / b) ** 2


def mesh(picture, folder):
    points, cells, fields = patch(folder)
    figure, axes = plt.subplots(figsize=(7.6, 5), layout="constrained")
    drawn = axes.tripcolor(*points.T, triangles(cells), fields["pressure"] / 1e6, shading="gouraud")
    edges = np.append(cells, cells[:, :1], axis=1)
    axes.add_collection(matplotlib.collections.LineCollection(points[edges], colors="white", linewidths=0.5, alpha=0.6))
    axes.set_aspect("equal")
    axes.set_xlabel("x (mm), material flows to the right")
    axes.set_ylabel("y (mm)")
    figure.colorbar(drawn, label="pressure (MPa)")
    figure.savefig(picture, dpi=100)


def bodies(picture, folder):
    """Seen from the field side, ahead and above."""
    view = pv.CreateView("RenderView")
    view.ViewSize, view.OrientationAxesVisibility = [880, 640], 0
    view.UseColorPaletteForBackground, view.Background = 0, [1, 1, 1]
    for name, colour in (("wheel", [0.72, 0.75, 0.80]), ("rail", [0.85, 0.74, 0.62])):
        body = pv.Show(pv.ExtractSurface(Input=pv.XMLUnstructuredGridReader(FileName=[f"{folder}/{name}.vtu"])), view)
        body.Representation, body.ColorArrayName = "Surface With Edges", ["POINTS", ""]
        body.AmbientColor = body.DiffuseColor = colour
        body.EdgeColor, body.Specular, body.Ambient = [0.35, 0.35, 0.4], 0, 0.25
    view.CameraViewUp = [0, 0, 1]
    view.CameraFocalPoint, view.CameraPosition = [0, 0, 0.33], [1.6, -1.9, 1.0]
    pv.ResetCamera(view)
    view.GetActiveCamera().Zoom(1.2)
    pv.SaveScreenshot(picture, view)


def main():
    kinds = {"operators": (operators, 2), "mesh": (mesh, 1), "bodies": (bodies, 1)}
    if len(sys.argv) < 4 or sys.argv[1] not in kinds or len(sys.argv) != 3 + kinds[sys.argv[1]][1]:
        sys.exit(__doc__)
    kinds[sys.argv[1]][0](*sys.argv[2:])


if __name__ == "__main__":
    main()
