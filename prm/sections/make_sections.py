#!/usr/bin/env python3
"""Writes the sections of this folder as meshes of quadrilaterals for Shape = section (doc/howto/sections.md), and the profiles of a tram (../profiles/
tram_wheel.txt, grooved_rail.txt).

    python3 prm/sections/make_sections.py

needs nothing but Python. Gmsh format 2.2, metres: y across, z from rail to wheel, the contact point is the origin; of wheel_s1002, rail_60e1 and those of a tram the axes are those of the profile, y from the gauge side to
the field side. A wheel lies at z > 0 with its axle at z = Wheel/Radius, a rail at z < 0.
Physical groups: 1 contact boundary, 2 hub (bore of a wheel, ends of an axle, sole of a rail), 3 the section.
"""
import collections
import math
import pathlib

CONTACT, HUB, INSIDE = 1, 2, 3


class Section:
    """Quadrilaterals between shared points; edges named by the ids of their boundaries."""

    def __init__(self):
        self.points, self.number, self.quads, self.edges = [], {}, [], []

    def point(self, y, z):
        key = (round(y * 1e8), round(z * 1e8))
        if key not in self.number:
            self.number[key] = len(self.points)
            self.points.append((y, z))
        return self.number[key]

    def block(self, place, n_s, n_t, sides=None):
        """n_s by n_t quadrilaterals at place(s, t), s and t from 0 to 1; sides: ids by s0, s1, t0, t1."""
        at = [[self.point(*place(i / n_s, j / n_t)) for j in range(n_t + 1)] for i in range(n_s + 1)]
        for i in range(n_s):
            for j in range(n_t):
                self.quads.append(upright(self.points, [at[i][j], at[i + 1][j], at[i + 1][j + 1], at[i][j + 1]]))
        rows = {'s0': at[0], 's1': at[-1], 't0': [row[0] for row in at], 't1': [row[-1] for row in at]}
        for side, boundary in (sides or {}).items():
            self.edges += [(boundary, p, q) for p, q in zip(rows[side], rows[side][1:])]

    def write(self, name, comment, radius=None):
        lines = ['$MeshFormat', '2.2 0 8', '$EndMeshFormat', '$PhysicalNames', '3']
        says = '' if radius is None else ', radius %g' % radius
        lines += ['1 %d "contact%s"' % (CONTACT, says), '1 %d "hub"' % HUB, '2 %d "section"' % INSIDE, '$EndPhysicalNames']
        lines += ['$Nodes', str(len(self.points))]
        lines += ['%d %.12g %.12g 0' % (n + 1, y, z) for n, (y, z) in enumerate(self.points)]
        elements = [('1', boundary, ends) for boundary, *ends in self.edges]
        elements += [('3', INSIDE, corners) for corners in self.quads]
        lines += ['$EndNodes', '$Elements', str(len(elements))]
        for n, (kind, group, corners) in enumerate(elements):
            lines.append('%d %s 2 %d %d %s' % (n + 1, kind, group, group, ' '.join(str(c + 1) for c in corners)))
        lines.append('$EndElements')
        path = pathlib.Path(__file__).resolve().parent / (name + '.msh')
        path.write_text('\n'.join(lines) + '\n')
        print('%s: %s; %d points, %d quadrilaterals' % (path.name, comment, len(self.points), len(self.quads)))

    def properties(self):
        """Area, height of the centroid, second moments about it for bending up and down and sideways."""
        area = first = up = across = 0.
        for quad in self.quads:
            for p, q in zip(quad, quad[1:] + quad[:1]):
                (y0, z0), (y1, z1) = self.points[p], self.points[q]
                c = y0 * z1 - y1 * z0
                area += c / 2
                first += c * (z0 + z1) / 6
                up += c * (z0 * z0 + z0 * z1 + z1 * z1) / 12
                across += c * (y0 * y0 + y0 * y1 + y1 * y1) / 12
        return area, first / area, up - first * first / area, across


def upright(points, quad):
    area = 0.
    for p, q in zip(quad, quad[1:] + quad[:1]):
        area += points[p][0] * points[q][1] - points[q][0] * points[p][1]
    return quad if area > 0. else quad[::-1]


def between(a, b, t):
    return a + (b - a) * t


