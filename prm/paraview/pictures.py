"""Pictures of a run, drawn by ParaView 5.11 or newer.

    pvpython prm/paraview/pictures.py RUN_FOLDER [--steps]

writes PNG files to RUN_FOLDER/pictures: von_mises, in 2D tractions, in 3D
patch_state and pressure_and_traction; with friction sliding, and where friction
falls with the sliding speed friction. Of a run in time they show the last step
with contact, with --steps every one. If it cannot: a message and exit code 1.

    RUN=RUN_FOLDER paraview --script=prm/paraview/pictures.py

opens the same views in ParaView's window, a tab each, to be played and probed;
so does Tools > Python Shell > Run Script once a .pvd file of the run is open.

The files hold m and Pa, the pictures show mm and MPa.
"""
import csv
import os
import re
import sys
import xml.etree.ElementTree as Xml

import paraview.simple as pv
from paraview.vtk.vtkRenderingCore import vtkRenderWindow

SIZE = [1200, 800]
ARROWS = 26  # along x
BLACK, DARK, LIGHT, WHITE = [0, 0, 0], [0.45] * 3, [0.82] * 3, [1, 1, 1]
BLUE, ORANGE = [0, 0.45, 0.70], [0.90, 0.62, 0]
STATES = {0: ("open", LIGHT), 1: ("slip", ORANGE), 2: ("stick", BLUE)}
PLACES = {"wheel": "above", "rail": "below"}
# White to red, light enough for black arrows
PRESSURES = [WHITE, [0.99, 0.83, 0.62], [0.99, 0.55, 0.35], [0.84, 0.19, 0.12]]


class RunError(Exception):
    """A message for the user."""


class Run:
    """Its fields; a reader is None if that file was not asked for."""

    def __init__(self, folder):
        check_record(folder)
        self.name = os.path.basename(os.path.abspath(folder))
        with open(os.path.join(folder, "used.prm"), encoding="utf-8") as file:
            scene = file.read()
        self.is_3d = re.search(r"^set Dimension *= *3", scene, re.M) is not None
        self.flow = "material flows to the " + (
            "left" if contact_entry(scene, "Speed", "").startswith("-") else "right"
        )
        self.mu = float(contact_entry(scene, "Friction coefficient", "0.3"))
        self.rows = read_rows(folder)
        arrays = ["pressure", "traction", "traction_bound", "state"]
        self.interface = open_fields(folder, "interface.pvd", arrays)
        self.bodies = open_fields(folder, "bodies.pvd", ["displacement", "von_mises"])
        self.shown = self.interface or self.bodies
        if self.shown is None:
            raise RunError(
                f"{folder} has no fields. A creep curve has none, its picture is creep_curve.svg; "
                "other scenes write them with Output/Interface fields and Body fields = true."
            )
        self.times = list(self.shown.TimestepValues)
        self.texts = []  # that tell the facts, one in each view
        fields = self.interface.PointData.keys() if self.interface else []
        self.falls = "sliding_speed" in fields
        bounds = [1000 * bound for bound in self.shown.GetDataInformation().GetBounds()]
        # Where contact is looked for, in mm; if that is not known a part of the bodies
        self.zone = bounds[:4] if self.interface else [bound / 40 for bound in bounds[:4]]

    def last_contact(self):
        """The last time if there never is contact."""
        if self.interface:
            for time in reversed(self.times):
                if largest(self.interface, "state", [time]) > 0:
                    return time
        return self.times[-1]

    def facts(self, time):
        """Load, friction and creepages of the state at a time."""
        if not self.rows:
            return ""
        in_time = "time_s" in self.rows[0]
        row = min(self.rows, key=lambda row: abs(float(row["time_s"]) - time if in_time else 0))
        if not row["normal_force_N"]:
            return "not converged"
        parts = [f"N = {float(row['normal_force_N']) / 1e3:.4g} kN"]
        if self.mu > 0:
            parts.append(("\u03bc_s" if self.falls else "\u03bc") + f" = {self.mu:.4g}")
            for name, label, factor, unit in (
                ("creepage_x", "creepage x", 100, " %"),
                ("creepage_y", "creepage y", 100, " %"),
                ("spin_1/m", "spin", 1, "/m"),
            ):
                if float(row[name]) != 0:
                    parts.append(f"{label} {factor * float(row[name]):.4g}{unit}")
        at_time = f"t = {time:.4g} s: " if len(self.times) > 1 else ""
        return (at_time + ", ".join(parts)).replace("-", "\u2212")

    def tell_facts(self, time):
        """In all views there are."""
        for show in self.texts:
            show(self.facts(time))


