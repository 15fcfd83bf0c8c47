# SPDX-License-Identifier: BSD-3-Clause
"""SE2, SE3Quat and Sim3."""

import numpy as np

import boxplus

from . import _rows
from ._geometry import Isometry2d, Isometry3d, Quaternion, Rotation2d, rotation, unit_quaternion, vector


class SE2:
    """A pose in the plane: SE2(x, y, theta), SE2([x, y, theta]) or SE2(Isometry2d)."""

    def __init__(self, *values):
        if len(values) == 1 and isinstance(values[0], Isometry2d):
            values = (np.append(values[0].translation(), values[0]._R.angle()),)
        elif len(values) == 1 and hasattr(values[0], "theta"):  # boxplus.SE2
            values = (values[0].vector(),)
        elif len(values) == 1 and isinstance(values[0], SE2):
            values = (values[0]._row,)
        self._row = vector(values[0] if len(values) == 1 else values or (0, 0, 0), 3, "SE2")

    @classmethod
    def from_row(cls, row):
        pose = cls()
        pose._row = np.array(row, dtype=float)
        return pose

    def translation(self):
        return self._row[:2].copy()

    def rotation(self):
        return Rotation2d(self._row[2])

    def angle(self):
        return float(self._row[2])

    t = property(translation)
    R = property(lambda self: self.rotation().to_rotation_matrix())

    def set_translation(self, t):
        self._row[:2] = vector(t, 2, "translation")

    def set_rotation(self, R):
        self._row[2] = Rotation2d(R).angle()

    def vector(self):
        """x, y, theta."""
        return self._row.copy()

    to_vector = vector

    def from_vector(self, values):
        self._row = vector(values, 3, "SE2")

    def to_isometry(self):
        return Isometry2d(self._row[2], self._row[:2])

    Isometry2d = isometry = to_isometry

    def inverse(self):
        return SE2(_rows.inverse2(self._row[None])[0])

    def __mul__(self, other):
        if isinstance(other, SE2):
            return SE2(_rows.compose2(self._row[None], other._row[None])[0])
        return self._row[:2] + self.rotation() * other

    def __getitem__(self, i):
        return float(self._row[i])

    def __eq__(self, other):
        return isinstance(other, SE2) and bool((self._row == other._row).all())

    __hash__ = None

    def __repr__(self):
        return "SE2({:.9g}, {:.9g}, {:.9g})".format(*self._row)


class SE3Quat(Isometry3d):
    """A rigid motion: SE3Quat(R, t), SE3Quat(Quaternion, t) or a vector of 7 numbers (x y z qx qy qz qw) or 6 (the vector
    part of the quaternion only)."""

    def __init__(self, *values):
        if len(values) == 1 and not isinstance(values[0], Isometry3d) and np.ndim(values[0]) == 1:
            super().__init__()
            size = len(values[0])
            self.from_vector(values[0]) if size == 7 else self.from_minimal_vector(values[0])
        else:
            super().__init__(*values)
        self.normalize_rotation()

    def rotation(self):
        """A Quaternion. The matrix is R."""
        return self.orientation()

    def normalize_rotation(self):
        """Unit length, w ≥ 0."""
        q = unit_quaternion(self._row[3:])
        self._row[3:] = q if q[3] >= 0 else -q

    def to_vector(self):
        """x y z qx qy qz qw."""
        return self._row.copy()

    vector = to_vector

    def from_vector(self, values):
        values = vector(values, 7, "SE3Quat")
        self._row = np.append(values[:3], unit_quaternion(values[3:]))

    def to_minimal_vector(self):
        return _rows.minimal(self._row[None])[0]

    def from_minimal_vector(self, values):
        values = vector(values, 6, "SE3Quat")
        squared = values[3:] @ values[3:]
        q = np.append(values[3:], np.sqrt(1 - squared)) if squared < 1 else np.append(-values[3:], 0)
        self._row = np.append(values[:3], unit_quaternion(q))

    def log(self):
        """omega, upsilon."""
        return _rows.logarithm(self._row[None])[0]

    @staticmethod
    def exp(tangent):
        return SE3Quat.from_row(boxplus.SE3.exp(np.roll(vector(tangent, 6, "tangent"), 3)).vector())

    def adj(self):
        """The adjoint matrix (6, 6), for tangents (omega, upsilon)."""
        R = self.R
        result = np.zeros((6, 6))
        result[:3, :3] = result[3:, 3:] = R
        result[3:, :3] = np.cross(np.eye(3), self._row[:3]).T @ R * -1
        return result

    def map(self, point):
        return self * point

    def to_homogeneous_matrix(self):
        return self.matrix()

    def to_isometry(self):
        return Isometry3d.from_row(self._row)

    Isometry3d = isometry = to_isometry

    def __getitem__(self, i):
        return float(self._row[i])


class Sim3:
    """A similarity p → s R p + t: Sim3(Quaternion or R, t, s), or a tangent vector (omega, upsilon, sigma)."""

    def __init__(self, *values):
        if len(values) == 3:
            R, t, s = values
            if not float(s) > 0:
                raise ValueError(f"Sim3: expected a scale above 0, got {s!r}")
            q = Quaternion(R if isinstance(R, Quaternion) else rotation(R)).coeffs()
            self._row = np.concatenate([vector(t, 3, "translation"), unit_quaternion(q), [float(s)]])
        elif len(values) == 1:
            self._row = values[0]._row.copy() if isinstance(values[0], Sim3) else boxplus.Sim3.exp(
                vector(values[0], 7, "Sim3")).vector()
        elif values:
            raise TypeError("Sim3: expected a rotation, a translation and a scale")
        else:
            self._row = np.array([0.0, 0, 0, 0, 0, 0, 1, 1])

    @classmethod
    def from_row(cls, row):
        result = cls()
        result._row = np.array(row, dtype=float)
        return result

    def _native(self):
        return boxplus.Sim3.from_vector(self._row)

    def translation(self):
        return self._row[:3].copy()

    def rotation(self):
        return Quaternion(self._row[3:7])

    def scale(self):
        return float(self._row[7])

    def log(self):
        return self._native().log()

    def map(self, point):
        return self._native() * vector(point, 3, "point")

    def inverse(self):
        return Sim3.from_row(self._native().inverse().vector())

    def __mul__(self, other):
        if isinstance(other, Sim3):
            return Sim3.from_row((self._native() * other._native()).vector())
        return self.map(other)

    def __repr__(self):
        return f"Sim3({self.rotation()!r}, {self._row[:3].tolist()}, {self._row[7]:.9g})"