def nearest(points, p):
    """Length along these points at which they are nearest to p, over the whole of it; points are close."""
    length = [0.]
    for a, b in zip(points, points[1:]):
        length.append(length[-1] + math.dist(a, b))
    return length[min(range(len(points)), key=lambda k: math.dist(points[k], p))] / length[-1]


def coons(bottom, top, left, right):
    """The map of the unit square between four curves: bottom, top of s, left, right of t."""
    def place(s, t):
        result = []
        for d in range(2):
            edges = between(bottom(s)[d], top(s)[d], t) + between(left(t)[d], right(t)[d], s)
            corners = between(between(bottom(0)[d], bottom(1)[d], s), between(top(0)[d], top(1)[d], s), t)
            result.append(edges - corners)
        return result
    return place


def line(p, q):
    return lambda t: (between(p[0], q[0], t), between(p[1], q[1], t))


def polyline(points):
    """The curve through these points, by arc length."""
    length = [0.]
    for p, q in zip(points, points[1:]):
        length.append(length[-1] + math.dist(p, q))

    def at(t):
        s = t * length[-1]
        k = next((k for k in range(1, len(points) - 1) if length[k] >= s), len(points) - 1)
        return line(points[k - 1], points[k])((s - length[k - 1]) / (length[k] - length[k - 1]))
    return at


# ---- bodies of revolution, by radius and y

WheelSize = collections.namedtuple('WheelSize', 'radius bore hub_radius rim_radius hub_half rim_half web web_offset hub_middle')
RAILWAY = WheelSize(0.46, 0.0925, 0.135, 0.39, 0.085, 0.0675, 0.030, 0.020, 0.)
TRAM = WheelSize(0.30, 0.070, 0.105, 0.240, 0.060, 0.0525, 0.022, -0.0075, -0.0225)
RADIUS, BORE, HUB_HALF, WEB = RAILWAY.radius, RAILWAY.bore, RAILWAY.hub_half, RAILWAY.web


def wheel_blocks(n, hub_boundary, mirror=1., shift=0., size=RAILWAY):
    """The wheel with an S-shaped web: blocks of (place, numbers, boundaries); n elements through the web, which goes from the middle of the hub
    to its offset at the rim."""
    def middle(r):
        t = min(max((r - size.hub_radius) / (size.rim_radius - size.hub_radius), 0.), 1.)
        return between(size.hub_middle, size.web_offset, 3 * t * t - 2 * t ** 3)

    def column(r0, r1, left, right):
        def place(s, t):
            r = between(r0, r1, s)
            return shift + mirror * between(left(r), right(r), t), size.radius - r
        return place

    def at(y):
        return lambda r: y

    def web_left(r):
        return middle(r) - size.web / 2

    def web_right(r):
        return middle(r) + size.web / 2

    blocks = []
    for left, right, n_t in ((at(size.hub_middle - size.hub_half), web_left, 2), (web_left, web_right, 1), (web_right, at(size.hub_middle + size.hub_half), 2)):
        blocks.append((column(size.bore, size.hub_radius, left, right), n, n_t * n, hub_boundary))
    blocks.append((column(size.hub_radius, size.rim_radius, web_left, web_right), 6 * n, n, {}))
    for left, right, n_t in ((at(-size.rim_half), web_left, 2), (web_left, web_right, 1), (web_right, at(size.rim_half), 2)):
        blocks.append((column(size.rim_radius, size.radius, left, right), 2 * n, n_t * n, {'s1': CONTACT}))
    return blocks


def wheel(n):
    section = Section()
    for place, n_s, n_t, sides in wheel_blocks(n, {'s0': HUB}):
        section.block(place, n_s, n_t, sides)
    section.write('wheel_%d' % n, 'R 0.46 m, bore 0.0925 m, S-web of 30 mm, %d elements through it' % n, 0.46)


def annular_plate(n):
    section = Section()
    inner, half = 0.08, 0.01
    section.block(lambda s, t: (between(-half, half, t), RADIUS - between(inner, RADIUS, s)), 19 * n // 2, n,
                  {'s0': HUB, 's1': CONTACT})
    section.write('annular_plate', 'a 0.46 m, b 0.08 m, t 0.02 m, %d elements through it' % n)


