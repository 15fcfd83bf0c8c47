# SPDX-License-Identifier: BSD-3-Clause
"""Every tag of g2o's type libraries: chi2 of lines with random numbers against formulas in NumPy.

The formulas are those of the table of tags in g2o's documents and of the papers, written a second time, with matrices
instead of quaternions: nothing of the library computes what is expected. A row of the table also says which element
each id of a line names, so that a wrong order of ids or fields is seen, too.
"""

import pathlib
import re
import tempfile
import unittest

import boxplus
import numpy as np

TRIALS = 10


# Poses, as matrices


def wrap(angle):
    return (angle + np.pi) % (2 * np.pi) - np.pi


def pose2(v):
    c, s = np.cos(v[2]), np.sin(v[2])
    return np.array([[c, -s, v[0]], [s, c, v[1]], [0, 0, 1]])


def vector2(X):
    return np.array([X[0, 2], X[1, 2], np.arctan2(X[1, 0], X[0, 0])])


def rotation(q):
    """The rotation matrix of (qx, qy, qz, qw)."""
    x, y, z, w = q
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


def pose3(v):
    X = np.eye(4)
    X[:3, :3] = rotation(v[3:7])
    X[:3, 3] = v[:3]
    return X


def euler_pose(v):
    """Of (x, y, z, roll, pitch, yaw): Rz(yaw) Ry(pitch) Rx(roll)."""
    (cr, cp, cy), (sr, sp, sy) = np.cos(v[3:]), np.sin(v[3:])
    X = np.eye(4)
    X[:3, :3] = (np.array([[cy, -sy, 0], [sy, cy, 0], [0, 0, 1]]) @ np.array([[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]])
                 @ np.array([[1, 0, 0], [0, cr, -sr], [0, sr, cr]]))
    X[:3, 3] = v[:3]
    return X


def vector3(X):
    """(t, qx, qy, qz) with qw >= 0. Only for rotations of less than 180 degrees."""
    w = np.sqrt(1 + np.trace(X[:3, :3])) / 2
    return np.r_[X[:3, 3], cross_part(X[:3, :3]) / (4 * w)]


def cross_part(R):
    return np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])


def cross_matrix(v):
    return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def exponential(A):
    """By scaling and squaring of the series."""
    A = A / 1024
    term = result = np.eye(len(A))
    for k in range(1, 12):
        term = term @ A / k
        result = result + term
    for _ in range(10):
        result = result @ result
    return result


def similarity(v):
    """The matrix (s R, t) of the logarithm (ω, υ, σ)."""
    A = np.zeros((4, 4))
    A[:3, :3] = cross_matrix(v[:3]) + v[6] * np.eye(3)
    A[:3, 3] = v[3:6]
    return exponential(A)


def logarithm(S):
    """(ω, υ, σ) of the matrix (s R, t)."""
    scale = np.cbrt(np.linalg.det(S[:3, :3]))
    R = S[:3, :3] / scale
    angle = np.arccos(np.clip((np.trace(R) - 1) / 2, -1, 1))
    omega = cross_part(R) * angle / (2 * np.sin(angle))
    columns = [similarity(np.r_[omega, unit, np.log(scale)])[:3, 3] for unit in np.eye(3)]  # t is linear in υ
    return np.r_[omega, np.linalg.solve(np.array(columns).T, S[:3, 3]), np.log(scale)]


inverse = np.linalg.inv


def seen(X, point):
    """The point in the frame of the pose or the similarity."""
    return (inverse(X) @ np.r_[point, 1])[:-1]


# Lines, planes, images


def segment_seen(X, s):
    a, b = seen(X, s[:2]), seen(X, s[2:])
    return a, b, np.arctan2(-(b - a)[0], (b - a)[1])  # the direction (x, y), turned by -90 degrees, is (y, -x)


def segment_line_error(X, s, z):
    a, b, angle = segment_seen(pose2(X), s)
    return np.array([wrap(angle - z[0]), np.array([np.cos(angle), np.sin(angle)]) @ (a + b) / 2 - z[1]])


def segment_end_error(X, s, z):
    a, b, angle = segment_seen(pose2(X), s)
    return np.r_[(b if z[0] else a) - z[1:3], wrap(angle - z[3])]


def line2_seen(X, line):
    normal = np.array([np.cos(line[0]), np.sin(line[0])])
    return np.array([line[0] - np.arctan2(X[1, 0], X[0, 0]), line[1] - normal @ X[:2, 2]])