def contact_entry(scene, name, default):
    """Of section Contact in the text of used.prm, which leaves out defaults."""
    section = re.search(r"^subsection Contact$(.*?)^end", scene, re.S | re.M)
    entry = section and re.search(rf"^ *set {name} *= *(\S+)", section.group(1), re.M)
    return entry.group(1) if entry else default


def read_rows(folder):
    """Of history.csv, else the last of results.csv."""
    for name in ("history.csv", "results.csv"):
        path = os.path.join(folder, name)
        if os.path.isfile(path):
            with open(path, encoding="utf-8", newline="") as file:
                rows = list(csv.DictReader(file))
            return rows if name == "history.csv" else rows[-1:]
    return []


def check_record(folder):
    """Every run has a run.json."""
    try:
        with open(os.path.join(folder, "run.json"), encoding="utf-8") as file:
            program = re.search(r'"program": "(.*)"', file.read())
    except (FileNotFoundError, NotADirectoryError):
        program = None
    if program is None or program.group(1) != "rolling-contact":
        raise RunError(f"{folder} is not the folder of a run: no run.json of rolling-contact.")


def open_fields(folder, name, arrays):
    path = os.path.join(folder, name)
    if not os.path.isfile(path):
        return None
    for block in Xml.parse(path).iter("DataSet"):
        if not os.path.isfile(os.path.join(folder, block.get("file"))):
            raise RunError(f"{folder} has no {block.get('file')}. Run the scene again.")
    reader = pv.PVDReader(registrationName=name, FileName=path)
    reader.UpdatePipeline()
    missing = [array for array in arrays if array not in reader.PointData.keys()]
    if missing:
        raise RunError(f"{path} has no {', '.join(missing)}: run the scene again.")
    return reader


def calculate(source, name, function, **properties):
    return pv.Calculator(
        registrationName=name, Input=source, ResultArrayName=name, Function=function, **properties
    )


def in_mm(source, points):
    """Moves the points to @p points, in m."""
    return calculate(source, "mm", f"1000*({points})", CoordinateResults=1)


def in_mpa(source, name, stress):
    return calculate(source, name, f"{stress}/1e6")


def flat_patch(run):
    """The contact surface without its height, in mm."""
    merged = pv.MergeBlocks(registrationName="patch", Input=run.interface)
    return in_mm(merged, "coordsX*iHat" + (" + coordsY*jHat" if run.is_3d else ""))


def grid_over(run, n_along_x):
    left, right, low, high = run.zone
    grid = pv.Plane(registrationName="grid", Origin=[left, low, 0])
    grid.Point1, grid.Point2 = [right, low, 0], [left, high, 0]
    grid.XResolution = n_along_x
    grid.YResolution = max(1, round(n_along_x * (high - low) / (right - left)))
    return grid


def largest(source, array, times):
    """Largest magnitude at any time; 0 if there are no values."""
    top = 0
    for time in times:
        source.UpdatePipeline(time)
        values = source.PointData[array]
        top = max(top, values.GetRange(-1)[1] if values else 0)
    return top


def new_view(kind, title):
    """In a tab of its own."""
    layout = pv.CreateLayout(title)
    view = pv.CreateView(kind)
    pv.AssignViewToLayout(view=view, layout=layout)
    view.ViewSize = SIZE
    pv.SetActiveView(view)
    return view


