"""A wheelset that is shifted across the track: where the right-hand wheel touches, with which forces, in the axes of the track.

Run: PYTHONPATH=build/python /usr/bin/python3 doc/python/profile_series.py [FILE.csv]
"""

import csv
import pathlib
import sys

import rolling_contact

SCENE = pathlib.Path(__file__).resolve().parents[2] / "prm/profiles_worn.prm"
COLUMNS = ("shift_mm", "wheel_y_mm", "angle_mrad", "patches", "max_pressure_MPa", "forward_N", "right_N", "bound")


def series(scene=SCENE, shifts=(-0.004, -0.002, 0.0, 0.002, 0.004), settings=None):
    """Rows of COLUMNS for lateral shifts (m) on bodies that are kept, and how often bodies were made."""
    rows = []
    with rolling_contact.Session(scene, settings) as session:
        for shift in shifts:
            session.profiles.lateral_shift = shift
            state = session.solve()
            forward, right, _ = state.force_track
            rows.append(
                (
                    1e3 * shift,
                    1e3 * state.contact_y_wheel,
                    1e3 * state.contact_angle,
                    len(state.patches),
                    1e-6 * max(patch["max_pressure_Pa"] for patch in state.patches),
                    forward,
                    right,
                    state.bounds.force,
                )
            )
        return rows, session.n_bodies_made


def main():
    rows, n_bodies = series()
    print(" ".join(f"{name:>16s}" for name in COLUMNS))
    for row in rows:
        print(" ".join(f"{value:16.5g}" for value in row))
    print(f"bodies made: {n_bodies}")
    if len(sys.argv) > 1:
        with open(sys.argv[1], "w", newline="") as file:
            csv.writer(file).writerows([COLUMNS, *rows])


if __name__ == "__main__":
    main()
