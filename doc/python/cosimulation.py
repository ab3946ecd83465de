"""A mass on a spring, driven by a wheel that slides on a rail: co-simulation against its closed form.

The wheel is fixed to a mass m on a spring k and slides at the creepage xi0 on a rail that passes at
the speed V. Its velocity v along x adds to the creepage, xi = xi0 + v/V, and friction that falls with
the sliding speed drives it: m x'' + k x = T(xi) - T(xi0). For small oscillations

    x'' - 2 sigma x' + omega0^2 x = 0,   sigma = T'(xi0) / (2 m V),   omega0^2 = k/m,

which grows where T' > 0, as T < 0 falls in size. T' is taken from steady states (rolling_contact.Session),
the growth from steps in time (rolling_contact.Transient), where the mass is the master: it integrates by the
trapezoidal rule and repeats each step until force and velocity at its end belong together.

The bodies give way by C T under the force, which the closed form leaves out: it changes omega by the part sigma tau and
sigma by about twice that, tau = C T'/V. Without inertia they run away under falling friction within tau, 0.3 ms here, and
steps have to be several times as long.

Run: PYTHONPATH=build/python /usr/bin/python3 doc/python/cosimulation.py
"""

import math
import pathlib
import sys

import numpy as np

import rolling_contact

SCENE = pathlib.Path(__file__).resolve().parents[2] / "prm/falling_friction_2d.prm"


def slope_of_creep_curve(scene, settings, creepage, difference):
    """dT/dxi of steady states, by a central difference of fourth order. Unit: N."""
    session = rolling_contact.Session(scene, settings)

    def force(part):
        session["Contact/Creepage x"] = creepage + part * difference
        return session.solve().force_x

    force(0.0)
    return (8 * (force(1) - force(-1)) - (force(2) - force(-2))) / (12 * difference)


def co_simulate(transient, mass, stiffness, creepage, speed, x, dt, n_steps, tolerance=1e-10):
    """Displacement and velocity of the mass at the ends of the steps, released at rest at x.

    Units: kg, N/m, 1, m/s, m, s; (n_steps + 1, 2) of m and m/s, and how many steps of contact were taken.
    """
    force_at_rest = transient.state.force_x
    largest = abs(x) * math.sqrt(stiffness / mass)
    v, force, n_taken = 0.0, 0.0, 0
    motion = [(x, v)]
    for _ in range(n_steps):
        saved = transient.save()
        acceleration = (force - stiffness * x) / mass
        v_end = v + dt * acceleration
        while True:
            state = transient.step(dt, creepage_x=creepage + v_end / speed)
            n_taken += 1
            force_end = state.force_x - force_at_rest
            # trapezoidal rule, implicit in the spring
            x_without = x + dt * v / 2
            v_next = v + dt / 2 * (acceleration + (force_end - stiffness * x_without) / mass)
            v_next /= 1 + dt**2 * stiffness / (4 * mass)
            if abs(v_next - v_end) <= tolerance * largest:
                break
            v_end = v_next
            transient.restore(saved)
        x, v, force = x + dt * (v + v_end) / 2, v_end, force_end
        motion.append((x, v))
    return np.array(motion), n_taken


def growth_and_frequency(x, dt):
    """sigma and omega of an oscillation by least squares, without what the trapezoidal rule changes.

    Where x' = lambda x it gives x_n = z^n with z = (1 + lambda dt/2) / (1 - lambda dt/2). Units: 1/s, 1/s.
    """
    rows = np.column_stack([x[1:-1], -x[:-2]])
    (trace, determinant), *_ = np.linalg.lstsq(rows, x[2:], rcond=None)
    root = np.emath.sqrt(trace * trace / 4 - determinant)
    z = trace / 2 + root
    rate = 2 / dt * (z - 1) / (z + 1)
    return rate.real, abs(rate.imag)


def compare(
    scene=SCENE,
    elements=24,
    creepage=0.006,
    mass=20000.0,
    frequency=5.0,
    n_cycles=4,
    steps_per_cycle=80,
    amplitude=1e-3,
):
    """The closed form and what is co-simulated: a dict of both, in SI units.

    The amplitude is that of v over xi0 V at the start.
    """
    settings = {"Mesh/Elements across patch": elements, "Contact/Creepage x": creepage}
    speed = float(rolling_contact.Scene(scene, settings).entries["Contact/Speed"])
    slope = slope_of_creep_curve(scene, settings, creepage, 0.02 * creepage)
    stiffness = mass * (2 * math.pi * frequency) ** 2
    sigma = slope / (2 * mass * speed)
    dt = 1 / (frequency * steps_per_cycle)
    transient = rolling_contact.Transient(
        scene, {**settings, "Time/Inertia": False, "Time/Initial state": "steady"}, time_step=dt
    )
    start = amplitude * creepage * speed / (2 * math.pi * frequency)
    motion, n_taken = co_simulate(
        transient, mass, stiffness, creepage, speed, start, dt, n_cycles * steps_per_cycle
    )
    found, omega = growth_and_frequency(motion[:, 0], dt)
    return {
        "slope": slope,
        "sigma": sigma,
        "omega": math.sqrt(stiffness / mass - sigma**2),
        "sigma_found": found,
        "omega_found": omega,
        "motion": motion,
        "dt": dt,
        "n_taken": n_taken,
    }


def main():
    result = compare()
    motion, dt = result["motion"], result["dt"]
    print(f"slope of the creep curve  dT/dxi = {result['slope']:.6g} N")
    for name, unit in (("sigma", "growth"), ("omega", "frequency")):
        closed, found = result[name], result[name + "_found"]
        print(f"{unit:10s} closed form {closed:9.5f} 1/s, co-simulated {found:9.5f} 1/s, error {found / closed - 1:+.2e}")
    print(f"{len(motion) - 1} steps of {dt:.3g} s, {result['n_taken']} steps of contact")
    if len(sys.argv) > 1:
        time = dt * np.arange(len(motion))
        np.savetxt(sys.argv[1], np.column_stack([time, motion]), delimiter=",", header="time_s,x_m,v_m/s", comments="")


if __name__ == "__main__":
    main()
