#!/usr/bin/env python3
"""table.h5 says what results.csv says. Usage: table_file.py GRID UNSOLVED ROWS,
folders of runs of Analysis = table."""
import csv
import sys

import h5py
import numpy as np


def rows_of(folder):
    with open(folder + "/results.csv", newline="") as file:
        return list(csv.DictReader(file))


def same(array, texts):
    """Whether an array holds these numbers with all digits, of which the texts
    have nine; NaN for empty texts."""
    wanted = np.array([float(text) if text else np.nan for text in texts])
    return np.allclose(np.asarray(array).reshape(-1), wanted, rtol=5e-9, atol=0,
                       equal_nan=True)


def check_grid(folder):
    rows = rows_of(folder)
    file = h5py.File(folder + "/table.h5")
    axes = file.attrs["axes"].split(", ")
    assert axes == ["contact_normal_load", "contact_creepage_x",
                    "contact_creepage_y", "contact_spin"], axes
    force = file["results/force_y_N"]
    assert force.shape == tuple(len(file["axes/" + name]) for name in axes)
    assert force.attrs["unit"] == "N"
    for d, name in enumerate(axes):
        scale = force.dims[d][0]
        assert scale == file["axes/" + name] and h5py.h5ds.is_scale(scale.id)
        assert force.dims[d].label == name
        entry = scale.attrs["entry"]
        shape = [1] * len(axes)
        shape[d] = -1
        grid = np.broadcast_to(scale[:].reshape(shape), force.shape)
        assert same(grid, [row[entry] for row in rows]), entry
    assert file["axes/contact_spin"].attrs["unit"] == "1/m"
    assert file["axes/contact_creepage_x"].attrs["unit"] == "1"
    n_arrays = 0
    for name, array in file["results"].items():
        column = array.attrs["column"]
        assert same(array, [row[column] for row in rows]), column
        n_arrays += 1
    assert n_arrays > 30
    assert file["results/spin_moment_Nm"].attrs["unit"] == "Nm"
    assert file["results/contact_area_m2"].attrs["unit"] == "m2"
    assert file["results/bound_force_per_muN"].attrs["unit"] == "mu N"
    assert file["results/traction_coefficient"].attrs["unit"] == "1"
    bound = file[force.attrs["bound"]]
    assert bound.attrs["unit"] == "N"
    wanted = 0.3 * file["results/normal_force_N"][:] * \
        file["results/bound_force_per_muN"][:]
    assert np.allclose(bound[:], wanted, rtol=1e-8)
    wanted = wanted / file["results/bound_force_per_muN"][:] * \
        file["results/bound_moment_per_muNa"][:] * \
        file["results/half_width_x_m"][:]
    assert np.allclose(file["bounds/spin_moment_Nm"][:], wanted, rtol=1e-8)
    assert (file["status"][:] == 1).all()
    assert "Analysis" in file["scene"][()].decode()


def check_unsolved(folder):
    rows = rows_of(folder)
    file = h5py.File(folder + "/table.h5")
    status = file["status"][:].reshape(-1)
    for k, row in enumerate(rows):
        assert status[k] == (1 if row["status"] == "solved" else 3)
    force = file["results/force_x_N"][:].reshape(-1)
    assert np.isnan(force[status == 3]).all()
    assert np.isfinite(force[status == 1]).all()
    assert (status == 3).any()


def check_rows(folder):
    rows = rows_of(folder)
    file = h5py.File(folder + "/table.h5")
    assert file.attrs["kind"] == "rows"
    assert file["results/force_x_N"].shape == (len(rows),)
    assert same(file["axes/contact_friction_coefficient"],
                [row["Contact/Friction coefficient"] for row in rows])
    assert list(file["status"]) == [2 if row["status"] == "no contact" else 1
                                    for row in rows]
    mu = file["axes/contact_friction_coefficient"][:]
    solved = (file["status"][:] == 1) & (mu > 0)
    assert np.allclose(file["bounds/force_x_N"][:][solved],
                       (mu * file["results/normal_force_N"][:] *
                        file["results/bound_force_per_muN"][:])[solved])


check_grid(sys.argv[1])
check_unsolved(sys.argv[2])
check_rows(sys.argv[3])
