"""A wheelset in a curve, co-simulated with an FMU of `Analysis = fmu`, until it stands still.

The wheelset has a mass m, inertias I_z and I_y about the vertical and its axle, and a suspension with the yaw stiffness K
to a frame that stands at -a/R against the radial direction (a: half the wheelbase). Forces on it are those of the FMU,

    m y'' = sum F_y - c y',  I_z psi'' = sum M_z + K (-a/R - psi) - c_psi psi',  I_y Omega' = sum M_y,

with dampers c and c_psi, so that it comes to rest where `Analysis = wheelset` finds its equilibrium.

Run: /usr/bin/python3 doc/python/fmu_in_curve.py output/wheelset_fmu/wheelset_fmi3.fmu 1500
"""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

from fmu import Fmu

FORCES = [f"{side}.{name}" for side in ("right", "left") for name in ("force_y", "moment_y", "moment_z", "force_bound")]


def co_simulate(
    path,
    radius,
    axle_load=120e3,
    yaw_stiffness=10e6,
    half_wheelbase=0.9,
    mass=1500.0,
    yaw_inertia=900.0,
    axle_inertia=80.0,
    damping=3e4,
    yaw_damping=3e4,
    dt=2e-4,
    duration=4.0,
    place=(0.0, 0.0, 0.0),
):
    """From a place (shift, yaw, excess) at rest. Where it comes to rest: a dict of shift (m), yaw (rad), excess of the axle's speed over V/r0, forces by name (N),
    whether both wheels are within the table, and what is left of the balances of force (N), moment and torque (N m)."""
    with Fmu(path) as fmu:
        wheelset = fmu.instantiate()
        r0 = float(fmu.by_name["wheel_radius"].start)
        speed = float(fmu.by_name["speed"].start)
        v = yaw_rate = 0.0
        y, yaw, excess = place
        axle = -(1 + excess) * speed / r0
        frame = -half_wheelbase / radius
        inputs = {"right.load": axle_load / 2, "left.load": axle_load / 2, "curvature": 1 / radius}
        wheelset.initialise(**inputs)
        for _ in range(round(duration / dt)):
            wheelset.set(lateral_shift=y, yaw=yaw, lateral_velocity=v, yaw_rate=yaw_rate, axle_speed=axle)
            wheelset.step(dt)
            forces = dict(zip(FORCES, wheelset.get(*FORCES)))
            force = forces["right.force_y"] + forces["left.force_y"]
            turn = forces["right.moment_z"] + forces["left.moment_z"] + yaw_stiffness * (frame - yaw)
            torque = forces["right.moment_y"] + forces["left.moment_y"]
            v += dt * force / mass
            v /= 1 + dt * damping / mass
            yaw_rate += dt * turn / yaw_inertia
            yaw_rate /= 1 + dt * yaw_damping / yaw_inertia
            axle += dt * torque / axle_inertia
            y += dt * v
            yaw += dt * yaw_rate
        inside = wheelset.get("right.inside_table", "left.inside_table")
        wheelset.terminate()
        wheelset.free()
        return {
            "shift": y,
            "yaw": yaw,
            "excess": -axle * r0 / speed - 1,
            "forces": forces,
            "inside": all(inside),
            "left_over": (force, turn, torque),
        }


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: fmu_in_curve.py FMU RADIUS")
    found = co_simulate(sys.argv[1], float(sys.argv[2]))
    print(f"shift {found['shift'] * 1e3:.4f} mm, yaw {found['yaw'] * 1e3:.4f} mrad, excess {found['excess']:.3e}")
    for side in ("right", "left"):
        forces = found["forces"]
        print(f"{side}: {forces[side + '.force_y']:.1f} N to the right, within {forces[side + '.force_bound']:.1f} N")
    print("inside the table" if found["inside"] else "outside the table")
    if not all(math.isfinite(value) and abs(value) < 50 for value in found["left_over"]):
        sys.exit(f"it does not stand still: {found['left_over']}")


if __name__ == "__main__":
    main()
