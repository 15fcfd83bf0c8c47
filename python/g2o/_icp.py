# SPDX-License-Identifier: BSD-3-Clause
"""Pairs of points with normals (Segal, Haehnel, Thrun, "Generalized-ICP", 2009), and stereo cameras that share one camera
matrix."""

import numpy as np

from . import _rows
from ._codecs import POINT3, Codec
from ._elements import Edge
from ._geometry import vector
from ._sba import ImageInPose, pinhole
from ._slam3d import VertexPointXYZ, VertexSE3


class EdgeGICP:
    """A pair of matching points of two scans with their normals, in the frames of the two poses."""

    def __init__(self):
        self.pos0, self.pos1 = np.zeros(3), np.zeros(3)
        self.normal0, self.normal1 = np.array([0.0, 0, 1]), np.array([0.0, 0, 1])
        self.R0, self.R1 = np.eye(3), np.eye(3)

    @staticmethod
    def _rotation(normal):
        """The rows n × a, a and n, with a orthogonal to n and closest to the y-axis."""
        normal = vector(normal, 3, "normal")
        up = np.array([0.0, 1, 0]) if abs(normal[1]) < 1 - 5e-7 else np.array([1.0, 0, 0])
        a = up - (up @ normal) * normal
        a /= np.linalg.norm(a)
        return np.stack([np.cross(normal, a), a, normal])

    def make_rot0(self):
        self.R0 = self._rotation(self.normal0)

    def make_rot1(self):
        self.R1 = self._rotation(self.normal1)

    def prec0(self, e):
        """The precision matrix of point 0: 1 along the normal, e across."""
        self.make_rot0()
        return self.R0.T @ np.diag([e, e, 1]) @ self.R0

    def prec1(self, e):
        self.make_rot1()
        return self.R1.T @ np.diag([e, e, 1]) @ self.R1

    def cov0(self, e):
        """The covariance matrix of point 0: e along the normal, 1 across."""
        self.make_rot0()
        return self.R0.T @ np.diag([1, 1, e]) @ self.R0

    def cov1(self, e):
        self.make_rot1()
        return self.R1.T @ np.diag([1, 1, e]) @ self.R1


def _decoded(row):
    pair = EdgeGICP()
    pair.pos0, pair.pos1 = row[:3].copy(), row[3:].copy()
    return pair


#: The measurement is an EdgeGICP, of which the row has the two points.
_PAIR = Codec("EdgeGICP", np.zeros(6),
              lambda value: np.append(vector(value.pos0, 3, "pos0"), vector(value.pos1, 3, "pos1")), _decoded)


class EdgeVVGicp(Edge):
    """Two matching points of two scans: the error is x₀⁻¹ x₁ p₁ − p₀. With pl_pl (plane to plane), the information is
    (cov0 + R cov1 Rᵀ)⁻¹, with the rotation R of x₀⁻¹ x₁ at the beginning of each iteration."""

    _TAG, _VERTICES, _CODEC, _DIM = "EDGE_V_V_GICP", (VertexSE3, VertexSE3), _PAIR, 3

    def __init__(self):
        super().__init__()
        self._pair = EdgeGICP()
        self.pl_pl = False
        self.cov0, self.cov1 = np.eye(3), np.eye(3)

    def measurement(self):
        return self._pair

    def information(self):
        return self._current_information().copy()

    def set_measurement(self, measurement):
        super().set_measurement(measurement)
        self._pair = measurement

    @staticmethod
    def _residuals(data, a, b):
        return _rows.into(a, _rows.out_of(b, data[:, 3:])) - data[:, :3]

    def _current_information(self):
        """Ω at the current estimates."""
        if self.pl_pl:
            R = (self.vertex(0).estimate().inverse() * self.vertex(1).estimate()).R
            self._information = np.linalg.inv(self.cov0 + R @ self.cov1 @ R.T)
        return self._information


class VertexSCam(VertexSE3):
    """The pose of a stereo camera. All objects share one camera matrix and baseline."""

    _TAG = None
    _camera = np.array([1.0, 1, 0, 0, 0.5])

    @staticmethod
    def set_kcam(fx, fy, cx, cy, tx):
        """Sets the camera of all objects. Call it before edges are added to a graph."""
        VertexSCam._camera = np.array([fx, fy, cx, cy, fx * tx], dtype=float)

    set_cam = set_kcam

    def set_all(self):
        """Has no effect: what depends on the estimate is always up to date."""

    set_transform = set_projection = set_dr = set_all

    def map_point(self, point):
        """u, v, and u in the right camera, of a point of the world."""
        return pinhole(_rows.into(self._row[None], vector(point, 3, "point")[None]), self._camera[None])[0]


class EdgeXYZVsc(ImageInPose):
    """(u, v, u_right) of a point in a VertexSCam: vertices point, camera."""

    _VERTICES, _CODEC, _DIM = (VertexPointXYZ, VertexSCam), POINT3, 3

    def _intrinsics(self):
        return VertexSCam._camera
