# SPDX-License-Identifier: MIT
"""Matrices of a straight beam, which two of the examples take."""

import numpy as np
from scipy import sparse


def beam_matrices(elements, length, bending, mass_per_length):
    """Stiffness and mass of Euler-Bernoulli elements; rows are deflection [m] and slope [rad] of each
    node. `bending` is E I, N m^2."""
    h = length / elements
    stiffness_of_one = bending / h**3 * np.array([
        [12, 6 * h, -12, 6 * h], [6 * h, 4 * h**2, -6 * h, 2 * h**2],
        [-12, -6 * h, 12, -6 * h], [6 * h, 2 * h**2, -6 * h, 4 * h**2]])  # fmt: skip
    mass_of_one = mass_per_length * h / 420 * np.array([
        [156, 22 * h, 54, -13 * h], [22 * h, 4 * h**2, 13 * h, -3 * h**2],
        [54, 13 * h, 156, -22 * h], [-13 * h, -3 * h**2, -22 * h, 4 * h**2]])  # fmt: skip
    size = 2 * (elements + 1)
    stiffness, mass = sparse.lil_matrix((size, size)), sparse.lil_matrix((size, size))
    for element in range(elements):
        rows = slice(2 * element, 2 * element + 4)
        stiffness[rows, rows] += stiffness_of_one
        mass[rows, rows] += mass_of_one
    return stiffness.tocsr(), mass.tocsr()
