"""What ParaView reads of runs, against what must hold and what the tables say.

Usage: pvpython paraview_fields.py RUN_FOLDER...
"""
import csv
import os
import re
import sys
import xml.etree.ElementTree as Xml

import numpy as np
import paraview.simple as pv
from paraview import servermanager
from paraview.vtk.util.numpy_support import vtk_to_numpy

SINGLE = 2.0**-22  # the fields are in single precision
OPEN, SLIP, STICK = 0, 1, 2
ARRAYS = {
    "interface.pvd": {
        "pressure": 1, "traction": 3, "traction_size": 1, "traction_bound": 1,
        "slip": 3, "gap": 1, "area": 1, "state": 1,
    },
    "bodies.pvd": {
        "displacement": 3, "stress_xx": 1, "stress_yy": 1, "stress_zz": 1,
        "stress_xz": 1, "von_mises": 1, "stress_error": 1,
    },
}
failures = 0


def report(what, good):
    global failures
    if not good:
        failures += 1
        print(f"FAILED: {what}")


def near(what, value, expected, tolerance):
    report(f"{what}: {value:.8g}, expected {expected:.8g}", abs(value - expected) <= tolerance)


class Scene:
    """used.prm of a run."""

    def __init__(self, folder):
        with open(os.path.join(folder, "used.prm"), encoding="utf-8") as file:
            self.text = file.read()
        self.dim = int(self.value("Dimension", ""))
        self.mu = float(self.value("Friction coefficient", "Contact"))
        self.width = float(self.value("Thickness", "Wheel")) if self.dim == 2 else 1
        self.bodies = [b.lower() for b in ("Wheel", "Rail") if self.value("Rigid", b) == "false"]
        self.node_by_node = self.value("Slip operator", "Contact") != "calibrated"
        one_state = self.value("Analysis", "") in ("quasi-static", "transient")
        self.has_fields = {
            "bodies.pvd": one_state and self.value("Body fields", "Output") == "true",
            "interface.pvd": one_state and self.value("Interface fields", "Output") == "true",
        }

    def value(self, entry, section):
        start = self.text.index(f"subsection {section}\n") if section else 0
        return re.search(rf"set {entry} *= *(.*)", self.text[start:]).group(1).strip()


def table(path):
    """Rows as dictionaries, the same by ParaView's reader and by Python's."""
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    read = servermanager.Fetch(pv.CSVReader(FileName=[path]))
    names = [read.GetColumnName(i) for i in range(read.GetNumberOfColumns())]
    report(f"{path}: columns", names == list(rows[0]) and read.GetNumberOfRows() == len(rows))
    for i, row in enumerate(rows):
        for name in names:
            value = read.GetValueByName(i, name)
            text = row[name] or "0"  # what ParaView makes of an empty entry
            same = value.ToString() == text or value.ToDouble() == float(text)
            report(f"{path}: {name} = {value}, expected {row[name]}", same)
    return rows


def leaves(data):
    if data.IsA("vtkDataSet"):
        return [data]
    parts = [data.GetPartition(i) for i in range(data.GetNumberOfPartitions())] \
        if data.IsA("vtkPartitionedDataSet") else \
        [data.GetBlock(i) for i in range(data.GetNumberOfBlocks())]
    return [leaf for part in parts if part is not None for leaf in leaves(part)]


def named_blocks(reader, time):
    """Blocks of a collection at a time: name to a list of data sets."""
    reader.UpdatePipeline(time)
    data = servermanager.Fetch(reader)
    if data.IsA("vtkDataSet"):  # the only block; ParaView forgets its name
        name = {block.get("name") for block in Xml.parse(reader.FileName).iter("DataSet")}
        return {name.pop(): [data]}
    return {
        data.GetMetaData(i).Get(data.NAME()): leaves(data.GetBlock(i))
        for i in range(data.GetNumberOfBlocks())
    }


def fields(data_sets, arrays, where):
    """Points and arrays of data sets, one after the other; all are finite."""
    values = {"points": np.vstack([vtk_to_numpy(d.GetPoints().GetData()) for d in data_sets])}
    for name, n_components in arrays.items():
        parts = [d.GetPointData().GetArray(name) for d in data_sets]
        report(f"{where}: array {name}", None not in parts)
        if None in parts:
            sys.exit(1)
        report(
            f"{where}: components of {name}",
            all(part.GetNumberOfComponents() == n_components for part in parts),
        )
        values[name] = np.concatenate([vtk_to_numpy(part) for part in parts]).astype(float)
    report(f"{where}: finite", all(np.isfinite(v).all() for v in values.values()))
    return values


