"""Pictures of states: SVG without any library, and axes of matplotlib."""

import numpy

_WIDTH, _HEIGHT, _MARGIN = 480.0, 300.0, 46.0
_COLOURS = {"pressure": "#1f5a94", "traction": "#c0392b"}
_STATES = {1: "#c0392b", 2: "#1f5a94"}


def _nodes_of(state):
    if state.fields is None:
        raise ValueError("nothing touches in this state, so there is nothing to draw")
    fields = state.fields
    is_line = not numpy.any(fields.positions[:, 1])
    return fields, is_line


def middle_line(fields):
    """x (m), pressure and traction along x (Pa) of the nodes nearest to y = 0, by x."""
    y = fields.positions[:, 1]
    nearest = numpy.abs(y) <= numpy.abs(y).min() + 1e-12
    order = numpy.argsort(fields.positions[nearest, 0])
    return tuple(
        values[nearest][order] for values in (fields.positions[:, 0], fields.pressure, fields.traction[:, 0])
    )


def _svg(content, title):
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{_WIDTH:g}" height="{_HEIGHT:g}" '
        f'viewBox="0 0 {_WIDTH:g} {_HEIGHT:g}" font-family="sans-serif" font-size="12">'
        f'<rect width="100%" height="100%" fill="white"/>'
        f'<text x="{_WIDTH / 2:g}" y="16" text-anchor="middle">{title}</text>{"".join(content)}</svg>'
    )


def _scaled(values, low, high, begin, end):
    return begin + (numpy.asarray(values) - low) / (high - low) * (end - begin)


