# SPDX-License-Identifier: BSD-3-Clause
"""Estimates and measurements as rows of numbers."""

import numpy as np

from ._geometry import Isometry3d, vector
from ._poses import SE2, SE3Quat, Sim3


class Codec:
    """`name` for messages. encode(value) gives a new row, decode(row) the value of the API. turn(row) gives the numbers of
    the value, and a row of these numbers."""

    def __init__(self, name, origin, encode, decode, turn=np.copy):
        self.name, self.origin, self.encode, self.decode, self.turn = name, np.array(origin, dtype=float), encode, decode, turn
        self.size = len(self.origin)


def _pose(cls):
    def encode(value):
        return (value if isinstance(value, cls) else cls(value))._row.copy()

    return encode


def _vector(size):
    return Codec(f"Vector{size}", np.zeros(size), lambda value: vector(value, size, f"Vector{size}"), np.copy)


def _number(value):
    return vector(np.ravel(value), 1, "number")


_ISOMETRY = [0, 0, 0, 0, 0, 0, 1]
POSE2 = Codec("SE2", np.zeros(3), _pose(SE2), SE2.from_row)
ISOMETRY = Codec("Isometry3d", _ISOMETRY, _pose(Isometry3d), Isometry3d.from_row)
QUAT = Codec("SE3Quat", _ISOMETRY, _pose(SE3Quat), SE3Quat.from_row)
#: The row is the inverse, with which boxplus counts.
SIMILARITY = Codec("Sim3", [*_ISOMETRY, 1], lambda value: Sim3(value).inverse()._row,
                   lambda row: Sim3.from_row(row).inverse(), lambda row: Sim3.from_row(row).inverse()._row)
NUMBER = Codec("float", np.zeros(1), _number, lambda row: float(row[0]))
POINT2, POINT3, VECTOR4 = _vector(2), _vector(3), _vector(4)


def vectors(size):
    return _vector(size)