def arc(k, z):
    left, right = k[0] * z[0], k[1] * z[1]
    turn, way = (right - left) * z[2] / k[2], (right + left) * z[2] / 2
    return pose2([way * np.sin(turn) / turn, way * (1 - np.cos(turn)) / turn, turn])


def unit_plane(v):
    return np.asarray(v[:4]) / np.linalg.norm(v[:3])


def plane_frame(n):
    """The rotation by the azimuth of n about z, and then by its elevation: its first column is n."""
    azimuth, elevation = np.arctan2(n[1], n[0]), np.arctan2(n[2], np.hypot(n[0], n[1]))
    c, s, ce, se = np.cos(azimuth), np.sin(azimuth), np.cos(elevation), np.sin(elevation)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ np.array([[ce, 0, -se], [0, 1, 0], [se, 0, ce]])


def plane_error(X, plane, z):
    n, d = X[:3, :3].T @ plane[:3], plane[3] + plane[:3] @ X[:3, 3]
    turned = plane_frame(n).T @ z[:3]
    return np.array([np.arctan2(turned[1], turned[0]), np.arctan2(turned[2], np.hypot(turned[0], turned[1])), z[3] - d])


def line3_frame(w, d):
    """U and φ of the orthonormal representation (Bartoli & Sturm 2005)."""
    U = np.array([w / np.linalg.norm(w), d / np.linalg.norm(d), np.cross(w, d) / np.linalg.norm(np.cross(w, d))]).T
    return U, np.arctan2(np.linalg.norm(d), np.linalg.norm(w))


def line3_error(X, line, z):
    w, d = plucker(line)
    R, t = X[:3, :3], X[:3, 3]
    U, phi = line3_frame(R.T @ (w - np.cross(t, d)), R.T @ d)
    V, psi = line3_frame(*plucker(z))
    D = np.eye(4)
    D[:3, :3] = U.T @ V
    return np.r_[vector3(D)[3:], psi - phi]


def plucker(v):
    """w without its part along d, and d."""
    w, d = np.asarray(v[:3]), np.asarray(v[3:6])
    return w - d * (w @ d) / (d @ d), d


def image(p, fx, fy, cx, cy):
    return np.array([fx * p[0] / p[2] + cx, fy * p[1] / p[2] + cy])


def stereo_image(p, fx, fy, cx, cy, bf):
    left = image(p, fx, fy, cx, cy)
    return np.r_[left, left[0] - bf / p[2]]


def one_focal_length(k):
    """fx, fy, cx, cy, bf of PARAMS_CAMERAPARAMETERS."""
    return k[0], k[0], k[1], k[2], k[0] * k[3]


def with_baseline(k):
    """fx, fy, cx, cy, bf of fx, fy, cx, cy, baseline."""
    return (*k[:4], k[0] * k[4])


def inverse_depth(psi):
    return np.array([psi[0], psi[1], 1]) / psi[2]


# Elements with random numbers


class Numbers:
    """Random fields of elements. Points are in front of all cameras, and angles far from where they jump."""

    def __init__(self, seed):
        self.random = np.random.default_rng(seed)

    def near(self, *values, spread=0.2):
        return np.asarray(values, float) + self.random.uniform(-spread, spread, len(values))

    def pose2(self):
        return self.near(0, 0, 0, spread=0.6)

    def pose3(self):
        q = self.near(0, 0, 0, 1)
        return np.r_[self.near(0, 0, 0, spread=0.5), q / np.linalg.norm(q)]

    def point2(self):
        return self.near(3, 1, spread=0.5)

    def point3(self):
        return self.near(0.5, -0.5, 5, spread=0.5)

    def segment(self):
        return self.near(3, 1, 4, 3)

    def line2(self):
        return self.near(0.5, 2)

    def plane(self):
        v = self.near(1, 0.2, 0.3, -3)
        return np.r_[v[:4] / np.linalg.norm(v[:3]), 0.2, 0.2, 0.2]

    def line3(self):
        w, d = self.near(0, -3, 0.2), self.near(0.6, 0.1, 0.8)
        d = d / np.linalg.norm(d)
        return np.r_[w - d * (w @ d), d]

    def drive(self):
        return self.near(1, 1, 0.7, spread=0.1)

    def pinhole(self):
        return np.r_[self.near(500, 510, spread=20), self.near(320, 240, spread=5)]

    def stereo(self):
        return np.r_[self.pinhole(), self.near(0.2, spread=0.1)]

    def stereo_bf(self):
        return np.r_[self.pinhole(), self.near(50, spread=10)]

    def similarity(self):
        return self.near(0.1, 0.1, -0.1, 0.3, 0.2, -0.4, 0.1)

    def pixel(self, rows=2):
        return self.near(*(310, 250, 290)[:rows], spread=30)

    def information(self, rows):
        A = self.random.normal(size=(rows, rows))
        return A @ A.T + np.eye(rows)


