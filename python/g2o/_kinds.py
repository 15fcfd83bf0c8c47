# SPDX-License-Identifier: BSD-3-Clause
"""The types of vertices that boxplus has: their rows, and steps in their tangent spaces."""

import warnings

import numpy as np

import boxplus

from . import _rows


def warn(text):
    warnings.warn(text, RuntimeWarning, stacklevel=3)


class Kind:
    """`type`: the class of boxplus. `size`: of a row. `dim`: of the tangent space."""

    def __init__(self, name, type, size, dim):
        self.name, self.type, self.size, self.dim = name, type, size, dim


SE2 = Kind("SE2", boxplus.SE2, 3, 3)
SE3 = Kind("SE3", boxplus.SE3, 7, 6)
VECTORS = {n: Kind(f"Vector{n}", getattr(boxplus, f"Vector{n}"), n, n) for n in range(1, 13)}
MOST = max(VECTORS)


def pieces(dimension):
    """The kinds of vectors that together have this dimension."""
    whole, rest = divmod(dimension, MOST)
    return [VECTORS[MOST]] * whole + ([VECTORS[rest]] if rest else [])


def moved(kind, rows, steps):
    """rows ⊞ steps, with steps (n, dim). It is ⊞ of boxplus."""
    if kind is SE2:
        return _rows.compose2(rows, steps)
    if kind is SE3:
        v = steps[:, 3:]
        w = np.sqrt(1 - (v * v).sum(axis=1, keepdims=True))
        return _rows.compose(rows, np.concatenate([steps[:, :3], v, w], axis=1))
    return rows + steps


def sizes(kind, rows, direction):
    """The size of the number that a step in this direction changes, for the width of a difference."""
    if kind is SE2 or kind is SE3:
        count = kind.dim // 3 + 1
        return np.abs(rows[:, :count]).max(axis=1) if direction < count else np.ones(len(rows))
    return np.abs(rows[:, direction])