def wheelset(n):
    """Two of these wheels, their treads 1.5 m apart, on a hollow axle that is held at its ends."""
    section = Section()
    hollow, gauge, journal = 0.030, 1.5, 0.300
    for mirror, shift in ((1., 0.), (-1., gauge)):
        for place, n_s, n_t, sides in wheel_blocks(n, {}, mirror, shift):
            section.block(place, n_s, n_t, sides)
    ends = [-HUB_HALF, -WEB / 2, WEB / 2, HUB_HALF]
    seats = [(a, b, (2, 1, 2)[k] * n) for k, (a, b) in enumerate(zip(ends, ends[1:]))]
    parts = [(-HUB_HALF - journal, -HUB_HALF, 6 * n)] + seats
    parts += [(HUB_HALF, gauge - HUB_HALF, 30 * n)] + [(gauge + a, gauge + b, m) for a, b, m in seats]
    parts += [(gauge + HUB_HALF, gauge + HUB_HALF + journal, 6 * n)]
    for k, (a, b, m) in enumerate(parts):
        sides = {'t0': HUB} if k == 0 else {'t1': HUB} if k == len(parts) - 1 else {}
        section.block(lambda s, t: (between(a, b, t), RADIUS - between(hollow, BORE, s)), n, m, sides)
    section.write('wheelset', 'two wheels and an axle, %d elements through the webs' % n, 0.46)


# ---- the same web and hub under a profile S1002 (EN 13715), in mm: across from the tape circle to the field side, and growth of the radius

S1002 = [  # ends across; a polynomial, lowest power first, or (centre, radius, below it or above)
    (-70., -62.764705882, ((-49.5, 9.519259302), 20.5, 1)), (-62.764705882, -49.662510381, ((-55., 16.), 12., 1)),
    (-49.662510381, -39.764473993, ((-58.558326413, 8.834924130), 20., 1)),
    (-39.764473993, -38.426669071, [-93.576667419, -2.747477419]), (-38.426669071, -35., ((-26.210665, 16.446), 13., -1)),
    (-35., -26., [-4.320221063e3, -1.038384026e3, -1.065501873e2, -6.051367875, -2.054332446e-1, -4.169739389e-3, -4.687195829e-5,
                  -2.252755540e-7]),
    (-26., 32.15796, [0., -3.358537058e-2, 1.565681624e-3, -2.810427944e-5, 5.844240864e-8, -1.562379023e-8, 5.309217349e-15,
                      -5.957839843e-12, 2.646656573e-13]),
    (32.15796, 60., [1.364323640, -0.066666667])]


def s1002():
    """Close points from the back of the flange to the field side."""
    points = []
    for begin, end, zone in S1002:
        for k in range(401):
            y = between(begin, end, (1 - math.cos(math.pi * k / 400)) / 2)
            if isinstance(zone, list):
                z = sum(c * y ** n for n, c in enumerate(zone))
            else:
                (y0, z0), radius, way = zone
                z = z0 + way * math.sqrt(max(0., radius ** 2 - (y - y0) ** 2))
            points.append((y, z))
    return points


def part(points, begin, end):
    """Between shares of its length, begin below end, with the close points in between."""
    total = sum(math.dist(p, q) for p, q in zip(points, points[1:]))
    at, result, run = polyline(points), [], 0.
    for p, q in zip(points, points[1:]):
        run += math.dist(p, q) / total
        if begin + 1e-9 < run < end - 1e-9:
            result.append(q)
    return [at(begin)] + result + [at(end)]


# Points of a rim's mesh, in mm: the tip and the root of the flange, the end of the field side, the back, cells along the tread and of them at the root, the
# line of nodes below the surface, its point below the root, the inside of the flange, and the middle of that
Rim = collections.namedtuple('Rim', 'tip root field back cells root_cells inside corner flange core')
S1002_RIM = Rim((-61.5, 26.), (-36.5, 8.4), 65., (-70., -4.), 10, 4,
                [(-53., 14.), (-49.5, 7.), (-45., 0.), (-39., -8.), (-31., -14.5), (-20., -19.), (-5., -22.), (65., -24.)], (-43.5, -2.),
                (-58., 15.), (-61., -6.))