def upper(omega):
    return omega[np.triu_indices(len(omega))]


VERTICES = {
    # the tag of a vertex or parameter: its fields
    "VERTEX_SE2": Numbers.pose2,
    "VERTEX_XY": Numbers.point2,
    "PARAMS_SE2OFFSET": Numbers.pose2,
    "VERTEX_SEGMENT2D": Numbers.segment,
    "VERTEX_LINE2D": lambda n: np.r_[n.line2(), -1, -1],
    "VERTEX_ODOM_DIFFERENTIAL": Numbers.drive,
    "VERTEX_SE3:QUAT": Numbers.pose3,
    "VERTEX_TRACKXYZ": Numbers.point3,
    "PARAMS_SE3OFFSET": Numbers.pose3,
    "PARAMS_CAMERACALIB": lambda n: np.r_[n.pose3(), n.pinhole()],
    "PARAMS_STEREOCAMERACALIB": lambda n: np.r_[n.pose3(), n.stereo()],
    "VERTEX3": lambda n: n.near(0, 0, 0, 0, 0, 0),
    "VERTEX_PLANE": Numbers.plane,
    "VERTEX_LINE3D": Numbers.line3,
    "VERTEX_CAM": lambda n: np.r_[n.pose3(), n.stereo()],
    "VERTEX_INTRINSICS": Numbers.stereo,
    "VERTEX_SE3:EXPMAP": Numbers.pose3,
    "PARAMS_CAMERAPARAMETERS": lambda n: np.r_[n.near(500, 320, 240, spread=20), n.near(0.2, spread=0.1)],
    "VERTEX_SIM3:EXPMAP": lambda n: np.r_[n.similarity(), n.pinhole(), n.pinhole()],
}

DATA = {
    "ROBOTLASER1": "0 -1.5 3 0.1 20 0.1 0 2 1.5 2.5 0 1 2 0.1 1 2 0.2 0 0 0.3 0.3 0.3 0 host 0",
    "VERTEX_TAG": "name 1 2 3 0 0 0 0 host 0",
    "VERTEX_ELLIPSE": "1 0 0 1 0 1 1 2 3",
}

POSE2, POINT2, OFFSET2 = "VERTEX_SE2", "VERTEX_XY", "PARAMS_SE2OFFSET"
POSE3, POINT3, OFFSET3 = "VERTEX_SE3:QUAT", "VERTEX_TRACKXYZ", "PARAMS_SE3OFFSET"
PSI = (POINT3, lambda n: n.near(0.1, -0.1, 0.2, spread=0.05))
CAMERA, MOVED = "PARAMS_CAMERAPARAMETERS", "VERTEX_SE3:EXPMAP"


def mounted_image(third):
    def error(X, point, camera, z):
        p = seen(pose3(X) @ pose3(camera[:7]), point)
        return np.r_[image(p, *camera[7:11]), third(p[2])] - z

    return error


def between_twists(X1, X2, Z):
    """log(T2⁻¹ Z T1), where T and Z are the inverses of what the file has."""
    D = pose3(X2) @ inverse(pose3(Z)) @ inverse(pose3(X1))
    return logarithm(D)[:6]


