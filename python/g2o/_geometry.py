# SPDX-License-Identifier: BSD-3-Clause
"""Rotations and poses with the names of Eigen. Lengths are in meters, angles in radians."""

import math

import numpy as np

from . import _rows


def is_finite(array):
    return math.isfinite(np.add.reduce(array, axis=None)) or bool(np.isfinite(array).all())  # a sum may overflow


def _array(values):
    try:
        return np.array(values, dtype=float)
    except (TypeError, ValueError):
        return np.array([])  # of no allowed shape


def vector(values, size, name):
    """A new array of `size` finite numbers."""
    array = _array(values)
    if array.shape != (size,) and array.shape in ((size, 1), (1, size)):
        array = array.reshape(size)
    if array.shape != (size,) or not is_finite(array):
        raise ValueError(f"{name}: expected {size} finite numbers, got {values!r}")
    return array


def matrix(values, shape, name):
    array = _array(values)
    if array.shape != shape or not is_finite(array):
        raise ValueError(f"{name}: expected a finite matrix of the shape {shape}, got {values!r}")
    return array


def rotation(values, name="rotation"):
    array = matrix(values, (3, 3), name)
    if not np.allclose(array @ array.T, np.eye(3), atol=1e-6) or np.linalg.det(array) < 0:
        raise ValueError(f"{name}: expected a rotation matrix, got {array.tolist()}")
    return array


def unit_quaternion(values, name="quaternion"):
    """(x, y, z, w) of length 1."""
    q = vector(values, 4, name)
    length = np.linalg.norm(q)
    if length == 0:
        raise ValueError(f"{name}: expected a quaternion that is not zero")
    return q if abs(length - 1) < 1e-15 else q / length


def quaternion_of_matrix(R):
    """(x, y, z, w) of a rotation matrix: the eigenvector of the largest eigenvalue (Bar-Itzhack, "New method for extracting
    the quaternion from a rotation matrix", 2000)."""
    K = np.array([[R[0, 0] - R[1, 1] - R[2, 2], R[1, 0] + R[0, 1], R[2, 0] + R[0, 2], R[2, 1] - R[1, 2]],
                  [R[1, 0] + R[0, 1], R[1, 1] - R[0, 0] - R[2, 2], R[2, 1] + R[1, 2], R[0, 2] - R[2, 0]],
                  [R[2, 0] + R[0, 2], R[2, 1] + R[1, 2], R[2, 2] - R[0, 0] - R[1, 1], R[1, 0] - R[0, 1]],
                  [R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1], R[0, 0] + R[1, 1] + R[2, 2]]])
    q = np.linalg.eigh(K)[1][:, 3]
    return q if q[3] >= 0 else -q


class AngleAxis:
    def __init__(self, angle=0.0, axis=(1, 0, 0)):
        if isinstance(angle, AngleAxis):
            angle, axis = angle.angle(), angle.axis()
        elif isinstance(angle, Quaternion) or np.ndim(angle) == 2:
            omega = _rows.rotation_vector(Quaternion(angle).coeffs()[None])[0]
            angle = float(np.linalg.norm(omega))
            axis = omega / angle if angle > 0 else axis
        self._angle, self._axis = float(angle), vector(axis, 3, "AngleAxis")

    def angle(self):
        return self._angle

    def axis(self):
        return self._axis.copy()

    def inverse(self):
        return AngleAxis(-self._angle, self._axis)

    def to_rotation_matrix(self):
        return Quaternion(self).to_rotation_matrix()

    rotation_matrix = matrix = to_rotation_matrix

    def __mul__(self, other):
        return Quaternion(self) * (Quaternion(other) if isinstance(other, AngleAxis) else other)

    def __repr__(self):
        return f"AngleAxis({self._angle:.9g}, {self._axis.tolist()})"


