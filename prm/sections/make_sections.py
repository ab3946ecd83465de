#!/usr/bin/env python3
"""Writes the sections of this folder as meshes of quadrilaterals for Shape = section (doc/sections.md).

    python3 prm/sections/make_sections.py

needs nothing but Python. Gmsh format 2.2, metres: y across, z from rail to wheel, the contact point is the origin; of wheel_s1002 and rail_60e1 the axes are those of the profile, y from the gauge side to the
field side. A wheel lies at z > 0 with its axle at z = Wheel/Radius, a rail at z < 0.
Physical groups: 1 contact boundary, 2 hub (bore of a wheel, ends of an axle, sole of a rail), 3 the section.
"""
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

RADIUS, BORE, HUB_RADIUS, RIM_RADIUS = 0.46, 0.0925, 0.135, 0.39
HUB_HALF, RIM_HALF, WEB, WEB_OFFSET = 0.085, 0.0675, 0.030, 0.020


def wheel_blocks(n, hub_boundary, mirror=1., shift=0.):
    """The wheel with an S-shaped web: blocks of (place, numbers, boundaries); n elements through the web."""
    def middle(r):
        t = min(max((r - HUB_RADIUS) / (RIM_RADIUS - HUB_RADIUS), 0.), 1.)
        return WEB_OFFSET * (3 * t * t - 2 * t ** 3)

    def column(r0, r1, left, right):
        def place(s, t):
            r = between(r0, r1, s)
            return shift + mirror * between(left(r), right(r), t), RADIUS - r
        return place

    def at(y):
        return lambda r: y

    def web_left(r):
        return middle(r) - WEB / 2

    def web_right(r):
        return middle(r) + WEB / 2

    blocks = []
    for left, right, n_t in ((at(-HUB_HALF), web_left, 2), (web_left, web_right, 1), (web_right, at(HUB_HALF), 2)):
        blocks.append((column(BORE, HUB_RADIUS, left, right), n, n_t * n, hub_boundary))
    blocks.append((column(HUB_RADIUS, RIM_RADIUS, web_left, web_right), 6 * n, n, {}))
    for left, right, n_t in ((at(-RIM_HALF), web_left, 2), (web_left, web_right, 1), (web_right, at(RIM_HALF), 2)):
        blocks.append((column(RIM_RADIUS, RADIUS, left, right), 2 * n, n_t * n, {'s1': CONTACT}))
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


def profiled_wheel(n):
    """The tread has cells of 20 by 20 mm, as long when it is revolved in 144 parts; n elements through the web."""
    section = Section()
    profile = s1002()
    field_end = (65., profile[-1][1] - 5.)
    tip = nearest(profile, (-61.5, 26.))
    tread = part(profile, tip, 1.) + [field_end]
    back = [(-70., -4.), (-70., profile[0][1])] + part(profile, 0., tip)
    cells, rows, root = 10, 1, 4
    surface, root_at, end_at = polyline(tread), nearest(tread, (-36.5, 8.4)), nearest(tread, profile[-1])
    breaks = [root_at * k / root for k in range(root)] + [between(root_at, end_at, k / (cells - 1 - root)) for k in range(cells - root)] + [1.]
    inside = [(-53., 14.), (-49.5, 7.), (-45., 0.), (-39., -8.), (-31., -14.5), (-20., -19.), (-5., -22.), (65., -24.)]
    corner = nearest([polyline(inside)(k / 2000) for k in range(2001)], (-43.5, -2.))
    inner = [(-58., 15.)] + [polyline(inside)(corner * (i - 1) / (root - 1)) for i in range(1, root)]
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
    core = [line((-61., -6.), inner[0])(j / (root - 1)) for j in range(root)]
    behind = polyline(back)
    for j in range(root - 1):
        a, b = j / (root - 1), (j + 1) / (root - 1)
        add(coons(line(core[j], core[j + 1]), lambda s: behind(between(a, b, s)), line(core[j], behind(a)), line(core[j + 1], behind(b))),
            1, rows)
        add(coons(line(core[j], core[j + 1]), line(inner[root - j], inner[root - j - 1]), line(core[j], inner[root - j]),
                  line(core[j + 1], inner[root - j - 1])), 1, 1)
    top = [line((-70., -4.), core[0])(k / rows) for k in range(rows)] + [core[0]] + inner[root:]
    columns = len(top) - 1
    depth = 1e3 * (RADIUS - RIM_RADIUS)
    left, right = 1e3 * (WEB_OFFSET - WEB / 2), 1e3 * (WEB_OFFSET + WEB / 2)
    first = round(columns * (left + 70.) / 135.)
    bottom = ([(between(-70., left, k / first), -depth) for k in range(first)] + [(between(left, right, k / n), -depth) for k in range(n)]
              + [(between(right, 65., k / (columns - first - n)), -depth) for k in range(columns - first - n + 1)])
    for i in range(columns):
        add(coons(line(bottom[i], bottom[i + 1]), line(top[i], top[i + 1]), line(bottom[i], top[i]), line(bottom[i + 1], top[i + 1])), 1, 2)
    for place, n_s, n_t, sides in wheel_blocks(n, {'s0': HUB})[:4]:
        section.block(place, n_s, n_t, sides)
    area, *_ = section.properties()
    section.write('wheel_s1002', 'S1002, R 0.46 m, bore 0.0925 m, S-web of 30 mm, %d elements through it; A %.1f cm2' % (n, area * 1e4), 0.46)


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


if __name__ == '__main__':
    wheel(2)
    wheel(3)
    annular_plate(2)
    rail(2)
    rail(3)
    wheelset(2)
    profiled_wheel(2)
    profiled_rail(2)
