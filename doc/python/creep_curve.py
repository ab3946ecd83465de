"""A creep curve with its error bounds, on bodies that are kept from point to point.

Run: PYTHONPATH=build/python /usr/bin/python3 doc/python/creep_curve.py [FILE.csv]
"""

import pathlib
import sys
import time

import rolling_contact

SCENE = pathlib.Path(__file__).resolve().parents[2] / "prm/lateral_3d_partial_slip.prm"
COLUMNS = "creepage_y,force_over_mu_N,bound,stick_share,ms"


def creep_curve(scene=SCENE, creepages=(0, 0.0005, 0.001, 0.002, 0.003, 0.005, 0.008), settings=None):
    """Rows of lateral creepage, T/(mu N), its bound (None if not known), share that sticks, and wall time in ms."""
    session = rolling_contact.Session(scene, settings)
    rows = []
    for creepage in creepages:
        session["Contact/Creepage y"] = creepage
        begin = time.perf_counter()
        state = session.solve()
        taken = 1e3 * (time.perf_counter() - begin)
        share = state.stick_area / state.contact_area
        rows.append((creepage, state.force_y / state.friction_force, state.bounds.force, share, taken))
    return rows


def main():
    rows = creep_curve()
    print("creepage y   T/(mu N)    bound   sticks        ms")
    for creepage, force, bound, share, taken in rows:
        known = "      -" if bound is None else f"{bound:7.4f}"
        print(f"{creepage:10.4f} {force:10.4f}  {known} {share:7.1%} {taken:9.1f}")
    if len(sys.argv) > 1:
        with open(sys.argv[1], "w") as file:
            print(COLUMNS, file=file)
            for row in rows:
                print(*("" if value is None else repr(value) for value in row), sep=",", file=file)


if __name__ == "__main__":
    main()