def check_laws(f, mu, where):
    """Signorini's and Coulomb's at every point, as far as single precision goes."""
    p, q, bound, state = f["pressure"], f["traction_size"], f["traction_bound"], f["state"]
    tiny = 4 * SINGLE * p.max()
    report(f"{where}: p >= 0", (p >= 0).all())
    report(f"{where}: bound <= mu p", (bound <= mu * p * (1 + 4 * SINGLE)).all())
    # The edge law lets the first node at a leading edge carry no traction
    report(f"{where}: bound = mu p", mu * p.sum() - bound.sum() <= 0.02 * mu * p.sum())
    report(f"{where}: |q| <= bound", (q <= bound * (1 + 4 * SINGLE) + mu * tiny).all())
    report(
        f"{where}: size of q",
        np.allclose(np.linalg.norm(f["traction"], axis=1), q, rtol=4 * SINGLE, atol=mu * tiny),
    )
    report(f"{where}: states", np.isin(state, [OPEN, SLIP, STICK]).all())
    report(f"{where}: gap", (f["gap"] >= -1e-9).all() and (f["gap"][p > tiny] < 1e-9).all())


def check_states(f, mu, node_by_node, where):
    """Not at hanging corners, whose values are interpolated; the edge law joins nodes."""
    p, q, bound, state = f["pressure"], f["traction_size"], f["traction_bound"], f["state"]
    report(f"{where}: open where p = 0", ((p == 0) == (state == OPEN)).all())
    slips = state == SLIP
    report(f"{where}: |q| = bound where it slips", np.allclose(q[slips], bound[slips], rtol=1e-5))
    if not node_by_node:
        return
    sliding = np.einsum("ij,ij->i", f["slip"], f["traction"])
    largest = np.abs(f["slip"]).max() * q.max()
    report(f"{where}: q opposes slip", (sliding <= 1e-6 * largest).all())
    if mu > 0:
        slip = np.linalg.norm(f["slip"][(state == STICK) & (bound > 0)], axis=1)
        report(f"{where}: no slip where it sticks: {slip.max(initial=0)}", (slip < 1e-9).all())


def integrals(reader, dim):
    """Of pressure and traction over the plane, by ParaView: N per width or N."""
    merged = pv.MergeBlocks(Input=reader)
    flat = pv.Calculator(Input=merged, CoordinateResults=1)
    flat.Function = "coordsX*iHat" + (" + coordsY*jHat" if dim == 3 else "")
    total = servermanager.Fetch(pv.IntegrateVariables(Input=flat)).GetPointData()
    return total.GetArray("pressure").GetTuple(0)[0], total.GetArray("traction").GetTuple(0)


def check_interface(reader, scene, time, row, where):
    blocks = named_blocks(reader, time)
    report(f"{where}: blocks {list(blocks)}", list(blocks) == ["interface"])
    f = fields(sum(blocks.values(), []), ARRAYS["interface.pvd"], where)
    check_laws(f, scene.mu, where)
    load = float(row["normal_force_N"])
    near(f"{where}: max pressure", f["pressure"].max(), float(row["max_pressure_Pa"]),
         4 * SINGLE * float(row["max_pressure_Pa"]))
    reader.UpdatePipeline(time)
    normal, tangential = (scene.width * np.array(i) for i in integrals(reader, scene.dim))
    near(f"{where}: load", normal, load, 1e-5 * load)
    near(f"{where}: force x", tangential[0], float(row["force_x_N"]), 1e-5 * load)
    near(f"{where}: force y", tangential[1], float(row["force_y_N"]), 1e-5 * load)
    _, at = np.unique(f["points"], axis=0, return_index=True)
    nodes = {name: values[at] for name, values in f.items()}
    # Of a run in time the slip is not all of that in the law
    if int(row.get("contact_nodes", 0)) == len(at):
        check_states(nodes, scene.mu, scene.node_by_node, where)
        near(f"{where}: sum of p area", nodes["pressure"] @ nodes["area"], load, 1e-5 * load)
        report(
            f"{where}: nodes in contact",
            (nodes["state"] != OPEN).sum() == int(row["nodes_in_contact"]),
        )
    return len(at)


