"""Every kind of output in ParaView, against what must hold and what the tables say, and its pictures."""

import functools
import os
import re
import select
import shutil
import subprocess
import types
import xml.etree.ElementTree as Xml

import numpy as np
import paraview.simple as pv
import pytest
from conftest import PROJECT, QUICK, QUIET, near
from paraview import servermanager
from paraview.vtk.util.numpy_support import vtk_to_numpy
from paraview.vtk.vtkIOImage import vtkPNGReader

FLAT = {**QUICK, "Output/Plot": "false"}
SOLID = {"Mesh/Elements across patch": 8, "Mesh/Growth": 0.5, **QUIET}
COARSE = {**SOLID, "Mesh/Elements across patch": 6}
DISCS, SPHERES = "carter_2d_partial_slip", "lateral_3d_partial_slip"
UPWIND, FRICTIONLESS = {"Contact/Slip operator": "upwind 2"}, {"Contact/Friction coefficient": 0}
SPREAD = {"Body solver": "distributed"} # on two ranks
NO_INTERFACE = {"Output/Interface fields": "false"}
RUNS = {
    "state_2d": (DISCS, FLAT, {"Mesh/Elements across patch": 24}),
    "upwind_2d": ("steel_on_aluminium_2d", FLAT, UPWIND, {"Contact/Speed": -1}),
    "levels_2d": ("adaptive_2d", FLAT, {"Mesh/Adaptive levels": 2}),
    "rigid_wheel_2d": (DISCS, FLAT, {"Wheel/Rigid": "true"}),
    "frictionless_2d": (DISCS, FLAT, FRICTIONLESS),
    "in_time_2d": ("oscillating_creepage_2d", FLAT, {"Time/Time step": 5e-6, "Time/End time": 100e-6, "Time/Field interval": 5}),
    "frictionless_impact_2d": ("impact_2d", FLAT, {"Time/Time step": 1e-6, "Time/Field interval": 40}),
    "upwind_3d": ("combined_3d", SOLID, UPWIND),
    "levels_3d": ("adaptive_3d", COARSE, {"Mesh/Adaptive levels": 1}),
    "frictionless_3d": (SPHERES, COARSE, FRICTIONLESS),
    "in_time_3d": ("start_up_3d", COARSE, {"Time/Rolled distance": 0.02, "Time/Field interval": 10}),
    "curve_2d": (DISCS, FLAT, {"Analysis": "creep curve", "Creep curve/Creepage x": "0 : 0.008 : 9"}),
    "without_interface_3d": ("wheel_on_rail_3d", COARSE, NO_INTERFACE),
    "distributed_2d": (DISCS, FLAT, SPREAD, NO_INTERFACE),
    "distributed_3d": (SPHERES, COARSE, {"Mesh/Growth": 0.7}, SPREAD)}
DRAWN = {
    **{name: RUNS[name] for name in ("state_2d", "rigid_wheel_2d", "upwind_3d", "frictionless_3d", "without_interface_3d")},
    "falling_2d": ("falling_friction_2d", QUICK),
    "falling_3d": ("combined_3d", SOLID, {"Contact/Speed": 20, "Contact/Friction law": "rational", "Contact/Friction decay speed": 0.2,
                                          "Contact/Kinetic friction coefficient": 0.2})}


@pytest.fixture(scope="module")
def of(shared):
    """The run of a name above, once."""
    def run(name):
        settings = {**RUNS, **DRAWN}[name]
        return shared(*settings, output=name, ranks=2 if SPREAD in settings else 0)
    return functools.cache(run)


SINGLE = 2.0**-22  # the fields are in single precision
OPEN, SLIP, STICK = 0, 1, 2
ARRAYS = {
    "interface.pvd": {"pressure": 1, "traction": 3, "traction_size": 1, "traction_bound": 1, "slip": 3, "gap": 1, "area": 1, "state": 1},
    "bodies.pvd": {"displacement": 3, "stress_xx": 1, "stress_yy": 1, "stress_zz": 1, "stress_xz": 1, "von_mises": 1, "stress_error": 1}}