def write_text(source, view, where, size, bold=0):
    text = pv.Show(source, view)
    text.WindowLocation, text.FontSize, text.Bold, text.Color = where, size, bold, BLACK


def flat_view(run, title, remark, zone, up="y"):
    """@p zone, in mm, x to the right and @p up, with axes, title and remark."""
    view = new_view("RenderView", title)
    view.UseColorPaletteForBackground, view.Background = 0, WHITE
    view.OrientationAxesVisibility = 0
    view.InteractionMode, view.CameraParallelProjection = "2D", 1
    text = pv.Text(registrationName=title, Text=f"{run.name}: {title}")
    write_text(text, view, "Upper Center", 28, bold=1)
    facts = pv.Text(registrationName="facts")

    def show_facts(text):
        facts.Text = text + "\n" + remark

    run.texts.append(show_facts)
    write_text(facts, view, "Lower Center", 20)
    if len(run.times) > 1:
        time = pv.AnnotateTimeFilter(Input=run.shown, Format="{time:.4g} s")
        write_text(time, view, "Upper Right Corner", 24)
    draw_axes(view.AxesGrid, zone, up)
    look(view, zone, up)
    return view


def draw_axes(grid, zone, up):
    """Before what is drawn."""
    before = (zone[1] - zone[0]) / 2
    grid.Visibility = grid.UseCustomBounds = 1
    third = [before] * 2 if up == "y" else [-before] * 2
    grid.CustomBounds = [*zone, *third] if up == "y" else [*zone[:2], *third, *zone[2:]]
    grid.AxesToLabel = 7  # those at the left and below
    grid.GridColor = BLACK
    for axis in "XYZ":
        setattr(grid, f"{axis}Title", f"{axis.lower()} (mm)")
        for part, size in (("Title", 24), ("Label", 20)):
            setattr(grid, f"{axis}{part}Color", BLACK)
            setattr(grid, f"{axis}{part}FontSize", size)


def look(view, zone, up):
    """Leaves room for axes, texts and, at the right, the colours."""
    width, height = zone[1] - zone[0], zone[3] - zone[2]
    half_height = max(0.66 * height, 0.72 * width * SIZE[1] / SIZE[0])
    x, y = zone[0] + 0.57 * width, zone[2] + 0.46 * height
    view.CameraParallelScale = half_height
    view.CameraFocalPoint = [x, y, 0] if up == "y" else [x, 0, y]
    view.CameraPosition = [x, y, 100 * half_height] if up == "y" else [x, -100 * half_height, y]
    view.CameraViewUp = [0, 1, 0] if up == "y" else [0, 0, 1]


def paint(source, view, array, title, colours):
    """Colours without shading, explained at the right."""
    surface = pv.Show(source, view)
    surface.Representation = "Surface"
    surface.ColorArrayName, surface.LookupTable = ["POINTS", array], colours
    surface.Ambient, surface.Diffuse, surface.Specular = 1, 0, 0
    bar = pv.GetScalarBar(colours, view)
    bar.Visibility = 1
    bar.Title, bar.ComponentTitle, bar.HorizontalTitle = title, "", 1
    bar.TitleColor = bar.LabelColor = BLACK
    bar.TitleFontSize, bar.LabelFontSize = 24, 22
    bar.AutomaticLabelFormat, bar.LabelFormat, bar.RangeLabelFormat = 0, "%.4g", "%.4g"
    bar.WindowLocation, bar.Orientation, bar.Position = "Any Location", "Vertical", [0.86, 0.25]
    bar.ScalarBarLength, bar.ScalarBarThickness = 0.5, 24
    return bar


def draw_black(source, view, representation, opacity=1):
    display = pv.Show(source, view)
    display.Representation = representation
    display.ColorArrayName = ["POINTS", ""]
    display.AmbientColor = display.DiffuseColor = BLACK
    display.Specular, display.Opacity = 0, opacity


