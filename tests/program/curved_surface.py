"""The forces of a state on a curved surface, from its interface.vtu alone: the
normals are those of the surface that the file draws. Prints force_y_N,
normal_force_N and spin_moment_Nm."""
import math
import sys

import vtu

field, _ = vtu.nodes(sys.argv[1])
section = sorted({(round(y, 9), round(z, 9)) for _, y, z in field["points"]})


def angle(y):
    """Slope of the section at y, downwards positive, from its neighbours."""
    k = min(range(len(section)), key=lambda i: abs(section[i][0] - y))
    (y0, z0), (y1, z1) = section[max(0, k - 1)], section[min(len(section) - 1, k + 1)]
    return -math.atan2(z1 - z0, y1 - y0)


across = upwards = moment = 0.0
for (x, y, _), area, p, (along, tangential, *_) in zip(
        field["points"], field["area"], field["pressure"], field["traction"]):
    turn = angle(y)
    force_y = area * (tangential * math.cos(turn) + p * math.sin(turn))
    across += force_y
    upwards += area * (p * math.cos(turn) - tangential * math.sin(turn))
    moment += x * force_y - y * area * along
print(across, upwards, moment)