def scene_of(run):
    """What used.prm of a run says."""
    text = (run / "used.prm").read_text(encoding="utf-8")

    def value(entry, section):
        start = text.index(f"subsection {section}\n") if section else 0
        return re.search(rf"set {entry} *= *(.*)", text[start:]).group(1).strip()

    dim, one_state = int(value("Dimension", "")), value("Analysis", "") in ("quasi-static", "transient")
    return types.SimpleNamespace(
        dim=dim, mu=float(value("Friction coefficient", "Contact")), width=float(value("Thickness", "Wheel")) if dim == 2 else 1,
        bodies=[body.lower() for body in ("Wheel", "Rail") if value("Rigid", body) == "false"],
        node_by_node=value("Slip operator", "Contact") != "calibrated",
        has={"bodies.pvd": one_state and value("Body fields", "Output") == "true",
             "interface.pvd": one_state and value("Interface fields", "Output") == "true"})


def rows(run, name):
    """Rows as dictionaries, the same by ParaView's reader and by Python's."""
    table = run.table(name)
    read = servermanager.Fetch(pv.CSVReader(FileName=[str(table.path)]))
    assert [read.GetColumnName(i) for i in range(read.GetNumberOfColumns())] == table.columns
    assert read.GetNumberOfRows() == len(table)
    for i, row in enumerate(table.rows):
        for column, text in zip(table.columns, row):
            value, text = read.GetValueByName(i, column), text or "0" # what ParaView makes of an empty entry
            assert value.ToString() == text or value.ToDouble() == float(text), column
    return [dict(zip(table.columns, row)) for row in table.rows]


def leaves(data):
    if data.IsA("vtkDataSet"):
        return [data]
    parts = [data.GetPartition(i) for i in range(data.GetNumberOfPartitions())] if data.IsA("vtkPartitionedDataSet") else \
            [data.GetBlock(i) for i in range(data.GetNumberOfBlocks())]
    return [leaf for part in parts if part is not None for leaf in leaves(part)]


def named_blocks(reader, time):
    """Blocks of a collection at a time: name to a list of data sets."""
    reader.UpdatePipeline(time)
    data = servermanager.Fetch(reader)
    if data.IsA("vtkDataSet"):  # the only block; ParaView forgets its name
        name = {block.get("name") for block in Xml.parse(reader.FileName).iter("DataSet")}
        return {name.pop(): [data]}
    return {data.GetMetaData(i).Get(data.NAME()): leaves(data.GetBlock(i)) for i in range(data.GetNumberOfBlocks())}


def fields(data_sets, arrays):
    """Points and arrays of data sets, one after the other; all are finite."""
    values = {"points": np.vstack([vtk_to_numpy(data.GetPoints().GetData()) for data in data_sets])}
    for name, n_components in arrays.items():
        parts = [data.GetPointData().GetArray(name) for data in data_sets]
        assert None not in parts, name
        assert all(part.GetNumberOfComponents() == n_components for part in parts), name
        values[name] = np.concatenate([vtk_to_numpy(part) for part in parts]).astype(float)
    assert all(np.isfinite(value).all() for value in values.values())
    return values


def check_laws(f, mu):
    """Signorini's and Coulomb's at every point, as far as single precision goes."""
    p, q, bound = f["pressure"], f["traction_size"], f["traction_bound"]
    tiny = 4 * SINGLE * p.max()
    assert (p >= 0).all()
    assert (bound <= mu * p * (1 + 4 * SINGLE)).all()
    # the edge law lets the first node at a leading edge carry no traction
    assert mu * p.sum() - bound.sum() <= 0.02 * mu * p.sum()
    assert (q <= bound * (1 + 4 * SINGLE) + mu * tiny).all()
    assert np.allclose(np.linalg.norm(f["traction"], axis=1), q, rtol=4 * SINGLE, atol=mu * tiny)
    assert np.isin(f["state"], [OPEN, SLIP, STICK]).all()
    assert (f["gap"] >= -1e-9).all() and (f["gap"][p > tiny] < 1e-9).all()