def colours_up_to(array, top, colours=None):
    """Evenly from 0 to @p top: those given, else viridis."""
    table = pv.GetColorTransferFunction(array)
    table.AutomaticRescaleRangeMode = "Never"
    if colours is None:
        table.ApplyPreset("Viridis (matplotlib)", True)
    else:
        table.ColorSpace = "RGB"
        table.RGBPoints = [part for i, colour in enumerate(colours) for part in (i, *colour)]
    table.NumberOfTableValues = 64
    table.RescaleTransferFunction(0, top or 1)
    return table


def show_states(run):
    """Every place has the state of the nearest node."""
    view = flat_view(run, "state of the patch", run.flow, run.zone)
    patch = flat_patch(run)
    nearest = pv.PointDatasetInterpolator(Input=patch, Source=grid_over(run, 400))
    nearest.Kernel = "VoronoiKernel"
    colours = pv.GetColorTransferFunction("state")
    colours.InterpretValuesAsCategories = colours.AnnotationsInitialized = 1
    colours.Annotations = [word for i, (name, _) in STATES.items() for word in (str(i), name)]
    colours.IndexedColors = [part for _, colour in STATES.values() for part in colour]
    bar = paint(nearest, view, "state", "State", colours)
    bar.TextPosition = "Ticks left/bottom, annotations right/top"
    draw_black(patch, view, "Wireframe", opacity=0.2)
    return view


def show_pressure(run):
    """Traction as arrows on a regular grid, bilinear between nodes."""
    top = largest(run.interface, "traction", run.times)
    remark = f"longest arrow {top / 1e6:.3g} MPa, {run.flow}" if top else "no traction"
    view = flat_view(run, "pressure, and traction on the wheel", remark, run.zone)
    patch = in_mpa(flat_patch(run), "p_MPa", "pressure")
    colours = colours_up_to("p_MPa", largest(patch, "p_MPa", run.times), PRESSURES)
    paint(patch, view, "p_MPa", "Pressure\n(MPa)", colours)
    if not top:
        return view
    grid = grid_over(run, ARROWS)
    places = pv.ResampleWithDataset(SourceDataArrays=patch, DestinationMesh=grid)
    arrows = pv.Glyph(registrationName="traction", Input=places, GlyphType="Arrow")
    arrows.GlyphMode = "All Points"
    arrows.OrientationArray = arrows.ScaleArray = ["POINTS", "traction"]
    arrows.ScaleFactor = 1.5 * (run.zone[1] - run.zone[0]) / ARROWS / top
    arrows.GlyphType.TipLength, arrows.GlyphType.TipRadius = 0.4, 0.15
    arrows.GlyphType.ShaftRadius = 0.045
    draw_black(arrows, view, "Surface")
    return view


def plot(source, view, curves):
    """Curves by name: colour, line and mark, as ParaView counts them."""
    chart = pv.Show(source, view, "XYChartRepresentation")
    chart.UseIndexForXAxis, chart.XArrayName = 0, "x"
    chart.SeriesVisibility = list(curves)
    look = {"Label": [], "Color": [], "LineStyle": [], "MarkerStyle": [], "MarkerSize": []}
    for name, (colour, line, mark) in curves.items():
        for series, value in zip(look.values(), ([name], map(str, colour), [line], [mark], ["10"])):
            series.extend([name, *value])
    for series, values in look.items():
        setattr(chart, f"Series{series}", values)


def chart_view(run, title, y_title):
    """A chart over x."""
    view = new_view("XYChartView", title)
    view.ChartTitle = f"{run.name}: {title}" + (" at {time:.4g} s" if len(run.times) > 1 else "")
    view.ChartTitleFontSize, view.ChartTitleBold, view.LegendFontSize = 28, 1, 22
    view.LeftAxisTitle = y_title
    view.LeftAxisTitleFontSize = view.BottomAxisTitleFontSize = 22
    view.LeftAxisTitleBold = view.BottomAxisTitleBold = 0
    view.LeftAxisLabelFontSize = view.BottomAxisLabelFontSize = 20

    def show_facts(text):
        view.BottomAxisTitle = f"x (mm), {run.flow}\n{text}"

    run.texts.append(show_facts)
    return view