class Quaternion:
    """Quaternion(w, x, y, z), Quaternion([x, y, z, w]), Quaternion(R) or Quaternion(AngleAxis)."""

    def __init__(self, *values):
        if not values:
            self._q = np.array([0.0, 0, 0, 1])
        elif len(values) == 4:
            self._q = vector([values[1], values[2], values[3], values[0]], 4, "Quaternion")
        elif len(values) != 1:
            raise TypeError(f"Quaternion: expected w, x, y, z, got {len(values)} arguments")
        elif isinstance(values[0], Quaternion):
            self._q = values[0]._q.copy()
        elif isinstance(values[0], AngleAxis):
            half = values[0].angle() / 2
            self._q = np.append(math.sin(half) * values[0].axis(), math.cos(half))
        elif np.ndim(values[0]) == 2:
            self._q = quaternion_of_matrix(rotation(values[0], "Quaternion"))
        else:
            self._q = vector(values[0], 4, "Quaternion")

    @staticmethod
    def identity():
        return Quaternion()

    @staticmethod
    def from_two_vectors(a, b):
        """The shortest rotation from the direction of a to the direction of b."""
        a, b = vector(a, 3, "a"), vector(b, 3, "b")
        a, b = a / np.linalg.norm(a), b / np.linalg.norm(b)
        w = 1 + a @ b
        if w < 1e-12:  # opposite directions: half a turn around any normal
            normal = np.cross(a, np.eye(3)[np.argmin(np.abs(a))])
            return Quaternion(np.append(normal, 0)).normalized()
        return Quaternion(np.append(np.cross(a, b), w)).normalized()

    def set_identity(self):
        self._q = np.array([0.0, 0, 0, 1])

    def x(self):
        return float(self._q[0])

    def y(self):
        return float(self._q[1])

    def z(self):
        return float(self._q[2])

    def w(self):
        return float(self._q[3])

    def vec(self):
        return self._q[:3].copy()

    def coeffs(self):
        """x, y, z, w."""
        return self._q.copy()

    def norm(self):
        return float(np.linalg.norm(self._q))

    def squared_norm(self):
        return float(self._q @ self._q)

    def normalize(self):
        self._q = self._q / np.linalg.norm(self._q)

    def normalized(self):
        return Quaternion(self._q / np.linalg.norm(self._q))

    def conjugate(self):
        return Quaternion(_rows.conjugate(self._q))

    def inverse(self):
        return Quaternion(_rows.conjugate(self._q) / self.squared_norm())

    def dot(self, other):
        return float(self._q @ other._q)

    def angular_distance(self, other):
        q = (self.conjugate() * other)._q
        return 2 * math.atan2(np.linalg.norm(q[:3]), abs(q[3]))

    def slerp(self, t, other):
        """The rotation at the fraction t of the way to the other one."""
        step = AngleAxis((self.inverse() * other).normalized())
        return self * AngleAxis(t * step.angle(), step.axis())

    def to_rotation_matrix(self):
        return _rows.matrix_of(self._q[None])[0]

    rotation_matrix = matrix = to_rotation_matrix
    R = property(to_rotation_matrix)

    def is_approx(self, other, precision=1e-12):
        return bool(np.linalg.norm(self._q - other._q) <= precision * min(self.norm(), other.norm()))

    def __mul__(self, other):
        if isinstance(other, (Quaternion, AngleAxis)):
            return Quaternion(_rows.multiply(self._q[None], Quaternion(other)._q[None])[0])
        return _rows.rotate(self._q[None], vector(other, 3, "point")[None])[0]

    def __eq__(self, other):
        return isinstance(other, Quaternion) and bool((self._q == other._q).all())

    __hash__ = None

    def __repr__(self):
        x, y, z, w = (f"{value:.9g}" for value in self._q)
        return f"Quaternion({w}, {x}, {y}, {z})"


class Rotation2d:
    def __init__(self, angle=0.0):
        if isinstance(angle, Rotation2d):
            angle = angle.angle()
        elif np.ndim(angle) == 2:
            R = matrix(angle, (2, 2), "Rotation2d")
            angle = math.atan2(R[1, 0], R[0, 0])
        self._angle = float(angle)

    def angle(self):
        return self._angle

    def inverse(self):
        return Rotation2d(-self._angle)

    def to_rotation_matrix(self):
        c, s = math.cos(self._angle), math.sin(self._angle)
        return np.array([[c, -s], [s, c]])

    rotation_matrix = matrix = to_rotation_matrix
    R = property(to_rotation_matrix)

    def __mul__(self, other):
        if isinstance(other, Rotation2d):
            return Rotation2d(self._angle + other._angle)
        return self.to_rotation_matrix() @ vector(other, 2, "point")

    def __repr__(self):
        return f"Rotation2d({self._angle:.9g})"