def check_states(f, mu, node_by_node):
    """Not at hanging corners, whose values are interpolated; the edge law joins nodes."""
    p, q, bound, state = f["pressure"], f["traction_size"], f["traction_bound"], f["state"]
    assert ((p == 0) == (state == OPEN)).all()
    slips = state == SLIP
    assert np.allclose(q[slips], bound[slips], rtol=1e-5)
    if not node_by_node:
        return
    sliding = np.einsum("ij,ij->i", f["slip"], f["traction"])
    assert (sliding <= 1e-6 * np.abs(f["slip"]).max() * q.max()).all(), "q opposes slip"
    if mu > 0:
        slip = np.linalg.norm(f["slip"][(state == STICK) & (bound > 0)], axis=1)
        assert (slip < 1e-9).all(), f"no slip where it sticks: {slip.max(initial=0)}"


def integrals(reader, scene):
    """Of pressure and traction over the plane, by ParaView, in N."""
    flat = pv.Calculator(Input=pv.MergeBlocks(Input=reader), CoordinateResults=1)
    flat.Function = "coordsX*iHat" + (" + coordsY*jHat" if scene.dim == 3 else "")
    total = servermanager.Fetch(pv.IntegrateVariables(Input=flat)).GetPointData()
    return [scene.width * value for name in ("pressure", "traction") for value in total.GetArray(name).GetTuple(0)]


def check_interface(reader, scene, time, row):
    blocks = named_blocks(reader, time)
    assert list(blocks) == ["interface"]
    f = fields(blocks["interface"], ARRAYS["interface.pvd"])
    check_laws(f, scene.mu)
    load = float(row["normal_force_N"])
    near(f["pressure"].max(), float(row["max_pressure_Pa"]), 4 * SINGLE)
    reader.UpdatePipeline(time)
    normal, along, across, *_ = integrals(reader, scene)
    near(normal, load, 1e-5)
    near(along, float(row["force_x_N"]), 0, 1e-5 * load)
    near(across, float(row["force_y_N"]), 0, 1e-5 * load)
    _, at = np.unique(f["points"], axis=0, return_index=True)
    nodes = {name: values[at] for name, values in f.items()}
    # of a run in time the slip is not all of that in the law
    if int(row.get("contact_nodes", 0)) == len(at):
        check_states(nodes, scene.mu, scene.node_by_node)
        near(nodes["pressure"] @ nodes["area"], load, 1e-5)
        assert (nodes["state"] != OPEN).sum() == int(row["nodes_in_contact"])