def sliding_of(run):
    """The sliding speed where friction depends on it, else the slip: array, title, function."""
    if run.falls:
        return "v", "sliding speed (m/s)", "sliding_speed"
    return "s", "slip (%)", "100*mag(slip)"


def touching(nodes):
    """Where there is pressure."""
    inside = pv.Threshold(registrationName="touching", Input=nodes, Scalars=["POINTS", "pressure"])
    inside.ThresholdMethod, inside.UpperThreshold = "Above Upper Threshold", 1e-9
    return inside


def show_map(run, array, title, function, from_zero=True):
    """3D: a nodal value over the patch, colours from 0 or its least to its largest."""
    view = flat_view(run, re.sub(r" \(.*", "", title), run.flow, run.zone)
    patch = calculate(flat_patch(run), array, f"if(pressure > 0, {function}, 0)")
    colours = colours_up_to(array, largest(patch, array, run.times))
    if not from_zero:
        inside = touching(patch)
        inside.UpdatePipeline(run.last_contact())
        colours.RescaleTransferFunction(*inside.PointData[array].GetRange())
        draw_black(patch, view, "Wireframe", opacity=0.1)
        patch = inside
    paint(patch, view, array, title.replace(" ", "\n"), colours)
    return view


def show_line(run, array, title, function):
    """2D: a nodal value of the nodes that touch, along x."""
    view = chart_view(run, re.sub(r" \(.*", "", title), title)
    nodes = calculate(flat_patch(run), "x", "coordsX")
    nodes = calculate(nodes, array, function)
    single = pv.ConvertToPointCloud(Input=nodes, CellGenerationMode="Vertex cells")
    nodes = touching(single)
    plot(nodes, view, {array: (BLUE, "0", "4")})
    view.ShowLegend = 0
    view.LeftAxisUseCustomRange, view.LeftAxisRangeMinimum = 1, 0
    view.LeftAxisRangeMaximum = 1.1 * largest(nodes, array, run.times) or 1
    return view


def show_sliding(run):
    show = show_map if run.is_3d else show_line
    return show(run, *sliding_of(run))


def show_friction(run):
    mu = ("mu", "friction coefficient (1)", "friction_coefficient")
    return show_map(run, *mu, from_zero=False) if run.is_3d else show_line(run, *mu)


def show_tractions(run):
    """2D: stresses along x; the marks of the traction tell the state."""
    view = chart_view(run, "tractions", "stress (MPa)")
    nodes = calculate(flat_patch(run), "x", "coordsX")
    for name, stress in {"p": "pressure", "\u03bcp": "traction_bound",
                         "\u2212\u03bcp": "-traction_bound", "q": "traction_X"}.items():
        nodes = in_mpa(nodes, name, stress)
    solid, dashed, none, dot = "1", "2", "0", "4"
    bound = (DARK, dashed, none)
    plot(nodes, view, {"p": (BLACK, solid, none), "\u03bcp": bound, "\u2212\u03bcp": bound})
    single = pv.ConvertToPointCloud(Input=nodes, CellGenerationMode="Vertex cells")
    for state, (name, colour) in STATES.items():
        these = pv.Threshold(registrationName=name, Input=single, Scalars=["POINTS", "state"])
        these.LowerThreshold = these.UpperThreshold = state
        plot(calculate(these, f"q, {name}", "q"), view, {f"q, {name}": (colour, none, dot)})
    highest = largest(nodes, "p", run.times) or 1
    view.LeftAxisUseCustomRange, view.LeftAxisRangeMaximum = 1, 1.1 * highest
    view.LeftAxisRangeMinimum = -max(1.1 * largest(nodes, "\u03bcp", run.times), 0.1 * highest)
    return view