def profiled_wheel(n, name='wheel_s1002', comment='S1002, R 0.46 m, bore 0.0925 m, S-web of 30 mm', profile=None, rim=S1002_RIM, size=RAILWAY):
    """The tread has cells of 20 by 20 mm, as long when it is revolved in 144 parts; n elements through the web."""
    section = Section()
    profile = profile or s1002()
    side, field = rim.back[0], rim.field
    field_end = (field, profile[-1][1] - 5.)
    tip = nearest(profile, rim.tip)
    tread = part(profile, tip, 1.) + [field_end]
    back = [rim.back, (side, profile[0][1])] + part(profile, 0., tip)
    cells, rows, root = rim.cells, 1, rim.root_cells
    surface, root_at, end_at = polyline(tread), nearest(tread, rim.root), nearest(tread, profile[-1])
    breaks = [root_at * k / root for k in range(root)] + [between(root_at, end_at, k / (cells - 1 - root)) for k in range(cells - root)] + [1.]
    inside = rim.inside
    corner = nearest([polyline(inside)(k / 2000) for k in range(2001)], rim.corner)
    inner = [rim.flange] + [polyline(inside)(corner * (i - 1) / (root - 1)) for i in range(1, root)]
    dense = [polyline(inside)(k / 2000) for k in range(2001)]
    begin = polyline(inside)(corner)
    for i in range(root, cells + 1):
        fade = max(0., 1. - (surface(breaks[i])[0] - surface(breaks[root])[0]) / 25.)
        across = surface(breaks[i])[0] + fade * (begin[0] - surface(breaks[root])[0])
        inner.append(min(dense, key=lambda p: abs(p[0] - across)) if i < cells else inside[-1])

    def add(place, n_s, n_t, sides=None):
        section.block(lambda s, t: (place(s, t)[0] / 1e3, -place(s, t)[1] / 1e3), n_s, n_t, sides)

    for i in range(cells):
        add(coons(line(inner[i], inner[i + 1]), lambda s: surface(between(breaks[i], breaks[i + 1], s)),
                  line(inner[i], surface(breaks[i])), line(inner[i + 1], surface(breaks[i + 1]))), 1, rows, {'t1': CONTACT})
    core = [line(rim.core, inner[0])(j / (root - 1)) for j in range(root)]
    behind = polyline(back)
    for j in range(root - 1):
        a, b = j / (root - 1), (j + 1) / (root - 1)
        add(coons(line(core[j], core[j + 1]), lambda s: behind(between(a, b, s)), line(core[j], behind(a)), line(core[j + 1], behind(b))),
            1, rows)
        add(coons(line(core[j], core[j + 1]), line(inner[root - j], inner[root - j - 1]), line(core[j], inner[root - j]),
                  line(core[j + 1], inner[root - j - 1])), 1, 1)
    top = [line(rim.back, core[0])(k / rows) for k in range(rows)] + [core[0]] + inner[root:]
    columns = len(top) - 1
    depth = 1e3 * (size.radius - size.rim_radius)
    left, right = 1e3 * (size.web_offset - size.web / 2), 1e3 * (size.web_offset + size.web / 2)
    first = round(columns * (left - side) / (field - side))
    bottom = ([(between(side, left, k / first), -depth) for k in range(first)] + [(between(left, right, k / n), -depth) for k in range(n)]
              + [(between(right, field, k / (columns - first - n)), -depth) for k in range(columns - first - n + 1)])
    for i in range(columns):
        add(coons(line(bottom[i], bottom[i + 1]), line(top[i], top[i + 1]), line(bottom[i], top[i]), line(bottom[i + 1], top[i + 1])), 1, 2)
    for place, n_s, n_t, sides in wheel_blocks(n, {'s0': HUB}, size=size)[:4]:
        section.block(place, n_s, n_t, sides)
    area, *_ = section.properties()
    section.write(name, '%s, %d elements through it; A %.1f cm2' % (comment, n, area * 1e4), size.radius)


# ---- the rail 60E1, EN 13674-1: the right half from the middle of the sole, in mm

def arc(centre, radius, begin, end, n=24):
    return [(centre[0] + radius * math.cos(between(begin, end, k / n)),
             centre[1] + radius * math.sin(between(begin, end, k / n))) for k in range(n + 1)]


def plus(p, t, q):
    return p[0] + t * q[0], p[1] + t * q[1]


