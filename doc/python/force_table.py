"""Creepages for forces: a small table for a vehicle model, which interpolates in loads and forces.

For each normal load N and each part of mu N that the wheel transmits along x and y: the creepages that have these forces,
and how far the forces may be off. Bodies are kept; a load with another patch makes them again.

Run: PYTHONPATH=build/python /usr/bin/python3 doc/python/force_table.py [FILE.csv]
"""

import itertools
import pathlib
import sys

import rolling_contact

SCENE = pathlib.Path(__file__).resolve().parents[2] / "prm/wheel_on_rail_3d.prm"
SETTINGS = {"Mesh/Elements across patch": 10, "Mesh/Growth": 0.8, "Mesh/Target error": ""}
COLUMNS = "normal_load_N,force_x_N,force_y_N,creepage_x,creepage_y,bound_of_mu_N"


def force_table(scene=SCENE, settings=None, loads=(76e3, 80e3, 84e3), parts=(0.0, 0.3, 0.6)):
    """Rows of COLUMNS, and how many sets of bodies were made."""
    given = rolling_contact.Scene(scene, SETTINGS if settings is None else settings)
    friction = float(given.entries.get("Contact/Friction coefficient", 0.3))
    without = {"Contact/Creepage x": 0, "Contact/Creepage y": 0, "Contact/Spin": 0}
    session = rolling_contact.Session(given, without)
    rows = []
    for load in loads:
        session["Contact/Normal load"] = load
        for part_x, part_y in itertools.product(parts, parts):
            session["Contact/Longitudinal force"] = -part_x * friction * load
            session["Contact/Lateral force"] = -part_y * friction * load
            state = session.solve()
            bound = state.bounds.force
            rows.append((load, state.force_x, state.force_y, *state.creepages[:2], bound))
    return rows, session.n_bodies_made


def main():
    rows, n_bodies = force_table()
    print("    N (kN)   T_x (kN)   T_y (kN)  creepage x  creepage y    bound")
    for load, force_x, force_y, creepage_x, creepage_y, bound in rows:
        known = "-" if bound is None else f"{bound:.4f}"
        print(f"{load / 1e3:10.1f} {force_x / 1e3:10.3f} {force_y / 1e3:10.3f} {creepage_x:11.6f} {creepage_y:11.6f} {known:>8s}")
    print(f"{len(rows)} states on {n_bodies} sets of bodies")
    if len(sys.argv) > 1:
        with open(sys.argv[1], "w") as file:
            print(COLUMNS, file=file)
            for row in rows:
                print(*("" if value is None else repr(value) for value in row), sep=",", file=file)


if __name__ == "__main__":
    main()