EDGES = {
    # the tag of an edge: the elements that its ids name, the fields of its measurement, its error
    "EDGE_SE2": ([POSE2, POSE2], Numbers.pose2,
                 lambda a, b, z: vector2(inverse(pose2(z)) @ inverse(pose2(a)) @ pose2(b))),
    "EDGE_SE2_XY": ([POSE2, POINT2], Numbers.point2, lambda X, p, z: seen(pose2(X), p) - z),
    "EDGE_BEARING_SE2_XY": ([POSE2, POINT2], lambda n: n.near(0.5),
                            lambda X, p, z: wrap(z - np.arctan2(*seen(pose2(X), p)[::-1]))),
    "EDGE_PRIOR_SE2": ([POSE2], Numbers.pose2, lambda X, z: vector2(inverse(pose2(z)) @ pose2(X))),
    "EDGE_PRIOR_SE2_XY": ([POSE2], Numbers.point2, lambda X, z: X[:2] - z),
    "EDGE_PRIOR_XY": ([POINT2], Numbers.point2, lambda p, z: p - z),
    "EDGE_POINTXY": ([POINT2, POINT2], Numbers.point2, lambda p, q, z: q - p - z),
    "EDGE_SE2_XY_CALIB": ([POSE2, POINT2, POSE2], Numbers.point2, lambda X, p, C, z: seen(pose2(X) @ pose2(C), p) - z),
    "EDGE_SE2_OFFSET": ([POSE2, POSE2, OFFSET2, OFFSET2], Numbers.pose2,
                        lambda a, b, P, Q, z: vector2(
                            inverse(pose2(z)) @ inverse(pose2(a) @ pose2(P)) @ pose2(b) @ pose2(Q))),
    "EDGE_SE2_POINTXY_OFFSET": ([POSE2, POINT2, OFFSET2], Numbers.point2,
                                lambda X, p, P, z: seen(pose2(X) @ pose2(P), p) - z),
    "EDGE_SE2_TWOPOINTSXY": ([POSE2, POINT2, POINT2], lambda n: np.r_[n.point2(), n.point2()],
                             lambda X, p, q, z: np.r_[seen(pose2(X), p), seen(pose2(X), q)] - z),
    "EDGE_SE2_LOTSOFXY": ([POSE2, POINT2, POINT2, POINT2, "||"], lambda n: np.r_[n.point2(), n.point2(), n.point2()],
                          lambda X, p, q, r, z: np.r_[[seen(pose2(X), v) for v in (p, q, r)]].ravel() - z),
    "EDGE_SE2_SEGMENT2D": ([POSE2, "VERTEX_SEGMENT2D"], Numbers.segment,
                           lambda X, s, z: np.r_[segment_seen(pose2(X), s)[:2]].ravel() - z),
    "EDGE_SE2_SEGMENT2D_LINE": ([POSE2, "VERTEX_SEGMENT2D"], Numbers.line2,
                                segment_line_error),
    "EDGE_SE2_SEGMENT2D_POINTLINE": ([POSE2, "VERTEX_SEGMENT2D"],
                                     lambda n: np.r_[n.random.integers(2), n.point2(), n.near(-0.5)],
                                     segment_end_error),
    "EDGE_SE2_LINE2D": ([POSE2, "VERTEX_LINE2D"], Numbers.line2,
                        lambda X, line, z: line2_seen(pose2(X), line) - z),
    "EDGE_LINE2D": (["VERTEX_LINE2D", "VERTEX_LINE2D"], lambda n: n.near(0.1, 0.3), lambda a, b, z: b[:2] - a[:2] - z),
    "EDGE_LINE2D_POINTXY": (["VERTEX_LINE2D", POINT2], lambda n: n.near(0.3),
                            lambda line, p, z: np.array([np.cos(line[0]), np.sin(line[0])]) @ p - line[1] - z),
    "EDGE_SE2_CALIB": ([POSE2, POSE2, POSE2], Numbers.pose2,
                       lambda a, b, L, z: vector2(
                           inverse(pose2(z)) @ inverse(pose2(a) @ pose2(L)) @ pose2(b) @ pose2(L))),
    "EDGE_SE2_ODOM_DIFFERENTIAL_CALIB": ([POSE2, POSE2, "VERTEX_ODOM_DIFFERENTIAL"], lambda n: n.near(1, 1.6, 0.5),
                                         lambda a, b, k, z: vector2(
                                             inverse(arc(k, z)) @ inverse(pose2(a)) @ pose2(b))),
    "EDGE_SE3:QUAT": ([POSE3, POSE3], Numbers.pose3,
                      lambda a, b, z: vector3(inverse(pose3(z)) @ inverse(pose3(a)) @ pose3(b))),
    "EDGE_SE3_TRACKXYZ": ([POSE3, POINT3, OFFSET3], Numbers.point3,
                          lambda X, p, P, z: seen(pose3(X) @ pose3(P), p) - z),
    "EDGE_SE3_PRIOR": ([POSE3, OFFSET3], Numbers.pose3,
                       lambda X, P, z: vector3(inverse(pose3(z)) @ pose3(X) @ pose3(P))),
    "EDGE_SE3_XYZ_PRIOR": ([POSE3, OFFSET3], Numbers.point3, lambda X, P, z: X[:3] - z),
    "EDGE_SE3_OFFSET": ([POSE3, POSE3, OFFSET3, OFFSET3], Numbers.pose3,
                        lambda a, b, P, Q, z: vector3(
                            inverse(pose3(z)) @ inverse(pose3(a) @ pose3(P)) @ pose3(b) @ pose3(Q))),
    "EDGE_PROJECT_DISPARITY": ([POSE3, POINT3, "PARAMS_CAMERACALIB"],
                               lambda n: np.r_[n.pixel(), n.near(0.3, spread=0.1)], mounted_image(lambda z: 1 / z)),
    "EDGE_PROJECT_DEPTH": ([POSE3, POINT3, "PARAMS_CAMERACALIB"], lambda n: np.r_[n.pixel(), n.near(5)],
                           mounted_image(lambda z: z)),
    "EDGE_POINTXYZ": ([POINT3, POINT3], Numbers.point3, lambda p, q, z: q - p - z),
    "EDGE_POINTXYZ_PRIOR": ([POINT3], Numbers.point3, lambda p, z: p - z),
    "EDGE_SE3_LOTSOF_XYZ": ([POSE3, POINT3, POINT3, "||"], lambda n: np.r_[n.point3(), n.point3()],
                            lambda X, p, q, z: np.r_[seen(pose3(X), p), seen(pose3(X), q)] - z),
    "EDGE_SE3_PLANE_CALIB": ([POSE3, "VERTEX_PLANE", POSE3], Numbers.plane,
                             lambda X, plane, P, z: plane_error(
                                 pose3(X) @ pose3(P), unit_plane(plane), unit_plane(z))),
    "EDGE_PLANE": (["VERTEX_PLANE", "VERTEX_PLANE"], lambda n: n.near(0, 0.1, 0.2, 0.3),
                   lambda a, b, z: unit_plane(b) - unit_plane(a) - z),
    "EDGE_SE3_LINE3D": ([POSE3, "VERTEX_LINE3D", OFFSET3], Numbers.line3,
                        lambda X, line, P, z: line3_error(pose3(X) @ pose3(P), line, z)),
    "EDGE_SE3_CALIB": ([POSE3, POSE3, POSE3], Numbers.pose3,
                       lambda a, b, C, z: vector3(
                           inverse(pose3(z)) @ inverse(pose3(a) @ pose3(C)) @ pose3(b) @ pose3(C))),
    "EDGE_PROJECT_P2MC": ([POINT3, "VERTEX_CAM"], Numbers.pixel,
                          lambda p, C, z: image(seen(pose3(C), p), *C[7:11]) - z),
    "EDGE_PROJECT_P2SC": ([POINT3, "VERTEX_CAM"], lambda n: n.pixel(3),
                          lambda p, C, z: stereo_image(seen(pose3(C), p), *with_baseline(C[7:12])) - z),
    "EDGE_PROJECT_P2MC_INTRINSICS": ([POINT3, "VERTEX_CAM", "VERTEX_INTRINSICS"], Numbers.pixel,
                                     lambda p, C, K, z: image(seen(pose3(C), p), *K[:4]) - z),
    "EDGE_CAM": (["VERTEX_CAM", "VERTEX_CAM"], Numbers.pose3,
                 lambda a, b, z: vector3(inverse(pose3(z)) @ inverse(pose3(a)) @ pose3(b))),
    "EDGE_SCALE": (["VERTEX_CAM", "VERTEX_CAM"], lambda n: n.near(1), lambda a, b, z: z - np.linalg.norm(b[:3] - a[:3])),
    "EDGE_SE3:EXPMAP": ([MOVED, MOVED], Numbers.pose3, between_twists),
    "EDGE_PROJECT_XYZ2UV:EXPMAP": ([POINT3, MOVED, CAMERA], Numbers.pixel,
                                   lambda p, X, k, z: z - image(seen(pose3(X), p), *one_focal_length(k)[:4])),
    "EDGE_PROJECT_XYZ2UVU:EXPMAP": ([POINT3, MOVED, CAMERA], lambda n: n.pixel(3),
                                    lambda p, X, k, z: z - stereo_image(seen(pose3(X), p), *one_focal_length(k))),
    "EDGE_PROJECT_PSI2UV:EXPMAP": ([PSI, MOVED, MOVED, CAMERA], Numbers.pixel,
                                   lambda psi, X, A, k, z: z - image(
                                       seen(pose3(X), (pose3(A) @ np.r_[inverse_depth(psi), 1])[:3]),
                                       *one_focal_length(k)[:4])),
    "EDGE_SIM3:EXPMAP": (["VERTEX_SIM3:EXPMAP", "VERTEX_SIM3:EXPMAP"], Numbers.similarity,
                         lambda a, b, z: logarithm(
                             inverse(similarity(z)) @ inverse(similarity(a)) @ similarity(b))),
    "EDGE_PROJECT_SIM3_XYZ:EXPMAP": ([POINT3, "VERTEX_SIM3:EXPMAP"], Numbers.pixel,
                                     lambda p, S, z: z - image(seen(similarity(S), p), *S[7:11])),
    "EDGE_PROJECT_INVERSE_SIM3_XYZ:EXPMAP": ([POINT3, "VERTEX_SIM3:EXPMAP"], Numbers.pixel,
                                             lambda p, S, z: z - image(
                                                 (similarity(S) @ np.r_[p, 1])[:3], *S[11:15])),
}