def check_stresses(f, dim, where):
    """von Mises stress again from the components."""
    xx, yy, zz, xz = (f["stress_" + c] for c in ("xx", "yy", "zz", "xz"))
    shear = xz**2 + (f["stress_xy"] ** 2 + f["stress_yz"] ** 2 if dim == 3 else 0)
    again = np.sqrt(((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) / 2 + 3 * shear)
    report(f"{where}: von Mises >= 0", (f["von_mises"] >= 0).all())
    report(
        f"{where}: von Mises of the components",
        np.allclose(f["von_mises"], again, rtol=1e-5, atol=1e-5 * again.max()),
    )


def check_nodes(f, where):
    """Each element brings its nodes; they have the values of the others there."""
    _, first, copies = np.unique(f["points"], axis=0, return_index=True, return_inverse=True)
    report(f"{where}: errors of the stress >= 0", (f["stress_error"] >= 0).all())
    report(f"{where}: several elements at a node", 2 * len(first) < len(copies))
    for name in ("stress_xx", "stress_zz", "stress_xz", "stress_error"):
        apart = np.abs(f[name] - f[name][first][copies.ravel()]).max()  # ranks round
        report(f"{where}: one {name} at a node", apart <= 4 * SINGLE * np.abs(f[name]).max())


def lowest_height(f, dim, side):
    """Of the deformed surface next to the other body, at x = y = 0, by its nearest point."""
    up = dim - 1
    surface = side * f["points"][:, up] < 1e-6
    distance = np.linalg.norm(f["points"][:, :up], axis=1) + (~surface) * 1e3
    at = distance.argmin()
    return f["points"][at, up] + f["displacement"][at, up]


def check_bodies(reader, scene, time, row, where):
    blocks = named_blocks(reader, time)
    report(f"{where}: blocks {list(blocks)}", list(blocks) == scene.bodies)
    arrays = dict(ARRAYS["bodies.pvd"])
    if scene.dim == 3:
        arrays.update({"stress_xy": 1, "stress_yz": 1})
    heights = []
    for name, data_sets in blocks.items():
        f = fields(data_sets, arrays, f"{where}, {name}")
        check_stresses(f, scene.dim, f"{where}, {name}")
        check_nodes(f, f"{where}, {name}")
        z = f["points"][:, scene.dim - 1]
        side = 1 if name == "wheel" else -1
        report(f"{where}: {name} on its side", (side * z >= -1e-6).all())
        heights.append(lowest_height(f, scene.dim, side))
        top = f["von_mises"].max()
        pressure = float(row["max_pressure_Pa"])
        if pressure > 0:
            report(f"{where}: {name}: von Mises / p0", 0.3 < top / pressure < 1.2)
    if "half_width_x_m" in row:  # at rest
        check_forces(reader, scene, row, where)
    if len(heights) == 2 and float(row["normal_force_N"]) > 0:
        near(f"{where}: the bodies touch, m", heights[0], heights[1], 1e-7)


def check_forces(reader, scene, row, where):
    """Of the stress in each body along a plane at the depth of the half-width."""
    load, depth = float(row["normal_force_N"]), float(row["half_width_x_m"])
    up, tolerance = scene.dim - 1, (0.02 if scene.dim == 2 else 0.1) * load
    for body in scene.bodies:
        cut = pv.Slice(Input=reader)
        cut.SliceType.Normal = normal = np.eye(3)[up]
        cut.SliceType.Origin = depth * normal * (1 if body == "wheel" else -1)
        total = servermanager.Fetch(pv.IntegrateVariables(Input=cut)).GetPointData()
        for stress, force in (("stress_zz", load), ("stress_xz", float(row["force_x_N"]))) + (
            (("stress_yz", float(row["force_y_N"])),) if scene.dim == 3 else ()
        ):
            through = total.GetArray(stress).GetTuple(0)[0] * scene.width
            near(f"{where}: {body}: force of {stress}", through, -force, tolerance)


def rows_at_times(folder, times):
    """The row of a table for each time of the fields."""
    rows = table(os.path.join(folder, "results.csv"))
    if not os.path.isfile(os.path.join(folder, "history.csv")):
        report(f"{folder}: one time, 0", list(times) == [0])
        return rows[-1:]
    history = table(os.path.join(folder, "history.csv"))
    at = {float(row["time_s"]): row for row in history}
    report(f"{folder}: several times", len(times) > 2)
    report(f"{folder}: times of the history", all(time in at for time in times))
    report(f"{folder}: last time", times[-1] == max(at))
    return [at[time] for time in times]


def check_run(folder):
    scene = Scene(folder)
    rows = None
    for name, check in (("interface.pvd", check_interface), ("bodies.pvd", check_bodies)):
        path = os.path.join(folder, name)
        report(f"{path}: written if asked for", os.path.isfile(path) == scene.has_fields[name])
        if not os.path.isfile(path):
            continue
        reader = pv.PVDReader(FileName=path)
        reader.UpdatePipelineInformation()
        times = list(reader.TimestepValues)
        rows = rows or rows_at_times(folder, times)
        for time, row in zip(times, rows):
            check(reader, scene, time, row, f"{path} at {time:g} s")
    if not any(scene.has_fields.values()):
        report(f"{folder}: several rows", len(table(os.path.join(folder, "results.csv"))) > 2)


for run_folder in sys.argv[1:]:
    check_run(run_folder)
sys.exit(failures > 0)
