"""Curves of pictures, as their .dat files have them, against the tables of the run that drew them.

Usage: charts.py KIND RUN_FOLDER [BODY], KIND one of the functions at the end of this file."""
import csv
import math
import sys

kind, folder = sys.argv[1:3]
failures = []


def check(what, good, *more):
    if not good:
        failures.append(what)
        if len(failures) < 10:
            print("FAILED:", what, *more)


def near(what, value, expected, relative=1e-6, absolute=1e-12):
    check(what, abs(value - expected) <= relative * abs(expected) + absolute, value, "expected", expected)


def table(name):
    with open(f"{folder}/{name}", newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def charts(name):
    """Label, names of the columns and points of each curve."""
    with open(f"{folder}/{name}.dat", encoding="utf-8") as file:
        blocks = file.read().strip("\n").split("\n\n\n")
    for block in blocks:
        lines = [line for line in block.split("\n") if line]
        *_, label, columns = [line[1:].strip() for line in lines if line.startswith("#")]
        yield label, columns.split("\t"), [tuple(map(float, line.split())) for line in lines if line[0] != "#"]


def same_points(what, points, expected, relative=1e-6):
    check(f"{what}: number of points", len(points) == len(expected), len(points), len(expected))
    for point, wanted in zip(points, expected):
        for value, right in zip(point, wanted):
            if not (math.isnan(value) and math.isnan(right)):
                near(what, value, right, relative)


def number(text):
    return float(text) if text else math.nan


def receptances(body):
    """Sizes, and below them phases in degrees in the same order."""
    rows = [row for row in table("receptances.csv") if row["body"] == body]
    curves = list(charts(f"receptances_{body}"))
    sizes = [(label, points) for label, columns, points in curves
             if columns == ["frequency (Hz)", "receptance (m/N)"]]
    phases = [points for _, columns, points in curves if columns == ["frequency (Hz)", "phase (\u00b0)"]]
    check("sizes and phases", 0 < len(sizes) == len(phases) and len(curves) == 2 * len(sizes))
    for (label, size), phase in zip(sizes, phases):
        motion, force = (part.split() for part in label.split(" / "))
        alpha = [(float(row["frequency_Hz"]), complex(float(row["real_m/N"]), float(row["imaginary_m/N"])))
                 for row in rows if [row["motion_at"], row["motion_along"]] == motion
                 and [row["force_at"], row["force_along"]] == force]
        same_points(label, size, [(f, abs(a)) for f, a in alpha])
        same_points(f"phase of {label}", phase, [(f, math.degrees(math.atan2(a.imag, a.real))) for f, a in alpha],
                    1e-5)


def track_decay():
    """A curve for each column of rates that is not empty."""
    rows = table("track_decay.csv")
    label = {"decay": "{}", "wave": "least of its {} waves", "limit": "ISO 3095, {}, at least"}
    curves = {label: points for label, _, points in charts("track_decay")}
    for column in list(rows[0])[1:]:
        what, direction, _ = column.replace("_dB", " dB").replace("_", " ").split()
        values = [(float(row["third_octave_Hz"]), number(row[column])) for row in rows]
        if all(math.isnan(rate) for _, rate in values):
            check(f"no curve of {column}", label[what].format(direction) not in curves)
        else:
            same_points(column, curves.pop(label[what].format(direction), []), values)
    check("no other curves", not curves, curves)


def stability():
    """Growth over frequency: what grows, what decays, names and the line of no growth."""
    rows = table("stability.csv")
    curves = [(label, points) for label, columns, points in charts("stability")
              if columns == ["frequency (kHz)", "growth (1/s)"]]

    def point(row):
        return float(row["frequency_Hz"]) / 1000, float(row["corrected_growth_1/s"] or row["growth_1/s"])

    grow, decay = ([points for label, points in curves if label == name][0] for name in ("grow", "decay"))
    unstable = [point(row) for row in rows if row["unstable"] == "true"]
    check("some grow", unstable and all(growth > 0 for _, growth in unstable))
    same_points("grow", grow, unstable)
    check("no other grows", all(growth <= 0 for _, growth in decay))
    for row in rows:
        if row["unstable"] != "true":
            check("a vibration that decays, once",
                  sum(abs(f / point(row)[0] - 1) < 1e-6 and abs(g / point(row)[1] - 1) < 1e-6
                      for f, g in decay) == 1, row)
    check("zero", any(len(points) == 2 and all(growth == 0 for _, growth in points) for _, points in curves))
    named = {label: points[0] for label, points in curves if len(points) == 1 and label not in ("grow", "decay")}
    for row in rows:
        name = row["wheel_mode_name"]
        check("a name", name in named, row)
        check("its place", any(row["wheel_mode_name"] == name and point(row)[0] and
                               abs(named[name][0] / point(row)[0] - 1) < 1e-6 and
                               abs(named[name][1] / point(row)[1] - 1) < 1e-6 for row in rows), name)


def modes(body):
    """Frequencies over nodal diameters by what has most of the energy."""
    families = {"mostly axial": [], "mostly radial": [], "mostly circumferential": []}
    for row in table("modes.csv"):
        if row["body"] == body and row["nodal_diameters"]:
            share = {name: float(row[f"{name[7:]}_share"]) for name in families}
            families[max(share, key=share.get)].append((float(row["nodal_diameters"]),
                                                        float(row["frequency_Hz"]) / 1000))
    curves = list(charts(f"modes_{body}"))
    check("families", [label for label, _, _ in curves] == sorted(n for n in families if families[n]))
    for label, columns, points in curves:
        check("axes", columns == ["nodal diameters", "frequency (kHz)"], columns)
        same_points(label, points, families[label])


def contact_table():
    """Places of first contact on the rail, the gap of 0 there, radii and conicities in mm."""
    rows = table("contact_table.csv")
    curves = list(charts("contact_points"))
    shifts = [1e3 * float(row["lateral_shift_m"]) for row in rows]
    same_points("first contacts", curves[-1][2], [(1e3 * float(row["right_y_track_m"]),
                                                   -1e3 * float(row["right_z_track_m"])) for row in rows])
    check("the wheel of the picture", curves[1][0] == "wheel, shifted by 0 mm", curves[1][0])
    # rail and wheel of the picture meet where the row without shift says
    row = min(rows, key=lambda row: abs(float(row["lateral_shift_m"])))
    at = 1e3 * float(row["right_y_track_m"]), -1e3 * float(row["right_z_track_m"])
    for label, _, points in curves[:2]:
        distance = min(math.dist(at, point) for point in points)
        check(f"{label} at the contact", distance < 0.1, distance)
    (_, columns, gaps), = charts("gaps")
    check("axes of the gaps", columns[:2] == ["y on the wheel's profile (mm)", "lateral shift (mm)"], columns)
    for row, shift in zip(rows, shifts):
        line = [(gap, y) for y, s, gap in gaps if abs(s - shift) < 1e-6 and not math.isnan(gap)]
        check("no gap below 0", all(-1e-3 < gap <= 1.0001 for gap, _ in line), shift)
        place = 1e3 * float(row["right_y_wheel_m"])
        check("no gap at the contact", min(gap for gap, y in line if abs(y - place) < 1.0) < 0.02, shift, place)
    radii, harmonic, equivalent = charts("steering")
    check("radii", radii[1] == ["lateral shift, amplitude (mm)", "r right \u2212 r left (mm)"], radii[1])
    same_points("radii", radii[2], [(s, 1e3 * (float(row["right_rolling_radius_m"]) -
                                               float(row["left_rolling_radius_m"])))
                                    for row, s in zip(rows, shifts)], 1e-4)
    for (label, columns, points), column in ((harmonic, "conicity_harmonic"), (equivalent, "conicity_en_15302")):
        check("conicity", columns[1] == "conicity" and column.startswith("conicity_" + label.split()[0].lower()))
        same_points(label, points, [(s, number(row[column])) for row, s in zip(rows, shifts)], 1e-5)


def profiles():
    """Peak pressure in MPa and heat in kJ/m^2 of the lines of nodes, over their place in mm."""
    rows, curves = table("across.csv"), {label: (columns, points) for label, columns, points in charts("profiles")}
    for label, axis, column, factor in (
            ("peak pressure along x", "max p (MPa)", "max_pressure_Pa", 1e-6),
            ("heat of friction, per metre rolled and metre across", "heat (kJ/m\u00b2)", "dissipation_J/m2", 1e-3)):
        columns, points = curves[label]
        check("axis", columns[1] == axis, columns)
        touching = [point for point in points if point[1] != 0]
        same_points(label, touching, [(1e3 * float(row["y_m"]), factor * float(row[column])) for row in rows], 1e-5)


def patch_3d():
    """Arrows of nodes that stick and slip by nodes.csv, whose sums are the forces; |q| and mu p along both lines."""
    nodes, (row,) = table("nodes.csv"), table("results.csv")
    values = [{name: number(text) for name, text in node.items()} for node in nodes]
    for column, of in (("pressure_Pa", "normal_force_N"), ("traction_x_Pa", "force_x_N"), ("traction_y_Pa", "force_y_N")):
        near(f"sum of {column}", sum(node["area_m2"] * node[column] for node in values), number(row[of]), 1e-6)
    check("nodes that touch", sum(node["state"] > 0 for node in values) == int(row["nodes_in_contact"]))
    curves = list(charts("patch"))
    check("axes", curves[0][1][0].startswith("x along the rail (mm), material flows to the ") and
          curves[0][1][1] == "y across (mm)", curves[0][1])
    largest = max(math.hypot(node["recovered_traction_x_Pa"], node["recovered_traction_y_Pa"]) for node in values)
    arrows = {label: points for label, _, points in curves if label.startswith("q, ")}
    longest = max(math.hypot(point[2], point[3]) for points in arrows.values() for point in points)
    for label, state in (("q, sticks", 2), ("q, slides", 1)):
        same_points(label, arrows.get(label, []),
                    [(1e3 * node["x_m"], 1e3 * node["y_m"], *(longest / largest * node[f"recovered_traction_{c}_Pa"] for c in "xy"))
                     for node in values if node["state"] == state], 1e-5)
    peak = max(values, key=lambda node: node["recovered_pressure_Pa"])
    for label, size in (("|q|", lambda node: math.hypot(node["recovered_traction_x_Pa"], node["recovered_traction_y_Pa"])),
                        ("\u03bcp", lambda node: 0.3 * node["recovered_pressure_Pa"])):
        lines = [(columns, points) for name, columns, points in curves if name == label]
        for (columns, points), along, across in zip(lines, "xy", "yx"):
            check("axes of lines", columns == [("x along the rail (mm)", "y across (mm)")[along == "y"], "|q|, \u03bcp (MPa)"], columns)
            on_line = sorted((node for node in values if abs(node[f"{across}_m"] - peak[f"{across}_m"]) < 1e-9),
                             key=lambda node: node[f"{along}_m"])
            same_points(f"{label} along {along}", points, [(1e3 * node[f"{along}_m"], 1e-6 * size(node)) for node in on_line], 1e-5)
        check(f"{label} along both", len(lines) == 2)


def sound():
    """Levels of third octaves, as far as they are shown, and of the modes by themselves."""
    bands, own = table("sound.csv"), table("sound_modes.csv")
    curves = {label: points for label, columns, points in charts("sound")
              if columns == ["frequency (Hz)", "sound power (dB re 1 pW)"]}
    columns = {"wheel": "wheel_dB_re_1pW", "rail": "rail_dB_re_1pW", "both, A-weighted": "total_dBA_re_1pW"}
    check("curves", set(curves) == set(columns) | {"modes of the wheel", "modes of the rail"}, set(curves))
    for label, column in columns.items():
        level = {float(row["centre_frequency_Hz"]): number(row[column]) for row in bands}
        shown = [(f, x) for f, x in curves[label] if not math.isnan(x)]
        check(f"{label}: some bands", len(shown) > 3)
        for f, x in shown:
            wanted = [value for centre, value in level.items() if abs(centre / f - 1) < 1e-6]
            check(f"{label}: a band", len(wanted) < 2)
            if wanted: # sound.csv ends with what is audible
                near(label, x, wanted[0])
        check(f"{label}: the loudest", abs(max(x for _, x in shown) -
                                           max(x for x in level.values() if not math.isnan(x))) < 1e-5)
    for body in ("wheel", "rail"):
        wanted = [(float(row["frequency_Hz"]), number(row["alone_dB_re_1pW"])) for row in own
                  if row["body"] == body]
        points = curves[f"modes of the {body}"]
        check(f"{body}: modes", len(points) == len(wanted) and any(not math.isnan(x) for _, x in points))
        for (f, x), (g, y) in zip(points, wanted):
            near("frequency of a mode", f, g)
            if not math.isnan(x):
                near("level of a mode", x, y)


def spectrum():
    """Third octaves, densities and lines with their names."""
    bands, densities, lines = table("third_octaves.csv"), table("spectrum.csv"), table("lines.csv")
    names = {"load N": "normal_force", "longitudinal T": "force_x", "lateral T": "force_y"}
    for column in densities[0]:
        if column.startswith("velocity_"):
            name = column.split("_psd_")[0]
            _, *point, axis = name.split("_")
            names["_".join(point or ["contact"]) + " " + axis] = name
    marks, drawn, loudest = [], 0, None
    for label, (_, y), points in charts("spectrum"):
        if "(dB re" in y:
            column = f"{names[label]}_dB_re_" + y.split("re ")[1].rstrip(")").replace(" ", "")
            rows = {round(float(row["centre_frequency_Hz"]), 3): number(row[column]) for row in bands}
        elif label in names:
            unit = "N2/Hz" if y == "density (N\u00b2/Hz)" else "(m/s)2/Hz"
            check("density", unit == "N2/Hz" or y == "density ((m/s)\u00b2/Hz)", y)
            column = f"{names[label]}_psd_{unit}"
            rows = {round(float(row["frequency_Hz"]), 3): number(row[column]) for row in densities}
            loudest = label
        else:
            marks.append((label, points))
            continue
        drawn += 1
        for f, value in points:
            if not math.isnan(value):
                near(label, value, rows[round(f, 3)])
    n_forces = sum(label in names for label in ("load N", "longitudinal T", "lateral T"))
    check("curves", drawn >= len({row["signal"] for row in lines}) + n_forces and marks, drawn)
    # lines of the loudest velocity: those with the highest level
    own = [row for row in lines if row["signal"] == names[loudest] + "_m/s"]
    loud = max((row for row in lines if row["signal"].startswith("velocity")), key=lambda r: float(r["level_dB"]))
    check("the loudest velocity", loud["signal"] == names[loudest] + "_m/s", loudest)
    own = sorted(sorted(own, key=lambda row: -float(row["level_dB"]))[:4], key=lambda row: float(row["frequency_Hz"]))
    check("number of marks", 0 < len(own) == len(marks), len(own), len(marks))
    for (label, ((f, value),)), row in zip(marks, own):
        near("a line", f, float(row["frequency_Hz"]))
        nearest = min(densities, key=lambda it: abs(float(it["frequency_Hz"]) - f))
        near("density of a line", value, float(nearest[f"{names[loudest]}_psd_(m/s)2/Hz"]))
        said = f"{float(row['frequency_Hz']):.5g} Hz"
        if row["multiple"] not in ("", "1"):
            said += f" = {row['multiple']} \u00d7 {float(row['fundamental_Hz']):.5g} Hz"
        else:
            said += f": eigenvalue {float(row['eigenvalue_Hz']):.5g} Hz, {float(row['eigenvalue_growth_1/s']):+.3g} 1/s"
        check("name of a line", label == said, label, said)


def spectrogram():
    """Levels over time and frequency, no more than so many dB below the highest."""
    rows = table("spectrogram.csv")
    (column,) = [name for name in rows[0] if name.startswith("level_")]
    ((_, columns, points),) = charts("spectrogram")
    check("axes", columns[:2] == ["time (ms)", "frequency (Hz)"], columns)
    levels = {(round(1e3 * float(row["time_s"]), 4), round(float(row["frequency_Hz"]), 3)): number(row[column])
              for row in rows}
    check("number of cells", len(points) == len(levels), len(points), len(levels))
    least = min(value for _, _, value in points)
    for time, frequency, value in points:
        level = levels[round(time, 4), round(frequency, 3)]
        near("level", value, level if level > least else least, 1e-6)
    check("levels differ", max(levels.values()) > least + 20)


def sweep():
    """Amplitudes along x up and down and growths, over the values of the axis."""
    rows = table("results.csv")
    axis = next(name for name in rows[0] if name[0].isupper())
    curves = list(charts("limit_cycles"))
    for way in ("up", "down"):
        (points,) = [points for label, columns, points in curves
                     if label == f"start 1, {way}" and columns[1] == "amplitude (m/s)"]
        same_points(way, points, [(float(row[axis]), 0.0 if row["cycle"] == "decayed" else
                                   float(row["cycle_velocity_x_amplitude_m/s"]))
                                  for row in rows if row["direction"] == way])
    (points,) = [points for label, columns, points in curves if columns[1] == "growth (1/s)"]
    same_points("growth", points, sorted({float(row[axis]): float(row["largest_growth_1/s"]) for row in rows}.items()))


def impacts():
    """Largest load and pressure over those at rest over speed, and the load of the worst run over its way."""
    rows, curves = table("results.csv"), list(charts("impacts"))
    check("curves", len(curves) == 3, len(curves))
    for (label, columns, points), quantity in zip(curves, ("load", "pressure")):
        check(f"axes of the {quantity}", columns == ["speed (m/s)", "largest over that at rest"], columns)
        check(f"name of the {quantity}", quantity in label, label)
        same_points(quantity, points, [(float(row["speed_m/s"]), float(row[f"largest_{quantity}/at_rest"]))
                                       for row in rows])
    worst = max(rows, key=lambda row: float(row["largest_load/at_rest"]))
    label, columns, points = curves[2]
    check("name of the history", label == f"at {float(worst['speed_m/s']):.3g} m/s", label)
    check("axes of the history", columns == ["rolled (m)", "load over that at rest"], columns)
    same_points("history", points, [(float(row["rolled_m"]), float(row["normal_force_N"]) /
                                     float(worst["load_at_rest_N"])) for row in table("impact_history.csv")], 1e-5)


def patch():
    """The map of states over time and place against cycle_patch.csv."""
    rows = table("cycle_patch.csv")
    ((_, columns, points),) = charts("cycle_patch")
    check("axes", columns[:2] == ["time (ms)", "x (mm)"], columns)
    n = 0
    for row in rows[::7]:
        t, x = 1e3 * float(row["time_s"]), 1e3 * float(row["x_m"])
        # corners of the cell around
        corners = sorted((math.hypot((u - t) / 1e3, v - x), state) for u, v, state in points)[:2]
        n += 1
        check("state of a node", any(state == float(row["state"]) for _, state in corners), row)
    check("some nodes", n > 20)


globals()[kind](*sys.argv[3:])
sys.exit(bool(failures))