EDGES_WITH_CAMERAS = {
    # the same, with the known numbers that follow the information
    "EDGE_SE3_PROJECT_XYZ:EXPMAP": ([POINT3, MOVED], Numbers.pixel, Numbers.pinhole,
                                    lambda p, X, z, k: z - image(seen(pose3(X), p), *k)),
    "EDGE_STEREO_SE3_PROJECT_XYZ:EXPMAP": ([POINT3, MOVED], lambda n: n.pixel(3), Numbers.stereo_bf,
                                           lambda p, X, z, k: z - stereo_image(seen(pose3(X), p), *k)),
    "EDGE_SE3_PROJECT_XYZONLYPOSE:EXPMAP": ([MOVED], Numbers.pixel, lambda n: np.r_[n.point3(), n.pinhole()],
                                            lambda X, z, k: z - image(seen(pose3(X), k[:3]), *k[3:])),
    "EDGE_STEREO_SE3_PROJECT_XYZONLYPOSE:EXPMAP": ([MOVED], lambda n: n.pixel(3),
                                                   lambda n: np.r_[n.point3(), n.stereo_bf()],
                                                   lambda X, z, k: z - stereo_image(seen(pose3(X), k[:3]), *k[3:])),
}

OTHERS = {"EDGE3", "EDGE_V_V_GICP"}  # with formulas for Ω, in tests of their own
# Old names of tags above, and tags of boxplus.
NOT_OF_G2O = {"VERTEX", "EDGE", "VERTEX2", "EDGE2", "VERTEX_XYZ", "RAWLASER1", "VERTEX_SE3_BAL",
              "EDGE_REPROJECTION_SE3_BAL", "VERTEX_CAMERA_M", "PARAMS_CAMERA_M", "EDGE_REPROJECTION_M", "EDGE_REPROJECTION_CALIB_M",
              "EDGE_REPROJECTION_RIG_M", "EDGE_REPROJECTION_RIG_CALIB_M", "ROBOTLASER2", "ROBOTLASER5", "RAWLASER2", "RAWLASER5",
              "VERTEX_IMU_BIAS", "VERTEX_DIRECTION", "PARAMS_DIRECTION", "PARAMS_POINT", "EDGE_INERTIAL", "EDGE_INERTIAL_GRAVITY",
              "EDGE_DIRECTION", "EDGE_DIRECTION_CALIB", "EDGE_FIELD", "EDGE_POSITION", "EDGE_POSITION_CALIB"}


