# SPDX-License-Identifier: BSD-3-Clause
"""The types of vertices that boxplus has: their rows, and steps in their tangent spaces."""

import warnings

import numpy as np

import boxplus


def warn(text):
    warnings.warn(text, RuntimeWarning, stacklevel=3)


class Kind:
    """`type`: the class of boxplus. `size`: of a row. `dim`: of the tangent space. `translations`: of a pose, the directions
    that are translations."""

    def __init__(self, name, type, size, dim, translations=None):
        self.name, self.type, self.size, self.dim, self.translations = name, type, size, dim, translations


SE2 = Kind("SE2", boxplus.SE2, 3, 3, range(2))
SE3 = Kind("SE3", boxplus.SE3, 7, 6, range(3))
SIM3 = Kind("Sim3", boxplus.Sim3, 8, 7, range(3, 6))
VECTORS = {n: Kind(f"Vector{n}", getattr(boxplus, f"Vector{n}"), n, n) for n in range(1, 13)}
MOST = max(VECTORS)


def pieces(dimension):
    """The kinds of vectors that together have this dimension."""
    whole, rest = divmod(dimension, MOST)
    return [VECTORS[MOST]] * whole + ([VECTORS[rest]] if rest else [])


def moved(kind, rows, steps):
    """rows ⊞ steps, with steps (n, dim). It is ⊞ of boxplus."""
    if kind.translations is None:
        return rows + steps
    return np.array([kind.type.from_vector(row).oplus(step).vector() for row, step in zip(rows, steps)])


def sizes(kind, rows, direction):
    """The size of the number that a step in this direction changes, for the width of a difference."""
    if kind.translations is None:
        return np.abs(rows[:, direction])
    is_translation = direction in kind.translations
    return np.abs(rows[:, :len(kind.translations)]).max(axis=1) if is_translation else np.ones(len(rows))
