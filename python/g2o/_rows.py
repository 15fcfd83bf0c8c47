# SPDX-License-Identifier: BSD-3-Clause
"""Poses as rows of arrays. All functions take and return arrays with one row per pose, and apply the chain rule to dual
numbers (boxplus/_dual.py) unless they say otherwise.

Quaternions are (x, y, z, w), poses in the plane (x, y, theta), poses in space (translation, quaternion), similarities
(translation, quaternion, scale).
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
    """(n, 6): (omega, upsilon), whose exponential is the pose; see exponential()."""
    twist = log(a)
    return np.concatenate([twist[:, 3:], twist[:, :3]], axis=1)


def quaternion_of_vector(omega):
    """The unit quaternions of rotation vectors (n, 3)."""
    half = 0.5 * np.sqrt((omega * omega).sum(axis=1, keepdims=True))
    sinc = np.where(half < 1e-8, 0.5, 0.5 * np.sin(half) / np.where(half < 1e-8, 1.0, half))
    return np.concatenate([sinc * omega, np.cos(half)], axis=1)


def exponential(tangent):
    """The poses of (omega, upsilon) (n, 6); of plain arrays."""
    return np.concatenate([_translations(tangent[:, :3], tangent[:, 3:], 0 * tangent[:, :1]),
                           quaternion_of_vector(tangent[:, :3])], axis=1)


# Similarities. The translation of the exponential of (omega, upsilon, sigma) is W upsilon, with the integral W of
# exp(u (omega^ + sigma I)) over u from 0 to 1, which is a block of the exponential of a larger matrix.

def _integrals(omega, sigma):
    count = len(omega)
    M = np.zeros((count, 6, 6))
    for i, (j, k) in enumerate(((1, 2), (2, 0), (0, 1))):
        M[:, k, j], M[:, j, k] = omega[:, i], -omega[:, i]
        M[:, i, i] = sigma[:, 0]
        M[:, i, i + 3] = 1
    halvings = max(0, int(np.ceil(np.log2(np.abs(M).sum(axis=2).max(initial=1e-3)))) + 2)
    M /= 2.0**halvings
    term = result = np.broadcast_to(np.eye(6), M.shape)
    for k in range(1, 16):
        term = term @ M / k
        result = result + term
    for _ in range(halvings):
        result = result @ result
    return result[:, :3, 3:]


def _translations(omega, upsilon, sigma):
    return (_integrals(omega, sigma) @ upsilon[:, :, None])[:, :, 0]


def similarity_exponential(tangent):
    """The similarities of (omega, upsilon, sigma) (n, 7); of plain arrays."""
    omega, upsilon, sigma = tangent[:, :3], tangent[:, 3:6], tangent[:, 6:]
    return np.concatenate([_translations(omega, upsilon, sigma), quaternion_of_vector(omega), np.exp(sigma)], axis=1)


def similarity_logarithm(a):
    """(omega, upsilon, sigma) (n, 7) of similarities; of plain arrays."""
    omega, sigma = rotation_vector(a[:, 3:7]), np.log(a[:, 7:])
    upsilon = np.linalg.solve(_integrals(omega, sigma), a[:, :3, None])[:, :, 0]
    return np.concatenate([omega, upsilon, sigma], axis=1)


def similarity_map(a, p):
    return a[:, 7:] * rotate(a[:, 3:7], p) + a[:, :3]


def similarity_compose(a, b):
    return np.concatenate([similarity_map(a, b[:, :3]), multiply(a[:, 3:7], b[:, 3:7]), a[:, 7:] * b[:, 7:]], axis=1)


def similarity_inverse(a):
    q = conjugate(a[:, 3:7])
    return np.concatenate([-rotate(q, a[:, :3]) / a[:, 7:], q, 1 / a[:, 7:]], axis=1)


# Poses in the plane.

compose2, inverse2, into2 = times, inverse, inverse_times


def relative2(z, a, b):
    """The vector (x, y, theta) of z⁻¹ a⁻¹ b."""
    return inverse_times(z, inverse_times(a, b))


def relative(z, a, b):
    """The minimal vector of z⁻¹ a⁻¹ b."""
    return minimal(inverse_times(z, inverse_times(a, b)))