def text_of(*fields):
    return " ".join(np.format_float_positional(f, trim="-") if isinstance(f, float) else str(f)
                    for field in fields for f in (field.tolist() if isinstance(field, np.ndarray) else [field]))


class Lines:
    """The elements that an edge names, with ids from 0, and the edge."""

    def __init__(self, tag, elements, numbers):
        self.tag, self.values, self.ids, self.text = tag, [], [], ""
        for element in elements:
            if element == "||":
                self.ids.append("||")
                continue
            vertex, fields = element if isinstance(element, tuple) else (element, VERTICES[element])
            values, name = fields(numbers), len(self.values)
            self.text += text_of(vertex, name, values) + "\n"
            self.values.append(values)
            self.ids.append(name)

    def chi2(self, *fields):
        """Of the edge with these fields, by the library."""
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "graph.g2o"
            path.write_text(self.text + text_of(self.tag, *self.ids, *fields) + "\n", encoding="utf-8")
            graph = boxplus.load(path)
            if graph.notes:
                raise AssertionError(str(graph.notes))
            return graph.chi2()


class Errors(unittest.TestCase):
    def test_chi2_of_each_tag_is_that_of_its_formula(self):
        for tag, (elements, measure, error) in EDGES.items():
            for seed in range(TRIALS):
                numbers = Numbers(seed)
                lines, z = Lines(tag, elements, numbers), measure(numbers)
                e = error(*lines.values, z)
                omega = numbers.information(len(e))
                count = [elements.count(POINT2) + elements.count(POINT3)] if "||" in elements else []
                fields = [int(z[0]), z[1:]] if tag == "EDGE_SE2_SEGMENT2D_POINTLINE" else [z]
                with self.subTest(tag=tag, seed=seed):
                    self.expect_equal(lines.chi2(*count, *fields, upper(omega)), e @ omega @ e)

    def test_chi2_of_tags_with_cameras_is_that_of_their_formulas(self):
        for tag, (elements, measure, known, error) in EDGES_WITH_CAMERAS.items():
            for seed in range(TRIALS):
                numbers = Numbers(seed)
                lines, z, k = Lines(tag, elements, numbers), measure(numbers), known(numbers)
                e = error(*lines.values, z, k)
                omega = numbers.information(len(e))
                with self.subTest(tag=tag, seed=seed):
                    self.expect_equal(lines.chi2(z, upper(omega), k), e @ omega @ e)

    def test_the_information_of_a_surface_follows_from_its_normal(self):
        for seed in range(TRIALS):
            numbers = Numbers(seed)
            lines = Lines("EDGE_V_V_GICP", [POSE3, POSE3], numbers)
            p, q, n, m = (numbers.near(1, 2, 3) for _ in range(4))
            n, m = n / np.linalg.norm(n), m / np.linalg.norm(m)
            e = seen(pose3(lines.values[0]), (pose3(lines.values[1]) @ np.r_[q, 1])[:3]) - p
            along = n @ e
            self.expect_equal(lines.chi2(p, n, q, m), along**2 + 0.01 * (e @ e - along**2))

    def test_old_tags_with_euler_angles_double_the_information_of_rotations(self):
        for seed in range(TRIALS):
            numbers = Numbers(seed)
            lines, z = Lines("EDGE3", ["VERTEX3", "VERTEX3"], numbers), numbers.near(0, 0, 0, 0, 0, 0)
            e = vector3(inverse(euler_pose(z)) @ inverse(euler_pose(lines.values[0])) @ euler_pose(lines.values[1]))
            e[3:] *= 2
            omega = numbers.information(6)
            self.expect_equal(lines.chi2(z, upper(omega)), e @ omega @ e)

    def test_data_belong_to_the_vertex_before_and_add_no_error(self):
        for tag, fields in DATA.items():
            lines = Lines("EDGE_PRIOR_SE2", [POSE2], Numbers(0))
            before = lines.chi2(0, 0, 0, 1, 0, 0, 1, 0, 1)
            lines.text += f"{tag} {fields}\n"
            self.assertEqual(lines.chi2(0, 0, 0, 1, 0, 0, 1, 0, 1), before)

    def test_no_tag_is_missing(self):
        document = (pathlib.Path(__file__).parents[2] / "docs/formats.md").read_text(encoding="utf-8")
        documented = set(re.findall("`((?:(?:VERTEX|EDGE|PARAMS)[0-9_]|ROBOTLASER|RAWLASER)[A-Z0-9_:]*)[ `]", document))
        self.assertEqual(documented - NOT_OF_G2O, {*VERTICES, *EDGES, *EDGES_WITH_CAMERAS, *DATA, *OTHERS})

    def expect_equal(self, chi2, expected):
        self.assertLess(abs(chi2 - expected), 1e-9 * (1 + expected))


if __name__ == "__main__":
    unittest.main()