def show_von_mises(run):
    """Near the contact, in 3D cut along the flow."""
    bodies = {block.get("name") for block in Xml.parse(run.bodies.FileName).iter("DataSet")}
    half = run.zone[1] - run.zone[0]
    high = 0.75 * half
    places = [f"{body} {place}" for body, place in PLACES.items() if body in bodies]
    remark = f"{' and '.join(places)}, deformation to scale, {run.flow}"
    zone = [-half, half, -high, high]
    view = flat_view(run, "von Mises stress", remark, zone, up="z" if run.is_3d else "y")
    # each element brings nodes of its own; wheel and rail stay apart
    shown = pv.CleantoGrid(Input=run.bodies)
    shown = pv.MergeBlocks(registrationName="bodies", Input=shown, MergePoints=0)
    if run.is_3d:
        shown = pv.Slice(registrationName="along the flow", Input=shown)
        shown.SliceType.Normal = [0, 1, 0]
        shown.SliceType.Origin = [0, 1e-6 * half, 0]  # not between two elements
    else:
        view.AxesGrid.YTitle = "z (mm)"
    shown = in_mpa(in_mm(shown, "coords + displacement"), "von_Mises_MPa", "von_mises")
    shown = pv.Clip(registrationName="near the contact", Input=shown, ClipType="Box", Exact=1)
    shown.ClipType.Position = [-half, -high, -high]
    shown.ClipType.Length = [2 * half, 2 * high, 2 * high]
    colours = colours_up_to("von_Mises_MPa", largest(shown, "von_Mises_MPa", run.times))
    paint(shown, view, "von_Mises_MPa", "von Mises\n(MPa)", colours)
    return view


def views_of(run):
    """By name; one at a time, as another view spoils the texts of a chart that is saved."""
    if run.interface and run.is_3d:
        yield "patch_state", show_states(run)
        yield "pressure_and_traction", show_pressure(run)
    elif run.interface:
        yield "tractions", show_tractions(run)
    if run.interface and run.mu > 0:
        yield "sliding", show_sliding(run)
    if run.falls:
        yield "friction", show_friction(run)
    if run.bodies:
        yield "von_mises", show_von_mises(run)


def go_to(time):
    scene = pv.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    scene.AnimationTime = time


def save(run, folder, every_step):
    os.makedirs(folder, exist_ok=True)
    steps = list(enumerate(run.times, start=1)) if every_step else [(0, run.last_contact())]
    for name, view in views_of(run):
        for step, time in steps:
            go_to(time)
            run.tell_facts(time)
            picture = os.path.join(folder, f"{name}-{step:04d}.png" if step else f"{name}.png")
            pv.SaveScreenshot(picture, view, ImageResolution=SIZE, CompressionLevel="9")
            print(picture)


def folder_in_window():
    """RUN or that of what is open."""
    source = pv.GetActiveSource()
    folder = os.environ.get("RUN") or os.path.dirname(getattr(source, "FileName", ""))
    if not folder:
        raise RunError("open bodies.pvd or interface.pvd of a run first, or set RUN to its folder.")
    return folder


def save_from(arguments):
    folders = [argument for argument in arguments if argument != "--steps"]
    if len(folders) != 1 or folders[0].startswith("-"):
        raise RunError("usage: pvpython prm/paraview/pictures.py RUN_FOLDER [--steps]")
    # Debian's ParaView would end with a stack trace
    if vtkRenderWindow().GetClassName() == "vtkXOpenGLRenderWindow" and "DISPLAY" not in os.environ:
        raise RunError("ParaView draws only on a display; xvfb-run -a -s -noreset gives one.")
    save(Run(folders[0]), os.path.join(folders[0], "pictures"), "--steps" in arguments)


in_window = not sys.argv[0]
try:
    if in_window:
        run = Run(folder_in_window())
        for _, view in views_of(run):
            pv.Render(view)
        pv.SetActiveSource(run.shown)
        go_to(run.last_contact())
        run.tell_facts(run.last_contact())
    else:
        save_from(sys.argv[1:])
except (RunError, OSError, Xml.ParseError) as error:
    print(f"pictures.py: {error}", file=sys.stderr)
    if not in_window:
        sys.exit(1)