class Isometry3d:
    """A rigid motion of space: Isometry3d(matrix), Isometry3d(R, t) or Isometry3d(Quaternion, t)."""

    def __init__(self, *values):
        if len(values) == 2:
            first, t = values
            q = first.coeffs() if isinstance(first, Quaternion) else Quaternion(first).coeffs()
            self._row = np.concatenate([vector(t, 3, "translation"), unit_quaternion(q)])
        elif not values:
            self._row = np.array([0.0, 0, 0, 0, 0, 0, 1])
        elif len(values) != 1:
            raise TypeError(f"{type(self).__name__}: expected a matrix, or a rotation and a translation")
        elif isinstance(values[0], Isometry3d):
            self._row = values[0]._row.copy()
        elif hasattr(values[0], "quaternion"):  # boxplus.SE3
            self._row = values[0].vector()
        else:
            T = np.asarray(values[0], dtype=float)
            if T.shape == (3, 4):
                T = np.vstack([T, [0, 0, 0, 1]])
            T = matrix(T, (4, 4), type(self).__name__)
            self._row = np.append(T[:3, 3], quaternion_of_matrix(rotation(T[:3, :3])))

    @classmethod
    def from_row(cls, row):
        """x y z qx qy qz qw, with a quaternion of length 1."""
        pose = cls()
        pose._row = np.array(row, dtype=float)
        return pose

    @classmethod
    def identity(cls):
        return cls()

    def set_identity(self):
        self._row = np.array([0.0, 0, 0, 0, 0, 0, 1])

    def translation(self):
        return self._row[:3].copy()

    position = translation
    t = property(translation)

    def rotation(self):
        """The matrix. (rotation() of an SE3Quat is a Quaternion.)"""
        return _rows.matrix_of(self._row[None, 3:])[0]

    linear = rotation_matrix = rotation

    def _matrix3(self):
        return _rows.matrix_of(self._row[None, 3:])[0]

    R = property(_matrix3)

    def orientation(self):
        return Quaternion(self._row[3:])

    quaternion_of_rotation = orientation

    def matrix(self):
        T = np.eye(4)
        T[:3, :3], T[:3, 3] = self._matrix3(), self._row[:3]
        return T

    def set_translation(self, t):
        self._row[:3] = vector(t, 3, "translation")

    def set_rotation(self, R):
        self._row[3:] = unit_quaternion(Quaternion(R).coeffs())

    def translate(self, t):
        """Appends a translation in the own frame."""
        self._row[:3] = self * t

    def pretranslate(self, t):
        self._row[:3] += vector(t, 3, "translation")

    def rotate(self, R):
        self._row[3:] = unit_quaternion((self.orientation() * Quaternion(R)).coeffs())

    def prerotate(self, R):
        q = Quaternion(R)
        self._row = np.concatenate([q * self._row[:3], unit_quaternion((q * self.orientation()).coeffs())])

    def inverse(self):
        return self.from_row(_rows.inverse(self._row[None])[0])

    def is_approx(self, other, precision=1e-12):
        difference = np.linalg.norm(self.matrix() - other.matrix())
        return bool(difference <= precision * min(np.linalg.norm(self.matrix()), np.linalg.norm(other.matrix())))

    def __mul__(self, other):
        if isinstance(other, Isometry3d):
            return self.from_row(_rows.compose(self._row[None], other._row[None])[0])
        return _rows.out_of(self._row[None], vector(other, 3, "point")[None])[0]

    __matmul__ = __mul__

    def __eq__(self, other):
        return isinstance(other, Isometry3d) and bool((self._row == other._row).all())

    __hash__ = None

    def __repr__(self):
        return f"{type(self).__name__}({self.orientation()!r}, {self._row[:3].tolist()})"


class Isometry2d:
    """A rigid motion of the plane: Isometry2d(matrix) or Isometry2d(angle or R, t)."""

    def __init__(self, *values):
        self._t, self._R = np.zeros(2), Rotation2d()
        if len(values) == 2:
            self._R, self._t = Rotation2d(values[0]), vector(values[1], 2, "translation")
        elif len(values) == 1 and isinstance(values[0], Isometry2d):
            self._R, self._t = values[0]._R, values[0]._t.copy()
        elif values:
            T = matrix(values[0], (3, 3), "Isometry2d")
            self._R, self._t = Rotation2d(T[:2, :2]), T[:2, 2].copy()

    def translation(self):
        return self._t.copy()

    def rotation(self):
        return self._R.to_rotation_matrix()

    t, R = property(translation), property(rotation)

    def matrix(self):
        T = np.eye(3)
        T[:2, :2], T[:2, 2] = self.rotation(), self._t
        return T

    def inverse(self):
        R = self._R.inverse()
        return Isometry2d(R, -(R * self._t))

    def __mul__(self, other):
        if isinstance(other, Isometry2d):
            return Isometry2d(self._R * other._R, self._R * other._t + self._t)
        return self._R * other + self._t

    def __repr__(self):
        return f"Isometry2d({self._R.angle():.9g}, {self._t.tolist()})"
