# SPDX-License-Identifier: BSD-3-Clause
"""Poses as rows of arrays. All functions take and return arrays with one row per pose, and apply the chain rule to dual
numbers (boxplus/_dual.py).

Quaternions are (x, y, z, w), poses in the plane (x, y, theta), poses in space (translation, quaternion).
"""

import numpy as np

from boxplus.rows import (_conjugate as conjugate, _multiply as multiply, _rotate as rotate,
                          _rotation_vector as rotation_vector, _upright as upright, _wrapped as wrapped, inverse,
                          inverse_times, log, rotation, times)

compose = times


def into(a, p):
    """The points p (n, 3) of the world in the frame of poses."""
    return inverse_times(a, p)


def out_of(a, p):
    """The points p (n, 3) of the frame of poses in the world."""
    return times(a, p)


def minimal(a):
    """(n, 6): the translation, and the vector part of the quaternion with w ≥ 0."""
    return np.concatenate([a[:, :3], upright(a[:, 3:7])[:, :3]], axis=1)


def matrix_of(q):
    """The rotation matrices (n, 3, 3) of unit quaternions."""
    return rotation(np.concatenate([0 * q[:, :3], q], axis=1))


def logarithm(a):
    """(n, 6): (omega, upsilon), whose exponential is the pose."""
    twist = log(a)
    return np.concatenate([twist[:, 3:], twist[:, :3]], axis=1)


# Poses in the plane.

compose2, inverse2, into2 = times, inverse, inverse_times


def relative2(z, a, b):
    """The vector (x, y, theta) of z⁻¹ a⁻¹ b."""
    return inverse_times(z, inverse_times(a, b))


def relative(z, a, b):
    """The minimal vector of z⁻¹ a⁻¹ b."""
    return minimal(inverse_times(z, inverse_times(a, b)))