def check_stresses(f, dim):
    """von Mises stress again from the components."""
    xx, yy, zz, xz = (f["stress_" + c] for c in ("xx", "yy", "zz", "xz"))
    shear = xz**2 + (f["stress_xy"] ** 2 + f["stress_yz"] ** 2 if dim == 3 else 0)
    again = np.sqrt(((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) / 2 + 3 * shear)
    assert (f["von_mises"] >= 0).all()
    assert np.allclose(f["von_mises"], again, rtol=1e-5, atol=1e-5 * again.max())


def check_nodes(f):
    """Each element brings its nodes; they have the values of the others there."""
    _, first, copies = np.unique(f["points"], axis=0, return_index=True, return_inverse=True)
    assert (f["stress_error"] >= 0).all()
    assert 2 * len(first) < len(copies), "several elements at a node"
    for name in ("stress_xx", "stress_zz", "stress_xz", "stress_error"):
        apart = np.abs(f[name] - f[name][first][copies.ravel()]).max()  # ranks round
        assert apart <= 4 * SINGLE * np.abs(f[name]).max(), name


def lowest_height(f, dim, side):
    """Of the deformed surface next to the other body, at x = y = 0, by its nearest point."""
    up = dim - 1
    surface = side * f["points"][:, up] < 1e-6
    at = (np.linalg.norm(f["points"][:, :up], axis=1) + (~surface) * 1e3).argmin()
    return f["points"][at, up] + f["displacement"][at, up]


def check_bodies(reader, scene, time, row):
    blocks = named_blocks(reader, time)
    assert list(blocks) == scene.bodies
    arrays = {**ARRAYS["bodies.pvd"], **({"stress_xy": 1, "stress_yz": 1} if scene.dim == 3 else {})}
    heights, pressure = [], float(row["max_pressure_Pa"])
    for name, data_sets in blocks.items():
        f = fields(data_sets, arrays)
        check_stresses(f, scene.dim)
        check_nodes(f)
        side = 1 if name == "wheel" else -1
        assert (side * f["points"][:, scene.dim - 1] >= -1e-6).all(), "on its side"
        heights.append(lowest_height(f, scene.dim, side))
        assert pressure <= 0 or 0.3 < f["von_mises"].max() / pressure < 1.2
    if "half_width_x_m" in row:  # at rest
        check_forces(reader, scene, row)
    if len(heights) == 2 and float(row["normal_force_N"]) > 0:
        near(heights[0], heights[1], 0, 1e-7) # the bodies touch


def check_forces(reader, scene, row):
    """Of the stress in each body along a plane at the depth of the half-width."""
    load, up = float(row["normal_force_N"]), scene.dim - 1
    forces = {"stress_zz": load, "stress_xz": float(row["force_x_N"]), **({"stress_yz": float(row["force_y_N"])} if up == 2 else {})}
    for body in scene.bodies:
        cut = pv.Slice(Input=reader)
        cut.SliceType.Normal = normal = np.eye(3)[up]
        cut.SliceType.Origin = float(row["half_width_x_m"]) * normal * (1 if body == "wheel" else -1)
        total = servermanager.Fetch(pv.IntegrateVariables(Input=cut)).GetPointData()
        for stress, force in forces.items():
            near(total.GetArray(stress).GetTuple(0)[0] * scene.width, -force, 0, (0.02 if up == 1 else 0.1) * load)


def rows_at_times(run, times):
    """The row of a table for each time of the fields."""
    results = rows(run, "results.csv")
    if not (run / "history.csv").is_file():
        assert list(times) == [0]
        return results[-1:]
    at = {float(row["time_s"]): row for row in rows(run, "history.csv")}
    assert len(times) > 2 and all(time in at for time in times)
    assert times[-1] == max(at)
    return [at[time] for time in times]


@pytest.mark.parametrize("name", RUNS)
def test_fields(of, name, capfd):
    run = of(name)
    capfd.readouterr()
    scene, at = scene_of(run), None
    for file, check in (("interface.pvd", check_interface), ("bodies.pvd", check_bodies)):
        assert (run / file).is_file() == scene.has[file], "written if asked for"
        if scene.has[file]:
            reader = pv.PVDReader(FileName=str(run / file))
            reader.UpdatePipelineInformation()
            times = list(reader.TimestepValues)
            at = at or rows_at_times(run, times)
            for time, row in zip(times, at):
                check(reader, scene, time, row)
    if not any(scene.has.values()):
        assert len(rows(run, "results.csv")) > 2
    said = [line for line in capfd.readouterr().err.splitlines() if not line.startswith("[hwloc/")] # a container may hide /sys
    assert not said, "ParaView reads them without a word"


@pytest.fixture(scope="module")
def display():
    """A display of its own, the first that is free."""
    with subprocess.Popen(["Xvfb", "-noreset", "-displayfd", "1"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as server:
        try:
            assert select.select([server.stdout], [], [], 60)[0], "no display"
            yield ":" + server.stdout.readline().strip()
        finally:
            server.kill()


def draw(folder, *arguments, display=None, refusal=None):
    """Pictures of a run, drawn as a user does, in silence or not."""
    environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
    done = subprocess.run(["pvpython", PROJECT / "prm/paraview/pictures.py", *arguments], cwd=folder, capture_output=True, text=True,
                          check=False, env=environment | ({"DISPLAY": display} if display else {}))
    said = [line for line in done.stderr.splitlines() if not line.startswith("[hwloc/")]
    if refusal is None:
        assert done.returncode == 0 and not said, done
    else:
        assert done.returncode == 1 and len(said) == 1 and f"pictures.py: {refusal}" in said[0], done


SIZE = (1200, 800)
GREY, ORANGE, BLUE = (209, 209, 209), (230, 158, 0), (0, 115, 179)
BLACK, RED, YELLOW, PURPLE = (0, 0, 0), (214, 48, 31), (253, 231, 37), (68, 1, 84)
GREEN, WHITE = (53, 183, 121), (255, 255, 255)  # green of viridis, at two thirds


def share(image, colour, tolerance=12):
    return (np.abs(image - colour).max(axis=2) <= tolerance).mean()


def drawing(path, wanted, unwanted=()):
    """A picture without axes, texts and legends: rows from below, columns, red, green and blue; colours have at least
    a share of it, or nothing."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    assert image.GetDimensions()[:2] == SIZE
    values = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(SIZE[1], SIZE[0], -1)[:, :, :3].astype(int)
    is_chart = (path.parent / "tractions.png").exists() and "von_mises" not in path.name
    margin, right = (70, 980) if is_chart else (150, 900)
    part = values[margin : SIZE[1] - margin, margin + 30 : right]
    for colour, least in wanted.items():
        assert share(part, colour) >= least, f"{path.name}: {colour}"
    for colour in unwanted:
        assert share(part, colour) < 2e-4, f"{path.name}: {colour}"
    return part


def check_pictures(run):
    """What the pictures of a run show: parts of the picture in certain colours."""
    name = run.folder.name
    rolls = "frictionless" not in name
    sticks = {BLUE: 0.05, ORANGE: 0.05} if rolls else {ORANGE: 0.05}
    pictures = list((run / "pictures").glob("*.png"))
    assert pictures
    for path in pictures:
        kind = path.name.split(".")[0].split("-")[0]
        if kind == "patch_state":
            drawing(path, {GREY: 0.02, **sticks}, () if rolls else (BLUE,))
        elif kind == "pressure_and_traction":
            drawing(path, {RED: 1e-3, **({BLACK: 5e-3} if rolls else {})}, () if rolls else (BLACK,))
        elif kind == "tractions":
            drawing(path, {colour: 2e-4 for colour in (BLACK, *sticks)}, () if rolls else (BLUE,))
        elif kind in ("sliding", "friction"):
            is_flat = (path.parent / "tractions.png").exists()
            drawing(path, {BLUE: 2e-4} if is_flat else {YELLOW: 1e-3, PURPLE: 1e-4})
        else:
            # with friction the stress may have its peak at a node of the surface
            image = drawing(path, {PURPLE if "impact" in name else GREEN if rolls else YELLOW: 1e-3})
            for body, half in zip(("rail", "wheel"), np.array_split(image, 2)):
                assert (share(half, WHITE) > 0.5) == (f"rigid_{body}" in name), f"{body} is missing where it is rigid"


@pytest.mark.parametrize("name", DRAWN)
def test_pictures(of, display, name):
    run = of(name)
    draw(run.folder.parent, name, display=display)
    drawn = [path.name for path in (run / "pictures").iterdir()]
    if name in ("upwind_3d", "falling_3d"):
        assert len(drawn) == {"upwind_3d": 4, "falling_3d": 5}[name]
    if name == "falling_2d":
        assert {"sliding.png", "friction.png"} <= set(drawn)
    if name == "without_interface_3d":
        assert drawn == ["von_mises.png"]
    check_pictures(run)


def test_pictures_of_every_step_or_of_the_last_contact(of, display):
    run = of("frictionless_impact_2d")
    draw(run.folder.parent, run.folder.name, "--steps", display=display)
    assert len(list((run / "pictures").glob("*-0003.png"))) == 2
    shutil.rmtree(run / "pictures")
    draw(run.folder.parent, run.folder.name, display=display)
    check_pictures(run)


def test_what_pictures_refuses(of, display, tmp_path):
    draw(tmp_path, display=display, refusal="usage: ")
    draw(tmp_path, ".", display=display, refusal=". is not the folder of a run")
    draw(of("curve_2d").folder.parent, "curve_2d", display=display, refusal="curve_2d has no fields. A creep curve has none")
    gone, old = (shutil.copytree(of("state_2d").folder, tmp_path / name) for name in ("gone", "old"))
    (gone / "rail.vtu").unlink()
    draw(tmp_path, "gone", display=display, refusal="gone has no rail.vtu")
    for path in old.glob("*.vtu"):
        path.write_bytes(path.read_bytes().replace(b'Name="von_mises"', b'Name="mises"'))
    draw(tmp_path, "old", display=display, refusal="old/bodies.pvd has no von_mises")
    draw(of("state_2d").folder.parent, "state_2d", refusal="ParaView draws only on a display")