def fillet(web_end, way, angle, height):
    """From the web to a line of slope 1:2.75, outwards: arcs of 120, 35 and 7 mm."""
    slope = math.atan(1 / 2.75)
    c120, towards = (8.25 + 120, web_end), (-math.cos(angle), way * math.sin(angle))
    on_120, c35 = plus(c120, 120, towards), plus(c120, 120 - 35, towards)
    across, along = (math.sin(slope), -way * math.cos(slope)), (math.cos(slope), way * math.sin(slope))
    start = plus((0., height), 7, across)
    d = start[0] - c35[0], start[1] - c35[1]
    b = d[0] * along[0] + d[1] * along[1]
    c7 = plus(start, -b - math.sqrt(b * b - (d[0] ** 2 + d[1] ** 2 - 28 ** 2)), along)
    joint = c35[0] + (c7[0] - c35[0]) * 35 / 28, c35[1] + (c7[1] - c35[1]) * 35 / 28

    def angle_of(p, centre):
        result = math.atan2(p[1] - centre[1], p[0] - centre[0])
        return result + 2 * math.pi if result < -1e-9 else result
    return (arc(c120, 120, math.pi, angle_of(on_120, c120)) + arc(c35, 35, angle_of(on_120, c35), angle_of(joint, c35))[1:]
            + arc(c7, 7, angle_of(joint, c7), angle_of(plus(c7, -7, across), c7))[1:])


def split(points, half):
    """Points of the outline nearer to the web than |y| = half, with that point at the end; and the others."""
    k = next(k for k, p in enumerate(points) if p[0] > half)
    p, q = points[k - 1], points[k]
    cut = line(p, q)((half - p[0]) / (q[0] - p[0]))
    return points[:k] + [cut], [cut] + points[k:]


def rail_outline():
    """Crown arcs, side of the head, upper and lower fillet, top of the foot."""
    a1 = math.asin(10.228 / 300)
    c1 = (0., 172. - 300.)
    c2 = plus(c1, 220, (math.sin(a1), math.cos(a1)))
    a2 = math.asin((26.0265 - c2[0]) / 80)
    c3 = plus(c2, 67, (math.sin(a2), math.cos(a2)))
    up = math.pi / 2
    a3 = up - math.atan(1 / 20)
    a_corner = (a2 + a3) / 2
    crown = [arc(c1, 300, up, up - a1), arc(c2, 80, up - a1, up - a2) + arc(c3, 13, up - a2, up - a_corner)[1:]]
    side = arc(c3, 13, up - a_corner, up - a3)
    # where side, slope 20:1, and underside, 1:2.75, meet; the corner of 3 mm is cut
    y, z = side[-1]
    corner_y = (z - 121 + 20 * y) / (20 + 1 / 2.75)
    corner = corner_y - 0.8, 121 + (corner_y - 0.8) / 2.75
    side.append((corner_y, 121 + corner_y / 2.75 + 1.6))
    side.append(corner)
    under = fillet(92.37, 1., 0.22187, 121.) + [corner]
    toe = (31.5 - 11.5 - 75 / 14) / (1 / 2.75 - 1 / 14)
    foot = fillet(60.40, -1., 0.23609, 31.5) + [(toe - 8, 31.5 - (toe - 8) / 2.75), (toe, 31.5 - toe / 2.75 + 0.35),
                                                (toe + 8, 11.5 + (75 - toe - 8) / 14), (74., 11.57), (75., 10.)]
    return crown, side, under, foot


