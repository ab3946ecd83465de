"""contact_problem.h5 read by h5py: its solution fulfils the laws that its arrays state.

usage: contact_problem.py FOLDER
"""

import csv
import sys

import h5py
import numpy as np

folder = sys.argv[1]
with h5py.File(folder + "/contact_problem.h5") as file:
    W = file["operators/W"][:]
    n = len(file["operators/positions"])
    T = len(W) // n - 1
    H = np.zeros((n, n))
    for row, column, value in file["operators/H"][:]:
        H[int(row), int(column)] += value
    gap, mu = file["loads/gap"][:], file["loads/friction"][:]
    p, approach = file["solution/pressure"][:], file["solution/approach"][0]
    q = file["solution/traction"][:].reshape(T, n)
    found_gap = file["solution/gap"][:]
    assert file["operators/W"].attrs["unit"] == "m/N"

forces = np.concatenate([H @ component for component in q] + [H @ p])
displacement = (W @ forces)[T * n:]
assert np.allclose(gap - approach + displacement, found_gap, atol=1e-9 * np.max(np.abs(displacement)))
touching = p > 0
assert touching.any() and not touching.all()
assert np.max(np.abs(found_gap[touching])) < 1e-6 * np.max(np.abs(displacement))
assert np.min(found_gap) > -1e-6 * np.max(np.abs(displacement))
assert np.all(np.sqrt((q**2).sum(axis=0)) <= mu * p * (1 + 1e-9) + 1e-9 * np.max(p))
with open(folder + "/results.csv", encoding="utf-8") as rows:
    result = next(csv.DictReader(rows))
assert np.isclose((H @ p).sum(), float(result["normal_force_N"]), rtol=1e-8)
assert np.isclose((H @ q[0]).sum(), float(result["force_x_N"]), rtol=1e-8)
