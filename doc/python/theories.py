"""The program beside the theories of half-spaces over longitudinal creepage: Kalker, FASTSIM, Polach, Shen.

Run: PYTHONPATH=build/python /usr/bin/python3 doc/python/theories.py [PICTURE.svg]    # the picture needs matplotlib
"""

import pathlib
import sys

import numpy

import rolling_contact
from rolling_contact import references

SCENE = pathlib.Path(__file__).resolve().parents[2] / "prm/combined_3d.prm"


def theories(scene=SCENE, creepages=(0.0002, 0.0005, 0.001, 0.002, 0.004, 0.008), settings=None):
    """{name: T/(mu N)} over the creepages and "bound", of alike bodies with radii (m, Pa)."""
    with rolling_contact.Session(scene, settings) as session:
        session.contact.creepage_y = session.contact.spin = 0
        found, bounds = [], []
        for creepage in creepages:
            session.contact.creepage_x = creepage
            state = session.solve()
            found.append(-state.force_x / state.friction_force)
            bounds.append(state.bounds.force)
        young, poisson = float(session.wheel.young_modulus), float(session.wheel.poisson_ratio)
        friction = float(session.contact.friction_coefficient)
        curvatures = []
        for along in ("radius", "lateral_radius"):
            radii = [float(getattr(body, along)) for body in (session.wheel, session.rail)]
            curvatures.append(sum(0.5 / radius for radius in radii if radius))
        load = state.normal_force
    modulus = references.contact_modulus(young, poisson, young, poisson)
    ellipse = references.hertz_ellipse(load, *curvatures, modulus)
    table = {"creepage": numpy.array(creepages), "program": numpy.array(found), "bound": numpy.array(bounds, float)}
    elastic = (ellipse, young / (2 * (1 + poisson)), poisson)
    table["kalker"] = -references.kalker(creepages, 0.0, 0.0, *elastic)[..., 0] / (friction * load)
    for name in ("fastsim", "polach", "shen_hedrick_elkins"):
        forces = getattr(references, name)(creepages, 0.0, 0.0, *elastic, friction)
        table[name] = -forces[..., 0] / (friction * load)
    return table


def main():
    table = theories()
    print(" ".join(f"{name:>12.12s}" for name in table))
    for row in zip(*table.values()):
        print(" ".join(f"{value:12.5f}" for value in row))
    if len(sys.argv) > 1:
        import matplotlib.pyplot as pyplot

        axes = pyplot.figure().add_subplot()
        for name in ("kalker", "fastsim", "polach", "shen_hedrick_elkins"):
            axes.plot(100 * table["creepage"], table[name], label=name)
        axes.errorbar(100 * table["creepage"], table["program"], table["bound"], fmt="ko", label="program, bound")
        axes.set_xlabel("longitudinal creepage (%)")
        axes.set_ylabel("T/(mu N)")
        axes.set_ylim(0, 1.15)
        axes.legend()
        axes.figure.savefig(sys.argv[1])


if __name__ == "__main__":
    main()