def rail(n):
    """n elements through the web."""
    section = Section()
    crown, side, under, foot = rail_outline()
    web_top, under = split(under, 13.)
    web_bottom, foot = split(foot, 17.)
    web = polyline(web_bottom[::-1] + web_top)
    neck, ankle = web(1), web(0)
    top = polyline(crown[0])

    def mirrored(place, n_s, n_t, sides=None):
        for sign in (1, -1):
            section.block(lambda s, t: (sign * place(s, t)[0] / 1e3, (place(s, t)[1] - 172) / 1e3), n_s, n_t, sides)

    def across(half):
        """From the left to the right side, given the right side by t."""
        return lambda s, t: (between(-1, 1, s) * half(t)[0] / 1e3, (half(t)[1] - 172) / 1e3)

    heel = line((17., 0.), ankle)
    section.block(across(heel), n, n, {'t0': HUB})
    section.block(across(web), n, 5 * n)
    neck_side = line(neck, top(1))

    def crowned(s):
        y, z = top(abs(2 * s - 1))
        return math.copysign(y, s - 0.5), z

    def head_middle(s, t):
        y, z = coons(line((-neck[0], neck[1]), neck), crowned, lambda t: (-neck_side(t)[0], neck_side(t)[1]), neck_side)(s, t)
        return y / 1e3, (z - 172) / 1e3
    section.block(head_middle, n, 3 * n, {'t1': CONTACT})
    mirrored(coons(polyline(under), polyline(crown[1]), neck_side, polyline(side[::-1])), 2 * n, 3 * n, {'t1': CONTACT})
    mirrored(coons(line((17., 0.), (75., 0.)), polyline(foot), heel, line((75., 0.), foot[-1])), 4 * n, n, {'t0': HUB})
    area, height, up, sideways = section.properties()
    section.write('rail_%d' % n, '60E1, %d elements through the web; A %.2f cm2, Iy %.1f cm4, Iz %.1f cm4 '
                  '(standard: 76.70, 3038.3, 512.3), centroid %.2f mm above the sole (80.92)'
                  % (n, area * 1e4, up * 1e8, sideways * 1e8, (height + 0.172) * 1e3))


def profiled_rail(n):
    """With a running surface from lower corner to lower corner of the head, and cells that are upright under all of it."""
    section = Section()
    crown, side, under, foot = rail_outline()
    web_top, under = split(under, 13.)
    web_bottom, foot = split(foot, 17.)
    web = polyline(web_bottom[::-1] + web_top)
    neck, ankle, top = web(1), web(0), crown[0][-1]
    shoulder = crown[1][-1]  # amid the corner of 13 mm
    flank = side if math.dist(side[0], shoulder) < 1e-9 else [shoulder] + side
    core, middle = (21.5, 157.), line(neck, top)(0.76)
    below = polyline(under)(0.53)
    corner = under[-1]
    under_middle, under_corner = part(under, 0., 0.53), part(under, 0.53, 1.)

    def mirrored(place, n_s, n_t, sides=None):
        for sign in (1, -1):
            section.block(lambda s, t: (sign * place(s, t)[0] / 1e3, (place(s, t)[1] - 172) / 1e3), n_s, n_t, sides)

    def across(half):
        return lambda s, t: (between(-1, 1, s) * half(t)[0] / 1e3, (half(t)[1] - 172) / 1e3)

    def crowned(s):
        y, z = polyline(crown[0])(abs(2 * s - 1))
        return math.copysign(y, s - 0.5), z

    heel = line((17., 0.), ankle)
    section.block(across(heel), n, n, {'t0': HUB})
    section.block(across(web), n, 5 * n)
    section.block(across(line(neck, middle)), n, 3)
    head = coons(line((-middle[0], middle[1]), middle), crowned, line((-middle[0], middle[1]), (-top[0], top[1])), line(middle, top))
    section.block(lambda s, t: (head(s, t)[0] / 1e3, (head(s, t)[1] - 172) / 1e3), n, 1, {'t1': CONTACT})
    mirrored(coons(line(middle, core), polyline(crown[1]), line(middle, top), line(core, shoulder)), 2, 1, {'t1': CONTACT})
    mirrored(coons(line(core, below), polyline(flank), line(core, shoulder), polyline(under_corner)), 3, 1, {'t1': CONTACT})
    mirrored(coons(polyline(under_middle), line(middle, core), line(neck, middle), line(below, core)), 2, 3)
    mirrored(coons(line((17., 0.), (75., 0.)), polyline(foot), heel, line((75., 0.), foot[-1])), 4 * n, n, {'t0': HUB})
    area, height, up, sideways = section.properties()
    section.write('rail_60e1', '60E1, %d elements through the web; A %.2f cm2, Iy %.1f cm4, Iz %.1f cm4 '
                  '(standard: 76.70, 3038.3, 512.3), centroid %.2f mm above the sole (80.92)'
                  % (n, area * 1e4, up * 1e8, sideways * 1e8, (height + 0.172) * 1e3))