def _svg_of_line(fields, friction):
    x, pressure, traction = middle_line(fields)
    bound = friction * pressure
    curves = [("mu p", bound, "#999999"), ("q", traction, _COLOURS["traction"])]
    if not friction:
        curves = [("p", pressure, _COLOURS["pressure"])]
    low = min(0.0, *(curve.min() for _, curve, _ in curves))
    high = max(curve.max() for _, curve, _ in curves) or 1.0
    at = _scaled(x, x.min(), x.max(), _MARGIN, _WIDTH - 16)
    content = []
    for number, (name, curve, colour) in enumerate(curves):
        up = _scaled(curve, low, high, _HEIGHT - _MARGIN, 30)
        points = " ".join(f"{i:.1f},{j:.1f}" for i, j in zip(at, up))
        content.append(f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="1.6"/>')
        content.append(f'<text x="{_WIDTH - 20:g}" y="{44 + 16 * number:g}" text-anchor="end" fill="{colour}">{name}</text>')
    zero = float(_scaled(0.0, low, high, _HEIGHT - _MARGIN, 30))
    content.append(f'<line x1="{_MARGIN:g}" x2="{_WIDTH - 16:g}" y1="{zero:.1f}" y2="{zero:.1f}" stroke="black"/>')
    for value, level in ((high, 30.0), (low, _HEIGHT - _MARGIN)):
        content.append(f'<text x="{_MARGIN - 4:g}" y="{level + 4:g}" text-anchor="end">{value / 1e6:.0f}</text>')
    for value, place, anchor in ((x.min(), _MARGIN, "start"), (x.max(), _WIDTH - 16, "end")):
        content.append(f'<text x="{place:g}" y="{_HEIGHT - 26:g}" text-anchor="{anchor}">{1e3 * value:.2f}</text>')
    content.append(f'<text x="{_WIDTH / 2:g}" y="{_HEIGHT - 8:g}" text-anchor="middle">x (mm), traction in MPa</text>')
    return content


def _svg_of_patch(fields):
    position, pressure = fields.positions, fields.pressure
    low, high = position.min(axis=0), position.max(axis=0)
    scale = min((_WIDTH - 2 * _MARGIN) / (high[0] - low[0]), (_HEIGHT - 2 * _MARGIN) / (high[1] - low[1]))
    middle = (low + high) / 2
    at = numpy.column_stack(
        (_WIDTH / 2 + scale * (position[:, 0] - middle[0]), _HEIGHT / 2 - scale * (position[:, 1] - middle[1]))
    )
    sides = [numpy.diff(numpy.unique(numpy.round(position[:, k], 9))) for k in (0, 1)]
    side = [scale * float(numpy.median(gaps)) for gaps in sides]
    traction = fields.traction
    longest = numpy.hypot(traction[:, 0], traction[:, 1]).max() or 1.0
    content = []
    for i in numpy.flatnonzero(pressure > 0.0):
        share, (x, y) = pressure[i] / pressure.max(), at[i]
        grey = int(250 - 90 * share)
        content.append(
            f'<rect x="{x - side[0] / 2:.1f}" y="{y - side[1] / 2:.1f}" width="{side[0]:.1f}" height="{side[1]:.1f}" '
            f'fill="rgb({grey},{grey},{grey})"/>'
        )
        arrow = 0.9 * max(side) * traction[i] / longest
        colour = _STATES.get(int(fields.node_states[i]), "#999999")
        content.append(
            f'<circle cx="{x:.1f}" cy="{y:.1f}" r="1.6" fill="{colour}"/>'
            f'<line x1="{x:.1f}" y1="{y:.1f}" x2="{x + arrow[0]:.1f}" y2="{y - arrow[1]:.1f}" '
            f'stroke="{colour}" stroke-width="1.4"/>'
        )
    ends = " by ".join(f"{1e3 * low[k]:.2f} to {1e3 * high[k]:.2f}" for k in (0, 1))
    content.append(
        f'<text x="{_WIDTH / 2:g}" y="{_HEIGHT - 8:g}" text-anchor="middle">x to the right, y up: {ends} mm; '
        f"blue sticks, red slides</text>"
    )
    return content


def svg(self):
    """The patch as SVG, for notebooks: 2D traction beside mu p, 3D pressure in grey, tractions as lines from the nodes."""
    if self.fields is None:
        return _svg([], "nothing touches")
    fields, is_line = _nodes_of(self)
    friction = self.friction_force / self.normal_force if self.normal_force else 0.0
    title = f"N = {self.normal_force:.5g} N, T = ({self.force_x:.4g}, {self.force_y:.4g}) N, p &#8804; {self.max_pressure / 1e6:.4g} MPa"
    return _svg(_svg_of_line(fields, friction) if is_line else _svg_of_patch(fields), title)


def plot(self, axes=None):
    """Draw the patch with matplotlib and return the axes; 2D over x, 3D as a map. Raises ImportError without matplotlib."""
    import matplotlib.pyplot

    fields, is_line = _nodes_of(self)
    if axes is None:
        axes = matplotlib.pyplot.figure().add_subplot()
    friction = self.friction_force / self.normal_force if self.normal_force else 0.0
    if is_line:
        x, pressure, traction = middle_line(fields)
        axes.plot(1e3 * x, 1e-6 * friction * pressure, color="0.6", label="mu p")
        axes.plot(1e3 * x, 1e-6 * traction, color=_COLOURS["traction"], label="q")
        axes.set_xlabel("x (mm)")
        axes.set_ylabel("traction on the wheel (MPa)")
        axes.legend()
        return axes
    position, traction = 1e3 * fields.positions, fields.traction
    touches = fields.pressure > 0.0
    shown = axes.scatter(
        position[touches, 0], position[touches, 1], c=1e-6 * fields.pressure[touches], cmap="Greys", vmin=0.0, s=60, marker="s"
    )
    axes.figure.colorbar(shown, label="pressure (MPa)")
    colours = [_STATES.get(int(number), "#999999") for number in fields.node_states[touches]]
    axes.quiver(*position[touches].T, *traction[touches].T, color=colours, width=0.004)
    for number, name in ((2, "sticks"), (1, "slides")):
        axes.plot([], [], color=_STATES[number], label=name)
    axes.set_aspect("equal")
    axes.set_xlabel("x (mm)")
    axes.set_ylabel("y (mm)")
    axes.legend()
    return axes
