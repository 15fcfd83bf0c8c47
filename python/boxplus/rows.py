# SPDX-License-Identifier: BSD-3-Clause
"""Poses and points as rows of arrays, for the error functions of BatchedEdge.

A row of SE2 is (x, y, theta), a row of SE3 is (x, y, z, qx, qy, qz, qw) with a quaternion of length 1, as in
Graph.estimates(). All functions take and return arrays with one row per edge. The names are those of the classes. If the
first argument has poses of the plane, the second one has poses (n, 3) or points (n, 2); if it has poses in space, the second
one has poses (n, 7) or points (n, 3). The derivatives of all functions are exact: they apply the chain rule to dual numbers.
"""

import numpy as np

from ._masks import require_unmasked

__all__ = ["inverse", "inverse_times", "log", "ominus", "rotation", "times"]


def times(a, b):
    """The products of poses, or points of the frames of a in the world."""
    if _is_plane(a, b):
        position = a[:, :2] + _turn(a[:, 2], b[:, :2])
        if b.shape[1] == 2:
            return position
        return np.concatenate([position, _wrapped(a[:, 2] + b[:, 2])[:, None]], axis=1)
    position = a[:, :3] + _rotate(a[:, 3:], b[:, :3])
    return position if b.shape[1] == 3 else np.concatenate([position, _multiply(a[:, 3:], b[:, 3:])], axis=1)


def inverse(a):
    """The inverses of poses."""
    if _is_plane(a):
        return np.concatenate([-_turn(-a[:, 2], a[:, :2]), -a[:, 2:]], axis=1)
    conjugate = _conjugate(a[:, 3:])
    return np.concatenate([-_rotate(conjugate, a[:, :3]), conjugate], axis=1)


def inverse_times(a, b):
    """The poses b relative to the poses a, or points of the world in the frames of a."""
    if _is_plane(a, b):
        position = _turn(-a[:, 2], b[:, :2] - a[:, :2])
        if b.shape[1] == 2:
            return position
        return np.concatenate([position, _wrapped(b[:, 2] - a[:, 2])[:, None]], axis=1)
    conjugate = _conjugate(a[:, 3:])
    position = _rotate(conjugate, b[:, :3] - a[:, :3])
    return position if b.shape[1] == 3 else np.concatenate([position, _multiply(conjugate, b[:, 3:])], axis=1)


def ominus(y, x):
    """y ⊟ x (n, 3) or (n, 6): the translation and the angle, or the vector part of the quaternion with w ≥ 0, of x⁻¹ y."""
    relative = inverse_times(x, y)
    return relative if _is_plane(relative) else np.concatenate([relative[:, :3], _upright(relative[:, 3:])[:, :3]], axis=1)


def rotation(a):
    """The rotation matrices (n, 2, 2) or (n, 3, 3) of poses."""
    if _is_plane(a):
        c, s = np.cos(a[:, 2]), np.sin(a[:, 2])
        return np.stack([np.stack([c, -s], axis=1), np.stack([s, c], axis=1)], axis=1)
    return np.stack([_rotate(a[:, 3:], np.broadcast_to(axis, (len(a), 3))) for axis in np.eye(3)], axis=2)


def log(a):
    """The constant velocities in the frame of the body (n, 3) or (n, 6) that lead from the origin to the poses in one
    second: m/s and rad/s."""
    if _is_plane(a):
        half = 0.5 * a[:, 2]
        is_small = np.abs(half) < 1e-3
        safe = np.where(is_small, 1.0, half)
        cotangent = np.where(is_small, 1 - half * half / 3 - half**4 / 45, safe * np.cos(safe) / np.sin(safe))
        x, y = a[:, 0], a[:, 1]
        return np.stack([cotangent * x + half * y, cotangent * y - half * x, a[:, 2]], axis=1)
    omega = _rotation_vector(a[:, 3:])
    squared = (omega * omega).sum(axis=1, keepdims=True)
    is_small = squared < 1e-6
    angle = np.sqrt(np.where(is_small, 1.0, squared))
    factor = np.where(is_small, 1 / 12 + squared / 720, (1 - 0.5 * angle * np.sin(angle) / (1 - np.cos(angle))) / angle**2)
    around = np.cross(omega, a[:, :3])
    return np.concatenate([a[:, :3] - 0.5 * around + factor * np.cross(omega, around), omega], axis=1)


def _is_plane(a, b=None):
    """True for SE2, False for SE3."""
    require_unmasked((a, b), "rows")
    width = a.shape[1] if a.ndim == 2 else 0
    if width not in (3, 7):
        raise ValueError(f"rows: expected poses of the shape (n, 3) or (n, 7), got {a.shape}")
    allowed = (2, 3) if width == 3 else (3, 7)
    if b is not None and (b.ndim != 2 or b.shape[1] not in allowed):
        raise ValueError(f"rows: expected points or poses of the shape (n, {allowed[0]}) or (n, {allowed[1]}), got {b.shape}")
    return width == 3


def _turn(angle, p):
    c, s = np.cos(angle), np.sin(angle)
    return np.stack([c * p[:, 0] - s * p[:, 1], s * p[:, 0] + c * p[:, 1]], axis=1)


def _wrapped(angle):
    return angle - 2 * np.pi * np.rint(angle / (2 * np.pi))


def _multiply(a, b):
    v, w, u, s = a[:, :3], a[:, 3:], b[:, :3], b[:, 3:]
    return np.concatenate([w * u + s * v + np.cross(v, u), w * s - (v * u).sum(axis=1, keepdims=True)], axis=1)


def _conjugate(q):
    return q * np.array([-1.0, -1, -1, 1])


def _rotate(q, p):
    v = q[:, :3]
    twice = 2 * np.cross(v, p)
    return p + q[:, 3:] * twice + np.cross(v, twice)


def _upright(q):
    return q * np.where(q[:, 3:] < 0, -1.0, 1.0)


def _rotation_vector(q):
    q = _upright(q)
    v, w = q[:, :3], q[:, 3:]
    squared = (v * v).sum(axis=1, keepdims=True)
    is_small = squared < 1e-16
    length = np.sqrt(np.where(is_small, 1.0, squared))
    return np.where(is_small, 2 / np.where(is_small, w, 1.0), 2 * np.arctan2(length, w) / length) * v