# ---- profiles of a tram, made for this scene out of lines and arcs: in mm, across to the gauge side and down

def outline(start, heading, pieces, step=0.25):
    """Points of a curve that begins at this angle below the horizontal: (None, length) goes straight on, (radius, angle) turns to this angle."""
    points, run = [start], start
    for radius, value in pieces:
        n = math.ceil((value if radius is None else radius * abs(value - heading)) / step)
        for k in range(1, n + 1):
            if radius is None:
                points.append(plus(run, value * k / n, (math.cos(heading), math.sin(heading))))
            else:
                way, angle = math.copysign(radius, value - heading), between(heading, value, k / n)
                points.append(plus(run, way, (math.sin(angle) - math.sin(heading), math.cos(heading) - math.cos(angle))))
        run, heading = points[-1], heading if radius is None else value
    return points


def tram_wheel_profile():
    """Close points from the back of the flange, 60 mm from the tape circle, to the field side: a cone of 1:40, a throat of 18 mm, a flange at 70
    degrees, 22 mm thick 10 mm below the tape circle and 24 mm high."""
    cone, flange = math.atan(1 / 40), math.radians(70.)
    pieces = [(None, 40. / math.cos(cone) + 22.613), (18., flange), (None, 6.739), (8., 0.), (11.107, math.radians(-90.)), (None, 6.)]
    return [(-y, z) for y, z in outline((-40., -1.), cone, pieces)][::-1]


CORNER, FACE, GROOVE = 0.110817, math.atan(6.), 47.  # where the corner of 13 mm begins, the gauge face, the depth of the groove
HEAD = -7.981  # mm: the middle of the head from that of a 60E1 with the same gauge face, which is the origin of a rail's section


def grooved_head(side):
    """Close points from the middle of the head to the bottom of the gauge face, or to that of the field side: arcs of 300, 80 and 13 mm."""
    end = FACE if side == 'gauge' else math.atan(20.)
    top = [(300., math.asin(10. / 300.)), (80., CORNER), (13., end)]
    z = outline((0., 0.), 0., top)[-1][1]
    depth = GROOVE - 6. * (1. - math.cos(FACE)) if side == 'gauge' else 37.
    return outline((0., 0.), 0., top + [(None, (depth - z) / math.sin(end))])


def grooved_rail_profile():
    """Close points from the floor of the groove to the field side."""
    gauge = grooved_head('gauge')
    gauge = gauge[:-1] + outline(gauge[-1], FACE, [(6., 0.), (None, 12.)])
    return [(HEAD + y, z) for y, z in [(-y, z) for y, z in gauge[:0:-1]] + grooved_head('field')]


def write_profile(name, points, comment):
    path = pathlib.Path(__file__).resolve().parents[1] / 'profiles' / (name + '.txt')
    path.write_text(''.join('# %s\n' % line for line in comment) + ''.join('%.4f %.4f\n' % p for p in points))
    print('%s: %d points' % (path.name, len(points)))


def tram_profiles():
    write_profile('tram_wheel', tram_wheel_profile(), [
        'A wheel of a tram, made for the scene tram_in_curve after the usual dimensions of such wheels, and no standard:',
        'a cone of 1:40, a throat of 18 mm, a flange at 70 degrees that is 24 mm high and 22 mm thick (10 mm below the',
        'tape circle, from its back, which is 60 mm from the tape circle). Written by sections/make_sections.py.',
        'y towards the field side, z down, mm.'])
    write_profile('grooved_rail', grooved_rail_profile(), [
        'The head of a grooved rail, made for the scene tram_in_curve after the usual dimensions of such rails, and no standard:',
        'arcs of 300, 80 and 13 mm, 56 mm wide between the gauge face 14 mm below the top and its mirror image, a gauge face of',
        '6:1, a groove 47 mm deep. The profile ends at the floor of the groove: the keeper beyond it is left out.',
        'Written by sections/make_sections.py. y towards the field side from the middle of a 60E1 with the same gauge face, as',
        'grooved_rail.msh, z down, mm, not inclined.'])


# ---- the sections under them

TRAM_RIM = Rim((-54., 22.), (-32.5, 3.8), 45., (-60., -4.), 10, 4,
               [(-47.5, 12.), (-45.5, 6.), (-42., -1.), (-36., -8.), (-27., -14.5), (-17., -17.5), (-5., -19.), (45., -21.)], (-40.5, -3.5),
               (-50.5, 15.), (-55., -6.))


def grooved_rail(n):
    """Head, groove, keeper, web and foot in mm, z down; only the head may touch. n elements through the web."""
    section = Section()
    gauge, field = grooved_head('gauge'), grooved_head('field')
    gauge, half = [(-y, z) for y, z in gauge], nearest(gauge, (26., 6.))
    crown = part(gauge, 0., half)[:0:-1] + part(field, 0., half)
    gauge_face, field_face = part(gauge, half, 1.), part(field, half, 1.)
    core = (-13., 15.), (13., 15.)
    below = (-22., 45.), (-12., 47.), (15., 40.)  # the foot of the core: its gauge side, above the web, its field side
    web, neck, ankle, sole, half_foot = -26., 78., 154., 180., 90.
    foot = polyline([(6., ankle), (10., 159.), (18., 162.5), (35., 166.), (90., 170.)])
    keeper = (-70., GROOVE), (-86., 52.)

    def add(place, n_s, n_t, sides=None):
        section.block(lambda s, t: ((HEAD + place(s, t)[0]) / 1e3, -place(s, t)[1] / 1e3), n_s, n_t, sides)

    def core_foot(s):
        return line(below[0], below[1])(4 * s) if s < 0.25 else line(below[1], below[2])((4 * s - 1) / 3)

    def web_head(s):
        return line(gauge_face[-1], below[0])(2 * s) if s < 0.5 else line(below[0], below[1])(2 * s - 1)

    add(coons(line(*core), polyline(crown), line(core[0], crown[0]), line(core[1], crown[-1])), 4, 1, {'t1': CONTACT})
    for corner, foot_of_core, face in ((core[0], below[0], gauge_face), (core[1], below[2], field_face)):
        add(coons(line(corner, foot_of_core), polyline(face), line(corner, face[0]), line(foot_of_core, face[-1])), 3, 1, {'t1': CONTACT})
    add(coons(core_foot, line(*core), line(below[0], core[0]), line(below[2], core[1])), 4, 3)
    left, right = (web - 6., neck), (web + 6., neck)
    add(coons(web_head, line(left, right), line(gauge_face[-1], left), line(below[1], right)), n, 2)
    groove = polyline([keeper[0], (-38.6, GROOVE), gauge_face[-1]])
    add(coons(groove, line(keeper[1], left), line(*keeper), line(gauge_face[-1], left)), 3, 2)
    add(coons(line(*keeper), line((-72., 4.), (-85., 4.)), line(keeper[0], (-72., 4.)), line(keeper[1], (-85., 4.))), 2, 3)
    add(coons(line(left, right), line((web - 6., ankle), (web + 6., ankle)), line(left, (web - 6., ankle)), line(right, (web + 6., ankle))), n, 4 * n)
    add(coons(line((web - 6., ankle), (web + 6., ankle)), line((web - 8., sole), (web + 8., sole)), line((web - 6., ankle), (web - 8., sole)),
              line((web + 6., ankle), (web + 8., sole))), n, n, {'t1': HUB})
    for sign in (1, -1):
        wing = coons(line((8., sole), (half_foot, sole)), foot, line((8., sole), (6., ankle)), line((half_foot, sole), foot(1)))
        add(lambda s, t: (web + sign * wing(s, t)[0], wing(s, t)[1]), 4 * n, n, {'t0': HUB})
    area, height, up, _ = section.properties()
    section.write('grooved_rail', 'a grooved rail of 180 mm, %d elements through the web; A %.1f cm2, Iy %.0f cm4' % (n, area * 1e4, up * 1e8))


if __name__ == '__main__':
    wheel(2)
    wheel(3)
    annular_plate(2)
    rail(2)
    rail(3)
    wheelset(2)
    profiled_wheel(2)
    profiled_rail(2)
    tram_profiles()
    profiled_wheel(2, 'wheel_tram', 'a tram wheel, R 0.3 m, bore 0.07 m, web of 22 mm', tram_wheel_profile(), TRAM_RIM, TRAM)
    grooved_rail(2)
